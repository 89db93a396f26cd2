struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_30 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_36 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_40 {
    member: f32,
    member_1: bool,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<i32>,
}

struct type_49 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_51 {
    member: array<type_49>,
}

struct type_54 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_56 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_58 {
    member: array<type_56>,
}

struct type_62 {
    member: type_54,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_26;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(2) 
var<uniform> global_4: type_42;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_45;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_67;
@group(0) @binding(7) 
var<storage> global_8: type_32;
@group(0) @binding(3) 
var<storage> global_9: type_51;
@group(0) @binding(4) 
var<storage> global_10: type_58;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_279_: u32;
    var phi_323_: i32;
    var phi_463_: type_36;
    var phi_613_: i32;
    var phi_614_: i32;
    var phi_624_: bool;
    var phi_634_: u32;
    var phi_635_: u32;
    var phi_637_: bool;
    var phi_642_: u32;
    var phi_674_: i32;
    var phi_692_: f32;
    var phi_698_: f32;
    var phi_738_: f32;
    var phi_744_: f32;
    var phi_796_: f32;
    var phi_807_: f32;
    var phi_816_: f32;
    var phi_822_: f32;
    var phi_862_: f32;
    var phi_868_: f32;
    var phi_920_: f32;
    var phi_931_: f32;
    var phi_940_: f32;
    var phi_946_: f32;
    var phi_986_: f32;
    var phi_992_: f32;
    var phi_1044_: f32;
    var phi_1055_: f32;
    var phi_1110_: i32;
    var phi_1132_: u32;
    var phi_1133_: u32;
    var phi_1170_: i32;
    var phi_1192_: u32;
    var phi_1193_: u32;
    var phi_1201_: f32;
    var phi_1202_: f32;
    var phi_3971_: bool;
    var phi_1275_: type_40;
    var phi_1278_: type_62;
    var phi_1280_: u32;
    var phi_1282_: bool;
    var phi_1284_: u32;
    var phi_1295_: bool;
    var phi_1381_: type_62;
    var phi_1382_: bool;
    var phi_1383_: u32;
    var phi_2905_: type_49;
    var phi_3761_: type_62;
    var phi_3838_: type_62;
    var phi_3839_: type_62;
    var phi_3840_: u32;
    var phi_3842_: type_62;
    var phi_3843_: u32;
    var phi_3844_: bool;
    var phi_3851_: type_62;
    var phi_3856_: type_62;
    var phi_3857_: bool;
    var phi_1402_: type_40;
    var phi_1405_: type_8;
    var phi_1406_: type_8;
    var phi_1428_: type_8;
    var phi_1453_: u32;
    var phi_1469_: type_56;
    var phi_1863_: bool;
    var phi_1892_: bool;
    var phi_2269_: f32;
    var phi_2270_: f32;
    var phi_2271_: f32;
    var phi_2272_: f32;
    var phi_2273_: vec3<f32>;
    var phi_2274_: vec3<f32>;
    var phi_2275_: vec3<f32>;
    var phi_2276_: vec3<f32>;
    var phi_2307_: bool;
    var phi_2316_: vec3<f32>;
    var phi_2481_: f32;
    var phi_2483_: f32;
    var phi_2484_: bool;
    var phi_2504_: f32;
    var phi_2505_: f32;
    var phi_2528_: type_22;
    var phi_2530_: type_22;
    var phi_2531_: bool;
    var phi_2535_: type_22;
    var phi_2536_: type_22;
    var phi_2537_: type_22;
    var phi_2538_: bool;
    var phi_2542_: type_22;
    var phi_2543_: bool;
    var phi_2544_: type_22;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2547_: type_22;
    var phi_2548_: bool;
    var phi_2549_: bool;
    var phi_2557_: type_22;
    var phi_2558_: bool;
    var phi_2562_: type_22;
    var phi_2585_: u32;
    var phi_2599_: i32;
    var phi_2615_: vec3<f32>;
    var phi_2616_: vec3<f32>;
    var phi_2628_: vec3<f32>;
    var phi_2629_: vec3<f32>;
    var phi_2641_: vec3<f32>;
    var phi_2642_: vec3<f32>;
    var phi_2678_: vec3<f32>;
    var phi_2860_: f32;
    var phi_2878_: bool;
    var phi_2879_: bool;
    var phi_2884_: type_40;
    var phi_2885_: type_40;
    var phi_1403_: type_40;
    var phi_3965_: bool;
    var local_10: type_40;
    var phi_4179_: bool;
    var phi_3859_: type_40;
    var phi_3860_: type_62;
    var phi_3861_: bool;
    var phi_3862_: u32;
    var phi_4178_: bool;
    var phi_3863_: type_40;
    var phi_3864_: type_62;
    var phi_3865_: u32;
    var phi_3866_: bool;
    var phi_3867_: u32;
    var phi_4177_: bool;
    var phi_3868_: type_40;
    var phi_3869_: type_62;
    var phi_3870_: u32;
    var phi_3871_: bool;
    var phi_3872_: u32;
    var phi_4176_: bool;
    var phi_1276_: type_40;
    var phi_1279_: type_62;
    var phi_1281_: u32;
    var phi_1283_: bool;
    var phi_1285_: u32;
    var phi_3873_: bool;
    var phi_4175_: bool;
    var local_11: type_40;
    var local_12: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e93 = arrayLength((&global_9.member));
            let _e108 = arrayLength((&global_7.member));
            let _e112 = global_4.member[0u][0u];
            let _e116 = global_4.member[0u][1u];
            let _e120 = global_4.member[0u][2u];
            let _e124 = global_4.member[1u][0u];
            let _e128 = global_4.member[1u][1u];
            let _e132 = global_4.member[1u][2u];
            let _e136 = global_4.member[1u][3u];
            let _e140 = (_e90.x + (_e90.y * 2097152u));
            let _e147 = (_e140 < arrayLength((&global_8.member)));
            if _e147 {
                if _e147 {
                } else {
                    break;
                }
                let _e151 = global_8.member[_e140].member_2;
                phi_279_ = _e151;
            } else {
                phi_279_ = 4294967295u;
            }
            let _e153 = phi_279_;
            let _e156 = global_1.member[0u];
            let _e160 = global_3.member[0u][0u];
            let _e164 = global_3.member[0u][1u];
            let _e168 = global_3.member[0u][2u];
            let _e172 = global_3.member[0u][3u];
            let _e176 = global_3.member[1u][0u];
            let _e180 = global_3.member[1u][1u];
            let _e184 = global_3.member[1u][2u];
            let _e188 = global_3.member[1u][3u];
            let _e189 = bitcast<f32>(_e160);
            let _e190 = bitcast<f32>(_e164);
            let _e191 = bitcast<f32>(_e168);
            let _e193 = bitcast<f32>(_e176);
            let _e194 = array<u32, 3>(_e180, _e184, _e188);
            let _e196 = bitcast<i32>(_e156);
            if (_e196 < -126i) {
                phi_323_ = -126i;
            } else {
                phi_323_ = select(_e196, 127i, (_e196 > 127i));
            }
            let _e201 = phi_323_;
            let _e206 = bitcast<f32>((bitcast<u32>((_e201 + 127i)) << bitcast<u32>(23i)));
            let _e212 = bitcast<f32>((bitcast<u32>(((_e196 - _e201) + 127i)) << bitcast<u32>(23i)));
            if (_e172 == 0u) {
                phi_463_ = type_36(array<f32, 3>(_e189, _e190, _e191), _e172, _e193, _e194);
            } else {
                let _e214 = bitcast<u32>(_e189);
                let _e216 = ((_e214 & 2139095040u) != 0u);
                let _e231 = bitcast<u32>(_e190);
                let _e233 = ((_e231 & 2139095040u) != 0u);
                let _e248 = bitcast<u32>(_e191);
                let _e250 = ((_e248 & 2139095040u) != 0u);
                let _e266 = bitcast<u32>(_e193);
                let _e268 = ((_e266 & 2139095040u) != 0u);
                phi_463_ = type_36(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e214 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e214 & 2147483648u))), _e189, _e216) * _e206) * select(0.00000011920929f, 1f, _e216)) * _e212), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e231 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e231 & 2147483648u))), _e190, _e233) * _e206) * select(0.00000011920929f, 1f, _e233)) * _e212), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e191, _e250) * _e206) * select(0.00000011920929f, 1f, _e250)) * _e212)), _e172, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e266 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e266 & 2147483648u))), _e193, _e268) * _e206) * select(0.00000011920929f, 1f, _e268)) * _e212), _e194);
            }
            let _e285 = phi_463_;
            if _e147 {
                let _e286 = (_e140 < arrayLength((&global_2.member)));
                if _e286 {
                    if _e147 {
                    } else {
                        break;
                    }
                    let _e291 = global_8.member[_e140].member.member_1;
                    let _e296 = global_8.member[_e140].member.member_3;
                    if (_e291 <= _e296) {
                        let _e298 = (1u < _e108);
                        if _e298 {
                            if (0u < _e108) {
                            } else {
                                break;
                            }
                            let _e302 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e302 + 1u) < _e302) {
                                if _e298 {
                                } else {
                                    break;
                                }
                                let _e307 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e147 {
                        } else {
                            break;
                        }
                        let _e317 = global_8.member[_e140].member.member_2[0u];
                        let _e319 = (bitcast<u32>(_e317) & 2147483647u);
                        let _e325 = global_8.member[_e140].member.member_2[1u];
                        let _e327 = (bitcast<u32>(_e325) & 2147483647u);
                        let _e333 = global_8.member[_e140].member.member_2[2u];
                        let _e335 = (bitcast<u32>(_e333) & 2147483647u);
                        let _e341 = global_8.member[_e140].member.member[0u];
                        let _e343 = (bitcast<u32>(_e341) & 2147483647u);
                        let _e349 = global_8.member[_e140].member.member[1u];
                        let _e351 = (bitcast<u32>(_e349) & 2147483647u);
                        let _e357 = global_8.member[_e140].member.member[2u];
                        let _e359 = (bitcast<u32>(_e357) & 2147483647u);
                        let _e361 = select(_e327, _e319, (_e327 < _e319));
                        let _e363 = select(_e335, _e361, (_e335 < _e361));
                        let _e365 = select(_e343, _e363, (_e343 < _e363));
                        let _e367 = select(_e351, _e365, (_e351 < _e365));
                        let _e369 = select(_e359, _e367, (_e359 < _e367));
                        let _e370 = bitcast<u32>(_e291);
                        let _e371 = (_e370 & 2147483647u);
                        let _e375 = bitcast<u32>(_e296);
                        let _e376 = (_e375 & 2147483647u);
                        let _e380 = (((select(_e371, _e369, (_e371 < _e369)) < 2139095040u) && (_e376 <= 2139095040u)) && (_e363 > 0u));
                        if _e380 {
                            let _e383 = (bitcast<u32>(bitcast<f32>(_e363)) & 2147483647u);
                            if (_e383 >= 8388608u) {
                                phi_613_ = (bitcast<i32>((_e383 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_613_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e383)), 32u, (_e383 == 0u))));
                            }
                            let _e397 = phi_613_;
                            phi_614_ = _e397;
                        } else {
                            phi_614_ = 0i;
                        }
                        let _e399 = phi_614_;
                        let _e400 = (_e319 == _e363);
                        if _e400 {
                            phi_624_ = true;
                        } else {
                            phi_624_ = (_e327 == _e363);
                        }
                        let _e403 = phi_624_;
                        let _e404 = select(1u, 0u, _e400);
                        if _e403 {
                            let _e405 = (_e404 + 1u);
                            phi_634_ = _e405;
                            phi_635_ = _e405;
                            phi_637_ = select(true, false, (_e405 == 2u));
                        } else {
                            phi_634_ = u32();
                            phi_635_ = 0u;
                            phi_637_ = true;
                        }
                        let _e409 = phi_634_;
                        let _e411 = phi_635_;
                        let _e413 = phi_637_;
                        if _e413 {
                            phi_642_ = (_e411 + 1u);
                        } else {
                            phi_642_ = 0u;
                        }
                        let _e417 = phi_642_;
                        let _e418 = select(_e409, _e411, _e413);
                        let _e419 = select(_e404, select(2u, _e404, _e403), _e413);
                        let _e420 = -(_e399);
                        if (_e420 < -126i) {
                            phi_674_ = -126i;
                        } else {
                            phi_674_ = select(_e420, 127i, (_e420 > 127i));
                        }
                        let _e425 = phi_674_;
                        let _e430 = bitcast<f32>((bitcast<u32>((_e425 + 127i)) << bitcast<u32>(23i)));
                        let _e436 = bitcast<f32>((bitcast<u32>(((_e420 - _e425) + 127i)) << bitcast<u32>(23i)));
                        let _e441 = global_8.member[_e140].member.member;
                        let _e442 = (_e418 == 0u);
                        if _e442 {
                            phi_692_ = _e441[0];
                        } else {
                            phi_692_ = _e441[1];
                        }
                        let _e446 = phi_692_;
                        let _e447 = (_e418 == 2u);
                        if _e447 {
                            phi_698_ = _e441[2];
                        } else {
                            phi_698_ = _e446;
                        }
                        let _e450 = phi_698_;
                        let _e451 = bitcast<u32>(_e450);
                        let _e453 = ((_e451 & 2139095040u) != 0u);
                        let _e465 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e451 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e451 & 2147483648u))), _e450, _e453) * select(0.00000011920929f, 1f, _e453));
                        let _e466 = global_8.member[_e140].member.member_2;
                        if _e442 {
                            phi_738_ = _e466[0];
                        } else {
                            phi_738_ = _e466[1];
                        }
                        let _e470 = phi_738_;
                        if _e447 {
                            phi_744_ = _e466[2];
                        } else {
                            phi_744_ = _e470;
                        }
                        let _e473 = phi_744_;
                        let _e474 = bitcast<u32>(_e473);
                        let _e476 = ((_e474 & 2139095040u) != 0u);
                        let _e490 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e474 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e474 & 2147483648u))), _e473, _e476) * _e430) * select(0.00000011920929f, 1f, _e476)) * _e436);
                        let _e494 = (bitcast<f32>((bitcast<u32>(_e490) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e494 {
                            let _e498 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) * 0.00000011920929f);
                            phi_796_ = select(0.00000000000011368684f, _e498, (_e498 > 0.00000000000011368684f));
                        } else {
                            phi_796_ = 0f;
                        }
                        let _e502 = phi_796_;
                        let _e503 = (_e465 + _e502);
                        let _e504 = (_e465 - _e502);
                        let _e505 = select(_e490, 0f, _e494);
                        if _e494 {
                            phi_807_ = 38685626000000000000000000f;
                        } else {
                            phi_807_ = (1f / _e490);
                        }
                        let _e508 = phi_807_;
                        let _e509 = (_e417 == 0u);
                        if _e509 {
                            phi_816_ = _e441[0];
                        } else {
                            phi_816_ = _e441[1];
                        }
                        let _e513 = phi_816_;
                        let _e514 = (_e417 == 2u);
                        if _e514 {
                            phi_822_ = _e441[2];
                        } else {
                            phi_822_ = _e513;
                        }
                        let _e517 = phi_822_;
                        let _e518 = bitcast<u32>(_e517);
                        let _e520 = ((_e518 & 2139095040u) != 0u);
                        let _e532 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e518 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e518 & 2147483648u))), _e517, _e520) * select(0.00000011920929f, 1f, _e520));
                        if _e509 {
                            phi_862_ = _e466[0];
                        } else {
                            phi_862_ = _e466[1];
                        }
                        let _e536 = phi_862_;
                        if _e514 {
                            phi_868_ = _e466[2];
                        } else {
                            phi_868_ = _e536;
                        }
                        let _e539 = phi_868_;
                        let _e540 = bitcast<u32>(_e539);
                        let _e542 = ((_e540 & 2139095040u) != 0u);
                        let _e556 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e540 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e540 & 2147483648u))), _e539, _e542) * _e430) * select(0.00000011920929f, 1f, _e542)) * _e436);
                        let _e560 = (bitcast<f32>((bitcast<u32>(_e556) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e560 {
                            let _e564 = (bitcast<f32>((bitcast<u32>(_e532) & 2147483647u)) * 0.00000011920929f);
                            phi_920_ = select(0.00000000000011368684f, _e564, (_e564 > 0.00000000000011368684f));
                        } else {
                            phi_920_ = 0f;
                        }
                        let _e568 = phi_920_;
                        let _e569 = (_e532 + _e568);
                        let _e570 = (_e532 - _e568);
                        let _e571 = select(_e556, 0f, _e560);
                        if _e560 {
                            phi_931_ = 38685626000000000000000000f;
                        } else {
                            phi_931_ = (1f / _e556);
                        }
                        let _e574 = phi_931_;
                        let _e575 = (_e419 == 0u);
                        if _e575 {
                            phi_940_ = _e441[0];
                        } else {
                            phi_940_ = _e441[1];
                        }
                        let _e579 = phi_940_;
                        let _e580 = (_e419 == 2u);
                        if _e580 {
                            phi_946_ = _e441[2];
                        } else {
                            phi_946_ = _e579;
                        }
                        let _e583 = phi_946_;
                        let _e584 = bitcast<u32>(_e583);
                        let _e586 = ((_e584 & 2139095040u) != 0u);
                        let _e598 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e584 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e584 & 2147483648u))), _e583, _e586) * select(0.00000011920929f, 1f, _e586));
                        if _e575 {
                            phi_986_ = _e466[0];
                        } else {
                            phi_986_ = _e466[1];
                        }
                        let _e602 = phi_986_;
                        if _e580 {
                            phi_992_ = _e466[2];
                        } else {
                            phi_992_ = _e602;
                        }
                        let _e605 = phi_992_;
                        let _e606 = bitcast<u32>(_e605);
                        let _e608 = ((_e606 & 2139095040u) != 0u);
                        let _e622 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e606 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e606 & 2147483648u))), _e605, _e608) * _e430) * select(0.00000011920929f, 1f, _e608)) * _e436);
                        let _e626 = (bitcast<f32>((bitcast<u32>(_e622) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e626 {
                            let _e630 = (bitcast<f32>((bitcast<u32>(_e598) & 2147483647u)) * 0.00000011920929f);
                            phi_1044_ = select(0.00000000000011368684f, _e630, (_e630 > 0.00000000000011368684f));
                        } else {
                            phi_1044_ = 0f;
                        }
                        let _e634 = phi_1044_;
                        let _e635 = (_e598 + _e634);
                        let _e636 = (_e598 - _e634);
                        let _e637 = select(_e622, 0f, _e626);
                        if _e626 {
                            phi_1055_ = 38685626000000000000000000f;
                        } else {
                            phi_1055_ = (1f / _e622);
                        }
                        let _e640 = phi_1055_;
                        let _e643 = bitcast<f32>((bitcast<u32>(_e465) & 2147483647u));
                        let _e646 = bitcast<f32>((bitcast<u32>(_e532) & 2147483647u));
                        let _e648 = select(_e646, _e643, (_e643 > _e646));
                        let _e651 = bitcast<f32>((bitcast<u32>(_e598) & 2147483647u));
                        if (_e380 && (select(_e651, _e648, (_e648 > _e651)) <= 1099511600000f)) {
                            let _e663 = ((_e371 & 8388607u) | (select(0u, 1u, ((_e371 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e666 = bitcast<i32>((_e371 >> bitcast<u32>(23i)));
                            let _e670 = (_e663 == 0u);
                            let _e673 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e663)), 32u, _e670)) - 8i);
                            if (_e666 == 255i) {
                                phi_1110_ = 255i;
                            } else {
                                phi_1110_ = (((_e666 + select(0i, 1i, (_e666 == 0i))) - _e673) + _e399);
                            }
                            let _e681 = phi_1110_;
                            let _e691 = (_e681 <= 0i);
                            if _e691 {
                                phi_1133_ = u32();
                            } else {
                                if _e670 {
                                    phi_1132_ = u32();
                                } else {
                                    phi_1132_ = select(((bitcast<u32>(_e681) << bitcast<u32>(23i)) | ((_e663 << bitcast<u32>(((_e673 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e681 >= 255i));
                                }
                                let _e695 = phi_1132_;
                                phi_1133_ = _e695;
                            }
                            let _e697 = phi_1133_;
                            let _e709 = ((_e376 & 8388607u) | (select(0u, 1u, ((_e376 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e712 = bitcast<i32>((_e376 >> bitcast<u32>(23i)));
                            let _e716 = (_e709 == 0u);
                            let _e719 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e709)), 32u, _e716)) - 8i);
                            if (_e712 == 255i) {
                                phi_1170_ = 255i;
                            } else {
                                phi_1170_ = (((_e712 + select(0i, 1i, (_e712 == 0i))) - _e719) + _e399);
                            }
                            let _e727 = phi_1170_;
                            let _e737 = (_e727 <= 0i);
                            if _e737 {
                                phi_1193_ = u32();
                            } else {
                                if _e716 {
                                    phi_1192_ = u32();
                                } else {
                                    phi_1192_ = select(((bitcast<u32>(_e727) << bitcast<u32>(23i)) | ((_e709 << bitcast<u32>(((_e719 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e727 >= 255i));
                                }
                                let _e741 = phi_1192_;
                                phi_1193_ = _e741;
                            }
                            let _e743 = phi_1193_;
                            phi_1201_ = bitcast<f32>(((_e375 & 2147483648u) | select(_e743, 0u, select(_e716, true, _e737))));
                            phi_1202_ = bitcast<f32>(((_e370 & 2147483648u) | select(_e697, 0u, select(_e670, true, _e691))));
                        } else {
                            phi_1201_ = 0f;
                            phi_1202_ = 1f;
                        }
                        let _e749 = phi_1201_;
                        let _e751 = phi_1202_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e112), bitcast<f32>(_e116), bitcast<f32>(_e120));
                        let _e756 = (_e418 % 3u);
                        let _e757 = (_e756 < 3u);
                        if _e757 {
                        } else {
                            break;
                        }
                        let _e759 = local_9[_e756];
                        let _e760 = (_e417 % 3u);
                        let _e761 = (_e760 < 3u);
                        if _e761 {
                        } else {
                            break;
                        }
                        let _e763 = local_9[_e760];
                        let _e764 = (_e419 % 3u);
                        let _e765 = (_e764 < 3u);
                        if _e765 {
                        } else {
                            break;
                        }
                        let _e767 = local_9[_e764];
                        local_8 = array<f32, 3>(bitcast<f32>(_e124), bitcast<f32>(_e128), bitcast<f32>(_e132));
                        if _e757 {
                        } else {
                            break;
                        }
                        let _e771 = local_8[_e756];
                        if _e761 {
                        } else {
                            break;
                        }
                        let _e773 = local_8[_e760];
                        if _e765 {
                        } else {
                            break;
                        }
                        let _e775 = local_8[_e764];
                        phi_3971_ = false;
                        phi_1275_ = type_40(_e749, false);
                        phi_1278_ = type_62(type_54(array<f32, 3>(_e759, _e763, _e767), array<f32, 3>(_e771, _e773, _e775)), select(0u, 2147483648u, (_e93 == 0u)));
                        phi_1280_ = ((3u * _e93) + 1u);
                        phi_1282_ = (_e751 <= _e749);
                        phi_1284_ = 0u;
                        loop {
                            let _e783 = phi_3971_;
                            let _e785 = phi_1275_;
                            let _e787 = phi_1278_;
                            let _e789 = phi_1280_;
                            let _e791 = phi_1282_;
                            let _e793 = phi_1284_;
                            local_11 = _e785;
                            if _e791 {
                                phi_1295_ = true;
                            } else {
                                phi_1295_ = (_e793 > 0u);
                            }
                            let _e796 = phi_1295_;
                            if _e796 {
                                let _e797 = (_e789 > 0u);
                                if _e797 {
                                    if _e791 {
                                        phi_1381_ = _e787;
                                        phi_1382_ = _e791;
                                        phi_1383_ = _e793;
                                    } else {
                                        let _e798 = (_e793 - 1u);
                                        let _e799 = (_e798 % 128u);
                                        let _e800 = (_e799 < 128u);
                                        if _e800 {
                                        } else {
                                            phi_4175_ = true;
                                            break;
                                        }
                                        let _e802 = local_6[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4175_ = true;
                                            break;
                                        }
                                        let _e804 = local_5[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4175_ = true;
                                            break;
                                        }
                                        let _e806 = local_4[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4175_ = true;
                                            break;
                                        }
                                        let _e808 = local_3[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4175_ = true;
                                            break;
                                        }
                                        let _e811 = local_2[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4175_ = true;
                                            break;
                                        }
                                        let _e813 = local_1[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4175_ = true;
                                            break;
                                        }
                                        let _e815 = local[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4175_ = true;
                                            break;
                                        }
                                        let _e820 = local_7[_e799];
                                        phi_1381_ = type_62(type_54(array<f32, 3>(_e804, _e806, _e808), array<f32, 3>(_e811, _e813, _e815)), _e802);
                                        phi_1382_ = (_e820 <= _e785.member);
                                        phi_1383_ = _e798;
                                    }
                                    let _e824 = phi_1381_;
                                    let _e826 = phi_1382_;
                                    let _e828 = phi_1383_;
                                    if _e826 {
                                        if ((_e824.member_1 & 2147483648u) != 0u) {
                                            phi_1402_ = _e785;
                                            phi_1405_ = type_8(0u, ((_e824.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1205 = phi_1402_;
                                                let _e1207 = phi_1405_;
                                                local_10 = _e1205;
                                                local_12 = _e1205;
                                                if (_e1207.member < _e1207.member_1) {
                                                    phi_1406_ = type_8((_e1207.member + 1u), _e1207.member_1);
                                                    phi_1428_ = type_8(1u, _e1207.member);
                                                } else {
                                                    phi_1406_ = _e1207;
                                                    phi_1428_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1220 = phi_1406_;
                                                let _e1222 = phi_1428_;
                                                let _e1226 = (bitcast<i32>(_e1222.member) != 0i);
                                                if _e1226 {
                                                    let _e1227 = ((_e824.member_1 & 268435455u) + _e1222.member_1);
                                                    let _e1228 = (_e1227 < arrayLength((&global_10.member)));
                                                    if _e1228 {
                                                        if _e1228 {
                                                        } else {
                                                            phi_3965_ = true;
                                                            break;
                                                        }
                                                        let _e1231 = global_10.member[_e1227].member_1;
                                                        phi_1453_ = _e1231;
                                                    } else {
                                                        phi_1453_ = 4294967295u;
                                                    }
                                                    let _e1233 = phi_1453_;
                                                    if _e1228 {
                                                        if _e1228 {
                                                        } else {
                                                            phi_3965_ = true;
                                                            break;
                                                        }
                                                        let _e1235 = global_10.member[_e1227];
                                                        phi_1469_ = _e1235;
                                                    } else {
                                                        phi_1469_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e1237 = phi_1469_;
                                                    let _e1249 = ((10u * _e418) & 31u);
                                                    let _e1252 = ((_e1237.member[0] >> bitcast<u32>(_e1249)) & 1023u);
                                                    let _e1260 = bitcast<f32>((bitcast<u32>(((_e824.member.member_1[0] - _e824.member.member[0]) * 0.0009775171f)) ^ _e136));
                                                    let _e1265 = (_e824.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1252)) - 8388608f) * _e1260)) ^ _e136)));
                                                    let _e1269 = select(select(_e824.member.member_1[0], _e1265, (_e1265 < _e824.member.member_1[0])), _e824.member.member_1[0], (_e1252 == 1023u));
                                                    let _e1271 = ((10u * _e417) & 31u);
                                                    let _e1274 = ((_e1237.member[0] >> bitcast<u32>(_e1271)) & 1023u);
                                                    let _e1282 = bitcast<f32>((bitcast<u32>(((_e824.member.member_1[1] - _e824.member.member[1]) * 0.0009775171f)) ^ _e136));
                                                    let _e1287 = (_e824.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1274)) - 8388608f) * _e1282)) ^ _e136)));
                                                    let _e1291 = select(select(_e824.member.member_1[1], _e1287, (_e1287 < _e824.member.member_1[1])), _e824.member.member_1[1], (_e1274 == 1023u));
                                                    let _e1293 = ((10u * _e419) & 31u);
                                                    let _e1296 = ((_e1237.member[0] >> bitcast<u32>(_e1293)) & 1023u);
                                                    let _e1304 = bitcast<f32>((bitcast<u32>(((_e824.member.member_1[2] - _e824.member.member[2]) * 0.0009775171f)) ^ _e136));
                                                    let _e1309 = (_e824.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1296)) - 8388608f) * _e1304)) ^ _e136)));
                                                    let _e1313 = select(select(_e824.member.member_1[2], _e1309, (_e1309 < _e824.member.member_1[2])), _e824.member.member_1[2], (_e1296 == 1023u));
                                                    let _e1317 = ((_e1237.member[1] >> bitcast<u32>(_e1249)) & 1023u);
                                                    let _e1325 = (_e824.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1317)) - 8388608f) * _e1260)) ^ _e136)));
                                                    let _e1329 = select(select(_e824.member.member_1[0], _e1325, (_e1325 < _e824.member.member_1[0])), _e824.member.member_1[0], (_e1317 == 1023u));
                                                    let _e1332 = ((_e1237.member[1] >> bitcast<u32>(_e1271)) & 1023u);
                                                    let _e1340 = (_e824.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1332)) - 8388608f) * _e1282)) ^ _e136)));
                                                    let _e1344 = select(select(_e824.member.member_1[1], _e1340, (_e1340 < _e824.member.member_1[1])), _e824.member.member_1[1], (_e1332 == 1023u));
                                                    let _e1347 = ((_e1237.member[1] >> bitcast<u32>(_e1293)) & 1023u);
                                                    let _e1355 = (_e824.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1347)) - 8388608f) * _e1304)) ^ _e136)));
                                                    let _e1359 = select(select(_e824.member.member_1[2], _e1355, (_e1355 < _e824.member.member_1[2])), _e824.member.member_1[2], (_e1347 == 1023u));
                                                    let _e1363 = ((_e1237.member[2] >> bitcast<u32>(_e1249)) & 1023u);
                                                    let _e1371 = (_e824.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1363)) - 8388608f) * _e1260)) ^ _e136)));
                                                    let _e1375 = select(select(_e824.member.member_1[0], _e1371, (_e1371 < _e824.member.member_1[0])), _e824.member.member_1[0], (_e1363 == 1023u));
                                                    let _e1378 = ((_e1237.member[2] >> bitcast<u32>(_e1271)) & 1023u);
                                                    let _e1386 = (_e824.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1378)) - 8388608f) * _e1282)) ^ _e136)));
                                                    let _e1390 = select(select(_e824.member.member_1[1], _e1386, (_e1386 < _e824.member.member_1[1])), _e824.member.member_1[1], (_e1378 == 1023u));
                                                    let _e1393 = ((_e1237.member[2] >> bitcast<u32>(_e1293)) & 1023u);
                                                    let _e1401 = (_e824.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1393)) - 8388608f) * _e1304)) ^ _e136)));
                                                    let _e1405 = select(select(_e824.member.member_1[2], _e1401, (_e1401 < _e824.member.member_1[2])), _e824.member.member_1[2], (_e1393 == 1023u));
                                                    let _e1409 = (_e1313 - _e598);
                                                    let _e1412 = (((_e1269 - _e465) * _e637) - (_e1409 * _e505));
                                                    let _e1415 = (((_e1291 - _e532) * _e637) - (_e1409 * _e571));
                                                    let _e1418 = (_e1359 - _e598);
                                                    let _e1421 = (((_e1329 - _e465) * _e637) - (_e1418 * _e505));
                                                    let _e1424 = (((_e1344 - _e532) * _e637) - (_e1418 * _e571));
                                                    let _e1427 = (_e1405 - _e598);
                                                    let _e1430 = (((_e1375 - _e465) * _e637) - (_e1427 * _e505));
                                                    let _e1433 = (((_e1390 - _e532) * _e637) - (_e1427 * _e571));
                                                    let _e1434 = (_e1430 * _e1424);
                                                    let _e1435 = (_e1433 * _e1421);
                                                    let _e1436 = (_e1412 * _e1433);
                                                    let _e1437 = (_e1415 * _e1430);
                                                    let _e1438 = (_e1421 * _e1415);
                                                    let _e1439 = (_e1424 * _e1412);
                                                    let _e1444 = (((_e1434 >= _e1435) && (_e1436 >= _e1437)) && (_e1438 >= _e1439));
                                                    if (_e1444 || (((_e1434 <= _e1435) && (_e1436 <= _e1437)) && (_e1438 <= _e1439))) {
                                                        let _e1451 = select(-1f, 1f, _e1444);
                                                        let _e1453 = ((_e1434 - _e1435) * _e1451);
                                                        let _e1455 = select(0f, _e1453, (_e1453 > 0f));
                                                        let _e1457 = ((_e1436 - _e1437) * _e1451);
                                                        let _e1459 = select(0f, _e1457, (_e1457 > 0f));
                                                        let _e1461 = ((_e1438 - _e1439) * _e1451);
                                                        let _e1463 = select(0f, _e1461, (_e1461 > 0f));
                                                        let _e1465 = ((_e1455 + _e1459) + _e1463);
                                                        if (_e1465 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2547_ = type_22();
                                                            phi_2548_ = true;
                                                            phi_2549_ = false;
                                                        } else {
                                                            let _e1468 = select(_e1421, _e1412, (_e1412 < _e1421));
                                                            if (select(_e1430, _e1468, (_e1468 < _e1430)) > 0f) {
                                                                phi_1863_ = true;
                                                            } else {
                                                                let _e1473 = select(_e1421, _e1412, (_e1412 > _e1421));
                                                                phi_1863_ = (select(_e1430, _e1473, (_e1473 > _e1430)) < 0f);
                                                            }
                                                            let _e1478 = phi_1863_;
                                                            if _e1478 {
                                                                phi_2544_ = type_22();
                                                                phi_2545_ = true;
                                                                phi_2546_ = false;
                                                            } else {
                                                                let _e1480 = select(_e1424, _e1415, (_e1415 < _e1424));
                                                                if (select(_e1433, _e1480, (_e1480 < _e1433)) > 0f) {
                                                                    phi_1892_ = true;
                                                                } else {
                                                                    let _e1485 = select(_e1424, _e1415, (_e1415 > _e1424));
                                                                    phi_1892_ = (select(_e1433, _e1485, (_e1485 > _e1433)) < 0f);
                                                                }
                                                                let _e1490 = phi_1892_;
                                                                if _e1490 {
                                                                    phi_2542_ = type_22();
                                                                    phi_2543_ = false;
                                                                } else {
                                                                    let _e1492 = select(_e1329, _e1269, (_e1269 < _e1329));
                                                                    let _e1496 = select(_e1329, _e1269, (_e1269 > _e1329));
                                                                    let _e1500 = select(_e1344, _e1291, (_e1291 < _e1344));
                                                                    let _e1504 = select(_e1344, _e1291, (_e1291 > _e1344));
                                                                    let _e1508 = select(_e1359, _e1313, (_e1313 < _e1359));
                                                                    let _e1512 = select(_e1359, _e1313, (_e1313 > _e1359));
                                                                    let _e1517 = ((select(_e1375, _e1492, (_e1492 < _e1375)) - _e503) * _e508);
                                                                    let _e1518 = ((select(_e1375, _e1496, (_e1496 > _e1375)) - _e504) * _e508);
                                                                    let _e1521 = ((select(_e1390, _e1500, (_e1500 < _e1390)) - _e569) * _e574);
                                                                    let _e1522 = ((select(_e1390, _e1504, (_e1504 > _e1390)) - _e570) * _e574);
                                                                    let _e1525 = ((select(_e1405, _e1508, (_e1508 < _e1405)) - _e635) * _e640);
                                                                    let _e1526 = ((select(_e1405, _e1512, (_e1512 > _e1405)) - _e636) * _e640);
                                                                    let _e1528 = select(_e1526, _e1525, (_e1525 < _e1526));
                                                                    let _e1530 = select(_e1526, _e1525, (_e1525 > _e1526));
                                                                    let _e1532 = select(_e1518, _e1517, (_e1517 < _e1518));
                                                                    let _e1534 = select(_e1522, _e1521, (_e1521 < _e1522));
                                                                    let _e1536 = select(_e1534, _e1532, (_e1532 > _e1534));
                                                                    let _e1538 = select(_e1528, _e1536, (_e1536 > _e1528));
                                                                    let _e1540 = select(_e1518, _e1517, (_e1517 > _e1518));
                                                                    let _e1542 = select(_e1522, _e1521, (_e1521 > _e1522));
                                                                    let _e1544 = select(_e1542, _e1540, (_e1540 < _e1542));
                                                                    let _e1546 = select(_e1530, _e1544, (_e1544 < _e1530));
                                                                    let _e1547 = -(_e1528);
                                                                    let _e1553 = select(_e751, _e1538, (_e1538 > _e751));
                                                                    if (_e1553 > (_e1546 + (select(_e1547, _e1530, (_e1530 > _e1547)) * 0.0000019073523f))) {
                                                                        phi_2537_ = type_22();
                                                                        phi_2538_ = true;
                                                                    } else {
                                                                        let _e1555 = (_e1553 > _e1205.member);
                                                                        if _e1555 {
                                                                            phi_2536_ = type_22();
                                                                        } else {
                                                                            let _e1556 = vec3<f32>(_e1269, _e1291, _e1313);
                                                                            let _e1557 = vec3<f32>(_e1329, _e1344, _e1359);
                                                                            let _e1558 = vec3<f32>(_e1375, _e1390, _e1405);
                                                                            let _e1559 = (_e1329 - _e1269);
                                                                            let _e1560 = (_e1344 - _e1291);
                                                                            let _e1561 = (_e1359 - _e1313);
                                                                            let _e1562 = vec3<f32>(_e1559, _e1560, _e1561);
                                                                            let _e1563 = (_e1375 - _e1329);
                                                                            let _e1564 = (_e1390 - _e1344);
                                                                            let _e1565 = (_e1405 - _e1359);
                                                                            let _e1566 = vec3<f32>(_e1563, _e1564, _e1565);
                                                                            let _e1567 = (_e1269 - _e1375);
                                                                            let _e1568 = (_e1291 - _e1390);
                                                                            let _e1569 = (_e1313 - _e1405);
                                                                            let _e1570 = vec3<f32>(_e1567, _e1568, _e1569);
                                                                            let _e1573 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                                            let _e1576 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                                            let _e1578 = select(_e1576, _e1573, (_e1573 > _e1576));
                                                                            let _e1581 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                                            let _e1583 = select(_e1581, _e1578, (_e1578 > _e1581));
                                                                            let _e1586 = bitcast<f32>((bitcast<u32>(_e1563) & 2147483647u));
                                                                            let _e1589 = bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u));
                                                                            let _e1591 = select(_e1589, _e1586, (_e1586 > _e1589));
                                                                            let _e1594 = bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u));
                                                                            let _e1596 = select(_e1594, _e1591, (_e1591 > _e1594));
                                                                            let _e1599 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                                            let _e1602 = bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u));
                                                                            let _e1604 = select(_e1602, _e1599, (_e1599 > _e1602));
                                                                            let _e1607 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                                            let _e1609 = select(_e1607, _e1604, (_e1604 > _e1607));
                                                                            let _e1611 = select(_e1596, _e1583, (_e1583 > _e1596));
                                                                            let _e1613 = select(_e1609, _e1611, (_e1611 > _e1609));
                                                                            if (_e1583 == _e1613) {
                                                                                phi_2269_ = _e1424;
                                                                                phi_2270_ = _e1421;
                                                                                phi_2271_ = _e1415;
                                                                                phi_2272_ = _e1412;
                                                                                phi_2273_ = _e1556;
                                                                                phi_2274_ = _e1570;
                                                                                phi_2275_ = _e1566;
                                                                                phi_2276_ = _e1562;
                                                                            } else {
                                                                                let _e1615 = (_e1596 == _e1613);
                                                                                let _e1620 = vec3(_e1615);
                                                                                phi_2269_ = select(_e1415, _e1433, _e1615);
                                                                                phi_2270_ = select(_e1412, _e1430, _e1615);
                                                                                phi_2271_ = select(_e1433, _e1424, _e1615);
                                                                                phi_2272_ = select(_e1430, _e1421, _e1615);
                                                                                phi_2273_ = select(_e1558, _e1557, _e1620);
                                                                                phi_2274_ = select(_e1566, _e1562, _e1620);
                                                                                phi_2275_ = select(_e1562, _e1570, _e1620);
                                                                                phi_2276_ = select(_e1570, _e1566, _e1620);
                                                                            }
                                                                            let _e1626 = phi_2269_;
                                                                            let _e1628 = phi_2270_;
                                                                            let _e1630 = phi_2271_;
                                                                            let _e1632 = phi_2272_;
                                                                            let _e1634 = phi_2273_;
                                                                            let _e1636 = phi_2274_;
                                                                            let _e1638 = phi_2275_;
                                                                            let _e1640 = phi_2276_;
                                                                            let _e1647 = ((_e1638.y * _e1636.z) - (_e1636.y * _e1638.z));
                                                                            let _e1652 = ((_e1638.z * _e1636.x) - (_e1636.z * _e1638.x));
                                                                            let _e1655 = ((_e1638.x * _e1636.y) - (_e1636.x * _e1638.y));
                                                                            if (_e1455 >= _e1459) {
                                                                                phi_2307_ = select(true, false, (_e1455 >= _e1463));
                                                                            } else {
                                                                                phi_2307_ = true;
                                                                            }
                                                                            let _e1660 = phi_2307_;
                                                                            if _e1660 {
                                                                                phi_2316_ = select(_e1558, _e1557, vec3((_e1459 >= _e1463)));
                                                                            } else {
                                                                                phi_2316_ = _e1556;
                                                                            }
                                                                            let _e1665 = phi_2316_;
                                                                            let _e1676 = (((_e1647 * (_e1665.x - _e465)) + (_e1652 * (_e1665.y - _e532))) + (_e1655 * (_e1665.z - _e598)));
                                                                            let _e1681 = (((_e1647 * _e505) + (_e1652 * _e571)) + (_e1655 * _e637));
                                                                            let _e1682 = (_e1628 - _e1632);
                                                                            let _e1683 = (_e1626 - _e1630);
                                                                            let _e1691 = (-(((_e1632 * _e1682) + (_e1630 * _e1683))) / ((_e1682 * _e1682) + (_e1683 * _e1683)));
                                                                            let _e1693 = select(1f, _e1691, (_e1691 < 1f));
                                                                            let _e1695 = select(0f, _e1693, (_e1693 > 0f));
                                                                            let _e1708 = ((_e1634.x + (_e1640.x * _e1695)) - _e465);
                                                                            let _e1709 = ((_e1634.y + (_e1640.y * _e1695)) - _e532);
                                                                            let _e1710 = ((_e1634.z + (_e1640.z * _e1695)) - _e598);
                                                                            let _e1711 = (_e1710 / _e637);
                                                                            let _e1723 = bitcast<f32>((bitcast<u32>(_e1708) & 2147483647u));
                                                                            let _e1726 = bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u));
                                                                            let _e1728 = select(_e1726, _e1723, (_e1723 > _e1726));
                                                                            let _e1731 = bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u));
                                                                            let _e1733 = select(_e1731, _e1728, (_e1728 > _e1731));
                                                                            let _e1739 = bitcast<f32>((bitcast<u32>(_e1647) & 2147483647u));
                                                                            let _e1742 = bitcast<f32>((bitcast<u32>(_e1652) & 2147483647u));
                                                                            let _e1744 = select(_e1742, _e1739, (_e1739 > _e1742));
                                                                            let _e1747 = bitcast<f32>((bitcast<u32>(_e1655) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1647 * _e1708) + (_e1652 * _e1709)) + (_e1655 * _e1710)) - _e1676)) & 2147483647u)) <= ((0.0000009536743f * select(_e1613, _e1733, (_e1733 > _e1613))) * select(_e1747, _e1744, (_e1744 > _e1747)))) {
                                                                                let _e1757 = bitcast<f32>((bitcast<u32>(_e1638.x) & 2147483647u));
                                                                                let _e1760 = bitcast<f32>((bitcast<u32>(_e1638.y) & 2147483647u));
                                                                                let _e1762 = select(_e1760, _e1757, (_e1757 > _e1760));
                                                                                let _e1765 = bitcast<f32>((bitcast<u32>(_e1638.z) & 2147483647u));
                                                                                let _e1771 = bitcast<f32>((bitcast<u32>(_e1636.x) & 2147483647u));
                                                                                let _e1774 = bitcast<f32>((bitcast<u32>(_e1636.y) & 2147483647u));
                                                                                let _e1776 = select(_e1774, _e1771, (_e1771 > _e1774));
                                                                                let _e1779 = bitcast<f32>((bitcast<u32>(_e1636.z) & 2147483647u));
                                                                                let _e1783 = (bitcast<f32>((bitcast<u32>(_e1681) & 2147483647u)) > ((0.0000038146973f * select(_e1765, _e1762, (_e1762 > _e1765))) * select(_e1779, _e1776, (_e1776 > _e1779))));
                                                                                if _e1783 {
                                                                                    phi_2481_ = (_e1676 / _e1681);
                                                                                } else {
                                                                                    phi_2481_ = f32();
                                                                                }
                                                                                let _e1786 = phi_2481_;
                                                                                phi_2483_ = _e1786;
                                                                                phi_2484_ = select(true, false, _e1783);
                                                                            } else {
                                                                                phi_2483_ = f32();
                                                                                phi_2484_ = true;
                                                                            }
                                                                            let _e1789 = phi_2483_;
                                                                            let _e1791 = phi_2484_;
                                                                            if _e1791 {
                                                                                let _e1799 = (((_e1647 * (_e1708 - (_e505 * _e1711))) + (_e1652 * (_e1709 - (_e571 * _e1711)))) / _e1681);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1799) & 2147483647u)) <= _e1613) {
                                                                                    phi_2504_ = (_e1711 + _e1799);
                                                                                } else {
                                                                                    phi_2504_ = _e1711;
                                                                                }
                                                                                let _e1806 = phi_2504_;
                                                                                phi_2505_ = _e1806;
                                                                            } else {
                                                                                phi_2505_ = _e1789;
                                                                            }
                                                                            let _e1808 = phi_2505_;
                                                                            let _e1810 = select(_e1546, _e1808, (_e1808 < _e1546));
                                                                            let _e1812 = select(_e1538, _e1810, (_e1810 > _e1538));
                                                                            if (_e1812 >= _e751) {
                                                                                let _e1814 = (_e1812 <= _e1205.member);
                                                                                if _e1814 {
                                                                                    let _e1815 = (1f / _e1465);
                                                                                    phi_2528_ = type_22(_e1812, (_e1459 * _e1815), (_e1463 * _e1815), _e1233);
                                                                                } else {
                                                                                    phi_2528_ = type_22();
                                                                                }
                                                                                let _e1820 = phi_2528_;
                                                                                phi_2530_ = _e1820;
                                                                                phi_2531_ = select(true, false, _e1814);
                                                                            } else {
                                                                                phi_2530_ = type_22();
                                                                                phi_2531_ = true;
                                                                            }
                                                                            let _e1823 = phi_2530_;
                                                                            let _e1825 = phi_2531_;
                                                                            if _e1825 {
                                                                                phi_2535_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2535_ = _e1823;
                                                                            }
                                                                            let _e1827 = phi_2535_;
                                                                            phi_2536_ = _e1827;
                                                                        }
                                                                        let _e1829 = phi_2536_;
                                                                        phi_2537_ = _e1829;
                                                                        phi_2538_ = _e1555;
                                                                    }
                                                                    let _e1831 = phi_2537_;
                                                                    let _e1833 = phi_2538_;
                                                                    phi_2542_ = _e1831;
                                                                    phi_2543_ = _e1833;
                                                                }
                                                                let _e1835 = phi_2542_;
                                                                let _e1837 = phi_2543_;
                                                                phi_2544_ = _e1835;
                                                                phi_2545_ = _e1490;
                                                                phi_2546_ = _e1837;
                                                            }
                                                            let _e1839 = phi_2544_;
                                                            let _e1841 = phi_2545_;
                                                            let _e1843 = phi_2546_;
                                                            phi_2547_ = _e1839;
                                                            phi_2548_ = _e1841;
                                                            phi_2549_ = _e1843;
                                                        }
                                                        let _e1845 = phi_2547_;
                                                        let _e1847 = phi_2548_;
                                                        let _e1849 = phi_2549_;
                                                        phi_2557_ = _e1845;
                                                        phi_2558_ = select(_e1849, true, _e1847);
                                                    } else {
                                                        phi_2557_ = type_22();
                                                        phi_2558_ = true;
                                                    }
                                                    let _e1852 = phi_2557_;
                                                    let _e1854 = phi_2558_;
                                                    if _e1854 {
                                                        phi_2562_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2562_ = _e1852;
                                                    }
                                                    let _e1856 = phi_2562_;
                                                    if (_e1856.member_3 != 4294967295u) {
                                                        if (_e1233 == _e153) {
                                                            phi_2879_ = false;
                                                        } else {
                                                            let _e1860 = (_e1233 < arrayLength((&global_5.member)));
                                                            if _e1860 {
                                                                if _e1860 {
                                                                } else {
                                                                    phi_3965_ = true;
                                                                    break;
                                                                }
                                                                let _e1862 = global_5.member[_e1233];
                                                                phi_2585_ = _e1862;
                                                            } else {
                                                                phi_2585_ = 4294967295u;
                                                            }
                                                            let _e1864 = phi_2585_;
                                                            let _e1865 = (_e1864 < arrayLength((&global_6.member)));
                                                            if _e1865 {
                                                                if _e1865 {
                                                                } else {
                                                                    phi_3965_ = true;
                                                                    break;
                                                                }
                                                                let _e1867 = global_6.member[_e1864];
                                                                phi_2599_ = _e1867;
                                                            } else {
                                                                phi_2599_ = 0i;
                                                            }
                                                            let _e1869 = phi_2599_;
                                                            let _e1870 = (_e1869 == 0i);
                                                            if _e1870 {
                                                                phi_2878_ = true;
                                                            } else {
                                                                if _e442 {
                                                                    phi_2616_ = vec3<f32>(_e1269, _e1291, _e1313);
                                                                } else {
                                                                    if (_e418 == 1u) {
                                                                        phi_2615_ = vec3<f32>(_e1313, _e1269, _e1291);
                                                                    } else {
                                                                        phi_2615_ = vec3<f32>(_e1291, _e1313, _e1269);
                                                                    }
                                                                    let _e1875 = phi_2615_;
                                                                    phi_2616_ = _e1875;
                                                                }
                                                                let _e1878 = phi_2616_;
                                                                if _e442 {
                                                                    phi_2629_ = vec3<f32>(_e1329, _e1344, _e1359);
                                                                } else {
                                                                    if (_e418 == 1u) {
                                                                        phi_2628_ = vec3<f32>(_e1359, _e1329, _e1344);
                                                                    } else {
                                                                        phi_2628_ = vec3<f32>(_e1344, _e1359, _e1329);
                                                                    }
                                                                    let _e1883 = phi_2628_;
                                                                    phi_2629_ = _e1883;
                                                                }
                                                                let _e1886 = phi_2629_;
                                                                if _e442 {
                                                                    phi_2642_ = vec3<f32>(_e1375, _e1390, _e1405);
                                                                } else {
                                                                    if (_e418 == 1u) {
                                                                        phi_2641_ = vec3<f32>(_e1405, _e1375, _e1390);
                                                                    } else {
                                                                        phi_2641_ = vec3<f32>(_e1390, _e1405, _e1375);
                                                                    }
                                                                    let _e1891 = phi_2641_;
                                                                    phi_2642_ = _e1891;
                                                                }
                                                                let _e1894 = phi_2642_;
                                                                let _e1897 = (_e1886.x - _e1878.x);
                                                                let _e1900 = (_e1886.y - _e1878.y);
                                                                let _e1903 = (_e1886.z - _e1878.z);
                                                                let _e1905 = (_e1894.x - _e1878.x);
                                                                let _e1907 = (_e1894.y - _e1878.y);
                                                                let _e1909 = (_e1894.z - _e1878.z);
                                                                if (_e285.member_1 == 1u) {
                                                                    phi_2678_ = (vec3<f32>(_e285.member[0], _e285.member[1], _e285.member[2]) - _e1878);
                                                                } else {
                                                                    phi_2678_ = vec3<f32>(_e285.member[0], _e285.member[1], _e285.member[2]);
                                                                }
                                                                let _e1924 = phi_2678_;
                                                                let _e1930 = bitcast<f32>((bitcast<u32>((_e1897 * _e1907)) ^ _e285.member_3[0]));
                                                                let _e1934 = bitcast<f32>((bitcast<u32>((_e1900 * _e1905)) ^ _e285.member_3[0]));
                                                                let _e1938 = bitcast<f32>((bitcast<u32>((_e1900 * _e1909)) ^ _e285.member_3[0]));
                                                                let _e1942 = bitcast<f32>((bitcast<u32>((_e1903 * _e1907)) ^ _e285.member_3[0]));
                                                                let _e1946 = bitcast<f32>((bitcast<u32>((_e1903 * _e1905)) ^ _e285.member_3[0]));
                                                                let _e1950 = bitcast<f32>((bitcast<u32>((_e1897 * _e1909)) ^ _e285.member_3[0]));
                                                                let _e1951 = (_e1938 - _e1942);
                                                                let _e1952 = (_e1946 - _e1950);
                                                                let _e1953 = (_e1930 - _e1934);
                                                                let _e1977 = (bitcast<f32>((bitcast<u32>(_e1938) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1942) & 2147483647u)));
                                                                let _e1984 = (bitcast<f32>((bitcast<u32>(_e1946) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1950) & 2147483647u)));
                                                                let _e1991 = (bitcast<f32>((bitcast<u32>(_e1930) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1934) & 2147483647u)));
                                                                if (_e285.member_2 == 0f) {
                                                                    phi_2860_ = 0f;
                                                                } else {
                                                                    let _e2021 = bitcast<f32>((bitcast<u32>(_e1951) & 2147483647u));
                                                                    let _e2024 = bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u));
                                                                    let _e2027 = bitcast<f32>((bitcast<u32>(_e1953) & 2147483647u));
                                                                    let _e2029 = select(_e2027, _e2024, (_e2024 > _e2027));
                                                                    let _e2033 = select(_e2027, _e2024, (_e2024 < _e2027));
                                                                    let _e2037 = select(_e2024, _e2021, (_e2021 < _e2024));
                                                                    let _e2039 = select(_e2024, _e2021, (_e2021 > _e2024));
                                                                    let _e2041 = select(_e2027, _e2039, (_e2039 < _e2027));
                                                                    phi_2860_ = bitcast<f32>((bitcast<u32>((_e285.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2029, _e2021, (_e2021 > _e2029)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2041, _e2037, (_e2037 > _e2041)))) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2033, _e2021, (_e2021 < _e2033)))) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1977 + _e1984) + _e1991))) ^ _e285.member_3[0]))) * 1.0000005f)) ^ _e285.member_3[0])))) ^ _e285.member_3[0]));
                                                                }
                                                                let _e2068 = phi_2860_;
                                                                phi_2878_ = (_e1870 || !(((((bitcast<f32>((bitcast<u32>((_e1924.x * _e1951)) ^ _e285.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1924.y * _e1952)) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1924.z * _e1953)) ^ _e285.member_3[0]))) * f32(-(_e1869))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1924.x) & 2147483647u)) * _e1977)) ^ _e285.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1924.y) & 2147483647u)) * _e1984)) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1924.z) & 2147483647u)) * _e1991)) ^ _e285.member_3[0]))))) ^ _e285.member_3[0])) + _e2068) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2082 = phi_2878_;
                                                            phi_2879_ = _e2082;
                                                        }
                                                        let _e2084 = phi_2879_;
                                                        if _e2084 {
                                                            phi_2884_ = type_40(_e1205.member, true);
                                                        } else {
                                                            phi_2884_ = _e1205;
                                                        }
                                                        let _e2089 = phi_2884_;
                                                        phi_2885_ = _e2089;
                                                    } else {
                                                        phi_2885_ = _e1205;
                                                    }
                                                    let _e2091 = phi_2885_;
                                                    phi_1403_ = _e2091;
                                                } else {
                                                    phi_1403_ = type_40();
                                                }
                                                let _e2093 = phi_1403_;
                                                continue;
                                                continuing {
                                                    phi_1402_ = _e2093;
                                                    phi_1405_ = _e1220;
                                                    phi_3965_ = _e783;
                                                    break if !(_e1226);
                                                }
                                            }
                                            let _e2096 = phi_3965_;
                                            phi_4175_ = _e2096;
                                            if _e2096 {
                                                break;
                                            }
                                            let _e2098 = local_10;
                                            phi_4179_ = _e2096;
                                            let _e2303 = local_12;
                                            phi_3859_ = _e2303;
                                            phi_3860_ = _e824;
                                            phi_3861_ = false;
                                            phi_3862_ = select(_e828, 0u, _e2098.member_1);
                                        } else {
                                            let _e838 = (_e824.member_1 < _e93);
                                            if _e838 {
                                                if _e838 {
                                                } else {
                                                    phi_4175_ = true;
                                                    break;
                                                }
                                                let _e840 = global_9.member[_e824.member_1];
                                                phi_2905_ = _e840;
                                            } else {
                                                phi_2905_ = type_49(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e842 = phi_2905_;
                                            let _e857 = ((10u * _e418) & 31u);
                                            let _e860 = ((_e842.member[0] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e868 = bitcast<f32>((bitcast<u32>(((_e824.member.member_1[0] - _e824.member.member[0]) * 0.0009775171f)) ^ _e136));
                                            let _e873 = (_e824.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e860)) - 8388608f) * _e868)) ^ _e136)));
                                            let _e877 = select(select(_e824.member.member_1[0], _e873, (_e873 < _e824.member.member_1[0])), _e824.member.member_1[0], (_e860 == 1023u));
                                            let _e879 = ((10u * _e417) & 31u);
                                            let _e882 = ((_e842.member[0] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e890 = bitcast<f32>((bitcast<u32>(((_e824.member.member_1[1] - _e824.member.member[1]) * 0.0009775171f)) ^ _e136));
                                            let _e895 = (_e824.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e882)) - 8388608f) * _e890)) ^ _e136)));
                                            let _e899 = select(select(_e824.member.member_1[1], _e895, (_e895 < _e824.member.member_1[1])), _e824.member.member_1[1], (_e882 == 1023u));
                                            let _e901 = ((10u * _e419) & 31u);
                                            let _e904 = ((_e842.member[0] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e912 = bitcast<f32>((bitcast<u32>(((_e824.member.member_1[2] - _e824.member.member[2]) * 0.0009775171f)) ^ _e136));
                                            let _e917 = (_e824.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e904)) - 8388608f) * _e912)) ^ _e136)));
                                            let _e921 = select(select(_e824.member.member_1[2], _e917, (_e917 < _e824.member.member_1[2])), _e824.member.member_1[2], (_e904 == 1023u));
                                            let _e924 = ((_e842.member[1] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e932 = (_e824.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e924)) - 8388608f) * _e868)) ^ _e136)));
                                            let _e936 = select(select(_e824.member.member_1[0], _e932, (_e932 < _e824.member.member_1[0])), _e824.member.member_1[0], (_e924 == 1023u));
                                            let _e939 = ((_e842.member[1] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e947 = (_e824.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e939)) - 8388608f) * _e890)) ^ _e136)));
                                            let _e951 = select(select(_e824.member.member_1[1], _e947, (_e947 < _e824.member.member_1[1])), _e824.member.member_1[1], (_e939 == 1023u));
                                            let _e954 = ((_e842.member[1] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e962 = (_e824.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e954)) - 8388608f) * _e912)) ^ _e136)));
                                            let _e966 = select(select(_e824.member.member_1[2], _e962, (_e962 < _e824.member.member_1[2])), _e824.member.member_1[2], (_e954 == 1023u));
                                            let _e972 = ((_e842.member_1[0] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e980 = (_e824.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e972)) - 8388608f) * _e868)) ^ _e136)));
                                            let _e984 = select(select(_e824.member.member_1[0], _e980, (_e980 < _e824.member.member_1[0])), _e824.member.member_1[0], (_e972 == 1023u));
                                            let _e987 = ((_e842.member_1[0] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e995 = (_e824.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e987)) - 8388608f) * _e890)) ^ _e136)));
                                            let _e999 = select(select(_e824.member.member_1[1], _e995, (_e995 < _e824.member.member_1[1])), _e824.member.member_1[1], (_e987 == 1023u));
                                            let _e1002 = ((_e842.member_1[0] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e1010 = (_e824.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1002)) - 8388608f) * _e912)) ^ _e136)));
                                            let _e1014 = select(select(_e824.member.member_1[2], _e1010, (_e1010 < _e824.member.member_1[2])), _e824.member.member_1[2], (_e1002 == 1023u));
                                            let _e1017 = ((_e842.member_1[1] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e1025 = (_e824.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1017)) - 8388608f) * _e868)) ^ _e136)));
                                            let _e1029 = select(select(_e824.member.member_1[0], _e1025, (_e1025 < _e824.member.member_1[0])), _e824.member.member_1[0], (_e1017 == 1023u));
                                            let _e1032 = ((_e842.member_1[1] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e1040 = (_e824.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1032)) - 8388608f) * _e890)) ^ _e136)));
                                            let _e1044 = select(select(_e824.member.member_1[1], _e1040, (_e1040 < _e824.member.member_1[1])), _e824.member.member_1[1], (_e1032 == 1023u));
                                            let _e1047 = ((_e842.member_1[1] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e1055 = (_e824.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1047)) - 8388608f) * _e912)) ^ _e136)));
                                            let _e1059 = select(select(_e824.member.member_1[2], _e1055, (_e1055 < _e824.member.member_1[2])), _e824.member.member_1[2], (_e1047 == 1023u));
                                            let _e1064 = type_62(type_54(array<f32, 3>(_e877, _e899, _e921), array<f32, 3>(_e936, _e951, _e966)), _e842.member_2);
                                            let _e1069 = type_62(type_54(array<f32, 3>(_e984, _e999, _e1014), array<f32, 3>(_e1029, _e1044, _e1059)), _e842.member_3);
                                            let _e1075 = ((_e877 - _e503) * _e508);
                                            let _e1076 = ((_e984 - _e503) * _e508);
                                            let _e1077 = ((_e936 - _e504) * _e508);
                                            let _e1078 = ((_e1029 - _e504) * _e508);
                                            let _e1083 = ((_e899 - _e569) * _e574);
                                            let _e1084 = ((_e999 - _e569) * _e574);
                                            let _e1085 = ((_e951 - _e570) * _e574);
                                            let _e1086 = ((_e1044 - _e570) * _e574);
                                            let _e1091 = ((_e921 - _e635) * _e640);
                                            let _e1092 = ((_e1014 - _e635) * _e640);
                                            let _e1093 = ((_e966 - _e636) * _e640);
                                            let _e1094 = ((_e1059 - _e636) * _e640);
                                            let _e1096 = select(_e1093, _e1091, (_e1091 < _e1093));
                                            let _e1098 = select(_e1094, _e1092, (_e1092 < _e1094));
                                            let _e1100 = select(_e1093, _e1091, (_e1091 > _e1093));
                                            let _e1102 = select(_e1094, _e1092, (_e1092 > _e1094));
                                            let _e1104 = select(_e1077, _e1075, (_e1075 < _e1077));
                                            let _e1106 = select(_e1078, _e1076, (_e1076 < _e1078));
                                            let _e1108 = select(_e1085, _e1083, (_e1083 < _e1085));
                                            let _e1110 = select(_e1086, _e1084, (_e1084 < _e1086));
                                            let _e1112 = select(_e1108, _e1104, (_e1104 > _e1108));
                                            let _e1114 = select(_e1110, _e1106, (_e1106 > _e1110));
                                            let _e1116 = select(_e1096, _e1112, (_e1112 > _e1096));
                                            let _e1118 = select(_e1098, _e1114, (_e1114 > _e1098));
                                            let _e1120 = select(_e1077, _e1075, (_e1075 > _e1077));
                                            let _e1122 = select(_e1078, _e1076, (_e1076 > _e1078));
                                            let _e1124 = select(_e1085, _e1083, (_e1083 > _e1085));
                                            let _e1126 = select(_e1086, _e1084, (_e1084 > _e1086));
                                            let _e1128 = select(_e1124, _e1120, (_e1120 < _e1124));
                                            let _e1130 = select(_e1126, _e1122, (_e1122 < _e1126));
                                            let _e1135 = -(_e1096);
                                            let _e1136 = -(_e1098);
                                            let _e1143 = (select(_e1100, _e1128, (_e1128 < _e1100)) + (select(_e1135, _e1100, (_e1100 > _e1135)) * 0.0000019073523f));
                                            let _e1144 = (select(_e1102, _e1130, (_e1130 < _e1102)) + (select(_e1136, _e1102, (_e1102 > _e1136)) * 0.0000019073523f));
                                            let _e1146 = select(_e751, _e1116, (_e1116 > _e751));
                                            let _e1148 = select(_e751, _e1118, (_e1118 > _e751));
                                            let _e1153 = (_e1146 <= select(_e785.member, _e1143, (_e1143 < _e785.member)));
                                            let _e1154 = (_e1148 <= select(_e785.member, _e1144, (_e1144 < _e785.member)));
                                            let _e1155 = (_e1146 <= _e1148);
                                            if _e1153 {
                                                if _e1154 {
                                                    if _e1155 {
                                                        phi_3761_ = _e1069;
                                                    } else {
                                                        phi_3761_ = _e1064;
                                                    }
                                                    let _e1157 = phi_3761_;
                                                    let _e1165 = (_e828 % 128u);
                                                    let _e1166 = (_e1165 < 128u);
                                                    if _e1166 {
                                                    } else {
                                                        phi_4175_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1165] = _e1157.member_1;
                                                    if _e1166 {
                                                    } else {
                                                        phi_4175_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1165] = _e1157.member.member[0];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4175_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1165] = _e1157.member.member[1];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4175_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1165] = _e1157.member.member[2];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4175_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1165] = _e1157.member.member_1[0];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4175_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1165] = _e1157.member.member_1[1];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4175_ = true;
                                                        break;
                                                    }
                                                    local[_e1165] = _e1157.member.member_1[2];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4175_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1165] = select(_e1148, _e1146, (_e1146 > _e1148));
                                                    if _e1155 {
                                                        phi_3838_ = _e1064;
                                                    } else {
                                                        phi_3838_ = _e1069;
                                                    }
                                                    let _e1183 = phi_3838_;
                                                    phi_3839_ = _e1183;
                                                    phi_3840_ = (_e828 + 1u);
                                                } else {
                                                    phi_3839_ = type_62();
                                                    phi_3840_ = u32();
                                                }
                                                let _e1185 = phi_3839_;
                                                let _e1187 = phi_3840_;
                                                phi_3842_ = _e1185;
                                                phi_3843_ = _e1187;
                                                phi_3844_ = select(true, false, _e1154);
                                            } else {
                                                phi_3842_ = type_62();
                                                phi_3843_ = u32();
                                                phi_3844_ = true;
                                            }
                                            let _e1190 = phi_3842_;
                                            let _e1192 = phi_3843_;
                                            let _e1194 = phi_3844_;
                                            if _e1194 {
                                                if _e1153 {
                                                    phi_3851_ = _e1064;
                                                } else {
                                                    phi_3851_ = _e1069;
                                                }
                                                let _e1196 = phi_3851_;
                                                phi_3856_ = _e1196;
                                                phi_3857_ = select(_e1154, true, _e1153);
                                            } else {
                                                phi_3856_ = _e1190;
                                                phi_3857_ = _e826;
                                            }
                                            let _e1199 = phi_3856_;
                                            let _e1201 = phi_3857_;
                                            phi_4179_ = _e783;
                                            phi_3859_ = _e785;
                                            phi_3860_ = _e1199;
                                            phi_3861_ = _e1201;
                                            phi_3862_ = select(_e1192, _e828, _e1194);
                                        }
                                        let _e2102 = phi_4179_;
                                        let _e2104 = phi_3859_;
                                        let _e2106 = phi_3860_;
                                        let _e2108 = phi_3861_;
                                        let _e2110 = phi_3862_;
                                        phi_4178_ = _e2102;
                                        phi_3863_ = _e2104;
                                        phi_3864_ = _e2106;
                                        phi_3865_ = (_e789 - 1u);
                                        phi_3866_ = _e2108;
                                        phi_3867_ = _e2110;
                                    } else {
                                        phi_4178_ = _e783;
                                        phi_3863_ = _e785;
                                        phi_3864_ = _e824;
                                        phi_3865_ = _e789;
                                        phi_3866_ = _e826;
                                        phi_3867_ = _e828;
                                    }
                                    let _e2112 = phi_4178_;
                                    let _e2114 = phi_3863_;
                                    let _e2116 = phi_3864_;
                                    let _e2118 = phi_3865_;
                                    let _e2120 = phi_3866_;
                                    let _e2122 = phi_3867_;
                                    phi_4177_ = _e2112;
                                    phi_3868_ = _e2114;
                                    phi_3869_ = _e2116;
                                    phi_3870_ = _e2118;
                                    phi_3871_ = _e2120;
                                    phi_3872_ = _e2122;
                                } else {
                                    phi_4177_ = _e783;
                                    phi_3868_ = type_40();
                                    phi_3869_ = type_62();
                                    phi_3870_ = u32();
                                    phi_3871_ = bool();
                                    phi_3872_ = u32();
                                }
                                let _e2124 = phi_4177_;
                                let _e2126 = phi_3868_;
                                let _e2128 = phi_3869_;
                                let _e2130 = phi_3870_;
                                let _e2132 = phi_3871_;
                                let _e2134 = phi_3872_;
                                phi_4176_ = _e2124;
                                phi_1276_ = _e2126;
                                phi_1279_ = _e2128;
                                phi_1281_ = _e2130;
                                phi_1283_ = _e2132;
                                phi_1285_ = _e2134;
                                phi_3873_ = _e797;
                            } else {
                                phi_4176_ = _e783;
                                phi_1276_ = type_40();
                                phi_1279_ = type_62();
                                phi_1281_ = u32();
                                phi_1283_ = bool();
                                phi_1285_ = u32();
                                phi_3873_ = false;
                            }
                            let _e2136 = phi_4176_;
                            let _e2138 = phi_1276_;
                            let _e2140 = phi_1279_;
                            let _e2142 = phi_1281_;
                            let _e2144 = phi_1283_;
                            let _e2146 = phi_1285_;
                            let _e2148 = phi_3873_;
                            continue;
                            continuing {
                                phi_3971_ = _e2136;
                                phi_1275_ = _e2138;
                                phi_1278_ = _e2140;
                                phi_1280_ = _e2142;
                                phi_1282_ = _e2144;
                                phi_1284_ = _e2146;
                                phi_4175_ = _e2136;
                                break if !(_e2148);
                            }
                        }
                        let _e2151 = phi_4175_;
                        if _e2151 {
                            break;
                        }
                        let _e2153 = local_11;
                        if _e2153.member_1 {
                        } else {
                            if _e286 {
                            } else {
                                break;
                            }
                            let _e2157 = global_2.member[_e140];
                            if _e147 {
                            } else {
                                break;
                            }
                            let _e2161 = global_8.member[_e140].member_1;
                            if _e286 {
                            } else {
                                break;
                            }
                            global_2.member[_e140] = type_24(_e2157.member, _e2157.member_1, _e2157.member_2, array<f32, 3>((_e2157.member_3[0] + (_e2161[0] * _e2157.member_1[0])), (_e2157.member_3[1] + (_e2161[1] * _e2157.member_1[1])), (_e2157.member_3[2] + (_e2161[2] * _e2157.member_1[2]))), _e2157.member_4);
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
fn trace_shadows_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
