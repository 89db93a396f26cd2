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
    var phi_276_: u32;
    var phi_320_: i32;
    var phi_344_: type_36;
    var phi_494_: i32;
    var phi_495_: i32;
    var phi_505_: bool;
    var phi_515_: u32;
    var phi_516_: u32;
    var phi_518_: bool;
    var phi_523_: u32;
    var phi_555_: i32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_590_: f32;
    var phi_596_: f32;
    var phi_619_: f32;
    var phi_630_: f32;
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
    var phi_862_: f32;
    var phi_863_: f32;
    var phi_3593_: bool;
    var phi_936_: type_40;
    var phi_939_: type_62;
    var phi_941_: u32;
    var phi_943_: bool;
    var phi_945_: u32;
    var phi_956_: bool;
    var phi_1042_: type_62;
    var phi_1043_: bool;
    var phi_1044_: u32;
    var phi_2551_: type_49;
    var phi_3383_: type_62;
    var phi_3460_: type_62;
    var phi_3461_: type_62;
    var phi_3462_: u32;
    var phi_3464_: type_62;
    var phi_3465_: u32;
    var phi_3466_: bool;
    var phi_3473_: type_62;
    var phi_3478_: type_62;
    var phi_3479_: bool;
    var phi_1063_: type_40;
    var phi_1066_: type_8;
    var phi_1067_: type_8;
    var phi_1089_: type_8;
    var phi_1114_: u32;
    var phi_1130_: type_56;
    var phi_1506_: bool;
    var phi_1535_: bool;
    var phi_1912_: f32;
    var phi_1913_: f32;
    var phi_1914_: f32;
    var phi_1915_: f32;
    var phi_1916_: vec3<f32>;
    var phi_1917_: vec3<f32>;
    var phi_1918_: vec3<f32>;
    var phi_1919_: vec3<f32>;
    var phi_1950_: bool;
    var phi_1959_: vec3<f32>;
    var phi_2126_: bool;
    var phi_2150_: f32;
    var phi_2151_: f32;
    var phi_2174_: type_22;
    var phi_2176_: type_22;
    var phi_2177_: bool;
    var phi_2181_: type_22;
    var phi_2182_: type_22;
    var phi_2183_: type_22;
    var phi_2184_: bool;
    var phi_2188_: type_22;
    var phi_2189_: bool;
    var phi_2190_: type_22;
    var phi_2191_: bool;
    var phi_2192_: bool;
    var phi_2193_: type_22;
    var phi_2194_: bool;
    var phi_2195_: bool;
    var phi_2203_: type_22;
    var phi_2204_: bool;
    var phi_2208_: type_22;
    var phi_2231_: u32;
    var phi_2245_: i32;
    var phi_2261_: vec3<f32>;
    var phi_2262_: vec3<f32>;
    var phi_2274_: vec3<f32>;
    var phi_2275_: vec3<f32>;
    var phi_2287_: vec3<f32>;
    var phi_2288_: vec3<f32>;
    var phi_2324_: vec3<f32>;
    var phi_2506_: f32;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2530_: type_40;
    var phi_2531_: type_40;
    var phi_1064_: type_40;
    var phi_3587_: bool;
    var local_10: type_40;
    var phi_3775_: bool;
    var phi_3481_: type_40;
    var phi_3482_: type_62;
    var phi_3483_: bool;
    var phi_3484_: u32;
    var phi_3774_: bool;
    var phi_3485_: type_40;
    var phi_3486_: type_62;
    var phi_3487_: u32;
    var phi_3488_: bool;
    var phi_3489_: u32;
    var phi_3773_: bool;
    var phi_3490_: type_40;
    var phi_3491_: type_62;
    var phi_3492_: u32;
    var phi_3493_: bool;
    var phi_3494_: u32;
    var phi_3772_: bool;
    var phi_937_: type_40;
    var phi_940_: type_62;
    var phi_942_: u32;
    var phi_944_: bool;
    var phi_946_: u32;
    var phi_3495_: bool;
    var phi_3771_: bool;
    var local_11: type_40;
    var local_12: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e88 = arrayLength((&global_9.member));
            let _e103 = arrayLength((&global_7.member));
            let _e107 = global_4.member[0u][0u];
            let _e111 = global_4.member[0u][1u];
            let _e115 = global_4.member[0u][2u];
            let _e119 = global_4.member[1u][0u];
            let _e123 = global_4.member[1u][1u];
            let _e127 = global_4.member[1u][2u];
            let _e131 = global_4.member[1u][3u];
            let _e135 = (_e85.x + (_e85.y * 2097152u));
            let _e142 = (_e135 < arrayLength((&global_8.member)));
            if _e142 {
                if _e142 {
                } else {
                    break;
                }
                let _e146 = global_8.member[_e135].member_2;
                phi_276_ = _e146;
            } else {
                phi_276_ = 4294967295u;
            }
            let _e148 = phi_276_;
            let _e151 = global_1.member[0u];
            let _e155 = global_3.member[0u][0u];
            let _e159 = global_3.member[0u][1u];
            let _e163 = global_3.member[0u][2u];
            let _e167 = global_3.member[0u][3u];
            let _e171 = global_3.member[1u][0u];
            let _e175 = global_3.member[1u][1u];
            let _e179 = global_3.member[1u][2u];
            let _e183 = global_3.member[1u][3u];
            let _e184 = bitcast<f32>(_e155);
            let _e185 = bitcast<f32>(_e159);
            let _e186 = bitcast<f32>(_e163);
            let _e188 = bitcast<f32>(_e171);
            let _e189 = array<u32, 3>(_e175, _e179, _e183);
            let _e191 = bitcast<i32>(_e151);
            if (_e191 < -126i) {
                phi_320_ = -126i;
            } else {
                phi_320_ = select(_e191, 127i, (_e191 > 127i));
            }
            let _e196 = phi_320_;
            let _e201 = bitcast<f32>((bitcast<u32>((_e196 + 127i)) << bitcast<u32>(23i)));
            let _e207 = bitcast<f32>((bitcast<u32>(((_e191 - _e196) + 127i)) << bitcast<u32>(23i)));
            if (_e167 == 0u) {
                phi_344_ = type_36(array<f32, 3>(_e184, _e185, _e186), _e167, _e188, _e189);
            } else {
                phi_344_ = type_36(array<f32, 3>(((_e184 * _e201) * _e207), ((_e185 * _e201) * _e207), ((_e186 * _e201) * _e207)), _e167, ((_e188 * _e201) * _e207), _e189);
            }
            let _e220 = phi_344_;
            if _e142 {
                let _e221 = (_e135 < arrayLength((&global_2.member)));
                if _e221 {
                    if _e142 {
                    } else {
                        break;
                    }
                    let _e226 = global_8.member[_e135].member.member_1;
                    let _e231 = global_8.member[_e135].member.member_3;
                    if (_e226 <= _e231) {
                        let _e233 = (1u < _e103);
                        if _e233 {
                            if (0u < _e103) {
                            } else {
                                break;
                            }
                            let _e237 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e237 + 1u) < _e237) {
                                if _e233 {
                                } else {
                                    break;
                                }
                                let _e242 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e142 {
                        } else {
                            break;
                        }
                        let _e252 = global_8.member[_e135].member.member_2[0u];
                        let _e254 = (bitcast<u32>(_e252) & 2147483647u);
                        let _e260 = global_8.member[_e135].member.member_2[1u];
                        let _e262 = (bitcast<u32>(_e260) & 2147483647u);
                        let _e268 = global_8.member[_e135].member.member_2[2u];
                        let _e270 = (bitcast<u32>(_e268) & 2147483647u);
                        let _e276 = global_8.member[_e135].member.member[0u];
                        let _e278 = (bitcast<u32>(_e276) & 2147483647u);
                        let _e284 = global_8.member[_e135].member.member[1u];
                        let _e286 = (bitcast<u32>(_e284) & 2147483647u);
                        let _e292 = global_8.member[_e135].member.member[2u];
                        let _e294 = (bitcast<u32>(_e292) & 2147483647u);
                        let _e296 = select(_e262, _e254, (_e262 < _e254));
                        let _e298 = select(_e270, _e296, (_e270 < _e296));
                        let _e300 = select(_e278, _e298, (_e278 < _e298));
                        let _e302 = select(_e286, _e300, (_e286 < _e300));
                        let _e304 = select(_e294, _e302, (_e294 < _e302));
                        let _e306 = (bitcast<u32>(_e226) & 2147483647u);
                        let _e315 = (((select(_e306, _e304, (_e306 < _e304)) < 2139095040u) && ((bitcast<u32>(_e231) & 2147483647u) <= 2139095040u)) && (_e298 > 0u));
                        if _e315 {
                            let _e318 = (bitcast<u32>(bitcast<f32>(_e298)) & 2147483647u);
                            if (_e318 >= 8388608u) {
                                phi_494_ = (bitcast<i32>((_e318 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_494_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e318)), 32u, (_e318 == 0u))));
                            }
                            let _e332 = phi_494_;
                            phi_495_ = _e332;
                        } else {
                            phi_495_ = 0i;
                        }
                        let _e334 = phi_495_;
                        let _e335 = (_e254 == _e298);
                        if _e335 {
                            phi_505_ = true;
                        } else {
                            phi_505_ = (_e262 == _e298);
                        }
                        let _e338 = phi_505_;
                        let _e339 = select(1u, 0u, _e335);
                        if _e338 {
                            let _e340 = (_e339 + 1u);
                            phi_515_ = _e340;
                            phi_516_ = _e340;
                            phi_518_ = select(true, false, (_e340 == 2u));
                        } else {
                            phi_515_ = u32();
                            phi_516_ = 0u;
                            phi_518_ = true;
                        }
                        let _e344 = phi_515_;
                        let _e346 = phi_516_;
                        let _e348 = phi_518_;
                        if _e348 {
                            phi_523_ = (_e346 + 1u);
                        } else {
                            phi_523_ = 0u;
                        }
                        let _e352 = phi_523_;
                        let _e353 = select(_e344, _e346, _e348);
                        let _e354 = select(_e339, select(2u, _e339, _e338), _e348);
                        let _e355 = -(_e334);
                        if (_e355 < -126i) {
                            phi_555_ = -126i;
                        } else {
                            phi_555_ = select(_e355, 127i, (_e355 > 127i));
                        }
                        let _e360 = phi_555_;
                        let _e365 = bitcast<f32>((bitcast<u32>((_e360 + 127i)) << bitcast<u32>(23i)));
                        let _e371 = bitcast<f32>((bitcast<u32>(((_e355 - _e360) + 127i)) << bitcast<u32>(23i)));
                        let _e376 = global_8.member[_e135].member.member;
                        let _e377 = (_e353 == 0u);
                        if _e377 {
                            phi_573_ = _e376[0];
                        } else {
                            phi_573_ = _e376[1];
                        }
                        let _e381 = phi_573_;
                        let _e382 = (_e353 == 2u);
                        if _e382 {
                            phi_579_ = _e376[2];
                        } else {
                            phi_579_ = _e381;
                        }
                        let _e385 = phi_579_;
                        let _e386 = global_8.member[_e135].member.member_2;
                        if _e377 {
                            phi_590_ = _e386[0];
                        } else {
                            phi_590_ = _e386[1];
                        }
                        let _e390 = phi_590_;
                        if _e382 {
                            phi_596_ = _e386[2];
                        } else {
                            phi_596_ = _e390;
                        }
                        let _e393 = phi_596_;
                        let _e395 = ((_e393 * _e365) * _e371);
                        let _e399 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e399 {
                            let _e403 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                            phi_619_ = select(0.00000000000011368684f, _e403, (_e403 > 0.00000000000011368684f));
                        } else {
                            phi_619_ = 0f;
                        }
                        let _e407 = phi_619_;
                        let _e408 = (_e385 + _e407);
                        let _e409 = (_e385 - _e407);
                        let _e410 = select(_e395, 0f, _e399);
                        if _e399 {
                            phi_630_ = 38685626000000000000000000f;
                        } else {
                            phi_630_ = (1f / _e395);
                        }
                        let _e413 = phi_630_;
                        let _e414 = (_e352 == 0u);
                        if _e414 {
                            phi_639_ = _e376[0];
                        } else {
                            phi_639_ = _e376[1];
                        }
                        let _e418 = phi_639_;
                        let _e419 = (_e352 == 2u);
                        if _e419 {
                            phi_645_ = _e376[2];
                        } else {
                            phi_645_ = _e418;
                        }
                        let _e422 = phi_645_;
                        if _e414 {
                            phi_656_ = _e386[0];
                        } else {
                            phi_656_ = _e386[1];
                        }
                        let _e426 = phi_656_;
                        if _e419 {
                            phi_662_ = _e386[2];
                        } else {
                            phi_662_ = _e426;
                        }
                        let _e429 = phi_662_;
                        let _e431 = ((_e429 * _e365) * _e371);
                        let _e435 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e435 {
                            let _e439 = (bitcast<f32>((bitcast<u32>(_e422) & 2147483647u)) * 0.00000011920929f);
                            phi_685_ = select(0.00000000000011368684f, _e439, (_e439 > 0.00000000000011368684f));
                        } else {
                            phi_685_ = 0f;
                        }
                        let _e443 = phi_685_;
                        let _e444 = (_e422 + _e443);
                        let _e445 = (_e422 - _e443);
                        let _e446 = select(_e431, 0f, _e435);
                        if _e435 {
                            phi_696_ = 38685626000000000000000000f;
                        } else {
                            phi_696_ = (1f / _e431);
                        }
                        let _e449 = phi_696_;
                        let _e450 = (_e354 == 0u);
                        if _e450 {
                            phi_705_ = _e376[0];
                        } else {
                            phi_705_ = _e376[1];
                        }
                        let _e454 = phi_705_;
                        let _e455 = (_e354 == 2u);
                        if _e455 {
                            phi_711_ = _e376[2];
                        } else {
                            phi_711_ = _e454;
                        }
                        let _e458 = phi_711_;
                        if _e450 {
                            phi_722_ = _e386[0];
                        } else {
                            phi_722_ = _e386[1];
                        }
                        let _e462 = phi_722_;
                        if _e455 {
                            phi_728_ = _e386[2];
                        } else {
                            phi_728_ = _e462;
                        }
                        let _e465 = phi_728_;
                        let _e467 = ((_e465 * _e365) * _e371);
                        let _e471 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e471 {
                            let _e475 = (bitcast<f32>((bitcast<u32>(_e458) & 2147483647u)) * 0.00000011920929f);
                            phi_751_ = select(0.00000000000011368684f, _e475, (_e475 > 0.00000000000011368684f));
                        } else {
                            phi_751_ = 0f;
                        }
                        let _e479 = phi_751_;
                        let _e480 = (_e458 + _e479);
                        let _e481 = (_e458 - _e479);
                        let _e482 = select(_e467, 0f, _e471);
                        if _e471 {
                            phi_762_ = 38685626000000000000000000f;
                        } else {
                            phi_762_ = (1f / _e467);
                        }
                        let _e485 = phi_762_;
                        let _e488 = bitcast<f32>((bitcast<u32>(_e385) & 2147483647u));
                        let _e491 = bitcast<f32>((bitcast<u32>(_e422) & 2147483647u));
                        let _e493 = select(_e491, _e488, (_e488 > _e491));
                        let _e496 = bitcast<f32>((bitcast<u32>(_e458) & 2147483647u));
                        if (_e315 && (select(_e496, _e493, (_e493 > _e496)) <= 1099511600000f)) {
                            let _e501 = (_e334 / 3i);
                            let _e508 = bitcast<f32>((bitcast<u32>((_e501 + 127i)) << bitcast<u32>(23i)));
                            let _e515 = bitcast<f32>((bitcast<u32>(((_e334 - (2i * _e501)) + 127i)) << bitcast<u32>(23i)));
                            let _e516 = (((_e226 * _e508) * _e508) * _e515);
                            let _e518 = select(340282350000000000000000000000000000000f, _e516, (_e516 < 340282350000000000000000000000000000000f));
                            let _e523 = (((_e231 * _e508) * _e508) * _e515);
                            let _e525 = select(340282350000000000000000000000000000000f, _e523, (_e523 < 340282350000000000000000000000000000000f));
                            phi_862_ = select(-340282350000000000000000000000000000000f, _e525, (_e525 > -340282350000000000000000000000000000000f));
                            phi_863_ = select(-340282350000000000000000000000000000000f, _e518, (_e518 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_862_ = 0f;
                            phi_863_ = 1f;
                        }
                        let _e529 = phi_862_;
                        let _e531 = phi_863_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e107), bitcast<f32>(_e111), bitcast<f32>(_e115));
                        let _e536 = (_e353 % 3u);
                        let _e537 = (_e536 < 3u);
                        if _e537 {
                        } else {
                            break;
                        }
                        let _e539 = local_9[_e536];
                        let _e540 = (_e352 % 3u);
                        let _e541 = (_e540 < 3u);
                        if _e541 {
                        } else {
                            break;
                        }
                        let _e543 = local_9[_e540];
                        let _e544 = (_e354 % 3u);
                        let _e545 = (_e544 < 3u);
                        if _e545 {
                        } else {
                            break;
                        }
                        let _e547 = local_9[_e544];
                        local_8 = array<f32, 3>(bitcast<f32>(_e119), bitcast<f32>(_e123), bitcast<f32>(_e127));
                        if _e537 {
                        } else {
                            break;
                        }
                        let _e551 = local_8[_e536];
                        if _e541 {
                        } else {
                            break;
                        }
                        let _e553 = local_8[_e540];
                        if _e545 {
                        } else {
                            break;
                        }
                        let _e555 = local_8[_e544];
                        phi_3593_ = false;
                        phi_936_ = type_40(_e529, false);
                        phi_939_ = type_62(type_54(array<f32, 3>(_e539, _e543, _e547), array<f32, 3>(_e551, _e553, _e555)), select(0u, 2147483648u, (_e88 == 0u)));
                        phi_941_ = ((3u * _e88) + 1u);
                        phi_943_ = (_e531 <= _e529);
                        phi_945_ = 0u;
                        loop {
                            let _e563 = phi_3593_;
                            let _e565 = phi_936_;
                            let _e567 = phi_939_;
                            let _e569 = phi_941_;
                            let _e571 = phi_943_;
                            let _e573 = phi_945_;
                            local_11 = _e565;
                            if _e571 {
                                phi_956_ = true;
                            } else {
                                phi_956_ = (_e573 > 0u);
                            }
                            let _e576 = phi_956_;
                            if _e576 {
                                let _e577 = (_e569 > 0u);
                                if _e577 {
                                    if _e571 {
                                        phi_1042_ = _e567;
                                        phi_1043_ = _e571;
                                        phi_1044_ = _e573;
                                    } else {
                                        let _e578 = (_e573 - 1u);
                                        let _e579 = (_e578 % 128u);
                                        let _e580 = (_e579 < 128u);
                                        if _e580 {
                                        } else {
                                            phi_3771_ = true;
                                            break;
                                        }
                                        let _e582 = local_6[_e579];
                                        if _e580 {
                                        } else {
                                            phi_3771_ = true;
                                            break;
                                        }
                                        let _e584 = local_5[_e579];
                                        if _e580 {
                                        } else {
                                            phi_3771_ = true;
                                            break;
                                        }
                                        let _e586 = local_4[_e579];
                                        if _e580 {
                                        } else {
                                            phi_3771_ = true;
                                            break;
                                        }
                                        let _e588 = local_3[_e579];
                                        if _e580 {
                                        } else {
                                            phi_3771_ = true;
                                            break;
                                        }
                                        let _e591 = local_2[_e579];
                                        if _e580 {
                                        } else {
                                            phi_3771_ = true;
                                            break;
                                        }
                                        let _e593 = local_1[_e579];
                                        if _e580 {
                                        } else {
                                            phi_3771_ = true;
                                            break;
                                        }
                                        let _e595 = local[_e579];
                                        if _e580 {
                                        } else {
                                            phi_3771_ = true;
                                            break;
                                        }
                                        let _e600 = local_7[_e579];
                                        phi_1042_ = type_62(type_54(array<f32, 3>(_e584, _e586, _e588), array<f32, 3>(_e591, _e593, _e595)), _e582);
                                        phi_1043_ = (_e600 <= _e565.member);
                                        phi_1044_ = _e578;
                                    }
                                    let _e604 = phi_1042_;
                                    let _e606 = phi_1043_;
                                    let _e608 = phi_1044_;
                                    if _e606 {
                                        if ((_e604.member_1 & 2147483648u) != 0u) {
                                            phi_1063_ = _e565;
                                            phi_1066_ = type_8(0u, ((_e604.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e961 = phi_1063_;
                                                let _e963 = phi_1066_;
                                                local_10 = _e961;
                                                local_12 = _e961;
                                                if (_e963.member < _e963.member_1) {
                                                    phi_1067_ = type_8((_e963.member + 1u), _e963.member_1);
                                                    phi_1089_ = type_8(1u, _e963.member);
                                                } else {
                                                    phi_1067_ = _e963;
                                                    phi_1089_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e976 = phi_1067_;
                                                let _e978 = phi_1089_;
                                                let _e982 = (bitcast<i32>(_e978.member) != 0i);
                                                if _e982 {
                                                    let _e983 = ((_e604.member_1 & 268435455u) + _e978.member_1);
                                                    let _e984 = (_e983 < arrayLength((&global_10.member)));
                                                    if _e984 {
                                                        if _e984 {
                                                        } else {
                                                            phi_3587_ = true;
                                                            break;
                                                        }
                                                        let _e987 = global_10.member[_e983].member_1;
                                                        phi_1114_ = _e987;
                                                    } else {
                                                        phi_1114_ = 4294967295u;
                                                    }
                                                    let _e989 = phi_1114_;
                                                    if _e984 {
                                                        if _e984 {
                                                        } else {
                                                            phi_3587_ = true;
                                                            break;
                                                        }
                                                        let _e991 = global_10.member[_e983];
                                                        phi_1130_ = _e991;
                                                    } else {
                                                        phi_1130_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e993 = phi_1130_;
                                                    let _e1005 = ((10u * _e353) & 31u);
                                                    let _e1008 = ((_e993.member[0] >> bitcast<u32>(_e1005)) & 1023u);
                                                    let _e1013 = bitcast<f32>((bitcast<u32>(((_e604.member.member_1[0] - _e604.member.member[0]) * 0.0009775171f)) ^ _e131));
                                                    let _e1019 = (_e604.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1008) * _e1013)) ^ _e131)));
                                                    let _e1023 = select(select(_e604.member.member_1[0], _e1019, (_e1019 < _e604.member.member_1[0])), _e604.member.member_1[0], (_e1008 == 1023u));
                                                    let _e1025 = ((10u * _e352) & 31u);
                                                    let _e1028 = ((_e993.member[0] >> bitcast<u32>(_e1025)) & 1023u);
                                                    let _e1033 = bitcast<f32>((bitcast<u32>(((_e604.member.member_1[1] - _e604.member.member[1]) * 0.0009775171f)) ^ _e131));
                                                    let _e1039 = (_e604.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1028) * _e1033)) ^ _e131)));
                                                    let _e1043 = select(select(_e604.member.member_1[1], _e1039, (_e1039 < _e604.member.member_1[1])), _e604.member.member_1[1], (_e1028 == 1023u));
                                                    let _e1045 = ((10u * _e354) & 31u);
                                                    let _e1048 = ((_e993.member[0] >> bitcast<u32>(_e1045)) & 1023u);
                                                    let _e1053 = bitcast<f32>((bitcast<u32>(((_e604.member.member_1[2] - _e604.member.member[2]) * 0.0009775171f)) ^ _e131));
                                                    let _e1059 = (_e604.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1048) * _e1053)) ^ _e131)));
                                                    let _e1063 = select(select(_e604.member.member_1[2], _e1059, (_e1059 < _e604.member.member_1[2])), _e604.member.member_1[2], (_e1048 == 1023u));
                                                    let _e1067 = ((_e993.member[1] >> bitcast<u32>(_e1005)) & 1023u);
                                                    let _e1073 = (_e604.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1067) * _e1013)) ^ _e131)));
                                                    let _e1077 = select(select(_e604.member.member_1[0], _e1073, (_e1073 < _e604.member.member_1[0])), _e604.member.member_1[0], (_e1067 == 1023u));
                                                    let _e1080 = ((_e993.member[1] >> bitcast<u32>(_e1025)) & 1023u);
                                                    let _e1086 = (_e604.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1080) * _e1033)) ^ _e131)));
                                                    let _e1090 = select(select(_e604.member.member_1[1], _e1086, (_e1086 < _e604.member.member_1[1])), _e604.member.member_1[1], (_e1080 == 1023u));
                                                    let _e1093 = ((_e993.member[1] >> bitcast<u32>(_e1045)) & 1023u);
                                                    let _e1099 = (_e604.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1093) * _e1053)) ^ _e131)));
                                                    let _e1103 = select(select(_e604.member.member_1[2], _e1099, (_e1099 < _e604.member.member_1[2])), _e604.member.member_1[2], (_e1093 == 1023u));
                                                    let _e1107 = ((_e993.member[2] >> bitcast<u32>(_e1005)) & 1023u);
                                                    let _e1113 = (_e604.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1107) * _e1013)) ^ _e131)));
                                                    let _e1117 = select(select(_e604.member.member_1[0], _e1113, (_e1113 < _e604.member.member_1[0])), _e604.member.member_1[0], (_e1107 == 1023u));
                                                    let _e1120 = ((_e993.member[2] >> bitcast<u32>(_e1025)) & 1023u);
                                                    let _e1126 = (_e604.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1120) * _e1033)) ^ _e131)));
                                                    let _e1130 = select(select(_e604.member.member_1[1], _e1126, (_e1126 < _e604.member.member_1[1])), _e604.member.member_1[1], (_e1120 == 1023u));
                                                    let _e1133 = ((_e993.member[2] >> bitcast<u32>(_e1045)) & 1023u);
                                                    let _e1139 = (_e604.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1133) * _e1053)) ^ _e131)));
                                                    let _e1143 = select(select(_e604.member.member_1[2], _e1139, (_e1139 < _e604.member.member_1[2])), _e604.member.member_1[2], (_e1133 == 1023u));
                                                    let _e1147 = (_e1063 - _e458);
                                                    let _e1150 = (((_e1023 - _e385) * _e482) - (_e1147 * _e410));
                                                    let _e1153 = (((_e1043 - _e422) * _e482) - (_e1147 * _e446));
                                                    let _e1156 = (_e1103 - _e458);
                                                    let _e1159 = (((_e1077 - _e385) * _e482) - (_e1156 * _e410));
                                                    let _e1162 = (((_e1090 - _e422) * _e482) - (_e1156 * _e446));
                                                    let _e1165 = (_e1143 - _e458);
                                                    let _e1168 = (((_e1117 - _e385) * _e482) - (_e1165 * _e410));
                                                    let _e1171 = (((_e1130 - _e422) * _e482) - (_e1165 * _e446));
                                                    let _e1172 = (_e1168 * _e1162);
                                                    let _e1173 = (_e1171 * _e1159);
                                                    let _e1174 = (_e1150 * _e1171);
                                                    let _e1175 = (_e1153 * _e1168);
                                                    let _e1176 = (_e1159 * _e1153);
                                                    let _e1177 = (_e1162 * _e1150);
                                                    let _e1182 = (((_e1172 >= _e1173) && (_e1174 >= _e1175)) && (_e1176 >= _e1177));
                                                    if (_e1182 || (((_e1172 <= _e1173) && (_e1174 <= _e1175)) && (_e1176 <= _e1177))) {
                                                        let _e1189 = select(-1f, 1f, _e1182);
                                                        let _e1191 = ((_e1172 - _e1173) * _e1189);
                                                        let _e1193 = select(0f, _e1191, (_e1191 > 0f));
                                                        let _e1195 = ((_e1174 - _e1175) * _e1189);
                                                        let _e1197 = select(0f, _e1195, (_e1195 > 0f));
                                                        let _e1199 = ((_e1176 - _e1177) * _e1189);
                                                        let _e1201 = select(0f, _e1199, (_e1199 > 0f));
                                                        let _e1203 = ((_e1193 + _e1197) + _e1201);
                                                        if (_e1203 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2193_ = type_22();
                                                            phi_2194_ = true;
                                                            phi_2195_ = false;
                                                        } else {
                                                            let _e1206 = select(_e1159, _e1150, (_e1150 < _e1159));
                                                            if (select(_e1168, _e1206, (_e1206 < _e1168)) > 0f) {
                                                                phi_1506_ = true;
                                                            } else {
                                                                let _e1211 = select(_e1159, _e1150, (_e1150 > _e1159));
                                                                phi_1506_ = (select(_e1168, _e1211, (_e1211 > _e1168)) < 0f);
                                                            }
                                                            let _e1216 = phi_1506_;
                                                            if _e1216 {
                                                                phi_2190_ = type_22();
                                                                phi_2191_ = true;
                                                                phi_2192_ = false;
                                                            } else {
                                                                let _e1218 = select(_e1162, _e1153, (_e1153 < _e1162));
                                                                if (select(_e1171, _e1218, (_e1218 < _e1171)) > 0f) {
                                                                    phi_1535_ = true;
                                                                } else {
                                                                    let _e1223 = select(_e1162, _e1153, (_e1153 > _e1162));
                                                                    phi_1535_ = (select(_e1171, _e1223, (_e1223 > _e1171)) < 0f);
                                                                }
                                                                let _e1228 = phi_1535_;
                                                                if _e1228 {
                                                                    phi_2188_ = type_22();
                                                                    phi_2189_ = false;
                                                                } else {
                                                                    let _e1230 = select(_e1077, _e1023, (_e1023 < _e1077));
                                                                    let _e1234 = select(_e1077, _e1023, (_e1023 > _e1077));
                                                                    let _e1238 = select(_e1090, _e1043, (_e1043 < _e1090));
                                                                    let _e1242 = select(_e1090, _e1043, (_e1043 > _e1090));
                                                                    let _e1246 = select(_e1103, _e1063, (_e1063 < _e1103));
                                                                    let _e1250 = select(_e1103, _e1063, (_e1063 > _e1103));
                                                                    let _e1255 = ((select(_e1117, _e1230, (_e1230 < _e1117)) - _e408) * _e413);
                                                                    let _e1256 = ((select(_e1117, _e1234, (_e1234 > _e1117)) - _e409) * _e413);
                                                                    let _e1259 = ((select(_e1130, _e1238, (_e1238 < _e1130)) - _e444) * _e449);
                                                                    let _e1260 = ((select(_e1130, _e1242, (_e1242 > _e1130)) - _e445) * _e449);
                                                                    let _e1263 = ((select(_e1143, _e1246, (_e1246 < _e1143)) - _e480) * _e485);
                                                                    let _e1264 = ((select(_e1143, _e1250, (_e1250 > _e1143)) - _e481) * _e485);
                                                                    let _e1266 = select(_e1264, _e1263, (_e1263 < _e1264));
                                                                    let _e1268 = select(_e1264, _e1263, (_e1263 > _e1264));
                                                                    let _e1270 = select(_e1256, _e1255, (_e1255 < _e1256));
                                                                    let _e1272 = select(_e1260, _e1259, (_e1259 < _e1260));
                                                                    let _e1274 = select(_e1272, _e1270, (_e1270 > _e1272));
                                                                    let _e1276 = select(_e1266, _e1274, (_e1274 > _e1266));
                                                                    let _e1278 = select(_e1256, _e1255, (_e1255 > _e1256));
                                                                    let _e1280 = select(_e1260, _e1259, (_e1259 > _e1260));
                                                                    let _e1282 = select(_e1280, _e1278, (_e1278 < _e1280));
                                                                    let _e1284 = select(_e1268, _e1282, (_e1282 < _e1268));
                                                                    let _e1285 = -(_e1266);
                                                                    let _e1291 = select(_e531, _e1276, (_e1276 > _e531));
                                                                    if (_e1291 > (_e1284 + (select(_e1285, _e1268, (_e1268 > _e1285)) * 0.0000019073523f))) {
                                                                        phi_2183_ = type_22();
                                                                        phi_2184_ = true;
                                                                    } else {
                                                                        let _e1293 = (_e1291 > _e961.member);
                                                                        if _e1293 {
                                                                            phi_2182_ = type_22();
                                                                        } else {
                                                                            let _e1294 = vec3<f32>(_e1023, _e1043, _e1063);
                                                                            let _e1295 = vec3<f32>(_e1077, _e1090, _e1103);
                                                                            let _e1296 = vec3<f32>(_e1117, _e1130, _e1143);
                                                                            let _e1297 = (_e1077 - _e1023);
                                                                            let _e1298 = (_e1090 - _e1043);
                                                                            let _e1299 = (_e1103 - _e1063);
                                                                            let _e1300 = vec3<f32>(_e1297, _e1298, _e1299);
                                                                            let _e1301 = (_e1117 - _e1077);
                                                                            let _e1302 = (_e1130 - _e1090);
                                                                            let _e1303 = (_e1143 - _e1103);
                                                                            let _e1304 = vec3<f32>(_e1301, _e1302, _e1303);
                                                                            let _e1305 = (_e1023 - _e1117);
                                                                            let _e1306 = (_e1043 - _e1130);
                                                                            let _e1307 = (_e1063 - _e1143);
                                                                            let _e1308 = vec3<f32>(_e1305, _e1306, _e1307);
                                                                            let _e1311 = bitcast<f32>((bitcast<u32>(_e1297) & 2147483647u));
                                                                            let _e1314 = bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u));
                                                                            let _e1316 = select(_e1314, _e1311, (_e1311 > _e1314));
                                                                            let _e1319 = bitcast<f32>((bitcast<u32>(_e1299) & 2147483647u));
                                                                            let _e1321 = select(_e1319, _e1316, (_e1316 > _e1319));
                                                                            let _e1324 = bitcast<f32>((bitcast<u32>(_e1301) & 2147483647u));
                                                                            let _e1327 = bitcast<f32>((bitcast<u32>(_e1302) & 2147483647u));
                                                                            let _e1329 = select(_e1327, _e1324, (_e1324 > _e1327));
                                                                            let _e1332 = bitcast<f32>((bitcast<u32>(_e1303) & 2147483647u));
                                                                            let _e1334 = select(_e1332, _e1329, (_e1329 > _e1332));
                                                                            let _e1337 = bitcast<f32>((bitcast<u32>(_e1305) & 2147483647u));
                                                                            let _e1340 = bitcast<f32>((bitcast<u32>(_e1306) & 2147483647u));
                                                                            let _e1342 = select(_e1340, _e1337, (_e1337 > _e1340));
                                                                            let _e1345 = bitcast<f32>((bitcast<u32>(_e1307) & 2147483647u));
                                                                            let _e1347 = select(_e1345, _e1342, (_e1342 > _e1345));
                                                                            let _e1349 = select(_e1334, _e1321, (_e1321 > _e1334));
                                                                            let _e1351 = select(_e1347, _e1349, (_e1349 > _e1347));
                                                                            if (_e1321 == _e1351) {
                                                                                phi_1912_ = _e1162;
                                                                                phi_1913_ = _e1159;
                                                                                phi_1914_ = _e1153;
                                                                                phi_1915_ = _e1150;
                                                                                phi_1916_ = _e1294;
                                                                                phi_1917_ = _e1308;
                                                                                phi_1918_ = _e1304;
                                                                                phi_1919_ = _e1300;
                                                                            } else {
                                                                                let _e1353 = (_e1334 == _e1351);
                                                                                let _e1358 = vec3(_e1353);
                                                                                phi_1912_ = select(_e1153, _e1171, _e1353);
                                                                                phi_1913_ = select(_e1150, _e1168, _e1353);
                                                                                phi_1914_ = select(_e1171, _e1162, _e1353);
                                                                                phi_1915_ = select(_e1168, _e1159, _e1353);
                                                                                phi_1916_ = select(_e1296, _e1295, _e1358);
                                                                                phi_1917_ = select(_e1304, _e1300, _e1358);
                                                                                phi_1918_ = select(_e1300, _e1308, _e1358);
                                                                                phi_1919_ = select(_e1308, _e1304, _e1358);
                                                                            }
                                                                            let _e1364 = phi_1912_;
                                                                            let _e1366 = phi_1913_;
                                                                            let _e1368 = phi_1914_;
                                                                            let _e1370 = phi_1915_;
                                                                            let _e1372 = phi_1916_;
                                                                            let _e1374 = phi_1917_;
                                                                            let _e1376 = phi_1918_;
                                                                            let _e1378 = phi_1919_;
                                                                            let _e1385 = ((_e1376.y * _e1374.z) - (_e1374.y * _e1376.z));
                                                                            let _e1390 = ((_e1376.z * _e1374.x) - (_e1374.z * _e1376.x));
                                                                            let _e1393 = ((_e1376.x * _e1374.y) - (_e1374.x * _e1376.y));
                                                                            if (_e1193 >= _e1197) {
                                                                                phi_1950_ = select(true, false, (_e1193 >= _e1201));
                                                                            } else {
                                                                                phi_1950_ = true;
                                                                            }
                                                                            let _e1398 = phi_1950_;
                                                                            if _e1398 {
                                                                                phi_1959_ = select(_e1296, _e1295, vec3((_e1197 >= _e1201)));
                                                                            } else {
                                                                                phi_1959_ = _e1294;
                                                                            }
                                                                            let _e1403 = phi_1959_;
                                                                            let _e1408 = (((_e1385 * _e410) + (_e1390 * _e446)) + (_e1393 * _e482));
                                                                            let _e1419 = (((_e1385 * (_e1403.x - _e385)) + (_e1390 * (_e1403.y - _e422))) + (_e1393 * (_e1403.z - _e458)));
                                                                            let _e1421 = (_e1366 - _e1370);
                                                                            let _e1422 = (_e1364 - _e1368);
                                                                            let _e1430 = (-(((_e1370 * _e1421) + (_e1368 * _e1422))) / ((_e1421 * _e1421) + (_e1422 * _e1422)));
                                                                            let _e1432 = select(1f, _e1430, (_e1430 < 1f));
                                                                            let _e1434 = select(0f, _e1432, (_e1432 > 0f));
                                                                            let _e1447 = ((_e1372.x + (_e1378.x * _e1434)) - _e385);
                                                                            let _e1448 = ((_e1372.y + (_e1378.y * _e1434)) - _e422);
                                                                            let _e1449 = ((_e1372.z + (_e1378.z * _e1434)) - _e458);
                                                                            let _e1450 = (_e1449 / _e482);
                                                                            let _e1462 = bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u));
                                                                            let _e1465 = bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u));
                                                                            let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                            let _e1470 = bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u));
                                                                            let _e1472 = select(_e1470, _e1467, (_e1467 > _e1470));
                                                                            let _e1478 = bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u));
                                                                            let _e1481 = bitcast<f32>((bitcast<u32>(_e1390) & 2147483647u));
                                                                            let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                                            let _e1486 = bitcast<f32>((bitcast<u32>(_e1393) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1385 * _e1447) + (_e1390 * _e1448)) + (_e1393 * _e1449)) - _e1419)) & 2147483647u)) <= ((0.0000009536743f * select(_e1351, _e1472, (_e1472 > _e1351))) * select(_e1486, _e1483, (_e1483 > _e1486)))) {
                                                                                let _e1496 = bitcast<f32>((bitcast<u32>(_e1376.x) & 2147483647u));
                                                                                let _e1499 = bitcast<f32>((bitcast<u32>(_e1376.y) & 2147483647u));
                                                                                let _e1501 = select(_e1499, _e1496, (_e1496 > _e1499));
                                                                                let _e1504 = bitcast<f32>((bitcast<u32>(_e1376.z) & 2147483647u));
                                                                                let _e1510 = bitcast<f32>((bitcast<u32>(_e1374.x) & 2147483647u));
                                                                                let _e1513 = bitcast<f32>((bitcast<u32>(_e1374.y) & 2147483647u));
                                                                                let _e1515 = select(_e1513, _e1510, (_e1510 > _e1513));
                                                                                let _e1518 = bitcast<f32>((bitcast<u32>(_e1374.z) & 2147483647u));
                                                                                phi_2126_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u)) > ((0.0000038146973f * select(_e1504, _e1501, (_e1501 > _e1504))) * select(_e1518, _e1515, (_e1515 > _e1518)))));
                                                                            } else {
                                                                                phi_2126_ = true;
                                                                            }
                                                                            let _e1525 = phi_2126_;
                                                                            if _e1525 {
                                                                                let _e1536 = ((((_e1385 * (_e1447 - (_e410 * _e1450))) + (_e1390 * (_e1448 - (_e446 * _e1450)))) + (_e1393 * (_e1449 - _e1449))) / _e1408);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1536) & 2147483647u)) <= _e1351) {
                                                                                    phi_2150_ = (_e1450 + _e1536);
                                                                                } else {
                                                                                    phi_2150_ = _e1450;
                                                                                }
                                                                                let _e1543 = phi_2150_;
                                                                                phi_2151_ = _e1543;
                                                                            } else {
                                                                                phi_2151_ = (_e1419 / _e1408);
                                                                            }
                                                                            let _e1545 = phi_2151_;
                                                                            let _e1547 = select(_e1284, _e1545, (_e1545 < _e1284));
                                                                            let _e1549 = select(_e1276, _e1547, (_e1547 > _e1276));
                                                                            if (_e1549 >= _e531) {
                                                                                let _e1551 = (_e1549 <= _e961.member);
                                                                                if _e1551 {
                                                                                    let _e1552 = (1f / _e1203);
                                                                                    phi_2174_ = type_22(_e1549, (_e1197 * _e1552), (_e1201 * _e1552), _e989);
                                                                                } else {
                                                                                    phi_2174_ = type_22();
                                                                                }
                                                                                let _e1557 = phi_2174_;
                                                                                phi_2176_ = _e1557;
                                                                                phi_2177_ = select(true, false, _e1551);
                                                                            } else {
                                                                                phi_2176_ = type_22();
                                                                                phi_2177_ = true;
                                                                            }
                                                                            let _e1560 = phi_2176_;
                                                                            let _e1562 = phi_2177_;
                                                                            if _e1562 {
                                                                                phi_2181_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2181_ = _e1560;
                                                                            }
                                                                            let _e1564 = phi_2181_;
                                                                            phi_2182_ = _e1564;
                                                                        }
                                                                        let _e1566 = phi_2182_;
                                                                        phi_2183_ = _e1566;
                                                                        phi_2184_ = _e1293;
                                                                    }
                                                                    let _e1568 = phi_2183_;
                                                                    let _e1570 = phi_2184_;
                                                                    phi_2188_ = _e1568;
                                                                    phi_2189_ = _e1570;
                                                                }
                                                                let _e1572 = phi_2188_;
                                                                let _e1574 = phi_2189_;
                                                                phi_2190_ = _e1572;
                                                                phi_2191_ = _e1228;
                                                                phi_2192_ = _e1574;
                                                            }
                                                            let _e1576 = phi_2190_;
                                                            let _e1578 = phi_2191_;
                                                            let _e1580 = phi_2192_;
                                                            phi_2193_ = _e1576;
                                                            phi_2194_ = _e1578;
                                                            phi_2195_ = _e1580;
                                                        }
                                                        let _e1582 = phi_2193_;
                                                        let _e1584 = phi_2194_;
                                                        let _e1586 = phi_2195_;
                                                        phi_2203_ = _e1582;
                                                        phi_2204_ = select(_e1586, true, _e1584);
                                                    } else {
                                                        phi_2203_ = type_22();
                                                        phi_2204_ = true;
                                                    }
                                                    let _e1589 = phi_2203_;
                                                    let _e1591 = phi_2204_;
                                                    if _e1591 {
                                                        phi_2208_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2208_ = _e1589;
                                                    }
                                                    let _e1593 = phi_2208_;
                                                    if (_e1593.member_3 != 4294967295u) {
                                                        if (_e989 == _e148) {
                                                            phi_2525_ = false;
                                                        } else {
                                                            let _e1597 = (_e989 < arrayLength((&global_5.member)));
                                                            if _e1597 {
                                                                if _e1597 {
                                                                } else {
                                                                    phi_3587_ = true;
                                                                    break;
                                                                }
                                                                let _e1599 = global_5.member[_e989];
                                                                phi_2231_ = _e1599;
                                                            } else {
                                                                phi_2231_ = 4294967295u;
                                                            }
                                                            let _e1601 = phi_2231_;
                                                            let _e1602 = (_e1601 < arrayLength((&global_6.member)));
                                                            if _e1602 {
                                                                if _e1602 {
                                                                } else {
                                                                    phi_3587_ = true;
                                                                    break;
                                                                }
                                                                let _e1604 = global_6.member[_e1601];
                                                                phi_2245_ = _e1604;
                                                            } else {
                                                                phi_2245_ = 0i;
                                                            }
                                                            let _e1606 = phi_2245_;
                                                            let _e1607 = (_e1606 == 0i);
                                                            if _e1607 {
                                                                phi_2524_ = true;
                                                            } else {
                                                                if _e377 {
                                                                    phi_2262_ = vec3<f32>(_e1023, _e1043, _e1063);
                                                                } else {
                                                                    if (_e353 == 1u) {
                                                                        phi_2261_ = vec3<f32>(_e1063, _e1023, _e1043);
                                                                    } else {
                                                                        phi_2261_ = vec3<f32>(_e1043, _e1063, _e1023);
                                                                    }
                                                                    let _e1612 = phi_2261_;
                                                                    phi_2262_ = _e1612;
                                                                }
                                                                let _e1615 = phi_2262_;
                                                                if _e377 {
                                                                    phi_2275_ = vec3<f32>(_e1077, _e1090, _e1103);
                                                                } else {
                                                                    if (_e353 == 1u) {
                                                                        phi_2274_ = vec3<f32>(_e1103, _e1077, _e1090);
                                                                    } else {
                                                                        phi_2274_ = vec3<f32>(_e1090, _e1103, _e1077);
                                                                    }
                                                                    let _e1620 = phi_2274_;
                                                                    phi_2275_ = _e1620;
                                                                }
                                                                let _e1623 = phi_2275_;
                                                                if _e377 {
                                                                    phi_2288_ = vec3<f32>(_e1117, _e1130, _e1143);
                                                                } else {
                                                                    if (_e353 == 1u) {
                                                                        phi_2287_ = vec3<f32>(_e1143, _e1117, _e1130);
                                                                    } else {
                                                                        phi_2287_ = vec3<f32>(_e1130, _e1143, _e1117);
                                                                    }
                                                                    let _e1628 = phi_2287_;
                                                                    phi_2288_ = _e1628;
                                                                }
                                                                let _e1631 = phi_2288_;
                                                                let _e1634 = (_e1623.x - _e1615.x);
                                                                let _e1637 = (_e1623.y - _e1615.y);
                                                                let _e1640 = (_e1623.z - _e1615.z);
                                                                let _e1642 = (_e1631.x - _e1615.x);
                                                                let _e1644 = (_e1631.y - _e1615.y);
                                                                let _e1646 = (_e1631.z - _e1615.z);
                                                                if (_e220.member_1 == 1u) {
                                                                    phi_2324_ = (vec3<f32>(_e220.member[0], _e220.member[1], _e220.member[2]) - _e1615);
                                                                } else {
                                                                    phi_2324_ = vec3<f32>(_e220.member[0], _e220.member[1], _e220.member[2]);
                                                                }
                                                                let _e1661 = phi_2324_;
                                                                let _e1667 = bitcast<f32>((bitcast<u32>((_e1634 * _e1644)) ^ _e220.member_3[0]));
                                                                let _e1671 = bitcast<f32>((bitcast<u32>((_e1637 * _e1642)) ^ _e220.member_3[0]));
                                                                let _e1675 = bitcast<f32>((bitcast<u32>((_e1637 * _e1646)) ^ _e220.member_3[0]));
                                                                let _e1679 = bitcast<f32>((bitcast<u32>((_e1640 * _e1644)) ^ _e220.member_3[0]));
                                                                let _e1683 = bitcast<f32>((bitcast<u32>((_e1640 * _e1642)) ^ _e220.member_3[0]));
                                                                let _e1687 = bitcast<f32>((bitcast<u32>((_e1634 * _e1646)) ^ _e220.member_3[0]));
                                                                let _e1688 = (_e1675 - _e1679);
                                                                let _e1689 = (_e1683 - _e1687);
                                                                let _e1690 = (_e1667 - _e1671);
                                                                let _e1714 = (bitcast<f32>((bitcast<u32>(_e1675) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1679) & 2147483647u)));
                                                                let _e1721 = (bitcast<f32>((bitcast<u32>(_e1683) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1687) & 2147483647u)));
                                                                let _e1728 = (bitcast<f32>((bitcast<u32>(_e1667) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1671) & 2147483647u)));
                                                                if (_e220.member_2 == 0f) {
                                                                    phi_2506_ = 0f;
                                                                } else {
                                                                    let _e1758 = bitcast<f32>((bitcast<u32>(_e1688) & 2147483647u));
                                                                    let _e1761 = bitcast<f32>((bitcast<u32>(_e1689) & 2147483647u));
                                                                    let _e1764 = bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u));
                                                                    let _e1766 = select(_e1764, _e1761, (_e1761 > _e1764));
                                                                    let _e1770 = select(_e1764, _e1761, (_e1761 < _e1764));
                                                                    let _e1774 = select(_e1761, _e1758, (_e1758 < _e1761));
                                                                    let _e1776 = select(_e1761, _e1758, (_e1758 > _e1761));
                                                                    let _e1778 = select(_e1764, _e1776, (_e1776 < _e1764));
                                                                    phi_2506_ = bitcast<f32>((bitcast<u32>((_e220.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1766, _e1758, (_e1758 > _e1766)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1778, _e1774, (_e1774 > _e1778)))) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1770, _e1758, (_e1758 < _e1770)))) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1714 + _e1721) + _e1728))) ^ _e220.member_3[0]))) * 1.0000005f)) ^ _e220.member_3[0])))) ^ _e220.member_3[0]));
                                                                }
                                                                let _e1805 = phi_2506_;
                                                                phi_2524_ = (_e1607 || !(((((bitcast<f32>((bitcast<u32>((_e1661.x * _e1688)) ^ _e220.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1661.y * _e1689)) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1661.z * _e1690)) ^ _e220.member_3[0]))) * f32(-(_e1606))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1661.x) & 2147483647u)) * _e1714)) ^ _e220.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1661.y) & 2147483647u)) * _e1721)) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1661.z) & 2147483647u)) * _e1728)) ^ _e220.member_3[0]))))) ^ _e220.member_3[0])) + _e1805) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1819 = phi_2524_;
                                                            phi_2525_ = _e1819;
                                                        }
                                                        let _e1821 = phi_2525_;
                                                        if _e1821 {
                                                            phi_2530_ = type_40(_e961.member, true);
                                                        } else {
                                                            phi_2530_ = _e961;
                                                        }
                                                        let _e1826 = phi_2530_;
                                                        phi_2531_ = _e1826;
                                                    } else {
                                                        phi_2531_ = _e961;
                                                    }
                                                    let _e1828 = phi_2531_;
                                                    phi_1064_ = _e1828;
                                                } else {
                                                    phi_1064_ = type_40();
                                                }
                                                let _e1830 = phi_1064_;
                                                continue;
                                                continuing {
                                                    phi_1063_ = _e1830;
                                                    phi_1066_ = _e976;
                                                    phi_3587_ = _e563;
                                                    break if !(_e982);
                                                }
                                            }
                                            let _e1833 = phi_3587_;
                                            phi_3771_ = _e1833;
                                            if _e1833 {
                                                break;
                                            }
                                            let _e1835 = local_10;
                                            phi_3775_ = _e1833;
                                            let _e2032 = local_12;
                                            phi_3481_ = _e2032;
                                            phi_3482_ = _e604;
                                            phi_3483_ = false;
                                            phi_3484_ = select(_e608, 0u, _e1835.member_1);
                                        } else {
                                            let _e618 = (_e604.member_1 < _e88);
                                            if _e618 {
                                                if _e618 {
                                                } else {
                                                    phi_3771_ = true;
                                                    break;
                                                }
                                                let _e620 = global_9.member[_e604.member_1];
                                                phi_2551_ = _e620;
                                            } else {
                                                phi_2551_ = type_49(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e622 = phi_2551_;
                                            let _e637 = ((10u * _e353) & 31u);
                                            let _e640 = ((_e622.member[0] >> bitcast<u32>(_e637)) & 1023u);
                                            let _e645 = bitcast<f32>((bitcast<u32>(((_e604.member.member_1[0] - _e604.member.member[0]) * 0.0009775171f)) ^ _e131));
                                            let _e651 = (_e604.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e640) * _e645)) ^ _e131)));
                                            let _e655 = select(select(_e604.member.member_1[0], _e651, (_e651 < _e604.member.member_1[0])), _e604.member.member_1[0], (_e640 == 1023u));
                                            let _e657 = ((10u * _e352) & 31u);
                                            let _e660 = ((_e622.member[0] >> bitcast<u32>(_e657)) & 1023u);
                                            let _e665 = bitcast<f32>((bitcast<u32>(((_e604.member.member_1[1] - _e604.member.member[1]) * 0.0009775171f)) ^ _e131));
                                            let _e671 = (_e604.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e660) * _e665)) ^ _e131)));
                                            let _e675 = select(select(_e604.member.member_1[1], _e671, (_e671 < _e604.member.member_1[1])), _e604.member.member_1[1], (_e660 == 1023u));
                                            let _e677 = ((10u * _e354) & 31u);
                                            let _e680 = ((_e622.member[0] >> bitcast<u32>(_e677)) & 1023u);
                                            let _e685 = bitcast<f32>((bitcast<u32>(((_e604.member.member_1[2] - _e604.member.member[2]) * 0.0009775171f)) ^ _e131));
                                            let _e691 = (_e604.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e680) * _e685)) ^ _e131)));
                                            let _e695 = select(select(_e604.member.member_1[2], _e691, (_e691 < _e604.member.member_1[2])), _e604.member.member_1[2], (_e680 == 1023u));
                                            let _e698 = ((_e622.member[1] >> bitcast<u32>(_e637)) & 1023u);
                                            let _e704 = (_e604.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e698) * _e645)) ^ _e131)));
                                            let _e708 = select(select(_e604.member.member_1[0], _e704, (_e704 < _e604.member.member_1[0])), _e604.member.member_1[0], (_e698 == 1023u));
                                            let _e711 = ((_e622.member[1] >> bitcast<u32>(_e657)) & 1023u);
                                            let _e717 = (_e604.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e711) * _e665)) ^ _e131)));
                                            let _e721 = select(select(_e604.member.member_1[1], _e717, (_e717 < _e604.member.member_1[1])), _e604.member.member_1[1], (_e711 == 1023u));
                                            let _e724 = ((_e622.member[1] >> bitcast<u32>(_e677)) & 1023u);
                                            let _e730 = (_e604.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e724) * _e685)) ^ _e131)));
                                            let _e734 = select(select(_e604.member.member_1[2], _e730, (_e730 < _e604.member.member_1[2])), _e604.member.member_1[2], (_e724 == 1023u));
                                            let _e740 = ((_e622.member_1[0] >> bitcast<u32>(_e637)) & 1023u);
                                            let _e746 = (_e604.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e740) * _e645)) ^ _e131)));
                                            let _e750 = select(select(_e604.member.member_1[0], _e746, (_e746 < _e604.member.member_1[0])), _e604.member.member_1[0], (_e740 == 1023u));
                                            let _e753 = ((_e622.member_1[0] >> bitcast<u32>(_e657)) & 1023u);
                                            let _e759 = (_e604.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e753) * _e665)) ^ _e131)));
                                            let _e763 = select(select(_e604.member.member_1[1], _e759, (_e759 < _e604.member.member_1[1])), _e604.member.member_1[1], (_e753 == 1023u));
                                            let _e766 = ((_e622.member_1[0] >> bitcast<u32>(_e677)) & 1023u);
                                            let _e772 = (_e604.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e766) * _e685)) ^ _e131)));
                                            let _e776 = select(select(_e604.member.member_1[2], _e772, (_e772 < _e604.member.member_1[2])), _e604.member.member_1[2], (_e766 == 1023u));
                                            let _e779 = ((_e622.member_1[1] >> bitcast<u32>(_e637)) & 1023u);
                                            let _e785 = (_e604.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e779) * _e645)) ^ _e131)));
                                            let _e789 = select(select(_e604.member.member_1[0], _e785, (_e785 < _e604.member.member_1[0])), _e604.member.member_1[0], (_e779 == 1023u));
                                            let _e792 = ((_e622.member_1[1] >> bitcast<u32>(_e657)) & 1023u);
                                            let _e798 = (_e604.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e792) * _e665)) ^ _e131)));
                                            let _e802 = select(select(_e604.member.member_1[1], _e798, (_e798 < _e604.member.member_1[1])), _e604.member.member_1[1], (_e792 == 1023u));
                                            let _e805 = ((_e622.member_1[1] >> bitcast<u32>(_e677)) & 1023u);
                                            let _e811 = (_e604.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e805) * _e685)) ^ _e131)));
                                            let _e815 = select(select(_e604.member.member_1[2], _e811, (_e811 < _e604.member.member_1[2])), _e604.member.member_1[2], (_e805 == 1023u));
                                            let _e820 = type_62(type_54(array<f32, 3>(_e655, _e675, _e695), array<f32, 3>(_e708, _e721, _e734)), _e622.member_2);
                                            let _e825 = type_62(type_54(array<f32, 3>(_e750, _e763, _e776), array<f32, 3>(_e789, _e802, _e815)), _e622.member_3);
                                            let _e831 = ((_e655 - _e408) * _e413);
                                            let _e832 = ((_e750 - _e408) * _e413);
                                            let _e833 = ((_e708 - _e409) * _e413);
                                            let _e834 = ((_e789 - _e409) * _e413);
                                            let _e839 = ((_e675 - _e444) * _e449);
                                            let _e840 = ((_e763 - _e444) * _e449);
                                            let _e841 = ((_e721 - _e445) * _e449);
                                            let _e842 = ((_e802 - _e445) * _e449);
                                            let _e847 = ((_e695 - _e480) * _e485);
                                            let _e848 = ((_e776 - _e480) * _e485);
                                            let _e849 = ((_e734 - _e481) * _e485);
                                            let _e850 = ((_e815 - _e481) * _e485);
                                            let _e852 = select(_e849, _e847, (_e847 < _e849));
                                            let _e854 = select(_e850, _e848, (_e848 < _e850));
                                            let _e856 = select(_e849, _e847, (_e847 > _e849));
                                            let _e858 = select(_e850, _e848, (_e848 > _e850));
                                            let _e860 = select(_e833, _e831, (_e831 < _e833));
                                            let _e862 = select(_e834, _e832, (_e832 < _e834));
                                            let _e864 = select(_e841, _e839, (_e839 < _e841));
                                            let _e866 = select(_e842, _e840, (_e840 < _e842));
                                            let _e868 = select(_e864, _e860, (_e860 > _e864));
                                            let _e870 = select(_e866, _e862, (_e862 > _e866));
                                            let _e872 = select(_e852, _e868, (_e868 > _e852));
                                            let _e874 = select(_e854, _e870, (_e870 > _e854));
                                            let _e876 = select(_e833, _e831, (_e831 > _e833));
                                            let _e878 = select(_e834, _e832, (_e832 > _e834));
                                            let _e880 = select(_e841, _e839, (_e839 > _e841));
                                            let _e882 = select(_e842, _e840, (_e840 > _e842));
                                            let _e884 = select(_e880, _e876, (_e876 < _e880));
                                            let _e886 = select(_e882, _e878, (_e878 < _e882));
                                            let _e891 = -(_e852);
                                            let _e892 = -(_e854);
                                            let _e899 = (select(_e856, _e884, (_e884 < _e856)) + (select(_e891, _e856, (_e856 > _e891)) * 0.0000019073523f));
                                            let _e900 = (select(_e858, _e886, (_e886 < _e858)) + (select(_e892, _e858, (_e858 > _e892)) * 0.0000019073523f));
                                            let _e902 = select(_e531, _e872, (_e872 > _e531));
                                            let _e904 = select(_e531, _e874, (_e874 > _e531));
                                            let _e909 = (_e902 <= select(_e565.member, _e899, (_e899 < _e565.member)));
                                            let _e910 = (_e904 <= select(_e565.member, _e900, (_e900 < _e565.member)));
                                            let _e911 = (_e902 <= _e904);
                                            if _e909 {
                                                if _e910 {
                                                    if _e911 {
                                                        phi_3383_ = _e825;
                                                    } else {
                                                        phi_3383_ = _e820;
                                                    }
                                                    let _e913 = phi_3383_;
                                                    let _e921 = (_e608 % 128u);
                                                    let _e922 = (_e921 < 128u);
                                                    if _e922 {
                                                    } else {
                                                        phi_3771_ = true;
                                                        break;
                                                    }
                                                    local_6[_e921] = _e913.member_1;
                                                    if _e922 {
                                                    } else {
                                                        phi_3771_ = true;
                                                        break;
                                                    }
                                                    local_5[_e921] = _e913.member.member[0];
                                                    if _e922 {
                                                    } else {
                                                        phi_3771_ = true;
                                                        break;
                                                    }
                                                    local_4[_e921] = _e913.member.member[1];
                                                    if _e922 {
                                                    } else {
                                                        phi_3771_ = true;
                                                        break;
                                                    }
                                                    local_3[_e921] = _e913.member.member[2];
                                                    if _e922 {
                                                    } else {
                                                        phi_3771_ = true;
                                                        break;
                                                    }
                                                    local_2[_e921] = _e913.member.member_1[0];
                                                    if _e922 {
                                                    } else {
                                                        phi_3771_ = true;
                                                        break;
                                                    }
                                                    local_1[_e921] = _e913.member.member_1[1];
                                                    if _e922 {
                                                    } else {
                                                        phi_3771_ = true;
                                                        break;
                                                    }
                                                    local[_e921] = _e913.member.member_1[2];
                                                    if _e922 {
                                                    } else {
                                                        phi_3771_ = true;
                                                        break;
                                                    }
                                                    local_7[_e921] = select(_e904, _e902, (_e902 > _e904));
                                                    if _e911 {
                                                        phi_3460_ = _e820;
                                                    } else {
                                                        phi_3460_ = _e825;
                                                    }
                                                    let _e939 = phi_3460_;
                                                    phi_3461_ = _e939;
                                                    phi_3462_ = (_e608 + 1u);
                                                } else {
                                                    phi_3461_ = type_62();
                                                    phi_3462_ = u32();
                                                }
                                                let _e941 = phi_3461_;
                                                let _e943 = phi_3462_;
                                                phi_3464_ = _e941;
                                                phi_3465_ = _e943;
                                                phi_3466_ = select(true, false, _e910);
                                            } else {
                                                phi_3464_ = type_62();
                                                phi_3465_ = u32();
                                                phi_3466_ = true;
                                            }
                                            let _e946 = phi_3464_;
                                            let _e948 = phi_3465_;
                                            let _e950 = phi_3466_;
                                            if _e950 {
                                                if _e909 {
                                                    phi_3473_ = _e820;
                                                } else {
                                                    phi_3473_ = _e825;
                                                }
                                                let _e952 = phi_3473_;
                                                phi_3478_ = _e952;
                                                phi_3479_ = select(_e910, true, _e909);
                                            } else {
                                                phi_3478_ = _e946;
                                                phi_3479_ = _e606;
                                            }
                                            let _e955 = phi_3478_;
                                            let _e957 = phi_3479_;
                                            phi_3775_ = _e563;
                                            phi_3481_ = _e565;
                                            phi_3482_ = _e955;
                                            phi_3483_ = _e957;
                                            phi_3484_ = select(_e948, _e608, _e950);
                                        }
                                        let _e1839 = phi_3775_;
                                        let _e1841 = phi_3481_;
                                        let _e1843 = phi_3482_;
                                        let _e1845 = phi_3483_;
                                        let _e1847 = phi_3484_;
                                        phi_3774_ = _e1839;
                                        phi_3485_ = _e1841;
                                        phi_3486_ = _e1843;
                                        phi_3487_ = (_e569 - 1u);
                                        phi_3488_ = _e1845;
                                        phi_3489_ = _e1847;
                                    } else {
                                        phi_3774_ = _e563;
                                        phi_3485_ = _e565;
                                        phi_3486_ = _e604;
                                        phi_3487_ = _e569;
                                        phi_3488_ = _e606;
                                        phi_3489_ = _e608;
                                    }
                                    let _e1849 = phi_3774_;
                                    let _e1851 = phi_3485_;
                                    let _e1853 = phi_3486_;
                                    let _e1855 = phi_3487_;
                                    let _e1857 = phi_3488_;
                                    let _e1859 = phi_3489_;
                                    phi_3773_ = _e1849;
                                    phi_3490_ = _e1851;
                                    phi_3491_ = _e1853;
                                    phi_3492_ = _e1855;
                                    phi_3493_ = _e1857;
                                    phi_3494_ = _e1859;
                                } else {
                                    phi_3773_ = _e563;
                                    phi_3490_ = type_40();
                                    phi_3491_ = type_62();
                                    phi_3492_ = u32();
                                    phi_3493_ = bool();
                                    phi_3494_ = u32();
                                }
                                let _e1861 = phi_3773_;
                                let _e1863 = phi_3490_;
                                let _e1865 = phi_3491_;
                                let _e1867 = phi_3492_;
                                let _e1869 = phi_3493_;
                                let _e1871 = phi_3494_;
                                phi_3772_ = _e1861;
                                phi_937_ = _e1863;
                                phi_940_ = _e1865;
                                phi_942_ = _e1867;
                                phi_944_ = _e1869;
                                phi_946_ = _e1871;
                                phi_3495_ = _e577;
                            } else {
                                phi_3772_ = _e563;
                                phi_937_ = type_40();
                                phi_940_ = type_62();
                                phi_942_ = u32();
                                phi_944_ = bool();
                                phi_946_ = u32();
                                phi_3495_ = false;
                            }
                            let _e1873 = phi_3772_;
                            let _e1875 = phi_937_;
                            let _e1877 = phi_940_;
                            let _e1879 = phi_942_;
                            let _e1881 = phi_944_;
                            let _e1883 = phi_946_;
                            let _e1885 = phi_3495_;
                            continue;
                            continuing {
                                phi_3593_ = _e1873;
                                phi_936_ = _e1875;
                                phi_939_ = _e1877;
                                phi_941_ = _e1879;
                                phi_943_ = _e1881;
                                phi_945_ = _e1883;
                                phi_3771_ = _e1873;
                                break if !(_e1885);
                            }
                        }
                        let _e1888 = phi_3771_;
                        if _e1888 {
                            break;
                        }
                        let _e1890 = local_11;
                        if _e1890.member_1 {
                        } else {
                            if _e221 {
                            } else {
                                break;
                            }
                            let _e1894 = global_2.member[_e135];
                            if _e142 {
                            } else {
                                break;
                            }
                            let _e1898 = global_8.member[_e135].member_1;
                            if _e221 {
                            } else {
                                break;
                            }
                            global_2.member[_e135] = type_24(_e1894.member, _e1894.member_1, _e1894.member_2, array<f32, 3>((_e1894.member_3[0] + (_e1898[0] * _e1894.member_1[0])), (_e1894.member_3[1] + (_e1898[1] * _e1894.member_1[1])), (_e1894.member_3[2] + (_e1898[2] * _e1894.member_1[2]))), _e1894.member_4);
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
