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

struct type_41 {
    member: f32,
    member_1: bool,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<i32>,
}

struct type_55 {
    member: array<array<u32, 7>>,
}

struct type_60 {
    member: type_30,
    member_1: u32,
}

struct type_63 {
    member: array<vec4<f32>, 3>,
    member_1: type_60,
    member_2: type_60,
}

struct type_70 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(1) 
var<uniform> global_3: type_43;
@group(0) @binding(2) 
var<uniform> global_4: type_43;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_46;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_70;
@group(0) @binding(3) 
var<storage> global_8: type_55;
@group(0) @binding(7) 
var<storage> global_9: type_33;
@group(0) @binding(4) 
var<storage> global_10: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_60, 128>;
    var local_4: array<u32, 3>;
    var local_5: array<array<f32, 3>, 3>;
    var local_6: array<f32, 4>;
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
    var phi_5007_: bool;
    var phi_2050_: type_41;
    var phi_2053_: type_60;
    var phi_2055_: u32;
    var phi_2057_: bool;
    var phi_2059_: u32;
    var phi_2070_: bool;
    var phi_2107_: type_60;
    var phi_2108_: bool;
    var phi_2109_: u32;
    var phi_4035_: u32;
    var phi_4041_: u32;
    var phi_4295_: u32;
    var phi_4296_: u32;
    var phi_4306_: u32;
    var phi_4308_: u32;
    var phi_4309_: bool;
    var phi_4329_: u32;
    var phi_4330_: u32;
    var phi_4334_: type_63;
    var phi_4678_: type_60;
    var phi_4711_: type_60;
    var phi_4712_: type_60;
    var phi_4713_: u32;
    var phi_4715_: type_60;
    var phi_4716_: u32;
    var phi_4717_: bool;
    var phi_4726_: type_60;
    var phi_4731_: type_60;
    var phi_4732_: bool;
    var phi_5004_: bool;
    var phi_2128_: type_41;
    var phi_2131_: type_8;
    var phi_2132_: type_8;
    var phi_2154_: type_8;
    var phi_2195_: u32;
    var phi_2201_: u32;
    var phi_2211_: u32;
    var phi_2227_: u32;
    var phi_2264_: u32;
    var phi_2270_: u32;
    var phi_2280_: u32;
    var phi_4989_: bool;
    var phi_2296_: type_8;
    var phi_2297_: type_8;
    var phi_2320_: type_8;
    var phi_2343_: u32;
    var phi_2358_: u32;
    var phi_2361_: type_8;
    var phi_2362_: type_8;
    var phi_2385_: type_8;
    var phi_2451_: u32;
    var phi_2431_: u32;
    var phi_2432_: u32;
    var phi_2455_: f32;
    var phi_4982_: bool;
    var phi_5068_: bool;
    var phi_5067_: bool;
    var phi_2955_: vec3<f32>;
    var phi_2956_: vec3<f32>;
    var phi_2987_: bool;
    var phi_2996_: vec3<f32>;
    var phi_3036_: type_21;
    var phi_3038_: type_21;
    var phi_3039_: bool;
    var phi_3043_: type_21;
    var phi_3044_: type_21;
    var phi_3045_: type_21;
    var phi_3046_: bool;
    var phi_3050_: type_21;
    var phi_3051_: bool;
    var phi_3055_: type_21;
    var phi_3056_: bool;
    var phi_3060_: type_21;
    var phi_3083_: u32;
    var phi_3097_: i32;
    var phi_3117_: vec3<f32>;
    var phi_3118_: vec3<f32>;
    var phi_3134_: vec3<f32>;
    var phi_3135_: vec3<f32>;
    var phi_3151_: vec3<f32>;
    var phi_3152_: vec3<f32>;
    var phi_3188_: vec3<f32>;
    var phi_3370_: f32;
    var phi_3388_: bool;
    var phi_3389_: bool;
    var phi_3394_: type_41;
    var phi_3395_: type_41;
    var phi_5070_: bool;
    var phi_2129_: type_41;
    var phi_5069_: bool;
    var local_7: type_41;
    var phi_5149_: bool;
    var phi_4734_: type_41;
    var phi_4735_: type_60;
    var phi_4736_: bool;
    var phi_4737_: u32;
    var phi_5148_: bool;
    var phi_4738_: type_41;
    var phi_4739_: type_60;
    var phi_4740_: u32;
    var phi_4741_: bool;
    var phi_4742_: u32;
    var phi_5147_: bool;
    var phi_4743_: type_41;
    var phi_4744_: type_60;
    var phi_4745_: u32;
    var phi_4746_: bool;
    var phi_4747_: u32;
    var phi_5146_: bool;
    var phi_2051_: type_41;
    var phi_2054_: type_60;
    var phi_2056_: u32;
    var phi_2058_: bool;
    var phi_2060_: u32;
    var phi_4748_: bool;
    var phi_5145_: bool;
    var local_8: type_41;
    var local_9: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_8.member));
            let _e102 = arrayLength((&global_10.member));
            let _e114 = arrayLength((&global_7.member));
            let _e118 = global_4.member[0u][0u];
            let _e122 = global_4.member[0u][1u];
            let _e126 = global_4.member[0u][2u];
            let _e130 = global_4.member[0u][3u];
            let _e134 = global_4.member[1u][0u];
            let _e138 = global_4.member[1u][1u];
            let _e142 = global_4.member[1u][2u];
            let _e146 = (_e97.x + (_e97.y * 2097152u));
            let _e158 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e130) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            local = array<i32, 3>(bitcast<i32>(_e134), bitcast<i32>(_e138), bitcast<i32>(_e142));
            let _e161 = (_e146 < arrayLength((&global_9.member)));
            if _e161 {
                if _e161 {
                } else {
                    break;
                }
                let _e165 = global_9.member[_e146].member_2;
                phi_342_ = _e165;
            } else {
                phi_342_ = 4294967295u;
            }
            let _e167 = phi_342_;
            let _e170 = global_1.member[0u];
            let _e174 = global_3.member[0u][0u];
            let _e178 = global_3.member[0u][1u];
            let _e182 = global_3.member[0u][2u];
            let _e186 = global_3.member[0u][3u];
            let _e190 = global_3.member[1u][0u];
            let _e194 = global_3.member[1u][1u];
            let _e198 = global_3.member[1u][2u];
            let _e202 = global_3.member[1u][3u];
            let _e203 = bitcast<f32>(_e174);
            let _e204 = bitcast<f32>(_e178);
            let _e205 = bitcast<f32>(_e182);
            let _e207 = bitcast<f32>(_e190);
            let _e208 = array<u32, 3>(_e194, _e198, _e202);
            let _e210 = bitcast<i32>(_e170);
            if (_e210 < -126i) {
                phi_386_ = -126i;
            } else {
                phi_386_ = select(_e210, 127i, (_e210 > 127i));
            }
            let _e215 = phi_386_;
            let _e220 = bitcast<f32>((bitcast<u32>((_e215 + 127i)) << bitcast<u32>(23i)));
            let _e226 = bitcast<f32>((bitcast<u32>(((_e210 - _e215) + 127i)) << bitcast<u32>(23i)));
            if (_e186 == 0u) {
                phi_410_ = type_37(array<f32, 3>(_e203, _e204, _e205), _e186, _e207, _e208);
            } else {
                phi_410_ = type_37(array<f32, 3>(((_e203 * _e220) * _e226), ((_e204 * _e220) * _e226), ((_e205 * _e220) * _e226)), _e186, ((_e207 * _e220) * _e226), _e208);
            }
            let _e239 = phi_410_;
            if _e161 {
                let _e240 = (_e146 < arrayLength((&global_2.member)));
                if _e240 {
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e245 = global_9.member[_e146].member.member_1;
                    let _e250 = global_9.member[_e146].member.member_3;
                    if (_e245 <= _e250) {
                        let _e252 = (1u < _e114);
                        if _e252 {
                            if (0u < _e114) {
                            } else {
                                break;
                            }
                            let _e256 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e256 + 1u) < _e256) {
                                if _e252 {
                                } else {
                                    break;
                                }
                                let _e261 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e161 {
                        } else {
                            break;
                        }
                        let _e271 = global_9.member[_e146].member.member_2[0u];
                        let _e273 = (bitcast<u32>(_e271) & 2147483647u);
                        let _e279 = global_9.member[_e146].member.member_2[1u];
                        let _e281 = (bitcast<u32>(_e279) & 2147483647u);
                        let _e287 = global_9.member[_e146].member.member_2[2u];
                        let _e289 = (bitcast<u32>(_e287) & 2147483647u);
                        let _e295 = global_9.member[_e146].member.member[0u];
                        let _e297 = (bitcast<u32>(_e295) & 2147483647u);
                        let _e303 = global_9.member[_e146].member.member[1u];
                        let _e305 = (bitcast<u32>(_e303) & 2147483647u);
                        let _e311 = global_9.member[_e146].member.member[2u];
                        let _e313 = (bitcast<u32>(_e311) & 2147483647u);
                        let _e315 = select(_e281, _e273, (_e281 < _e273));
                        let _e317 = select(_e289, _e315, (_e289 < _e315));
                        let _e319 = select(_e297, _e317, (_e297 < _e317));
                        let _e321 = select(_e305, _e319, (_e305 < _e319));
                        let _e323 = select(_e313, _e321, (_e313 < _e321));
                        let _e325 = (bitcast<u32>(_e245) & 2147483647u);
                        let _e334 = (((select(_e325, _e323, (_e325 < _e323)) < 2139095040u) && ((bitcast<u32>(_e250) & 2147483647u) <= 2139095040u)) && (_e317 > 0u));
                        if _e334 {
                            let _e337 = (bitcast<u32>(bitcast<f32>(_e317)) & 2147483647u);
                            if (_e337 >= 8388608u) {
                                phi_560_ = (bitcast<i32>((_e337 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_560_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e337)), 32u, (_e337 == 0u))));
                            }
                            let _e351 = phi_560_;
                            phi_561_ = _e351;
                        } else {
                            phi_561_ = 0i;
                        }
                        let _e353 = phi_561_;
                        let _e354 = (_e273 == _e317);
                        if _e354 {
                            phi_571_ = true;
                        } else {
                            phi_571_ = (_e281 == _e317);
                        }
                        let _e357 = phi_571_;
                        let _e358 = select(1u, 0u, _e354);
                        if _e357 {
                            let _e359 = (_e358 + 1u);
                            phi_581_ = _e359;
                            phi_582_ = _e359;
                            phi_584_ = select(true, false, (_e359 == 2u));
                        } else {
                            phi_581_ = u32();
                            phi_582_ = 0u;
                            phi_584_ = true;
                        }
                        let _e363 = phi_581_;
                        let _e365 = phi_582_;
                        let _e367 = phi_584_;
                        if _e367 {
                            phi_589_ = (_e365 + 1u);
                        } else {
                            phi_589_ = 0u;
                        }
                        let _e371 = phi_589_;
                        let _e372 = select(_e363, _e365, _e367);
                        let _e373 = select(_e358, select(2u, _e358, _e357), _e367);
                        let _e374 = -(_e353);
                        if (_e374 < -126i) {
                            phi_622_ = -126i;
                        } else {
                            phi_622_ = select(_e374, 127i, (_e374 > 127i));
                        }
                        let _e379 = phi_622_;
                        let _e384 = bitcast<f32>((bitcast<u32>((_e379 + 127i)) << bitcast<u32>(23i)));
                        let _e390 = bitcast<f32>((bitcast<u32>(((_e374 - _e379) + 127i)) << bitcast<u32>(23i)));
                        let _e395 = global_9.member[_e146].member.member;
                        let _e396 = (_e372 == 0u);
                        if _e396 {
                            phi_640_ = _e395[0];
                        } else {
                            phi_640_ = _e395[1];
                        }
                        let _e400 = phi_640_;
                        let _e401 = (_e372 == 2u);
                        if _e401 {
                            phi_646_ = _e395[2];
                        } else {
                            phi_646_ = _e400;
                        }
                        let _e404 = phi_646_;
                        let _e405 = global_9.member[_e146].member.member_2;
                        if _e396 {
                            phi_657_ = _e405[0];
                        } else {
                            phi_657_ = _e405[1];
                        }
                        let _e409 = phi_657_;
                        if _e401 {
                            phi_663_ = _e405[2];
                        } else {
                            phi_663_ = _e409;
                        }
                        let _e412 = phi_663_;
                        let _e414 = ((_e412 * _e384) * _e390);
                        let _e418 = (bitcast<f32>((bitcast<u32>(_e414) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e418 {
                            let _e422 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) * 0.00000011920929f);
                            phi_686_ = select(0.00000000000011368684f, _e422, (_e422 > 0.00000000000011368684f));
                        } else {
                            phi_686_ = 0f;
                        }
                        let _e426 = phi_686_;
                        let _e427 = (_e404 + _e426);
                        let _e428 = (_e404 - _e426);
                        let _e429 = select(_e414, 0f, _e418);
                        if _e418 {
                            phi_697_ = 38685626000000000000000000f;
                        } else {
                            phi_697_ = (1f / _e414);
                        }
                        let _e432 = phi_697_;
                        let _e433 = (_e371 == 0u);
                        if _e433 {
                            phi_706_ = _e395[0];
                        } else {
                            phi_706_ = _e395[1];
                        }
                        let _e437 = phi_706_;
                        let _e438 = (_e371 == 2u);
                        if _e438 {
                            phi_712_ = _e395[2];
                        } else {
                            phi_712_ = _e437;
                        }
                        let _e441 = phi_712_;
                        if _e433 {
                            phi_723_ = _e405[0];
                        } else {
                            phi_723_ = _e405[1];
                        }
                        let _e445 = phi_723_;
                        if _e438 {
                            phi_729_ = _e405[2];
                        } else {
                            phi_729_ = _e445;
                        }
                        let _e448 = phi_729_;
                        let _e450 = ((_e448 * _e384) * _e390);
                        let _e454 = (bitcast<f32>((bitcast<u32>(_e450) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e454 {
                            let _e458 = (bitcast<f32>((bitcast<u32>(_e441) & 2147483647u)) * 0.00000011920929f);
                            phi_752_ = select(0.00000000000011368684f, _e458, (_e458 > 0.00000000000011368684f));
                        } else {
                            phi_752_ = 0f;
                        }
                        let _e462 = phi_752_;
                        let _e463 = (_e441 + _e462);
                        let _e464 = (_e441 - _e462);
                        let _e465 = select(_e450, 0f, _e454);
                        if _e454 {
                            phi_763_ = 38685626000000000000000000f;
                        } else {
                            phi_763_ = (1f / _e450);
                        }
                        let _e468 = phi_763_;
                        let _e469 = (_e373 == 0u);
                        if _e469 {
                            phi_772_ = _e395[0];
                        } else {
                            phi_772_ = _e395[1];
                        }
                        let _e473 = phi_772_;
                        let _e474 = (_e373 == 2u);
                        if _e474 {
                            phi_778_ = _e395[2];
                        } else {
                            phi_778_ = _e473;
                        }
                        let _e477 = phi_778_;
                        if _e469 {
                            phi_789_ = _e405[0];
                        } else {
                            phi_789_ = _e405[1];
                        }
                        let _e481 = phi_789_;
                        if _e474 {
                            phi_795_ = _e405[2];
                        } else {
                            phi_795_ = _e481;
                        }
                        let _e484 = phi_795_;
                        let _e486 = ((_e484 * _e384) * _e390);
                        let _e490 = (bitcast<f32>((bitcast<u32>(_e486) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e490 {
                            let _e494 = (bitcast<f32>((bitcast<u32>(_e477) & 2147483647u)) * 0.00000011920929f);
                            phi_818_ = select(0.00000000000011368684f, _e494, (_e494 > 0.00000000000011368684f));
                        } else {
                            phi_818_ = 0f;
                        }
                        let _e498 = phi_818_;
                        let _e499 = (_e477 + _e498);
                        let _e500 = (_e477 - _e498);
                        let _e501 = select(_e486, 0f, _e490);
                        if _e490 {
                            phi_829_ = 38685626000000000000000000f;
                        } else {
                            phi_829_ = (1f / _e486);
                        }
                        let _e504 = phi_829_;
                        let _e507 = bitcast<f32>((bitcast<u32>(_e404) & 2147483647u));
                        let _e510 = bitcast<f32>((bitcast<u32>(_e441) & 2147483647u));
                        let _e512 = select(_e510, _e507, (_e507 > _e510));
                        let _e515 = bitcast<f32>((bitcast<u32>(_e477) & 2147483647u));
                        if (_e334 && (select(_e515, _e512, (_e512 > _e515)) <= 1099511600000f)) {
                            let _e520 = (_e353 / 3i);
                            let _e527 = bitcast<f32>((bitcast<u32>((_e520 + 127i)) << bitcast<u32>(23i)));
                            let _e534 = bitcast<f32>((bitcast<u32>(((_e353 - (2i * _e520)) + 127i)) << bitcast<u32>(23i)));
                            let _e535 = (((_e245 * _e527) * _e527) * _e534);
                            let _e537 = select(340282350000000000000000000000000000000f, _e535, (_e535 < 340282350000000000000000000000000000000f));
                            let _e542 = (((_e250 * _e527) * _e527) * _e534);
                            let _e544 = select(340282350000000000000000000000000000000f, _e542, (_e542 < 340282350000000000000000000000000000000f));
                            phi_929_ = select(-340282350000000000000000000000000000000f, _e544, (_e544 > -340282350000000000000000000000000000000f));
                            phi_930_ = select(-340282350000000000000000000000000000000f, _e537, (_e537 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_929_ = 0f;
                            phi_930_ = 1f;
                        }
                        let _e548 = phi_929_;
                        let _e550 = phi_930_;
                        local_3 = array<type_60, 128>(type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e554 = (_e372 % 3u);
                        let _e555 = (_e554 < 3u);
                        if _e555 {
                        } else {
                            break;
                        }
                        let _e557 = local_1[_e554];
                        let _e560 = (_e371 % 3u);
                        let _e561 = (_e560 < 3u);
                        if _e561 {
                        } else {
                            break;
                        }
                        let _e563 = local_1[_e560];
                        let _e566 = (_e373 % 3u);
                        let _e567 = (_e566 < 3u);
                        if _e567 {
                        } else {
                            break;
                        }
                        let _e569 = local_1[_e566];
                        if _e555 {
                        } else {
                            break;
                        }
                        let _e574 = local[_e554];
                        if _e561 {
                        } else {
                            break;
                        }
                        let _e578 = local[_e560];
                        if _e567 {
                        } else {
                            break;
                        }
                        let _e582 = local[_e566];
                        phi_5007_ = false;
                        phi_2050_ = type_41(_e548, false);
                        phi_2053_ = type_60(type_30(vec4<f32>((f32(_e557) * _e158), (f32(_e563) * _e158), (f32(_e569) * _e158), 0f), vec4<f32>((f32(_e574) * _e158), (f32(_e578) * _e158), (f32(_e582) * _e158), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                        phi_2055_ = ((3u * _e99) + 1u);
                        phi_2057_ = (_e550 <= _e548);
                        phi_2059_ = 0u;
                        loop {
                            let _e592 = phi_5007_;
                            let _e594 = phi_2050_;
                            let _e596 = phi_2053_;
                            let _e598 = phi_2055_;
                            let _e600 = phi_2057_;
                            let _e602 = phi_2059_;
                            local_8 = _e594;
                            if _e600 {
                                phi_2070_ = true;
                            } else {
                                phi_2070_ = (_e602 > 0u);
                            }
                            let _e605 = phi_2070_;
                            if _e605 {
                                let _e606 = (_e598 > 0u);
                                if _e606 {
                                    if _e600 {
                                        phi_2107_ = _e596;
                                        phi_2108_ = _e600;
                                        phi_2109_ = _e602;
                                    } else {
                                        let _e607 = (_e602 - 1u);
                                        let _e608 = (_e607 % 128u);
                                        let _e609 = (_e608 < 128u);
                                        if _e609 {
                                        } else {
                                            phi_5145_ = true;
                                            break;
                                        }
                                        let _e611 = local_3[_e608];
                                        if _e609 {
                                        } else {
                                            phi_5145_ = true;
                                            break;
                                        }
                                        let _e619 = local_2[_e608];
                                        phi_2107_ = type_60(type_30(_e611.member.member, _e611.member.member_1), _e611.member_1);
                                        phi_2108_ = (_e619 <= _e594.member);
                                        phi_2109_ = _e607;
                                    }
                                    let _e623 = phi_2107_;
                                    let _e625 = phi_2108_;
                                    let _e627 = phi_2109_;
                                    if _e625 {
                                        let _e632 = (_e623.member_1 & 268435455u);
                                        if ((_e623.member_1 & 2147483648u) != 0u) {
                                            phi_5004_ = _e592;
                                            phi_2128_ = _e594;
                                            phi_2131_ = type_8(0u, ((_e623.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1094 = phi_5004_;
                                                let _e1096 = phi_2128_;
                                                let _e1098 = phi_2131_;
                                                local_7 = _e1096;
                                                local_9 = _e1096;
                                                if (_e1098.member < _e1098.member_1) {
                                                    phi_2132_ = type_8((_e1098.member + 1u), _e1098.member_1);
                                                    phi_2154_ = type_8(1u, _e1098.member);
                                                } else {
                                                    phi_2132_ = _e1098;
                                                    phi_2154_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1111 = phi_2132_;
                                                let _e1113 = phi_2154_;
                                                let _e1117 = (bitcast<i32>(_e1113.member) != 0i);
                                                if _e1117 {
                                                    let _e1122 = (_e623.member.member_1.x - _e623.member.member.x);
                                                    let _e1125 = (_e623.member.member_1.y - _e623.member.member.y);
                                                    let _e1128 = (_e623.member.member_1.z - _e623.member.member.z);
                                                    let _e1130 = select(_e1125, _e1122, (_e1122 > _e1125));
                                                    let _e1132 = select(_e1128, _e1130, (_e1130 > _e1128));
                                                    let _e1134 = (_e1132 < (1024f * _e158));
                                                    if _e1134 {
                                                        phi_2195_ = 0u;
                                                    } else {
                                                        phi_2195_ = select(2u, 1u, (_e1132 < (2097152f * _e158)));
                                                    }
                                                    let _e1139 = phi_2195_;
                                                    switch bitcast<i32>(_e1139) {
                                                        case 0: {
                                                            phi_2201_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2201_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2201_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2201_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1142 = phi_2201_;
                                                    switch bitcast<i32>(_e1139) {
                                                        case 0: {
                                                            phi_2211_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2211_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2211_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2211_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1149 = phi_2211_;
                                                    let _e1151 = ((_e632 + (_e1113.member_1 * ((3u * _e1142) + 1u))) + (3u * _e1149));
                                                    let _e1152 = (_e1151 < _e102);
                                                    if _e1152 {
                                                        if _e1152 {
                                                        } else {
                                                            phi_5069_ = true;
                                                            break;
                                                        }
                                                        let _e1154 = global_10.member[_e1151];
                                                        phi_2227_ = _e1154;
                                                    } else {
                                                        phi_2227_ = 4294967295u;
                                                    }
                                                    let _e1156 = phi_2227_;
                                                    local_4 = array<u32, 3>(_e372, _e371, _e373);
                                                    if _e1134 {
                                                        phi_2264_ = 0u;
                                                    } else {
                                                        phi_2264_ = select(2u, 1u, (_e1132 < (2097152f * _e158)));
                                                    }
                                                    let _e1162 = phi_2264_;
                                                    switch bitcast<i32>(_e1162) {
                                                        case 0: {
                                                            phi_2270_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2270_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2270_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2270_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1165 = phi_2270_;
                                                    switch bitcast<i32>(_e1162) {
                                                        case 0: {
                                                            phi_2280_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2280_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2280_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2280_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1172 = phi_2280_;
                                                    local_6 = array<f32, 4>(_e623.member.member.x, _e623.member.member.y, _e623.member.member.z, _e623.member.member.w);
                                                    local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4989_ = _e1094;
                                                    phi_2296_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1186 = phi_4989_;
                                                        let _e1188 = phi_2296_;
                                                        if (_e1188.member < _e1188.member_1) {
                                                            phi_2297_ = type_8((_e1188.member + 1u), _e1188.member_1);
                                                            phi_2320_ = type_8(1u, _e1188.member);
                                                        } else {
                                                            phi_2297_ = _e1188;
                                                            phi_2320_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1201 = phi_2297_;
                                                        let _e1203 = phi_2320_;
                                                        let _e1207 = (bitcast<i32>(_e1203.member) != 0i);
                                                        if _e1207 {
                                                            let _e1209 = ((_e632 + (_e1113.member_1 * ((3u * _e1165) + 1u))) + (_e1203.member_1 * _e1172));
                                                            let _e1210 = (_e1209 < _e102);
                                                            if _e1210 {
                                                                if _e1210 {
                                                                } else {
                                                                    phi_5067_ = true;
                                                                    break;
                                                                }
                                                                let _e1212 = global_10.member[_e1209];
                                                                phi_2343_ = _e1212;
                                                            } else {
                                                                phi_2343_ = 0u;
                                                            }
                                                            let _e1214 = phi_2343_;
                                                            let _e1215 = (_e1209 + 1u);
                                                            let _e1216 = (_e1215 < _e102);
                                                            if _e1216 {
                                                                if _e1216 {
                                                                } else {
                                                                    phi_5067_ = true;
                                                                    break;
                                                                }
                                                                let _e1218 = global_10.member[_e1215];
                                                                phi_2358_ = _e1218;
                                                            } else {
                                                                phi_2358_ = 0u;
                                                            }
                                                            let _e1220 = phi_2358_;
                                                            phi_2361_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1222 = phi_2361_;
                                                                if (_e1222.member < _e1222.member_1) {
                                                                    phi_2362_ = type_8((_e1222.member + 1u), _e1222.member_1);
                                                                    phi_2385_ = type_8(1u, _e1222.member);
                                                                } else {
                                                                    phi_2362_ = _e1222;
                                                                    phi_2385_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1235 = phi_2362_;
                                                                let _e1237 = phi_2385_;
                                                                let _e1241 = (bitcast<i32>(_e1237.member) != 0i);
                                                                if _e1241 {
                                                                    let _e1242 = (_e1237.member_1 < 3u);
                                                                    if _e1242 {
                                                                    } else {
                                                                        phi_4982_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1244 = local_4[_e1237.member_1];
                                                                    if (_e1237.member_1 < 4u) {
                                                                    } else {
                                                                        phi_4982_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1247 = local_6[_e1237.member_1];
                                                                    switch bitcast<i32>(_e1162) {
                                                                        case 0: {
                                                                            phi_2455_ = (_e1247 + (f32(((_e1214 >> bitcast<u32>(((10u * _e1244) & 31u))) & 1023u)) * _e158));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1244 == 0u) {
                                                                                phi_2432_ = _e1214;
                                                                            } else {
                                                                                if (_e1244 == 1u) {
                                                                                    phi_2431_ = ((_e1214 >> bitcast<u32>(21i)) | (_e1220 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_2431_ = (_e1220 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1268 = phi_2431_;
                                                                                phi_2432_ = _e1268;
                                                                            }
                                                                            let _e1270 = phi_2432_;
                                                                            phi_2455_ = (_e1247 + (f32((_e1270 & 2097151u)) * _e158));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1249 = (_e1209 + _e1244);
                                                                            let _e1250 = (_e1249 < _e102);
                                                                            if _e1250 {
                                                                                if _e1250 {
                                                                                } else {
                                                                                    phi_4982_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1252 = global_10.member[_e1249];
                                                                                phi_2451_ = _e1252;
                                                                            } else {
                                                                                phi_2451_ = 0u;
                                                                            }
                                                                            let _e1254 = phi_2451_;
                                                                            phi_2455_ = (f32(bitcast<i32>(_e1254)) * _e158);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_2455_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1284 = phi_2455_;
                                                                    if (_e1203.member_1 < 3u) {
                                                                    } else {
                                                                        phi_4982_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1242 {
                                                                    } else {
                                                                        phi_4982_ = true;
                                                                        break;
                                                                    }
                                                                    local_5[_e1203.member_1][_e1237.member_1] = _e1284;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_2361_ = _e1235;
                                                                    phi_4982_ = _e1186;
                                                                    break if !(_e1241);
                                                                }
                                                            }
                                                            let _e1290 = phi_4982_;
                                                            phi_5067_ = _e1290;
                                                            if _e1290 {
                                                                break;
                                                            }
                                                            phi_5068_ = _e1290;
                                                        } else {
                                                            phi_5068_ = _e1186;
                                                        }
                                                        let _e1292 = phi_5068_;
                                                        continue;
                                                        continuing {
                                                            phi_4989_ = _e1292;
                                                            phi_2296_ = _e1201;
                                                            phi_5067_ = _e1292;
                                                            break if !(_e1207);
                                                        }
                                                    }
                                                    let _e1295 = phi_5067_;
                                                    phi_5069_ = _e1295;
                                                    if _e1295 {
                                                        break;
                                                    }
                                                    let _e1296 = local_5;
                                                    let _e1312 = (_e1296[0][2] - _e477);
                                                    let _e1315 = (((_e1296[0][0] - _e404) * _e501) - (_e1312 * _e429));
                                                    let _e1318 = (((_e1296[0][1] - _e441) * _e501) - (_e1312 * _e465));
                                                    let _e1321 = (_e1296[1][2] - _e477);
                                                    let _e1324 = (((_e1296[1][0] - _e404) * _e501) - (_e1321 * _e429));
                                                    let _e1327 = (((_e1296[1][1] - _e441) * _e501) - (_e1321 * _e465));
                                                    let _e1330 = (_e1296[2][2] - _e477);
                                                    let _e1333 = (((_e1296[2][0] - _e404) * _e501) - (_e1330 * _e429));
                                                    let _e1336 = (((_e1296[2][1] - _e441) * _e501) - (_e1330 * _e465));
                                                    let _e1337 = (_e1333 * _e1327);
                                                    let _e1338 = (_e1336 * _e1324);
                                                    let _e1339 = (_e1315 * _e1336);
                                                    let _e1340 = (_e1318 * _e1333);
                                                    let _e1341 = (_e1324 * _e1318);
                                                    let _e1342 = (_e1327 * _e1315);
                                                    let _e1347 = (((_e1337 >= _e1338) && (_e1339 >= _e1340)) && (_e1341 >= _e1342));
                                                    if (_e1347 || (((_e1337 <= _e1338) && (_e1339 <= _e1340)) && (_e1341 <= _e1342))) {
                                                        let _e1354 = select(-1f, 1f, _e1347);
                                                        let _e1356 = ((_e1337 - _e1338) * _e1354);
                                                        let _e1358 = select(0f, _e1356, (_e1356 > 0f));
                                                        let _e1360 = ((_e1339 - _e1340) * _e1354);
                                                        let _e1362 = select(0f, _e1360, (_e1360 > 0f));
                                                        let _e1364 = ((_e1341 - _e1342) * _e1354);
                                                        let _e1366 = select(0f, _e1364, (_e1364 > 0f));
                                                        let _e1368 = ((_e1358 + _e1362) + _e1366);
                                                        if (_e1368 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3050_ = type_21();
                                                            phi_3051_ = true;
                                                        } else {
                                                            let _e1371 = select(_e1296[1][0], _e1296[0][0], (_e1296[0][0] < _e1296[1][0]));
                                                            let _e1375 = select(_e1296[1][0], _e1296[0][0], (_e1296[0][0] > _e1296[1][0]));
                                                            let _e1379 = select(_e1296[1][1], _e1296[0][1], (_e1296[0][1] < _e1296[1][1]));
                                                            let _e1383 = select(_e1296[1][1], _e1296[0][1], (_e1296[0][1] > _e1296[1][1]));
                                                            let _e1387 = select(_e1296[1][2], _e1296[0][2], (_e1296[0][2] < _e1296[1][2]));
                                                            let _e1391 = select(_e1296[1][2], _e1296[0][2], (_e1296[0][2] > _e1296[1][2]));
                                                            let _e1396 = ((select(_e1296[2][0], _e1371, (_e1371 < _e1296[2][0])) - _e427) * _e432);
                                                            let _e1397 = ((select(_e1296[2][0], _e1375, (_e1375 > _e1296[2][0])) - _e428) * _e432);
                                                            let _e1400 = ((select(_e1296[2][1], _e1379, (_e1379 < _e1296[2][1])) - _e463) * _e468);
                                                            let _e1401 = ((select(_e1296[2][1], _e1383, (_e1383 > _e1296[2][1])) - _e464) * _e468);
                                                            let _e1404 = ((select(_e1296[2][2], _e1387, (_e1387 < _e1296[2][2])) - _e499) * _e504);
                                                            let _e1405 = ((select(_e1296[2][2], _e1391, (_e1391 > _e1296[2][2])) - _e500) * _e504);
                                                            let _e1407 = select(_e1405, _e1404, (_e1404 < _e1405));
                                                            let _e1409 = select(_e1405, _e1404, (_e1404 > _e1405));
                                                            let _e1411 = select(_e1397, _e1396, (_e1396 < _e1397));
                                                            let _e1413 = select(_e1401, _e1400, (_e1400 < _e1401));
                                                            let _e1415 = select(_e1413, _e1411, (_e1411 > _e1413));
                                                            let _e1417 = select(_e1407, _e1415, (_e1415 > _e1407));
                                                            let _e1419 = select(_e1397, _e1396, (_e1396 > _e1397));
                                                            let _e1421 = select(_e1401, _e1400, (_e1400 > _e1401));
                                                            let _e1423 = select(_e1421, _e1419, (_e1419 < _e1421));
                                                            let _e1425 = select(_e1409, _e1423, (_e1423 < _e1409));
                                                            let _e1426 = -(_e1407);
                                                            let _e1432 = select(_e550, _e1417, (_e1417 > _e550));
                                                            if (_e1432 > (_e1425 + (select(_e1426, _e1409, (_e1409 > _e1426)) * 0.0000019073523f))) {
                                                                phi_3045_ = type_21();
                                                                phi_3046_ = true;
                                                            } else {
                                                                let _e1434 = (_e1432 > _e1096.member);
                                                                if _e1434 {
                                                                    phi_3044_ = type_21();
                                                                } else {
                                                                    let _e1438 = (_e1296[1][0] - _e1296[0][0]);
                                                                    let _e1439 = (_e1296[1][1] - _e1296[0][1]);
                                                                    let _e1440 = (_e1296[1][2] - _e1296[0][2]);
                                                                    let _e1441 = vec3<f32>(_e1438, _e1439, _e1440);
                                                                    let _e1442 = (_e1296[2][0] - _e1296[1][0]);
                                                                    let _e1443 = (_e1296[2][1] - _e1296[1][1]);
                                                                    let _e1444 = (_e1296[2][2] - _e1296[1][2]);
                                                                    let _e1445 = vec3<f32>(_e1442, _e1443, _e1444);
                                                                    let _e1446 = (_e1296[0][0] - _e1296[2][0]);
                                                                    let _e1447 = (_e1296[0][1] - _e1296[2][1]);
                                                                    let _e1448 = (_e1296[0][2] - _e1296[2][2]);
                                                                    let _e1449 = vec3<f32>(_e1446, _e1447, _e1448);
                                                                    let _e1452 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                    let _e1455 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                                    let _e1457 = select(_e1455, _e1452, (_e1452 > _e1455));
                                                                    let _e1460 = bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u));
                                                                    let _e1462 = select(_e1460, _e1457, (_e1457 > _e1460));
                                                                    let _e1465 = bitcast<f32>((bitcast<u32>(_e1442) & 2147483647u));
                                                                    let _e1468 = bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u));
                                                                    let _e1470 = select(_e1468, _e1465, (_e1465 > _e1468));
                                                                    let _e1473 = bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u));
                                                                    let _e1475 = select(_e1473, _e1470, (_e1470 > _e1473));
                                                                    let _e1478 = bitcast<f32>((bitcast<u32>(_e1446) & 2147483647u));
                                                                    let _e1481 = bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u));
                                                                    let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                                    let _e1486 = bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u));
                                                                    let _e1488 = select(_e1486, _e1483, (_e1483 > _e1486));
                                                                    let _e1490 = select(_e1475, _e1462, (_e1462 > _e1475));
                                                                    let _e1492 = select(_e1488, _e1490, (_e1490 > _e1488));
                                                                    if (_e1462 == _e1492) {
                                                                        phi_2955_ = _e1445;
                                                                        phi_2956_ = _e1449;
                                                                    } else {
                                                                        let _e1495 = vec3((_e1475 == _e1492));
                                                                        phi_2955_ = select(_e1441, _e1449, _e1495);
                                                                        phi_2956_ = select(_e1445, _e1441, _e1495);
                                                                    }
                                                                    let _e1499 = phi_2955_;
                                                                    let _e1501 = phi_2956_;
                                                                    let _e1508 = ((_e1499.y * _e1501.z) - (_e1501.y * _e1499.z));
                                                                    let _e1513 = ((_e1499.z * _e1501.x) - (_e1501.z * _e1499.x));
                                                                    let _e1516 = ((_e1499.x * _e1501.y) - (_e1501.x * _e1499.y));
                                                                    if (_e1358 >= _e1362) {
                                                                        phi_2987_ = select(true, false, (_e1358 >= _e1366));
                                                                    } else {
                                                                        phi_2987_ = true;
                                                                    }
                                                                    let _e1521 = phi_2987_;
                                                                    if _e1521 {
                                                                        phi_2996_ = select(vec3<f32>(_e1296[2][0], _e1296[2][1], _e1296[2][2]), vec3<f32>(_e1296[1][0], _e1296[1][1], _e1296[1][2]), vec3((_e1362 >= _e1366)));
                                                                    } else {
                                                                        phi_2996_ = vec3<f32>(_e1296[0][0], _e1296[0][1], _e1296[0][2]);
                                                                    }
                                                                    let _e1526 = phi_2996_;
                                                                    let _e1543 = ((((_e1508 * (_e1526.x - _e404)) + (_e1513 * (_e1526.y - _e441))) + (_e1516 * (_e1526.z - _e477))) / (((_e1508 * _e429) + (_e1513 * _e465)) + (_e1516 * _e501)));
                                                                    let _e1545 = select(_e1425, _e1543, (_e1543 < _e1425));
                                                                    let _e1547 = select(_e1417, _e1545, (_e1545 > _e1417));
                                                                    if (_e1547 >= _e550) {
                                                                        let _e1549 = (_e1547 <= _e1096.member);
                                                                        if _e1549 {
                                                                            let _e1550 = (1f / _e1368);
                                                                            phi_3036_ = type_21(_e1547, (_e1362 * _e1550), (_e1366 * _e1550), _e1156);
                                                                        } else {
                                                                            phi_3036_ = type_21();
                                                                        }
                                                                        let _e1555 = phi_3036_;
                                                                        phi_3038_ = _e1555;
                                                                        phi_3039_ = select(true, false, _e1549);
                                                                    } else {
                                                                        phi_3038_ = type_21();
                                                                        phi_3039_ = true;
                                                                    }
                                                                    let _e1558 = phi_3038_;
                                                                    let _e1560 = phi_3039_;
                                                                    if _e1560 {
                                                                        phi_3043_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3043_ = _e1558;
                                                                    }
                                                                    let _e1562 = phi_3043_;
                                                                    phi_3044_ = _e1562;
                                                                }
                                                                let _e1564 = phi_3044_;
                                                                phi_3045_ = _e1564;
                                                                phi_3046_ = _e1434;
                                                            }
                                                            let _e1566 = phi_3045_;
                                                            let _e1568 = phi_3046_;
                                                            phi_3050_ = _e1566;
                                                            phi_3051_ = _e1568;
                                                        }
                                                        let _e1570 = phi_3050_;
                                                        let _e1572 = phi_3051_;
                                                        phi_3055_ = _e1570;
                                                        phi_3056_ = _e1572;
                                                    } else {
                                                        phi_3055_ = type_21();
                                                        phi_3056_ = true;
                                                    }
                                                    let _e1574 = phi_3055_;
                                                    let _e1576 = phi_3056_;
                                                    if _e1576 {
                                                        phi_3060_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3060_ = _e1574;
                                                    }
                                                    let _e1578 = phi_3060_;
                                                    if (_e1578.member_3 != 4294967295u) {
                                                        if (_e1156 == _e167) {
                                                            phi_3389_ = false;
                                                        } else {
                                                            let _e1582 = (_e1156 < arrayLength((&global_5.member)));
                                                            if _e1582 {
                                                                if _e1582 {
                                                                } else {
                                                                    phi_5069_ = true;
                                                                    break;
                                                                }
                                                                let _e1584 = global_5.member[_e1156];
                                                                phi_3083_ = _e1584;
                                                            } else {
                                                                phi_3083_ = 4294967295u;
                                                            }
                                                            let _e1586 = phi_3083_;
                                                            let _e1587 = (_e1586 < arrayLength((&global_6.member)));
                                                            if _e1587 {
                                                                if _e1587 {
                                                                } else {
                                                                    phi_5069_ = true;
                                                                    break;
                                                                }
                                                                let _e1589 = global_6.member[_e1586];
                                                                phi_3097_ = _e1589;
                                                            } else {
                                                                phi_3097_ = 0i;
                                                            }
                                                            let _e1591 = phi_3097_;
                                                            let _e1592 = (_e1591 == 0i);
                                                            if _e1592 {
                                                                phi_3388_ = true;
                                                            } else {
                                                                if _e396 {
                                                                    phi_3118_ = vec3<f32>(_e1296[0][0], _e1296[0][1], _e1296[0][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_3117_ = vec3<f32>(_e1296[0][2], _e1296[0][0], _e1296[0][1]);
                                                                    } else {
                                                                        phi_3117_ = vec3<f32>(_e1296[0][1], _e1296[0][2], _e1296[0][0]);
                                                                    }
                                                                    let _e1597 = phi_3117_;
                                                                    phi_3118_ = _e1597;
                                                                }
                                                                let _e1600 = phi_3118_;
                                                                if _e396 {
                                                                    phi_3135_ = vec3<f32>(_e1296[1][0], _e1296[1][1], _e1296[1][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_3134_ = vec3<f32>(_e1296[1][2], _e1296[1][0], _e1296[1][1]);
                                                                    } else {
                                                                        phi_3134_ = vec3<f32>(_e1296[1][1], _e1296[1][2], _e1296[1][0]);
                                                                    }
                                                                    let _e1605 = phi_3134_;
                                                                    phi_3135_ = _e1605;
                                                                }
                                                                let _e1608 = phi_3135_;
                                                                if _e396 {
                                                                    phi_3152_ = vec3<f32>(_e1296[2][0], _e1296[2][1], _e1296[2][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_3151_ = vec3<f32>(_e1296[2][2], _e1296[2][0], _e1296[2][1]);
                                                                    } else {
                                                                        phi_3151_ = vec3<f32>(_e1296[2][1], _e1296[2][2], _e1296[2][0]);
                                                                    }
                                                                    let _e1613 = phi_3151_;
                                                                    phi_3152_ = _e1613;
                                                                }
                                                                let _e1616 = phi_3152_;
                                                                let _e1619 = (_e1608.x - _e1600.x);
                                                                let _e1622 = (_e1608.y - _e1600.y);
                                                                let _e1625 = (_e1608.z - _e1600.z);
                                                                let _e1627 = (_e1616.x - _e1600.x);
                                                                let _e1629 = (_e1616.y - _e1600.y);
                                                                let _e1631 = (_e1616.z - _e1600.z);
                                                                if (_e239.member_1 == 1u) {
                                                                    phi_3188_ = (vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]) - _e1600);
                                                                } else {
                                                                    phi_3188_ = vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]);
                                                                }
                                                                let _e1646 = phi_3188_;
                                                                let _e1652 = bitcast<f32>((bitcast<u32>((_e1619 * _e1629)) ^ _e239.member_3[0]));
                                                                let _e1656 = bitcast<f32>((bitcast<u32>((_e1622 * _e1627)) ^ _e239.member_3[0]));
                                                                let _e1660 = bitcast<f32>((bitcast<u32>((_e1622 * _e1631)) ^ _e239.member_3[0]));
                                                                let _e1664 = bitcast<f32>((bitcast<u32>((_e1625 * _e1629)) ^ _e239.member_3[0]));
                                                                let _e1668 = bitcast<f32>((bitcast<u32>((_e1625 * _e1627)) ^ _e239.member_3[0]));
                                                                let _e1672 = bitcast<f32>((bitcast<u32>((_e1619 * _e1631)) ^ _e239.member_3[0]));
                                                                let _e1673 = (_e1660 - _e1664);
                                                                let _e1674 = (_e1668 - _e1672);
                                                                let _e1675 = (_e1652 - _e1656);
                                                                let _e1699 = (bitcast<f32>((bitcast<u32>(_e1660) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u)));
                                                                let _e1706 = (bitcast<f32>((bitcast<u32>(_e1668) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1672) & 2147483647u)));
                                                                let _e1713 = (bitcast<f32>((bitcast<u32>(_e1652) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1656) & 2147483647u)));
                                                                if (_e239.member_2 == 0f) {
                                                                    phi_3370_ = 0f;
                                                                } else {
                                                                    let _e1743 = bitcast<f32>((bitcast<u32>(_e1673) & 2147483647u));
                                                                    let _e1746 = bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u));
                                                                    let _e1749 = bitcast<f32>((bitcast<u32>(_e1675) & 2147483647u));
                                                                    let _e1751 = select(_e1749, _e1746, (_e1746 > _e1749));
                                                                    let _e1755 = select(_e1749, _e1746, (_e1746 < _e1749));
                                                                    let _e1759 = select(_e1746, _e1743, (_e1743 < _e1746));
                                                                    let _e1761 = select(_e1746, _e1743, (_e1743 > _e1746));
                                                                    let _e1763 = select(_e1749, _e1761, (_e1761 < _e1749));
                                                                    phi_3370_ = bitcast<f32>((bitcast<u32>((_e239.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1751, _e1743, (_e1743 > _e1751)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1763, _e1759, (_e1759 > _e1763)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1755, _e1743, (_e1743 < _e1755)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1699 + _e1706) + _e1713))) ^ _e239.member_3[0]))) * 1.0000005f)) ^ _e239.member_3[0])))) ^ _e239.member_3[0]));
                                                                }
                                                                let _e1790 = phi_3370_;
                                                                phi_3388_ = (_e1592 || !(((((bitcast<f32>((bitcast<u32>((_e1646.x * _e1673)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1646.y * _e1674)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1646.z * _e1675)) ^ _e239.member_3[0]))) * f32(-(_e1591))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1646.x) & 2147483647u)) * _e1699)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1646.y) & 2147483647u)) * _e1706)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1646.z) & 2147483647u)) * _e1713)) ^ _e239.member_3[0]))))) ^ _e239.member_3[0])) + _e1790) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1804 = phi_3388_;
                                                            phi_3389_ = _e1804;
                                                        }
                                                        let _e1806 = phi_3389_;
                                                        if _e1806 {
                                                            phi_3394_ = type_41(_e1096.member, true);
                                                        } else {
                                                            phi_3394_ = _e1096;
                                                        }
                                                        let _e1811 = phi_3394_;
                                                        phi_3395_ = _e1811;
                                                    } else {
                                                        phi_3395_ = _e1096;
                                                    }
                                                    let _e1813 = phi_3395_;
                                                    phi_5070_ = _e1295;
                                                    phi_2129_ = _e1813;
                                                } else {
                                                    phi_5070_ = _e1094;
                                                    phi_2129_ = type_41();
                                                }
                                                let _e1815 = phi_5070_;
                                                let _e1817 = phi_2129_;
                                                continue;
                                                continuing {
                                                    phi_5004_ = _e1815;
                                                    phi_2128_ = _e1817;
                                                    phi_2131_ = _e1111;
                                                    phi_5069_ = _e1815;
                                                    break if !(_e1117);
                                                }
                                            }
                                            let _e1820 = phi_5069_;
                                            phi_5145_ = _e1820;
                                            if _e1820 {
                                                break;
                                            }
                                            let _e1822 = local_7;
                                            phi_5149_ = _e1820;
                                            let _e2034 = local_9;
                                            phi_4734_ = _e2034;
                                            phi_4735_ = _e623;
                                            phi_4736_ = false;
                                            phi_4737_ = select(_e627, 0u, _e1822.member_1);
                                        } else {
                                            if (_e623.member_1 >= _e99) {
                                                phi_4334_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e623.member_1 < _e99) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e641 = ((1u + (_e372 * 2u)) % 7u);
                                                if (_e641 < 7u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e646 = global_8.member[_e623.member_1][_e641];
                                                let _e649 = ((1u + (_e371 * 2u)) % 7u);
                                                if (_e649 < 7u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e654 = global_8.member[_e623.member_1][_e649];
                                                let _e657 = ((1u + (_e373 * 2u)) % 7u);
                                                if (_e657 < 7u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e662 = global_8.member[_e623.member_1][_e657];
                                                let _e665 = (((_e372 + 1u) * 2u) % 7u);
                                                if (_e665 < 7u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e670 = global_8.member[_e623.member_1][_e665];
                                                let _e673 = (((_e371 + 1u) * 2u) % 7u);
                                                if (_e673 < 7u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e678 = global_8.member[_e623.member_1][_e673];
                                                let _e681 = (((_e373 + 1u) * 2u) % 7u);
                                                if (_e681 < 7u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e686 = global_8.member[_e623.member_1][_e681];
                                                let _e709 = (bitcast<f32>((bitcast<u32>((_e623.member.member_1.x - _e623.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e710 = (bitcast<f32>((bitcast<u32>((_e623.member.member_1.y - _e623.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e711 = (bitcast<f32>((bitcast<u32>((_e623.member.member_1.z - _e623.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e713 = select(_e158, _e709, (_e709 > _e158));
                                                let _e715 = select(_e158, _e710, (_e710 > _e158));
                                                let _e717 = select(_e158, _e711, (_e711 > _e158));
                                                let _e742 = bitcast<u32>((f32(bitcast<i32>((_e646 & 2097151u))) * _e713));
                                                let _e747 = (bitcast<i32>((_e646 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e750 = bitcast<f32>((_e742 & bitcast<u32>(_e747)));
                                                let _e751 = bitcast<u32>((f32(bitcast<i32>((_e654 & 2097151u))) * _e715));
                                                let _e756 = (bitcast<i32>((_e654 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e759 = bitcast<f32>((_e751 & bitcast<u32>(_e756)));
                                                let _e760 = bitcast<u32>((f32(bitcast<i32>((_e662 & 2097151u))) * _e717));
                                                let _e765 = (bitcast<i32>((_e662 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e768 = bitcast<f32>((_e760 & bitcast<u32>(_e765)));
                                                let _e772 = bitcast<f32>((_e742 & bitcast<u32>(~(_e747))));
                                                let _e776 = bitcast<f32>((_e751 & bitcast<u32>(~(_e756))));
                                                let _e780 = bitcast<f32>((_e760 & bitcast<u32>(~(_e765))));
                                                let _e781 = bitcast<u32>((f32(bitcast<i32>((_e670 & 2097151u))) * _e713));
                                                let _e786 = (bitcast<i32>((_e670 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e789 = bitcast<f32>((_e781 & bitcast<u32>(_e786)));
                                                let _e790 = bitcast<u32>((f32(bitcast<i32>((_e678 & 2097151u))) * _e715));
                                                let _e795 = (bitcast<i32>((_e678 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e798 = bitcast<f32>((_e790 & bitcast<u32>(_e795)));
                                                let _e799 = bitcast<u32>((f32(bitcast<i32>((_e686 & 2097151u))) * _e717));
                                                let _e804 = (bitcast<i32>((_e686 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e807 = bitcast<f32>((_e799 & bitcast<u32>(_e804)));
                                                let _e811 = bitcast<f32>((_e781 & bitcast<u32>(~(_e786))));
                                                let _e815 = bitcast<f32>((_e790 & bitcast<u32>(~(_e795))));
                                                let _e819 = bitcast<f32>((_e799 & bitcast<u32>(~(_e804))));
                                                let _e820 = (_e623.member.member.x + _e750);
                                                let _e821 = (_e623.member.member.y + _e759);
                                                let _e822 = (_e623.member.member.z + _e768);
                                                let _e825 = (_e623.member.member_1.x - _e789);
                                                let _e826 = (_e623.member.member_1.y - _e798);
                                                let _e827 = (_e623.member.member_1.z - _e807);
                                                let _e846 = (_e825 - _e820);
                                                let _e847 = (_e826 - _e821);
                                                let _e848 = (_e827 - _e822);
                                                let _e850 = select(_e847, _e846, (_e846 > _e847));
                                                let _e852 = select(_e848, _e850, (_e850 > _e848));
                                                if (_e852 < (1024f * _e158)) {
                                                    phi_4035_ = 0u;
                                                } else {
                                                    phi_4035_ = select(2u, 1u, (_e852 < (2097152f * _e158)));
                                                }
                                                let _e859 = phi_4035_;
                                                switch bitcast<i32>(_e859) {
                                                    case 0: {
                                                        phi_4041_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_4041_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_4041_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_4041_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e862 = phi_4041_;
                                                let _e868 = global_8.member[_e623.member_1][0u];
                                                let _e872 = global_8.member[_e623.member_1][2u];
                                                let _e876 = global_8.member[_e623.member_1][4u];
                                                let _e880 = global_8.member[_e623.member_1][6u];
                                                let _e892 = (((_e872 >> bitcast<u32>(22i)) | ((_e876 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e880 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e893 = (_e868 & 268435455u);
                                                let _e894 = (_e892 & 268435455u);
                                                let _e897 = ((_e868 >> bitcast<u32>(28u)) & 7u);
                                                let _e905 = ((_e868 >> bitcast<u32>(31i)) | (((_e892 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e906 = (_e897 != 0u);
                                                if (_e897 == 0u) {
                                                    phi_4296_ = _e893;
                                                } else {
                                                    if (_e897 == 7u) {
                                                        phi_4295_ = 2147483648u;
                                                    } else {
                                                        phi_4295_ = ((2147483648u | (_e897 << bitcast<u32>(28u))) | (_e894 & 268435455u));
                                                    }
                                                    let _e915 = phi_4295_;
                                                    phi_4296_ = _e915;
                                                }
                                                let _e917 = phi_4296_;
                                                if _e906 {
                                                    let _e918 = (_e897 != 7u);
                                                    if _e918 {
                                                        phi_4306_ = (_e894 + (_e897 * ((3u * _e862) + 1u)));
                                                    } else {
                                                        phi_4306_ = u32();
                                                    }
                                                    let _e922 = phi_4306_;
                                                    phi_4308_ = _e922;
                                                    phi_4309_ = select(true, false, _e918);
                                                } else {
                                                    phi_4308_ = u32();
                                                    phi_4309_ = true;
                                                }
                                                let _e925 = phi_4308_;
                                                let _e927 = phi_4309_;
                                                if (_e905 == 0u) {
                                                    phi_4330_ = (_e893 + select(0u, 1u, !(_e906)));
                                                } else {
                                                    if (_e905 == 7u) {
                                                        phi_4329_ = 2147483648u;
                                                    } else {
                                                        phi_4329_ = ((2147483648u | (_e905 << bitcast<u32>(28u))) | (select(_e925, _e894, _e927) & 268435455u));
                                                    }
                                                    let _e940 = phi_4329_;
                                                    phi_4330_ = _e940;
                                                }
                                                let _e942 = phi_4330_;
                                                phi_4334_ = type_63(array<vec4<f32>, 3>(vec4<f32>(_e820, (_e623.member.member.x + _e772), _e825, (_e623.member.member_1.x - _e811)), vec4<f32>(_e821, (_e623.member.member.y + _e776), _e826, (_e623.member.member_1.y - _e815)), vec4<f32>(_e822, (_e623.member.member.z + _e780), _e827, (_e623.member.member_1.z - _e819))), type_60(type_30((_e623.member.member + vec4<f32>(_e750, _e759, _e768, 0f)), (_e623.member.member_1 - vec4<f32>(_e789, _e798, _e807, 0f))), _e917), type_60(type_30((_e623.member.member + vec4<f32>(_e772, _e776, _e780, 0f)), (_e623.member.member_1 - vec4<f32>(_e811, _e815, _e819, 0f))), _e942));
                                            }
                                            let _e947 = phi_4334_;
                                            let _e959 = ((_e947.member[0].x - _e427) * _e432);
                                            let _e960 = ((_e947.member[0].y - _e427) * _e432);
                                            let _e961 = ((_e947.member[0].z - _e428) * _e432);
                                            let _e962 = ((_e947.member[0].w - _e428) * _e432);
                                            let _e972 = ((_e947.member[1].x - _e463) * _e468);
                                            let _e973 = ((_e947.member[1].y - _e463) * _e468);
                                            let _e974 = ((_e947.member[1].z - _e464) * _e468);
                                            let _e975 = ((_e947.member[1].w - _e464) * _e468);
                                            let _e985 = ((_e947.member[2].x - _e499) * _e504);
                                            let _e986 = ((_e947.member[2].y - _e499) * _e504);
                                            let _e987 = ((_e947.member[2].z - _e500) * _e504);
                                            let _e988 = ((_e947.member[2].w - _e500) * _e504);
                                            let _e990 = select(_e987, _e985, (_e985 < _e987));
                                            let _e992 = select(_e988, _e986, (_e986 < _e988));
                                            let _e994 = select(_e987, _e985, (_e985 > _e987));
                                            let _e996 = select(_e988, _e986, (_e986 > _e988));
                                            let _e998 = select(_e961, _e959, (_e959 < _e961));
                                            let _e1000 = select(_e962, _e960, (_e960 < _e962));
                                            let _e1002 = select(_e974, _e972, (_e972 < _e974));
                                            let _e1004 = select(_e975, _e973, (_e973 < _e975));
                                            let _e1006 = select(_e1002, _e998, (_e998 > _e1002));
                                            let _e1008 = select(_e1004, _e1000, (_e1000 > _e1004));
                                            let _e1010 = select(_e990, _e1006, (_e1006 > _e990));
                                            let _e1012 = select(_e992, _e1008, (_e1008 > _e992));
                                            let _e1014 = select(_e961, _e959, (_e959 > _e961));
                                            let _e1016 = select(_e962, _e960, (_e960 > _e962));
                                            let _e1018 = select(_e974, _e972, (_e972 > _e974));
                                            let _e1020 = select(_e975, _e973, (_e973 > _e975));
                                            let _e1022 = select(_e1018, _e1014, (_e1014 < _e1018));
                                            let _e1024 = select(_e1020, _e1016, (_e1016 < _e1020));
                                            let _e1029 = -(_e990);
                                            let _e1030 = -(_e992);
                                            let _e1037 = (select(_e994, _e1022, (_e1022 < _e994)) + (select(_e1029, _e994, (_e994 > _e1029)) * 0.0000019073523f));
                                            let _e1038 = (select(_e996, _e1024, (_e1024 < _e996)) + (select(_e1030, _e996, (_e996 > _e1030)) * 0.0000019073523f));
                                            let _e1040 = select(_e550, _e1010, (_e1010 > _e550));
                                            let _e1042 = select(_e550, _e1012, (_e1012 > _e550));
                                            let _e1047 = (_e1040 <= select(_e594.member, _e1037, (_e1037 < _e594.member)));
                                            let _e1048 = (_e1042 <= select(_e594.member, _e1038, (_e1038 < _e594.member)));
                                            let _e1049 = (_e1040 <= _e1042);
                                            if _e1047 {
                                                if _e1048 {
                                                    if _e1049 {
                                                        phi_4678_ = _e947.member_2;
                                                    } else {
                                                        phi_4678_ = _e947.member_1;
                                                    }
                                                    let _e1053 = phi_4678_;
                                                    let _e1054 = (_e627 % 128u);
                                                    let _e1055 = (_e1054 < 128u);
                                                    if _e1055 {
                                                    } else {
                                                        phi_5145_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1054] = type_60(type_30(_e1053.member.member, _e1053.member.member_1), _e1053.member_1);
                                                    if _e1055 {
                                                    } else {
                                                        phi_5145_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1054] = select(_e1042, _e1040, (_e1040 > _e1042));
                                                    if _e1049 {
                                                        phi_4711_ = _e947.member_1;
                                                    } else {
                                                        phi_4711_ = _e947.member_2;
                                                    }
                                                    let _e1070 = phi_4711_;
                                                    phi_4712_ = _e1070;
                                                    phi_4713_ = (_e627 + 1u);
                                                } else {
                                                    phi_4712_ = type_60();
                                                    phi_4713_ = u32();
                                                }
                                                let _e1072 = phi_4712_;
                                                let _e1074 = phi_4713_;
                                                phi_4715_ = _e1072;
                                                phi_4716_ = _e1074;
                                                phi_4717_ = select(true, false, _e1048);
                                            } else {
                                                phi_4715_ = type_60();
                                                phi_4716_ = u32();
                                                phi_4717_ = true;
                                            }
                                            let _e1077 = phi_4715_;
                                            let _e1079 = phi_4716_;
                                            let _e1081 = phi_4717_;
                                            if _e1081 {
                                                if _e1047 {
                                                    phi_4726_ = _e947.member_1;
                                                } else {
                                                    phi_4726_ = _e947.member_2;
                                                }
                                                let _e1085 = phi_4726_;
                                                phi_4731_ = _e1085;
                                                phi_4732_ = select(_e1048, true, _e1047);
                                            } else {
                                                phi_4731_ = _e1077;
                                                phi_4732_ = _e625;
                                            }
                                            let _e1088 = phi_4731_;
                                            let _e1090 = phi_4732_;
                                            phi_5149_ = _e592;
                                            phi_4734_ = _e594;
                                            phi_4735_ = _e1088;
                                            phi_4736_ = _e1090;
                                            phi_4737_ = select(_e1079, _e627, _e1081);
                                        }
                                        let _e1826 = phi_5149_;
                                        let _e1828 = phi_4734_;
                                        let _e1830 = phi_4735_;
                                        let _e1832 = phi_4736_;
                                        let _e1834 = phi_4737_;
                                        phi_5148_ = _e1826;
                                        phi_4738_ = _e1828;
                                        phi_4739_ = _e1830;
                                        phi_4740_ = (_e598 - 1u);
                                        phi_4741_ = _e1832;
                                        phi_4742_ = _e1834;
                                    } else {
                                        phi_5148_ = _e592;
                                        phi_4738_ = _e594;
                                        phi_4739_ = _e623;
                                        phi_4740_ = _e598;
                                        phi_4741_ = _e625;
                                        phi_4742_ = _e627;
                                    }
                                    let _e1836 = phi_5148_;
                                    let _e1838 = phi_4738_;
                                    let _e1840 = phi_4739_;
                                    let _e1842 = phi_4740_;
                                    let _e1844 = phi_4741_;
                                    let _e1846 = phi_4742_;
                                    phi_5147_ = _e1836;
                                    phi_4743_ = _e1838;
                                    phi_4744_ = _e1840;
                                    phi_4745_ = _e1842;
                                    phi_4746_ = _e1844;
                                    phi_4747_ = _e1846;
                                } else {
                                    phi_5147_ = _e592;
                                    phi_4743_ = type_41();
                                    phi_4744_ = type_60();
                                    phi_4745_ = u32();
                                    phi_4746_ = bool();
                                    phi_4747_ = u32();
                                }
                                let _e1848 = phi_5147_;
                                let _e1850 = phi_4743_;
                                let _e1852 = phi_4744_;
                                let _e1854 = phi_4745_;
                                let _e1856 = phi_4746_;
                                let _e1858 = phi_4747_;
                                phi_5146_ = _e1848;
                                phi_2051_ = _e1850;
                                phi_2054_ = _e1852;
                                phi_2056_ = _e1854;
                                phi_2058_ = _e1856;
                                phi_2060_ = _e1858;
                                phi_4748_ = _e606;
                            } else {
                                phi_5146_ = _e592;
                                phi_2051_ = type_41();
                                phi_2054_ = type_60();
                                phi_2056_ = u32();
                                phi_2058_ = bool();
                                phi_2060_ = u32();
                                phi_4748_ = false;
                            }
                            let _e1860 = phi_5146_;
                            let _e1862 = phi_2051_;
                            let _e1864 = phi_2054_;
                            let _e1866 = phi_2056_;
                            let _e1868 = phi_2058_;
                            let _e1870 = phi_2060_;
                            let _e1872 = phi_4748_;
                            continue;
                            continuing {
                                phi_5007_ = _e1860;
                                phi_2050_ = _e1862;
                                phi_2053_ = _e1864;
                                phi_2055_ = _e1866;
                                phi_2057_ = _e1868;
                                phi_2059_ = _e1870;
                                phi_5145_ = _e1860;
                                break if !(_e1872);
                            }
                        }
                        let _e1875 = phi_5145_;
                        if _e1875 {
                            break;
                        }
                        let _e1877 = local_8;
                        if _e1877.member_1 {
                        } else {
                            if _e240 {
                            } else {
                                break;
                            }
                            let _e1881 = global_2.member[_e146];
                            if _e161 {
                            } else {
                                break;
                            }
                            let _e1885 = global_9.member[_e146].member_1;
                            if _e240 {
                            } else {
                                break;
                            }
                            global_2.member[_e146] = type_23(_e1881.member, _e1881.member_1, _e1881.member_2, array<f32, 3>((_e1881.member_3[0] + (_e1885[0] * _e1881.member_1[0])), (_e1881.member_3[1] + (_e1885[1] * _e1881.member_1[1])), (_e1881.member_3[2] + (_e1885[2] * _e1881.member_1[2]))), _e1881.member_4);
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
