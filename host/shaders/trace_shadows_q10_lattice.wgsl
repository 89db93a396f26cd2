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

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_46 {
    member: f32,
    member_1: bool,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_61 {
    member: type_34,
    member_1: u32,
}

struct type_62 {
    member: array<vec4<f32>, 3>,
    member_1: type_61,
    member_2: type_61,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_29;
@group(0) @binding(1) 
var<uniform> global_3: type_48;
@group(0) @binding(2) 
var<uniform> global_4: type_48;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_51;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_69;
@group(0) @binding(7) 
var<storage> global_9: type_37;
@group(0) @binding(4) 
var<storage> global_10: type_4;

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
    var local_10: array<u32, 3>;
    var local_11: array<array<f32, 3>, 3>;
    var local_12: array<f32, 4>;
    var phi_341_: u32;
    var phi_385_: i32;
    var phi_409_: type_41;
    var phi_559_: i32;
    var phi_560_: i32;
    var phi_570_: bool;
    var phi_580_: u32;
    var phi_581_: u32;
    var phi_583_: bool;
    var phi_588_: u32;
    var phi_621_: i32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_656_: f32;
    var phi_662_: f32;
    var phi_685_: f32;
    var phi_696_: f32;
    var phi_705_: f32;
    var phi_711_: f32;
    var phi_722_: f32;
    var phi_728_: f32;
    var phi_751_: f32;
    var phi_762_: f32;
    var phi_771_: f32;
    var phi_777_: f32;
    var phi_788_: f32;
    var phi_794_: f32;
    var phi_817_: f32;
    var phi_828_: f32;
    var phi_928_: f32;
    var phi_929_: f32;
    var phi_3940_: bool;
    var phi_1018_: type_46;
    var phi_1021_: type_61;
    var phi_1023_: u32;
    var phi_1025_: bool;
    var phi_1027_: u32;
    var phi_1038_: bool;
    var phi_1124_: type_61;
    var phi_1125_: bool;
    var phi_1126_: u32;
    var phi_2910_: u32;
    var phi_2916_: u32;
    var phi_3170_: u32;
    var phi_3171_: u32;
    var phi_3181_: u32;
    var phi_3183_: u32;
    var phi_3184_: bool;
    var phi_3204_: u32;
    var phi_3205_: u32;
    var phi_3209_: type_62;
    var phi_3553_: type_61;
    var phi_3630_: type_61;
    var phi_3631_: type_61;
    var phi_3632_: u32;
    var phi_3634_: type_61;
    var phi_3635_: u32;
    var phi_3636_: bool;
    var phi_3645_: type_61;
    var phi_3650_: type_61;
    var phi_3651_: bool;
    var phi_3937_: bool;
    var phi_1145_: type_46;
    var phi_1148_: type_8;
    var phi_1149_: type_8;
    var phi_1171_: type_8;
    var phi_1212_: u32;
    var phi_1218_: u32;
    var phi_1228_: u32;
    var phi_1244_: u32;
    var phi_1281_: u32;
    var phi_1287_: u32;
    var phi_1297_: u32;
    var phi_3922_: bool;
    var phi_1313_: type_8;
    var phi_1314_: type_8;
    var phi_1337_: type_8;
    var phi_1360_: u32;
    var phi_1375_: u32;
    var phi_1378_: type_8;
    var phi_1379_: type_8;
    var phi_1402_: type_8;
    var phi_1468_: u32;
    var phi_1448_: u32;
    var phi_1449_: u32;
    var phi_1472_: f32;
    var phi_3915_: bool;
    var phi_4001_: bool;
    var phi_4000_: bool;
    var phi_1972_: vec3<f32>;
    var phi_1973_: vec3<f32>;
    var phi_2004_: bool;
    var phi_2013_: vec3<f32>;
    var phi_2053_: type_25;
    var phi_2055_: type_25;
    var phi_2056_: bool;
    var phi_2060_: type_25;
    var phi_2061_: type_25;
    var phi_2062_: type_25;
    var phi_2063_: bool;
    var phi_2067_: type_25;
    var phi_2068_: bool;
    var phi_2072_: type_25;
    var phi_2073_: bool;
    var phi_2077_: type_25;
    var phi_2100_: u32;
    var phi_2114_: i32;
    var phi_2134_: vec3<f32>;
    var phi_2135_: vec3<f32>;
    var phi_2151_: vec3<f32>;
    var phi_2152_: vec3<f32>;
    var phi_2168_: vec3<f32>;
    var phi_2169_: vec3<f32>;
    var phi_2205_: vec3<f32>;
    var phi_2387_: f32;
    var phi_2405_: bool;
    var phi_2406_: bool;
    var phi_2411_: type_46;
    var phi_2412_: type_46;
    var phi_4003_: bool;
    var phi_1146_: type_46;
    var phi_4002_: bool;
    var local_13: type_46;
    var phi_4082_: bool;
    var phi_3653_: type_46;
    var phi_3654_: type_61;
    var phi_3655_: bool;
    var phi_3656_: u32;
    var phi_4081_: bool;
    var phi_3657_: type_46;
    var phi_3658_: type_61;
    var phi_3659_: u32;
    var phi_3660_: bool;
    var phi_3661_: u32;
    var phi_4080_: bool;
    var phi_3662_: type_46;
    var phi_3663_: type_61;
    var phi_3664_: u32;
    var phi_3665_: bool;
    var phi_3666_: u32;
    var phi_4079_: bool;
    var phi_1019_: type_46;
    var phi_1022_: type_61;
    var phi_1024_: u32;
    var phi_1026_: bool;
    var phi_1028_: u32;
    var phi_3667_: bool;
    var phi_4078_: bool;
    var local_14: type_46;
    var local_15: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e102 = global;
            let _e104 = arrayLength((&global_5.member));
            let _e107 = arrayLength((&global_10.member));
            let _e119 = arrayLength((&global_8.member));
            let _e123 = global_4.member[0u][0u];
            let _e127 = global_4.member[0u][1u];
            let _e131 = global_4.member[0u][2u];
            let _e135 = global_4.member[0u][3u];
            let _e139 = global_4.member[1u][0u];
            let _e143 = global_4.member[1u][1u];
            let _e147 = global_4.member[1u][2u];
            let _e151 = (_e102.x + (_e102.y * 2097152u));
            let _e163 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e135) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            local = array<i32, 3>(bitcast<i32>(_e139), bitcast<i32>(_e143), bitcast<i32>(_e147));
            let _e166 = (_e151 < arrayLength((&global_9.member)));
            if _e166 {
                if _e166 {
                } else {
                    break;
                }
                let _e170 = global_9.member[_e151].member_2;
                phi_341_ = _e170;
            } else {
                phi_341_ = 4294967295u;
            }
            let _e172 = phi_341_;
            let _e175 = global_1.member[0u];
            let _e179 = global_3.member[0u][0u];
            let _e183 = global_3.member[0u][1u];
            let _e187 = global_3.member[0u][2u];
            let _e191 = global_3.member[0u][3u];
            let _e195 = global_3.member[1u][0u];
            let _e199 = global_3.member[1u][1u];
            let _e203 = global_3.member[1u][2u];
            let _e207 = global_3.member[1u][3u];
            let _e208 = bitcast<f32>(_e179);
            let _e209 = bitcast<f32>(_e183);
            let _e210 = bitcast<f32>(_e187);
            let _e212 = bitcast<f32>(_e195);
            let _e213 = array<u32, 3>(_e199, _e203, _e207);
            let _e215 = bitcast<i32>(_e175);
            if (_e215 < -126i) {
                phi_385_ = -126i;
            } else {
                phi_385_ = select(_e215, 127i, (_e215 > 127i));
            }
            let _e220 = phi_385_;
            let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
            let _e231 = bitcast<f32>((bitcast<u32>(((_e215 - _e220) + 127i)) << bitcast<u32>(23i)));
            if (_e191 == 0u) {
                phi_409_ = type_41(array<f32, 3>(_e208, _e209, _e210), _e191, _e212, _e213);
            } else {
                phi_409_ = type_41(array<f32, 3>(((_e208 * _e225) * _e231), ((_e209 * _e225) * _e231), ((_e210 * _e225) * _e231)), _e191, ((_e212 * _e225) * _e231), _e213);
            }
            let _e244 = phi_409_;
            if _e166 {
                let _e245 = (_e151 < arrayLength((&global_2.member)));
                if _e245 {
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e250 = global_9.member[_e151].member.member_1;
                    let _e255 = global_9.member[_e151].member.member_3;
                    if (_e250 <= _e255) {
                        let _e257 = (1u < _e119);
                        if _e257 {
                            if (0u < _e119) {
                            } else {
                                break;
                            }
                            let _e261 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e261 + 1u) < _e261) {
                                if _e257 {
                                } else {
                                    break;
                                }
                                let _e266 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e166 {
                        } else {
                            break;
                        }
                        let _e276 = global_9.member[_e151].member.member_2[0u];
                        let _e278 = (bitcast<u32>(_e276) & 2147483647u);
                        let _e284 = global_9.member[_e151].member.member_2[1u];
                        let _e286 = (bitcast<u32>(_e284) & 2147483647u);
                        let _e292 = global_9.member[_e151].member.member_2[2u];
                        let _e294 = (bitcast<u32>(_e292) & 2147483647u);
                        let _e300 = global_9.member[_e151].member.member[0u];
                        let _e302 = (bitcast<u32>(_e300) & 2147483647u);
                        let _e308 = global_9.member[_e151].member.member[1u];
                        let _e310 = (bitcast<u32>(_e308) & 2147483647u);
                        let _e316 = global_9.member[_e151].member.member[2u];
                        let _e318 = (bitcast<u32>(_e316) & 2147483647u);
                        let _e320 = select(_e286, _e278, (_e286 < _e278));
                        let _e322 = select(_e294, _e320, (_e294 < _e320));
                        let _e324 = select(_e302, _e322, (_e302 < _e322));
                        let _e326 = select(_e310, _e324, (_e310 < _e324));
                        let _e328 = select(_e318, _e326, (_e318 < _e326));
                        let _e330 = (bitcast<u32>(_e250) & 2147483647u);
                        let _e339 = (((select(_e330, _e328, (_e330 < _e328)) < 2139095040u) && ((bitcast<u32>(_e255) & 2147483647u) <= 2139095040u)) && (_e322 > 0u));
                        if _e339 {
                            let _e342 = (bitcast<u32>(bitcast<f32>(_e322)) & 2147483647u);
                            if (_e342 >= 8388608u) {
                                phi_559_ = (bitcast<i32>((_e342 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_559_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e342)), 32u, (_e342 == 0u))));
                            }
                            let _e356 = phi_559_;
                            phi_560_ = _e356;
                        } else {
                            phi_560_ = 0i;
                        }
                        let _e358 = phi_560_;
                        let _e359 = (_e278 == _e322);
                        if _e359 {
                            phi_570_ = true;
                        } else {
                            phi_570_ = (_e286 == _e322);
                        }
                        let _e362 = phi_570_;
                        let _e363 = select(1u, 0u, _e359);
                        if _e362 {
                            let _e364 = (_e363 + 1u);
                            phi_580_ = _e364;
                            phi_581_ = _e364;
                            phi_583_ = select(true, false, (_e364 == 2u));
                        } else {
                            phi_580_ = u32();
                            phi_581_ = 0u;
                            phi_583_ = true;
                        }
                        let _e368 = phi_580_;
                        let _e370 = phi_581_;
                        let _e372 = phi_583_;
                        if _e372 {
                            phi_588_ = (_e370 + 1u);
                        } else {
                            phi_588_ = 0u;
                        }
                        let _e376 = phi_588_;
                        let _e377 = select(_e368, _e370, _e372);
                        let _e378 = select(_e363, select(2u, _e363, _e362), _e372);
                        let _e379 = -(_e358);
                        if (_e379 < -126i) {
                            phi_621_ = -126i;
                        } else {
                            phi_621_ = select(_e379, 127i, (_e379 > 127i));
                        }
                        let _e384 = phi_621_;
                        let _e389 = bitcast<f32>((bitcast<u32>((_e384 + 127i)) << bitcast<u32>(23i)));
                        let _e395 = bitcast<f32>((bitcast<u32>(((_e379 - _e384) + 127i)) << bitcast<u32>(23i)));
                        let _e400 = global_9.member[_e151].member.member;
                        let _e401 = (_e377 == 0u);
                        if _e401 {
                            phi_639_ = _e400[0];
                        } else {
                            phi_639_ = _e400[1];
                        }
                        let _e405 = phi_639_;
                        let _e406 = (_e377 == 2u);
                        if _e406 {
                            phi_645_ = _e400[2];
                        } else {
                            phi_645_ = _e405;
                        }
                        let _e409 = phi_645_;
                        let _e410 = global_9.member[_e151].member.member_2;
                        if _e401 {
                            phi_656_ = _e410[0];
                        } else {
                            phi_656_ = _e410[1];
                        }
                        let _e414 = phi_656_;
                        if _e406 {
                            phi_662_ = _e410[2];
                        } else {
                            phi_662_ = _e414;
                        }
                        let _e417 = phi_662_;
                        let _e419 = ((_e417 * _e389) * _e395);
                        let _e423 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e423 {
                            let _e427 = (bitcast<f32>((bitcast<u32>(_e409) & 2147483647u)) * 0.00000011920929f);
                            phi_685_ = select(0.00000000000011368684f, _e427, (_e427 > 0.00000000000011368684f));
                        } else {
                            phi_685_ = 0f;
                        }
                        let _e431 = phi_685_;
                        let _e432 = (_e409 + _e431);
                        let _e433 = (_e409 - _e431);
                        let _e434 = select(_e419, 0f, _e423);
                        if _e423 {
                            phi_696_ = 38685626000000000000000000f;
                        } else {
                            phi_696_ = (1f / _e419);
                        }
                        let _e437 = phi_696_;
                        let _e438 = (_e376 == 0u);
                        if _e438 {
                            phi_705_ = _e400[0];
                        } else {
                            phi_705_ = _e400[1];
                        }
                        let _e442 = phi_705_;
                        let _e443 = (_e376 == 2u);
                        if _e443 {
                            phi_711_ = _e400[2];
                        } else {
                            phi_711_ = _e442;
                        }
                        let _e446 = phi_711_;
                        if _e438 {
                            phi_722_ = _e410[0];
                        } else {
                            phi_722_ = _e410[1];
                        }
                        let _e450 = phi_722_;
                        if _e443 {
                            phi_728_ = _e410[2];
                        } else {
                            phi_728_ = _e450;
                        }
                        let _e453 = phi_728_;
                        let _e455 = ((_e453 * _e389) * _e395);
                        let _e459 = (bitcast<f32>((bitcast<u32>(_e455) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e459 {
                            let _e463 = (bitcast<f32>((bitcast<u32>(_e446) & 2147483647u)) * 0.00000011920929f);
                            phi_751_ = select(0.00000000000011368684f, _e463, (_e463 > 0.00000000000011368684f));
                        } else {
                            phi_751_ = 0f;
                        }
                        let _e467 = phi_751_;
                        let _e468 = (_e446 + _e467);
                        let _e469 = (_e446 - _e467);
                        let _e470 = select(_e455, 0f, _e459);
                        if _e459 {
                            phi_762_ = 38685626000000000000000000f;
                        } else {
                            phi_762_ = (1f / _e455);
                        }
                        let _e473 = phi_762_;
                        let _e474 = (_e378 == 0u);
                        if _e474 {
                            phi_771_ = _e400[0];
                        } else {
                            phi_771_ = _e400[1];
                        }
                        let _e478 = phi_771_;
                        let _e479 = (_e378 == 2u);
                        if _e479 {
                            phi_777_ = _e400[2];
                        } else {
                            phi_777_ = _e478;
                        }
                        let _e482 = phi_777_;
                        if _e474 {
                            phi_788_ = _e410[0];
                        } else {
                            phi_788_ = _e410[1];
                        }
                        let _e486 = phi_788_;
                        if _e479 {
                            phi_794_ = _e410[2];
                        } else {
                            phi_794_ = _e486;
                        }
                        let _e489 = phi_794_;
                        let _e491 = ((_e489 * _e389) * _e395);
                        let _e495 = (bitcast<f32>((bitcast<u32>(_e491) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e495 {
                            let _e499 = (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) * 0.00000011920929f);
                            phi_817_ = select(0.00000000000011368684f, _e499, (_e499 > 0.00000000000011368684f));
                        } else {
                            phi_817_ = 0f;
                        }
                        let _e503 = phi_817_;
                        let _e504 = (_e482 + _e503);
                        let _e505 = (_e482 - _e503);
                        let _e506 = select(_e491, 0f, _e495);
                        if _e495 {
                            phi_828_ = 38685626000000000000000000f;
                        } else {
                            phi_828_ = (1f / _e491);
                        }
                        let _e509 = phi_828_;
                        let _e512 = bitcast<f32>((bitcast<u32>(_e409) & 2147483647u));
                        let _e515 = bitcast<f32>((bitcast<u32>(_e446) & 2147483647u));
                        let _e517 = select(_e515, _e512, (_e512 > _e515));
                        let _e520 = bitcast<f32>((bitcast<u32>(_e482) & 2147483647u));
                        if (_e339 && (select(_e520, _e517, (_e517 > _e520)) <= 1099511600000f)) {
                            let _e525 = (_e358 / 3i);
                            let _e532 = bitcast<f32>((bitcast<u32>((_e525 + 127i)) << bitcast<u32>(23i)));
                            let _e539 = bitcast<f32>((bitcast<u32>(((_e358 - (2i * _e525)) + 127i)) << bitcast<u32>(23i)));
                            let _e540 = (((_e250 * _e532) * _e532) * _e539);
                            let _e542 = select(340282350000000000000000000000000000000f, _e540, (_e540 < 340282350000000000000000000000000000000f));
                            let _e547 = (((_e255 * _e532) * _e532) * _e539);
                            let _e549 = select(340282350000000000000000000000000000000f, _e547, (_e547 < 340282350000000000000000000000000000000f));
                            phi_928_ = select(-340282350000000000000000000000000000000f, _e549, (_e549 > -340282350000000000000000000000000000000f));
                            phi_929_ = select(-340282350000000000000000000000000000000f, _e542, (_e542 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_928_ = 0f;
                            phi_929_ = 1f;
                        }
                        let _e553 = phi_928_;
                        let _e555 = phi_929_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e559 = (_e377 % 3u);
                        let _e560 = (_e559 < 3u);
                        if _e560 {
                        } else {
                            break;
                        }
                        let _e562 = local_1[_e559];
                        let _e565 = (_e376 % 3u);
                        let _e566 = (_e565 < 3u);
                        if _e566 {
                        } else {
                            break;
                        }
                        let _e568 = local_1[_e565];
                        let _e571 = (_e378 % 3u);
                        let _e572 = (_e571 < 3u);
                        if _e572 {
                        } else {
                            break;
                        }
                        let _e574 = local_1[_e571];
                        if _e560 {
                        } else {
                            break;
                        }
                        let _e579 = local[_e559];
                        if _e566 {
                        } else {
                            break;
                        }
                        let _e583 = local[_e565];
                        if _e572 {
                        } else {
                            break;
                        }
                        let _e587 = local[_e571];
                        phi_3940_ = false;
                        phi_1018_ = type_46(_e553, false);
                        phi_1021_ = type_61(type_34(vec4<f32>((f32(_e562) * _e163), (f32(_e568) * _e163), (f32(_e574) * _e163), 0f), vec4<f32>((f32(_e579) * _e163), (f32(_e583) * _e163), (f32(_e587) * _e163), 0f)), select(0u, 2147483648u, (_e104 == 0u)));
                        phi_1023_ = ((3u * _e104) + 1u);
                        phi_1025_ = (_e555 <= _e553);
                        phi_1027_ = 0u;
                        loop {
                            let _e597 = phi_3940_;
                            let _e599 = phi_1018_;
                            let _e601 = phi_1021_;
                            let _e603 = phi_1023_;
                            let _e605 = phi_1025_;
                            let _e607 = phi_1027_;
                            local_14 = _e599;
                            if _e605 {
                                phi_1038_ = true;
                            } else {
                                phi_1038_ = (_e607 > 0u);
                            }
                            let _e610 = phi_1038_;
                            if _e610 {
                                let _e611 = (_e603 > 0u);
                                if _e611 {
                                    if _e605 {
                                        phi_1124_ = _e601;
                                        phi_1125_ = _e605;
                                        phi_1126_ = _e607;
                                    } else {
                                        let _e612 = (_e607 - 1u);
                                        let _e613 = (_e612 % 128u);
                                        let _e614 = (_e613 < 128u);
                                        if _e614 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e616 = local_7[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e618 = local_6[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e620 = local_5[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e622 = local_4[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e624 = local_3[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e626 = local_2[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e631 = local_8[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e634 = local_9[_e613];
                                        phi_1124_ = type_61(type_34(vec4<f32>(_e616, _e618, _e620, 0f), vec4<f32>(_e622, _e624, _e626, 0f)), _e631);
                                        phi_1125_ = (_e634 <= _e599.member);
                                        phi_1126_ = _e612;
                                    }
                                    let _e638 = phi_1124_;
                                    let _e640 = phi_1125_;
                                    let _e642 = phi_1126_;
                                    if _e640 {
                                        let _e647 = (_e638.member_1 & 268435455u);
                                        if ((_e638.member_1 & 2147483648u) != 0u) {
                                            phi_3937_ = _e597;
                                            phi_1145_ = _e599;
                                            phi_1148_ = type_8(0u, ((_e638.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1107 = phi_3937_;
                                                let _e1109 = phi_1145_;
                                                let _e1111 = phi_1148_;
                                                local_13 = _e1109;
                                                local_15 = _e1109;
                                                if (_e1111.member < _e1111.member_1) {
                                                    phi_1149_ = type_8((_e1111.member + 1u), _e1111.member_1);
                                                    phi_1171_ = type_8(1u, _e1111.member);
                                                } else {
                                                    phi_1149_ = _e1111;
                                                    phi_1171_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1124 = phi_1149_;
                                                let _e1126 = phi_1171_;
                                                let _e1130 = (bitcast<i32>(_e1126.member) != 0i);
                                                if _e1130 {
                                                    let _e1135 = (_e638.member.member_1.x - _e638.member.member.x);
                                                    let _e1138 = (_e638.member.member_1.y - _e638.member.member.y);
                                                    let _e1141 = (_e638.member.member_1.z - _e638.member.member.z);
                                                    let _e1143 = select(_e1138, _e1135, (_e1135 > _e1138));
                                                    let _e1145 = select(_e1141, _e1143, (_e1143 > _e1141));
                                                    let _e1147 = (_e1145 < (1024f * _e163));
                                                    if _e1147 {
                                                        phi_1212_ = 0u;
                                                    } else {
                                                        phi_1212_ = select(2u, 1u, (_e1145 < (2097152f * _e163)));
                                                    }
                                                    let _e1152 = phi_1212_;
                                                    switch bitcast<i32>(_e1152) {
                                                        case 0: {
                                                            phi_1218_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1218_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1218_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1218_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1155 = phi_1218_;
                                                    switch bitcast<i32>(_e1152) {
                                                        case 0: {
                                                            phi_1228_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1228_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1228_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1228_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1162 = phi_1228_;
                                                    let _e1164 = ((_e647 + (_e1126.member_1 * ((3u * _e1155) + 1u))) + (3u * _e1162));
                                                    let _e1165 = (_e1164 < _e107);
                                                    if _e1165 {
                                                        if _e1165 {
                                                        } else {
                                                            phi_4002_ = true;
                                                            break;
                                                        }
                                                        let _e1167 = global_10.member[_e1164];
                                                        phi_1244_ = _e1167;
                                                    } else {
                                                        phi_1244_ = 4294967295u;
                                                    }
                                                    let _e1169 = phi_1244_;
                                                    local_10 = array<u32, 3>(_e377, _e376, _e378);
                                                    if _e1147 {
                                                        phi_1281_ = 0u;
                                                    } else {
                                                        phi_1281_ = select(2u, 1u, (_e1145 < (2097152f * _e163)));
                                                    }
                                                    let _e1175 = phi_1281_;
                                                    switch bitcast<i32>(_e1175) {
                                                        case 0: {
                                                            phi_1287_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1287_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1287_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1287_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1178 = phi_1287_;
                                                    switch bitcast<i32>(_e1175) {
                                                        case 0: {
                                                            phi_1297_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1297_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1297_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1297_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1185 = phi_1297_;
                                                    local_12 = array<f32, 4>(_e638.member.member.x, _e638.member.member.y, _e638.member.member.z, _e638.member.member.w);
                                                    local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_3922_ = _e1107;
                                                    phi_1313_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1199 = phi_3922_;
                                                        let _e1201 = phi_1313_;
                                                        if (_e1201.member < _e1201.member_1) {
                                                            phi_1314_ = type_8((_e1201.member + 1u), _e1201.member_1);
                                                            phi_1337_ = type_8(1u, _e1201.member);
                                                        } else {
                                                            phi_1314_ = _e1201;
                                                            phi_1337_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1214 = phi_1314_;
                                                        let _e1216 = phi_1337_;
                                                        let _e1220 = (bitcast<i32>(_e1216.member) != 0i);
                                                        if _e1220 {
                                                            let _e1222 = ((_e647 + (_e1126.member_1 * ((3u * _e1178) + 1u))) + (_e1216.member_1 * _e1185));
                                                            let _e1223 = (_e1222 < _e107);
                                                            if _e1223 {
                                                                if _e1223 {
                                                                } else {
                                                                    phi_4000_ = true;
                                                                    break;
                                                                }
                                                                let _e1225 = global_10.member[_e1222];
                                                                phi_1360_ = _e1225;
                                                            } else {
                                                                phi_1360_ = 0u;
                                                            }
                                                            let _e1227 = phi_1360_;
                                                            let _e1228 = (_e1222 + 1u);
                                                            let _e1229 = (_e1228 < _e107);
                                                            if _e1229 {
                                                                if _e1229 {
                                                                } else {
                                                                    phi_4000_ = true;
                                                                    break;
                                                                }
                                                                let _e1231 = global_10.member[_e1228];
                                                                phi_1375_ = _e1231;
                                                            } else {
                                                                phi_1375_ = 0u;
                                                            }
                                                            let _e1233 = phi_1375_;
                                                            phi_1378_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1235 = phi_1378_;
                                                                if (_e1235.member < _e1235.member_1) {
                                                                    phi_1379_ = type_8((_e1235.member + 1u), _e1235.member_1);
                                                                    phi_1402_ = type_8(1u, _e1235.member);
                                                                } else {
                                                                    phi_1379_ = _e1235;
                                                                    phi_1402_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1248 = phi_1379_;
                                                                let _e1250 = phi_1402_;
                                                                let _e1254 = (bitcast<i32>(_e1250.member) != 0i);
                                                                if _e1254 {
                                                                    let _e1255 = (_e1250.member_1 < 3u);
                                                                    if _e1255 {
                                                                    } else {
                                                                        phi_3915_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1257 = local_10[_e1250.member_1];
                                                                    if (_e1250.member_1 < 4u) {
                                                                    } else {
                                                                        phi_3915_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1260 = local_12[_e1250.member_1];
                                                                    switch bitcast<i32>(_e1175) {
                                                                        case 0: {
                                                                            phi_1472_ = (_e1260 + (f32(((_e1227 >> bitcast<u32>(((10u * _e1257) & 31u))) & 1023u)) * _e163));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1257 == 0u) {
                                                                                phi_1449_ = _e1227;
                                                                            } else {
                                                                                if (_e1257 == 1u) {
                                                                                    phi_1448_ = ((_e1227 >> bitcast<u32>(21i)) | (_e1233 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_1448_ = (_e1233 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1281 = phi_1448_;
                                                                                phi_1449_ = _e1281;
                                                                            }
                                                                            let _e1283 = phi_1449_;
                                                                            phi_1472_ = (_e1260 + (f32((_e1283 & 2097151u)) * _e163));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1262 = (_e1222 + _e1257);
                                                                            let _e1263 = (_e1262 < _e107);
                                                                            if _e1263 {
                                                                                if _e1263 {
                                                                                } else {
                                                                                    phi_3915_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1265 = global_10.member[_e1262];
                                                                                phi_1468_ = _e1265;
                                                                            } else {
                                                                                phi_1468_ = 0u;
                                                                            }
                                                                            let _e1267 = phi_1468_;
                                                                            phi_1472_ = (f32(bitcast<i32>(_e1267)) * _e163);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_1472_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1297 = phi_1472_;
                                                                    if (_e1216.member_1 < 3u) {
                                                                    } else {
                                                                        phi_3915_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1255 {
                                                                    } else {
                                                                        phi_3915_ = true;
                                                                        break;
                                                                    }
                                                                    local_11[_e1216.member_1][_e1250.member_1] = _e1297;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_1378_ = _e1248;
                                                                    phi_3915_ = _e1199;
                                                                    break if !(_e1254);
                                                                }
                                                            }
                                                            let _e1303 = phi_3915_;
                                                            phi_4000_ = _e1303;
                                                            if _e1303 {
                                                                break;
                                                            }
                                                            phi_4001_ = _e1303;
                                                        } else {
                                                            phi_4001_ = _e1199;
                                                        }
                                                        let _e1305 = phi_4001_;
                                                        continue;
                                                        continuing {
                                                            phi_3922_ = _e1305;
                                                            phi_1313_ = _e1214;
                                                            phi_4000_ = _e1305;
                                                            break if !(_e1220);
                                                        }
                                                    }
                                                    let _e1308 = phi_4000_;
                                                    phi_4002_ = _e1308;
                                                    if _e1308 {
                                                        break;
                                                    }
                                                    let _e1309 = local_11;
                                                    let _e1325 = (_e1309[0][2] - _e482);
                                                    let _e1328 = (((_e1309[0][0] - _e409) * _e506) - (_e1325 * _e434));
                                                    let _e1331 = (((_e1309[0][1] - _e446) * _e506) - (_e1325 * _e470));
                                                    let _e1334 = (_e1309[1][2] - _e482);
                                                    let _e1337 = (((_e1309[1][0] - _e409) * _e506) - (_e1334 * _e434));
                                                    let _e1340 = (((_e1309[1][1] - _e446) * _e506) - (_e1334 * _e470));
                                                    let _e1343 = (_e1309[2][2] - _e482);
                                                    let _e1346 = (((_e1309[2][0] - _e409) * _e506) - (_e1343 * _e434));
                                                    let _e1349 = (((_e1309[2][1] - _e446) * _e506) - (_e1343 * _e470));
                                                    let _e1350 = (_e1346 * _e1340);
                                                    let _e1351 = (_e1349 * _e1337);
                                                    let _e1352 = (_e1328 * _e1349);
                                                    let _e1353 = (_e1331 * _e1346);
                                                    let _e1354 = (_e1337 * _e1331);
                                                    let _e1355 = (_e1340 * _e1328);
                                                    let _e1360 = (((_e1350 >= _e1351) && (_e1352 >= _e1353)) && (_e1354 >= _e1355));
                                                    if (_e1360 || (((_e1350 <= _e1351) && (_e1352 <= _e1353)) && (_e1354 <= _e1355))) {
                                                        let _e1367 = select(-1f, 1f, _e1360);
                                                        let _e1369 = ((_e1350 - _e1351) * _e1367);
                                                        let _e1371 = select(0f, _e1369, (_e1369 > 0f));
                                                        let _e1373 = ((_e1352 - _e1353) * _e1367);
                                                        let _e1375 = select(0f, _e1373, (_e1373 > 0f));
                                                        let _e1377 = ((_e1354 - _e1355) * _e1367);
                                                        let _e1379 = select(0f, _e1377, (_e1377 > 0f));
                                                        let _e1381 = ((_e1371 + _e1375) + _e1379);
                                                        if (_e1381 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2067_ = type_25();
                                                            phi_2068_ = true;
                                                        } else {
                                                            let _e1384 = select(_e1309[1][0], _e1309[0][0], (_e1309[0][0] < _e1309[1][0]));
                                                            let _e1388 = select(_e1309[1][0], _e1309[0][0], (_e1309[0][0] > _e1309[1][0]));
                                                            let _e1392 = select(_e1309[1][1], _e1309[0][1], (_e1309[0][1] < _e1309[1][1]));
                                                            let _e1396 = select(_e1309[1][1], _e1309[0][1], (_e1309[0][1] > _e1309[1][1]));
                                                            let _e1400 = select(_e1309[1][2], _e1309[0][2], (_e1309[0][2] < _e1309[1][2]));
                                                            let _e1404 = select(_e1309[1][2], _e1309[0][2], (_e1309[0][2] > _e1309[1][2]));
                                                            let _e1409 = ((select(_e1309[2][0], _e1384, (_e1384 < _e1309[2][0])) - _e432) * _e437);
                                                            let _e1410 = ((select(_e1309[2][0], _e1388, (_e1388 > _e1309[2][0])) - _e433) * _e437);
                                                            let _e1413 = ((select(_e1309[2][1], _e1392, (_e1392 < _e1309[2][1])) - _e468) * _e473);
                                                            let _e1414 = ((select(_e1309[2][1], _e1396, (_e1396 > _e1309[2][1])) - _e469) * _e473);
                                                            let _e1417 = ((select(_e1309[2][2], _e1400, (_e1400 < _e1309[2][2])) - _e504) * _e509);
                                                            let _e1418 = ((select(_e1309[2][2], _e1404, (_e1404 > _e1309[2][2])) - _e505) * _e509);
                                                            let _e1420 = select(_e1418, _e1417, (_e1417 < _e1418));
                                                            let _e1422 = select(_e1418, _e1417, (_e1417 > _e1418));
                                                            let _e1424 = select(_e1410, _e1409, (_e1409 < _e1410));
                                                            let _e1426 = select(_e1414, _e1413, (_e1413 < _e1414));
                                                            let _e1428 = select(_e1426, _e1424, (_e1424 > _e1426));
                                                            let _e1430 = select(_e1420, _e1428, (_e1428 > _e1420));
                                                            let _e1432 = select(_e1410, _e1409, (_e1409 > _e1410));
                                                            let _e1434 = select(_e1414, _e1413, (_e1413 > _e1414));
                                                            let _e1436 = select(_e1434, _e1432, (_e1432 < _e1434));
                                                            let _e1438 = select(_e1422, _e1436, (_e1436 < _e1422));
                                                            let _e1439 = -(_e1420);
                                                            let _e1445 = select(_e555, _e1430, (_e1430 > _e555));
                                                            if (_e1445 > (_e1438 + (select(_e1439, _e1422, (_e1422 > _e1439)) * 0.0000019073523f))) {
                                                                phi_2062_ = type_25();
                                                                phi_2063_ = true;
                                                            } else {
                                                                let _e1447 = (_e1445 > _e1109.member);
                                                                if _e1447 {
                                                                    phi_2061_ = type_25();
                                                                } else {
                                                                    let _e1451 = (_e1309[1][0] - _e1309[0][0]);
                                                                    let _e1452 = (_e1309[1][1] - _e1309[0][1]);
                                                                    let _e1453 = (_e1309[1][2] - _e1309[0][2]);
                                                                    let _e1454 = vec3<f32>(_e1451, _e1452, _e1453);
                                                                    let _e1455 = (_e1309[2][0] - _e1309[1][0]);
                                                                    let _e1456 = (_e1309[2][1] - _e1309[1][1]);
                                                                    let _e1457 = (_e1309[2][2] - _e1309[1][2]);
                                                                    let _e1458 = vec3<f32>(_e1455, _e1456, _e1457);
                                                                    let _e1459 = (_e1309[0][0] - _e1309[2][0]);
                                                                    let _e1460 = (_e1309[0][1] - _e1309[2][1]);
                                                                    let _e1461 = (_e1309[0][2] - _e1309[2][2]);
                                                                    let _e1462 = vec3<f32>(_e1459, _e1460, _e1461);
                                                                    let _e1465 = bitcast<f32>((bitcast<u32>(_e1451) & 2147483647u));
                                                                    let _e1468 = bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u));
                                                                    let _e1470 = select(_e1468, _e1465, (_e1465 > _e1468));
                                                                    let _e1473 = bitcast<f32>((bitcast<u32>(_e1453) & 2147483647u));
                                                                    let _e1475 = select(_e1473, _e1470, (_e1470 > _e1473));
                                                                    let _e1478 = bitcast<f32>((bitcast<u32>(_e1455) & 2147483647u));
                                                                    let _e1481 = bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u));
                                                                    let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                                    let _e1486 = bitcast<f32>((bitcast<u32>(_e1457) & 2147483647u));
                                                                    let _e1488 = select(_e1486, _e1483, (_e1483 > _e1486));
                                                                    let _e1491 = bitcast<f32>((bitcast<u32>(_e1459) & 2147483647u));
                                                                    let _e1494 = bitcast<f32>((bitcast<u32>(_e1460) & 2147483647u));
                                                                    let _e1496 = select(_e1494, _e1491, (_e1491 > _e1494));
                                                                    let _e1499 = bitcast<f32>((bitcast<u32>(_e1461) & 2147483647u));
                                                                    let _e1501 = select(_e1499, _e1496, (_e1496 > _e1499));
                                                                    let _e1503 = select(_e1488, _e1475, (_e1475 > _e1488));
                                                                    let _e1505 = select(_e1501, _e1503, (_e1503 > _e1501));
                                                                    if (_e1475 == _e1505) {
                                                                        phi_1972_ = _e1458;
                                                                        phi_1973_ = _e1462;
                                                                    } else {
                                                                        let _e1508 = vec3((_e1488 == _e1505));
                                                                        phi_1972_ = select(_e1454, _e1462, _e1508);
                                                                        phi_1973_ = select(_e1458, _e1454, _e1508);
                                                                    }
                                                                    let _e1512 = phi_1972_;
                                                                    let _e1514 = phi_1973_;
                                                                    let _e1521 = ((_e1512.y * _e1514.z) - (_e1514.y * _e1512.z));
                                                                    let _e1526 = ((_e1512.z * _e1514.x) - (_e1514.z * _e1512.x));
                                                                    let _e1529 = ((_e1512.x * _e1514.y) - (_e1514.x * _e1512.y));
                                                                    if (_e1371 >= _e1375) {
                                                                        phi_2004_ = select(true, false, (_e1371 >= _e1379));
                                                                    } else {
                                                                        phi_2004_ = true;
                                                                    }
                                                                    let _e1534 = phi_2004_;
                                                                    if _e1534 {
                                                                        phi_2013_ = select(vec3<f32>(_e1309[2][0], _e1309[2][1], _e1309[2][2]), vec3<f32>(_e1309[1][0], _e1309[1][1], _e1309[1][2]), vec3((_e1375 >= _e1379)));
                                                                    } else {
                                                                        phi_2013_ = vec3<f32>(_e1309[0][0], _e1309[0][1], _e1309[0][2]);
                                                                    }
                                                                    let _e1539 = phi_2013_;
                                                                    let _e1556 = ((((_e1521 * (_e1539.x - _e409)) + (_e1526 * (_e1539.y - _e446))) + (_e1529 * (_e1539.z - _e482))) / (((_e1521 * _e434) + (_e1526 * _e470)) + (_e1529 * _e506)));
                                                                    let _e1558 = select(_e1438, _e1556, (_e1556 < _e1438));
                                                                    let _e1560 = select(_e1430, _e1558, (_e1558 > _e1430));
                                                                    if (_e1560 >= _e555) {
                                                                        let _e1562 = (_e1560 <= _e1109.member);
                                                                        if _e1562 {
                                                                            let _e1563 = (1f / _e1381);
                                                                            phi_2053_ = type_25(_e1560, (_e1375 * _e1563), (_e1379 * _e1563), _e1169);
                                                                        } else {
                                                                            phi_2053_ = type_25();
                                                                        }
                                                                        let _e1568 = phi_2053_;
                                                                        phi_2055_ = _e1568;
                                                                        phi_2056_ = select(true, false, _e1562);
                                                                    } else {
                                                                        phi_2055_ = type_25();
                                                                        phi_2056_ = true;
                                                                    }
                                                                    let _e1571 = phi_2055_;
                                                                    let _e1573 = phi_2056_;
                                                                    if _e1573 {
                                                                        phi_2060_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2060_ = _e1571;
                                                                    }
                                                                    let _e1575 = phi_2060_;
                                                                    phi_2061_ = _e1575;
                                                                }
                                                                let _e1577 = phi_2061_;
                                                                phi_2062_ = _e1577;
                                                                phi_2063_ = _e1447;
                                                            }
                                                            let _e1579 = phi_2062_;
                                                            let _e1581 = phi_2063_;
                                                            phi_2067_ = _e1579;
                                                            phi_2068_ = _e1581;
                                                        }
                                                        let _e1583 = phi_2067_;
                                                        let _e1585 = phi_2068_;
                                                        phi_2072_ = _e1583;
                                                        phi_2073_ = _e1585;
                                                    } else {
                                                        phi_2072_ = type_25();
                                                        phi_2073_ = true;
                                                    }
                                                    let _e1587 = phi_2072_;
                                                    let _e1589 = phi_2073_;
                                                    if _e1589 {
                                                        phi_2077_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2077_ = _e1587;
                                                    }
                                                    let _e1591 = phi_2077_;
                                                    if (_e1591.member_3 != 4294967295u) {
                                                        if (_e1169 == _e172) {
                                                            phi_2406_ = false;
                                                        } else {
                                                            let _e1595 = (_e1169 < arrayLength((&global_6.member)));
                                                            if _e1595 {
                                                                if _e1595 {
                                                                } else {
                                                                    phi_4002_ = true;
                                                                    break;
                                                                }
                                                                let _e1597 = global_6.member[_e1169];
                                                                phi_2100_ = _e1597;
                                                            } else {
                                                                phi_2100_ = 4294967295u;
                                                            }
                                                            let _e1599 = phi_2100_;
                                                            let _e1600 = (_e1599 < arrayLength((&global_7.member)));
                                                            if _e1600 {
                                                                if _e1600 {
                                                                } else {
                                                                    phi_4002_ = true;
                                                                    break;
                                                                }
                                                                let _e1602 = global_7.member[_e1599];
                                                                phi_2114_ = _e1602;
                                                            } else {
                                                                phi_2114_ = 0i;
                                                            }
                                                            let _e1604 = phi_2114_;
                                                            let _e1605 = (_e1604 == 0i);
                                                            if _e1605 {
                                                                phi_2405_ = true;
                                                            } else {
                                                                if _e401 {
                                                                    phi_2135_ = vec3<f32>(_e1309[0][0], _e1309[0][1], _e1309[0][2]);
                                                                } else {
                                                                    if (_e377 == 1u) {
                                                                        phi_2134_ = vec3<f32>(_e1309[0][2], _e1309[0][0], _e1309[0][1]);
                                                                    } else {
                                                                        phi_2134_ = vec3<f32>(_e1309[0][1], _e1309[0][2], _e1309[0][0]);
                                                                    }
                                                                    let _e1610 = phi_2134_;
                                                                    phi_2135_ = _e1610;
                                                                }
                                                                let _e1613 = phi_2135_;
                                                                if _e401 {
                                                                    phi_2152_ = vec3<f32>(_e1309[1][0], _e1309[1][1], _e1309[1][2]);
                                                                } else {
                                                                    if (_e377 == 1u) {
                                                                        phi_2151_ = vec3<f32>(_e1309[1][2], _e1309[1][0], _e1309[1][1]);
                                                                    } else {
                                                                        phi_2151_ = vec3<f32>(_e1309[1][1], _e1309[1][2], _e1309[1][0]);
                                                                    }
                                                                    let _e1618 = phi_2151_;
                                                                    phi_2152_ = _e1618;
                                                                }
                                                                let _e1621 = phi_2152_;
                                                                if _e401 {
                                                                    phi_2169_ = vec3<f32>(_e1309[2][0], _e1309[2][1], _e1309[2][2]);
                                                                } else {
                                                                    if (_e377 == 1u) {
                                                                        phi_2168_ = vec3<f32>(_e1309[2][2], _e1309[2][0], _e1309[2][1]);
                                                                    } else {
                                                                        phi_2168_ = vec3<f32>(_e1309[2][1], _e1309[2][2], _e1309[2][0]);
                                                                    }
                                                                    let _e1626 = phi_2168_;
                                                                    phi_2169_ = _e1626;
                                                                }
                                                                let _e1629 = phi_2169_;
                                                                let _e1632 = (_e1621.x - _e1613.x);
                                                                let _e1635 = (_e1621.y - _e1613.y);
                                                                let _e1638 = (_e1621.z - _e1613.z);
                                                                let _e1640 = (_e1629.x - _e1613.x);
                                                                let _e1642 = (_e1629.y - _e1613.y);
                                                                let _e1644 = (_e1629.z - _e1613.z);
                                                                if (_e244.member_1 == 1u) {
                                                                    phi_2205_ = (vec3<f32>(_e244.member[0], _e244.member[1], _e244.member[2]) - _e1613);
                                                                } else {
                                                                    phi_2205_ = vec3<f32>(_e244.member[0], _e244.member[1], _e244.member[2]);
                                                                }
                                                                let _e1659 = phi_2205_;
                                                                let _e1665 = bitcast<f32>((bitcast<u32>((_e1632 * _e1642)) ^ _e244.member_3[0]));
                                                                let _e1669 = bitcast<f32>((bitcast<u32>((_e1635 * _e1640)) ^ _e244.member_3[0]));
                                                                let _e1673 = bitcast<f32>((bitcast<u32>((_e1635 * _e1644)) ^ _e244.member_3[0]));
                                                                let _e1677 = bitcast<f32>((bitcast<u32>((_e1638 * _e1642)) ^ _e244.member_3[0]));
                                                                let _e1681 = bitcast<f32>((bitcast<u32>((_e1638 * _e1640)) ^ _e244.member_3[0]));
                                                                let _e1685 = bitcast<f32>((bitcast<u32>((_e1632 * _e1644)) ^ _e244.member_3[0]));
                                                                let _e1686 = (_e1673 - _e1677);
                                                                let _e1687 = (_e1681 - _e1685);
                                                                let _e1688 = (_e1665 - _e1669);
                                                                let _e1712 = (bitcast<f32>((bitcast<u32>(_e1673) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1677) & 2147483647u)));
                                                                let _e1719 = (bitcast<f32>((bitcast<u32>(_e1681) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1685) & 2147483647u)));
                                                                let _e1726 = (bitcast<f32>((bitcast<u32>(_e1665) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1669) & 2147483647u)));
                                                                if (_e244.member_2 == 0f) {
                                                                    phi_2387_ = 0f;
                                                                } else {
                                                                    let _e1756 = bitcast<f32>((bitcast<u32>(_e1686) & 2147483647u));
                                                                    let _e1759 = bitcast<f32>((bitcast<u32>(_e1687) & 2147483647u));
                                                                    let _e1762 = bitcast<f32>((bitcast<u32>(_e1688) & 2147483647u));
                                                                    let _e1764 = select(_e1762, _e1759, (_e1759 > _e1762));
                                                                    let _e1768 = select(_e1762, _e1759, (_e1759 < _e1762));
                                                                    let _e1772 = select(_e1759, _e1756, (_e1756 < _e1759));
                                                                    let _e1774 = select(_e1759, _e1756, (_e1756 > _e1759));
                                                                    let _e1776 = select(_e1762, _e1774, (_e1774 < _e1762));
                                                                    phi_2387_ = bitcast<f32>((bitcast<u32>((_e244.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1764, _e1756, (_e1756 > _e1764)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1776, _e1772, (_e1772 > _e1776)))) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1768, _e1756, (_e1756 < _e1768)))) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1712 + _e1719) + _e1726))) ^ _e244.member_3[0]))) * 1.0000005f)) ^ _e244.member_3[0])))) ^ _e244.member_3[0]));
                                                                }
                                                                let _e1803 = phi_2387_;
                                                                phi_2405_ = (_e1605 || !(((((bitcast<f32>((bitcast<u32>((_e1659.x * _e1686)) ^ _e244.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1659.y * _e1687)) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1659.z * _e1688)) ^ _e244.member_3[0]))) * f32(-(_e1604))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1659.x) & 2147483647u)) * _e1712)) ^ _e244.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1659.y) & 2147483647u)) * _e1719)) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1659.z) & 2147483647u)) * _e1726)) ^ _e244.member_3[0]))))) ^ _e244.member_3[0])) + _e1803) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1817 = phi_2405_;
                                                            phi_2406_ = _e1817;
                                                        }
                                                        let _e1819 = phi_2406_;
                                                        if _e1819 {
                                                            phi_2411_ = type_46(_e1109.member, true);
                                                        } else {
                                                            phi_2411_ = _e1109;
                                                        }
                                                        let _e1824 = phi_2411_;
                                                        phi_2412_ = _e1824;
                                                    } else {
                                                        phi_2412_ = _e1109;
                                                    }
                                                    let _e1826 = phi_2412_;
                                                    phi_4003_ = _e1308;
                                                    phi_1146_ = _e1826;
                                                } else {
                                                    phi_4003_ = _e1107;
                                                    phi_1146_ = type_46();
                                                }
                                                let _e1828 = phi_4003_;
                                                let _e1830 = phi_1146_;
                                                continue;
                                                continuing {
                                                    phi_3937_ = _e1828;
                                                    phi_1145_ = _e1830;
                                                    phi_1148_ = _e1124;
                                                    phi_4002_ = _e1828;
                                                    break if !(_e1130);
                                                }
                                            }
                                            let _e1833 = phi_4002_;
                                            phi_4078_ = _e1833;
                                            if _e1833 {
                                                break;
                                            }
                                            let _e1835 = local_13;
                                            phi_4082_ = _e1833;
                                            let _e2047 = local_15;
                                            phi_3653_ = _e2047;
                                            phi_3654_ = _e638;
                                            phi_3655_ = false;
                                            phi_3656_ = select(_e642, 0u, _e1835.member_1);
                                        } else {
                                            if (_e638.member_1 >= _e104) {
                                                phi_3209_ = type_62(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e638.member_1 < _e104) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e655 = ((1u + _e377) % 4u);
                                                if (_e655 < 4u) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e660 = global_5.member[_e638.member_1][_e655];
                                                let _e662 = (_e660 >> bitcast<u32>(11u));
                                                let _e664 = ((1u + _e376) % 4u);
                                                if (_e664 < 4u) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e669 = global_5.member[_e638.member_1][_e664];
                                                let _e671 = (_e669 >> bitcast<u32>(11u));
                                                let _e673 = ((1u + _e378) % 4u);
                                                if (_e673 < 4u) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e678 = global_5.member[_e638.member_1][_e673];
                                                let _e680 = (_e678 >> bitcast<u32>(11u));
                                                let _e703 = (bitcast<f32>((bitcast<u32>((_e638.member.member_1.x - _e638.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e704 = (bitcast<f32>((bitcast<u32>((_e638.member.member_1.y - _e638.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e705 = (bitcast<f32>((bitcast<u32>((_e638.member.member_1.z - _e638.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e707 = select(_e163, _e703, (_e703 > _e163));
                                                let _e709 = select(_e163, _e704, (_e704 > _e163));
                                                let _e711 = select(_e163, _e705, (_e705 > _e163));
                                                let _e736 = bitcast<u32>((f32(bitcast<i32>((_e660 & 1023u))) * _e707));
                                                let _e741 = (bitcast<i32>((_e660 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e744 = bitcast<f32>((_e736 & bitcast<u32>(_e741)));
                                                let _e745 = bitcast<u32>((f32(bitcast<i32>((_e669 & 1023u))) * _e709));
                                                let _e750 = (bitcast<i32>((_e669 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e753 = bitcast<f32>((_e745 & bitcast<u32>(_e750)));
                                                let _e754 = bitcast<u32>((f32(bitcast<i32>((_e678 & 1023u))) * _e711));
                                                let _e759 = (bitcast<i32>((_e678 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e762 = bitcast<f32>((_e754 & bitcast<u32>(_e759)));
                                                let _e766 = bitcast<f32>((_e736 & bitcast<u32>(~(_e741))));
                                                let _e770 = bitcast<f32>((_e745 & bitcast<u32>(~(_e750))));
                                                let _e774 = bitcast<f32>((_e754 & bitcast<u32>(~(_e759))));
                                                let _e775 = bitcast<u32>((f32(bitcast<i32>((_e662 & 1023u))) * _e707));
                                                let _e780 = (bitcast<i32>((_e662 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e783 = bitcast<f32>((_e775 & bitcast<u32>(_e780)));
                                                let _e784 = bitcast<u32>((f32(bitcast<i32>((_e671 & 1023u))) * _e709));
                                                let _e789 = (bitcast<i32>((_e671 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e792 = bitcast<f32>((_e784 & bitcast<u32>(_e789)));
                                                let _e793 = bitcast<u32>((f32(bitcast<i32>((_e680 & 1023u))) * _e711));
                                                let _e798 = (bitcast<i32>((_e680 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e801 = bitcast<f32>((_e793 & bitcast<u32>(_e798)));
                                                let _e805 = bitcast<f32>((_e775 & bitcast<u32>(~(_e780))));
                                                let _e809 = bitcast<f32>((_e784 & bitcast<u32>(~(_e789))));
                                                let _e813 = bitcast<f32>((_e793 & bitcast<u32>(~(_e798))));
                                                let _e814 = (_e638.member.member.x + _e744);
                                                let _e815 = (_e638.member.member.y + _e753);
                                                let _e816 = (_e638.member.member.z + _e762);
                                                let _e819 = (_e638.member.member_1.x - _e783);
                                                let _e820 = (_e638.member.member_1.y - _e792);
                                                let _e821 = (_e638.member.member_1.z - _e801);
                                                let _e840 = (_e819 - _e814);
                                                let _e841 = (_e820 - _e815);
                                                let _e842 = (_e821 - _e816);
                                                let _e844 = select(_e841, _e840, (_e840 > _e841));
                                                let _e846 = select(_e842, _e844, (_e844 > _e842));
                                                if (_e846 < (1024f * _e163)) {
                                                    phi_2910_ = 0u;
                                                } else {
                                                    phi_2910_ = select(2u, 1u, (_e846 < (2097152f * _e163)));
                                                }
                                                let _e853 = phi_2910_;
                                                switch bitcast<i32>(_e853) {
                                                    case 0: {
                                                        phi_2916_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2916_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2916_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2916_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e856 = phi_2916_;
                                                let _e862 = global_5.member[_e638.member_1][0u];
                                                let _e866 = global_5.member[_e638.member_1][1u];
                                                let _e870 = global_5.member[_e638.member_1][2u];
                                                let _e874 = global_5.member[_e638.member_1][3u];
                                                let _e886 = (((_e866 >> bitcast<u32>(22i)) | ((_e870 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e874 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e887 = (_e862 & 268435455u);
                                                let _e888 = (_e886 & 268435455u);
                                                let _e891 = ((_e862 >> bitcast<u32>(28u)) & 7u);
                                                let _e899 = ((_e862 >> bitcast<u32>(31i)) | (((_e886 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e900 = (_e891 != 0u);
                                                if (_e891 == 0u) {
                                                    phi_3171_ = _e887;
                                                } else {
                                                    if (_e891 == 7u) {
                                                        phi_3170_ = 2147483648u;
                                                    } else {
                                                        phi_3170_ = ((2147483648u | (_e891 << bitcast<u32>(28u))) | (_e888 & 268435455u));
                                                    }
                                                    let _e909 = phi_3170_;
                                                    phi_3171_ = _e909;
                                                }
                                                let _e911 = phi_3171_;
                                                if _e900 {
                                                    let _e912 = (_e891 != 7u);
                                                    if _e912 {
                                                        phi_3181_ = (_e888 + (_e891 * ((3u * _e856) + 1u)));
                                                    } else {
                                                        phi_3181_ = u32();
                                                    }
                                                    let _e916 = phi_3181_;
                                                    phi_3183_ = _e916;
                                                    phi_3184_ = select(true, false, _e912);
                                                } else {
                                                    phi_3183_ = u32();
                                                    phi_3184_ = true;
                                                }
                                                let _e919 = phi_3183_;
                                                let _e921 = phi_3184_;
                                                if (_e899 == 0u) {
                                                    phi_3205_ = (_e887 + select(0u, 1u, !(_e900)));
                                                } else {
                                                    if (_e899 == 7u) {
                                                        phi_3204_ = 2147483648u;
                                                    } else {
                                                        phi_3204_ = ((2147483648u | (_e899 << bitcast<u32>(28u))) | (select(_e919, _e888, _e921) & 268435455u));
                                                    }
                                                    let _e934 = phi_3204_;
                                                    phi_3205_ = _e934;
                                                }
                                                let _e936 = phi_3205_;
                                                phi_3209_ = type_62(array<vec4<f32>, 3>(vec4<f32>(_e814, (_e638.member.member.x + _e766), _e819, (_e638.member.member_1.x - _e805)), vec4<f32>(_e815, (_e638.member.member.y + _e770), _e820, (_e638.member.member_1.y - _e809)), vec4<f32>(_e816, (_e638.member.member.z + _e774), _e821, (_e638.member.member_1.z - _e813))), type_61(type_34((_e638.member.member + vec4<f32>(_e744, _e753, _e762, 0f)), (_e638.member.member_1 - vec4<f32>(_e783, _e792, _e801, 0f))), _e911), type_61(type_34((_e638.member.member + vec4<f32>(_e766, _e770, _e774, 0f)), (_e638.member.member_1 - vec4<f32>(_e805, _e809, _e813, 0f))), _e936));
                                            }
                                            let _e941 = phi_3209_;
                                            let _e953 = ((_e941.member[0].x - _e432) * _e437);
                                            let _e954 = ((_e941.member[0].y - _e432) * _e437);
                                            let _e955 = ((_e941.member[0].z - _e433) * _e437);
                                            let _e956 = ((_e941.member[0].w - _e433) * _e437);
                                            let _e966 = ((_e941.member[1].x - _e468) * _e473);
                                            let _e967 = ((_e941.member[1].y - _e468) * _e473);
                                            let _e968 = ((_e941.member[1].z - _e469) * _e473);
                                            let _e969 = ((_e941.member[1].w - _e469) * _e473);
                                            let _e979 = ((_e941.member[2].x - _e504) * _e509);
                                            let _e980 = ((_e941.member[2].y - _e504) * _e509);
                                            let _e981 = ((_e941.member[2].z - _e505) * _e509);
                                            let _e982 = ((_e941.member[2].w - _e505) * _e509);
                                            let _e984 = select(_e981, _e979, (_e979 < _e981));
                                            let _e986 = select(_e982, _e980, (_e980 < _e982));
                                            let _e988 = select(_e981, _e979, (_e979 > _e981));
                                            let _e990 = select(_e982, _e980, (_e980 > _e982));
                                            let _e992 = select(_e955, _e953, (_e953 < _e955));
                                            let _e994 = select(_e956, _e954, (_e954 < _e956));
                                            let _e996 = select(_e968, _e966, (_e966 < _e968));
                                            let _e998 = select(_e969, _e967, (_e967 < _e969));
                                            let _e1000 = select(_e996, _e992, (_e992 > _e996));
                                            let _e1002 = select(_e998, _e994, (_e994 > _e998));
                                            let _e1004 = select(_e984, _e1000, (_e1000 > _e984));
                                            let _e1006 = select(_e986, _e1002, (_e1002 > _e986));
                                            let _e1008 = select(_e955, _e953, (_e953 > _e955));
                                            let _e1010 = select(_e956, _e954, (_e954 > _e956));
                                            let _e1012 = select(_e968, _e966, (_e966 > _e968));
                                            let _e1014 = select(_e969, _e967, (_e967 > _e969));
                                            let _e1016 = select(_e1012, _e1008, (_e1008 < _e1012));
                                            let _e1018 = select(_e1014, _e1010, (_e1010 < _e1014));
                                            let _e1023 = -(_e984);
                                            let _e1024 = -(_e986);
                                            let _e1031 = (select(_e988, _e1016, (_e1016 < _e988)) + (select(_e1023, _e988, (_e988 > _e1023)) * 0.0000019073523f));
                                            let _e1032 = (select(_e990, _e1018, (_e1018 < _e990)) + (select(_e1024, _e990, (_e990 > _e1024)) * 0.0000019073523f));
                                            let _e1034 = select(_e555, _e1004, (_e1004 > _e555));
                                            let _e1036 = select(_e555, _e1006, (_e1006 > _e555));
                                            let _e1041 = (_e1034 <= select(_e599.member, _e1031, (_e1031 < _e599.member)));
                                            let _e1042 = (_e1036 <= select(_e599.member, _e1032, (_e1032 < _e599.member)));
                                            let _e1043 = (_e1034 <= _e1036);
                                            if _e1041 {
                                                if _e1042 {
                                                    if _e1043 {
                                                        phi_3553_ = _e941.member_2;
                                                    } else {
                                                        phi_3553_ = _e941.member_1;
                                                    }
                                                    let _e1047 = phi_3553_;
                                                    let _e1069 = (_e642 % 128u);
                                                    let _e1070 = (_e1069 < 128u);
                                                    if _e1070 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1069] = _e1047.member_1;
                                                    if _e1070 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1069] = _e1047.member.member.x;
                                                    if _e1070 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1069] = _e1047.member.member.y;
                                                    if _e1070 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1069] = _e1047.member.member.z;
                                                    if _e1070 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1069] = _e1047.member.member_1.x;
                                                    if _e1070 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1069] = _e1047.member.member_1.y;
                                                    if _e1070 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1069] = _e1047.member.member_1.z;
                                                    if _e1070 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1069] = select(_e1036, _e1034, (_e1034 > _e1036));
                                                    if _e1043 {
                                                        phi_3630_ = _e941.member_1;
                                                    } else {
                                                        phi_3630_ = _e941.member_2;
                                                    }
                                                    let _e1083 = phi_3630_;
                                                    phi_3631_ = _e1083;
                                                    phi_3632_ = (_e642 + 1u);
                                                } else {
                                                    phi_3631_ = type_61();
                                                    phi_3632_ = u32();
                                                }
                                                let _e1085 = phi_3631_;
                                                let _e1087 = phi_3632_;
                                                phi_3634_ = _e1085;
                                                phi_3635_ = _e1087;
                                                phi_3636_ = select(true, false, _e1042);
                                            } else {
                                                phi_3634_ = type_61();
                                                phi_3635_ = u32();
                                                phi_3636_ = true;
                                            }
                                            let _e1090 = phi_3634_;
                                            let _e1092 = phi_3635_;
                                            let _e1094 = phi_3636_;
                                            if _e1094 {
                                                if _e1041 {
                                                    phi_3645_ = _e941.member_1;
                                                } else {
                                                    phi_3645_ = _e941.member_2;
                                                }
                                                let _e1098 = phi_3645_;
                                                phi_3650_ = _e1098;
                                                phi_3651_ = select(_e1042, true, _e1041);
                                            } else {
                                                phi_3650_ = _e1090;
                                                phi_3651_ = _e640;
                                            }
                                            let _e1101 = phi_3650_;
                                            let _e1103 = phi_3651_;
                                            phi_4082_ = _e597;
                                            phi_3653_ = _e599;
                                            phi_3654_ = _e1101;
                                            phi_3655_ = _e1103;
                                            phi_3656_ = select(_e1092, _e642, _e1094);
                                        }
                                        let _e1839 = phi_4082_;
                                        let _e1841 = phi_3653_;
                                        let _e1843 = phi_3654_;
                                        let _e1845 = phi_3655_;
                                        let _e1847 = phi_3656_;
                                        phi_4081_ = _e1839;
                                        phi_3657_ = _e1841;
                                        phi_3658_ = _e1843;
                                        phi_3659_ = (_e603 - 1u);
                                        phi_3660_ = _e1845;
                                        phi_3661_ = _e1847;
                                    } else {
                                        phi_4081_ = _e597;
                                        phi_3657_ = _e599;
                                        phi_3658_ = _e638;
                                        phi_3659_ = _e603;
                                        phi_3660_ = _e640;
                                        phi_3661_ = _e642;
                                    }
                                    let _e1849 = phi_4081_;
                                    let _e1851 = phi_3657_;
                                    let _e1853 = phi_3658_;
                                    let _e1855 = phi_3659_;
                                    let _e1857 = phi_3660_;
                                    let _e1859 = phi_3661_;
                                    phi_4080_ = _e1849;
                                    phi_3662_ = _e1851;
                                    phi_3663_ = _e1853;
                                    phi_3664_ = _e1855;
                                    phi_3665_ = _e1857;
                                    phi_3666_ = _e1859;
                                } else {
                                    phi_4080_ = _e597;
                                    phi_3662_ = type_46();
                                    phi_3663_ = type_61();
                                    phi_3664_ = u32();
                                    phi_3665_ = bool();
                                    phi_3666_ = u32();
                                }
                                let _e1861 = phi_4080_;
                                let _e1863 = phi_3662_;
                                let _e1865 = phi_3663_;
                                let _e1867 = phi_3664_;
                                let _e1869 = phi_3665_;
                                let _e1871 = phi_3666_;
                                phi_4079_ = _e1861;
                                phi_1019_ = _e1863;
                                phi_1022_ = _e1865;
                                phi_1024_ = _e1867;
                                phi_1026_ = _e1869;
                                phi_1028_ = _e1871;
                                phi_3667_ = _e611;
                            } else {
                                phi_4079_ = _e597;
                                phi_1019_ = type_46();
                                phi_1022_ = type_61();
                                phi_1024_ = u32();
                                phi_1026_ = bool();
                                phi_1028_ = u32();
                                phi_3667_ = false;
                            }
                            let _e1873 = phi_4079_;
                            let _e1875 = phi_1019_;
                            let _e1877 = phi_1022_;
                            let _e1879 = phi_1024_;
                            let _e1881 = phi_1026_;
                            let _e1883 = phi_1028_;
                            let _e1885 = phi_3667_;
                            continue;
                            continuing {
                                phi_3940_ = _e1873;
                                phi_1018_ = _e1875;
                                phi_1021_ = _e1877;
                                phi_1023_ = _e1879;
                                phi_1025_ = _e1881;
                                phi_1027_ = _e1883;
                                phi_4078_ = _e1873;
                                break if !(_e1885);
                            }
                        }
                        let _e1888 = phi_4078_;
                        if _e1888 {
                            break;
                        }
                        let _e1890 = local_14;
                        if _e1890.member_1 {
                        } else {
                            if _e245 {
                            } else {
                                break;
                            }
                            let _e1894 = global_2.member[_e151];
                            if _e166 {
                            } else {
                                break;
                            }
                            let _e1898 = global_9.member[_e151].member_1;
                            if _e245 {
                            } else {
                                break;
                            }
                            global_2.member[_e151] = type_27(_e1894.member, _e1894.member_1, _e1894.member_2, array<f32, 3>((_e1894.member_3[0] + (_e1898[0] * _e1894.member_1[0])), (_e1894.member_3[1] + (_e1898[1] * _e1894.member_1[1])), (_e1894.member_3[2] + (_e1898[2] * _e1894.member_1[2]))), _e1894.member_4);
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
fn trace_shadows_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
