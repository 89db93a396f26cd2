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

struct type_55 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_57 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_59 {
    member: array<type_57>,
}

struct type_63 {
    member: type_55,
    member_1: u32,
}

struct type_70 {
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
var<storage, read_write> global_7: type_70;
@group(0) @binding(7) 
var<storage> global_8: type_32;
@group(0) @binding(3) 
var<storage> global_9: type_51;
@group(0) @binding(4) 
var<storage> global_10: type_59;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 128>;
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<f32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<u32, 3>;
    var local_17: array<u32, 3>;
    var local_18: array<u32, 3>;
    var local_19: array<array<f32, 3>, 3>;
    var local_20: array<u32, 3>;
    var local_21: array<f32, 3>;
    var local_22: array<f32, 3>;
    var phi_290_: u32;
    var phi_334_: i32;
    var phi_358_: type_36;
    var phi_508_: i32;
    var phi_509_: i32;
    var phi_519_: bool;
    var phi_529_: u32;
    var phi_530_: u32;
    var phi_532_: bool;
    var phi_537_: u32;
    var phi_570_: i32;
    var phi_588_: f32;
    var phi_594_: f32;
    var phi_605_: f32;
    var phi_611_: f32;
    var phi_634_: f32;
    var phi_645_: f32;
    var phi_654_: f32;
    var phi_660_: f32;
    var phi_671_: f32;
    var phi_677_: f32;
    var phi_700_: f32;
    var phi_711_: f32;
    var phi_720_: f32;
    var phi_726_: f32;
    var phi_737_: f32;
    var phi_743_: f32;
    var phi_766_: f32;
    var phi_777_: f32;
    var phi_877_: f32;
    var phi_878_: f32;
    var phi_3282_: bool;
    var phi_951_: type_40;
    var phi_954_: type_63;
    var phi_956_: u32;
    var phi_958_: bool;
    var phi_960_: u32;
    var phi_971_: bool;
    var phi_1057_: type_63;
    var phi_1058_: bool;
    var phi_1059_: u32;
    var phi_2277_: type_49;
    var phi_2286_: type_8;
    var phi_2287_: type_8;
    var phi_2310_: type_8;
    var phi_3275_: bool;
    var phi_2440_: type_8;
    var phi_2441_: type_8;
    var phi_2464_: type_8;
    var phi_3342_: bool;
    var phi_3027_: type_63;
    var phi_3104_: type_63;
    var phi_3105_: type_63;
    var phi_3106_: u32;
    var phi_3108_: type_63;
    var phi_3109_: u32;
    var phi_3110_: bool;
    var phi_3117_: type_63;
    var phi_3122_: type_63;
    var phi_3123_: bool;
    var phi_3359_: bool;
    var phi_1078_: type_40;
    var phi_1081_: type_8;
    var phi_1082_: type_8;
    var phi_1104_: type_8;
    var phi_1146_: u32;
    var phi_1170_: type_57;
    var phi_3355_: bool;
    var phi_1181_: type_8;
    var phi_1182_: type_8;
    var phi_1205_: type_8;
    var phi_1215_: type_8;
    var phi_1216_: type_8;
    var phi_1239_: type_8;
    var phi_3350_: bool;
    var phi_3363_: bool;
    var phi_3362_: bool;
    var phi_1802_: vec3<f32>;
    var phi_1803_: vec3<f32>;
    var phi_1834_: bool;
    var phi_1843_: vec3<f32>;
    var phi_1883_: type_22;
    var phi_1885_: type_22;
    var phi_1886_: bool;
    var phi_1890_: type_22;
    var phi_1891_: type_22;
    var phi_1892_: type_22;
    var phi_1893_: bool;
    var phi_1897_: type_22;
    var phi_1898_: bool;
    var phi_1902_: type_22;
    var phi_1903_: bool;
    var phi_1907_: type_22;
    var phi_1930_: u32;
    var phi_1944_: i32;
    var phi_1964_: vec3<f32>;
    var phi_1965_: vec3<f32>;
    var phi_1981_: vec3<f32>;
    var phi_1982_: vec3<f32>;
    var phi_1998_: vec3<f32>;
    var phi_1999_: vec3<f32>;
    var phi_2035_: vec3<f32>;
    var phi_2217_: f32;
    var phi_2235_: bool;
    var phi_2236_: bool;
    var phi_2241_: type_40;
    var phi_2242_: type_40;
    var phi_3365_: bool;
    var phi_1079_: type_40;
    var phi_3364_: bool;
    var local_23: type_40;
    var phi_3444_: bool;
    var phi_3125_: type_40;
    var phi_3126_: type_63;
    var phi_3127_: bool;
    var phi_3128_: u32;
    var phi_3443_: bool;
    var phi_3129_: type_40;
    var phi_3130_: type_63;
    var phi_3131_: u32;
    var phi_3132_: bool;
    var phi_3133_: u32;
    var phi_3442_: bool;
    var phi_3134_: type_40;
    var phi_3135_: type_63;
    var phi_3136_: u32;
    var phi_3137_: bool;
    var phi_3138_: u32;
    var phi_3441_: bool;
    var phi_952_: type_40;
    var phi_955_: type_63;
    var phi_957_: u32;
    var phi_959_: bool;
    var phi_961_: u32;
    var phi_3139_: bool;
    var phi_3440_: bool;
    var local_24: type_40;
    var local_25: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e101 = arrayLength((&global_9.member));
            let _e116 = arrayLength((&global_7.member));
            let _e120 = global_4.member[0u][0u];
            let _e124 = global_4.member[0u][1u];
            let _e128 = global_4.member[0u][2u];
            let _e132 = global_4.member[1u][0u];
            let _e136 = global_4.member[1u][1u];
            let _e140 = global_4.member[1u][2u];
            let _e144 = global_4.member[1u][3u];
            let _e148 = (_e98.x + (_e98.y * 2097152u));
            let _e155 = (_e148 < arrayLength((&global_8.member)));
            if _e155 {
                if _e155 {
                } else {
                    break;
                }
                let _e159 = global_8.member[_e148].member_2;
                phi_290_ = _e159;
            } else {
                phi_290_ = 4294967295u;
            }
            let _e161 = phi_290_;
            let _e164 = global_1.member[0u];
            let _e168 = global_3.member[0u][0u];
            let _e172 = global_3.member[0u][1u];
            let _e176 = global_3.member[0u][2u];
            let _e180 = global_3.member[0u][3u];
            let _e184 = global_3.member[1u][0u];
            let _e188 = global_3.member[1u][1u];
            let _e192 = global_3.member[1u][2u];
            let _e196 = global_3.member[1u][3u];
            let _e197 = bitcast<f32>(_e168);
            let _e198 = bitcast<f32>(_e172);
            let _e199 = bitcast<f32>(_e176);
            let _e201 = bitcast<f32>(_e184);
            let _e202 = array<u32, 3>(_e188, _e192, _e196);
            let _e204 = bitcast<i32>(_e164);
            if (_e204 < -126i) {
                phi_334_ = -126i;
            } else {
                phi_334_ = select(_e204, 127i, (_e204 > 127i));
            }
            let _e209 = phi_334_;
            let _e214 = bitcast<f32>((bitcast<u32>((_e209 + 127i)) << bitcast<u32>(23i)));
            let _e220 = bitcast<f32>((bitcast<u32>(((_e204 - _e209) + 127i)) << bitcast<u32>(23i)));
            if (_e180 == 0u) {
                phi_358_ = type_36(array<f32, 3>(_e197, _e198, _e199), _e180, _e201, _e202);
            } else {
                phi_358_ = type_36(array<f32, 3>(((_e197 * _e214) * _e220), ((_e198 * _e214) * _e220), ((_e199 * _e214) * _e220)), _e180, ((_e201 * _e214) * _e220), _e202);
            }
            let _e233 = phi_358_;
            if _e155 {
                let _e234 = (_e148 < arrayLength((&global_2.member)));
                if _e234 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e239 = global_8.member[_e148].member.member_1;
                    let _e244 = global_8.member[_e148].member.member_3;
                    if (_e239 <= _e244) {
                        let _e246 = (1u < _e116);
                        if _e246 {
                            if (0u < _e116) {
                            } else {
                                break;
                            }
                            let _e250 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e250 + 1u) < _e250) {
                                if _e246 {
                                } else {
                                    break;
                                }
                                let _e255 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e265 = global_8.member[_e148].member.member_2[0u];
                        let _e267 = (bitcast<u32>(_e265) & 2147483647u);
                        let _e273 = global_8.member[_e148].member.member_2[1u];
                        let _e275 = (bitcast<u32>(_e273) & 2147483647u);
                        let _e281 = global_8.member[_e148].member.member_2[2u];
                        let _e283 = (bitcast<u32>(_e281) & 2147483647u);
                        let _e289 = global_8.member[_e148].member.member[0u];
                        let _e291 = (bitcast<u32>(_e289) & 2147483647u);
                        let _e297 = global_8.member[_e148].member.member[1u];
                        let _e299 = (bitcast<u32>(_e297) & 2147483647u);
                        let _e305 = global_8.member[_e148].member.member[2u];
                        let _e307 = (bitcast<u32>(_e305) & 2147483647u);
                        let _e309 = select(_e275, _e267, (_e275 < _e267));
                        let _e311 = select(_e283, _e309, (_e283 < _e309));
                        let _e313 = select(_e291, _e311, (_e291 < _e311));
                        let _e315 = select(_e299, _e313, (_e299 < _e313));
                        let _e317 = select(_e307, _e315, (_e307 < _e315));
                        let _e319 = (bitcast<u32>(_e239) & 2147483647u);
                        let _e328 = (((select(_e319, _e317, (_e319 < _e317)) < 2139095040u) && ((bitcast<u32>(_e244) & 2147483647u) <= 2139095040u)) && (_e311 > 0u));
                        if _e328 {
                            let _e331 = (bitcast<u32>(bitcast<f32>(_e311)) & 2147483647u);
                            if (_e331 >= 8388608u) {
                                phi_508_ = (bitcast<i32>((_e331 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_508_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e331)), 32u, (_e331 == 0u))));
                            }
                            let _e345 = phi_508_;
                            phi_509_ = _e345;
                        } else {
                            phi_509_ = 0i;
                        }
                        let _e347 = phi_509_;
                        let _e348 = (_e267 == _e311);
                        if _e348 {
                            phi_519_ = true;
                        } else {
                            phi_519_ = (_e275 == _e311);
                        }
                        let _e351 = phi_519_;
                        let _e352 = select(1u, 0u, _e348);
                        if _e351 {
                            let _e353 = (_e352 + 1u);
                            phi_529_ = _e353;
                            phi_530_ = _e353;
                            phi_532_ = select(true, false, (_e353 == 2u));
                        } else {
                            phi_529_ = u32();
                            phi_530_ = 0u;
                            phi_532_ = true;
                        }
                        let _e357 = phi_529_;
                        let _e359 = phi_530_;
                        let _e361 = phi_532_;
                        if _e361 {
                            phi_537_ = (_e359 + 1u);
                        } else {
                            phi_537_ = 0u;
                        }
                        let _e365 = phi_537_;
                        let _e366 = select(_e357, _e359, _e361);
                        let _e367 = select(_e352, select(2u, _e352, _e351), _e361);
                        let _e368 = -(_e347);
                        if (_e368 < -126i) {
                            phi_570_ = -126i;
                        } else {
                            phi_570_ = select(_e368, 127i, (_e368 > 127i));
                        }
                        let _e373 = phi_570_;
                        let _e378 = bitcast<f32>((bitcast<u32>((_e373 + 127i)) << bitcast<u32>(23i)));
                        let _e384 = bitcast<f32>((bitcast<u32>(((_e368 - _e373) + 127i)) << bitcast<u32>(23i)));
                        let _e389 = global_8.member[_e148].member.member;
                        let _e390 = (_e366 == 0u);
                        if _e390 {
                            phi_588_ = _e389[0];
                        } else {
                            phi_588_ = _e389[1];
                        }
                        let _e394 = phi_588_;
                        let _e395 = (_e366 == 2u);
                        if _e395 {
                            phi_594_ = _e389[2];
                        } else {
                            phi_594_ = _e394;
                        }
                        let _e398 = phi_594_;
                        let _e399 = global_8.member[_e148].member.member_2;
                        if _e390 {
                            phi_605_ = _e399[0];
                        } else {
                            phi_605_ = _e399[1];
                        }
                        let _e403 = phi_605_;
                        if _e395 {
                            phi_611_ = _e399[2];
                        } else {
                            phi_611_ = _e403;
                        }
                        let _e406 = phi_611_;
                        let _e408 = ((_e406 * _e378) * _e384);
                        let _e412 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e412 {
                            let _e416 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) * 0.00000011920929f);
                            phi_634_ = select(0.00000000000011368684f, _e416, (_e416 > 0.00000000000011368684f));
                        } else {
                            phi_634_ = 0f;
                        }
                        let _e420 = phi_634_;
                        let _e421 = (_e398 + _e420);
                        let _e422 = (_e398 - _e420);
                        let _e423 = select(_e408, 0f, _e412);
                        if _e412 {
                            phi_645_ = 38685626000000000000000000f;
                        } else {
                            phi_645_ = (1f / _e408);
                        }
                        let _e426 = phi_645_;
                        let _e427 = (_e365 == 0u);
                        if _e427 {
                            phi_654_ = _e389[0];
                        } else {
                            phi_654_ = _e389[1];
                        }
                        let _e431 = phi_654_;
                        let _e432 = (_e365 == 2u);
                        if _e432 {
                            phi_660_ = _e389[2];
                        } else {
                            phi_660_ = _e431;
                        }
                        let _e435 = phi_660_;
                        if _e427 {
                            phi_671_ = _e399[0];
                        } else {
                            phi_671_ = _e399[1];
                        }
                        let _e439 = phi_671_;
                        if _e432 {
                            phi_677_ = _e399[2];
                        } else {
                            phi_677_ = _e439;
                        }
                        let _e442 = phi_677_;
                        let _e444 = ((_e442 * _e378) * _e384);
                        let _e448 = (bitcast<f32>((bitcast<u32>(_e444) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e448 {
                            let _e452 = (bitcast<f32>((bitcast<u32>(_e435) & 2147483647u)) * 0.00000011920929f);
                            phi_700_ = select(0.00000000000011368684f, _e452, (_e452 > 0.00000000000011368684f));
                        } else {
                            phi_700_ = 0f;
                        }
                        let _e456 = phi_700_;
                        let _e457 = (_e435 + _e456);
                        let _e458 = (_e435 - _e456);
                        let _e459 = select(_e444, 0f, _e448);
                        if _e448 {
                            phi_711_ = 38685626000000000000000000f;
                        } else {
                            phi_711_ = (1f / _e444);
                        }
                        let _e462 = phi_711_;
                        let _e463 = (_e367 == 0u);
                        if _e463 {
                            phi_720_ = _e389[0];
                        } else {
                            phi_720_ = _e389[1];
                        }
                        let _e467 = phi_720_;
                        let _e468 = (_e367 == 2u);
                        if _e468 {
                            phi_726_ = _e389[2];
                        } else {
                            phi_726_ = _e467;
                        }
                        let _e471 = phi_726_;
                        if _e463 {
                            phi_737_ = _e399[0];
                        } else {
                            phi_737_ = _e399[1];
                        }
                        let _e475 = phi_737_;
                        if _e468 {
                            phi_743_ = _e399[2];
                        } else {
                            phi_743_ = _e475;
                        }
                        let _e478 = phi_743_;
                        let _e480 = ((_e478 * _e378) * _e384);
                        let _e484 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e484 {
                            let _e488 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) * 0.00000011920929f);
                            phi_766_ = select(0.00000000000011368684f, _e488, (_e488 > 0.00000000000011368684f));
                        } else {
                            phi_766_ = 0f;
                        }
                        let _e492 = phi_766_;
                        let _e493 = (_e471 + _e492);
                        let _e494 = (_e471 - _e492);
                        let _e495 = select(_e480, 0f, _e484);
                        if _e484 {
                            phi_777_ = 38685626000000000000000000f;
                        } else {
                            phi_777_ = (1f / _e480);
                        }
                        let _e498 = phi_777_;
                        let _e501 = bitcast<f32>((bitcast<u32>(_e398) & 2147483647u));
                        let _e504 = bitcast<f32>((bitcast<u32>(_e435) & 2147483647u));
                        let _e506 = select(_e504, _e501, (_e501 > _e504));
                        let _e509 = bitcast<f32>((bitcast<u32>(_e471) & 2147483647u));
                        if (_e328 && (select(_e509, _e506, (_e506 > _e509)) <= 1099511600000f)) {
                            let _e514 = (_e347 / 3i);
                            let _e521 = bitcast<f32>((bitcast<u32>((_e514 + 127i)) << bitcast<u32>(23i)));
                            let _e528 = bitcast<f32>((bitcast<u32>(((_e347 - (2i * _e514)) + 127i)) << bitcast<u32>(23i)));
                            let _e529 = (((_e239 * _e521) * _e521) * _e528);
                            let _e531 = select(340282350000000000000000000000000000000f, _e529, (_e529 < 340282350000000000000000000000000000000f));
                            let _e536 = (((_e244 * _e521) * _e521) * _e528);
                            let _e538 = select(340282350000000000000000000000000000000f, _e536, (_e536 < 340282350000000000000000000000000000000f));
                            phi_877_ = select(-340282350000000000000000000000000000000f, _e538, (_e538 > -340282350000000000000000000000000000000f));
                            phi_878_ = select(-340282350000000000000000000000000000000f, _e531, (_e531 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_877_ = 0f;
                            phi_878_ = 1f;
                        }
                        let _e542 = phi_877_;
                        let _e544 = phi_878_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_11 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_22 = array<f32, 3>(bitcast<f32>(_e120), bitcast<f32>(_e124), bitcast<f32>(_e128));
                        let _e549 = (_e366 % 3u);
                        let _e550 = (_e549 < 3u);
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e552 = local_22[_e549];
                        let _e553 = (_e365 % 3u);
                        let _e554 = (_e553 < 3u);
                        if _e554 {
                        } else {
                            break;
                        }
                        let _e556 = local_22[_e553];
                        let _e557 = (_e367 % 3u);
                        let _e558 = (_e557 < 3u);
                        if _e558 {
                        } else {
                            break;
                        }
                        let _e560 = local_22[_e557];
                        local_21 = array<f32, 3>(bitcast<f32>(_e132), bitcast<f32>(_e136), bitcast<f32>(_e140));
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e564 = local_21[_e549];
                        if _e554 {
                        } else {
                            break;
                        }
                        let _e566 = local_21[_e553];
                        if _e558 {
                        } else {
                            break;
                        }
                        let _e568 = local_21[_e557];
                        phi_3282_ = false;
                        phi_951_ = type_40(_e542, false);
                        phi_954_ = type_63(type_55(array<f32, 3>(_e552, _e556, _e560), array<f32, 3>(_e564, _e566, _e568)), select(0u, 2147483648u, (_e101 == 0u)));
                        phi_956_ = ((3u * _e101) + 1u);
                        phi_958_ = (_e544 <= _e542);
                        phi_960_ = 0u;
                        loop {
                            let _e576 = phi_3282_;
                            let _e578 = phi_951_;
                            let _e580 = phi_954_;
                            let _e582 = phi_956_;
                            let _e584 = phi_958_;
                            let _e586 = phi_960_;
                            local_24 = _e578;
                            if _e584 {
                                phi_971_ = true;
                            } else {
                                phi_971_ = (_e586 > 0u);
                            }
                            let _e589 = phi_971_;
                            if _e589 {
                                let _e590 = (_e582 > 0u);
                                if _e590 {
                                    if _e584 {
                                        phi_1057_ = _e580;
                                        phi_1058_ = _e584;
                                        phi_1059_ = _e586;
                                    } else {
                                        let _e591 = (_e586 - 1u);
                                        let _e592 = (_e591 % 128u);
                                        let _e593 = (_e592 < 128u);
                                        if _e593 {
                                        } else {
                                            phi_3440_ = true;
                                            break;
                                        }
                                        let _e595 = local_6[_e592];
                                        if _e593 {
                                        } else {
                                            phi_3440_ = true;
                                            break;
                                        }
                                        let _e597 = local_5[_e592];
                                        if _e593 {
                                        } else {
                                            phi_3440_ = true;
                                            break;
                                        }
                                        let _e599 = local_4[_e592];
                                        if _e593 {
                                        } else {
                                            phi_3440_ = true;
                                            break;
                                        }
                                        let _e601 = local_3[_e592];
                                        if _e593 {
                                        } else {
                                            phi_3440_ = true;
                                            break;
                                        }
                                        let _e604 = local_2[_e592];
                                        if _e593 {
                                        } else {
                                            phi_3440_ = true;
                                            break;
                                        }
                                        let _e606 = local_1[_e592];
                                        if _e593 {
                                        } else {
                                            phi_3440_ = true;
                                            break;
                                        }
                                        let _e608 = local[_e592];
                                        if _e593 {
                                        } else {
                                            phi_3440_ = true;
                                            break;
                                        }
                                        let _e613 = local_11[_e592];
                                        phi_1057_ = type_63(type_55(array<f32, 3>(_e597, _e599, _e601), array<f32, 3>(_e604, _e606, _e608)), _e595);
                                        phi_1058_ = (_e613 <= _e578.member);
                                        phi_1059_ = _e591;
                                    }
                                    let _e617 = phi_1057_;
                                    let _e619 = phi_1058_;
                                    let _e621 = phi_1059_;
                                    if _e619 {
                                        if ((_e617.member_1 & 2147483648u) != 0u) {
                                            phi_3359_ = _e576;
                                            phi_1078_ = _e578;
                                            phi_1081_ = type_8(0u, ((_e617.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e946 = phi_3359_;
                                                let _e948 = phi_1078_;
                                                let _e950 = phi_1081_;
                                                local_23 = _e948;
                                                local_25 = _e948;
                                                if (_e950.member < _e950.member_1) {
                                                    phi_1082_ = type_8((_e950.member + 1u), _e950.member_1);
                                                    phi_1104_ = type_8(1u, _e950.member);
                                                } else {
                                                    phi_1082_ = _e950;
                                                    phi_1104_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e963 = phi_1082_;
                                                let _e965 = phi_1104_;
                                                let _e969 = (bitcast<i32>(_e965.member) != 0i);
                                                if _e969 {
                                                    local_8 = array<f32, 3>(_e617.member.member[0], _e617.member.member[1], _e617.member.member[2]);
                                                    local_7 = array<f32, 3>(_e617.member.member_1[0], _e617.member.member_1[1], _e617.member.member_1[2]);
                                                    let _e980 = ((_e617.member_1 & 268435455u) + _e965.member_1);
                                                    let _e981 = (_e980 < arrayLength((&global_10.member)));
                                                    if _e981 {
                                                        if _e981 {
                                                        } else {
                                                            phi_3364_ = true;
                                                            break;
                                                        }
                                                        let _e984 = global_10.member[_e980].member_1;
                                                        phi_1146_ = _e984;
                                                    } else {
                                                        phi_1146_ = 4294967295u;
                                                    }
                                                    let _e986 = phi_1146_;
                                                    local_18 = array<u32, 3>(_e366, _e365, _e367);
                                                    if _e981 {
                                                        if _e981 {
                                                        } else {
                                                            phi_3364_ = true;
                                                            break;
                                                        }
                                                        let _e989 = global_10.member[_e980];
                                                        phi_1170_ = _e989;
                                                    } else {
                                                        phi_1170_ = type_57(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e991 = phi_1170_;
                                                    local_20 = array<u32, 3>(_e991.member[0], _e991.member[1], _e991.member[2]);
                                                    local_19[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_19[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_19[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_3355_ = _e946;
                                                    phi_1181_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1001 = phi_3355_;
                                                        let _e1003 = phi_1181_;
                                                        if (_e1003.member < _e1003.member_1) {
                                                            phi_1182_ = type_8((_e1003.member + 1u), _e1003.member_1);
                                                            phi_1205_ = type_8(1u, _e1003.member);
                                                        } else {
                                                            phi_1182_ = _e1003;
                                                            phi_1205_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1016 = phi_1182_;
                                                        let _e1018 = phi_1205_;
                                                        let _e1022 = (bitcast<i32>(_e1018.member) != 0i);
                                                        if _e1022 {
                                                            phi_1215_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1024 = phi_1215_;
                                                                if (_e1024.member < _e1024.member_1) {
                                                                    phi_1216_ = type_8((_e1024.member + 1u), _e1024.member_1);
                                                                    phi_1239_ = type_8(1u, _e1024.member);
                                                                } else {
                                                                    phi_1216_ = _e1024;
                                                                    phi_1239_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1037 = phi_1216_;
                                                                let _e1039 = phi_1239_;
                                                                let _e1043 = (bitcast<i32>(_e1039.member) != 0i);
                                                                if _e1043 {
                                                                    let _e1044 = (_e1018.member_1 < 3u);
                                                                    if _e1044 {
                                                                    } else {
                                                                        phi_3350_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1046 = local_20[_e1018.member_1];
                                                                    let _e1047 = (_e1039.member_1 < 3u);
                                                                    if _e1047 {
                                                                    } else {
                                                                        phi_3350_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1049 = local_18[_e1039.member_1];
                                                                    let _e1054 = ((_e1046 >> bitcast<u32>(((10u * _e1049) & 31u))) & 1023u);
                                                                    if _e1047 {
                                                                    } else {
                                                                        phi_3350_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1056 = local_8[_e1039.member_1];
                                                                    if _e1047 {
                                                                    } else {
                                                                        phi_3350_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1058 = local_7[_e1039.member_1];
                                                                    let _e1069 = (_e1056 + bitcast<f32>((bitcast<u32>((f32(_e1054) * bitcast<f32>((bitcast<u32>(((_e1058 - _e1056) * 0.0009775171f)) ^ _e144)))) ^ _e144)));
                                                                    if _e1044 {
                                                                    } else {
                                                                        phi_3350_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1047 {
                                                                    } else {
                                                                        phi_3350_ = true;
                                                                        break;
                                                                    }
                                                                    local_19[_e1018.member_1][_e1039.member_1] = select(select(_e1058, _e1069, (_e1069 < _e1058)), _e1058, (_e1054 == 1023u));
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_1215_ = _e1037;
                                                                    phi_3350_ = _e1001;
                                                                    break if !(_e1043);
                                                                }
                                                            }
                                                            let _e1078 = phi_3350_;
                                                            phi_3362_ = _e1078;
                                                            if _e1078 {
                                                                break;
                                                            }
                                                            phi_3363_ = _e1078;
                                                        } else {
                                                            phi_3363_ = _e1001;
                                                        }
                                                        let _e1080 = phi_3363_;
                                                        continue;
                                                        continuing {
                                                            phi_3355_ = _e1080;
                                                            phi_1181_ = _e1016;
                                                            phi_3362_ = _e1080;
                                                            break if !(_e1022);
                                                        }
                                                    }
                                                    let _e1083 = phi_3362_;
                                                    phi_3364_ = _e1083;
                                                    if _e1083 {
                                                        break;
                                                    }
                                                    let _e1084 = local_19;
                                                    let _e1100 = (_e1084[0][2] - _e471);
                                                    let _e1103 = (((_e1084[0][0] - _e398) * _e495) - (_e1100 * _e423));
                                                    let _e1106 = (((_e1084[0][1] - _e435) * _e495) - (_e1100 * _e459));
                                                    let _e1109 = (_e1084[1][2] - _e471);
                                                    let _e1112 = (((_e1084[1][0] - _e398) * _e495) - (_e1109 * _e423));
                                                    let _e1115 = (((_e1084[1][1] - _e435) * _e495) - (_e1109 * _e459));
                                                    let _e1118 = (_e1084[2][2] - _e471);
                                                    let _e1121 = (((_e1084[2][0] - _e398) * _e495) - (_e1118 * _e423));
                                                    let _e1124 = (((_e1084[2][1] - _e435) * _e495) - (_e1118 * _e459));
                                                    let _e1125 = (_e1121 * _e1115);
                                                    let _e1126 = (_e1124 * _e1112);
                                                    let _e1127 = (_e1103 * _e1124);
                                                    let _e1128 = (_e1106 * _e1121);
                                                    let _e1129 = (_e1112 * _e1106);
                                                    let _e1130 = (_e1115 * _e1103);
                                                    let _e1135 = (((_e1125 >= _e1126) && (_e1127 >= _e1128)) && (_e1129 >= _e1130));
                                                    if (_e1135 || (((_e1125 <= _e1126) && (_e1127 <= _e1128)) && (_e1129 <= _e1130))) {
                                                        let _e1142 = select(-1f, 1f, _e1135);
                                                        let _e1144 = ((_e1125 - _e1126) * _e1142);
                                                        let _e1146 = select(0f, _e1144, (_e1144 > 0f));
                                                        let _e1148 = ((_e1127 - _e1128) * _e1142);
                                                        let _e1150 = select(0f, _e1148, (_e1148 > 0f));
                                                        let _e1152 = ((_e1129 - _e1130) * _e1142);
                                                        let _e1154 = select(0f, _e1152, (_e1152 > 0f));
                                                        let _e1156 = ((_e1146 + _e1150) + _e1154);
                                                        if (_e1156 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1897_ = type_22();
                                                            phi_1898_ = true;
                                                        } else {
                                                            let _e1159 = select(_e1084[1][0], _e1084[0][0], (_e1084[0][0] < _e1084[1][0]));
                                                            let _e1163 = select(_e1084[1][0], _e1084[0][0], (_e1084[0][0] > _e1084[1][0]));
                                                            let _e1167 = select(_e1084[1][1], _e1084[0][1], (_e1084[0][1] < _e1084[1][1]));
                                                            let _e1171 = select(_e1084[1][1], _e1084[0][1], (_e1084[0][1] > _e1084[1][1]));
                                                            let _e1175 = select(_e1084[1][2], _e1084[0][2], (_e1084[0][2] < _e1084[1][2]));
                                                            let _e1179 = select(_e1084[1][2], _e1084[0][2], (_e1084[0][2] > _e1084[1][2]));
                                                            let _e1184 = ((select(_e1084[2][0], _e1159, (_e1159 < _e1084[2][0])) - _e421) * _e426);
                                                            let _e1185 = ((select(_e1084[2][0], _e1163, (_e1163 > _e1084[2][0])) - _e422) * _e426);
                                                            let _e1188 = ((select(_e1084[2][1], _e1167, (_e1167 < _e1084[2][1])) - _e457) * _e462);
                                                            let _e1189 = ((select(_e1084[2][1], _e1171, (_e1171 > _e1084[2][1])) - _e458) * _e462);
                                                            let _e1192 = ((select(_e1084[2][2], _e1175, (_e1175 < _e1084[2][2])) - _e493) * _e498);
                                                            let _e1193 = ((select(_e1084[2][2], _e1179, (_e1179 > _e1084[2][2])) - _e494) * _e498);
                                                            let _e1195 = select(_e1193, _e1192, (_e1192 < _e1193));
                                                            let _e1197 = select(_e1193, _e1192, (_e1192 > _e1193));
                                                            let _e1199 = select(_e1185, _e1184, (_e1184 < _e1185));
                                                            let _e1201 = select(_e1189, _e1188, (_e1188 < _e1189));
                                                            let _e1203 = select(_e1201, _e1199, (_e1199 > _e1201));
                                                            let _e1205 = select(_e1195, _e1203, (_e1203 > _e1195));
                                                            let _e1207 = select(_e1185, _e1184, (_e1184 > _e1185));
                                                            let _e1209 = select(_e1189, _e1188, (_e1188 > _e1189));
                                                            let _e1211 = select(_e1209, _e1207, (_e1207 < _e1209));
                                                            let _e1213 = select(_e1197, _e1211, (_e1211 < _e1197));
                                                            let _e1214 = -(_e1195);
                                                            let _e1220 = select(_e544, _e1205, (_e1205 > _e544));
                                                            if (_e1220 > (_e1213 + (select(_e1214, _e1197, (_e1197 > _e1214)) * 0.0000019073523f))) {
                                                                phi_1892_ = type_22();
                                                                phi_1893_ = true;
                                                            } else {
                                                                let _e1222 = (_e1220 > _e948.member);
                                                                if _e1222 {
                                                                    phi_1891_ = type_22();
                                                                } else {
                                                                    let _e1226 = (_e1084[1][0] - _e1084[0][0]);
                                                                    let _e1227 = (_e1084[1][1] - _e1084[0][1]);
                                                                    let _e1228 = (_e1084[1][2] - _e1084[0][2]);
                                                                    let _e1229 = vec3<f32>(_e1226, _e1227, _e1228);
                                                                    let _e1230 = (_e1084[2][0] - _e1084[1][0]);
                                                                    let _e1231 = (_e1084[2][1] - _e1084[1][1]);
                                                                    let _e1232 = (_e1084[2][2] - _e1084[1][2]);
                                                                    let _e1233 = vec3<f32>(_e1230, _e1231, _e1232);
                                                                    let _e1234 = (_e1084[0][0] - _e1084[2][0]);
                                                                    let _e1235 = (_e1084[0][1] - _e1084[2][1]);
                                                                    let _e1236 = (_e1084[0][2] - _e1084[2][2]);
                                                                    let _e1237 = vec3<f32>(_e1234, _e1235, _e1236);
                                                                    let _e1240 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                    let _e1243 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                    let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                                                                    let _e1248 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                    let _e1250 = select(_e1248, _e1245, (_e1245 > _e1248));
                                                                    let _e1253 = bitcast<f32>((bitcast<u32>(_e1230) & 2147483647u));
                                                                    let _e1256 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                    let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                                    let _e1261 = bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u));
                                                                    let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                    let _e1266 = bitcast<f32>((bitcast<u32>(_e1234) & 2147483647u));
                                                                    let _e1269 = bitcast<f32>((bitcast<u32>(_e1235) & 2147483647u));
                                                                    let _e1271 = select(_e1269, _e1266, (_e1266 > _e1269));
                                                                    let _e1274 = bitcast<f32>((bitcast<u32>(_e1236) & 2147483647u));
                                                                    let _e1276 = select(_e1274, _e1271, (_e1271 > _e1274));
                                                                    let _e1278 = select(_e1263, _e1250, (_e1250 > _e1263));
                                                                    let _e1280 = select(_e1276, _e1278, (_e1278 > _e1276));
                                                                    if (_e1250 == _e1280) {
                                                                        phi_1802_ = _e1233;
                                                                        phi_1803_ = _e1237;
                                                                    } else {
                                                                        let _e1283 = vec3((_e1263 == _e1280));
                                                                        phi_1802_ = select(_e1229, _e1237, _e1283);
                                                                        phi_1803_ = select(_e1233, _e1229, _e1283);
                                                                    }
                                                                    let _e1287 = phi_1802_;
                                                                    let _e1289 = phi_1803_;
                                                                    let _e1296 = ((_e1287.y * _e1289.z) - (_e1289.y * _e1287.z));
                                                                    let _e1301 = ((_e1287.z * _e1289.x) - (_e1289.z * _e1287.x));
                                                                    let _e1304 = ((_e1287.x * _e1289.y) - (_e1289.x * _e1287.y));
                                                                    if (_e1146 >= _e1150) {
                                                                        phi_1834_ = select(true, false, (_e1146 >= _e1154));
                                                                    } else {
                                                                        phi_1834_ = true;
                                                                    }
                                                                    let _e1309 = phi_1834_;
                                                                    if _e1309 {
                                                                        phi_1843_ = select(vec3<f32>(_e1084[2][0], _e1084[2][1], _e1084[2][2]), vec3<f32>(_e1084[1][0], _e1084[1][1], _e1084[1][2]), vec3((_e1150 >= _e1154)));
                                                                    } else {
                                                                        phi_1843_ = vec3<f32>(_e1084[0][0], _e1084[0][1], _e1084[0][2]);
                                                                    }
                                                                    let _e1314 = phi_1843_;
                                                                    let _e1331 = ((((_e1296 * (_e1314.x - _e398)) + (_e1301 * (_e1314.y - _e435))) + (_e1304 * (_e1314.z - _e471))) / (((_e1296 * _e423) + (_e1301 * _e459)) + (_e1304 * _e495)));
                                                                    let _e1333 = select(_e1213, _e1331, (_e1331 < _e1213));
                                                                    let _e1335 = select(_e1205, _e1333, (_e1333 > _e1205));
                                                                    if (_e1335 >= _e544) {
                                                                        let _e1337 = (_e1335 <= _e948.member);
                                                                        if _e1337 {
                                                                            let _e1338 = (1f / _e1156);
                                                                            phi_1883_ = type_22(_e1335, (_e1150 * _e1338), (_e1154 * _e1338), _e986);
                                                                        } else {
                                                                            phi_1883_ = type_22();
                                                                        }
                                                                        let _e1343 = phi_1883_;
                                                                        phi_1885_ = _e1343;
                                                                        phi_1886_ = select(true, false, _e1337);
                                                                    } else {
                                                                        phi_1885_ = type_22();
                                                                        phi_1886_ = true;
                                                                    }
                                                                    let _e1346 = phi_1885_;
                                                                    let _e1348 = phi_1886_;
                                                                    if _e1348 {
                                                                        phi_1890_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1890_ = _e1346;
                                                                    }
                                                                    let _e1350 = phi_1890_;
                                                                    phi_1891_ = _e1350;
                                                                }
                                                                let _e1352 = phi_1891_;
                                                                phi_1892_ = _e1352;
                                                                phi_1893_ = _e1222;
                                                            }
                                                            let _e1354 = phi_1892_;
                                                            let _e1356 = phi_1893_;
                                                            phi_1897_ = _e1354;
                                                            phi_1898_ = _e1356;
                                                        }
                                                        let _e1358 = phi_1897_;
                                                        let _e1360 = phi_1898_;
                                                        phi_1902_ = _e1358;
                                                        phi_1903_ = _e1360;
                                                    } else {
                                                        phi_1902_ = type_22();
                                                        phi_1903_ = true;
                                                    }
                                                    let _e1362 = phi_1902_;
                                                    let _e1364 = phi_1903_;
                                                    if _e1364 {
                                                        phi_1907_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1907_ = _e1362;
                                                    }
                                                    let _e1366 = phi_1907_;
                                                    if (_e1366.member_3 != 4294967295u) {
                                                        if (_e986 == _e161) {
                                                            phi_2236_ = false;
                                                        } else {
                                                            let _e1370 = (_e986 < arrayLength((&global_5.member)));
                                                            if _e1370 {
                                                                if _e1370 {
                                                                } else {
                                                                    phi_3364_ = true;
                                                                    break;
                                                                }
                                                                let _e1372 = global_5.member[_e986];
                                                                phi_1930_ = _e1372;
                                                            } else {
                                                                phi_1930_ = 4294967295u;
                                                            }
                                                            let _e1374 = phi_1930_;
                                                            let _e1375 = (_e1374 < arrayLength((&global_6.member)));
                                                            if _e1375 {
                                                                if _e1375 {
                                                                } else {
                                                                    phi_3364_ = true;
                                                                    break;
                                                                }
                                                                let _e1377 = global_6.member[_e1374];
                                                                phi_1944_ = _e1377;
                                                            } else {
                                                                phi_1944_ = 0i;
                                                            }
                                                            let _e1379 = phi_1944_;
                                                            let _e1380 = (_e1379 == 0i);
                                                            if _e1380 {
                                                                phi_2235_ = true;
                                                            } else {
                                                                if _e390 {
                                                                    phi_1965_ = vec3<f32>(_e1084[0][0], _e1084[0][1], _e1084[0][2]);
                                                                } else {
                                                                    if (_e366 == 1u) {
                                                                        phi_1964_ = vec3<f32>(_e1084[0][2], _e1084[0][0], _e1084[0][1]);
                                                                    } else {
                                                                        phi_1964_ = vec3<f32>(_e1084[0][1], _e1084[0][2], _e1084[0][0]);
                                                                    }
                                                                    let _e1385 = phi_1964_;
                                                                    phi_1965_ = _e1385;
                                                                }
                                                                let _e1388 = phi_1965_;
                                                                if _e390 {
                                                                    phi_1982_ = vec3<f32>(_e1084[1][0], _e1084[1][1], _e1084[1][2]);
                                                                } else {
                                                                    if (_e366 == 1u) {
                                                                        phi_1981_ = vec3<f32>(_e1084[1][2], _e1084[1][0], _e1084[1][1]);
                                                                    } else {
                                                                        phi_1981_ = vec3<f32>(_e1084[1][1], _e1084[1][2], _e1084[1][0]);
                                                                    }
                                                                    let _e1393 = phi_1981_;
                                                                    phi_1982_ = _e1393;
                                                                }
                                                                let _e1396 = phi_1982_;
                                                                if _e390 {
                                                                    phi_1999_ = vec3<f32>(_e1084[2][0], _e1084[2][1], _e1084[2][2]);
                                                                } else {
                                                                    if (_e366 == 1u) {
                                                                        phi_1998_ = vec3<f32>(_e1084[2][2], _e1084[2][0], _e1084[2][1]);
                                                                    } else {
                                                                        phi_1998_ = vec3<f32>(_e1084[2][1], _e1084[2][2], _e1084[2][0]);
                                                                    }
                                                                    let _e1401 = phi_1998_;
                                                                    phi_1999_ = _e1401;
                                                                }
                                                                let _e1404 = phi_1999_;
                                                                let _e1407 = (_e1396.x - _e1388.x);
                                                                let _e1410 = (_e1396.y - _e1388.y);
                                                                let _e1413 = (_e1396.z - _e1388.z);
                                                                let _e1415 = (_e1404.x - _e1388.x);
                                                                let _e1417 = (_e1404.y - _e1388.y);
                                                                let _e1419 = (_e1404.z - _e1388.z);
                                                                if (_e233.member_1 == 1u) {
                                                                    phi_2035_ = (vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]) - _e1388);
                                                                } else {
                                                                    phi_2035_ = vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]);
                                                                }
                                                                let _e1434 = phi_2035_;
                                                                let _e1440 = bitcast<f32>((bitcast<u32>((_e1407 * _e1417)) ^ _e233.member_3[0]));
                                                                let _e1444 = bitcast<f32>((bitcast<u32>((_e1410 * _e1415)) ^ _e233.member_3[0]));
                                                                let _e1448 = bitcast<f32>((bitcast<u32>((_e1410 * _e1419)) ^ _e233.member_3[0]));
                                                                let _e1452 = bitcast<f32>((bitcast<u32>((_e1413 * _e1417)) ^ _e233.member_3[0]));
                                                                let _e1456 = bitcast<f32>((bitcast<u32>((_e1413 * _e1415)) ^ _e233.member_3[0]));
                                                                let _e1460 = bitcast<f32>((bitcast<u32>((_e1407 * _e1419)) ^ _e233.member_3[0]));
                                                                let _e1461 = (_e1448 - _e1452);
                                                                let _e1462 = (_e1456 - _e1460);
                                                                let _e1463 = (_e1440 - _e1444);
                                                                let _e1487 = (bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u)));
                                                                let _e1494 = (bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1460) & 2147483647u)));
                                                                let _e1501 = (bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u)));
                                                                if (_e233.member_2 == 0f) {
                                                                    phi_2217_ = 0f;
                                                                } else {
                                                                    let _e1531 = bitcast<f32>((bitcast<u32>(_e1461) & 2147483647u));
                                                                    let _e1534 = bitcast<f32>((bitcast<u32>(_e1462) & 2147483647u));
                                                                    let _e1537 = bitcast<f32>((bitcast<u32>(_e1463) & 2147483647u));
                                                                    let _e1539 = select(_e1537, _e1534, (_e1534 > _e1537));
                                                                    let _e1543 = select(_e1537, _e1534, (_e1534 < _e1537));
                                                                    let _e1547 = select(_e1534, _e1531, (_e1531 < _e1534));
                                                                    let _e1549 = select(_e1534, _e1531, (_e1531 > _e1534));
                                                                    let _e1551 = select(_e1537, _e1549, (_e1549 < _e1537));
                                                                    phi_2217_ = bitcast<f32>((bitcast<u32>((_e233.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1539, _e1531, (_e1531 > _e1539)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1551, _e1547, (_e1547 > _e1551)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1543, _e1531, (_e1531 < _e1543)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1487 + _e1494) + _e1501))) ^ _e233.member_3[0]))) * 1.0000005f)) ^ _e233.member_3[0])))) ^ _e233.member_3[0]));
                                                                }
                                                                let _e1578 = phi_2217_;
                                                                phi_2235_ = (_e1380 || !(((((bitcast<f32>((bitcast<u32>((_e1434.x * _e1461)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1434.y * _e1462)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1434.z * _e1463)) ^ _e233.member_3[0]))) * f32(-(_e1379))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1434.x) & 2147483647u)) * _e1487)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1434.y) & 2147483647u)) * _e1494)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1434.z) & 2147483647u)) * _e1501)) ^ _e233.member_3[0]))))) ^ _e233.member_3[0])) + _e1578) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1592 = phi_2235_;
                                                            phi_2236_ = _e1592;
                                                        }
                                                        let _e1594 = phi_2236_;
                                                        if _e1594 {
                                                            phi_2241_ = type_40(_e948.member, true);
                                                        } else {
                                                            phi_2241_ = _e948;
                                                        }
                                                        let _e1599 = phi_2241_;
                                                        phi_2242_ = _e1599;
                                                    } else {
                                                        phi_2242_ = _e948;
                                                    }
                                                    let _e1601 = phi_2242_;
                                                    phi_3365_ = _e1083;
                                                    phi_1079_ = _e1601;
                                                } else {
                                                    phi_3365_ = _e946;
                                                    phi_1079_ = type_40();
                                                }
                                                let _e1603 = phi_3365_;
                                                let _e1605 = phi_1079_;
                                                continue;
                                                continuing {
                                                    phi_3359_ = _e1603;
                                                    phi_1078_ = _e1605;
                                                    phi_1081_ = _e963;
                                                    phi_3364_ = _e1603;
                                                    break if !(_e969);
                                                }
                                            }
                                            let _e1608 = phi_3364_;
                                            phi_3440_ = _e1608;
                                            if _e1608 {
                                                break;
                                            }
                                            let _e1610 = local_23;
                                            phi_3444_ = _e1608;
                                            let _e1810 = local_25;
                                            phi_3125_ = _e1810;
                                            phi_3126_ = _e617;
                                            phi_3127_ = false;
                                            phi_3128_ = select(_e621, 0u, _e1610.member_1);
                                        } else {
                                            local_10 = array<f32, 3>(_e617.member.member[0], _e617.member.member[1], _e617.member.member[2]);
                                            local_9 = array<f32, 3>(_e617.member.member_1[0], _e617.member.member_1[1], _e617.member.member_1[2]);
                                            let _e641 = (_e617.member_1 < _e101);
                                            if _e641 {
                                                if _e641 {
                                                } else {
                                                    phi_3440_ = true;
                                                    break;
                                                }
                                                let _e643 = global_9.member[_e617.member_1];
                                                phi_2277_ = _e643;
                                            } else {
                                                phi_2277_ = type_49(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e645 = phi_2277_;
                                            let _e647 = array<u32, 3>(_e366, _e365, _e367);
                                            local_17 = _e647;
                                            local_13 = array<f32, 3>(0f, 0f, 0f);
                                            local_12 = array<f32, 3>(0f, 0f, 0f);
                                            phi_2286_ = type_8(0u, 3u);
                                            loop {
                                                let _e649 = phi_2286_;
                                                if (_e649.member < _e649.member_1) {
                                                    phi_2287_ = type_8((_e649.member + 1u), _e649.member_1);
                                                    phi_2310_ = type_8(1u, _e649.member);
                                                } else {
                                                    phi_2287_ = _e649;
                                                    phi_2310_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e662 = phi_2287_;
                                                let _e664 = phi_2310_;
                                                let _e668 = (bitcast<i32>(_e664.member) != 0i);
                                                if _e668 {
                                                    let _e669 = (_e664.member_1 < 3u);
                                                    if _e669 {
                                                    } else {
                                                        phi_3275_ = true;
                                                        break;
                                                    }
                                                    let _e671 = local_17[_e664.member_1];
                                                    if _e669 {
                                                    } else {
                                                        phi_3275_ = true;
                                                        break;
                                                    }
                                                    let _e673 = local_10[_e664.member_1];
                                                    if _e669 {
                                                    } else {
                                                        phi_3275_ = true;
                                                        break;
                                                    }
                                                    let _e675 = local_9[_e664.member_1];
                                                    let _e678 = ((10u * _e671) & 31u);
                                                    let _e681 = ((_e645.member[0] >> bitcast<u32>(_e678)) & 1023u);
                                                    let _e686 = bitcast<f32>((bitcast<u32>(((_e675 - _e673) * 0.0009775171f)) ^ _e144));
                                                    let _e692 = (_e673 + bitcast<f32>((bitcast<u32>((f32(_e681) * _e686)) ^ _e144)));
                                                    if _e669 {
                                                    } else {
                                                        phi_3275_ = true;
                                                        break;
                                                    }
                                                    local_13[_e664.member_1] = select(select(_e675, _e692, (_e692 < _e675)), _e675, (_e681 == 1023u));
                                                    let _e701 = ((_e645.member[1] >> bitcast<u32>(_e678)) & 1023u);
                                                    let _e707 = (_e673 + bitcast<f32>((bitcast<u32>((f32(_e701) * _e686)) ^ _e144)));
                                                    if _e669 {
                                                    } else {
                                                        phi_3275_ = true;
                                                        break;
                                                    }
                                                    local_12[_e664.member_1] = select(select(_e675, _e707, (_e707 < _e675)), _e675, (_e701 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_2286_ = _e662;
                                                    phi_3275_ = _e576;
                                                    break if !(_e668);
                                                }
                                            }
                                            let _e715 = phi_3275_;
                                            phi_3440_ = _e715;
                                            if _e715 {
                                                break;
                                            }
                                            let _e716 = local_12;
                                            let _e717 = local_13;
                                            local_16 = _e647;
                                            local_15 = array<f32, 3>(0f, 0f, 0f);
                                            local_14 = array<f32, 3>(0f, 0f, 0f);
                                            phi_2440_ = type_8(0u, 3u);
                                            loop {
                                                let _e726 = phi_2440_;
                                                if (_e726.member < _e726.member_1) {
                                                    phi_2441_ = type_8((_e726.member + 1u), _e726.member_1);
                                                    phi_2464_ = type_8(1u, _e726.member);
                                                } else {
                                                    phi_2441_ = _e726;
                                                    phi_2464_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e739 = phi_2441_;
                                                let _e741 = phi_2464_;
                                                let _e745 = (bitcast<i32>(_e741.member) != 0i);
                                                if _e745 {
                                                    let _e746 = (_e741.member_1 < 3u);
                                                    if _e746 {
                                                    } else {
                                                        phi_3342_ = true;
                                                        break;
                                                    }
                                                    let _e748 = local_16[_e741.member_1];
                                                    if _e746 {
                                                    } else {
                                                        phi_3342_ = true;
                                                        break;
                                                    }
                                                    let _e750 = local_10[_e741.member_1];
                                                    if _e746 {
                                                    } else {
                                                        phi_3342_ = true;
                                                        break;
                                                    }
                                                    let _e752 = local_9[_e741.member_1];
                                                    let _e755 = ((10u * _e748) & 31u);
                                                    let _e758 = ((_e645.member_1[0] >> bitcast<u32>(_e755)) & 1023u);
                                                    let _e763 = bitcast<f32>((bitcast<u32>(((_e752 - _e750) * 0.0009775171f)) ^ _e144));
                                                    let _e769 = (_e750 + bitcast<f32>((bitcast<u32>((f32(_e758) * _e763)) ^ _e144)));
                                                    if _e746 {
                                                    } else {
                                                        phi_3342_ = true;
                                                        break;
                                                    }
                                                    local_15[_e741.member_1] = select(select(_e752, _e769, (_e769 < _e752)), _e752, (_e758 == 1023u));
                                                    let _e778 = ((_e645.member_1[1] >> bitcast<u32>(_e755)) & 1023u);
                                                    let _e784 = (_e750 + bitcast<f32>((bitcast<u32>((f32(_e778) * _e763)) ^ _e144)));
                                                    if _e746 {
                                                    } else {
                                                        phi_3342_ = true;
                                                        break;
                                                    }
                                                    local_14[_e741.member_1] = select(select(_e752, _e784, (_e784 < _e752)), _e752, (_e778 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_2440_ = _e739;
                                                    phi_3342_ = _e715;
                                                    break if !(_e745);
                                                }
                                            }
                                            let _e792 = phi_3342_;
                                            phi_3440_ = _e792;
                                            if _e792 {
                                                break;
                                            }
                                            let _e793 = local_14;
                                            let _e794 = local_15;
                                            let _e805 = type_63(type_55(array<f32, 3>(_e717[0], _e717[1], _e717[2]), array<f32, 3>(_e716[0], _e716[1], _e716[2])), _e645.member_2);
                                            let _e810 = type_63(type_55(array<f32, 3>(_e794[0], _e794[1], _e794[2]), array<f32, 3>(_e793[0], _e793[1], _e793[2])), _e645.member_3);
                                            let _e816 = ((_e717[0] - _e421) * _e426);
                                            let _e817 = ((_e794[0] - _e421) * _e426);
                                            let _e818 = ((_e716[0] - _e422) * _e426);
                                            let _e819 = ((_e793[0] - _e422) * _e426);
                                            let _e824 = ((_e717[1] - _e457) * _e462);
                                            let _e825 = ((_e794[1] - _e457) * _e462);
                                            let _e826 = ((_e716[1] - _e458) * _e462);
                                            let _e827 = ((_e793[1] - _e458) * _e462);
                                            let _e832 = ((_e717[2] - _e493) * _e498);
                                            let _e833 = ((_e794[2] - _e493) * _e498);
                                            let _e834 = ((_e716[2] - _e494) * _e498);
                                            let _e835 = ((_e793[2] - _e494) * _e498);
                                            let _e837 = select(_e834, _e832, (_e832 < _e834));
                                            let _e839 = select(_e835, _e833, (_e833 < _e835));
                                            let _e841 = select(_e834, _e832, (_e832 > _e834));
                                            let _e843 = select(_e835, _e833, (_e833 > _e835));
                                            let _e845 = select(_e818, _e816, (_e816 < _e818));
                                            let _e847 = select(_e819, _e817, (_e817 < _e819));
                                            let _e849 = select(_e826, _e824, (_e824 < _e826));
                                            let _e851 = select(_e827, _e825, (_e825 < _e827));
                                            let _e853 = select(_e849, _e845, (_e845 > _e849));
                                            let _e855 = select(_e851, _e847, (_e847 > _e851));
                                            let _e857 = select(_e837, _e853, (_e853 > _e837));
                                            let _e859 = select(_e839, _e855, (_e855 > _e839));
                                            let _e861 = select(_e818, _e816, (_e816 > _e818));
                                            let _e863 = select(_e819, _e817, (_e817 > _e819));
                                            let _e865 = select(_e826, _e824, (_e824 > _e826));
                                            let _e867 = select(_e827, _e825, (_e825 > _e827));
                                            let _e869 = select(_e865, _e861, (_e861 < _e865));
                                            let _e871 = select(_e867, _e863, (_e863 < _e867));
                                            let _e876 = -(_e837);
                                            let _e877 = -(_e839);
                                            let _e884 = (select(_e841, _e869, (_e869 < _e841)) + (select(_e876, _e841, (_e841 > _e876)) * 0.0000019073523f));
                                            let _e885 = (select(_e843, _e871, (_e871 < _e843)) + (select(_e877, _e843, (_e843 > _e877)) * 0.0000019073523f));
                                            let _e887 = select(_e544, _e857, (_e857 > _e544));
                                            let _e889 = select(_e544, _e859, (_e859 > _e544));
                                            let _e894 = (_e887 <= select(_e578.member, _e884, (_e884 < _e578.member)));
                                            let _e895 = (_e889 <= select(_e578.member, _e885, (_e885 < _e578.member)));
                                            let _e896 = (_e887 <= _e889);
                                            if _e894 {
                                                if _e895 {
                                                    if _e896 {
                                                        phi_3027_ = _e810;
                                                    } else {
                                                        phi_3027_ = _e805;
                                                    }
                                                    let _e898 = phi_3027_;
                                                    let _e906 = (_e621 % 128u);
                                                    let _e907 = (_e906 < 128u);
                                                    if _e907 {
                                                    } else {
                                                        phi_3440_ = true;
                                                        break;
                                                    }
                                                    local_6[_e906] = _e898.member_1;
                                                    if _e907 {
                                                    } else {
                                                        phi_3440_ = true;
                                                        break;
                                                    }
                                                    local_5[_e906] = _e898.member.member[0];
                                                    if _e907 {
                                                    } else {
                                                        phi_3440_ = true;
                                                        break;
                                                    }
                                                    local_4[_e906] = _e898.member.member[1];
                                                    if _e907 {
                                                    } else {
                                                        phi_3440_ = true;
                                                        break;
                                                    }
                                                    local_3[_e906] = _e898.member.member[2];
                                                    if _e907 {
                                                    } else {
                                                        phi_3440_ = true;
                                                        break;
                                                    }
                                                    local_2[_e906] = _e898.member.member_1[0];
                                                    if _e907 {
                                                    } else {
                                                        phi_3440_ = true;
                                                        break;
                                                    }
                                                    local_1[_e906] = _e898.member.member_1[1];
                                                    if _e907 {
                                                    } else {
                                                        phi_3440_ = true;
                                                        break;
                                                    }
                                                    local[_e906] = _e898.member.member_1[2];
                                                    if _e907 {
                                                    } else {
                                                        phi_3440_ = true;
                                                        break;
                                                    }
                                                    local_11[_e906] = select(_e889, _e887, (_e887 > _e889));
                                                    if _e896 {
                                                        phi_3104_ = _e805;
                                                    } else {
                                                        phi_3104_ = _e810;
                                                    }
                                                    let _e924 = phi_3104_;
                                                    phi_3105_ = _e924;
                                                    phi_3106_ = (_e621 + 1u);
                                                } else {
                                                    phi_3105_ = type_63();
                                                    phi_3106_ = u32();
                                                }
                                                let _e926 = phi_3105_;
                                                let _e928 = phi_3106_;
                                                phi_3108_ = _e926;
                                                phi_3109_ = _e928;
                                                phi_3110_ = select(true, false, _e895);
                                            } else {
                                                phi_3108_ = type_63();
                                                phi_3109_ = u32();
                                                phi_3110_ = true;
                                            }
                                            let _e931 = phi_3108_;
                                            let _e933 = phi_3109_;
                                            let _e935 = phi_3110_;
                                            if _e935 {
                                                if _e894 {
                                                    phi_3117_ = _e805;
                                                } else {
                                                    phi_3117_ = _e810;
                                                }
                                                let _e937 = phi_3117_;
                                                phi_3122_ = _e937;
                                                phi_3123_ = select(_e895, true, _e894);
                                            } else {
                                                phi_3122_ = _e931;
                                                phi_3123_ = _e619;
                                            }
                                            let _e940 = phi_3122_;
                                            let _e942 = phi_3123_;
                                            phi_3444_ = _e792;
                                            phi_3125_ = _e578;
                                            phi_3126_ = _e940;
                                            phi_3127_ = _e942;
                                            phi_3128_ = select(_e933, _e621, _e935);
                                        }
                                        let _e1614 = phi_3444_;
                                        let _e1616 = phi_3125_;
                                        let _e1618 = phi_3126_;
                                        let _e1620 = phi_3127_;
                                        let _e1622 = phi_3128_;
                                        phi_3443_ = _e1614;
                                        phi_3129_ = _e1616;
                                        phi_3130_ = _e1618;
                                        phi_3131_ = (_e582 - 1u);
                                        phi_3132_ = _e1620;
                                        phi_3133_ = _e1622;
                                    } else {
                                        phi_3443_ = _e576;
                                        phi_3129_ = _e578;
                                        phi_3130_ = _e617;
                                        phi_3131_ = _e582;
                                        phi_3132_ = _e619;
                                        phi_3133_ = _e621;
                                    }
                                    let _e1624 = phi_3443_;
                                    let _e1626 = phi_3129_;
                                    let _e1628 = phi_3130_;
                                    let _e1630 = phi_3131_;
                                    let _e1632 = phi_3132_;
                                    let _e1634 = phi_3133_;
                                    phi_3442_ = _e1624;
                                    phi_3134_ = _e1626;
                                    phi_3135_ = _e1628;
                                    phi_3136_ = _e1630;
                                    phi_3137_ = _e1632;
                                    phi_3138_ = _e1634;
                                } else {
                                    phi_3442_ = _e576;
                                    phi_3134_ = type_40();
                                    phi_3135_ = type_63();
                                    phi_3136_ = u32();
                                    phi_3137_ = bool();
                                    phi_3138_ = u32();
                                }
                                let _e1636 = phi_3442_;
                                let _e1638 = phi_3134_;
                                let _e1640 = phi_3135_;
                                let _e1642 = phi_3136_;
                                let _e1644 = phi_3137_;
                                let _e1646 = phi_3138_;
                                phi_3441_ = _e1636;
                                phi_952_ = _e1638;
                                phi_955_ = _e1640;
                                phi_957_ = _e1642;
                                phi_959_ = _e1644;
                                phi_961_ = _e1646;
                                phi_3139_ = _e590;
                            } else {
                                phi_3441_ = _e576;
                                phi_952_ = type_40();
                                phi_955_ = type_63();
                                phi_957_ = u32();
                                phi_959_ = bool();
                                phi_961_ = u32();
                                phi_3139_ = false;
                            }
                            let _e1648 = phi_3441_;
                            let _e1650 = phi_952_;
                            let _e1652 = phi_955_;
                            let _e1654 = phi_957_;
                            let _e1656 = phi_959_;
                            let _e1658 = phi_961_;
                            let _e1660 = phi_3139_;
                            continue;
                            continuing {
                                phi_3282_ = _e1648;
                                phi_951_ = _e1650;
                                phi_954_ = _e1652;
                                phi_956_ = _e1654;
                                phi_958_ = _e1656;
                                phi_960_ = _e1658;
                                phi_3440_ = _e1648;
                                break if !(_e1660);
                            }
                        }
                        let _e1663 = phi_3440_;
                        if _e1663 {
                            break;
                        }
                        let _e1665 = local_24;
                        if _e1665.member_1 {
                        } else {
                            if _e234 {
                            } else {
                                break;
                            }
                            let _e1669 = global_2.member[_e148];
                            if _e155 {
                            } else {
                                break;
                            }
                            let _e1673 = global_8.member[_e148].member_1;
                            if _e234 {
                            } else {
                                break;
                            }
                            global_2.member[_e148] = type_24(_e1669.member, _e1669.member_1, _e1669.member_2, array<f32, 3>((_e1669.member_3[0] + (_e1673[0] * _e1669.member_1[0])), (_e1669.member_3[1] + (_e1673[1] * _e1669.member_1[1])), (_e1669.member_3[2] + (_e1673[2] * _e1669.member_1[2]))), _e1669.member_4);
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
