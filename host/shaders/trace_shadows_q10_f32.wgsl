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
    var phi_330_: u32;
    var phi_374_: i32;
    var phi_514_: type_45;
    var phi_664_: i32;
    var phi_665_: i32;
    var phi_675_: bool;
    var phi_685_: u32;
    var phi_686_: u32;
    var phi_688_: bool;
    var phi_693_: u32;
    var phi_725_: i32;
    var phi_743_: f32;
    var phi_749_: f32;
    var phi_789_: f32;
    var phi_795_: f32;
    var phi_847_: f32;
    var phi_858_: f32;
    var phi_867_: f32;
    var phi_873_: f32;
    var phi_913_: f32;
    var phi_919_: f32;
    var phi_971_: f32;
    var phi_982_: f32;
    var phi_991_: f32;
    var phi_997_: f32;
    var phi_1037_: f32;
    var phi_1043_: f32;
    var phi_1095_: f32;
    var phi_1106_: f32;
    var phi_1161_: i32;
    var phi_1183_: u32;
    var phi_1184_: u32;
    var phi_1221_: i32;
    var phi_1243_: u32;
    var phi_1244_: u32;
    var phi_1252_: f32;
    var phi_1253_: f32;
    var phi_4257_: bool;
    var phi_1342_: type_51;
    var phi_1345_: type_63;
    var phi_1347_: u32;
    var phi_1349_: bool;
    var phi_1351_: u32;
    var phi_1362_: bool;
    var phi_1448_: type_63;
    var phi_1449_: bool;
    var phi_1450_: u32;
    var phi_3502_: u32;
    var phi_3503_: u32;
    var phi_3513_: u32;
    var phi_3515_: u32;
    var phi_3516_: bool;
    var phi_3536_: u32;
    var phi_3537_: u32;
    var phi_3541_: type_64;
    var phi_3885_: type_63;
    var phi_3962_: type_63;
    var phi_3963_: type_63;
    var phi_3964_: u32;
    var phi_3966_: type_63;
    var phi_3967_: u32;
    var phi_3968_: bool;
    var phi_3977_: type_63;
    var phi_3982_: type_63;
    var phi_3983_: bool;
    var phi_1468_: type_51;
    var phi_1471_: type_8;
    var phi_1472_: type_8;
    var phi_1494_: type_8;
    var phi_1515_: u32;
    var phi_1604_: array<array<f32, 3>, 3>;
    var phi_1721_: bool;
    var phi_1750_: bool;
    var phi_2151_: f32;
    var phi_2152_: f32;
    var phi_2153_: f32;
    var phi_2154_: f32;
    var phi_2155_: vec3<f32>;
    var phi_2156_: vec3<f32>;
    var phi_2157_: vec3<f32>;
    var phi_2158_: vec3<f32>;
    var phi_2189_: bool;
    var phi_2198_: vec3<f32>;
    var phi_2363_: f32;
    var phi_2365_: f32;
    var phi_2366_: bool;
    var phi_2386_: f32;
    var phi_2387_: f32;
    var phi_2410_: type_30;
    var phi_2412_: type_30;
    var phi_2413_: bool;
    var phi_2417_: type_30;
    var phi_2418_: type_30;
    var phi_2419_: type_30;
    var phi_2420_: bool;
    var phi_2424_: type_30;
    var phi_2425_: bool;
    var phi_2426_: type_30;
    var phi_2427_: bool;
    var phi_2428_: bool;
    var phi_2429_: type_30;
    var phi_2430_: bool;
    var phi_2431_: bool;
    var phi_2439_: type_30;
    var phi_2440_: bool;
    var phi_2444_: type_30;
    var phi_2467_: u32;
    var phi_2481_: i32;
    var phi_2501_: vec3<f32>;
    var phi_2502_: vec3<f32>;
    var phi_2518_: vec3<f32>;
    var phi_2519_: vec3<f32>;
    var phi_2535_: vec3<f32>;
    var phi_2536_: vec3<f32>;
    var phi_2572_: vec3<f32>;
    var phi_2754_: f32;
    var phi_2772_: bool;
    var phi_2773_: bool;
    var phi_2778_: type_51;
    var phi_2779_: type_51;
    var phi_1469_: type_51;
    var phi_4251_: bool;
    var local_10: type_51;
    var phi_4447_: bool;
    var phi_3985_: type_51;
    var phi_3986_: type_63;
    var phi_3987_: bool;
    var phi_3988_: u32;
    var phi_4446_: bool;
    var phi_3989_: type_51;
    var phi_3990_: type_63;
    var phi_3991_: u32;
    var phi_3992_: bool;
    var phi_3993_: u32;
    var phi_4445_: bool;
    var phi_3994_: type_51;
    var phi_3995_: type_63;
    var phi_3996_: u32;
    var phi_3997_: bool;
    var phi_3998_: u32;
    var phi_4444_: bool;
    var phi_1343_: type_51;
    var phi_1346_: type_63;
    var phi_1348_: u32;
    var phi_1350_: bool;
    var phi_1352_: u32;
    var phi_3999_: bool;
    var phi_4443_: bool;
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
                phi_330_ = _e166;
            } else {
                phi_330_ = 4294967295u;
            }
            let _e168 = phi_330_;
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
                phi_374_ = -126i;
            } else {
                phi_374_ = select(_e211, 127i, (_e211 > 127i));
            }
            let _e216 = phi_374_;
            let _e221 = bitcast<f32>((bitcast<u32>((_e216 + 127i)) << bitcast<u32>(23i)));
            let _e227 = bitcast<f32>((bitcast<u32>(((_e211 - _e216) + 127i)) << bitcast<u32>(23i)));
            if (_e187 == 0u) {
                phi_514_ = type_45(array<f32, 3>(_e204, _e205, _e206), _e187, _e208, _e209);
            } else {
                let _e229 = bitcast<u32>(_e204);
                let _e231 = ((_e229 & 2139095040u) != 0u);
                let _e246 = bitcast<u32>(_e205);
                let _e248 = ((_e246 & 2139095040u) != 0u);
                let _e263 = bitcast<u32>(_e206);
                let _e265 = ((_e263 & 2139095040u) != 0u);
                let _e281 = bitcast<u32>(_e208);
                let _e283 = ((_e281 & 2139095040u) != 0u);
                phi_514_ = type_45(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e229 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e229 & 2147483648u))), _e204, _e231) * _e221) * select(0.00000011920929f, 1f, _e231)) * _e227), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e246 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e246 & 2147483648u))), _e205, _e248) * _e221) * select(0.00000011920929f, 1f, _e248)) * _e227), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e263 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e263 & 2147483648u))), _e206, _e265) * _e221) * select(0.00000011920929f, 1f, _e265)) * _e227)), _e187, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e281 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e281 & 2147483648u))), _e208, _e283) * _e221) * select(0.00000011920929f, 1f, _e283)) * _e227), _e209);
            }
            let _e300 = phi_514_;
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
                                phi_664_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_664_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                            }
                            let _e412 = phi_664_;
                            phi_665_ = _e412;
                        } else {
                            phi_665_ = 0i;
                        }
                        let _e414 = phi_665_;
                        let _e415 = (_e334 == _e378);
                        if _e415 {
                            phi_675_ = true;
                        } else {
                            phi_675_ = (_e342 == _e378);
                        }
                        let _e418 = phi_675_;
                        let _e419 = select(1u, 0u, _e415);
                        if _e418 {
                            let _e420 = (_e419 + 1u);
                            phi_685_ = _e420;
                            phi_686_ = _e420;
                            phi_688_ = select(true, false, (_e420 == 2u));
                        } else {
                            phi_685_ = u32();
                            phi_686_ = 0u;
                            phi_688_ = true;
                        }
                        let _e424 = phi_685_;
                        let _e426 = phi_686_;
                        let _e428 = phi_688_;
                        if _e428 {
                            phi_693_ = (_e426 + 1u);
                        } else {
                            phi_693_ = 0u;
                        }
                        let _e432 = phi_693_;
                        let _e433 = select(_e424, _e426, _e428);
                        let _e434 = select(_e419, select(2u, _e419, _e418), _e428);
                        let _e435 = -(_e414);
                        if (_e435 < -126i) {
                            phi_725_ = -126i;
                        } else {
                            phi_725_ = select(_e435, 127i, (_e435 > 127i));
                        }
                        let _e440 = phi_725_;
                        let _e445 = bitcast<f32>((bitcast<u32>((_e440 + 127i)) << bitcast<u32>(23i)));
                        let _e451 = bitcast<f32>((bitcast<u32>(((_e435 - _e440) + 127i)) << bitcast<u32>(23i)));
                        let _e456 = global_10.member[_e147].member.member;
                        let _e457 = (_e433 == 0u);
                        if _e457 {
                            phi_743_ = _e456[0];
                        } else {
                            phi_743_ = _e456[1];
                        }
                        let _e461 = phi_743_;
                        let _e462 = (_e433 == 2u);
                        if _e462 {
                            phi_749_ = _e456[2];
                        } else {
                            phi_749_ = _e461;
                        }
                        let _e465 = phi_749_;
                        let _e466 = bitcast<u32>(_e465);
                        let _e468 = ((_e466 & 2139095040u) != 0u);
                        let _e480 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e466 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e466 & 2147483648u))), _e465, _e468) * select(0.00000011920929f, 1f, _e468));
                        let _e481 = global_10.member[_e147].member.member_2;
                        if _e457 {
                            phi_789_ = _e481[0];
                        } else {
                            phi_789_ = _e481[1];
                        }
                        let _e485 = phi_789_;
                        if _e462 {
                            phi_795_ = _e481[2];
                        } else {
                            phi_795_ = _e485;
                        }
                        let _e488 = phi_795_;
                        let _e489 = bitcast<u32>(_e488);
                        let _e491 = ((_e489 & 2139095040u) != 0u);
                        let _e505 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e489 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e489 & 2147483648u))), _e488, _e491) * _e445) * select(0.00000011920929f, 1f, _e491)) * _e451);
                        let _e509 = (bitcast<f32>((bitcast<u32>(_e505) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e509 {
                            let _e513 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) * 0.00000011920929f);
                            phi_847_ = select(0.00000000000011368684f, _e513, (_e513 > 0.00000000000011368684f));
                        } else {
                            phi_847_ = 0f;
                        }
                        let _e517 = phi_847_;
                        let _e518 = (_e480 + _e517);
                        let _e519 = (_e480 - _e517);
                        let _e520 = select(_e505, 0f, _e509);
                        if _e509 {
                            phi_858_ = 38685626000000000000000000f;
                        } else {
                            phi_858_ = (1f / _e505);
                        }
                        let _e523 = phi_858_;
                        let _e524 = (_e432 == 0u);
                        if _e524 {
                            phi_867_ = _e456[0];
                        } else {
                            phi_867_ = _e456[1];
                        }
                        let _e528 = phi_867_;
                        let _e529 = (_e432 == 2u);
                        if _e529 {
                            phi_873_ = _e456[2];
                        } else {
                            phi_873_ = _e528;
                        }
                        let _e532 = phi_873_;
                        let _e533 = bitcast<u32>(_e532);
                        let _e535 = ((_e533 & 2139095040u) != 0u);
                        let _e547 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e533 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e533 & 2147483648u))), _e532, _e535) * select(0.00000011920929f, 1f, _e535));
                        if _e524 {
                            phi_913_ = _e481[0];
                        } else {
                            phi_913_ = _e481[1];
                        }
                        let _e551 = phi_913_;
                        if _e529 {
                            phi_919_ = _e481[2];
                        } else {
                            phi_919_ = _e551;
                        }
                        let _e554 = phi_919_;
                        let _e555 = bitcast<u32>(_e554);
                        let _e557 = ((_e555 & 2139095040u) != 0u);
                        let _e571 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e555 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e555 & 2147483648u))), _e554, _e557) * _e445) * select(0.00000011920929f, 1f, _e557)) * _e451);
                        let _e575 = (bitcast<f32>((bitcast<u32>(_e571) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e575 {
                            let _e579 = (bitcast<f32>((bitcast<u32>(_e547) & 2147483647u)) * 0.00000011920929f);
                            phi_971_ = select(0.00000000000011368684f, _e579, (_e579 > 0.00000000000011368684f));
                        } else {
                            phi_971_ = 0f;
                        }
                        let _e583 = phi_971_;
                        let _e584 = (_e547 + _e583);
                        let _e585 = (_e547 - _e583);
                        let _e586 = select(_e571, 0f, _e575);
                        if _e575 {
                            phi_982_ = 38685626000000000000000000f;
                        } else {
                            phi_982_ = (1f / _e571);
                        }
                        let _e589 = phi_982_;
                        let _e590 = (_e434 == 0u);
                        if _e590 {
                            phi_991_ = _e456[0];
                        } else {
                            phi_991_ = _e456[1];
                        }
                        let _e594 = phi_991_;
                        let _e595 = (_e434 == 2u);
                        if _e595 {
                            phi_997_ = _e456[2];
                        } else {
                            phi_997_ = _e594;
                        }
                        let _e598 = phi_997_;
                        let _e599 = bitcast<u32>(_e598);
                        let _e601 = ((_e599 & 2139095040u) != 0u);
                        let _e613 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e599 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e599 & 2147483648u))), _e598, _e601) * select(0.00000011920929f, 1f, _e601));
                        if _e590 {
                            phi_1037_ = _e481[0];
                        } else {
                            phi_1037_ = _e481[1];
                        }
                        let _e617 = phi_1037_;
                        if _e595 {
                            phi_1043_ = _e481[2];
                        } else {
                            phi_1043_ = _e617;
                        }
                        let _e620 = phi_1043_;
                        let _e621 = bitcast<u32>(_e620);
                        let _e623 = ((_e621 & 2139095040u) != 0u);
                        let _e637 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e621 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e621 & 2147483648u))), _e620, _e623) * _e445) * select(0.00000011920929f, 1f, _e623)) * _e451);
                        let _e641 = (bitcast<f32>((bitcast<u32>(_e637) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e641 {
                            let _e645 = (bitcast<f32>((bitcast<u32>(_e613) & 2147483647u)) * 0.00000011920929f);
                            phi_1095_ = select(0.00000000000011368684f, _e645, (_e645 > 0.00000000000011368684f));
                        } else {
                            phi_1095_ = 0f;
                        }
                        let _e649 = phi_1095_;
                        let _e650 = (_e613 + _e649);
                        let _e651 = (_e613 - _e649);
                        let _e652 = select(_e637, 0f, _e641);
                        if _e641 {
                            phi_1106_ = 38685626000000000000000000f;
                        } else {
                            phi_1106_ = (1f / _e637);
                        }
                        let _e655 = phi_1106_;
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
                                phi_1161_ = 255i;
                            } else {
                                phi_1161_ = (((_e681 + select(0i, 1i, (_e681 == 0i))) - _e688) + _e414);
                            }
                            let _e696 = phi_1161_;
                            let _e706 = (_e696 <= 0i);
                            if _e706 {
                                phi_1184_ = u32();
                            } else {
                                if _e685 {
                                    phi_1183_ = u32();
                                } else {
                                    phi_1183_ = select(((bitcast<u32>(_e696) << bitcast<u32>(23i)) | ((_e678 << bitcast<u32>(((_e688 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e696 >= 255i));
                                }
                                let _e710 = phi_1183_;
                                phi_1184_ = _e710;
                            }
                            let _e712 = phi_1184_;
                            let _e724 = ((_e391 & 8388607u) | (select(0u, 1u, ((_e391 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e727 = bitcast<i32>((_e391 >> bitcast<u32>(23i)));
                            let _e731 = (_e724 == 0u);
                            let _e734 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e724)), 32u, _e731)) - 8i);
                            if (_e727 == 255i) {
                                phi_1221_ = 255i;
                            } else {
                                phi_1221_ = (((_e727 + select(0i, 1i, (_e727 == 0i))) - _e734) + _e414);
                            }
                            let _e742 = phi_1221_;
                            let _e752 = (_e742 <= 0i);
                            if _e752 {
                                phi_1244_ = u32();
                            } else {
                                if _e731 {
                                    phi_1243_ = u32();
                                } else {
                                    phi_1243_ = select(((bitcast<u32>(_e742) << bitcast<u32>(23i)) | ((_e724 << bitcast<u32>(((_e734 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e742 >= 255i));
                                }
                                let _e756 = phi_1243_;
                                phi_1244_ = _e756;
                            }
                            let _e758 = phi_1244_;
                            phi_1252_ = bitcast<f32>(((_e390 & 2147483648u) | select(_e758, 0u, select(_e731, true, _e752))));
                            phi_1253_ = bitcast<f32>(((_e385 & 2147483648u) | select(_e712, 0u, select(_e685, true, _e706))));
                        } else {
                            phi_1252_ = 0f;
                            phi_1253_ = 1f;
                        }
                        let _e764 = phi_1252_;
                        let _e766 = phi_1253_;
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
                        phi_4257_ = false;
                        phi_1342_ = type_51(_e764, false);
                        phi_1345_ = type_63(type_39(vec4<f32>((f32(_e773) * _e159), (f32(_e779) * _e159), (f32(_e785) * _e159), 0f), vec4<f32>((f32(_e790) * _e159), (f32(_e794) * _e159), (f32(_e798) * _e159), 0f)), select(0u, 2147483648u, (_e101 == 0u)));
                        phi_1347_ = ((3u * _e101) + 1u);
                        phi_1349_ = (_e766 <= _e764);
                        phi_1351_ = 0u;
                        loop {
                            let _e808 = phi_4257_;
                            let _e810 = phi_1342_;
                            let _e812 = phi_1345_;
                            let _e814 = phi_1347_;
                            let _e816 = phi_1349_;
                            let _e818 = phi_1351_;
                            local_11 = _e810;
                            if _e816 {
                                phi_1362_ = true;
                            } else {
                                phi_1362_ = (_e818 > 0u);
                            }
                            let _e821 = phi_1362_;
                            if _e821 {
                                let _e822 = (_e814 > 0u);
                                if _e822 {
                                    if _e816 {
                                        phi_1448_ = _e812;
                                        phi_1449_ = _e816;
                                        phi_1450_ = _e818;
                                    } else {
                                        let _e823 = (_e818 - 1u);
                                        let _e824 = (_e823 % 128u);
                                        let _e825 = (_e824 < 128u);
                                        if _e825 {
                                        } else {
                                            phi_4443_ = true;
                                            break;
                                        }
                                        let _e827 = local_7[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4443_ = true;
                                            break;
                                        }
                                        let _e829 = local_6[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4443_ = true;
                                            break;
                                        }
                                        let _e831 = local_5[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4443_ = true;
                                            break;
                                        }
                                        let _e833 = local_4[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4443_ = true;
                                            break;
                                        }
                                        let _e835 = local_3[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4443_ = true;
                                            break;
                                        }
                                        let _e837 = local_2[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4443_ = true;
                                            break;
                                        }
                                        let _e842 = local_8[_e824];
                                        if _e825 {
                                        } else {
                                            phi_4443_ = true;
                                            break;
                                        }
                                        let _e845 = local_9[_e824];
                                        phi_1448_ = type_63(type_39(vec4<f32>(_e827, _e829, _e831, 0f), vec4<f32>(_e833, _e835, _e837, 0f)), _e842);
                                        phi_1449_ = (_e845 <= _e810.member);
                                        phi_1450_ = _e823;
                                    }
                                    let _e849 = phi_1448_;
                                    let _e851 = phi_1449_;
                                    let _e853 = phi_1450_;
                                    if _e851 {
                                        if ((_e849.member_1 & 2147483648u) != 0u) {
                                            phi_1468_ = _e810;
                                            phi_1471_ = type_8(0u, ((_e849.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1303 = phi_1468_;
                                                let _e1305 = phi_1471_;
                                                local_10 = _e1303;
                                                local_12 = _e1303;
                                                if (_e1305.member < _e1305.member_1) {
                                                    phi_1472_ = type_8((_e1305.member + 1u), _e1305.member_1);
                                                    phi_1494_ = type_8(1u, _e1305.member);
                                                } else {
                                                    phi_1472_ = _e1305;
                                                    phi_1494_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1318 = phi_1472_;
                                                let _e1320 = phi_1494_;
                                                let _e1324 = (bitcast<i32>(_e1320.member) != 0i);
                                                if _e1324 {
                                                    let _e1325 = ((_e849.member_1 & 268435455u) + _e1320.member_1);
                                                    let _e1326 = (_e1325 < _e103);
                                                    if _e1326 {
                                                        if _e1326 {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        let _e1330 = global_6.member[_e1325].member_1;
                                                        phi_1515_ = _e1330;
                                                    } else {
                                                        phi_1515_ = 4294967295u;
                                                    }
                                                    let _e1332 = phi_1515_;
                                                    if (_e1325 >= _e103) {
                                                        phi_1604_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1326 {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        if (_e770 < 9u) {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        let _e1339 = global_6.member[_e1325].member[_e770];
                                                        if (_e776 < 9u) {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        let _e1345 = global_6.member[_e1325].member[_e776];
                                                        if (_e782 < 9u) {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        let _e1351 = global_6.member[_e1325].member[_e782];
                                                        let _e1353 = (3u + _e770);
                                                        if (_e1353 < 9u) {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        let _e1359 = global_6.member[_e1325].member[_e1353];
                                                        let _e1360 = (3u + _e776);
                                                        if (_e1360 < 9u) {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        let _e1366 = global_6.member[_e1325].member[_e1360];
                                                        let _e1367 = (3u + _e782);
                                                        if (_e1367 < 9u) {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        let _e1373 = global_6.member[_e1325].member[_e1367];
                                                        let _e1375 = (6u + _e770);
                                                        if (_e1375 < 9u) {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        let _e1381 = global_6.member[_e1325].member[_e1375];
                                                        let _e1382 = (6u + _e776);
                                                        if (_e1382 < 9u) {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        let _e1388 = global_6.member[_e1325].member[_e1382];
                                                        let _e1389 = (6u + _e782);
                                                        if (_e1389 < 9u) {
                                                        } else {
                                                            phi_4251_ = true;
                                                            break;
                                                        }
                                                        let _e1395 = global_6.member[_e1325].member[_e1389];
                                                        phi_1604_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1339, _e1345, _e1351), array<f32, 3>(_e1359, _e1366, _e1373), array<f32, 3>(_e1381, _e1388, _e1395));
                                                    }
                                                    let _e1399 = phi_1604_;
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
                                                            phi_2429_ = type_30();
                                                            phi_2430_ = true;
                                                            phi_2431_ = false;
                                                        } else {
                                                            let _e1474 = select(_e1423, _e1410, (_e1410 < _e1423));
                                                            if (select(_e1436, _e1474, (_e1474 < _e1436)) > 0f) {
                                                                phi_1721_ = true;
                                                            } else {
                                                                let _e1479 = select(_e1423, _e1410, (_e1410 > _e1423));
                                                                phi_1721_ = (select(_e1436, _e1479, (_e1479 > _e1436)) < 0f);
                                                            }
                                                            let _e1484 = phi_1721_;
                                                            if _e1484 {
                                                                phi_2426_ = type_30();
                                                                phi_2427_ = true;
                                                                phi_2428_ = false;
                                                            } else {
                                                                let _e1486 = select(_e1426, _e1413, (_e1413 < _e1426));
                                                                if (select(_e1439, _e1486, (_e1486 < _e1439)) > 0f) {
                                                                    phi_1750_ = true;
                                                                } else {
                                                                    let _e1491 = select(_e1426, _e1413, (_e1413 > _e1426));
                                                                    phi_1750_ = (select(_e1439, _e1491, (_e1491 > _e1439)) < 0f);
                                                                }
                                                                let _e1496 = phi_1750_;
                                                                if _e1496 {
                                                                    phi_2424_ = type_30();
                                                                    phi_2425_ = false;
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
                                                                        phi_2419_ = type_30();
                                                                        phi_2420_ = true;
                                                                    } else {
                                                                        let _e1561 = (_e1559 > _e1303.member);
                                                                        if _e1561 {
                                                                            phi_2418_ = type_30();
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
                                                                                phi_2151_ = _e1426;
                                                                                phi_2152_ = _e1423;
                                                                                phi_2153_ = _e1413;
                                                                                phi_2154_ = _e1410;
                                                                                phi_2155_ = _e1562;
                                                                                phi_2156_ = _e1576;
                                                                                phi_2157_ = _e1572;
                                                                                phi_2158_ = _e1568;
                                                                            } else {
                                                                                let _e1621 = (_e1602 == _e1619);
                                                                                let _e1626 = vec3(_e1621);
                                                                                phi_2151_ = select(_e1413, _e1439, _e1621);
                                                                                phi_2152_ = select(_e1410, _e1436, _e1621);
                                                                                phi_2153_ = select(_e1439, _e1426, _e1621);
                                                                                phi_2154_ = select(_e1436, _e1423, _e1621);
                                                                                phi_2155_ = select(_e1564, _e1563, _e1626);
                                                                                phi_2156_ = select(_e1572, _e1568, _e1626);
                                                                                phi_2157_ = select(_e1568, _e1576, _e1626);
                                                                                phi_2158_ = select(_e1576, _e1572, _e1626);
                                                                            }
                                                                            let _e1632 = phi_2151_;
                                                                            let _e1634 = phi_2152_;
                                                                            let _e1636 = phi_2153_;
                                                                            let _e1638 = phi_2154_;
                                                                            let _e1640 = phi_2155_;
                                                                            let _e1642 = phi_2156_;
                                                                            let _e1644 = phi_2157_;
                                                                            let _e1646 = phi_2158_;
                                                                            let _e1653 = ((_e1644.y * _e1642.z) - (_e1642.y * _e1644.z));
                                                                            let _e1658 = ((_e1644.z * _e1642.x) - (_e1642.z * _e1644.x));
                                                                            let _e1661 = ((_e1644.x * _e1642.y) - (_e1642.x * _e1644.y));
                                                                            if (_e1461 >= _e1465) {
                                                                                phi_2189_ = select(true, false, (_e1461 >= _e1469));
                                                                            } else {
                                                                                phi_2189_ = true;
                                                                            }
                                                                            let _e1666 = phi_2189_;
                                                                            if _e1666 {
                                                                                phi_2198_ = select(_e1564, _e1563, vec3((_e1465 >= _e1469)));
                                                                            } else {
                                                                                phi_2198_ = _e1562;
                                                                            }
                                                                            let _e1671 = phi_2198_;
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
                                                                                    phi_2363_ = (_e1682 / _e1687);
                                                                                } else {
                                                                                    phi_2363_ = f32();
                                                                                }
                                                                                let _e1792 = phi_2363_;
                                                                                phi_2365_ = _e1792;
                                                                                phi_2366_ = select(true, false, _e1789);
                                                                            } else {
                                                                                phi_2365_ = f32();
                                                                                phi_2366_ = true;
                                                                            }
                                                                            let _e1795 = phi_2365_;
                                                                            let _e1797 = phi_2366_;
                                                                            if _e1797 {
                                                                                let _e1805 = (((_e1653 * (_e1714 - (_e520 * _e1717))) + (_e1658 * (_e1715 - (_e586 * _e1717)))) / _e1687);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1805) & 2147483647u)) <= _e1619) {
                                                                                    phi_2386_ = (_e1717 + _e1805);
                                                                                } else {
                                                                                    phi_2386_ = _e1717;
                                                                                }
                                                                                let _e1812 = phi_2386_;
                                                                                phi_2387_ = _e1812;
                                                                            } else {
                                                                                phi_2387_ = _e1795;
                                                                            }
                                                                            let _e1814 = phi_2387_;
                                                                            let _e1816 = select(_e1552, _e1814, (_e1814 < _e1552));
                                                                            let _e1818 = select(_e1544, _e1816, (_e1816 > _e1544));
                                                                            if (_e1818 >= _e766) {
                                                                                let _e1820 = (_e1818 <= _e1303.member);
                                                                                if _e1820 {
                                                                                    let _e1821 = (1f / _e1471);
                                                                                    phi_2410_ = type_30(_e1818, (_e1465 * _e1821), (_e1469 * _e1821), _e1332);
                                                                                } else {
                                                                                    phi_2410_ = type_30();
                                                                                }
                                                                                let _e1826 = phi_2410_;
                                                                                phi_2412_ = _e1826;
                                                                                phi_2413_ = select(true, false, _e1820);
                                                                            } else {
                                                                                phi_2412_ = type_30();
                                                                                phi_2413_ = true;
                                                                            }
                                                                            let _e1829 = phi_2412_;
                                                                            let _e1831 = phi_2413_;
                                                                            if _e1831 {
                                                                                phi_2417_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2417_ = _e1829;
                                                                            }
                                                                            let _e1833 = phi_2417_;
                                                                            phi_2418_ = _e1833;
                                                                        }
                                                                        let _e1835 = phi_2418_;
                                                                        phi_2419_ = _e1835;
                                                                        phi_2420_ = _e1561;
                                                                    }
                                                                    let _e1837 = phi_2419_;
                                                                    let _e1839 = phi_2420_;
                                                                    phi_2424_ = _e1837;
                                                                    phi_2425_ = _e1839;
                                                                }
                                                                let _e1841 = phi_2424_;
                                                                let _e1843 = phi_2425_;
                                                                phi_2426_ = _e1841;
                                                                phi_2427_ = _e1496;
                                                                phi_2428_ = _e1843;
                                                            }
                                                            let _e1845 = phi_2426_;
                                                            let _e1847 = phi_2427_;
                                                            let _e1849 = phi_2428_;
                                                            phi_2429_ = _e1845;
                                                            phi_2430_ = _e1847;
                                                            phi_2431_ = _e1849;
                                                        }
                                                        let _e1851 = phi_2429_;
                                                        let _e1853 = phi_2430_;
                                                        let _e1855 = phi_2431_;
                                                        phi_2439_ = _e1851;
                                                        phi_2440_ = select(_e1855, true, _e1853);
                                                    } else {
                                                        phi_2439_ = type_30();
                                                        phi_2440_ = true;
                                                    }
                                                    let _e1858 = phi_2439_;
                                                    let _e1860 = phi_2440_;
                                                    if _e1860 {
                                                        phi_2444_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2444_ = _e1858;
                                                    }
                                                    let _e1862 = phi_2444_;
                                                    if (_e1862.member_3 != 4294967295u) {
                                                        if (_e1332 == _e168) {
                                                            phi_2773_ = false;
                                                        } else {
                                                            let _e1866 = (_e1332 < arrayLength((&global_7.member)));
                                                            if _e1866 {
                                                                if _e1866 {
                                                                } else {
                                                                    phi_4251_ = true;
                                                                    break;
                                                                }
                                                                let _e1868 = global_7.member[_e1332];
                                                                phi_2467_ = _e1868;
                                                            } else {
                                                                phi_2467_ = 4294967295u;
                                                            }
                                                            let _e1870 = phi_2467_;
                                                            let _e1871 = (_e1870 < arrayLength((&global_8.member)));
                                                            if _e1871 {
                                                                if _e1871 {
                                                                } else {
                                                                    phi_4251_ = true;
                                                                    break;
                                                                }
                                                                let _e1873 = global_8.member[_e1870];
                                                                phi_2481_ = _e1873;
                                                            } else {
                                                                phi_2481_ = 0i;
                                                            }
                                                            let _e1875 = phi_2481_;
                                                            let _e1876 = (_e1875 == 0i);
                                                            if _e1876 {
                                                                phi_2772_ = true;
                                                            } else {
                                                                if _e457 {
                                                                    phi_2502_ = vec3<f32>(_e1399[0][0], _e1399[0][1], _e1399[0][2]);
                                                                } else {
                                                                    if (_e433 == 1u) {
                                                                        phi_2501_ = vec3<f32>(_e1399[0][2], _e1399[0][0], _e1399[0][1]);
                                                                    } else {
                                                                        phi_2501_ = vec3<f32>(_e1399[0][1], _e1399[0][2], _e1399[0][0]);
                                                                    }
                                                                    let _e1881 = phi_2501_;
                                                                    phi_2502_ = _e1881;
                                                                }
                                                                let _e1884 = phi_2502_;
                                                                if _e457 {
                                                                    phi_2519_ = vec3<f32>(_e1399[1][0], _e1399[1][1], _e1399[1][2]);
                                                                } else {
                                                                    if (_e433 == 1u) {
                                                                        phi_2518_ = vec3<f32>(_e1399[1][2], _e1399[1][0], _e1399[1][1]);
                                                                    } else {
                                                                        phi_2518_ = vec3<f32>(_e1399[1][1], _e1399[1][2], _e1399[1][0]);
                                                                    }
                                                                    let _e1889 = phi_2518_;
                                                                    phi_2519_ = _e1889;
                                                                }
                                                                let _e1892 = phi_2519_;
                                                                if _e457 {
                                                                    phi_2536_ = vec3<f32>(_e1399[2][0], _e1399[2][1], _e1399[2][2]);
                                                                } else {
                                                                    if (_e433 == 1u) {
                                                                        phi_2535_ = vec3<f32>(_e1399[2][2], _e1399[2][0], _e1399[2][1]);
                                                                    } else {
                                                                        phi_2535_ = vec3<f32>(_e1399[2][1], _e1399[2][2], _e1399[2][0]);
                                                                    }
                                                                    let _e1897 = phi_2535_;
                                                                    phi_2536_ = _e1897;
                                                                }
                                                                let _e1900 = phi_2536_;
                                                                let _e1903 = (_e1892.x - _e1884.x);
                                                                let _e1906 = (_e1892.y - _e1884.y);
                                                                let _e1909 = (_e1892.z - _e1884.z);
                                                                let _e1911 = (_e1900.x - _e1884.x);
                                                                let _e1913 = (_e1900.y - _e1884.y);
                                                                let _e1915 = (_e1900.z - _e1884.z);
                                                                if (_e300.member_1 == 1u) {
                                                                    phi_2572_ = (vec3<f32>(_e300.member[0], _e300.member[1], _e300.member[2]) - _e1884);
                                                                } else {
                                                                    phi_2572_ = vec3<f32>(_e300.member[0], _e300.member[1], _e300.member[2]);
                                                                }
                                                                let _e1930 = phi_2572_;
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
                                                                    phi_2754_ = 0f;
                                                                } else {
                                                                    let _e2027 = bitcast<f32>((bitcast<u32>(_e1957) & 2147483647u));
                                                                    let _e2030 = bitcast<f32>((bitcast<u32>(_e1958) & 2147483647u));
                                                                    let _e2033 = bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u));
                                                                    let _e2035 = select(_e2033, _e2030, (_e2030 > _e2033));
                                                                    let _e2039 = select(_e2033, _e2030, (_e2030 < _e2033));
                                                                    let _e2043 = select(_e2030, _e2027, (_e2027 < _e2030));
                                                                    let _e2045 = select(_e2030, _e2027, (_e2027 > _e2030));
                                                                    let _e2047 = select(_e2033, _e2045, (_e2045 < _e2033));
                                                                    phi_2754_ = bitcast<f32>((bitcast<u32>((_e300.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2035, _e2027, (_e2027 > _e2035)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2047, _e2043, (_e2043 > _e2047)))) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2039, _e2027, (_e2027 < _e2039)))) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1983 + _e1990) + _e1997))) ^ _e300.member_3[0]))) * 1.0000005f)) ^ _e300.member_3[0])))) ^ _e300.member_3[0]));
                                                                }
                                                                let _e2074 = phi_2754_;
                                                                phi_2772_ = (_e1876 || !(((((bitcast<f32>((bitcast<u32>((_e1930.x * _e1957)) ^ _e300.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1930.y * _e1958)) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1930.z * _e1959)) ^ _e300.member_3[0]))) * f32(-(_e1875))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1930.x) & 2147483647u)) * _e1983)) ^ _e300.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1930.y) & 2147483647u)) * _e1990)) ^ _e300.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1930.z) & 2147483647u)) * _e1997)) ^ _e300.member_3[0]))))) ^ _e300.member_3[0])) + _e2074) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2088 = phi_2772_;
                                                            phi_2773_ = _e2088;
                                                        }
                                                        let _e2090 = phi_2773_;
                                                        if _e2090 {
                                                            phi_2778_ = type_51(_e1303.member, true);
                                                        } else {
                                                            phi_2778_ = _e1303;
                                                        }
                                                        let _e2095 = phi_2778_;
                                                        phi_2779_ = _e2095;
                                                    } else {
                                                        phi_2779_ = _e1303;
                                                    }
                                                    let _e2097 = phi_2779_;
                                                    phi_1469_ = _e2097;
                                                } else {
                                                    phi_1469_ = type_51();
                                                }
                                                let _e2099 = phi_1469_;
                                                continue;
                                                continuing {
                                                    phi_1468_ = _e2099;
                                                    phi_1471_ = _e1318;
                                                    phi_4251_ = _e808;
                                                    break if !(_e1324);
                                                }
                                            }
                                            let _e2102 = phi_4251_;
                                            phi_4443_ = _e2102;
                                            if _e2102 {
                                                break;
                                            }
                                            let _e2104 = local_10;
                                            phi_4447_ = _e2102;
                                            let _e2316 = local_12;
                                            phi_3985_ = _e2316;
                                            phi_3986_ = _e849;
                                            phi_3987_ = false;
                                            phi_3988_ = select(_e853, 0u, _e2104.member_1);
                                        } else {
                                            if (_e849.member_1 >= _e101) {
                                                phi_3541_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e849.member_1 < _e101) {
                                                } else {
                                                    phi_4443_ = true;
                                                    break;
                                                }
                                                let _e865 = ((1u + _e433) % 4u);
                                                if (_e865 < 4u) {
                                                } else {
                                                    phi_4443_ = true;
                                                    break;
                                                }
                                                let _e870 = global_5.member[_e849.member_1][_e865];
                                                let _e872 = (_e870 >> bitcast<u32>(11u));
                                                let _e874 = ((1u + _e432) % 4u);
                                                if (_e874 < 4u) {
                                                } else {
                                                    phi_4443_ = true;
                                                    break;
                                                }
                                                let _e879 = global_5.member[_e849.member_1][_e874];
                                                let _e881 = (_e879 >> bitcast<u32>(11u));
                                                let _e883 = ((1u + _e434) % 4u);
                                                if (_e883 < 4u) {
                                                } else {
                                                    phi_4443_ = true;
                                                    break;
                                                }
                                                let _e888 = global_5.member[_e849.member_1][_e883];
                                                let _e890 = (_e888 >> bitcast<u32>(11u));
                                                let _e913 = (bitcast<f32>((bitcast<u32>((_e849.member.member_1.x - _e849.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e914 = (bitcast<f32>((bitcast<u32>((_e849.member.member_1.y - _e849.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e915 = (bitcast<f32>((bitcast<u32>((_e849.member.member_1.z - _e849.member.member.z)) & 2139095040u)) * 0.001953125f);
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
                                                let _e1059 = global_5.member[_e849.member_1][0u];
                                                let _e1063 = global_5.member[_e849.member_1][1u];
                                                let _e1067 = global_5.member[_e849.member_1][2u];
                                                let _e1071 = global_5.member[_e849.member_1][3u];
                                                let _e1083 = (((_e1063 >> bitcast<u32>(22i)) | ((_e1067 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1071 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1084 = (_e1059 & 268435455u);
                                                let _e1085 = (_e1083 & 268435455u);
                                                let _e1088 = ((_e1059 >> bitcast<u32>(28u)) & 7u);
                                                let _e1096 = ((_e1059 >> bitcast<u32>(31i)) | (((_e1083 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1097 = (_e1088 != 0u);
                                                if (_e1088 == 0u) {
                                                    phi_3503_ = _e1084;
                                                } else {
                                                    if (_e1088 == 7u) {
                                                        phi_3502_ = 2147483648u;
                                                    } else {
                                                        phi_3502_ = ((2147483648u | (_e1088 << bitcast<u32>(28u))) | (_e1085 & 268435455u));
                                                    }
                                                    let _e1106 = phi_3502_;
                                                    phi_3503_ = _e1106;
                                                }
                                                let _e1108 = phi_3503_;
                                                if _e1097 {
                                                    let _e1109 = (_e1088 != 7u);
                                                    if _e1109 {
                                                        phi_3513_ = (_e1085 + _e1088);
                                                    } else {
                                                        phi_3513_ = u32();
                                                    }
                                                    let _e1112 = phi_3513_;
                                                    phi_3515_ = _e1112;
                                                    phi_3516_ = select(true, false, _e1109);
                                                } else {
                                                    phi_3515_ = u32();
                                                    phi_3516_ = true;
                                                }
                                                let _e1115 = phi_3515_;
                                                let _e1117 = phi_3516_;
                                                if (_e1096 == 0u) {
                                                    phi_3537_ = (_e1084 + select(0u, 1u, !(_e1097)));
                                                } else {
                                                    if (_e1096 == 7u) {
                                                        phi_3536_ = 2147483648u;
                                                    } else {
                                                        phi_3536_ = ((2147483648u | (_e1096 << bitcast<u32>(28u))) | (select(_e1115, _e1085, _e1117) & 268435455u));
                                                    }
                                                    let _e1130 = phi_3536_;
                                                    phi_3537_ = _e1130;
                                                }
                                                let _e1132 = phi_3537_;
                                                phi_3541_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e849.member.member.x + _e960), (_e849.member.member.x + _e982), (_e849.member.member_1.x - _e999), (_e849.member.member_1.x - _e1021)), vec4<f32>((_e849.member.member.y + _e969), (_e849.member.member.y + _e986), (_e849.member.member_1.y - _e1008), (_e849.member.member_1.y - _e1025)), vec4<f32>((_e849.member.member.z + _e978), (_e849.member.member.z + _e990), (_e849.member.member_1.z - _e1017), (_e849.member.member_1.z - _e1029))), type_63(type_39((_e849.member.member + vec4<f32>(_e960, _e969, _e978, 0f)), (_e849.member.member_1 - vec4<f32>(_e999, _e1008, _e1017, 0f))), _e1108), type_63(type_39((_e849.member.member + vec4<f32>(_e982, _e986, _e990, 0f)), (_e849.member.member_1 - vec4<f32>(_e1021, _e1025, _e1029, 0f))), _e1132));
                                            }
                                            let _e1137 = phi_3541_;
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
                                                        phi_3885_ = _e1137.member_2;
                                                    } else {
                                                        phi_3885_ = _e1137.member_1;
                                                    }
                                                    let _e1243 = phi_3885_;
                                                    let _e1265 = (_e853 % 128u);
                                                    let _e1266 = (_e1265 < 128u);
                                                    if _e1266 {
                                                    } else {
                                                        phi_4443_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1265] = _e1243.member_1;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4443_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1265] = _e1243.member.member.x;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4443_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1265] = _e1243.member.member.y;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4443_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1265] = _e1243.member.member.z;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4443_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1265] = _e1243.member.member_1.x;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4443_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1265] = _e1243.member.member_1.y;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4443_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1265] = _e1243.member.member_1.z;
                                                    if _e1266 {
                                                    } else {
                                                        phi_4443_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1265] = select(_e1232, _e1230, (_e1230 > _e1232));
                                                    if _e1239 {
                                                        phi_3962_ = _e1137.member_1;
                                                    } else {
                                                        phi_3962_ = _e1137.member_2;
                                                    }
                                                    let _e1279 = phi_3962_;
                                                    phi_3963_ = _e1279;
                                                    phi_3964_ = (_e853 + 1u);
                                                } else {
                                                    phi_3963_ = type_63();
                                                    phi_3964_ = u32();
                                                }
                                                let _e1281 = phi_3963_;
                                                let _e1283 = phi_3964_;
                                                phi_3966_ = _e1281;
                                                phi_3967_ = _e1283;
                                                phi_3968_ = select(true, false, _e1238);
                                            } else {
                                                phi_3966_ = type_63();
                                                phi_3967_ = u32();
                                                phi_3968_ = true;
                                            }
                                            let _e1286 = phi_3966_;
                                            let _e1288 = phi_3967_;
                                            let _e1290 = phi_3968_;
                                            if _e1290 {
                                                if _e1237 {
                                                    phi_3977_ = _e1137.member_1;
                                                } else {
                                                    phi_3977_ = _e1137.member_2;
                                                }
                                                let _e1294 = phi_3977_;
                                                phi_3982_ = _e1294;
                                                phi_3983_ = select(_e1238, true, _e1237);
                                            } else {
                                                phi_3982_ = _e1286;
                                                phi_3983_ = _e851;
                                            }
                                            let _e1297 = phi_3982_;
                                            let _e1299 = phi_3983_;
                                            phi_4447_ = _e808;
                                            phi_3985_ = _e810;
                                            phi_3986_ = _e1297;
                                            phi_3987_ = _e1299;
                                            phi_3988_ = select(_e1288, _e853, _e1290);
                                        }
                                        let _e2108 = phi_4447_;
                                        let _e2110 = phi_3985_;
                                        let _e2112 = phi_3986_;
                                        let _e2114 = phi_3987_;
                                        let _e2116 = phi_3988_;
                                        phi_4446_ = _e2108;
                                        phi_3989_ = _e2110;
                                        phi_3990_ = _e2112;
                                        phi_3991_ = (_e814 - 1u);
                                        phi_3992_ = _e2114;
                                        phi_3993_ = _e2116;
                                    } else {
                                        phi_4446_ = _e808;
                                        phi_3989_ = _e810;
                                        phi_3990_ = _e849;
                                        phi_3991_ = _e814;
                                        phi_3992_ = _e851;
                                        phi_3993_ = _e853;
                                    }
                                    let _e2118 = phi_4446_;
                                    let _e2120 = phi_3989_;
                                    let _e2122 = phi_3990_;
                                    let _e2124 = phi_3991_;
                                    let _e2126 = phi_3992_;
                                    let _e2128 = phi_3993_;
                                    phi_4445_ = _e2118;
                                    phi_3994_ = _e2120;
                                    phi_3995_ = _e2122;
                                    phi_3996_ = _e2124;
                                    phi_3997_ = _e2126;
                                    phi_3998_ = _e2128;
                                } else {
                                    phi_4445_ = _e808;
                                    phi_3994_ = type_51();
                                    phi_3995_ = type_63();
                                    phi_3996_ = u32();
                                    phi_3997_ = bool();
                                    phi_3998_ = u32();
                                }
                                let _e2130 = phi_4445_;
                                let _e2132 = phi_3994_;
                                let _e2134 = phi_3995_;
                                let _e2136 = phi_3996_;
                                let _e2138 = phi_3997_;
                                let _e2140 = phi_3998_;
                                phi_4444_ = _e2130;
                                phi_1343_ = _e2132;
                                phi_1346_ = _e2134;
                                phi_1348_ = _e2136;
                                phi_1350_ = _e2138;
                                phi_1352_ = _e2140;
                                phi_3999_ = _e822;
                            } else {
                                phi_4444_ = _e808;
                                phi_1343_ = type_51();
                                phi_1346_ = type_63();
                                phi_1348_ = u32();
                                phi_1350_ = bool();
                                phi_1352_ = u32();
                                phi_3999_ = false;
                            }
                            let _e2142 = phi_4444_;
                            let _e2144 = phi_1343_;
                            let _e2146 = phi_1346_;
                            let _e2148 = phi_1348_;
                            let _e2150 = phi_1350_;
                            let _e2152 = phi_1352_;
                            let _e2154 = phi_3999_;
                            continue;
                            continuing {
                                phi_4257_ = _e2142;
                                phi_1342_ = _e2144;
                                phi_1345_ = _e2146;
                                phi_1347_ = _e2148;
                                phi_1349_ = _e2150;
                                phi_1351_ = _e2152;
                                phi_4443_ = _e2142;
                                break if !(_e2154);
                            }
                        }
                        let _e2157 = phi_4443_;
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
