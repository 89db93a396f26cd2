struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
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

struct type_31 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_36 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_47 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: f32,
    member_1: bool,
}

struct type_52 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_33;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_52;
@group(0) @binding(2) 
var<storage> global_4: type_38;
@group(0) @binding(3) 
var<storage, read_write> global_5: type_26;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_194_: u32;
    var phi_343_: i32;
    var phi_344_: i32;
    var phi_354_: bool;
    var phi_364_: u32;
    var phi_365_: u32;
    var phi_367_: bool;
    var phi_372_: u32;
    var phi_405_: i32;
    var phi_423_: f32;
    var phi_429_: f32;
    var phi_469_: f32;
    var phi_475_: f32;
    var phi_527_: f32;
    var phi_539_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_594_: f32;
    var phi_600_: f32;
    var phi_652_: f32;
    var phi_664_: f32;
    var phi_673_: f32;
    var phi_679_: f32;
    var phi_719_: f32;
    var phi_725_: f32;
    var phi_777_: f32;
    var phi_789_: f32;
    var phi_844_: i32;
    var phi_866_: u32;
    var phi_867_: u32;
    var phi_904_: i32;
    var phi_926_: u32;
    var phi_927_: u32;
    var phi_935_: f32;
    var phi_936_: f32;
    var phi_2648_: bool;
    var phi_951_: type_48;
    var phi_954_: u32;
    var phi_956_: bool;
    var phi_958_: u32;
    var phi_960_: u32;
    var phi_971_: bool;
    var phi_1003_: bool;
    var phi_1004_: u32;
    var phi_1005_: u32;
    var phi_1020_: type_48;
    var phi_1023_: type_7;
    var phi_1024_: type_7;
    var phi_1046_: type_7;
    var phi_1067_: u32;
    var phi_1159_: array<array<f32, 3>, 3>;
    var phi_1311_: bool;
    var phi_1340_: bool;
    var phi_1759_: f32;
    var phi_1760_: f32;
    var phi_1761_: f32;
    var phi_1762_: f32;
    var phi_1763_: vec3<f32>;
    var phi_1764_: vec3<f32>;
    var phi_1765_: vec3<f32>;
    var phi_1766_: vec3<f32>;
    var phi_1803_: bool;
    var phi_1812_: vec3<f32>;
    var phi_1977_: f32;
    var phi_1979_: f32;
    var phi_1980_: bool;
    var phi_2000_: f32;
    var phi_2001_: f32;
    var phi_2024_: type_22;
    var phi_2026_: type_22;
    var phi_2027_: bool;
    var phi_2031_: type_22;
    var phi_2032_: type_22;
    var phi_2033_: type_22;
    var phi_2034_: bool;
    var phi_2038_: type_22;
    var phi_2039_: bool;
    var phi_2040_: type_22;
    var phi_2041_: bool;
    var phi_2042_: bool;
    var phi_2043_: type_22;
    var phi_2044_: bool;
    var phi_2045_: bool;
    var phi_2053_: type_22;
    var phi_2054_: bool;
    var phi_2058_: type_22;
    var phi_2069_: type_48;
    var phi_2070_: type_48;
    var phi_1021_: type_48;
    var phi_2642_: bool;
    var phi_2838_: bool;
    var phi_2071_: type_48;
    var phi_2136_: type_47;
    var phi_2498_: u32;
    var phi_2525_: u32;
    var phi_2526_: u32;
    var phi_2527_: u32;
    var phi_2529_: u32;
    var phi_2530_: u32;
    var phi_2531_: bool;
    var phi_2540_: u32;
    var phi_2545_: bool;
    var phi_2547_: u32;
    var phi_2551_: bool;
    var phi_2552_: u32;
    var phi_2553_: u32;
    var phi_2563_: u32;
    var phi_2806_: bool;
    var phi_2565_: type_48;
    var phi_2566_: u32;
    var phi_2567_: bool;
    var phi_2568_: u32;
    var phi_2569_: u32;
    var phi_2805_: bool;
    var phi_2570_: type_48;
    var phi_2571_: u32;
    var phi_2572_: bool;
    var phi_2573_: u32;
    var phi_2574_: u32;
    var phi_2804_: bool;
    var phi_952_: type_48;
    var phi_955_: u32;
    var phi_957_: bool;
    var phi_959_: u32;
    var phi_961_: u32;
    var phi_2575_: bool;
    var phi_2803_: bool;
    var local_2: type_48;
    var local_3: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e70 = global;
            let _e72 = arrayLength((&global_2.member));
            let _e74 = arrayLength((&global_1.member));
            let _e80 = arrayLength((&global_3.member));
            let _e84 = (_e70.x + (_e70.y * 2097152u));
            let _e85 = (_e84 < arrayLength((&global_4.member)));
            if _e85 {
                if _e85 {
                } else {
                    break;
                }
                let _e89 = global_4.member[_e84].member_2;
                phi_194_ = _e89;
            } else {
                phi_194_ = 4294967295u;
            }
            let _e91 = phi_194_;
            if _e85 {
                let _e92 = (_e84 < arrayLength((&global_5.member)));
                if _e92 {
                    if _e85 {
                    } else {
                        break;
                    }
                    let _e97 = global_4.member[_e84].member.member_1;
                    let _e102 = global_4.member[_e84].member.member_3;
                    if (_e97 <= _e102) {
                        let _e104 = (1u < _e80);
                        if _e104 {
                            if (0u < _e80) {
                            } else {
                                break;
                            }
                            let _e108 = atomicAdd((&global_3.member[0u]), 1u);
                            if ((_e108 + 1u) < _e108) {
                                if _e104 {
                                } else {
                                    break;
                                }
                                let _e113 = atomicAdd((&global_3.member[1u]), 1u);
                            }
                        }
                        if _e85 {
                        } else {
                            break;
                        }
                        let _e123 = global_4.member[_e84].member.member_2[0u];
                        let _e125 = (bitcast<u32>(_e123) & 2147483647u);
                        let _e131 = global_4.member[_e84].member.member_2[1u];
                        let _e133 = (bitcast<u32>(_e131) & 2147483647u);
                        let _e139 = global_4.member[_e84].member.member_2[2u];
                        let _e141 = (bitcast<u32>(_e139) & 2147483647u);
                        let _e147 = global_4.member[_e84].member.member[0u];
                        let _e149 = (bitcast<u32>(_e147) & 2147483647u);
                        let _e155 = global_4.member[_e84].member.member[1u];
                        let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                        let _e163 = global_4.member[_e84].member.member[2u];
                        let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                        let _e167 = select(_e133, _e125, (_e133 < _e125));
                        let _e169 = select(_e141, _e167, (_e141 < _e167));
                        let _e171 = select(_e149, _e169, (_e149 < _e169));
                        let _e173 = select(_e157, _e171, (_e157 < _e171));
                        let _e175 = select(_e165, _e173, (_e165 < _e173));
                        let _e176 = bitcast<u32>(_e97);
                        let _e177 = (_e176 & 2147483647u);
                        let _e181 = bitcast<u32>(_e102);
                        let _e182 = (_e181 & 2147483647u);
                        let _e186 = (((select(_e177, _e175, (_e177 < _e175)) < 2139095040u) && (_e182 <= 2139095040u)) && (_e169 > 0u));
                        if _e186 {
                            let _e189 = (bitcast<u32>(bitcast<f32>(_e169)) & 2147483647u);
                            if (_e189 >= 8388608u) {
                                phi_343_ = (bitcast<i32>((_e189 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_343_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e189)), 32u, (_e189 == 0u))));
                            }
                            let _e203 = phi_343_;
                            phi_344_ = _e203;
                        } else {
                            phi_344_ = 0i;
                        }
                        let _e205 = phi_344_;
                        let _e206 = (_e125 == _e169);
                        if _e206 {
                            phi_354_ = true;
                        } else {
                            phi_354_ = (_e133 == _e169);
                        }
                        let _e209 = phi_354_;
                        let _e210 = select(1u, 0u, _e206);
                        if _e209 {
                            let _e211 = (_e210 + 1u);
                            phi_364_ = _e211;
                            phi_365_ = _e211;
                            phi_367_ = select(true, false, (_e211 == 2u));
                        } else {
                            phi_364_ = u32();
                            phi_365_ = 0u;
                            phi_367_ = true;
                        }
                        let _e215 = phi_364_;
                        let _e217 = phi_365_;
                        let _e219 = phi_367_;
                        if _e219 {
                            phi_372_ = (_e217 + 1u);
                        } else {
                            phi_372_ = 0u;
                        }
                        let _e223 = phi_372_;
                        let _e224 = select(_e215, _e217, _e219);
                        let _e225 = select(_e210, select(2u, _e210, _e209), _e219);
                        let _e226 = -(_e205);
                        if (_e226 < -126i) {
                            phi_405_ = -126i;
                        } else {
                            phi_405_ = select(_e226, 127i, (_e226 > 127i));
                        }
                        let _e231 = phi_405_;
                        let _e236 = bitcast<f32>((bitcast<u32>((_e231 + 127i)) << bitcast<u32>(23i)));
                        let _e242 = bitcast<f32>((bitcast<u32>(((_e226 - _e231) + 127i)) << bitcast<u32>(23i)));
                        let _e247 = global_4.member[_e84].member.member;
                        let _e248 = (_e224 == 0u);
                        if _e248 {
                            phi_423_ = _e247[0];
                        } else {
                            phi_423_ = _e247[1];
                        }
                        let _e252 = phi_423_;
                        let _e253 = (_e224 == 2u);
                        if _e253 {
                            phi_429_ = _e247[2];
                        } else {
                            phi_429_ = _e252;
                        }
                        let _e256 = phi_429_;
                        let _e257 = bitcast<u32>(_e256);
                        let _e259 = ((_e257 & 2139095040u) != 0u);
                        let _e271 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e257 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e257 & 2147483648u))), _e256, _e259) * select(0.00000011920929f, 1f, _e259));
                        let _e272 = global_4.member[_e84].member.member_2;
                        if _e248 {
                            phi_469_ = _e272[0];
                        } else {
                            phi_469_ = _e272[1];
                        }
                        let _e276 = phi_469_;
                        if _e253 {
                            phi_475_ = _e272[2];
                        } else {
                            phi_475_ = _e276;
                        }
                        let _e279 = phi_475_;
                        let _e280 = bitcast<u32>(_e279);
                        let _e282 = ((_e280 & 2139095040u) != 0u);
                        let _e296 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e280 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e280 & 2147483648u))), _e279, _e282) * _e236) * select(0.00000011920929f, 1f, _e282)) * _e242);
                        let _e300 = (bitcast<f32>((bitcast<u32>(_e296) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e300 {
                            let _e304 = (bitcast<f32>((bitcast<u32>(_e271) & 2147483647u)) * 0.00000011920929f);
                            phi_527_ = select(0.00000000000011368684f, _e304, (_e304 > 0.00000000000011368684f));
                        } else {
                            phi_527_ = 0f;
                        }
                        let _e308 = phi_527_;
                        let _e309 = (_e271 + _e308);
                        let _e310 = (_e271 - _e308);
                        let _e311 = select(_e296, 0f, _e300);
                        if _e300 {
                            phi_539_ = 38685626000000000000000000f;
                        } else {
                            phi_539_ = (1f / _e296);
                        }
                        let _e314 = phi_539_;
                        let _e315 = (_e223 == 0u);
                        if _e315 {
                            phi_548_ = _e247[0];
                        } else {
                            phi_548_ = _e247[1];
                        }
                        let _e319 = phi_548_;
                        let _e320 = (_e223 == 2u);
                        if _e320 {
                            phi_554_ = _e247[2];
                        } else {
                            phi_554_ = _e319;
                        }
                        let _e323 = phi_554_;
                        let _e324 = bitcast<u32>(_e323);
                        let _e326 = ((_e324 & 2139095040u) != 0u);
                        let _e338 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e324 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e324 & 2147483648u))), _e323, _e326) * select(0.00000011920929f, 1f, _e326));
                        if _e315 {
                            phi_594_ = _e272[0];
                        } else {
                            phi_594_ = _e272[1];
                        }
                        let _e342 = phi_594_;
                        if _e320 {
                            phi_600_ = _e272[2];
                        } else {
                            phi_600_ = _e342;
                        }
                        let _e345 = phi_600_;
                        let _e346 = bitcast<u32>(_e345);
                        let _e348 = ((_e346 & 2139095040u) != 0u);
                        let _e362 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e346 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e346 & 2147483648u))), _e345, _e348) * _e236) * select(0.00000011920929f, 1f, _e348)) * _e242);
                        let _e366 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e366 {
                            let _e370 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) * 0.00000011920929f);
                            phi_652_ = select(0.00000000000011368684f, _e370, (_e370 > 0.00000000000011368684f));
                        } else {
                            phi_652_ = 0f;
                        }
                        let _e374 = phi_652_;
                        let _e375 = (_e338 + _e374);
                        let _e376 = (_e338 - _e374);
                        let _e377 = select(_e362, 0f, _e366);
                        if _e366 {
                            phi_664_ = 38685626000000000000000000f;
                        } else {
                            phi_664_ = (1f / _e362);
                        }
                        let _e380 = phi_664_;
                        let _e381 = (_e225 == 0u);
                        if _e381 {
                            phi_673_ = _e247[0];
                        } else {
                            phi_673_ = _e247[1];
                        }
                        let _e385 = phi_673_;
                        let _e386 = (_e225 == 2u);
                        if _e386 {
                            phi_679_ = _e247[2];
                        } else {
                            phi_679_ = _e385;
                        }
                        let _e389 = phi_679_;
                        let _e390 = bitcast<u32>(_e389);
                        let _e392 = ((_e390 & 2139095040u) != 0u);
                        let _e404 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e390 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e390 & 2147483648u))), _e389, _e392) * select(0.00000011920929f, 1f, _e392));
                        if _e381 {
                            phi_719_ = _e272[0];
                        } else {
                            phi_719_ = _e272[1];
                        }
                        let _e408 = phi_719_;
                        if _e386 {
                            phi_725_ = _e272[2];
                        } else {
                            phi_725_ = _e408;
                        }
                        let _e411 = phi_725_;
                        let _e412 = bitcast<u32>(_e411);
                        let _e414 = ((_e412 & 2139095040u) != 0u);
                        let _e428 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e412 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e412 & 2147483648u))), _e411, _e414) * _e236) * select(0.00000011920929f, 1f, _e414)) * _e242);
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e428) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e432 {
                            let _e436 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) * 0.00000011920929f);
                            phi_777_ = select(0.00000000000011368684f, _e436, (_e436 > 0.00000000000011368684f));
                        } else {
                            phi_777_ = 0f;
                        }
                        let _e440 = phi_777_;
                        let _e441 = (_e404 + _e440);
                        let _e442 = (_e404 - _e440);
                        let _e443 = select(_e428, 0f, _e432);
                        if _e432 {
                            phi_789_ = 38685626000000000000000000f;
                        } else {
                            phi_789_ = (1f / _e428);
                        }
                        let _e446 = phi_789_;
                        let _e449 = bitcast<f32>((bitcast<u32>(_e271) & 2147483647u));
                        let _e452 = bitcast<f32>((bitcast<u32>(_e338) & 2147483647u));
                        let _e454 = select(_e452, _e449, (_e449 > _e452));
                        let _e457 = bitcast<f32>((bitcast<u32>(_e404) & 2147483647u));
                        if (_e186 && (select(_e457, _e454, (_e454 > _e457)) <= 1099511600000f)) {
                            let _e469 = ((_e177 & 8388607u) | (select(0u, 1u, ((_e177 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e472 = bitcast<i32>((_e177 >> bitcast<u32>(23i)));
                            let _e476 = (_e469 == 0u);
                            let _e479 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e469)), 32u, _e476)) - 8i);
                            if (_e472 == 255i) {
                                phi_844_ = 255i;
                            } else {
                                phi_844_ = (((_e472 + select(0i, 1i, (_e472 == 0i))) - _e479) + _e205);
                            }
                            let _e487 = phi_844_;
                            let _e497 = (_e487 <= 0i);
                            if _e497 {
                                phi_867_ = u32();
                            } else {
                                if _e476 {
                                    phi_866_ = u32();
                                } else {
                                    phi_866_ = select(((bitcast<u32>(_e487) << bitcast<u32>(23i)) | ((_e469 << bitcast<u32>(((_e479 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e487 >= 255i));
                                }
                                let _e501 = phi_866_;
                                phi_867_ = _e501;
                            }
                            let _e503 = phi_867_;
                            let _e515 = ((_e182 & 8388607u) | (select(0u, 1u, ((_e182 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e518 = bitcast<i32>((_e182 >> bitcast<u32>(23i)));
                            let _e522 = (_e515 == 0u);
                            let _e525 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e515)), 32u, _e522)) - 8i);
                            if (_e518 == 255i) {
                                phi_904_ = 255i;
                            } else {
                                phi_904_ = (((_e518 + select(0i, 1i, (_e518 == 0i))) - _e525) + _e205);
                            }
                            let _e533 = phi_904_;
                            let _e543 = (_e533 <= 0i);
                            if _e543 {
                                phi_927_ = u32();
                            } else {
                                if _e522 {
                                    phi_926_ = u32();
                                } else {
                                    phi_926_ = select(((bitcast<u32>(_e533) << bitcast<u32>(23i)) | ((_e515 << bitcast<u32>(((_e525 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e533 >= 255i));
                                }
                                let _e547 = phi_926_;
                                phi_927_ = _e547;
                            }
                            let _e549 = phi_927_;
                            phi_935_ = bitcast<f32>(((_e181 & 2147483648u) | select(_e549, 0u, select(_e522, true, _e543))));
                            phi_936_ = bitcast<f32>(((_e176 & 2147483648u) | select(_e503, 0u, select(_e476, true, _e497))));
                        } else {
                            phi_935_ = 0f;
                            phi_936_ = 1f;
                        }
                        let _e555 = phi_935_;
                        let _e557 = phi_936_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2648_ = false;
                        phi_951_ = type_48(_e555, false);
                        phi_954_ = ((3u * _e72) + 1u);
                        phi_956_ = (_e557 <= _e555);
                        phi_958_ = 0u;
                        phi_960_ = select(0u, 2147483648u, (_e72 == 0u));
                        loop {
                            let _e565 = phi_2648_;
                            let _e567 = phi_951_;
                            let _e569 = phi_954_;
                            let _e571 = phi_956_;
                            let _e573 = phi_958_;
                            let _e575 = phi_960_;
                            local_2 = _e567;
                            if _e571 {
                                phi_971_ = true;
                            } else {
                                phi_971_ = (_e573 > 0u);
                            }
                            let _e578 = phi_971_;
                            if _e578 {
                                let _e579 = (_e569 > 0u);
                                if _e579 {
                                    if _e571 {
                                        phi_1003_ = _e571;
                                        phi_1004_ = _e573;
                                        phi_1005_ = _e575;
                                    } else {
                                        let _e580 = (_e573 - 1u);
                                        let _e581 = (_e580 % 128u);
                                        let _e582 = (_e581 < 128u);
                                        if _e582 {
                                        } else {
                                            phi_2803_ = true;
                                            break;
                                        }
                                        let _e584 = local_1[_e581];
                                        if _e582 {
                                        } else {
                                            phi_2803_ = true;
                                            break;
                                        }
                                        let _e586 = local[_e581];
                                        phi_1003_ = (_e586 <= _e567.member);
                                        phi_1004_ = _e580;
                                        phi_1005_ = _e584;
                                    }
                                    let _e590 = phi_1003_;
                                    let _e592 = phi_1004_;
                                    let _e594 = phi_1005_;
                                    if _e590 {
                                        let _e597 = ((_e594 & 2147483648u) != 0u);
                                        if _e597 {
                                            phi_1020_ = _e567;
                                            phi_1023_ = type_7(0u, ((_e594 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e604 = phi_1020_;
                                                let _e606 = phi_1023_;
                                                local_3 = _e604;
                                                if (_e606.member < _e606.member_1) {
                                                    phi_1024_ = type_7((_e606.member + 1u), _e606.member_1);
                                                    phi_1046_ = type_7(1u, _e606.member);
                                                } else {
                                                    phi_1024_ = _e606;
                                                    phi_1046_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e619 = phi_1024_;
                                                let _e621 = phi_1046_;
                                                let _e625 = (bitcast<i32>(_e621.member) != 0i);
                                                if _e625 {
                                                    let _e626 = ((_e594 & 268435455u) + _e621.member_1);
                                                    let _e627 = (_e626 < _e74);
                                                    if _e627 {
                                                        if _e627 {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e631 = global_1.member[_e626].member_1;
                                                        phi_1067_ = _e631;
                                                    } else {
                                                        phi_1067_ = 4294967295u;
                                                    }
                                                    let _e633 = phi_1067_;
                                                    if (_e626 >= _e74) {
                                                        phi_1159_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e627 {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e635 = (_e224 % 3u);
                                                        let _e636 = (_e223 % 3u);
                                                        let _e637 = (_e225 % 3u);
                                                        if (_e635 < 9u) {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e643 = global_1.member[_e626].member[_e635];
                                                        if (_e636 < 9u) {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e649 = global_1.member[_e626].member[_e636];
                                                        if (_e637 < 9u) {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e655 = global_1.member[_e626].member[_e637];
                                                        let _e657 = (3u + _e635);
                                                        if (_e657 < 9u) {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e663 = global_1.member[_e626].member[_e657];
                                                        let _e664 = (3u + _e636);
                                                        if (_e664 < 9u) {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e670 = global_1.member[_e626].member[_e664];
                                                        let _e671 = (3u + _e637);
                                                        if (_e671 < 9u) {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e677 = global_1.member[_e626].member[_e671];
                                                        let _e679 = (6u + _e635);
                                                        if (_e679 < 9u) {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e685 = global_1.member[_e626].member[_e679];
                                                        let _e686 = (6u + _e636);
                                                        if (_e686 < 9u) {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e692 = global_1.member[_e626].member[_e686];
                                                        let _e693 = (6u + _e637);
                                                        if (_e693 < 9u) {
                                                        } else {
                                                            phi_2642_ = true;
                                                            break;
                                                        }
                                                        let _e699 = global_1.member[_e626].member[_e693];
                                                        phi_1159_ = array<array<f32, 3>, 3>(array<f32, 3>(_e643, _e649, _e655), array<f32, 3>(_e663, _e670, _e677), array<f32, 3>(_e685, _e692, _e699));
                                                    }
                                                    let _e703 = phi_1159_;
                                                    let _e711 = (_e703[0][2] - _e404);
                                                    let _e714 = (((_e703[0][0] - _e271) * _e443) - (_e711 * _e311));
                                                    let _e717 = (((_e703[0][1] - _e338) * _e443) - (_e711 * _e377));
                                                    let _e724 = (_e703[1][2] - _e404);
                                                    let _e727 = (((_e703[1][0] - _e271) * _e443) - (_e724 * _e311));
                                                    let _e730 = (((_e703[1][1] - _e338) * _e443) - (_e724 * _e377));
                                                    let _e737 = (_e703[2][2] - _e404);
                                                    let _e740 = (((_e703[2][0] - _e271) * _e443) - (_e737 * _e311));
                                                    let _e743 = (((_e703[2][1] - _e338) * _e443) - (_e737 * _e377));
                                                    let _e744 = (_e740 * _e730);
                                                    let _e745 = (_e743 * _e727);
                                                    let _e746 = (_e714 * _e743);
                                                    let _e747 = (_e717 * _e740);
                                                    let _e748 = (_e727 * _e717);
                                                    let _e749 = (_e730 * _e714);
                                                    let _e754 = (((_e744 >= _e745) && (_e746 >= _e747)) && (_e748 >= _e749));
                                                    if (_e754 || (((_e744 <= _e745) && (_e746 <= _e747)) && (_e748 <= _e749))) {
                                                        let _e761 = select(-1f, 1f, _e754);
                                                        let _e763 = ((_e744 - _e745) * _e761);
                                                        let _e765 = select(0f, _e763, (_e763 > 0f));
                                                        let _e767 = ((_e746 - _e747) * _e761);
                                                        let _e769 = select(0f, _e767, (_e767 > 0f));
                                                        let _e771 = ((_e748 - _e749) * _e761);
                                                        let _e773 = select(0f, _e771, (_e771 > 0f));
                                                        let _e775 = ((_e765 + _e769) + _e773);
                                                        if (_e775 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2043_ = type_22();
                                                            phi_2044_ = true;
                                                            phi_2045_ = false;
                                                        } else {
                                                            let _e778 = select(_e727, _e714, (_e714 < _e727));
                                                            if (select(_e740, _e778, (_e778 < _e740)) > 0f) {
                                                                phi_1311_ = true;
                                                            } else {
                                                                let _e783 = select(_e727, _e714, (_e714 > _e727));
                                                                phi_1311_ = (select(_e740, _e783, (_e783 > _e740)) < 0f);
                                                            }
                                                            let _e788 = phi_1311_;
                                                            if _e788 {
                                                                phi_2040_ = type_22();
                                                                phi_2041_ = true;
                                                                phi_2042_ = false;
                                                            } else {
                                                                let _e790 = select(_e730, _e717, (_e717 < _e730));
                                                                if (select(_e743, _e790, (_e790 < _e743)) > 0f) {
                                                                    phi_1340_ = true;
                                                                } else {
                                                                    let _e795 = select(_e730, _e717, (_e717 > _e730));
                                                                    phi_1340_ = (select(_e743, _e795, (_e795 > _e743)) < 0f);
                                                                }
                                                                let _e800 = phi_1340_;
                                                                if _e800 {
                                                                    phi_2038_ = type_22();
                                                                    phi_2039_ = false;
                                                                } else {
                                                                    let _e802 = select(_e703[1][0], _e703[0][0], (_e703[0][0] < _e703[1][0]));
                                                                    let _e806 = select(_e703[1][0], _e703[0][0], (_e703[0][0] > _e703[1][0]));
                                                                    let _e810 = select(_e703[1][1], _e703[0][1], (_e703[0][1] < _e703[1][1]));
                                                                    let _e814 = select(_e703[1][1], _e703[0][1], (_e703[0][1] > _e703[1][1]));
                                                                    let _e818 = select(_e703[1][2], _e703[0][2], (_e703[0][2] < _e703[1][2]));
                                                                    let _e822 = select(_e703[1][2], _e703[0][2], (_e703[0][2] > _e703[1][2]));
                                                                    let _e827 = ((select(_e703[2][0], _e802, (_e802 < _e703[2][0])) - _e309) * _e314);
                                                                    let _e828 = ((select(_e703[2][0], _e806, (_e806 > _e703[2][0])) - _e310) * _e314);
                                                                    let _e831 = ((select(_e703[2][1], _e810, (_e810 < _e703[2][1])) - _e375) * _e380);
                                                                    let _e832 = ((select(_e703[2][1], _e814, (_e814 > _e703[2][1])) - _e376) * _e380);
                                                                    let _e835 = ((select(_e703[2][2], _e818, (_e818 < _e703[2][2])) - _e441) * _e446);
                                                                    let _e836 = ((select(_e703[2][2], _e822, (_e822 > _e703[2][2])) - _e442) * _e446);
                                                                    let _e838 = select(_e836, _e835, (_e835 < _e836));
                                                                    let _e840 = select(_e836, _e835, (_e835 > _e836));
                                                                    let _e842 = select(_e828, _e827, (_e827 < _e828));
                                                                    let _e844 = select(_e832, _e831, (_e831 < _e832));
                                                                    let _e846 = select(_e844, _e842, (_e842 > _e844));
                                                                    let _e848 = select(_e838, _e846, (_e846 > _e838));
                                                                    let _e850 = select(_e828, _e827, (_e827 > _e828));
                                                                    let _e852 = select(_e832, _e831, (_e831 > _e832));
                                                                    let _e854 = select(_e852, _e850, (_e850 < _e852));
                                                                    let _e856 = select(_e840, _e854, (_e854 < _e840));
                                                                    let _e857 = -(_e838);
                                                                    let _e863 = select(_e557, _e848, (_e848 > _e557));
                                                                    if (_e863 > (_e856 + (select(_e857, _e840, (_e840 > _e857)) * 0.0000019073523f))) {
                                                                        phi_2033_ = type_22();
                                                                        phi_2034_ = true;
                                                                    } else {
                                                                        let _e865 = (_e863 > _e604.member);
                                                                        if _e865 {
                                                                            phi_2032_ = type_22();
                                                                        } else {
                                                                            let _e866 = vec3<f32>(_e703[0][0], _e703[0][1], _e703[0][2]);
                                                                            let _e867 = vec3<f32>(_e703[1][0], _e703[1][1], _e703[1][2]);
                                                                            let _e868 = vec3<f32>(_e703[2][0], _e703[2][1], _e703[2][2]);
                                                                            let _e869 = (_e703[1][0] - _e703[0][0]);
                                                                            let _e870 = (_e703[1][1] - _e703[0][1]);
                                                                            let _e871 = (_e703[1][2] - _e703[0][2]);
                                                                            let _e872 = vec3<f32>(_e869, _e870, _e871);
                                                                            let _e873 = (_e703[2][0] - _e703[1][0]);
                                                                            let _e874 = (_e703[2][1] - _e703[1][1]);
                                                                            let _e875 = (_e703[2][2] - _e703[1][2]);
                                                                            let _e876 = vec3<f32>(_e873, _e874, _e875);
                                                                            let _e877 = (_e703[0][0] - _e703[2][0]);
                                                                            let _e878 = (_e703[0][1] - _e703[2][1]);
                                                                            let _e879 = (_e703[0][2] - _e703[2][2]);
                                                                            let _e880 = vec3<f32>(_e877, _e878, _e879);
                                                                            let _e883 = bitcast<f32>((bitcast<u32>(_e869) & 2147483647u));
                                                                            let _e886 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                            let _e888 = select(_e886, _e883, (_e883 > _e886));
                                                                            let _e891 = bitcast<f32>((bitcast<u32>(_e871) & 2147483647u));
                                                                            let _e893 = select(_e891, _e888, (_e888 > _e891));
                                                                            let _e896 = bitcast<f32>((bitcast<u32>(_e873) & 2147483647u));
                                                                            let _e899 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                            let _e901 = select(_e899, _e896, (_e896 > _e899));
                                                                            let _e904 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                            let _e906 = select(_e904, _e901, (_e901 > _e904));
                                                                            let _e909 = bitcast<f32>((bitcast<u32>(_e877) & 2147483647u));
                                                                            let _e912 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                            let _e914 = select(_e912, _e909, (_e909 > _e912));
                                                                            let _e917 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                            let _e919 = select(_e917, _e914, (_e914 > _e917));
                                                                            let _e921 = select(_e906, _e893, (_e893 > _e906));
                                                                            let _e923 = select(_e919, _e921, (_e921 > _e919));
                                                                            if (_e893 == _e923) {
                                                                                phi_1759_ = _e730;
                                                                                phi_1760_ = _e727;
                                                                                phi_1761_ = _e717;
                                                                                phi_1762_ = _e714;
                                                                                phi_1763_ = _e866;
                                                                                phi_1764_ = _e880;
                                                                                phi_1765_ = _e876;
                                                                                phi_1766_ = _e872;
                                                                            } else {
                                                                                let _e925 = (_e906 == _e923);
                                                                                let _e930 = vec3(_e925);
                                                                                phi_1759_ = select(_e717, _e743, _e925);
                                                                                phi_1760_ = select(_e714, _e740, _e925);
                                                                                phi_1761_ = select(_e743, _e730, _e925);
                                                                                phi_1762_ = select(_e740, _e727, _e925);
                                                                                phi_1763_ = select(_e868, _e867, _e930);
                                                                                phi_1764_ = select(_e876, _e872, _e930);
                                                                                phi_1765_ = select(_e872, _e880, _e930);
                                                                                phi_1766_ = select(_e880, _e876, _e930);
                                                                            }
                                                                            let _e936 = phi_1759_;
                                                                            let _e938 = phi_1760_;
                                                                            let _e940 = phi_1761_;
                                                                            let _e942 = phi_1762_;
                                                                            let _e944 = phi_1763_;
                                                                            let _e946 = phi_1764_;
                                                                            let _e948 = phi_1765_;
                                                                            let _e950 = phi_1766_;
                                                                            let _e957 = ((_e948.y * _e946.z) - (_e946.y * _e948.z));
                                                                            let _e962 = ((_e948.z * _e946.x) - (_e946.z * _e948.x));
                                                                            let _e965 = ((_e948.x * _e946.y) - (_e946.x * _e948.y));
                                                                            if (_e765 >= _e769) {
                                                                                phi_1803_ = select(true, false, (_e765 >= _e773));
                                                                            } else {
                                                                                phi_1803_ = true;
                                                                            }
                                                                            let _e970 = phi_1803_;
                                                                            if _e970 {
                                                                                phi_1812_ = select(_e868, _e867, vec3((_e769 >= _e773)));
                                                                            } else {
                                                                                phi_1812_ = _e866;
                                                                            }
                                                                            let _e975 = phi_1812_;
                                                                            let _e986 = (((_e957 * (_e975.x - _e271)) + (_e962 * (_e975.y - _e338))) + (_e965 * (_e975.z - _e404)));
                                                                            let _e991 = (((_e957 * _e311) + (_e962 * _e377)) + (_e965 * _e443));
                                                                            let _e992 = (_e938 - _e942);
                                                                            let _e993 = (_e936 - _e940);
                                                                            let _e1001 = (-(((_e942 * _e992) + (_e940 * _e993))) / ((_e992 * _e992) + (_e993 * _e993)));
                                                                            let _e1003 = select(1f, _e1001, (_e1001 < 1f));
                                                                            let _e1005 = select(0f, _e1003, (_e1003 > 0f));
                                                                            let _e1018 = ((_e944.x + (_e950.x * _e1005)) - _e271);
                                                                            let _e1019 = ((_e944.y + (_e950.y * _e1005)) - _e338);
                                                                            let _e1020 = ((_e944.z + (_e950.z * _e1005)) - _e404);
                                                                            let _e1021 = (_e1020 / _e443);
                                                                            let _e1033 = bitcast<f32>((bitcast<u32>(_e1018) & 2147483647u));
                                                                            let _e1036 = bitcast<f32>((bitcast<u32>(_e1019) & 2147483647u));
                                                                            let _e1038 = select(_e1036, _e1033, (_e1033 > _e1036));
                                                                            let _e1041 = bitcast<f32>((bitcast<u32>(_e1020) & 2147483647u));
                                                                            let _e1043 = select(_e1041, _e1038, (_e1038 > _e1041));
                                                                            let _e1049 = bitcast<f32>((bitcast<u32>(_e957) & 2147483647u));
                                                                            let _e1052 = bitcast<f32>((bitcast<u32>(_e962) & 2147483647u));
                                                                            let _e1054 = select(_e1052, _e1049, (_e1049 > _e1052));
                                                                            let _e1057 = bitcast<f32>((bitcast<u32>(_e965) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e957 * _e1018) + (_e962 * _e1019)) + (_e965 * _e1020)) - _e986)) & 2147483647u)) <= ((0.0000009536743f * select(_e923, _e1043, (_e1043 > _e923))) * select(_e1057, _e1054, (_e1054 > _e1057)))) {
                                                                                let _e1067 = bitcast<f32>((bitcast<u32>(_e948.x) & 2147483647u));
                                                                                let _e1070 = bitcast<f32>((bitcast<u32>(_e948.y) & 2147483647u));
                                                                                let _e1072 = select(_e1070, _e1067, (_e1067 > _e1070));
                                                                                let _e1075 = bitcast<f32>((bitcast<u32>(_e948.z) & 2147483647u));
                                                                                let _e1081 = bitcast<f32>((bitcast<u32>(_e946.x) & 2147483647u));
                                                                                let _e1084 = bitcast<f32>((bitcast<u32>(_e946.y) & 2147483647u));
                                                                                let _e1086 = select(_e1084, _e1081, (_e1081 > _e1084));
                                                                                let _e1089 = bitcast<f32>((bitcast<u32>(_e946.z) & 2147483647u));
                                                                                let _e1093 = (bitcast<f32>((bitcast<u32>(_e991) & 2147483647u)) > ((0.0000038146973f * select(_e1075, _e1072, (_e1072 > _e1075))) * select(_e1089, _e1086, (_e1086 > _e1089))));
                                                                                if _e1093 {
                                                                                    phi_1977_ = (_e986 / _e991);
                                                                                } else {
                                                                                    phi_1977_ = f32();
                                                                                }
                                                                                let _e1096 = phi_1977_;
                                                                                phi_1979_ = _e1096;
                                                                                phi_1980_ = select(true, false, _e1093);
                                                                            } else {
                                                                                phi_1979_ = f32();
                                                                                phi_1980_ = true;
                                                                            }
                                                                            let _e1099 = phi_1979_;
                                                                            let _e1101 = phi_1980_;
                                                                            if _e1101 {
                                                                                let _e1109 = (((_e957 * (_e1018 - (_e311 * _e1021))) + (_e962 * (_e1019 - (_e377 * _e1021)))) / _e991);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1109) & 2147483647u)) <= _e923) {
                                                                                    phi_2000_ = (_e1021 + _e1109);
                                                                                } else {
                                                                                    phi_2000_ = _e1021;
                                                                                }
                                                                                let _e1116 = phi_2000_;
                                                                                phi_2001_ = _e1116;
                                                                            } else {
                                                                                phi_2001_ = _e1099;
                                                                            }
                                                                            let _e1118 = phi_2001_;
                                                                            let _e1120 = select(_e856, _e1118, (_e1118 < _e856));
                                                                            let _e1122 = select(_e848, _e1120, (_e1120 > _e848));
                                                                            if (_e1122 >= _e557) {
                                                                                let _e1124 = (_e1122 <= _e604.member);
                                                                                if _e1124 {
                                                                                    let _e1125 = (1f / _e775);
                                                                                    phi_2024_ = type_22(_e1122, (_e769 * _e1125), (_e773 * _e1125), _e633);
                                                                                } else {
                                                                                    phi_2024_ = type_22();
                                                                                }
                                                                                let _e1130 = phi_2024_;
                                                                                phi_2026_ = _e1130;
                                                                                phi_2027_ = select(true, false, _e1124);
                                                                            } else {
                                                                                phi_2026_ = type_22();
                                                                                phi_2027_ = true;
                                                                            }
                                                                            let _e1133 = phi_2026_;
                                                                            let _e1135 = phi_2027_;
                                                                            if _e1135 {
                                                                                phi_2031_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2031_ = _e1133;
                                                                            }
                                                                            let _e1137 = phi_2031_;
                                                                            phi_2032_ = _e1137;
                                                                        }
                                                                        let _e1139 = phi_2032_;
                                                                        phi_2033_ = _e1139;
                                                                        phi_2034_ = _e865;
                                                                    }
                                                                    let _e1141 = phi_2033_;
                                                                    let _e1143 = phi_2034_;
                                                                    phi_2038_ = _e1141;
                                                                    phi_2039_ = _e1143;
                                                                }
                                                                let _e1145 = phi_2038_;
                                                                let _e1147 = phi_2039_;
                                                                phi_2040_ = _e1145;
                                                                phi_2041_ = _e800;
                                                                phi_2042_ = _e1147;
                                                            }
                                                            let _e1149 = phi_2040_;
                                                            let _e1151 = phi_2041_;
                                                            let _e1153 = phi_2042_;
                                                            phi_2043_ = _e1149;
                                                            phi_2044_ = _e1151;
                                                            phi_2045_ = _e1153;
                                                        }
                                                        let _e1155 = phi_2043_;
                                                        let _e1157 = phi_2044_;
                                                        let _e1159 = phi_2045_;
                                                        phi_2053_ = _e1155;
                                                        phi_2054_ = select(_e1159, true, _e1157);
                                                    } else {
                                                        phi_2053_ = type_22();
                                                        phi_2054_ = true;
                                                    }
                                                    let _e1162 = phi_2053_;
                                                    let _e1164 = phi_2054_;
                                                    if _e1164 {
                                                        phi_2058_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2058_ = _e1162;
                                                    }
                                                    let _e1166 = phi_2058_;
                                                    if (_e1166.member_3 != 4294967295u) {
                                                        if (_e633 != _e91) {
                                                            phi_2069_ = type_48(_e604.member, true);
                                                        } else {
                                                            phi_2069_ = _e604;
                                                        }
                                                        let _e1174 = phi_2069_;
                                                        phi_2070_ = _e1174;
                                                    } else {
                                                        phi_2070_ = _e604;
                                                    }
                                                    let _e1176 = phi_2070_;
                                                    phi_1021_ = _e1176;
                                                } else {
                                                    phi_1021_ = type_48();
                                                }
                                                let _e1178 = phi_1021_;
                                                continue;
                                                continuing {
                                                    phi_1020_ = _e1178;
                                                    phi_1023_ = _e619;
                                                    phi_2642_ = _e565;
                                                    break if !(_e625);
                                                }
                                            }
                                            let _e1181 = phi_2642_;
                                            phi_2803_ = _e1181;
                                            if _e1181 {
                                                break;
                                            }
                                            phi_2838_ = _e1181;
                                            let _e1551 = local_3;
                                            phi_2071_ = _e1551;
                                        } else {
                                            phi_2838_ = _e565;
                                            phi_2071_ = _e567;
                                        }
                                        let _e1183 = phi_2838_;
                                        let _e1185 = phi_2071_;
                                        if _e597 {
                                            phi_2551_ = bool();
                                            phi_2552_ = u32();
                                            phi_2553_ = u32();
                                        } else {
                                            if (_e594 >= _e72) {
                                                phi_2136_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e594 < _e72) {
                                                } else {
                                                    phi_2803_ = true;
                                                    break;
                                                }
                                                let _e1188 = (_e224 % 3u);
                                                if (_e1188 < 3u) {
                                                } else {
                                                    phi_2803_ = true;
                                                    break;
                                                }
                                                let _e1194 = global_2.member[_e594].member[_e1188];
                                                let _e1200 = (_e223 % 3u);
                                                if (_e1200 < 3u) {
                                                } else {
                                                    phi_2803_ = true;
                                                    break;
                                                }
                                                let _e1206 = global_2.member[_e594].member[_e1200];
                                                let _e1212 = (_e225 % 3u);
                                                if (_e1212 < 3u) {
                                                } else {
                                                    phi_2803_ = true;
                                                    break;
                                                }
                                                let _e1218 = global_2.member[_e594].member[_e1212];
                                                let _e1228 = global_2.member[_e594].member_1;
                                                let _e1232 = global_2.member[_e594].member_2;
                                                phi_2136_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e1194[0], _e1194[1], _e1194[2], _e1194[3]), vec4<f32>(_e1206[0], _e1206[1], _e1206[2], _e1206[3]), vec4<f32>(_e1218[0], _e1218[1], _e1218[2], _e1218[3])), _e1228, _e1232);
                                            }
                                            let _e1235 = phi_2136_;
                                            let _e1247 = ((_e1235.member[0].x - _e309) * _e314);
                                            let _e1248 = ((_e1235.member[0].y - _e309) * _e314);
                                            let _e1249 = ((_e1235.member[0].z - _e310) * _e314);
                                            let _e1250 = ((_e1235.member[0].w - _e310) * _e314);
                                            let _e1260 = ((_e1235.member[1].x - _e375) * _e380);
                                            let _e1261 = ((_e1235.member[1].y - _e375) * _e380);
                                            let _e1262 = ((_e1235.member[1].z - _e376) * _e380);
                                            let _e1263 = ((_e1235.member[1].w - _e376) * _e380);
                                            let _e1273 = ((_e1235.member[2].x - _e441) * _e446);
                                            let _e1274 = ((_e1235.member[2].y - _e441) * _e446);
                                            let _e1275 = ((_e1235.member[2].z - _e442) * _e446);
                                            let _e1276 = ((_e1235.member[2].w - _e442) * _e446);
                                            let _e1278 = select(_e1275, _e1273, (_e1273 < _e1275));
                                            let _e1280 = select(_e1276, _e1274, (_e1274 < _e1276));
                                            let _e1282 = select(_e1275, _e1273, (_e1273 > _e1275));
                                            let _e1284 = select(_e1276, _e1274, (_e1274 > _e1276));
                                            let _e1286 = select(_e1249, _e1247, (_e1247 < _e1249));
                                            let _e1288 = select(_e1250, _e1248, (_e1248 < _e1250));
                                            let _e1290 = select(_e1262, _e1260, (_e1260 < _e1262));
                                            let _e1292 = select(_e1263, _e1261, (_e1261 < _e1263));
                                            let _e1294 = select(_e1290, _e1286, (_e1286 > _e1290));
                                            let _e1296 = select(_e1292, _e1288, (_e1288 > _e1292));
                                            let _e1298 = select(_e1278, _e1294, (_e1294 > _e1278));
                                            let _e1300 = select(_e1280, _e1296, (_e1296 > _e1280));
                                            let _e1302 = select(_e1249, _e1247, (_e1247 > _e1249));
                                            let _e1304 = select(_e1250, _e1248, (_e1248 > _e1250));
                                            let _e1306 = select(_e1262, _e1260, (_e1260 > _e1262));
                                            let _e1308 = select(_e1263, _e1261, (_e1261 > _e1263));
                                            let _e1310 = select(_e1306, _e1302, (_e1302 < _e1306));
                                            let _e1312 = select(_e1308, _e1304, (_e1304 < _e1308));
                                            let _e1317 = -(_e1278);
                                            let _e1318 = -(_e1280);
                                            let _e1325 = (select(_e1282, _e1310, (_e1310 < _e1282)) + (select(_e1317, _e1282, (_e1282 > _e1317)) * 0.0000019073523f));
                                            let _e1326 = (select(_e1284, _e1312, (_e1312 < _e1284)) + (select(_e1318, _e1284, (_e1284 > _e1318)) * 0.0000019073523f));
                                            let _e1328 = select(_e557, _e1298, (_e1298 > _e557));
                                            let _e1330 = select(_e557, _e1300, (_e1300 > _e557));
                                            let _e1335 = (_e1328 <= select(_e1185.member, _e1325, (_e1325 < _e1185.member)));
                                            let _e1336 = (_e1330 <= select(_e1185.member, _e1326, (_e1326 < _e1185.member)));
                                            let _e1337 = (_e1328 <= _e1330);
                                            if _e1335 {
                                                if _e1336 {
                                                    if _e1337 {
                                                        phi_2498_ = _e1235.member_2;
                                                    } else {
                                                        phi_2498_ = _e1235.member_1;
                                                    }
                                                    let _e1341 = phi_2498_;
                                                    let _e1343 = (_e592 % 128u);
                                                    let _e1344 = (_e1343 < 128u);
                                                    if _e1344 {
                                                    } else {
                                                        phi_2803_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1343] = _e1341;
                                                    if _e1344 {
                                                    } else {
                                                        phi_2803_ = true;
                                                        break;
                                                    }
                                                    local[_e1343] = select(_e1328, _e1330, _e1337);
                                                    if _e1337 {
                                                        phi_2525_ = _e1235.member_1;
                                                    } else {
                                                        phi_2525_ = _e1235.member_2;
                                                    }
                                                    let _e1351 = phi_2525_;
                                                    phi_2526_ = (_e592 + 1u);
                                                    phi_2527_ = _e1351;
                                                } else {
                                                    phi_2526_ = u32();
                                                    phi_2527_ = u32();
                                                }
                                                let _e1353 = phi_2526_;
                                                let _e1355 = phi_2527_;
                                                phi_2529_ = _e1353;
                                                phi_2530_ = _e1355;
                                                phi_2531_ = select(true, false, _e1336);
                                            } else {
                                                phi_2529_ = u32();
                                                phi_2530_ = u32();
                                                phi_2531_ = true;
                                            }
                                            let _e1358 = phi_2529_;
                                            let _e1360 = phi_2530_;
                                            let _e1362 = phi_2531_;
                                            if _e1362 {
                                                if _e1335 {
                                                    phi_2540_ = _e1235.member_1;
                                                } else {
                                                    phi_2540_ = _e1235.member_2;
                                                }
                                                let _e1366 = phi_2540_;
                                                phi_2545_ = select(_e1336, true, _e1335);
                                                phi_2547_ = _e1366;
                                            } else {
                                                phi_2545_ = _e590;
                                                phi_2547_ = _e1360;
                                            }
                                            let _e1369 = phi_2545_;
                                            let _e1371 = phi_2547_;
                                            phi_2551_ = _e1369;
                                            phi_2552_ = select(_e1358, _e592, _e1362);
                                            phi_2553_ = _e1371;
                                        }
                                        let _e1374 = phi_2551_;
                                        let _e1376 = phi_2552_;
                                        let _e1378 = phi_2553_;
                                        if _e597 {
                                            phi_2563_ = select(_e592, 0u, _e1185.member_1);
                                        } else {
                                            phi_2563_ = _e1376;
                                        }
                                        let _e1382 = phi_2563_;
                                        phi_2806_ = _e1183;
                                        phi_2565_ = _e1185;
                                        phi_2566_ = (_e569 - 1u);
                                        phi_2567_ = select(_e1374, false, _e597);
                                        phi_2568_ = _e1382;
                                        phi_2569_ = select(_e1378, _e594, _e597);
                                    } else {
                                        phi_2806_ = _e565;
                                        phi_2565_ = _e567;
                                        phi_2566_ = _e569;
                                        phi_2567_ = _e590;
                                        phi_2568_ = _e592;
                                        phi_2569_ = _e594;
                                    }
                                    let _e1386 = phi_2806_;
                                    let _e1388 = phi_2565_;
                                    let _e1390 = phi_2566_;
                                    let _e1392 = phi_2567_;
                                    let _e1394 = phi_2568_;
                                    let _e1396 = phi_2569_;
                                    phi_2805_ = _e1386;
                                    phi_2570_ = _e1388;
                                    phi_2571_ = _e1390;
                                    phi_2572_ = _e1392;
                                    phi_2573_ = _e1394;
                                    phi_2574_ = _e1396;
                                } else {
                                    phi_2805_ = _e565;
                                    phi_2570_ = type_48();
                                    phi_2571_ = u32();
                                    phi_2572_ = bool();
                                    phi_2573_ = u32();
                                    phi_2574_ = u32();
                                }
                                let _e1398 = phi_2805_;
                                let _e1400 = phi_2570_;
                                let _e1402 = phi_2571_;
                                let _e1404 = phi_2572_;
                                let _e1406 = phi_2573_;
                                let _e1408 = phi_2574_;
                                phi_2804_ = _e1398;
                                phi_952_ = _e1400;
                                phi_955_ = _e1402;
                                phi_957_ = _e1404;
                                phi_959_ = _e1406;
                                phi_961_ = _e1408;
                                phi_2575_ = _e579;
                            } else {
                                phi_2804_ = _e565;
                                phi_952_ = type_48();
                                phi_955_ = u32();
                                phi_957_ = bool();
                                phi_959_ = u32();
                                phi_961_ = u32();
                                phi_2575_ = false;
                            }
                            let _e1410 = phi_2804_;
                            let _e1412 = phi_952_;
                            let _e1414 = phi_955_;
                            let _e1416 = phi_957_;
                            let _e1418 = phi_959_;
                            let _e1420 = phi_961_;
                            let _e1422 = phi_2575_;
                            continue;
                            continuing {
                                phi_2648_ = _e1410;
                                phi_951_ = _e1412;
                                phi_954_ = _e1414;
                                phi_956_ = _e1416;
                                phi_958_ = _e1418;
                                phi_960_ = _e1420;
                                phi_2803_ = _e1410;
                                break if !(_e1422);
                            }
                        }
                        let _e1425 = phi_2803_;
                        if _e1425 {
                            break;
                        }
                        let _e1427 = local_2;
                        if _e1427.member_1 {
                        } else {
                            if _e92 {
                            } else {
                                break;
                            }
                            let _e1431 = global_5.member[_e84];
                            if _e85 {
                            } else {
                                break;
                            }
                            let _e1435 = global_4.member[_e84].member_1;
                            if _e92 {
                            } else {
                                break;
                            }
                            global_5.member[_e84] = type_24(_e1431.member, _e1431.member_1, _e1431.member_2, array<f32, 3>((_e1431.member_3[0] + (_e1435[0] * _e1431.member_1[0])), (_e1431.member_3[1] + (_e1435[1] * _e1431.member_1[1])), (_e1431.member_3[2] + (_e1435[2] * _e1431.member_1[2]))), _e1431.member_4);
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
fn trace_shadows(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
