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
    var phi_288_: u32;
    var phi_332_: i32;
    var phi_356_: type_36;
    var phi_506_: i32;
    var phi_507_: i32;
    var phi_517_: bool;
    var phi_527_: u32;
    var phi_528_: u32;
    var phi_530_: bool;
    var phi_535_: u32;
    var phi_568_: i32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_632_: f32;
    var phi_643_: f32;
    var phi_652_: f32;
    var phi_658_: f32;
    var phi_669_: f32;
    var phi_675_: f32;
    var phi_698_: f32;
    var phi_709_: f32;
    var phi_718_: f32;
    var phi_724_: f32;
    var phi_735_: f32;
    var phi_741_: f32;
    var phi_764_: f32;
    var phi_775_: f32;
    var phi_875_: f32;
    var phi_876_: f32;
    var phi_5242_: bool;
    var phi_3004_: type_39;
    var phi_3007_: type_62;
    var phi_3009_: u32;
    var phi_3011_: bool;
    var phi_3013_: u32;
    var phi_3024_: bool;
    var phi_3069_: type_62;
    var phi_3070_: bool;
    var phi_3071_: u32;
    var phi_4289_: type_48;
    var phi_4298_: type_8;
    var phi_4299_: type_8;
    var phi_4322_: type_8;
    var phi_5235_: bool;
    var phi_4452_: type_8;
    var phi_4453_: type_8;
    var phi_4476_: type_8;
    var phi_5302_: bool;
    var phi_5039_: type_62;
    var phi_5078_: type_62;
    var phi_5079_: type_62;
    var phi_5080_: u32;
    var phi_5082_: type_62;
    var phi_5083_: u32;
    var phi_5084_: bool;
    var phi_5091_: type_62;
    var phi_5096_: type_62;
    var phi_5097_: bool;
    var phi_5319_: bool;
    var phi_3090_: type_39;
    var phi_3093_: type_8;
    var phi_3094_: type_8;
    var phi_3116_: type_8;
    var phi_3158_: u32;
    var phi_3182_: type_56;
    var phi_5315_: bool;
    var phi_3193_: type_8;
    var phi_3194_: type_8;
    var phi_3217_: type_8;
    var phi_3227_: type_8;
    var phi_3228_: type_8;
    var phi_3251_: type_8;
    var phi_5310_: bool;
    var phi_5323_: bool;
    var phi_5322_: bool;
    var phi_3814_: vec3<f32>;
    var phi_3815_: vec3<f32>;
    var phi_3846_: bool;
    var phi_3855_: vec3<f32>;
    var phi_3895_: type_22;
    var phi_3897_: type_22;
    var phi_3898_: bool;
    var phi_3902_: type_22;
    var phi_3903_: type_22;
    var phi_3904_: type_22;
    var phi_3905_: bool;
    var phi_3909_: type_22;
    var phi_3910_: bool;
    var phi_3914_: type_22;
    var phi_3915_: bool;
    var phi_3919_: type_22;
    var phi_3942_: u32;
    var phi_3956_: i32;
    var phi_3976_: vec3<f32>;
    var phi_3977_: vec3<f32>;
    var phi_3993_: vec3<f32>;
    var phi_3994_: vec3<f32>;
    var phi_4010_: vec3<f32>;
    var phi_4011_: vec3<f32>;
    var phi_4047_: vec3<f32>;
    var phi_4229_: f32;
    var phi_4247_: bool;
    var phi_4248_: bool;
    var phi_4253_: type_39;
    var phi_4254_: type_39;
    var phi_5325_: bool;
    var phi_3091_: type_39;
    var phi_5324_: bool;
    var local_17: type_39;
    var phi_5404_: bool;
    var phi_5099_: type_39;
    var phi_5100_: type_62;
    var phi_5101_: bool;
    var phi_5102_: u32;
    var phi_5403_: bool;
    var phi_5103_: type_39;
    var phi_5104_: type_62;
    var phi_5105_: u32;
    var phi_5106_: bool;
    var phi_5107_: u32;
    var phi_5402_: bool;
    var phi_5108_: type_39;
    var phi_5109_: type_62;
    var phi_5110_: u32;
    var phi_5111_: bool;
    var phi_5112_: u32;
    var phi_5401_: bool;
    var phi_3005_: type_39;
    var phi_3008_: type_62;
    var phi_3010_: u32;
    var phi_3012_: bool;
    var phi_3014_: u32;
    var phi_5113_: bool;
    var phi_5400_: bool;
    var local_18: type_39;
    var local_19: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e97 = arrayLength((&global_9.member));
            let _e112 = arrayLength((&global_7.member));
            let _e116 = global_4.member[0u][0u];
            let _e120 = global_4.member[0u][1u];
            let _e124 = global_4.member[0u][2u];
            let _e128 = global_4.member[1u][0u];
            let _e132 = global_4.member[1u][1u];
            let _e136 = global_4.member[1u][2u];
            let _e140 = global_4.member[1u][3u];
            let _e144 = (_e94.x + (_e94.y * 2097152u));
            let _e151 = (_e144 < arrayLength((&global_8.member)));
            if _e151 {
                if _e151 {
                } else {
                    break;
                }
                let _e155 = global_8.member[_e144].member_2;
                phi_288_ = _e155;
            } else {
                phi_288_ = 4294967295u;
            }
            let _e157 = phi_288_;
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
                phi_332_ = -126i;
            } else {
                phi_332_ = select(_e200, 127i, (_e200 > 127i));
            }
            let _e205 = phi_332_;
            let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
            let _e216 = bitcast<f32>((bitcast<u32>(((_e200 - _e205) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_356_ = type_36(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                phi_356_ = type_36(array<f32, 3>(((_e193 * _e210) * _e216), ((_e194 * _e210) * _e216), ((_e195 * _e210) * _e216)), _e176, ((_e197 * _e210) * _e216), _e198);
            }
            let _e229 = phi_356_;
            if _e151 {
                let _e230 = (_e144 < arrayLength((&global_2.member)));
                if _e230 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e235 = global_8.member[_e144].member.member_1;
                    let _e240 = global_8.member[_e144].member.member_3;
                    if (_e235 <= _e240) {
                        let _e242 = (1u < _e112);
                        if _e242 {
                            if (0u < _e112) {
                            } else {
                                break;
                            }
                            let _e246 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e246 + 1u) < _e246) {
                                if _e242 {
                                } else {
                                    break;
                                }
                                let _e251 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e261 = global_8.member[_e144].member.member_2[0u];
                        let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                        let _e269 = global_8.member[_e144].member.member_2[1u];
                        let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                        let _e277 = global_8.member[_e144].member.member_2[2u];
                        let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                        let _e285 = global_8.member[_e144].member.member[0u];
                        let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                        let _e293 = global_8.member[_e144].member.member[1u];
                        let _e295 = (bitcast<u32>(_e293) & 2147483647u);
                        let _e301 = global_8.member[_e144].member.member[2u];
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
                                phi_506_ = (bitcast<i32>((_e327 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_506_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e327)), 32u, (_e327 == 0u))));
                            }
                            let _e341 = phi_506_;
                            phi_507_ = _e341;
                        } else {
                            phi_507_ = 0i;
                        }
                        let _e343 = phi_507_;
                        let _e344 = (_e263 == _e307);
                        if _e344 {
                            phi_517_ = true;
                        } else {
                            phi_517_ = (_e271 == _e307);
                        }
                        let _e347 = phi_517_;
                        let _e348 = select(1u, 0u, _e344);
                        if _e347 {
                            let _e349 = (_e348 + 1u);
                            phi_527_ = _e349;
                            phi_528_ = _e349;
                            phi_530_ = select(true, false, (_e349 == 2u));
                        } else {
                            phi_527_ = u32();
                            phi_528_ = 0u;
                            phi_530_ = true;
                        }
                        let _e353 = phi_527_;
                        let _e355 = phi_528_;
                        let _e357 = phi_530_;
                        if _e357 {
                            phi_535_ = (_e355 + 1u);
                        } else {
                            phi_535_ = 0u;
                        }
                        let _e361 = phi_535_;
                        let _e362 = select(_e353, _e355, _e357);
                        let _e363 = select(_e348, select(2u, _e348, _e347), _e357);
                        let _e364 = -(_e343);
                        if (_e364 < -126i) {
                            phi_568_ = -126i;
                        } else {
                            phi_568_ = select(_e364, 127i, (_e364 > 127i));
                        }
                        let _e369 = phi_568_;
                        let _e374 = bitcast<f32>((bitcast<u32>((_e369 + 127i)) << bitcast<u32>(23i)));
                        let _e380 = bitcast<f32>((bitcast<u32>(((_e364 - _e369) + 127i)) << bitcast<u32>(23i)));
                        let _e385 = global_8.member[_e144].member.member;
                        let _e386 = (_e362 == 0u);
                        if _e386 {
                            phi_586_ = _e385[0];
                        } else {
                            phi_586_ = _e385[1];
                        }
                        let _e390 = phi_586_;
                        let _e391 = (_e362 == 2u);
                        if _e391 {
                            phi_592_ = _e385[2];
                        } else {
                            phi_592_ = _e390;
                        }
                        let _e394 = phi_592_;
                        let _e395 = global_8.member[_e144].member.member_2;
                        if _e386 {
                            phi_603_ = _e395[0];
                        } else {
                            phi_603_ = _e395[1];
                        }
                        let _e399 = phi_603_;
                        if _e391 {
                            phi_609_ = _e395[2];
                        } else {
                            phi_609_ = _e399;
                        }
                        let _e402 = phi_609_;
                        let _e404 = ((_e402 * _e374) * _e380);
                        let _e408 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e408 {
                            let _e412 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) * 0.00000011920929f);
                            phi_632_ = select(0.00000000000011368684f, _e412, (_e412 > 0.00000000000011368684f));
                        } else {
                            phi_632_ = 0f;
                        }
                        let _e416 = phi_632_;
                        let _e417 = (_e394 + _e416);
                        let _e418 = (_e394 - _e416);
                        let _e419 = select(_e404, 0f, _e408);
                        if _e408 {
                            phi_643_ = 38685626000000000000000000f;
                        } else {
                            phi_643_ = (1f / _e404);
                        }
                        let _e422 = phi_643_;
                        let _e423 = (_e361 == 0u);
                        if _e423 {
                            phi_652_ = _e385[0];
                        } else {
                            phi_652_ = _e385[1];
                        }
                        let _e427 = phi_652_;
                        let _e428 = (_e361 == 2u);
                        if _e428 {
                            phi_658_ = _e385[2];
                        } else {
                            phi_658_ = _e427;
                        }
                        let _e431 = phi_658_;
                        if _e423 {
                            phi_669_ = _e395[0];
                        } else {
                            phi_669_ = _e395[1];
                        }
                        let _e435 = phi_669_;
                        if _e428 {
                            phi_675_ = _e395[2];
                        } else {
                            phi_675_ = _e435;
                        }
                        let _e438 = phi_675_;
                        let _e440 = ((_e438 * _e374) * _e380);
                        let _e444 = (bitcast<f32>((bitcast<u32>(_e440) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e444 {
                            let _e448 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) * 0.00000011920929f);
                            phi_698_ = select(0.00000000000011368684f, _e448, (_e448 > 0.00000000000011368684f));
                        } else {
                            phi_698_ = 0f;
                        }
                        let _e452 = phi_698_;
                        let _e453 = (_e431 + _e452);
                        let _e454 = (_e431 - _e452);
                        let _e455 = select(_e440, 0f, _e444);
                        if _e444 {
                            phi_709_ = 38685626000000000000000000f;
                        } else {
                            phi_709_ = (1f / _e440);
                        }
                        let _e458 = phi_709_;
                        let _e459 = (_e363 == 0u);
                        if _e459 {
                            phi_718_ = _e385[0];
                        } else {
                            phi_718_ = _e385[1];
                        }
                        let _e463 = phi_718_;
                        let _e464 = (_e363 == 2u);
                        if _e464 {
                            phi_724_ = _e385[2];
                        } else {
                            phi_724_ = _e463;
                        }
                        let _e467 = phi_724_;
                        if _e459 {
                            phi_735_ = _e395[0];
                        } else {
                            phi_735_ = _e395[1];
                        }
                        let _e471 = phi_735_;
                        if _e464 {
                            phi_741_ = _e395[2];
                        } else {
                            phi_741_ = _e471;
                        }
                        let _e474 = phi_741_;
                        let _e476 = ((_e474 * _e374) * _e380);
                        let _e480 = (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e480 {
                            let _e484 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) * 0.00000011920929f);
                            phi_764_ = select(0.00000000000011368684f, _e484, (_e484 > 0.00000000000011368684f));
                        } else {
                            phi_764_ = 0f;
                        }
                        let _e488 = phi_764_;
                        let _e489 = (_e467 + _e488);
                        let _e490 = (_e467 - _e488);
                        let _e491 = select(_e476, 0f, _e480);
                        if _e480 {
                            phi_775_ = 38685626000000000000000000f;
                        } else {
                            phi_775_ = (1f / _e476);
                        }
                        let _e494 = phi_775_;
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
                            phi_875_ = select(-340282350000000000000000000000000000000f, _e534, (_e534 > -340282350000000000000000000000000000000f));
                            phi_876_ = select(-340282350000000000000000000000000000000f, _e527, (_e527 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_875_ = 0f;
                            phi_876_ = 1f;
                        }
                        let _e538 = phi_875_;
                        let _e540 = phi_876_;
                        local_5 = array<type_62, 128>(type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_62(type_53(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_16 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                        let _e545 = (_e362 % 3u);
                        let _e546 = (_e545 < 3u);
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e548 = local_16[_e545];
                        let _e549 = (_e361 % 3u);
                        let _e550 = (_e549 < 3u);
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e552 = local_16[_e549];
                        let _e553 = (_e363 % 3u);
                        let _e554 = (_e553 < 3u);
                        if _e554 {
                        } else {
                            break;
                        }
                        let _e556 = local_16[_e553];
                        local_15 = array<f32, 3>(bitcast<f32>(_e128), bitcast<f32>(_e132), bitcast<f32>(_e136));
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e560 = local_15[_e545];
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e562 = local_15[_e549];
                        if _e554 {
                        } else {
                            break;
                        }
                        let _e564 = local_15[_e553];
                        phi_5242_ = false;
                        phi_3004_ = type_39(_e538, false);
                        phi_3007_ = type_62(type_53(array<f32, 3>(_e548, _e552, _e556), array<f32, 3>(_e560, _e562, _e564)), select(0u, 2147483648u, (_e97 == 0u)));
                        phi_3009_ = ((3u * _e97) + 1u);
                        phi_3011_ = (_e540 <= _e538);
                        phi_3013_ = 0u;
                        loop {
                            let _e572 = phi_5242_;
                            let _e574 = phi_3004_;
                            let _e576 = phi_3007_;
                            let _e578 = phi_3009_;
                            let _e580 = phi_3011_;
                            let _e582 = phi_3013_;
                            local_18 = _e574;
                            if _e580 {
                                phi_3024_ = true;
                            } else {
                                phi_3024_ = (_e582 > 0u);
                            }
                            let _e585 = phi_3024_;
                            if _e585 {
                                let _e586 = (_e578 > 0u);
                                if _e586 {
                                    if _e580 {
                                        phi_3069_ = _e576;
                                        phi_3070_ = _e580;
                                        phi_3071_ = _e582;
                                    } else {
                                        let _e587 = (_e582 - 1u);
                                        let _e588 = (_e587 % 128u);
                                        let _e589 = (_e588 < 128u);
                                        if _e589 {
                                        } else {
                                            phi_5400_ = true;
                                            break;
                                        }
                                        let _e591 = local_5[_e588];
                                        if _e589 {
                                        } else {
                                            phi_5400_ = true;
                                            break;
                                        }
                                        let _e607 = local_4[_e588];
                                        phi_3069_ = type_62(type_53(array<f32, 3>(_e591.member.member[0], _e591.member.member[1], _e591.member.member[2]), array<f32, 3>(_e591.member.member_1[0], _e591.member.member_1[1], _e591.member.member_1[2])), _e591.member_1);
                                        phi_3070_ = (_e607 <= _e574.member);
                                        phi_3071_ = _e587;
                                    }
                                    let _e611 = phi_3069_;
                                    let _e613 = phi_3070_;
                                    let _e615 = phi_3071_;
                                    if _e613 {
                                        if ((_e611.member_1 & 2147483648u) != 0u) {
                                            phi_5319_ = _e572;
                                            phi_3090_ = _e574;
                                            phi_3093_ = type_8(0u, ((_e611.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e937 = phi_5319_;
                                                let _e939 = phi_3090_;
                                                let _e941 = phi_3093_;
                                                local_17 = _e939;
                                                local_19 = _e939;
                                                if (_e941.member < _e941.member_1) {
                                                    phi_3094_ = type_8((_e941.member + 1u), _e941.member_1);
                                                    phi_3116_ = type_8(1u, _e941.member);
                                                } else {
                                                    phi_3094_ = _e941;
                                                    phi_3116_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e954 = phi_3094_;
                                                let _e956 = phi_3116_;
                                                let _e960 = (bitcast<i32>(_e956.member) != 0i);
                                                if _e960 {
                                                    local_1 = array<f32, 3>(_e611.member.member[0], _e611.member.member[1], _e611.member.member[2]);
                                                    local = array<f32, 3>(_e611.member.member_1[0], _e611.member.member_1[1], _e611.member.member_1[2]);
                                                    let _e971 = ((_e611.member_1 & 268435455u) + _e956.member_1);
                                                    let _e972 = (_e971 < arrayLength((&global_10.member)));
                                                    if _e972 {
                                                        if _e972 {
                                                        } else {
                                                            phi_5324_ = true;
                                                            break;
                                                        }
                                                        let _e975 = global_10.member[_e971].member_1;
                                                        phi_3158_ = _e975;
                                                    } else {
                                                        phi_3158_ = 4294967295u;
                                                    }
                                                    let _e977 = phi_3158_;
                                                    local_12 = array<u32, 3>(_e362, _e361, _e363);
                                                    if _e972 {
                                                        if _e972 {
                                                        } else {
                                                            phi_5324_ = true;
                                                            break;
                                                        }
                                                        let _e980 = global_10.member[_e971];
                                                        phi_3182_ = _e980;
                                                    } else {
                                                        phi_3182_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e982 = phi_3182_;
                                                    local_14 = array<u32, 3>(_e982.member[0], _e982.member[1], _e982.member[2]);
                                                    local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_5315_ = _e937;
                                                    phi_3193_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e992 = phi_5315_;
                                                        let _e994 = phi_3193_;
                                                        if (_e994.member < _e994.member_1) {
                                                            phi_3194_ = type_8((_e994.member + 1u), _e994.member_1);
                                                            phi_3217_ = type_8(1u, _e994.member);
                                                        } else {
                                                            phi_3194_ = _e994;
                                                            phi_3217_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1007 = phi_3194_;
                                                        let _e1009 = phi_3217_;
                                                        let _e1013 = (bitcast<i32>(_e1009.member) != 0i);
                                                        if _e1013 {
                                                            phi_3227_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1015 = phi_3227_;
                                                                if (_e1015.member < _e1015.member_1) {
                                                                    phi_3228_ = type_8((_e1015.member + 1u), _e1015.member_1);
                                                                    phi_3251_ = type_8(1u, _e1015.member);
                                                                } else {
                                                                    phi_3228_ = _e1015;
                                                                    phi_3251_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1028 = phi_3228_;
                                                                let _e1030 = phi_3251_;
                                                                let _e1034 = (bitcast<i32>(_e1030.member) != 0i);
                                                                if _e1034 {
                                                                    let _e1035 = (_e1009.member_1 < 3u);
                                                                    if _e1035 {
                                                                    } else {
                                                                        phi_5310_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1037 = local_14[_e1009.member_1];
                                                                    let _e1038 = (_e1030.member_1 < 3u);
                                                                    if _e1038 {
                                                                    } else {
                                                                        phi_5310_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1040 = local_12[_e1030.member_1];
                                                                    let _e1045 = ((_e1037 >> bitcast<u32>(((10u * _e1040) & 31u))) & 1023u);
                                                                    if _e1038 {
                                                                    } else {
                                                                        phi_5310_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1047 = local_1[_e1030.member_1];
                                                                    if _e1038 {
                                                                    } else {
                                                                        phi_5310_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1049 = local[_e1030.member_1];
                                                                    let _e1060 = (_e1047 + bitcast<f32>((bitcast<u32>((f32(_e1045) * bitcast<f32>((bitcast<u32>(((_e1049 - _e1047) * 0.0009775171f)) ^ _e140)))) ^ _e140)));
                                                                    if _e1035 {
                                                                    } else {
                                                                        phi_5310_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1038 {
                                                                    } else {
                                                                        phi_5310_ = true;
                                                                        break;
                                                                    }
                                                                    local_13[_e1009.member_1][_e1030.member_1] = select(select(_e1049, _e1060, (_e1060 < _e1049)), _e1049, (_e1045 == 1023u));
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_3227_ = _e1028;
                                                                    phi_5310_ = _e992;
                                                                    break if !(_e1034);
                                                                }
                                                            }
                                                            let _e1069 = phi_5310_;
                                                            phi_5322_ = _e1069;
                                                            if _e1069 {
                                                                break;
                                                            }
                                                            phi_5323_ = _e1069;
                                                        } else {
                                                            phi_5323_ = _e992;
                                                        }
                                                        let _e1071 = phi_5323_;
                                                        continue;
                                                        continuing {
                                                            phi_5315_ = _e1071;
                                                            phi_3193_ = _e1007;
                                                            phi_5322_ = _e1071;
                                                            break if !(_e1013);
                                                        }
                                                    }
                                                    let _e1074 = phi_5322_;
                                                    phi_5324_ = _e1074;
                                                    if _e1074 {
                                                        break;
                                                    }
                                                    let _e1075 = local_13;
                                                    let _e1091 = (_e1075[0][2] - _e467);
                                                    let _e1094 = (((_e1075[0][0] - _e394) * _e491) - (_e1091 * _e419));
                                                    let _e1097 = (((_e1075[0][1] - _e431) * _e491) - (_e1091 * _e455));
                                                    let _e1100 = (_e1075[1][2] - _e467);
                                                    let _e1103 = (((_e1075[1][0] - _e394) * _e491) - (_e1100 * _e419));
                                                    let _e1106 = (((_e1075[1][1] - _e431) * _e491) - (_e1100 * _e455));
                                                    let _e1109 = (_e1075[2][2] - _e467);
                                                    let _e1112 = (((_e1075[2][0] - _e394) * _e491) - (_e1109 * _e419));
                                                    let _e1115 = (((_e1075[2][1] - _e431) * _e491) - (_e1109 * _e455));
                                                    let _e1116 = (_e1112 * _e1106);
                                                    let _e1117 = (_e1115 * _e1103);
                                                    let _e1118 = (_e1094 * _e1115);
                                                    let _e1119 = (_e1097 * _e1112);
                                                    let _e1120 = (_e1103 * _e1097);
                                                    let _e1121 = (_e1106 * _e1094);
                                                    let _e1126 = (((_e1116 >= _e1117) && (_e1118 >= _e1119)) && (_e1120 >= _e1121));
                                                    if (_e1126 || (((_e1116 <= _e1117) && (_e1118 <= _e1119)) && (_e1120 <= _e1121))) {
                                                        let _e1133 = select(-1f, 1f, _e1126);
                                                        let _e1135 = ((_e1116 - _e1117) * _e1133);
                                                        let _e1137 = select(0f, _e1135, (_e1135 > 0f));
                                                        let _e1139 = ((_e1118 - _e1119) * _e1133);
                                                        let _e1141 = select(0f, _e1139, (_e1139 > 0f));
                                                        let _e1143 = ((_e1120 - _e1121) * _e1133);
                                                        let _e1145 = select(0f, _e1143, (_e1143 > 0f));
                                                        let _e1147 = ((_e1137 + _e1141) + _e1145);
                                                        if (_e1147 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3909_ = type_22();
                                                            phi_3910_ = true;
                                                        } else {
                                                            let _e1150 = select(_e1075[1][0], _e1075[0][0], (_e1075[0][0] < _e1075[1][0]));
                                                            let _e1154 = select(_e1075[1][0], _e1075[0][0], (_e1075[0][0] > _e1075[1][0]));
                                                            let _e1158 = select(_e1075[1][1], _e1075[0][1], (_e1075[0][1] < _e1075[1][1]));
                                                            let _e1162 = select(_e1075[1][1], _e1075[0][1], (_e1075[0][1] > _e1075[1][1]));
                                                            let _e1166 = select(_e1075[1][2], _e1075[0][2], (_e1075[0][2] < _e1075[1][2]));
                                                            let _e1170 = select(_e1075[1][2], _e1075[0][2], (_e1075[0][2] > _e1075[1][2]));
                                                            let _e1175 = ((select(_e1075[2][0], _e1150, (_e1150 < _e1075[2][0])) - _e417) * _e422);
                                                            let _e1176 = ((select(_e1075[2][0], _e1154, (_e1154 > _e1075[2][0])) - _e418) * _e422);
                                                            let _e1179 = ((select(_e1075[2][1], _e1158, (_e1158 < _e1075[2][1])) - _e453) * _e458);
                                                            let _e1180 = ((select(_e1075[2][1], _e1162, (_e1162 > _e1075[2][1])) - _e454) * _e458);
                                                            let _e1183 = ((select(_e1075[2][2], _e1166, (_e1166 < _e1075[2][2])) - _e489) * _e494);
                                                            let _e1184 = ((select(_e1075[2][2], _e1170, (_e1170 > _e1075[2][2])) - _e490) * _e494);
                                                            let _e1186 = select(_e1184, _e1183, (_e1183 < _e1184));
                                                            let _e1188 = select(_e1184, _e1183, (_e1183 > _e1184));
                                                            let _e1190 = select(_e1176, _e1175, (_e1175 < _e1176));
                                                            let _e1192 = select(_e1180, _e1179, (_e1179 < _e1180));
                                                            let _e1194 = select(_e1192, _e1190, (_e1190 > _e1192));
                                                            let _e1196 = select(_e1186, _e1194, (_e1194 > _e1186));
                                                            let _e1198 = select(_e1176, _e1175, (_e1175 > _e1176));
                                                            let _e1200 = select(_e1180, _e1179, (_e1179 > _e1180));
                                                            let _e1202 = select(_e1200, _e1198, (_e1198 < _e1200));
                                                            let _e1204 = select(_e1188, _e1202, (_e1202 < _e1188));
                                                            let _e1205 = -(_e1186);
                                                            let _e1211 = select(_e540, _e1196, (_e1196 > _e540));
                                                            if (_e1211 > (_e1204 + (select(_e1205, _e1188, (_e1188 > _e1205)) * 0.0000019073523f))) {
                                                                phi_3904_ = type_22();
                                                                phi_3905_ = true;
                                                            } else {
                                                                let _e1213 = (_e1211 > _e939.member);
                                                                if _e1213 {
                                                                    phi_3903_ = type_22();
                                                                } else {
                                                                    let _e1217 = (_e1075[1][0] - _e1075[0][0]);
                                                                    let _e1218 = (_e1075[1][1] - _e1075[0][1]);
                                                                    let _e1219 = (_e1075[1][2] - _e1075[0][2]);
                                                                    let _e1220 = vec3<f32>(_e1217, _e1218, _e1219);
                                                                    let _e1221 = (_e1075[2][0] - _e1075[1][0]);
                                                                    let _e1222 = (_e1075[2][1] - _e1075[1][1]);
                                                                    let _e1223 = (_e1075[2][2] - _e1075[1][2]);
                                                                    let _e1224 = vec3<f32>(_e1221, _e1222, _e1223);
                                                                    let _e1225 = (_e1075[0][0] - _e1075[2][0]);
                                                                    let _e1226 = (_e1075[0][1] - _e1075[2][1]);
                                                                    let _e1227 = (_e1075[0][2] - _e1075[2][2]);
                                                                    let _e1228 = vec3<f32>(_e1225, _e1226, _e1227);
                                                                    let _e1231 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                    let _e1234 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                    let _e1236 = select(_e1234, _e1231, (_e1231 > _e1234));
                                                                    let _e1239 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                    let _e1241 = select(_e1239, _e1236, (_e1236 > _e1239));
                                                                    let _e1244 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                    let _e1247 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                    let _e1249 = select(_e1247, _e1244, (_e1244 > _e1247));
                                                                    let _e1252 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                    let _e1254 = select(_e1252, _e1249, (_e1249 > _e1252));
                                                                    let _e1257 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                    let _e1260 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                    let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                                                                    let _e1265 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                    let _e1267 = select(_e1265, _e1262, (_e1262 > _e1265));
                                                                    let _e1269 = select(_e1254, _e1241, (_e1241 > _e1254));
                                                                    let _e1271 = select(_e1267, _e1269, (_e1269 > _e1267));
                                                                    if (_e1241 == _e1271) {
                                                                        phi_3814_ = _e1224;
                                                                        phi_3815_ = _e1228;
                                                                    } else {
                                                                        let _e1274 = vec3((_e1254 == _e1271));
                                                                        phi_3814_ = select(_e1220, _e1228, _e1274);
                                                                        phi_3815_ = select(_e1224, _e1220, _e1274);
                                                                    }
                                                                    let _e1278 = phi_3814_;
                                                                    let _e1280 = phi_3815_;
                                                                    let _e1287 = ((_e1278.y * _e1280.z) - (_e1280.y * _e1278.z));
                                                                    let _e1292 = ((_e1278.z * _e1280.x) - (_e1280.z * _e1278.x));
                                                                    let _e1295 = ((_e1278.x * _e1280.y) - (_e1280.x * _e1278.y));
                                                                    if (_e1137 >= _e1141) {
                                                                        phi_3846_ = select(true, false, (_e1137 >= _e1145));
                                                                    } else {
                                                                        phi_3846_ = true;
                                                                    }
                                                                    let _e1300 = phi_3846_;
                                                                    if _e1300 {
                                                                        phi_3855_ = select(vec3<f32>(_e1075[2][0], _e1075[2][1], _e1075[2][2]), vec3<f32>(_e1075[1][0], _e1075[1][1], _e1075[1][2]), vec3((_e1141 >= _e1145)));
                                                                    } else {
                                                                        phi_3855_ = vec3<f32>(_e1075[0][0], _e1075[0][1], _e1075[0][2]);
                                                                    }
                                                                    let _e1305 = phi_3855_;
                                                                    let _e1322 = ((((_e1287 * (_e1305.x - _e394)) + (_e1292 * (_e1305.y - _e431))) + (_e1295 * (_e1305.z - _e467))) / (((_e1287 * _e419) + (_e1292 * _e455)) + (_e1295 * _e491)));
                                                                    let _e1324 = select(_e1204, _e1322, (_e1322 < _e1204));
                                                                    let _e1326 = select(_e1196, _e1324, (_e1324 > _e1196));
                                                                    if (_e1326 >= _e540) {
                                                                        let _e1328 = (_e1326 <= _e939.member);
                                                                        if _e1328 {
                                                                            let _e1329 = (1f / _e1147);
                                                                            phi_3895_ = type_22(_e1326, (_e1141 * _e1329), (_e1145 * _e1329), _e977);
                                                                        } else {
                                                                            phi_3895_ = type_22();
                                                                        }
                                                                        let _e1334 = phi_3895_;
                                                                        phi_3897_ = _e1334;
                                                                        phi_3898_ = select(true, false, _e1328);
                                                                    } else {
                                                                        phi_3897_ = type_22();
                                                                        phi_3898_ = true;
                                                                    }
                                                                    let _e1337 = phi_3897_;
                                                                    let _e1339 = phi_3898_;
                                                                    if _e1339 {
                                                                        phi_3902_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3902_ = _e1337;
                                                                    }
                                                                    let _e1341 = phi_3902_;
                                                                    phi_3903_ = _e1341;
                                                                }
                                                                let _e1343 = phi_3903_;
                                                                phi_3904_ = _e1343;
                                                                phi_3905_ = _e1213;
                                                            }
                                                            let _e1345 = phi_3904_;
                                                            let _e1347 = phi_3905_;
                                                            phi_3909_ = _e1345;
                                                            phi_3910_ = _e1347;
                                                        }
                                                        let _e1349 = phi_3909_;
                                                        let _e1351 = phi_3910_;
                                                        phi_3914_ = _e1349;
                                                        phi_3915_ = _e1351;
                                                    } else {
                                                        phi_3914_ = type_22();
                                                        phi_3915_ = true;
                                                    }
                                                    let _e1353 = phi_3914_;
                                                    let _e1355 = phi_3915_;
                                                    if _e1355 {
                                                        phi_3919_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3919_ = _e1353;
                                                    }
                                                    let _e1357 = phi_3919_;
                                                    if (_e1357.member_3 != 4294967295u) {
                                                        if (_e977 == _e157) {
                                                            phi_4248_ = false;
                                                        } else {
                                                            let _e1361 = (_e977 < arrayLength((&global_5.member)));
                                                            if _e1361 {
                                                                if _e1361 {
                                                                } else {
                                                                    phi_5324_ = true;
                                                                    break;
                                                                }
                                                                let _e1363 = global_5.member[_e977];
                                                                phi_3942_ = _e1363;
                                                            } else {
                                                                phi_3942_ = 4294967295u;
                                                            }
                                                            let _e1365 = phi_3942_;
                                                            let _e1366 = (_e1365 < arrayLength((&global_6.member)));
                                                            if _e1366 {
                                                                if _e1366 {
                                                                } else {
                                                                    phi_5324_ = true;
                                                                    break;
                                                                }
                                                                let _e1368 = global_6.member[_e1365];
                                                                phi_3956_ = _e1368;
                                                            } else {
                                                                phi_3956_ = 0i;
                                                            }
                                                            let _e1370 = phi_3956_;
                                                            let _e1371 = (_e1370 == 0i);
                                                            if _e1371 {
                                                                phi_4247_ = true;
                                                            } else {
                                                                if _e386 {
                                                                    phi_3977_ = vec3<f32>(_e1075[0][0], _e1075[0][1], _e1075[0][2]);
                                                                } else {
                                                                    if (_e362 == 1u) {
                                                                        phi_3976_ = vec3<f32>(_e1075[0][2], _e1075[0][0], _e1075[0][1]);
                                                                    } else {
                                                                        phi_3976_ = vec3<f32>(_e1075[0][1], _e1075[0][2], _e1075[0][0]);
                                                                    }
                                                                    let _e1376 = phi_3976_;
                                                                    phi_3977_ = _e1376;
                                                                }
                                                                let _e1379 = phi_3977_;
                                                                if _e386 {
                                                                    phi_3994_ = vec3<f32>(_e1075[1][0], _e1075[1][1], _e1075[1][2]);
                                                                } else {
                                                                    if (_e362 == 1u) {
                                                                        phi_3993_ = vec3<f32>(_e1075[1][2], _e1075[1][0], _e1075[1][1]);
                                                                    } else {
                                                                        phi_3993_ = vec3<f32>(_e1075[1][1], _e1075[1][2], _e1075[1][0]);
                                                                    }
                                                                    let _e1384 = phi_3993_;
                                                                    phi_3994_ = _e1384;
                                                                }
                                                                let _e1387 = phi_3994_;
                                                                if _e386 {
                                                                    phi_4011_ = vec3<f32>(_e1075[2][0], _e1075[2][1], _e1075[2][2]);
                                                                } else {
                                                                    if (_e362 == 1u) {
                                                                        phi_4010_ = vec3<f32>(_e1075[2][2], _e1075[2][0], _e1075[2][1]);
                                                                    } else {
                                                                        phi_4010_ = vec3<f32>(_e1075[2][1], _e1075[2][2], _e1075[2][0]);
                                                                    }
                                                                    let _e1392 = phi_4010_;
                                                                    phi_4011_ = _e1392;
                                                                }
                                                                let _e1395 = phi_4011_;
                                                                let _e1398 = (_e1387.x - _e1379.x);
                                                                let _e1401 = (_e1387.y - _e1379.y);
                                                                let _e1404 = (_e1387.z - _e1379.z);
                                                                let _e1406 = (_e1395.x - _e1379.x);
                                                                let _e1408 = (_e1395.y - _e1379.y);
                                                                let _e1410 = (_e1395.z - _e1379.z);
                                                                if (_e229.member_1 == 1u) {
                                                                    phi_4047_ = (vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]) - _e1379);
                                                                } else {
                                                                    phi_4047_ = vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]);
                                                                }
                                                                let _e1425 = phi_4047_;
                                                                let _e1431 = bitcast<f32>((bitcast<u32>((_e1398 * _e1408)) ^ _e229.member_3[0]));
                                                                let _e1435 = bitcast<f32>((bitcast<u32>((_e1401 * _e1406)) ^ _e229.member_3[0]));
                                                                let _e1439 = bitcast<f32>((bitcast<u32>((_e1401 * _e1410)) ^ _e229.member_3[0]));
                                                                let _e1443 = bitcast<f32>((bitcast<u32>((_e1404 * _e1408)) ^ _e229.member_3[0]));
                                                                let _e1447 = bitcast<f32>((bitcast<u32>((_e1404 * _e1406)) ^ _e229.member_3[0]));
                                                                let _e1451 = bitcast<f32>((bitcast<u32>((_e1398 * _e1410)) ^ _e229.member_3[0]));
                                                                let _e1452 = (_e1439 - _e1443);
                                                                let _e1453 = (_e1447 - _e1451);
                                                                let _e1454 = (_e1431 - _e1435);
                                                                let _e1478 = (bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u)));
                                                                let _e1485 = (bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1451) & 2147483647u)));
                                                                let _e1492 = (bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u)));
                                                                if (_e229.member_2 == 0f) {
                                                                    phi_4229_ = 0f;
                                                                } else {
                                                                    let _e1522 = bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u));
                                                                    let _e1525 = bitcast<f32>((bitcast<u32>(_e1453) & 2147483647u));
                                                                    let _e1528 = bitcast<f32>((bitcast<u32>(_e1454) & 2147483647u));
                                                                    let _e1530 = select(_e1528, _e1525, (_e1525 > _e1528));
                                                                    let _e1534 = select(_e1528, _e1525, (_e1525 < _e1528));
                                                                    let _e1538 = select(_e1525, _e1522, (_e1522 < _e1525));
                                                                    let _e1540 = select(_e1525, _e1522, (_e1522 > _e1525));
                                                                    let _e1542 = select(_e1528, _e1540, (_e1540 < _e1528));
                                                                    phi_4229_ = bitcast<f32>((bitcast<u32>((_e229.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1530, _e1522, (_e1522 > _e1530)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1542, _e1538, (_e1538 > _e1542)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1534, _e1522, (_e1522 < _e1534)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1478 + _e1485) + _e1492))) ^ _e229.member_3[0]))) * 1.0000005f)) ^ _e229.member_3[0])))) ^ _e229.member_3[0]));
                                                                }
                                                                let _e1569 = phi_4229_;
                                                                phi_4247_ = (_e1371 || !(((((bitcast<f32>((bitcast<u32>((_e1425.x * _e1452)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1425.y * _e1453)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1425.z * _e1454)) ^ _e229.member_3[0]))) * f32(-(_e1370))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1425.x) & 2147483647u)) * _e1478)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1425.y) & 2147483647u)) * _e1485)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1425.z) & 2147483647u)) * _e1492)) ^ _e229.member_3[0]))))) ^ _e229.member_3[0])) + _e1569) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1583 = phi_4247_;
                                                            phi_4248_ = _e1583;
                                                        }
                                                        let _e1585 = phi_4248_;
                                                        if _e1585 {
                                                            phi_4253_ = type_39(_e939.member, true);
                                                        } else {
                                                            phi_4253_ = _e939;
                                                        }
                                                        let _e1590 = phi_4253_;
                                                        phi_4254_ = _e1590;
                                                    } else {
                                                        phi_4254_ = _e939;
                                                    }
                                                    let _e1592 = phi_4254_;
                                                    phi_5325_ = _e1074;
                                                    phi_3091_ = _e1592;
                                                } else {
                                                    phi_5325_ = _e937;
                                                    phi_3091_ = type_39();
                                                }
                                                let _e1594 = phi_5325_;
                                                let _e1596 = phi_3091_;
                                                continue;
                                                continuing {
                                                    phi_5319_ = _e1594;
                                                    phi_3090_ = _e1596;
                                                    phi_3093_ = _e954;
                                                    phi_5324_ = _e1594;
                                                    break if !(_e960);
                                                }
                                            }
                                            let _e1599 = phi_5324_;
                                            phi_5400_ = _e1599;
                                            if _e1599 {
                                                break;
                                            }
                                            let _e1601 = local_17;
                                            phi_5404_ = _e1599;
                                            let _e1801 = local_19;
                                            phi_5099_ = _e1801;
                                            phi_5100_ = _e611;
                                            phi_5101_ = false;
                                            phi_5102_ = select(_e615, 0u, _e1601.member_1);
                                        } else {
                                            local_3 = array<f32, 3>(_e611.member.member[0], _e611.member.member[1], _e611.member.member[2]);
                                            local_2 = array<f32, 3>(_e611.member.member_1[0], _e611.member.member_1[1], _e611.member.member_1[2]);
                                            let _e635 = (_e611.member_1 < _e97);
                                            if _e635 {
                                                if _e635 {
                                                } else {
                                                    phi_5400_ = true;
                                                    break;
                                                }
                                                let _e637 = global_9.member[_e611.member_1];
                                                phi_4289_ = _e637;
                                            } else {
                                                phi_4289_ = type_48(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e639 = phi_4289_;
                                            let _e641 = array<u32, 3>(_e362, _e361, _e363);
                                            local_11 = _e641;
                                            local_7 = array<f32, 3>(0f, 0f, 0f);
                                            local_6 = array<f32, 3>(0f, 0f, 0f);
                                            phi_4298_ = type_8(0u, 3u);
                                            loop {
                                                let _e643 = phi_4298_;
                                                if (_e643.member < _e643.member_1) {
                                                    phi_4299_ = type_8((_e643.member + 1u), _e643.member_1);
                                                    phi_4322_ = type_8(1u, _e643.member);
                                                } else {
                                                    phi_4299_ = _e643;
                                                    phi_4322_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e656 = phi_4299_;
                                                let _e658 = phi_4322_;
                                                let _e662 = (bitcast<i32>(_e658.member) != 0i);
                                                if _e662 {
                                                    let _e663 = (_e658.member_1 < 3u);
                                                    if _e663 {
                                                    } else {
                                                        phi_5235_ = true;
                                                        break;
                                                    }
                                                    let _e665 = local_11[_e658.member_1];
                                                    if _e663 {
                                                    } else {
                                                        phi_5235_ = true;
                                                        break;
                                                    }
                                                    let _e667 = local_3[_e658.member_1];
                                                    if _e663 {
                                                    } else {
                                                        phi_5235_ = true;
                                                        break;
                                                    }
                                                    let _e669 = local_2[_e658.member_1];
                                                    let _e672 = ((10u * _e665) & 31u);
                                                    let _e675 = ((_e639.member[0] >> bitcast<u32>(_e672)) & 1023u);
                                                    let _e680 = bitcast<f32>((bitcast<u32>(((_e669 - _e667) * 0.0009775171f)) ^ _e140));
                                                    let _e686 = (_e667 + bitcast<f32>((bitcast<u32>((f32(_e675) * _e680)) ^ _e140)));
                                                    if _e663 {
                                                    } else {
                                                        phi_5235_ = true;
                                                        break;
                                                    }
                                                    local_7[_e658.member_1] = select(select(_e669, _e686, (_e686 < _e669)), _e669, (_e675 == 1023u));
                                                    let _e695 = ((_e639.member[1] >> bitcast<u32>(_e672)) & 1023u);
                                                    let _e701 = (_e667 + bitcast<f32>((bitcast<u32>((f32(_e695) * _e680)) ^ _e140)));
                                                    if _e663 {
                                                    } else {
                                                        phi_5235_ = true;
                                                        break;
                                                    }
                                                    local_6[_e658.member_1] = select(select(_e669, _e701, (_e701 < _e669)), _e669, (_e695 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_4298_ = _e656;
                                                    phi_5235_ = _e572;
                                                    break if !(_e662);
                                                }
                                            }
                                            let _e709 = phi_5235_;
                                            phi_5400_ = _e709;
                                            if _e709 {
                                                break;
                                            }
                                            let _e710 = local_6;
                                            let _e711 = local_7;
                                            local_10 = _e641;
                                            local_9 = array<f32, 3>(0f, 0f, 0f);
                                            local_8 = array<f32, 3>(0f, 0f, 0f);
                                            phi_4452_ = type_8(0u, 3u);
                                            loop {
                                                let _e720 = phi_4452_;
                                                if (_e720.member < _e720.member_1) {
                                                    phi_4453_ = type_8((_e720.member + 1u), _e720.member_1);
                                                    phi_4476_ = type_8(1u, _e720.member);
                                                } else {
                                                    phi_4453_ = _e720;
                                                    phi_4476_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e733 = phi_4453_;
                                                let _e735 = phi_4476_;
                                                let _e739 = (bitcast<i32>(_e735.member) != 0i);
                                                if _e739 {
                                                    let _e740 = (_e735.member_1 < 3u);
                                                    if _e740 {
                                                    } else {
                                                        phi_5302_ = true;
                                                        break;
                                                    }
                                                    let _e742 = local_10[_e735.member_1];
                                                    if _e740 {
                                                    } else {
                                                        phi_5302_ = true;
                                                        break;
                                                    }
                                                    let _e744 = local_3[_e735.member_1];
                                                    if _e740 {
                                                    } else {
                                                        phi_5302_ = true;
                                                        break;
                                                    }
                                                    let _e746 = local_2[_e735.member_1];
                                                    let _e749 = ((10u * _e742) & 31u);
                                                    let _e752 = ((_e639.member_1[0] >> bitcast<u32>(_e749)) & 1023u);
                                                    let _e757 = bitcast<f32>((bitcast<u32>(((_e746 - _e744) * 0.0009775171f)) ^ _e140));
                                                    let _e763 = (_e744 + bitcast<f32>((bitcast<u32>((f32(_e752) * _e757)) ^ _e140)));
                                                    if _e740 {
                                                    } else {
                                                        phi_5302_ = true;
                                                        break;
                                                    }
                                                    local_9[_e735.member_1] = select(select(_e746, _e763, (_e763 < _e746)), _e746, (_e752 == 1023u));
                                                    let _e772 = ((_e639.member_1[1] >> bitcast<u32>(_e749)) & 1023u);
                                                    let _e778 = (_e744 + bitcast<f32>((bitcast<u32>((f32(_e772) * _e757)) ^ _e140)));
                                                    if _e740 {
                                                    } else {
                                                        phi_5302_ = true;
                                                        break;
                                                    }
                                                    local_8[_e735.member_1] = select(select(_e746, _e778, (_e778 < _e746)), _e746, (_e772 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_4452_ = _e733;
                                                    phi_5302_ = _e709;
                                                    break if !(_e739);
                                                }
                                            }
                                            let _e786 = phi_5302_;
                                            phi_5400_ = _e786;
                                            if _e786 {
                                                break;
                                            }
                                            let _e787 = local_8;
                                            let _e788 = local_9;
                                            let _e799 = type_62(type_53(array<f32, 3>(_e711[0], _e711[1], _e711[2]), array<f32, 3>(_e710[0], _e710[1], _e710[2])), _e639.member_2);
                                            let _e804 = type_62(type_53(array<f32, 3>(_e788[0], _e788[1], _e788[2]), array<f32, 3>(_e787[0], _e787[1], _e787[2])), _e639.member_3);
                                            let _e810 = ((_e711[0] - _e417) * _e422);
                                            let _e811 = ((_e788[0] - _e417) * _e422);
                                            let _e812 = ((_e710[0] - _e418) * _e422);
                                            let _e813 = ((_e787[0] - _e418) * _e422);
                                            let _e818 = ((_e711[1] - _e453) * _e458);
                                            let _e819 = ((_e788[1] - _e453) * _e458);
                                            let _e820 = ((_e710[1] - _e454) * _e458);
                                            let _e821 = ((_e787[1] - _e454) * _e458);
                                            let _e826 = ((_e711[2] - _e489) * _e494);
                                            let _e827 = ((_e788[2] - _e489) * _e494);
                                            let _e828 = ((_e710[2] - _e490) * _e494);
                                            let _e829 = ((_e787[2] - _e490) * _e494);
                                            let _e831 = select(_e828, _e826, (_e826 < _e828));
                                            let _e833 = select(_e829, _e827, (_e827 < _e829));
                                            let _e835 = select(_e828, _e826, (_e826 > _e828));
                                            let _e837 = select(_e829, _e827, (_e827 > _e829));
                                            let _e839 = select(_e812, _e810, (_e810 < _e812));
                                            let _e841 = select(_e813, _e811, (_e811 < _e813));
                                            let _e843 = select(_e820, _e818, (_e818 < _e820));
                                            let _e845 = select(_e821, _e819, (_e819 < _e821));
                                            let _e847 = select(_e843, _e839, (_e839 > _e843));
                                            let _e849 = select(_e845, _e841, (_e841 > _e845));
                                            let _e851 = select(_e831, _e847, (_e847 > _e831));
                                            let _e853 = select(_e833, _e849, (_e849 > _e833));
                                            let _e855 = select(_e812, _e810, (_e810 > _e812));
                                            let _e857 = select(_e813, _e811, (_e811 > _e813));
                                            let _e859 = select(_e820, _e818, (_e818 > _e820));
                                            let _e861 = select(_e821, _e819, (_e819 > _e821));
                                            let _e863 = select(_e859, _e855, (_e855 < _e859));
                                            let _e865 = select(_e861, _e857, (_e857 < _e861));
                                            let _e870 = -(_e831);
                                            let _e871 = -(_e833);
                                            let _e878 = (select(_e835, _e863, (_e863 < _e835)) + (select(_e870, _e835, (_e835 > _e870)) * 0.0000019073523f));
                                            let _e879 = (select(_e837, _e865, (_e865 < _e837)) + (select(_e871, _e837, (_e837 > _e871)) * 0.0000019073523f));
                                            let _e881 = select(_e540, _e851, (_e851 > _e540));
                                            let _e883 = select(_e540, _e853, (_e853 > _e540));
                                            let _e888 = (_e881 <= select(_e574.member, _e878, (_e878 < _e574.member)));
                                            let _e889 = (_e883 <= select(_e574.member, _e879, (_e879 < _e574.member)));
                                            let _e890 = (_e881 <= _e883);
                                            if _e888 {
                                                if _e889 {
                                                    if _e890 {
                                                        phi_5039_ = _e804;
                                                    } else {
                                                        phi_5039_ = _e799;
                                                    }
                                                    let _e892 = phi_5039_;
                                                    let _e893 = (_e615 % 128u);
                                                    let _e894 = (_e893 < 128u);
                                                    if _e894 {
                                                    } else {
                                                        phi_5400_ = true;
                                                        break;
                                                    }
                                                    local_5[_e893] = type_62(type_53(array<f32, 3>(_e892.member.member[0], _e892.member.member[1], _e892.member.member[2]), array<f32, 3>(_e892.member.member_1[0], _e892.member.member_1[1], _e892.member.member_1[2])), _e892.member_1);
                                                    if _e894 {
                                                    } else {
                                                        phi_5400_ = true;
                                                        break;
                                                    }
                                                    local_4[_e893] = select(_e883, _e881, (_e881 > _e883));
                                                    if _e890 {
                                                        phi_5078_ = _e799;
                                                    } else {
                                                        phi_5078_ = _e804;
                                                    }
                                                    let _e915 = phi_5078_;
                                                    phi_5079_ = _e915;
                                                    phi_5080_ = (_e615 + 1u);
                                                } else {
                                                    phi_5079_ = type_62();
                                                    phi_5080_ = u32();
                                                }
                                                let _e917 = phi_5079_;
                                                let _e919 = phi_5080_;
                                                phi_5082_ = _e917;
                                                phi_5083_ = _e919;
                                                phi_5084_ = select(true, false, _e889);
                                            } else {
                                                phi_5082_ = type_62();
                                                phi_5083_ = u32();
                                                phi_5084_ = true;
                                            }
                                            let _e922 = phi_5082_;
                                            let _e924 = phi_5083_;
                                            let _e926 = phi_5084_;
                                            if _e926 {
                                                if _e888 {
                                                    phi_5091_ = _e799;
                                                } else {
                                                    phi_5091_ = _e804;
                                                }
                                                let _e928 = phi_5091_;
                                                phi_5096_ = _e928;
                                                phi_5097_ = select(_e889, true, _e888);
                                            } else {
                                                phi_5096_ = _e922;
                                                phi_5097_ = _e613;
                                            }
                                            let _e931 = phi_5096_;
                                            let _e933 = phi_5097_;
                                            phi_5404_ = _e786;
                                            phi_5099_ = _e574;
                                            phi_5100_ = _e931;
                                            phi_5101_ = _e933;
                                            phi_5102_ = select(_e924, _e615, _e926);
                                        }
                                        let _e1605 = phi_5404_;
                                        let _e1607 = phi_5099_;
                                        let _e1609 = phi_5100_;
                                        let _e1611 = phi_5101_;
                                        let _e1613 = phi_5102_;
                                        phi_5403_ = _e1605;
                                        phi_5103_ = _e1607;
                                        phi_5104_ = _e1609;
                                        phi_5105_ = (_e578 - 1u);
                                        phi_5106_ = _e1611;
                                        phi_5107_ = _e1613;
                                    } else {
                                        phi_5403_ = _e572;
                                        phi_5103_ = _e574;
                                        phi_5104_ = _e611;
                                        phi_5105_ = _e578;
                                        phi_5106_ = _e613;
                                        phi_5107_ = _e615;
                                    }
                                    let _e1615 = phi_5403_;
                                    let _e1617 = phi_5103_;
                                    let _e1619 = phi_5104_;
                                    let _e1621 = phi_5105_;
                                    let _e1623 = phi_5106_;
                                    let _e1625 = phi_5107_;
                                    phi_5402_ = _e1615;
                                    phi_5108_ = _e1617;
                                    phi_5109_ = _e1619;
                                    phi_5110_ = _e1621;
                                    phi_5111_ = _e1623;
                                    phi_5112_ = _e1625;
                                } else {
                                    phi_5402_ = _e572;
                                    phi_5108_ = type_39();
                                    phi_5109_ = type_62();
                                    phi_5110_ = u32();
                                    phi_5111_ = bool();
                                    phi_5112_ = u32();
                                }
                                let _e1627 = phi_5402_;
                                let _e1629 = phi_5108_;
                                let _e1631 = phi_5109_;
                                let _e1633 = phi_5110_;
                                let _e1635 = phi_5111_;
                                let _e1637 = phi_5112_;
                                phi_5401_ = _e1627;
                                phi_3005_ = _e1629;
                                phi_3008_ = _e1631;
                                phi_3010_ = _e1633;
                                phi_3012_ = _e1635;
                                phi_3014_ = _e1637;
                                phi_5113_ = _e586;
                            } else {
                                phi_5401_ = _e572;
                                phi_3005_ = type_39();
                                phi_3008_ = type_62();
                                phi_3010_ = u32();
                                phi_3012_ = bool();
                                phi_3014_ = u32();
                                phi_5113_ = false;
                            }
                            let _e1639 = phi_5401_;
                            let _e1641 = phi_3005_;
                            let _e1643 = phi_3008_;
                            let _e1645 = phi_3010_;
                            let _e1647 = phi_3012_;
                            let _e1649 = phi_3014_;
                            let _e1651 = phi_5113_;
                            continue;
                            continuing {
                                phi_5242_ = _e1639;
                                phi_3004_ = _e1641;
                                phi_3007_ = _e1643;
                                phi_3009_ = _e1645;
                                phi_3011_ = _e1647;
                                phi_3013_ = _e1649;
                                phi_5400_ = _e1639;
                                break if !(_e1651);
                            }
                        }
                        let _e1654 = phi_5400_;
                        if _e1654 {
                            break;
                        }
                        let _e1656 = local_18;
                        if _e1656.member_1 {
                        } else {
                            if _e230 {
                            } else {
                                break;
                            }
                            let _e1660 = global_2.member[_e144];
                            if _e151 {
                            } else {
                                break;
                            }
                            let _e1664 = global_8.member[_e144].member_1;
                            if _e230 {
                            } else {
                                break;
                            }
                            global_2.member[_e144] = type_24(_e1660.member, _e1660.member_1, _e1660.member_2, array<f32, 3>((_e1660.member_3[0] + (_e1664[0] * _e1660.member_1[0])), (_e1660.member_3[1] + (_e1664[1] * _e1660.member_1[1])), (_e1660.member_3[2] + (_e1664[2] * _e1660.member_1[2]))), _e1660.member_4);
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
