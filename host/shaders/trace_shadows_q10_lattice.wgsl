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
    var phi_342_: u32;
    var phi_386_: i32;
    var phi_410_: type_41;
    var phi_560_: i32;
    var phi_561_: i32;
    var phi_571_: bool;
    var phi_581_: u32;
    var phi_582_: u32;
    var phi_584_: bool;
    var phi_589_: u32;
    var phi_622_: i32;
    var phi_640_: f32;
    var phi_646_: f32;
    var phi_657_: f32;
    var phi_663_: f32;
    var phi_686_: f32;
    var phi_697_: f32;
    var phi_706_: f32;
    var phi_712_: f32;
    var phi_723_: f32;
    var phi_729_: f32;
    var phi_752_: f32;
    var phi_763_: f32;
    var phi_772_: f32;
    var phi_778_: f32;
    var phi_789_: f32;
    var phi_795_: f32;
    var phi_818_: f32;
    var phi_829_: f32;
    var phi_929_: f32;
    var phi_930_: f32;
    var phi_4083_: bool;
    var phi_1019_: type_46;
    var phi_1022_: type_61;
    var phi_1024_: u32;
    var phi_1026_: bool;
    var phi_1028_: u32;
    var phi_1039_: bool;
    var phi_1125_: type_61;
    var phi_1126_: bool;
    var phi_1127_: u32;
    var phi_3053_: u32;
    var phi_3059_: u32;
    var phi_3313_: u32;
    var phi_3314_: u32;
    var phi_3324_: u32;
    var phi_3326_: u32;
    var phi_3327_: bool;
    var phi_3347_: u32;
    var phi_3348_: u32;
    var phi_3352_: type_62;
    var phi_3696_: type_61;
    var phi_3773_: type_61;
    var phi_3774_: type_61;
    var phi_3775_: u32;
    var phi_3777_: type_61;
    var phi_3778_: u32;
    var phi_3779_: bool;
    var phi_3788_: type_61;
    var phi_3793_: type_61;
    var phi_3794_: bool;
    var phi_4080_: bool;
    var phi_1146_: type_46;
    var phi_1149_: type_8;
    var phi_1150_: type_8;
    var phi_1172_: type_8;
    var phi_1213_: u32;
    var phi_1219_: u32;
    var phi_1229_: u32;
    var phi_1245_: u32;
    var phi_1282_: u32;
    var phi_1288_: u32;
    var phi_1298_: u32;
    var phi_4065_: bool;
    var phi_1314_: type_8;
    var phi_1315_: type_8;
    var phi_1338_: type_8;
    var phi_1361_: u32;
    var phi_1376_: u32;
    var phi_1379_: type_8;
    var phi_1380_: type_8;
    var phi_1403_: type_8;
    var phi_1469_: u32;
    var phi_1449_: u32;
    var phi_1450_: u32;
    var phi_1473_: f32;
    var phi_4058_: bool;
    var phi_4144_: bool;
    var phi_4143_: bool;
    var phi_1973_: vec3<f32>;
    var phi_1974_: vec3<f32>;
    var phi_2005_: bool;
    var phi_2014_: vec3<f32>;
    var phi_2054_: type_25;
    var phi_2056_: type_25;
    var phi_2057_: bool;
    var phi_2061_: type_25;
    var phi_2062_: type_25;
    var phi_2063_: type_25;
    var phi_2064_: bool;
    var phi_2068_: type_25;
    var phi_2069_: bool;
    var phi_2073_: type_25;
    var phi_2074_: bool;
    var phi_2078_: type_25;
    var phi_2101_: u32;
    var phi_2115_: i32;
    var phi_2135_: vec3<f32>;
    var phi_2136_: vec3<f32>;
    var phi_2152_: vec3<f32>;
    var phi_2153_: vec3<f32>;
    var phi_2169_: vec3<f32>;
    var phi_2170_: vec3<f32>;
    var phi_2206_: vec3<f32>;
    var phi_2388_: f32;
    var phi_2406_: bool;
    var phi_2407_: bool;
    var phi_2412_: type_46;
    var phi_2413_: type_46;
    var phi_4146_: bool;
    var phi_1147_: type_46;
    var phi_4145_: bool;
    var local_13: type_46;
    var phi_4225_: bool;
    var phi_3796_: type_46;
    var phi_3797_: type_61;
    var phi_3798_: bool;
    var phi_3799_: u32;
    var phi_4224_: bool;
    var phi_3800_: type_46;
    var phi_3801_: type_61;
    var phi_3802_: u32;
    var phi_3803_: bool;
    var phi_3804_: u32;
    var phi_4223_: bool;
    var phi_3805_: type_46;
    var phi_3806_: type_61;
    var phi_3807_: u32;
    var phi_3808_: bool;
    var phi_3809_: u32;
    var phi_4222_: bool;
    var phi_1020_: type_46;
    var phi_1023_: type_61;
    var phi_1025_: u32;
    var phi_1027_: bool;
    var phi_1029_: u32;
    var phi_3810_: bool;
    var phi_4221_: bool;
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
                phi_342_ = _e170;
            } else {
                phi_342_ = 4294967295u;
            }
            let _e172 = phi_342_;
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
                phi_386_ = -126i;
            } else {
                phi_386_ = select(_e215, 127i, (_e215 > 127i));
            }
            let _e220 = phi_386_;
            let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
            let _e231 = bitcast<f32>((bitcast<u32>(((_e215 - _e220) + 127i)) << bitcast<u32>(23i)));
            if (_e191 == 0u) {
                phi_410_ = type_41(array<f32, 3>(_e208, _e209, _e210), _e191, _e212, _e213);
            } else {
                phi_410_ = type_41(array<f32, 3>(((_e208 * _e225) * _e231), ((_e209 * _e225) * _e231), ((_e210 * _e225) * _e231)), _e191, ((_e212 * _e225) * _e231), _e213);
            }
            let _e244 = phi_410_;
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
                                phi_560_ = (bitcast<i32>((_e342 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_560_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e342)), 32u, (_e342 == 0u))));
                            }
                            let _e356 = phi_560_;
                            phi_561_ = _e356;
                        } else {
                            phi_561_ = 0i;
                        }
                        let _e358 = phi_561_;
                        let _e359 = (_e278 == _e322);
                        if _e359 {
                            phi_571_ = true;
                        } else {
                            phi_571_ = (_e286 == _e322);
                        }
                        let _e362 = phi_571_;
                        let _e363 = select(1u, 0u, _e359);
                        if _e362 {
                            let _e364 = (_e363 + 1u);
                            phi_581_ = _e364;
                            phi_582_ = _e364;
                            phi_584_ = select(true, false, (_e364 == 2u));
                        } else {
                            phi_581_ = u32();
                            phi_582_ = 0u;
                            phi_584_ = true;
                        }
                        let _e368 = phi_581_;
                        let _e370 = phi_582_;
                        let _e372 = phi_584_;
                        if _e372 {
                            phi_589_ = (_e370 + 1u);
                        } else {
                            phi_589_ = 0u;
                        }
                        let _e376 = phi_589_;
                        let _e377 = select(_e368, _e370, _e372);
                        let _e378 = select(_e363, select(2u, _e363, _e362), _e372);
                        let _e379 = -(_e358);
                        if (_e379 < -126i) {
                            phi_622_ = -126i;
                        } else {
                            phi_622_ = select(_e379, 127i, (_e379 > 127i));
                        }
                        let _e384 = phi_622_;
                        let _e389 = bitcast<f32>((bitcast<u32>((_e384 + 127i)) << bitcast<u32>(23i)));
                        let _e395 = bitcast<f32>((bitcast<u32>(((_e379 - _e384) + 127i)) << bitcast<u32>(23i)));
                        let _e400 = global_9.member[_e151].member.member;
                        let _e401 = (_e377 == 0u);
                        if _e401 {
                            phi_640_ = _e400[0];
                        } else {
                            phi_640_ = _e400[1];
                        }
                        let _e405 = phi_640_;
                        let _e406 = (_e377 == 2u);
                        if _e406 {
                            phi_646_ = _e400[2];
                        } else {
                            phi_646_ = _e405;
                        }
                        let _e409 = phi_646_;
                        let _e410 = global_9.member[_e151].member.member_2;
                        if _e401 {
                            phi_657_ = _e410[0];
                        } else {
                            phi_657_ = _e410[1];
                        }
                        let _e414 = phi_657_;
                        if _e406 {
                            phi_663_ = _e410[2];
                        } else {
                            phi_663_ = _e414;
                        }
                        let _e417 = phi_663_;
                        let _e419 = ((_e417 * _e389) * _e395);
                        let _e423 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e423 {
                            let _e427 = (bitcast<f32>((bitcast<u32>(_e409) & 2147483647u)) * 0.00000011920929f);
                            phi_686_ = select(0.00000000000011368684f, _e427, (_e427 > 0.00000000000011368684f));
                        } else {
                            phi_686_ = 0f;
                        }
                        let _e431 = phi_686_;
                        let _e432 = (_e409 + _e431);
                        let _e433 = (_e409 - _e431);
                        let _e434 = select(_e419, 0f, _e423);
                        if _e423 {
                            phi_697_ = 38685626000000000000000000f;
                        } else {
                            phi_697_ = (1f / _e419);
                        }
                        let _e437 = phi_697_;
                        let _e438 = (_e376 == 0u);
                        if _e438 {
                            phi_706_ = _e400[0];
                        } else {
                            phi_706_ = _e400[1];
                        }
                        let _e442 = phi_706_;
                        let _e443 = (_e376 == 2u);
                        if _e443 {
                            phi_712_ = _e400[2];
                        } else {
                            phi_712_ = _e442;
                        }
                        let _e446 = phi_712_;
                        if _e438 {
                            phi_723_ = _e410[0];
                        } else {
                            phi_723_ = _e410[1];
                        }
                        let _e450 = phi_723_;
                        if _e443 {
                            phi_729_ = _e410[2];
                        } else {
                            phi_729_ = _e450;
                        }
                        let _e453 = phi_729_;
                        let _e455 = ((_e453 * _e389) * _e395);
                        let _e459 = (bitcast<f32>((bitcast<u32>(_e455) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e459 {
                            let _e463 = (bitcast<f32>((bitcast<u32>(_e446) & 2147483647u)) * 0.00000011920929f);
                            phi_752_ = select(0.00000000000011368684f, _e463, (_e463 > 0.00000000000011368684f));
                        } else {
                            phi_752_ = 0f;
                        }
                        let _e467 = phi_752_;
                        let _e468 = (_e446 + _e467);
                        let _e469 = (_e446 - _e467);
                        let _e470 = select(_e455, 0f, _e459);
                        if _e459 {
                            phi_763_ = 38685626000000000000000000f;
                        } else {
                            phi_763_ = (1f / _e455);
                        }
                        let _e473 = phi_763_;
                        let _e474 = (_e378 == 0u);
                        if _e474 {
                            phi_772_ = _e400[0];
                        } else {
                            phi_772_ = _e400[1];
                        }
                        let _e478 = phi_772_;
                        let _e479 = (_e378 == 2u);
                        if _e479 {
                            phi_778_ = _e400[2];
                        } else {
                            phi_778_ = _e478;
                        }
                        let _e482 = phi_778_;
                        if _e474 {
                            phi_789_ = _e410[0];
                        } else {
                            phi_789_ = _e410[1];
                        }
                        let _e486 = phi_789_;
                        if _e479 {
                            phi_795_ = _e410[2];
                        } else {
                            phi_795_ = _e486;
                        }
                        let _e489 = phi_795_;
                        let _e491 = ((_e489 * _e389) * _e395);
                        let _e495 = (bitcast<f32>((bitcast<u32>(_e491) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e495 {
                            let _e499 = (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) * 0.00000011920929f);
                            phi_818_ = select(0.00000000000011368684f, _e499, (_e499 > 0.00000000000011368684f));
                        } else {
                            phi_818_ = 0f;
                        }
                        let _e503 = phi_818_;
                        let _e504 = (_e482 + _e503);
                        let _e505 = (_e482 - _e503);
                        let _e506 = select(_e491, 0f, _e495);
                        if _e495 {
                            phi_829_ = 38685626000000000000000000f;
                        } else {
                            phi_829_ = (1f / _e491);
                        }
                        let _e509 = phi_829_;
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
                            phi_929_ = select(-340282350000000000000000000000000000000f, _e549, (_e549 > -340282350000000000000000000000000000000f));
                            phi_930_ = select(-340282350000000000000000000000000000000f, _e542, (_e542 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_929_ = 0f;
                            phi_930_ = 1f;
                        }
                        let _e553 = phi_929_;
                        let _e555 = phi_930_;
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
                        phi_4083_ = false;
                        phi_1019_ = type_46(_e553, false);
                        phi_1022_ = type_61(type_34(vec4<f32>((f32(_e562) * _e163), (f32(_e568) * _e163), (f32(_e574) * _e163), 0f), vec4<f32>((f32(_e579) * _e163), (f32(_e583) * _e163), (f32(_e587) * _e163), 0f)), select(0u, 2147483648u, (_e104 == 0u)));
                        phi_1024_ = ((3u * _e104) + 1u);
                        phi_1026_ = (_e555 <= _e553);
                        phi_1028_ = 0u;
                        loop {
                            let _e597 = phi_4083_;
                            let _e599 = phi_1019_;
                            let _e601 = phi_1022_;
                            let _e603 = phi_1024_;
                            let _e605 = phi_1026_;
                            let _e607 = phi_1028_;
                            local_14 = _e599;
                            if _e605 {
                                phi_1039_ = true;
                            } else {
                                phi_1039_ = (_e607 > 0u);
                            }
                            let _e610 = phi_1039_;
                            if _e610 {
                                let _e611 = (_e603 > 0u);
                                if _e611 {
                                    if _e605 {
                                        phi_1125_ = _e601;
                                        phi_1126_ = _e605;
                                        phi_1127_ = _e607;
                                    } else {
                                        let _e612 = (_e607 - 1u);
                                        let _e613 = (_e612 % 128u);
                                        let _e614 = (_e613 < 128u);
                                        if _e614 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e616 = local_7[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e618 = local_6[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e620 = local_5[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e622 = local_4[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e624 = local_3[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e626 = local_2[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e631 = local_8[_e613];
                                        if _e614 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e634 = local_9[_e613];
                                        phi_1125_ = type_61(type_34(vec4<f32>(_e616, _e618, _e620, 0f), vec4<f32>(_e622, _e624, _e626, 0f)), _e631);
                                        phi_1126_ = (_e634 <= _e599.member);
                                        phi_1127_ = _e612;
                                    }
                                    let _e638 = phi_1125_;
                                    let _e640 = phi_1126_;
                                    let _e642 = phi_1127_;
                                    if _e640 {
                                        let _e647 = (_e638.member_1 & 268435455u);
                                        if ((_e638.member_1 & 2147483648u) != 0u) {
                                            phi_4080_ = _e597;
                                            phi_1146_ = _e599;
                                            phi_1149_ = type_8(0u, ((_e638.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1128 = phi_4080_;
                                                let _e1130 = phi_1146_;
                                                let _e1132 = phi_1149_;
                                                local_13 = _e1130;
                                                local_15 = _e1130;
                                                if (_e1132.member < _e1132.member_1) {
                                                    phi_1150_ = type_8((_e1132.member + 1u), _e1132.member_1);
                                                    phi_1172_ = type_8(1u, _e1132.member);
                                                } else {
                                                    phi_1150_ = _e1132;
                                                    phi_1172_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1145 = phi_1150_;
                                                let _e1147 = phi_1172_;
                                                let _e1151 = (bitcast<i32>(_e1147.member) != 0i);
                                                if _e1151 {
                                                    let _e1156 = (_e638.member.member_1.x - _e638.member.member.x);
                                                    let _e1159 = (_e638.member.member_1.y - _e638.member.member.y);
                                                    let _e1162 = (_e638.member.member_1.z - _e638.member.member.z);
                                                    let _e1164 = select(_e1159, _e1156, (_e1156 > _e1159));
                                                    let _e1166 = select(_e1162, _e1164, (_e1164 > _e1162));
                                                    let _e1168 = (_e1166 < (1024f * _e163));
                                                    if _e1168 {
                                                        phi_1213_ = 0u;
                                                    } else {
                                                        phi_1213_ = select(2u, 1u, (_e1166 < (2097152f * _e163)));
                                                    }
                                                    let _e1173 = phi_1213_;
                                                    switch bitcast<i32>(_e1173) {
                                                        case 0: {
                                                            phi_1219_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1219_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1219_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1219_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1176 = phi_1219_;
                                                    switch bitcast<i32>(_e1173) {
                                                        case 0: {
                                                            phi_1229_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1229_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1229_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1229_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1183 = phi_1229_;
                                                    let _e1185 = ((_e647 + (_e1147.member_1 * ((3u * _e1176) + 1u))) + (3u * _e1183));
                                                    let _e1186 = (_e1185 < _e107);
                                                    if _e1186 {
                                                        if _e1186 {
                                                        } else {
                                                            phi_4145_ = true;
                                                            break;
                                                        }
                                                        let _e1188 = global_10.member[_e1185];
                                                        phi_1245_ = _e1188;
                                                    } else {
                                                        phi_1245_ = 4294967295u;
                                                    }
                                                    let _e1190 = phi_1245_;
                                                    local_10 = array<u32, 3>(_e377, _e376, _e378);
                                                    if _e1168 {
                                                        phi_1282_ = 0u;
                                                    } else {
                                                        phi_1282_ = select(2u, 1u, (_e1166 < (2097152f * _e163)));
                                                    }
                                                    let _e1196 = phi_1282_;
                                                    switch bitcast<i32>(_e1196) {
                                                        case 0: {
                                                            phi_1288_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1288_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1288_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1288_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1199 = phi_1288_;
                                                    switch bitcast<i32>(_e1196) {
                                                        case 0: {
                                                            phi_1298_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1298_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1298_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1298_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1206 = phi_1298_;
                                                    local_12 = array<f32, 4>(_e638.member.member.x, _e638.member.member.y, _e638.member.member.z, _e638.member.member.w);
                                                    local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4065_ = _e1128;
                                                    phi_1314_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1220 = phi_4065_;
                                                        let _e1222 = phi_1314_;
                                                        if (_e1222.member < _e1222.member_1) {
                                                            phi_1315_ = type_8((_e1222.member + 1u), _e1222.member_1);
                                                            phi_1338_ = type_8(1u, _e1222.member);
                                                        } else {
                                                            phi_1315_ = _e1222;
                                                            phi_1338_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1235 = phi_1315_;
                                                        let _e1237 = phi_1338_;
                                                        let _e1241 = (bitcast<i32>(_e1237.member) != 0i);
                                                        if _e1241 {
                                                            let _e1243 = ((_e647 + (_e1147.member_1 * ((3u * _e1199) + 1u))) + (_e1237.member_1 * _e1206));
                                                            let _e1244 = (_e1243 < _e107);
                                                            if _e1244 {
                                                                if _e1244 {
                                                                } else {
                                                                    phi_4143_ = true;
                                                                    break;
                                                                }
                                                                let _e1246 = global_10.member[_e1243];
                                                                phi_1361_ = _e1246;
                                                            } else {
                                                                phi_1361_ = 0u;
                                                            }
                                                            let _e1248 = phi_1361_;
                                                            let _e1249 = (_e1243 + 1u);
                                                            let _e1250 = (_e1249 < _e107);
                                                            if _e1250 {
                                                                if _e1250 {
                                                                } else {
                                                                    phi_4143_ = true;
                                                                    break;
                                                                }
                                                                let _e1252 = global_10.member[_e1249];
                                                                phi_1376_ = _e1252;
                                                            } else {
                                                                phi_1376_ = 0u;
                                                            }
                                                            let _e1254 = phi_1376_;
                                                            phi_1379_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1256 = phi_1379_;
                                                                if (_e1256.member < _e1256.member_1) {
                                                                    phi_1380_ = type_8((_e1256.member + 1u), _e1256.member_1);
                                                                    phi_1403_ = type_8(1u, _e1256.member);
                                                                } else {
                                                                    phi_1380_ = _e1256;
                                                                    phi_1403_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1269 = phi_1380_;
                                                                let _e1271 = phi_1403_;
                                                                let _e1275 = (bitcast<i32>(_e1271.member) != 0i);
                                                                if _e1275 {
                                                                    let _e1276 = (_e1271.member_1 < 3u);
                                                                    if _e1276 {
                                                                    } else {
                                                                        phi_4058_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1278 = local_10[_e1271.member_1];
                                                                    if (_e1271.member_1 < 4u) {
                                                                    } else {
                                                                        phi_4058_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1281 = local_12[_e1271.member_1];
                                                                    switch bitcast<i32>(_e1196) {
                                                                        case 0: {
                                                                            phi_1473_ = (_e1281 + (f32(((_e1248 >> bitcast<u32>(((10u * _e1278) & 31u))) & 1023u)) * _e163));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1278 == 0u) {
                                                                                phi_1450_ = _e1248;
                                                                            } else {
                                                                                if (_e1278 == 1u) {
                                                                                    phi_1449_ = ((_e1248 >> bitcast<u32>(21i)) | (_e1254 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_1449_ = (_e1254 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1302 = phi_1449_;
                                                                                phi_1450_ = _e1302;
                                                                            }
                                                                            let _e1304 = phi_1450_;
                                                                            phi_1473_ = (_e1281 + (f32((_e1304 & 2097151u)) * _e163));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1283 = (_e1243 + _e1278);
                                                                            let _e1284 = (_e1283 < _e107);
                                                                            if _e1284 {
                                                                                if _e1284 {
                                                                                } else {
                                                                                    phi_4058_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1286 = global_10.member[_e1283];
                                                                                phi_1469_ = _e1286;
                                                                            } else {
                                                                                phi_1469_ = 0u;
                                                                            }
                                                                            let _e1288 = phi_1469_;
                                                                            phi_1473_ = (f32(bitcast<i32>(_e1288)) * _e163);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_1473_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1318 = phi_1473_;
                                                                    if (_e1237.member_1 < 3u) {
                                                                    } else {
                                                                        phi_4058_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1276 {
                                                                    } else {
                                                                        phi_4058_ = true;
                                                                        break;
                                                                    }
                                                                    local_11[_e1237.member_1][_e1271.member_1] = _e1318;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_1379_ = _e1269;
                                                                    phi_4058_ = _e1220;
                                                                    break if !(_e1275);
                                                                }
                                                            }
                                                            let _e1324 = phi_4058_;
                                                            phi_4143_ = _e1324;
                                                            if _e1324 {
                                                                break;
                                                            }
                                                            phi_4144_ = _e1324;
                                                        } else {
                                                            phi_4144_ = _e1220;
                                                        }
                                                        let _e1326 = phi_4144_;
                                                        continue;
                                                        continuing {
                                                            phi_4065_ = _e1326;
                                                            phi_1314_ = _e1235;
                                                            phi_4143_ = _e1326;
                                                            break if !(_e1241);
                                                        }
                                                    }
                                                    let _e1329 = phi_4143_;
                                                    phi_4145_ = _e1329;
                                                    if _e1329 {
                                                        break;
                                                    }
                                                    let _e1330 = local_11;
                                                    let _e1346 = (_e1330[0][2] - _e482);
                                                    let _e1349 = (((_e1330[0][0] - _e409) * _e506) - (_e1346 * _e434));
                                                    let _e1352 = (((_e1330[0][1] - _e446) * _e506) - (_e1346 * _e470));
                                                    let _e1355 = (_e1330[1][2] - _e482);
                                                    let _e1358 = (((_e1330[1][0] - _e409) * _e506) - (_e1355 * _e434));
                                                    let _e1361 = (((_e1330[1][1] - _e446) * _e506) - (_e1355 * _e470));
                                                    let _e1364 = (_e1330[2][2] - _e482);
                                                    let _e1367 = (((_e1330[2][0] - _e409) * _e506) - (_e1364 * _e434));
                                                    let _e1370 = (((_e1330[2][1] - _e446) * _e506) - (_e1364 * _e470));
                                                    let _e1371 = (_e1367 * _e1361);
                                                    let _e1372 = (_e1370 * _e1358);
                                                    let _e1373 = (_e1349 * _e1370);
                                                    let _e1374 = (_e1352 * _e1367);
                                                    let _e1375 = (_e1358 * _e1352);
                                                    let _e1376 = (_e1361 * _e1349);
                                                    let _e1381 = (((_e1371 >= _e1372) && (_e1373 >= _e1374)) && (_e1375 >= _e1376));
                                                    if (_e1381 || (((_e1371 <= _e1372) && (_e1373 <= _e1374)) && (_e1375 <= _e1376))) {
                                                        let _e1388 = select(-1f, 1f, _e1381);
                                                        let _e1390 = ((_e1371 - _e1372) * _e1388);
                                                        let _e1392 = select(0f, _e1390, (_e1390 > 0f));
                                                        let _e1394 = ((_e1373 - _e1374) * _e1388);
                                                        let _e1396 = select(0f, _e1394, (_e1394 > 0f));
                                                        let _e1398 = ((_e1375 - _e1376) * _e1388);
                                                        let _e1400 = select(0f, _e1398, (_e1398 > 0f));
                                                        let _e1402 = ((_e1392 + _e1396) + _e1400);
                                                        if (_e1402 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2068_ = type_25();
                                                            phi_2069_ = true;
                                                        } else {
                                                            let _e1405 = select(_e1330[1][0], _e1330[0][0], (_e1330[0][0] < _e1330[1][0]));
                                                            let _e1409 = select(_e1330[1][0], _e1330[0][0], (_e1330[0][0] > _e1330[1][0]));
                                                            let _e1413 = select(_e1330[1][1], _e1330[0][1], (_e1330[0][1] < _e1330[1][1]));
                                                            let _e1417 = select(_e1330[1][1], _e1330[0][1], (_e1330[0][1] > _e1330[1][1]));
                                                            let _e1421 = select(_e1330[1][2], _e1330[0][2], (_e1330[0][2] < _e1330[1][2]));
                                                            let _e1425 = select(_e1330[1][2], _e1330[0][2], (_e1330[0][2] > _e1330[1][2]));
                                                            let _e1430 = ((select(_e1330[2][0], _e1405, (_e1405 < _e1330[2][0])) - _e432) * _e437);
                                                            let _e1431 = ((select(_e1330[2][0], _e1409, (_e1409 > _e1330[2][0])) - _e433) * _e437);
                                                            let _e1434 = ((select(_e1330[2][1], _e1413, (_e1413 < _e1330[2][1])) - _e468) * _e473);
                                                            let _e1435 = ((select(_e1330[2][1], _e1417, (_e1417 > _e1330[2][1])) - _e469) * _e473);
                                                            let _e1438 = ((select(_e1330[2][2], _e1421, (_e1421 < _e1330[2][2])) - _e504) * _e509);
                                                            let _e1439 = ((select(_e1330[2][2], _e1425, (_e1425 > _e1330[2][2])) - _e505) * _e509);
                                                            let _e1441 = select(_e1439, _e1438, (_e1438 < _e1439));
                                                            let _e1443 = select(_e1439, _e1438, (_e1438 > _e1439));
                                                            let _e1445 = select(_e1431, _e1430, (_e1430 < _e1431));
                                                            let _e1447 = select(_e1435, _e1434, (_e1434 < _e1435));
                                                            let _e1449 = select(_e1447, _e1445, (_e1445 > _e1447));
                                                            let _e1451 = select(_e1441, _e1449, (_e1449 > _e1441));
                                                            let _e1453 = select(_e1431, _e1430, (_e1430 > _e1431));
                                                            let _e1455 = select(_e1435, _e1434, (_e1434 > _e1435));
                                                            let _e1457 = select(_e1455, _e1453, (_e1453 < _e1455));
                                                            let _e1459 = select(_e1443, _e1457, (_e1457 < _e1443));
                                                            let _e1460 = -(_e1441);
                                                            let _e1466 = select(_e555, _e1451, (_e1451 > _e555));
                                                            if (_e1466 > (_e1459 + (select(_e1460, _e1443, (_e1443 > _e1460)) * 0.0000019073523f))) {
                                                                phi_2063_ = type_25();
                                                                phi_2064_ = true;
                                                            } else {
                                                                let _e1468 = (_e1466 > _e1130.member);
                                                                if _e1468 {
                                                                    phi_2062_ = type_25();
                                                                } else {
                                                                    let _e1472 = (_e1330[1][0] - _e1330[0][0]);
                                                                    let _e1473 = (_e1330[1][1] - _e1330[0][1]);
                                                                    let _e1474 = (_e1330[1][2] - _e1330[0][2]);
                                                                    let _e1475 = vec3<f32>(_e1472, _e1473, _e1474);
                                                                    let _e1476 = (_e1330[2][0] - _e1330[1][0]);
                                                                    let _e1477 = (_e1330[2][1] - _e1330[1][1]);
                                                                    let _e1478 = (_e1330[2][2] - _e1330[1][2]);
                                                                    let _e1479 = vec3<f32>(_e1476, _e1477, _e1478);
                                                                    let _e1480 = (_e1330[0][0] - _e1330[2][0]);
                                                                    let _e1481 = (_e1330[0][1] - _e1330[2][1]);
                                                                    let _e1482 = (_e1330[0][2] - _e1330[2][2]);
                                                                    let _e1483 = vec3<f32>(_e1480, _e1481, _e1482);
                                                                    let _e1486 = bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u));
                                                                    let _e1489 = bitcast<f32>((bitcast<u32>(_e1473) & 2147483647u));
                                                                    let _e1491 = select(_e1489, _e1486, (_e1486 > _e1489));
                                                                    let _e1494 = bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u));
                                                                    let _e1496 = select(_e1494, _e1491, (_e1491 > _e1494));
                                                                    let _e1499 = bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u));
                                                                    let _e1502 = bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u));
                                                                    let _e1504 = select(_e1502, _e1499, (_e1499 > _e1502));
                                                                    let _e1507 = bitcast<f32>((bitcast<u32>(_e1478) & 2147483647u));
                                                                    let _e1509 = select(_e1507, _e1504, (_e1504 > _e1507));
                                                                    let _e1512 = bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u));
                                                                    let _e1515 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                    let _e1517 = select(_e1515, _e1512, (_e1512 > _e1515));
                                                                    let _e1520 = bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u));
                                                                    let _e1522 = select(_e1520, _e1517, (_e1517 > _e1520));
                                                                    let _e1524 = select(_e1509, _e1496, (_e1496 > _e1509));
                                                                    let _e1526 = select(_e1522, _e1524, (_e1524 > _e1522));
                                                                    if (_e1496 == _e1526) {
                                                                        phi_1973_ = _e1479;
                                                                        phi_1974_ = _e1483;
                                                                    } else {
                                                                        let _e1529 = vec3((_e1509 == _e1526));
                                                                        phi_1973_ = select(_e1475, _e1483, _e1529);
                                                                        phi_1974_ = select(_e1479, _e1475, _e1529);
                                                                    }
                                                                    let _e1533 = phi_1973_;
                                                                    let _e1535 = phi_1974_;
                                                                    let _e1542 = ((_e1533.y * _e1535.z) - (_e1535.y * _e1533.z));
                                                                    let _e1547 = ((_e1533.z * _e1535.x) - (_e1535.z * _e1533.x));
                                                                    let _e1550 = ((_e1533.x * _e1535.y) - (_e1535.x * _e1533.y));
                                                                    if (_e1392 >= _e1396) {
                                                                        phi_2005_ = select(true, false, (_e1392 >= _e1400));
                                                                    } else {
                                                                        phi_2005_ = true;
                                                                    }
                                                                    let _e1555 = phi_2005_;
                                                                    if _e1555 {
                                                                        phi_2014_ = select(vec3<f32>(_e1330[2][0], _e1330[2][1], _e1330[2][2]), vec3<f32>(_e1330[1][0], _e1330[1][1], _e1330[1][2]), vec3((_e1396 >= _e1400)));
                                                                    } else {
                                                                        phi_2014_ = vec3<f32>(_e1330[0][0], _e1330[0][1], _e1330[0][2]);
                                                                    }
                                                                    let _e1560 = phi_2014_;
                                                                    let _e1577 = ((((_e1542 * (_e1560.x - _e409)) + (_e1547 * (_e1560.y - _e446))) + (_e1550 * (_e1560.z - _e482))) / (((_e1542 * _e434) + (_e1547 * _e470)) + (_e1550 * _e506)));
                                                                    let _e1579 = select(_e1459, _e1577, (_e1577 < _e1459));
                                                                    let _e1581 = select(_e1451, _e1579, (_e1579 > _e1451));
                                                                    if (_e1581 >= _e555) {
                                                                        let _e1583 = (_e1581 <= _e1130.member);
                                                                        if _e1583 {
                                                                            let _e1584 = (1f / _e1402);
                                                                            phi_2054_ = type_25(_e1581, (_e1396 * _e1584), (_e1400 * _e1584), _e1190);
                                                                        } else {
                                                                            phi_2054_ = type_25();
                                                                        }
                                                                        let _e1589 = phi_2054_;
                                                                        phi_2056_ = _e1589;
                                                                        phi_2057_ = select(true, false, _e1583);
                                                                    } else {
                                                                        phi_2056_ = type_25();
                                                                        phi_2057_ = true;
                                                                    }
                                                                    let _e1592 = phi_2056_;
                                                                    let _e1594 = phi_2057_;
                                                                    if _e1594 {
                                                                        phi_2061_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2061_ = _e1592;
                                                                    }
                                                                    let _e1596 = phi_2061_;
                                                                    phi_2062_ = _e1596;
                                                                }
                                                                let _e1598 = phi_2062_;
                                                                phi_2063_ = _e1598;
                                                                phi_2064_ = _e1468;
                                                            }
                                                            let _e1600 = phi_2063_;
                                                            let _e1602 = phi_2064_;
                                                            phi_2068_ = _e1600;
                                                            phi_2069_ = _e1602;
                                                        }
                                                        let _e1604 = phi_2068_;
                                                        let _e1606 = phi_2069_;
                                                        phi_2073_ = _e1604;
                                                        phi_2074_ = _e1606;
                                                    } else {
                                                        phi_2073_ = type_25();
                                                        phi_2074_ = true;
                                                    }
                                                    let _e1608 = phi_2073_;
                                                    let _e1610 = phi_2074_;
                                                    if _e1610 {
                                                        phi_2078_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2078_ = _e1608;
                                                    }
                                                    let _e1612 = phi_2078_;
                                                    if (_e1612.member_3 != 4294967295u) {
                                                        if (_e1190 == _e172) {
                                                            phi_2407_ = false;
                                                        } else {
                                                            let _e1616 = (_e1190 < arrayLength((&global_6.member)));
                                                            if _e1616 {
                                                                if _e1616 {
                                                                } else {
                                                                    phi_4145_ = true;
                                                                    break;
                                                                }
                                                                let _e1618 = global_6.member[_e1190];
                                                                phi_2101_ = _e1618;
                                                            } else {
                                                                phi_2101_ = 4294967295u;
                                                            }
                                                            let _e1620 = phi_2101_;
                                                            let _e1621 = (_e1620 < arrayLength((&global_7.member)));
                                                            if _e1621 {
                                                                if _e1621 {
                                                                } else {
                                                                    phi_4145_ = true;
                                                                    break;
                                                                }
                                                                let _e1623 = global_7.member[_e1620];
                                                                phi_2115_ = _e1623;
                                                            } else {
                                                                phi_2115_ = 0i;
                                                            }
                                                            let _e1625 = phi_2115_;
                                                            let _e1626 = (_e1625 == 0i);
                                                            if _e1626 {
                                                                phi_2406_ = true;
                                                            } else {
                                                                if _e401 {
                                                                    phi_2136_ = vec3<f32>(_e1330[0][0], _e1330[0][1], _e1330[0][2]);
                                                                } else {
                                                                    if (_e377 == 1u) {
                                                                        phi_2135_ = vec3<f32>(_e1330[0][2], _e1330[0][0], _e1330[0][1]);
                                                                    } else {
                                                                        phi_2135_ = vec3<f32>(_e1330[0][1], _e1330[0][2], _e1330[0][0]);
                                                                    }
                                                                    let _e1631 = phi_2135_;
                                                                    phi_2136_ = _e1631;
                                                                }
                                                                let _e1634 = phi_2136_;
                                                                if _e401 {
                                                                    phi_2153_ = vec3<f32>(_e1330[1][0], _e1330[1][1], _e1330[1][2]);
                                                                } else {
                                                                    if (_e377 == 1u) {
                                                                        phi_2152_ = vec3<f32>(_e1330[1][2], _e1330[1][0], _e1330[1][1]);
                                                                    } else {
                                                                        phi_2152_ = vec3<f32>(_e1330[1][1], _e1330[1][2], _e1330[1][0]);
                                                                    }
                                                                    let _e1639 = phi_2152_;
                                                                    phi_2153_ = _e1639;
                                                                }
                                                                let _e1642 = phi_2153_;
                                                                if _e401 {
                                                                    phi_2170_ = vec3<f32>(_e1330[2][0], _e1330[2][1], _e1330[2][2]);
                                                                } else {
                                                                    if (_e377 == 1u) {
                                                                        phi_2169_ = vec3<f32>(_e1330[2][2], _e1330[2][0], _e1330[2][1]);
                                                                    } else {
                                                                        phi_2169_ = vec3<f32>(_e1330[2][1], _e1330[2][2], _e1330[2][0]);
                                                                    }
                                                                    let _e1647 = phi_2169_;
                                                                    phi_2170_ = _e1647;
                                                                }
                                                                let _e1650 = phi_2170_;
                                                                let _e1653 = (_e1642.x - _e1634.x);
                                                                let _e1656 = (_e1642.y - _e1634.y);
                                                                let _e1659 = (_e1642.z - _e1634.z);
                                                                let _e1661 = (_e1650.x - _e1634.x);
                                                                let _e1663 = (_e1650.y - _e1634.y);
                                                                let _e1665 = (_e1650.z - _e1634.z);
                                                                if (_e244.member_1 == 1u) {
                                                                    phi_2206_ = (vec3<f32>(_e244.member[0], _e244.member[1], _e244.member[2]) - _e1634);
                                                                } else {
                                                                    phi_2206_ = vec3<f32>(_e244.member[0], _e244.member[1], _e244.member[2]);
                                                                }
                                                                let _e1680 = phi_2206_;
                                                                let _e1686 = bitcast<f32>((bitcast<u32>((_e1653 * _e1663)) ^ _e244.member_3[0]));
                                                                let _e1690 = bitcast<f32>((bitcast<u32>((_e1656 * _e1661)) ^ _e244.member_3[0]));
                                                                let _e1694 = bitcast<f32>((bitcast<u32>((_e1656 * _e1665)) ^ _e244.member_3[0]));
                                                                let _e1698 = bitcast<f32>((bitcast<u32>((_e1659 * _e1663)) ^ _e244.member_3[0]));
                                                                let _e1702 = bitcast<f32>((bitcast<u32>((_e1659 * _e1661)) ^ _e244.member_3[0]));
                                                                let _e1706 = bitcast<f32>((bitcast<u32>((_e1653 * _e1665)) ^ _e244.member_3[0]));
                                                                let _e1707 = (_e1694 - _e1698);
                                                                let _e1708 = (_e1702 - _e1706);
                                                                let _e1709 = (_e1686 - _e1690);
                                                                let _e1733 = (bitcast<f32>((bitcast<u32>(_e1694) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1698) & 2147483647u)));
                                                                let _e1740 = (bitcast<f32>((bitcast<u32>(_e1702) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1706) & 2147483647u)));
                                                                let _e1747 = (bitcast<f32>((bitcast<u32>(_e1686) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u)));
                                                                if (_e244.member_2 == 0f) {
                                                                    phi_2388_ = 0f;
                                                                } else {
                                                                    let _e1777 = bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u));
                                                                    let _e1780 = bitcast<f32>((bitcast<u32>(_e1708) & 2147483647u));
                                                                    let _e1783 = bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u));
                                                                    let _e1785 = select(_e1783, _e1780, (_e1780 > _e1783));
                                                                    let _e1789 = select(_e1783, _e1780, (_e1780 < _e1783));
                                                                    let _e1793 = select(_e1780, _e1777, (_e1777 < _e1780));
                                                                    let _e1795 = select(_e1780, _e1777, (_e1777 > _e1780));
                                                                    let _e1797 = select(_e1783, _e1795, (_e1795 < _e1783));
                                                                    phi_2388_ = bitcast<f32>((bitcast<u32>((_e244.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1785, _e1777, (_e1777 > _e1785)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1797, _e1793, (_e1793 > _e1797)))) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1789, _e1777, (_e1777 < _e1789)))) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1733 + _e1740) + _e1747))) ^ _e244.member_3[0]))) * 1.0000005f)) ^ _e244.member_3[0])))) ^ _e244.member_3[0]));
                                                                }
                                                                let _e1824 = phi_2388_;
                                                                phi_2406_ = (_e1626 || !(((((bitcast<f32>((bitcast<u32>((_e1680.x * _e1707)) ^ _e244.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1680.y * _e1708)) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1680.z * _e1709)) ^ _e244.member_3[0]))) * f32(-(_e1625))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1680.x) & 2147483647u)) * _e1733)) ^ _e244.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1680.y) & 2147483647u)) * _e1740)) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1680.z) & 2147483647u)) * _e1747)) ^ _e244.member_3[0]))))) ^ _e244.member_3[0])) + _e1824) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1838 = phi_2406_;
                                                            phi_2407_ = _e1838;
                                                        }
                                                        let _e1840 = phi_2407_;
                                                        if _e1840 {
                                                            phi_2412_ = type_46(_e1130.member, true);
                                                        } else {
                                                            phi_2412_ = _e1130;
                                                        }
                                                        let _e1845 = phi_2412_;
                                                        phi_2413_ = _e1845;
                                                    } else {
                                                        phi_2413_ = _e1130;
                                                    }
                                                    let _e1847 = phi_2413_;
                                                    phi_4146_ = _e1329;
                                                    phi_1147_ = _e1847;
                                                } else {
                                                    phi_4146_ = _e1128;
                                                    phi_1147_ = type_46();
                                                }
                                                let _e1849 = phi_4146_;
                                                let _e1851 = phi_1147_;
                                                continue;
                                                continuing {
                                                    phi_4080_ = _e1849;
                                                    phi_1146_ = _e1851;
                                                    phi_1149_ = _e1145;
                                                    phi_4145_ = _e1849;
                                                    break if !(_e1151);
                                                }
                                            }
                                            let _e1854 = phi_4145_;
                                            phi_4221_ = _e1854;
                                            if _e1854 {
                                                break;
                                            }
                                            let _e1856 = local_13;
                                            phi_4225_ = _e1854;
                                            let _e2068 = local_15;
                                            phi_3796_ = _e2068;
                                            phi_3797_ = _e638;
                                            phi_3798_ = false;
                                            phi_3799_ = select(_e642, 0u, _e1856.member_1);
                                        } else {
                                            if (_e638.member_1 >= _e104) {
                                                phi_3352_ = type_62(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e638.member_1 < _e104) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e655 = ((1u + _e377) % 4u);
                                                if (_e655 < 4u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e660 = global_5.member[_e638.member_1][_e655];
                                                let _e662 = ((1u + _e376) % 4u);
                                                if (_e662 < 4u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e667 = global_5.member[_e638.member_1][_e662];
                                                let _e669 = ((1u + _e378) % 4u);
                                                if (_e669 < 4u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e674 = global_5.member[_e638.member_1][_e669];
                                                let _e676 = ((_e377 + 1u) % 4u);
                                                if (_e676 < 4u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e681 = global_5.member[_e638.member_1][_e676];
                                                let _e683 = (_e681 >> bitcast<u32>(11u));
                                                let _e685 = ((_e376 + 1u) % 4u);
                                                if (_e685 < 4u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e690 = global_5.member[_e638.member_1][_e685];
                                                let _e692 = (_e690 >> bitcast<u32>(11u));
                                                let _e694 = ((_e378 + 1u) % 4u);
                                                if (_e694 < 4u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e699 = global_5.member[_e638.member_1][_e694];
                                                let _e701 = (_e699 >> bitcast<u32>(11u));
                                                let _e724 = (bitcast<f32>((bitcast<u32>((_e638.member.member_1.x - _e638.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e725 = (bitcast<f32>((bitcast<u32>((_e638.member.member_1.y - _e638.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e726 = (bitcast<f32>((bitcast<u32>((_e638.member.member_1.z - _e638.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e728 = select(_e163, _e724, (_e724 > _e163));
                                                let _e730 = select(_e163, _e725, (_e725 > _e163));
                                                let _e732 = select(_e163, _e726, (_e726 > _e163));
                                                let _e757 = bitcast<u32>((f32(bitcast<i32>((_e660 & 1023u))) * _e728));
                                                let _e762 = (bitcast<i32>((_e660 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e765 = bitcast<f32>((_e757 & bitcast<u32>(_e762)));
                                                let _e766 = bitcast<u32>((f32(bitcast<i32>((_e667 & 1023u))) * _e730));
                                                let _e771 = (bitcast<i32>((_e667 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e774 = bitcast<f32>((_e766 & bitcast<u32>(_e771)));
                                                let _e775 = bitcast<u32>((f32(bitcast<i32>((_e674 & 1023u))) * _e732));
                                                let _e780 = (bitcast<i32>((_e674 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e783 = bitcast<f32>((_e775 & bitcast<u32>(_e780)));
                                                let _e787 = bitcast<f32>((_e757 & bitcast<u32>(~(_e762))));
                                                let _e791 = bitcast<f32>((_e766 & bitcast<u32>(~(_e771))));
                                                let _e795 = bitcast<f32>((_e775 & bitcast<u32>(~(_e780))));
                                                let _e796 = bitcast<u32>((f32(bitcast<i32>((_e683 & 1023u))) * _e728));
                                                let _e801 = (bitcast<i32>((_e683 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e804 = bitcast<f32>((_e796 & bitcast<u32>(_e801)));
                                                let _e805 = bitcast<u32>((f32(bitcast<i32>((_e692 & 1023u))) * _e730));
                                                let _e810 = (bitcast<i32>((_e692 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e813 = bitcast<f32>((_e805 & bitcast<u32>(_e810)));
                                                let _e814 = bitcast<u32>((f32(bitcast<i32>((_e701 & 1023u))) * _e732));
                                                let _e819 = (bitcast<i32>((_e701 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e822 = bitcast<f32>((_e814 & bitcast<u32>(_e819)));
                                                let _e826 = bitcast<f32>((_e796 & bitcast<u32>(~(_e801))));
                                                let _e830 = bitcast<f32>((_e805 & bitcast<u32>(~(_e810))));
                                                let _e834 = bitcast<f32>((_e814 & bitcast<u32>(~(_e819))));
                                                let _e835 = (_e638.member.member.x + _e765);
                                                let _e836 = (_e638.member.member.y + _e774);
                                                let _e837 = (_e638.member.member.z + _e783);
                                                let _e840 = (_e638.member.member_1.x - _e804);
                                                let _e841 = (_e638.member.member_1.y - _e813);
                                                let _e842 = (_e638.member.member_1.z - _e822);
                                                let _e861 = (_e840 - _e835);
                                                let _e862 = (_e841 - _e836);
                                                let _e863 = (_e842 - _e837);
                                                let _e865 = select(_e862, _e861, (_e861 > _e862));
                                                let _e867 = select(_e863, _e865, (_e865 > _e863));
                                                if (_e867 < (1024f * _e163)) {
                                                    phi_3053_ = 0u;
                                                } else {
                                                    phi_3053_ = select(2u, 1u, (_e867 < (2097152f * _e163)));
                                                }
                                                let _e874 = phi_3053_;
                                                switch bitcast<i32>(_e874) {
                                                    case 0: {
                                                        phi_3059_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3059_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3059_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3059_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e877 = phi_3059_;
                                                let _e883 = global_5.member[_e638.member_1][0u];
                                                let _e887 = global_5.member[_e638.member_1][1u];
                                                let _e891 = global_5.member[_e638.member_1][2u];
                                                let _e895 = global_5.member[_e638.member_1][3u];
                                                let _e907 = (((_e887 >> bitcast<u32>(22i)) | ((_e891 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e895 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e908 = (_e883 & 268435455u);
                                                let _e909 = (_e907 & 268435455u);
                                                let _e912 = ((_e883 >> bitcast<u32>(28u)) & 7u);
                                                let _e920 = ((_e883 >> bitcast<u32>(31i)) | (((_e907 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e921 = (_e912 != 0u);
                                                if (_e912 == 0u) {
                                                    phi_3314_ = _e908;
                                                } else {
                                                    if (_e912 == 7u) {
                                                        phi_3313_ = 2147483648u;
                                                    } else {
                                                        phi_3313_ = ((2147483648u | (_e912 << bitcast<u32>(28u))) | (_e909 & 268435455u));
                                                    }
                                                    let _e930 = phi_3313_;
                                                    phi_3314_ = _e930;
                                                }
                                                let _e932 = phi_3314_;
                                                if _e921 {
                                                    let _e933 = (_e912 != 7u);
                                                    if _e933 {
                                                        phi_3324_ = (_e909 + (_e912 * ((3u * _e877) + 1u)));
                                                    } else {
                                                        phi_3324_ = u32();
                                                    }
                                                    let _e937 = phi_3324_;
                                                    phi_3326_ = _e937;
                                                    phi_3327_ = select(true, false, _e933);
                                                } else {
                                                    phi_3326_ = u32();
                                                    phi_3327_ = true;
                                                }
                                                let _e940 = phi_3326_;
                                                let _e942 = phi_3327_;
                                                if (_e920 == 0u) {
                                                    phi_3348_ = (_e908 + select(0u, 1u, !(_e921)));
                                                } else {
                                                    if (_e920 == 7u) {
                                                        phi_3347_ = 2147483648u;
                                                    } else {
                                                        phi_3347_ = ((2147483648u | (_e920 << bitcast<u32>(28u))) | (select(_e940, _e909, _e942) & 268435455u));
                                                    }
                                                    let _e955 = phi_3347_;
                                                    phi_3348_ = _e955;
                                                }
                                                let _e957 = phi_3348_;
                                                phi_3352_ = type_62(array<vec4<f32>, 3>(vec4<f32>(_e835, (_e638.member.member.x + _e787), _e840, (_e638.member.member_1.x - _e826)), vec4<f32>(_e836, (_e638.member.member.y + _e791), _e841, (_e638.member.member_1.y - _e830)), vec4<f32>(_e837, (_e638.member.member.z + _e795), _e842, (_e638.member.member_1.z - _e834))), type_61(type_34((_e638.member.member + vec4<f32>(_e765, _e774, _e783, 0f)), (_e638.member.member_1 - vec4<f32>(_e804, _e813, _e822, 0f))), _e932), type_61(type_34((_e638.member.member + vec4<f32>(_e787, _e791, _e795, 0f)), (_e638.member.member_1 - vec4<f32>(_e826, _e830, _e834, 0f))), _e957));
                                            }
                                            let _e962 = phi_3352_;
                                            let _e974 = ((_e962.member[0].x - _e432) * _e437);
                                            let _e975 = ((_e962.member[0].y - _e432) * _e437);
                                            let _e976 = ((_e962.member[0].z - _e433) * _e437);
                                            let _e977 = ((_e962.member[0].w - _e433) * _e437);
                                            let _e987 = ((_e962.member[1].x - _e468) * _e473);
                                            let _e988 = ((_e962.member[1].y - _e468) * _e473);
                                            let _e989 = ((_e962.member[1].z - _e469) * _e473);
                                            let _e990 = ((_e962.member[1].w - _e469) * _e473);
                                            let _e1000 = ((_e962.member[2].x - _e504) * _e509);
                                            let _e1001 = ((_e962.member[2].y - _e504) * _e509);
                                            let _e1002 = ((_e962.member[2].z - _e505) * _e509);
                                            let _e1003 = ((_e962.member[2].w - _e505) * _e509);
                                            let _e1005 = select(_e1002, _e1000, (_e1000 < _e1002));
                                            let _e1007 = select(_e1003, _e1001, (_e1001 < _e1003));
                                            let _e1009 = select(_e1002, _e1000, (_e1000 > _e1002));
                                            let _e1011 = select(_e1003, _e1001, (_e1001 > _e1003));
                                            let _e1013 = select(_e976, _e974, (_e974 < _e976));
                                            let _e1015 = select(_e977, _e975, (_e975 < _e977));
                                            let _e1017 = select(_e989, _e987, (_e987 < _e989));
                                            let _e1019 = select(_e990, _e988, (_e988 < _e990));
                                            let _e1021 = select(_e1017, _e1013, (_e1013 > _e1017));
                                            let _e1023 = select(_e1019, _e1015, (_e1015 > _e1019));
                                            let _e1025 = select(_e1005, _e1021, (_e1021 > _e1005));
                                            let _e1027 = select(_e1007, _e1023, (_e1023 > _e1007));
                                            let _e1029 = select(_e976, _e974, (_e974 > _e976));
                                            let _e1031 = select(_e977, _e975, (_e975 > _e977));
                                            let _e1033 = select(_e989, _e987, (_e987 > _e989));
                                            let _e1035 = select(_e990, _e988, (_e988 > _e990));
                                            let _e1037 = select(_e1033, _e1029, (_e1029 < _e1033));
                                            let _e1039 = select(_e1035, _e1031, (_e1031 < _e1035));
                                            let _e1044 = -(_e1005);
                                            let _e1045 = -(_e1007);
                                            let _e1052 = (select(_e1009, _e1037, (_e1037 < _e1009)) + (select(_e1044, _e1009, (_e1009 > _e1044)) * 0.0000019073523f));
                                            let _e1053 = (select(_e1011, _e1039, (_e1039 < _e1011)) + (select(_e1045, _e1011, (_e1011 > _e1045)) * 0.0000019073523f));
                                            let _e1055 = select(_e555, _e1025, (_e1025 > _e555));
                                            let _e1057 = select(_e555, _e1027, (_e1027 > _e555));
                                            let _e1062 = (_e1055 <= select(_e599.member, _e1052, (_e1052 < _e599.member)));
                                            let _e1063 = (_e1057 <= select(_e599.member, _e1053, (_e1053 < _e599.member)));
                                            let _e1064 = (_e1055 <= _e1057);
                                            if _e1062 {
                                                if _e1063 {
                                                    if _e1064 {
                                                        phi_3696_ = _e962.member_2;
                                                    } else {
                                                        phi_3696_ = _e962.member_1;
                                                    }
                                                    let _e1068 = phi_3696_;
                                                    let _e1090 = (_e642 % 128u);
                                                    let _e1091 = (_e1090 < 128u);
                                                    if _e1091 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1090] = _e1068.member_1;
                                                    if _e1091 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1090] = _e1068.member.member.x;
                                                    if _e1091 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1090] = _e1068.member.member.y;
                                                    if _e1091 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1090] = _e1068.member.member.z;
                                                    if _e1091 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1090] = _e1068.member.member_1.x;
                                                    if _e1091 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1090] = _e1068.member.member_1.y;
                                                    if _e1091 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1090] = _e1068.member.member_1.z;
                                                    if _e1091 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1090] = select(_e1057, _e1055, (_e1055 > _e1057));
                                                    if _e1064 {
                                                        phi_3773_ = _e962.member_1;
                                                    } else {
                                                        phi_3773_ = _e962.member_2;
                                                    }
                                                    let _e1104 = phi_3773_;
                                                    phi_3774_ = _e1104;
                                                    phi_3775_ = (_e642 + 1u);
                                                } else {
                                                    phi_3774_ = type_61();
                                                    phi_3775_ = u32();
                                                }
                                                let _e1106 = phi_3774_;
                                                let _e1108 = phi_3775_;
                                                phi_3777_ = _e1106;
                                                phi_3778_ = _e1108;
                                                phi_3779_ = select(true, false, _e1063);
                                            } else {
                                                phi_3777_ = type_61();
                                                phi_3778_ = u32();
                                                phi_3779_ = true;
                                            }
                                            let _e1111 = phi_3777_;
                                            let _e1113 = phi_3778_;
                                            let _e1115 = phi_3779_;
                                            if _e1115 {
                                                if _e1062 {
                                                    phi_3788_ = _e962.member_1;
                                                } else {
                                                    phi_3788_ = _e962.member_2;
                                                }
                                                let _e1119 = phi_3788_;
                                                phi_3793_ = _e1119;
                                                phi_3794_ = select(_e1063, true, _e1062);
                                            } else {
                                                phi_3793_ = _e1111;
                                                phi_3794_ = _e640;
                                            }
                                            let _e1122 = phi_3793_;
                                            let _e1124 = phi_3794_;
                                            phi_4225_ = _e597;
                                            phi_3796_ = _e599;
                                            phi_3797_ = _e1122;
                                            phi_3798_ = _e1124;
                                            phi_3799_ = select(_e1113, _e642, _e1115);
                                        }
                                        let _e1860 = phi_4225_;
                                        let _e1862 = phi_3796_;
                                        let _e1864 = phi_3797_;
                                        let _e1866 = phi_3798_;
                                        let _e1868 = phi_3799_;
                                        phi_4224_ = _e1860;
                                        phi_3800_ = _e1862;
                                        phi_3801_ = _e1864;
                                        phi_3802_ = (_e603 - 1u);
                                        phi_3803_ = _e1866;
                                        phi_3804_ = _e1868;
                                    } else {
                                        phi_4224_ = _e597;
                                        phi_3800_ = _e599;
                                        phi_3801_ = _e638;
                                        phi_3802_ = _e603;
                                        phi_3803_ = _e640;
                                        phi_3804_ = _e642;
                                    }
                                    let _e1870 = phi_4224_;
                                    let _e1872 = phi_3800_;
                                    let _e1874 = phi_3801_;
                                    let _e1876 = phi_3802_;
                                    let _e1878 = phi_3803_;
                                    let _e1880 = phi_3804_;
                                    phi_4223_ = _e1870;
                                    phi_3805_ = _e1872;
                                    phi_3806_ = _e1874;
                                    phi_3807_ = _e1876;
                                    phi_3808_ = _e1878;
                                    phi_3809_ = _e1880;
                                } else {
                                    phi_4223_ = _e597;
                                    phi_3805_ = type_46();
                                    phi_3806_ = type_61();
                                    phi_3807_ = u32();
                                    phi_3808_ = bool();
                                    phi_3809_ = u32();
                                }
                                let _e1882 = phi_4223_;
                                let _e1884 = phi_3805_;
                                let _e1886 = phi_3806_;
                                let _e1888 = phi_3807_;
                                let _e1890 = phi_3808_;
                                let _e1892 = phi_3809_;
                                phi_4222_ = _e1882;
                                phi_1020_ = _e1884;
                                phi_1023_ = _e1886;
                                phi_1025_ = _e1888;
                                phi_1027_ = _e1890;
                                phi_1029_ = _e1892;
                                phi_3810_ = _e611;
                            } else {
                                phi_4222_ = _e597;
                                phi_1020_ = type_46();
                                phi_1023_ = type_61();
                                phi_1025_ = u32();
                                phi_1027_ = bool();
                                phi_1029_ = u32();
                                phi_3810_ = false;
                            }
                            let _e1894 = phi_4222_;
                            let _e1896 = phi_1020_;
                            let _e1898 = phi_1023_;
                            let _e1900 = phi_1025_;
                            let _e1902 = phi_1027_;
                            let _e1904 = phi_1029_;
                            let _e1906 = phi_3810_;
                            continue;
                            continuing {
                                phi_4083_ = _e1894;
                                phi_1019_ = _e1896;
                                phi_1022_ = _e1898;
                                phi_1024_ = _e1900;
                                phi_1026_ = _e1902;
                                phi_1028_ = _e1904;
                                phi_4221_ = _e1894;
                                break if !(_e1906);
                            }
                        }
                        let _e1909 = phi_4221_;
                        if _e1909 {
                            break;
                        }
                        let _e1911 = local_14;
                        if _e1911.member_1 {
                        } else {
                            if _e245 {
                            } else {
                                break;
                            }
                            let _e1915 = global_2.member[_e151];
                            if _e166 {
                            } else {
                                break;
                            }
                            let _e1919 = global_9.member[_e151].member_1;
                            if _e245 {
                            } else {
                                break;
                            }
                            global_2.member[_e151] = type_27(_e1915.member, _e1915.member_1, _e1915.member_2, array<f32, 3>((_e1915.member_3[0] + (_e1919[0] * _e1915.member_1[0])), (_e1915.member_3[1] + (_e1919[1] * _e1915.member_1[1])), (_e1915.member_3[2] + (_e1919[2] * _e1915.member_1[2]))), _e1915.member_4);
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
