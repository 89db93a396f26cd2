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

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: type_28,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_31 {
    member: array<type_29>,
}

struct type_35 {
    member: type_28,
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

struct type_54 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_56 {
    member: array<type_54>,
}

struct type_59 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_62 {
    member: type_59,
    member_1: u32,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_31;
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
@group(0) @binding(7) 
var<storage> global_9: type_37;
@group(0) @binding(3) 
var<storage> global_10: type_56;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_62, 128>;
    var local_4: array<f32, 3>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<u32, 3>;
    var local_9: array<u32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var phi_276_: u32;
    var phi_341_: type_41;
    var phi_491_: i32;
    var phi_492_: i32;
    var phi_502_: bool;
    var phi_512_: u32;
    var phi_513_: u32;
    var phi_515_: bool;
    var phi_520_: u32;
    var phi_565_: f32;
    var phi_571_: f32;
    var phi_582_: f32;
    var phi_588_: f32;
    var phi_611_: f32;
    var phi_622_: f32;
    var phi_631_: f32;
    var phi_637_: f32;
    var phi_648_: f32;
    var phi_654_: f32;
    var phi_677_: f32;
    var phi_688_: f32;
    var phi_697_: f32;
    var phi_703_: f32;
    var phi_714_: f32;
    var phi_720_: f32;
    var phi_743_: f32;
    var phi_754_: f32;
    var phi_854_: f32;
    var phi_855_: f32;
    var phi_5089_: bool;
    var phi_2983_: type_45;
    var phi_2986_: type_62;
    var phi_2988_: u32;
    var phi_2990_: bool;
    var phi_2992_: u32;
    var phi_3003_: bool;
    var phi_3048_: type_62;
    var phi_3049_: bool;
    var phi_3050_: u32;
    var phi_4150_: type_54;
    var phi_4159_: type_8;
    var phi_4160_: type_8;
    var phi_4183_: type_8;
    var phi_5082_: bool;
    var phi_4313_: type_8;
    var phi_4314_: type_8;
    var phi_4337_: type_8;
    var phi_5143_: bool;
    var phi_4900_: type_62;
    var phi_4939_: type_62;
    var phi_4940_: type_62;
    var phi_4941_: u32;
    var phi_4943_: type_62;
    var phi_4944_: u32;
    var phi_4945_: bool;
    var phi_4952_: type_62;
    var phi_4957_: type_62;
    var phi_4958_: bool;
    var phi_3068_: type_45;
    var phi_3071_: type_8;
    var phi_3072_: type_8;
    var phi_3094_: type_8;
    var phi_3115_: u32;
    var phi_3204_: array<array<f32, 3>, 3>;
    var phi_3675_: vec3<f32>;
    var phi_3676_: vec3<f32>;
    var phi_3707_: bool;
    var phi_3716_: vec3<f32>;
    var phi_3756_: type_27;
    var phi_3758_: type_27;
    var phi_3759_: bool;
    var phi_3763_: type_27;
    var phi_3764_: type_27;
    var phi_3765_: type_27;
    var phi_3766_: bool;
    var phi_3770_: type_27;
    var phi_3771_: bool;
    var phi_3775_: type_27;
    var phi_3776_: bool;
    var phi_3780_: type_27;
    var phi_3803_: u32;
    var phi_3817_: i32;
    var phi_3837_: vec3<f32>;
    var phi_3838_: vec3<f32>;
    var phi_3854_: vec3<f32>;
    var phi_3855_: vec3<f32>;
    var phi_3871_: vec3<f32>;
    var phi_3872_: vec3<f32>;
    var phi_3908_: vec3<f32>;
    var phi_4090_: f32;
    var phi_4108_: bool;
    var phi_4109_: bool;
    var phi_4114_: type_45;
    var phi_4115_: type_45;
    var phi_3069_: type_45;
    var phi_5151_: bool;
    var local_12: type_45;
    var phi_5235_: bool;
    var phi_4960_: type_45;
    var phi_4961_: type_62;
    var phi_4962_: bool;
    var phi_4963_: u32;
    var phi_5234_: bool;
    var phi_4964_: type_45;
    var phi_4965_: type_62;
    var phi_4966_: u32;
    var phi_4967_: bool;
    var phi_4968_: u32;
    var phi_5233_: bool;
    var phi_4969_: type_45;
    var phi_4970_: type_62;
    var phi_4971_: u32;
    var phi_4972_: bool;
    var phi_4973_: u32;
    var phi_5232_: bool;
    var phi_2984_: type_45;
    var phi_2987_: type_62;
    var phi_2989_: u32;
    var phi_2991_: bool;
    var phi_2993_: u32;
    var phi_4974_: bool;
    var phi_5231_: bool;
    var local_13: type_45;
    var local_14: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e93 = arrayLength((&global_10.member));
            let _e95 = arrayLength((&global_5.member));
            let _e107 = arrayLength((&global_8.member));
            let _e111 = global_4.member[0u][0u];
            let _e115 = global_4.member[0u][1u];
            let _e119 = global_4.member[0u][2u];
            let _e123 = global_4.member[1u][0u];
            let _e127 = global_4.member[1u][1u];
            let _e131 = global_4.member[1u][2u];
            let _e135 = global_4.member[1u][3u];
            let _e139 = (_e90.x + (_e90.y * 2097152u));
            let _e146 = (_e139 < arrayLength((&global_9.member)));
            if _e146 {
                if _e146 {
                } else {
                    break;
                }
                let _e150 = global_9.member[_e139].member_2;
                phi_276_ = _e150;
            } else {
                phi_276_ = 4294967295u;
            }
            let _e152 = phi_276_;
            let _e155 = global_1.member[0u];
            let _e159 = global_3.member[0u][0u];
            let _e163 = global_3.member[0u][1u];
            let _e167 = global_3.member[0u][2u];
            let _e171 = global_3.member[0u][3u];
            let _e175 = global_3.member[1u][0u];
            let _e179 = global_3.member[1u][1u];
            let _e183 = global_3.member[1u][2u];
            let _e187 = global_3.member[1u][3u];
            let _e188 = bitcast<f32>(_e159);
            let _e189 = bitcast<f32>(_e163);
            let _e190 = bitcast<f32>(_e167);
            let _e192 = bitcast<f32>(_e175);
            let _e193 = array<u32, 3>(_e179, _e183, _e187);
            let _e195 = bitcast<i32>(_e155);
            let _e196 = (_e195 / 2i);
            let _e201 = bitcast<f32>((bitcast<u32>((_e196 + 127i)) << bitcast<u32>(23i)));
            let _e207 = bitcast<f32>((bitcast<u32>(((_e195 - _e196) + 127i)) << bitcast<u32>(23i)));
            if (_e171 == 0u) {
                phi_341_ = type_41(array<f32, 3>(_e188, _e189, _e190), _e171, _e192, _e193);
            } else {
                phi_341_ = type_41(array<f32, 3>(((_e188 * _e201) * _e207), ((_e189 * _e201) * _e207), ((_e190 * _e201) * _e207)), _e171, ((_e192 * _e201) * _e207), _e193);
            }
            let _e220 = phi_341_;
            if _e146 {
                let _e221 = (_e139 < arrayLength((&global_2.member)));
                if _e221 {
                    if _e146 {
                    } else {
                        break;
                    }
                    let _e226 = global_9.member[_e139].member.member_1;
                    let _e231 = global_9.member[_e139].member.member_3;
                    if (_e226 <= _e231) {
                        let _e233 = (1u < _e107);
                        if _e233 {
                            if (0u < _e107) {
                            } else {
                                break;
                            }
                            let _e237 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e237 + 1u) < _e237) {
                                if _e233 {
                                } else {
                                    break;
                                }
                                let _e242 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e146 {
                        } else {
                            break;
                        }
                        let _e252 = global_9.member[_e139].member.member_2[0u];
                        let _e254 = (bitcast<u32>(_e252) & 2147483647u);
                        let _e260 = global_9.member[_e139].member.member_2[1u];
                        let _e262 = (bitcast<u32>(_e260) & 2147483647u);
                        let _e268 = global_9.member[_e139].member.member_2[2u];
                        let _e270 = (bitcast<u32>(_e268) & 2147483647u);
                        let _e276 = global_9.member[_e139].member.member[0u];
                        let _e278 = (bitcast<u32>(_e276) & 2147483647u);
                        let _e284 = global_9.member[_e139].member.member[1u];
                        let _e286 = (bitcast<u32>(_e284) & 2147483647u);
                        let _e292 = global_9.member[_e139].member.member[2u];
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
                                phi_491_ = (bitcast<i32>((_e318 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_491_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e318)), 32u, (_e318 == 0u))));
                            }
                            let _e332 = phi_491_;
                            phi_492_ = _e332;
                        } else {
                            phi_492_ = 0i;
                        }
                        let _e334 = phi_492_;
                        let _e335 = (_e254 == _e298);
                        if _e335 {
                            phi_502_ = true;
                        } else {
                            phi_502_ = (_e262 == _e298);
                        }
                        let _e338 = phi_502_;
                        let _e339 = select(1u, 0u, _e335);
                        if _e338 {
                            let _e340 = (_e339 + 1u);
                            phi_512_ = _e340;
                            phi_513_ = _e340;
                            phi_515_ = select(true, false, (_e340 == 2u));
                        } else {
                            phi_512_ = u32();
                            phi_513_ = 0u;
                            phi_515_ = true;
                        }
                        let _e344 = phi_512_;
                        let _e346 = phi_513_;
                        let _e348 = phi_515_;
                        if _e348 {
                            phi_520_ = (_e346 + 1u);
                        } else {
                            phi_520_ = 0u;
                        }
                        let _e352 = phi_520_;
                        let _e353 = select(_e344, _e346, _e348);
                        let _e354 = select(_e339, select(2u, _e339, _e338), _e348);
                        let _e355 = -(_e334);
                        let _e356 = (_e355 / 2i);
                        let _e361 = bitcast<f32>((bitcast<u32>((_e356 + 127i)) << bitcast<u32>(23i)));
                        let _e367 = bitcast<f32>((bitcast<u32>(((_e355 - _e356) + 127i)) << bitcast<u32>(23i)));
                        let _e372 = global_9.member[_e139].member.member;
                        let _e373 = (_e353 == 0u);
                        if _e373 {
                            phi_565_ = _e372[0];
                        } else {
                            phi_565_ = _e372[1];
                        }
                        let _e377 = phi_565_;
                        let _e378 = (_e353 == 2u);
                        if _e378 {
                            phi_571_ = _e372[2];
                        } else {
                            phi_571_ = _e377;
                        }
                        let _e381 = phi_571_;
                        let _e382 = global_9.member[_e139].member.member_2;
                        if _e373 {
                            phi_582_ = _e382[0];
                        } else {
                            phi_582_ = _e382[1];
                        }
                        let _e386 = phi_582_;
                        if _e378 {
                            phi_588_ = _e382[2];
                        } else {
                            phi_588_ = _e386;
                        }
                        let _e389 = phi_588_;
                        let _e391 = ((_e389 * _e361) * _e367);
                        let _e395 = (bitcast<f32>((bitcast<u32>(_e391) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e395 {
                            let _e399 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) * 0.00000011920929f);
                            phi_611_ = select(0.00000000000011368684f, _e399, (_e399 > 0.00000000000011368684f));
                        } else {
                            phi_611_ = 0f;
                        }
                        let _e403 = phi_611_;
                        let _e404 = (_e381 + _e403);
                        let _e405 = (_e381 - _e403);
                        let _e406 = select(_e391, 0f, _e395);
                        if _e395 {
                            phi_622_ = 38685626000000000000000000f;
                        } else {
                            phi_622_ = (1f / _e391);
                        }
                        let _e409 = phi_622_;
                        let _e410 = (_e352 == 0u);
                        if _e410 {
                            phi_631_ = _e372[0];
                        } else {
                            phi_631_ = _e372[1];
                        }
                        let _e414 = phi_631_;
                        let _e415 = (_e352 == 2u);
                        if _e415 {
                            phi_637_ = _e372[2];
                        } else {
                            phi_637_ = _e414;
                        }
                        let _e418 = phi_637_;
                        if _e410 {
                            phi_648_ = _e382[0];
                        } else {
                            phi_648_ = _e382[1];
                        }
                        let _e422 = phi_648_;
                        if _e415 {
                            phi_654_ = _e382[2];
                        } else {
                            phi_654_ = _e422;
                        }
                        let _e425 = phi_654_;
                        let _e427 = ((_e425 * _e361) * _e367);
                        let _e431 = (bitcast<f32>((bitcast<u32>(_e427) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e431 {
                            let _e435 = (bitcast<f32>((bitcast<u32>(_e418) & 2147483647u)) * 0.00000011920929f);
                            phi_677_ = select(0.00000000000011368684f, _e435, (_e435 > 0.00000000000011368684f));
                        } else {
                            phi_677_ = 0f;
                        }
                        let _e439 = phi_677_;
                        let _e440 = (_e418 + _e439);
                        let _e441 = (_e418 - _e439);
                        let _e442 = select(_e427, 0f, _e431);
                        if _e431 {
                            phi_688_ = 38685626000000000000000000f;
                        } else {
                            phi_688_ = (1f / _e427);
                        }
                        let _e445 = phi_688_;
                        let _e446 = (_e354 == 0u);
                        if _e446 {
                            phi_697_ = _e372[0];
                        } else {
                            phi_697_ = _e372[1];
                        }
                        let _e450 = phi_697_;
                        let _e451 = (_e354 == 2u);
                        if _e451 {
                            phi_703_ = _e372[2];
                        } else {
                            phi_703_ = _e450;
                        }
                        let _e454 = phi_703_;
                        if _e446 {
                            phi_714_ = _e382[0];
                        } else {
                            phi_714_ = _e382[1];
                        }
                        let _e458 = phi_714_;
                        if _e451 {
                            phi_720_ = _e382[2];
                        } else {
                            phi_720_ = _e458;
                        }
                        let _e461 = phi_720_;
                        let _e463 = ((_e461 * _e361) * _e367);
                        let _e467 = (bitcast<f32>((bitcast<u32>(_e463) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e467 {
                            let _e471 = (bitcast<f32>((bitcast<u32>(_e454) & 2147483647u)) * 0.00000011920929f);
                            phi_743_ = select(0.00000000000011368684f, _e471, (_e471 > 0.00000000000011368684f));
                        } else {
                            phi_743_ = 0f;
                        }
                        let _e475 = phi_743_;
                        let _e476 = (_e454 + _e475);
                        let _e477 = (_e454 - _e475);
                        let _e478 = select(_e463, 0f, _e467);
                        if _e467 {
                            phi_754_ = 38685626000000000000000000f;
                        } else {
                            phi_754_ = (1f / _e463);
                        }
                        let _e481 = phi_754_;
                        let _e484 = bitcast<f32>((bitcast<u32>(_e381) & 2147483647u));
                        let _e487 = bitcast<f32>((bitcast<u32>(_e418) & 2147483647u));
                        let _e489 = select(_e487, _e484, (_e484 > _e487));
                        let _e492 = bitcast<f32>((bitcast<u32>(_e454) & 2147483647u));
                        if (_e315 && (select(_e492, _e489, (_e489 > _e492)) <= 1099511600000f)) {
                            let _e497 = (_e334 / 3i);
                            let _e504 = bitcast<f32>((bitcast<u32>((_e497 + 127i)) << bitcast<u32>(23i)));
                            let _e511 = bitcast<f32>((bitcast<u32>(((_e334 - (2i * _e497)) + 127i)) << bitcast<u32>(23i)));
                            let _e512 = (((_e226 * _e504) * _e504) * _e511);
                            let _e514 = select(340282350000000000000000000000000000000f, _e512, (_e512 < 340282350000000000000000000000000000000f));
                            let _e519 = (((_e231 * _e504) * _e504) * _e511);
                            let _e521 = select(340282350000000000000000000000000000000f, _e519, (_e519 < 340282350000000000000000000000000000000f));
                            phi_854_ = select(-340282350000000000000000000000000000000f, _e521, (_e521 > -340282350000000000000000000000000000000f));
                            phi_855_ = select(-340282350000000000000000000000000000000f, _e514, (_e514 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_854_ = 0f;
                            phi_855_ = 1f;
                        }
                        let _e525 = phi_854_;
                        let _e527 = phi_855_;
                        local_3 = array<type_62, 128>(type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_11 = array<f32, 3>(bitcast<f32>(_e111), bitcast<f32>(_e115), bitcast<f32>(_e119));
                        let _e532 = (_e353 % 3u);
                        let _e533 = (_e532 < 3u);
                        if _e533 {
                        } else {
                            break;
                        }
                        let _e535 = local_11[_e532];
                        let _e536 = (_e352 % 3u);
                        let _e537 = (_e536 < 3u);
                        if _e537 {
                        } else {
                            break;
                        }
                        let _e539 = local_11[_e536];
                        let _e540 = (_e354 % 3u);
                        let _e541 = (_e540 < 3u);
                        if _e541 {
                        } else {
                            break;
                        }
                        let _e543 = local_11[_e540];
                        local_10 = array<f32, 3>(bitcast<f32>(_e123), bitcast<f32>(_e127), bitcast<f32>(_e131));
                        if _e533 {
                        } else {
                            break;
                        }
                        let _e547 = local_10[_e532];
                        if _e537 {
                        } else {
                            break;
                        }
                        let _e549 = local_10[_e536];
                        if _e541 {
                        } else {
                            break;
                        }
                        let _e551 = local_10[_e540];
                        phi_5089_ = false;
                        phi_2983_ = type_45(_e525, false);
                        phi_2986_ = type_62(type_59(array<f32, 3>(_e535, _e539, _e543), array<f32, 3>(_e547, _e549, _e551)), select(0u, 2147483648u, (_e93 == 0u)));
                        phi_2988_ = ((3u * _e93) + 1u);
                        phi_2990_ = (_e527 <= _e525);
                        phi_2992_ = 0u;
                        loop {
                            let _e559 = phi_5089_;
                            let _e561 = phi_2983_;
                            let _e563 = phi_2986_;
                            let _e565 = phi_2988_;
                            let _e567 = phi_2990_;
                            let _e569 = phi_2992_;
                            local_13 = _e561;
                            if _e567 {
                                phi_3003_ = true;
                            } else {
                                phi_3003_ = (_e569 > 0u);
                            }
                            let _e572 = phi_3003_;
                            if _e572 {
                                let _e573 = (_e565 > 0u);
                                if _e573 {
                                    if _e567 {
                                        phi_3048_ = _e563;
                                        phi_3049_ = _e567;
                                        phi_3050_ = _e569;
                                    } else {
                                        let _e574 = (_e569 - 1u);
                                        let _e575 = (_e574 % 128u);
                                        let _e576 = (_e575 < 128u);
                                        if _e576 {
                                        } else {
                                            phi_5231_ = true;
                                            break;
                                        }
                                        let _e578 = local_3[_e575];
                                        if _e576 {
                                        } else {
                                            phi_5231_ = true;
                                            break;
                                        }
                                        let _e594 = local_2[_e575];
                                        phi_3048_ = type_62(type_59(array<f32, 3>(_e578.member.member[0], _e578.member.member[1], _e578.member.member[2]), array<f32, 3>(_e578.member.member_1[0], _e578.member.member_1[1], _e578.member.member_1[2])), _e578.member_1);
                                        phi_3049_ = (_e594 <= _e561.member);
                                        phi_3050_ = _e574;
                                    }
                                    let _e598 = phi_3048_;
                                    let _e600 = phi_3049_;
                                    let _e602 = phi_3050_;
                                    if _e600 {
                                        if ((_e598.member_1 & 2147483648u) != 0u) {
                                            phi_3068_ = _e561;
                                            phi_3071_ = type_8(0u, ((_e598.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e924 = phi_3068_;
                                                let _e926 = phi_3071_;
                                                local_12 = _e924;
                                                local_14 = _e924;
                                                if (_e926.member < _e926.member_1) {
                                                    phi_3072_ = type_8((_e926.member + 1u), _e926.member_1);
                                                    phi_3094_ = type_8(1u, _e926.member);
                                                } else {
                                                    phi_3072_ = _e926;
                                                    phi_3094_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e939 = phi_3072_;
                                                let _e941 = phi_3094_;
                                                let _e945 = (bitcast<i32>(_e941.member) != 0i);
                                                if _e945 {
                                                    let _e946 = ((_e598.member_1 & 268435455u) + _e941.member_1);
                                                    let _e947 = (_e946 < _e95);
                                                    if _e947 {
                                                        if _e947 {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        let _e951 = global_5.member[_e946].member_1;
                                                        phi_3115_ = _e951;
                                                    } else {
                                                        phi_3115_ = 4294967295u;
                                                    }
                                                    let _e953 = phi_3115_;
                                                    if (_e946 >= _e95) {
                                                        phi_3204_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e947 {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        if (_e532 < 9u) {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        let _e960 = global_5.member[_e946].member[_e532];
                                                        if (_e536 < 9u) {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        let _e966 = global_5.member[_e946].member[_e536];
                                                        if (_e540 < 9u) {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        let _e972 = global_5.member[_e946].member[_e540];
                                                        let _e974 = (3u + _e532);
                                                        if (_e974 < 9u) {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        let _e980 = global_5.member[_e946].member[_e974];
                                                        let _e981 = (3u + _e536);
                                                        if (_e981 < 9u) {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        let _e987 = global_5.member[_e946].member[_e981];
                                                        let _e988 = (3u + _e540);
                                                        if (_e988 < 9u) {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        let _e994 = global_5.member[_e946].member[_e988];
                                                        let _e996 = (6u + _e532);
                                                        if (_e996 < 9u) {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        let _e1002 = global_5.member[_e946].member[_e996];
                                                        let _e1003 = (6u + _e536);
                                                        if (_e1003 < 9u) {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        let _e1009 = global_5.member[_e946].member[_e1003];
                                                        let _e1010 = (6u + _e540);
                                                        if (_e1010 < 9u) {
                                                        } else {
                                                            phi_5151_ = true;
                                                            break;
                                                        }
                                                        let _e1016 = global_5.member[_e946].member[_e1010];
                                                        phi_3204_ = array<array<f32, 3>, 3>(array<f32, 3>(_e960, _e966, _e972), array<f32, 3>(_e980, _e987, _e994), array<f32, 3>(_e1002, _e1009, _e1016));
                                                    }
                                                    let _e1020 = phi_3204_;
                                                    let _e1028 = (_e1020[0][2] - _e454);
                                                    let _e1031 = (((_e1020[0][0] - _e381) * _e478) - (_e1028 * _e406));
                                                    let _e1034 = (((_e1020[0][1] - _e418) * _e478) - (_e1028 * _e442));
                                                    let _e1041 = (_e1020[1][2] - _e454);
                                                    let _e1044 = (((_e1020[1][0] - _e381) * _e478) - (_e1041 * _e406));
                                                    let _e1047 = (((_e1020[1][1] - _e418) * _e478) - (_e1041 * _e442));
                                                    let _e1054 = (_e1020[2][2] - _e454);
                                                    let _e1057 = (((_e1020[2][0] - _e381) * _e478) - (_e1054 * _e406));
                                                    let _e1060 = (((_e1020[2][1] - _e418) * _e478) - (_e1054 * _e442));
                                                    let _e1061 = (_e1057 * _e1047);
                                                    let _e1062 = (_e1060 * _e1044);
                                                    let _e1063 = (_e1031 * _e1060);
                                                    let _e1064 = (_e1034 * _e1057);
                                                    let _e1065 = (_e1044 * _e1034);
                                                    let _e1066 = (_e1047 * _e1031);
                                                    let _e1071 = (((_e1061 >= _e1062) && (_e1063 >= _e1064)) && (_e1065 >= _e1066));
                                                    if (_e1071 || (((_e1061 <= _e1062) && (_e1063 <= _e1064)) && (_e1065 <= _e1066))) {
                                                        let _e1078 = select(-1f, 1f, _e1071);
                                                        let _e1080 = ((_e1061 - _e1062) * _e1078);
                                                        let _e1082 = select(0f, _e1080, (_e1080 > 0f));
                                                        let _e1084 = ((_e1063 - _e1064) * _e1078);
                                                        let _e1086 = select(0f, _e1084, (_e1084 > 0f));
                                                        let _e1088 = ((_e1065 - _e1066) * _e1078);
                                                        let _e1090 = select(0f, _e1088, (_e1088 > 0f));
                                                        let _e1092 = ((_e1082 + _e1086) + _e1090);
                                                        if (_e1092 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3770_ = type_27();
                                                            phi_3771_ = true;
                                                        } else {
                                                            let _e1095 = select(_e1020[1][0], _e1020[0][0], (_e1020[0][0] < _e1020[1][0]));
                                                            let _e1099 = select(_e1020[1][0], _e1020[0][0], (_e1020[0][0] > _e1020[1][0]));
                                                            let _e1103 = select(_e1020[1][1], _e1020[0][1], (_e1020[0][1] < _e1020[1][1]));
                                                            let _e1107 = select(_e1020[1][1], _e1020[0][1], (_e1020[0][1] > _e1020[1][1]));
                                                            let _e1111 = select(_e1020[1][2], _e1020[0][2], (_e1020[0][2] < _e1020[1][2]));
                                                            let _e1115 = select(_e1020[1][2], _e1020[0][2], (_e1020[0][2] > _e1020[1][2]));
                                                            let _e1120 = ((select(_e1020[2][0], _e1095, (_e1095 < _e1020[2][0])) - _e404) * _e409);
                                                            let _e1121 = ((select(_e1020[2][0], _e1099, (_e1099 > _e1020[2][0])) - _e405) * _e409);
                                                            let _e1124 = ((select(_e1020[2][1], _e1103, (_e1103 < _e1020[2][1])) - _e440) * _e445);
                                                            let _e1125 = ((select(_e1020[2][1], _e1107, (_e1107 > _e1020[2][1])) - _e441) * _e445);
                                                            let _e1128 = ((select(_e1020[2][2], _e1111, (_e1111 < _e1020[2][2])) - _e476) * _e481);
                                                            let _e1129 = ((select(_e1020[2][2], _e1115, (_e1115 > _e1020[2][2])) - _e477) * _e481);
                                                            let _e1131 = select(_e1129, _e1128, (_e1128 < _e1129));
                                                            let _e1133 = select(_e1129, _e1128, (_e1128 > _e1129));
                                                            let _e1135 = select(_e1121, _e1120, (_e1120 < _e1121));
                                                            let _e1137 = select(_e1125, _e1124, (_e1124 < _e1125));
                                                            let _e1139 = select(_e1137, _e1135, (_e1135 > _e1137));
                                                            let _e1141 = select(_e1131, _e1139, (_e1139 > _e1131));
                                                            let _e1143 = select(_e1121, _e1120, (_e1120 > _e1121));
                                                            let _e1145 = select(_e1125, _e1124, (_e1124 > _e1125));
                                                            let _e1147 = select(_e1145, _e1143, (_e1143 < _e1145));
                                                            let _e1149 = select(_e1133, _e1147, (_e1147 < _e1133));
                                                            let _e1150 = -(_e1131);
                                                            let _e1156 = select(_e527, _e1141, (_e1141 > _e527));
                                                            if (_e1156 > (_e1149 + (select(_e1150, _e1133, (_e1133 > _e1150)) * 0.0000019073523f))) {
                                                                phi_3765_ = type_27();
                                                                phi_3766_ = true;
                                                            } else {
                                                                let _e1158 = (_e1156 > _e924.member);
                                                                if _e1158 {
                                                                    phi_3764_ = type_27();
                                                                } else {
                                                                    let _e1162 = (_e1020[1][0] - _e1020[0][0]);
                                                                    let _e1163 = (_e1020[1][1] - _e1020[0][1]);
                                                                    let _e1164 = (_e1020[1][2] - _e1020[0][2]);
                                                                    let _e1165 = vec3<f32>(_e1162, _e1163, _e1164);
                                                                    let _e1166 = (_e1020[2][0] - _e1020[1][0]);
                                                                    let _e1167 = (_e1020[2][1] - _e1020[1][1]);
                                                                    let _e1168 = (_e1020[2][2] - _e1020[1][2]);
                                                                    let _e1169 = vec3<f32>(_e1166, _e1167, _e1168);
                                                                    let _e1170 = (_e1020[0][0] - _e1020[2][0]);
                                                                    let _e1171 = (_e1020[0][1] - _e1020[2][1]);
                                                                    let _e1172 = (_e1020[0][2] - _e1020[2][2]);
                                                                    let _e1173 = vec3<f32>(_e1170, _e1171, _e1172);
                                                                    let _e1176 = bitcast<f32>((bitcast<u32>(_e1162) & 2147483647u));
                                                                    let _e1179 = bitcast<f32>((bitcast<u32>(_e1163) & 2147483647u));
                                                                    let _e1181 = select(_e1179, _e1176, (_e1176 > _e1179));
                                                                    let _e1184 = bitcast<f32>((bitcast<u32>(_e1164) & 2147483647u));
                                                                    let _e1186 = select(_e1184, _e1181, (_e1181 > _e1184));
                                                                    let _e1189 = bitcast<f32>((bitcast<u32>(_e1166) & 2147483647u));
                                                                    let _e1192 = bitcast<f32>((bitcast<u32>(_e1167) & 2147483647u));
                                                                    let _e1194 = select(_e1192, _e1189, (_e1189 > _e1192));
                                                                    let _e1197 = bitcast<f32>((bitcast<u32>(_e1168) & 2147483647u));
                                                                    let _e1199 = select(_e1197, _e1194, (_e1194 > _e1197));
                                                                    let _e1202 = bitcast<f32>((bitcast<u32>(_e1170) & 2147483647u));
                                                                    let _e1205 = bitcast<f32>((bitcast<u32>(_e1171) & 2147483647u));
                                                                    let _e1207 = select(_e1205, _e1202, (_e1202 > _e1205));
                                                                    let _e1210 = bitcast<f32>((bitcast<u32>(_e1172) & 2147483647u));
                                                                    let _e1212 = select(_e1210, _e1207, (_e1207 > _e1210));
                                                                    let _e1214 = select(_e1199, _e1186, (_e1186 > _e1199));
                                                                    let _e1216 = select(_e1212, _e1214, (_e1214 > _e1212));
                                                                    if (_e1186 == _e1216) {
                                                                        phi_3675_ = _e1169;
                                                                        phi_3676_ = _e1173;
                                                                    } else {
                                                                        let _e1219 = vec3((_e1199 == _e1216));
                                                                        phi_3675_ = select(_e1165, _e1173, _e1219);
                                                                        phi_3676_ = select(_e1169, _e1165, _e1219);
                                                                    }
                                                                    let _e1223 = phi_3675_;
                                                                    let _e1225 = phi_3676_;
                                                                    let _e1232 = ((_e1223.y * _e1225.z) - (_e1225.y * _e1223.z));
                                                                    let _e1237 = ((_e1223.z * _e1225.x) - (_e1225.z * _e1223.x));
                                                                    let _e1240 = ((_e1223.x * _e1225.y) - (_e1225.x * _e1223.y));
                                                                    if (_e1082 >= _e1086) {
                                                                        phi_3707_ = select(true, false, (_e1082 >= _e1090));
                                                                    } else {
                                                                        phi_3707_ = true;
                                                                    }
                                                                    let _e1245 = phi_3707_;
                                                                    if _e1245 {
                                                                        phi_3716_ = select(vec3<f32>(_e1020[2][0], _e1020[2][1], _e1020[2][2]), vec3<f32>(_e1020[1][0], _e1020[1][1], _e1020[1][2]), vec3((_e1086 >= _e1090)));
                                                                    } else {
                                                                        phi_3716_ = vec3<f32>(_e1020[0][0], _e1020[0][1], _e1020[0][2]);
                                                                    }
                                                                    let _e1250 = phi_3716_;
                                                                    let _e1267 = ((((_e1232 * (_e1250.x - _e381)) + (_e1237 * (_e1250.y - _e418))) + (_e1240 * (_e1250.z - _e454))) / (((_e1232 * _e406) + (_e1237 * _e442)) + (_e1240 * _e478)));
                                                                    let _e1269 = select(_e1149, _e1267, (_e1267 < _e1149));
                                                                    let _e1271 = select(_e1141, _e1269, (_e1269 > _e1141));
                                                                    if (_e1271 >= _e527) {
                                                                        let _e1273 = (_e1271 <= _e924.member);
                                                                        if _e1273 {
                                                                            let _e1274 = (1f / _e1092);
                                                                            phi_3756_ = type_27(_e1271, (_e1086 * _e1274), (_e1090 * _e1274), _e953);
                                                                        } else {
                                                                            phi_3756_ = type_27();
                                                                        }
                                                                        let _e1279 = phi_3756_;
                                                                        phi_3758_ = _e1279;
                                                                        phi_3759_ = select(true, false, _e1273);
                                                                    } else {
                                                                        phi_3758_ = type_27();
                                                                        phi_3759_ = true;
                                                                    }
                                                                    let _e1282 = phi_3758_;
                                                                    let _e1284 = phi_3759_;
                                                                    if _e1284 {
                                                                        phi_3763_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3763_ = _e1282;
                                                                    }
                                                                    let _e1286 = phi_3763_;
                                                                    phi_3764_ = _e1286;
                                                                }
                                                                let _e1288 = phi_3764_;
                                                                phi_3765_ = _e1288;
                                                                phi_3766_ = _e1158;
                                                            }
                                                            let _e1290 = phi_3765_;
                                                            let _e1292 = phi_3766_;
                                                            phi_3770_ = _e1290;
                                                            phi_3771_ = _e1292;
                                                        }
                                                        let _e1294 = phi_3770_;
                                                        let _e1296 = phi_3771_;
                                                        phi_3775_ = _e1294;
                                                        phi_3776_ = _e1296;
                                                    } else {
                                                        phi_3775_ = type_27();
                                                        phi_3776_ = true;
                                                    }
                                                    let _e1298 = phi_3775_;
                                                    let _e1300 = phi_3776_;
                                                    if _e1300 {
                                                        phi_3780_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3780_ = _e1298;
                                                    }
                                                    let _e1302 = phi_3780_;
                                                    if (_e1302.member_3 != 4294967295u) {
                                                        if (_e953 == _e152) {
                                                            phi_4109_ = false;
                                                        } else {
                                                            let _e1306 = (_e953 < arrayLength((&global_6.member)));
                                                            if _e1306 {
                                                                if _e1306 {
                                                                } else {
                                                                    phi_5151_ = true;
                                                                    break;
                                                                }
                                                                let _e1308 = global_6.member[_e953];
                                                                phi_3803_ = _e1308;
                                                            } else {
                                                                phi_3803_ = 4294967295u;
                                                            }
                                                            let _e1310 = phi_3803_;
                                                            let _e1311 = (_e1310 < arrayLength((&global_7.member)));
                                                            if _e1311 {
                                                                if _e1311 {
                                                                } else {
                                                                    phi_5151_ = true;
                                                                    break;
                                                                }
                                                                let _e1313 = global_7.member[_e1310];
                                                                phi_3817_ = _e1313;
                                                            } else {
                                                                phi_3817_ = 0i;
                                                            }
                                                            let _e1315 = phi_3817_;
                                                            let _e1316 = (_e1315 == 0i);
                                                            if _e1316 {
                                                                phi_4108_ = true;
                                                            } else {
                                                                if _e373 {
                                                                    phi_3838_ = vec3<f32>(_e1020[0][0], _e1020[0][1], _e1020[0][2]);
                                                                } else {
                                                                    if (_e353 == 1u) {
                                                                        phi_3837_ = vec3<f32>(_e1020[0][2], _e1020[0][0], _e1020[0][1]);
                                                                    } else {
                                                                        phi_3837_ = vec3<f32>(_e1020[0][1], _e1020[0][2], _e1020[0][0]);
                                                                    }
                                                                    let _e1321 = phi_3837_;
                                                                    phi_3838_ = _e1321;
                                                                }
                                                                let _e1324 = phi_3838_;
                                                                if _e373 {
                                                                    phi_3855_ = vec3<f32>(_e1020[1][0], _e1020[1][1], _e1020[1][2]);
                                                                } else {
                                                                    if (_e353 == 1u) {
                                                                        phi_3854_ = vec3<f32>(_e1020[1][2], _e1020[1][0], _e1020[1][1]);
                                                                    } else {
                                                                        phi_3854_ = vec3<f32>(_e1020[1][1], _e1020[1][2], _e1020[1][0]);
                                                                    }
                                                                    let _e1329 = phi_3854_;
                                                                    phi_3855_ = _e1329;
                                                                }
                                                                let _e1332 = phi_3855_;
                                                                if _e373 {
                                                                    phi_3872_ = vec3<f32>(_e1020[2][0], _e1020[2][1], _e1020[2][2]);
                                                                } else {
                                                                    if (_e353 == 1u) {
                                                                        phi_3871_ = vec3<f32>(_e1020[2][2], _e1020[2][0], _e1020[2][1]);
                                                                    } else {
                                                                        phi_3871_ = vec3<f32>(_e1020[2][1], _e1020[2][2], _e1020[2][0]);
                                                                    }
                                                                    let _e1337 = phi_3871_;
                                                                    phi_3872_ = _e1337;
                                                                }
                                                                let _e1340 = phi_3872_;
                                                                let _e1343 = (_e1332.x - _e1324.x);
                                                                let _e1346 = (_e1332.y - _e1324.y);
                                                                let _e1349 = (_e1332.z - _e1324.z);
                                                                let _e1351 = (_e1340.x - _e1324.x);
                                                                let _e1353 = (_e1340.y - _e1324.y);
                                                                let _e1355 = (_e1340.z - _e1324.z);
                                                                if (_e220.member_1 == 1u) {
                                                                    phi_3908_ = (vec3<f32>(_e220.member[0], _e220.member[1], _e220.member[2]) - _e1324);
                                                                } else {
                                                                    phi_3908_ = vec3<f32>(_e220.member[0], _e220.member[1], _e220.member[2]);
                                                                }
                                                                let _e1370 = phi_3908_;
                                                                let _e1376 = bitcast<f32>((bitcast<u32>((_e1343 * _e1353)) ^ _e220.member_3[0]));
                                                                let _e1380 = bitcast<f32>((bitcast<u32>((_e1346 * _e1351)) ^ _e220.member_3[0]));
                                                                let _e1384 = bitcast<f32>((bitcast<u32>((_e1346 * _e1355)) ^ _e220.member_3[0]));
                                                                let _e1388 = bitcast<f32>((bitcast<u32>((_e1349 * _e1353)) ^ _e220.member_3[0]));
                                                                let _e1392 = bitcast<f32>((bitcast<u32>((_e1349 * _e1351)) ^ _e220.member_3[0]));
                                                                let _e1396 = bitcast<f32>((bitcast<u32>((_e1343 * _e1355)) ^ _e220.member_3[0]));
                                                                let _e1397 = (_e1384 - _e1388);
                                                                let _e1398 = (_e1392 - _e1396);
                                                                let _e1399 = (_e1376 - _e1380);
                                                                let _e1423 = (bitcast<f32>((bitcast<u32>(_e1384) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1388) & 2147483647u)));
                                                                let _e1430 = (bitcast<f32>((bitcast<u32>(_e1392) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1396) & 2147483647u)));
                                                                let _e1437 = (bitcast<f32>((bitcast<u32>(_e1376) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1380) & 2147483647u)));
                                                                if (_e220.member_2 == 0f) {
                                                                    phi_4090_ = 0f;
                                                                } else {
                                                                    let _e1467 = bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u));
                                                                    let _e1470 = bitcast<f32>((bitcast<u32>(_e1398) & 2147483647u));
                                                                    let _e1473 = bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u));
                                                                    let _e1475 = select(_e1473, _e1470, (_e1470 > _e1473));
                                                                    let _e1479 = select(_e1473, _e1470, (_e1470 < _e1473));
                                                                    let _e1483 = select(_e1470, _e1467, (_e1467 < _e1470));
                                                                    let _e1485 = select(_e1470, _e1467, (_e1467 > _e1470));
                                                                    let _e1487 = select(_e1473, _e1485, (_e1485 < _e1473));
                                                                    phi_4090_ = bitcast<f32>((bitcast<u32>((_e220.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1475, _e1467, (_e1467 > _e1475)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1487, _e1483, (_e1483 > _e1487)))) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1479, _e1467, (_e1467 < _e1479)))) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1423 + _e1430) + _e1437))) ^ _e220.member_3[0]))) * 1.0000005f)) ^ _e220.member_3[0])))) ^ _e220.member_3[0]));
                                                                }
                                                                let _e1514 = phi_4090_;
                                                                phi_4108_ = (_e1316 || !(((((bitcast<f32>((bitcast<u32>((_e1370.x * _e1397)) ^ _e220.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1370.y * _e1398)) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1370.z * _e1399)) ^ _e220.member_3[0]))) * f32(-(_e1315))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1370.x) & 2147483647u)) * _e1423)) ^ _e220.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1370.y) & 2147483647u)) * _e1430)) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1370.z) & 2147483647u)) * _e1437)) ^ _e220.member_3[0]))))) ^ _e220.member_3[0])) + _e1514) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1528 = phi_4108_;
                                                            phi_4109_ = _e1528;
                                                        }
                                                        let _e1530 = phi_4109_;
                                                        if _e1530 {
                                                            phi_4114_ = type_45(_e924.member, true);
                                                        } else {
                                                            phi_4114_ = _e924;
                                                        }
                                                        let _e1535 = phi_4114_;
                                                        phi_4115_ = _e1535;
                                                    } else {
                                                        phi_4115_ = _e924;
                                                    }
                                                    let _e1537 = phi_4115_;
                                                    phi_3069_ = _e1537;
                                                } else {
                                                    phi_3069_ = type_45();
                                                }
                                                let _e1539 = phi_3069_;
                                                continue;
                                                continuing {
                                                    phi_3068_ = _e1539;
                                                    phi_3071_ = _e939;
                                                    phi_5151_ = _e559;
                                                    break if !(_e945);
                                                }
                                            }
                                            let _e1542 = phi_5151_;
                                            phi_5231_ = _e1542;
                                            if _e1542 {
                                                break;
                                            }
                                            let _e1544 = local_12;
                                            phi_5235_ = _e1542;
                                            let _e1730 = local_14;
                                            phi_4960_ = _e1730;
                                            phi_4961_ = _e598;
                                            phi_4962_ = false;
                                            phi_4963_ = select(_e602, 0u, _e1544.member_1);
                                        } else {
                                            local_1 = array<f32, 3>(_e598.member.member[0], _e598.member.member[1], _e598.member.member[2]);
                                            local = array<f32, 3>(_e598.member.member_1[0], _e598.member.member_1[1], _e598.member.member_1[2]);
                                            let _e622 = (_e598.member_1 < _e93);
                                            if _e622 {
                                                if _e622 {
                                                } else {
                                                    phi_5231_ = true;
                                                    break;
                                                }
                                                let _e624 = global_10.member[_e598.member_1];
                                                phi_4150_ = _e624;
                                            } else {
                                                phi_4150_ = type_54(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e626 = phi_4150_;
                                            let _e628 = array<u32, 3>(_e353, _e352, _e354);
                                            local_9 = _e628;
                                            local_5 = array<f32, 3>(0f, 0f, 0f);
                                            local_4 = array<f32, 3>(0f, 0f, 0f);
                                            phi_4159_ = type_8(0u, 3u);
                                            loop {
                                                let _e630 = phi_4159_;
                                                if (_e630.member < _e630.member_1) {
                                                    phi_4160_ = type_8((_e630.member + 1u), _e630.member_1);
                                                    phi_4183_ = type_8(1u, _e630.member);
                                                } else {
                                                    phi_4160_ = _e630;
                                                    phi_4183_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e643 = phi_4160_;
                                                let _e645 = phi_4183_;
                                                let _e649 = (bitcast<i32>(_e645.member) != 0i);
                                                if _e649 {
                                                    let _e650 = (_e645.member_1 < 3u);
                                                    if _e650 {
                                                    } else {
                                                        phi_5082_ = true;
                                                        break;
                                                    }
                                                    let _e652 = local_9[_e645.member_1];
                                                    if _e650 {
                                                    } else {
                                                        phi_5082_ = true;
                                                        break;
                                                    }
                                                    let _e654 = local_1[_e645.member_1];
                                                    if _e650 {
                                                    } else {
                                                        phi_5082_ = true;
                                                        break;
                                                    }
                                                    let _e656 = local[_e645.member_1];
                                                    let _e659 = ((10u * _e652) & 31u);
                                                    let _e662 = ((_e626.member[0] >> bitcast<u32>(_e659)) & 1023u);
                                                    let _e667 = bitcast<f32>((bitcast<u32>(((_e656 - _e654) * 0.0009775171f)) ^ _e135));
                                                    let _e673 = (_e654 + bitcast<f32>((bitcast<u32>((f32(_e662) * _e667)) ^ _e135)));
                                                    if _e650 {
                                                    } else {
                                                        phi_5082_ = true;
                                                        break;
                                                    }
                                                    local_5[_e645.member_1] = select(select(_e656, _e673, (_e673 < _e656)), _e656, (_e662 == 1023u));
                                                    let _e682 = ((_e626.member[1] >> bitcast<u32>(_e659)) & 1023u);
                                                    let _e688 = (_e654 + bitcast<f32>((bitcast<u32>((f32(_e682) * _e667)) ^ _e135)));
                                                    if _e650 {
                                                    } else {
                                                        phi_5082_ = true;
                                                        break;
                                                    }
                                                    local_4[_e645.member_1] = select(select(_e656, _e688, (_e688 < _e656)), _e656, (_e682 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_4159_ = _e643;
                                                    phi_5082_ = _e559;
                                                    break if !(_e649);
                                                }
                                            }
                                            let _e696 = phi_5082_;
                                            phi_5231_ = _e696;
                                            if _e696 {
                                                break;
                                            }
                                            let _e697 = local_4;
                                            let _e698 = local_5;
                                            local_8 = _e628;
                                            local_7 = array<f32, 3>(0f, 0f, 0f);
                                            local_6 = array<f32, 3>(0f, 0f, 0f);
                                            phi_4313_ = type_8(0u, 3u);
                                            loop {
                                                let _e707 = phi_4313_;
                                                if (_e707.member < _e707.member_1) {
                                                    phi_4314_ = type_8((_e707.member + 1u), _e707.member_1);
                                                    phi_4337_ = type_8(1u, _e707.member);
                                                } else {
                                                    phi_4314_ = _e707;
                                                    phi_4337_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e720 = phi_4314_;
                                                let _e722 = phi_4337_;
                                                let _e726 = (bitcast<i32>(_e722.member) != 0i);
                                                if _e726 {
                                                    let _e727 = (_e722.member_1 < 3u);
                                                    if _e727 {
                                                    } else {
                                                        phi_5143_ = true;
                                                        break;
                                                    }
                                                    let _e729 = local_8[_e722.member_1];
                                                    if _e727 {
                                                    } else {
                                                        phi_5143_ = true;
                                                        break;
                                                    }
                                                    let _e731 = local_1[_e722.member_1];
                                                    if _e727 {
                                                    } else {
                                                        phi_5143_ = true;
                                                        break;
                                                    }
                                                    let _e733 = local[_e722.member_1];
                                                    let _e736 = ((10u * _e729) & 31u);
                                                    let _e739 = ((_e626.member_1[0] >> bitcast<u32>(_e736)) & 1023u);
                                                    let _e744 = bitcast<f32>((bitcast<u32>(((_e733 - _e731) * 0.0009775171f)) ^ _e135));
                                                    let _e750 = (_e731 + bitcast<f32>((bitcast<u32>((f32(_e739) * _e744)) ^ _e135)));
                                                    if _e727 {
                                                    } else {
                                                        phi_5143_ = true;
                                                        break;
                                                    }
                                                    local_7[_e722.member_1] = select(select(_e733, _e750, (_e750 < _e733)), _e733, (_e739 == 1023u));
                                                    let _e759 = ((_e626.member_1[1] >> bitcast<u32>(_e736)) & 1023u);
                                                    let _e765 = (_e731 + bitcast<f32>((bitcast<u32>((f32(_e759) * _e744)) ^ _e135)));
                                                    if _e727 {
                                                    } else {
                                                        phi_5143_ = true;
                                                        break;
                                                    }
                                                    local_6[_e722.member_1] = select(select(_e733, _e765, (_e765 < _e733)), _e733, (_e759 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_4313_ = _e720;
                                                    phi_5143_ = _e696;
                                                    break if !(_e726);
                                                }
                                            }
                                            let _e773 = phi_5143_;
                                            phi_5231_ = _e773;
                                            if _e773 {
                                                break;
                                            }
                                            let _e774 = local_6;
                                            let _e775 = local_7;
                                            let _e786 = type_62(type_59(array<f32, 3>(_e698[0], _e698[1], _e698[2]), array<f32, 3>(_e697[0], _e697[1], _e697[2])), _e626.member_2);
                                            let _e791 = type_62(type_59(array<f32, 3>(_e775[0], _e775[1], _e775[2]), array<f32, 3>(_e774[0], _e774[1], _e774[2])), _e626.member_3);
                                            let _e797 = ((_e698[0] - _e404) * _e409);
                                            let _e798 = ((_e775[0] - _e404) * _e409);
                                            let _e799 = ((_e697[0] - _e405) * _e409);
                                            let _e800 = ((_e774[0] - _e405) * _e409);
                                            let _e805 = ((_e698[1] - _e440) * _e445);
                                            let _e806 = ((_e775[1] - _e440) * _e445);
                                            let _e807 = ((_e697[1] - _e441) * _e445);
                                            let _e808 = ((_e774[1] - _e441) * _e445);
                                            let _e813 = ((_e698[2] - _e476) * _e481);
                                            let _e814 = ((_e775[2] - _e476) * _e481);
                                            let _e815 = ((_e697[2] - _e477) * _e481);
                                            let _e816 = ((_e774[2] - _e477) * _e481);
                                            let _e818 = select(_e815, _e813, (_e813 < _e815));
                                            let _e820 = select(_e816, _e814, (_e814 < _e816));
                                            let _e822 = select(_e815, _e813, (_e813 > _e815));
                                            let _e824 = select(_e816, _e814, (_e814 > _e816));
                                            let _e826 = select(_e799, _e797, (_e797 < _e799));
                                            let _e828 = select(_e800, _e798, (_e798 < _e800));
                                            let _e830 = select(_e807, _e805, (_e805 < _e807));
                                            let _e832 = select(_e808, _e806, (_e806 < _e808));
                                            let _e834 = select(_e830, _e826, (_e826 > _e830));
                                            let _e836 = select(_e832, _e828, (_e828 > _e832));
                                            let _e838 = select(_e818, _e834, (_e834 > _e818));
                                            let _e840 = select(_e820, _e836, (_e836 > _e820));
                                            let _e842 = select(_e799, _e797, (_e797 > _e799));
                                            let _e844 = select(_e800, _e798, (_e798 > _e800));
                                            let _e846 = select(_e807, _e805, (_e805 > _e807));
                                            let _e848 = select(_e808, _e806, (_e806 > _e808));
                                            let _e850 = select(_e846, _e842, (_e842 < _e846));
                                            let _e852 = select(_e848, _e844, (_e844 < _e848));
                                            let _e857 = -(_e818);
                                            let _e858 = -(_e820);
                                            let _e865 = (select(_e822, _e850, (_e850 < _e822)) + (select(_e857, _e822, (_e822 > _e857)) * 0.0000019073523f));
                                            let _e866 = (select(_e824, _e852, (_e852 < _e824)) + (select(_e858, _e824, (_e824 > _e858)) * 0.0000019073523f));
                                            let _e868 = select(_e527, _e838, (_e838 > _e527));
                                            let _e870 = select(_e527, _e840, (_e840 > _e527));
                                            let _e875 = (_e868 <= select(_e561.member, _e865, (_e865 < _e561.member)));
                                            let _e876 = (_e870 <= select(_e561.member, _e866, (_e866 < _e561.member)));
                                            let _e877 = (_e868 <= _e870);
                                            if _e875 {
                                                if _e876 {
                                                    if _e877 {
                                                        phi_4900_ = _e791;
                                                    } else {
                                                        phi_4900_ = _e786;
                                                    }
                                                    let _e879 = phi_4900_;
                                                    let _e880 = (_e602 % 128u);
                                                    let _e881 = (_e880 < 128u);
                                                    if _e881 {
                                                    } else {
                                                        phi_5231_ = true;
                                                        break;
                                                    }
                                                    local_3[_e880] = type_62(type_59(array<f32, 3>(_e879.member.member[0], _e879.member.member[1], _e879.member.member[2]), array<f32, 3>(_e879.member.member_1[0], _e879.member.member_1[1], _e879.member.member_1[2])), _e879.member_1);
                                                    if _e881 {
                                                    } else {
                                                        phi_5231_ = true;
                                                        break;
                                                    }
                                                    local_2[_e880] = select(_e870, _e868, (_e868 > _e870));
                                                    if _e877 {
                                                        phi_4939_ = _e786;
                                                    } else {
                                                        phi_4939_ = _e791;
                                                    }
                                                    let _e902 = phi_4939_;
                                                    phi_4940_ = _e902;
                                                    phi_4941_ = (_e602 + 1u);
                                                } else {
                                                    phi_4940_ = type_62();
                                                    phi_4941_ = u32();
                                                }
                                                let _e904 = phi_4940_;
                                                let _e906 = phi_4941_;
                                                phi_4943_ = _e904;
                                                phi_4944_ = _e906;
                                                phi_4945_ = select(true, false, _e876);
                                            } else {
                                                phi_4943_ = type_62();
                                                phi_4944_ = u32();
                                                phi_4945_ = true;
                                            }
                                            let _e909 = phi_4943_;
                                            let _e911 = phi_4944_;
                                            let _e913 = phi_4945_;
                                            if _e913 {
                                                if _e875 {
                                                    phi_4952_ = _e786;
                                                } else {
                                                    phi_4952_ = _e791;
                                                }
                                                let _e915 = phi_4952_;
                                                phi_4957_ = _e915;
                                                phi_4958_ = select(_e876, true, _e875);
                                            } else {
                                                phi_4957_ = _e909;
                                                phi_4958_ = _e600;
                                            }
                                            let _e918 = phi_4957_;
                                            let _e920 = phi_4958_;
                                            phi_5235_ = _e773;
                                            phi_4960_ = _e561;
                                            phi_4961_ = _e918;
                                            phi_4962_ = _e920;
                                            phi_4963_ = select(_e911, _e602, _e913);
                                        }
                                        let _e1548 = phi_5235_;
                                        let _e1550 = phi_4960_;
                                        let _e1552 = phi_4961_;
                                        let _e1554 = phi_4962_;
                                        let _e1556 = phi_4963_;
                                        phi_5234_ = _e1548;
                                        phi_4964_ = _e1550;
                                        phi_4965_ = _e1552;
                                        phi_4966_ = (_e565 - 1u);
                                        phi_4967_ = _e1554;
                                        phi_4968_ = _e1556;
                                    } else {
                                        phi_5234_ = _e559;
                                        phi_4964_ = _e561;
                                        phi_4965_ = _e598;
                                        phi_4966_ = _e565;
                                        phi_4967_ = _e600;
                                        phi_4968_ = _e602;
                                    }
                                    let _e1558 = phi_5234_;
                                    let _e1560 = phi_4964_;
                                    let _e1562 = phi_4965_;
                                    let _e1564 = phi_4966_;
                                    let _e1566 = phi_4967_;
                                    let _e1568 = phi_4968_;
                                    phi_5233_ = _e1558;
                                    phi_4969_ = _e1560;
                                    phi_4970_ = _e1562;
                                    phi_4971_ = _e1564;
                                    phi_4972_ = _e1566;
                                    phi_4973_ = _e1568;
                                } else {
                                    phi_5233_ = _e559;
                                    phi_4969_ = type_45();
                                    phi_4970_ = type_62();
                                    phi_4971_ = u32();
                                    phi_4972_ = bool();
                                    phi_4973_ = u32();
                                }
                                let _e1570 = phi_5233_;
                                let _e1572 = phi_4969_;
                                let _e1574 = phi_4970_;
                                let _e1576 = phi_4971_;
                                let _e1578 = phi_4972_;
                                let _e1580 = phi_4973_;
                                phi_5232_ = _e1570;
                                phi_2984_ = _e1572;
                                phi_2987_ = _e1574;
                                phi_2989_ = _e1576;
                                phi_2991_ = _e1578;
                                phi_2993_ = _e1580;
                                phi_4974_ = _e573;
                            } else {
                                phi_5232_ = _e559;
                                phi_2984_ = type_45();
                                phi_2987_ = type_62();
                                phi_2989_ = u32();
                                phi_2991_ = bool();
                                phi_2993_ = u32();
                                phi_4974_ = false;
                            }
                            let _e1582 = phi_5232_;
                            let _e1584 = phi_2984_;
                            let _e1586 = phi_2987_;
                            let _e1588 = phi_2989_;
                            let _e1590 = phi_2991_;
                            let _e1592 = phi_2993_;
                            let _e1594 = phi_4974_;
                            continue;
                            continuing {
                                phi_5089_ = _e1582;
                                phi_2983_ = _e1584;
                                phi_2986_ = _e1586;
                                phi_2988_ = _e1588;
                                phi_2990_ = _e1590;
                                phi_2992_ = _e1592;
                                phi_5231_ = _e1582;
                                break if !(_e1594);
                            }
                        }
                        let _e1597 = phi_5231_;
                        if _e1597 {
                            break;
                        }
                        let _e1599 = local_13;
                        if _e1599.member_1 {
                        } else {
                            if _e221 {
                            } else {
                                break;
                            }
                            let _e1603 = global_2.member[_e139];
                            if _e146 {
                            } else {
                                break;
                            }
                            let _e1607 = global_9.member[_e139].member_1;
                            if _e221 {
                            } else {
                                break;
                            }
                            global_2.member[_e139] = type_29(_e1603.member, _e1603.member_1, _e1603.member_2, array<f32, 3>((_e1603.member_3[0] + (_e1607[0] * _e1603.member_1[0])), (_e1603.member_3[1] + (_e1607[1] * _e1603.member_1[1])), (_e1603.member_3[2] + (_e1607[2] * _e1603.member_1[2]))), _e1603.member_4);
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
fn trace_shadows_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
