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
    var phi_4377_: bool;
    var phi_1359_: type_51;
    var phi_1362_: u32;
    var phi_1364_: bool;
    var phi_1366_: u32;
    var phi_1368_: type_63;
    var phi_1379_: bool;
    var phi_1465_: bool;
    var phi_1466_: u32;
    var phi_1467_: type_63;
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
    var phi_4371_: bool;
    var phi_4649_: bool;
    var phi_2865_: type_51;
    var phi_3592_: u32;
    var phi_3593_: u32;
    var phi_3603_: u32;
    var phi_3605_: u32;
    var phi_3606_: bool;
    var phi_3626_: u32;
    var phi_3627_: u32;
    var phi_3631_: type_64;
    var phi_3993_: type_63;
    var phi_4069_: type_63;
    var phi_4070_: u32;
    var phi_4071_: type_63;
    var phi_4073_: u32;
    var phi_4074_: type_63;
    var phi_4075_: bool;
    var phi_4084_: type_63;
    var phi_4089_: bool;
    var phi_4091_: type_63;
    var phi_4095_: bool;
    var phi_4096_: u32;
    var phi_4097_: type_63;
    var phi_4107_: u32;
    var phi_4108_: type_63;
    var phi_4566_: bool;
    var phi_4109_: type_51;
    var phi_4110_: u32;
    var phi_4111_: bool;
    var phi_4112_: u32;
    var phi_4113_: type_63;
    var phi_4565_: bool;
    var phi_4114_: type_51;
    var phi_4115_: u32;
    var phi_4116_: bool;
    var phi_4117_: u32;
    var phi_4118_: type_63;
    var phi_4564_: bool;
    var phi_1360_: type_51;
    var phi_1363_: u32;
    var phi_1365_: bool;
    var phi_1367_: u32;
    var phi_1369_: type_63;
    var phi_4119_: bool;
    var phi_4563_: bool;
    var local_10: type_51;
    var local_11: type_51;

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
                        phi_4377_ = false;
                        phi_1359_ = type_51(_e764, false);
                        phi_1362_ = ((3u * _e101) + 1u);
                        phi_1364_ = (_e766 <= _e764);
                        phi_1366_ = 0u;
                        phi_1368_ = type_63(type_39(vec4<f32>((f32(_e773) * _e159), (f32(_e779) * _e159), (f32(_e785) * _e159), 0f), vec4<f32>((f32(_e790) * _e159), (f32(_e794) * _e159), (f32(_e798) * _e159), 0f)), select(0u, 2147483648u, (_e101 == 0u)));
                        loop {
                            let _e808 = phi_4377_;
                            let _e810 = phi_1359_;
                            let _e812 = phi_1362_;
                            let _e814 = phi_1364_;
                            let _e816 = phi_1366_;
                            let _e818 = phi_1368_;
                            local_10 = _e810;
                            if _e814 {
                                phi_1379_ = true;
                            } else {
                                phi_1379_ = (_e816 > 0u);
                            }
                            let _e821 = phi_1379_;
                            if _e821 {
                                let _e822 = (_e812 > 0u);
                                if _e822 {
                                    if _e814 {
                                        phi_1465_ = _e814;
                                        phi_1466_ = _e816;
                                        phi_1467_ = _e818;
                                    } else {
                                        let _e823 = (_e816 - 1u);
                                        let _e824 = (_e823 % 128u);
                                        let _e825 = (_e824 < 128u);
                                        if _e825 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e827 = local_7[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e829 = local_6[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e831 = local_5[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e833 = local_4[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e835 = local_3[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e837 = local_2[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4563_ = true;
                                            break;
                                        }
                                        let _e842 = local_8[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4563_ = true;
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
                                        let _e857 = ((_e853.member_1 & 2147483648u) != 0u);
                                        if _e857 {
                                            phi_1485_ = _e810;
                                            phi_1488_ = type_8(0u, ((_e853.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e864 = phi_1485_;
                                                let _e866 = phi_1488_;
                                                local_11 = _e864;
                                                if (_e866.member < _e866.member_1) {
                                                    phi_1489_ = type_8((_e866.member + 1u), _e866.member_1);
                                                    phi_1511_ = type_8(1u, _e866.member);
                                                } else {
                                                    phi_1489_ = _e866;
                                                    phi_1511_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e879 = phi_1489_;
                                                let _e881 = phi_1511_;
                                                let _e885 = (bitcast<i32>(_e881.member) != 0i);
                                                if _e885 {
                                                    let _e886 = ((_e853.member_1 & 268435455u) + _e881.member_1);
                                                    let _e887 = (_e886 < _e103);
                                                    if _e887 {
                                                        if _e887 {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e891 = global_6.member[_e886].member_1;
                                                        phi_1532_ = _e891;
                                                    } else {
                                                        phi_1532_ = 4294967295u;
                                                    }
                                                    let _e893 = phi_1532_;
                                                    if (_e886 >= _e103) {
                                                        phi_1624_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e887 {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        if (_e770 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e900 = global_6.member[_e886].member[_e770];
                                                        if (_e776 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e906 = global_6.member[_e886].member[_e776];
                                                        if (_e782 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e912 = global_6.member[_e886].member[_e782];
                                                        let _e914 = (3u + _e770);
                                                        if (_e914 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e920 = global_6.member[_e886].member[_e914];
                                                        let _e921 = (3u + _e776);
                                                        if (_e921 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e927 = global_6.member[_e886].member[_e921];
                                                        let _e928 = (3u + _e782);
                                                        if (_e928 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e934 = global_6.member[_e886].member[_e928];
                                                        let _e936 = (6u + _e770);
                                                        if (_e936 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e942 = global_6.member[_e886].member[_e936];
                                                        let _e943 = (6u + _e776);
                                                        if (_e943 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e949 = global_6.member[_e886].member[_e943];
                                                        let _e950 = (6u + _e782);
                                                        if (_e950 < 9u) {
                                                        } else {
                                                            phi_4371_ = true;
                                                            break;
                                                        }
                                                        let _e956 = global_6.member[_e886].member[_e950];
                                                        phi_1624_ = array<array<f32, 3>, 3>(array<f32, 3>(_e900, _e906, _e912), array<f32, 3>(_e920, _e927, _e934), array<f32, 3>(_e942, _e949, _e956));
                                                    }
                                                    let _e960 = phi_1624_;
                                                    let _e968 = (_e960[0][2] - _e613);
                                                    let _e971 = (((_e960[0][0] - _e480) * _e652) - (_e968 * _e520));
                                                    let _e974 = (((_e960[0][1] - _e547) * _e652) - (_e968 * _e586));
                                                    let _e981 = (_e960[1][2] - _e613);
                                                    let _e984 = (((_e960[1][0] - _e480) * _e652) - (_e981 * _e520));
                                                    let _e987 = (((_e960[1][1] - _e547) * _e652) - (_e981 * _e586));
                                                    let _e994 = (_e960[2][2] - _e613);
                                                    let _e997 = (((_e960[2][0] - _e480) * _e652) - (_e994 * _e520));
                                                    let _e1000 = (((_e960[2][1] - _e547) * _e652) - (_e994 * _e586));
                                                    let _e1001 = (_e997 * _e987);
                                                    let _e1002 = (_e1000 * _e984);
                                                    let _e1003 = (_e971 * _e1000);
                                                    let _e1004 = (_e974 * _e997);
                                                    let _e1005 = (_e984 * _e974);
                                                    let _e1006 = (_e987 * _e971);
                                                    let _e1011 = (((_e1001 >= _e1002) && (_e1003 >= _e1004)) && (_e1005 >= _e1006));
                                                    if (_e1011 || (((_e1001 <= _e1002) && (_e1003 <= _e1004)) && (_e1005 <= _e1006))) {
                                                        let _e1018 = select(-1f, 1f, _e1011);
                                                        let _e1020 = ((_e1001 - _e1002) * _e1018);
                                                        let _e1022 = select(0f, _e1020, (_e1020 > 0f));
                                                        let _e1024 = ((_e1003 - _e1004) * _e1018);
                                                        let _e1026 = select(0f, _e1024, (_e1024 > 0f));
                                                        let _e1028 = ((_e1005 - _e1006) * _e1018);
                                                        let _e1030 = select(0f, _e1028, (_e1028 > 0f));
                                                        let _e1032 = ((_e1022 + _e1026) + _e1030);
                                                        if (_e1032 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2508_ = type_30();
                                                            phi_2509_ = true;
                                                            phi_2510_ = false;
                                                        } else {
                                                            let _e1035 = select(_e984, _e971, (_e971 < _e984));
                                                            if (select(_e997, _e1035, (_e1035 < _e997)) > 0f) {
                                                                phi_1776_ = true;
                                                            } else {
                                                                let _e1040 = select(_e984, _e971, (_e971 > _e984));
                                                                phi_1776_ = (select(_e997, _e1040, (_e1040 > _e997)) < 0f);
                                                            }
                                                            let _e1045 = phi_1776_;
                                                            if _e1045 {
                                                                phi_2505_ = type_30();
                                                                phi_2506_ = true;
                                                                phi_2507_ = false;
                                                            } else {
                                                                let _e1047 = select(_e987, _e974, (_e974 < _e987));
                                                                if (select(_e1000, _e1047, (_e1047 < _e1000)) > 0f) {
                                                                    phi_1805_ = true;
                                                                } else {
                                                                    let _e1052 = select(_e987, _e974, (_e974 > _e987));
                                                                    phi_1805_ = (select(_e1000, _e1052, (_e1052 > _e1000)) < 0f);
                                                                }
                                                                let _e1057 = phi_1805_;
                                                                if _e1057 {
                                                                    phi_2503_ = type_30();
                                                                    phi_2504_ = false;
                                                                } else {
                                                                    let _e1059 = select(_e960[1][0], _e960[0][0], (_e960[0][0] < _e960[1][0]));
                                                                    let _e1063 = select(_e960[1][0], _e960[0][0], (_e960[0][0] > _e960[1][0]));
                                                                    let _e1067 = select(_e960[1][1], _e960[0][1], (_e960[0][1] < _e960[1][1]));
                                                                    let _e1071 = select(_e960[1][1], _e960[0][1], (_e960[0][1] > _e960[1][1]));
                                                                    let _e1075 = select(_e960[1][2], _e960[0][2], (_e960[0][2] < _e960[1][2]));
                                                                    let _e1079 = select(_e960[1][2], _e960[0][2], (_e960[0][2] > _e960[1][2]));
                                                                    let _e1084 = ((select(_e960[2][0], _e1059, (_e1059 < _e960[2][0])) - _e518) * _e523);
                                                                    let _e1085 = ((select(_e960[2][0], _e1063, (_e1063 > _e960[2][0])) - _e519) * _e523);
                                                                    let _e1088 = ((select(_e960[2][1], _e1067, (_e1067 < _e960[2][1])) - _e584) * _e589);
                                                                    let _e1089 = ((select(_e960[2][1], _e1071, (_e1071 > _e960[2][1])) - _e585) * _e589);
                                                                    let _e1092 = ((select(_e960[2][2], _e1075, (_e1075 < _e960[2][2])) - _e650) * _e655);
                                                                    let _e1093 = ((select(_e960[2][2], _e1079, (_e1079 > _e960[2][2])) - _e651) * _e655);
                                                                    let _e1095 = select(_e1093, _e1092, (_e1092 < _e1093));
                                                                    let _e1097 = select(_e1093, _e1092, (_e1092 > _e1093));
                                                                    let _e1099 = select(_e1085, _e1084, (_e1084 < _e1085));
                                                                    let _e1101 = select(_e1089, _e1088, (_e1088 < _e1089));
                                                                    let _e1103 = select(_e1101, _e1099, (_e1099 > _e1101));
                                                                    let _e1105 = select(_e1095, _e1103, (_e1103 > _e1095));
                                                                    let _e1107 = select(_e1085, _e1084, (_e1084 > _e1085));
                                                                    let _e1109 = select(_e1089, _e1088, (_e1088 > _e1089));
                                                                    let _e1111 = select(_e1109, _e1107, (_e1107 < _e1109));
                                                                    let _e1113 = select(_e1097, _e1111, (_e1111 < _e1097));
                                                                    let _e1114 = -(_e1095);
                                                                    let _e1120 = select(_e766, _e1105, (_e1105 > _e766));
                                                                    if (_e1120 > (_e1113 + (select(_e1114, _e1097, (_e1097 > _e1114)) * 0.0000019073523f))) {
                                                                        phi_2498_ = type_30();
                                                                        phi_2499_ = true;
                                                                    } else {
                                                                        let _e1122 = (_e1120 > _e864.member);
                                                                        if _e1122 {
                                                                            phi_2497_ = type_30();
                                                                        } else {
                                                                            let _e1123 = vec3<f32>(_e960[0][0], _e960[0][1], _e960[0][2]);
                                                                            let _e1124 = vec3<f32>(_e960[1][0], _e960[1][1], _e960[1][2]);
                                                                            let _e1125 = vec3<f32>(_e960[2][0], _e960[2][1], _e960[2][2]);
                                                                            let _e1126 = (_e960[1][0] - _e960[0][0]);
                                                                            let _e1127 = (_e960[1][1] - _e960[0][1]);
                                                                            let _e1128 = (_e960[1][2] - _e960[0][2]);
                                                                            let _e1129 = vec3<f32>(_e1126, _e1127, _e1128);
                                                                            let _e1130 = (_e960[2][0] - _e960[1][0]);
                                                                            let _e1131 = (_e960[2][1] - _e960[1][1]);
                                                                            let _e1132 = (_e960[2][2] - _e960[1][2]);
                                                                            let _e1133 = vec3<f32>(_e1130, _e1131, _e1132);
                                                                            let _e1134 = (_e960[0][0] - _e960[2][0]);
                                                                            let _e1135 = (_e960[0][1] - _e960[2][1]);
                                                                            let _e1136 = (_e960[0][2] - _e960[2][2]);
                                                                            let _e1137 = vec3<f32>(_e1134, _e1135, _e1136);
                                                                            let _e1140 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                            let _e1143 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                                            let _e1145 = select(_e1143, _e1140, (_e1140 > _e1143));
                                                                            let _e1148 = bitcast<f32>((bitcast<u32>(_e1128) & 2147483647u));
                                                                            let _e1150 = select(_e1148, _e1145, (_e1145 > _e1148));
                                                                            let _e1153 = bitcast<f32>((bitcast<u32>(_e1130) & 2147483647u));
                                                                            let _e1156 = bitcast<f32>((bitcast<u32>(_e1131) & 2147483647u));
                                                                            let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                                                                            let _e1161 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                                            let _e1163 = select(_e1161, _e1158, (_e1158 > _e1161));
                                                                            let _e1166 = bitcast<f32>((bitcast<u32>(_e1134) & 2147483647u));
                                                                            let _e1169 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                            let _e1171 = select(_e1169, _e1166, (_e1166 > _e1169));
                                                                            let _e1174 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                            let _e1176 = select(_e1174, _e1171, (_e1171 > _e1174));
                                                                            let _e1178 = select(_e1163, _e1150, (_e1150 > _e1163));
                                                                            let _e1180 = select(_e1176, _e1178, (_e1178 > _e1176));
                                                                            if (_e1150 == _e1180) {
                                                                                phi_2224_ = _e987;
                                                                                phi_2225_ = _e984;
                                                                                phi_2226_ = _e974;
                                                                                phi_2227_ = _e971;
                                                                                phi_2228_ = _e1123;
                                                                                phi_2229_ = _e1137;
                                                                                phi_2230_ = _e1133;
                                                                                phi_2231_ = _e1129;
                                                                            } else {
                                                                                let _e1182 = (_e1163 == _e1180);
                                                                                let _e1187 = vec3(_e1182);
                                                                                phi_2224_ = select(_e974, _e1000, _e1182);
                                                                                phi_2225_ = select(_e971, _e997, _e1182);
                                                                                phi_2226_ = select(_e1000, _e987, _e1182);
                                                                                phi_2227_ = select(_e997, _e984, _e1182);
                                                                                phi_2228_ = select(_e1125, _e1124, _e1187);
                                                                                phi_2229_ = select(_e1133, _e1129, _e1187);
                                                                                phi_2230_ = select(_e1129, _e1137, _e1187);
                                                                                phi_2231_ = select(_e1137, _e1133, _e1187);
                                                                            }
                                                                            let _e1193 = phi_2224_;
                                                                            let _e1195 = phi_2225_;
                                                                            let _e1197 = phi_2226_;
                                                                            let _e1199 = phi_2227_;
                                                                            let _e1201 = phi_2228_;
                                                                            let _e1203 = phi_2229_;
                                                                            let _e1205 = phi_2230_;
                                                                            let _e1207 = phi_2231_;
                                                                            let _e1214 = ((_e1205.y * _e1203.z) - (_e1203.y * _e1205.z));
                                                                            let _e1219 = ((_e1205.z * _e1203.x) - (_e1203.z * _e1205.x));
                                                                            let _e1222 = ((_e1205.x * _e1203.y) - (_e1203.x * _e1205.y));
                                                                            if (_e1022 >= _e1026) {
                                                                                phi_2268_ = select(true, false, (_e1022 >= _e1030));
                                                                            } else {
                                                                                phi_2268_ = true;
                                                                            }
                                                                            let _e1227 = phi_2268_;
                                                                            if _e1227 {
                                                                                phi_2277_ = select(_e1125, _e1124, vec3((_e1026 >= _e1030)));
                                                                            } else {
                                                                                phi_2277_ = _e1123;
                                                                            }
                                                                            let _e1232 = phi_2277_;
                                                                            let _e1243 = (((_e1214 * (_e1232.x - _e480)) + (_e1219 * (_e1232.y - _e547))) + (_e1222 * (_e1232.z - _e613)));
                                                                            let _e1248 = (((_e1214 * _e520) + (_e1219 * _e586)) + (_e1222 * _e652));
                                                                            let _e1249 = (_e1195 - _e1199);
                                                                            let _e1250 = (_e1193 - _e1197);
                                                                            let _e1258 = (-(((_e1199 * _e1249) + (_e1197 * _e1250))) / ((_e1249 * _e1249) + (_e1250 * _e1250)));
                                                                            let _e1260 = select(1f, _e1258, (_e1258 < 1f));
                                                                            let _e1262 = select(0f, _e1260, (_e1260 > 0f));
                                                                            let _e1275 = ((_e1201.x + (_e1207.x * _e1262)) - _e480);
                                                                            let _e1276 = ((_e1201.y + (_e1207.y * _e1262)) - _e547);
                                                                            let _e1277 = ((_e1201.z + (_e1207.z * _e1262)) - _e613);
                                                                            let _e1278 = (_e1277 / _e652);
                                                                            let _e1290 = bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u));
                                                                            let _e1293 = bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u));
                                                                            let _e1295 = select(_e1293, _e1290, (_e1290 > _e1293));
                                                                            let _e1298 = bitcast<f32>((bitcast<u32>(_e1277) & 2147483647u));
                                                                            let _e1300 = select(_e1298, _e1295, (_e1295 > _e1298));
                                                                            let _e1306 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                            let _e1309 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                            let _e1311 = select(_e1309, _e1306, (_e1306 > _e1309));
                                                                            let _e1314 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1214 * _e1275) + (_e1219 * _e1276)) + (_e1222 * _e1277)) - _e1243)) & 2147483647u)) <= ((0.0000009536743f * select(_e1180, _e1300, (_e1300 > _e1180))) * select(_e1314, _e1311, (_e1311 > _e1314)))) {
                                                                                let _e1324 = bitcast<f32>((bitcast<u32>(_e1205.x) & 2147483647u));
                                                                                let _e1327 = bitcast<f32>((bitcast<u32>(_e1205.y) & 2147483647u));
                                                                                let _e1329 = select(_e1327, _e1324, (_e1324 > _e1327));
                                                                                let _e1332 = bitcast<f32>((bitcast<u32>(_e1205.z) & 2147483647u));
                                                                                let _e1338 = bitcast<f32>((bitcast<u32>(_e1203.x) & 2147483647u));
                                                                                let _e1341 = bitcast<f32>((bitcast<u32>(_e1203.y) & 2147483647u));
                                                                                let _e1343 = select(_e1341, _e1338, (_e1338 > _e1341));
                                                                                let _e1346 = bitcast<f32>((bitcast<u32>(_e1203.z) & 2147483647u));
                                                                                let _e1350 = (bitcast<f32>((bitcast<u32>(_e1248) & 2147483647u)) > ((0.0000038146973f * select(_e1332, _e1329, (_e1329 > _e1332))) * select(_e1346, _e1343, (_e1343 > _e1346))));
                                                                                if _e1350 {
                                                                                    phi_2442_ = (_e1243 / _e1248);
                                                                                } else {
                                                                                    phi_2442_ = f32();
                                                                                }
                                                                                let _e1353 = phi_2442_;
                                                                                phi_2444_ = _e1353;
                                                                                phi_2445_ = select(true, false, _e1350);
                                                                            } else {
                                                                                phi_2444_ = f32();
                                                                                phi_2445_ = true;
                                                                            }
                                                                            let _e1356 = phi_2444_;
                                                                            let _e1358 = phi_2445_;
                                                                            if _e1358 {
                                                                                let _e1366 = (((_e1214 * (_e1275 - (_e520 * _e1278))) + (_e1219 * (_e1276 - (_e586 * _e1278)))) / _e1248);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u)) <= _e1180) {
                                                                                    phi_2465_ = (_e1278 + _e1366);
                                                                                } else {
                                                                                    phi_2465_ = _e1278;
                                                                                }
                                                                                let _e1373 = phi_2465_;
                                                                                phi_2466_ = _e1373;
                                                                            } else {
                                                                                phi_2466_ = _e1356;
                                                                            }
                                                                            let _e1375 = phi_2466_;
                                                                            let _e1377 = select(_e1113, _e1375, (_e1375 < _e1113));
                                                                            let _e1379 = select(_e1105, _e1377, (_e1377 > _e1105));
                                                                            if (_e1379 >= _e766) {
                                                                                let _e1381 = (_e1379 <= _e864.member);
                                                                                if _e1381 {
                                                                                    let _e1382 = (1f / _e1032);
                                                                                    phi_2489_ = type_30(_e1379, (_e1026 * _e1382), (_e1030 * _e1382), _e893);
                                                                                } else {
                                                                                    phi_2489_ = type_30();
                                                                                }
                                                                                let _e1387 = phi_2489_;
                                                                                phi_2491_ = _e1387;
                                                                                phi_2492_ = select(true, false, _e1381);
                                                                            } else {
                                                                                phi_2491_ = type_30();
                                                                                phi_2492_ = true;
                                                                            }
                                                                            let _e1390 = phi_2491_;
                                                                            let _e1392 = phi_2492_;
                                                                            if _e1392 {
                                                                                phi_2496_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2496_ = _e1390;
                                                                            }
                                                                            let _e1394 = phi_2496_;
                                                                            phi_2497_ = _e1394;
                                                                        }
                                                                        let _e1396 = phi_2497_;
                                                                        phi_2498_ = _e1396;
                                                                        phi_2499_ = _e1122;
                                                                    }
                                                                    let _e1398 = phi_2498_;
                                                                    let _e1400 = phi_2499_;
                                                                    phi_2503_ = _e1398;
                                                                    phi_2504_ = _e1400;
                                                                }
                                                                let _e1402 = phi_2503_;
                                                                let _e1404 = phi_2504_;
                                                                phi_2505_ = _e1402;
                                                                phi_2506_ = _e1057;
                                                                phi_2507_ = _e1404;
                                                            }
                                                            let _e1406 = phi_2505_;
                                                            let _e1408 = phi_2506_;
                                                            let _e1410 = phi_2507_;
                                                            phi_2508_ = _e1406;
                                                            phi_2509_ = _e1408;
                                                            phi_2510_ = _e1410;
                                                        }
                                                        let _e1412 = phi_2508_;
                                                        let _e1414 = phi_2509_;
                                                        let _e1416 = phi_2510_;
                                                        phi_2518_ = _e1412;
                                                        phi_2519_ = select(_e1416, true, _e1414);
                                                    } else {
                                                        phi_2518_ = type_30();
                                                        phi_2519_ = true;
                                                    }
                                                    let _e1419 = phi_2518_;
                                                    let _e1421 = phi_2519_;
                                                    if _e1421 {
                                                        phi_2523_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2523_ = _e1419;
                                                    }
                                                    let _e1423 = phi_2523_;
                                                    if (_e1423.member_3 != 4294967295u) {
                                                        if (_e893 == _e168) {
                                                            phi_2858_ = false;
                                                        } else {
                                                            let _e1427 = (_e893 < arrayLength((&global_7.member)));
                                                            if _e1427 {
                                                                if _e1427 {
                                                                } else {
                                                                    phi_4371_ = true;
                                                                    break;
                                                                }
                                                                let _e1429 = global_7.member[_e893];
                                                                phi_2546_ = _e1429;
                                                            } else {
                                                                phi_2546_ = 4294967295u;
                                                            }
                                                            let _e1431 = phi_2546_;
                                                            let _e1432 = (_e1431 < arrayLength((&global_8.member)));
                                                            if _e1432 {
                                                                if _e1432 {
                                                                } else {
                                                                    phi_4371_ = true;
                                                                    break;
                                                                }
                                                                let _e1434 = global_8.member[_e1431];
                                                                phi_2560_ = _e1434;
                                                            } else {
                                                                phi_2560_ = 0i;
                                                            }
                                                            let _e1436 = phi_2560_;
                                                            let _e1437 = (_e1436 == 0i);
                                                            if _e1437 {
                                                                phi_2857_ = true;
                                                            } else {
                                                                if _e457 {
                                                                    phi_2583_ = vec3<f32>(_e960[0][0], _e960[0][1], _e960[0][2]);
                                                                } else {
                                                                    if (_e433 == 1u) {
                                                                        phi_2582_ = vec3<f32>(_e960[0][2], _e960[0][0], _e960[0][1]);
                                                                    } else {
                                                                        phi_2582_ = vec3<f32>(_e960[0][1], _e960[0][2], _e960[0][0]);
                                                                    }
                                                                    let _e1442 = phi_2582_;
                                                                    phi_2583_ = _e1442;
                                                                }
                                                                let _e1445 = phi_2583_;
                                                                if _e457 {
                                                                    phi_2602_ = vec3<f32>(_e960[1][0], _e960[1][1], _e960[1][2]);
                                                                } else {
                                                                    if (_e433 == 1u) {
                                                                        phi_2601_ = vec3<f32>(_e960[1][2], _e960[1][0], _e960[1][1]);
                                                                    } else {
                                                                        phi_2601_ = vec3<f32>(_e960[1][1], _e960[1][2], _e960[1][0]);
                                                                    }
                                                                    let _e1450 = phi_2601_;
                                                                    phi_2602_ = _e1450;
                                                                }
                                                                let _e1453 = phi_2602_;
                                                                if _e457 {
                                                                    phi_2621_ = vec3<f32>(_e960[2][0], _e960[2][1], _e960[2][2]);
                                                                } else {
                                                                    if (_e433 == 1u) {
                                                                        phi_2620_ = vec3<f32>(_e960[2][2], _e960[2][0], _e960[2][1]);
                                                                    } else {
                                                                        phi_2620_ = vec3<f32>(_e960[2][1], _e960[2][2], _e960[2][0]);
                                                                    }
                                                                    let _e1458 = phi_2620_;
                                                                    phi_2621_ = _e1458;
                                                                }
                                                                let _e1461 = phi_2621_;
                                                                let _e1464 = (_e1453.x - _e1445.x);
                                                                let _e1467 = (_e1453.y - _e1445.y);
                                                                let _e1470 = (_e1453.z - _e1445.z);
                                                                let _e1472 = (_e1461.x - _e1445.x);
                                                                let _e1474 = (_e1461.y - _e1445.y);
                                                                let _e1476 = (_e1461.z - _e1445.z);
                                                                if (_e300.member_1 == 1u) {
                                                                    phi_2657_ = (vec3<f32>(_e300.member[0], _e300.member[1], _e300.member[2]) - _e1445);
                                                                } else {
                                                                    phi_2657_ = vec3<f32>(_e300.member[0], _e300.member[1], _e300.member[2]);
                                                                }
                                                                let _e1491 = phi_2657_;
                                                                let _e1497 = bitcast<f32>((bitcast<u32>((_e1464 * _e1474)) ^ _e300.member_3[0]));
                                                                let _e1501 = bitcast<f32>((bitcast<u32>((_e1467 * _e1472)) ^ _e300.member_3[0]));
                                                                let _e1505 = bitcast<f32>((bitcast<u32>((_e1467 * _e1476)) ^ _e300.member_3[0]));
                                                                let _e1509 = bitcast<f32>((bitcast<u32>((_e1470 * _e1474)) ^ _e300.member_3[0]));
                                                                let _e1513 = bitcast<f32>((bitcast<u32>((_e1470 * _e1472)) ^ _e300.member_3[0]));
                                                                let _e1517 = bitcast<f32>((bitcast<u32>((_e1464 * _e1476)) ^ _e300.member_3[0]));
                                                                let _e1518 = (_e1505 - _e1509);
                                                                let _e1519 = (_e1513 - _e1517);
                                                                let _e1520 = (_e1497 - _e1501);
                                                                let _e1544 = (bitcast<f32>((bitcast<u32>(_e1505) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1509) & 2147483647u)));
                                                                let _e1551 = (bitcast<f32>((bitcast<u32>(_e1513) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1517) & 2147483647u)));
                                                                let _e1558 = (bitcast<f32>((bitcast<u32>(_e1497) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1501) & 2147483647u)));
                                                                if (_e300.member_2 == 0f) {
                                                                    phi_2839_ = 0f;
                                                                } else {
                                                                    let _e1588 = bitcast<f32>((bitcast<u32>(_e1518) & 2147483647u));
                                                                    let _e1591 = bitcast<f32>((bitcast<u32>(_e1519) & 2147483647u));
                                                                    let _e1594 = bitcast<f32>((bitcast<u32>(_e1520) & 2147483647u));
                                                                    let _e1596 = select(_e1594, _e1591, (_e1591 > _e1594));
                                                                    let _e1600 = select(_e1594, _e1591, (_e1591 < _e1594));
                                                                    let _e1604 = select(_e1591, _e1588, (_e1588 < _e1591));
                                                                    let _e1606 = select(_e1591, _e1588, (_e1588 > _e1591));
                                                                    let _e1608 = select(_e1594, _e1606, (_e1606 < _e1594));
                                                                    phi_2839_ = bitcast<f32>((bitcast<u32>((_e300.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1596, _e1588, (_e1588 > _e1596)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1608, _e1604, (_e1604 > _e1608)))) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1600, _e1588, (_e1588 < _e1600)))) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1544 + _e1551) + _e1558))) ^ _e300.member_3[0]))) * 1.0000005f)) ^ _e300.member_3[0])))) ^ _e300.member_3[0]));
                                                                }
                                                                let _e1635 = phi_2839_;
                                                                phi_2857_ = (_e1437 || !(((((bitcast<f32>((bitcast<u32>((_e1491.x * _e1518)) ^ _e300.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1491.y * _e1519)) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1491.z * _e1520)) ^ _e300.member_3[0]))) * f32(-(_e1436))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1491.x) & 2147483647u)) * _e1544)) ^ _e300.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1491.y) & 2147483647u)) * _e1551)) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1491.z) & 2147483647u)) * _e1558)) ^ _e300.member_3[0]))))) ^ _e300.member_3[0])) + _e1635) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1649 = phi_2857_;
                                                            phi_2858_ = _e1649;
                                                        }
                                                        let _e1651 = phi_2858_;
                                                        if _e1651 {
                                                            phi_2863_ = type_51(_e864.member, true);
                                                        } else {
                                                            phi_2863_ = _e864;
                                                        }
                                                        let _e1656 = phi_2863_;
                                                        phi_2864_ = _e1656;
                                                    } else {
                                                        phi_2864_ = _e864;
                                                    }
                                                    let _e1658 = phi_2864_;
                                                    phi_1486_ = _e1658;
                                                } else {
                                                    phi_1486_ = type_51();
                                                }
                                                let _e1660 = phi_1486_;
                                                continue;
                                                continuing {
                                                    phi_1485_ = _e1660;
                                                    phi_1488_ = _e879;
                                                    phi_4371_ = _e808;
                                                    break if !(_e885);
                                                }
                                            }
                                            let _e1663 = phi_4371_;
                                            phi_4563_ = _e1663;
                                            if _e1663 {
                                                break;
                                            }
                                            phi_4649_ = _e1663;
                                            let _e2299 = local_11;
                                            phi_2865_ = _e2299;
                                        } else {
                                            phi_4649_ = _e808;
                                            phi_2865_ = _e810;
                                        }
                                        let _e1665 = phi_4649_;
                                        let _e1667 = phi_2865_;
                                        if _e857 {
                                            phi_4095_ = bool();
                                            phi_4096_ = u32();
                                            phi_4097_ = type_63();
                                        } else {
                                            if (_e853.member_1 >= _e101) {
                                                phi_3631_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e853.member_1 < _e101) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1671 = ((1u + _e433) % 4u);
                                                if (_e1671 < 4u) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1676 = global_5.member[_e853.member_1][_e1671];
                                                let _e1678 = (_e1676 >> bitcast<u32>(11u));
                                                let _e1680 = ((1u + _e432) % 4u);
                                                if (_e1680 < 4u) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1685 = global_5.member[_e853.member_1][_e1680];
                                                let _e1687 = (_e1685 >> bitcast<u32>(11u));
                                                let _e1689 = ((1u + _e434) % 4u);
                                                if (_e1689 < 4u) {
                                                } else {
                                                    phi_4563_ = true;
                                                    break;
                                                }
                                                let _e1694 = global_5.member[_e853.member_1][_e1689];
                                                let _e1696 = (_e1694 >> bitcast<u32>(11u));
                                                let _e1719 = (bitcast<f32>((bitcast<u32>((_e853.member.member_1.x - _e853.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e1720 = (bitcast<f32>((bitcast<u32>((_e853.member.member_1.y - _e853.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e1721 = (bitcast<f32>((bitcast<u32>((_e853.member.member_1.z - _e853.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e1723 = select(_e159, _e1719, (_e1719 > _e159));
                                                let _e1725 = select(_e159, _e1720, (_e1720 > _e159));
                                                let _e1727 = select(_e159, _e1721, (_e1721 > _e159));
                                                let _e1758 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1676 & 1023u))) - 8388608f) * _e1723));
                                                let _e1763 = (bitcast<i32>((_e1676 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1766 = bitcast<f32>((_e1758 & bitcast<u32>(_e1763)));
                                                let _e1767 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1685 & 1023u))) - 8388608f) * _e1725));
                                                let _e1772 = (bitcast<i32>((_e1685 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1775 = bitcast<f32>((_e1767 & bitcast<u32>(_e1772)));
                                                let _e1776 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1694 & 1023u))) - 8388608f) * _e1727));
                                                let _e1781 = (bitcast<i32>((_e1694 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1784 = bitcast<f32>((_e1776 & bitcast<u32>(_e1781)));
                                                let _e1788 = bitcast<f32>((_e1758 & bitcast<u32>(~(_e1763))));
                                                let _e1792 = bitcast<f32>((_e1767 & bitcast<u32>(~(_e1772))));
                                                let _e1796 = bitcast<f32>((_e1776 & bitcast<u32>(~(_e1781))));
                                                let _e1797 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1678 & 1023u))) - 8388608f) * _e1723));
                                                let _e1802 = (bitcast<i32>((_e1678 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1805 = bitcast<f32>((_e1797 & bitcast<u32>(_e1802)));
                                                let _e1806 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1687 & 1023u))) - 8388608f) * _e1725));
                                                let _e1811 = (bitcast<i32>((_e1687 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1814 = bitcast<f32>((_e1806 & bitcast<u32>(_e1811)));
                                                let _e1815 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1696 & 1023u))) - 8388608f) * _e1727));
                                                let _e1820 = (bitcast<i32>((_e1696 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1823 = bitcast<f32>((_e1815 & bitcast<u32>(_e1820)));
                                                let _e1827 = bitcast<f32>((_e1797 & bitcast<u32>(~(_e1802))));
                                                let _e1831 = bitcast<f32>((_e1806 & bitcast<u32>(~(_e1811))));
                                                let _e1835 = bitcast<f32>((_e1815 & bitcast<u32>(~(_e1820))));
                                                let _e1865 = global_5.member[_e853.member_1][0u];
                                                let _e1869 = global_5.member[_e853.member_1][1u];
                                                let _e1873 = global_5.member[_e853.member_1][2u];
                                                let _e1877 = global_5.member[_e853.member_1][3u];
                                                let _e1889 = (((_e1869 >> bitcast<u32>(22i)) | ((_e1873 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1877 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1890 = (_e1865 & 268435455u);
                                                let _e1891 = (_e1889 & 268435455u);
                                                let _e1894 = ((_e1865 >> bitcast<u32>(28u)) & 7u);
                                                let _e1902 = ((_e1865 >> bitcast<u32>(31i)) | (((_e1889 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1903 = (_e1894 != 0u);
                                                if (_e1894 == 0u) {
                                                    phi_3593_ = _e1890;
                                                } else {
                                                    if (_e1894 == 7u) {
                                                        phi_3592_ = 2147483648u;
                                                    } else {
                                                        phi_3592_ = ((2147483648u | (_e1894 << bitcast<u32>(28u))) | (_e1891 & 268435455u));
                                                    }
                                                    let _e1912 = phi_3592_;
                                                    phi_3593_ = _e1912;
                                                }
                                                let _e1914 = phi_3593_;
                                                if _e1903 {
                                                    let _e1915 = (_e1894 != 7u);
                                                    if _e1915 {
                                                        phi_3603_ = (_e1891 + _e1894);
                                                    } else {
                                                        phi_3603_ = u32();
                                                    }
                                                    let _e1918 = phi_3603_;
                                                    phi_3605_ = _e1918;
                                                    phi_3606_ = select(true, false, _e1915);
                                                } else {
                                                    phi_3605_ = u32();
                                                    phi_3606_ = true;
                                                }
                                                let _e1921 = phi_3605_;
                                                let _e1923 = phi_3606_;
                                                if (_e1902 == 0u) {
                                                    phi_3627_ = (_e1890 + select(0u, 1u, !(_e1903)));
                                                } else {
                                                    if (_e1902 == 7u) {
                                                        phi_3626_ = 2147483648u;
                                                    } else {
                                                        phi_3626_ = ((2147483648u | (_e1902 << bitcast<u32>(28u))) | (select(_e1921, _e1891, _e1923) & 268435455u));
                                                    }
                                                    let _e1936 = phi_3626_;
                                                    phi_3627_ = _e1936;
                                                }
                                                let _e1938 = phi_3627_;
                                                phi_3631_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e853.member.member.x + _e1766), (_e853.member.member.x + _e1788), (_e853.member.member_1.x - _e1805), (_e853.member.member_1.x - _e1827)), vec4<f32>((_e853.member.member.y + _e1775), (_e853.member.member.y + _e1792), (_e853.member.member_1.y - _e1814), (_e853.member.member_1.y - _e1831)), vec4<f32>((_e853.member.member.z + _e1784), (_e853.member.member.z + _e1796), (_e853.member.member_1.z - _e1823), (_e853.member.member_1.z - _e1835))), type_63(type_39((_e853.member.member + vec4<f32>(_e1766, _e1775, _e1784, 0f)), (_e853.member.member_1 - vec4<f32>(_e1805, _e1814, _e1823, 0f))), _e1914), type_63(type_39((_e853.member.member + vec4<f32>(_e1788, _e1792, _e1796, 0f)), (_e853.member.member_1 - vec4<f32>(_e1827, _e1831, _e1835, 0f))), _e1938));
                                            }
                                            let _e1943 = phi_3631_;
                                            let _e1955 = ((_e1943.member[0].x - _e518) * _e523);
                                            let _e1956 = ((_e1943.member[0].y - _e518) * _e523);
                                            let _e1957 = ((_e1943.member[0].z - _e519) * _e523);
                                            let _e1958 = ((_e1943.member[0].w - _e519) * _e523);
                                            let _e1968 = ((_e1943.member[1].x - _e584) * _e589);
                                            let _e1969 = ((_e1943.member[1].y - _e584) * _e589);
                                            let _e1970 = ((_e1943.member[1].z - _e585) * _e589);
                                            let _e1971 = ((_e1943.member[1].w - _e585) * _e589);
                                            let _e1981 = ((_e1943.member[2].x - _e650) * _e655);
                                            let _e1982 = ((_e1943.member[2].y - _e650) * _e655);
                                            let _e1983 = ((_e1943.member[2].z - _e651) * _e655);
                                            let _e1984 = ((_e1943.member[2].w - _e651) * _e655);
                                            let _e1986 = select(_e1983, _e1981, (_e1981 < _e1983));
                                            let _e1988 = select(_e1984, _e1982, (_e1982 < _e1984));
                                            let _e1990 = select(_e1983, _e1981, (_e1981 > _e1983));
                                            let _e1992 = select(_e1984, _e1982, (_e1982 > _e1984));
                                            let _e1994 = select(_e1957, _e1955, (_e1955 < _e1957));
                                            let _e1996 = select(_e1958, _e1956, (_e1956 < _e1958));
                                            let _e1998 = select(_e1970, _e1968, (_e1968 < _e1970));
                                            let _e2000 = select(_e1971, _e1969, (_e1969 < _e1971));
                                            let _e2002 = select(_e1998, _e1994, (_e1994 > _e1998));
                                            let _e2004 = select(_e2000, _e1996, (_e1996 > _e2000));
                                            let _e2006 = select(_e1986, _e2002, (_e2002 > _e1986));
                                            let _e2008 = select(_e1988, _e2004, (_e2004 > _e1988));
                                            let _e2010 = select(_e1957, _e1955, (_e1955 > _e1957));
                                            let _e2012 = select(_e1958, _e1956, (_e1956 > _e1958));
                                            let _e2014 = select(_e1970, _e1968, (_e1968 > _e1970));
                                            let _e2016 = select(_e1971, _e1969, (_e1969 > _e1971));
                                            let _e2018 = select(_e2014, _e2010, (_e2010 < _e2014));
                                            let _e2020 = select(_e2016, _e2012, (_e2012 < _e2016));
                                            let _e2025 = -(_e1986);
                                            let _e2026 = -(_e1988);
                                            let _e2033 = (select(_e1990, _e2018, (_e2018 < _e1990)) + (select(_e2025, _e1990, (_e1990 > _e2025)) * 0.0000019073523f));
                                            let _e2034 = (select(_e1992, _e2020, (_e2020 < _e1992)) + (select(_e2026, _e1992, (_e1992 > _e2026)) * 0.0000019073523f));
                                            let _e2036 = select(_e766, _e2006, (_e2006 > _e766));
                                            let _e2038 = select(_e766, _e2008, (_e2008 > _e766));
                                            let _e2043 = (_e2036 <= select(_e1667.member, _e2033, (_e2033 < _e1667.member)));
                                            let _e2044 = (_e2038 <= select(_e1667.member, _e2034, (_e2034 < _e1667.member)));
                                            let _e2045 = (_e2036 <= _e2038);
                                            if _e2043 {
                                                if _e2044 {
                                                    if _e2045 {
                                                        phi_3993_ = _e1943.member_2;
                                                    } else {
                                                        phi_3993_ = _e1943.member_1;
                                                    }
                                                    let _e2049 = phi_3993_;
                                                    let _e2070 = (_e851 % 128u);
                                                    let _e2071 = (_e2070 < 128u);
                                                    if _e2071 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2070] = _e2049.member_1;
                                                    if _e2071 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2070] = _e2049.member.member.x;
                                                    if _e2071 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2070] = _e2049.member.member.y;
                                                    if _e2071 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2070] = _e2049.member.member.z;
                                                    if _e2071 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2070] = _e2049.member.member_1.x;
                                                    if _e2071 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2070] = _e2049.member.member_1.y;
                                                    if _e2071 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2070] = _e2049.member.member_1.z;
                                                    if _e2071 {
                                                    } else {
                                                        phi_4563_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2070] = select(_e2036, _e2038, _e2045);
                                                    if _e2045 {
                                                        phi_4069_ = _e1943.member_1;
                                                    } else {
                                                        phi_4069_ = _e1943.member_2;
                                                    }
                                                    let _e2084 = phi_4069_;
                                                    phi_4070_ = (_e851 + 1u);
                                                    phi_4071_ = _e2084;
                                                } else {
                                                    phi_4070_ = u32();
                                                    phi_4071_ = type_63();
                                                }
                                                let _e2086 = phi_4070_;
                                                let _e2088 = phi_4071_;
                                                phi_4073_ = _e2086;
                                                phi_4074_ = _e2088;
                                                phi_4075_ = select(true, false, _e2044);
                                            } else {
                                                phi_4073_ = u32();
                                                phi_4074_ = type_63();
                                                phi_4075_ = true;
                                            }
                                            let _e2091 = phi_4073_;
                                            let _e2093 = phi_4074_;
                                            let _e2095 = phi_4075_;
                                            if _e2095 {
                                                if _e2043 {
                                                    phi_4084_ = _e1943.member_1;
                                                } else {
                                                    phi_4084_ = _e1943.member_2;
                                                }
                                                let _e2099 = phi_4084_;
                                                phi_4089_ = select(_e2044, true, _e2043);
                                                phi_4091_ = _e2099;
                                            } else {
                                                phi_4089_ = _e849;
                                                phi_4091_ = _e2093;
                                            }
                                            let _e2102 = phi_4089_;
                                            let _e2104 = phi_4091_;
                                            phi_4095_ = _e2102;
                                            phi_4096_ = select(_e2091, _e851, _e2095);
                                            phi_4097_ = _e2104;
                                        }
                                        let _e2107 = phi_4095_;
                                        let _e2109 = phi_4096_;
                                        let _e2111 = phi_4097_;
                                        if _e857 {
                                            phi_4107_ = select(_e851, 0u, _e1667.member_1);
                                            phi_4108_ = _e853;
                                        } else {
                                            phi_4107_ = _e2109;
                                            phi_4108_ = _e2111;
                                        }
                                        let _e2115 = phi_4107_;
                                        let _e2117 = phi_4108_;
                                        phi_4566_ = _e1665;
                                        phi_4109_ = _e1667;
                                        phi_4110_ = (_e812 - 1u);
                                        phi_4111_ = select(_e2107, false, _e857);
                                        phi_4112_ = _e2115;
                                        phi_4113_ = _e2117;
                                    } else {
                                        phi_4566_ = _e808;
                                        phi_4109_ = _e810;
                                        phi_4110_ = _e812;
                                        phi_4111_ = _e849;
                                        phi_4112_ = _e851;
                                        phi_4113_ = _e853;
                                    }
                                    let _e2120 = phi_4566_;
                                    let _e2122 = phi_4109_;
                                    let _e2124 = phi_4110_;
                                    let _e2126 = phi_4111_;
                                    let _e2128 = phi_4112_;
                                    let _e2130 = phi_4113_;
                                    phi_4565_ = _e2120;
                                    phi_4114_ = _e2122;
                                    phi_4115_ = _e2124;
                                    phi_4116_ = _e2126;
                                    phi_4117_ = _e2128;
                                    phi_4118_ = _e2130;
                                } else {
                                    phi_4565_ = _e808;
                                    phi_4114_ = type_51();
                                    phi_4115_ = u32();
                                    phi_4116_ = bool();
                                    phi_4117_ = u32();
                                    phi_4118_ = type_63();
                                }
                                let _e2132 = phi_4565_;
                                let _e2134 = phi_4114_;
                                let _e2136 = phi_4115_;
                                let _e2138 = phi_4116_;
                                let _e2140 = phi_4117_;
                                let _e2142 = phi_4118_;
                                phi_4564_ = _e2132;
                                phi_1360_ = _e2134;
                                phi_1363_ = _e2136;
                                phi_1365_ = _e2138;
                                phi_1367_ = _e2140;
                                phi_1369_ = _e2142;
                                phi_4119_ = _e822;
                            } else {
                                phi_4564_ = _e808;
                                phi_1360_ = type_51();
                                phi_1363_ = u32();
                                phi_1365_ = bool();
                                phi_1367_ = u32();
                                phi_1369_ = type_63();
                                phi_4119_ = false;
                            }
                            let _e2144 = phi_4564_;
                            let _e2146 = phi_1360_;
                            let _e2148 = phi_1363_;
                            let _e2150 = phi_1365_;
                            let _e2152 = phi_1367_;
                            let _e2154 = phi_1369_;
                            let _e2156 = phi_4119_;
                            continue;
                            continuing {
                                phi_4377_ = _e2144;
                                phi_1359_ = _e2146;
                                phi_1362_ = _e2148;
                                phi_1364_ = _e2150;
                                phi_1366_ = _e2152;
                                phi_1368_ = _e2154;
                                phi_4563_ = _e2144;
                                break if !(_e2156);
                            }
                        }
                        let _e2159 = phi_4563_;
                        if _e2159 {
                            break;
                        }
                        let _e2161 = local_10;
                        if _e2161.member_1 {
                        } else {
                            if _e301 {
                            } else {
                                break;
                            }
                            let _e2165 = global_2.member[_e147];
                            if _e162 {
                            } else {
                                break;
                            }
                            let _e2169 = global_10.member[_e147].member_1;
                            if _e301 {
                            } else {
                                break;
                            }
                            global_2.member[_e147] = type_32(_e2165.member, _e2165.member_1, _e2165.member_2, array<f32, 3>((_e2165.member_3[0] + (_e2169[0] * _e2165.member_1[0])), (_e2165.member_3[1] + (_e2169[1] * _e2165.member_1[1])), (_e2165.member_3[2] + (_e2169[2] * _e2165.member_1[2]))), _e2165.member_4);
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
