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

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_29 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_41 {
    member: array<type_39>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_49 {
    member: f32,
    member_1: bool,
}

struct type_51 {
    member: array<vec4<u32>, 2>,
}

struct type_54 {
    member: array<i32>,
}

struct type_61 {
    member: type_38,
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
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_33;
@group(0) @binding(1) 
var<uniform> global_3: type_51;
@group(0) @binding(2) 
var<uniform> global_4: type_51;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(4) 
var<storage> global_6: type_24;
@group(0) @binding(5) 
var<storage> global_7: type_4;
@group(0) @binding(6) 
var<storage> global_8: type_54;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_69;
@group(0) @binding(7) 
var<storage> global_10: type_41;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_61, 128>;
    var phi_325_: u32;
    var phi_369_: i32;
    var phi_393_: type_44;
    var phi_543_: i32;
    var phi_544_: i32;
    var phi_554_: bool;
    var phi_564_: u32;
    var phi_565_: u32;
    var phi_567_: bool;
    var phi_572_: u32;
    var phi_605_: i32;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_640_: f32;
    var phi_646_: f32;
    var phi_669_: f32;
    var phi_680_: f32;
    var phi_689_: f32;
    var phi_695_: f32;
    var phi_706_: f32;
    var phi_712_: f32;
    var phi_735_: f32;
    var phi_746_: f32;
    var phi_755_: f32;
    var phi_761_: f32;
    var phi_772_: f32;
    var phi_778_: f32;
    var phi_801_: f32;
    var phi_812_: f32;
    var phi_912_: f32;
    var phi_913_: f32;
    var phi_4711_: bool;
    var phi_2033_: type_49;
    var phi_2036_: type_61;
    var phi_2038_: u32;
    var phi_2040_: bool;
    var phi_2042_: u32;
    var phi_2053_: bool;
    var phi_2090_: type_61;
    var phi_2091_: bool;
    var phi_2092_: u32;
    var phi_4022_: u32;
    var phi_4023_: u32;
    var phi_4033_: u32;
    var phi_4035_: u32;
    var phi_4036_: bool;
    var phi_4056_: u32;
    var phi_4057_: u32;
    var phi_4061_: type_64;
    var phi_4405_: type_61;
    var phi_4438_: type_61;
    var phi_4439_: type_61;
    var phi_4440_: u32;
    var phi_4442_: type_61;
    var phi_4443_: u32;
    var phi_4444_: bool;
    var phi_4453_: type_61;
    var phi_4458_: type_61;
    var phi_4459_: bool;
    var phi_2110_: type_49;
    var phi_2113_: type_8;
    var phi_2114_: type_8;
    var phi_2136_: type_8;
    var phi_2157_: u32;
    var phi_2246_: array<array<f32, 3>, 3>;
    var phi_2717_: vec3<f32>;
    var phi_2718_: vec3<f32>;
    var phi_2749_: bool;
    var phi_2758_: vec3<f32>;
    var phi_2798_: type_29;
    var phi_2800_: type_29;
    var phi_2801_: bool;
    var phi_2805_: type_29;
    var phi_2806_: type_29;
    var phi_2807_: type_29;
    var phi_2808_: bool;
    var phi_2812_: type_29;
    var phi_2813_: bool;
    var phi_2817_: type_29;
    var phi_2818_: bool;
    var phi_2822_: type_29;
    var phi_2845_: u32;
    var phi_2859_: i32;
    var phi_2879_: vec3<f32>;
    var phi_2880_: vec3<f32>;
    var phi_2896_: vec3<f32>;
    var phi_2897_: vec3<f32>;
    var phi_2913_: vec3<f32>;
    var phi_2914_: vec3<f32>;
    var phi_2950_: vec3<f32>;
    var phi_3132_: f32;
    var phi_3150_: bool;
    var phi_3151_: bool;
    var phi_3156_: type_49;
    var phi_3157_: type_49;
    var phi_2111_: type_49;
    var phi_4705_: bool;
    var local_4: type_49;
    var phi_4847_: bool;
    var phi_4461_: type_49;
    var phi_4462_: type_61;
    var phi_4463_: bool;
    var phi_4464_: u32;
    var phi_4846_: bool;
    var phi_4465_: type_49;
    var phi_4466_: type_61;
    var phi_4467_: u32;
    var phi_4468_: bool;
    var phi_4469_: u32;
    var phi_4845_: bool;
    var phi_4470_: type_49;
    var phi_4471_: type_61;
    var phi_4472_: u32;
    var phi_4473_: bool;
    var phi_4474_: u32;
    var phi_4844_: bool;
    var phi_2034_: type_49;
    var phi_2037_: type_61;
    var phi_2039_: u32;
    var phi_2041_: bool;
    var phi_2043_: u32;
    var phi_4475_: bool;
    var phi_4843_: bool;
    var local_5: type_49;
    var local_6: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e89 = global;
            let _e91 = arrayLength((&global_5.member));
            let _e93 = arrayLength((&global_6.member));
            let _e105 = arrayLength((&global_9.member));
            let _e109 = global_4.member[0u][0u];
            let _e113 = global_4.member[0u][1u];
            let _e117 = global_4.member[0u][2u];
            let _e121 = global_4.member[0u][3u];
            let _e125 = global_4.member[1u][0u];
            let _e129 = global_4.member[1u][1u];
            let _e133 = global_4.member[1u][2u];
            let _e137 = (_e89.x + (_e89.y * 2097152u));
            let _e149 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e121) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e109), bitcast<i32>(_e113), bitcast<i32>(_e117));
            local = array<i32, 3>(bitcast<i32>(_e125), bitcast<i32>(_e129), bitcast<i32>(_e133));
            let _e152 = (_e137 < arrayLength((&global_10.member)));
            if _e152 {
                if _e152 {
                } else {
                    break;
                }
                let _e156 = global_10.member[_e137].member_2;
                phi_325_ = _e156;
            } else {
                phi_325_ = 4294967295u;
            }
            let _e158 = phi_325_;
            let _e161 = global_1.member[0u];
            let _e165 = global_3.member[0u][0u];
            let _e169 = global_3.member[0u][1u];
            let _e173 = global_3.member[0u][2u];
            let _e177 = global_3.member[0u][3u];
            let _e181 = global_3.member[1u][0u];
            let _e185 = global_3.member[1u][1u];
            let _e189 = global_3.member[1u][2u];
            let _e193 = global_3.member[1u][3u];
            let _e194 = bitcast<f32>(_e165);
            let _e195 = bitcast<f32>(_e169);
            let _e196 = bitcast<f32>(_e173);
            let _e198 = bitcast<f32>(_e181);
            let _e199 = array<u32, 3>(_e185, _e189, _e193);
            let _e201 = bitcast<i32>(_e161);
            if (_e201 < -126i) {
                phi_369_ = -126i;
            } else {
                phi_369_ = select(_e201, 127i, (_e201 > 127i));
            }
            let _e206 = phi_369_;
            let _e211 = bitcast<f32>((bitcast<u32>((_e206 + 127i)) << bitcast<u32>(23i)));
            let _e217 = bitcast<f32>((bitcast<u32>(((_e201 - _e206) + 127i)) << bitcast<u32>(23i)));
            if (_e177 == 0u) {
                phi_393_ = type_44(array<f32, 3>(_e194, _e195, _e196), _e177, _e198, _e199);
            } else {
                phi_393_ = type_44(array<f32, 3>(((_e194 * _e211) * _e217), ((_e195 * _e211) * _e217), ((_e196 * _e211) * _e217)), _e177, ((_e198 * _e211) * _e217), _e199);
            }
            let _e230 = phi_393_;
            if _e152 {
                let _e231 = (_e137 < arrayLength((&global_2.member)));
                if _e231 {
                    if _e152 {
                    } else {
                        break;
                    }
                    let _e236 = global_10.member[_e137].member.member_1;
                    let _e241 = global_10.member[_e137].member.member_3;
                    if (_e236 <= _e241) {
                        let _e243 = (1u < _e105);
                        if _e243 {
                            if (0u < _e105) {
                            } else {
                                break;
                            }
                            let _e247 = atomicAdd((&global_9.member[0u]), 1u);
                            if ((_e247 + 1u) < _e247) {
                                if _e243 {
                                } else {
                                    break;
                                }
                                let _e252 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                        if _e152 {
                        } else {
                            break;
                        }
                        let _e262 = global_10.member[_e137].member.member_2[0u];
                        let _e264 = (bitcast<u32>(_e262) & 2147483647u);
                        let _e270 = global_10.member[_e137].member.member_2[1u];
                        let _e272 = (bitcast<u32>(_e270) & 2147483647u);
                        let _e278 = global_10.member[_e137].member.member_2[2u];
                        let _e280 = (bitcast<u32>(_e278) & 2147483647u);
                        let _e286 = global_10.member[_e137].member.member[0u];
                        let _e288 = (bitcast<u32>(_e286) & 2147483647u);
                        let _e294 = global_10.member[_e137].member.member[1u];
                        let _e296 = (bitcast<u32>(_e294) & 2147483647u);
                        let _e302 = global_10.member[_e137].member.member[2u];
                        let _e304 = (bitcast<u32>(_e302) & 2147483647u);
                        let _e306 = select(_e272, _e264, (_e272 < _e264));
                        let _e308 = select(_e280, _e306, (_e280 < _e306));
                        let _e310 = select(_e288, _e308, (_e288 < _e308));
                        let _e312 = select(_e296, _e310, (_e296 < _e310));
                        let _e314 = select(_e304, _e312, (_e304 < _e312));
                        let _e316 = (bitcast<u32>(_e236) & 2147483647u);
                        let _e325 = (((select(_e316, _e314, (_e316 < _e314)) < 2139095040u) && ((bitcast<u32>(_e241) & 2147483647u) <= 2139095040u)) && (_e308 > 0u));
                        if _e325 {
                            let _e328 = (bitcast<u32>(bitcast<f32>(_e308)) & 2147483647u);
                            if (_e328 >= 8388608u) {
                                phi_543_ = (bitcast<i32>((_e328 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_543_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e328)), 32u, (_e328 == 0u))));
                            }
                            let _e342 = phi_543_;
                            phi_544_ = _e342;
                        } else {
                            phi_544_ = 0i;
                        }
                        let _e344 = phi_544_;
                        let _e345 = (_e264 == _e308);
                        if _e345 {
                            phi_554_ = true;
                        } else {
                            phi_554_ = (_e272 == _e308);
                        }
                        let _e348 = phi_554_;
                        let _e349 = select(1u, 0u, _e345);
                        if _e348 {
                            let _e350 = (_e349 + 1u);
                            phi_564_ = _e350;
                            phi_565_ = _e350;
                            phi_567_ = select(true, false, (_e350 == 2u));
                        } else {
                            phi_564_ = u32();
                            phi_565_ = 0u;
                            phi_567_ = true;
                        }
                        let _e354 = phi_564_;
                        let _e356 = phi_565_;
                        let _e358 = phi_567_;
                        if _e358 {
                            phi_572_ = (_e356 + 1u);
                        } else {
                            phi_572_ = 0u;
                        }
                        let _e362 = phi_572_;
                        let _e363 = select(_e354, _e356, _e358);
                        let _e364 = select(_e349, select(2u, _e349, _e348), _e358);
                        let _e365 = -(_e344);
                        if (_e365 < -126i) {
                            phi_605_ = -126i;
                        } else {
                            phi_605_ = select(_e365, 127i, (_e365 > 127i));
                        }
                        let _e370 = phi_605_;
                        let _e375 = bitcast<f32>((bitcast<u32>((_e370 + 127i)) << bitcast<u32>(23i)));
                        let _e381 = bitcast<f32>((bitcast<u32>(((_e365 - _e370) + 127i)) << bitcast<u32>(23i)));
                        let _e386 = global_10.member[_e137].member.member;
                        let _e387 = (_e363 == 0u);
                        if _e387 {
                            phi_623_ = _e386[0];
                        } else {
                            phi_623_ = _e386[1];
                        }
                        let _e391 = phi_623_;
                        let _e392 = (_e363 == 2u);
                        if _e392 {
                            phi_629_ = _e386[2];
                        } else {
                            phi_629_ = _e391;
                        }
                        let _e395 = phi_629_;
                        let _e396 = global_10.member[_e137].member.member_2;
                        if _e387 {
                            phi_640_ = _e396[0];
                        } else {
                            phi_640_ = _e396[1];
                        }
                        let _e400 = phi_640_;
                        if _e392 {
                            phi_646_ = _e396[2];
                        } else {
                            phi_646_ = _e400;
                        }
                        let _e403 = phi_646_;
                        let _e405 = ((_e403 * _e375) * _e381);
                        let _e409 = (bitcast<f32>((bitcast<u32>(_e405) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e409 {
                            let _e413 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) * 0.00000011920929f);
                            phi_669_ = select(0.00000000000011368684f, _e413, (_e413 > 0.00000000000011368684f));
                        } else {
                            phi_669_ = 0f;
                        }
                        let _e417 = phi_669_;
                        let _e418 = (_e395 + _e417);
                        let _e419 = (_e395 - _e417);
                        let _e420 = select(_e405, 0f, _e409);
                        if _e409 {
                            phi_680_ = 38685626000000000000000000f;
                        } else {
                            phi_680_ = (1f / _e405);
                        }
                        let _e423 = phi_680_;
                        let _e424 = (_e362 == 0u);
                        if _e424 {
                            phi_689_ = _e386[0];
                        } else {
                            phi_689_ = _e386[1];
                        }
                        let _e428 = phi_689_;
                        let _e429 = (_e362 == 2u);
                        if _e429 {
                            phi_695_ = _e386[2];
                        } else {
                            phi_695_ = _e428;
                        }
                        let _e432 = phi_695_;
                        if _e424 {
                            phi_706_ = _e396[0];
                        } else {
                            phi_706_ = _e396[1];
                        }
                        let _e436 = phi_706_;
                        if _e429 {
                            phi_712_ = _e396[2];
                        } else {
                            phi_712_ = _e436;
                        }
                        let _e439 = phi_712_;
                        let _e441 = ((_e439 * _e375) * _e381);
                        let _e445 = (bitcast<f32>((bitcast<u32>(_e441) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e445 {
                            let _e449 = (bitcast<f32>((bitcast<u32>(_e432) & 2147483647u)) * 0.00000011920929f);
                            phi_735_ = select(0.00000000000011368684f, _e449, (_e449 > 0.00000000000011368684f));
                        } else {
                            phi_735_ = 0f;
                        }
                        let _e453 = phi_735_;
                        let _e454 = (_e432 + _e453);
                        let _e455 = (_e432 - _e453);
                        let _e456 = select(_e441, 0f, _e445);
                        if _e445 {
                            phi_746_ = 38685626000000000000000000f;
                        } else {
                            phi_746_ = (1f / _e441);
                        }
                        let _e459 = phi_746_;
                        let _e460 = (_e364 == 0u);
                        if _e460 {
                            phi_755_ = _e386[0];
                        } else {
                            phi_755_ = _e386[1];
                        }
                        let _e464 = phi_755_;
                        let _e465 = (_e364 == 2u);
                        if _e465 {
                            phi_761_ = _e386[2];
                        } else {
                            phi_761_ = _e464;
                        }
                        let _e468 = phi_761_;
                        if _e460 {
                            phi_772_ = _e396[0];
                        } else {
                            phi_772_ = _e396[1];
                        }
                        let _e472 = phi_772_;
                        if _e465 {
                            phi_778_ = _e396[2];
                        } else {
                            phi_778_ = _e472;
                        }
                        let _e475 = phi_778_;
                        let _e477 = ((_e475 * _e375) * _e381);
                        let _e481 = (bitcast<f32>((bitcast<u32>(_e477) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e481 {
                            let _e485 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) * 0.00000011920929f);
                            phi_801_ = select(0.00000000000011368684f, _e485, (_e485 > 0.00000000000011368684f));
                        } else {
                            phi_801_ = 0f;
                        }
                        let _e489 = phi_801_;
                        let _e490 = (_e468 + _e489);
                        let _e491 = (_e468 - _e489);
                        let _e492 = select(_e477, 0f, _e481);
                        if _e481 {
                            phi_812_ = 38685626000000000000000000f;
                        } else {
                            phi_812_ = (1f / _e477);
                        }
                        let _e495 = phi_812_;
                        let _e498 = bitcast<f32>((bitcast<u32>(_e395) & 2147483647u));
                        let _e501 = bitcast<f32>((bitcast<u32>(_e432) & 2147483647u));
                        let _e503 = select(_e501, _e498, (_e498 > _e501));
                        let _e506 = bitcast<f32>((bitcast<u32>(_e468) & 2147483647u));
                        if (_e325 && (select(_e506, _e503, (_e503 > _e506)) <= 1099511600000f)) {
                            let _e511 = (_e344 / 3i);
                            let _e518 = bitcast<f32>((bitcast<u32>((_e511 + 127i)) << bitcast<u32>(23i)));
                            let _e525 = bitcast<f32>((bitcast<u32>(((_e344 - (2i * _e511)) + 127i)) << bitcast<u32>(23i)));
                            let _e526 = (((_e236 * _e518) * _e518) * _e525);
                            let _e528 = select(340282350000000000000000000000000000000f, _e526, (_e526 < 340282350000000000000000000000000000000f));
                            let _e533 = (((_e241 * _e518) * _e518) * _e525);
                            let _e535 = select(340282350000000000000000000000000000000f, _e533, (_e533 < 340282350000000000000000000000000000000f));
                            phi_912_ = select(-340282350000000000000000000000000000000f, _e535, (_e535 > -340282350000000000000000000000000000000f));
                            phi_913_ = select(-340282350000000000000000000000000000000f, _e528, (_e528 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_912_ = 0f;
                            phi_913_ = 1f;
                        }
                        let _e539 = phi_912_;
                        let _e541 = phi_913_;
                        local_3 = array<type_61, 128>(type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e545 = (_e363 % 3u);
                        let _e546 = (_e545 < 3u);
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e548 = local_1[_e545];
                        let _e551 = (_e362 % 3u);
                        let _e552 = (_e551 < 3u);
                        if _e552 {
                        } else {
                            break;
                        }
                        let _e554 = local_1[_e551];
                        let _e557 = (_e364 % 3u);
                        let _e558 = (_e557 < 3u);
                        if _e558 {
                        } else {
                            break;
                        }
                        let _e560 = local_1[_e557];
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e565 = local[_e545];
                        if _e552 {
                        } else {
                            break;
                        }
                        let _e569 = local[_e551];
                        if _e558 {
                        } else {
                            break;
                        }
                        let _e573 = local[_e557];
                        phi_4711_ = false;
                        phi_2033_ = type_49(_e539, false);
                        phi_2036_ = type_61(type_38(vec4<f32>((f32(_e548) * _e149), (f32(_e554) * _e149), (f32(_e560) * _e149), 0f), vec4<f32>((f32(_e565) * _e149), (f32(_e569) * _e149), (f32(_e573) * _e149), 0f)), select(0u, 2147483648u, (_e91 == 0u)));
                        phi_2038_ = ((3u * _e91) + 1u);
                        phi_2040_ = (_e541 <= _e539);
                        phi_2042_ = 0u;
                        loop {
                            let _e583 = phi_4711_;
                            let _e585 = phi_2033_;
                            let _e587 = phi_2036_;
                            let _e589 = phi_2038_;
                            let _e591 = phi_2040_;
                            let _e593 = phi_2042_;
                            local_5 = _e585;
                            if _e591 {
                                phi_2053_ = true;
                            } else {
                                phi_2053_ = (_e593 > 0u);
                            }
                            let _e596 = phi_2053_;
                            if _e596 {
                                let _e597 = (_e589 > 0u);
                                if _e597 {
                                    if _e591 {
                                        phi_2090_ = _e587;
                                        phi_2091_ = _e591;
                                        phi_2092_ = _e593;
                                    } else {
                                        let _e598 = (_e593 - 1u);
                                        let _e599 = (_e598 % 128u);
                                        let _e600 = (_e599 < 128u);
                                        if _e600 {
                                        } else {
                                            phi_4843_ = true;
                                            break;
                                        }
                                        let _e602 = local_3[_e599];
                                        if _e600 {
                                        } else {
                                            phi_4843_ = true;
                                            break;
                                        }
                                        let _e610 = local_2[_e599];
                                        phi_2090_ = type_61(type_38(_e602.member.member, _e602.member.member_1), _e602.member_1);
                                        phi_2091_ = (_e610 <= _e585.member);
                                        phi_2092_ = _e598;
                                    }
                                    let _e614 = phi_2090_;
                                    let _e616 = phi_2091_;
                                    let _e618 = phi_2092_;
                                    if _e616 {
                                        if ((_e614.member_1 & 2147483648u) != 0u) {
                                            phi_2110_ = _e585;
                                            phi_2113_ = type_8(0u, ((_e614.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1064 = phi_2110_;
                                                let _e1066 = phi_2113_;
                                                local_4 = _e1064;
                                                local_6 = _e1064;
                                                if (_e1066.member < _e1066.member_1) {
                                                    phi_2114_ = type_8((_e1066.member + 1u), _e1066.member_1);
                                                    phi_2136_ = type_8(1u, _e1066.member);
                                                } else {
                                                    phi_2114_ = _e1066;
                                                    phi_2136_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1079 = phi_2114_;
                                                let _e1081 = phi_2136_;
                                                let _e1085 = (bitcast<i32>(_e1081.member) != 0i);
                                                if _e1085 {
                                                    let _e1086 = ((_e614.member_1 & 268435455u) + _e1081.member_1);
                                                    let _e1087 = (_e1086 < _e93);
                                                    if _e1087 {
                                                        if _e1087 {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        let _e1091 = global_6.member[_e1086].member_1;
                                                        phi_2157_ = _e1091;
                                                    } else {
                                                        phi_2157_ = 4294967295u;
                                                    }
                                                    let _e1093 = phi_2157_;
                                                    if (_e1086 >= _e93) {
                                                        phi_2246_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1087 {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        if (_e545 < 9u) {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        let _e1100 = global_6.member[_e1086].member[_e545];
                                                        if (_e551 < 9u) {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        let _e1106 = global_6.member[_e1086].member[_e551];
                                                        if (_e557 < 9u) {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        let _e1112 = global_6.member[_e1086].member[_e557];
                                                        let _e1114 = (3u + _e545);
                                                        if (_e1114 < 9u) {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        let _e1120 = global_6.member[_e1086].member[_e1114];
                                                        let _e1121 = (3u + _e551);
                                                        if (_e1121 < 9u) {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        let _e1127 = global_6.member[_e1086].member[_e1121];
                                                        let _e1128 = (3u + _e557);
                                                        if (_e1128 < 9u) {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        let _e1134 = global_6.member[_e1086].member[_e1128];
                                                        let _e1136 = (6u + _e545);
                                                        if (_e1136 < 9u) {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        let _e1142 = global_6.member[_e1086].member[_e1136];
                                                        let _e1143 = (6u + _e551);
                                                        if (_e1143 < 9u) {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        let _e1149 = global_6.member[_e1086].member[_e1143];
                                                        let _e1150 = (6u + _e557);
                                                        if (_e1150 < 9u) {
                                                        } else {
                                                            phi_4705_ = true;
                                                            break;
                                                        }
                                                        let _e1156 = global_6.member[_e1086].member[_e1150];
                                                        phi_2246_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1100, _e1106, _e1112), array<f32, 3>(_e1120, _e1127, _e1134), array<f32, 3>(_e1142, _e1149, _e1156));
                                                    }
                                                    let _e1160 = phi_2246_;
                                                    let _e1168 = (_e1160[0][2] - _e468);
                                                    let _e1171 = (((_e1160[0][0] - _e395) * _e492) - (_e1168 * _e420));
                                                    let _e1174 = (((_e1160[0][1] - _e432) * _e492) - (_e1168 * _e456));
                                                    let _e1181 = (_e1160[1][2] - _e468);
                                                    let _e1184 = (((_e1160[1][0] - _e395) * _e492) - (_e1181 * _e420));
                                                    let _e1187 = (((_e1160[1][1] - _e432) * _e492) - (_e1181 * _e456));
                                                    let _e1194 = (_e1160[2][2] - _e468);
                                                    let _e1197 = (((_e1160[2][0] - _e395) * _e492) - (_e1194 * _e420));
                                                    let _e1200 = (((_e1160[2][1] - _e432) * _e492) - (_e1194 * _e456));
                                                    let _e1201 = (_e1197 * _e1187);
                                                    let _e1202 = (_e1200 * _e1184);
                                                    let _e1203 = (_e1171 * _e1200);
                                                    let _e1204 = (_e1174 * _e1197);
                                                    let _e1205 = (_e1184 * _e1174);
                                                    let _e1206 = (_e1187 * _e1171);
                                                    let _e1211 = (((_e1201 >= _e1202) && (_e1203 >= _e1204)) && (_e1205 >= _e1206));
                                                    if (_e1211 || (((_e1201 <= _e1202) && (_e1203 <= _e1204)) && (_e1205 <= _e1206))) {
                                                        let _e1218 = select(-1f, 1f, _e1211);
                                                        let _e1220 = ((_e1201 - _e1202) * _e1218);
                                                        let _e1222 = select(0f, _e1220, (_e1220 > 0f));
                                                        let _e1224 = ((_e1203 - _e1204) * _e1218);
                                                        let _e1226 = select(0f, _e1224, (_e1224 > 0f));
                                                        let _e1228 = ((_e1205 - _e1206) * _e1218);
                                                        let _e1230 = select(0f, _e1228, (_e1228 > 0f));
                                                        let _e1232 = ((_e1222 + _e1226) + _e1230);
                                                        if (_e1232 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2812_ = type_29();
                                                            phi_2813_ = true;
                                                        } else {
                                                            let _e1235 = select(_e1160[1][0], _e1160[0][0], (_e1160[0][0] < _e1160[1][0]));
                                                            let _e1239 = select(_e1160[1][0], _e1160[0][0], (_e1160[0][0] > _e1160[1][0]));
                                                            let _e1243 = select(_e1160[1][1], _e1160[0][1], (_e1160[0][1] < _e1160[1][1]));
                                                            let _e1247 = select(_e1160[1][1], _e1160[0][1], (_e1160[0][1] > _e1160[1][1]));
                                                            let _e1251 = select(_e1160[1][2], _e1160[0][2], (_e1160[0][2] < _e1160[1][2]));
                                                            let _e1255 = select(_e1160[1][2], _e1160[0][2], (_e1160[0][2] > _e1160[1][2]));
                                                            let _e1260 = ((select(_e1160[2][0], _e1235, (_e1235 < _e1160[2][0])) - _e418) * _e423);
                                                            let _e1261 = ((select(_e1160[2][0], _e1239, (_e1239 > _e1160[2][0])) - _e419) * _e423);
                                                            let _e1264 = ((select(_e1160[2][1], _e1243, (_e1243 < _e1160[2][1])) - _e454) * _e459);
                                                            let _e1265 = ((select(_e1160[2][1], _e1247, (_e1247 > _e1160[2][1])) - _e455) * _e459);
                                                            let _e1268 = ((select(_e1160[2][2], _e1251, (_e1251 < _e1160[2][2])) - _e490) * _e495);
                                                            let _e1269 = ((select(_e1160[2][2], _e1255, (_e1255 > _e1160[2][2])) - _e491) * _e495);
                                                            let _e1271 = select(_e1269, _e1268, (_e1268 < _e1269));
                                                            let _e1273 = select(_e1269, _e1268, (_e1268 > _e1269));
                                                            let _e1275 = select(_e1261, _e1260, (_e1260 < _e1261));
                                                            let _e1277 = select(_e1265, _e1264, (_e1264 < _e1265));
                                                            let _e1279 = select(_e1277, _e1275, (_e1275 > _e1277));
                                                            let _e1281 = select(_e1271, _e1279, (_e1279 > _e1271));
                                                            let _e1283 = select(_e1261, _e1260, (_e1260 > _e1261));
                                                            let _e1285 = select(_e1265, _e1264, (_e1264 > _e1265));
                                                            let _e1287 = select(_e1285, _e1283, (_e1283 < _e1285));
                                                            let _e1289 = select(_e1273, _e1287, (_e1287 < _e1273));
                                                            let _e1290 = -(_e1271);
                                                            let _e1296 = select(_e541, _e1281, (_e1281 > _e541));
                                                            if (_e1296 > (_e1289 + (select(_e1290, _e1273, (_e1273 > _e1290)) * 0.0000019073523f))) {
                                                                phi_2807_ = type_29();
                                                                phi_2808_ = true;
                                                            } else {
                                                                let _e1298 = (_e1296 > _e1064.member);
                                                                if _e1298 {
                                                                    phi_2806_ = type_29();
                                                                } else {
                                                                    let _e1302 = (_e1160[1][0] - _e1160[0][0]);
                                                                    let _e1303 = (_e1160[1][1] - _e1160[0][1]);
                                                                    let _e1304 = (_e1160[1][2] - _e1160[0][2]);
                                                                    let _e1305 = vec3<f32>(_e1302, _e1303, _e1304);
                                                                    let _e1306 = (_e1160[2][0] - _e1160[1][0]);
                                                                    let _e1307 = (_e1160[2][1] - _e1160[1][1]);
                                                                    let _e1308 = (_e1160[2][2] - _e1160[1][2]);
                                                                    let _e1309 = vec3<f32>(_e1306, _e1307, _e1308);
                                                                    let _e1310 = (_e1160[0][0] - _e1160[2][0]);
                                                                    let _e1311 = (_e1160[0][1] - _e1160[2][1]);
                                                                    let _e1312 = (_e1160[0][2] - _e1160[2][2]);
                                                                    let _e1313 = vec3<f32>(_e1310, _e1311, _e1312);
                                                                    let _e1316 = bitcast<f32>((bitcast<u32>(_e1302) & 2147483647u));
                                                                    let _e1319 = bitcast<f32>((bitcast<u32>(_e1303) & 2147483647u));
                                                                    let _e1321 = select(_e1319, _e1316, (_e1316 > _e1319));
                                                                    let _e1324 = bitcast<f32>((bitcast<u32>(_e1304) & 2147483647u));
                                                                    let _e1326 = select(_e1324, _e1321, (_e1321 > _e1324));
                                                                    let _e1329 = bitcast<f32>((bitcast<u32>(_e1306) & 2147483647u));
                                                                    let _e1332 = bitcast<f32>((bitcast<u32>(_e1307) & 2147483647u));
                                                                    let _e1334 = select(_e1332, _e1329, (_e1329 > _e1332));
                                                                    let _e1337 = bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u));
                                                                    let _e1339 = select(_e1337, _e1334, (_e1334 > _e1337));
                                                                    let _e1342 = bitcast<f32>((bitcast<u32>(_e1310) & 2147483647u));
                                                                    let _e1345 = bitcast<f32>((bitcast<u32>(_e1311) & 2147483647u));
                                                                    let _e1347 = select(_e1345, _e1342, (_e1342 > _e1345));
                                                                    let _e1350 = bitcast<f32>((bitcast<u32>(_e1312) & 2147483647u));
                                                                    let _e1352 = select(_e1350, _e1347, (_e1347 > _e1350));
                                                                    let _e1354 = select(_e1339, _e1326, (_e1326 > _e1339));
                                                                    let _e1356 = select(_e1352, _e1354, (_e1354 > _e1352));
                                                                    if (_e1326 == _e1356) {
                                                                        phi_2717_ = _e1309;
                                                                        phi_2718_ = _e1313;
                                                                    } else {
                                                                        let _e1359 = vec3((_e1339 == _e1356));
                                                                        phi_2717_ = select(_e1305, _e1313, _e1359);
                                                                        phi_2718_ = select(_e1309, _e1305, _e1359);
                                                                    }
                                                                    let _e1363 = phi_2717_;
                                                                    let _e1365 = phi_2718_;
                                                                    let _e1372 = ((_e1363.y * _e1365.z) - (_e1365.y * _e1363.z));
                                                                    let _e1377 = ((_e1363.z * _e1365.x) - (_e1365.z * _e1363.x));
                                                                    let _e1380 = ((_e1363.x * _e1365.y) - (_e1365.x * _e1363.y));
                                                                    if (_e1222 >= _e1226) {
                                                                        phi_2749_ = select(true, false, (_e1222 >= _e1230));
                                                                    } else {
                                                                        phi_2749_ = true;
                                                                    }
                                                                    let _e1385 = phi_2749_;
                                                                    if _e1385 {
                                                                        phi_2758_ = select(vec3<f32>(_e1160[2][0], _e1160[2][1], _e1160[2][2]), vec3<f32>(_e1160[1][0], _e1160[1][1], _e1160[1][2]), vec3((_e1226 >= _e1230)));
                                                                    } else {
                                                                        phi_2758_ = vec3<f32>(_e1160[0][0], _e1160[0][1], _e1160[0][2]);
                                                                    }
                                                                    let _e1390 = phi_2758_;
                                                                    let _e1407 = ((((_e1372 * (_e1390.x - _e395)) + (_e1377 * (_e1390.y - _e432))) + (_e1380 * (_e1390.z - _e468))) / (((_e1372 * _e420) + (_e1377 * _e456)) + (_e1380 * _e492)));
                                                                    let _e1409 = select(_e1289, _e1407, (_e1407 < _e1289));
                                                                    let _e1411 = select(_e1281, _e1409, (_e1409 > _e1281));
                                                                    if (_e1411 >= _e541) {
                                                                        let _e1413 = (_e1411 <= _e1064.member);
                                                                        if _e1413 {
                                                                            let _e1414 = (1f / _e1232);
                                                                            phi_2798_ = type_29(_e1411, (_e1226 * _e1414), (_e1230 * _e1414), _e1093);
                                                                        } else {
                                                                            phi_2798_ = type_29();
                                                                        }
                                                                        let _e1419 = phi_2798_;
                                                                        phi_2800_ = _e1419;
                                                                        phi_2801_ = select(true, false, _e1413);
                                                                    } else {
                                                                        phi_2800_ = type_29();
                                                                        phi_2801_ = true;
                                                                    }
                                                                    let _e1422 = phi_2800_;
                                                                    let _e1424 = phi_2801_;
                                                                    if _e1424 {
                                                                        phi_2805_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2805_ = _e1422;
                                                                    }
                                                                    let _e1426 = phi_2805_;
                                                                    phi_2806_ = _e1426;
                                                                }
                                                                let _e1428 = phi_2806_;
                                                                phi_2807_ = _e1428;
                                                                phi_2808_ = _e1298;
                                                            }
                                                            let _e1430 = phi_2807_;
                                                            let _e1432 = phi_2808_;
                                                            phi_2812_ = _e1430;
                                                            phi_2813_ = _e1432;
                                                        }
                                                        let _e1434 = phi_2812_;
                                                        let _e1436 = phi_2813_;
                                                        phi_2817_ = _e1434;
                                                        phi_2818_ = _e1436;
                                                    } else {
                                                        phi_2817_ = type_29();
                                                        phi_2818_ = true;
                                                    }
                                                    let _e1438 = phi_2817_;
                                                    let _e1440 = phi_2818_;
                                                    if _e1440 {
                                                        phi_2822_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2822_ = _e1438;
                                                    }
                                                    let _e1442 = phi_2822_;
                                                    if (_e1442.member_3 != 4294967295u) {
                                                        if (_e1093 == _e158) {
                                                            phi_3151_ = false;
                                                        } else {
                                                            let _e1446 = (_e1093 < arrayLength((&global_7.member)));
                                                            if _e1446 {
                                                                if _e1446 {
                                                                } else {
                                                                    phi_4705_ = true;
                                                                    break;
                                                                }
                                                                let _e1448 = global_7.member[_e1093];
                                                                phi_2845_ = _e1448;
                                                            } else {
                                                                phi_2845_ = 4294967295u;
                                                            }
                                                            let _e1450 = phi_2845_;
                                                            let _e1451 = (_e1450 < arrayLength((&global_8.member)));
                                                            if _e1451 {
                                                                if _e1451 {
                                                                } else {
                                                                    phi_4705_ = true;
                                                                    break;
                                                                }
                                                                let _e1453 = global_8.member[_e1450];
                                                                phi_2859_ = _e1453;
                                                            } else {
                                                                phi_2859_ = 0i;
                                                            }
                                                            let _e1455 = phi_2859_;
                                                            let _e1456 = (_e1455 == 0i);
                                                            if _e1456 {
                                                                phi_3150_ = true;
                                                            } else {
                                                                if _e387 {
                                                                    phi_2880_ = vec3<f32>(_e1160[0][0], _e1160[0][1], _e1160[0][2]);
                                                                } else {
                                                                    if (_e363 == 1u) {
                                                                        phi_2879_ = vec3<f32>(_e1160[0][2], _e1160[0][0], _e1160[0][1]);
                                                                    } else {
                                                                        phi_2879_ = vec3<f32>(_e1160[0][1], _e1160[0][2], _e1160[0][0]);
                                                                    }
                                                                    let _e1461 = phi_2879_;
                                                                    phi_2880_ = _e1461;
                                                                }
                                                                let _e1464 = phi_2880_;
                                                                if _e387 {
                                                                    phi_2897_ = vec3<f32>(_e1160[1][0], _e1160[1][1], _e1160[1][2]);
                                                                } else {
                                                                    if (_e363 == 1u) {
                                                                        phi_2896_ = vec3<f32>(_e1160[1][2], _e1160[1][0], _e1160[1][1]);
                                                                    } else {
                                                                        phi_2896_ = vec3<f32>(_e1160[1][1], _e1160[1][2], _e1160[1][0]);
                                                                    }
                                                                    let _e1469 = phi_2896_;
                                                                    phi_2897_ = _e1469;
                                                                }
                                                                let _e1472 = phi_2897_;
                                                                if _e387 {
                                                                    phi_2914_ = vec3<f32>(_e1160[2][0], _e1160[2][1], _e1160[2][2]);
                                                                } else {
                                                                    if (_e363 == 1u) {
                                                                        phi_2913_ = vec3<f32>(_e1160[2][2], _e1160[2][0], _e1160[2][1]);
                                                                    } else {
                                                                        phi_2913_ = vec3<f32>(_e1160[2][1], _e1160[2][2], _e1160[2][0]);
                                                                    }
                                                                    let _e1477 = phi_2913_;
                                                                    phi_2914_ = _e1477;
                                                                }
                                                                let _e1480 = phi_2914_;
                                                                let _e1483 = (_e1472.x - _e1464.x);
                                                                let _e1486 = (_e1472.y - _e1464.y);
                                                                let _e1489 = (_e1472.z - _e1464.z);
                                                                let _e1491 = (_e1480.x - _e1464.x);
                                                                let _e1493 = (_e1480.y - _e1464.y);
                                                                let _e1495 = (_e1480.z - _e1464.z);
                                                                if (_e230.member_1 == 1u) {
                                                                    phi_2950_ = (vec3<f32>(_e230.member[0], _e230.member[1], _e230.member[2]) - _e1464);
                                                                } else {
                                                                    phi_2950_ = vec3<f32>(_e230.member[0], _e230.member[1], _e230.member[2]);
                                                                }
                                                                let _e1510 = phi_2950_;
                                                                let _e1516 = bitcast<f32>((bitcast<u32>((_e1483 * _e1493)) ^ _e230.member_3[0]));
                                                                let _e1520 = bitcast<f32>((bitcast<u32>((_e1486 * _e1491)) ^ _e230.member_3[0]));
                                                                let _e1524 = bitcast<f32>((bitcast<u32>((_e1486 * _e1495)) ^ _e230.member_3[0]));
                                                                let _e1528 = bitcast<f32>((bitcast<u32>((_e1489 * _e1493)) ^ _e230.member_3[0]));
                                                                let _e1532 = bitcast<f32>((bitcast<u32>((_e1489 * _e1491)) ^ _e230.member_3[0]));
                                                                let _e1536 = bitcast<f32>((bitcast<u32>((_e1483 * _e1495)) ^ _e230.member_3[0]));
                                                                let _e1537 = (_e1524 - _e1528);
                                                                let _e1538 = (_e1532 - _e1536);
                                                                let _e1539 = (_e1516 - _e1520);
                                                                let _e1563 = (bitcast<f32>((bitcast<u32>(_e1524) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1528) & 2147483647u)));
                                                                let _e1570 = (bitcast<f32>((bitcast<u32>(_e1532) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1536) & 2147483647u)));
                                                                let _e1577 = (bitcast<f32>((bitcast<u32>(_e1516) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1520) & 2147483647u)));
                                                                if (_e230.member_2 == 0f) {
                                                                    phi_3132_ = 0f;
                                                                } else {
                                                                    let _e1607 = bitcast<f32>((bitcast<u32>(_e1537) & 2147483647u));
                                                                    let _e1610 = bitcast<f32>((bitcast<u32>(_e1538) & 2147483647u));
                                                                    let _e1613 = bitcast<f32>((bitcast<u32>(_e1539) & 2147483647u));
                                                                    let _e1615 = select(_e1613, _e1610, (_e1610 > _e1613));
                                                                    let _e1619 = select(_e1613, _e1610, (_e1610 < _e1613));
                                                                    let _e1623 = select(_e1610, _e1607, (_e1607 < _e1610));
                                                                    let _e1625 = select(_e1610, _e1607, (_e1607 > _e1610));
                                                                    let _e1627 = select(_e1613, _e1625, (_e1625 < _e1613));
                                                                    phi_3132_ = bitcast<f32>((bitcast<u32>((_e230.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1615, _e1607, (_e1607 > _e1615)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1627, _e1623, (_e1623 > _e1627)))) ^ _e230.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1619, _e1607, (_e1607 < _e1619)))) ^ _e230.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1563 + _e1570) + _e1577))) ^ _e230.member_3[0]))) * 1.0000005f)) ^ _e230.member_3[0])))) ^ _e230.member_3[0]));
                                                                }
                                                                let _e1654 = phi_3132_;
                                                                phi_3150_ = (_e1456 || !(((((bitcast<f32>((bitcast<u32>((_e1510.x * _e1537)) ^ _e230.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1510.y * _e1538)) ^ _e230.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1510.z * _e1539)) ^ _e230.member_3[0]))) * f32(-(_e1455))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1510.x) & 2147483647u)) * _e1563)) ^ _e230.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1510.y) & 2147483647u)) * _e1570)) ^ _e230.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1510.z) & 2147483647u)) * _e1577)) ^ _e230.member_3[0]))))) ^ _e230.member_3[0])) + _e1654) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1668 = phi_3150_;
                                                            phi_3151_ = _e1668;
                                                        }
                                                        let _e1670 = phi_3151_;
                                                        if _e1670 {
                                                            phi_3156_ = type_49(_e1064.member, true);
                                                        } else {
                                                            phi_3156_ = _e1064;
                                                        }
                                                        let _e1675 = phi_3156_;
                                                        phi_3157_ = _e1675;
                                                    } else {
                                                        phi_3157_ = _e1064;
                                                    }
                                                    let _e1677 = phi_3157_;
                                                    phi_2111_ = _e1677;
                                                } else {
                                                    phi_2111_ = type_49();
                                                }
                                                let _e1679 = phi_2111_;
                                                continue;
                                                continuing {
                                                    phi_2110_ = _e1679;
                                                    phi_2113_ = _e1079;
                                                    phi_4705_ = _e583;
                                                    break if !(_e1085);
                                                }
                                            }
                                            let _e1682 = phi_4705_;
                                            phi_4843_ = _e1682;
                                            if _e1682 {
                                                break;
                                            }
                                            let _e1684 = local_4;
                                            phi_4847_ = _e1682;
                                            let _e1871 = local_6;
                                            phi_4461_ = _e1871;
                                            phi_4462_ = _e614;
                                            phi_4463_ = false;
                                            phi_4464_ = select(_e618, 0u, _e1684.member_1);
                                        } else {
                                            if (_e614.member_1 >= _e91) {
                                                phi_4061_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e614.member_1 < _e91) {
                                                } else {
                                                    phi_4843_ = true;
                                                    break;
                                                }
                                                let _e630 = ((1u + _e363) % 4u);
                                                if (_e630 < 4u) {
                                                } else {
                                                    phi_4843_ = true;
                                                    break;
                                                }
                                                let _e635 = global_5.member[_e614.member_1][_e630];
                                                let _e637 = ((1u + _e362) % 4u);
                                                if (_e637 < 4u) {
                                                } else {
                                                    phi_4843_ = true;
                                                    break;
                                                }
                                                let _e642 = global_5.member[_e614.member_1][_e637];
                                                let _e644 = ((1u + _e364) % 4u);
                                                if (_e644 < 4u) {
                                                } else {
                                                    phi_4843_ = true;
                                                    break;
                                                }
                                                let _e649 = global_5.member[_e614.member_1][_e644];
                                                let _e651 = ((_e363 + 1u) % 4u);
                                                if (_e651 < 4u) {
                                                } else {
                                                    phi_4843_ = true;
                                                    break;
                                                }
                                                let _e656 = global_5.member[_e614.member_1][_e651];
                                                let _e658 = (_e656 >> bitcast<u32>(11u));
                                                let _e660 = ((_e362 + 1u) % 4u);
                                                if (_e660 < 4u) {
                                                } else {
                                                    phi_4843_ = true;
                                                    break;
                                                }
                                                let _e665 = global_5.member[_e614.member_1][_e660];
                                                let _e667 = (_e665 >> bitcast<u32>(11u));
                                                let _e669 = ((_e364 + 1u) % 4u);
                                                if (_e669 < 4u) {
                                                } else {
                                                    phi_4843_ = true;
                                                    break;
                                                }
                                                let _e674 = global_5.member[_e614.member_1][_e669];
                                                let _e676 = (_e674 >> bitcast<u32>(11u));
                                                let _e699 = (bitcast<f32>((bitcast<u32>((_e614.member.member_1.x - _e614.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e700 = (bitcast<f32>((bitcast<u32>((_e614.member.member_1.y - _e614.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e701 = (bitcast<f32>((bitcast<u32>((_e614.member.member_1.z - _e614.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e703 = select(_e149, _e699, (_e699 > _e149));
                                                let _e705 = select(_e149, _e700, (_e700 > _e149));
                                                let _e707 = select(_e149, _e701, (_e701 > _e149));
                                                let _e732 = bitcast<u32>((f32(bitcast<i32>((_e635 & 1023u))) * _e703));
                                                let _e737 = (bitcast<i32>((_e635 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e740 = bitcast<f32>((_e732 & bitcast<u32>(_e737)));
                                                let _e741 = bitcast<u32>((f32(bitcast<i32>((_e642 & 1023u))) * _e705));
                                                let _e746 = (bitcast<i32>((_e642 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e749 = bitcast<f32>((_e741 & bitcast<u32>(_e746)));
                                                let _e750 = bitcast<u32>((f32(bitcast<i32>((_e649 & 1023u))) * _e707));
                                                let _e755 = (bitcast<i32>((_e649 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e758 = bitcast<f32>((_e750 & bitcast<u32>(_e755)));
                                                let _e762 = bitcast<f32>((_e732 & bitcast<u32>(~(_e737))));
                                                let _e766 = bitcast<f32>((_e741 & bitcast<u32>(~(_e746))));
                                                let _e770 = bitcast<f32>((_e750 & bitcast<u32>(~(_e755))));
                                                let _e771 = bitcast<u32>((f32(bitcast<i32>((_e658 & 1023u))) * _e703));
                                                let _e776 = (bitcast<i32>((_e658 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e779 = bitcast<f32>((_e771 & bitcast<u32>(_e776)));
                                                let _e780 = bitcast<u32>((f32(bitcast<i32>((_e667 & 1023u))) * _e705));
                                                let _e785 = (bitcast<i32>((_e667 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e788 = bitcast<f32>((_e780 & bitcast<u32>(_e785)));
                                                let _e789 = bitcast<u32>((f32(bitcast<i32>((_e676 & 1023u))) * _e707));
                                                let _e794 = (bitcast<i32>((_e676 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e797 = bitcast<f32>((_e789 & bitcast<u32>(_e794)));
                                                let _e801 = bitcast<f32>((_e771 & bitcast<u32>(~(_e776))));
                                                let _e805 = bitcast<f32>((_e780 & bitcast<u32>(~(_e785))));
                                                let _e809 = bitcast<f32>((_e789 & bitcast<u32>(~(_e794))));
                                                let _e839 = global_5.member[_e614.member_1][0u];
                                                let _e843 = global_5.member[_e614.member_1][1u];
                                                let _e847 = global_5.member[_e614.member_1][2u];
                                                let _e851 = global_5.member[_e614.member_1][3u];
                                                let _e863 = (((_e843 >> bitcast<u32>(22i)) | ((_e847 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e851 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e864 = (_e839 & 268435455u);
                                                let _e865 = (_e863 & 268435455u);
                                                let _e868 = ((_e839 >> bitcast<u32>(28u)) & 7u);
                                                let _e876 = ((_e839 >> bitcast<u32>(31i)) | (((_e863 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e877 = (_e868 != 0u);
                                                if (_e868 == 0u) {
                                                    phi_4023_ = _e864;
                                                } else {
                                                    if (_e868 == 7u) {
                                                        phi_4022_ = 2147483648u;
                                                    } else {
                                                        phi_4022_ = ((2147483648u | (_e868 << bitcast<u32>(28u))) | (_e865 & 268435455u));
                                                    }
                                                    let _e886 = phi_4022_;
                                                    phi_4023_ = _e886;
                                                }
                                                let _e888 = phi_4023_;
                                                if _e877 {
                                                    let _e889 = (_e868 != 7u);
                                                    if _e889 {
                                                        phi_4033_ = (_e865 + _e868);
                                                    } else {
                                                        phi_4033_ = u32();
                                                    }
                                                    let _e892 = phi_4033_;
                                                    phi_4035_ = _e892;
                                                    phi_4036_ = select(true, false, _e889);
                                                } else {
                                                    phi_4035_ = u32();
                                                    phi_4036_ = true;
                                                }
                                                let _e895 = phi_4035_;
                                                let _e897 = phi_4036_;
                                                if (_e876 == 0u) {
                                                    phi_4057_ = (_e864 + select(0u, 1u, !(_e877)));
                                                } else {
                                                    if (_e876 == 7u) {
                                                        phi_4056_ = 2147483648u;
                                                    } else {
                                                        phi_4056_ = ((2147483648u | (_e876 << bitcast<u32>(28u))) | (select(_e895, _e865, _e897) & 268435455u));
                                                    }
                                                    let _e910 = phi_4056_;
                                                    phi_4057_ = _e910;
                                                }
                                                let _e912 = phi_4057_;
                                                phi_4061_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e614.member.member.x + _e740), (_e614.member.member.x + _e762), (_e614.member.member_1.x - _e779), (_e614.member.member_1.x - _e801)), vec4<f32>((_e614.member.member.y + _e749), (_e614.member.member.y + _e766), (_e614.member.member_1.y - _e788), (_e614.member.member_1.y - _e805)), vec4<f32>((_e614.member.member.z + _e758), (_e614.member.member.z + _e770), (_e614.member.member_1.z - _e797), (_e614.member.member_1.z - _e809))), type_61(type_38((_e614.member.member + vec4<f32>(_e740, _e749, _e758, 0f)), (_e614.member.member_1 - vec4<f32>(_e779, _e788, _e797, 0f))), _e888), type_61(type_38((_e614.member.member + vec4<f32>(_e762, _e766, _e770, 0f)), (_e614.member.member_1 - vec4<f32>(_e801, _e805, _e809, 0f))), _e912));
                                            }
                                            let _e917 = phi_4061_;
                                            let _e929 = ((_e917.member[0].x - _e418) * _e423);
                                            let _e930 = ((_e917.member[0].y - _e418) * _e423);
                                            let _e931 = ((_e917.member[0].z - _e419) * _e423);
                                            let _e932 = ((_e917.member[0].w - _e419) * _e423);
                                            let _e942 = ((_e917.member[1].x - _e454) * _e459);
                                            let _e943 = ((_e917.member[1].y - _e454) * _e459);
                                            let _e944 = ((_e917.member[1].z - _e455) * _e459);
                                            let _e945 = ((_e917.member[1].w - _e455) * _e459);
                                            let _e955 = ((_e917.member[2].x - _e490) * _e495);
                                            let _e956 = ((_e917.member[2].y - _e490) * _e495);
                                            let _e957 = ((_e917.member[2].z - _e491) * _e495);
                                            let _e958 = ((_e917.member[2].w - _e491) * _e495);
                                            let _e960 = select(_e957, _e955, (_e955 < _e957));
                                            let _e962 = select(_e958, _e956, (_e956 < _e958));
                                            let _e964 = select(_e957, _e955, (_e955 > _e957));
                                            let _e966 = select(_e958, _e956, (_e956 > _e958));
                                            let _e968 = select(_e931, _e929, (_e929 < _e931));
                                            let _e970 = select(_e932, _e930, (_e930 < _e932));
                                            let _e972 = select(_e944, _e942, (_e942 < _e944));
                                            let _e974 = select(_e945, _e943, (_e943 < _e945));
                                            let _e976 = select(_e972, _e968, (_e968 > _e972));
                                            let _e978 = select(_e974, _e970, (_e970 > _e974));
                                            let _e980 = select(_e960, _e976, (_e976 > _e960));
                                            let _e982 = select(_e962, _e978, (_e978 > _e962));
                                            let _e984 = select(_e931, _e929, (_e929 > _e931));
                                            let _e986 = select(_e932, _e930, (_e930 > _e932));
                                            let _e988 = select(_e944, _e942, (_e942 > _e944));
                                            let _e990 = select(_e945, _e943, (_e943 > _e945));
                                            let _e992 = select(_e988, _e984, (_e984 < _e988));
                                            let _e994 = select(_e990, _e986, (_e986 < _e990));
                                            let _e999 = -(_e960);
                                            let _e1000 = -(_e962);
                                            let _e1007 = (select(_e964, _e992, (_e992 < _e964)) + (select(_e999, _e964, (_e964 > _e999)) * 0.0000019073523f));
                                            let _e1008 = (select(_e966, _e994, (_e994 < _e966)) + (select(_e1000, _e966, (_e966 > _e1000)) * 0.0000019073523f));
                                            let _e1010 = select(_e541, _e980, (_e980 > _e541));
                                            let _e1012 = select(_e541, _e982, (_e982 > _e541));
                                            let _e1017 = (_e1010 <= select(_e585.member, _e1007, (_e1007 < _e585.member)));
                                            let _e1018 = (_e1012 <= select(_e585.member, _e1008, (_e1008 < _e585.member)));
                                            let _e1019 = (_e1010 <= _e1012);
                                            if _e1017 {
                                                if _e1018 {
                                                    if _e1019 {
                                                        phi_4405_ = _e917.member_2;
                                                    } else {
                                                        phi_4405_ = _e917.member_1;
                                                    }
                                                    let _e1023 = phi_4405_;
                                                    let _e1024 = (_e618 % 128u);
                                                    let _e1025 = (_e1024 < 128u);
                                                    if _e1025 {
                                                    } else {
                                                        phi_4843_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1024] = type_61(type_38(_e1023.member.member, _e1023.member.member_1), _e1023.member_1);
                                                    if _e1025 {
                                                    } else {
                                                        phi_4843_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1024] = select(_e1012, _e1010, (_e1010 > _e1012));
                                                    if _e1019 {
                                                        phi_4438_ = _e917.member_1;
                                                    } else {
                                                        phi_4438_ = _e917.member_2;
                                                    }
                                                    let _e1040 = phi_4438_;
                                                    phi_4439_ = _e1040;
                                                    phi_4440_ = (_e618 + 1u);
                                                } else {
                                                    phi_4439_ = type_61();
                                                    phi_4440_ = u32();
                                                }
                                                let _e1042 = phi_4439_;
                                                let _e1044 = phi_4440_;
                                                phi_4442_ = _e1042;
                                                phi_4443_ = _e1044;
                                                phi_4444_ = select(true, false, _e1018);
                                            } else {
                                                phi_4442_ = type_61();
                                                phi_4443_ = u32();
                                                phi_4444_ = true;
                                            }
                                            let _e1047 = phi_4442_;
                                            let _e1049 = phi_4443_;
                                            let _e1051 = phi_4444_;
                                            if _e1051 {
                                                if _e1017 {
                                                    phi_4453_ = _e917.member_1;
                                                } else {
                                                    phi_4453_ = _e917.member_2;
                                                }
                                                let _e1055 = phi_4453_;
                                                phi_4458_ = _e1055;
                                                phi_4459_ = select(_e1018, true, _e1017);
                                            } else {
                                                phi_4458_ = _e1047;
                                                phi_4459_ = _e616;
                                            }
                                            let _e1058 = phi_4458_;
                                            let _e1060 = phi_4459_;
                                            phi_4847_ = _e583;
                                            phi_4461_ = _e585;
                                            phi_4462_ = _e1058;
                                            phi_4463_ = _e1060;
                                            phi_4464_ = select(_e1049, _e618, _e1051);
                                        }
                                        let _e1688 = phi_4847_;
                                        let _e1690 = phi_4461_;
                                        let _e1692 = phi_4462_;
                                        let _e1694 = phi_4463_;
                                        let _e1696 = phi_4464_;
                                        phi_4846_ = _e1688;
                                        phi_4465_ = _e1690;
                                        phi_4466_ = _e1692;
                                        phi_4467_ = (_e589 - 1u);
                                        phi_4468_ = _e1694;
                                        phi_4469_ = _e1696;
                                    } else {
                                        phi_4846_ = _e583;
                                        phi_4465_ = _e585;
                                        phi_4466_ = _e614;
                                        phi_4467_ = _e589;
                                        phi_4468_ = _e616;
                                        phi_4469_ = _e618;
                                    }
                                    let _e1698 = phi_4846_;
                                    let _e1700 = phi_4465_;
                                    let _e1702 = phi_4466_;
                                    let _e1704 = phi_4467_;
                                    let _e1706 = phi_4468_;
                                    let _e1708 = phi_4469_;
                                    phi_4845_ = _e1698;
                                    phi_4470_ = _e1700;
                                    phi_4471_ = _e1702;
                                    phi_4472_ = _e1704;
                                    phi_4473_ = _e1706;
                                    phi_4474_ = _e1708;
                                } else {
                                    phi_4845_ = _e583;
                                    phi_4470_ = type_49();
                                    phi_4471_ = type_61();
                                    phi_4472_ = u32();
                                    phi_4473_ = bool();
                                    phi_4474_ = u32();
                                }
                                let _e1710 = phi_4845_;
                                let _e1712 = phi_4470_;
                                let _e1714 = phi_4471_;
                                let _e1716 = phi_4472_;
                                let _e1718 = phi_4473_;
                                let _e1720 = phi_4474_;
                                phi_4844_ = _e1710;
                                phi_2034_ = _e1712;
                                phi_2037_ = _e1714;
                                phi_2039_ = _e1716;
                                phi_2041_ = _e1718;
                                phi_2043_ = _e1720;
                                phi_4475_ = _e597;
                            } else {
                                phi_4844_ = _e583;
                                phi_2034_ = type_49();
                                phi_2037_ = type_61();
                                phi_2039_ = u32();
                                phi_2041_ = bool();
                                phi_2043_ = u32();
                                phi_4475_ = false;
                            }
                            let _e1722 = phi_4844_;
                            let _e1724 = phi_2034_;
                            let _e1726 = phi_2037_;
                            let _e1728 = phi_2039_;
                            let _e1730 = phi_2041_;
                            let _e1732 = phi_2043_;
                            let _e1734 = phi_4475_;
                            continue;
                            continuing {
                                phi_4711_ = _e1722;
                                phi_2033_ = _e1724;
                                phi_2036_ = _e1726;
                                phi_2038_ = _e1728;
                                phi_2040_ = _e1730;
                                phi_2042_ = _e1732;
                                phi_4843_ = _e1722;
                                break if !(_e1734);
                            }
                        }
                        let _e1737 = phi_4843_;
                        if _e1737 {
                            break;
                        }
                        let _e1739 = local_5;
                        if _e1739.member_1 {
                        } else {
                            if _e231 {
                            } else {
                                break;
                            }
                            let _e1743 = global_2.member[_e137];
                            if _e152 {
                            } else {
                                break;
                            }
                            let _e1747 = global_10.member[_e137].member_1;
                            if _e231 {
                            } else {
                                break;
                            }
                            global_2.member[_e137] = type_31(_e1743.member, _e1743.member_1, _e1743.member_2, array<f32, 3>((_e1743.member_3[0] + (_e1747[0] * _e1743.member_1[0])), (_e1743.member_3[1] + (_e1747[1] * _e1743.member_1[1])), (_e1743.member_3[2] + (_e1747[2] * _e1743.member_1[2]))), _e1743.member_4);
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
fn trace_shadows_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
