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

struct type_45 {
    member: f32,
    member_1: bool,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_60 {
    member: type_34,
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
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_29;
@group(0) @binding(1) 
var<uniform> global_3: type_47;
@group(0) @binding(2) 
var<uniform> global_4: type_47;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_50;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_70;
@group(0) @binding(7) 
var<storage> global_9: type_37;
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
    var phi_5007_: bool;
    var phi_2050_: type_45;
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
    var phi_2128_: type_45;
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
    var phi_3036_: type_25;
    var phi_3038_: type_25;
    var phi_3039_: bool;
    var phi_3043_: type_25;
    var phi_3044_: type_25;
    var phi_3045_: type_25;
    var phi_3046_: bool;
    var phi_3050_: type_25;
    var phi_3051_: bool;
    var phi_3055_: type_25;
    var phi_3056_: bool;
    var phi_3060_: type_25;
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
    var phi_3394_: type_45;
    var phi_3395_: type_45;
    var phi_5070_: bool;
    var phi_2129_: type_45;
    var phi_5069_: bool;
    var local_7: type_45;
    var phi_5149_: bool;
    var phi_4734_: type_45;
    var phi_4735_: type_60;
    var phi_4736_: bool;
    var phi_4737_: u32;
    var phi_5148_: bool;
    var phi_4738_: type_45;
    var phi_4739_: type_60;
    var phi_4740_: u32;
    var phi_4741_: bool;
    var phi_4742_: u32;
    var phi_5147_: bool;
    var phi_4743_: type_45;
    var phi_4744_: type_60;
    var phi_4745_: u32;
    var phi_4746_: bool;
    var phi_4747_: u32;
    var phi_5146_: bool;
    var phi_2051_: type_45;
    var phi_2054_: type_60;
    var phi_2056_: u32;
    var phi_2058_: bool;
    var phi_2060_: u32;
    var phi_4748_: bool;
    var phi_5145_: bool;
    var local_8: type_45;
    var local_9: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_5.member));
            let _e103 = arrayLength((&global_10.member));
            let _e115 = arrayLength((&global_8.member));
            let _e119 = global_4.member[0u][0u];
            let _e123 = global_4.member[0u][1u];
            let _e127 = global_4.member[0u][2u];
            let _e131 = global_4.member[0u][3u];
            let _e135 = global_4.member[1u][0u];
            let _e139 = global_4.member[1u][1u];
            let _e143 = global_4.member[1u][2u];
            let _e147 = (_e98.x + (_e98.y * 2097152u));
            let _e159 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e131) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            local = array<i32, 3>(bitcast<i32>(_e135), bitcast<i32>(_e139), bitcast<i32>(_e143));
            let _e162 = (_e147 < arrayLength((&global_9.member)));
            if _e162 {
                if _e162 {
                } else {
                    break;
                }
                let _e166 = global_9.member[_e147].member_2;
                phi_342_ = _e166;
            } else {
                phi_342_ = 4294967295u;
            }
            let _e168 = phi_342_;
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
                phi_386_ = -126i;
            } else {
                phi_386_ = select(_e211, 127i, (_e211 > 127i));
            }
            let _e216 = phi_386_;
            let _e221 = bitcast<f32>((bitcast<u32>((_e216 + 127i)) << bitcast<u32>(23i)));
            let _e227 = bitcast<f32>((bitcast<u32>(((_e211 - _e216) + 127i)) << bitcast<u32>(23i)));
            if (_e187 == 0u) {
                phi_410_ = type_41(array<f32, 3>(_e204, _e205, _e206), _e187, _e208, _e209);
            } else {
                phi_410_ = type_41(array<f32, 3>(((_e204 * _e221) * _e227), ((_e205 * _e221) * _e227), ((_e206 * _e221) * _e227)), _e187, ((_e208 * _e221) * _e227), _e209);
            }
            let _e240 = phi_410_;
            if _e162 {
                let _e241 = (_e147 < arrayLength((&global_2.member)));
                if _e241 {
                    if _e162 {
                    } else {
                        break;
                    }
                    let _e246 = global_9.member[_e147].member.member_1;
                    let _e251 = global_9.member[_e147].member.member_3;
                    if (_e246 <= _e251) {
                        let _e253 = (1u < _e115);
                        if _e253 {
                            if (0u < _e115) {
                            } else {
                                break;
                            }
                            let _e257 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e257 + 1u) < _e257) {
                                if _e253 {
                                } else {
                                    break;
                                }
                                let _e262 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e162 {
                        } else {
                            break;
                        }
                        let _e272 = global_9.member[_e147].member.member_2[0u];
                        let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                        let _e280 = global_9.member[_e147].member.member_2[1u];
                        let _e282 = (bitcast<u32>(_e280) & 2147483647u);
                        let _e288 = global_9.member[_e147].member.member_2[2u];
                        let _e290 = (bitcast<u32>(_e288) & 2147483647u);
                        let _e296 = global_9.member[_e147].member.member[0u];
                        let _e298 = (bitcast<u32>(_e296) & 2147483647u);
                        let _e304 = global_9.member[_e147].member.member[1u];
                        let _e306 = (bitcast<u32>(_e304) & 2147483647u);
                        let _e312 = global_9.member[_e147].member.member[2u];
                        let _e314 = (bitcast<u32>(_e312) & 2147483647u);
                        let _e316 = select(_e282, _e274, (_e282 < _e274));
                        let _e318 = select(_e290, _e316, (_e290 < _e316));
                        let _e320 = select(_e298, _e318, (_e298 < _e318));
                        let _e322 = select(_e306, _e320, (_e306 < _e320));
                        let _e324 = select(_e314, _e322, (_e314 < _e322));
                        let _e326 = (bitcast<u32>(_e246) & 2147483647u);
                        let _e335 = (((select(_e326, _e324, (_e326 < _e324)) < 2139095040u) && ((bitcast<u32>(_e251) & 2147483647u) <= 2139095040u)) && (_e318 > 0u));
                        if _e335 {
                            let _e338 = (bitcast<u32>(bitcast<f32>(_e318)) & 2147483647u);
                            if (_e338 >= 8388608u) {
                                phi_560_ = (bitcast<i32>((_e338 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_560_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e338)), 32u, (_e338 == 0u))));
                            }
                            let _e352 = phi_560_;
                            phi_561_ = _e352;
                        } else {
                            phi_561_ = 0i;
                        }
                        let _e354 = phi_561_;
                        let _e355 = (_e274 == _e318);
                        if _e355 {
                            phi_571_ = true;
                        } else {
                            phi_571_ = (_e282 == _e318);
                        }
                        let _e358 = phi_571_;
                        let _e359 = select(1u, 0u, _e355);
                        if _e358 {
                            let _e360 = (_e359 + 1u);
                            phi_581_ = _e360;
                            phi_582_ = _e360;
                            phi_584_ = select(true, false, (_e360 == 2u));
                        } else {
                            phi_581_ = u32();
                            phi_582_ = 0u;
                            phi_584_ = true;
                        }
                        let _e364 = phi_581_;
                        let _e366 = phi_582_;
                        let _e368 = phi_584_;
                        if _e368 {
                            phi_589_ = (_e366 + 1u);
                        } else {
                            phi_589_ = 0u;
                        }
                        let _e372 = phi_589_;
                        let _e373 = select(_e364, _e366, _e368);
                        let _e374 = select(_e359, select(2u, _e359, _e358), _e368);
                        let _e375 = -(_e354);
                        if (_e375 < -126i) {
                            phi_622_ = -126i;
                        } else {
                            phi_622_ = select(_e375, 127i, (_e375 > 127i));
                        }
                        let _e380 = phi_622_;
                        let _e385 = bitcast<f32>((bitcast<u32>((_e380 + 127i)) << bitcast<u32>(23i)));
                        let _e391 = bitcast<f32>((bitcast<u32>(((_e375 - _e380) + 127i)) << bitcast<u32>(23i)));
                        let _e396 = global_9.member[_e147].member.member;
                        let _e397 = (_e373 == 0u);
                        if _e397 {
                            phi_640_ = _e396[0];
                        } else {
                            phi_640_ = _e396[1];
                        }
                        let _e401 = phi_640_;
                        let _e402 = (_e373 == 2u);
                        if _e402 {
                            phi_646_ = _e396[2];
                        } else {
                            phi_646_ = _e401;
                        }
                        let _e405 = phi_646_;
                        let _e406 = global_9.member[_e147].member.member_2;
                        if _e397 {
                            phi_657_ = _e406[0];
                        } else {
                            phi_657_ = _e406[1];
                        }
                        let _e410 = phi_657_;
                        if _e402 {
                            phi_663_ = _e406[2];
                        } else {
                            phi_663_ = _e410;
                        }
                        let _e413 = phi_663_;
                        let _e415 = ((_e413 * _e385) * _e391);
                        let _e419 = (bitcast<f32>((bitcast<u32>(_e415) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e419 {
                            let _e423 = (bitcast<f32>((bitcast<u32>(_e405) & 2147483647u)) * 0.00000011920929f);
                            phi_686_ = select(0.00000000000011368684f, _e423, (_e423 > 0.00000000000011368684f));
                        } else {
                            phi_686_ = 0f;
                        }
                        let _e427 = phi_686_;
                        let _e428 = (_e405 + _e427);
                        let _e429 = (_e405 - _e427);
                        let _e430 = select(_e415, 0f, _e419);
                        if _e419 {
                            phi_697_ = 38685626000000000000000000f;
                        } else {
                            phi_697_ = (1f / _e415);
                        }
                        let _e433 = phi_697_;
                        let _e434 = (_e372 == 0u);
                        if _e434 {
                            phi_706_ = _e396[0];
                        } else {
                            phi_706_ = _e396[1];
                        }
                        let _e438 = phi_706_;
                        let _e439 = (_e372 == 2u);
                        if _e439 {
                            phi_712_ = _e396[2];
                        } else {
                            phi_712_ = _e438;
                        }
                        let _e442 = phi_712_;
                        if _e434 {
                            phi_723_ = _e406[0];
                        } else {
                            phi_723_ = _e406[1];
                        }
                        let _e446 = phi_723_;
                        if _e439 {
                            phi_729_ = _e406[2];
                        } else {
                            phi_729_ = _e446;
                        }
                        let _e449 = phi_729_;
                        let _e451 = ((_e449 * _e385) * _e391);
                        let _e455 = (bitcast<f32>((bitcast<u32>(_e451) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e455 {
                            let _e459 = (bitcast<f32>((bitcast<u32>(_e442) & 2147483647u)) * 0.00000011920929f);
                            phi_752_ = select(0.00000000000011368684f, _e459, (_e459 > 0.00000000000011368684f));
                        } else {
                            phi_752_ = 0f;
                        }
                        let _e463 = phi_752_;
                        let _e464 = (_e442 + _e463);
                        let _e465 = (_e442 - _e463);
                        let _e466 = select(_e451, 0f, _e455);
                        if _e455 {
                            phi_763_ = 38685626000000000000000000f;
                        } else {
                            phi_763_ = (1f / _e451);
                        }
                        let _e469 = phi_763_;
                        let _e470 = (_e374 == 0u);
                        if _e470 {
                            phi_772_ = _e396[0];
                        } else {
                            phi_772_ = _e396[1];
                        }
                        let _e474 = phi_772_;
                        let _e475 = (_e374 == 2u);
                        if _e475 {
                            phi_778_ = _e396[2];
                        } else {
                            phi_778_ = _e474;
                        }
                        let _e478 = phi_778_;
                        if _e470 {
                            phi_789_ = _e406[0];
                        } else {
                            phi_789_ = _e406[1];
                        }
                        let _e482 = phi_789_;
                        if _e475 {
                            phi_795_ = _e406[2];
                        } else {
                            phi_795_ = _e482;
                        }
                        let _e485 = phi_795_;
                        let _e487 = ((_e485 * _e385) * _e391);
                        let _e491 = (bitcast<f32>((bitcast<u32>(_e487) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e491 {
                            let _e495 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) * 0.00000011920929f);
                            phi_818_ = select(0.00000000000011368684f, _e495, (_e495 > 0.00000000000011368684f));
                        } else {
                            phi_818_ = 0f;
                        }
                        let _e499 = phi_818_;
                        let _e500 = (_e478 + _e499);
                        let _e501 = (_e478 - _e499);
                        let _e502 = select(_e487, 0f, _e491);
                        if _e491 {
                            phi_829_ = 38685626000000000000000000f;
                        } else {
                            phi_829_ = (1f / _e487);
                        }
                        let _e505 = phi_829_;
                        let _e508 = bitcast<f32>((bitcast<u32>(_e405) & 2147483647u));
                        let _e511 = bitcast<f32>((bitcast<u32>(_e442) & 2147483647u));
                        let _e513 = select(_e511, _e508, (_e508 > _e511));
                        let _e516 = bitcast<f32>((bitcast<u32>(_e478) & 2147483647u));
                        if (_e335 && (select(_e516, _e513, (_e513 > _e516)) <= 1099511600000f)) {
                            let _e521 = (_e354 / 3i);
                            let _e528 = bitcast<f32>((bitcast<u32>((_e521 + 127i)) << bitcast<u32>(23i)));
                            let _e535 = bitcast<f32>((bitcast<u32>(((_e354 - (2i * _e521)) + 127i)) << bitcast<u32>(23i)));
                            let _e536 = (((_e246 * _e528) * _e528) * _e535);
                            let _e538 = select(340282350000000000000000000000000000000f, _e536, (_e536 < 340282350000000000000000000000000000000f));
                            let _e543 = (((_e251 * _e528) * _e528) * _e535);
                            let _e545 = select(340282350000000000000000000000000000000f, _e543, (_e543 < 340282350000000000000000000000000000000f));
                            phi_929_ = select(-340282350000000000000000000000000000000f, _e545, (_e545 > -340282350000000000000000000000000000000f));
                            phi_930_ = select(-340282350000000000000000000000000000000f, _e538, (_e538 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_929_ = 0f;
                            phi_930_ = 1f;
                        }
                        let _e549 = phi_929_;
                        let _e551 = phi_930_;
                        local_3 = array<type_60, 128>(type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e555 = (_e373 % 3u);
                        let _e556 = (_e555 < 3u);
                        if _e556 {
                        } else {
                            break;
                        }
                        let _e558 = local_1[_e555];
                        let _e561 = (_e372 % 3u);
                        let _e562 = (_e561 < 3u);
                        if _e562 {
                        } else {
                            break;
                        }
                        let _e564 = local_1[_e561];
                        let _e567 = (_e374 % 3u);
                        let _e568 = (_e567 < 3u);
                        if _e568 {
                        } else {
                            break;
                        }
                        let _e570 = local_1[_e567];
                        if _e556 {
                        } else {
                            break;
                        }
                        let _e575 = local[_e555];
                        if _e562 {
                        } else {
                            break;
                        }
                        let _e579 = local[_e561];
                        if _e568 {
                        } else {
                            break;
                        }
                        let _e583 = local[_e567];
                        phi_5007_ = false;
                        phi_2050_ = type_45(_e549, false);
                        phi_2053_ = type_60(type_34(vec4<f32>((f32(_e558) * _e159), (f32(_e564) * _e159), (f32(_e570) * _e159), 0f), vec4<f32>((f32(_e575) * _e159), (f32(_e579) * _e159), (f32(_e583) * _e159), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                        phi_2055_ = ((3u * _e100) + 1u);
                        phi_2057_ = (_e551 <= _e549);
                        phi_2059_ = 0u;
                        loop {
                            let _e593 = phi_5007_;
                            let _e595 = phi_2050_;
                            let _e597 = phi_2053_;
                            let _e599 = phi_2055_;
                            let _e601 = phi_2057_;
                            let _e603 = phi_2059_;
                            local_8 = _e595;
                            if _e601 {
                                phi_2070_ = true;
                            } else {
                                phi_2070_ = (_e603 > 0u);
                            }
                            let _e606 = phi_2070_;
                            if _e606 {
                                let _e607 = (_e599 > 0u);
                                if _e607 {
                                    if _e601 {
                                        phi_2107_ = _e597;
                                        phi_2108_ = _e601;
                                        phi_2109_ = _e603;
                                    } else {
                                        let _e608 = (_e603 - 1u);
                                        let _e609 = (_e608 % 128u);
                                        let _e610 = (_e609 < 128u);
                                        if _e610 {
                                        } else {
                                            phi_5145_ = true;
                                            break;
                                        }
                                        let _e612 = local_3[_e609];
                                        if _e610 {
                                        } else {
                                            phi_5145_ = true;
                                            break;
                                        }
                                        let _e620 = local_2[_e609];
                                        phi_2107_ = type_60(type_34(_e612.member.member, _e612.member.member_1), _e612.member_1);
                                        phi_2108_ = (_e620 <= _e595.member);
                                        phi_2109_ = _e608;
                                    }
                                    let _e624 = phi_2107_;
                                    let _e626 = phi_2108_;
                                    let _e628 = phi_2109_;
                                    if _e626 {
                                        let _e633 = (_e624.member_1 & 268435455u);
                                        if ((_e624.member_1 & 2147483648u) != 0u) {
                                            phi_5004_ = _e593;
                                            phi_2128_ = _e595;
                                            phi_2131_ = type_8(0u, ((_e624.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1095 = phi_5004_;
                                                let _e1097 = phi_2128_;
                                                let _e1099 = phi_2131_;
                                                local_7 = _e1097;
                                                local_9 = _e1097;
                                                if (_e1099.member < _e1099.member_1) {
                                                    phi_2132_ = type_8((_e1099.member + 1u), _e1099.member_1);
                                                    phi_2154_ = type_8(1u, _e1099.member);
                                                } else {
                                                    phi_2132_ = _e1099;
                                                    phi_2154_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1112 = phi_2132_;
                                                let _e1114 = phi_2154_;
                                                let _e1118 = (bitcast<i32>(_e1114.member) != 0i);
                                                if _e1118 {
                                                    let _e1123 = (_e624.member.member_1.x - _e624.member.member.x);
                                                    let _e1126 = (_e624.member.member_1.y - _e624.member.member.y);
                                                    let _e1129 = (_e624.member.member_1.z - _e624.member.member.z);
                                                    let _e1131 = select(_e1126, _e1123, (_e1123 > _e1126));
                                                    let _e1133 = select(_e1129, _e1131, (_e1131 > _e1129));
                                                    let _e1135 = (_e1133 < (1024f * _e159));
                                                    if _e1135 {
                                                        phi_2195_ = 0u;
                                                    } else {
                                                        phi_2195_ = select(2u, 1u, (_e1133 < (2097152f * _e159)));
                                                    }
                                                    let _e1140 = phi_2195_;
                                                    switch bitcast<i32>(_e1140) {
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
                                                    let _e1143 = phi_2201_;
                                                    switch bitcast<i32>(_e1140) {
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
                                                    let _e1150 = phi_2211_;
                                                    let _e1152 = ((_e633 + (_e1114.member_1 * ((3u * _e1143) + 1u))) + (3u * _e1150));
                                                    let _e1153 = (_e1152 < _e103);
                                                    if _e1153 {
                                                        if _e1153 {
                                                        } else {
                                                            phi_5069_ = true;
                                                            break;
                                                        }
                                                        let _e1155 = global_10.member[_e1152];
                                                        phi_2227_ = _e1155;
                                                    } else {
                                                        phi_2227_ = 4294967295u;
                                                    }
                                                    let _e1157 = phi_2227_;
                                                    local_4 = array<u32, 3>(_e373, _e372, _e374);
                                                    if _e1135 {
                                                        phi_2264_ = 0u;
                                                    } else {
                                                        phi_2264_ = select(2u, 1u, (_e1133 < (2097152f * _e159)));
                                                    }
                                                    let _e1163 = phi_2264_;
                                                    switch bitcast<i32>(_e1163) {
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
                                                    let _e1166 = phi_2270_;
                                                    switch bitcast<i32>(_e1163) {
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
                                                    let _e1173 = phi_2280_;
                                                    local_6 = array<f32, 4>(_e624.member.member.x, _e624.member.member.y, _e624.member.member.z, _e624.member.member.w);
                                                    local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4989_ = _e1095;
                                                    phi_2296_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1187 = phi_4989_;
                                                        let _e1189 = phi_2296_;
                                                        if (_e1189.member < _e1189.member_1) {
                                                            phi_2297_ = type_8((_e1189.member + 1u), _e1189.member_1);
                                                            phi_2320_ = type_8(1u, _e1189.member);
                                                        } else {
                                                            phi_2297_ = _e1189;
                                                            phi_2320_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1202 = phi_2297_;
                                                        let _e1204 = phi_2320_;
                                                        let _e1208 = (bitcast<i32>(_e1204.member) != 0i);
                                                        if _e1208 {
                                                            let _e1210 = ((_e633 + (_e1114.member_1 * ((3u * _e1166) + 1u))) + (_e1204.member_1 * _e1173));
                                                            let _e1211 = (_e1210 < _e103);
                                                            if _e1211 {
                                                                if _e1211 {
                                                                } else {
                                                                    phi_5067_ = true;
                                                                    break;
                                                                }
                                                                let _e1213 = global_10.member[_e1210];
                                                                phi_2343_ = _e1213;
                                                            } else {
                                                                phi_2343_ = 0u;
                                                            }
                                                            let _e1215 = phi_2343_;
                                                            let _e1216 = (_e1210 + 1u);
                                                            let _e1217 = (_e1216 < _e103);
                                                            if _e1217 {
                                                                if _e1217 {
                                                                } else {
                                                                    phi_5067_ = true;
                                                                    break;
                                                                }
                                                                let _e1219 = global_10.member[_e1216];
                                                                phi_2358_ = _e1219;
                                                            } else {
                                                                phi_2358_ = 0u;
                                                            }
                                                            let _e1221 = phi_2358_;
                                                            phi_2361_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1223 = phi_2361_;
                                                                if (_e1223.member < _e1223.member_1) {
                                                                    phi_2362_ = type_8((_e1223.member + 1u), _e1223.member_1);
                                                                    phi_2385_ = type_8(1u, _e1223.member);
                                                                } else {
                                                                    phi_2362_ = _e1223;
                                                                    phi_2385_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1236 = phi_2362_;
                                                                let _e1238 = phi_2385_;
                                                                let _e1242 = (bitcast<i32>(_e1238.member) != 0i);
                                                                if _e1242 {
                                                                    let _e1243 = (_e1238.member_1 < 3u);
                                                                    if _e1243 {
                                                                    } else {
                                                                        phi_4982_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1245 = local_4[_e1238.member_1];
                                                                    if (_e1238.member_1 < 4u) {
                                                                    } else {
                                                                        phi_4982_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1248 = local_6[_e1238.member_1];
                                                                    switch bitcast<i32>(_e1163) {
                                                                        case 0: {
                                                                            phi_2455_ = (_e1248 + (f32(((_e1215 >> bitcast<u32>(((10u * _e1245) & 31u))) & 1023u)) * _e159));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1245 == 0u) {
                                                                                phi_2432_ = _e1215;
                                                                            } else {
                                                                                if (_e1245 == 1u) {
                                                                                    phi_2431_ = ((_e1215 >> bitcast<u32>(21i)) | (_e1221 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_2431_ = (_e1221 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1269 = phi_2431_;
                                                                                phi_2432_ = _e1269;
                                                                            }
                                                                            let _e1271 = phi_2432_;
                                                                            phi_2455_ = (_e1248 + (f32((_e1271 & 2097151u)) * _e159));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1250 = (_e1210 + _e1245);
                                                                            let _e1251 = (_e1250 < _e103);
                                                                            if _e1251 {
                                                                                if _e1251 {
                                                                                } else {
                                                                                    phi_4982_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1253 = global_10.member[_e1250];
                                                                                phi_2451_ = _e1253;
                                                                            } else {
                                                                                phi_2451_ = 0u;
                                                                            }
                                                                            let _e1255 = phi_2451_;
                                                                            phi_2455_ = (f32(bitcast<i32>(_e1255)) * _e159);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_2455_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1285 = phi_2455_;
                                                                    if (_e1204.member_1 < 3u) {
                                                                    } else {
                                                                        phi_4982_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1243 {
                                                                    } else {
                                                                        phi_4982_ = true;
                                                                        break;
                                                                    }
                                                                    local_5[_e1204.member_1][_e1238.member_1] = _e1285;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_2361_ = _e1236;
                                                                    phi_4982_ = _e1187;
                                                                    break if !(_e1242);
                                                                }
                                                            }
                                                            let _e1291 = phi_4982_;
                                                            phi_5067_ = _e1291;
                                                            if _e1291 {
                                                                break;
                                                            }
                                                            phi_5068_ = _e1291;
                                                        } else {
                                                            phi_5068_ = _e1187;
                                                        }
                                                        let _e1293 = phi_5068_;
                                                        continue;
                                                        continuing {
                                                            phi_4989_ = _e1293;
                                                            phi_2296_ = _e1202;
                                                            phi_5067_ = _e1293;
                                                            break if !(_e1208);
                                                        }
                                                    }
                                                    let _e1296 = phi_5067_;
                                                    phi_5069_ = _e1296;
                                                    if _e1296 {
                                                        break;
                                                    }
                                                    let _e1297 = local_5;
                                                    let _e1313 = (_e1297[0][2] - _e478);
                                                    let _e1316 = (((_e1297[0][0] - _e405) * _e502) - (_e1313 * _e430));
                                                    let _e1319 = (((_e1297[0][1] - _e442) * _e502) - (_e1313 * _e466));
                                                    let _e1322 = (_e1297[1][2] - _e478);
                                                    let _e1325 = (((_e1297[1][0] - _e405) * _e502) - (_e1322 * _e430));
                                                    let _e1328 = (((_e1297[1][1] - _e442) * _e502) - (_e1322 * _e466));
                                                    let _e1331 = (_e1297[2][2] - _e478);
                                                    let _e1334 = (((_e1297[2][0] - _e405) * _e502) - (_e1331 * _e430));
                                                    let _e1337 = (((_e1297[2][1] - _e442) * _e502) - (_e1331 * _e466));
                                                    let _e1338 = (_e1334 * _e1328);
                                                    let _e1339 = (_e1337 * _e1325);
                                                    let _e1340 = (_e1316 * _e1337);
                                                    let _e1341 = (_e1319 * _e1334);
                                                    let _e1342 = (_e1325 * _e1319);
                                                    let _e1343 = (_e1328 * _e1316);
                                                    let _e1348 = (((_e1338 >= _e1339) && (_e1340 >= _e1341)) && (_e1342 >= _e1343));
                                                    if (_e1348 || (((_e1338 <= _e1339) && (_e1340 <= _e1341)) && (_e1342 <= _e1343))) {
                                                        let _e1355 = select(-1f, 1f, _e1348);
                                                        let _e1357 = ((_e1338 - _e1339) * _e1355);
                                                        let _e1359 = select(0f, _e1357, (_e1357 > 0f));
                                                        let _e1361 = ((_e1340 - _e1341) * _e1355);
                                                        let _e1363 = select(0f, _e1361, (_e1361 > 0f));
                                                        let _e1365 = ((_e1342 - _e1343) * _e1355);
                                                        let _e1367 = select(0f, _e1365, (_e1365 > 0f));
                                                        let _e1369 = ((_e1359 + _e1363) + _e1367);
                                                        if (_e1369 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3050_ = type_25();
                                                            phi_3051_ = true;
                                                        } else {
                                                            let _e1372 = select(_e1297[1][0], _e1297[0][0], (_e1297[0][0] < _e1297[1][0]));
                                                            let _e1376 = select(_e1297[1][0], _e1297[0][0], (_e1297[0][0] > _e1297[1][0]));
                                                            let _e1380 = select(_e1297[1][1], _e1297[0][1], (_e1297[0][1] < _e1297[1][1]));
                                                            let _e1384 = select(_e1297[1][1], _e1297[0][1], (_e1297[0][1] > _e1297[1][1]));
                                                            let _e1388 = select(_e1297[1][2], _e1297[0][2], (_e1297[0][2] < _e1297[1][2]));
                                                            let _e1392 = select(_e1297[1][2], _e1297[0][2], (_e1297[0][2] > _e1297[1][2]));
                                                            let _e1397 = ((select(_e1297[2][0], _e1372, (_e1372 < _e1297[2][0])) - _e428) * _e433);
                                                            let _e1398 = ((select(_e1297[2][0], _e1376, (_e1376 > _e1297[2][0])) - _e429) * _e433);
                                                            let _e1401 = ((select(_e1297[2][1], _e1380, (_e1380 < _e1297[2][1])) - _e464) * _e469);
                                                            let _e1402 = ((select(_e1297[2][1], _e1384, (_e1384 > _e1297[2][1])) - _e465) * _e469);
                                                            let _e1405 = ((select(_e1297[2][2], _e1388, (_e1388 < _e1297[2][2])) - _e500) * _e505);
                                                            let _e1406 = ((select(_e1297[2][2], _e1392, (_e1392 > _e1297[2][2])) - _e501) * _e505);
                                                            let _e1408 = select(_e1406, _e1405, (_e1405 < _e1406));
                                                            let _e1410 = select(_e1406, _e1405, (_e1405 > _e1406));
                                                            let _e1412 = select(_e1398, _e1397, (_e1397 < _e1398));
                                                            let _e1414 = select(_e1402, _e1401, (_e1401 < _e1402));
                                                            let _e1416 = select(_e1414, _e1412, (_e1412 > _e1414));
                                                            let _e1418 = select(_e1408, _e1416, (_e1416 > _e1408));
                                                            let _e1420 = select(_e1398, _e1397, (_e1397 > _e1398));
                                                            let _e1422 = select(_e1402, _e1401, (_e1401 > _e1402));
                                                            let _e1424 = select(_e1422, _e1420, (_e1420 < _e1422));
                                                            let _e1426 = select(_e1410, _e1424, (_e1424 < _e1410));
                                                            let _e1427 = -(_e1408);
                                                            let _e1433 = select(_e551, _e1418, (_e1418 > _e551));
                                                            if (_e1433 > (_e1426 + (select(_e1427, _e1410, (_e1410 > _e1427)) * 0.0000019073523f))) {
                                                                phi_3045_ = type_25();
                                                                phi_3046_ = true;
                                                            } else {
                                                                let _e1435 = (_e1433 > _e1097.member);
                                                                if _e1435 {
                                                                    phi_3044_ = type_25();
                                                                } else {
                                                                    let _e1439 = (_e1297[1][0] - _e1297[0][0]);
                                                                    let _e1440 = (_e1297[1][1] - _e1297[0][1]);
                                                                    let _e1441 = (_e1297[1][2] - _e1297[0][2]);
                                                                    let _e1442 = vec3<f32>(_e1439, _e1440, _e1441);
                                                                    let _e1443 = (_e1297[2][0] - _e1297[1][0]);
                                                                    let _e1444 = (_e1297[2][1] - _e1297[1][1]);
                                                                    let _e1445 = (_e1297[2][2] - _e1297[1][2]);
                                                                    let _e1446 = vec3<f32>(_e1443, _e1444, _e1445);
                                                                    let _e1447 = (_e1297[0][0] - _e1297[2][0]);
                                                                    let _e1448 = (_e1297[0][1] - _e1297[2][1]);
                                                                    let _e1449 = (_e1297[0][2] - _e1297[2][2]);
                                                                    let _e1450 = vec3<f32>(_e1447, _e1448, _e1449);
                                                                    let _e1453 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                                    let _e1456 = bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u));
                                                                    let _e1458 = select(_e1456, _e1453, (_e1453 > _e1456));
                                                                    let _e1461 = bitcast<f32>((bitcast<u32>(_e1441) & 2147483647u));
                                                                    let _e1463 = select(_e1461, _e1458, (_e1458 > _e1461));
                                                                    let _e1466 = bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u));
                                                                    let _e1469 = bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u));
                                                                    let _e1471 = select(_e1469, _e1466, (_e1466 > _e1469));
                                                                    let _e1474 = bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u));
                                                                    let _e1476 = select(_e1474, _e1471, (_e1471 > _e1474));
                                                                    let _e1479 = bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u));
                                                                    let _e1482 = bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u));
                                                                    let _e1484 = select(_e1482, _e1479, (_e1479 > _e1482));
                                                                    let _e1487 = bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u));
                                                                    let _e1489 = select(_e1487, _e1484, (_e1484 > _e1487));
                                                                    let _e1491 = select(_e1476, _e1463, (_e1463 > _e1476));
                                                                    let _e1493 = select(_e1489, _e1491, (_e1491 > _e1489));
                                                                    if (_e1463 == _e1493) {
                                                                        phi_2955_ = _e1446;
                                                                        phi_2956_ = _e1450;
                                                                    } else {
                                                                        let _e1496 = vec3((_e1476 == _e1493));
                                                                        phi_2955_ = select(_e1442, _e1450, _e1496);
                                                                        phi_2956_ = select(_e1446, _e1442, _e1496);
                                                                    }
                                                                    let _e1500 = phi_2955_;
                                                                    let _e1502 = phi_2956_;
                                                                    let _e1509 = ((_e1500.y * _e1502.z) - (_e1502.y * _e1500.z));
                                                                    let _e1514 = ((_e1500.z * _e1502.x) - (_e1502.z * _e1500.x));
                                                                    let _e1517 = ((_e1500.x * _e1502.y) - (_e1502.x * _e1500.y));
                                                                    if (_e1359 >= _e1363) {
                                                                        phi_2987_ = select(true, false, (_e1359 >= _e1367));
                                                                    } else {
                                                                        phi_2987_ = true;
                                                                    }
                                                                    let _e1522 = phi_2987_;
                                                                    if _e1522 {
                                                                        phi_2996_ = select(vec3<f32>(_e1297[2][0], _e1297[2][1], _e1297[2][2]), vec3<f32>(_e1297[1][0], _e1297[1][1], _e1297[1][2]), vec3((_e1363 >= _e1367)));
                                                                    } else {
                                                                        phi_2996_ = vec3<f32>(_e1297[0][0], _e1297[0][1], _e1297[0][2]);
                                                                    }
                                                                    let _e1527 = phi_2996_;
                                                                    let _e1544 = ((((_e1509 * (_e1527.x - _e405)) + (_e1514 * (_e1527.y - _e442))) + (_e1517 * (_e1527.z - _e478))) / (((_e1509 * _e430) + (_e1514 * _e466)) + (_e1517 * _e502)));
                                                                    let _e1546 = select(_e1426, _e1544, (_e1544 < _e1426));
                                                                    let _e1548 = select(_e1418, _e1546, (_e1546 > _e1418));
                                                                    if (_e1548 >= _e551) {
                                                                        let _e1550 = (_e1548 <= _e1097.member);
                                                                        if _e1550 {
                                                                            let _e1551 = (1f / _e1369);
                                                                            phi_3036_ = type_25(_e1548, (_e1363 * _e1551), (_e1367 * _e1551), _e1157);
                                                                        } else {
                                                                            phi_3036_ = type_25();
                                                                        }
                                                                        let _e1556 = phi_3036_;
                                                                        phi_3038_ = _e1556;
                                                                        phi_3039_ = select(true, false, _e1550);
                                                                    } else {
                                                                        phi_3038_ = type_25();
                                                                        phi_3039_ = true;
                                                                    }
                                                                    let _e1559 = phi_3038_;
                                                                    let _e1561 = phi_3039_;
                                                                    if _e1561 {
                                                                        phi_3043_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3043_ = _e1559;
                                                                    }
                                                                    let _e1563 = phi_3043_;
                                                                    phi_3044_ = _e1563;
                                                                }
                                                                let _e1565 = phi_3044_;
                                                                phi_3045_ = _e1565;
                                                                phi_3046_ = _e1435;
                                                            }
                                                            let _e1567 = phi_3045_;
                                                            let _e1569 = phi_3046_;
                                                            phi_3050_ = _e1567;
                                                            phi_3051_ = _e1569;
                                                        }
                                                        let _e1571 = phi_3050_;
                                                        let _e1573 = phi_3051_;
                                                        phi_3055_ = _e1571;
                                                        phi_3056_ = _e1573;
                                                    } else {
                                                        phi_3055_ = type_25();
                                                        phi_3056_ = true;
                                                    }
                                                    let _e1575 = phi_3055_;
                                                    let _e1577 = phi_3056_;
                                                    if _e1577 {
                                                        phi_3060_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3060_ = _e1575;
                                                    }
                                                    let _e1579 = phi_3060_;
                                                    if (_e1579.member_3 != 4294967295u) {
                                                        if (_e1157 == _e168) {
                                                            phi_3389_ = false;
                                                        } else {
                                                            let _e1583 = (_e1157 < arrayLength((&global_6.member)));
                                                            if _e1583 {
                                                                if _e1583 {
                                                                } else {
                                                                    phi_5069_ = true;
                                                                    break;
                                                                }
                                                                let _e1585 = global_6.member[_e1157];
                                                                phi_3083_ = _e1585;
                                                            } else {
                                                                phi_3083_ = 4294967295u;
                                                            }
                                                            let _e1587 = phi_3083_;
                                                            let _e1588 = (_e1587 < arrayLength((&global_7.member)));
                                                            if _e1588 {
                                                                if _e1588 {
                                                                } else {
                                                                    phi_5069_ = true;
                                                                    break;
                                                                }
                                                                let _e1590 = global_7.member[_e1587];
                                                                phi_3097_ = _e1590;
                                                            } else {
                                                                phi_3097_ = 0i;
                                                            }
                                                            let _e1592 = phi_3097_;
                                                            let _e1593 = (_e1592 == 0i);
                                                            if _e1593 {
                                                                phi_3388_ = true;
                                                            } else {
                                                                if _e397 {
                                                                    phi_3118_ = vec3<f32>(_e1297[0][0], _e1297[0][1], _e1297[0][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_3117_ = vec3<f32>(_e1297[0][2], _e1297[0][0], _e1297[0][1]);
                                                                    } else {
                                                                        phi_3117_ = vec3<f32>(_e1297[0][1], _e1297[0][2], _e1297[0][0]);
                                                                    }
                                                                    let _e1598 = phi_3117_;
                                                                    phi_3118_ = _e1598;
                                                                }
                                                                let _e1601 = phi_3118_;
                                                                if _e397 {
                                                                    phi_3135_ = vec3<f32>(_e1297[1][0], _e1297[1][1], _e1297[1][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_3134_ = vec3<f32>(_e1297[1][2], _e1297[1][0], _e1297[1][1]);
                                                                    } else {
                                                                        phi_3134_ = vec3<f32>(_e1297[1][1], _e1297[1][2], _e1297[1][0]);
                                                                    }
                                                                    let _e1606 = phi_3134_;
                                                                    phi_3135_ = _e1606;
                                                                }
                                                                let _e1609 = phi_3135_;
                                                                if _e397 {
                                                                    phi_3152_ = vec3<f32>(_e1297[2][0], _e1297[2][1], _e1297[2][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_3151_ = vec3<f32>(_e1297[2][2], _e1297[2][0], _e1297[2][1]);
                                                                    } else {
                                                                        phi_3151_ = vec3<f32>(_e1297[2][1], _e1297[2][2], _e1297[2][0]);
                                                                    }
                                                                    let _e1614 = phi_3151_;
                                                                    phi_3152_ = _e1614;
                                                                }
                                                                let _e1617 = phi_3152_;
                                                                let _e1620 = (_e1609.x - _e1601.x);
                                                                let _e1623 = (_e1609.y - _e1601.y);
                                                                let _e1626 = (_e1609.z - _e1601.z);
                                                                let _e1628 = (_e1617.x - _e1601.x);
                                                                let _e1630 = (_e1617.y - _e1601.y);
                                                                let _e1632 = (_e1617.z - _e1601.z);
                                                                if (_e240.member_1 == 1u) {
                                                                    phi_3188_ = (vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]) - _e1601);
                                                                } else {
                                                                    phi_3188_ = vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]);
                                                                }
                                                                let _e1647 = phi_3188_;
                                                                let _e1653 = bitcast<f32>((bitcast<u32>((_e1620 * _e1630)) ^ _e240.member_3[0]));
                                                                let _e1657 = bitcast<f32>((bitcast<u32>((_e1623 * _e1628)) ^ _e240.member_3[0]));
                                                                let _e1661 = bitcast<f32>((bitcast<u32>((_e1623 * _e1632)) ^ _e240.member_3[0]));
                                                                let _e1665 = bitcast<f32>((bitcast<u32>((_e1626 * _e1630)) ^ _e240.member_3[0]));
                                                                let _e1669 = bitcast<f32>((bitcast<u32>((_e1626 * _e1628)) ^ _e240.member_3[0]));
                                                                let _e1673 = bitcast<f32>((bitcast<u32>((_e1620 * _e1632)) ^ _e240.member_3[0]));
                                                                let _e1674 = (_e1661 - _e1665);
                                                                let _e1675 = (_e1669 - _e1673);
                                                                let _e1676 = (_e1653 - _e1657);
                                                                let _e1700 = (bitcast<f32>((bitcast<u32>(_e1661) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1665) & 2147483647u)));
                                                                let _e1707 = (bitcast<f32>((bitcast<u32>(_e1669) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1673) & 2147483647u)));
                                                                let _e1714 = (bitcast<f32>((bitcast<u32>(_e1653) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1657) & 2147483647u)));
                                                                if (_e240.member_2 == 0f) {
                                                                    phi_3370_ = 0f;
                                                                } else {
                                                                    let _e1744 = bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u));
                                                                    let _e1747 = bitcast<f32>((bitcast<u32>(_e1675) & 2147483647u));
                                                                    let _e1750 = bitcast<f32>((bitcast<u32>(_e1676) & 2147483647u));
                                                                    let _e1752 = select(_e1750, _e1747, (_e1747 > _e1750));
                                                                    let _e1756 = select(_e1750, _e1747, (_e1747 < _e1750));
                                                                    let _e1760 = select(_e1747, _e1744, (_e1744 < _e1747));
                                                                    let _e1762 = select(_e1747, _e1744, (_e1744 > _e1747));
                                                                    let _e1764 = select(_e1750, _e1762, (_e1762 < _e1750));
                                                                    phi_3370_ = bitcast<f32>((bitcast<u32>((_e240.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1752, _e1744, (_e1744 > _e1752)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1764, _e1760, (_e1760 > _e1764)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1756, _e1744, (_e1744 < _e1756)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1700 + _e1707) + _e1714))) ^ _e240.member_3[0]))) * 1.0000005f)) ^ _e240.member_3[0])))) ^ _e240.member_3[0]));
                                                                }
                                                                let _e1791 = phi_3370_;
                                                                phi_3388_ = (_e1593 || !(((((bitcast<f32>((bitcast<u32>((_e1647.x * _e1674)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1647.y * _e1675)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1647.z * _e1676)) ^ _e240.member_3[0]))) * f32(-(_e1592))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1647.x) & 2147483647u)) * _e1700)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1647.y) & 2147483647u)) * _e1707)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1647.z) & 2147483647u)) * _e1714)) ^ _e240.member_3[0]))))) ^ _e240.member_3[0])) + _e1791) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1805 = phi_3388_;
                                                            phi_3389_ = _e1805;
                                                        }
                                                        let _e1807 = phi_3389_;
                                                        if _e1807 {
                                                            phi_3394_ = type_45(_e1097.member, true);
                                                        } else {
                                                            phi_3394_ = _e1097;
                                                        }
                                                        let _e1812 = phi_3394_;
                                                        phi_3395_ = _e1812;
                                                    } else {
                                                        phi_3395_ = _e1097;
                                                    }
                                                    let _e1814 = phi_3395_;
                                                    phi_5070_ = _e1296;
                                                    phi_2129_ = _e1814;
                                                } else {
                                                    phi_5070_ = _e1095;
                                                    phi_2129_ = type_45();
                                                }
                                                let _e1816 = phi_5070_;
                                                let _e1818 = phi_2129_;
                                                continue;
                                                continuing {
                                                    phi_5004_ = _e1816;
                                                    phi_2128_ = _e1818;
                                                    phi_2131_ = _e1112;
                                                    phi_5069_ = _e1816;
                                                    break if !(_e1118);
                                                }
                                            }
                                            let _e1821 = phi_5069_;
                                            phi_5145_ = _e1821;
                                            if _e1821 {
                                                break;
                                            }
                                            let _e1823 = local_7;
                                            phi_5149_ = _e1821;
                                            let _e2035 = local_9;
                                            phi_4734_ = _e2035;
                                            phi_4735_ = _e624;
                                            phi_4736_ = false;
                                            phi_4737_ = select(_e628, 0u, _e1823.member_1);
                                        } else {
                                            if (_e624.member_1 >= _e100) {
                                                phi_4334_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e624.member_1 < _e100) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e641 = ((1u + _e373) % 4u);
                                                if (_e641 < 4u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e646 = global_5.member[_e624.member_1][_e641];
                                                let _e648 = ((1u + _e372) % 4u);
                                                if (_e648 < 4u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e653 = global_5.member[_e624.member_1][_e648];
                                                let _e655 = ((1u + _e374) % 4u);
                                                if (_e655 < 4u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e660 = global_5.member[_e624.member_1][_e655];
                                                let _e662 = ((_e373 + 1u) % 4u);
                                                if (_e662 < 4u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e667 = global_5.member[_e624.member_1][_e662];
                                                let _e669 = (_e667 >> bitcast<u32>(11u));
                                                let _e671 = ((_e372 + 1u) % 4u);
                                                if (_e671 < 4u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e676 = global_5.member[_e624.member_1][_e671];
                                                let _e678 = (_e676 >> bitcast<u32>(11u));
                                                let _e680 = ((_e374 + 1u) % 4u);
                                                if (_e680 < 4u) {
                                                } else {
                                                    phi_5145_ = true;
                                                    break;
                                                }
                                                let _e685 = global_5.member[_e624.member_1][_e680];
                                                let _e687 = (_e685 >> bitcast<u32>(11u));
                                                let _e710 = (bitcast<f32>((bitcast<u32>((_e624.member.member_1.x - _e624.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e711 = (bitcast<f32>((bitcast<u32>((_e624.member.member_1.y - _e624.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e712 = (bitcast<f32>((bitcast<u32>((_e624.member.member_1.z - _e624.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e714 = select(_e159, _e710, (_e710 > _e159));
                                                let _e716 = select(_e159, _e711, (_e711 > _e159));
                                                let _e718 = select(_e159, _e712, (_e712 > _e159));
                                                let _e743 = bitcast<u32>((f32(bitcast<i32>((_e646 & 1023u))) * _e714));
                                                let _e748 = (bitcast<i32>((_e646 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e751 = bitcast<f32>((_e743 & bitcast<u32>(_e748)));
                                                let _e752 = bitcast<u32>((f32(bitcast<i32>((_e653 & 1023u))) * _e716));
                                                let _e757 = (bitcast<i32>((_e653 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e760 = bitcast<f32>((_e752 & bitcast<u32>(_e757)));
                                                let _e761 = bitcast<u32>((f32(bitcast<i32>((_e660 & 1023u))) * _e718));
                                                let _e766 = (bitcast<i32>((_e660 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e769 = bitcast<f32>((_e761 & bitcast<u32>(_e766)));
                                                let _e773 = bitcast<f32>((_e743 & bitcast<u32>(~(_e748))));
                                                let _e777 = bitcast<f32>((_e752 & bitcast<u32>(~(_e757))));
                                                let _e781 = bitcast<f32>((_e761 & bitcast<u32>(~(_e766))));
                                                let _e782 = bitcast<u32>((f32(bitcast<i32>((_e669 & 1023u))) * _e714));
                                                let _e787 = (bitcast<i32>((_e669 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e790 = bitcast<f32>((_e782 & bitcast<u32>(_e787)));
                                                let _e791 = bitcast<u32>((f32(bitcast<i32>((_e678 & 1023u))) * _e716));
                                                let _e796 = (bitcast<i32>((_e678 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e799 = bitcast<f32>((_e791 & bitcast<u32>(_e796)));
                                                let _e800 = bitcast<u32>((f32(bitcast<i32>((_e687 & 1023u))) * _e718));
                                                let _e805 = (bitcast<i32>((_e687 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e808 = bitcast<f32>((_e800 & bitcast<u32>(_e805)));
                                                let _e812 = bitcast<f32>((_e782 & bitcast<u32>(~(_e787))));
                                                let _e816 = bitcast<f32>((_e791 & bitcast<u32>(~(_e796))));
                                                let _e820 = bitcast<f32>((_e800 & bitcast<u32>(~(_e805))));
                                                let _e821 = (_e624.member.member.x + _e751);
                                                let _e822 = (_e624.member.member.y + _e760);
                                                let _e823 = (_e624.member.member.z + _e769);
                                                let _e826 = (_e624.member.member_1.x - _e790);
                                                let _e827 = (_e624.member.member_1.y - _e799);
                                                let _e828 = (_e624.member.member_1.z - _e808);
                                                let _e847 = (_e826 - _e821);
                                                let _e848 = (_e827 - _e822);
                                                let _e849 = (_e828 - _e823);
                                                let _e851 = select(_e848, _e847, (_e847 > _e848));
                                                let _e853 = select(_e849, _e851, (_e851 > _e849));
                                                if (_e853 < (1024f * _e159)) {
                                                    phi_4035_ = 0u;
                                                } else {
                                                    phi_4035_ = select(2u, 1u, (_e853 < (2097152f * _e159)));
                                                }
                                                let _e860 = phi_4035_;
                                                switch bitcast<i32>(_e860) {
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
                                                let _e863 = phi_4041_;
                                                let _e869 = global_5.member[_e624.member_1][0u];
                                                let _e873 = global_5.member[_e624.member_1][1u];
                                                let _e877 = global_5.member[_e624.member_1][2u];
                                                let _e881 = global_5.member[_e624.member_1][3u];
                                                let _e893 = (((_e873 >> bitcast<u32>(22i)) | ((_e877 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e881 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e894 = (_e869 & 268435455u);
                                                let _e895 = (_e893 & 268435455u);
                                                let _e898 = ((_e869 >> bitcast<u32>(28u)) & 7u);
                                                let _e906 = ((_e869 >> bitcast<u32>(31i)) | (((_e893 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e907 = (_e898 != 0u);
                                                if (_e898 == 0u) {
                                                    phi_4296_ = _e894;
                                                } else {
                                                    if (_e898 == 7u) {
                                                        phi_4295_ = 2147483648u;
                                                    } else {
                                                        phi_4295_ = ((2147483648u | (_e898 << bitcast<u32>(28u))) | (_e895 & 268435455u));
                                                    }
                                                    let _e916 = phi_4295_;
                                                    phi_4296_ = _e916;
                                                }
                                                let _e918 = phi_4296_;
                                                if _e907 {
                                                    let _e919 = (_e898 != 7u);
                                                    if _e919 {
                                                        phi_4306_ = (_e895 + (_e898 * ((3u * _e863) + 1u)));
                                                    } else {
                                                        phi_4306_ = u32();
                                                    }
                                                    let _e923 = phi_4306_;
                                                    phi_4308_ = _e923;
                                                    phi_4309_ = select(true, false, _e919);
                                                } else {
                                                    phi_4308_ = u32();
                                                    phi_4309_ = true;
                                                }
                                                let _e926 = phi_4308_;
                                                let _e928 = phi_4309_;
                                                if (_e906 == 0u) {
                                                    phi_4330_ = (_e894 + select(0u, 1u, !(_e907)));
                                                } else {
                                                    if (_e906 == 7u) {
                                                        phi_4329_ = 2147483648u;
                                                    } else {
                                                        phi_4329_ = ((2147483648u | (_e906 << bitcast<u32>(28u))) | (select(_e926, _e895, _e928) & 268435455u));
                                                    }
                                                    let _e941 = phi_4329_;
                                                    phi_4330_ = _e941;
                                                }
                                                let _e943 = phi_4330_;
                                                phi_4334_ = type_63(array<vec4<f32>, 3>(vec4<f32>(_e821, (_e624.member.member.x + _e773), _e826, (_e624.member.member_1.x - _e812)), vec4<f32>(_e822, (_e624.member.member.y + _e777), _e827, (_e624.member.member_1.y - _e816)), vec4<f32>(_e823, (_e624.member.member.z + _e781), _e828, (_e624.member.member_1.z - _e820))), type_60(type_34((_e624.member.member + vec4<f32>(_e751, _e760, _e769, 0f)), (_e624.member.member_1 - vec4<f32>(_e790, _e799, _e808, 0f))), _e918), type_60(type_34((_e624.member.member + vec4<f32>(_e773, _e777, _e781, 0f)), (_e624.member.member_1 - vec4<f32>(_e812, _e816, _e820, 0f))), _e943));
                                            }
                                            let _e948 = phi_4334_;
                                            let _e960 = ((_e948.member[0].x - _e428) * _e433);
                                            let _e961 = ((_e948.member[0].y - _e428) * _e433);
                                            let _e962 = ((_e948.member[0].z - _e429) * _e433);
                                            let _e963 = ((_e948.member[0].w - _e429) * _e433);
                                            let _e973 = ((_e948.member[1].x - _e464) * _e469);
                                            let _e974 = ((_e948.member[1].y - _e464) * _e469);
                                            let _e975 = ((_e948.member[1].z - _e465) * _e469);
                                            let _e976 = ((_e948.member[1].w - _e465) * _e469);
                                            let _e986 = ((_e948.member[2].x - _e500) * _e505);
                                            let _e987 = ((_e948.member[2].y - _e500) * _e505);
                                            let _e988 = ((_e948.member[2].z - _e501) * _e505);
                                            let _e989 = ((_e948.member[2].w - _e501) * _e505);
                                            let _e991 = select(_e988, _e986, (_e986 < _e988));
                                            let _e993 = select(_e989, _e987, (_e987 < _e989));
                                            let _e995 = select(_e988, _e986, (_e986 > _e988));
                                            let _e997 = select(_e989, _e987, (_e987 > _e989));
                                            let _e999 = select(_e962, _e960, (_e960 < _e962));
                                            let _e1001 = select(_e963, _e961, (_e961 < _e963));
                                            let _e1003 = select(_e975, _e973, (_e973 < _e975));
                                            let _e1005 = select(_e976, _e974, (_e974 < _e976));
                                            let _e1007 = select(_e1003, _e999, (_e999 > _e1003));
                                            let _e1009 = select(_e1005, _e1001, (_e1001 > _e1005));
                                            let _e1011 = select(_e991, _e1007, (_e1007 > _e991));
                                            let _e1013 = select(_e993, _e1009, (_e1009 > _e993));
                                            let _e1015 = select(_e962, _e960, (_e960 > _e962));
                                            let _e1017 = select(_e963, _e961, (_e961 > _e963));
                                            let _e1019 = select(_e975, _e973, (_e973 > _e975));
                                            let _e1021 = select(_e976, _e974, (_e974 > _e976));
                                            let _e1023 = select(_e1019, _e1015, (_e1015 < _e1019));
                                            let _e1025 = select(_e1021, _e1017, (_e1017 < _e1021));
                                            let _e1030 = -(_e991);
                                            let _e1031 = -(_e993);
                                            let _e1038 = (select(_e995, _e1023, (_e1023 < _e995)) + (select(_e1030, _e995, (_e995 > _e1030)) * 0.0000019073523f));
                                            let _e1039 = (select(_e997, _e1025, (_e1025 < _e997)) + (select(_e1031, _e997, (_e997 > _e1031)) * 0.0000019073523f));
                                            let _e1041 = select(_e551, _e1011, (_e1011 > _e551));
                                            let _e1043 = select(_e551, _e1013, (_e1013 > _e551));
                                            let _e1048 = (_e1041 <= select(_e595.member, _e1038, (_e1038 < _e595.member)));
                                            let _e1049 = (_e1043 <= select(_e595.member, _e1039, (_e1039 < _e595.member)));
                                            let _e1050 = (_e1041 <= _e1043);
                                            if _e1048 {
                                                if _e1049 {
                                                    if _e1050 {
                                                        phi_4678_ = _e948.member_2;
                                                    } else {
                                                        phi_4678_ = _e948.member_1;
                                                    }
                                                    let _e1054 = phi_4678_;
                                                    let _e1055 = (_e628 % 128u);
                                                    let _e1056 = (_e1055 < 128u);
                                                    if _e1056 {
                                                    } else {
                                                        phi_5145_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1055] = type_60(type_34(_e1054.member.member, _e1054.member.member_1), _e1054.member_1);
                                                    if _e1056 {
                                                    } else {
                                                        phi_5145_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1055] = select(_e1043, _e1041, (_e1041 > _e1043));
                                                    if _e1050 {
                                                        phi_4711_ = _e948.member_1;
                                                    } else {
                                                        phi_4711_ = _e948.member_2;
                                                    }
                                                    let _e1071 = phi_4711_;
                                                    phi_4712_ = _e1071;
                                                    phi_4713_ = (_e628 + 1u);
                                                } else {
                                                    phi_4712_ = type_60();
                                                    phi_4713_ = u32();
                                                }
                                                let _e1073 = phi_4712_;
                                                let _e1075 = phi_4713_;
                                                phi_4715_ = _e1073;
                                                phi_4716_ = _e1075;
                                                phi_4717_ = select(true, false, _e1049);
                                            } else {
                                                phi_4715_ = type_60();
                                                phi_4716_ = u32();
                                                phi_4717_ = true;
                                            }
                                            let _e1078 = phi_4715_;
                                            let _e1080 = phi_4716_;
                                            let _e1082 = phi_4717_;
                                            if _e1082 {
                                                if _e1048 {
                                                    phi_4726_ = _e948.member_1;
                                                } else {
                                                    phi_4726_ = _e948.member_2;
                                                }
                                                let _e1086 = phi_4726_;
                                                phi_4731_ = _e1086;
                                                phi_4732_ = select(_e1049, true, _e1048);
                                            } else {
                                                phi_4731_ = _e1078;
                                                phi_4732_ = _e626;
                                            }
                                            let _e1089 = phi_4731_;
                                            let _e1091 = phi_4732_;
                                            phi_5149_ = _e593;
                                            phi_4734_ = _e595;
                                            phi_4735_ = _e1089;
                                            phi_4736_ = _e1091;
                                            phi_4737_ = select(_e1080, _e628, _e1082);
                                        }
                                        let _e1827 = phi_5149_;
                                        let _e1829 = phi_4734_;
                                        let _e1831 = phi_4735_;
                                        let _e1833 = phi_4736_;
                                        let _e1835 = phi_4737_;
                                        phi_5148_ = _e1827;
                                        phi_4738_ = _e1829;
                                        phi_4739_ = _e1831;
                                        phi_4740_ = (_e599 - 1u);
                                        phi_4741_ = _e1833;
                                        phi_4742_ = _e1835;
                                    } else {
                                        phi_5148_ = _e593;
                                        phi_4738_ = _e595;
                                        phi_4739_ = _e624;
                                        phi_4740_ = _e599;
                                        phi_4741_ = _e626;
                                        phi_4742_ = _e628;
                                    }
                                    let _e1837 = phi_5148_;
                                    let _e1839 = phi_4738_;
                                    let _e1841 = phi_4739_;
                                    let _e1843 = phi_4740_;
                                    let _e1845 = phi_4741_;
                                    let _e1847 = phi_4742_;
                                    phi_5147_ = _e1837;
                                    phi_4743_ = _e1839;
                                    phi_4744_ = _e1841;
                                    phi_4745_ = _e1843;
                                    phi_4746_ = _e1845;
                                    phi_4747_ = _e1847;
                                } else {
                                    phi_5147_ = _e593;
                                    phi_4743_ = type_45();
                                    phi_4744_ = type_60();
                                    phi_4745_ = u32();
                                    phi_4746_ = bool();
                                    phi_4747_ = u32();
                                }
                                let _e1849 = phi_5147_;
                                let _e1851 = phi_4743_;
                                let _e1853 = phi_4744_;
                                let _e1855 = phi_4745_;
                                let _e1857 = phi_4746_;
                                let _e1859 = phi_4747_;
                                phi_5146_ = _e1849;
                                phi_2051_ = _e1851;
                                phi_2054_ = _e1853;
                                phi_2056_ = _e1855;
                                phi_2058_ = _e1857;
                                phi_2060_ = _e1859;
                                phi_4748_ = _e607;
                            } else {
                                phi_5146_ = _e593;
                                phi_2051_ = type_45();
                                phi_2054_ = type_60();
                                phi_2056_ = u32();
                                phi_2058_ = bool();
                                phi_2060_ = u32();
                                phi_4748_ = false;
                            }
                            let _e1861 = phi_5146_;
                            let _e1863 = phi_2051_;
                            let _e1865 = phi_2054_;
                            let _e1867 = phi_2056_;
                            let _e1869 = phi_2058_;
                            let _e1871 = phi_2060_;
                            let _e1873 = phi_4748_;
                            continue;
                            continuing {
                                phi_5007_ = _e1861;
                                phi_2050_ = _e1863;
                                phi_2053_ = _e1865;
                                phi_2055_ = _e1867;
                                phi_2057_ = _e1869;
                                phi_2059_ = _e1871;
                                phi_5145_ = _e1861;
                                break if !(_e1873);
                            }
                        }
                        let _e1876 = phi_5145_;
                        if _e1876 {
                            break;
                        }
                        let _e1878 = local_8;
                        if _e1878.member_1 {
                        } else {
                            if _e241 {
                            } else {
                                break;
                            }
                            let _e1882 = global_2.member[_e147];
                            if _e162 {
                            } else {
                                break;
                            }
                            let _e1886 = global_9.member[_e147].member_1;
                            if _e241 {
                            } else {
                                break;
                            }
                            global_2.member[_e147] = type_27(_e1882.member, _e1882.member_1, _e1882.member_2, array<f32, 3>((_e1882.member_3[0] + (_e1886[0] * _e1882.member_1[0])), (_e1882.member_3[1] + (_e1886[1] * _e1882.member_1[1])), (_e1882.member_3[2] + (_e1886[2] * _e1882.member_1[2]))), _e1882.member_4);
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
