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

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
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

struct type_40 {
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

struct type_59 {
    member: array<array<u32, 7>>,
}

struct type_61 {
    member: type_34,
    member_1: u32,
}

struct type_64 {
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
var<storage, read_write> global_2: type_29;
@group(0) @binding(1) 
var<uniform> global_3: type_47;
@group(0) @binding(2) 
var<uniform> global_4: type_47;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_50;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_69;
@group(0) @binding(3) 
var<storage> global_9: type_59;
@group(0) @binding(7) 
var<storage> global_10: type_37;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_61, 128>;
    var phi_323_: u32;
    var phi_388_: type_40;
    var phi_538_: i32;
    var phi_539_: i32;
    var phi_549_: bool;
    var phi_559_: u32;
    var phi_560_: u32;
    var phi_562_: bool;
    var phi_567_: u32;
    var phi_612_: f32;
    var phi_618_: f32;
    var phi_629_: f32;
    var phi_635_: f32;
    var phi_658_: f32;
    var phi_669_: f32;
    var phi_678_: f32;
    var phi_684_: f32;
    var phi_695_: f32;
    var phi_701_: f32;
    var phi_724_: f32;
    var phi_735_: f32;
    var phi_744_: f32;
    var phi_750_: f32;
    var phi_761_: f32;
    var phi_767_: f32;
    var phi_790_: f32;
    var phi_801_: f32;
    var phi_901_: f32;
    var phi_902_: f32;
    var phi_4700_: bool;
    var phi_2022_: type_45;
    var phi_2025_: type_61;
    var phi_2027_: u32;
    var phi_2029_: bool;
    var phi_2031_: u32;
    var phi_2042_: bool;
    var phi_2079_: type_61;
    var phi_2080_: bool;
    var phi_2081_: u32;
    var phi_4011_: u32;
    var phi_4012_: u32;
    var phi_4022_: u32;
    var phi_4024_: u32;
    var phi_4025_: bool;
    var phi_4045_: u32;
    var phi_4046_: u32;
    var phi_4050_: type_64;
    var phi_4394_: type_61;
    var phi_4427_: type_61;
    var phi_4428_: type_61;
    var phi_4429_: u32;
    var phi_4431_: type_61;
    var phi_4432_: u32;
    var phi_4433_: bool;
    var phi_4442_: type_61;
    var phi_4447_: type_61;
    var phi_4448_: bool;
    var phi_2099_: type_45;
    var phi_2102_: type_8;
    var phi_2103_: type_8;
    var phi_2125_: type_8;
    var phi_2146_: u32;
    var phi_2235_: array<array<f32, 3>, 3>;
    var phi_2706_: vec3<f32>;
    var phi_2707_: vec3<f32>;
    var phi_2738_: bool;
    var phi_2747_: vec3<f32>;
    var phi_2787_: type_25;
    var phi_2789_: type_25;
    var phi_2790_: bool;
    var phi_2794_: type_25;
    var phi_2795_: type_25;
    var phi_2796_: type_25;
    var phi_2797_: bool;
    var phi_2801_: type_25;
    var phi_2802_: bool;
    var phi_2806_: type_25;
    var phi_2807_: bool;
    var phi_2811_: type_25;
    var phi_2834_: u32;
    var phi_2848_: i32;
    var phi_2868_: vec3<f32>;
    var phi_2869_: vec3<f32>;
    var phi_2885_: vec3<f32>;
    var phi_2886_: vec3<f32>;
    var phi_2902_: vec3<f32>;
    var phi_2903_: vec3<f32>;
    var phi_2939_: vec3<f32>;
    var phi_3121_: f32;
    var phi_3139_: bool;
    var phi_3140_: bool;
    var phi_3145_: type_45;
    var phi_3146_: type_45;
    var phi_2100_: type_45;
    var phi_4694_: bool;
    var local_4: type_45;
    var phi_4830_: bool;
    var phi_4450_: type_45;
    var phi_4451_: type_61;
    var phi_4452_: bool;
    var phi_4453_: u32;
    var phi_4829_: bool;
    var phi_4454_: type_45;
    var phi_4455_: type_61;
    var phi_4456_: u32;
    var phi_4457_: bool;
    var phi_4458_: u32;
    var phi_4828_: bool;
    var phi_4459_: type_45;
    var phi_4460_: type_61;
    var phi_4461_: u32;
    var phi_4462_: bool;
    var phi_4463_: u32;
    var phi_4827_: bool;
    var phi_2023_: type_45;
    var phi_2026_: type_61;
    var phi_2028_: u32;
    var phi_2030_: bool;
    var phi_2032_: u32;
    var phi_4464_: bool;
    var phi_4826_: bool;
    var local_5: type_45;
    var local_6: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_9.member));
            let _e91 = arrayLength((&global_5.member));
            let _e103 = arrayLength((&global_8.member));
            let _e107 = global_4.member[0u][0u];
            let _e111 = global_4.member[0u][1u];
            let _e115 = global_4.member[0u][2u];
            let _e119 = global_4.member[0u][3u];
            let _e123 = global_4.member[1u][0u];
            let _e127 = global_4.member[1u][1u];
            let _e131 = global_4.member[1u][2u];
            let _e135 = (_e87.x + (_e87.y * 2097152u));
            let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e119) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e107), bitcast<i32>(_e111), bitcast<i32>(_e115));
            local = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            let _e150 = (_e135 < arrayLength((&global_10.member)));
            if _e150 {
                if _e150 {
                } else {
                    break;
                }
                let _e154 = global_10.member[_e135].member_2;
                phi_323_ = _e154;
            } else {
                phi_323_ = 4294967295u;
            }
            let _e156 = phi_323_;
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
                phi_388_ = type_40(array<f32, 3>(_e192, _e193, _e194), _e175, _e196, _e197);
            } else {
                phi_388_ = type_40(array<f32, 3>(((_e192 * _e205) * _e211), ((_e193 * _e205) * _e211), ((_e194 * _e205) * _e211)), _e175, ((_e196 * _e205) * _e211), _e197);
            }
            let _e224 = phi_388_;
            if _e150 {
                let _e225 = (_e135 < arrayLength((&global_2.member)));
                if _e225 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e230 = global_10.member[_e135].member.member_1;
                    let _e235 = global_10.member[_e135].member.member_3;
                    if (_e230 <= _e235) {
                        let _e237 = (1u < _e103);
                        if _e237 {
                            if (0u < _e103) {
                            } else {
                                break;
                            }
                            let _e241 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e241 + 1u) < _e241) {
                                if _e237 {
                                } else {
                                    break;
                                }
                                let _e246 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e150 {
                        } else {
                            break;
                        }
                        let _e256 = global_10.member[_e135].member.member_2[0u];
                        let _e258 = (bitcast<u32>(_e256) & 2147483647u);
                        let _e264 = global_10.member[_e135].member.member_2[1u];
                        let _e266 = (bitcast<u32>(_e264) & 2147483647u);
                        let _e272 = global_10.member[_e135].member.member_2[2u];
                        let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                        let _e280 = global_10.member[_e135].member.member[0u];
                        let _e282 = (bitcast<u32>(_e280) & 2147483647u);
                        let _e288 = global_10.member[_e135].member.member[1u];
                        let _e290 = (bitcast<u32>(_e288) & 2147483647u);
                        let _e296 = global_10.member[_e135].member.member[2u];
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
                                phi_538_ = (bitcast<i32>((_e322 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_538_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e322)), 32u, (_e322 == 0u))));
                            }
                            let _e336 = phi_538_;
                            phi_539_ = _e336;
                        } else {
                            phi_539_ = 0i;
                        }
                        let _e338 = phi_539_;
                        let _e339 = (_e258 == _e302);
                        if _e339 {
                            phi_549_ = true;
                        } else {
                            phi_549_ = (_e266 == _e302);
                        }
                        let _e342 = phi_549_;
                        let _e343 = select(1u, 0u, _e339);
                        if _e342 {
                            let _e344 = (_e343 + 1u);
                            phi_559_ = _e344;
                            phi_560_ = _e344;
                            phi_562_ = select(true, false, (_e344 == 2u));
                        } else {
                            phi_559_ = u32();
                            phi_560_ = 0u;
                            phi_562_ = true;
                        }
                        let _e348 = phi_559_;
                        let _e350 = phi_560_;
                        let _e352 = phi_562_;
                        if _e352 {
                            phi_567_ = (_e350 + 1u);
                        } else {
                            phi_567_ = 0u;
                        }
                        let _e356 = phi_567_;
                        let _e357 = select(_e348, _e350, _e352);
                        let _e358 = select(_e343, select(2u, _e343, _e342), _e352);
                        let _e359 = -(_e338);
                        let _e360 = (_e359 / 2i);
                        let _e365 = bitcast<f32>((bitcast<u32>((_e360 + 127i)) << bitcast<u32>(23i)));
                        let _e371 = bitcast<f32>((bitcast<u32>(((_e359 - _e360) + 127i)) << bitcast<u32>(23i)));
                        let _e376 = global_10.member[_e135].member.member;
                        let _e377 = (_e357 == 0u);
                        if _e377 {
                            phi_612_ = _e376[0];
                        } else {
                            phi_612_ = _e376[1];
                        }
                        let _e381 = phi_612_;
                        let _e382 = (_e357 == 2u);
                        if _e382 {
                            phi_618_ = _e376[2];
                        } else {
                            phi_618_ = _e381;
                        }
                        let _e385 = phi_618_;
                        let _e386 = global_10.member[_e135].member.member_2;
                        if _e377 {
                            phi_629_ = _e386[0];
                        } else {
                            phi_629_ = _e386[1];
                        }
                        let _e390 = phi_629_;
                        if _e382 {
                            phi_635_ = _e386[2];
                        } else {
                            phi_635_ = _e390;
                        }
                        let _e393 = phi_635_;
                        let _e395 = ((_e393 * _e365) * _e371);
                        let _e399 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e399 {
                            let _e403 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                            phi_658_ = select(0.00000000000011368684f, _e403, (_e403 > 0.00000000000011368684f));
                        } else {
                            phi_658_ = 0f;
                        }
                        let _e407 = phi_658_;
                        let _e408 = (_e385 + _e407);
                        let _e409 = (_e385 - _e407);
                        let _e410 = select(_e395, 0f, _e399);
                        if _e399 {
                            phi_669_ = 38685626000000000000000000f;
                        } else {
                            phi_669_ = (1f / _e395);
                        }
                        let _e413 = phi_669_;
                        let _e414 = (_e356 == 0u);
                        if _e414 {
                            phi_678_ = _e376[0];
                        } else {
                            phi_678_ = _e376[1];
                        }
                        let _e418 = phi_678_;
                        let _e419 = (_e356 == 2u);
                        if _e419 {
                            phi_684_ = _e376[2];
                        } else {
                            phi_684_ = _e418;
                        }
                        let _e422 = phi_684_;
                        if _e414 {
                            phi_695_ = _e386[0];
                        } else {
                            phi_695_ = _e386[1];
                        }
                        let _e426 = phi_695_;
                        if _e419 {
                            phi_701_ = _e386[2];
                        } else {
                            phi_701_ = _e426;
                        }
                        let _e429 = phi_701_;
                        let _e431 = ((_e429 * _e365) * _e371);
                        let _e435 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e435 {
                            let _e439 = (bitcast<f32>((bitcast<u32>(_e422) & 2147483647u)) * 0.00000011920929f);
                            phi_724_ = select(0.00000000000011368684f, _e439, (_e439 > 0.00000000000011368684f));
                        } else {
                            phi_724_ = 0f;
                        }
                        let _e443 = phi_724_;
                        let _e444 = (_e422 + _e443);
                        let _e445 = (_e422 - _e443);
                        let _e446 = select(_e431, 0f, _e435);
                        if _e435 {
                            phi_735_ = 38685626000000000000000000f;
                        } else {
                            phi_735_ = (1f / _e431);
                        }
                        let _e449 = phi_735_;
                        let _e450 = (_e358 == 0u);
                        if _e450 {
                            phi_744_ = _e376[0];
                        } else {
                            phi_744_ = _e376[1];
                        }
                        let _e454 = phi_744_;
                        let _e455 = (_e358 == 2u);
                        if _e455 {
                            phi_750_ = _e376[2];
                        } else {
                            phi_750_ = _e454;
                        }
                        let _e458 = phi_750_;
                        if _e450 {
                            phi_761_ = _e386[0];
                        } else {
                            phi_761_ = _e386[1];
                        }
                        let _e462 = phi_761_;
                        if _e455 {
                            phi_767_ = _e386[2];
                        } else {
                            phi_767_ = _e462;
                        }
                        let _e465 = phi_767_;
                        let _e467 = ((_e465 * _e365) * _e371);
                        let _e471 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e471 {
                            let _e475 = (bitcast<f32>((bitcast<u32>(_e458) & 2147483647u)) * 0.00000011920929f);
                            phi_790_ = select(0.00000000000011368684f, _e475, (_e475 > 0.00000000000011368684f));
                        } else {
                            phi_790_ = 0f;
                        }
                        let _e479 = phi_790_;
                        let _e480 = (_e458 + _e479);
                        let _e481 = (_e458 - _e479);
                        let _e482 = select(_e467, 0f, _e471);
                        if _e471 {
                            phi_801_ = 38685626000000000000000000f;
                        } else {
                            phi_801_ = (1f / _e467);
                        }
                        let _e485 = phi_801_;
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
                            phi_901_ = select(-340282350000000000000000000000000000000f, _e525, (_e525 > -340282350000000000000000000000000000000f));
                            phi_902_ = select(-340282350000000000000000000000000000000f, _e518, (_e518 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_901_ = 0f;
                            phi_902_ = 1f;
                        }
                        let _e529 = phi_901_;
                        let _e531 = phi_902_;
                        local_3 = array<type_61, 128>(type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e535 = (_e357 % 3u);
                        let _e536 = (_e535 < 3u);
                        if _e536 {
                        } else {
                            break;
                        }
                        let _e538 = local_1[_e535];
                        let _e541 = (_e356 % 3u);
                        let _e542 = (_e541 < 3u);
                        if _e542 {
                        } else {
                            break;
                        }
                        let _e544 = local_1[_e541];
                        let _e547 = (_e358 % 3u);
                        let _e548 = (_e547 < 3u);
                        if _e548 {
                        } else {
                            break;
                        }
                        let _e550 = local_1[_e547];
                        if _e536 {
                        } else {
                            break;
                        }
                        let _e555 = local[_e535];
                        if _e542 {
                        } else {
                            break;
                        }
                        let _e559 = local[_e541];
                        if _e548 {
                        } else {
                            break;
                        }
                        let _e563 = local[_e547];
                        phi_4700_ = false;
                        phi_2022_ = type_45(_e529, false);
                        phi_2025_ = type_61(type_34(vec4<f32>((f32(_e538) * _e147), (f32(_e544) * _e147), (f32(_e550) * _e147), 0f), vec4<f32>((f32(_e555) * _e147), (f32(_e559) * _e147), (f32(_e563) * _e147), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                        phi_2027_ = ((3u * _e89) + 1u);
                        phi_2029_ = (_e531 <= _e529);
                        phi_2031_ = 0u;
                        loop {
                            let _e573 = phi_4700_;
                            let _e575 = phi_2022_;
                            let _e577 = phi_2025_;
                            let _e579 = phi_2027_;
                            let _e581 = phi_2029_;
                            let _e583 = phi_2031_;
                            local_5 = _e575;
                            if _e581 {
                                phi_2042_ = true;
                            } else {
                                phi_2042_ = (_e583 > 0u);
                            }
                            let _e586 = phi_2042_;
                            if _e586 {
                                let _e587 = (_e579 > 0u);
                                if _e587 {
                                    if _e581 {
                                        phi_2079_ = _e577;
                                        phi_2080_ = _e581;
                                        phi_2081_ = _e583;
                                    } else {
                                        let _e588 = (_e583 - 1u);
                                        let _e589 = (_e588 % 128u);
                                        let _e590 = (_e589 < 128u);
                                        if _e590 {
                                        } else {
                                            phi_4826_ = true;
                                            break;
                                        }
                                        let _e592 = local_3[_e589];
                                        if _e590 {
                                        } else {
                                            phi_4826_ = true;
                                            break;
                                        }
                                        let _e600 = local_2[_e589];
                                        phi_2079_ = type_61(type_34(_e592.member.member, _e592.member.member_1), _e592.member_1);
                                        phi_2080_ = (_e600 <= _e575.member);
                                        phi_2081_ = _e588;
                                    }
                                    let _e604 = phi_2079_;
                                    let _e606 = phi_2080_;
                                    let _e608 = phi_2081_;
                                    if _e606 {
                                        if ((_e604.member_1 & 2147483648u) != 0u) {
                                            phi_2099_ = _e575;
                                            phi_2102_ = type_8(0u, ((_e604.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1054 = phi_2099_;
                                                let _e1056 = phi_2102_;
                                                local_4 = _e1054;
                                                local_6 = _e1054;
                                                if (_e1056.member < _e1056.member_1) {
                                                    phi_2103_ = type_8((_e1056.member + 1u), _e1056.member_1);
                                                    phi_2125_ = type_8(1u, _e1056.member);
                                                } else {
                                                    phi_2103_ = _e1056;
                                                    phi_2125_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1069 = phi_2103_;
                                                let _e1071 = phi_2125_;
                                                let _e1075 = (bitcast<i32>(_e1071.member) != 0i);
                                                if _e1075 {
                                                    let _e1076 = ((_e604.member_1 & 268435455u) + _e1071.member_1);
                                                    let _e1077 = (_e1076 < _e91);
                                                    if _e1077 {
                                                        if _e1077 {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        let _e1081 = global_5.member[_e1076].member_1;
                                                        phi_2146_ = _e1081;
                                                    } else {
                                                        phi_2146_ = 4294967295u;
                                                    }
                                                    let _e1083 = phi_2146_;
                                                    if (_e1076 >= _e91) {
                                                        phi_2235_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1077 {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        if (_e535 < 9u) {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        let _e1090 = global_5.member[_e1076].member[_e535];
                                                        if (_e541 < 9u) {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        let _e1096 = global_5.member[_e1076].member[_e541];
                                                        if (_e547 < 9u) {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        let _e1102 = global_5.member[_e1076].member[_e547];
                                                        let _e1104 = (3u + _e535);
                                                        if (_e1104 < 9u) {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        let _e1110 = global_5.member[_e1076].member[_e1104];
                                                        let _e1111 = (3u + _e541);
                                                        if (_e1111 < 9u) {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        let _e1117 = global_5.member[_e1076].member[_e1111];
                                                        let _e1118 = (3u + _e547);
                                                        if (_e1118 < 9u) {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        let _e1124 = global_5.member[_e1076].member[_e1118];
                                                        let _e1126 = (6u + _e535);
                                                        if (_e1126 < 9u) {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        let _e1132 = global_5.member[_e1076].member[_e1126];
                                                        let _e1133 = (6u + _e541);
                                                        if (_e1133 < 9u) {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        let _e1139 = global_5.member[_e1076].member[_e1133];
                                                        let _e1140 = (6u + _e547);
                                                        if (_e1140 < 9u) {
                                                        } else {
                                                            phi_4694_ = true;
                                                            break;
                                                        }
                                                        let _e1146 = global_5.member[_e1076].member[_e1140];
                                                        phi_2235_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1090, _e1096, _e1102), array<f32, 3>(_e1110, _e1117, _e1124), array<f32, 3>(_e1132, _e1139, _e1146));
                                                    }
                                                    let _e1150 = phi_2235_;
                                                    let _e1158 = (_e1150[0][2] - _e458);
                                                    let _e1161 = (((_e1150[0][0] - _e385) * _e482) - (_e1158 * _e410));
                                                    let _e1164 = (((_e1150[0][1] - _e422) * _e482) - (_e1158 * _e446));
                                                    let _e1171 = (_e1150[1][2] - _e458);
                                                    let _e1174 = (((_e1150[1][0] - _e385) * _e482) - (_e1171 * _e410));
                                                    let _e1177 = (((_e1150[1][1] - _e422) * _e482) - (_e1171 * _e446));
                                                    let _e1184 = (_e1150[2][2] - _e458);
                                                    let _e1187 = (((_e1150[2][0] - _e385) * _e482) - (_e1184 * _e410));
                                                    let _e1190 = (((_e1150[2][1] - _e422) * _e482) - (_e1184 * _e446));
                                                    let _e1191 = (_e1187 * _e1177);
                                                    let _e1192 = (_e1190 * _e1174);
                                                    let _e1193 = (_e1161 * _e1190);
                                                    let _e1194 = (_e1164 * _e1187);
                                                    let _e1195 = (_e1174 * _e1164);
                                                    let _e1196 = (_e1177 * _e1161);
                                                    let _e1201 = (((_e1191 >= _e1192) && (_e1193 >= _e1194)) && (_e1195 >= _e1196));
                                                    if (_e1201 || (((_e1191 <= _e1192) && (_e1193 <= _e1194)) && (_e1195 <= _e1196))) {
                                                        let _e1208 = select(-1f, 1f, _e1201);
                                                        let _e1210 = ((_e1191 - _e1192) * _e1208);
                                                        let _e1212 = select(0f, _e1210, (_e1210 > 0f));
                                                        let _e1214 = ((_e1193 - _e1194) * _e1208);
                                                        let _e1216 = select(0f, _e1214, (_e1214 > 0f));
                                                        let _e1218 = ((_e1195 - _e1196) * _e1208);
                                                        let _e1220 = select(0f, _e1218, (_e1218 > 0f));
                                                        let _e1222 = ((_e1212 + _e1216) + _e1220);
                                                        if (_e1222 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2801_ = type_25();
                                                            phi_2802_ = true;
                                                        } else {
                                                            let _e1225 = select(_e1150[1][0], _e1150[0][0], (_e1150[0][0] < _e1150[1][0]));
                                                            let _e1229 = select(_e1150[1][0], _e1150[0][0], (_e1150[0][0] > _e1150[1][0]));
                                                            let _e1233 = select(_e1150[1][1], _e1150[0][1], (_e1150[0][1] < _e1150[1][1]));
                                                            let _e1237 = select(_e1150[1][1], _e1150[0][1], (_e1150[0][1] > _e1150[1][1]));
                                                            let _e1241 = select(_e1150[1][2], _e1150[0][2], (_e1150[0][2] < _e1150[1][2]));
                                                            let _e1245 = select(_e1150[1][2], _e1150[0][2], (_e1150[0][2] > _e1150[1][2]));
                                                            let _e1250 = ((select(_e1150[2][0], _e1225, (_e1225 < _e1150[2][0])) - _e408) * _e413);
                                                            let _e1251 = ((select(_e1150[2][0], _e1229, (_e1229 > _e1150[2][0])) - _e409) * _e413);
                                                            let _e1254 = ((select(_e1150[2][1], _e1233, (_e1233 < _e1150[2][1])) - _e444) * _e449);
                                                            let _e1255 = ((select(_e1150[2][1], _e1237, (_e1237 > _e1150[2][1])) - _e445) * _e449);
                                                            let _e1258 = ((select(_e1150[2][2], _e1241, (_e1241 < _e1150[2][2])) - _e480) * _e485);
                                                            let _e1259 = ((select(_e1150[2][2], _e1245, (_e1245 > _e1150[2][2])) - _e481) * _e485);
                                                            let _e1261 = select(_e1259, _e1258, (_e1258 < _e1259));
                                                            let _e1263 = select(_e1259, _e1258, (_e1258 > _e1259));
                                                            let _e1265 = select(_e1251, _e1250, (_e1250 < _e1251));
                                                            let _e1267 = select(_e1255, _e1254, (_e1254 < _e1255));
                                                            let _e1269 = select(_e1267, _e1265, (_e1265 > _e1267));
                                                            let _e1271 = select(_e1261, _e1269, (_e1269 > _e1261));
                                                            let _e1273 = select(_e1251, _e1250, (_e1250 > _e1251));
                                                            let _e1275 = select(_e1255, _e1254, (_e1254 > _e1255));
                                                            let _e1277 = select(_e1275, _e1273, (_e1273 < _e1275));
                                                            let _e1279 = select(_e1263, _e1277, (_e1277 < _e1263));
                                                            let _e1280 = -(_e1261);
                                                            let _e1286 = select(_e531, _e1271, (_e1271 > _e531));
                                                            if (_e1286 > (_e1279 + (select(_e1280, _e1263, (_e1263 > _e1280)) * 0.0000019073523f))) {
                                                                phi_2796_ = type_25();
                                                                phi_2797_ = true;
                                                            } else {
                                                                let _e1288 = (_e1286 > _e1054.member);
                                                                if _e1288 {
                                                                    phi_2795_ = type_25();
                                                                } else {
                                                                    let _e1292 = (_e1150[1][0] - _e1150[0][0]);
                                                                    let _e1293 = (_e1150[1][1] - _e1150[0][1]);
                                                                    let _e1294 = (_e1150[1][2] - _e1150[0][2]);
                                                                    let _e1295 = vec3<f32>(_e1292, _e1293, _e1294);
                                                                    let _e1296 = (_e1150[2][0] - _e1150[1][0]);
                                                                    let _e1297 = (_e1150[2][1] - _e1150[1][1]);
                                                                    let _e1298 = (_e1150[2][2] - _e1150[1][2]);
                                                                    let _e1299 = vec3<f32>(_e1296, _e1297, _e1298);
                                                                    let _e1300 = (_e1150[0][0] - _e1150[2][0]);
                                                                    let _e1301 = (_e1150[0][1] - _e1150[2][1]);
                                                                    let _e1302 = (_e1150[0][2] - _e1150[2][2]);
                                                                    let _e1303 = vec3<f32>(_e1300, _e1301, _e1302);
                                                                    let _e1306 = bitcast<f32>((bitcast<u32>(_e1292) & 2147483647u));
                                                                    let _e1309 = bitcast<f32>((bitcast<u32>(_e1293) & 2147483647u));
                                                                    let _e1311 = select(_e1309, _e1306, (_e1306 > _e1309));
                                                                    let _e1314 = bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u));
                                                                    let _e1316 = select(_e1314, _e1311, (_e1311 > _e1314));
                                                                    let _e1319 = bitcast<f32>((bitcast<u32>(_e1296) & 2147483647u));
                                                                    let _e1322 = bitcast<f32>((bitcast<u32>(_e1297) & 2147483647u));
                                                                    let _e1324 = select(_e1322, _e1319, (_e1319 > _e1322));
                                                                    let _e1327 = bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u));
                                                                    let _e1329 = select(_e1327, _e1324, (_e1324 > _e1327));
                                                                    let _e1332 = bitcast<f32>((bitcast<u32>(_e1300) & 2147483647u));
                                                                    let _e1335 = bitcast<f32>((bitcast<u32>(_e1301) & 2147483647u));
                                                                    let _e1337 = select(_e1335, _e1332, (_e1332 > _e1335));
                                                                    let _e1340 = bitcast<f32>((bitcast<u32>(_e1302) & 2147483647u));
                                                                    let _e1342 = select(_e1340, _e1337, (_e1337 > _e1340));
                                                                    let _e1344 = select(_e1329, _e1316, (_e1316 > _e1329));
                                                                    let _e1346 = select(_e1342, _e1344, (_e1344 > _e1342));
                                                                    if (_e1316 == _e1346) {
                                                                        phi_2706_ = _e1299;
                                                                        phi_2707_ = _e1303;
                                                                    } else {
                                                                        let _e1349 = vec3((_e1329 == _e1346));
                                                                        phi_2706_ = select(_e1295, _e1303, _e1349);
                                                                        phi_2707_ = select(_e1299, _e1295, _e1349);
                                                                    }
                                                                    let _e1353 = phi_2706_;
                                                                    let _e1355 = phi_2707_;
                                                                    let _e1362 = ((_e1353.y * _e1355.z) - (_e1355.y * _e1353.z));
                                                                    let _e1367 = ((_e1353.z * _e1355.x) - (_e1355.z * _e1353.x));
                                                                    let _e1370 = ((_e1353.x * _e1355.y) - (_e1355.x * _e1353.y));
                                                                    if (_e1212 >= _e1216) {
                                                                        phi_2738_ = select(true, false, (_e1212 >= _e1220));
                                                                    } else {
                                                                        phi_2738_ = true;
                                                                    }
                                                                    let _e1375 = phi_2738_;
                                                                    if _e1375 {
                                                                        phi_2747_ = select(vec3<f32>(_e1150[2][0], _e1150[2][1], _e1150[2][2]), vec3<f32>(_e1150[1][0], _e1150[1][1], _e1150[1][2]), vec3((_e1216 >= _e1220)));
                                                                    } else {
                                                                        phi_2747_ = vec3<f32>(_e1150[0][0], _e1150[0][1], _e1150[0][2]);
                                                                    }
                                                                    let _e1380 = phi_2747_;
                                                                    let _e1397 = ((((_e1362 * (_e1380.x - _e385)) + (_e1367 * (_e1380.y - _e422))) + (_e1370 * (_e1380.z - _e458))) / (((_e1362 * _e410) + (_e1367 * _e446)) + (_e1370 * _e482)));
                                                                    let _e1399 = select(_e1279, _e1397, (_e1397 < _e1279));
                                                                    let _e1401 = select(_e1271, _e1399, (_e1399 > _e1271));
                                                                    if (_e1401 >= _e531) {
                                                                        let _e1403 = (_e1401 <= _e1054.member);
                                                                        if _e1403 {
                                                                            let _e1404 = (1f / _e1222);
                                                                            phi_2787_ = type_25(_e1401, (_e1216 * _e1404), (_e1220 * _e1404), _e1083);
                                                                        } else {
                                                                            phi_2787_ = type_25();
                                                                        }
                                                                        let _e1409 = phi_2787_;
                                                                        phi_2789_ = _e1409;
                                                                        phi_2790_ = select(true, false, _e1403);
                                                                    } else {
                                                                        phi_2789_ = type_25();
                                                                        phi_2790_ = true;
                                                                    }
                                                                    let _e1412 = phi_2789_;
                                                                    let _e1414 = phi_2790_;
                                                                    if _e1414 {
                                                                        phi_2794_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2794_ = _e1412;
                                                                    }
                                                                    let _e1416 = phi_2794_;
                                                                    phi_2795_ = _e1416;
                                                                }
                                                                let _e1418 = phi_2795_;
                                                                phi_2796_ = _e1418;
                                                                phi_2797_ = _e1288;
                                                            }
                                                            let _e1420 = phi_2796_;
                                                            let _e1422 = phi_2797_;
                                                            phi_2801_ = _e1420;
                                                            phi_2802_ = _e1422;
                                                        }
                                                        let _e1424 = phi_2801_;
                                                        let _e1426 = phi_2802_;
                                                        phi_2806_ = _e1424;
                                                        phi_2807_ = _e1426;
                                                    } else {
                                                        phi_2806_ = type_25();
                                                        phi_2807_ = true;
                                                    }
                                                    let _e1428 = phi_2806_;
                                                    let _e1430 = phi_2807_;
                                                    if _e1430 {
                                                        phi_2811_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2811_ = _e1428;
                                                    }
                                                    let _e1432 = phi_2811_;
                                                    if (_e1432.member_3 != 4294967295u) {
                                                        if (_e1083 == _e156) {
                                                            phi_3140_ = false;
                                                        } else {
                                                            let _e1436 = (_e1083 < arrayLength((&global_6.member)));
                                                            if _e1436 {
                                                                if _e1436 {
                                                                } else {
                                                                    phi_4694_ = true;
                                                                    break;
                                                                }
                                                                let _e1438 = global_6.member[_e1083];
                                                                phi_2834_ = _e1438;
                                                            } else {
                                                                phi_2834_ = 4294967295u;
                                                            }
                                                            let _e1440 = phi_2834_;
                                                            let _e1441 = (_e1440 < arrayLength((&global_7.member)));
                                                            if _e1441 {
                                                                if _e1441 {
                                                                } else {
                                                                    phi_4694_ = true;
                                                                    break;
                                                                }
                                                                let _e1443 = global_7.member[_e1440];
                                                                phi_2848_ = _e1443;
                                                            } else {
                                                                phi_2848_ = 0i;
                                                            }
                                                            let _e1445 = phi_2848_;
                                                            let _e1446 = (_e1445 == 0i);
                                                            if _e1446 {
                                                                phi_3139_ = true;
                                                            } else {
                                                                if _e377 {
                                                                    phi_2869_ = vec3<f32>(_e1150[0][0], _e1150[0][1], _e1150[0][2]);
                                                                } else {
                                                                    if (_e357 == 1u) {
                                                                        phi_2868_ = vec3<f32>(_e1150[0][2], _e1150[0][0], _e1150[0][1]);
                                                                    } else {
                                                                        phi_2868_ = vec3<f32>(_e1150[0][1], _e1150[0][2], _e1150[0][0]);
                                                                    }
                                                                    let _e1451 = phi_2868_;
                                                                    phi_2869_ = _e1451;
                                                                }
                                                                let _e1454 = phi_2869_;
                                                                if _e377 {
                                                                    phi_2886_ = vec3<f32>(_e1150[1][0], _e1150[1][1], _e1150[1][2]);
                                                                } else {
                                                                    if (_e357 == 1u) {
                                                                        phi_2885_ = vec3<f32>(_e1150[1][2], _e1150[1][0], _e1150[1][1]);
                                                                    } else {
                                                                        phi_2885_ = vec3<f32>(_e1150[1][1], _e1150[1][2], _e1150[1][0]);
                                                                    }
                                                                    let _e1459 = phi_2885_;
                                                                    phi_2886_ = _e1459;
                                                                }
                                                                let _e1462 = phi_2886_;
                                                                if _e377 {
                                                                    phi_2903_ = vec3<f32>(_e1150[2][0], _e1150[2][1], _e1150[2][2]);
                                                                } else {
                                                                    if (_e357 == 1u) {
                                                                        phi_2902_ = vec3<f32>(_e1150[2][2], _e1150[2][0], _e1150[2][1]);
                                                                    } else {
                                                                        phi_2902_ = vec3<f32>(_e1150[2][1], _e1150[2][2], _e1150[2][0]);
                                                                    }
                                                                    let _e1467 = phi_2902_;
                                                                    phi_2903_ = _e1467;
                                                                }
                                                                let _e1470 = phi_2903_;
                                                                let _e1473 = (_e1462.x - _e1454.x);
                                                                let _e1476 = (_e1462.y - _e1454.y);
                                                                let _e1479 = (_e1462.z - _e1454.z);
                                                                let _e1481 = (_e1470.x - _e1454.x);
                                                                let _e1483 = (_e1470.y - _e1454.y);
                                                                let _e1485 = (_e1470.z - _e1454.z);
                                                                if (_e224.member_1 == 1u) {
                                                                    phi_2939_ = (vec3<f32>(_e224.member[0], _e224.member[1], _e224.member[2]) - _e1454);
                                                                } else {
                                                                    phi_2939_ = vec3<f32>(_e224.member[0], _e224.member[1], _e224.member[2]);
                                                                }
                                                                let _e1500 = phi_2939_;
                                                                let _e1506 = bitcast<f32>((bitcast<u32>((_e1473 * _e1483)) ^ _e224.member_3[0]));
                                                                let _e1510 = bitcast<f32>((bitcast<u32>((_e1476 * _e1481)) ^ _e224.member_3[0]));
                                                                let _e1514 = bitcast<f32>((bitcast<u32>((_e1476 * _e1485)) ^ _e224.member_3[0]));
                                                                let _e1518 = bitcast<f32>((bitcast<u32>((_e1479 * _e1483)) ^ _e224.member_3[0]));
                                                                let _e1522 = bitcast<f32>((bitcast<u32>((_e1479 * _e1481)) ^ _e224.member_3[0]));
                                                                let _e1526 = bitcast<f32>((bitcast<u32>((_e1473 * _e1485)) ^ _e224.member_3[0]));
                                                                let _e1527 = (_e1514 - _e1518);
                                                                let _e1528 = (_e1522 - _e1526);
                                                                let _e1529 = (_e1506 - _e1510);
                                                                let _e1553 = (bitcast<f32>((bitcast<u32>(_e1514) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1518) & 2147483647u)));
                                                                let _e1560 = (bitcast<f32>((bitcast<u32>(_e1522) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1526) & 2147483647u)));
                                                                let _e1567 = (bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1510) & 2147483647u)));
                                                                if (_e224.member_2 == 0f) {
                                                                    phi_3121_ = 0f;
                                                                } else {
                                                                    let _e1597 = bitcast<f32>((bitcast<u32>(_e1527) & 2147483647u));
                                                                    let _e1600 = bitcast<f32>((bitcast<u32>(_e1528) & 2147483647u));
                                                                    let _e1603 = bitcast<f32>((bitcast<u32>(_e1529) & 2147483647u));
                                                                    let _e1605 = select(_e1603, _e1600, (_e1600 > _e1603));
                                                                    let _e1609 = select(_e1603, _e1600, (_e1600 < _e1603));
                                                                    let _e1613 = select(_e1600, _e1597, (_e1597 < _e1600));
                                                                    let _e1615 = select(_e1600, _e1597, (_e1597 > _e1600));
                                                                    let _e1617 = select(_e1603, _e1615, (_e1615 < _e1603));
                                                                    phi_3121_ = bitcast<f32>((bitcast<u32>((_e224.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1605, _e1597, (_e1597 > _e1605)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1617, _e1613, (_e1613 > _e1617)))) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1609, _e1597, (_e1597 < _e1609)))) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1553 + _e1560) + _e1567))) ^ _e224.member_3[0]))) * 1.0000005f)) ^ _e224.member_3[0])))) ^ _e224.member_3[0]));
                                                                }
                                                                let _e1644 = phi_3121_;
                                                                phi_3139_ = (_e1446 || !(((((bitcast<f32>((bitcast<u32>((_e1500.x * _e1527)) ^ _e224.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1500.y * _e1528)) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1500.z * _e1529)) ^ _e224.member_3[0]))) * f32(-(_e1445))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1500.x) & 2147483647u)) * _e1553)) ^ _e224.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1500.y) & 2147483647u)) * _e1560)) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1500.z) & 2147483647u)) * _e1567)) ^ _e224.member_3[0]))))) ^ _e224.member_3[0])) + _e1644) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1658 = phi_3139_;
                                                            phi_3140_ = _e1658;
                                                        }
                                                        let _e1660 = phi_3140_;
                                                        if _e1660 {
                                                            phi_3145_ = type_45(_e1054.member, true);
                                                        } else {
                                                            phi_3145_ = _e1054;
                                                        }
                                                        let _e1665 = phi_3145_;
                                                        phi_3146_ = _e1665;
                                                    } else {
                                                        phi_3146_ = _e1054;
                                                    }
                                                    let _e1667 = phi_3146_;
                                                    phi_2100_ = _e1667;
                                                } else {
                                                    phi_2100_ = type_45();
                                                }
                                                let _e1669 = phi_2100_;
                                                continue;
                                                continuing {
                                                    phi_2099_ = _e1669;
                                                    phi_2102_ = _e1069;
                                                    phi_4694_ = _e573;
                                                    break if !(_e1075);
                                                }
                                            }
                                            let _e1672 = phi_4694_;
                                            phi_4826_ = _e1672;
                                            if _e1672 {
                                                break;
                                            }
                                            let _e1674 = local_4;
                                            phi_4830_ = _e1672;
                                            let _e1859 = local_6;
                                            phi_4450_ = _e1859;
                                            phi_4451_ = _e604;
                                            phi_4452_ = false;
                                            phi_4453_ = select(_e608, 0u, _e1674.member_1);
                                        } else {
                                            if (_e604.member_1 >= _e89) {
                                                phi_4050_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e604.member_1 < _e89) {
                                                } else {
                                                    phi_4826_ = true;
                                                    break;
                                                }
                                                let _e621 = ((1u + (_e357 * 2u)) % 7u);
                                                if (_e621 < 7u) {
                                                } else {
                                                    phi_4826_ = true;
                                                    break;
                                                }
                                                let _e626 = global_9.member[_e604.member_1][_e621];
                                                let _e629 = ((1u + (_e356 * 2u)) % 7u);
                                                if (_e629 < 7u) {
                                                } else {
                                                    phi_4826_ = true;
                                                    break;
                                                }
                                                let _e634 = global_9.member[_e604.member_1][_e629];
                                                let _e637 = ((1u + (_e358 * 2u)) % 7u);
                                                if (_e637 < 7u) {
                                                } else {
                                                    phi_4826_ = true;
                                                    break;
                                                }
                                                let _e642 = global_9.member[_e604.member_1][_e637];
                                                let _e645 = (((_e357 + 1u) * 2u) % 7u);
                                                if (_e645 < 7u) {
                                                } else {
                                                    phi_4826_ = true;
                                                    break;
                                                }
                                                let _e650 = global_9.member[_e604.member_1][_e645];
                                                let _e653 = (((_e356 + 1u) * 2u) % 7u);
                                                if (_e653 < 7u) {
                                                } else {
                                                    phi_4826_ = true;
                                                    break;
                                                }
                                                let _e658 = global_9.member[_e604.member_1][_e653];
                                                let _e661 = (((_e358 + 1u) * 2u) % 7u);
                                                if (_e661 < 7u) {
                                                } else {
                                                    phi_4826_ = true;
                                                    break;
                                                }
                                                let _e666 = global_9.member[_e604.member_1][_e661];
                                                let _e689 = (bitcast<f32>((bitcast<u32>((_e604.member.member_1.x - _e604.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e690 = (bitcast<f32>((bitcast<u32>((_e604.member.member_1.y - _e604.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e691 = (bitcast<f32>((bitcast<u32>((_e604.member.member_1.z - _e604.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e693 = select(_e147, _e689, (_e689 > _e147));
                                                let _e695 = select(_e147, _e690, (_e690 > _e147));
                                                let _e697 = select(_e147, _e691, (_e691 > _e147));
                                                let _e722 = bitcast<u32>((f32(bitcast<i32>((_e626 & 2097151u))) * _e693));
                                                let _e727 = (bitcast<i32>((_e626 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e730 = bitcast<f32>((_e722 & bitcast<u32>(_e727)));
                                                let _e731 = bitcast<u32>((f32(bitcast<i32>((_e634 & 2097151u))) * _e695));
                                                let _e736 = (bitcast<i32>((_e634 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e739 = bitcast<f32>((_e731 & bitcast<u32>(_e736)));
                                                let _e740 = bitcast<u32>((f32(bitcast<i32>((_e642 & 2097151u))) * _e697));
                                                let _e745 = (bitcast<i32>((_e642 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e748 = bitcast<f32>((_e740 & bitcast<u32>(_e745)));
                                                let _e752 = bitcast<f32>((_e722 & bitcast<u32>(~(_e727))));
                                                let _e756 = bitcast<f32>((_e731 & bitcast<u32>(~(_e736))));
                                                let _e760 = bitcast<f32>((_e740 & bitcast<u32>(~(_e745))));
                                                let _e761 = bitcast<u32>((f32(bitcast<i32>((_e650 & 2097151u))) * _e693));
                                                let _e766 = (bitcast<i32>((_e650 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e769 = bitcast<f32>((_e761 & bitcast<u32>(_e766)));
                                                let _e770 = bitcast<u32>((f32(bitcast<i32>((_e658 & 2097151u))) * _e695));
                                                let _e775 = (bitcast<i32>((_e658 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e778 = bitcast<f32>((_e770 & bitcast<u32>(_e775)));
                                                let _e779 = bitcast<u32>((f32(bitcast<i32>((_e666 & 2097151u))) * _e697));
                                                let _e784 = (bitcast<i32>((_e666 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e787 = bitcast<f32>((_e779 & bitcast<u32>(_e784)));
                                                let _e791 = bitcast<f32>((_e761 & bitcast<u32>(~(_e766))));
                                                let _e795 = bitcast<f32>((_e770 & bitcast<u32>(~(_e775))));
                                                let _e799 = bitcast<f32>((_e779 & bitcast<u32>(~(_e784))));
                                                let _e829 = global_9.member[_e604.member_1][0u];
                                                let _e833 = global_9.member[_e604.member_1][2u];
                                                let _e837 = global_9.member[_e604.member_1][4u];
                                                let _e841 = global_9.member[_e604.member_1][6u];
                                                let _e853 = (((_e833 >> bitcast<u32>(22i)) | ((_e837 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e841 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e854 = (_e829 & 268435455u);
                                                let _e855 = (_e853 & 268435455u);
                                                let _e858 = ((_e829 >> bitcast<u32>(28u)) & 7u);
                                                let _e866 = ((_e829 >> bitcast<u32>(31i)) | (((_e853 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e867 = (_e858 != 0u);
                                                if (_e858 == 0u) {
                                                    phi_4012_ = _e854;
                                                } else {
                                                    if (_e858 == 7u) {
                                                        phi_4011_ = 2147483648u;
                                                    } else {
                                                        phi_4011_ = ((2147483648u | (_e858 << bitcast<u32>(28u))) | (_e855 & 268435455u));
                                                    }
                                                    let _e876 = phi_4011_;
                                                    phi_4012_ = _e876;
                                                }
                                                let _e878 = phi_4012_;
                                                if _e867 {
                                                    let _e879 = (_e858 != 7u);
                                                    if _e879 {
                                                        phi_4022_ = (_e855 + _e858);
                                                    } else {
                                                        phi_4022_ = u32();
                                                    }
                                                    let _e882 = phi_4022_;
                                                    phi_4024_ = _e882;
                                                    phi_4025_ = select(true, false, _e879);
                                                } else {
                                                    phi_4024_ = u32();
                                                    phi_4025_ = true;
                                                }
                                                let _e885 = phi_4024_;
                                                let _e887 = phi_4025_;
                                                if (_e866 == 0u) {
                                                    phi_4046_ = (_e854 + select(0u, 1u, !(_e867)));
                                                } else {
                                                    if (_e866 == 7u) {
                                                        phi_4045_ = 2147483648u;
                                                    } else {
                                                        phi_4045_ = ((2147483648u | (_e866 << bitcast<u32>(28u))) | (select(_e885, _e855, _e887) & 268435455u));
                                                    }
                                                    let _e900 = phi_4045_;
                                                    phi_4046_ = _e900;
                                                }
                                                let _e902 = phi_4046_;
                                                phi_4050_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e604.member.member.x + _e730), (_e604.member.member.x + _e752), (_e604.member.member_1.x - _e769), (_e604.member.member_1.x - _e791)), vec4<f32>((_e604.member.member.y + _e739), (_e604.member.member.y + _e756), (_e604.member.member_1.y - _e778), (_e604.member.member_1.y - _e795)), vec4<f32>((_e604.member.member.z + _e748), (_e604.member.member.z + _e760), (_e604.member.member_1.z - _e787), (_e604.member.member_1.z - _e799))), type_61(type_34((_e604.member.member + vec4<f32>(_e730, _e739, _e748, 0f)), (_e604.member.member_1 - vec4<f32>(_e769, _e778, _e787, 0f))), _e878), type_61(type_34((_e604.member.member + vec4<f32>(_e752, _e756, _e760, 0f)), (_e604.member.member_1 - vec4<f32>(_e791, _e795, _e799, 0f))), _e902));
                                            }
                                            let _e907 = phi_4050_;
                                            let _e919 = ((_e907.member[0].x - _e408) * _e413);
                                            let _e920 = ((_e907.member[0].y - _e408) * _e413);
                                            let _e921 = ((_e907.member[0].z - _e409) * _e413);
                                            let _e922 = ((_e907.member[0].w - _e409) * _e413);
                                            let _e932 = ((_e907.member[1].x - _e444) * _e449);
                                            let _e933 = ((_e907.member[1].y - _e444) * _e449);
                                            let _e934 = ((_e907.member[1].z - _e445) * _e449);
                                            let _e935 = ((_e907.member[1].w - _e445) * _e449);
                                            let _e945 = ((_e907.member[2].x - _e480) * _e485);
                                            let _e946 = ((_e907.member[2].y - _e480) * _e485);
                                            let _e947 = ((_e907.member[2].z - _e481) * _e485);
                                            let _e948 = ((_e907.member[2].w - _e481) * _e485);
                                            let _e950 = select(_e947, _e945, (_e945 < _e947));
                                            let _e952 = select(_e948, _e946, (_e946 < _e948));
                                            let _e954 = select(_e947, _e945, (_e945 > _e947));
                                            let _e956 = select(_e948, _e946, (_e946 > _e948));
                                            let _e958 = select(_e921, _e919, (_e919 < _e921));
                                            let _e960 = select(_e922, _e920, (_e920 < _e922));
                                            let _e962 = select(_e934, _e932, (_e932 < _e934));
                                            let _e964 = select(_e935, _e933, (_e933 < _e935));
                                            let _e966 = select(_e962, _e958, (_e958 > _e962));
                                            let _e968 = select(_e964, _e960, (_e960 > _e964));
                                            let _e970 = select(_e950, _e966, (_e966 > _e950));
                                            let _e972 = select(_e952, _e968, (_e968 > _e952));
                                            let _e974 = select(_e921, _e919, (_e919 > _e921));
                                            let _e976 = select(_e922, _e920, (_e920 > _e922));
                                            let _e978 = select(_e934, _e932, (_e932 > _e934));
                                            let _e980 = select(_e935, _e933, (_e933 > _e935));
                                            let _e982 = select(_e978, _e974, (_e974 < _e978));
                                            let _e984 = select(_e980, _e976, (_e976 < _e980));
                                            let _e989 = -(_e950);
                                            let _e990 = -(_e952);
                                            let _e997 = (select(_e954, _e982, (_e982 < _e954)) + (select(_e989, _e954, (_e954 > _e989)) * 0.0000019073523f));
                                            let _e998 = (select(_e956, _e984, (_e984 < _e956)) + (select(_e990, _e956, (_e956 > _e990)) * 0.0000019073523f));
                                            let _e1000 = select(_e531, _e970, (_e970 > _e531));
                                            let _e1002 = select(_e531, _e972, (_e972 > _e531));
                                            let _e1007 = (_e1000 <= select(_e575.member, _e997, (_e997 < _e575.member)));
                                            let _e1008 = (_e1002 <= select(_e575.member, _e998, (_e998 < _e575.member)));
                                            let _e1009 = (_e1000 <= _e1002);
                                            if _e1007 {
                                                if _e1008 {
                                                    if _e1009 {
                                                        phi_4394_ = _e907.member_2;
                                                    } else {
                                                        phi_4394_ = _e907.member_1;
                                                    }
                                                    let _e1013 = phi_4394_;
                                                    let _e1014 = (_e608 % 128u);
                                                    let _e1015 = (_e1014 < 128u);
                                                    if _e1015 {
                                                    } else {
                                                        phi_4826_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1014] = type_61(type_34(_e1013.member.member, _e1013.member.member_1), _e1013.member_1);
                                                    if _e1015 {
                                                    } else {
                                                        phi_4826_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1014] = select(_e1002, _e1000, (_e1000 > _e1002));
                                                    if _e1009 {
                                                        phi_4427_ = _e907.member_1;
                                                    } else {
                                                        phi_4427_ = _e907.member_2;
                                                    }
                                                    let _e1030 = phi_4427_;
                                                    phi_4428_ = _e1030;
                                                    phi_4429_ = (_e608 + 1u);
                                                } else {
                                                    phi_4428_ = type_61();
                                                    phi_4429_ = u32();
                                                }
                                                let _e1032 = phi_4428_;
                                                let _e1034 = phi_4429_;
                                                phi_4431_ = _e1032;
                                                phi_4432_ = _e1034;
                                                phi_4433_ = select(true, false, _e1008);
                                            } else {
                                                phi_4431_ = type_61();
                                                phi_4432_ = u32();
                                                phi_4433_ = true;
                                            }
                                            let _e1037 = phi_4431_;
                                            let _e1039 = phi_4432_;
                                            let _e1041 = phi_4433_;
                                            if _e1041 {
                                                if _e1007 {
                                                    phi_4442_ = _e907.member_1;
                                                } else {
                                                    phi_4442_ = _e907.member_2;
                                                }
                                                let _e1045 = phi_4442_;
                                                phi_4447_ = _e1045;
                                                phi_4448_ = select(_e1008, true, _e1007);
                                            } else {
                                                phi_4447_ = _e1037;
                                                phi_4448_ = _e606;
                                            }
                                            let _e1048 = phi_4447_;
                                            let _e1050 = phi_4448_;
                                            phi_4830_ = _e573;
                                            phi_4450_ = _e575;
                                            phi_4451_ = _e1048;
                                            phi_4452_ = _e1050;
                                            phi_4453_ = select(_e1039, _e608, _e1041);
                                        }
                                        let _e1678 = phi_4830_;
                                        let _e1680 = phi_4450_;
                                        let _e1682 = phi_4451_;
                                        let _e1684 = phi_4452_;
                                        let _e1686 = phi_4453_;
                                        phi_4829_ = _e1678;
                                        phi_4454_ = _e1680;
                                        phi_4455_ = _e1682;
                                        phi_4456_ = (_e579 - 1u);
                                        phi_4457_ = _e1684;
                                        phi_4458_ = _e1686;
                                    } else {
                                        phi_4829_ = _e573;
                                        phi_4454_ = _e575;
                                        phi_4455_ = _e604;
                                        phi_4456_ = _e579;
                                        phi_4457_ = _e606;
                                        phi_4458_ = _e608;
                                    }
                                    let _e1688 = phi_4829_;
                                    let _e1690 = phi_4454_;
                                    let _e1692 = phi_4455_;
                                    let _e1694 = phi_4456_;
                                    let _e1696 = phi_4457_;
                                    let _e1698 = phi_4458_;
                                    phi_4828_ = _e1688;
                                    phi_4459_ = _e1690;
                                    phi_4460_ = _e1692;
                                    phi_4461_ = _e1694;
                                    phi_4462_ = _e1696;
                                    phi_4463_ = _e1698;
                                } else {
                                    phi_4828_ = _e573;
                                    phi_4459_ = type_45();
                                    phi_4460_ = type_61();
                                    phi_4461_ = u32();
                                    phi_4462_ = bool();
                                    phi_4463_ = u32();
                                }
                                let _e1700 = phi_4828_;
                                let _e1702 = phi_4459_;
                                let _e1704 = phi_4460_;
                                let _e1706 = phi_4461_;
                                let _e1708 = phi_4462_;
                                let _e1710 = phi_4463_;
                                phi_4827_ = _e1700;
                                phi_2023_ = _e1702;
                                phi_2026_ = _e1704;
                                phi_2028_ = _e1706;
                                phi_2030_ = _e1708;
                                phi_2032_ = _e1710;
                                phi_4464_ = _e587;
                            } else {
                                phi_4827_ = _e573;
                                phi_2023_ = type_45();
                                phi_2026_ = type_61();
                                phi_2028_ = u32();
                                phi_2030_ = bool();
                                phi_2032_ = u32();
                                phi_4464_ = false;
                            }
                            let _e1712 = phi_4827_;
                            let _e1714 = phi_2023_;
                            let _e1716 = phi_2026_;
                            let _e1718 = phi_2028_;
                            let _e1720 = phi_2030_;
                            let _e1722 = phi_2032_;
                            let _e1724 = phi_4464_;
                            continue;
                            continuing {
                                phi_4700_ = _e1712;
                                phi_2022_ = _e1714;
                                phi_2025_ = _e1716;
                                phi_2027_ = _e1718;
                                phi_2029_ = _e1720;
                                phi_2031_ = _e1722;
                                phi_4826_ = _e1712;
                                break if !(_e1724);
                            }
                        }
                        let _e1727 = phi_4826_;
                        if _e1727 {
                            break;
                        }
                        let _e1729 = local_5;
                        if _e1729.member_1 {
                        } else {
                            if _e225 {
                            } else {
                                break;
                            }
                            let _e1733 = global_2.member[_e135];
                            if _e150 {
                            } else {
                                break;
                            }
                            let _e1737 = global_10.member[_e135].member_1;
                            if _e225 {
                            } else {
                                break;
                            }
                            global_2.member[_e135] = type_27(_e1733.member, _e1733.member_1, _e1733.member_2, array<f32, 3>((_e1733.member_3[0] + (_e1737[0] * _e1733.member_1[0])), (_e1733.member_3[1] + (_e1737[1] * _e1733.member_1[1])), (_e1733.member_3[2] + (_e1737[2] * _e1733.member_1[2]))), _e1733.member_4);
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
fn trace_shadows_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
