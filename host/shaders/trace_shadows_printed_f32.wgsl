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
    var phi_277_: u32;
    var phi_321_: i32;
    var phi_345_: type_41;
    var phi_495_: i32;
    var phi_496_: i32;
    var phi_506_: bool;
    var phi_516_: u32;
    var phi_517_: u32;
    var phi_519_: bool;
    var phi_524_: u32;
    var phi_557_: i32;
    var phi_575_: f32;
    var phi_581_: f32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_621_: f32;
    var phi_632_: f32;
    var phi_641_: f32;
    var phi_647_: f32;
    var phi_658_: f32;
    var phi_664_: f32;
    var phi_687_: f32;
    var phi_698_: f32;
    var phi_707_: f32;
    var phi_713_: f32;
    var phi_724_: f32;
    var phi_730_: f32;
    var phi_753_: f32;
    var phi_764_: f32;
    var phi_864_: f32;
    var phi_865_: f32;
    var phi_5099_: bool;
    var phi_2993_: type_45;
    var phi_2996_: type_62;
    var phi_2998_: u32;
    var phi_3000_: bool;
    var phi_3002_: u32;
    var phi_3013_: bool;
    var phi_3058_: type_62;
    var phi_3059_: bool;
    var phi_3060_: u32;
    var phi_4160_: type_54;
    var phi_4169_: type_8;
    var phi_4170_: type_8;
    var phi_4193_: type_8;
    var phi_5092_: bool;
    var phi_4323_: type_8;
    var phi_4324_: type_8;
    var phi_4347_: type_8;
    var phi_5159_: bool;
    var phi_4910_: type_62;
    var phi_4949_: type_62;
    var phi_4950_: type_62;
    var phi_4951_: u32;
    var phi_4953_: type_62;
    var phi_4954_: u32;
    var phi_4955_: bool;
    var phi_4962_: type_62;
    var phi_4967_: type_62;
    var phi_4968_: bool;
    var phi_3078_: type_45;
    var phi_3081_: type_8;
    var phi_3082_: type_8;
    var phi_3104_: type_8;
    var phi_3125_: u32;
    var phi_3214_: array<array<f32, 3>, 3>;
    var phi_3685_: vec3<f32>;
    var phi_3686_: vec3<f32>;
    var phi_3717_: bool;
    var phi_3726_: vec3<f32>;
    var phi_3766_: type_27;
    var phi_3768_: type_27;
    var phi_3769_: bool;
    var phi_3773_: type_27;
    var phi_3774_: type_27;
    var phi_3775_: type_27;
    var phi_3776_: bool;
    var phi_3780_: type_27;
    var phi_3781_: bool;
    var phi_3785_: type_27;
    var phi_3786_: bool;
    var phi_3790_: type_27;
    var phi_3813_: u32;
    var phi_3827_: i32;
    var phi_3847_: vec3<f32>;
    var phi_3848_: vec3<f32>;
    var phi_3864_: vec3<f32>;
    var phi_3865_: vec3<f32>;
    var phi_3881_: vec3<f32>;
    var phi_3882_: vec3<f32>;
    var phi_3918_: vec3<f32>;
    var phi_4100_: f32;
    var phi_4118_: bool;
    var phi_4119_: bool;
    var phi_4124_: type_45;
    var phi_4125_: type_45;
    var phi_3079_: type_45;
    var phi_5167_: bool;
    var local_12: type_45;
    var phi_5251_: bool;
    var phi_4970_: type_45;
    var phi_4971_: type_62;
    var phi_4972_: bool;
    var phi_4973_: u32;
    var phi_5250_: bool;
    var phi_4974_: type_45;
    var phi_4975_: type_62;
    var phi_4976_: u32;
    var phi_4977_: bool;
    var phi_4978_: u32;
    var phi_5249_: bool;
    var phi_4979_: type_45;
    var phi_4980_: type_62;
    var phi_4981_: u32;
    var phi_4982_: bool;
    var phi_4983_: u32;
    var phi_5248_: bool;
    var phi_2994_: type_45;
    var phi_2997_: type_62;
    var phi_2999_: u32;
    var phi_3001_: bool;
    var phi_3003_: u32;
    var phi_4984_: bool;
    var phi_5247_: bool;
    var local_13: type_45;
    var local_14: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e94 = arrayLength((&global_10.member));
            let _e96 = arrayLength((&global_5.member));
            let _e108 = arrayLength((&global_8.member));
            let _e112 = global_4.member[0u][0u];
            let _e116 = global_4.member[0u][1u];
            let _e120 = global_4.member[0u][2u];
            let _e124 = global_4.member[1u][0u];
            let _e128 = global_4.member[1u][1u];
            let _e132 = global_4.member[1u][2u];
            let _e136 = global_4.member[1u][3u];
            let _e140 = (_e91.x + (_e91.y * 2097152u));
            let _e147 = (_e140 < arrayLength((&global_9.member)));
            if _e147 {
                if _e147 {
                } else {
                    break;
                }
                let _e151 = global_9.member[_e140].member_2;
                phi_277_ = _e151;
            } else {
                phi_277_ = 4294967295u;
            }
            let _e153 = phi_277_;
            let _e156 = global_1.member[0u];
            let _e160 = global_3.member[0u][0u];
            let _e164 = global_3.member[0u][1u];
            let _e168 = global_3.member[0u][2u];
            let _e172 = global_3.member[0u][3u];
            let _e176 = global_3.member[1u][0u];
            let _e180 = global_3.member[1u][1u];
            let _e184 = global_3.member[1u][2u];
            let _e188 = global_3.member[1u][3u];
            let _e189 = bitcast<f32>(_e160);
            let _e190 = bitcast<f32>(_e164);
            let _e191 = bitcast<f32>(_e168);
            let _e193 = bitcast<f32>(_e176);
            let _e194 = array<u32, 3>(_e180, _e184, _e188);
            let _e196 = bitcast<i32>(_e156);
            if (_e196 < -126i) {
                phi_321_ = -126i;
            } else {
                phi_321_ = select(_e196, 127i, (_e196 > 127i));
            }
            let _e201 = phi_321_;
            let _e206 = bitcast<f32>((bitcast<u32>((_e201 + 127i)) << bitcast<u32>(23i)));
            let _e212 = bitcast<f32>((bitcast<u32>(((_e196 - _e201) + 127i)) << bitcast<u32>(23i)));
            if (_e172 == 0u) {
                phi_345_ = type_41(array<f32, 3>(_e189, _e190, _e191), _e172, _e193, _e194);
            } else {
                phi_345_ = type_41(array<f32, 3>(((_e189 * _e206) * _e212), ((_e190 * _e206) * _e212), ((_e191 * _e206) * _e212)), _e172, ((_e193 * _e206) * _e212), _e194);
            }
            let _e225 = phi_345_;
            if _e147 {
                let _e226 = (_e140 < arrayLength((&global_2.member)));
                if _e226 {
                    if _e147 {
                    } else {
                        break;
                    }
                    let _e231 = global_9.member[_e140].member.member_1;
                    let _e236 = global_9.member[_e140].member.member_3;
                    if (_e231 <= _e236) {
                        let _e238 = (1u < _e108);
                        if _e238 {
                            if (0u < _e108) {
                            } else {
                                break;
                            }
                            let _e242 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e242 + 1u) < _e242) {
                                if _e238 {
                                } else {
                                    break;
                                }
                                let _e247 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e147 {
                        } else {
                            break;
                        }
                        let _e257 = global_9.member[_e140].member.member_2[0u];
                        let _e259 = (bitcast<u32>(_e257) & 2147483647u);
                        let _e265 = global_9.member[_e140].member.member_2[1u];
                        let _e267 = (bitcast<u32>(_e265) & 2147483647u);
                        let _e273 = global_9.member[_e140].member.member_2[2u];
                        let _e275 = (bitcast<u32>(_e273) & 2147483647u);
                        let _e281 = global_9.member[_e140].member.member[0u];
                        let _e283 = (bitcast<u32>(_e281) & 2147483647u);
                        let _e289 = global_9.member[_e140].member.member[1u];
                        let _e291 = (bitcast<u32>(_e289) & 2147483647u);
                        let _e297 = global_9.member[_e140].member.member[2u];
                        let _e299 = (bitcast<u32>(_e297) & 2147483647u);
                        let _e301 = select(_e267, _e259, (_e267 < _e259));
                        let _e303 = select(_e275, _e301, (_e275 < _e301));
                        let _e305 = select(_e283, _e303, (_e283 < _e303));
                        let _e307 = select(_e291, _e305, (_e291 < _e305));
                        let _e309 = select(_e299, _e307, (_e299 < _e307));
                        let _e311 = (bitcast<u32>(_e231) & 2147483647u);
                        let _e320 = (((select(_e311, _e309, (_e311 < _e309)) < 2139095040u) && ((bitcast<u32>(_e236) & 2147483647u) <= 2139095040u)) && (_e303 > 0u));
                        if _e320 {
                            let _e323 = (bitcast<u32>(bitcast<f32>(_e303)) & 2147483647u);
                            if (_e323 >= 8388608u) {
                                phi_495_ = (bitcast<i32>((_e323 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_495_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e323)), 32u, (_e323 == 0u))));
                            }
                            let _e337 = phi_495_;
                            phi_496_ = _e337;
                        } else {
                            phi_496_ = 0i;
                        }
                        let _e339 = phi_496_;
                        let _e340 = (_e259 == _e303);
                        if _e340 {
                            phi_506_ = true;
                        } else {
                            phi_506_ = (_e267 == _e303);
                        }
                        let _e343 = phi_506_;
                        let _e344 = select(1u, 0u, _e340);
                        if _e343 {
                            let _e345 = (_e344 + 1u);
                            phi_516_ = _e345;
                            phi_517_ = _e345;
                            phi_519_ = select(true, false, (_e345 == 2u));
                        } else {
                            phi_516_ = u32();
                            phi_517_ = 0u;
                            phi_519_ = true;
                        }
                        let _e349 = phi_516_;
                        let _e351 = phi_517_;
                        let _e353 = phi_519_;
                        if _e353 {
                            phi_524_ = (_e351 + 1u);
                        } else {
                            phi_524_ = 0u;
                        }
                        let _e357 = phi_524_;
                        let _e358 = select(_e349, _e351, _e353);
                        let _e359 = select(_e344, select(2u, _e344, _e343), _e353);
                        let _e360 = -(_e339);
                        if (_e360 < -126i) {
                            phi_557_ = -126i;
                        } else {
                            phi_557_ = select(_e360, 127i, (_e360 > 127i));
                        }
                        let _e365 = phi_557_;
                        let _e370 = bitcast<f32>((bitcast<u32>((_e365 + 127i)) << bitcast<u32>(23i)));
                        let _e376 = bitcast<f32>((bitcast<u32>(((_e360 - _e365) + 127i)) << bitcast<u32>(23i)));
                        let _e381 = global_9.member[_e140].member.member;
                        let _e382 = (_e358 == 0u);
                        if _e382 {
                            phi_575_ = _e381[0];
                        } else {
                            phi_575_ = _e381[1];
                        }
                        let _e386 = phi_575_;
                        let _e387 = (_e358 == 2u);
                        if _e387 {
                            phi_581_ = _e381[2];
                        } else {
                            phi_581_ = _e386;
                        }
                        let _e390 = phi_581_;
                        let _e391 = global_9.member[_e140].member.member_2;
                        if _e382 {
                            phi_592_ = _e391[0];
                        } else {
                            phi_592_ = _e391[1];
                        }
                        let _e395 = phi_592_;
                        if _e387 {
                            phi_598_ = _e391[2];
                        } else {
                            phi_598_ = _e395;
                        }
                        let _e398 = phi_598_;
                        let _e400 = ((_e398 * _e370) * _e376);
                        let _e404 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e404 {
                            let _e408 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                            phi_621_ = select(0.00000000000011368684f, _e408, (_e408 > 0.00000000000011368684f));
                        } else {
                            phi_621_ = 0f;
                        }
                        let _e412 = phi_621_;
                        let _e413 = (_e390 + _e412);
                        let _e414 = (_e390 - _e412);
                        let _e415 = select(_e400, 0f, _e404);
                        if _e404 {
                            phi_632_ = 38685626000000000000000000f;
                        } else {
                            phi_632_ = (1f / _e400);
                        }
                        let _e418 = phi_632_;
                        let _e419 = (_e357 == 0u);
                        if _e419 {
                            phi_641_ = _e381[0];
                        } else {
                            phi_641_ = _e381[1];
                        }
                        let _e423 = phi_641_;
                        let _e424 = (_e357 == 2u);
                        if _e424 {
                            phi_647_ = _e381[2];
                        } else {
                            phi_647_ = _e423;
                        }
                        let _e427 = phi_647_;
                        if _e419 {
                            phi_658_ = _e391[0];
                        } else {
                            phi_658_ = _e391[1];
                        }
                        let _e431 = phi_658_;
                        if _e424 {
                            phi_664_ = _e391[2];
                        } else {
                            phi_664_ = _e431;
                        }
                        let _e434 = phi_664_;
                        let _e436 = ((_e434 * _e370) * _e376);
                        let _e440 = (bitcast<f32>((bitcast<u32>(_e436) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e440 {
                            let _e444 = (bitcast<f32>((bitcast<u32>(_e427) & 2147483647u)) * 0.00000011920929f);
                            phi_687_ = select(0.00000000000011368684f, _e444, (_e444 > 0.00000000000011368684f));
                        } else {
                            phi_687_ = 0f;
                        }
                        let _e448 = phi_687_;
                        let _e449 = (_e427 + _e448);
                        let _e450 = (_e427 - _e448);
                        let _e451 = select(_e436, 0f, _e440);
                        if _e440 {
                            phi_698_ = 38685626000000000000000000f;
                        } else {
                            phi_698_ = (1f / _e436);
                        }
                        let _e454 = phi_698_;
                        let _e455 = (_e359 == 0u);
                        if _e455 {
                            phi_707_ = _e381[0];
                        } else {
                            phi_707_ = _e381[1];
                        }
                        let _e459 = phi_707_;
                        let _e460 = (_e359 == 2u);
                        if _e460 {
                            phi_713_ = _e381[2];
                        } else {
                            phi_713_ = _e459;
                        }
                        let _e463 = phi_713_;
                        if _e455 {
                            phi_724_ = _e391[0];
                        } else {
                            phi_724_ = _e391[1];
                        }
                        let _e467 = phi_724_;
                        if _e460 {
                            phi_730_ = _e391[2];
                        } else {
                            phi_730_ = _e467;
                        }
                        let _e470 = phi_730_;
                        let _e472 = ((_e470 * _e370) * _e376);
                        let _e476 = (bitcast<f32>((bitcast<u32>(_e472) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e476 {
                            let _e480 = (bitcast<f32>((bitcast<u32>(_e463) & 2147483647u)) * 0.00000011920929f);
                            phi_753_ = select(0.00000000000011368684f, _e480, (_e480 > 0.00000000000011368684f));
                        } else {
                            phi_753_ = 0f;
                        }
                        let _e484 = phi_753_;
                        let _e485 = (_e463 + _e484);
                        let _e486 = (_e463 - _e484);
                        let _e487 = select(_e472, 0f, _e476);
                        if _e476 {
                            phi_764_ = 38685626000000000000000000f;
                        } else {
                            phi_764_ = (1f / _e472);
                        }
                        let _e490 = phi_764_;
                        let _e493 = bitcast<f32>((bitcast<u32>(_e390) & 2147483647u));
                        let _e496 = bitcast<f32>((bitcast<u32>(_e427) & 2147483647u));
                        let _e498 = select(_e496, _e493, (_e493 > _e496));
                        let _e501 = bitcast<f32>((bitcast<u32>(_e463) & 2147483647u));
                        if (_e320 && (select(_e501, _e498, (_e498 > _e501)) <= 1099511600000f)) {
                            let _e506 = (_e339 / 3i);
                            let _e513 = bitcast<f32>((bitcast<u32>((_e506 + 127i)) << bitcast<u32>(23i)));
                            let _e520 = bitcast<f32>((bitcast<u32>(((_e339 - (2i * _e506)) + 127i)) << bitcast<u32>(23i)));
                            let _e521 = (((_e231 * _e513) * _e513) * _e520);
                            let _e523 = select(340282350000000000000000000000000000000f, _e521, (_e521 < 340282350000000000000000000000000000000f));
                            let _e528 = (((_e236 * _e513) * _e513) * _e520);
                            let _e530 = select(340282350000000000000000000000000000000f, _e528, (_e528 < 340282350000000000000000000000000000000f));
                            phi_864_ = select(-340282350000000000000000000000000000000f, _e530, (_e530 > -340282350000000000000000000000000000000f));
                            phi_865_ = select(-340282350000000000000000000000000000000f, _e523, (_e523 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_864_ = 0f;
                            phi_865_ = 1f;
                        }
                        let _e534 = phi_864_;
                        let _e536 = phi_865_;
                        local_3 = array<type_62, 128>(type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_59(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_11 = array<f32, 3>(bitcast<f32>(_e112), bitcast<f32>(_e116), bitcast<f32>(_e120));
                        let _e541 = (_e358 % 3u);
                        let _e542 = (_e541 < 3u);
                        if _e542 {
                        } else {
                            break;
                        }
                        let _e544 = local_11[_e541];
                        let _e545 = (_e357 % 3u);
                        let _e546 = (_e545 < 3u);
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e548 = local_11[_e545];
                        let _e549 = (_e359 % 3u);
                        let _e550 = (_e549 < 3u);
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e552 = local_11[_e549];
                        local_10 = array<f32, 3>(bitcast<f32>(_e124), bitcast<f32>(_e128), bitcast<f32>(_e132));
                        if _e542 {
                        } else {
                            break;
                        }
                        let _e556 = local_10[_e541];
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e558 = local_10[_e545];
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e560 = local_10[_e549];
                        phi_5099_ = false;
                        phi_2993_ = type_45(_e534, false);
                        phi_2996_ = type_62(type_59(array<f32, 3>(_e544, _e548, _e552), array<f32, 3>(_e556, _e558, _e560)), select(0u, 2147483648u, (_e94 == 0u)));
                        phi_2998_ = ((3u * _e94) + 1u);
                        phi_3000_ = (_e536 <= _e534);
                        phi_3002_ = 0u;
                        loop {
                            let _e568 = phi_5099_;
                            let _e570 = phi_2993_;
                            let _e572 = phi_2996_;
                            let _e574 = phi_2998_;
                            let _e576 = phi_3000_;
                            let _e578 = phi_3002_;
                            local_13 = _e570;
                            if _e576 {
                                phi_3013_ = true;
                            } else {
                                phi_3013_ = (_e578 > 0u);
                            }
                            let _e581 = phi_3013_;
                            if _e581 {
                                let _e582 = (_e574 > 0u);
                                if _e582 {
                                    if _e576 {
                                        phi_3058_ = _e572;
                                        phi_3059_ = _e576;
                                        phi_3060_ = _e578;
                                    } else {
                                        let _e583 = (_e578 - 1u);
                                        let _e584 = (_e583 % 128u);
                                        let _e585 = (_e584 < 128u);
                                        if _e585 {
                                        } else {
                                            phi_5247_ = true;
                                            break;
                                        }
                                        let _e587 = local_3[_e584];
                                        if _e585 {
                                        } else {
                                            phi_5247_ = true;
                                            break;
                                        }
                                        let _e603 = local_2[_e584];
                                        phi_3058_ = type_62(type_59(array<f32, 3>(_e587.member.member[0], _e587.member.member[1], _e587.member.member[2]), array<f32, 3>(_e587.member.member_1[0], _e587.member.member_1[1], _e587.member.member_1[2])), _e587.member_1);
                                        phi_3059_ = (_e603 <= _e570.member);
                                        phi_3060_ = _e583;
                                    }
                                    let _e607 = phi_3058_;
                                    let _e609 = phi_3059_;
                                    let _e611 = phi_3060_;
                                    if _e609 {
                                        if ((_e607.member_1 & 2147483648u) != 0u) {
                                            phi_3078_ = _e570;
                                            phi_3081_ = type_8(0u, ((_e607.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e933 = phi_3078_;
                                                let _e935 = phi_3081_;
                                                local_12 = _e933;
                                                local_14 = _e933;
                                                if (_e935.member < _e935.member_1) {
                                                    phi_3082_ = type_8((_e935.member + 1u), _e935.member_1);
                                                    phi_3104_ = type_8(1u, _e935.member);
                                                } else {
                                                    phi_3082_ = _e935;
                                                    phi_3104_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e948 = phi_3082_;
                                                let _e950 = phi_3104_;
                                                let _e954 = (bitcast<i32>(_e950.member) != 0i);
                                                if _e954 {
                                                    let _e955 = ((_e607.member_1 & 268435455u) + _e950.member_1);
                                                    let _e956 = (_e955 < _e96);
                                                    if _e956 {
                                                        if _e956 {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        let _e960 = global_5.member[_e955].member_1;
                                                        phi_3125_ = _e960;
                                                    } else {
                                                        phi_3125_ = 4294967295u;
                                                    }
                                                    let _e962 = phi_3125_;
                                                    if (_e955 >= _e96) {
                                                        phi_3214_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e956 {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        if (_e541 < 9u) {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        let _e969 = global_5.member[_e955].member[_e541];
                                                        if (_e545 < 9u) {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        let _e975 = global_5.member[_e955].member[_e545];
                                                        if (_e549 < 9u) {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        let _e981 = global_5.member[_e955].member[_e549];
                                                        let _e983 = (3u + _e541);
                                                        if (_e983 < 9u) {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        let _e989 = global_5.member[_e955].member[_e983];
                                                        let _e990 = (3u + _e545);
                                                        if (_e990 < 9u) {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        let _e996 = global_5.member[_e955].member[_e990];
                                                        let _e997 = (3u + _e549);
                                                        if (_e997 < 9u) {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        let _e1003 = global_5.member[_e955].member[_e997];
                                                        let _e1005 = (6u + _e541);
                                                        if (_e1005 < 9u) {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        let _e1011 = global_5.member[_e955].member[_e1005];
                                                        let _e1012 = (6u + _e545);
                                                        if (_e1012 < 9u) {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        let _e1018 = global_5.member[_e955].member[_e1012];
                                                        let _e1019 = (6u + _e549);
                                                        if (_e1019 < 9u) {
                                                        } else {
                                                            phi_5167_ = true;
                                                            break;
                                                        }
                                                        let _e1025 = global_5.member[_e955].member[_e1019];
                                                        phi_3214_ = array<array<f32, 3>, 3>(array<f32, 3>(_e969, _e975, _e981), array<f32, 3>(_e989, _e996, _e1003), array<f32, 3>(_e1011, _e1018, _e1025));
                                                    }
                                                    let _e1029 = phi_3214_;
                                                    let _e1037 = (_e1029[0][2] - _e463);
                                                    let _e1040 = (((_e1029[0][0] - _e390) * _e487) - (_e1037 * _e415));
                                                    let _e1043 = (((_e1029[0][1] - _e427) * _e487) - (_e1037 * _e451));
                                                    let _e1050 = (_e1029[1][2] - _e463);
                                                    let _e1053 = (((_e1029[1][0] - _e390) * _e487) - (_e1050 * _e415));
                                                    let _e1056 = (((_e1029[1][1] - _e427) * _e487) - (_e1050 * _e451));
                                                    let _e1063 = (_e1029[2][2] - _e463);
                                                    let _e1066 = (((_e1029[2][0] - _e390) * _e487) - (_e1063 * _e415));
                                                    let _e1069 = (((_e1029[2][1] - _e427) * _e487) - (_e1063 * _e451));
                                                    let _e1070 = (_e1066 * _e1056);
                                                    let _e1071 = (_e1069 * _e1053);
                                                    let _e1072 = (_e1040 * _e1069);
                                                    let _e1073 = (_e1043 * _e1066);
                                                    let _e1074 = (_e1053 * _e1043);
                                                    let _e1075 = (_e1056 * _e1040);
                                                    let _e1080 = (((_e1070 >= _e1071) && (_e1072 >= _e1073)) && (_e1074 >= _e1075));
                                                    if (_e1080 || (((_e1070 <= _e1071) && (_e1072 <= _e1073)) && (_e1074 <= _e1075))) {
                                                        let _e1087 = select(-1f, 1f, _e1080);
                                                        let _e1089 = ((_e1070 - _e1071) * _e1087);
                                                        let _e1091 = select(0f, _e1089, (_e1089 > 0f));
                                                        let _e1093 = ((_e1072 - _e1073) * _e1087);
                                                        let _e1095 = select(0f, _e1093, (_e1093 > 0f));
                                                        let _e1097 = ((_e1074 - _e1075) * _e1087);
                                                        let _e1099 = select(0f, _e1097, (_e1097 > 0f));
                                                        let _e1101 = ((_e1091 + _e1095) + _e1099);
                                                        if (_e1101 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3780_ = type_27();
                                                            phi_3781_ = true;
                                                        } else {
                                                            let _e1104 = select(_e1029[1][0], _e1029[0][0], (_e1029[0][0] < _e1029[1][0]));
                                                            let _e1108 = select(_e1029[1][0], _e1029[0][0], (_e1029[0][0] > _e1029[1][0]));
                                                            let _e1112 = select(_e1029[1][1], _e1029[0][1], (_e1029[0][1] < _e1029[1][1]));
                                                            let _e1116 = select(_e1029[1][1], _e1029[0][1], (_e1029[0][1] > _e1029[1][1]));
                                                            let _e1120 = select(_e1029[1][2], _e1029[0][2], (_e1029[0][2] < _e1029[1][2]));
                                                            let _e1124 = select(_e1029[1][2], _e1029[0][2], (_e1029[0][2] > _e1029[1][2]));
                                                            let _e1129 = ((select(_e1029[2][0], _e1104, (_e1104 < _e1029[2][0])) - _e413) * _e418);
                                                            let _e1130 = ((select(_e1029[2][0], _e1108, (_e1108 > _e1029[2][0])) - _e414) * _e418);
                                                            let _e1133 = ((select(_e1029[2][1], _e1112, (_e1112 < _e1029[2][1])) - _e449) * _e454);
                                                            let _e1134 = ((select(_e1029[2][1], _e1116, (_e1116 > _e1029[2][1])) - _e450) * _e454);
                                                            let _e1137 = ((select(_e1029[2][2], _e1120, (_e1120 < _e1029[2][2])) - _e485) * _e490);
                                                            let _e1138 = ((select(_e1029[2][2], _e1124, (_e1124 > _e1029[2][2])) - _e486) * _e490);
                                                            let _e1140 = select(_e1138, _e1137, (_e1137 < _e1138));
                                                            let _e1142 = select(_e1138, _e1137, (_e1137 > _e1138));
                                                            let _e1144 = select(_e1130, _e1129, (_e1129 < _e1130));
                                                            let _e1146 = select(_e1134, _e1133, (_e1133 < _e1134));
                                                            let _e1148 = select(_e1146, _e1144, (_e1144 > _e1146));
                                                            let _e1150 = select(_e1140, _e1148, (_e1148 > _e1140));
                                                            let _e1152 = select(_e1130, _e1129, (_e1129 > _e1130));
                                                            let _e1154 = select(_e1134, _e1133, (_e1133 > _e1134));
                                                            let _e1156 = select(_e1154, _e1152, (_e1152 < _e1154));
                                                            let _e1158 = select(_e1142, _e1156, (_e1156 < _e1142));
                                                            let _e1159 = -(_e1140);
                                                            let _e1165 = select(_e536, _e1150, (_e1150 > _e536));
                                                            if (_e1165 > (_e1158 + (select(_e1159, _e1142, (_e1142 > _e1159)) * 0.0000019073523f))) {
                                                                phi_3775_ = type_27();
                                                                phi_3776_ = true;
                                                            } else {
                                                                let _e1167 = (_e1165 > _e933.member);
                                                                if _e1167 {
                                                                    phi_3774_ = type_27();
                                                                } else {
                                                                    let _e1171 = (_e1029[1][0] - _e1029[0][0]);
                                                                    let _e1172 = (_e1029[1][1] - _e1029[0][1]);
                                                                    let _e1173 = (_e1029[1][2] - _e1029[0][2]);
                                                                    let _e1174 = vec3<f32>(_e1171, _e1172, _e1173);
                                                                    let _e1175 = (_e1029[2][0] - _e1029[1][0]);
                                                                    let _e1176 = (_e1029[2][1] - _e1029[1][1]);
                                                                    let _e1177 = (_e1029[2][2] - _e1029[1][2]);
                                                                    let _e1178 = vec3<f32>(_e1175, _e1176, _e1177);
                                                                    let _e1179 = (_e1029[0][0] - _e1029[2][0]);
                                                                    let _e1180 = (_e1029[0][1] - _e1029[2][1]);
                                                                    let _e1181 = (_e1029[0][2] - _e1029[2][2]);
                                                                    let _e1182 = vec3<f32>(_e1179, _e1180, _e1181);
                                                                    let _e1185 = bitcast<f32>((bitcast<u32>(_e1171) & 2147483647u));
                                                                    let _e1188 = bitcast<f32>((bitcast<u32>(_e1172) & 2147483647u));
                                                                    let _e1190 = select(_e1188, _e1185, (_e1185 > _e1188));
                                                                    let _e1193 = bitcast<f32>((bitcast<u32>(_e1173) & 2147483647u));
                                                                    let _e1195 = select(_e1193, _e1190, (_e1190 > _e1193));
                                                                    let _e1198 = bitcast<f32>((bitcast<u32>(_e1175) & 2147483647u));
                                                                    let _e1201 = bitcast<f32>((bitcast<u32>(_e1176) & 2147483647u));
                                                                    let _e1203 = select(_e1201, _e1198, (_e1198 > _e1201));
                                                                    let _e1206 = bitcast<f32>((bitcast<u32>(_e1177) & 2147483647u));
                                                                    let _e1208 = select(_e1206, _e1203, (_e1203 > _e1206));
                                                                    let _e1211 = bitcast<f32>((bitcast<u32>(_e1179) & 2147483647u));
                                                                    let _e1214 = bitcast<f32>((bitcast<u32>(_e1180) & 2147483647u));
                                                                    let _e1216 = select(_e1214, _e1211, (_e1211 > _e1214));
                                                                    let _e1219 = bitcast<f32>((bitcast<u32>(_e1181) & 2147483647u));
                                                                    let _e1221 = select(_e1219, _e1216, (_e1216 > _e1219));
                                                                    let _e1223 = select(_e1208, _e1195, (_e1195 > _e1208));
                                                                    let _e1225 = select(_e1221, _e1223, (_e1223 > _e1221));
                                                                    if (_e1195 == _e1225) {
                                                                        phi_3685_ = _e1178;
                                                                        phi_3686_ = _e1182;
                                                                    } else {
                                                                        let _e1228 = vec3((_e1208 == _e1225));
                                                                        phi_3685_ = select(_e1174, _e1182, _e1228);
                                                                        phi_3686_ = select(_e1178, _e1174, _e1228);
                                                                    }
                                                                    let _e1232 = phi_3685_;
                                                                    let _e1234 = phi_3686_;
                                                                    let _e1241 = ((_e1232.y * _e1234.z) - (_e1234.y * _e1232.z));
                                                                    let _e1246 = ((_e1232.z * _e1234.x) - (_e1234.z * _e1232.x));
                                                                    let _e1249 = ((_e1232.x * _e1234.y) - (_e1234.x * _e1232.y));
                                                                    if (_e1091 >= _e1095) {
                                                                        phi_3717_ = select(true, false, (_e1091 >= _e1099));
                                                                    } else {
                                                                        phi_3717_ = true;
                                                                    }
                                                                    let _e1254 = phi_3717_;
                                                                    if _e1254 {
                                                                        phi_3726_ = select(vec3<f32>(_e1029[2][0], _e1029[2][1], _e1029[2][2]), vec3<f32>(_e1029[1][0], _e1029[1][1], _e1029[1][2]), vec3((_e1095 >= _e1099)));
                                                                    } else {
                                                                        phi_3726_ = vec3<f32>(_e1029[0][0], _e1029[0][1], _e1029[0][2]);
                                                                    }
                                                                    let _e1259 = phi_3726_;
                                                                    let _e1276 = ((((_e1241 * (_e1259.x - _e390)) + (_e1246 * (_e1259.y - _e427))) + (_e1249 * (_e1259.z - _e463))) / (((_e1241 * _e415) + (_e1246 * _e451)) + (_e1249 * _e487)));
                                                                    let _e1278 = select(_e1158, _e1276, (_e1276 < _e1158));
                                                                    let _e1280 = select(_e1150, _e1278, (_e1278 > _e1150));
                                                                    if (_e1280 >= _e536) {
                                                                        let _e1282 = (_e1280 <= _e933.member);
                                                                        if _e1282 {
                                                                            let _e1283 = (1f / _e1101);
                                                                            phi_3766_ = type_27(_e1280, (_e1095 * _e1283), (_e1099 * _e1283), _e962);
                                                                        } else {
                                                                            phi_3766_ = type_27();
                                                                        }
                                                                        let _e1288 = phi_3766_;
                                                                        phi_3768_ = _e1288;
                                                                        phi_3769_ = select(true, false, _e1282);
                                                                    } else {
                                                                        phi_3768_ = type_27();
                                                                        phi_3769_ = true;
                                                                    }
                                                                    let _e1291 = phi_3768_;
                                                                    let _e1293 = phi_3769_;
                                                                    if _e1293 {
                                                                        phi_3773_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3773_ = _e1291;
                                                                    }
                                                                    let _e1295 = phi_3773_;
                                                                    phi_3774_ = _e1295;
                                                                }
                                                                let _e1297 = phi_3774_;
                                                                phi_3775_ = _e1297;
                                                                phi_3776_ = _e1167;
                                                            }
                                                            let _e1299 = phi_3775_;
                                                            let _e1301 = phi_3776_;
                                                            phi_3780_ = _e1299;
                                                            phi_3781_ = _e1301;
                                                        }
                                                        let _e1303 = phi_3780_;
                                                        let _e1305 = phi_3781_;
                                                        phi_3785_ = _e1303;
                                                        phi_3786_ = _e1305;
                                                    } else {
                                                        phi_3785_ = type_27();
                                                        phi_3786_ = true;
                                                    }
                                                    let _e1307 = phi_3785_;
                                                    let _e1309 = phi_3786_;
                                                    if _e1309 {
                                                        phi_3790_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3790_ = _e1307;
                                                    }
                                                    let _e1311 = phi_3790_;
                                                    if (_e1311.member_3 != 4294967295u) {
                                                        if (_e962 == _e153) {
                                                            phi_4119_ = false;
                                                        } else {
                                                            let _e1315 = (_e962 < arrayLength((&global_6.member)));
                                                            if _e1315 {
                                                                if _e1315 {
                                                                } else {
                                                                    phi_5167_ = true;
                                                                    break;
                                                                }
                                                                let _e1317 = global_6.member[_e962];
                                                                phi_3813_ = _e1317;
                                                            } else {
                                                                phi_3813_ = 4294967295u;
                                                            }
                                                            let _e1319 = phi_3813_;
                                                            let _e1320 = (_e1319 < arrayLength((&global_7.member)));
                                                            if _e1320 {
                                                                if _e1320 {
                                                                } else {
                                                                    phi_5167_ = true;
                                                                    break;
                                                                }
                                                                let _e1322 = global_7.member[_e1319];
                                                                phi_3827_ = _e1322;
                                                            } else {
                                                                phi_3827_ = 0i;
                                                            }
                                                            let _e1324 = phi_3827_;
                                                            let _e1325 = (_e1324 == 0i);
                                                            if _e1325 {
                                                                phi_4118_ = true;
                                                            } else {
                                                                if _e382 {
                                                                    phi_3848_ = vec3<f32>(_e1029[0][0], _e1029[0][1], _e1029[0][2]);
                                                                } else {
                                                                    if (_e358 == 1u) {
                                                                        phi_3847_ = vec3<f32>(_e1029[0][2], _e1029[0][0], _e1029[0][1]);
                                                                    } else {
                                                                        phi_3847_ = vec3<f32>(_e1029[0][1], _e1029[0][2], _e1029[0][0]);
                                                                    }
                                                                    let _e1330 = phi_3847_;
                                                                    phi_3848_ = _e1330;
                                                                }
                                                                let _e1333 = phi_3848_;
                                                                if _e382 {
                                                                    phi_3865_ = vec3<f32>(_e1029[1][0], _e1029[1][1], _e1029[1][2]);
                                                                } else {
                                                                    if (_e358 == 1u) {
                                                                        phi_3864_ = vec3<f32>(_e1029[1][2], _e1029[1][0], _e1029[1][1]);
                                                                    } else {
                                                                        phi_3864_ = vec3<f32>(_e1029[1][1], _e1029[1][2], _e1029[1][0]);
                                                                    }
                                                                    let _e1338 = phi_3864_;
                                                                    phi_3865_ = _e1338;
                                                                }
                                                                let _e1341 = phi_3865_;
                                                                if _e382 {
                                                                    phi_3882_ = vec3<f32>(_e1029[2][0], _e1029[2][1], _e1029[2][2]);
                                                                } else {
                                                                    if (_e358 == 1u) {
                                                                        phi_3881_ = vec3<f32>(_e1029[2][2], _e1029[2][0], _e1029[2][1]);
                                                                    } else {
                                                                        phi_3881_ = vec3<f32>(_e1029[2][1], _e1029[2][2], _e1029[2][0]);
                                                                    }
                                                                    let _e1346 = phi_3881_;
                                                                    phi_3882_ = _e1346;
                                                                }
                                                                let _e1349 = phi_3882_;
                                                                let _e1352 = (_e1341.x - _e1333.x);
                                                                let _e1355 = (_e1341.y - _e1333.y);
                                                                let _e1358 = (_e1341.z - _e1333.z);
                                                                let _e1360 = (_e1349.x - _e1333.x);
                                                                let _e1362 = (_e1349.y - _e1333.y);
                                                                let _e1364 = (_e1349.z - _e1333.z);
                                                                if (_e225.member_1 == 1u) {
                                                                    phi_3918_ = (vec3<f32>(_e225.member[0], _e225.member[1], _e225.member[2]) - _e1333);
                                                                } else {
                                                                    phi_3918_ = vec3<f32>(_e225.member[0], _e225.member[1], _e225.member[2]);
                                                                }
                                                                let _e1379 = phi_3918_;
                                                                let _e1385 = bitcast<f32>((bitcast<u32>((_e1352 * _e1362)) ^ _e225.member_3[0]));
                                                                let _e1389 = bitcast<f32>((bitcast<u32>((_e1355 * _e1360)) ^ _e225.member_3[0]));
                                                                let _e1393 = bitcast<f32>((bitcast<u32>((_e1355 * _e1364)) ^ _e225.member_3[0]));
                                                                let _e1397 = bitcast<f32>((bitcast<u32>((_e1358 * _e1362)) ^ _e225.member_3[0]));
                                                                let _e1401 = bitcast<f32>((bitcast<u32>((_e1358 * _e1360)) ^ _e225.member_3[0]));
                                                                let _e1405 = bitcast<f32>((bitcast<u32>((_e1352 * _e1364)) ^ _e225.member_3[0]));
                                                                let _e1406 = (_e1393 - _e1397);
                                                                let _e1407 = (_e1401 - _e1405);
                                                                let _e1408 = (_e1385 - _e1389);
                                                                let _e1432 = (bitcast<f32>((bitcast<u32>(_e1393) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u)));
                                                                let _e1439 = (bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1405) & 2147483647u)));
                                                                let _e1446 = (bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1389) & 2147483647u)));
                                                                if (_e225.member_2 == 0f) {
                                                                    phi_4100_ = 0f;
                                                                } else {
                                                                    let _e1476 = bitcast<f32>((bitcast<u32>(_e1406) & 2147483647u));
                                                                    let _e1479 = bitcast<f32>((bitcast<u32>(_e1407) & 2147483647u));
                                                                    let _e1482 = bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u));
                                                                    let _e1484 = select(_e1482, _e1479, (_e1479 > _e1482));
                                                                    let _e1488 = select(_e1482, _e1479, (_e1479 < _e1482));
                                                                    let _e1492 = select(_e1479, _e1476, (_e1476 < _e1479));
                                                                    let _e1494 = select(_e1479, _e1476, (_e1476 > _e1479));
                                                                    let _e1496 = select(_e1482, _e1494, (_e1494 < _e1482));
                                                                    phi_4100_ = bitcast<f32>((bitcast<u32>((_e225.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1484, _e1476, (_e1476 > _e1484)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1496, _e1492, (_e1492 > _e1496)))) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1488, _e1476, (_e1476 < _e1488)))) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1432 + _e1439) + _e1446))) ^ _e225.member_3[0]))) * 1.0000005f)) ^ _e225.member_3[0])))) ^ _e225.member_3[0]));
                                                                }
                                                                let _e1523 = phi_4100_;
                                                                phi_4118_ = (_e1325 || !(((((bitcast<f32>((bitcast<u32>((_e1379.x * _e1406)) ^ _e225.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1379.y * _e1407)) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1379.z * _e1408)) ^ _e225.member_3[0]))) * f32(-(_e1324))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1379.x) & 2147483647u)) * _e1432)) ^ _e225.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1379.y) & 2147483647u)) * _e1439)) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1379.z) & 2147483647u)) * _e1446)) ^ _e225.member_3[0]))))) ^ _e225.member_3[0])) + _e1523) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1537 = phi_4118_;
                                                            phi_4119_ = _e1537;
                                                        }
                                                        let _e1539 = phi_4119_;
                                                        if _e1539 {
                                                            phi_4124_ = type_45(_e933.member, true);
                                                        } else {
                                                            phi_4124_ = _e933;
                                                        }
                                                        let _e1544 = phi_4124_;
                                                        phi_4125_ = _e1544;
                                                    } else {
                                                        phi_4125_ = _e933;
                                                    }
                                                    let _e1546 = phi_4125_;
                                                    phi_3079_ = _e1546;
                                                } else {
                                                    phi_3079_ = type_45();
                                                }
                                                let _e1548 = phi_3079_;
                                                continue;
                                                continuing {
                                                    phi_3078_ = _e1548;
                                                    phi_3081_ = _e948;
                                                    phi_5167_ = _e568;
                                                    break if !(_e954);
                                                }
                                            }
                                            let _e1551 = phi_5167_;
                                            phi_5247_ = _e1551;
                                            if _e1551 {
                                                break;
                                            }
                                            let _e1553 = local_12;
                                            phi_5251_ = _e1551;
                                            let _e1741 = local_14;
                                            phi_4970_ = _e1741;
                                            phi_4971_ = _e607;
                                            phi_4972_ = false;
                                            phi_4973_ = select(_e611, 0u, _e1553.member_1);
                                        } else {
                                            local_1 = array<f32, 3>(_e607.member.member[0], _e607.member.member[1], _e607.member.member[2]);
                                            local = array<f32, 3>(_e607.member.member_1[0], _e607.member.member_1[1], _e607.member.member_1[2]);
                                            let _e631 = (_e607.member_1 < _e94);
                                            if _e631 {
                                                if _e631 {
                                                } else {
                                                    phi_5247_ = true;
                                                    break;
                                                }
                                                let _e633 = global_10.member[_e607.member_1];
                                                phi_4160_ = _e633;
                                            } else {
                                                phi_4160_ = type_54(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e635 = phi_4160_;
                                            let _e637 = array<u32, 3>(_e358, _e357, _e359);
                                            local_9 = _e637;
                                            local_5 = array<f32, 3>(0f, 0f, 0f);
                                            local_4 = array<f32, 3>(0f, 0f, 0f);
                                            phi_4169_ = type_8(0u, 3u);
                                            loop {
                                                let _e639 = phi_4169_;
                                                if (_e639.member < _e639.member_1) {
                                                    phi_4170_ = type_8((_e639.member + 1u), _e639.member_1);
                                                    phi_4193_ = type_8(1u, _e639.member);
                                                } else {
                                                    phi_4170_ = _e639;
                                                    phi_4193_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e652 = phi_4170_;
                                                let _e654 = phi_4193_;
                                                let _e658 = (bitcast<i32>(_e654.member) != 0i);
                                                if _e658 {
                                                    let _e659 = (_e654.member_1 < 3u);
                                                    if _e659 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    let _e661 = local_9[_e654.member_1];
                                                    if _e659 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    let _e663 = local_1[_e654.member_1];
                                                    if _e659 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    let _e665 = local[_e654.member_1];
                                                    let _e668 = ((10u * _e661) & 31u);
                                                    let _e671 = ((_e635.member[0] >> bitcast<u32>(_e668)) & 1023u);
                                                    let _e676 = bitcast<f32>((bitcast<u32>(((_e665 - _e663) * 0.0009775171f)) ^ _e136));
                                                    let _e682 = (_e663 + bitcast<f32>((bitcast<u32>((f32(_e671) * _e676)) ^ _e136)));
                                                    if _e659 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_5[_e654.member_1] = select(select(_e665, _e682, (_e682 < _e665)), _e665, (_e671 == 1023u));
                                                    let _e691 = ((_e635.member[1] >> bitcast<u32>(_e668)) & 1023u);
                                                    let _e697 = (_e663 + bitcast<f32>((bitcast<u32>((f32(_e691) * _e676)) ^ _e136)));
                                                    if _e659 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_4[_e654.member_1] = select(select(_e665, _e697, (_e697 < _e665)), _e665, (_e691 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_4169_ = _e652;
                                                    phi_5092_ = _e568;
                                                    break if !(_e658);
                                                }
                                            }
                                            let _e705 = phi_5092_;
                                            phi_5247_ = _e705;
                                            if _e705 {
                                                break;
                                            }
                                            let _e706 = local_4;
                                            let _e707 = local_5;
                                            local_8 = _e637;
                                            local_7 = array<f32, 3>(0f, 0f, 0f);
                                            local_6 = array<f32, 3>(0f, 0f, 0f);
                                            phi_4323_ = type_8(0u, 3u);
                                            loop {
                                                let _e716 = phi_4323_;
                                                if (_e716.member < _e716.member_1) {
                                                    phi_4324_ = type_8((_e716.member + 1u), _e716.member_1);
                                                    phi_4347_ = type_8(1u, _e716.member);
                                                } else {
                                                    phi_4324_ = _e716;
                                                    phi_4347_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e729 = phi_4324_;
                                                let _e731 = phi_4347_;
                                                let _e735 = (bitcast<i32>(_e731.member) != 0i);
                                                if _e735 {
                                                    let _e736 = (_e731.member_1 < 3u);
                                                    if _e736 {
                                                    } else {
                                                        phi_5159_ = true;
                                                        break;
                                                    }
                                                    let _e738 = local_8[_e731.member_1];
                                                    if _e736 {
                                                    } else {
                                                        phi_5159_ = true;
                                                        break;
                                                    }
                                                    let _e740 = local_1[_e731.member_1];
                                                    if _e736 {
                                                    } else {
                                                        phi_5159_ = true;
                                                        break;
                                                    }
                                                    let _e742 = local[_e731.member_1];
                                                    let _e745 = ((10u * _e738) & 31u);
                                                    let _e748 = ((_e635.member_1[0] >> bitcast<u32>(_e745)) & 1023u);
                                                    let _e753 = bitcast<f32>((bitcast<u32>(((_e742 - _e740) * 0.0009775171f)) ^ _e136));
                                                    let _e759 = (_e740 + bitcast<f32>((bitcast<u32>((f32(_e748) * _e753)) ^ _e136)));
                                                    if _e736 {
                                                    } else {
                                                        phi_5159_ = true;
                                                        break;
                                                    }
                                                    local_7[_e731.member_1] = select(select(_e742, _e759, (_e759 < _e742)), _e742, (_e748 == 1023u));
                                                    let _e768 = ((_e635.member_1[1] >> bitcast<u32>(_e745)) & 1023u);
                                                    let _e774 = (_e740 + bitcast<f32>((bitcast<u32>((f32(_e768) * _e753)) ^ _e136)));
                                                    if _e736 {
                                                    } else {
                                                        phi_5159_ = true;
                                                        break;
                                                    }
                                                    local_6[_e731.member_1] = select(select(_e742, _e774, (_e774 < _e742)), _e742, (_e768 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_4323_ = _e729;
                                                    phi_5159_ = _e705;
                                                    break if !(_e735);
                                                }
                                            }
                                            let _e782 = phi_5159_;
                                            phi_5247_ = _e782;
                                            if _e782 {
                                                break;
                                            }
                                            let _e783 = local_6;
                                            let _e784 = local_7;
                                            let _e795 = type_62(type_59(array<f32, 3>(_e707[0], _e707[1], _e707[2]), array<f32, 3>(_e706[0], _e706[1], _e706[2])), _e635.member_2);
                                            let _e800 = type_62(type_59(array<f32, 3>(_e784[0], _e784[1], _e784[2]), array<f32, 3>(_e783[0], _e783[1], _e783[2])), _e635.member_3);
                                            let _e806 = ((_e707[0] - _e413) * _e418);
                                            let _e807 = ((_e784[0] - _e413) * _e418);
                                            let _e808 = ((_e706[0] - _e414) * _e418);
                                            let _e809 = ((_e783[0] - _e414) * _e418);
                                            let _e814 = ((_e707[1] - _e449) * _e454);
                                            let _e815 = ((_e784[1] - _e449) * _e454);
                                            let _e816 = ((_e706[1] - _e450) * _e454);
                                            let _e817 = ((_e783[1] - _e450) * _e454);
                                            let _e822 = ((_e707[2] - _e485) * _e490);
                                            let _e823 = ((_e784[2] - _e485) * _e490);
                                            let _e824 = ((_e706[2] - _e486) * _e490);
                                            let _e825 = ((_e783[2] - _e486) * _e490);
                                            let _e827 = select(_e824, _e822, (_e822 < _e824));
                                            let _e829 = select(_e825, _e823, (_e823 < _e825));
                                            let _e831 = select(_e824, _e822, (_e822 > _e824));
                                            let _e833 = select(_e825, _e823, (_e823 > _e825));
                                            let _e835 = select(_e808, _e806, (_e806 < _e808));
                                            let _e837 = select(_e809, _e807, (_e807 < _e809));
                                            let _e839 = select(_e816, _e814, (_e814 < _e816));
                                            let _e841 = select(_e817, _e815, (_e815 < _e817));
                                            let _e843 = select(_e839, _e835, (_e835 > _e839));
                                            let _e845 = select(_e841, _e837, (_e837 > _e841));
                                            let _e847 = select(_e827, _e843, (_e843 > _e827));
                                            let _e849 = select(_e829, _e845, (_e845 > _e829));
                                            let _e851 = select(_e808, _e806, (_e806 > _e808));
                                            let _e853 = select(_e809, _e807, (_e807 > _e809));
                                            let _e855 = select(_e816, _e814, (_e814 > _e816));
                                            let _e857 = select(_e817, _e815, (_e815 > _e817));
                                            let _e859 = select(_e855, _e851, (_e851 < _e855));
                                            let _e861 = select(_e857, _e853, (_e853 < _e857));
                                            let _e866 = -(_e827);
                                            let _e867 = -(_e829);
                                            let _e874 = (select(_e831, _e859, (_e859 < _e831)) + (select(_e866, _e831, (_e831 > _e866)) * 0.0000019073523f));
                                            let _e875 = (select(_e833, _e861, (_e861 < _e833)) + (select(_e867, _e833, (_e833 > _e867)) * 0.0000019073523f));
                                            let _e877 = select(_e536, _e847, (_e847 > _e536));
                                            let _e879 = select(_e536, _e849, (_e849 > _e536));
                                            let _e884 = (_e877 <= select(_e570.member, _e874, (_e874 < _e570.member)));
                                            let _e885 = (_e879 <= select(_e570.member, _e875, (_e875 < _e570.member)));
                                            let _e886 = (_e877 <= _e879);
                                            if _e884 {
                                                if _e885 {
                                                    if _e886 {
                                                        phi_4910_ = _e800;
                                                    } else {
                                                        phi_4910_ = _e795;
                                                    }
                                                    let _e888 = phi_4910_;
                                                    let _e889 = (_e611 % 128u);
                                                    let _e890 = (_e889 < 128u);
                                                    if _e890 {
                                                    } else {
                                                        phi_5247_ = true;
                                                        break;
                                                    }
                                                    local_3[_e889] = type_62(type_59(array<f32, 3>(_e888.member.member[0], _e888.member.member[1], _e888.member.member[2]), array<f32, 3>(_e888.member.member_1[0], _e888.member.member_1[1], _e888.member.member_1[2])), _e888.member_1);
                                                    if _e890 {
                                                    } else {
                                                        phi_5247_ = true;
                                                        break;
                                                    }
                                                    local_2[_e889] = select(_e879, _e877, (_e877 > _e879));
                                                    if _e886 {
                                                        phi_4949_ = _e795;
                                                    } else {
                                                        phi_4949_ = _e800;
                                                    }
                                                    let _e911 = phi_4949_;
                                                    phi_4950_ = _e911;
                                                    phi_4951_ = (_e611 + 1u);
                                                } else {
                                                    phi_4950_ = type_62();
                                                    phi_4951_ = u32();
                                                }
                                                let _e913 = phi_4950_;
                                                let _e915 = phi_4951_;
                                                phi_4953_ = _e913;
                                                phi_4954_ = _e915;
                                                phi_4955_ = select(true, false, _e885);
                                            } else {
                                                phi_4953_ = type_62();
                                                phi_4954_ = u32();
                                                phi_4955_ = true;
                                            }
                                            let _e918 = phi_4953_;
                                            let _e920 = phi_4954_;
                                            let _e922 = phi_4955_;
                                            if _e922 {
                                                if _e884 {
                                                    phi_4962_ = _e795;
                                                } else {
                                                    phi_4962_ = _e800;
                                                }
                                                let _e924 = phi_4962_;
                                                phi_4967_ = _e924;
                                                phi_4968_ = select(_e885, true, _e884);
                                            } else {
                                                phi_4967_ = _e918;
                                                phi_4968_ = _e609;
                                            }
                                            let _e927 = phi_4967_;
                                            let _e929 = phi_4968_;
                                            phi_5251_ = _e782;
                                            phi_4970_ = _e570;
                                            phi_4971_ = _e927;
                                            phi_4972_ = _e929;
                                            phi_4973_ = select(_e920, _e611, _e922);
                                        }
                                        let _e1557 = phi_5251_;
                                        let _e1559 = phi_4970_;
                                        let _e1561 = phi_4971_;
                                        let _e1563 = phi_4972_;
                                        let _e1565 = phi_4973_;
                                        phi_5250_ = _e1557;
                                        phi_4974_ = _e1559;
                                        phi_4975_ = _e1561;
                                        phi_4976_ = (_e574 - 1u);
                                        phi_4977_ = _e1563;
                                        phi_4978_ = _e1565;
                                    } else {
                                        phi_5250_ = _e568;
                                        phi_4974_ = _e570;
                                        phi_4975_ = _e607;
                                        phi_4976_ = _e574;
                                        phi_4977_ = _e609;
                                        phi_4978_ = _e611;
                                    }
                                    let _e1567 = phi_5250_;
                                    let _e1569 = phi_4974_;
                                    let _e1571 = phi_4975_;
                                    let _e1573 = phi_4976_;
                                    let _e1575 = phi_4977_;
                                    let _e1577 = phi_4978_;
                                    phi_5249_ = _e1567;
                                    phi_4979_ = _e1569;
                                    phi_4980_ = _e1571;
                                    phi_4981_ = _e1573;
                                    phi_4982_ = _e1575;
                                    phi_4983_ = _e1577;
                                } else {
                                    phi_5249_ = _e568;
                                    phi_4979_ = type_45();
                                    phi_4980_ = type_62();
                                    phi_4981_ = u32();
                                    phi_4982_ = bool();
                                    phi_4983_ = u32();
                                }
                                let _e1579 = phi_5249_;
                                let _e1581 = phi_4979_;
                                let _e1583 = phi_4980_;
                                let _e1585 = phi_4981_;
                                let _e1587 = phi_4982_;
                                let _e1589 = phi_4983_;
                                phi_5248_ = _e1579;
                                phi_2994_ = _e1581;
                                phi_2997_ = _e1583;
                                phi_2999_ = _e1585;
                                phi_3001_ = _e1587;
                                phi_3003_ = _e1589;
                                phi_4984_ = _e582;
                            } else {
                                phi_5248_ = _e568;
                                phi_2994_ = type_45();
                                phi_2997_ = type_62();
                                phi_2999_ = u32();
                                phi_3001_ = bool();
                                phi_3003_ = u32();
                                phi_4984_ = false;
                            }
                            let _e1591 = phi_5248_;
                            let _e1593 = phi_2994_;
                            let _e1595 = phi_2997_;
                            let _e1597 = phi_2999_;
                            let _e1599 = phi_3001_;
                            let _e1601 = phi_3003_;
                            let _e1603 = phi_4984_;
                            continue;
                            continuing {
                                phi_5099_ = _e1591;
                                phi_2993_ = _e1593;
                                phi_2996_ = _e1595;
                                phi_2998_ = _e1597;
                                phi_3000_ = _e1599;
                                phi_3002_ = _e1601;
                                phi_5247_ = _e1591;
                                break if !(_e1603);
                            }
                        }
                        let _e1606 = phi_5247_;
                        if _e1606 {
                            break;
                        }
                        let _e1608 = local_13;
                        if _e1608.member_1 {
                        } else {
                            if _e226 {
                            } else {
                                break;
                            }
                            let _e1612 = global_2.member[_e140];
                            if _e147 {
                            } else {
                                break;
                            }
                            let _e1616 = global_9.member[_e140].member_1;
                            if _e226 {
                            } else {
                                break;
                            }
                            global_2.member[_e140] = type_29(_e1612.member, _e1612.member_1, _e1612.member_2, array<f32, 3>((_e1612.member_3[0] + (_e1616[0] * _e1612.member_1[0])), (_e1612.member_3[1] + (_e1616[1] * _e1612.member_1[1])), (_e1612.member_3[2] + (_e1616[2] * _e1612.member_1[2]))), _e1612.member_4);
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
