struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_39 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_45 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_51 {
    member: f32,
    member_1: bool,
}

struct type_53 {
    member: array<vec4<u32>, 2>,
}

struct type_56 {
    member: array<i32>,
}

struct type_63 {
    member: type_39,
    member_1: u32,
}

struct type_64 {
    member: array<vec4<f32>, 3>,
    member_1: type_63,
    member_2: type_63,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_34;
@group(0) @binding(1) 
var<uniform> global_3: type_53;
@group(0) @binding(2) 
var<uniform> global_4: type_53;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(4) 
var<storage> global_6: type_24;
@group(0) @binding(5) 
var<storage> global_7: type_4;
@group(0) @binding(6) 
var<storage> global_8: type_56;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_69;
@group(0) @binding(7) 
var<storage> global_10: type_42;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var phi_336_: u32;
    var phi_380_: i32;
    var phi_520_: type_45;
    var phi_670_: i32;
    var phi_671_: i32;
    var phi_681_: bool;
    var phi_691_: u32;
    var phi_692_: u32;
    var phi_694_: bool;
    var phi_699_: u32;
    var phi_732_: i32;
    var phi_750_: f32;
    var phi_756_: f32;
    var phi_796_: f32;
    var phi_802_: f32;
    var phi_854_: f32;
    var phi_866_: f32;
    var phi_875_: f32;
    var phi_881_: f32;
    var phi_921_: f32;
    var phi_927_: f32;
    var phi_979_: f32;
    var phi_991_: f32;
    var phi_1000_: f32;
    var phi_1006_: f32;
    var phi_1046_: f32;
    var phi_1052_: f32;
    var phi_1104_: f32;
    var phi_1116_: f32;
    var phi_1171_: i32;
    var phi_1193_: u32;
    var phi_1194_: u32;
    var phi_1231_: i32;
    var phi_1253_: u32;
    var phi_1254_: u32;
    var phi_1262_: f32;
    var phi_1263_: f32;
    var phi_4374_: bool;
    var phi_1359_: type_51;
    var phi_1362_: bool;
    var phi_1364_: u32;
    var phi_1366_: u32;
    var phi_1368_: type_63;
    var phi_1379_: bool;
    var phi_1465_: bool;
    var phi_1466_: u32;
    var phi_1467_: type_63;
    var phi_3598_: u32;
    var phi_3599_: u32;
    var phi_3609_: u32;
    var phi_3611_: u32;
    var phi_3612_: bool;
    var phi_3632_: u32;
    var phi_3633_: u32;
    var phi_3637_: type_64;
    var phi_3999_: type_63;
    var phi_4076_: type_63;
    var phi_4077_: u32;
    var phi_4078_: type_63;
    var phi_4080_: u32;
    var phi_4081_: type_63;
    var phi_4082_: bool;
    var phi_4091_: type_63;
    var phi_4096_: bool;
    var phi_4098_: type_63;
    var phi_1485_: type_51;
    var phi_1488_: type_8;
    var phi_1489_: type_8;
    var phi_1511_: type_8;
    var phi_1532_: u32;
    var phi_1624_: array<array<f32, 3>, 3>;
    var phi_1776_: bool;
    var phi_1805_: bool;
    var phi_2224_: f32;
    var phi_2225_: f32;
    var phi_2226_: f32;
    var phi_2227_: f32;
    var phi_2228_: vec3<f32>;
    var phi_2229_: vec3<f32>;
    var phi_2230_: vec3<f32>;
    var phi_2231_: vec3<f32>;
    var phi_2268_: bool;
    var phi_2277_: vec3<f32>;
    var phi_2442_: f32;
    var phi_2444_: f32;
    var phi_2445_: bool;
    var phi_2465_: f32;
    var phi_2466_: f32;
    var phi_2489_: type_30;
    var phi_2491_: type_30;
    var phi_2492_: bool;
    var phi_2496_: type_30;
    var phi_2497_: type_30;
    var phi_2498_: type_30;
    var phi_2499_: bool;
    var phi_2503_: type_30;
    var phi_2504_: bool;
    var phi_2505_: type_30;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2508_: type_30;
    var phi_2509_: bool;
    var phi_2510_: bool;
    var phi_2518_: type_30;
    var phi_2519_: bool;
    var phi_2523_: type_30;
    var phi_2546_: u32;
    var phi_2560_: i32;
    var phi_2582_: vec3<f32>;
    var phi_2583_: vec3<f32>;
    var phi_2601_: vec3<f32>;
    var phi_2602_: vec3<f32>;
    var phi_2620_: vec3<f32>;
    var phi_2621_: vec3<f32>;
    var phi_2657_: vec3<f32>;
    var phi_2839_: f32;
    var phi_2857_: bool;
    var phi_2858_: bool;
    var phi_2863_: type_51;
    var phi_2864_: type_51;
    var phi_1486_: type_51;
    var phi_4368_: bool;
    var local_10: type_51;
    var phi_4564_: bool;
    var phi_4102_: type_51;
    var phi_4103_: bool;
    var phi_4104_: u32;
    var phi_4105_: type_63;
    var phi_4563_: bool;
    var phi_4106_: type_51;
    var phi_4107_: bool;
    var phi_4108_: u32;
    var phi_4109_: u32;
    var phi_4110_: type_63;
    var phi_4562_: bool;
    var phi_4111_: type_51;
    var phi_4112_: bool;
    var phi_4113_: u32;
    var phi_4114_: u32;
    var phi_4115_: type_63;
    var phi_4561_: bool;
    var phi_1360_: type_51;
    var phi_1363_: bool;
    var phi_1365_: u32;
    var phi_1367_: u32;
    var phi_1369_: type_63;
    var phi_4116_: bool;
    var phi_4560_: bool;
    var local_11: type_51;
    var local_12: type_51;

