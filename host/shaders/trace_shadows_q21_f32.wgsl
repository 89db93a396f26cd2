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
    var phi_324_: u32;
    var phi_368_: i32;
    var phi_392_: type_40;
    var phi_542_: i32;
    var phi_543_: i32;
    var phi_553_: bool;
    var phi_563_: u32;
    var phi_564_: u32;
    var phi_566_: bool;
    var phi_571_: u32;
    var phi_604_: i32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_668_: f32;
    var phi_679_: f32;
    var phi_688_: f32;
    var phi_694_: f32;
    var phi_705_: f32;
    var phi_711_: f32;
    var phi_734_: f32;
    var phi_745_: f32;
    var phi_754_: f32;
    var phi_760_: f32;
    var phi_771_: f32;
    var phi_777_: f32;
    var phi_800_: f32;
    var phi_811_: f32;
    var phi_911_: f32;
    var phi_912_: f32;
    var phi_4710_: bool;
    var phi_2032_: type_45;
    var phi_2035_: type_61;
    var phi_2037_: u32;
    var phi_2039_: bool;
    var phi_2041_: u32;
    var phi_2052_: bool;
    var phi_2089_: type_61;
    var phi_2090_: bool;
    var phi_2091_: u32;
    var phi_4021_: u32;
    var phi_4022_: u32;
    var phi_4032_: u32;
    var phi_4034_: u32;
    var phi_4035_: bool;
    var phi_4055_: u32;
    var phi_4056_: u32;
    var phi_4060_: type_64;
    var phi_4404_: type_61;
    var phi_4437_: type_61;
    var phi_4438_: type_61;
    var phi_4439_: u32;
    var phi_4441_: type_61;
    var phi_4442_: u32;
    var phi_4443_: bool;
    var phi_4452_: type_61;
    var phi_4457_: type_61;
    var phi_4458_: bool;
    var phi_2109_: type_45;
    var phi_2112_: type_8;
    var phi_2113_: type_8;
    var phi_2135_: type_8;
    var phi_2156_: u32;
    var phi_2245_: array<array<f32, 3>, 3>;
    var phi_2716_: vec3<f32>;
    var phi_2717_: vec3<f32>;
    var phi_2748_: bool;
    var phi_2757_: vec3<f32>;
    var phi_2797_: type_25;
    var phi_2799_: type_25;
    var phi_2800_: bool;
    var phi_2804_: type_25;
    var phi_2805_: type_25;
    var phi_2806_: type_25;
    var phi_2807_: bool;
    var phi_2811_: type_25;
    var phi_2812_: bool;
    var phi_2816_: type_25;
    var phi_2817_: bool;
    var phi_2821_: type_25;
    var phi_2844_: u32;
    var phi_2858_: i32;
    var phi_2878_: vec3<f32>;
    var phi_2879_: vec3<f32>;
    var phi_2895_: vec3<f32>;
    var phi_2896_: vec3<f32>;
    var phi_2912_: vec3<f32>;
    var phi_2913_: vec3<f32>;
    var phi_2949_: vec3<f32>;
    var phi_3131_: f32;
    var phi_3149_: bool;
    var phi_3150_: bool;
    var phi_3155_: type_45;
    var phi_3156_: type_45;
    var phi_2110_: type_45;
    var phi_4704_: bool;
    var local_4: type_45;
    var phi_4846_: bool;
    var phi_4460_: type_45;
    var phi_4461_: type_61;
    var phi_4462_: bool;
    var phi_4463_: u32;
    var phi_4845_: bool;
    var phi_4464_: type_45;
    var phi_4465_: type_61;
    var phi_4466_: u32;
    var phi_4467_: bool;
    var phi_4468_: u32;
    var phi_4844_: bool;
    var phi_4469_: type_45;
    var phi_4470_: type_61;
    var phi_4471_: u32;
    var phi_4472_: bool;
    var phi_4473_: u32;
    var phi_4843_: bool;
    var phi_2033_: type_45;
    var phi_2036_: type_61;
    var phi_2038_: u32;
    var phi_2040_: bool;
    var phi_2042_: u32;
    var phi_4474_: bool;
    var phi_4842_: bool;
    var local_5: type_45;
    var local_6: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_9.member));
            let _e92 = arrayLength((&global_5.member));
            let _e104 = arrayLength((&global_8.member));
            let _e108 = global_4.member[0u][0u];
            let _e112 = global_4.member[0u][1u];
            let _e116 = global_4.member[0u][2u];
            let _e120 = global_4.member[0u][3u];
            let _e124 = global_4.member[1u][0u];
            let _e128 = global_4.member[1u][1u];
            let _e132 = global_4.member[1u][2u];
            let _e136 = (_e88.x + (_e88.y * 2097152u));
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e151 = (_e136 < arrayLength((&global_10.member)));
            if _e151 {
                if _e151 {
                } else {
                    break;
                }
                let _e155 = global_10.member[_e136].member_2;
                phi_324_ = _e155;
            } else {
                phi_324_ = 4294967295u;
            }
            let _e157 = phi_324_;
            let _e160 = global_1.member[0u];
            let _e164 = global_3.member[0u][0u];
            let _e168 = global_3.member[0u][1u];
            let _e172 = global_3.member[0u][2u];
            let _e176 = global_3.member[0u][3u];
            let _e180 = global_3.member[1u][0u];
            let _e184 = global_3.member[1u][1u];
            let _e188 = global_3.member[1u][2u];
            let _e192 = global_3.member[1u][3u];
            let _e193 = bitcast<f32>(_e164);
            let _e194 = bitcast<f32>(_e168);
            let _e195 = bitcast<f32>(_e172);
            let _e197 = bitcast<f32>(_e180);
            let _e198 = array<u32, 3>(_e184, _e188, _e192);
            let _e200 = bitcast<i32>(_e160);
            if (_e200 < -126i) {
                phi_368_ = -126i;
            } else {
                phi_368_ = select(_e200, 127i, (_e200 > 127i));
            }
            let _e205 = phi_368_;
            let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
            let _e216 = bitcast<f32>((bitcast<u32>(((_e200 - _e205) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_392_ = type_40(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                phi_392_ = type_40(array<f32, 3>(((_e193 * _e210) * _e216), ((_e194 * _e210) * _e216), ((_e195 * _e210) * _e216)), _e176, ((_e197 * _e210) * _e216), _e198);
            }
            let _e229 = phi_392_;
            if _e151 {
                let _e230 = (_e136 < arrayLength((&global_2.member)));
                if _e230 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e235 = global_10.member[_e136].member.member_1;
                    let _e240 = global_10.member[_e136].member.member_3;
                    if (_e235 <= _e240) {
                        let _e242 = (1u < _e104);
                        if _e242 {
                            if (0u < _e104) {
                            } else {
                                break;
                            }
                            let _e246 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e246 + 1u) < _e246) {
                                if _e242 {
                                } else {
                                    break;
                                }
                                let _e251 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e261 = global_10.member[_e136].member.member_2[0u];
                        let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                        let _e269 = global_10.member[_e136].member.member_2[1u];
                        let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                        let _e277 = global_10.member[_e136].member.member_2[2u];
                        let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                        let _e285 = global_10.member[_e136].member.member[0u];
                        let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                        let _e293 = global_10.member[_e136].member.member[1u];
                        let _e295 = (bitcast<u32>(_e293) & 2147483647u);
                        let _e301 = global_10.member[_e136].member.member[2u];
                        let _e303 = (bitcast<u32>(_e301) & 2147483647u);
                        let _e305 = select(_e271, _e263, (_e271 < _e263));
                        let _e307 = select(_e279, _e305, (_e279 < _e305));
                        let _e309 = select(_e287, _e307, (_e287 < _e307));
                        let _e311 = select(_e295, _e309, (_e295 < _e309));
                        let _e313 = select(_e303, _e311, (_e303 < _e311));
                        let _e315 = (bitcast<u32>(_e235) & 2147483647u);
                        let _e324 = (((select(_e315, _e313, (_e315 < _e313)) < 2139095040u) && ((bitcast<u32>(_e240) & 2147483647u) <= 2139095040u)) && (_e307 > 0u));
                        if _e324 {
                            let _e327 = (bitcast<u32>(bitcast<f32>(_e307)) & 2147483647u);
                            if (_e327 >= 8388608u) {
                                phi_542_ = (bitcast<i32>((_e327 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_542_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e327)), 32u, (_e327 == 0u))));
                            }
                            let _e341 = phi_542_;
                            phi_543_ = _e341;
                        } else {
                            phi_543_ = 0i;
                        }
                        let _e343 = phi_543_;
                        let _e344 = (_e263 == _e307);
                        if _e344 {
                            phi_553_ = true;
                        } else {
                            phi_553_ = (_e271 == _e307);
                        }
                        let _e347 = phi_553_;
                        let _e348 = select(1u, 0u, _e344);
                        if _e347 {
                            let _e349 = (_e348 + 1u);
                            phi_563_ = _e349;
                            phi_564_ = _e349;
                            phi_566_ = select(true, false, (_e349 == 2u));
                        } else {
                            phi_563_ = u32();
                            phi_564_ = 0u;
                            phi_566_ = true;
                        }
                        let _e353 = phi_563_;
                        let _e355 = phi_564_;
                        let _e357 = phi_566_;
                        if _e357 {
                            phi_571_ = (_e355 + 1u);
                        } else {
                            phi_571_ = 0u;
                        }
                        let _e361 = phi_571_;
                        let _e362 = select(_e353, _e355, _e357);
                        let _e363 = select(_e348, select(2u, _e348, _e347), _e357);
                        let _e364 = -(_e343);
                        if (_e364 < -126i) {
                            phi_604_ = -126i;
                        } else {
                            phi_604_ = select(_e364, 127i, (_e364 > 127i));
                        }
                        let _e369 = phi_604_;
                        let _e374 = bitcast<f32>((bitcast<u32>((_e369 + 127i)) << bitcast<u32>(23i)));
                        let _e380 = bitcast<f32>((bitcast<u32>(((_e364 - _e369) + 127i)) << bitcast<u32>(23i)));
                        let _e385 = global_10.member[_e136].member.member;
                        let _e386 = (_e362 == 0u);
                        if _e386 {
                            phi_622_ = _e385[0];
                        } else {
                            phi_622_ = _e385[1];
                        }
                        let _e390 = phi_622_;
                        let _e391 = (_e362 == 2u);
                        if _e391 {
                            phi_628_ = _e385[2];
                        } else {
                            phi_628_ = _e390;
                        }
                        let _e394 = phi_628_;
                        let _e395 = global_10.member[_e136].member.member_2;
                        if _e386 {
                            phi_639_ = _e395[0];
                        } else {
                            phi_639_ = _e395[1];
                        }
                        let _e399 = phi_639_;
                        if _e391 {
                            phi_645_ = _e395[2];
                        } else {
                            phi_645_ = _e399;
                        }
                        let _e402 = phi_645_;
                        let _e404 = ((_e402 * _e374) * _e380);
                        let _e408 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e408 {
                            let _e412 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) * 0.00000011920929f);
                            phi_668_ = select(0.00000000000011368684f, _e412, (_e412 > 0.00000000000011368684f));
                        } else {
                            phi_668_ = 0f;
                        }
                        let _e416 = phi_668_;
                        let _e417 = (_e394 + _e416);
                        let _e418 = (_e394 - _e416);
                        let _e419 = select(_e404, 0f, _e408);
                        if _e408 {
                            phi_679_ = 38685626000000000000000000f;
                        } else {
                            phi_679_ = (1f / _e404);
                        }
                        let _e422 = phi_679_;
                        let _e423 = (_e361 == 0u);
                        if _e423 {
                            phi_688_ = _e385[0];
                        } else {
                            phi_688_ = _e385[1];
                        }
                        let _e427 = phi_688_;
                        let _e428 = (_e361 == 2u);
                        if _e428 {
                            phi_694_ = _e385[2];
                        } else {
                            phi_694_ = _e427;
                        }
                        let _e431 = phi_694_;
                        if _e423 {
                            phi_705_ = _e395[0];
                        } else {
                            phi_705_ = _e395[1];
                        }
                        let _e435 = phi_705_;
                        if _e428 {
                            phi_711_ = _e395[2];
                        } else {
                            phi_711_ = _e435;
                        }
                        let _e438 = phi_711_;
                        let _e440 = ((_e438 * _e374) * _e380);
                        let _e444 = (bitcast<f32>((bitcast<u32>(_e440) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e444 {
                            let _e448 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) * 0.00000011920929f);
                            phi_734_ = select(0.00000000000011368684f, _e448, (_e448 > 0.00000000000011368684f));
                        } else {
                            phi_734_ = 0f;
                        }
                        let _e452 = phi_734_;
                        let _e453 = (_e431 + _e452);
                        let _e454 = (_e431 - _e452);
                        let _e455 = select(_e440, 0f, _e444);
                        if _e444 {
                            phi_745_ = 38685626000000000000000000f;
                        } else {
                            phi_745_ = (1f / _e440);
                        }
                        let _e458 = phi_745_;
                        let _e459 = (_e363 == 0u);
                        if _e459 {
                            phi_754_ = _e385[0];
                        } else {
                            phi_754_ = _e385[1];
                        }
                        let _e463 = phi_754_;
                        let _e464 = (_e363 == 2u);
                        if _e464 {
                            phi_760_ = _e385[2];
                        } else {
                            phi_760_ = _e463;
                        }
                        let _e467 = phi_760_;
                        if _e459 {
                            phi_771_ = _e395[0];
                        } else {
                            phi_771_ = _e395[1];
                        }
                        let _e471 = phi_771_;
                        if _e464 {
                            phi_777_ = _e395[2];
                        } else {
                            phi_777_ = _e471;
                        }
                        let _e474 = phi_777_;
                        let _e476 = ((_e474 * _e374) * _e380);
                        let _e480 = (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e480 {
                            let _e484 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) * 0.00000011920929f);
                            phi_800_ = select(0.00000000000011368684f, _e484, (_e484 > 0.00000000000011368684f));
                        } else {
                            phi_800_ = 0f;
                        }
                        let _e488 = phi_800_;
                        let _e489 = (_e467 + _e488);
                        let _e490 = (_e467 - _e488);
                        let _e491 = select(_e476, 0f, _e480);
                        if _e480 {
                            phi_811_ = 38685626000000000000000000f;
                        } else {
                            phi_811_ = (1f / _e476);
                        }
                        let _e494 = phi_811_;
                        let _e497 = bitcast<f32>((bitcast<u32>(_e394) & 2147483647u));
                        let _e500 = bitcast<f32>((bitcast<u32>(_e431) & 2147483647u));
                        let _e502 = select(_e500, _e497, (_e497 > _e500));
                        let _e505 = bitcast<f32>((bitcast<u32>(_e467) & 2147483647u));
                        if (_e324 && (select(_e505, _e502, (_e502 > _e505)) <= 1099511600000f)) {
                            let _e510 = (_e343 / 3i);
                            let _e517 = bitcast<f32>((bitcast<u32>((_e510 + 127i)) << bitcast<u32>(23i)));
                            let _e524 = bitcast<f32>((bitcast<u32>(((_e343 - (2i * _e510)) + 127i)) << bitcast<u32>(23i)));
                            let _e525 = (((_e235 * _e517) * _e517) * _e524);
                            let _e527 = select(340282350000000000000000000000000000000f, _e525, (_e525 < 340282350000000000000000000000000000000f));
                            let _e532 = (((_e240 * _e517) * _e517) * _e524);
                            let _e534 = select(340282350000000000000000000000000000000f, _e532, (_e532 < 340282350000000000000000000000000000000f));
                            phi_911_ = select(-340282350000000000000000000000000000000f, _e534, (_e534 > -340282350000000000000000000000000000000f));
                            phi_912_ = select(-340282350000000000000000000000000000000f, _e527, (_e527 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_911_ = 0f;
                            phi_912_ = 1f;
                        }
                        let _e538 = phi_911_;
                        let _e540 = phi_912_;
                        local_3 = array<type_61, 128>(type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e544 = (_e362 % 3u);
                        let _e545 = (_e544 < 3u);
                        if _e545 {
                        } else {
                            break;
                        }
                        let _e547 = local_1[_e544];
                        let _e550 = (_e361 % 3u);
                        let _e551 = (_e550 < 3u);
                        if _e551 {
                        } else {
                            break;
                        }
                        let _e553 = local_1[_e550];
                        let _e556 = (_e363 % 3u);
                        let _e557 = (_e556 < 3u);
                        if _e557 {
                        } else {
                            break;
                        }
                        let _e559 = local_1[_e556];
                        if _e545 {
                        } else {
                            break;
                        }
                        let _e564 = local[_e544];
                        if _e551 {
                        } else {
                            break;
                        }
                        let _e568 = local[_e550];
                        if _e557 {
                        } else {
                            break;
                        }
                        let _e572 = local[_e556];
                        phi_4710_ = false;
                        phi_2032_ = type_45(_e538, false);
                        phi_2035_ = type_61(type_34(vec4<f32>((f32(_e547) * _e148), (f32(_e553) * _e148), (f32(_e559) * _e148), 0f), vec4<f32>((f32(_e564) * _e148), (f32(_e568) * _e148), (f32(_e572) * _e148), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                        phi_2037_ = ((3u * _e90) + 1u);
                        phi_2039_ = (_e540 <= _e538);
                        phi_2041_ = 0u;
                        loop {
                            let _e582 = phi_4710_;
                            let _e584 = phi_2032_;
                            let _e586 = phi_2035_;
                            let _e588 = phi_2037_;
                            let _e590 = phi_2039_;
                            let _e592 = phi_2041_;
                            local_5 = _e584;
                            if _e590 {
                                phi_2052_ = true;
                            } else {
                                phi_2052_ = (_e592 > 0u);
                            }
                            let _e595 = phi_2052_;
                            if _e595 {
                                let _e596 = (_e588 > 0u);
                                if _e596 {
                                    if _e590 {
                                        phi_2089_ = _e586;
                                        phi_2090_ = _e590;
                                        phi_2091_ = _e592;
                                    } else {
                                        let _e597 = (_e592 - 1u);
                                        let _e598 = (_e597 % 128u);
                                        let _e599 = (_e598 < 128u);
                                        if _e599 {
                                        } else {
                                            phi_4842_ = true;
                                            break;
                                        }
                                        let _e601 = local_3[_e598];
                                        if _e599 {
                                        } else {
                                            phi_4842_ = true;
                                            break;
                                        }
                                        let _e609 = local_2[_e598];
                                        phi_2089_ = type_61(type_34(_e601.member.member, _e601.member.member_1), _e601.member_1);
                                        phi_2090_ = (_e609 <= _e584.member);
                                        phi_2091_ = _e597;
                                    }
                                    let _e613 = phi_2089_;
                                    let _e615 = phi_2090_;
                                    let _e617 = phi_2091_;
                                    if _e615 {
                                        if ((_e613.member_1 & 2147483648u) != 0u) {
                                            phi_2109_ = _e584;
                                            phi_2112_ = type_8(0u, ((_e613.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1063 = phi_2109_;
                                                let _e1065 = phi_2112_;
                                                local_4 = _e1063;
                                                local_6 = _e1063;
                                                if (_e1065.member < _e1065.member_1) {
                                                    phi_2113_ = type_8((_e1065.member + 1u), _e1065.member_1);
                                                    phi_2135_ = type_8(1u, _e1065.member);
                                                } else {
                                                    phi_2113_ = _e1065;
                                                    phi_2135_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1078 = phi_2113_;
                                                let _e1080 = phi_2135_;
                                                let _e1084 = (bitcast<i32>(_e1080.member) != 0i);
                                                if _e1084 {
                                                    let _e1085 = ((_e613.member_1 & 268435455u) + _e1080.member_1);
                                                    let _e1086 = (_e1085 < _e92);
                                                    if _e1086 {
                                                        if _e1086 {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        let _e1090 = global_5.member[_e1085].member_1;
                                                        phi_2156_ = _e1090;
                                                    } else {
                                                        phi_2156_ = 4294967295u;
                                                    }
                                                    let _e1092 = phi_2156_;
                                                    if (_e1085 >= _e92) {
                                                        phi_2245_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1086 {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        if (_e544 < 9u) {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        let _e1099 = global_5.member[_e1085].member[_e544];
                                                        if (_e550 < 9u) {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        let _e1105 = global_5.member[_e1085].member[_e550];
                                                        if (_e556 < 9u) {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        let _e1111 = global_5.member[_e1085].member[_e556];
                                                        let _e1113 = (3u + _e544);
                                                        if (_e1113 < 9u) {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        let _e1119 = global_5.member[_e1085].member[_e1113];
                                                        let _e1120 = (3u + _e550);
                                                        if (_e1120 < 9u) {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        let _e1126 = global_5.member[_e1085].member[_e1120];
                                                        let _e1127 = (3u + _e556);
                                                        if (_e1127 < 9u) {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        let _e1133 = global_5.member[_e1085].member[_e1127];
                                                        let _e1135 = (6u + _e544);
                                                        if (_e1135 < 9u) {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        let _e1141 = global_5.member[_e1085].member[_e1135];
                                                        let _e1142 = (6u + _e550);
                                                        if (_e1142 < 9u) {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        let _e1148 = global_5.member[_e1085].member[_e1142];
                                                        let _e1149 = (6u + _e556);
                                                        if (_e1149 < 9u) {
                                                        } else {
                                                            phi_4704_ = true;
                                                            break;
                                                        }
                                                        let _e1155 = global_5.member[_e1085].member[_e1149];
                                                        phi_2245_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1099, _e1105, _e1111), array<f32, 3>(_e1119, _e1126, _e1133), array<f32, 3>(_e1141, _e1148, _e1155));
                                                    }
                                                    let _e1159 = phi_2245_;
                                                    let _e1167 = (_e1159[0][2] - _e467);
                                                    let _e1170 = (((_e1159[0][0] - _e394) * _e491) - (_e1167 * _e419));
                                                    let _e1173 = (((_e1159[0][1] - _e431) * _e491) - (_e1167 * _e455));
                                                    let _e1180 = (_e1159[1][2] - _e467);
                                                    let _e1183 = (((_e1159[1][0] - _e394) * _e491) - (_e1180 * _e419));
                                                    let _e1186 = (((_e1159[1][1] - _e431) * _e491) - (_e1180 * _e455));
                                                    let _e1193 = (_e1159[2][2] - _e467);
                                                    let _e1196 = (((_e1159[2][0] - _e394) * _e491) - (_e1193 * _e419));
                                                    let _e1199 = (((_e1159[2][1] - _e431) * _e491) - (_e1193 * _e455));
                                                    let _e1200 = (_e1196 * _e1186);
                                                    let _e1201 = (_e1199 * _e1183);
                                                    let _e1202 = (_e1170 * _e1199);
                                                    let _e1203 = (_e1173 * _e1196);
                                                    let _e1204 = (_e1183 * _e1173);
                                                    let _e1205 = (_e1186 * _e1170);
                                                    let _e1210 = (((_e1200 >= _e1201) && (_e1202 >= _e1203)) && (_e1204 >= _e1205));
                                                    if (_e1210 || (((_e1200 <= _e1201) && (_e1202 <= _e1203)) && (_e1204 <= _e1205))) {
                                                        let _e1217 = select(-1f, 1f, _e1210);
                                                        let _e1219 = ((_e1200 - _e1201) * _e1217);
                                                        let _e1221 = select(0f, _e1219, (_e1219 > 0f));
                                                        let _e1223 = ((_e1202 - _e1203) * _e1217);
                                                        let _e1225 = select(0f, _e1223, (_e1223 > 0f));
                                                        let _e1227 = ((_e1204 - _e1205) * _e1217);
                                                        let _e1229 = select(0f, _e1227, (_e1227 > 0f));
                                                        let _e1231 = ((_e1221 + _e1225) + _e1229);
                                                        if (_e1231 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2811_ = type_25();
                                                            phi_2812_ = true;
                                                        } else {
                                                            let _e1234 = select(_e1159[1][0], _e1159[0][0], (_e1159[0][0] < _e1159[1][0]));
                                                            let _e1238 = select(_e1159[1][0], _e1159[0][0], (_e1159[0][0] > _e1159[1][0]));
                                                            let _e1242 = select(_e1159[1][1], _e1159[0][1], (_e1159[0][1] < _e1159[1][1]));
                                                            let _e1246 = select(_e1159[1][1], _e1159[0][1], (_e1159[0][1] > _e1159[1][1]));
                                                            let _e1250 = select(_e1159[1][2], _e1159[0][2], (_e1159[0][2] < _e1159[1][2]));
                                                            let _e1254 = select(_e1159[1][2], _e1159[0][2], (_e1159[0][2] > _e1159[1][2]));
                                                            let _e1259 = ((select(_e1159[2][0], _e1234, (_e1234 < _e1159[2][0])) - _e417) * _e422);
                                                            let _e1260 = ((select(_e1159[2][0], _e1238, (_e1238 > _e1159[2][0])) - _e418) * _e422);
                                                            let _e1263 = ((select(_e1159[2][1], _e1242, (_e1242 < _e1159[2][1])) - _e453) * _e458);
                                                            let _e1264 = ((select(_e1159[2][1], _e1246, (_e1246 > _e1159[2][1])) - _e454) * _e458);
                                                            let _e1267 = ((select(_e1159[2][2], _e1250, (_e1250 < _e1159[2][2])) - _e489) * _e494);
                                                            let _e1268 = ((select(_e1159[2][2], _e1254, (_e1254 > _e1159[2][2])) - _e490) * _e494);
                                                            let _e1270 = select(_e1268, _e1267, (_e1267 < _e1268));
                                                            let _e1272 = select(_e1268, _e1267, (_e1267 > _e1268));
                                                            let _e1274 = select(_e1260, _e1259, (_e1259 < _e1260));
                                                            let _e1276 = select(_e1264, _e1263, (_e1263 < _e1264));
                                                            let _e1278 = select(_e1276, _e1274, (_e1274 > _e1276));
                                                            let _e1280 = select(_e1270, _e1278, (_e1278 > _e1270));
                                                            let _e1282 = select(_e1260, _e1259, (_e1259 > _e1260));
                                                            let _e1284 = select(_e1264, _e1263, (_e1263 > _e1264));
                                                            let _e1286 = select(_e1284, _e1282, (_e1282 < _e1284));
                                                            let _e1288 = select(_e1272, _e1286, (_e1286 < _e1272));
                                                            let _e1289 = -(_e1270);
                                                            let _e1295 = select(_e540, _e1280, (_e1280 > _e540));
                                                            if (_e1295 > (_e1288 + (select(_e1289, _e1272, (_e1272 > _e1289)) * 0.0000019073523f))) {
                                                                phi_2806_ = type_25();
                                                                phi_2807_ = true;
                                                            } else {
                                                                let _e1297 = (_e1295 > _e1063.member);
                                                                if _e1297 {
                                                                    phi_2805_ = type_25();
                                                                } else {
                                                                    let _e1301 = (_e1159[1][0] - _e1159[0][0]);
                                                                    let _e1302 = (_e1159[1][1] - _e1159[0][1]);
                                                                    let _e1303 = (_e1159[1][2] - _e1159[0][2]);
                                                                    let _e1304 = vec3<f32>(_e1301, _e1302, _e1303);
                                                                    let _e1305 = (_e1159[2][0] - _e1159[1][0]);
                                                                    let _e1306 = (_e1159[2][1] - _e1159[1][1]);
                                                                    let _e1307 = (_e1159[2][2] - _e1159[1][2]);
                                                                    let _e1308 = vec3<f32>(_e1305, _e1306, _e1307);
                                                                    let _e1309 = (_e1159[0][0] - _e1159[2][0]);
                                                                    let _e1310 = (_e1159[0][1] - _e1159[2][1]);
                                                                    let _e1311 = (_e1159[0][2] - _e1159[2][2]);
                                                                    let _e1312 = vec3<f32>(_e1309, _e1310, _e1311);
                                                                    let _e1315 = bitcast<f32>((bitcast<u32>(_e1301) & 2147483647u));
                                                                    let _e1318 = bitcast<f32>((bitcast<u32>(_e1302) & 2147483647u));
                                                                    let _e1320 = select(_e1318, _e1315, (_e1315 > _e1318));
                                                                    let _e1323 = bitcast<f32>((bitcast<u32>(_e1303) & 2147483647u));
                                                                    let _e1325 = select(_e1323, _e1320, (_e1320 > _e1323));
                                                                    let _e1328 = bitcast<f32>((bitcast<u32>(_e1305) & 2147483647u));
                                                                    let _e1331 = bitcast<f32>((bitcast<u32>(_e1306) & 2147483647u));
                                                                    let _e1333 = select(_e1331, _e1328, (_e1328 > _e1331));
                                                                    let _e1336 = bitcast<f32>((bitcast<u32>(_e1307) & 2147483647u));
                                                                    let _e1338 = select(_e1336, _e1333, (_e1333 > _e1336));
                                                                    let _e1341 = bitcast<f32>((bitcast<u32>(_e1309) & 2147483647u));
                                                                    let _e1344 = bitcast<f32>((bitcast<u32>(_e1310) & 2147483647u));
                                                                    let _e1346 = select(_e1344, _e1341, (_e1341 > _e1344));
                                                                    let _e1349 = bitcast<f32>((bitcast<u32>(_e1311) & 2147483647u));
                                                                    let _e1351 = select(_e1349, _e1346, (_e1346 > _e1349));
                                                                    let _e1353 = select(_e1338, _e1325, (_e1325 > _e1338));
                                                                    let _e1355 = select(_e1351, _e1353, (_e1353 > _e1351));
                                                                    if (_e1325 == _e1355) {
                                                                        phi_2716_ = _e1308;
                                                                        phi_2717_ = _e1312;
                                                                    } else {
                                                                        let _e1358 = vec3((_e1338 == _e1355));
                                                                        phi_2716_ = select(_e1304, _e1312, _e1358);
                                                                        phi_2717_ = select(_e1308, _e1304, _e1358);
                                                                    }
                                                                    let _e1362 = phi_2716_;
                                                                    let _e1364 = phi_2717_;
                                                                    let _e1371 = ((_e1362.y * _e1364.z) - (_e1364.y * _e1362.z));
                                                                    let _e1376 = ((_e1362.z * _e1364.x) - (_e1364.z * _e1362.x));
                                                                    let _e1379 = ((_e1362.x * _e1364.y) - (_e1364.x * _e1362.y));
                                                                    if (_e1221 >= _e1225) {
                                                                        phi_2748_ = select(true, false, (_e1221 >= _e1229));
                                                                    } else {
                                                                        phi_2748_ = true;
                                                                    }
                                                                    let _e1384 = phi_2748_;
                                                                    if _e1384 {
                                                                        phi_2757_ = select(vec3<f32>(_e1159[2][0], _e1159[2][1], _e1159[2][2]), vec3<f32>(_e1159[1][0], _e1159[1][1], _e1159[1][2]), vec3((_e1225 >= _e1229)));
                                                                    } else {
                                                                        phi_2757_ = vec3<f32>(_e1159[0][0], _e1159[0][1], _e1159[0][2]);
                                                                    }
                                                                    let _e1389 = phi_2757_;
                                                                    let _e1406 = ((((_e1371 * (_e1389.x - _e394)) + (_e1376 * (_e1389.y - _e431))) + (_e1379 * (_e1389.z - _e467))) / (((_e1371 * _e419) + (_e1376 * _e455)) + (_e1379 * _e491)));
                                                                    let _e1408 = select(_e1288, _e1406, (_e1406 < _e1288));
                                                                    let _e1410 = select(_e1280, _e1408, (_e1408 > _e1280));
                                                                    if (_e1410 >= _e540) {
                                                                        let _e1412 = (_e1410 <= _e1063.member);
                                                                        if _e1412 {
                                                                            let _e1413 = (1f / _e1231);
                                                                            phi_2797_ = type_25(_e1410, (_e1225 * _e1413), (_e1229 * _e1413), _e1092);
                                                                        } else {
                                                                            phi_2797_ = type_25();
                                                                        }
                                                                        let _e1418 = phi_2797_;
                                                                        phi_2799_ = _e1418;
                                                                        phi_2800_ = select(true, false, _e1412);
                                                                    } else {
                                                                        phi_2799_ = type_25();
                                                                        phi_2800_ = true;
                                                                    }
                                                                    let _e1421 = phi_2799_;
                                                                    let _e1423 = phi_2800_;
                                                                    if _e1423 {
                                                                        phi_2804_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2804_ = _e1421;
                                                                    }
                                                                    let _e1425 = phi_2804_;
                                                                    phi_2805_ = _e1425;
                                                                }
                                                                let _e1427 = phi_2805_;
                                                                phi_2806_ = _e1427;
                                                                phi_2807_ = _e1297;
                                                            }
                                                            let _e1429 = phi_2806_;
                                                            let _e1431 = phi_2807_;
                                                            phi_2811_ = _e1429;
                                                            phi_2812_ = _e1431;
                                                        }
                                                        let _e1433 = phi_2811_;
                                                        let _e1435 = phi_2812_;
                                                        phi_2816_ = _e1433;
                                                        phi_2817_ = _e1435;
                                                    } else {
                                                        phi_2816_ = type_25();
                                                        phi_2817_ = true;
                                                    }
                                                    let _e1437 = phi_2816_;
                                                    let _e1439 = phi_2817_;
                                                    if _e1439 {
                                                        phi_2821_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2821_ = _e1437;
                                                    }
                                                    let _e1441 = phi_2821_;
                                                    if (_e1441.member_3 != 4294967295u) {
                                                        if (_e1092 == _e157) {
                                                            phi_3150_ = false;
                                                        } else {
                                                            let _e1445 = (_e1092 < arrayLength((&global_6.member)));
                                                            if _e1445 {
                                                                if _e1445 {
                                                                } else {
                                                                    phi_4704_ = true;
                                                                    break;
                                                                }
                                                                let _e1447 = global_6.member[_e1092];
                                                                phi_2844_ = _e1447;
                                                            } else {
                                                                phi_2844_ = 4294967295u;
                                                            }
                                                            let _e1449 = phi_2844_;
                                                            let _e1450 = (_e1449 < arrayLength((&global_7.member)));
                                                            if _e1450 {
                                                                if _e1450 {
                                                                } else {
                                                                    phi_4704_ = true;
                                                                    break;
                                                                }
                                                                let _e1452 = global_7.member[_e1449];
                                                                phi_2858_ = _e1452;
                                                            } else {
                                                                phi_2858_ = 0i;
                                                            }
                                                            let _e1454 = phi_2858_;
                                                            let _e1455 = (_e1454 == 0i);
                                                            if _e1455 {
                                                                phi_3149_ = true;
                                                            } else {
                                                                if _e386 {
                                                                    phi_2879_ = vec3<f32>(_e1159[0][0], _e1159[0][1], _e1159[0][2]);
                                                                } else {
                                                                    if (_e362 == 1u) {
                                                                        phi_2878_ = vec3<f32>(_e1159[0][2], _e1159[0][0], _e1159[0][1]);
                                                                    } else {
                                                                        phi_2878_ = vec3<f32>(_e1159[0][1], _e1159[0][2], _e1159[0][0]);
                                                                    }
                                                                    let _e1460 = phi_2878_;
                                                                    phi_2879_ = _e1460;
                                                                }
                                                                let _e1463 = phi_2879_;
                                                                if _e386 {
                                                                    phi_2896_ = vec3<f32>(_e1159[1][0], _e1159[1][1], _e1159[1][2]);
                                                                } else {
                                                                    if (_e362 == 1u) {
                                                                        phi_2895_ = vec3<f32>(_e1159[1][2], _e1159[1][0], _e1159[1][1]);
                                                                    } else {
                                                                        phi_2895_ = vec3<f32>(_e1159[1][1], _e1159[1][2], _e1159[1][0]);
                                                                    }
                                                                    let _e1468 = phi_2895_;
                                                                    phi_2896_ = _e1468;
                                                                }
                                                                let _e1471 = phi_2896_;
                                                                if _e386 {
                                                                    phi_2913_ = vec3<f32>(_e1159[2][0], _e1159[2][1], _e1159[2][2]);
                                                                } else {
                                                                    if (_e362 == 1u) {
                                                                        phi_2912_ = vec3<f32>(_e1159[2][2], _e1159[2][0], _e1159[2][1]);
                                                                    } else {
                                                                        phi_2912_ = vec3<f32>(_e1159[2][1], _e1159[2][2], _e1159[2][0]);
                                                                    }
                                                                    let _e1476 = phi_2912_;
                                                                    phi_2913_ = _e1476;
                                                                }
                                                                let _e1479 = phi_2913_;
                                                                let _e1482 = (_e1471.x - _e1463.x);
                                                                let _e1485 = (_e1471.y - _e1463.y);
                                                                let _e1488 = (_e1471.z - _e1463.z);
                                                                let _e1490 = (_e1479.x - _e1463.x);
                                                                let _e1492 = (_e1479.y - _e1463.y);
                                                                let _e1494 = (_e1479.z - _e1463.z);
                                                                if (_e229.member_1 == 1u) {
                                                                    phi_2949_ = (vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]) - _e1463);
                                                                } else {
                                                                    phi_2949_ = vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]);
                                                                }
                                                                let _e1509 = phi_2949_;
                                                                let _e1515 = bitcast<f32>((bitcast<u32>((_e1482 * _e1492)) ^ _e229.member_3[0]));
                                                                let _e1519 = bitcast<f32>((bitcast<u32>((_e1485 * _e1490)) ^ _e229.member_3[0]));
                                                                let _e1523 = bitcast<f32>((bitcast<u32>((_e1485 * _e1494)) ^ _e229.member_3[0]));
                                                                let _e1527 = bitcast<f32>((bitcast<u32>((_e1488 * _e1492)) ^ _e229.member_3[0]));
                                                                let _e1531 = bitcast<f32>((bitcast<u32>((_e1488 * _e1490)) ^ _e229.member_3[0]));
                                                                let _e1535 = bitcast<f32>((bitcast<u32>((_e1482 * _e1494)) ^ _e229.member_3[0]));
                                                                let _e1536 = (_e1523 - _e1527);
                                                                let _e1537 = (_e1531 - _e1535);
                                                                let _e1538 = (_e1515 - _e1519);
                                                                let _e1562 = (bitcast<f32>((bitcast<u32>(_e1523) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1527) & 2147483647u)));
                                                                let _e1569 = (bitcast<f32>((bitcast<u32>(_e1531) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1535) & 2147483647u)));
                                                                let _e1576 = (bitcast<f32>((bitcast<u32>(_e1515) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1519) & 2147483647u)));
                                                                if (_e229.member_2 == 0f) {
                                                                    phi_3131_ = 0f;
                                                                } else {
                                                                    let _e1606 = bitcast<f32>((bitcast<u32>(_e1536) & 2147483647u));
                                                                    let _e1609 = bitcast<f32>((bitcast<u32>(_e1537) & 2147483647u));
                                                                    let _e1612 = bitcast<f32>((bitcast<u32>(_e1538) & 2147483647u));
                                                                    let _e1614 = select(_e1612, _e1609, (_e1609 > _e1612));
                                                                    let _e1618 = select(_e1612, _e1609, (_e1609 < _e1612));
                                                                    let _e1622 = select(_e1609, _e1606, (_e1606 < _e1609));
                                                                    let _e1624 = select(_e1609, _e1606, (_e1606 > _e1609));
                                                                    let _e1626 = select(_e1612, _e1624, (_e1624 < _e1612));
                                                                    phi_3131_ = bitcast<f32>((bitcast<u32>((_e229.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1614, _e1606, (_e1606 > _e1614)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1626, _e1622, (_e1622 > _e1626)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1618, _e1606, (_e1606 < _e1618)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1562 + _e1569) + _e1576))) ^ _e229.member_3[0]))) * 1.0000005f)) ^ _e229.member_3[0])))) ^ _e229.member_3[0]));
                                                                }
                                                                let _e1653 = phi_3131_;
                                                                phi_3149_ = (_e1455 || !(((((bitcast<f32>((bitcast<u32>((_e1509.x * _e1536)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1509.y * _e1537)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1509.z * _e1538)) ^ _e229.member_3[0]))) * f32(-(_e1454))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1509.x) & 2147483647u)) * _e1562)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1509.y) & 2147483647u)) * _e1569)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1509.z) & 2147483647u)) * _e1576)) ^ _e229.member_3[0]))))) ^ _e229.member_3[0])) + _e1653) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1667 = phi_3149_;
                                                            phi_3150_ = _e1667;
                                                        }
                                                        let _e1669 = phi_3150_;
                                                        if _e1669 {
                                                            phi_3155_ = type_45(_e1063.member, true);
                                                        } else {
                                                            phi_3155_ = _e1063;
                                                        }
                                                        let _e1674 = phi_3155_;
                                                        phi_3156_ = _e1674;
                                                    } else {
                                                        phi_3156_ = _e1063;
                                                    }
                                                    let _e1676 = phi_3156_;
                                                    phi_2110_ = _e1676;
                                                } else {
                                                    phi_2110_ = type_45();
                                                }
                                                let _e1678 = phi_2110_;
                                                continue;
                                                continuing {
                                                    phi_2109_ = _e1678;
                                                    phi_2112_ = _e1078;
                                                    phi_4704_ = _e582;
                                                    break if !(_e1084);
                                                }
                                            }
                                            let _e1681 = phi_4704_;
                                            phi_4842_ = _e1681;
                                            if _e1681 {
                                                break;
                                            }
                                            let _e1683 = local_4;
                                            phi_4846_ = _e1681;
                                            let _e1870 = local_6;
                                            phi_4460_ = _e1870;
                                            phi_4461_ = _e613;
                                            phi_4462_ = false;
                                            phi_4463_ = select(_e617, 0u, _e1683.member_1);
                                        } else {
                                            if (_e613.member_1 >= _e90) {
                                                phi_4060_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_61(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e613.member_1 < _e90) {
                                                } else {
                                                    phi_4842_ = true;
                                                    break;
                                                }
                                                let _e630 = ((1u + (_e362 * 2u)) % 7u);
                                                if (_e630 < 7u) {
                                                } else {
                                                    phi_4842_ = true;
                                                    break;
                                                }
                                                let _e635 = global_9.member[_e613.member_1][_e630];
                                                let _e638 = ((1u + (_e361 * 2u)) % 7u);
                                                if (_e638 < 7u) {
                                                } else {
                                                    phi_4842_ = true;
                                                    break;
                                                }
                                                let _e643 = global_9.member[_e613.member_1][_e638];
                                                let _e646 = ((1u + (_e363 * 2u)) % 7u);
                                                if (_e646 < 7u) {
                                                } else {
                                                    phi_4842_ = true;
                                                    break;
                                                }
                                                let _e651 = global_9.member[_e613.member_1][_e646];
                                                let _e654 = (((_e362 + 1u) * 2u) % 7u);
                                                if (_e654 < 7u) {
                                                } else {
                                                    phi_4842_ = true;
                                                    break;
                                                }
                                                let _e659 = global_9.member[_e613.member_1][_e654];
                                                let _e662 = (((_e361 + 1u) * 2u) % 7u);
                                                if (_e662 < 7u) {
                                                } else {
                                                    phi_4842_ = true;
                                                    break;
                                                }
                                                let _e667 = global_9.member[_e613.member_1][_e662];
                                                let _e670 = (((_e363 + 1u) * 2u) % 7u);
                                                if (_e670 < 7u) {
                                                } else {
                                                    phi_4842_ = true;
                                                    break;
                                                }
                                                let _e675 = global_9.member[_e613.member_1][_e670];
                                                let _e698 = (bitcast<f32>((bitcast<u32>((_e613.member.member_1.x - _e613.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e699 = (bitcast<f32>((bitcast<u32>((_e613.member.member_1.y - _e613.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e700 = (bitcast<f32>((bitcast<u32>((_e613.member.member_1.z - _e613.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e702 = select(_e148, _e698, (_e698 > _e148));
                                                let _e704 = select(_e148, _e699, (_e699 > _e148));
                                                let _e706 = select(_e148, _e700, (_e700 > _e148));
                                                let _e731 = bitcast<u32>((f32(bitcast<i32>((_e635 & 2097151u))) * _e702));
                                                let _e736 = (bitcast<i32>((_e635 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e739 = bitcast<f32>((_e731 & bitcast<u32>(_e736)));
                                                let _e740 = bitcast<u32>((f32(bitcast<i32>((_e643 & 2097151u))) * _e704));
                                                let _e745 = (bitcast<i32>((_e643 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e748 = bitcast<f32>((_e740 & bitcast<u32>(_e745)));
                                                let _e749 = bitcast<u32>((f32(bitcast<i32>((_e651 & 2097151u))) * _e706));
                                                let _e754 = (bitcast<i32>((_e651 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e757 = bitcast<f32>((_e749 & bitcast<u32>(_e754)));
                                                let _e761 = bitcast<f32>((_e731 & bitcast<u32>(~(_e736))));
                                                let _e765 = bitcast<f32>((_e740 & bitcast<u32>(~(_e745))));
                                                let _e769 = bitcast<f32>((_e749 & bitcast<u32>(~(_e754))));
                                                let _e770 = bitcast<u32>((f32(bitcast<i32>((_e659 & 2097151u))) * _e702));
                                                let _e775 = (bitcast<i32>((_e659 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e778 = bitcast<f32>((_e770 & bitcast<u32>(_e775)));
                                                let _e779 = bitcast<u32>((f32(bitcast<i32>((_e667 & 2097151u))) * _e704));
                                                let _e784 = (bitcast<i32>((_e667 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e787 = bitcast<f32>((_e779 & bitcast<u32>(_e784)));
                                                let _e788 = bitcast<u32>((f32(bitcast<i32>((_e675 & 2097151u))) * _e706));
                                                let _e793 = (bitcast<i32>((_e675 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e796 = bitcast<f32>((_e788 & bitcast<u32>(_e793)));
                                                let _e800 = bitcast<f32>((_e770 & bitcast<u32>(~(_e775))));
                                                let _e804 = bitcast<f32>((_e779 & bitcast<u32>(~(_e784))));
                                                let _e808 = bitcast<f32>((_e788 & bitcast<u32>(~(_e793))));
                                                let _e838 = global_9.member[_e613.member_1][0u];
                                                let _e842 = global_9.member[_e613.member_1][2u];
                                                let _e846 = global_9.member[_e613.member_1][4u];
                                                let _e850 = global_9.member[_e613.member_1][6u];
                                                let _e862 = (((_e842 >> bitcast<u32>(22i)) | ((_e846 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e850 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e863 = (_e838 & 268435455u);
                                                let _e864 = (_e862 & 268435455u);
                                                let _e867 = ((_e838 >> bitcast<u32>(28u)) & 7u);
                                                let _e875 = ((_e838 >> bitcast<u32>(31i)) | (((_e862 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e876 = (_e867 != 0u);
                                                if (_e867 == 0u) {
                                                    phi_4022_ = _e863;
                                                } else {
                                                    if (_e867 == 7u) {
                                                        phi_4021_ = 2147483648u;
                                                    } else {
                                                        phi_4021_ = ((2147483648u | (_e867 << bitcast<u32>(28u))) | (_e864 & 268435455u));
                                                    }
                                                    let _e885 = phi_4021_;
                                                    phi_4022_ = _e885;
                                                }
                                                let _e887 = phi_4022_;
                                                if _e876 {
                                                    let _e888 = (_e867 != 7u);
                                                    if _e888 {
                                                        phi_4032_ = (_e864 + _e867);
                                                    } else {
                                                        phi_4032_ = u32();
                                                    }
                                                    let _e891 = phi_4032_;
                                                    phi_4034_ = _e891;
                                                    phi_4035_ = select(true, false, _e888);
                                                } else {
                                                    phi_4034_ = u32();
                                                    phi_4035_ = true;
                                                }
                                                let _e894 = phi_4034_;
                                                let _e896 = phi_4035_;
                                                if (_e875 == 0u) {
                                                    phi_4056_ = (_e863 + select(0u, 1u, !(_e876)));
                                                } else {
                                                    if (_e875 == 7u) {
                                                        phi_4055_ = 2147483648u;
                                                    } else {
                                                        phi_4055_ = ((2147483648u | (_e875 << bitcast<u32>(28u))) | (select(_e894, _e864, _e896) & 268435455u));
                                                    }
                                                    let _e909 = phi_4055_;
                                                    phi_4056_ = _e909;
                                                }
                                                let _e911 = phi_4056_;
                                                phi_4060_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e613.member.member.x + _e739), (_e613.member.member.x + _e761), (_e613.member.member_1.x - _e778), (_e613.member.member_1.x - _e800)), vec4<f32>((_e613.member.member.y + _e748), (_e613.member.member.y + _e765), (_e613.member.member_1.y - _e787), (_e613.member.member_1.y - _e804)), vec4<f32>((_e613.member.member.z + _e757), (_e613.member.member.z + _e769), (_e613.member.member_1.z - _e796), (_e613.member.member_1.z - _e808))), type_61(type_34((_e613.member.member + vec4<f32>(_e739, _e748, _e757, 0f)), (_e613.member.member_1 - vec4<f32>(_e778, _e787, _e796, 0f))), _e887), type_61(type_34((_e613.member.member + vec4<f32>(_e761, _e765, _e769, 0f)), (_e613.member.member_1 - vec4<f32>(_e800, _e804, _e808, 0f))), _e911));
                                            }
                                            let _e916 = phi_4060_;
                                            let _e928 = ((_e916.member[0].x - _e417) * _e422);
                                            let _e929 = ((_e916.member[0].y - _e417) * _e422);
                                            let _e930 = ((_e916.member[0].z - _e418) * _e422);
                                            let _e931 = ((_e916.member[0].w - _e418) * _e422);
                                            let _e941 = ((_e916.member[1].x - _e453) * _e458);
                                            let _e942 = ((_e916.member[1].y - _e453) * _e458);
                                            let _e943 = ((_e916.member[1].z - _e454) * _e458);
                                            let _e944 = ((_e916.member[1].w - _e454) * _e458);
                                            let _e954 = ((_e916.member[2].x - _e489) * _e494);
                                            let _e955 = ((_e916.member[2].y - _e489) * _e494);
                                            let _e956 = ((_e916.member[2].z - _e490) * _e494);
                                            let _e957 = ((_e916.member[2].w - _e490) * _e494);
                                            let _e959 = select(_e956, _e954, (_e954 < _e956));
                                            let _e961 = select(_e957, _e955, (_e955 < _e957));
                                            let _e963 = select(_e956, _e954, (_e954 > _e956));
                                            let _e965 = select(_e957, _e955, (_e955 > _e957));
                                            let _e967 = select(_e930, _e928, (_e928 < _e930));
                                            let _e969 = select(_e931, _e929, (_e929 < _e931));
                                            let _e971 = select(_e943, _e941, (_e941 < _e943));
                                            let _e973 = select(_e944, _e942, (_e942 < _e944));
                                            let _e975 = select(_e971, _e967, (_e967 > _e971));
                                            let _e977 = select(_e973, _e969, (_e969 > _e973));
                                            let _e979 = select(_e959, _e975, (_e975 > _e959));
                                            let _e981 = select(_e961, _e977, (_e977 > _e961));
                                            let _e983 = select(_e930, _e928, (_e928 > _e930));
                                            let _e985 = select(_e931, _e929, (_e929 > _e931));
                                            let _e987 = select(_e943, _e941, (_e941 > _e943));
                                            let _e989 = select(_e944, _e942, (_e942 > _e944));
                                            let _e991 = select(_e987, _e983, (_e983 < _e987));
                                            let _e993 = select(_e989, _e985, (_e985 < _e989));
                                            let _e998 = -(_e959);
                                            let _e999 = -(_e961);
                                            let _e1006 = (select(_e963, _e991, (_e991 < _e963)) + (select(_e998, _e963, (_e963 > _e998)) * 0.0000019073523f));
                                            let _e1007 = (select(_e965, _e993, (_e993 < _e965)) + (select(_e999, _e965, (_e965 > _e999)) * 0.0000019073523f));
                                            let _e1009 = select(_e540, _e979, (_e979 > _e540));
                                            let _e1011 = select(_e540, _e981, (_e981 > _e540));
                                            let _e1016 = (_e1009 <= select(_e584.member, _e1006, (_e1006 < _e584.member)));
                                            let _e1017 = (_e1011 <= select(_e584.member, _e1007, (_e1007 < _e584.member)));
                                            let _e1018 = (_e1009 <= _e1011);
                                            if _e1016 {
                                                if _e1017 {
                                                    if _e1018 {
                                                        phi_4404_ = _e916.member_2;
                                                    } else {
                                                        phi_4404_ = _e916.member_1;
                                                    }
                                                    let _e1022 = phi_4404_;
                                                    let _e1023 = (_e617 % 128u);
                                                    let _e1024 = (_e1023 < 128u);
                                                    if _e1024 {
                                                    } else {
                                                        phi_4842_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1023] = type_61(type_34(_e1022.member.member, _e1022.member.member_1), _e1022.member_1);
                                                    if _e1024 {
                                                    } else {
                                                        phi_4842_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1023] = select(_e1011, _e1009, (_e1009 > _e1011));
                                                    if _e1018 {
                                                        phi_4437_ = _e916.member_1;
                                                    } else {
                                                        phi_4437_ = _e916.member_2;
                                                    }
                                                    let _e1039 = phi_4437_;
                                                    phi_4438_ = _e1039;
                                                    phi_4439_ = (_e617 + 1u);
                                                } else {
                                                    phi_4438_ = type_61();
                                                    phi_4439_ = u32();
                                                }
                                                let _e1041 = phi_4438_;
                                                let _e1043 = phi_4439_;
                                                phi_4441_ = _e1041;
                                                phi_4442_ = _e1043;
                                                phi_4443_ = select(true, false, _e1017);
                                            } else {
                                                phi_4441_ = type_61();
                                                phi_4442_ = u32();
                                                phi_4443_ = true;
                                            }
                                            let _e1046 = phi_4441_;
                                            let _e1048 = phi_4442_;
                                            let _e1050 = phi_4443_;
                                            if _e1050 {
                                                if _e1016 {
                                                    phi_4452_ = _e916.member_1;
                                                } else {
                                                    phi_4452_ = _e916.member_2;
                                                }
                                                let _e1054 = phi_4452_;
                                                phi_4457_ = _e1054;
                                                phi_4458_ = select(_e1017, true, _e1016);
                                            } else {
                                                phi_4457_ = _e1046;
                                                phi_4458_ = _e615;
                                            }
                                            let _e1057 = phi_4457_;
                                            let _e1059 = phi_4458_;
                                            phi_4846_ = _e582;
                                            phi_4460_ = _e584;
                                            phi_4461_ = _e1057;
                                            phi_4462_ = _e1059;
                                            phi_4463_ = select(_e1048, _e617, _e1050);
                                        }
                                        let _e1687 = phi_4846_;
                                        let _e1689 = phi_4460_;
                                        let _e1691 = phi_4461_;
                                        let _e1693 = phi_4462_;
                                        let _e1695 = phi_4463_;
                                        phi_4845_ = _e1687;
                                        phi_4464_ = _e1689;
                                        phi_4465_ = _e1691;
                                        phi_4466_ = (_e588 - 1u);
                                        phi_4467_ = _e1693;
                                        phi_4468_ = _e1695;
                                    } else {
                                        phi_4845_ = _e582;
                                        phi_4464_ = _e584;
                                        phi_4465_ = _e613;
                                        phi_4466_ = _e588;
                                        phi_4467_ = _e615;
                                        phi_4468_ = _e617;
                                    }
                                    let _e1697 = phi_4845_;
                                    let _e1699 = phi_4464_;
                                    let _e1701 = phi_4465_;
                                    let _e1703 = phi_4466_;
                                    let _e1705 = phi_4467_;
                                    let _e1707 = phi_4468_;
                                    phi_4844_ = _e1697;
                                    phi_4469_ = _e1699;
                                    phi_4470_ = _e1701;
                                    phi_4471_ = _e1703;
                                    phi_4472_ = _e1705;
                                    phi_4473_ = _e1707;
                                } else {
                                    phi_4844_ = _e582;
                                    phi_4469_ = type_45();
                                    phi_4470_ = type_61();
                                    phi_4471_ = u32();
                                    phi_4472_ = bool();
                                    phi_4473_ = u32();
                                }
                                let _e1709 = phi_4844_;
                                let _e1711 = phi_4469_;
                                let _e1713 = phi_4470_;
                                let _e1715 = phi_4471_;
                                let _e1717 = phi_4472_;
                                let _e1719 = phi_4473_;
                                phi_4843_ = _e1709;
                                phi_2033_ = _e1711;
                                phi_2036_ = _e1713;
                                phi_2038_ = _e1715;
                                phi_2040_ = _e1717;
                                phi_2042_ = _e1719;
                                phi_4474_ = _e596;
                            } else {
                                phi_4843_ = _e582;
                                phi_2033_ = type_45();
                                phi_2036_ = type_61();
                                phi_2038_ = u32();
                                phi_2040_ = bool();
                                phi_2042_ = u32();
                                phi_4474_ = false;
                            }
                            let _e1721 = phi_4843_;
                            let _e1723 = phi_2033_;
                            let _e1725 = phi_2036_;
                            let _e1727 = phi_2038_;
                            let _e1729 = phi_2040_;
                            let _e1731 = phi_2042_;
                            let _e1733 = phi_4474_;
                            continue;
                            continuing {
                                phi_4710_ = _e1721;
                                phi_2032_ = _e1723;
                                phi_2035_ = _e1725;
                                phi_2037_ = _e1727;
                                phi_2039_ = _e1729;
                                phi_2041_ = _e1731;
                                phi_4842_ = _e1721;
                                break if !(_e1733);
                            }
                        }
                        let _e1736 = phi_4842_;
                        if _e1736 {
                            break;
                        }
                        let _e1738 = local_5;
                        if _e1738.member_1 {
                        } else {
                            if _e230 {
                            } else {
                                break;
                            }
                            let _e1742 = global_2.member[_e136];
                            if _e151 {
                            } else {
                                break;
                            }
                            let _e1746 = global_10.member[_e136].member_1;
                            if _e230 {
                            } else {
                                break;
                            }
                            global_2.member[_e136] = type_27(_e1742.member, _e1742.member_1, _e1742.member_2, array<f32, 3>((_e1742.member_3[0] + (_e1746[0] * _e1742.member_1[0])), (_e1742.member_3[1] + (_e1746[1] * _e1742.member_1[1])), (_e1742.member_3[2] + (_e1746[2] * _e1742.member_1[2]))), _e1742.member_4);
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
