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

struct type_46 {
    member: f32,
    member_1: bool,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_55 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_61 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_63 {
    member: type_61,
    member_1: u32,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_31;
@group(0) @binding(1) 
var<uniform> global_3: type_48;
@group(0) @binding(2) 
var<uniform> global_4: type_48;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_51;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_68;
@group(0) @binding(7) 
var<storage> global_9: type_37;
@group(0) @binding(3) 
var<storage> global_10: type_57;

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
    var local_9: array<f32, 128>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<u32, 3>;
    var local_15: array<u32, 3>;
    var local_16: array<f32, 3>;
    var local_17: array<f32, 3>;
    var phi_279_: u32;
    var phi_323_: i32;
    var phi_347_: type_41;
    var phi_497_: i32;
    var phi_498_: i32;
    var phi_508_: bool;
    var phi_518_: u32;
    var phi_519_: u32;
    var phi_521_: bool;
    var phi_526_: u32;
    var phi_559_: i32;
    var phi_577_: f32;
    var phi_583_: f32;
    var phi_594_: f32;
    var phi_600_: f32;
    var phi_623_: f32;
    var phi_634_: f32;
    var phi_643_: f32;
    var phi_649_: f32;
    var phi_660_: f32;
    var phi_666_: f32;
    var phi_689_: f32;
    var phi_700_: f32;
    var phi_709_: f32;
    var phi_715_: f32;
    var phi_726_: f32;
    var phi_732_: f32;
    var phi_755_: f32;
    var phi_766_: f32;
    var phi_866_: f32;
    var phi_867_: f32;
    var phi_3139_: bool;
    var phi_940_: type_46;
    var phi_943_: type_63;
    var phi_945_: u32;
    var phi_947_: bool;
    var phi_949_: u32;
    var phi_960_: bool;
    var phi_1046_: type_63;
    var phi_1047_: bool;
    var phi_1048_: u32;
    var phi_2148_: type_55;
    var phi_2157_: type_8;
    var phi_2158_: type_8;
    var phi_2181_: type_8;
    var phi_3132_: bool;
    var phi_2311_: type_8;
    var phi_2312_: type_8;
    var phi_2335_: type_8;
    var phi_3199_: bool;
    var phi_2898_: type_63;
    var phi_2975_: type_63;
    var phi_2976_: type_63;
    var phi_2977_: u32;
    var phi_2979_: type_63;
    var phi_2980_: u32;
    var phi_2981_: bool;
    var phi_2988_: type_63;
    var phi_2993_: type_63;
    var phi_2994_: bool;
    var phi_1066_: type_46;
    var phi_1069_: type_8;
    var phi_1070_: type_8;
    var phi_1092_: type_8;
    var phi_1113_: u32;
    var phi_1202_: array<array<f32, 3>, 3>;
    var phi_1673_: vec3<f32>;
    var phi_1674_: vec3<f32>;
    var phi_1705_: bool;
    var phi_1714_: vec3<f32>;
    var phi_1754_: type_27;
    var phi_1756_: type_27;
    var phi_1757_: bool;
    var phi_1761_: type_27;
    var phi_1762_: type_27;
    var phi_1763_: type_27;
    var phi_1764_: bool;
    var phi_1768_: type_27;
    var phi_1769_: bool;
    var phi_1773_: type_27;
    var phi_1774_: bool;
    var phi_1778_: type_27;
    var phi_1801_: u32;
    var phi_1815_: i32;
    var phi_1835_: vec3<f32>;
    var phi_1836_: vec3<f32>;
    var phi_1852_: vec3<f32>;
    var phi_1853_: vec3<f32>;
    var phi_1869_: vec3<f32>;
    var phi_1870_: vec3<f32>;
    var phi_1906_: vec3<f32>;
    var phi_2088_: f32;
    var phi_2106_: bool;
    var phi_2107_: bool;
    var phi_2112_: type_46;
    var phi_2113_: type_46;
    var phi_1067_: type_46;
    var phi_3207_: bool;
    var local_18: type_46;
    var phi_3291_: bool;
    var phi_2996_: type_46;
    var phi_2997_: type_63;
    var phi_2998_: bool;
    var phi_2999_: u32;
    var phi_3290_: bool;
    var phi_3000_: type_46;
    var phi_3001_: type_63;
    var phi_3002_: u32;
    var phi_3003_: bool;
    var phi_3004_: u32;
    var phi_3289_: bool;
    var phi_3005_: type_46;
    var phi_3006_: type_63;
    var phi_3007_: u32;
    var phi_3008_: bool;
    var phi_3009_: u32;
    var phi_3288_: bool;
    var phi_941_: type_46;
    var phi_944_: type_63;
    var phi_946_: u32;
    var phi_948_: bool;
    var phi_950_: u32;
    var phi_3010_: bool;
    var phi_3287_: bool;
    var local_19: type_46;
    var local_20: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e98 = arrayLength((&global_10.member));
            let _e100 = arrayLength((&global_5.member));
            let _e112 = arrayLength((&global_8.member));
            let _e116 = global_4.member[0u][0u];
            let _e120 = global_4.member[0u][1u];
            let _e124 = global_4.member[0u][2u];
            let _e128 = global_4.member[1u][0u];
            let _e132 = global_4.member[1u][1u];
            let _e136 = global_4.member[1u][2u];
            let _e140 = global_4.member[1u][3u];
            let _e144 = (_e95.x + (_e95.y * 2097152u));
            let _e151 = (_e144 < arrayLength((&global_9.member)));
            if _e151 {
                if _e151 {
                } else {
                    break;
                }
                let _e155 = global_9.member[_e144].member_2;
                phi_279_ = _e155;
            } else {
                phi_279_ = 4294967295u;
            }
            let _e157 = phi_279_;
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
                phi_323_ = -126i;
            } else {
                phi_323_ = select(_e200, 127i, (_e200 > 127i));
            }
            let _e205 = phi_323_;
            let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
            let _e216 = bitcast<f32>((bitcast<u32>(((_e200 - _e205) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_347_ = type_41(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                phi_347_ = type_41(array<f32, 3>(((_e193 * _e210) * _e216), ((_e194 * _e210) * _e216), ((_e195 * _e210) * _e216)), _e176, ((_e197 * _e210) * _e216), _e198);
            }
            let _e229 = phi_347_;
            if _e151 {
                let _e230 = (_e144 < arrayLength((&global_2.member)));
                if _e230 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e235 = global_9.member[_e144].member.member_1;
                    let _e240 = global_9.member[_e144].member.member_3;
                    if (_e235 <= _e240) {
                        let _e242 = (1u < _e112);
                        if _e242 {
                            if (0u < _e112) {
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
                        let _e261 = global_9.member[_e144].member.member_2[0u];
                        let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                        let _e269 = global_9.member[_e144].member.member_2[1u];
                        let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                        let _e277 = global_9.member[_e144].member.member_2[2u];
                        let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                        let _e285 = global_9.member[_e144].member.member[0u];
                        let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                        let _e293 = global_9.member[_e144].member.member[1u];
                        let _e295 = (bitcast<u32>(_e293) & 2147483647u);
                        let _e301 = global_9.member[_e144].member.member[2u];
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
                                phi_497_ = (bitcast<i32>((_e327 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_497_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e327)), 32u, (_e327 == 0u))));
                            }
                            let _e341 = phi_497_;
                            phi_498_ = _e341;
                        } else {
                            phi_498_ = 0i;
                        }
                        let _e343 = phi_498_;
                        let _e344 = (_e263 == _e307);
                        if _e344 {
                            phi_508_ = true;
                        } else {
                            phi_508_ = (_e271 == _e307);
                        }
                        let _e347 = phi_508_;
                        let _e348 = select(1u, 0u, _e344);
                        if _e347 {
                            let _e349 = (_e348 + 1u);
                            phi_518_ = _e349;
                            phi_519_ = _e349;
                            phi_521_ = select(true, false, (_e349 == 2u));
                        } else {
                            phi_518_ = u32();
                            phi_519_ = 0u;
                            phi_521_ = true;
                        }
                        let _e353 = phi_518_;
                        let _e355 = phi_519_;
                        let _e357 = phi_521_;
                        if _e357 {
                            phi_526_ = (_e355 + 1u);
                        } else {
                            phi_526_ = 0u;
                        }
                        let _e361 = phi_526_;
                        let _e362 = select(_e353, _e355, _e357);
                        let _e363 = select(_e348, select(2u, _e348, _e347), _e357);
                        let _e364 = -(_e343);
                        if (_e364 < -126i) {
                            phi_559_ = -126i;
                        } else {
                            phi_559_ = select(_e364, 127i, (_e364 > 127i));
                        }
                        let _e369 = phi_559_;
                        let _e374 = bitcast<f32>((bitcast<u32>((_e369 + 127i)) << bitcast<u32>(23i)));
                        let _e380 = bitcast<f32>((bitcast<u32>(((_e364 - _e369) + 127i)) << bitcast<u32>(23i)));
                        let _e385 = global_9.member[_e144].member.member;
                        let _e386 = (_e362 == 0u);
                        if _e386 {
                            phi_577_ = _e385[0];
                        } else {
                            phi_577_ = _e385[1];
                        }
                        let _e390 = phi_577_;
                        let _e391 = (_e362 == 2u);
                        if _e391 {
                            phi_583_ = _e385[2];
                        } else {
                            phi_583_ = _e390;
                        }
                        let _e394 = phi_583_;
                        let _e395 = global_9.member[_e144].member.member_2;
                        if _e386 {
                            phi_594_ = _e395[0];
                        } else {
                            phi_594_ = _e395[1];
                        }
                        let _e399 = phi_594_;
                        if _e391 {
                            phi_600_ = _e395[2];
                        } else {
                            phi_600_ = _e399;
                        }
                        let _e402 = phi_600_;
                        let _e404 = ((_e402 * _e374) * _e380);
                        let _e408 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e408 {
                            let _e412 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) * 0.00000011920929f);
                            phi_623_ = select(0.00000000000011368684f, _e412, (_e412 > 0.00000000000011368684f));
                        } else {
                            phi_623_ = 0f;
                        }
                        let _e416 = phi_623_;
                        let _e417 = (_e394 + _e416);
                        let _e418 = (_e394 - _e416);
                        let _e419 = select(_e404, 0f, _e408);
                        if _e408 {
                            phi_634_ = 38685626000000000000000000f;
                        } else {
                            phi_634_ = (1f / _e404);
                        }
                        let _e422 = phi_634_;
                        let _e423 = (_e361 == 0u);
                        if _e423 {
                            phi_643_ = _e385[0];
                        } else {
                            phi_643_ = _e385[1];
                        }
                        let _e427 = phi_643_;
                        let _e428 = (_e361 == 2u);
                        if _e428 {
                            phi_649_ = _e385[2];
                        } else {
                            phi_649_ = _e427;
                        }
                        let _e431 = phi_649_;
                        if _e423 {
                            phi_660_ = _e395[0];
                        } else {
                            phi_660_ = _e395[1];
                        }
                        let _e435 = phi_660_;
                        if _e428 {
                            phi_666_ = _e395[2];
                        } else {
                            phi_666_ = _e435;
                        }
                        let _e438 = phi_666_;
                        let _e440 = ((_e438 * _e374) * _e380);
                        let _e444 = (bitcast<f32>((bitcast<u32>(_e440) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e444 {
                            let _e448 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) * 0.00000011920929f);
                            phi_689_ = select(0.00000000000011368684f, _e448, (_e448 > 0.00000000000011368684f));
                        } else {
                            phi_689_ = 0f;
                        }
                        let _e452 = phi_689_;
                        let _e453 = (_e431 + _e452);
                        let _e454 = (_e431 - _e452);
                        let _e455 = select(_e440, 0f, _e444);
                        if _e444 {
                            phi_700_ = 38685626000000000000000000f;
                        } else {
                            phi_700_ = (1f / _e440);
                        }
                        let _e458 = phi_700_;
                        let _e459 = (_e363 == 0u);
                        if _e459 {
                            phi_709_ = _e385[0];
                        } else {
                            phi_709_ = _e385[1];
                        }
                        let _e463 = phi_709_;
                        let _e464 = (_e363 == 2u);
                        if _e464 {
                            phi_715_ = _e385[2];
                        } else {
                            phi_715_ = _e463;
                        }
                        let _e467 = phi_715_;
                        if _e459 {
                            phi_726_ = _e395[0];
                        } else {
                            phi_726_ = _e395[1];
                        }
                        let _e471 = phi_726_;
                        if _e464 {
                            phi_732_ = _e395[2];
                        } else {
                            phi_732_ = _e471;
                        }
                        let _e474 = phi_732_;
                        let _e476 = ((_e474 * _e374) * _e380);
                        let _e480 = (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e480 {
                            let _e484 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) * 0.00000011920929f);
                            phi_755_ = select(0.00000000000011368684f, _e484, (_e484 > 0.00000000000011368684f));
                        } else {
                            phi_755_ = 0f;
                        }
                        let _e488 = phi_755_;
                        let _e489 = (_e467 + _e488);
                        let _e490 = (_e467 - _e488);
                        let _e491 = select(_e476, 0f, _e480);
                        if _e480 {
                            phi_766_ = 38685626000000000000000000f;
                        } else {
                            phi_766_ = (1f / _e476);
                        }
                        let _e494 = phi_766_;
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
                            phi_866_ = select(-340282350000000000000000000000000000000f, _e534, (_e534 > -340282350000000000000000000000000000000f));
                            phi_867_ = select(-340282350000000000000000000000000000000f, _e527, (_e527 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_866_ = 0f;
                            phi_867_ = 1f;
                        }
                        let _e538 = phi_866_;
                        let _e540 = phi_867_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_17 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                        let _e545 = (_e362 % 3u);
                        let _e546 = (_e545 < 3u);
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e548 = local_17[_e545];
                        let _e549 = (_e361 % 3u);
                        let _e550 = (_e549 < 3u);
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e552 = local_17[_e549];
                        let _e553 = (_e363 % 3u);
                        let _e554 = (_e553 < 3u);
                        if _e554 {
                        } else {
                            break;
                        }
                        let _e556 = local_17[_e553];
                        local_16 = array<f32, 3>(bitcast<f32>(_e128), bitcast<f32>(_e132), bitcast<f32>(_e136));
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e560 = local_16[_e545];
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e562 = local_16[_e549];
                        if _e554 {
                        } else {
                            break;
                        }
                        let _e564 = local_16[_e553];
                        phi_3139_ = false;
                        phi_940_ = type_46(_e538, false);
                        phi_943_ = type_63(type_61(array<f32, 3>(_e548, _e552, _e556), array<f32, 3>(_e560, _e562, _e564)), select(0u, 2147483648u, (_e98 == 0u)));
                        phi_945_ = ((3u * _e98) + 1u);
                        phi_947_ = (_e540 <= _e538);
                        phi_949_ = 0u;
                        loop {
                            let _e572 = phi_3139_;
                            let _e574 = phi_940_;
                            let _e576 = phi_943_;
                            let _e578 = phi_945_;
                            let _e580 = phi_947_;
                            let _e582 = phi_949_;
                            local_19 = _e574;
                            if _e580 {
                                phi_960_ = true;
                            } else {
                                phi_960_ = (_e582 > 0u);
                            }
                            let _e585 = phi_960_;
                            if _e585 {
                                let _e586 = (_e578 > 0u);
                                if _e586 {
                                    if _e580 {
                                        phi_1046_ = _e576;
                                        phi_1047_ = _e580;
                                        phi_1048_ = _e582;
                                    } else {
                                        let _e587 = (_e582 - 1u);
                                        let _e588 = (_e587 % 128u);
                                        let _e589 = (_e588 < 128u);
                                        if _e589 {
                                        } else {
                                            phi_3287_ = true;
                                            break;
                                        }
                                        let _e591 = local_6[_e588];
                                        if _e589 {
                                        } else {
                                            phi_3287_ = true;
                                            break;
                                        }
                                        let _e593 = local_5[_e588];
                                        if _e589 {
                                        } else {
                                            phi_3287_ = true;
                                            break;
                                        }
                                        let _e595 = local_4[_e588];
                                        if _e589 {
                                        } else {
                                            phi_3287_ = true;
                                            break;
                                        }
                                        let _e597 = local_3[_e588];
                                        if _e589 {
                                        } else {
                                            phi_3287_ = true;
                                            break;
                                        }
                                        let _e600 = local_2[_e588];
                                        if _e589 {
                                        } else {
                                            phi_3287_ = true;
                                            break;
                                        }
                                        let _e602 = local_1[_e588];
                                        if _e589 {
                                        } else {
                                            phi_3287_ = true;
                                            break;
                                        }
                                        let _e604 = local[_e588];
                                        if _e589 {
                                        } else {
                                            phi_3287_ = true;
                                            break;
                                        }
                                        let _e609 = local_9[_e588];
                                        phi_1046_ = type_63(type_61(array<f32, 3>(_e593, _e595, _e597), array<f32, 3>(_e600, _e602, _e604)), _e591);
                                        phi_1047_ = (_e609 <= _e574.member);
                                        phi_1048_ = _e587;
                                    }
                                    let _e613 = phi_1046_;
                                    let _e615 = phi_1047_;
                                    let _e617 = phi_1048_;
                                    if _e615 {
                                        if ((_e613.member_1 & 2147483648u) != 0u) {
                                            phi_1066_ = _e574;
                                            phi_1069_ = type_8(0u, ((_e613.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e942 = phi_1066_;
                                                let _e944 = phi_1069_;
                                                local_18 = _e942;
                                                local_20 = _e942;
                                                if (_e944.member < _e944.member_1) {
                                                    phi_1070_ = type_8((_e944.member + 1u), _e944.member_1);
                                                    phi_1092_ = type_8(1u, _e944.member);
                                                } else {
                                                    phi_1070_ = _e944;
                                                    phi_1092_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e957 = phi_1070_;
                                                let _e959 = phi_1092_;
                                                let _e963 = (bitcast<i32>(_e959.member) != 0i);
                                                if _e963 {
                                                    let _e964 = ((_e613.member_1 & 268435455u) + _e959.member_1);
                                                    let _e965 = (_e964 < _e100);
                                                    if _e965 {
                                                        if _e965 {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        let _e969 = global_5.member[_e964].member_1;
                                                        phi_1113_ = _e969;
                                                    } else {
                                                        phi_1113_ = 4294967295u;
                                                    }
                                                    let _e971 = phi_1113_;
                                                    if (_e964 >= _e100) {
                                                        phi_1202_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e965 {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        if (_e545 < 9u) {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        let _e978 = global_5.member[_e964].member[_e545];
                                                        if (_e549 < 9u) {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        let _e984 = global_5.member[_e964].member[_e549];
                                                        if (_e553 < 9u) {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        let _e990 = global_5.member[_e964].member[_e553];
                                                        let _e992 = (3u + _e545);
                                                        if (_e992 < 9u) {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        let _e998 = global_5.member[_e964].member[_e992];
                                                        let _e999 = (3u + _e549);
                                                        if (_e999 < 9u) {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        let _e1005 = global_5.member[_e964].member[_e999];
                                                        let _e1006 = (3u + _e553);
                                                        if (_e1006 < 9u) {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        let _e1012 = global_5.member[_e964].member[_e1006];
                                                        let _e1014 = (6u + _e545);
                                                        if (_e1014 < 9u) {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        let _e1020 = global_5.member[_e964].member[_e1014];
                                                        let _e1021 = (6u + _e549);
                                                        if (_e1021 < 9u) {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        let _e1027 = global_5.member[_e964].member[_e1021];
                                                        let _e1028 = (6u + _e553);
                                                        if (_e1028 < 9u) {
                                                        } else {
                                                            phi_3207_ = true;
                                                            break;
                                                        }
                                                        let _e1034 = global_5.member[_e964].member[_e1028];
                                                        phi_1202_ = array<array<f32, 3>, 3>(array<f32, 3>(_e978, _e984, _e990), array<f32, 3>(_e998, _e1005, _e1012), array<f32, 3>(_e1020, _e1027, _e1034));
                                                    }
                                                    let _e1038 = phi_1202_;
                                                    let _e1046 = (_e1038[0][2] - _e467);
                                                    let _e1049 = (((_e1038[0][0] - _e394) * _e491) - (_e1046 * _e419));
                                                    let _e1052 = (((_e1038[0][1] - _e431) * _e491) - (_e1046 * _e455));
                                                    let _e1059 = (_e1038[1][2] - _e467);
                                                    let _e1062 = (((_e1038[1][0] - _e394) * _e491) - (_e1059 * _e419));
                                                    let _e1065 = (((_e1038[1][1] - _e431) * _e491) - (_e1059 * _e455));
                                                    let _e1072 = (_e1038[2][2] - _e467);
                                                    let _e1075 = (((_e1038[2][0] - _e394) * _e491) - (_e1072 * _e419));
                                                    let _e1078 = (((_e1038[2][1] - _e431) * _e491) - (_e1072 * _e455));
                                                    let _e1079 = (_e1075 * _e1065);
                                                    let _e1080 = (_e1078 * _e1062);
                                                    let _e1081 = (_e1049 * _e1078);
                                                    let _e1082 = (_e1052 * _e1075);
                                                    let _e1083 = (_e1062 * _e1052);
                                                    let _e1084 = (_e1065 * _e1049);
                                                    let _e1089 = (((_e1079 >= _e1080) && (_e1081 >= _e1082)) && (_e1083 >= _e1084));
                                                    if (_e1089 || (((_e1079 <= _e1080) && (_e1081 <= _e1082)) && (_e1083 <= _e1084))) {
                                                        let _e1096 = select(-1f, 1f, _e1089);
                                                        let _e1098 = ((_e1079 - _e1080) * _e1096);
                                                        let _e1100 = select(0f, _e1098, (_e1098 > 0f));
                                                        let _e1102 = ((_e1081 - _e1082) * _e1096);
                                                        let _e1104 = select(0f, _e1102, (_e1102 > 0f));
                                                        let _e1106 = ((_e1083 - _e1084) * _e1096);
                                                        let _e1108 = select(0f, _e1106, (_e1106 > 0f));
                                                        let _e1110 = ((_e1100 + _e1104) + _e1108);
                                                        if (_e1110 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1768_ = type_27();
                                                            phi_1769_ = true;
                                                        } else {
                                                            let _e1113 = select(_e1038[1][0], _e1038[0][0], (_e1038[0][0] < _e1038[1][0]));
                                                            let _e1117 = select(_e1038[1][0], _e1038[0][0], (_e1038[0][0] > _e1038[1][0]));
                                                            let _e1121 = select(_e1038[1][1], _e1038[0][1], (_e1038[0][1] < _e1038[1][1]));
                                                            let _e1125 = select(_e1038[1][1], _e1038[0][1], (_e1038[0][1] > _e1038[1][1]));
                                                            let _e1129 = select(_e1038[1][2], _e1038[0][2], (_e1038[0][2] < _e1038[1][2]));
                                                            let _e1133 = select(_e1038[1][2], _e1038[0][2], (_e1038[0][2] > _e1038[1][2]));
                                                            let _e1138 = ((select(_e1038[2][0], _e1113, (_e1113 < _e1038[2][0])) - _e417) * _e422);
                                                            let _e1139 = ((select(_e1038[2][0], _e1117, (_e1117 > _e1038[2][0])) - _e418) * _e422);
                                                            let _e1142 = ((select(_e1038[2][1], _e1121, (_e1121 < _e1038[2][1])) - _e453) * _e458);
                                                            let _e1143 = ((select(_e1038[2][1], _e1125, (_e1125 > _e1038[2][1])) - _e454) * _e458);
                                                            let _e1146 = ((select(_e1038[2][2], _e1129, (_e1129 < _e1038[2][2])) - _e489) * _e494);
                                                            let _e1147 = ((select(_e1038[2][2], _e1133, (_e1133 > _e1038[2][2])) - _e490) * _e494);
                                                            let _e1149 = select(_e1147, _e1146, (_e1146 < _e1147));
                                                            let _e1151 = select(_e1147, _e1146, (_e1146 > _e1147));
                                                            let _e1153 = select(_e1139, _e1138, (_e1138 < _e1139));
                                                            let _e1155 = select(_e1143, _e1142, (_e1142 < _e1143));
                                                            let _e1157 = select(_e1155, _e1153, (_e1153 > _e1155));
                                                            let _e1159 = select(_e1149, _e1157, (_e1157 > _e1149));
                                                            let _e1161 = select(_e1139, _e1138, (_e1138 > _e1139));
                                                            let _e1163 = select(_e1143, _e1142, (_e1142 > _e1143));
                                                            let _e1165 = select(_e1163, _e1161, (_e1161 < _e1163));
                                                            let _e1167 = select(_e1151, _e1165, (_e1165 < _e1151));
                                                            let _e1168 = -(_e1149);
                                                            let _e1174 = select(_e540, _e1159, (_e1159 > _e540));
                                                            if (_e1174 > (_e1167 + (select(_e1168, _e1151, (_e1151 > _e1168)) * 0.0000019073523f))) {
                                                                phi_1763_ = type_27();
                                                                phi_1764_ = true;
                                                            } else {
                                                                let _e1176 = (_e1174 > _e942.member);
                                                                if _e1176 {
                                                                    phi_1762_ = type_27();
                                                                } else {
                                                                    let _e1180 = (_e1038[1][0] - _e1038[0][0]);
                                                                    let _e1181 = (_e1038[1][1] - _e1038[0][1]);
                                                                    let _e1182 = (_e1038[1][2] - _e1038[0][2]);
                                                                    let _e1183 = vec3<f32>(_e1180, _e1181, _e1182);
                                                                    let _e1184 = (_e1038[2][0] - _e1038[1][0]);
                                                                    let _e1185 = (_e1038[2][1] - _e1038[1][1]);
                                                                    let _e1186 = (_e1038[2][2] - _e1038[1][2]);
                                                                    let _e1187 = vec3<f32>(_e1184, _e1185, _e1186);
                                                                    let _e1188 = (_e1038[0][0] - _e1038[2][0]);
                                                                    let _e1189 = (_e1038[0][1] - _e1038[2][1]);
                                                                    let _e1190 = (_e1038[0][2] - _e1038[2][2]);
                                                                    let _e1191 = vec3<f32>(_e1188, _e1189, _e1190);
                                                                    let _e1194 = bitcast<f32>((bitcast<u32>(_e1180) & 2147483647u));
                                                                    let _e1197 = bitcast<f32>((bitcast<u32>(_e1181) & 2147483647u));
                                                                    let _e1199 = select(_e1197, _e1194, (_e1194 > _e1197));
                                                                    let _e1202 = bitcast<f32>((bitcast<u32>(_e1182) & 2147483647u));
                                                                    let _e1204 = select(_e1202, _e1199, (_e1199 > _e1202));
                                                                    let _e1207 = bitcast<f32>((bitcast<u32>(_e1184) & 2147483647u));
                                                                    let _e1210 = bitcast<f32>((bitcast<u32>(_e1185) & 2147483647u));
                                                                    let _e1212 = select(_e1210, _e1207, (_e1207 > _e1210));
                                                                    let _e1215 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
                                                                    let _e1217 = select(_e1215, _e1212, (_e1212 > _e1215));
                                                                    let _e1220 = bitcast<f32>((bitcast<u32>(_e1188) & 2147483647u));
                                                                    let _e1223 = bitcast<f32>((bitcast<u32>(_e1189) & 2147483647u));
                                                                    let _e1225 = select(_e1223, _e1220, (_e1220 > _e1223));
                                                                    let _e1228 = bitcast<f32>((bitcast<u32>(_e1190) & 2147483647u));
                                                                    let _e1230 = select(_e1228, _e1225, (_e1225 > _e1228));
                                                                    let _e1232 = select(_e1217, _e1204, (_e1204 > _e1217));
                                                                    let _e1234 = select(_e1230, _e1232, (_e1232 > _e1230));
                                                                    if (_e1204 == _e1234) {
                                                                        phi_1673_ = _e1187;
                                                                        phi_1674_ = _e1191;
                                                                    } else {
                                                                        let _e1237 = vec3((_e1217 == _e1234));
                                                                        phi_1673_ = select(_e1183, _e1191, _e1237);
                                                                        phi_1674_ = select(_e1187, _e1183, _e1237);
                                                                    }
                                                                    let _e1241 = phi_1673_;
                                                                    let _e1243 = phi_1674_;
                                                                    let _e1250 = ((_e1241.y * _e1243.z) - (_e1243.y * _e1241.z));
                                                                    let _e1255 = ((_e1241.z * _e1243.x) - (_e1243.z * _e1241.x));
                                                                    let _e1258 = ((_e1241.x * _e1243.y) - (_e1243.x * _e1241.y));
                                                                    if (_e1100 >= _e1104) {
                                                                        phi_1705_ = select(true, false, (_e1100 >= _e1108));
                                                                    } else {
                                                                        phi_1705_ = true;
                                                                    }
                                                                    let _e1263 = phi_1705_;
                                                                    if _e1263 {
                                                                        phi_1714_ = select(vec3<f32>(_e1038[2][0], _e1038[2][1], _e1038[2][2]), vec3<f32>(_e1038[1][0], _e1038[1][1], _e1038[1][2]), vec3((_e1104 >= _e1108)));
                                                                    } else {
                                                                        phi_1714_ = vec3<f32>(_e1038[0][0], _e1038[0][1], _e1038[0][2]);
                                                                    }
                                                                    let _e1268 = phi_1714_;
                                                                    let _e1285 = ((((_e1250 * (_e1268.x - _e394)) + (_e1255 * (_e1268.y - _e431))) + (_e1258 * (_e1268.z - _e467))) / (((_e1250 * _e419) + (_e1255 * _e455)) + (_e1258 * _e491)));
                                                                    let _e1287 = select(_e1167, _e1285, (_e1285 < _e1167));
                                                                    let _e1289 = select(_e1159, _e1287, (_e1287 > _e1159));
                                                                    if (_e1289 >= _e540) {
                                                                        let _e1291 = (_e1289 <= _e942.member);
                                                                        if _e1291 {
                                                                            let _e1292 = (1f / _e1110);
                                                                            phi_1754_ = type_27(_e1289, (_e1104 * _e1292), (_e1108 * _e1292), _e971);
                                                                        } else {
                                                                            phi_1754_ = type_27();
                                                                        }
                                                                        let _e1297 = phi_1754_;
                                                                        phi_1756_ = _e1297;
                                                                        phi_1757_ = select(true, false, _e1291);
                                                                    } else {
                                                                        phi_1756_ = type_27();
                                                                        phi_1757_ = true;
                                                                    }
                                                                    let _e1300 = phi_1756_;
                                                                    let _e1302 = phi_1757_;
                                                                    if _e1302 {
                                                                        phi_1761_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1761_ = _e1300;
                                                                    }
                                                                    let _e1304 = phi_1761_;
                                                                    phi_1762_ = _e1304;
                                                                }
                                                                let _e1306 = phi_1762_;
                                                                phi_1763_ = _e1306;
                                                                phi_1764_ = _e1176;
                                                            }
                                                            let _e1308 = phi_1763_;
                                                            let _e1310 = phi_1764_;
                                                            phi_1768_ = _e1308;
                                                            phi_1769_ = _e1310;
                                                        }
                                                        let _e1312 = phi_1768_;
                                                        let _e1314 = phi_1769_;
                                                        phi_1773_ = _e1312;
                                                        phi_1774_ = _e1314;
                                                    } else {
                                                        phi_1773_ = type_27();
                                                        phi_1774_ = true;
                                                    }
                                                    let _e1316 = phi_1773_;
                                                    let _e1318 = phi_1774_;
                                                    if _e1318 {
                                                        phi_1778_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1778_ = _e1316;
                                                    }
                                                    let _e1320 = phi_1778_;
                                                    if (_e1320.member_3 != 4294967295u) {
                                                        if (_e971 == _e157) {
                                                            phi_2107_ = false;
                                                        } else {
                                                            let _e1324 = (_e971 < arrayLength((&global_6.member)));
                                                            if _e1324 {
                                                                if _e1324 {
                                                                } else {
                                                                    phi_3207_ = true;
                                                                    break;
                                                                }
                                                                let _e1326 = global_6.member[_e971];
                                                                phi_1801_ = _e1326;
                                                            } else {
                                                                phi_1801_ = 4294967295u;
                                                            }
                                                            let _e1328 = phi_1801_;
                                                            let _e1329 = (_e1328 < arrayLength((&global_7.member)));
                                                            if _e1329 {
                                                                if _e1329 {
                                                                } else {
                                                                    phi_3207_ = true;
                                                                    break;
                                                                }
                                                                let _e1331 = global_7.member[_e1328];
                                                                phi_1815_ = _e1331;
                                                            } else {
                                                                phi_1815_ = 0i;
                                                            }
                                                            let _e1333 = phi_1815_;
                                                            let _e1334 = (_e1333 == 0i);
                                                            if _e1334 {
                                                                phi_2106_ = true;
                                                            } else {
                                                                if _e386 {
                                                                    phi_1836_ = vec3<f32>(_e1038[0][0], _e1038[0][1], _e1038[0][2]);
                                                                } else {
                                                                    if (_e362 == 1u) {
                                                                        phi_1835_ = vec3<f32>(_e1038[0][2], _e1038[0][0], _e1038[0][1]);
                                                                    } else {
                                                                        phi_1835_ = vec3<f32>(_e1038[0][1], _e1038[0][2], _e1038[0][0]);
                                                                    }
                                                                    let _e1339 = phi_1835_;
                                                                    phi_1836_ = _e1339;
                                                                }
                                                                let _e1342 = phi_1836_;
                                                                if _e386 {
                                                                    phi_1853_ = vec3<f32>(_e1038[1][0], _e1038[1][1], _e1038[1][2]);
                                                                } else {
                                                                    if (_e362 == 1u) {
                                                                        phi_1852_ = vec3<f32>(_e1038[1][2], _e1038[1][0], _e1038[1][1]);
                                                                    } else {
                                                                        phi_1852_ = vec3<f32>(_e1038[1][1], _e1038[1][2], _e1038[1][0]);
                                                                    }
                                                                    let _e1347 = phi_1852_;
                                                                    phi_1853_ = _e1347;
                                                                }
                                                                let _e1350 = phi_1853_;
                                                                if _e386 {
                                                                    phi_1870_ = vec3<f32>(_e1038[2][0], _e1038[2][1], _e1038[2][2]);
                                                                } else {
                                                                    if (_e362 == 1u) {
                                                                        phi_1869_ = vec3<f32>(_e1038[2][2], _e1038[2][0], _e1038[2][1]);
                                                                    } else {
                                                                        phi_1869_ = vec3<f32>(_e1038[2][1], _e1038[2][2], _e1038[2][0]);
                                                                    }
                                                                    let _e1355 = phi_1869_;
                                                                    phi_1870_ = _e1355;
                                                                }
                                                                let _e1358 = phi_1870_;
                                                                let _e1361 = (_e1350.x - _e1342.x);
                                                                let _e1364 = (_e1350.y - _e1342.y);
                                                                let _e1367 = (_e1350.z - _e1342.z);
                                                                let _e1369 = (_e1358.x - _e1342.x);
                                                                let _e1371 = (_e1358.y - _e1342.y);
                                                                let _e1373 = (_e1358.z - _e1342.z);
                                                                if (_e229.member_1 == 1u) {
                                                                    phi_1906_ = (vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]) - _e1342);
                                                                } else {
                                                                    phi_1906_ = vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]);
                                                                }
                                                                let _e1388 = phi_1906_;
                                                                let _e1394 = bitcast<f32>((bitcast<u32>((_e1361 * _e1371)) ^ _e229.member_3[0]));
                                                                let _e1398 = bitcast<f32>((bitcast<u32>((_e1364 * _e1369)) ^ _e229.member_3[0]));
                                                                let _e1402 = bitcast<f32>((bitcast<u32>((_e1364 * _e1373)) ^ _e229.member_3[0]));
                                                                let _e1406 = bitcast<f32>((bitcast<u32>((_e1367 * _e1371)) ^ _e229.member_3[0]));
                                                                let _e1410 = bitcast<f32>((bitcast<u32>((_e1367 * _e1369)) ^ _e229.member_3[0]));
                                                                let _e1414 = bitcast<f32>((bitcast<u32>((_e1361 * _e1373)) ^ _e229.member_3[0]));
                                                                let _e1415 = (_e1402 - _e1406);
                                                                let _e1416 = (_e1410 - _e1414);
                                                                let _e1417 = (_e1394 - _e1398);
                                                                let _e1441 = (bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1406) & 2147483647u)));
                                                                let _e1448 = (bitcast<f32>((bitcast<u32>(_e1410) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1414) & 2147483647u)));
                                                                let _e1455 = (bitcast<f32>((bitcast<u32>(_e1394) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1398) & 2147483647u)));
                                                                if (_e229.member_2 == 0f) {
                                                                    phi_2088_ = 0f;
                                                                } else {
                                                                    let _e1485 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                                    let _e1488 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                                    let _e1491 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                    let _e1493 = select(_e1491, _e1488, (_e1488 > _e1491));
                                                                    let _e1497 = select(_e1491, _e1488, (_e1488 < _e1491));
                                                                    let _e1501 = select(_e1488, _e1485, (_e1485 < _e1488));
                                                                    let _e1503 = select(_e1488, _e1485, (_e1485 > _e1488));
                                                                    let _e1505 = select(_e1491, _e1503, (_e1503 < _e1491));
                                                                    phi_2088_ = bitcast<f32>((bitcast<u32>((_e229.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1493, _e1485, (_e1485 > _e1493)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1505, _e1501, (_e1501 > _e1505)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1497, _e1485, (_e1485 < _e1497)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1441 + _e1448) + _e1455))) ^ _e229.member_3[0]))) * 1.0000005f)) ^ _e229.member_3[0])))) ^ _e229.member_3[0]));
                                                                }
                                                                let _e1532 = phi_2088_;
                                                                phi_2106_ = (_e1334 || !(((((bitcast<f32>((bitcast<u32>((_e1388.x * _e1415)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1388.y * _e1416)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1388.z * _e1417)) ^ _e229.member_3[0]))) * f32(-(_e1333))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1388.x) & 2147483647u)) * _e1441)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1388.y) & 2147483647u)) * _e1448)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1388.z) & 2147483647u)) * _e1455)) ^ _e229.member_3[0]))))) ^ _e229.member_3[0])) + _e1532) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1546 = phi_2106_;
                                                            phi_2107_ = _e1546;
                                                        }
                                                        let _e1548 = phi_2107_;
                                                        if _e1548 {
                                                            phi_2112_ = type_46(_e942.member, true);
                                                        } else {
                                                            phi_2112_ = _e942;
                                                        }
                                                        let _e1553 = phi_2112_;
                                                        phi_2113_ = _e1553;
                                                    } else {
                                                        phi_2113_ = _e942;
                                                    }
                                                    let _e1555 = phi_2113_;
                                                    phi_1067_ = _e1555;
                                                } else {
                                                    phi_1067_ = type_46();
                                                }
                                                let _e1557 = phi_1067_;
                                                continue;
                                                continuing {
                                                    phi_1066_ = _e1557;
                                                    phi_1069_ = _e957;
                                                    phi_3207_ = _e572;
                                                    break if !(_e963);
                                                }
                                            }
                                            let _e1560 = phi_3207_;
                                            phi_3287_ = _e1560;
                                            if _e1560 {
                                                break;
                                            }
                                            let _e1562 = local_18;
                                            phi_3291_ = _e1560;
                                            let _e1750 = local_20;
                                            phi_2996_ = _e1750;
                                            phi_2997_ = _e613;
                                            phi_2998_ = false;
                                            phi_2999_ = select(_e617, 0u, _e1562.member_1);
                                        } else {
                                            local_8 = array<f32, 3>(_e613.member.member[0], _e613.member.member[1], _e613.member.member[2]);
                                            local_7 = array<f32, 3>(_e613.member.member_1[0], _e613.member.member_1[1], _e613.member.member_1[2]);
                                            let _e637 = (_e613.member_1 < _e98);
                                            if _e637 {
                                                if _e637 {
                                                } else {
                                                    phi_3287_ = true;
                                                    break;
                                                }
                                                let _e639 = global_10.member[_e613.member_1];
                                                phi_2148_ = _e639;
                                            } else {
                                                phi_2148_ = type_55(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e641 = phi_2148_;
                                            let _e643 = array<u32, 3>(_e362, _e361, _e363);
                                            local_15 = _e643;
                                            local_11 = array<f32, 3>(0f, 0f, 0f);
                                            local_10 = array<f32, 3>(0f, 0f, 0f);
                                            phi_2157_ = type_8(0u, 3u);
                                            loop {
                                                let _e645 = phi_2157_;
                                                if (_e645.member < _e645.member_1) {
                                                    phi_2158_ = type_8((_e645.member + 1u), _e645.member_1);
                                                    phi_2181_ = type_8(1u, _e645.member);
                                                } else {
                                                    phi_2158_ = _e645;
                                                    phi_2181_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e658 = phi_2158_;
                                                let _e660 = phi_2181_;
                                                let _e664 = (bitcast<i32>(_e660.member) != 0i);
                                                if _e664 {
                                                    let _e665 = (_e660.member_1 < 3u);
                                                    if _e665 {
                                                    } else {
                                                        phi_3132_ = true;
                                                        break;
                                                    }
                                                    let _e667 = local_15[_e660.member_1];
                                                    if _e665 {
                                                    } else {
                                                        phi_3132_ = true;
                                                        break;
                                                    }
                                                    let _e669 = local_8[_e660.member_1];
                                                    if _e665 {
                                                    } else {
                                                        phi_3132_ = true;
                                                        break;
                                                    }
                                                    let _e671 = local_7[_e660.member_1];
                                                    let _e674 = ((10u * _e667) & 31u);
                                                    let _e677 = ((_e641.member[0] >> bitcast<u32>(_e674)) & 1023u);
                                                    let _e682 = bitcast<f32>((bitcast<u32>(((_e671 - _e669) * 0.0009775171f)) ^ _e140));
                                                    let _e688 = (_e669 + bitcast<f32>((bitcast<u32>((f32(_e677) * _e682)) ^ _e140)));
                                                    if _e665 {
                                                    } else {
                                                        phi_3132_ = true;
                                                        break;
                                                    }
                                                    local_11[_e660.member_1] = select(select(_e671, _e688, (_e688 < _e671)), _e671, (_e677 == 1023u));
                                                    let _e697 = ((_e641.member[1] >> bitcast<u32>(_e674)) & 1023u);
                                                    let _e703 = (_e669 + bitcast<f32>((bitcast<u32>((f32(_e697) * _e682)) ^ _e140)));
                                                    if _e665 {
                                                    } else {
                                                        phi_3132_ = true;
                                                        break;
                                                    }
                                                    local_10[_e660.member_1] = select(select(_e671, _e703, (_e703 < _e671)), _e671, (_e697 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_2157_ = _e658;
                                                    phi_3132_ = _e572;
                                                    break if !(_e664);
                                                }
                                            }
                                            let _e711 = phi_3132_;
                                            phi_3287_ = _e711;
                                            if _e711 {
                                                break;
                                            }
                                            let _e712 = local_10;
                                            let _e713 = local_11;
                                            local_14 = _e643;
                                            local_13 = array<f32, 3>(0f, 0f, 0f);
                                            local_12 = array<f32, 3>(0f, 0f, 0f);
                                            phi_2311_ = type_8(0u, 3u);
                                            loop {
                                                let _e722 = phi_2311_;
                                                if (_e722.member < _e722.member_1) {
                                                    phi_2312_ = type_8((_e722.member + 1u), _e722.member_1);
                                                    phi_2335_ = type_8(1u, _e722.member);
                                                } else {
                                                    phi_2312_ = _e722;
                                                    phi_2335_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e735 = phi_2312_;
                                                let _e737 = phi_2335_;
                                                let _e741 = (bitcast<i32>(_e737.member) != 0i);
                                                if _e741 {
                                                    let _e742 = (_e737.member_1 < 3u);
                                                    if _e742 {
                                                    } else {
                                                        phi_3199_ = true;
                                                        break;
                                                    }
                                                    let _e744 = local_14[_e737.member_1];
                                                    if _e742 {
                                                    } else {
                                                        phi_3199_ = true;
                                                        break;
                                                    }
                                                    let _e746 = local_8[_e737.member_1];
                                                    if _e742 {
                                                    } else {
                                                        phi_3199_ = true;
                                                        break;
                                                    }
                                                    let _e748 = local_7[_e737.member_1];
                                                    let _e751 = ((10u * _e744) & 31u);
                                                    let _e754 = ((_e641.member_1[0] >> bitcast<u32>(_e751)) & 1023u);
                                                    let _e759 = bitcast<f32>((bitcast<u32>(((_e748 - _e746) * 0.0009775171f)) ^ _e140));
                                                    let _e765 = (_e746 + bitcast<f32>((bitcast<u32>((f32(_e754) * _e759)) ^ _e140)));
                                                    if _e742 {
                                                    } else {
                                                        phi_3199_ = true;
                                                        break;
                                                    }
                                                    local_13[_e737.member_1] = select(select(_e748, _e765, (_e765 < _e748)), _e748, (_e754 == 1023u));
                                                    let _e774 = ((_e641.member_1[1] >> bitcast<u32>(_e751)) & 1023u);
                                                    let _e780 = (_e746 + bitcast<f32>((bitcast<u32>((f32(_e774) * _e759)) ^ _e140)));
                                                    if _e742 {
                                                    } else {
                                                        phi_3199_ = true;
                                                        break;
                                                    }
                                                    local_12[_e737.member_1] = select(select(_e748, _e780, (_e780 < _e748)), _e748, (_e774 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_2311_ = _e735;
                                                    phi_3199_ = _e711;
                                                    break if !(_e741);
                                                }
                                            }
                                            let _e788 = phi_3199_;
                                            phi_3287_ = _e788;
                                            if _e788 {
                                                break;
                                            }
                                            let _e789 = local_12;
                                            let _e790 = local_13;
                                            let _e801 = type_63(type_61(array<f32, 3>(_e713[0], _e713[1], _e713[2]), array<f32, 3>(_e712[0], _e712[1], _e712[2])), _e641.member_2);
                                            let _e806 = type_63(type_61(array<f32, 3>(_e790[0], _e790[1], _e790[2]), array<f32, 3>(_e789[0], _e789[1], _e789[2])), _e641.member_3);
                                            let _e812 = ((_e713[0] - _e417) * _e422);
                                            let _e813 = ((_e790[0] - _e417) * _e422);
                                            let _e814 = ((_e712[0] - _e418) * _e422);
                                            let _e815 = ((_e789[0] - _e418) * _e422);
                                            let _e820 = ((_e713[1] - _e453) * _e458);
                                            let _e821 = ((_e790[1] - _e453) * _e458);
                                            let _e822 = ((_e712[1] - _e454) * _e458);
                                            let _e823 = ((_e789[1] - _e454) * _e458);
                                            let _e828 = ((_e713[2] - _e489) * _e494);
                                            let _e829 = ((_e790[2] - _e489) * _e494);
                                            let _e830 = ((_e712[2] - _e490) * _e494);
                                            let _e831 = ((_e789[2] - _e490) * _e494);
                                            let _e833 = select(_e830, _e828, (_e828 < _e830));
                                            let _e835 = select(_e831, _e829, (_e829 < _e831));
                                            let _e837 = select(_e830, _e828, (_e828 > _e830));
                                            let _e839 = select(_e831, _e829, (_e829 > _e831));
                                            let _e841 = select(_e814, _e812, (_e812 < _e814));
                                            let _e843 = select(_e815, _e813, (_e813 < _e815));
                                            let _e845 = select(_e822, _e820, (_e820 < _e822));
                                            let _e847 = select(_e823, _e821, (_e821 < _e823));
                                            let _e849 = select(_e845, _e841, (_e841 > _e845));
                                            let _e851 = select(_e847, _e843, (_e843 > _e847));
                                            let _e853 = select(_e833, _e849, (_e849 > _e833));
                                            let _e855 = select(_e835, _e851, (_e851 > _e835));
                                            let _e857 = select(_e814, _e812, (_e812 > _e814));
                                            let _e859 = select(_e815, _e813, (_e813 > _e815));
                                            let _e861 = select(_e822, _e820, (_e820 > _e822));
                                            let _e863 = select(_e823, _e821, (_e821 > _e823));
                                            let _e865 = select(_e861, _e857, (_e857 < _e861));
                                            let _e867 = select(_e863, _e859, (_e859 < _e863));
                                            let _e872 = -(_e833);
                                            let _e873 = -(_e835);
                                            let _e880 = (select(_e837, _e865, (_e865 < _e837)) + (select(_e872, _e837, (_e837 > _e872)) * 0.0000019073523f));
                                            let _e881 = (select(_e839, _e867, (_e867 < _e839)) + (select(_e873, _e839, (_e839 > _e873)) * 0.0000019073523f));
                                            let _e883 = select(_e540, _e853, (_e853 > _e540));
                                            let _e885 = select(_e540, _e855, (_e855 > _e540));
                                            let _e890 = (_e883 <= select(_e574.member, _e880, (_e880 < _e574.member)));
                                            let _e891 = (_e885 <= select(_e574.member, _e881, (_e881 < _e574.member)));
                                            let _e892 = (_e883 <= _e885);
                                            if _e890 {
                                                if _e891 {
                                                    if _e892 {
                                                        phi_2898_ = _e806;
                                                    } else {
                                                        phi_2898_ = _e801;
                                                    }
                                                    let _e894 = phi_2898_;
                                                    let _e902 = (_e617 % 128u);
                                                    let _e903 = (_e902 < 128u);
                                                    if _e903 {
                                                    } else {
                                                        phi_3287_ = true;
                                                        break;
                                                    }
                                                    local_6[_e902] = _e894.member_1;
                                                    if _e903 {
                                                    } else {
                                                        phi_3287_ = true;
                                                        break;
                                                    }
                                                    local_5[_e902] = _e894.member.member[0];
                                                    if _e903 {
                                                    } else {
                                                        phi_3287_ = true;
                                                        break;
                                                    }
                                                    local_4[_e902] = _e894.member.member[1];
                                                    if _e903 {
                                                    } else {
                                                        phi_3287_ = true;
                                                        break;
                                                    }
                                                    local_3[_e902] = _e894.member.member[2];
                                                    if _e903 {
                                                    } else {
                                                        phi_3287_ = true;
                                                        break;
                                                    }
                                                    local_2[_e902] = _e894.member.member_1[0];
                                                    if _e903 {
                                                    } else {
                                                        phi_3287_ = true;
                                                        break;
                                                    }
                                                    local_1[_e902] = _e894.member.member_1[1];
                                                    if _e903 {
                                                    } else {
                                                        phi_3287_ = true;
                                                        break;
                                                    }
                                                    local[_e902] = _e894.member.member_1[2];
                                                    if _e903 {
                                                    } else {
                                                        phi_3287_ = true;
                                                        break;
                                                    }
                                                    local_9[_e902] = select(_e885, _e883, (_e883 > _e885));
                                                    if _e892 {
                                                        phi_2975_ = _e801;
                                                    } else {
                                                        phi_2975_ = _e806;
                                                    }
                                                    let _e920 = phi_2975_;
                                                    phi_2976_ = _e920;
                                                    phi_2977_ = (_e617 + 1u);
                                                } else {
                                                    phi_2976_ = type_63();
                                                    phi_2977_ = u32();
                                                }
                                                let _e922 = phi_2976_;
                                                let _e924 = phi_2977_;
                                                phi_2979_ = _e922;
                                                phi_2980_ = _e924;
                                                phi_2981_ = select(true, false, _e891);
                                            } else {
                                                phi_2979_ = type_63();
                                                phi_2980_ = u32();
                                                phi_2981_ = true;
                                            }
                                            let _e927 = phi_2979_;
                                            let _e929 = phi_2980_;
                                            let _e931 = phi_2981_;
                                            if _e931 {
                                                if _e890 {
                                                    phi_2988_ = _e801;
                                                } else {
                                                    phi_2988_ = _e806;
                                                }
                                                let _e933 = phi_2988_;
                                                phi_2993_ = _e933;
                                                phi_2994_ = select(_e891, true, _e890);
                                            } else {
                                                phi_2993_ = _e927;
                                                phi_2994_ = _e615;
                                            }
                                            let _e936 = phi_2993_;
                                            let _e938 = phi_2994_;
                                            phi_3291_ = _e788;
                                            phi_2996_ = _e574;
                                            phi_2997_ = _e936;
                                            phi_2998_ = _e938;
                                            phi_2999_ = select(_e929, _e617, _e931);
                                        }
                                        let _e1566 = phi_3291_;
                                        let _e1568 = phi_2996_;
                                        let _e1570 = phi_2997_;
                                        let _e1572 = phi_2998_;
                                        let _e1574 = phi_2999_;
                                        phi_3290_ = _e1566;
                                        phi_3000_ = _e1568;
                                        phi_3001_ = _e1570;
                                        phi_3002_ = (_e578 - 1u);
                                        phi_3003_ = _e1572;
                                        phi_3004_ = _e1574;
                                    } else {
                                        phi_3290_ = _e572;
                                        phi_3000_ = _e574;
                                        phi_3001_ = _e613;
                                        phi_3002_ = _e578;
                                        phi_3003_ = _e615;
                                        phi_3004_ = _e617;
                                    }
                                    let _e1576 = phi_3290_;
                                    let _e1578 = phi_3000_;
                                    let _e1580 = phi_3001_;
                                    let _e1582 = phi_3002_;
                                    let _e1584 = phi_3003_;
                                    let _e1586 = phi_3004_;
                                    phi_3289_ = _e1576;
                                    phi_3005_ = _e1578;
                                    phi_3006_ = _e1580;
                                    phi_3007_ = _e1582;
                                    phi_3008_ = _e1584;
                                    phi_3009_ = _e1586;
                                } else {
                                    phi_3289_ = _e572;
                                    phi_3005_ = type_46();
                                    phi_3006_ = type_63();
                                    phi_3007_ = u32();
                                    phi_3008_ = bool();
                                    phi_3009_ = u32();
                                }
                                let _e1588 = phi_3289_;
                                let _e1590 = phi_3005_;
                                let _e1592 = phi_3006_;
                                let _e1594 = phi_3007_;
                                let _e1596 = phi_3008_;
                                let _e1598 = phi_3009_;
                                phi_3288_ = _e1588;
                                phi_941_ = _e1590;
                                phi_944_ = _e1592;
                                phi_946_ = _e1594;
                                phi_948_ = _e1596;
                                phi_950_ = _e1598;
                                phi_3010_ = _e586;
                            } else {
                                phi_3288_ = _e572;
                                phi_941_ = type_46();
                                phi_944_ = type_63();
                                phi_946_ = u32();
                                phi_948_ = bool();
                                phi_950_ = u32();
                                phi_3010_ = false;
                            }
                            let _e1600 = phi_3288_;
                            let _e1602 = phi_941_;
                            let _e1604 = phi_944_;
                            let _e1606 = phi_946_;
                            let _e1608 = phi_948_;
                            let _e1610 = phi_950_;
                            let _e1612 = phi_3010_;
                            continue;
                            continuing {
                                phi_3139_ = _e1600;
                                phi_940_ = _e1602;
                                phi_943_ = _e1604;
                                phi_945_ = _e1606;
                                phi_947_ = _e1608;
                                phi_949_ = _e1610;
                                phi_3287_ = _e1600;
                                break if !(_e1612);
                            }
                        }
                        let _e1615 = phi_3287_;
                        if _e1615 {
                            break;
                        }
                        let _e1617 = local_19;
                        if _e1617.member_1 {
                        } else {
                            if _e230 {
                            } else {
                                break;
                            }
                            let _e1621 = global_2.member[_e144];
                            if _e151 {
                            } else {
                                break;
                            }
                            let _e1625 = global_9.member[_e144].member_1;
                            if _e230 {
                            } else {
                                break;
                            }
                            global_2.member[_e144] = type_29(_e1621.member, _e1621.member_1, _e1621.member_2, array<f32, 3>((_e1621.member_3[0] + (_e1625[0] * _e1621.member_1[0])), (_e1621.member_3[1] + (_e1625[1] * _e1621.member_1[1])), (_e1621.member_3[2] + (_e1625[2] * _e1621.member_1[2]))), _e1621.member_4);
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