    switch bitcast<i32>(0u) {
        default: {
            let _e99 = global;
            let _e101 = arrayLength((&global_5.member));
            let _e103 = arrayLength((&global_6.member));
            let _e115 = arrayLength((&global_9.member));
            let _e119 = global_4.member[0u][0u];
            let _e123 = global_4.member[0u][1u];
            let _e127 = global_4.member[0u][2u];
            let _e131 = global_4.member[0u][3u];
            let _e135 = global_4.member[1u][0u];
            let _e139 = global_4.member[1u][1u];
            let _e143 = global_4.member[1u][2u];
            let _e147 = (_e99.x + (_e99.y * 2097152u));
            let _e159 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e131) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            local = array<i32, 3>(bitcast<i32>(_e135), bitcast<i32>(_e139), bitcast<i32>(_e143));
            let _e162 = (_e147 < arrayLength((&global_10.member)));
            if _e162 {
                if _e162 {
                } else {
                    break;
                }
                let _e166 = global_10.member[_e147].member_2;
                phi_336_ = _e166;
            } else {
                phi_336_ = 4294967295u;
            }
            let _e168 = phi_336_;
            let _e171 = global_1.member[0u];
            let _e175 = global_3.member[0u][0u];
            let _e179 = global_3.member[0u][1u];
            let _e183 = global_3.member[0u][2u];
            let _e187 = global_3.member[0u][3u];
            let _e191 = global_3.member[1u][0u];
            let _e195 = global_3.member[1u][1u];
            let _e199 = global_3.member[1u][2u];
            let _e203 = global_3.member[1u][3u];
            let _e204 = bitcast<f32>(_e175);
            let _e205 = bitcast<f32>(_e179);
            let _e206 = bitcast<f32>(_e183);
            let _e208 = bitcast<f32>(_e191);
            let _e209 = array<u32, 3>(_e195, _e199, _e203);
            let _e211 = bitcast<i32>(_e171);
            if (_e211 < -126i) {
                phi_380_ = -126i;
            } else {
                phi_380_ = select(_e211, 127i, (_e211 > 127i));
            }
            let _e216 = phi_380_;
            let _e221 = bitcast<f32>((bitcast<u32>((_e216 + 127i)) << bitcast<u32>(23i)));
            let _e227 = bitcast<f32>((bitcast<u32>(((_e211 - _e216) + 127i)) << bitcast<u32>(23i)));
            if (_e187 == 0u) {
                phi_520_ = type_45(array<f32, 3>(_e204, _e205, _e206), _e187, _e208, _e209);
            } else {
                let _e229 = bitcast<u32>(_e204);
                let _e231 = ((_e229 & 2139095040u) != 0u);
                let _e246 = bitcast<u32>(_e205);
                let _e248 = ((_e246 & 2139095040u) != 0u);
                let _e263 = bitcast<u32>(_e206);
                let _e265 = ((_e263 & 2139095040u) != 0u);
                let _e281 = bitcast<u32>(_e208);
                let _e283 = ((_e281 & 2139095040u) != 0u);
                phi_520_ = type_45(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e229 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e229 & 2147483648u))), _e204, _e231) * _e221) * select(0.00000011920929f, 1f, _e231)) * _e227), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e246 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e246 & 2147483648u))), _e205, _e248) * _e221) * select(0.00000011920929f, 1f, _e248)) * _e227), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e263 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e263 & 2147483648u))), _e206, _e265) * _e221) * select(0.00000011920929f, 1f, _e265)) * _e227)), _e187, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e281 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e281 & 2147483648u))), _e208, _e283) * _e221) * select(0.00000011920929f, 1f, _e283)) * _e227), _e209);
            }
            let _e300 = phi_520_;
            if _e162 {
                let _e301 = (_e147 < arrayLength((&global_2.member)));
                if _e301 {
                    if _e162 {
                    } else {
                        break;
                    }
                    let _e306 = global_10.member[_e147].member.member_1;
                    let _e311 = global_10.member[_e147].member.member_3;
                    if (_e306 <= _e311) {
                        let _e313 = (1u < _e115);
                        if _e313 {
                            if (0u < _e115) {
                            } else {
                                break;
                            }
                            let _e317 = atomicAdd((&global_9.member[0u]), 1u);
                            if ((_e317 + 1u) < _e317) {
                                if _e313 {
                                } else {
                                    break;
                                }
                                let _e322 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                        if _e162 {
                        } else {
                            break;
                        }
                        let _e332 = global_10.member[_e147].member.member_2[0u];
                        let _e334 = (bitcast<u32>(_e332) & 2147483647u);
                        let _e340 = global_10.member[_e147].member.member_2[1u];
                        let _e342 = (bitcast<u32>(_e340) & 2147483647u);
                        let _e348 = global_10.member[_e147].member.member_2[2u];
                        let _e350 = (bitcast<u32>(_e348) & 2147483647u);
                        let _e356 = global_10.member[_e147].member.member[0u];
                        let _e358 = (bitcast<u32>(_e356) & 2147483647u);
                        let _e364 = global_10.member[_e147].member.member[1u];
                        let _e366 = (bitcast<u32>(_e364) & 2147483647u);
                        let _e372 = global_10.member[_e147].member.member[2u];
                        let _e374 = (bitcast<u32>(_e372) & 2147483647u);
                        let _e376 = select(_e342, _e334, (_e342 < _e334));
                        let _e378 = select(_e350, _e376, (_e350 < _e376));
                        let _e380 = select(_e358, _e378, (_e358 < _e378));
                        let _e382 = select(_e366, _e380, (_e366 < _e380));
                        let _e384 = select(_e374, _e382, (_e374 < _e382));
                        let _e385 = bitcast<u32>(_e306);
                        let _e386 = (_e385 & 2147483647u);
                        let _e390 = bitcast<u32>(_e311);
                        let _e391 = (_e390 & 2147483647u);
                        let _e395 = (((select(_e386, _e384, (_e386 < _e384)) < 2139095040u) && (_e391 <= 2139095040u)) && (_e378 > 0u));
                        if _e395 {
                            let _e398 = (bitcast<u32>(bitcast<f32>(_e378)) & 2147483647u);
                            if (_e398 >= 8388608u) {
                                phi_670_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_670_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                            }
                            let _e412 = phi_670_;
                            phi_671_ = _e412;
                        } else {
                            phi_671_ = 0i;
                        }
                        let _e414 = phi_671_;
                        let _e415 = (_e334 == _e378);
                        if _e415 {
                            phi_681_ = true;
                        } else {
                            phi_681_ = (_e342 == _e378);
                        }
                        let _e418 = phi_681_;
                        let _e419 = select(1u, 0u, _e415);
                        if _e418 {
                            let _e420 = (_e419 + 1u);
                            phi_691_ = _e420;
                            phi_692_ = _e420;
                            phi_694_ = select(true, false, (_e420 == 2u));
                        } else {
                            phi_691_ = u32();
                            phi_692_ = 0u;
                            phi_694_ = true;
                        }
                        let _e424 = phi_691_;
                        let _e426 = phi_692_;
                        let _e428 = phi_694_;
                        if _e428 {
                            phi_699_ = (_e426 + 1u);
                        } else {
                            phi_699_ = 0u;
                        }
                        let _e432 = phi_699_;
                        let _e433 = select(_e424, _e426, _e428);
                        let _e434 = select(_e419, select(2u, _e419, _e418), _e428);
                        let _e435 = -(_e414);
                        if (_e435 < -126i) {
                            phi_732_ = -126i;
                        } else {
                            phi_732_ = select(_e435, 127i, (_e435 > 127i));
                        }
                        let _e440 = phi_732_;
                        let _e445 = bitcast<f32>((bitcast<u32>((_e440 + 127i)) << bitcast<u32>(23i)));
                        let _e451 = bitcast<f32>((bitcast<u32>(((_e435 - _e440) + 127i)) << bitcast<u32>(23i)));
                        let _e456 = global_10.member[_e147].member.member;
                        let _e457 = (_e433 == 0u);
                        if _e457 {
                            phi_750_ = _e456[0];
                        } else {
                            phi_750_ = _e456[1];
                        }
                        let _e461 = phi_750_;
                        let _e462 = (_e433 == 2u);
                        if _e462 {
                            phi_756_ = _e456[2];
                        } else {
                            phi_756_ = _e461;
                        }
                        let _e465 = phi_756_;
                        let _e466 = bitcast<u32>(_e465);
                        let _e468 = ((_e466 & 2139095040u) != 0u);
                        let _e480 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e466 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e466 & 2147483648u))), _e465, _e468) * select(0.00000011920929f, 1f, _e468));
                        let _e481 = global_10.member[_e147].member.member_2;
                        if _e457 {
                            phi_796_ = _e481[0];
                        } else {
                            phi_796_ = _e481[1];
                        }
                        let _e485 = phi_796_;
                        if _e462 {
                            phi_802_ = _e481[2];
                        } else {
                            phi_802_ = _e485;
                        }
                        let _e488 = phi_802_;
                        let _e489 = bitcast<u32>(_e488);
                        let _e491 = ((_e489 & 2139095040u) != 0u);
                        let _e505 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e489 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e489 & 2147483648u))), _e488, _e491) * _e445) * select(0.00000011920929f, 1f, _e491)) * _e451);
                        let _e509 = (bitcast<f32>((bitcast<u32>(_e505) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e509 {
                            let _e513 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) * 0.00000011920929f);
                            phi_854_ = select(0.00000000000011368684f, _e513, (_e513 > 0.00000000000011368684f));
                        } else {
                            phi_854_ = 0f;
                        }
                        let _e517 = phi_854_;
                        let _e518 = (_e480 + _e517);
                        let _e519 = (_e480 - _e517);
                        let _e520 = select(_e505, 0f, _e509);
                        if _e509 {
                            phi_866_ = 38685626000000000000000000f;
                        } else {
                            phi_866_ = (1f / _e505);
                        }
                        let _e523 = phi_866_;
                        let _e524 = (_e432 == 0u);
                        if _e524 {
                            phi_875_ = _e456[0];
                        } else {
                            phi_875_ = _e456[1];
                        }
                        let _e528 = phi_875_;
                        let _e529 = (_e432 == 2u);
                        if _e529 {
                            phi_881_ = _e456[2];
                        } else {
                            phi_881_ = _e528;
                        }
                        let _e532 = phi_881_;
                        let _e533 = bitcast<u32>(_e532);
                        let _e535 = ((_e533 & 2139095040u) != 0u);
                        let _e547 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e533 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e533 & 2147483648u))), _e532, _e535) * select(0.00000011920929f, 1f, _e535));
                        if _e524 {
                            phi_921_ = _e481[0];
                        } else {
                            phi_921_ = _e481[1];
                        }
                        let _e551 = phi_921_;
                        if _e529 {
                            phi_927_ = _e481[2];
                        } else {
                            phi_927_ = _e551;
                        }
                        let _e554 = phi_927_;
                        let _e555 = bitcast<u32>(_e554);
                        let _e557 = ((_e555 & 2139095040u) != 0u);
                        let _e571 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e555 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e555 & 2147483648u))), _e554, _e557) * _e445) * select(0.00000011920929f, 1f, _e557)) * _e451);
                        let _e575 = (bitcast<f32>((bitcast<u32>(_e571) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e575 {
                            let _e579 = (bitcast<f32>((bitcast<u32>(_e547) & 2147483647u)) * 0.00000011920929f);
                            phi_979_ = select(0.00000000000011368684f, _e579, (_e579 > 0.00000000000011368684f));
                        } else {
                            phi_979_ = 0f;
                        }
                        let _e583 = phi_979_;
                        let _e584 = (_e547 + _e583);
                        let _e585 = (_e547 - _e583);
                        let _e586 = select(_e571, 0f, _e575);
                        if _e575 {
                            phi_991_ = 38685626000000000000000000f;
                        } else {
                            phi_991_ = (1f / _e571);
                        }
                        let _e589 = phi_991_;
                        let _e590 = (_e434 == 0u);
                        if _e590 {
                            phi_1000_ = _e456[0];
                        } else {
                            phi_1000_ = _e456[1];
                        }
                        let _e594 = phi_1000_;
                        let _e595 = (_e434 == 2u);
                        if _e595 {
                            phi_1006_ = _e456[2];
                        } else {
                            phi_1006_ = _e594;
                        }
                        let _e598 = phi_1006_;
                        let _e599 = bitcast<u32>(_e598);
                        let _e601 = ((_e599 & 2139095040u) != 0u);
                        let _e613 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e599 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e599 & 2147483648u))), _e598, _e601) * select(0.00000011920929f, 1f, _e601));
                        if _e590 {
                            phi_1046_ = _e481[0];
                        } else {
                            phi_1046_ = _e481[1];
                        }
                        let _e617 = phi_1046_;
                        if _e595 {
                            phi_1052_ = _e481[2];
                        } else {
                            phi_1052_ = _e617;
                        }
                        let _e620 = phi_1052_;
                        let _e621 = bitcast<u32>(_e620);
                        let _e623 = ((_e621 & 2139095040u) != 0u);
                        let _e637 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e621 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e621 & 2147483648u))), _e620, _e623) * _e445) * select(0.00000011920929f, 1f, _e623)) * _e451);
                        let _e641 = (bitcast<f32>((bitcast<u32>(_e637) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e641 {
                            let _e645 = (bitcast<f32>((bitcast<u32>(_e613) & 2147483647u)) * 0.00000011920929f);
                            phi_1104_ = select(0.00000000000011368684f, _e645, (_e645 > 0.00000000000011368684f));
                        } else {
                            phi_1104_ = 0f;
                        }
                        let _e649 = phi_1104_;
                        let _e650 = (_e613 + _e649);
                        let _e651 = (_e613 - _e649);
                        let _e652 = select(_e637, 0f, _e641);
                        if _e641 {
                            phi_1116_ = 38685626000000000000000000f;
                        } else {
                            phi_1116_ = (1f / _e637);
                        }
                        let _e655 = phi_1116_;
                        let _e658 = bitcast<f32>((bitcast<u32>(_e480) & 2147483647u));
                        let _e661 = bitcast<f32>((bitcast<u32>(_e547) & 2147483647u));
                        let _e663 = select(_e661, _e658, (_e658 > _e661));
                        let _e666 = bitcast<f32>((bitcast<u32>(_e613) & 2147483647u));
                        if (_e395 && (select(_e666, _e663, (_e663 > _e666)) <= 1099511600000f)) {
                            let _e678 = ((_e386 & 8388607u) | (select(0u, 1u, ((_e386 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e681 = bitcast<i32>((_e386 >> bitcast<u32>(23i)));
                            let _e685 = (_e678 == 0u);
                            let _e688 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e678)), 32u, _e685)) - 8i);
                            if (_e681 == 255i) {
                                phi_1171_ = 255i;
                            } else {
                                phi_1171_ = (((_e681 + select(0i, 1i, (_e681 == 0i))) - _e688) + _e414);
                            }
                            let _e696 = phi_1171_;
                            let _e706 = (_e696 <= 0i);
                            if _e706 {
                                phi_1194_ = u32();
                            } else {
                                if _e685 {
                                    phi_1193_ = u32();
                                } else {
                                    phi_1193_ = select(((bitcast<u32>(_e696) << bitcast<u32>(23i)) | ((_e678 << bitcast<u32>(((_e688 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e696 >= 255i));
                                }
                                let _e710 = phi_1193_;
                                phi_1194_ = _e710;
                            }
                            let _e712 = phi_1194_;
                            let _e724 = ((_e391 & 8388607u) | (select(0u, 1u, ((_e391 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e727 = bitcast<i32>((_e391 >> bitcast<u32>(23i)));
                            let _e731 = (_e724 == 0u);
                            let _e734 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e724)), 32u, _e731)) - 8i);
                            if (_e727 == 255i) {
                                phi_1231_ = 255i;
                            } else {
                                phi_1231_ = (((_e727 + select(0i, 1i, (_e727 == 0i))) - _e734) + _e414);
                            }
                            let _e742 = phi_1231_;
                            let _e752 = (_e742 <= 0i);
                            if _e752 {
                                phi_1254_ = u32();
                            } else {
                                if _e731 {
                                    phi_1253_ = u32();
                                } else {
                                    phi_1253_ = select(((bitcast<u32>(_e742) << bitcast<u32>(23i)) | ((_e724 << bitcast<u32>(((_e734 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e742 >= 255i));
                                }
                                let _e756 = phi_1253_;
                                phi_1254_ = _e756;
                            }
                            let _e758 = phi_1254_;
                            phi_1262_ = bitcast<f32>(((_e390 & 2147483648u) | select(_e758, 0u, select(_e731, true, _e752))));
                            phi_1263_ = bitcast<f32>(((_e385 & 2147483648u) | select(_e712, 0u, select(_e685, true, _e706))));
                        } else {
                            phi_1262_ = 0f;
                            phi_1263_ = 1f;
                        }
                        let _e764 = phi_1262_;
                        let _e766 = phi_1263_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e770 = (_e433 % 3u);
                        let _e771 = (_e770 < 3u);
                        if _e771 {
                        } else {
                            break;
                        }
                        let _e773 = local_1[_e770];
                        let _e776 = (_e432 % 3u);
                        let _e777 = (_e776 < 3u);
                        if _e777 {
                        } else {
                            break;
                        }
                        let _e779 = local_1[_e776];
                        let _e782 = (_e434 % 3u);
                        let _e783 = (_e782 < 3u);
                        if _e783 {
                        } else {
                            break;
                        }
                        let _e785 = local_1[_e782];
                        if _e771 {
                        } else {
                            break;
                        }
                        let _e790 = local[_e770];
                        if _e777 {
                        } else {
                            break;
                        }
                        let _e794 = local[_e776];
                        if _e783 {
                        } else {
                            break;
                        }
                        let _e798 = local[_e782];
                        phi_4374_ = false;
                        phi_1359_ = type_51(_e764, false);
                        phi_1362_ = (_e766 <= _e764);
                        phi_1364_ = ((3u * _e101) + 1u);
                        phi_1366_ = 0u;
                        phi_1368_ = type_63(type_39(vec4<f32>((f32(_e773) * _e159), (f32(_e779) * _e159), (f32(_e785) * _e159), 0f), vec4<f32>((f32(_e790) * _e159), (f32(_e794) * _e159), (f32(_e798) * _e159), 0f)), select(0u, 2147483648u, (_e101 == 0u)));
                        loop {
                            let _e808 = phi_4374_;
                            let _e810 = phi_1359_;
                            let _e812 = phi_1362_;
                            let _e814 = phi_1364_;
                            let _e816 = phi_1366_;
                            let _e818 = phi_1368_;
                            local_11 = _e810;
                            if _e812 {
                                phi_1379_ = true;
                            } else {
                                phi_1379_ = (_e816 > 0u);
                            }
                            let _e821 = phi_1379_;
                            if _e821 {
                                let _e822 = (_e814 > 0u);
                                if _e822 {
                                    if _e812 {
                                        phi_1465_ = _e812;
                                        phi_1466_ = _e816;
                                        phi_1467_ = _e818;
                                    } else {
                                        let _e823 = (_e816 - 1u);
                                        let _e824 = (_e823 % 128u);
                                        let _e825 = (_e824 < 128u);
                                        if _e825 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e827 = local_7[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e829 = local_6[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e831 = local_5[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e833 = local_4[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e835 = local_3[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e837 = local_2[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e842 = local_8[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4560_ = true;
                                            break;
                                        }
                                        let _e845 = local_9[_e824];
                                        phi_1465_ = (_e845 <= _e810.member);
                                        phi_1466_ = _e823;
                                        phi_1467_ = type_63(type_39(vec4<f32>(_e827, _e829, _e831, 0f), vec4<f32>(_e833, _e835, _e837, 0f)), _e842);
                                    }
                                    let _e849 = phi_1465_;
                                    let _e851 = phi_1466_;
                                    let _e853 = phi_1467_;
                                    if _e849 {
                                        if ((_e853.member_1 & 2147483648u) != 0u) {
                                            phi_1485_ = _e810;
                                            phi_1488_ = type_8(0u, ((_e853.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1303 = phi_1485_;
                                                let _e1305 = phi_1488_;
                                                local_10 = _e1303;
                                                local_12 = _e1303;
                                                if (_e1305.member < _e1305.member_1) {
                                                    phi_1489_ = type_8((_e1305.member + 1u), _e1305.member_1);
                                                    phi_1511_ = type_8(1u, _e1305.member);
                                                } else {
                                                    phi_1489_ = _e1305;
                                                    phi_1511_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1318 = phi_1489_;
                                                let _e1320 = phi_1511_;
                                                let _e1324 = (bitcast<i32>(_e1320.member) != 0i);
                                                if _e1324 {
                                                    let _e1325 = ((_e853.member_1 & 268435455u) + _e1320.member_1);
                                                    let _e1326 = (_e1325 < _e103);
                                                    if _e1326 {
                                                        if _e1326 {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1330 = global_6.member[_e1325].member_1;
                                                        phi_1532_ = _e1330;
                                                    } else {
                                                        phi_1532_ = 4294967295u;
                                                    }
                                                    let _e1332 = phi_1532_;
                                                    if (_e1325 >= _e103) {
                                                        phi_1624_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1326 {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        if (_e770 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1339 = global_6.member[_e1325].member[_e770];
                                                        if (_e776 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1345 = global_6.member[_e1325].member[_e776];
                                                        if (_e782 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1351 = global_6.member[_e1325].member[_e782];
                                                        let _e1353 = (3u + _e770);
                                                        if (_e1353 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1359 = global_6.member[_e1325].member[_e1353];
                                                        let _e1360 = (3u + _e776);
                                                        if (_e1360 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1366 = global_6.member[_e1325].member[_e1360];
                                                        let _e1367 = (3u + _e782);
                                                        if (_e1367 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1373 = global_6.member[_e1325].member[_e1367];
                                                        let _e1375 = (6u + _e770);
                                                        if (_e1375 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1381 = global_6.member[_e1325].member[_e1375];
                                                        let _e1382 = (6u + _e776);
                                                        if (_e1382 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1388 = global_6.member[_e1325].member[_e1382];
                                                        let _e1389 = (6u + _e782);
                                                        if (_e1389 < 9u) {
                                                        } else {
                                                            phi_4368_ = true;
                                                            break;
                                                        }
                                                        let _e1395 = global_6.member[_e1325].member[_e1389];
                                                        phi_1624_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1339, _e1345, _e1351), array<f32, 3>(_e1359, _e1366, _e1373), array<f32, 3>(_e1381, _e1388, _e1395));
                                                    }
                                                    let _e1399 = phi_1624_;
                                                    let _e1407 = (_e1399[0][2] - _e613);
                                                    let _e1410 = (((_e1399[0][0] - _e480) * _e652) - (_e1407 * _e520));
                                                    let _e1413 = (((_e1399[0][1] - _e547) * _e652) - (_e1407 * _e586));
                                                    let _e1420 = (_e1399[1][2] - _e613);
                                                    let _e1423 = (((_e1399[1][0] - _e480) * _e652) - (_e1420 * _e520));
                                                    let _e1426 = (((_e1399[1][1] - _e547) * _e652) - (_e1420 * _e586));
                                                    let _e1433 = (_e1399[2][2] - _e613);
                                                    let _e1436 = (((_e1399[2][0] - _e480) * _e652) - (_e1433 * _e520));
                                                    let _e1439 = (((_e1399[2][1] - _e547) * _e652) - (_e1433 * _e586));
                                                    let _e1440 = (_e1436 * _e1426);
                                                    let _e1441 = (_e1439 * _e1423);
                                                    let _e1442 = (_e1410 * _e1439);
                                                    let _e1443 = (_e1413 * _e1436);
                                                    let _e1444 = (_e1423 * _e1413);
                                                    let _e1445 = (_e1426 * _e1410);
                                                    let _e1450 = (((_e1440 >= _e1441) && (_e1442 >= _e1443)) && (_e1444 >= _e1445));
                                                    if (_e1450 || (((_e1440 <= _e1441) && (_e1442 <= _e1443)) && (_e1444 <= _e1445))) {
                                                        let _e1457 = select(-1f, 1f, _e1450);
                                                        let _e1459 = ((_e1440 - _e1441) * _e1457);
                                                        let _e1461 = select(0f, _e1459, (_e1459 > 0f));
                                                        let _e1463 = ((_e1442 - _e1443) * _e1457);
                                                        let _e1465 = select(0f, _e1463, (_e1463 > 0f));
                                                        let _e1467 = ((_e1444 - _e1445) * _e1457);
                                                        let _e1469 = select(0f, _e1467, (_e1467 > 0f));
                                                        let _e1471 = ((_e1461 + _e1465) + _e1469);
                                                        if (_e1471 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2508_ = type_30();
                                                            phi_2509_ = true;
                                                            phi_2510_ = false;
                                                        } else {
                                                            let _e1474 = select(_e1423, _e1410, (_e1410 < _e1423));
                                                            if (select(_e1436, _e1474, (_e1474 < _e1436)) > 0f) {
                                                                phi_1776_ = true;
                                                            } else {
                                                                let _e1479 = select(_e1423, _e1410, (_e1410 > _e1423));
                                                                phi_1776_ = (select(_e1436, _e1479, (_e1479 > _e1436)) < 0f);
                                                            }
                                                            let _e1484 = phi_1776_;
                                                            if _e1484 {
                                                                phi_2505_ = type_30();
                                                                phi_2506_ = true;
                                                                phi_2507_ = false;
                                                            } else {
                                                                let _e1486 = select(_e1426, _e1413, (_e1413 < _e1426));
                                                                if (select(_e1439, _e1486, (_e1486 < _e1439)) > 0f) {
                                                                    phi_1805_ = true;
                                                                } else {
                                                                    let _e1491 = select(_e1426, _e1413, (_e1413 > _e1426));
                                                                    phi_1805_ = (select(_e1439, _e1491, (_e1491 > _e1439)) < 0f);
                                                                }
                                                                let _e1496 = phi_1805_;
                                                                if _e1496 {
                                                                    phi_2503_ = type_30();
                                                                    phi_2504_ = false;
                                                                } else {
                                                                    let _e1498 = select(_e1399[1][0], _e1399[0][0], (_e1399[0][0] < _e1399[1][0]));
                                                                    let _e1502 = select(_e1399[1][0], _e1399[0][0], (_e1399[0][0] > _e1399[1][0]));
                                                                    let _e1506 = select(_e1399[1][1], _e1399[0][1], (_e1399[0][1] < _e1399[1][1]));
                                                                    let _e1510 = select(_e1399[1][1], _e1399[0][1], (_e1399[0][1] > _e1399[1][1]));
                                                                    let _e1514 = select(_e1399[1][2], _e1399[0][2], (_e1399[0][2] < _e1399[1][2]));
                                                                    let _e1518 = select(_e1399[1][2], _e1399[0][2], (_e1399[0][2] > _e1399[1][2]));
                                                                    let _e1523 = ((select(_e1399[2][0], _e1498, (_e1498 < _e1399[2][0])) - _e518) * _e523);
                                                                    let _e1524 = ((select(_e1399[2][0], _e1502, (_e1502 > _e1399[2][0])) - _e519) * _e523);
                                                                    let _e1527 = ((select(_e1399[2][1], _e1506, (_e1506 < _e1399[2][1])) - _e584) * _e589);
                                                                    let _e1528 = ((select(_e1399[2][1], _e1510, (_e1510 > _e1399[2][1])) - _e585) * _e589);
                                                                    let _e1531 = ((select(_e1399[2][2], _e1514, (_e1514 < _e1399[2][2])) - _e650) * _e655);
                                                                    let _e1532 = ((select(_e1399[2][2], _e1518, (_e1518 > _e1399[2][2])) - _e651) * _e655);
                                                                    let _e1534 = select(_e1532, _e1531, (_e1531 < _e1532));
                                                                    let _e1536 = select(_e1532, _e1531, (_e1531 > _e1532));
                                                                    let _e1538 = select(_e1524, _e1523, (_e1523 < _e1524));
                                                                    let _e1540 = select(_e1528, _e1527, (_e1527 < _e1528));
                                                                    let _e1542 = select(_e1540, _e1538, (_e1538 > _e1540));
                                                                    let _e1544 = select(_e1534, _e1542, (_e1542 > _e1534));
                                                                    let _e1546 = select(_e1524, _e1523, (_e1523 > _e1524));
                                                                    let _e1548 = select(_e1528, _e1527, (_e1527 > _e1528));
                                                                    let _e1550 = select(_e1548, _e1546, (_e1546 < _e1548));
                                                                    let _e1552 = select(_e1536, _e1550, (_e1550 < _e1536));
                                                                    let _e1553 = -(_e1534);
                                                                    let _e1559 = select(_e766, _e1544, (_e1544 > _e766));
                                                                    if (_e1559 > (_e1552 + (select(_e1553, _e1536, (_e1536 > _e1553)) * 0.0000019073523f))) {
                                                                        phi_2498_ = type_30();
                                                                        phi_2499_ = true;
                                                                    } else {
                                                                        let _e1561 = (_e1559 > _e1303.member);
                                                                        if _e1561 {
                                                                            phi_2497_ = type_30();
                                                                        } else {
                                                                            let _e1562 = vec3<f32>(_e1399[0][0], _e1399[0][1], _e1399[0][2]);
                                                                            let _e1563 = vec3<f32>(_e1399[1][0], _e1399[1][1], _e1399[1][2]);
                                                                            let _e1564 = vec3<f32>(_e1399[2][0], _e1399[2][1], _e1399[2][2]);
                                                                            let _e1565 = (_e1399[1][0] - _e1399[0][0]);
                                                                            let _e1566 = (_e1399[1][1] - _e1399[0][1]);
                                                                            let _e1567 = (_e1399[1][2] - _e1399[0][2]);
                                                                            let _e1568 = vec3<f32>(_e1565, _e1566, _e1567);
                                                                            let _e1569 = (_e1399[2][0] - _e1399[1][0]);
                                                                            let _e1570 = (_e1399[2][1] - _e1399[1][1]);
                                                                            let _e1571 = (_e1399[2][2] - _e1399[1][2]);
                                                                            let _e1572 = vec3<f32>(_e1569, _e1570, _e1571);
                                                                            let _e1573 = (_e1399[0][0] - _e1399[2][0]);
                                                                            let _e1574 = (_e1399[0][1] - _e1399[2][1]);
                                                                            let _e1575 = (_e1399[0][2] - _e1399[2][2]);
                                                                            let _e1576 = vec3<f32>(_e1573, _e1574, _e1575);
                                                                            let _e1579 = bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u));
                                                                            let _e1582 = bitcast<f32>((bitcast<u32>(_e1566) & 2147483647u));
                                                                            let _e1584 = select(_e1582, _e1579, (_e1579 > _e1582));
                                                                            let _e1587 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                                            let _e1589 = select(_e1587, _e1584, (_e1584 > _e1587));
                                                                            let _e1592 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                                            let _e1595 = bitcast<f32>((bitcast<u32>(_e1570) & 2147483647u));
                                                                            let _e1597 = select(_e1595, _e1592, (_e1592 > _e1595));
                                                                            let _e1600 = bitcast<f32>((bitcast<u32>(_e1571) & 2147483647u));
                                                                            let _e1602 = select(_e1600, _e1597, (_e1597 > _e1600));
                                                                            let _e1605 = bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u));
                                                                            let _e1608 = bitcast<f32>((bitcast<u32>(_e1574) & 2147483647u));
                                                                            let _e1610 = select(_e1608, _e1605, (_e1605 > _e1608));
                                                                            let _e1613 = bitcast<f32>((bitcast<u32>(_e1575) & 2147483647u));
                                                                            let _e1615 = select(_e1613, _e1610, (_e1610 > _e1613));
                                                                            let _e1617 = select(_e1602, _e1589, (_e1589 > _e1602));
                                                                            let _e1619 = select(_e1615, _e1617, (_e1617 > _e1615));
                                                                            if (_e1589 == _e1619) {
                                                                                phi_2224_ = _e1426;
                                                                                phi_2225_ = _e1423;
                                                                                phi_2226_ = _e1413;
                                                                                phi_2227_ = _e1410;
                                                                                phi_2228_ = _e1562;
                                                                                phi_2229_ = _e1576;
                                                                                phi_2230_ = _e1572;
                                                                                phi_2231_ = _e1568;
                                                                            } else {
                                                                                let _e1621 = (_e1602 == _e1619);
                                                                                let _e1626 = vec3(_e1621);
                                                                                phi_2224_ = select(_e1413, _e1439, _e1621);
                                                                                phi_2225_ = select(_e1410, _e1436, _e1621);
                                                                                phi_2226_ = select(_e1439, _e1426, _e1621);
                                                                                phi_2227_ = select(_e1436, _e1423, _e1621);
                                                                                phi_2228_ = select(_e1564, _e1563, _e1626);
                                                                                phi_2229_ = select(_e1572, _e1568, _e1626);
                                                                                phi_2230_ = select(_e1568, _e1576, _e1626);
                                                                                phi_2231_ = select(_e1576, _e1572, _e1626);
                                                                            }
                                                                            let _e1632 = phi_2224_;
                                                                            let _e1634 = phi_2225_;
                                                                            let _e1636 = phi_2226_;
                                                                            let _e1638 = phi_2227_;
                                                                            let _e1640 = phi_2228_;
                                                                            let _e1642 = phi_2229_;
                                                                            let _e1644 = phi_2230_;
                                                                            let _e1646 = phi_2231_;
                                                                            let _e1653 = ((_e1644.y * _e1642.z) - (_e1642.y * _e1644.z));
                                                                            let _e1658 = ((_e1644.z * _e1642.x) - (_e1642.z * _e1644.x));
                                                                            let _e1661 = ((_e1644.x * _e1642.y) - (_e1642.x * _e1644.y));
                                                                            if (_e1461 >= _e1465) {
                                                                                phi_2268_ = select(true, false, (_e1461 >= _e1469));
                                                                            } else {
                                                                                phi_2268_ = true;
                                                                            }
                                                                            let _e1666 = phi_2268_;
                                                                            if _e1666 {
                                                                                phi_2277_ = select(_e1564, _e1563, vec3((_e1465 >= _e1469)));
                                                                            } else {
                                                                                phi_2277_ = _e1562;
                                                                            }
                                                                            let _e1671 = phi_2277_;
                                                                            let _e1682 = (((_e1653 * (_e1671.x - _e480)) + (_e1658 * (_e1671.y - _e547))) + (_e1661 * (_e1671.z - _e613)));
                                                                            let _e1687 = (((_e1653 * _e520) + (_e1658 * _e586)) + (_e1661 * _e652));
                                                                            let _e1688 = (_e1634 - _e1638);
                                                                            let _e1689 = (_e1632 - _e1636);
                                                                            let _e1697 = (-(((_e1638 * _e1688) + (_e1636 * _e1689))) / ((_e1688 * _e1688) + (_e1689 * _e1689)));
                                                                            let _e1699 = select(1f, _e1697, (_e1697 < 1f));
                                                                            let _e1701 = select(0f, _e1699, (_e1699 > 0f));
                                                                            let _e1714 = ((_e1640.x + (_e1646.x * _e1701)) - _e480);
                                                                            let _e1715 = ((_e1640.y + (_e1646.y * _e1701)) - _e547);
                                                                            let _e1716 = ((_e1640.z + (_e1646.z * _e1701)) - _e613);
                                                                            let _e1717 = (_e1716 / _e652);
                                                                            let _e1729 = bitcast<f32>((bitcast<u32>(_e1714) & 2147483647u));
                                                                            let _e1732 = bitcast<f32>((bitcast<u32>(_e1715) & 2147483647u));
                                                                            let _e1734 = select(_e1732, _e1729, (_e1729 > _e1732));
                                                                            let _e1737 = bitcast<f32>((bitcast<u32>(_e1716) & 2147483647u));
                                                                            let _e1739 = select(_e1737, _e1734, (_e1734 > _e1737));
                                                                            let _e1745 = bitcast<f32>((bitcast<u32>(_e1653) & 2147483647u));
                                                                            let _e1748 = bitcast<f32>((bitcast<u32>(_e1658) & 2147483647u));
                                                                            let _e1750 = select(_e1748, _e1745, (_e1745 > _e1748));
                                                                            let _e1753 = bitcast<f32>((bitcast<u32>(_e1661) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1653 * _e1714) + (_e1658 * _e1715)) + (_e1661 * _e1716)) - _e1682)) & 2147483647u)) <= ((0.0000009536743f * select(_e1619, _e1739, (_e1739 > _e1619))) * select(_e1753, _e1750, (_e1750 > _e1753)))) {
                                                                                let _e1763 = bitcast<f32>((bitcast<u32>(_e1644.x) & 2147483647u));
                                                                                let _e1766 = bitcast<f32>((bitcast<u32>(_e1644.y) & 2147483647u));
                                                                                let _e1768 = select(_e1766, _e1763, (_e1763 > _e1766));
                                                                                let _e1771 = bitcast<f32>((bitcast<u32>(_e1644.z) & 2147483647u));
                                                                                let _e1777 = bitcast<f32>((bitcast<u32>(_e1642.x) & 2147483647u));
                                                                                let _e1780 = bitcast<f32>((bitcast<u32>(_e1642.y) & 2147483647u));
                                                                                let _e1782 = select(_e1780, _e1777, (_e1777 > _e1780));
                                                                                let _e1785 = bitcast<f32>((bitcast<u32>(_e1642.z) & 2147483647u));
                                                                                let _e1789 = (bitcast<f32>((bitcast<u32>(_e1687) & 2147483647u)) > ((0.0000038146973f * select(_e1771, _e1768, (_e1768 > _e1771))) * select(_e1785, _e1782, (_e1782 > _e1785))));
                                                                                if _e1789 {
                                                                                    phi_2442_ = (_e1682 / _e1687);
                                                                                } else {
                                                                                    phi_2442_ = f32();
                                                                                }
                                                                                let _e1792 = phi_2442_;
                                                                                phi_2444_ = _e1792;
                                                                                phi_2445_ = select(true, false, _e1789);
                                                                            } else {
                                                                                phi_2444_ = f32();
                                                                                phi_2445_ = true;
                                                                            }
                                                                            let _e1795 = phi_2444_;
                                                                            let _e1797 = phi_2445_;
                                                                            if _e1797 {
                                                                                let _e1805 = (((_e1653 * (_e1714 - (_e520 * _e1717))) + (_e1658 * (_e1715 - (_e586 * _e1717)))) / _e1687);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1805) & 2147483647u)) <= _e1619) {
                                                                                    phi_2465_ = (_e1717 + _e1805);
                                                                                } else {
                                                                                    phi_2465_ = _e1717;
                                                                                }
                                                                                let _e1812 = phi_2465_;
                                                                                phi_2466_ = _e1812;
                                                                            } else {
                                                                                phi_2466_ = _e1795;
                                                                            }
                                                                            let _e1814 = phi_2466_;
                                                                            let _e1816 = select(_e1552, _e1814, (_e1814 < _e1552));
                                                                            let _e1818 = select(_e1544, _e1816, (_e1816 > _e1544));
                                                                            if (_e1818 >= _e766) {
                                                                                let _e1820 = (_e1818 <= _e1303.member);
                                                                                if _e1820 {
                                                                                    let _e1821 = (1f / _e1471);
                                                                                    phi_2489_ = type_30(_e1818, (_e1465 * _e1821), (_e1469 * _e1821), _e1332);
                                                                                } else {
                                                                                    phi_2489_ = type_30();
                                                                                }
                                                                                let _e1826 = phi_2489_;
                                                                                phi_2491_ = _e1826;
                                                                                phi_2492_ = select(true, false, _e1820);
                                                                            } else {
                                                                                phi_2491_ = type_30();
                                                                                phi_2492_ = true;
                                                                            }
                                                                            let _e1829 = phi_2491_;
                                                                            let _e1831 = phi_2492_;
                                                                            if _e1831 {
                                                                                phi_2496_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2496_ = _e1829;
                                                                            }
                                                                            let _e1833 = phi_2496_;
                                                                            phi_2497_ = _e1833;
                                                                        }
                                                                        let _e1835 = phi_2497_;
                                                                        phi_2498_ = _e1835;
                                                                        phi_2499_ = _e1561;
                                                                    }
                                                                    let _e1837 = phi_2498_;
                                                                    let _e1839 = phi_2499_;
                                                                    phi_2503_ = _e1837;
                                                                    phi_2504_ = _e1839;
                                                                }
                                                                let _e1841 = phi_2503_;
                                                                let _e1843 = phi_2504_;
                                                                phi_2505_ = _e1841;
                                                                phi_2506_ = _e1496;
                                                                phi_2507_ = _e1843;
                                                            }
                                                            let _e1845 = phi_2505_;
                                                            let _e1847 = phi_2506_;
                                                            let _e1849 = phi_2507_;
                                                            phi_2508_ = _e1845;
                                                            phi_2509_ = _e1847;
                                                            phi_2510_ = _e1849;
                                                        }
                                                        let _e1851 = phi_2508_;
                                                        let _e1853 = phi_2509_;
                                                        let _e1855 = phi_2510_;
                                                        phi_2518_ = _e1851;
                                                        phi_2519_ = select(_e1855, true, _e1853);
                                                    } else {
                                                        phi_2518_ = type_30();
                                                        phi_2519_ = true;
                                                    }
                                                    let _e1858 = phi_2518_;
                                                    let _e1860 = phi_2519_;
                                                    if _e1860 {
                                                        phi_2523_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2523_ = _e1858;
                                                    }
                                                    let _e1862 = phi_2523_;
                                                    if (_e1862.member_3 != 4294967295u) {
                                                        if (_e1332 == _e168) {
                                                            phi_2858_ = false;
                                                        } else {
                                                            let _e1866 = (_e1332 < arrayLength((&global_7.member)));
                                                            if _e1866 {
                                                                if _e1866 {
                                                                } else {
                                                                    phi_4368_ = true;
                                                                    break;
                                                                }
                                                                let _e1868 = global_7.member[_e1332];
                                                                phi_2546_ = _e1868;
                                                            } else {
                                                                phi_2546_ = 4294967295u;
                                                            }
                                                            let _e1870 = phi_2546_;
                                                            let _e1871 = (_e1870 < arrayLength((&global_8.member)));
                                                            if _e1871 {
                                                                if _e1871 {
                                                                } else {
                                                                    phi_4368_ = true;
                                                                    break;
                                                                }
                                                                let _e1873 = global_8.member[_e1870];
                                                                phi_2560_ = _e1873;
                                                            } else {
                                                                phi_2560_ = 0i;
                                                            }
                                                            let _e1875 = phi_2560_;
                                                            let _e1876 = (_e1875 == 0i);
                                                            if _e1876 {
                                                                phi_2857_ = true;
                                                            } else {
                                                                if _e457 {
                                                                    phi_2583_ = vec3<f32>(_e1399[0][0], _e1399[0][1], _e1399[0][2]);
                                                                } else {
                                                                    if (_e433 == 1u) {
                                                                        phi_2582_ = vec3<f32>(_e1399[0][2], _e1399[0][0], _e1399[0][1]);
                                                                    } else {
                                                                        phi_2582_ = vec3<f32>(_e1399[0][1], _e1399[0][2], _e1399[0][0]);
                                                                    }
                                                                    let _e1881 = phi_2582_;
                                                                    phi_2583_ = _e1881;
                                                                }
                                                                let _e1884 = phi_2583_;
                                                                if _e457 {
                                                                    phi_2602_ = vec3<f32>(_e1399[1][0], _e1399[1][1], _e1399[1][2]);
                                                                } else {
                                                                    if (_e433 == 1u) {
                                                                        phi_2601_ = vec3<f32>(_e1399[1][2], _e1399[1][0], _e1399[1][1]);
                                                                    } else {
                                                                        phi_2601_ = vec3<f32>(_e1399[1][1], _e1399[1][2], _e1399[1][0]);
                                                                    }
                                                                    let _e1889 = phi_2601_;
                                                                    phi_2602_ = _e1889;
                                                                }
                                                                let _e1892 = phi_2602_;
                                                                if _e457 {
                                                                    phi_2621_ = vec3<f32>(_e1399[2][0], _e1399[2][1], _e1399[2][2]);
                                                                } else {
                                                                    if (_e433 == 1u) {
                                                                        phi_2620_ = vec3<f32>(_e1399[2][2], _e1399[2][0], _e1399[2][1]);
                                                                    } else {
                                                                        phi_2620_ = vec3<f32>(_e1399[2][1], _e1399[2][2], _e1399[2][0]);
                                                                    }
                                                                    let _e1897 = phi_2620_;
                                                                    phi_2621_ = _e1897;
                                                                }
                                                                let _e1900 = phi_2621_;
                                                                let _e1903 = (_e1892.x - _e1884.x);
                                                                let _e1906 = (_e1892.y - _e1884.y);
                                                                let _e1909 = (_e1892.z - _e1884.z);
                                                                let _e1911 = (_e1900.x - _e1884.x);
                                                                let _e1913 = (_e1900.y - _e1884.y);
                                                                let _e1915 = (_e1900.z - _e1884.z);
                                                                if (_e300.member_1 == 1u) {
                                                                    phi_2657_ = (vec3<f32>(_e300.member[0], _e300.member[1], _e300.member[2]) - _e1884);
                                                                } else {
                                                                    phi_2657_ = vec3<f32>(_e300.member[0], _e300.member[1], _e300.member[2]);
                                                                }
                                                                let _e1930 = phi_2657_;
                                                                let _e1936 = bitcast<f32>((bitcast<u32>((_e1903 * _e1913)) ^ _e300.member_3[0]));
                                                                let _e1940 = bitcast<f32>((bitcast<u32>((_e1906 * _e1911)) ^ _e300.member_3[0]));
                                                                let _e1944 = bitcast<f32>((bitcast<u32>((_e1906 * _e1915)) ^ _e300.member_3[0]));
                                                                let _e1948 = bitcast<f32>((bitcast<u32>((_e1909 * _e1913)) ^ _e300.member_3[0]));
                                                                let _e1952 = bitcast<f32>((bitcast<u32>((_e1909 * _e1911)) ^ _e300.member_3[0]));
                                                                let _e1956 = bitcast<f32>((bitcast<u32>((_e1903 * _e1915)) ^ _e300.member_3[0]));
                                                                let _e1957 = (_e1944 - _e1948);
                                                                let _e1958 = (_e1952 - _e1956);
                                                                let _e1959 = (_e1936 - _e1940);
                                                                let _e1983 = (bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1948) & 2147483647u)));
                                                                let _e1990 = (bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1956) & 2147483647u)));
                                                                let _e1997 = (bitcast<f32>((bitcast<u32>(_e1936) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1940) & 2147483647u)));
                                                                if (_e300.member_2 == 0f) {
                                                                    phi_2839_ = 0f;
                                                                } else {
                                                                    let _e2027 = bitcast<f32>((bitcast<u32>(_e1957) & 2147483647u));
                                                                    let _e2030 = bitcast<f32>((bitcast<u32>(_e1958) & 2147483647u));
                                                                    let _e2033 = bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u));
                                                                    let _e2035 = select(_e2033, _e2030, (_e2030 > _e2033));
                                                                    let _e2039 = select(_e2033, _e2030, (_e2030 < _e2033));
                                                                    let _e2043 = select(_e2030, _e2027, (_e2027 < _e2030));
                                                                    let _e2045 = select(_e2030, _e2027, (_e2027 > _e2030));
                                                                    let _e2047 = select(_e2033, _e2045, (_e2045 < _e2033));
                                                                    phi_2839_ = bitcast<f32>((bitcast<u32>((_e300.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2035, _e2027, (_e2027 > _e2035)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2047, _e2043, (_e2043 > _e2047)))) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2039, _e2027, (_e2027 < _e2039)))) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1983 + _e1990) + _e1997))) ^ _e300.member_3[0]))) * 1.0000005f)) ^ _e300.member_3[0])))) ^ _e300.member_3[0]));
                                                                }
                                                                let _e2074 = phi_2839_;
                                                                phi_2857_ = (_e1876 || !(((((bitcast<f32>((bitcast<u32>((_e1930.x * _e1957)) ^ _e300.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1930.y * _e1958)) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1930.z * _e1959)) ^ _e300.member_3[0]))) * f32(-(_e1875))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1930.x) & 2147483647u)) * _e1983)) ^ _e300.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1930.y) & 2147483647u)) * _e1990)) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1930.z) & 2147483647u)) * _e1997)) ^ _e300.member_3[0]))))) ^ _e300.member_3[0])) + _e2074) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2088 = phi_2857_;
                                                            phi_2858_ = _e2088;
                                                        }
                                                        let _e2090 = phi_2858_;
                                                        if _e2090 {
                                                            phi_2863_ = type_51(_e1303.member, true);
                                                        } else {
                                                            phi_2863_ = _e1303;
                                                        }
                                                        let _e2095 = phi_2863_;
                                                        phi_2864_ = _e2095;
                                                    } else {
                                                        phi_2864_ = _e1303;
                                                    }
                                                    let _e2097 = phi_2864_;
                                                    phi_1486_ = _e2097;
                                                } else {
                                                    phi_1486_ = type_51();
                                                }
                                                let _e2099 = phi_1486_;
                                                continue;
                                                continuing {
                                                    phi_1485_ = _e2099;
                                                    phi_1488_ = _e1318;
                                                    phi_4368_ = _e808;
                                                    break if !(_e1324);
                                                }
                                            }
                                            let _e2102 = phi_4368_;
                                            phi_4560_ = _e2102;
                                            if _e2102 {
                                                break;
                                            }
                                            let _e2104 = local_10;
                                            phi_4564_ = _e2102;
                                            let _e2316 = local_12;
                                            phi_4102_ = _e2316;
                                            phi_4103_ = false;
                                            phi_4104_ = select(_e851, 0u, _e2104.member_1);
                                            phi_4105_ = _e853;
                                        } else {
                                            if (_e853.member_1 >= _e101) {
                                                phi_3637_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e853.member_1 < _e101) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e865 = ((1u + _e433) % 4u);
                                                if (_e865 < 4u) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e870 = global_5.member[_e853.member_1][_e865];
                                                let _e872 = (_e870 >> bitcast<u32>(11u));
                                                let _e874 = ((1u + _e432) % 4u);
                                                if (_e874 < 4u) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e879 = global_5.member[_e853.member_1][_e874];
                                                let _e881 = (_e879 >> bitcast<u32>(11u));
                                                let _e883 = ((1u + _e434) % 4u);
                                                if (_e883 < 4u) {
                                                } else {
                                                    phi_4560_ = true;
                                                    break;
                                                }
                                                let _e888 = global_5.member[_e853.member_1][_e883];
                                                let _e890 = (_e888 >> bitcast<u32>(11u));
                                                let _e913 = (bitcast<f32>((bitcast<u32>((_e853.member.member_1.x - _e853.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e914 = (bitcast<f32>((bitcast<u32>((_e853.member.member_1.y - _e853.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e915 = (bitcast<f32>((bitcast<u32>((_e853.member.member_1.z - _e853.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e917 = select(_e159, _e913, (_e913 > _e159));
                                                let _e919 = select(_e159, _e914, (_e914 > _e159));
                                                let _e921 = select(_e159, _e915, (_e915 > _e159));
                                                let _e952 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e870 & 1023u))) - 8388608f) * _e917));
                                                let _e957 = (bitcast<i32>((_e870 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e960 = bitcast<f32>((_e952 & bitcast<u32>(_e957)));
                                                let _e961 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e879 & 1023u))) - 8388608f) * _e919));
                                                let _e966 = (bitcast<i32>((_e879 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e969 = bitcast<f32>((_e961 & bitcast<u32>(_e966)));
                                                let _e970 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e888 & 1023u))) - 8388608f) * _e921));
                                                let _e975 = (bitcast<i32>((_e888 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e978 = bitcast<f32>((_e970 & bitcast<u32>(_e975)));
                                                let _e982 = bitcast<f32>((_e952 & bitcast<u32>(~(_e957))));
                                                let _e986 = bitcast<f32>((_e961 & bitcast<u32>(~(_e966))));
                                                let _e990 = bitcast<f32>((_e970 & bitcast<u32>(~(_e975))));
                                                let _e991 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e872 & 1023u))) - 8388608f) * _e917));
                                                let _e996 = (bitcast<i32>((_e872 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e999 = bitcast<f32>((_e991 & bitcast<u32>(_e996)));
                                                let _e1000 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e881 & 1023u))) - 8388608f) * _e919));
                                                let _e1005 = (bitcast<i32>((_e881 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1008 = bitcast<f32>((_e1000 & bitcast<u32>(_e1005)));
                                                let _e1009 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e890 & 1023u))) - 8388608f) * _e921));
                                                let _e1014 = (bitcast<i32>((_e890 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1017 = bitcast<f32>((_e1009 & bitcast<u32>(_e1014)));
                                                let _e1021 = bitcast<f32>((_e991 & bitcast<u32>(~(_e996))));
                                                let _e1025 = bitcast<f32>((_e1000 & bitcast<u32>(~(_e1005))));
                                                let _e1029 = bitcast<f32>((_e1009 & bitcast<u32>(~(_e1014))));
                                                let _e1059 = global_5.member[_e853.member_1][0u];
                                                let _e1063 = global_5.member[_e853.member_1][1u];
                                                let _e1067 = global_5.member[_e853.member_1][2u];
                                                let _e1071 = global_5.member[_e853.member_1][3u];
                                                let _e1083 = (((_e1063 >> bitcast<u32>(22i)) | ((_e1067 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1071 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1084 = (_e1059 & 268435455u);
                                                let _e1085 = (_e1083 & 268435455u);
                                                let _e1088 = ((_e1059 >> bitcast<u32>(28u)) & 7u);
                                                let _e1096 = ((_e1059 >> bitcast<u32>(31i)) | (((_e1083 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1097 = (_e1088 != 0u);
                                                if (_e1088 == 0u) {
                                                    phi_3599_ = _e1084;
                                                } else {
                                                    if (_e1088 == 7u) {
                                                        phi_3598_ = 2147483648u;
                                                    } else {
                                                        phi_3598_ = ((2147483648u | (_e1088 << bitcast<u32>(28u))) | (_e1085 & 268435455u));
                                                    }
                                                    let _e1106 = phi_3598_;
                                                    phi_3599_ = _e1106;
                                                }
                                                let _e1108 = phi_3599_;
                                                if _e1097 {
                                                    let _e1109 = (_e1088 != 7u);
                                                    if _e1109 {
                                                        phi_3609_ = (_e1085 + _e1088);
                                                    } else {
                                                        phi_3609_ = u32();
                                                    }
                                                    let _e1112 = phi_3609_;
                                                    phi_3611_ = _e1112;
                                                    phi_3612_ = select(true, false, _e1109);
                                                } else {
                                                    phi_3611_ = u32();
                                                    phi_3612_ = true;
                                                }
                                                let _e1115 = phi_3611_;
                                                let _e1117 = phi_3612_;
                                                if (_e1096 == 0u) {
                                                    phi_3633_ = (_e1084 + select(0u, 1u, !(_e1097)));
                                                } else {
                                                    if (_e1096 == 7u) {
                                                        phi_3632_ = 2147483648u;
                                                    } else {
                                                        phi_3632_ = ((2147483648u | (_e1096 << bitcast<u32>(28u))) | (select(_e1115, _e1085, _e1117) & 268435455u));
                                                    }
                                                    let _e1130 = phi_3632_;
                                                    phi_3633_ = _e1130;
                                                }
                                                let _e1132 = phi_3633_;
                                                phi_3637_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e853.member.member.x + _e960), (_e853.member.member.x + _e982), (_e853.member.member_1.x - _e999), (_e853.member.member_1.x - _e1021)), vec4<f32>((_e853.member.member.y + _e969), (_e853.member.member.y + _e986), (_e853.member.member_1.y - _e1008), (_e853.member.member_1.y - _e1025)), vec4<f32>((_e853.member.member.z + _e978), (_e853.member.member.z + _e990), (_e853.member.member_1.z - _e1017), (_e853.member.member_1.z - _e1029))), type_63(type_39((_e853.member.member + vec4<f32>(_e960, _e969, _e978, 0f)), (_e853.member.member_1 - vec4<f32>(_e999, _e1008, _e1017, 0f))), _e1108), type_63(type_39((_e853.member.member + vec4<f32>(_e982, _e986, _e990, 0f)), (_e853.member.member_1 - vec4<f32>(_e1021, _e1025, _e1029, 0f))), _e1132));
                                            }
                                            let _e1137 = phi_3637_;
                                            let _e1149 = ((_e1137.member[0].x - _e518) * _e523);
                                            let _e1150 = ((_e1137.member[0].y - _e518) * _e523);
                                            let _e1151 = ((_e1137.member[0].z - _e519) * _e523);
                                            let _e1152 = ((_e1137.member[0].w - _e519) * _e523);
                                            let _e1162 = ((_e1137.member[1].x - _e584) * _e589);
                                            let _e1163 = ((_e1137.member[1].y - _e584) * _e589);
                                            let _e1164 = ((_e1137.member[1].z - _e585) * _e589);
                                            let _e1165 = ((_e1137.member[1].w - _e585) * _e589);
                                            let _e1175 = ((_e1137.member[2].x - _e650) * _e655);
                                            let _e1176 = ((_e1137.member[2].y - _e650) * _e655);
                                            let _e1177 = ((_e1137.member[2].z - _e651) * _e655);
                                            let _e1178 = ((_e1137.member[2].w - _e651) * _e655);
                                            let _e1180 = select(_e1177, _e1175, (_e1175 < _e1177));
                                            let _e1182 = select(_e1178, _e1176, (_e1176 < _e1178));
                                            let _e1184 = select(_e1177, _e1175, (_e1175 > _e1177));
                                            let _e1186 = select(_e1178, _e1176, (_e1176 > _e1178));
                                            let _e1188 = select(_e1151, _e1149, (_e1149 < _e1151));
                                            let _e1190 = select(_e1152, _e1150, (_e1150 < _e1152));
                                            let _e1192 = select(_e1164, _e1162, (_e1162 < _e1164));
                                            let _e1194 = select(_e1165, _e1163, (_e1163 < _e1165));
                                            let _e1196 = select(_e1192, _e1188, (_e1188 > _e1192));
                                            let _e1198 = select(_e1194, _e1190, (_e1190 > _e1194));
                                            let _e1200 = select(_e1180, _e1196, (_e1196 > _e1180));
                                            let _e1202 = select(_e1182, _e1198, (_e1198 > _e1182));
                                            let _e1204 = select(_e1151, _e1149, (_e1149 > _e1151));
                                            let _e1206 = select(_e1152, _e1150, (_e1150 > _e1152));
                                            let _e1208 = select(_e1164, _e1162, (_e1162 > _e1164));
                                            let _e1210 = select(_e1165, _e1163, (_e1163 > _e1165));
                                            let _e1212 = select(_e1208, _e1204, (_e1204 < _e1208));
                                            let _e1214 = select(_e1210, _e1206, (_e1206 < _e1210));
                                            let _e1219 = -(_e1180);
                                            let _e1220 = -(_e1182);
                                            let _e1227 = (select(_e1184, _e1212, (_e1212 < _e1184)) + (select(_e1219, _e1184, (_e1184 > _e1219)) * 0.0000019073523f));
                                            let _e1228 = (select(_e1186, _e1214, (_e1214 < _e1186)) + (select(_e1220, _e1186, (_e1186 > _e1220)) * 0.0000019073523f));
                                            let _e1230 = select(_e766, _e1200, (_e1200 > _e766));
                                            let _e1232 = select(_e766, _e1202, (_e1202 > _e766));
                                            let _e1237 = (_e1230 <= select(_e810.member, _e1227, (_e1227 < _e810.member)));
                                            let _e1238 = (_e1232 <= select(_e810.member, _e1228, (_e1228 < _e810.member)));
                                            let _e1239 = (_e1230 <= _e1232);
                                            if _e1237 {
                                                if _e1238 {
                                                    if _e1239 {
                                                        phi_3999_ = _e1137.member_2;
                                                    } else {
                                                        phi_3999_ = _e1137.member_1;
                                                    }
                                                    let _e1243 = phi_3999_;
                                                    let _e1265 = (_e851 % 128u);
                                                    let _e1266 = (_e1265 < 128u);
                                                    if _e1266 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1265] = _e1243.member_1;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1265] = _e1243.member.member.x;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1265] = _e1243.member.member.y;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1265] = _e1243.member.member.z;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1265] = _e1243.member.member_1.x;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1265] = _e1243.member.member_1.y;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1265] = _e1243.member.member_1.z;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4560_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1265] = select(_e1232, _e1230, !(_e1239));
                                                    if _e1239 {
                                                        phi_4076_ = _e1137.member_1;
                                                    } else {
                                                        phi_4076_ = _e1137.member_2;
                                                    }
                                                    let _e1279 = phi_4076_;
                                                    phi_4077_ = (_e851 + 1u);
                                                    phi_4078_ = _e1279;
                                                } else {
                                                    phi_4077_ = u32();
                                                    phi_4078_ = type_63();
                                                }
                                                let _e1281 = phi_4077_;
                                                let _e1283 = phi_4078_;
                                                phi_4080_ = _e1281;
                                                phi_4081_ = _e1283;
                                                phi_4082_ = select(true, false, _e1238);
                                            } else {
                                                phi_4080_ = u32();
                                                phi_4081_ = type_63();
                                                phi_4082_ = true;
                                            }
                                            let _e1286 = phi_4080_;
                                            let _e1288 = phi_4081_;
                                            let _e1290 = phi_4082_;
                                            if _e1290 {
                                                if _e1237 {
                                                    phi_4091_ = _e1137.member_1;
                                                } else {
                                                    phi_4091_ = _e1137.member_2;
                                                }
                                                let _e1294 = phi_4091_;
                                                phi_4096_ = select(_e1238, true, _e1237);
                                                phi_4098_ = _e1294;
                                            } else {
                                                phi_4096_ = _e849;
                                                phi_4098_ = _e1288;
                                            }
                                            let _e1297 = phi_4096_;
                                            let _e1299 = phi_4098_;
                                            phi_4564_ = _e808;
                                            phi_4102_ = _e810;
                                            phi_4103_ = _e1297;
                                            phi_4104_ = select(_e1286, _e851, _e1290);
                                            phi_4105_ = _e1299;
                                        }
                                        let _e2108 = phi_4564_;
                                        let _e2110 = phi_4102_;
                                        let _e2112 = phi_4103_;
                                        let _e2114 = phi_4104_;
                                        let _e2116 = phi_4105_;
                                        phi_4563_ = _e2108;
                                        phi_4106_ = _e2110;
                                        phi_4107_ = _e2112;
                                        phi_4108_ = (_e814 - 1u);
                                        phi_4109_ = _e2114;
                                        phi_4110_ = _e2116;
                                    } else {
                                        phi_4563_ = _e808;
                                        phi_4106_ = _e810;
                                        phi_4107_ = _e849;
                                        phi_4108_ = _e814;
                                        phi_4109_ = _e851;
                                        phi_4110_ = _e853;
                                    }
                                    let _e2118 = phi_4563_;
                                    let _e2120 = phi_4106_;
                                    let _e2122 = phi_4107_;
                                    let _e2124 = phi_4108_;
                                    let _e2126 = phi_4109_;
                                    let _e2128 = phi_4110_;
                                    phi_4562_ = _e2118;
                                    phi_4111_ = _e2120;
                                    phi_4112_ = _e2122;
                                    phi_4113_ = _e2124;
                                    phi_4114_ = _e2126;
                                    phi_4115_ = _e2128;
                                } else {
                                    phi_4562_ = _e808;
                                    phi_4111_ = type_51();
                                    phi_4112_ = bool();
                                    phi_4113_ = u32();
                                    phi_4114_ = u32();
                                    phi_4115_ = type_63();
                                }
                                let _e2130 = phi_4562_;
                                let _e2132 = phi_4111_;
                                let _e2134 = phi_4112_;
                                let _e2136 = phi_4113_;
                                let _e2138 = phi_4114_;
                                let _e2140 = phi_4115_;
                                phi_4561_ = _e2130;
                                phi_1360_ = _e2132;
                                phi_1363_ = _e2134;
                                phi_1365_ = _e2136;
                                phi_1367_ = _e2138;
                                phi_1369_ = _e2140;
                                phi_4116_ = _e822;
                            } else {
                                phi_4561_ = _e808;
                                phi_1360_ = type_51();
                                phi_1363_ = bool();
                                phi_1365_ = u32();
                                phi_1367_ = u32();
                                phi_1369_ = type_63();
                                phi_4116_ = false;
                            }
                            let _e2142 = phi_4561_;
                            let _e2144 = phi_1360_;
                            let _e2146 = phi_1363_;
                            let _e2148 = phi_1365_;
                            let _e2150 = phi_1367_;
                            let _e2152 = phi_1369_;
                            let _e2154 = phi_4116_;
                            continue;
                            continuing {
                                phi_4374_ = _e2142;
                                phi_1359_ = _e2144;
                                phi_1362_ = _e2146;
                                phi_1364_ = _e2148;
                                phi_1366_ = _e2150;
                                phi_1368_ = _e2152;
                                phi_4560_ = _e2142;
                                break if !(_e2154);
                            }
                        }
                        let _e2157 = phi_4560_;
                        if _e2157 {
                            break;
                        }
                        let _e2159 = local_11;
                        if _e2159.member_1 {
                        } else {
                            if _e301 {
                            } else {
                                break;
                            }
                            let _e2163 = global_2.member[_e147];
                            if _e162 {
                            } else {
                                break;
                            }
                            let _e2167 = global_10.member[_e147].member_1;
                            if _e301 {
                            } else {
                                break;
                            }
                            global_2.member[_e147] = type_32(_e2163.member, _e2163.member_1, _e2163.member_2, array<f32, 3>((_e2163.member_3[0] + (_e2167[0] * _e2163.member_1[0])), (_e2163.member_3[1] + (_e2167[1] * _e2163.member_1[1])), (_e2163.member_3[2] + (_e2167[2] * _e2163.member_1[2]))), _e2163.member_4);
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_shadows_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
