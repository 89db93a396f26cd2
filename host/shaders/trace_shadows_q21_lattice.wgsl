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

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_23 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_37 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: f32,
    member_1: bool,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<i32>,
}

struct type_56 {
    member: array<array<u32, 7>>,
}

struct type_61 {
    member: type_30,
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
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(1) 
var<uniform> global_3: type_44;
@group(0) @binding(2) 
var<uniform> global_4: type_44;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_47;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_69;
@group(0) @binding(3) 
var<storage> global_8: type_56;
@group(0) @binding(7) 
var<storage> global_9: type_33;
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
    var phi_410_: type_37;
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
    var phi_1019_: type_42;
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
    var phi_1146_: type_42;
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
    var phi_2054_: type_21;
    var phi_2056_: type_21;
    var phi_2057_: bool;
    var phi_2061_: type_21;
    var phi_2062_: type_21;
    var phi_2063_: type_21;
    var phi_2064_: bool;
    var phi_2068_: type_21;
    var phi_2069_: bool;
    var phi_2073_: type_21;
    var phi_2074_: bool;
    var phi_2078_: type_21;
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
    var phi_2412_: type_42;
    var phi_2413_: type_42;
    var phi_4146_: bool;
    var phi_1147_: type_42;
    var phi_4145_: bool;
    var local_13: type_42;
    var phi_4225_: bool;
    var phi_3796_: type_42;
    var phi_3797_: type_61;
    var phi_3798_: bool;
    var phi_3799_: u32;
    var phi_4224_: bool;
    var phi_3800_: type_42;
    var phi_3801_: type_61;
    var phi_3802_: u32;
    var phi_3803_: bool;
    var phi_3804_: u32;
    var phi_4223_: bool;
    var phi_3805_: type_42;
    var phi_3806_: type_61;
    var phi_3807_: u32;
    var phi_3808_: bool;
    var phi_3809_: u32;
    var phi_4222_: bool;
    var phi_1020_: type_42;
    var phi_1023_: type_61;
    var phi_1025_: u32;
    var phi_1027_: bool;
    var phi_1029_: u32;
    var phi_3810_: bool;
    var phi_4221_: bool;
    var local_14: type_42;
    var local_15: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e101 = global;
            let _e103 = arrayLength((&global_8.member));
            let _e106 = arrayLength((&global_10.member));
            let _e118 = arrayLength((&global_7.member));
            let _e122 = global_4.member[0u][0u];
            let _e126 = global_4.member[0u][1u];
            let _e130 = global_4.member[0u][2u];
            let _e134 = global_4.member[0u][3u];
            let _e138 = global_4.member[1u][0u];
            let _e142 = global_4.member[1u][1u];
            let _e146 = global_4.member[1u][2u];
            let _e150 = (_e101.x + (_e101.y * 2097152u));
            let _e162 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e134) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            local = array<i32, 3>(bitcast<i32>(_e138), bitcast<i32>(_e142), bitcast<i32>(_e146));
            let _e165 = (_e150 < arrayLength((&global_9.member)));
            if _e165 {
                if _e165 {
                } else {
                    break;
                }
                let _e169 = global_9.member[_e150].member_2;
                phi_342_ = _e169;
            } else {
                phi_342_ = 4294967295u;
            }
            let _e171 = phi_342_;
            let _e174 = global_1.member[0u];
            let _e178 = global_3.member[0u][0u];
            let _e182 = global_3.member[0u][1u];
            let _e186 = global_3.member[0u][2u];
            let _e190 = global_3.member[0u][3u];
            let _e194 = global_3.member[1u][0u];
            let _e198 = global_3.member[1u][1u];
            let _e202 = global_3.member[1u][2u];
            let _e206 = global_3.member[1u][3u];
            let _e207 = bitcast<f32>(_e178);
            let _e208 = bitcast<f32>(_e182);
            let _e209 = bitcast<f32>(_e186);
            let _e211 = bitcast<f32>(_e194);
            let _e212 = array<u32, 3>(_e198, _e202, _e206);
            let _e214 = bitcast<i32>(_e174);
            if (_e214 < -126i) {
                phi_386_ = -126i;
            } else {
                phi_386_ = select(_e214, 127i, (_e214 > 127i));
            }
            let _e219 = phi_386_;
            let _e224 = bitcast<f32>((bitcast<u32>((_e219 + 127i)) << bitcast<u32>(23i)));
            let _e230 = bitcast<f32>((bitcast<u32>(((_e214 - _e219) + 127i)) << bitcast<u32>(23i)));
            if (_e190 == 0u) {
                phi_410_ = type_37(array<f32, 3>(_e207, _e208, _e209), _e190, _e211, _e212);
            } else {
                phi_410_ = type_37(array<f32, 3>(((_e207 * _e224) * _e230), ((_e208 * _e224) * _e230), ((_e209 * _e224) * _e230)), _e190, ((_e211 * _e224) * _e230), _e212);
            }
            let _e243 = phi_410_;
            if _e165 {
                let _e244 = (_e150 < arrayLength((&global_2.member)));
                if _e244 {
                    if _e165 {
                    } else {
                        break;
                    }
                    let _e249 = global_9.member[_e150].member.member_1;
                    let _e254 = global_9.member[_e150].member.member_3;
                    if (_e249 <= _e254) {
                        let _e256 = (1u < _e118);
                        if _e256 {
                            if (0u < _e118) {
                            } else {
                                break;
                            }
                            let _e260 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e260 + 1u) < _e260) {
                                if _e256 {
                                } else {
                                    break;
                                }
                                let _e265 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e165 {
                        } else {
                            break;
                        }
                        let _e275 = global_9.member[_e150].member.member_2[0u];
                        let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                        let _e283 = global_9.member[_e150].member.member_2[1u];
                        let _e285 = (bitcast<u32>(_e283) & 2147483647u);
                        let _e291 = global_9.member[_e150].member.member_2[2u];
                        let _e293 = (bitcast<u32>(_e291) & 2147483647u);
                        let _e299 = global_9.member[_e150].member.member[0u];
                        let _e301 = (bitcast<u32>(_e299) & 2147483647u);
                        let _e307 = global_9.member[_e150].member.member[1u];
                        let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                        let _e315 = global_9.member[_e150].member.member[2u];
                        let _e317 = (bitcast<u32>(_e315) & 2147483647u);
                        let _e319 = select(_e285, _e277, (_e285 < _e277));
                        let _e321 = select(_e293, _e319, (_e293 < _e319));
                        let _e323 = select(_e301, _e321, (_e301 < _e321));
                        let _e325 = select(_e309, _e323, (_e309 < _e323));
                        let _e327 = select(_e317, _e325, (_e317 < _e325));
                        let _e329 = (bitcast<u32>(_e249) & 2147483647u);
                        let _e338 = (((select(_e329, _e327, (_e329 < _e327)) < 2139095040u) && ((bitcast<u32>(_e254) & 2147483647u) <= 2139095040u)) && (_e321 > 0u));
                        if _e338 {
                            let _e341 = (bitcast<u32>(bitcast<f32>(_e321)) & 2147483647u);
                            if (_e341 >= 8388608u) {
                                phi_560_ = (bitcast<i32>((_e341 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_560_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e341)), 32u, (_e341 == 0u))));
                            }
                            let _e355 = phi_560_;
                            phi_561_ = _e355;
                        } else {
                            phi_561_ = 0i;
                        }
                        let _e357 = phi_561_;
                        let _e358 = (_e277 == _e321);
                        if _e358 {
                            phi_571_ = true;
                        } else {
                            phi_571_ = (_e285 == _e321);
                        }
                        let _e361 = phi_571_;
                        let _e362 = select(1u, 0u, _e358);
                        if _e361 {
                            let _e363 = (_e362 + 1u);
                            phi_581_ = _e363;
                            phi_582_ = _e363;
                            phi_584_ = select(true, false, (_e363 == 2u));
                        } else {
                            phi_581_ = u32();
                            phi_582_ = 0u;
                            phi_584_ = true;
                        }
                        let _e367 = phi_581_;
                        let _e369 = phi_582_;
                        let _e371 = phi_584_;
                        if _e371 {
                            phi_589_ = (_e369 + 1u);
                        } else {
                            phi_589_ = 0u;
                        }
                        let _e375 = phi_589_;
                        let _e376 = select(_e367, _e369, _e371);
                        let _e377 = select(_e362, select(2u, _e362, _e361), _e371);
                        let _e378 = -(_e357);
                        if (_e378 < -126i) {
                            phi_622_ = -126i;
                        } else {
                            phi_622_ = select(_e378, 127i, (_e378 > 127i));
                        }
                        let _e383 = phi_622_;
                        let _e388 = bitcast<f32>((bitcast<u32>((_e383 + 127i)) << bitcast<u32>(23i)));
                        let _e394 = bitcast<f32>((bitcast<u32>(((_e378 - _e383) + 127i)) << bitcast<u32>(23i)));
                        let _e399 = global_9.member[_e150].member.member;
                        let _e400 = (_e376 == 0u);
                        if _e400 {
                            phi_640_ = _e399[0];
                        } else {
                            phi_640_ = _e399[1];
                        }
                        let _e404 = phi_640_;
                        let _e405 = (_e376 == 2u);
                        if _e405 {
                            phi_646_ = _e399[2];
                        } else {
                            phi_646_ = _e404;
                        }
                        let _e408 = phi_646_;
                        let _e409 = global_9.member[_e150].member.member_2;
                        if _e400 {
                            phi_657_ = _e409[0];
                        } else {
                            phi_657_ = _e409[1];
                        }
                        let _e413 = phi_657_;
                        if _e405 {
                            phi_663_ = _e409[2];
                        } else {
                            phi_663_ = _e413;
                        }
                        let _e416 = phi_663_;
                        let _e418 = ((_e416 * _e388) * _e394);
                        let _e422 = (bitcast<f32>((bitcast<u32>(_e418) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e422 {
                            let _e426 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) * 0.00000011920929f);
                            phi_686_ = select(0.00000000000011368684f, _e426, (_e426 > 0.00000000000011368684f));
                        } else {
                            phi_686_ = 0f;
                        }
                        let _e430 = phi_686_;
                        let _e431 = (_e408 + _e430);
                        let _e432 = (_e408 - _e430);
                        let _e433 = select(_e418, 0f, _e422);
                        if _e422 {
                            phi_697_ = 38685626000000000000000000f;
                        } else {
                            phi_697_ = (1f / _e418);
                        }
                        let _e436 = phi_697_;
                        let _e437 = (_e375 == 0u);
                        if _e437 {
                            phi_706_ = _e399[0];
                        } else {
                            phi_706_ = _e399[1];
                        }
                        let _e441 = phi_706_;
                        let _e442 = (_e375 == 2u);
                        if _e442 {
                            phi_712_ = _e399[2];
                        } else {
                            phi_712_ = _e441;
                        }
                        let _e445 = phi_712_;
                        if _e437 {
                            phi_723_ = _e409[0];
                        } else {
                            phi_723_ = _e409[1];
                        }
                        let _e449 = phi_723_;
                        if _e442 {
                            phi_729_ = _e409[2];
                        } else {
                            phi_729_ = _e449;
                        }
                        let _e452 = phi_729_;
                        let _e454 = ((_e452 * _e388) * _e394);
                        let _e458 = (bitcast<f32>((bitcast<u32>(_e454) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e458 {
                            let _e462 = (bitcast<f32>((bitcast<u32>(_e445) & 2147483647u)) * 0.00000011920929f);
                            phi_752_ = select(0.00000000000011368684f, _e462, (_e462 > 0.00000000000011368684f));
                        } else {
                            phi_752_ = 0f;
                        }
                        let _e466 = phi_752_;
                        let _e467 = (_e445 + _e466);
                        let _e468 = (_e445 - _e466);
                        let _e469 = select(_e454, 0f, _e458);
                        if _e458 {
                            phi_763_ = 38685626000000000000000000f;
                        } else {
                            phi_763_ = (1f / _e454);
                        }
                        let _e472 = phi_763_;
                        let _e473 = (_e377 == 0u);
                        if _e473 {
                            phi_772_ = _e399[0];
                        } else {
                            phi_772_ = _e399[1];
                        }
                        let _e477 = phi_772_;
                        let _e478 = (_e377 == 2u);
                        if _e478 {
                            phi_778_ = _e399[2];
                        } else {
                            phi_778_ = _e477;
                        }
                        let _e481 = phi_778_;
                        if _e473 {
                            phi_789_ = _e409[0];
                        } else {
                            phi_789_ = _e409[1];
                        }
                        let _e485 = phi_789_;
                        if _e478 {
                            phi_795_ = _e409[2];
                        } else {
                            phi_795_ = _e485;
                        }
                        let _e488 = phi_795_;
                        let _e490 = ((_e488 * _e388) * _e394);
                        let _e494 = (bitcast<f32>((bitcast<u32>(_e490) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e494 {
                            let _e498 = (bitcast<f32>((bitcast<u32>(_e481) & 2147483647u)) * 0.00000011920929f);
                            phi_818_ = select(0.00000000000011368684f, _e498, (_e498 > 0.00000000000011368684f));
                        } else {
                            phi_818_ = 0f;
                        }
                        let _e502 = phi_818_;
                        let _e503 = (_e481 + _e502);
                        let _e504 = (_e481 - _e502);
                        let _e505 = select(_e490, 0f, _e494);
                        if _e494 {
                            phi_829_ = 38685626000000000000000000f;
                        } else {
                            phi_829_ = (1f / _e490);
                        }
                        let _e508 = phi_829_;
                        let _e511 = bitcast<f32>((bitcast<u32>(_e408) & 2147483647u));
                        let _e514 = bitcast<f32>((bitcast<u32>(_e445) & 2147483647u));
                        let _e516 = select(_e514, _e511, (_e511 > _e514));
                        let _e519 = bitcast<f32>((bitcast<u32>(_e481) & 2147483647u));
                        if (_e338 && (select(_e519, _e516, (_e516 > _e519)) <= 1099511600000f)) {
                            let _e524 = (_e357 / 3i);
                            let _e531 = bitcast<f32>((bitcast<u32>((_e524 + 127i)) << bitcast<u32>(23i)));
                            let _e538 = bitcast<f32>((bitcast<u32>(((_e357 - (2i * _e524)) + 127i)) << bitcast<u32>(23i)));
                            let _e539 = (((_e249 * _e531) * _e531) * _e538);
                            let _e541 = select(340282350000000000000000000000000000000f, _e539, (_e539 < 340282350000000000000000000000000000000f));
                            let _e546 = (((_e254 * _e531) * _e531) * _e538);
                            let _e548 = select(340282350000000000000000000000000000000f, _e546, (_e546 < 340282350000000000000000000000000000000f));
                            phi_929_ = select(-340282350000000000000000000000000000000f, _e548, (_e548 > -340282350000000000000000000000000000000f));
                            phi_930_ = select(-340282350000000000000000000000000000000f, _e541, (_e541 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_929_ = 0f;
                            phi_930_ = 1f;
                        }
                        let _e552 = phi_929_;
                        let _e554 = phi_930_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e558 = (_e376 % 3u);
                        let _e559 = (_e558 < 3u);
                        if _e559 {
                        } else {
                            break;
                        }
                        let _e561 = local_1[_e558];
                        let _e564 = (_e375 % 3u);
                        let _e565 = (_e564 < 3u);
                        if _e565 {
                        } else {
                            break;
                        }
                        let _e567 = local_1[_e564];
                        let _e570 = (_e377 % 3u);
                        let _e571 = (_e570 < 3u);
                        if _e571 {
                        } else {
                            break;
                        }
                        let _e573 = local_1[_e570];
                        if _e559 {
                        } else {
                            break;
                        }
                        let _e578 = local[_e558];
                        if _e565 {
                        } else {
                            break;
                        }
                        let _e582 = local[_e564];
                        if _e571 {
                        } else {
                            break;
                        }
                        let _e586 = local[_e570];
                        phi_4083_ = false;
                        phi_1019_ = type_42(_e552, false);
                        phi_1022_ = type_61(type_30(vec4<f32>((f32(_e561) * _e162), (f32(_e567) * _e162), (f32(_e573) * _e162), 0f), vec4<f32>((f32(_e578) * _e162), (f32(_e582) * _e162), (f32(_e586) * _e162), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                        phi_1024_ = ((3u * _e103) + 1u);
                        phi_1026_ = (_e554 <= _e552);
                        phi_1028_ = 0u;
                        loop {
                            let _e596 = phi_4083_;
                            let _e598 = phi_1019_;
                            let _e600 = phi_1022_;
                            let _e602 = phi_1024_;
                            let _e604 = phi_1026_;
                            let _e606 = phi_1028_;
                            local_14 = _e598;
                            if _e604 {
                                phi_1039_ = true;
                            } else {
                                phi_1039_ = (_e606 > 0u);
                            }
                            let _e609 = phi_1039_;
                            if _e609 {
                                let _e610 = (_e602 > 0u);
                                if _e610 {
                                    if _e604 {
                                        phi_1125_ = _e600;
                                        phi_1126_ = _e604;
                                        phi_1127_ = _e606;
                                    } else {
                                        let _e611 = (_e606 - 1u);
                                        let _e612 = (_e611 % 128u);
                                        let _e613 = (_e612 < 128u);
                                        if _e613 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e615 = local_7[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e617 = local_6[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e619 = local_5[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e621 = local_4[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e623 = local_3[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e625 = local_2[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e630 = local_8[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4221_ = true;
                                            break;
                                        }
                                        let _e633 = local_9[_e612];
                                        phi_1125_ = type_61(type_30(vec4<f32>(_e615, _e617, _e619, 0f), vec4<f32>(_e621, _e623, _e625, 0f)), _e630);
                                        phi_1126_ = (_e633 <= _e598.member);
                                        phi_1127_ = _e611;
                                    }
                                    let _e637 = phi_1125_;
                                    let _e639 = phi_1126_;
                                    let _e641 = phi_1127_;
                                    if _e639 {
                                        let _e646 = (_e637.member_1 & 268435455u);
                                        if ((_e637.member_1 & 2147483648u) != 0u) {
                                            phi_4080_ = _e596;
                                            phi_1146_ = _e598;
                                            phi_1149_ = type_8(0u, ((_e637.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1127 = phi_4080_;
                                                let _e1129 = phi_1146_;
                                                let _e1131 = phi_1149_;
                                                local_13 = _e1129;
                                                local_15 = _e1129;
                                                if (_e1131.member < _e1131.member_1) {
                                                    phi_1150_ = type_8((_e1131.member + 1u), _e1131.member_1);
                                                    phi_1172_ = type_8(1u, _e1131.member);
                                                } else {
                                                    phi_1150_ = _e1131;
                                                    phi_1172_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1144 = phi_1150_;
                                                let _e1146 = phi_1172_;
                                                let _e1150 = (bitcast<i32>(_e1146.member) != 0i);
                                                if _e1150 {
                                                    let _e1155 = (_e637.member.member_1.x - _e637.member.member.x);
                                                    let _e1158 = (_e637.member.member_1.y - _e637.member.member.y);
                                                    let _e1161 = (_e637.member.member_1.z - _e637.member.member.z);
                                                    let _e1163 = select(_e1158, _e1155, (_e1155 > _e1158));
                                                    let _e1165 = select(_e1161, _e1163, (_e1163 > _e1161));
                                                    let _e1167 = (_e1165 < (1024f * _e162));
                                                    if _e1167 {
                                                        phi_1213_ = 0u;
                                                    } else {
                                                        phi_1213_ = select(2u, 1u, (_e1165 < (2097152f * _e162)));
                                                    }
                                                    let _e1172 = phi_1213_;
                                                    switch bitcast<i32>(_e1172) {
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
                                                    let _e1175 = phi_1219_;
                                                    switch bitcast<i32>(_e1172) {
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
                                                    let _e1182 = phi_1229_;
                                                    let _e1184 = ((_e646 + (_e1146.member_1 * ((3u * _e1175) + 1u))) + (3u * _e1182));
                                                    let _e1185 = (_e1184 < _e106);
                                                    if _e1185 {
                                                        if _e1185 {
                                                        } else {
                                                            phi_4145_ = true;
                                                            break;
                                                        }
                                                        let _e1187 = global_10.member[_e1184];
                                                        phi_1245_ = _e1187;
                                                    } else {
                                                        phi_1245_ = 4294967295u;
                                                    }
                                                    let _e1189 = phi_1245_;
                                                    local_10 = array<u32, 3>(_e376, _e375, _e377);
                                                    if _e1167 {
                                                        phi_1282_ = 0u;
                                                    } else {
                                                        phi_1282_ = select(2u, 1u, (_e1165 < (2097152f * _e162)));
                                                    }
                                                    let _e1195 = phi_1282_;
                                                    switch bitcast<i32>(_e1195) {
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
                                                    let _e1198 = phi_1288_;
                                                    switch bitcast<i32>(_e1195) {
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
                                                    let _e1205 = phi_1298_;
                                                    local_12 = array<f32, 4>(_e637.member.member.x, _e637.member.member.y, _e637.member.member.z, _e637.member.member.w);
                                                    local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4065_ = _e1127;
                                                    phi_1314_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1219 = phi_4065_;
                                                        let _e1221 = phi_1314_;
                                                        if (_e1221.member < _e1221.member_1) {
                                                            phi_1315_ = type_8((_e1221.member + 1u), _e1221.member_1);
                                                            phi_1338_ = type_8(1u, _e1221.member);
                                                        } else {
                                                            phi_1315_ = _e1221;
                                                            phi_1338_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1234 = phi_1315_;
                                                        let _e1236 = phi_1338_;
                                                        let _e1240 = (bitcast<i32>(_e1236.member) != 0i);
                                                        if _e1240 {
                                                            let _e1242 = ((_e646 + (_e1146.member_1 * ((3u * _e1198) + 1u))) + (_e1236.member_1 * _e1205));
                                                            let _e1243 = (_e1242 < _e106);
                                                            if _e1243 {
                                                                if _e1243 {
                                                                } else {
                                                                    phi_4143_ = true;
                                                                    break;
                                                                }
                                                                let _e1245 = global_10.member[_e1242];
                                                                phi_1361_ = _e1245;
                                                            } else {
                                                                phi_1361_ = 0u;
                                                            }
                                                            let _e1247 = phi_1361_;
                                                            let _e1248 = (_e1242 + 1u);
                                                            let _e1249 = (_e1248 < _e106);
                                                            if _e1249 {
                                                                if _e1249 {
                                                                } else {
                                                                    phi_4143_ = true;
                                                                    break;
                                                                }
                                                                let _e1251 = global_10.member[_e1248];
                                                                phi_1376_ = _e1251;
                                                            } else {
                                                                phi_1376_ = 0u;
                                                            }
                                                            let _e1253 = phi_1376_;
                                                            phi_1379_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1255 = phi_1379_;
                                                                if (_e1255.member < _e1255.member_1) {
                                                                    phi_1380_ = type_8((_e1255.member + 1u), _e1255.member_1);
                                                                    phi_1403_ = type_8(1u, _e1255.member);
                                                                } else {
                                                                    phi_1380_ = _e1255;
                                                                    phi_1403_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1268 = phi_1380_;
                                                                let _e1270 = phi_1403_;
                                                                let _e1274 = (bitcast<i32>(_e1270.member) != 0i);
                                                                if _e1274 {
                                                                    let _e1275 = (_e1270.member_1 < 3u);
                                                                    if _e1275 {
                                                                    } else {
                                                                        phi_4058_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1277 = local_10[_e1270.member_1];
                                                                    if (_e1270.member_1 < 4u) {
                                                                    } else {
                                                                        phi_4058_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1280 = local_12[_e1270.member_1];
                                                                    switch bitcast<i32>(_e1195) {
                                                                        case 0: {
                                                                            phi_1473_ = (_e1280 + (f32(((_e1247 >> bitcast<u32>(((10u * _e1277) & 31u))) & 1023u)) * _e162));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1277 == 0u) {
                                                                                phi_1450_ = _e1247;
                                                                            } else {
                                                                                if (_e1277 == 1u) {
                                                                                    phi_1449_ = ((_e1247 >> bitcast<u32>(21i)) | (_e1253 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_1449_ = (_e1253 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1301 = phi_1449_;
                                                                                phi_1450_ = _e1301;
                                                                            }
                                                                            let _e1303 = phi_1450_;
                                                                            phi_1473_ = (_e1280 + (f32((_e1303 & 2097151u)) * _e162));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1282 = (_e1242 + _e1277);
                                                                            let _e1283 = (_e1282 < _e106);
                                                                            if _e1283 {
                                                                                if _e1283 {
                                                                                } else {
                                                                                    phi_4058_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1285 = global_10.member[_e1282];
                                                                                phi_1469_ = _e1285;
                                                                            } else {
                                                                                phi_1469_ = 0u;
                                                                            }
                                                                            let _e1287 = phi_1469_;
                                                                            phi_1473_ = (f32(bitcast<i32>(_e1287)) * _e162);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_1473_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1317 = phi_1473_;
                                                                    if (_e1236.member_1 < 3u) {
                                                                    } else {
                                                                        phi_4058_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1275 {
                                                                    } else {
                                                                        phi_4058_ = true;
                                                                        break;
                                                                    }
                                                                    local_11[_e1236.member_1][_e1270.member_1] = _e1317;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_1379_ = _e1268;
                                                                    phi_4058_ = _e1219;
                                                                    break if !(_e1274);
                                                                }
                                                            }
                                                            let _e1323 = phi_4058_;
                                                            phi_4143_ = _e1323;
                                                            if _e1323 {
                                                                break;
                                                            }
                                                            phi_4144_ = _e1323;
                                                        } else {
                                                            phi_4144_ = _e1219;
                                                        }
                                                        let _e1325 = phi_4144_;
                                                        continue;
                                                        continuing {
                                                            phi_4065_ = _e1325;
                                                            phi_1314_ = _e1234;
                                                            phi_4143_ = _e1325;
                                                            break if !(_e1240);
                                                        }
                                                    }
                                                    let _e1328 = phi_4143_;
                                                    phi_4145_ = _e1328;
                                                    if _e1328 {
                                                        break;
                                                    }
                                                    let _e1329 = local_11;
                                                    let _e1345 = (_e1329[0][2] - _e481);
                                                    let _e1348 = (((_e1329[0][0] - _e408) * _e505) - (_e1345 * _e433));
                                                    let _e1351 = (((_e1329[0][1] - _e445) * _e505) - (_e1345 * _e469));
                                                    let _e1354 = (_e1329[1][2] - _e481);
                                                    let _e1357 = (((_e1329[1][0] - _e408) * _e505) - (_e1354 * _e433));
                                                    let _e1360 = (((_e1329[1][1] - _e445) * _e505) - (_e1354 * _e469));
                                                    let _e1363 = (_e1329[2][2] - _e481);
                                                    let _e1366 = (((_e1329[2][0] - _e408) * _e505) - (_e1363 * _e433));
                                                    let _e1369 = (((_e1329[2][1] - _e445) * _e505) - (_e1363 * _e469));
                                                    let _e1370 = (_e1366 * _e1360);
                                                    let _e1371 = (_e1369 * _e1357);
                                                    let _e1372 = (_e1348 * _e1369);
                                                    let _e1373 = (_e1351 * _e1366);
                                                    let _e1374 = (_e1357 * _e1351);
                                                    let _e1375 = (_e1360 * _e1348);
                                                    let _e1380 = (((_e1370 >= _e1371) && (_e1372 >= _e1373)) && (_e1374 >= _e1375));
                                                    if (_e1380 || (((_e1370 <= _e1371) && (_e1372 <= _e1373)) && (_e1374 <= _e1375))) {
                                                        let _e1387 = select(-1f, 1f, _e1380);
                                                        let _e1389 = ((_e1370 - _e1371) * _e1387);
                                                        let _e1391 = select(0f, _e1389, (_e1389 > 0f));
                                                        let _e1393 = ((_e1372 - _e1373) * _e1387);
                                                        let _e1395 = select(0f, _e1393, (_e1393 > 0f));
                                                        let _e1397 = ((_e1374 - _e1375) * _e1387);
                                                        let _e1399 = select(0f, _e1397, (_e1397 > 0f));
                                                        let _e1401 = ((_e1391 + _e1395) + _e1399);
                                                        if (_e1401 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2068_ = type_21();
                                                            phi_2069_ = true;
                                                        } else {
                                                            let _e1404 = select(_e1329[1][0], _e1329[0][0], (_e1329[0][0] < _e1329[1][0]));
                                                            let _e1408 = select(_e1329[1][0], _e1329[0][0], (_e1329[0][0] > _e1329[1][0]));
                                                            let _e1412 = select(_e1329[1][1], _e1329[0][1], (_e1329[0][1] < _e1329[1][1]));
                                                            let _e1416 = select(_e1329[1][1], _e1329[0][1], (_e1329[0][1] > _e1329[1][1]));
                                                            let _e1420 = select(_e1329[1][2], _e1329[0][2], (_e1329[0][2] < _e1329[1][2]));
                                                            let _e1424 = select(_e1329[1][2], _e1329[0][2], (_e1329[0][2] > _e1329[1][2]));
                                                            let _e1429 = ((select(_e1329[2][0], _e1404, (_e1404 < _e1329[2][0])) - _e431) * _e436);
                                                            let _e1430 = ((select(_e1329[2][0], _e1408, (_e1408 > _e1329[2][0])) - _e432) * _e436);
                                                            let _e1433 = ((select(_e1329[2][1], _e1412, (_e1412 < _e1329[2][1])) - _e467) * _e472);
                                                            let _e1434 = ((select(_e1329[2][1], _e1416, (_e1416 > _e1329[2][1])) - _e468) * _e472);
                                                            let _e1437 = ((select(_e1329[2][2], _e1420, (_e1420 < _e1329[2][2])) - _e503) * _e508);
                                                            let _e1438 = ((select(_e1329[2][2], _e1424, (_e1424 > _e1329[2][2])) - _e504) * _e508);
                                                            let _e1440 = select(_e1438, _e1437, (_e1437 < _e1438));
                                                            let _e1442 = select(_e1438, _e1437, (_e1437 > _e1438));
                                                            let _e1444 = select(_e1430, _e1429, (_e1429 < _e1430));
                                                            let _e1446 = select(_e1434, _e1433, (_e1433 < _e1434));
                                                            let _e1448 = select(_e1446, _e1444, (_e1444 > _e1446));
                                                            let _e1450 = select(_e1440, _e1448, (_e1448 > _e1440));
                                                            let _e1452 = select(_e1430, _e1429, (_e1429 > _e1430));
                                                            let _e1454 = select(_e1434, _e1433, (_e1433 > _e1434));
                                                            let _e1456 = select(_e1454, _e1452, (_e1452 < _e1454));
                                                            let _e1458 = select(_e1442, _e1456, (_e1456 < _e1442));
                                                            let _e1459 = -(_e1440);
                                                            let _e1465 = select(_e554, _e1450, (_e1450 > _e554));
                                                            if (_e1465 > (_e1458 + (select(_e1459, _e1442, (_e1442 > _e1459)) * 0.0000019073523f))) {
                                                                phi_2063_ = type_21();
                                                                phi_2064_ = true;
                                                            } else {
                                                                let _e1467 = (_e1465 > _e1129.member);
                                                                if _e1467 {
                                                                    phi_2062_ = type_21();
                                                                } else {
                                                                    let _e1471 = (_e1329[1][0] - _e1329[0][0]);
                                                                    let _e1472 = (_e1329[1][1] - _e1329[0][1]);
                                                                    let _e1473 = (_e1329[1][2] - _e1329[0][2]);
                                                                    let _e1474 = vec3<f32>(_e1471, _e1472, _e1473);
                                                                    let _e1475 = (_e1329[2][0] - _e1329[1][0]);
                                                                    let _e1476 = (_e1329[2][1] - _e1329[1][1]);
                                                                    let _e1477 = (_e1329[2][2] - _e1329[1][2]);
                                                                    let _e1478 = vec3<f32>(_e1475, _e1476, _e1477);
                                                                    let _e1479 = (_e1329[0][0] - _e1329[2][0]);
                                                                    let _e1480 = (_e1329[0][1] - _e1329[2][1]);
                                                                    let _e1481 = (_e1329[0][2] - _e1329[2][2]);
                                                                    let _e1482 = vec3<f32>(_e1479, _e1480, _e1481);
                                                                    let _e1485 = bitcast<f32>((bitcast<u32>(_e1471) & 2147483647u));
                                                                    let _e1488 = bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u));
                                                                    let _e1490 = select(_e1488, _e1485, (_e1485 > _e1488));
                                                                    let _e1493 = bitcast<f32>((bitcast<u32>(_e1473) & 2147483647u));
                                                                    let _e1495 = select(_e1493, _e1490, (_e1490 > _e1493));
                                                                    let _e1498 = bitcast<f32>((bitcast<u32>(_e1475) & 2147483647u));
                                                                    let _e1501 = bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u));
                                                                    let _e1503 = select(_e1501, _e1498, (_e1498 > _e1501));
                                                                    let _e1506 = bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u));
                                                                    let _e1508 = select(_e1506, _e1503, (_e1503 > _e1506));
                                                                    let _e1511 = bitcast<f32>((bitcast<u32>(_e1479) & 2147483647u));
                                                                    let _e1514 = bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u));
                                                                    let _e1516 = select(_e1514, _e1511, (_e1511 > _e1514));
                                                                    let _e1519 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                    let _e1521 = select(_e1519, _e1516, (_e1516 > _e1519));
                                                                    let _e1523 = select(_e1508, _e1495, (_e1495 > _e1508));
                                                                    let _e1525 = select(_e1521, _e1523, (_e1523 > _e1521));
                                                                    if (_e1495 == _e1525) {
                                                                        phi_1973_ = _e1478;
                                                                        phi_1974_ = _e1482;
                                                                    } else {
                                                                        let _e1528 = vec3((_e1508 == _e1525));
                                                                        phi_1973_ = select(_e1474, _e1482, _e1528);
                                                                        phi_1974_ = select(_e1478, _e1474, _e1528);
                                                                    }
                                                                    let _e1532 = phi_1973_;
                                                                    let _e1534 = phi_1974_;
                                                                    let _e1541 = ((_e1532.y * _e1534.z) - (_e1534.y * _e1532.z));
                                                                    let _e1546 = ((_e1532.z * _e1534.x) - (_e1534.z * _e1532.x));
                                                                    let _e1549 = ((_e1532.x * _e1534.y) - (_e1534.x * _e1532.y));
                                                                    if (_e1391 >= _e1395) {
                                                                        phi_2005_ = select(true, false, (_e1391 >= _e1399));
                                                                    } else {
                                                                        phi_2005_ = true;
                                                                    }
                                                                    let _e1554 = phi_2005_;
                                                                    if _e1554 {
                                                                        phi_2014_ = select(vec3<f32>(_e1329[2][0], _e1329[2][1], _e1329[2][2]), vec3<f32>(_e1329[1][0], _e1329[1][1], _e1329[1][2]), vec3((_e1395 >= _e1399)));
                                                                    } else {
                                                                        phi_2014_ = vec3<f32>(_e1329[0][0], _e1329[0][1], _e1329[0][2]);
                                                                    }
                                                                    let _e1559 = phi_2014_;
                                                                    let _e1576 = ((((_e1541 * (_e1559.x - _e408)) + (_e1546 * (_e1559.y - _e445))) + (_e1549 * (_e1559.z - _e481))) / (((_e1541 * _e433) + (_e1546 * _e469)) + (_e1549 * _e505)));
                                                                    let _e1578 = select(_e1458, _e1576, (_e1576 < _e1458));
                                                                    let _e1580 = select(_e1450, _e1578, (_e1578 > _e1450));
                                                                    if (_e1580 >= _e554) {
                                                                        let _e1582 = (_e1580 <= _e1129.member);
                                                                        if _e1582 {
                                                                            let _e1583 = (1f / _e1401);
                                                                            phi_2054_ = type_21(_e1580, (_e1395 * _e1583), (_e1399 * _e1583), _e1189);
                                                                        } else {
                                                                            phi_2054_ = type_21();
                                                                        }
                                                                        let _e1588 = phi_2054_;
                                                                        phi_2056_ = _e1588;
                                                                        phi_2057_ = select(true, false, _e1582);
                                                                    } else {
                                                                        phi_2056_ = type_21();
                                                                        phi_2057_ = true;
                                                                    }
                                                                    let _e1591 = phi_2056_;
                                                                    let _e1593 = phi_2057_;
                                                                    if _e1593 {
                                                                        phi_2061_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2061_ = _e1591;
                                                                    }
                                                                    let _e1595 = phi_2061_;
                                                                    phi_2062_ = _e1595;
                                                                }
                                                                let _e1597 = phi_2062_;
                                                                phi_2063_ = _e1597;
                                                                phi_2064_ = _e1467;
                                                            }
                                                            let _e1599 = phi_2063_;
                                                            let _e1601 = phi_2064_;
                                                            phi_2068_ = _e1599;
                                                            phi_2069_ = _e1601;
                                                        }
                                                        let _e1603 = phi_2068_;
                                                        let _e1605 = phi_2069_;
                                                        phi_2073_ = _e1603;
                                                        phi_2074_ = _e1605;
                                                    } else {
                                                        phi_2073_ = type_21();
                                                        phi_2074_ = true;
                                                    }
                                                    let _e1607 = phi_2073_;
                                                    let _e1609 = phi_2074_;
                                                    if _e1609 {
                                                        phi_2078_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2078_ = _e1607;
                                                    }
                                                    let _e1611 = phi_2078_;
                                                    if (_e1611.member_3 != 4294967295u) {
                                                        if (_e1189 == _e171) {
                                                            phi_2407_ = false;
                                                        } else {
                                                            let _e1615 = (_e1189 < arrayLength((&global_5.member)));
                                                            if _e1615 {
                                                                if _e1615 {
                                                                } else {
                                                                    phi_4145_ = true;
                                                                    break;
                                                                }
                                                                let _e1617 = global_5.member[_e1189];
                                                                phi_2101_ = _e1617;
                                                            } else {
                                                                phi_2101_ = 4294967295u;
                                                            }
                                                            let _e1619 = phi_2101_;
                                                            let _e1620 = (_e1619 < arrayLength((&global_6.member)));
                                                            if _e1620 {
                                                                if _e1620 {
                                                                } else {
                                                                    phi_4145_ = true;
                                                                    break;
                                                                }
                                                                let _e1622 = global_6.member[_e1619];
                                                                phi_2115_ = _e1622;
                                                            } else {
                                                                phi_2115_ = 0i;
                                                            }
                                                            let _e1624 = phi_2115_;
                                                            let _e1625 = (_e1624 == 0i);
                                                            if _e1625 {
                                                                phi_2406_ = true;
                                                            } else {
                                                                if _e400 {
                                                                    phi_2136_ = vec3<f32>(_e1329[0][0], _e1329[0][1], _e1329[0][2]);
                                                                } else {
                                                                    if (_e376 == 1u) {
                                                                        phi_2135_ = vec3<f32>(_e1329[0][2], _e1329[0][0], _e1329[0][1]);
                                                                    } else {
                                                                        phi_2135_ = vec3<f32>(_e1329[0][1], _e1329[0][2], _e1329[0][0]);
                                                                    }
                                                                    let _e1630 = phi_2135_;
                                                                    phi_2136_ = _e1630;
                                                                }
                                                                let _e1633 = phi_2136_;
                                                                if _e400 {
                                                                    phi_2153_ = vec3<f32>(_e1329[1][0], _e1329[1][1], _e1329[1][2]);
                                                                } else {
                                                                    if (_e376 == 1u) {
                                                                        phi_2152_ = vec3<f32>(_e1329[1][2], _e1329[1][0], _e1329[1][1]);
                                                                    } else {
                                                                        phi_2152_ = vec3<f32>(_e1329[1][1], _e1329[1][2], _e1329[1][0]);
                                                                    }
                                                                    let _e1638 = phi_2152_;
                                                                    phi_2153_ = _e1638;
                                                                }
                                                                let _e1641 = phi_2153_;
                                                                if _e400 {
                                                                    phi_2170_ = vec3<f32>(_e1329[2][0], _e1329[2][1], _e1329[2][2]);
                                                                } else {
                                                                    if (_e376 == 1u) {
                                                                        phi_2169_ = vec3<f32>(_e1329[2][2], _e1329[2][0], _e1329[2][1]);
                                                                    } else {
                                                                        phi_2169_ = vec3<f32>(_e1329[2][1], _e1329[2][2], _e1329[2][0]);
                                                                    }
                                                                    let _e1646 = phi_2169_;
                                                                    phi_2170_ = _e1646;
                                                                }
                                                                let _e1649 = phi_2170_;
                                                                let _e1652 = (_e1641.x - _e1633.x);
                                                                let _e1655 = (_e1641.y - _e1633.y);
                                                                let _e1658 = (_e1641.z - _e1633.z);
                                                                let _e1660 = (_e1649.x - _e1633.x);
                                                                let _e1662 = (_e1649.y - _e1633.y);
                                                                let _e1664 = (_e1649.z - _e1633.z);
                                                                if (_e243.member_1 == 1u) {
                                                                    phi_2206_ = (vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]) - _e1633);
                                                                } else {
                                                                    phi_2206_ = vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]);
                                                                }
                                                                let _e1679 = phi_2206_;
                                                                let _e1685 = bitcast<f32>((bitcast<u32>((_e1652 * _e1662)) ^ _e243.member_3[0]));
                                                                let _e1689 = bitcast<f32>((bitcast<u32>((_e1655 * _e1660)) ^ _e243.member_3[0]));
                                                                let _e1693 = bitcast<f32>((bitcast<u32>((_e1655 * _e1664)) ^ _e243.member_3[0]));
                                                                let _e1697 = bitcast<f32>((bitcast<u32>((_e1658 * _e1662)) ^ _e243.member_3[0]));
                                                                let _e1701 = bitcast<f32>((bitcast<u32>((_e1658 * _e1660)) ^ _e243.member_3[0]));
                                                                let _e1705 = bitcast<f32>((bitcast<u32>((_e1652 * _e1664)) ^ _e243.member_3[0]));
                                                                let _e1706 = (_e1693 - _e1697);
                                                                let _e1707 = (_e1701 - _e1705);
                                                                let _e1708 = (_e1685 - _e1689);
                                                                let _e1732 = (bitcast<f32>((bitcast<u32>(_e1693) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1697) & 2147483647u)));
                                                                let _e1739 = (bitcast<f32>((bitcast<u32>(_e1701) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1705) & 2147483647u)));
                                                                let _e1746 = (bitcast<f32>((bitcast<u32>(_e1685) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1689) & 2147483647u)));
                                                                if (_e243.member_2 == 0f) {
                                                                    phi_2388_ = 0f;
                                                                } else {
                                                                    let _e1776 = bitcast<f32>((bitcast<u32>(_e1706) & 2147483647u));
                                                                    let _e1779 = bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u));
                                                                    let _e1782 = bitcast<f32>((bitcast<u32>(_e1708) & 2147483647u));
                                                                    let _e1784 = select(_e1782, _e1779, (_e1779 > _e1782));
                                                                    let _e1788 = select(_e1782, _e1779, (_e1779 < _e1782));
                                                                    let _e1792 = select(_e1779, _e1776, (_e1776 < _e1779));
                                                                    let _e1794 = select(_e1779, _e1776, (_e1776 > _e1779));
                                                                    let _e1796 = select(_e1782, _e1794, (_e1794 < _e1782));
                                                                    phi_2388_ = bitcast<f32>((bitcast<u32>((_e243.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1784, _e1776, (_e1776 > _e1784)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1796, _e1792, (_e1792 > _e1796)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1788, _e1776, (_e1776 < _e1788)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1732 + _e1739) + _e1746))) ^ _e243.member_3[0]))) * 1.0000005f)) ^ _e243.member_3[0])))) ^ _e243.member_3[0]));
                                                                }
                                                                let _e1823 = phi_2388_;
                                                                phi_2406_ = (_e1625 || !(((((bitcast<f32>((bitcast<u32>((_e1679.x * _e1706)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1679.y * _e1707)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1679.z * _e1708)) ^ _e243.member_3[0]))) * f32(-(_e1624))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1679.x) & 2147483647u)) * _e1732)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1679.y) & 2147483647u)) * _e1739)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1679.z) & 2147483647u)) * _e1746)) ^ _e243.member_3[0]))))) ^ _e243.member_3[0])) + _e1823) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1837 = phi_2406_;
                                                            phi_2407_ = _e1837;
                                                        }
                                                        let _e1839 = phi_2407_;
                                                        if _e1839 {
                                                            phi_2412_ = type_42(_e1129.member, true);
                                                        } else {
                                                            phi_2412_ = _e1129;
                                                        }
                                                        let _e1844 = phi_2412_;
                                                        phi_2413_ = _e1844;
                                                    } else {
                                                        phi_2413_ = _e1129;
                                                    }
                                                    let _e1846 = phi_2413_;
                                                    phi_4146_ = _e1328;
                                                    phi_1147_ = _e1846;
                                                } else {
                                                    phi_4146_ = _e1127;
                                                    phi_1147_ = type_42();
                                                }
                                                let _e1848 = phi_4146_;
                                                let _e1850 = phi_1147_;
                                                continue;
                                                continuing {
                                                    phi_4080_ = _e1848;
                                                    phi_1146_ = _e1850;
                                                    phi_1149_ = _e1144;
                                                    phi_4145_ = _e1848;
                                                    break if !(_e1150);
                                                }
                                            }
                                            let _e1853 = phi_4145_;
                                            phi_4221_ = _e1853;
                                            if _e1853 {
                                                break;
                                            }
                                            let _e1855 = local_13;
                                            phi_4225_ = _e1853;
                                            let _e2067 = local_15;
                                            phi_3796_ = _e2067;
                                            phi_3797_ = _e637;
                                            phi_3798_ = false;
                                            phi_3799_ = select(_e641, 0u, _e1855.member_1);
                                        } else {
                                            if (_e637.member_1 >= _e103) {
                                                phi_3352_ = type_62(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_61(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_61(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e637.member_1 < _e103) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e655 = ((1u + (_e376 * 2u)) % 7u);
                                                if (_e655 < 7u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e660 = global_8.member[_e637.member_1][_e655];
                                                let _e663 = ((1u + (_e375 * 2u)) % 7u);
                                                if (_e663 < 7u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e668 = global_8.member[_e637.member_1][_e663];
                                                let _e671 = ((1u + (_e377 * 2u)) % 7u);
                                                if (_e671 < 7u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e676 = global_8.member[_e637.member_1][_e671];
                                                let _e679 = (((_e376 + 1u) * 2u) % 7u);
                                                if (_e679 < 7u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e684 = global_8.member[_e637.member_1][_e679];
                                                let _e687 = (((_e375 + 1u) * 2u) % 7u);
                                                if (_e687 < 7u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e692 = global_8.member[_e637.member_1][_e687];
                                                let _e695 = (((_e377 + 1u) * 2u) % 7u);
                                                if (_e695 < 7u) {
                                                } else {
                                                    phi_4221_ = true;
                                                    break;
                                                }
                                                let _e700 = global_8.member[_e637.member_1][_e695];
                                                let _e723 = (bitcast<f32>((bitcast<u32>((_e637.member.member_1.x - _e637.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e724 = (bitcast<f32>((bitcast<u32>((_e637.member.member_1.y - _e637.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e725 = (bitcast<f32>((bitcast<u32>((_e637.member.member_1.z - _e637.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e727 = select(_e162, _e723, (_e723 > _e162));
                                                let _e729 = select(_e162, _e724, (_e724 > _e162));
                                                let _e731 = select(_e162, _e725, (_e725 > _e162));
                                                let _e756 = bitcast<u32>((f32(bitcast<i32>((_e660 & 2097151u))) * _e727));
                                                let _e761 = (bitcast<i32>((_e660 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e764 = bitcast<f32>((_e756 & bitcast<u32>(_e761)));
                                                let _e765 = bitcast<u32>((f32(bitcast<i32>((_e668 & 2097151u))) * _e729));
                                                let _e770 = (bitcast<i32>((_e668 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e773 = bitcast<f32>((_e765 & bitcast<u32>(_e770)));
                                                let _e774 = bitcast<u32>((f32(bitcast<i32>((_e676 & 2097151u))) * _e731));
                                                let _e779 = (bitcast<i32>((_e676 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e782 = bitcast<f32>((_e774 & bitcast<u32>(_e779)));
                                                let _e786 = bitcast<f32>((_e756 & bitcast<u32>(~(_e761))));
                                                let _e790 = bitcast<f32>((_e765 & bitcast<u32>(~(_e770))));
                                                let _e794 = bitcast<f32>((_e774 & bitcast<u32>(~(_e779))));
                                                let _e795 = bitcast<u32>((f32(bitcast<i32>((_e684 & 2097151u))) * _e727));
                                                let _e800 = (bitcast<i32>((_e684 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e803 = bitcast<f32>((_e795 & bitcast<u32>(_e800)));
                                                let _e804 = bitcast<u32>((f32(bitcast<i32>((_e692 & 2097151u))) * _e729));
                                                let _e809 = (bitcast<i32>((_e692 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e812 = bitcast<f32>((_e804 & bitcast<u32>(_e809)));
                                                let _e813 = bitcast<u32>((f32(bitcast<i32>((_e700 & 2097151u))) * _e731));
                                                let _e818 = (bitcast<i32>((_e700 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e821 = bitcast<f32>((_e813 & bitcast<u32>(_e818)));
                                                let _e825 = bitcast<f32>((_e795 & bitcast<u32>(~(_e800))));
                                                let _e829 = bitcast<f32>((_e804 & bitcast<u32>(~(_e809))));
                                                let _e833 = bitcast<f32>((_e813 & bitcast<u32>(~(_e818))));
                                                let _e834 = (_e637.member.member.x + _e764);
                                                let _e835 = (_e637.member.member.y + _e773);
                                                let _e836 = (_e637.member.member.z + _e782);
                                                let _e839 = (_e637.member.member_1.x - _e803);
                                                let _e840 = (_e637.member.member_1.y - _e812);
                                                let _e841 = (_e637.member.member_1.z - _e821);
                                                let _e860 = (_e839 - _e834);
                                                let _e861 = (_e840 - _e835);
                                                let _e862 = (_e841 - _e836);
                                                let _e864 = select(_e861, _e860, (_e860 > _e861));
                                                let _e866 = select(_e862, _e864, (_e864 > _e862));
                                                if (_e866 < (1024f * _e162)) {
                                                    phi_3053_ = 0u;
                                                } else {
                                                    phi_3053_ = select(2u, 1u, (_e866 < (2097152f * _e162)));
                                                }
                                                let _e873 = phi_3053_;
                                                switch bitcast<i32>(_e873) {
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
                                                let _e876 = phi_3059_;
                                                let _e882 = global_8.member[_e637.member_1][0u];
                                                let _e886 = global_8.member[_e637.member_1][2u];
                                                let _e890 = global_8.member[_e637.member_1][4u];
                                                let _e894 = global_8.member[_e637.member_1][6u];
                                                let _e906 = (((_e886 >> bitcast<u32>(22i)) | ((_e890 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e894 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e907 = (_e882 & 268435455u);
                                                let _e908 = (_e906 & 268435455u);
                                                let _e911 = ((_e882 >> bitcast<u32>(28u)) & 7u);
                                                let _e919 = ((_e882 >> bitcast<u32>(31i)) | (((_e906 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e920 = (_e911 != 0u);
                                                if (_e911 == 0u) {
                                                    phi_3314_ = _e907;
                                                } else {
                                                    if (_e911 == 7u) {
                                                        phi_3313_ = 2147483648u;
                                                    } else {
                                                        phi_3313_ = ((2147483648u | (_e911 << bitcast<u32>(28u))) | (_e908 & 268435455u));
                                                    }
                                                    let _e929 = phi_3313_;
                                                    phi_3314_ = _e929;
                                                }
                                                let _e931 = phi_3314_;
                                                if _e920 {
                                                    let _e932 = (_e911 != 7u);
                                                    if _e932 {
                                                        phi_3324_ = (_e908 + (_e911 * ((3u * _e876) + 1u)));
                                                    } else {
                                                        phi_3324_ = u32();
                                                    }
                                                    let _e936 = phi_3324_;
                                                    phi_3326_ = _e936;
                                                    phi_3327_ = select(true, false, _e932);
                                                } else {
                                                    phi_3326_ = u32();
                                                    phi_3327_ = true;
                                                }
                                                let _e939 = phi_3326_;
                                                let _e941 = phi_3327_;
                                                if (_e919 == 0u) {
                                                    phi_3348_ = (_e907 + select(0u, 1u, !(_e920)));
                                                } else {
                                                    if (_e919 == 7u) {
                                                        phi_3347_ = 2147483648u;
                                                    } else {
                                                        phi_3347_ = ((2147483648u | (_e919 << bitcast<u32>(28u))) | (select(_e939, _e908, _e941) & 268435455u));
                                                    }
                                                    let _e954 = phi_3347_;
                                                    phi_3348_ = _e954;
                                                }
                                                let _e956 = phi_3348_;
                                                phi_3352_ = type_62(array<vec4<f32>, 3>(vec4<f32>(_e834, (_e637.member.member.x + _e786), _e839, (_e637.member.member_1.x - _e825)), vec4<f32>(_e835, (_e637.member.member.y + _e790), _e840, (_e637.member.member_1.y - _e829)), vec4<f32>(_e836, (_e637.member.member.z + _e794), _e841, (_e637.member.member_1.z - _e833))), type_61(type_30((_e637.member.member + vec4<f32>(_e764, _e773, _e782, 0f)), (_e637.member.member_1 - vec4<f32>(_e803, _e812, _e821, 0f))), _e931), type_61(type_30((_e637.member.member + vec4<f32>(_e786, _e790, _e794, 0f)), (_e637.member.member_1 - vec4<f32>(_e825, _e829, _e833, 0f))), _e956));
                                            }
                                            let _e961 = phi_3352_;
                                            let _e973 = ((_e961.member[0].x - _e431) * _e436);
                                            let _e974 = ((_e961.member[0].y - _e431) * _e436);
                                            let _e975 = ((_e961.member[0].z - _e432) * _e436);
                                            let _e976 = ((_e961.member[0].w - _e432) * _e436);
                                            let _e986 = ((_e961.member[1].x - _e467) * _e472);
                                            let _e987 = ((_e961.member[1].y - _e467) * _e472);
                                            let _e988 = ((_e961.member[1].z - _e468) * _e472);
                                            let _e989 = ((_e961.member[1].w - _e468) * _e472);
                                            let _e999 = ((_e961.member[2].x - _e503) * _e508);
                                            let _e1000 = ((_e961.member[2].y - _e503) * _e508);
                                            let _e1001 = ((_e961.member[2].z - _e504) * _e508);
                                            let _e1002 = ((_e961.member[2].w - _e504) * _e508);
                                            let _e1004 = select(_e1001, _e999, (_e999 < _e1001));
                                            let _e1006 = select(_e1002, _e1000, (_e1000 < _e1002));
                                            let _e1008 = select(_e1001, _e999, (_e999 > _e1001));
                                            let _e1010 = select(_e1002, _e1000, (_e1000 > _e1002));
                                            let _e1012 = select(_e975, _e973, (_e973 < _e975));
                                            let _e1014 = select(_e976, _e974, (_e974 < _e976));
                                            let _e1016 = select(_e988, _e986, (_e986 < _e988));
                                            let _e1018 = select(_e989, _e987, (_e987 < _e989));
                                            let _e1020 = select(_e1016, _e1012, (_e1012 > _e1016));
                                            let _e1022 = select(_e1018, _e1014, (_e1014 > _e1018));
                                            let _e1024 = select(_e1004, _e1020, (_e1020 > _e1004));
                                            let _e1026 = select(_e1006, _e1022, (_e1022 > _e1006));
                                            let _e1028 = select(_e975, _e973, (_e973 > _e975));
                                            let _e1030 = select(_e976, _e974, (_e974 > _e976));
                                            let _e1032 = select(_e988, _e986, (_e986 > _e988));
                                            let _e1034 = select(_e989, _e987, (_e987 > _e989));
                                            let _e1036 = select(_e1032, _e1028, (_e1028 < _e1032));
                                            let _e1038 = select(_e1034, _e1030, (_e1030 < _e1034));
                                            let _e1043 = -(_e1004);
                                            let _e1044 = -(_e1006);
                                            let _e1051 = (select(_e1008, _e1036, (_e1036 < _e1008)) + (select(_e1043, _e1008, (_e1008 > _e1043)) * 0.0000019073523f));
                                            let _e1052 = (select(_e1010, _e1038, (_e1038 < _e1010)) + (select(_e1044, _e1010, (_e1010 > _e1044)) * 0.0000019073523f));
                                            let _e1054 = select(_e554, _e1024, (_e1024 > _e554));
                                            let _e1056 = select(_e554, _e1026, (_e1026 > _e554));
                                            let _e1061 = (_e1054 <= select(_e598.member, _e1051, (_e1051 < _e598.member)));
                                            let _e1062 = (_e1056 <= select(_e598.member, _e1052, (_e1052 < _e598.member)));
                                            let _e1063 = (_e1054 <= _e1056);
                                            if _e1061 {
                                                if _e1062 {
                                                    if _e1063 {
                                                        phi_3696_ = _e961.member_2;
                                                    } else {
                                                        phi_3696_ = _e961.member_1;
                                                    }
                                                    let _e1067 = phi_3696_;
                                                    let _e1089 = (_e641 % 128u);
                                                    let _e1090 = (_e1089 < 128u);
                                                    if _e1090 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1089] = _e1067.member_1;
                                                    if _e1090 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1089] = _e1067.member.member.x;
                                                    if _e1090 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1089] = _e1067.member.member.y;
                                                    if _e1090 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1089] = _e1067.member.member.z;
                                                    if _e1090 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1089] = _e1067.member.member_1.x;
                                                    if _e1090 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1089] = _e1067.member.member_1.y;
                                                    if _e1090 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1089] = _e1067.member.member_1.z;
                                                    if _e1090 {
                                                    } else {
                                                        phi_4221_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1089] = select(_e1056, _e1054, (_e1054 > _e1056));
                                                    if _e1063 {
                                                        phi_3773_ = _e961.member_1;
                                                    } else {
                                                        phi_3773_ = _e961.member_2;
                                                    }
                                                    let _e1103 = phi_3773_;
                                                    phi_3774_ = _e1103;
                                                    phi_3775_ = (_e641 + 1u);
                                                } else {
                                                    phi_3774_ = type_61();
                                                    phi_3775_ = u32();
                                                }
                                                let _e1105 = phi_3774_;
                                                let _e1107 = phi_3775_;
                                                phi_3777_ = _e1105;
                                                phi_3778_ = _e1107;
                                                phi_3779_ = select(true, false, _e1062);
                                            } else {
                                                phi_3777_ = type_61();
                                                phi_3778_ = u32();
                                                phi_3779_ = true;
                                            }
                                            let _e1110 = phi_3777_;
                                            let _e1112 = phi_3778_;
                                            let _e1114 = phi_3779_;
                                            if _e1114 {
                                                if _e1061 {
                                                    phi_3788_ = _e961.member_1;
                                                } else {
                                                    phi_3788_ = _e961.member_2;
                                                }
                                                let _e1118 = phi_3788_;
                                                phi_3793_ = _e1118;
                                                phi_3794_ = select(_e1062, true, _e1061);
                                            } else {
                                                phi_3793_ = _e1110;
                                                phi_3794_ = _e639;
                                            }
                                            let _e1121 = phi_3793_;
                                            let _e1123 = phi_3794_;
                                            phi_4225_ = _e596;
                                            phi_3796_ = _e598;
                                            phi_3797_ = _e1121;
                                            phi_3798_ = _e1123;
                                            phi_3799_ = select(_e1112, _e641, _e1114);
                                        }
                                        let _e1859 = phi_4225_;
                                        let _e1861 = phi_3796_;
                                        let _e1863 = phi_3797_;
                                        let _e1865 = phi_3798_;
                                        let _e1867 = phi_3799_;
                                        phi_4224_ = _e1859;
                                        phi_3800_ = _e1861;
                                        phi_3801_ = _e1863;
                                        phi_3802_ = (_e602 - 1u);
                                        phi_3803_ = _e1865;
                                        phi_3804_ = _e1867;
                                    } else {
                                        phi_4224_ = _e596;
                                        phi_3800_ = _e598;
                                        phi_3801_ = _e637;
                                        phi_3802_ = _e602;
                                        phi_3803_ = _e639;
                                        phi_3804_ = _e641;
                                    }
                                    let _e1869 = phi_4224_;
                                    let _e1871 = phi_3800_;
                                    let _e1873 = phi_3801_;
                                    let _e1875 = phi_3802_;
                                    let _e1877 = phi_3803_;
                                    let _e1879 = phi_3804_;
                                    phi_4223_ = _e1869;
                                    phi_3805_ = _e1871;
                                    phi_3806_ = _e1873;
                                    phi_3807_ = _e1875;
                                    phi_3808_ = _e1877;
                                    phi_3809_ = _e1879;
                                } else {
                                    phi_4223_ = _e596;
                                    phi_3805_ = type_42();
                                    phi_3806_ = type_61();
                                    phi_3807_ = u32();
                                    phi_3808_ = bool();
                                    phi_3809_ = u32();
                                }
                                let _e1881 = phi_4223_;
                                let _e1883 = phi_3805_;
                                let _e1885 = phi_3806_;
                                let _e1887 = phi_3807_;
                                let _e1889 = phi_3808_;
                                let _e1891 = phi_3809_;
                                phi_4222_ = _e1881;
                                phi_1020_ = _e1883;
                                phi_1023_ = _e1885;
                                phi_1025_ = _e1887;
                                phi_1027_ = _e1889;
                                phi_1029_ = _e1891;
                                phi_3810_ = _e610;
                            } else {
                                phi_4222_ = _e596;
                                phi_1020_ = type_42();
                                phi_1023_ = type_61();
                                phi_1025_ = u32();
                                phi_1027_ = bool();
                                phi_1029_ = u32();
                                phi_3810_ = false;
                            }
                            let _e1893 = phi_4222_;
                            let _e1895 = phi_1020_;
                            let _e1897 = phi_1023_;
                            let _e1899 = phi_1025_;
                            let _e1901 = phi_1027_;
                            let _e1903 = phi_1029_;
                            let _e1905 = phi_3810_;
                            continue;
                            continuing {
                                phi_4083_ = _e1893;
                                phi_1019_ = _e1895;
                                phi_1022_ = _e1897;
                                phi_1024_ = _e1899;
                                phi_1026_ = _e1901;
                                phi_1028_ = _e1903;
                                phi_4221_ = _e1893;
                                break if !(_e1905);
                            }
                        }
                        let _e1908 = phi_4221_;
                        if _e1908 {
                            break;
                        }
                        let _e1910 = local_14;
                        if _e1910.member_1 {
                        } else {
                            if _e244 {
                            } else {
                                break;
                            }
                            let _e1914 = global_2.member[_e150];
                            if _e165 {
                            } else {
                                break;
                            }
                            let _e1918 = global_9.member[_e150].member_1;
                            if _e244 {
                            } else {
                                break;
                            }
                            global_2.member[_e150] = type_23(_e1914.member, _e1914.member_1, _e1914.member_2, array<f32, 3>((_e1914.member_3[0] + (_e1918[0] * _e1914.member_1[0])), (_e1914.member_3[1] + (_e1918[1] * _e1914.member_1[1])), (_e1914.member_3[2] + (_e1918[2] * _e1914.member_1[2]))), _e1914.member_4);
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
fn trace_shadows_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
