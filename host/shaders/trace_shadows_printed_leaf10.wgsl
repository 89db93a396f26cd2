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

struct type_39 {
    member: f32,
    member_1: bool,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<i32>,
}

struct type_48 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_53 {
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
    member: type_53,
    member_1: u32,
}

struct type_71 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_26;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
@group(0) @binding(2) 
var<uniform> global_4: type_41;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_44;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_71;
@group(0) @binding(7) 
var<storage> global_8: type_32;
@group(0) @binding(3) 
var<storage> global_9: type_50;
@group(0) @binding(4) 
var<storage> global_10: type_58;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<f32, 128>;
    var local_5: array<type_62, 128>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<u32, 3>;
    var local_11: array<u32, 3>;
    var local_12: array<u32, 3>;
    var local_13: array<array<f32, 3>, 3>;
    var local_14: array<u32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<f32, 3>;
    var phi_287_: u32;
    var phi_352_: type_36;
    var phi_502_: i32;
    var phi_503_: i32;
    var phi_513_: bool;
    var phi_523_: u32;
    var phi_524_: u32;
    var phi_526_: bool;
    var phi_531_: u32;
    var phi_576_: f32;
    var phi_582_: f32;
    var phi_593_: f32;
    var phi_599_: f32;
    var phi_622_: f32;
    var phi_633_: f32;
    var phi_642_: f32;
    var phi_648_: f32;
    var phi_659_: f32;
    var phi_665_: f32;
    var phi_688_: f32;
    var phi_699_: f32;
    var phi_708_: f32;
    var phi_714_: f32;
    var phi_725_: f32;
    var phi_731_: f32;
    var phi_754_: f32;
    var phi_765_: f32;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_5232_: bool;
    var phi_2994_: type_39;
    var phi_2997_: type_62;
    var phi_2999_: u32;
    var phi_3001_: bool;
    var phi_3003_: u32;
    var phi_3014_: bool;
    var phi_3059_: type_62;
    var phi_3060_: bool;
    var phi_3061_: u32;
    var phi_4279_: type_48;
    var phi_4288_: type_8;
    var phi_4289_: type_8;
    var phi_4312_: type_8;
    var phi_5225_: bool;
    var phi_4442_: type_8;
    var phi_4443_: type_8;
    var phi_4466_: type_8;
    var phi_5286_: bool;
    var phi_5029_: type_62;
    var phi_5068_: type_62;
    var phi_5069_: type_62;
    var phi_5070_: u32;
    var phi_5072_: type_62;
    var phi_5073_: u32;
    var phi_5074_: bool;
    var phi_5081_: type_62;
    var phi_5086_: type_62;
    var phi_5087_: bool;
    var phi_5303_: bool;
    var phi_3080_: type_39;
    var phi_3083_: type_8;
    var phi_3084_: type_8;
    var phi_3106_: type_8;
    var phi_3148_: u32;
    var phi_3172_: type_56;
    var phi_5299_: bool;
    var phi_3183_: type_8;
    var phi_3184_: type_8;
    var phi_3207_: type_8;
    var phi_3217_: type_8;
    var phi_3218_: type_8;
    var phi_3241_: type_8;
    var phi_5294_: bool;
    var phi_5307_: bool;
    var phi_5306_: bool;
    var phi_3804_: vec3<f32>;
    var phi_3805_: vec3<f32>;
    var phi_3836_: bool;
    var phi_3845_: vec3<f32>;
    var phi_3885_: type_22;
    var phi_3887_: type_22;
    var phi_3888_: bool;
    var phi_3892_: type_22;
    var phi_3893_: type_22;
    var phi_3894_: type_22;
    var phi_3895_: bool;
    var phi_3899_: type_22;
    var phi_3900_: bool;
    var phi_3904_: type_22;
    var phi_3905_: bool;
    var phi_3909_: type_22;
    var phi_3932_: u32;
    var phi_3946_: i32;
    var phi_3966_: vec3<f32>;
    var phi_3967_: vec3<f32>;
    var phi_3983_: vec3<f32>;
    var phi_3984_: vec3<f32>;
    var phi_4000_: vec3<f32>;
    var phi_4001_: vec3<f32>;
    var phi_4037_: vec3<f32>;
    var phi_4219_: f32;
    var phi_4237_: bool;
    var phi_4238_: bool;
    var phi_4243_: type_39;
    var phi_4244_: type_39;
    var phi_5309_: bool;
    var phi_3081_: type_39;
    var phi_5308_: bool;
    var local_17: type_39;
    var phi_5388_: bool;
    var phi_5089_: type_39;
    var phi_5090_: type_62;
    var phi_5091_: bool;
    var phi_5092_: u32;
    var phi_5387_: bool;
    var phi_5093_: type_39;
    var phi_5094_: type_62;
    var phi_5095_: u32;
    var phi_5096_: bool;
    var phi_5097_: u32;
    var phi_5386_: bool;
    var phi_5098_: type_39;
    var phi_5099_: type_62;
    var phi_5100_: u32;
    var phi_5101_: bool;
    var phi_5102_: u32;
    var phi_5385_: bool;
    var phi_2995_: type_39;
    var phi_2998_: type_62;
    var phi_3000_: u32;
    var phi_3002_: bool;
    var phi_3004_: u32;
    var phi_5103_: bool;
    var phi_5384_: bool;
    var local_18: type_39;
    var local_19: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e96 = arrayLength((&global_9.member));
            let _e111 = arrayLength((&global_7.member));
            let _e115 = global_4.member[0u][0u];
            let _e119 = global_4.member[0u][1u];
            let _e123 = global_4.member[0u][2u];
            let _e127 = global_4.member[1u][0u];
            let _e131 = global_4.member[1u][1u];
            let _e135 = global_4.member[1u][2u];
            let _e139 = global_4.member[1u][3u];
            let _e143 = (_e93.x + (_e93.y * 2097152u));
            let _e150 = (_e143 < arrayLength((&global_8.member)));
            if _e150 {
                if _e150 {
                } else {
                    break;
                }
                let _e154 = global_8.member[_e143].member_2;
                phi_287_ = _e154;
            } else {
                phi_287_ = 4294967295u;
            }
            let _e156 = phi_287_;
            let _e159 = global_1.member[0u];
            let _e163 = global_3.member[0u][0u];
            let _e167 = global_3.member[0u][1u];
            let _e171 = global_3.member[0u][2u];
            let _e175 = global_3.member[0u][3u];
            let _e179 = global_3.member[1u][0u];
            let _e183 = global_3.member[1u][1u];
            let _e187 = global_3.member[1u][2u];
            let _e191 = global_3.member[1u][3u];
            let _e192 = bitcast<f32>(_e163);
            let _e193 = bitcast<f32>(_e167);
            let _e194 = bitcast<f32>(_e171);
            let _e196 = bitcast<f32>(_e179);
            let _e197 = array<u32, 3>(_e183, _e187, _e191);
            let _e199 = bitcast<i32>(_e159);
            let _e200 = (_e199 / 2i);
            let _e205 = bitcast<f32>((bitcast<u32>((_e200 + 127i)) << bitcast<u32>(23i)));
            let _e211 = bitcast<f32>((bitcast<u32>(((_e199 - _e200) + 127i)) << bitcast<u32>(23i)));
            if (_e175 == 0u) {
                phi_352_ = type_36(array<f32, 3>(_e192, _e193, _e194), _e175, _e196, _e197);
            } else {
                phi_352_ = type_36(array<f32, 3>(((_e192 * _e205) * _e211), ((_e193 * _e205) * _e211), ((_e194 * _e205) * _e211)), _e175, ((_e196 * _e205) * _e211), _e197);
            }
            let _e224 = phi_352_;
            if _e150 {
                let _e225 = (_e143 < arrayLength((&global_2.member)));
                if _e225 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e230 = global_8.member[_e143].member.member_1;
                    let _e235 = global_8.member[_e143].member.member_3;
                    if (_e230 <= _e235) {
                        let _e237 = (1u < _e111);
                        if _e237 {
                            if (0u < _e111) {
                            } else {
                                break;
                            }
                            let _e241 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e241 + 1u) < _e241) {
                                if _e237 {
                                } else {
                                    break;
                                }
                                let _e246 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e150 {
                        } else {
                            break;
                        }
                        let _e256 = global_8.member[_e143].member.member_2[0u];
                        let _e258 = (bitcast<u32>(_e256) & 2147483647u);
                        let _e264 = global_8.member[_e143].member.member_2[1u];
                        let _e266 = (bitcast<u32>(_e264) & 2147483647u);
                        let _e272 = global_8.member[_e143].member.member_2[2u];
                        let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                        let _e280 = global_8.member[_e143].member.member[0u];
                        let _e282 = (bitcast<u32>(_e280) & 2147483647u);
                        let _e288 = global_8.member[_e143].member.member[1u];
                        let _e290 = (bitcast<u32>(_e288) & 2147483647u);
                        let _e296 = global_8.member[_e143].member.member[2u];
                        let _e298 = (bitcast<u32>(_e296) & 2147483647u);
                        let _e300 = select(_e266, _e258, (_e266 < _e258));
                        let _e302 = select(_e274, _e300, (_e274 < _e300));
                        let _e304 = select(_e282, _e302, (_e282 < _e302));
                        let _e306 = select(_e290, _e304, (_e290 < _e304));
                        let _e308 = select(_e298, _e306, (_e298 < _e306));
                        let _e310 = (bitcast<u32>(_e230) & 2147483647u);
                        let _e319 = (((select(_e310, _e308, (_e310 < _e308)) < 2139095040u) && ((bitcast<u32>(_e235) & 2147483647u) <= 2139095040u)) && (_e302 > 0u));
                        if _e319 {
                            let _e322 = (bitcast<u32>(bitcast<f32>(_e302)) & 2147483647u);
                            if (_e322 >= 8388608u) {
                                phi_502_ = (bitcast<i32>((_e322 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_502_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e322)), 32u, (_e322 == 0u))));
                            }
                            let _e336 = phi_502_;
                            phi_503_ = _e336;
                        } else {
                            phi_503_ = 0i;
                        }
                        let _e338 = phi_503_;
                        let _e339 = (_e258 == _e302);
                        if _e339 {
                            phi_513_ = true;
                        } else {
                            phi_513_ = (_e266 == _e302);
                        }
                        let _e342 = phi_513_;
                        let _e343 = select(1u, 0u, _e339);
                        if _e342 {
                            let _e344 = (_e343 + 1u);
                            phi_523_ = _e344;
                            phi_524_ = _e344;
                            phi_526_ = select(true, false, (_e344 == 2u));
                        } else {
                            phi_523_ = u32();
                            phi_524_ = 0u;
                            phi_526_ = true;
                        }
                        let _e348 = phi_523_;
                        let _e350 = phi_524_;
                        let _e352 = phi_526_;
                        if _e352 {
                            phi_531_ = (_e350 + 1u);
                        } else {
                            phi_531_ = 0u;
                        }
                        let _e356 = phi_531_;
                        let _e357 = select(_e348, _e350, _e352);
                        let _e358 = select(_e343, select(2u, _e343, _e342), _e352);
                        let _e359 = -(_e338);
                        let _e360 = (_e359 / 2i);
                        let _e365 = bitcast<f32>((bitcast<u32>((_e360 + 127i)) << bitcast<u32>(23i)));
                        let _e371 = bitcast<f32>((bitcast<u32>(((_e359 - _e360) + 127i)) << bitcast<u32>(23i)));
                        let _e376 = global_8.member[_e143].member.member;
                        let _e377 = (_e357 == 0u);
                        if _e377 {
                            phi_576_ = _e376[0];
                        } else {
                            phi_576_ = _e376[1];
                        }
                        let _e381 = phi_576_;
                        let _e382 = (_e357 == 2u);
                        if _e382 {
                            phi_582_ = _e376[2];
                        } else {
                            phi_582_ = _e381;
                        }
                        let _e385 = phi_582_;
                        let _e386 = global_8.member[_e143].member.member_2;
                        if _e377 {
                            phi_593_ = _e386[0];
                        } else {
                            phi_593_ = _e386[1];
                        }
                        let _e390 = phi_593_;
                        if _e382 {
                            phi_599_ = _e386[2];
                        } else {
                            phi_599_ = _e390;
                        }
                        let _e393 = phi_599_;
                        let _e395 = ((_e393 * _e365) * _e371);
                        let _e399 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e399 {
                            let _e403 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                            phi_622_ = select(0.00000000000011368684f, _e403, (_e403 > 0.00000000000011368684f));
                        } else {
                            phi_622_ = 0f;
                        }
                        let _e407 = phi_622_;
                        let _e408 = (_e385 + _e407);
                        let _e409 = (_e385 - _e407);
                        let _e410 = select(_e395, 0f, _e399);
                        if _e399 {
                            phi_633_ = 38685626000000000000000000f;
                        } else {
                            phi_633_ = (1f / _e395);
                        }
                        let _e413 = phi_633_;
                        let _e414 = (_e356 == 0u);
                        if _e414 {
                            phi_642_ = _e376[0];
                        } else {
                            phi_642_ = _e376[1];
                        }
                        let _e418 = phi_642_;
                        let _e419 = (_e356 == 2u);
                        if _e419 {
                            phi_648_ = _e376[2];
                        } else {
                            phi_648_ = _e418;
                        }
                        let _e422 = phi_648_;
                        if _e414 {
                            phi_659_ = _e386[0];
                        } else {
                            phi_659_ = _e386[1];
                        }
                        let _e426 = phi_659_;
                        if _e419 {
                            phi_665_ = _e386[2];
                        } else {
                            phi_665_ = _e426;
                        }
                        let _e429 = phi_665_;
                        let _e431 = ((_e429 * _e365) * _e371);
                        let _e435 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e435 {
                            let _e439 = (bitcast<f32>((bitcast<u32>(_e422) & 2147483647u)) * 0.00000011920929f);
                            phi_688_ = select(0.00000000000011368684f, _e439, (_e439 > 0.00000000000011368684f));
                        } else {
                            phi_688_ = 0f;
                        }
                        let _e443 = phi_688_;
                        let _e444 = (_e422 + _e443);
                        let _e445 = (_e422 - _e443);
                        let _e446 = select(_e431, 0f, _e435);
                        if _e435 {
                            phi_699_ = 38685626000000000000000000f;
                        } else {
                            phi_699_ = (1f / _e431);
                        }
                        let _e449 = phi_699_;
                        let _e450 = (_e358 == 0u);
                        if _e450 {
                            phi_708_ = _e376[0];
                        } else {
                            phi_708_ = _e376[1];
                        }
                        let _e454 = phi_708_;
                        let _e455 = (_e358 == 2u);
                        if _e455 {
                            phi_714_ = _e376[2];
                        } else {
                            phi_714_ = _e454;
                        }
                        let _e458 = phi_714_;
                        if _e450 {
                            phi_725_ = _e386[0];
                        } else {
                            phi_725_ = _e386[1];
                        }
                        let _e462 = phi_725_;
                        if _e455 {
                            phi_731_ = _e386[2];
                        } else {
                            phi_731_ = _e462;
                        }
                        let _e465 = phi_731_;
                        let _e467 = ((_e465 * _e365) * _e371);
                        let _e471 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e471 {
                            let _e475 = (bitcast<f32>((bitcast<u32>(_e458) & 2147483647u)) * 0.00000011920929f);
                            phi_754_ = select(0.00000000000011368684f, _e475, (_e475 > 0.00000000000011368684f));
                        } else {
                            phi_754_ = 0f;
                        }
                        let _e479 = phi_754_;
                        let _e480 = (_e458 + _e479);
                        let _e481 = (_e458 - _e479);
                        let _e482 = select(_e467, 0f, _e471);
                        if _e471 {
                            phi_765_ = 38685626000000000000000000f;
                        } else {
                            phi_765_ = (1f / _e467);
                        }
                        let _e485 = phi_765_;
                        let _e488 = bitcast<f32>((bitcast<u32>(_e385) & 2147483647u));
                        let _e491 = bitcast<f32>((bitcast<u32>(_e422) & 2147483647u));
                        let _e493 = select(_e491, _e488, (_e488 > _e491));
                        let _e496 = bitcast<f32>((bitcast<u32>(_e458) & 2147483647u));
                        if (_e319 && (select(_e496, _e493, (_e493 > _e496)) <= 1099511600000f)) {
                            let _e501 = (_e338 / 3i);
                            let _e508 = bitcast<f32>((bitcast<u32>((_e501 + 127i)) << bitcast<u32>(23i)));
                            let _e515 = bitcast<f32>((bitcast<u32>(((_e338 - (2i * _e501)) + 127i)) << bitcast<u32>(23i)));
                            let _e516 = (((_e230 * _e508) * _e508) * _e515);
                            let _e518 = select(340282350000000000000000000000000000000f, _e516, (_e516 < 340282350000000000000000000000000000000f));
                            let _e523 = (((_e235 * _e508) * _e508) * _e515);
                            let _e525 = select(340282350000000000000000000000000000000f, _e523, (_e523 < 340282350000000000000000000000000000000f));
                            phi_865_ = select(-340282350000000000000000000000000000000f, _e525, (_e525 > -340282350000000000000000000000000000000f));
                            phi_866_ = select(-340282350000000000000000000000000000000f, _e518, (_e518 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_865_ = 0f;
                            phi_866_ = 1f;
                        }
                        let _e529 = phi_865_;
                        let _e531 = phi_866_;
                        local_5 = array<type_62, 128>(type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_16 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                        let _e536 = (_e357 % 3u);
                        let _e537 = (_e536 < 3u);
                        if _e537 {
                        } else {
                            break;
                        }
                        let _e539 = local_16[_e536];
                        let _e540 = (_e356 % 3u);
                        let _e541 = (_e540 < 3u);
                        if _e541 {
                        } else {
                            break;
                        }
                        let _e543 = local_16[_e540];
                        let _e544 = (_e358 % 3u);
                        let _e545 = (_e544 < 3u);
                        if _e545 {
                        } else {
                            break;
                        }
                        let _e547 = local_16[_e544];
                        local_15 = array<f32, 3>(bitcast<f32>(_e127), bitcast<f32>(_e131), bitcast<f32>(_e135));
                        if _e537 {
                        } else {
                            break;
                        }
                        let _e551 = local_15[_e536];
                        if _e541 {
                        } else {
                            break;
                        }
                        let _e553 = local_15[_e540];
                        if _e545 {
                        } else {
                            break;
                        }
                        let _e555 = local_15[_e544];
                        phi_5232_ = false;
                        phi_2994_ = type_39(_e529, false);
                        phi_2997_ = type_62(type_53(array<f32, 3>(_e539, _e543, _e547), array<f32, 3>(_e551, _e553, _e555)), select(0u, 2147483648u, (_e96 == 0u)));
                        phi_2999_ = ((3u * _e96) + 1u);
                        phi_3001_ = (_e531 <= _e529);
                        phi_3003_ = 0u;
                        loop {
                            let _e563 = phi_5232_;
                            let _e565 = phi_2994_;
                            let _e567 = phi_2997_;
                            let _e569 = phi_2999_;
                            let _e571 = phi_3001_;
                            let _e573 = phi_3003_;
                            local_18 = _e565;
                            if _e571 {
                                phi_3014_ = true;
                            } else {
                                phi_3014_ = (_e573 > 0u);
                            }
                            let _e576 = phi_3014_;
                            if _e576 {
                                let _e577 = (_e569 > 0u);
                                if _e577 {
                                    if _e571 {
                                        phi_3059_ = _e567;
                                        phi_3060_ = _e571;
                                        phi_3061_ = _e573;
                                    } else {
                                        let _e578 = (_e573 - 1u);
                                        let _e579 = (_e578 % 128u);
                                        let _e580 = (_e579 < 128u);
                                        if _e580 {
                                        } else {
                                            phi_5384_ = true;
                                            break;
                                        }
                                        let _e582 = local_5[_e579];
                                        if _e580 {
                                        } else {
                                            phi_5384_ = true;
                                            break;
                                        }
                                        let _e598 = local_4[_e579];
                                        phi_3059_ = type_62(type_53(array<f32, 3>(_e582.member.member[0], _e582.member.member[1], _e582.member.member[2]), array<f32, 3>(_e582.member.member_1[0], _e582.member.member_1[1], _e582.member.member_1[2])), _e582.member_1);
                                        phi_3060_ = (_e598 <= _e565.member);
                                        phi_3061_ = _e578;
                                    }
                                    let _e602 = phi_3059_;
                                    let _e604 = phi_3060_;
                                    let _e606 = phi_3061_;
                                    if _e604 {
                                        if ((_e602.member_1 & 2147483648u) != 0u) {
                                            phi_5303_ = _e563;
                                            phi_3080_ = _e565;
                                            phi_3083_ = type_8(0u, ((_e602.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e928 = phi_5303_;
                                                let _e930 = phi_3080_;
                                                let _e932 = phi_3083_;
                                                local_17 = _e930;
                                                local_19 = _e930;
                                                if (_e932.member < _e932.member_1) {
                                                    phi_3084_ = type_8((_e932.member + 1u), _e932.member_1);
                                                    phi_3106_ = type_8(1u, _e932.member);
                                                } else {
                                                    phi_3084_ = _e932;
                                                    phi_3106_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e945 = phi_3084_;
                                                let _e947 = phi_3106_;
                                                let _e951 = (bitcast<i32>(_e947.member) != 0i);
                                                if _e951 {
                                                    local_1 = array<f32, 3>(_e602.member.member[0], _e602.member.member[1], _e602.member.member[2]);
                                                    local = array<f32, 3>(_e602.member.member_1[0], _e602.member.member_1[1], _e602.member.member_1[2]);
                                                    let _e962 = ((_e602.member_1 & 268435455u) + _e947.member_1);
                                                    let _e963 = (_e962 < arrayLength((&global_10.member)));
                                                    if _e963 {
                                                        if _e963 {
                                                        } else {
                                                            phi_5308_ = true;
                                                            break;
                                                        }
                                                        let _e966 = global_10.member[_e962].member_1;
                                                        phi_3148_ = _e966;
                                                    } else {
                                                        phi_3148_ = 4294967295u;
                                                    }
                                                    let _e968 = phi_3148_;
                                                    local_12 = array<u32, 3>(_e357, _e356, _e358);
                                                    if _e963 {
                                                        if _e963 {
                                                        } else {
                                                            phi_5308_ = true;
                                                            break;
                                                        }
                                                        let _e971 = global_10.member[_e962];
                                                        phi_3172_ = _e971;
                                                    } else {
                                                        phi_3172_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e973 = phi_3172_;
                                                    local_14 = array<u32, 3>(_e973.member[0], _e973.member[1], _e973.member[2]);
                                                    local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_5299_ = _e928;
                                                    phi_3183_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e983 = phi_5299_;
                                                        let _e985 = phi_3183_;
                                                        if (_e985.member < _e985.member_1) {
                                                            phi_3184_ = type_8((_e985.member + 1u), _e985.member_1);
                                                            phi_3207_ = type_8(1u, _e985.member);
                                                        } else {
                                                            phi_3184_ = _e985;
                                                            phi_3207_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e998 = phi_3184_;
                                                        let _e1000 = phi_3207_;
                                                        let _e1004 = (bitcast<i32>(_e1000.member) != 0i);
                                                        if _e1004 {
                                                            phi_3217_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1006 = phi_3217_;
                                                                if (_e1006.member < _e1006.member_1) {
                                                                    phi_3218_ = type_8((_e1006.member + 1u), _e1006.member_1);
                                                                    phi_3241_ = type_8(1u, _e1006.member);
                                                                } else {
                                                                    phi_3218_ = _e1006;
                                                                    phi_3241_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1019 = phi_3218_;
                                                                let _e1021 = phi_3241_;
                                                                let _e1025 = (bitcast<i32>(_e1021.member) != 0i);
                                                                if _e1025 {
                                                                    let _e1026 = (_e1000.member_1 < 3u);
                                                                    if _e1026 {
                                                                    } else {
                                                                        phi_5294_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1028 = local_14[_e1000.member_1];
                                                                    let _e1029 = (_e1021.member_1 < 3u);
                                                                    if _e1029 {
                                                                    } else {
                                                                        phi_5294_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1031 = local_12[_e1021.member_1];
                                                                    let _e1036 = ((_e1028 >> bitcast<u32>(((10u * _e1031) & 31u))) & 1023u);
                                                                    if _e1029 {
                                                                    } else {
                                                                        phi_5294_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1038 = local_1[_e1021.member_1];
                                                                    if _e1029 {
                                                                    } else {
                                                                        phi_5294_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1040 = local[_e1021.member_1];
                                                                    let _e1051 = (_e1038 + bitcast<f32>((bitcast<u32>((f32(_e1036) * bitcast<f32>((bitcast<u32>(((_e1040 - _e1038) * 0.0009775171f)) ^ _e139)))) ^ _e139)));
                                                                    if _e1026 {
                                                                    } else {
                                                                        phi_5294_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1029 {
                                                                    } else {
                                                                        phi_5294_ = true;
                                                                        break;
                                                                    }
                                                                    local_13[_e1000.member_1][_e1021.member_1] = select(select(_e1040, _e1051, (_e1051 < _e1040)), _e1040, (_e1036 == 1023u));
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_3217_ = _e1019;
                                                                    phi_5294_ = _e983;
                                                                    break if !(_e1025);
                                                                }
                                                            }
                                                            let _e1060 = phi_5294_;
                                                            phi_5306_ = _e1060;
                                                            if _e1060 {
                                                                break;
                                                            }
                                                            phi_5307_ = _e1060;
                                                        } else {
                                                            phi_5307_ = _e983;
                                                        }
                                                        let _e1062 = phi_5307_;
                                                        continue;
                                                        continuing {
                                                            phi_5299_ = _e1062;
                                                            phi_3183_ = _e998;
                                                            phi_5306_ = _e1062;
                                                            break if !(_e1004);
                                                        }
                                                    }
                                                    let _e1065 = phi_5306_;
                                                    phi_5308_ = _e1065;
                                                    if _e1065 {
                                                        break;
                                                    }
                                                    let _e1066 = local_13;
                                                    let _e1082 = (_e1066[0][2] - _e458);
                                                    let _e1085 = (((_e1066[0][0] - _e385) * _e482) - (_e1082 * _e410));
                                                    let _e1088 = (((_e1066[0][1] - _e422) * _e482) - (_e1082 * _e446));
                                                    let _e1091 = (_e1066[1][2] - _e458);
                                                    let _e1094 = (((_e1066[1][0] - _e385) * _e482) - (_e1091 * _e410));
                                                    let _e1097 = (((_e1066[1][1] - _e422) * _e482) - (_e1091 * _e446));
                                                    let _e1100 = (_e1066[2][2] - _e458);
                                                    let _e1103 = (((_e1066[2][0] - _e385) * _e482) - (_e1100 * _e410));
                                                    let _e1106 = (((_e1066[2][1] - _e422) * _e482) - (_e1100 * _e446));
                                                    let _e1107 = (_e1103 * _e1097);
                                                    let _e1108 = (_e1106 * _e1094);
                                                    let _e1109 = (_e1085 * _e1106);
                                                    let _e1110 = (_e1088 * _e1103);
                                                    let _e1111 = (_e1094 * _e1088);
                                                    let _e1112 = (_e1097 * _e1085);
                                                    let _e1117 = (((_e1107 >= _e1108) && (_e1109 >= _e1110)) && (_e1111 >= _e1112));
                                                    if (_e1117 || (((_e1107 <= _e1108) && (_e1109 <= _e1110)) && (_e1111 <= _e1112))) {
                                                        let _e1124 = select(-1f, 1f, _e1117);
                                                        let _e1126 = ((_e1107 - _e1108) * _e1124);
                                                        let _e1128 = select(0f, _e1126, (_e1126 > 0f));
                                                        let _e1130 = ((_e1109 - _e1110) * _e1124);
                                                        let _e1132 = select(0f, _e1130, (_e1130 > 0f));
                                                        let _e1134 = ((_e1111 - _e1112) * _e1124);
                                                        let _e1136 = select(0f, _e1134, (_e1134 > 0f));
                                                        let _e1138 = ((_e1128 + _e1132) + _e1136);
                                                        if (_e1138 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3899_ = type_22();
                                                            phi_3900_ = true;
                                                        } else {
                                                            let _e1141 = select(_e1066[1][0], _e1066[0][0], (_e1066[0][0] < _e1066[1][0]));
                                                            let _e1145 = select(_e1066[1][0], _e1066[0][0], (_e1066[0][0] > _e1066[1][0]));
                                                            let _e1149 = select(_e1066[1][1], _e1066[0][1], (_e1066[0][1] < _e1066[1][1]));
                                                            let _e1153 = select(_e1066[1][1], _e1066[0][1], (_e1066[0][1] > _e1066[1][1]));
                                                            let _e1157 = select(_e1066[1][2], _e1066[0][2], (_e1066[0][2] < _e1066[1][2]));
                                                            let _e1161 = select(_e1066[1][2], _e1066[0][2], (_e1066[0][2] > _e1066[1][2]));
                                                            let _e1166 = ((select(_e1066[2][0], _e1141, (_e1141 < _e1066[2][0])) - _e408) * _e413);
                                                            let _e1167 = ((select(_e1066[2][0], _e1145, (_e1145 > _e1066[2][0])) - _e409) * _e413);
                                                            let _e1170 = ((select(_e1066[2][1], _e1149, (_e1149 < _e1066[2][1])) - _e444) * _e449);
                                                            let _e1171 = ((select(_e1066[2][1], _e1153, (_e1153 > _e1066[2][1])) - _e445) * _e449);
                                                            let _e1174 = ((select(_e1066[2][2], _e1157, (_e1157 < _e1066[2][2])) - _e480) * _e485);
                                                            let _e1175 = ((select(_e1066[2][2], _e1161, (_e1161 > _e1066[2][2])) - _e481) * _e485);
                                                            let _e1177 = select(_e1175, _e1174, (_e1174 < _e1175));
                                                            let _e1179 = select(_e1175, _e1174, (_e1174 > _e1175));
                                                            let _e1181 = select(_e1167, _e1166, (_e1166 < _e1167));
                                                            let _e1183 = select(_e1171, _e1170, (_e1170 < _e1171));
                                                            let _e1185 = select(_e1183, _e1181, (_e1181 > _e1183));
                                                            let _e1187 = select(_e1177, _e1185, (_e1185 > _e1177));
                                                            let _e1189 = select(_e1167, _e1166, (_e1166 > _e1167));
                                                            let _e1191 = select(_e1171, _e1170, (_e1170 > _e1171));
                                                            let _e1193 = select(_e1191, _e1189, (_e1189 < _e1191));
                                                            let _e1195 = select(_e1179, _e1193, (_e1193 < _e1179));
                                                            let _e1196 = -(_e1177);
                                                            let _e1202 = select(_e531, _e1187, (_e1187 > _e531));
                                                            if (_e1202 > (_e1195 + (select(_e1196, _e1179, (_e1179 > _e1196)) * 0.0000019073523f))) {
                                                                phi_3894_ = type_22();
                                                                phi_3895_ = true;
                                                            } else {
                                                                let _e1204 = (_e1202 > _e930.member);
                                                                if _e1204 {
                                                                    phi_3893_ = type_22();
                                                                } else {
                                                                    let _e1208 = (_e1066[1][0] - _e1066[0][0]);
                                                                    let _e1209 = (_e1066[1][1] - _e1066[0][1]);
                                                                    let _e1210 = (_e1066[1][2] - _e1066[0][2]);
                                                                    let _e1211 = vec3<f32>(_e1208, _e1209, _e1210);
                                                                    let _e1212 = (_e1066[2][0] - _e1066[1][0]);
                                                                    let _e1213 = (_e1066[2][1] - _e1066[1][1]);
                                                                    let _e1214 = (_e1066[2][2] - _e1066[1][2]);
                                                                    let _e1215 = vec3<f32>(_e1212, _e1213, _e1214);
                                                                    let _e1216 = (_e1066[0][0] - _e1066[2][0]);
                                                                    let _e1217 = (_e1066[0][1] - _e1066[2][1]);
                                                                    let _e1218 = (_e1066[0][2] - _e1066[2][2]);
                                                                    let _e1219 = vec3<f32>(_e1216, _e1217, _e1218);
                                                                    let _e1222 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                    let _e1225 = bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u));
                                                                    let _e1227 = select(_e1225, _e1222, (_e1222 > _e1225));
                                                                    let _e1230 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                    let _e1232 = select(_e1230, _e1227, (_e1227 > _e1230));
                                                                    let _e1235 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                    let _e1238 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                    let _e1240 = select(_e1238, _e1235, (_e1235 > _e1238));
                                                                    let _e1243 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                    let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                                                                    let _e1248 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                    let _e1251 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                    let _e1253 = select(_e1251, _e1248, (_e1248 > _e1251));
                                                                    let _e1256 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                    let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                                    let _e1260 = select(_e1245, _e1232, (_e1232 > _e1245));
                                                                    let _e1262 = select(_e1258, _e1260, (_e1260 > _e1258));
                                                                    if (_e1232 == _e1262) {
                                                                        phi_3804_ = _e1215;
                                                                        phi_3805_ = _e1219;
                                                                    } else {
                                                                        let _e1265 = vec3((_e1245 == _e1262));
                                                                        phi_3804_ = select(_e1211, _e1219, _e1265);
                                                                        phi_3805_ = select(_e1215, _e1211, _e1265);
                                                                    }
                                                                    let _e1269 = phi_3804_;
                                                                    let _e1271 = phi_3805_;
                                                                    let _e1278 = ((_e1269.y * _e1271.z) - (_e1271.y * _e1269.z));
                                                                    let _e1283 = ((_e1269.z * _e1271.x) - (_e1271.z * _e1269.x));
                                                                    let _e1286 = ((_e1269.x * _e1271.y) - (_e1271.x * _e1269.y));
                                                                    if (_e1128 >= _e1132) {
                                                                        phi_3836_ = select(true, false, (_e1128 >= _e1136));
                                                                    } else {
                                                                        phi_3836_ = true;
                                                                    }
                                                                    let _e1291 = phi_3836_;
                                                                    if _e1291 {
                                                                        phi_3845_ = select(vec3<f32>(_e1066[2][0], _e1066[2][1], _e1066[2][2]), vec3<f32>(_e1066[1][0], _e1066[1][1], _e1066[1][2]), vec3((_e1132 >= _e1136)));
                                                                    } else {
                                                                        phi_3845_ = vec3<f32>(_e1066[0][0], _e1066[0][1], _e1066[0][2]);
                                                                    }
                                                                    let _e1296 = phi_3845_;
                                                                    let _e1313 = ((((_e1278 * (_e1296.x - _e385)) + (_e1283 * (_e1296.y - _e422))) + (_e1286 * (_e1296.z - _e458))) / (((_e1278 * _e410) + (_e1283 * _e446)) + (_e1286 * _e482)));
                                                                    let _e1315 = select(_e1195, _e1313, (_e1313 < _e1195));
                                                                    let _e1317 = select(_e1187, _e1315, (_e1315 > _e1187));
                                                                    if (_e1317 >= _e531) {
                                                                        let _e1319 = (_e1317 <= _e930.member);
                                                                        if _e1319 {
                                                                            let _e1320 = (1f / _e1138);
                                                                            phi_3885_ = type_22(_e1317, (_e1132 * _e1320), (_e1136 * _e1320), _e968);
                                                                        } else {
                                                                            phi_3885_ = type_22();
                                                                        }
                                                                        let _e1325 = phi_3885_;
                                                                        phi_3887_ = _e1325;
                                                                        phi_3888_ = select(true, false, _e1319);
                                                                    } else {
                                                                        phi_3887_ = type_22();
                                                                        phi_3888_ = true;
                                                                    }
                                                                    let _e1328 = phi_3887_;
                                                                    let _e1330 = phi_3888_;
                                                                    if _e1330 {
                                                                        phi_3892_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3892_ = _e1328;
                                                                    }
                                                                    let _e1332 = phi_3892_;
                                                                    phi_3893_ = _e1332;
                                                                }
                                                                let _e1334 = phi_3893_;
                                                                phi_3894_ = _e1334;
                                                                phi_3895_ = _e1204;
                                                            }
                                                            let _e1336 = phi_3894_;
                                                            let _e1338 = phi_3895_;
                                                            phi_3899_ = _e1336;
                                                            phi_3900_ = _e1338;
                                                        }
                                                        let _e1340 = phi_3899_;
                                                        let _e1342 = phi_3900_;
                                                        phi_3904_ = _e1340;
                                                        phi_3905_ = _e1342;
                                                    } else {
                                                        phi_3904_ = type_22();
                                                        phi_3905_ = true;
                                                    }
                                                    let _e1344 = phi_3904_;
                                                    let _e1346 = phi_3905_;
                                                    if _e1346 {
                                                        phi_3909_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3909_ = _e1344;
                                                    }
                                                    let _e1348 = phi_3909_;
                                                    if (_e1348.member_3 != 4294967295u) {
                                                        if (_e968 == _e156) {
                                                            phi_4238_ = false;
                                                        } else {
                                                            let _e1352 = (_e968 < arrayLength((&global_5.member)));
                                                            if _e1352 {
                                                                if _e1352 {
                                                                } else {
                                                                    phi_5308_ = true;
                                                                    break;
                                                                }
                                                                let _e1354 = global_5.member[_e968];
                                                                phi_3932_ = _e1354;
                                                            } else {
                                                                phi_3932_ = 4294967295u;
                                                            }
                                                            let _e1356 = phi_3932_;
                                                            let _e1357 = (_e1356 < arrayLength((&global_6.member)));
                                                            if _e1357 {
                                                                if _e1357 {
                                                                } else {
                                                                    phi_5308_ = true;
                                                                    break;
                                                                }
                                                                let _e1359 = global_6.member[_e1356];
                                                                phi_3946_ = _e1359;
                                                            } else {
                                                                phi_3946_ = 0i;
                                                            }
                                                            let _e1361 = phi_3946_;
                                                            let _e1362 = (_e1361 == 0i);
                                                            if _e1362 {
                                                                phi_4237_ = true;
                                                            } else {
                                                                if _e377 {
                                                                    phi_3967_ = vec3<f32>(_e1066[0][0], _e1066[0][1], _e1066[0][2]);
                                                                } else {
                                                                    if (_e357 == 1u) {
                                                                        phi_3966_ = vec3<f32>(_e1066[0][2], _e1066[0][0], _e1066[0][1]);
                                                                    } else {
                                                                        phi_3966_ = vec3<f32>(_e1066[0][1], _e1066[0][2], _e1066[0][0]);
                                                                    }
                                                                    let _e1367 = phi_3966_;
                                                                    phi_3967_ = _e1367;
                                                                }
                                                                let _e1370 = phi_3967_;
                                                                if _e377 {
                                                                    phi_3984_ = vec3<f32>(_e1066[1][0], _e1066[1][1], _e1066[1][2]);
                                                                } else {
                                                                    if (_e357 == 1u) {
                                                                        phi_3983_ = vec3<f32>(_e1066[1][2], _e1066[1][0], _e1066[1][1]);
                                                                    } else {
                                                                        phi_3983_ = vec3<f32>(_e1066[1][1], _e1066[1][2], _e1066[1][0]);
                                                                    }
                                                                    let _e1375 = phi_3983_;
                                                                    phi_3984_ = _e1375;
                                                                }
                                                                let _e1378 = phi_3984_;
                                                                if _e377 {
                                                                    phi_4001_ = vec3<f32>(_e1066[2][0], _e1066[2][1], _e1066[2][2]);
                                                                } else {
                                                                    if (_e357 == 1u) {
                                                                        phi_4000_ = vec3<f32>(_e1066[2][2], _e1066[2][0], _e1066[2][1]);
                                                                    } else {
                                                                        phi_4000_ = vec3<f32>(_e1066[2][1], _e1066[2][2], _e1066[2][0]);
                                                                    }
                                                                    let _e1383 = phi_4000_;
                                                                    phi_4001_ = _e1383;
                                                                }
                                                                let _e1386 = phi_4001_;
                                                                let _e1389 = (_e1378.x - _e1370.x);
                                                                let _e1392 = (_e1378.y - _e1370.y);
                                                                let _e1395 = (_e1378.z - _e1370.z);
                                                                let _e1397 = (_e1386.x - _e1370.x);
                                                                let _e1399 = (_e1386.y - _e1370.y);
                                                                let _e1401 = (_e1386.z - _e1370.z);
                                                                if (_e224.member_1 == 1u) {
                                                                    phi_4037_ = (vec3<f32>(_e224.member[0], _e224.member[1], _e224.member[2]) - _e1370);
                                                                } else {
                                                                    phi_4037_ = vec3<f32>(_e224.member[0], _e224.member[1], _e224.member[2]);
                                                                }
                                                                let _e1416 = phi_4037_;
                                                                let _e1422 = bitcast<f32>((bitcast<u32>((_e1389 * _e1399)) ^ _e224.member_3[0]));
                                                                let _e1426 = bitcast<f32>((bitcast<u32>((_e1392 * _e1397)) ^ _e224.member_3[0]));
                                                                let _e1430 = bitcast<f32>((bitcast<u32>((_e1392 * _e1401)) ^ _e224.member_3[0]));
                                                                let _e1434 = bitcast<f32>((bitcast<u32>((_e1395 * _e1399)) ^ _e224.member_3[0]));
                                                                let _e1438 = bitcast<f32>((bitcast<u32>((_e1395 * _e1397)) ^ _e224.member_3[0]));
                                                                let _e1442 = bitcast<f32>((bitcast<u32>((_e1389 * _e1401)) ^ _e224.member_3[0]));
                                                                let _e1443 = (_e1430 - _e1434);
                                                                let _e1444 = (_e1438 - _e1442);
                                                                let _e1445 = (_e1422 - _e1426);
                                                                let _e1469 = (bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u)));
                                                                let _e1476 = (bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1442) & 2147483647u)));
                                                                let _e1483 = (bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u)));
                                                                if (_e224.member_2 == 0f) {
                                                                    phi_4219_ = 0f;
                                                                } else {
                                                                    let _e1513 = bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u));
                                                                    let _e1516 = bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u));
                                                                    let _e1519 = bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u));
                                                                    let _e1521 = select(_e1519, _e1516, (_e1516 > _e1519));
                                                                    let _e1525 = select(_e1519, _e1516, (_e1516 < _e1519));
                                                                    let _e1529 = select(_e1516, _e1513, (_e1513 < _e1516));
                                                                    let _e1531 = select(_e1516, _e1513, (_e1513 > _e1516));
                                                                    let _e1533 = select(_e1519, _e1531, (_e1531 < _e1519));
                                                                    phi_4219_ = bitcast<f32>((bitcast<u32>((_e224.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1521, _e1513, (_e1513 > _e1521)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1533, _e1529, (_e1529 > _e1533)))) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1525, _e1513, (_e1513 < _e1525)))) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1469 + _e1476) + _e1483))) ^ _e224.member_3[0]))) * 1.0000005f)) ^ _e224.member_3[0])))) ^ _e224.member_3[0]));
                                                                }
                                                                let _e1560 = phi_4219_;
                                                                phi_4237_ = (_e1362 || !(((((bitcast<f32>((bitcast<u32>((_e1416.x * _e1443)) ^ _e224.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1416.y * _e1444)) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1416.z * _e1445)) ^ _e224.member_3[0]))) * f32(-(_e1361))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1416.x) & 2147483647u)) * _e1469)) ^ _e224.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1416.y) & 2147483647u)) * _e1476)) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1416.z) & 2147483647u)) * _e1483)) ^ _e224.member_3[0]))))) ^ _e224.member_3[0])) + _e1560) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1574 = phi_4237_;
                                                            phi_4238_ = _e1574;
                                                        }
                                                        let _e1576 = phi_4238_;
                                                        if _e1576 {
                                                            phi_4243_ = type_39(_e930.member, true);
                                                        } else {
                                                            phi_4243_ = _e930;
                                                        }
                                                        let _e1581 = phi_4243_;
                                                        phi_4244_ = _e1581;
                                                    } else {
                                                        phi_4244_ = _e930;
                                                    }
                                                    let _e1583 = phi_4244_;
                                                    phi_5309_ = _e1065;
                                                    phi_3081_ = _e1583;
                                                } else {
                                                    phi_5309_ = _e928;
                                                    phi_3081_ = type_39();
                                                }
                                                let _e1585 = phi_5309_;
                                                let _e1587 = phi_3081_;
                                                continue;
                                                continuing {
                                                    phi_5303_ = _e1585;
                                                    phi_3080_ = _e1587;
                                                    phi_3083_ = _e945;
                                                    phi_5308_ = _e1585;
                                                    break if !(_e951);
                                                }
                                            }
                                            let _e1590 = phi_5308_;
                                            phi_5384_ = _e1590;
                                            if _e1590 {
                                                break;
                                            }
                                            let _e1592 = local_17;
                                            phi_5388_ = _e1590;
                                            let _e1790 = local_19;
                                            phi_5089_ = _e1790;
                                            phi_5090_ = _e602;
                                            phi_5091_ = false;
                                            phi_5092_ = select(_e606, 0u, _e1592.member_1);
                                        } else {
                                            local_3 = array<f32, 3>(_e602.member.member[0], _e602.member.member[1], _e602.member.member[2]);
                                            local_2 = array<f32, 3>(_e602.member.member_1[0], _e602.member.member_1[1], _e602.member.member_1[2]);
                                            let _e626 = (_e602.member_1 < _e96);
                                            if _e626 {
                                                if _e626 {
                                                } else {
                                                    phi_5384_ = true;
                                                    break;
                                                }
                                                let _e628 = global_9.member[_e602.member_1];
                                                phi_4279_ = _e628;
                                            } else {
                                                phi_4279_ = type_48(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e630 = phi_4279_;
                                            let _e632 = array<u32, 3>(_e357, _e356, _e358);
                                            local_11 = _e632;
                                            local_7 = array<f32, 3>(0f, 0f, 0f);
                                            local_6 = array<f32, 3>(0f, 0f, 0f);
                                            phi_4288_ = type_8(0u, 3u);
                                            loop {
                                                let _e634 = phi_4288_;
                                                if (_e634.member < _e634.member_1) {
                                                    phi_4289_ = type_8((_e634.member + 1u), _e634.member_1);
                                                    phi_4312_ = type_8(1u, _e634.member);
                                                } else {
                                                    phi_4289_ = _e634;
                                                    phi_4312_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e647 = phi_4289_;
                                                let _e649 = phi_4312_;
                                                let _e653 = (bitcast<i32>(_e649.member) != 0i);
                                                if _e653 {
                                                    let _e654 = (_e649.member_1 < 3u);
                                                    if _e654 {
                                                    } else {
                                                        phi_5225_ = true;
                                                        break;
                                                    }
                                                    let _e656 = local_11[_e649.member_1];
                                                    if _e654 {
                                                    } else {
                                                        phi_5225_ = true;
                                                        break;
                                                    }
                                                    let _e658 = local_3[_e649.member_1];
                                                    if _e654 {
                                                    } else {
                                                        phi_5225_ = true;
                                                        break;
                                                    }
                                                    let _e660 = local_2[_e649.member_1];
                                                    let _e663 = ((10u * _e656) & 31u);
                                                    let _e666 = ((_e630.member[0] >> bitcast<u32>(_e663)) & 1023u);
                                                    let _e671 = bitcast<f32>((bitcast<u32>(((_e660 - _e658) * 0.0009775171f)) ^ _e139));
                                                    let _e677 = (_e658 + bitcast<f32>((bitcast<u32>((f32(_e666) * _e671)) ^ _e139)));
                                                    if _e654 {
                                                    } else {
                                                        phi_5225_ = true;
                                                        break;
                                                    }
                                                    local_7[_e649.member_1] = select(select(_e660, _e677, (_e677 < _e660)), _e660, (_e666 == 1023u));
                                                    let _e686 = ((_e630.member[1] >> bitcast<u32>(_e663)) & 1023u);
                                                    let _e692 = (_e658 + bitcast<f32>((bitcast<u32>((f32(_e686) * _e671)) ^ _e139)));
                                                    if _e654 {
                                                    } else {
                                                        phi_5225_ = true;
                                                        break;
                                                    }
                                                    local_6[_e649.member_1] = select(select(_e660, _e692, (_e692 < _e660)), _e660, (_e686 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_4288_ = _e647;
                                                    phi_5225_ = _e563;
                                                    break if !(_e653);
                                                }
                                            }
                                            let _e700 = phi_5225_;
                                            phi_5384_ = _e700;
                                            if _e700 {
                                                break;
                                            }
                                            let _e701 = local_6;
                                            let _e702 = local_7;
                                            local_10 = _e632;
                                            local_9 = array<f32, 3>(0f, 0f, 0f);
                                            local_8 = array<f32, 3>(0f, 0f, 0f);
                                            phi_4442_ = type_8(0u, 3u);
                                            loop {
                                                let _e711 = phi_4442_;
                                                if (_e711.member < _e711.member_1) {
                                                    phi_4443_ = type_8((_e711.member + 1u), _e711.member_1);
                                                    phi_4466_ = type_8(1u, _e711.member);
                                                } else {
                                                    phi_4443_ = _e711;
                                                    phi_4466_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e724 = phi_4443_;
                                                let _e726 = phi_4466_;
                                                let _e730 = (bitcast<i32>(_e726.member) != 0i);
                                                if _e730 {
                                                    let _e731 = (_e726.member_1 < 3u);
                                                    if _e731 {
                                                    } else {
                                                        phi_5286_ = true;
                                                        break;
                                                    }
                                                    let _e733 = local_10[_e726.member_1];
                                                    if _e731 {
                                                    } else {
                                                        phi_5286_ = true;
                                                        break;
                                                    }
                                                    let _e735 = local_3[_e726.member_1];
                                                    if _e731 {
                                                    } else {
                                                        phi_5286_ = true;
                                                        break;
                                                    }
                                                    let _e737 = local_2[_e726.member_1];
                                                    let _e740 = ((10u * _e733) & 31u);
                                                    let _e743 = ((_e630.member_1[0] >> bitcast<u32>(_e740)) & 1023u);
                                                    let _e748 = bitcast<f32>((bitcast<u32>(((_e737 - _e735) * 0.0009775171f)) ^ _e139));
                                                    let _e754 = (_e735 + bitcast<f32>((bitcast<u32>((f32(_e743) * _e748)) ^ _e139)));
                                                    if _e731 {
                                                    } else {
                                                        phi_5286_ = true;
                                                        break;
                                                    }
                                                    local_9[_e726.member_1] = select(select(_e737, _e754, (_e754 < _e737)), _e737, (_e743 == 1023u));
                                                    let _e763 = ((_e630.member_1[1] >> bitcast<u32>(_e740)) & 1023u);
                                                    let _e769 = (_e735 + bitcast<f32>((bitcast<u32>((f32(_e763) * _e748)) ^ _e139)));
                                                    if _e731 {
                                                    } else {
                                                        phi_5286_ = true;
                                                        break;
                                                    }
                                                    local_8[_e726.member_1] = select(select(_e737, _e769, (_e769 < _e737)), _e737, (_e763 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_4442_ = _e724;
                                                    phi_5286_ = _e700;
                                                    break if !(_e730);
                                                }
                                            }
                                            let _e777 = phi_5286_;
                                            phi_5384_ = _e777;
                                            if _e777 {
                                                break;
                                            }
                                            let _e778 = local_8;
                                            let _e779 = local_9;
                                            let _e790 = type_62(type_53(array<f32, 3>(_e702[0], _e702[1], _e702[2]), array<f32, 3>(_e701[0], _e701[1], _e701[2])), _e630.member_2);
                                            let _e795 = type_62(type_53(array<f32, 3>(_e779[0], _e779[1], _e779[2]), array<f32, 3>(_e778[0], _e778[1], _e778[2])), _e630.member_3);
                                            let _e801 = ((_e702[0] - _e408) * _e413);
                                            let _e802 = ((_e779[0] - _e408) * _e413);
                                            let _e803 = ((_e701[0] - _e409) * _e413);
                                            let _e804 = ((_e778[0] - _e409) * _e413);
                                            let _e809 = ((_e702[1] - _e444) * _e449);
                                            let _e810 = ((_e779[1] - _e444) * _e449);
                                            let _e811 = ((_e701[1] - _e445) * _e449);
                                            let _e812 = ((_e778[1] - _e445) * _e449);
                                            let _e817 = ((_e702[2] - _e480) * _e485);
                                            let _e818 = ((_e779[2] - _e480) * _e485);
                                            let _e819 = ((_e701[2] - _e481) * _e485);
                                            let _e820 = ((_e778[2] - _e481) * _e485);
                                            let _e822 = select(_e819, _e817, (_e817 < _e819));
                                            let _e824 = select(_e820, _e818, (_e818 < _e820));
                                            let _e826 = select(_e819, _e817, (_e817 > _e819));
                                            let _e828 = select(_e820, _e818, (_e818 > _e820));
                                            let _e830 = select(_e803, _e801, (_e801 < _e803));
                                            let _e832 = select(_e804, _e802, (_e802 < _e804));
                                            let _e834 = select(_e811, _e809, (_e809 < _e811));
                                            let _e836 = select(_e812, _e810, (_e810 < _e812));
                                            let _e838 = select(_e834, _e830, (_e830 > _e834));
                                            let _e840 = select(_e836, _e832, (_e832 > _e836));
                                            let _e842 = select(_e822, _e838, (_e838 > _e822));
                                            let _e844 = select(_e824, _e840, (_e840 > _e824));
                                            let _e846 = select(_e803, _e801, (_e801 > _e803));
                                            let _e848 = select(_e804, _e802, (_e802 > _e804));
                                            let _e850 = select(_e811, _e809, (_e809 > _e811));
                                            let _e852 = select(_e812, _e810, (_e810 > _e812));
                                            let _e854 = select(_e850, _e846, (_e846 < _e850));
                                            let _e856 = select(_e852, _e848, (_e848 < _e852));
                                            let _e861 = -(_e822);
                                            let _e862 = -(_e824);
                                            let _e869 = (select(_e826, _e854, (_e854 < _e826)) + (select(_e861, _e826, (_e826 > _e861)) * 0.0000019073523f));
                                            let _e870 = (select(_e828, _e856, (_e856 < _e828)) + (select(_e862, _e828, (_e828 > _e862)) * 0.0000019073523f));
                                            let _e872 = select(_e531, _e842, (_e842 > _e531));
                                            let _e874 = select(_e531, _e844, (_e844 > _e531));
                                            let _e879 = (_e872 <= select(_e565.member, _e869, (_e869 < _e565.member)));
                                            let _e880 = (_e874 <= select(_e565.member, _e870, (_e870 < _e565.member)));
                                            let _e881 = (_e872 <= _e874);
                                            if _e879 {
                                                if _e880 {
                                                    if _e881 {
                                                        phi_5029_ = _e795;
                                                    } else {
                                                        phi_5029_ = _e790;
                                                    }
                                                    let _e883 = phi_5029_;
                                                    let _e884 = (_e606 % 128u);
                                                    let _e885 = (_e884 < 128u);
                                                    if _e885 {
                                                    } else {
                                                        phi_5384_ = true;
                                                        break;
                                                    }
                                                    local_5[_e884] = type_62(type_53(array<f32, 3>(_e883.member.member[0], _e883.member.member[1], _e883.member.member[2]), array<f32, 3>(_e883.member.member_1[0], _e883.member.member_1[1], _e883.member.member_1[2])), _e883.member_1);
                                                    if _e885 {
                                                    } else {
                                                        phi_5384_ = true;
                                                        break;
                                                    }
                                                    local_4[_e884] = select(_e874, _e872, (_e872 > _e874));
                                                    if _e881 {
                                                        phi_5068_ = _e790;
                                                    } else {
                                                        phi_5068_ = _e795;
                                                    }
                                                    let _e906 = phi_5068_;
                                                    phi_5069_ = _e906;
                                                    phi_5070_ = (_e606 + 1u);
                                                } else {
                                                    phi_5069_ = type_62();
                                                    phi_5070_ = u32();
                                                }
                                                let _e908 = phi_5069_;
                                                let _e910 = phi_5070_;
                                                phi_5072_ = _e908;
                                                phi_5073_ = _e910;
                                                phi_5074_ = select(true, false, _e880);
                                            } else {
                                                phi_5072_ = type_62();
                                                phi_5073_ = u32();
                                                phi_5074_ = true;
                                            }
                                            let _e913 = phi_5072_;
                                            let _e915 = phi_5073_;
                                            let _e917 = phi_5074_;
                                            if _e917 {
                                                if _e879 {
                                                    phi_5081_ = _e790;
                                                } else {
                                                    phi_5081_ = _e795;
                                                }
                                                let _e919 = phi_5081_;
                                                phi_5086_ = _e919;
                                                phi_5087_ = select(_e880, true, _e879);
                                            } else {
                                                phi_5086_ = _e913;
                                                phi_5087_ = _e604;
                                            }
                                            let _e922 = phi_5086_;
                                            let _e924 = phi_5087_;
                                            phi_5388_ = _e777;
                                            phi_5089_ = _e565;
                                            phi_5090_ = _e922;
                                            phi_5091_ = _e924;
                                            phi_5092_ = select(_e915, _e606, _e917);
                                        }
                                        let _e1596 = phi_5388_;
                                        let _e1598 = phi_5089_;
                                        let _e1600 = phi_5090_;
                                        let _e1602 = phi_5091_;
                                        let _e1604 = phi_5092_;
                                        phi_5387_ = _e1596;
                                        phi_5093_ = _e1598;
                                        phi_5094_ = _e1600;
                                        phi_5095_ = (_e569 - 1u);
                                        phi_5096_ = _e1602;
                                        phi_5097_ = _e1604;
                                    } else {
                                        phi_5387_ = _e563;
                                        phi_5093_ = _e565;
                                        phi_5094_ = _e602;
                                        phi_5095_ = _e569;
                                        phi_5096_ = _e604;
                                        phi_5097_ = _e606;
                                    }
                                    let _e1606 = phi_5387_;
                                    let _e1608 = phi_5093_;
                                    let _e1610 = phi_5094_;
                                    let _e1612 = phi_5095_;
                                    let _e1614 = phi_5096_;
                                    let _e1616 = phi_5097_;
                                    phi_5386_ = _e1606;
                                    phi_5098_ = _e1608;
                                    phi_5099_ = _e1610;
                                    phi_5100_ = _e1612;
                                    phi_5101_ = _e1614;
                                    phi_5102_ = _e1616;
                                } else {
                                    phi_5386_ = _e563;
                                    phi_5098_ = type_39();
                                    phi_5099_ = type_62();
                                    phi_5100_ = u32();
                                    phi_5101_ = bool();
                                    phi_5102_ = u32();
                                }
                                let _e1618 = phi_5386_;
                                let _e1620 = phi_5098_;
                                let _e1622 = phi_5099_;
                                let _e1624 = phi_5100_;
                                let _e1626 = phi_5101_;
                                let _e1628 = phi_5102_;
                                phi_5385_ = _e1618;
                                phi_2995_ = _e1620;
                                phi_2998_ = _e1622;
                                phi_3000_ = _e1624;
                                phi_3002_ = _e1626;
                                phi_3004_ = _e1628;
                                phi_5103_ = _e577;
                            } else {
                                phi_5385_ = _e563;
                                phi_2995_ = type_39();
                                phi_2998_ = type_62();
                                phi_3000_ = u32();
                                phi_3002_ = bool();
                                phi_3004_ = u32();
                                phi_5103_ = false;
                            }
                            let _e1630 = phi_5385_;
                            let _e1632 = phi_2995_;
                            let _e1634 = phi_2998_;
                            let _e1636 = phi_3000_;
                            let _e1638 = phi_3002_;
                            let _e1640 = phi_3004_;
                            let _e1642 = phi_5103_;
                            continue;
                            continuing {
                                phi_5232_ = _e1630;
                                phi_2994_ = _e1632;
                                phi_2997_ = _e1634;
                                phi_2999_ = _e1636;
                                phi_3001_ = _e1638;
                                phi_3003_ = _e1640;
                                phi_5384_ = _e1630;
                                break if !(_e1642);
                            }
                        }
                        let _e1645 = phi_5384_;
                        if _e1645 {
                            break;
                        }
                        let _e1647 = local_18;
                        if _e1647.member_1 {
                        } else {
                            if _e225 {
                            } else {
                                break;
                            }
                            let _e1651 = global_2.member[_e143];
                            if _e150 {
                            } else {
                                break;
                            }
                            let _e1655 = global_8.member[_e143].member_1;
                            if _e225 {
                            } else {
                                break;
                            }
                            global_2.member[_e143] = type_24(_e1651.member, _e1651.member_1, _e1651.member_2, array<f32, 3>((_e1651.member_3[0] + (_e1655[0] * _e1651.member_1[0])), (_e1651.member_3[1] + (_e1655[1] * _e1651.member_1[1])), (_e1651.member_3[2] + (_e1655[2] * _e1651.member_1[2]))), _e1651.member_4);
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
