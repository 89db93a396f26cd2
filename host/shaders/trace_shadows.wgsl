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
    var phi_2645_: bool;
    var phi_951_: type_48;
    var phi_954_: bool;
    var phi_956_: u32;
    var phi_958_: u32;
    var phi_960_: u32;
    var phi_971_: bool;
    var phi_1003_: bool;
    var phi_1004_: u32;
    var phi_1005_: u32;
    var phi_2142_: type_47;
    var phi_2504_: u32;
    var phi_2532_: u32;
    var phi_2533_: u32;
    var phi_2534_: u32;
    var phi_2536_: u32;
    var phi_2537_: u32;
    var phi_2538_: bool;
    var phi_2547_: u32;
    var phi_2552_: bool;
    var phi_2554_: u32;
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
    var phi_2639_: bool;
    var local_2: type_48;
    var phi_2804_: bool;
    var phi_2558_: type_48;
    var phi_2559_: bool;
    var phi_2560_: u32;
    var phi_2561_: u32;
    var phi_2803_: bool;
    var phi_2562_: type_48;
    var phi_2563_: bool;
    var phi_2564_: u32;
    var phi_2565_: u32;
    var phi_2566_: u32;
    var phi_2802_: bool;
    var phi_2567_: type_48;
    var phi_2568_: bool;
    var phi_2569_: u32;
    var phi_2570_: u32;
    var phi_2571_: u32;
    var phi_2801_: bool;
    var phi_952_: type_48;
    var phi_955_: bool;
    var phi_957_: u32;
    var phi_959_: u32;
    var phi_961_: u32;
    var phi_2572_: bool;
    var phi_2800_: bool;
    var local_3: type_48;
    var local_4: type_48;

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
                        phi_2645_ = false;
                        phi_951_ = type_48(_e555, false);
                        phi_954_ = (_e557 <= _e555);
                        phi_956_ = ((3u * _e72) + 1u);
                        phi_958_ = 0u;
                        phi_960_ = select(0u, 2147483648u, (_e72 == 0u));
                        loop {
                            let _e565 = phi_2645_;
                            let _e567 = phi_951_;
                            let _e569 = phi_954_;
                            let _e571 = phi_956_;
                            let _e573 = phi_958_;
                            let _e575 = phi_960_;
                            local_3 = _e567;
                            if _e569 {
                                phi_971_ = true;
                            } else {
                                phi_971_ = (_e573 > 0u);
                            }
                            let _e578 = phi_971_;
                            if _e578 {
                                let _e579 = (_e571 > 0u);
                                if _e579 {
                                    if _e569 {
                                        phi_1003_ = _e569;
                                        phi_1004_ = _e573;
                                        phi_1005_ = _e575;
                                    } else {
                                        let _e580 = (_e573 - 1u);
                                        let _e581 = (_e580 % 128u);
                                        let _e582 = (_e581 < 128u);
                                        if _e582 {
                                        } else {
                                            phi_2800_ = true;
                                            break;
                                        }
                                        let _e584 = local_1[_e581];
                                        if _e582 {
                                        } else {
                                            phi_2800_ = true;
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
                                        if ((_e594 & 2147483648u) != 0u) {
                                            phi_1020_ = _e567;
                                            phi_1023_ = type_7(0u, ((_e594 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e792 = phi_1020_;
                                                let _e794 = phi_1023_;
                                                local_2 = _e792;
                                                local_4 = _e792;
                                                if (_e794.member < _e794.member_1) {
                                                    phi_1024_ = type_7((_e794.member + 1u), _e794.member_1);
                                                    phi_1046_ = type_7(1u, _e794.member);
                                                } else {
                                                    phi_1024_ = _e794;
                                                    phi_1046_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e807 = phi_1024_;
                                                let _e809 = phi_1046_;
                                                let _e813 = (bitcast<i32>(_e809.member) != 0i);
                                                if _e813 {
                                                    let _e814 = ((_e594 & 268435455u) + _e809.member_1);
                                                    let _e815 = (_e814 < _e74);
                                                    if _e815 {
                                                        if _e815 {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e819 = global_1.member[_e814].member_1;
                                                        phi_1067_ = _e819;
                                                    } else {
                                                        phi_1067_ = 4294967295u;
                                                    }
                                                    let _e821 = phi_1067_;
                                                    if (_e814 >= _e74) {
                                                        phi_1159_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e815 {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e823 = (_e224 % 3u);
                                                        let _e824 = (_e223 % 3u);
                                                        let _e825 = (_e225 % 3u);
                                                        if (_e823 < 9u) {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e831 = global_1.member[_e814].member[_e823];
                                                        if (_e824 < 9u) {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e837 = global_1.member[_e814].member[_e824];
                                                        if (_e825 < 9u) {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e843 = global_1.member[_e814].member[_e825];
                                                        let _e845 = (3u + _e823);
                                                        if (_e845 < 9u) {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e851 = global_1.member[_e814].member[_e845];
                                                        let _e852 = (3u + _e824);
                                                        if (_e852 < 9u) {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e858 = global_1.member[_e814].member[_e852];
                                                        let _e859 = (3u + _e825);
                                                        if (_e859 < 9u) {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e865 = global_1.member[_e814].member[_e859];
                                                        let _e867 = (6u + _e823);
                                                        if (_e867 < 9u) {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e873 = global_1.member[_e814].member[_e867];
                                                        let _e874 = (6u + _e824);
                                                        if (_e874 < 9u) {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e880 = global_1.member[_e814].member[_e874];
                                                        let _e881 = (6u + _e825);
                                                        if (_e881 < 9u) {
                                                        } else {
                                                            phi_2639_ = true;
                                                            break;
                                                        }
                                                        let _e887 = global_1.member[_e814].member[_e881];
                                                        phi_1159_ = array<array<f32, 3>, 3>(array<f32, 3>(_e831, _e837, _e843), array<f32, 3>(_e851, _e858, _e865), array<f32, 3>(_e873, _e880, _e887));
                                                    }
                                                    let _e891 = phi_1159_;
                                                    let _e899 = (_e891[0][2] - _e404);
                                                    let _e902 = (((_e891[0][0] - _e271) * _e443) - (_e899 * _e311));
                                                    let _e905 = (((_e891[0][1] - _e338) * _e443) - (_e899 * _e377));
                                                    let _e912 = (_e891[1][2] - _e404);
                                                    let _e915 = (((_e891[1][0] - _e271) * _e443) - (_e912 * _e311));
                                                    let _e918 = (((_e891[1][1] - _e338) * _e443) - (_e912 * _e377));
                                                    let _e925 = (_e891[2][2] - _e404);
                                                    let _e928 = (((_e891[2][0] - _e271) * _e443) - (_e925 * _e311));
                                                    let _e931 = (((_e891[2][1] - _e338) * _e443) - (_e925 * _e377));
                                                    let _e932 = (_e928 * _e918);
                                                    let _e933 = (_e931 * _e915);
                                                    let _e934 = (_e902 * _e931);
                                                    let _e935 = (_e905 * _e928);
                                                    let _e936 = (_e915 * _e905);
                                                    let _e937 = (_e918 * _e902);
                                                    let _e942 = (((_e932 >= _e933) && (_e934 >= _e935)) && (_e936 >= _e937));
                                                    if (_e942 || (((_e932 <= _e933) && (_e934 <= _e935)) && (_e936 <= _e937))) {
                                                        let _e949 = select(-1f, 1f, _e942);
                                                        let _e951 = ((_e932 - _e933) * _e949);
                                                        let _e953 = select(0f, _e951, (_e951 > 0f));
                                                        let _e955 = ((_e934 - _e935) * _e949);
                                                        let _e957 = select(0f, _e955, (_e955 > 0f));
                                                        let _e959 = ((_e936 - _e937) * _e949);
                                                        let _e961 = select(0f, _e959, (_e959 > 0f));
                                                        let _e963 = ((_e953 + _e957) + _e961);
                                                        if (_e963 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2043_ = type_22();
                                                            phi_2044_ = true;
                                                            phi_2045_ = false;
                                                        } else {
                                                            let _e966 = select(_e915, _e902, (_e902 < _e915));
                                                            if (select(_e928, _e966, (_e966 < _e928)) > 0f) {
                                                                phi_1311_ = true;
                                                            } else {
                                                                let _e971 = select(_e915, _e902, (_e902 > _e915));
                                                                phi_1311_ = (select(_e928, _e971, (_e971 > _e928)) < 0f);
                                                            }
                                                            let _e976 = phi_1311_;
                                                            if _e976 {
                                                                phi_2040_ = type_22();
                                                                phi_2041_ = true;
                                                                phi_2042_ = false;
                                                            } else {
                                                                let _e978 = select(_e918, _e905, (_e905 < _e918));
                                                                if (select(_e931, _e978, (_e978 < _e931)) > 0f) {
                                                                    phi_1340_ = true;
                                                                } else {
                                                                    let _e983 = select(_e918, _e905, (_e905 > _e918));
                                                                    phi_1340_ = (select(_e931, _e983, (_e983 > _e931)) < 0f);
                                                                }
                                                                let _e988 = phi_1340_;
                                                                if _e988 {
                                                                    phi_2038_ = type_22();
                                                                    phi_2039_ = false;
                                                                } else {
                                                                    let _e990 = select(_e891[1][0], _e891[0][0], (_e891[0][0] < _e891[1][0]));
                                                                    let _e994 = select(_e891[1][0], _e891[0][0], (_e891[0][0] > _e891[1][0]));
                                                                    let _e998 = select(_e891[1][1], _e891[0][1], (_e891[0][1] < _e891[1][1]));
                                                                    let _e1002 = select(_e891[1][1], _e891[0][1], (_e891[0][1] > _e891[1][1]));
                                                                    let _e1006 = select(_e891[1][2], _e891[0][2], (_e891[0][2] < _e891[1][2]));
                                                                    let _e1010 = select(_e891[1][2], _e891[0][2], (_e891[0][2] > _e891[1][2]));
                                                                    let _e1015 = ((select(_e891[2][0], _e990, (_e990 < _e891[2][0])) - _e309) * _e314);
                                                                    let _e1016 = ((select(_e891[2][0], _e994, (_e994 > _e891[2][0])) - _e310) * _e314);
                                                                    let _e1019 = ((select(_e891[2][1], _e998, (_e998 < _e891[2][1])) - _e375) * _e380);
                                                                    let _e1020 = ((select(_e891[2][1], _e1002, (_e1002 > _e891[2][1])) - _e376) * _e380);
                                                                    let _e1023 = ((select(_e891[2][2], _e1006, (_e1006 < _e891[2][2])) - _e441) * _e446);
                                                                    let _e1024 = ((select(_e891[2][2], _e1010, (_e1010 > _e891[2][2])) - _e442) * _e446);
                                                                    let _e1026 = select(_e1024, _e1023, (_e1023 < _e1024));
                                                                    let _e1028 = select(_e1024, _e1023, (_e1023 > _e1024));
                                                                    let _e1030 = select(_e1016, _e1015, (_e1015 < _e1016));
                                                                    let _e1032 = select(_e1020, _e1019, (_e1019 < _e1020));
                                                                    let _e1034 = select(_e1032, _e1030, (_e1030 > _e1032));
                                                                    let _e1036 = select(_e1026, _e1034, (_e1034 > _e1026));
                                                                    let _e1038 = select(_e1016, _e1015, (_e1015 > _e1016));
                                                                    let _e1040 = select(_e1020, _e1019, (_e1019 > _e1020));
                                                                    let _e1042 = select(_e1040, _e1038, (_e1038 < _e1040));
                                                                    let _e1044 = select(_e1028, _e1042, (_e1042 < _e1028));
                                                                    let _e1045 = -(_e1026);
                                                                    let _e1051 = select(_e557, _e1036, (_e1036 > _e557));
                                                                    if (_e1051 > (_e1044 + (select(_e1045, _e1028, (_e1028 > _e1045)) * 0.0000019073523f))) {
                                                                        phi_2033_ = type_22();
                                                                        phi_2034_ = true;
                                                                    } else {
                                                                        let _e1053 = (_e1051 > _e792.member);
                                                                        if _e1053 {
                                                                            phi_2032_ = type_22();
                                                                        } else {
                                                                            let _e1054 = vec3<f32>(_e891[0][0], _e891[0][1], _e891[0][2]);
                                                                            let _e1055 = vec3<f32>(_e891[1][0], _e891[1][1], _e891[1][2]);
                                                                            let _e1056 = vec3<f32>(_e891[2][0], _e891[2][1], _e891[2][2]);
                                                                            let _e1057 = (_e891[1][0] - _e891[0][0]);
                                                                            let _e1058 = (_e891[1][1] - _e891[0][1]);
                                                                            let _e1059 = (_e891[1][2] - _e891[0][2]);
                                                                            let _e1060 = vec3<f32>(_e1057, _e1058, _e1059);
                                                                            let _e1061 = (_e891[2][0] - _e891[1][0]);
                                                                            let _e1062 = (_e891[2][1] - _e891[1][1]);
                                                                            let _e1063 = (_e891[2][2] - _e891[1][2]);
                                                                            let _e1064 = vec3<f32>(_e1061, _e1062, _e1063);
                                                                            let _e1065 = (_e891[0][0] - _e891[2][0]);
                                                                            let _e1066 = (_e891[0][1] - _e891[2][1]);
                                                                            let _e1067 = (_e891[0][2] - _e891[2][2]);
                                                                            let _e1068 = vec3<f32>(_e1065, _e1066, _e1067);
                                                                            let _e1071 = bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u));
                                                                            let _e1074 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                                            let _e1076 = select(_e1074, _e1071, (_e1071 > _e1074));
                                                                            let _e1079 = bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u));
                                                                            let _e1081 = select(_e1079, _e1076, (_e1076 > _e1079));
                                                                            let _e1084 = bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u));
                                                                            let _e1087 = bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u));
                                                                            let _e1089 = select(_e1087, _e1084, (_e1084 > _e1087));
                                                                            let _e1092 = bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u));
                                                                            let _e1094 = select(_e1092, _e1089, (_e1089 > _e1092));
                                                                            let _e1097 = bitcast<f32>((bitcast<u32>(_e1065) & 2147483647u));
                                                                            let _e1100 = bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u));
                                                                            let _e1102 = select(_e1100, _e1097, (_e1097 > _e1100));
                                                                            let _e1105 = bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u));
                                                                            let _e1107 = select(_e1105, _e1102, (_e1102 > _e1105));
                                                                            let _e1109 = select(_e1094, _e1081, (_e1081 > _e1094));
                                                                            let _e1111 = select(_e1107, _e1109, (_e1109 > _e1107));
                                                                            if (_e1081 == _e1111) {
                                                                                phi_1759_ = _e918;
                                                                                phi_1760_ = _e915;
                                                                                phi_1761_ = _e905;
                                                                                phi_1762_ = _e902;
                                                                                phi_1763_ = _e1054;
                                                                                phi_1764_ = _e1068;
                                                                                phi_1765_ = _e1064;
                                                                                phi_1766_ = _e1060;
                                                                            } else {
                                                                                let _e1113 = (_e1094 == _e1111);
                                                                                let _e1118 = vec3(_e1113);
                                                                                phi_1759_ = select(_e905, _e931, _e1113);
                                                                                phi_1760_ = select(_e902, _e928, _e1113);
                                                                                phi_1761_ = select(_e931, _e918, _e1113);
                                                                                phi_1762_ = select(_e928, _e915, _e1113);
                                                                                phi_1763_ = select(_e1056, _e1055, _e1118);
                                                                                phi_1764_ = select(_e1064, _e1060, _e1118);
                                                                                phi_1765_ = select(_e1060, _e1068, _e1118);
                                                                                phi_1766_ = select(_e1068, _e1064, _e1118);
                                                                            }
                                                                            let _e1124 = phi_1759_;
                                                                            let _e1126 = phi_1760_;
                                                                            let _e1128 = phi_1761_;
                                                                            let _e1130 = phi_1762_;
                                                                            let _e1132 = phi_1763_;
                                                                            let _e1134 = phi_1764_;
                                                                            let _e1136 = phi_1765_;
                                                                            let _e1138 = phi_1766_;
                                                                            let _e1145 = ((_e1136.y * _e1134.z) - (_e1134.y * _e1136.z));
                                                                            let _e1150 = ((_e1136.z * _e1134.x) - (_e1134.z * _e1136.x));
                                                                            let _e1153 = ((_e1136.x * _e1134.y) - (_e1134.x * _e1136.y));
                                                                            if (_e953 >= _e957) {
                                                                                phi_1803_ = select(true, false, (_e953 >= _e961));
                                                                            } else {
                                                                                phi_1803_ = true;
                                                                            }
                                                                            let _e1158 = phi_1803_;
                                                                            if _e1158 {
                                                                                phi_1812_ = select(_e1056, _e1055, vec3((_e957 >= _e961)));
                                                                            } else {
                                                                                phi_1812_ = _e1054;
                                                                            }
                                                                            let _e1163 = phi_1812_;
                                                                            let _e1174 = (((_e1145 * (_e1163.x - _e271)) + (_e1150 * (_e1163.y - _e338))) + (_e1153 * (_e1163.z - _e404)));
                                                                            let _e1179 = (((_e1145 * _e311) + (_e1150 * _e377)) + (_e1153 * _e443));
                                                                            let _e1180 = (_e1126 - _e1130);
                                                                            let _e1181 = (_e1124 - _e1128);
                                                                            let _e1189 = (-(((_e1130 * _e1180) + (_e1128 * _e1181))) / ((_e1180 * _e1180) + (_e1181 * _e1181)));
                                                                            let _e1191 = select(1f, _e1189, (_e1189 < 1f));
                                                                            let _e1193 = select(0f, _e1191, (_e1191 > 0f));
                                                                            let _e1206 = ((_e1132.x + (_e1138.x * _e1193)) - _e271);
                                                                            let _e1207 = ((_e1132.y + (_e1138.y * _e1193)) - _e338);
                                                                            let _e1208 = ((_e1132.z + (_e1138.z * _e1193)) - _e404);
                                                                            let _e1209 = (_e1208 / _e443);
                                                                            let _e1221 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                            let _e1224 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                            let _e1226 = select(_e1224, _e1221, (_e1221 > _e1224));
                                                                            let _e1229 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                            let _e1231 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                                            let _e1237 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
                                                                            let _e1240 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                                            let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                            let _e1245 = bitcast<f32>((bitcast<u32>(_e1153) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1145 * _e1206) + (_e1150 * _e1207)) + (_e1153 * _e1208)) - _e1174)) & 2147483647u)) <= ((0.0000009536743f * select(_e1111, _e1231, (_e1231 > _e1111))) * select(_e1245, _e1242, (_e1242 > _e1245)))) {
                                                                                let _e1255 = bitcast<f32>((bitcast<u32>(_e1136.x) & 2147483647u));
                                                                                let _e1258 = bitcast<f32>((bitcast<u32>(_e1136.y) & 2147483647u));
                                                                                let _e1260 = select(_e1258, _e1255, (_e1255 > _e1258));
                                                                                let _e1263 = bitcast<f32>((bitcast<u32>(_e1136.z) & 2147483647u));
                                                                                let _e1269 = bitcast<f32>((bitcast<u32>(_e1134.x) & 2147483647u));
                                                                                let _e1272 = bitcast<f32>((bitcast<u32>(_e1134.y) & 2147483647u));
                                                                                let _e1274 = select(_e1272, _e1269, (_e1269 > _e1272));
                                                                                let _e1277 = bitcast<f32>((bitcast<u32>(_e1134.z) & 2147483647u));
                                                                                let _e1281 = (bitcast<f32>((bitcast<u32>(_e1179) & 2147483647u)) > ((0.0000038146973f * select(_e1263, _e1260, (_e1260 > _e1263))) * select(_e1277, _e1274, (_e1274 > _e1277))));
                                                                                if _e1281 {
                                                                                    phi_1977_ = (_e1174 / _e1179);
                                                                                } else {
                                                                                    phi_1977_ = f32();
                                                                                }
                                                                                let _e1284 = phi_1977_;
                                                                                phi_1979_ = _e1284;
                                                                                phi_1980_ = select(true, false, _e1281);
                                                                            } else {
                                                                                phi_1979_ = f32();
                                                                                phi_1980_ = true;
                                                                            }
                                                                            let _e1287 = phi_1979_;
                                                                            let _e1289 = phi_1980_;
                                                                            if _e1289 {
                                                                                let _e1297 = (((_e1145 * (_e1206 - (_e311 * _e1209))) + (_e1150 * (_e1207 - (_e377 * _e1209)))) / _e1179);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1297) & 2147483647u)) <= _e1111) {
                                                                                    phi_2000_ = (_e1209 + _e1297);
                                                                                } else {
                                                                                    phi_2000_ = _e1209;
                                                                                }
                                                                                let _e1304 = phi_2000_;
                                                                                phi_2001_ = _e1304;
                                                                            } else {
                                                                                phi_2001_ = _e1287;
                                                                            }
                                                                            let _e1306 = phi_2001_;
                                                                            let _e1308 = select(_e1044, _e1306, (_e1306 < _e1044));
                                                                            let _e1310 = select(_e1036, _e1308, (_e1308 > _e1036));
                                                                            if (_e1310 >= _e557) {
                                                                                let _e1312 = (_e1310 <= _e792.member);
                                                                                if _e1312 {
                                                                                    let _e1313 = (1f / _e963);
                                                                                    phi_2024_ = type_22(_e1310, (_e957 * _e1313), (_e961 * _e1313), _e821);
                                                                                } else {
                                                                                    phi_2024_ = type_22();
                                                                                }
                                                                                let _e1318 = phi_2024_;
                                                                                phi_2026_ = _e1318;
                                                                                phi_2027_ = select(true, false, _e1312);
                                                                            } else {
                                                                                phi_2026_ = type_22();
                                                                                phi_2027_ = true;
                                                                            }
                                                                            let _e1321 = phi_2026_;
                                                                            let _e1323 = phi_2027_;
                                                                            if _e1323 {
                                                                                phi_2031_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2031_ = _e1321;
                                                                            }
                                                                            let _e1325 = phi_2031_;
                                                                            phi_2032_ = _e1325;
                                                                        }
                                                                        let _e1327 = phi_2032_;
                                                                        phi_2033_ = _e1327;
                                                                        phi_2034_ = _e1053;
                                                                    }
                                                                    let _e1329 = phi_2033_;
                                                                    let _e1331 = phi_2034_;
                                                                    phi_2038_ = _e1329;
                                                                    phi_2039_ = _e1331;
                                                                }
                                                                let _e1333 = phi_2038_;
                                                                let _e1335 = phi_2039_;
                                                                phi_2040_ = _e1333;
                                                                phi_2041_ = _e988;
                                                                phi_2042_ = _e1335;
                                                            }
                                                            let _e1337 = phi_2040_;
                                                            let _e1339 = phi_2041_;
                                                            let _e1341 = phi_2042_;
                                                            phi_2043_ = _e1337;
                                                            phi_2044_ = _e1339;
                                                            phi_2045_ = _e1341;
                                                        }
                                                        let _e1343 = phi_2043_;
                                                        let _e1345 = phi_2044_;
                                                        let _e1347 = phi_2045_;
                                                        phi_2053_ = _e1343;
                                                        phi_2054_ = select(_e1347, true, _e1345);
                                                    } else {
                                                        phi_2053_ = type_22();
                                                        phi_2054_ = true;
                                                    }
                                                    let _e1350 = phi_2053_;
                                                    let _e1352 = phi_2054_;
                                                    if _e1352 {
                                                        phi_2058_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2058_ = _e1350;
                                                    }
                                                    let _e1354 = phi_2058_;
                                                    if (_e1354.member_3 != 4294967295u) {
                                                        if (_e821 != _e91) {
                                                            phi_2069_ = type_48(_e792.member, true);
                                                        } else {
                                                            phi_2069_ = _e792;
                                                        }
                                                        let _e1362 = phi_2069_;
                                                        phi_2070_ = _e1362;
                                                    } else {
                                                        phi_2070_ = _e792;
                                                    }
                                                    let _e1364 = phi_2070_;
                                                    phi_1021_ = _e1364;
                                                } else {
                                                    phi_1021_ = type_48();
                                                }
                                                let _e1366 = phi_1021_;
                                                continue;
                                                continuing {
                                                    phi_1020_ = _e1366;
                                                    phi_1023_ = _e807;
                                                    phi_2639_ = _e565;
                                                    break if !(_e813);
                                                }
                                            }
                                            let _e1369 = phi_2639_;
                                            phi_2800_ = _e1369;
                                            if _e1369 {
                                                break;
                                            }
                                            let _e1371 = local_2;
                                            phi_2804_ = _e1369;
                                            let _e1562 = local_4;
                                            phi_2558_ = _e1562;
                                            phi_2559_ = false;
                                            phi_2560_ = select(_e592, 0u, _e1371.member_1);
                                            phi_2561_ = _e594;
                                        } else {
                                            if (_e594 >= _e72) {
                                                phi_2142_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e594 < _e72) {
                                                } else {
                                                    phi_2800_ = true;
                                                    break;
                                                }
                                                let _e604 = (_e224 % 3u);
                                                if (_e604 < 3u) {
                                                } else {
                                                    phi_2800_ = true;
                                                    break;
                                                }
                                                let _e610 = global_2.member[_e594].member[_e604];
                                                let _e616 = (_e223 % 3u);
                                                if (_e616 < 3u) {
                                                } else {
                                                    phi_2800_ = true;
                                                    break;
                                                }
                                                let _e622 = global_2.member[_e594].member[_e616];
                                                let _e628 = (_e225 % 3u);
                                                if (_e628 < 3u) {
                                                } else {
                                                    phi_2800_ = true;
                                                    break;
                                                }
                                                let _e634 = global_2.member[_e594].member[_e628];
                                                let _e644 = global_2.member[_e594].member_1;
                                                let _e648 = global_2.member[_e594].member_2;
                                                phi_2142_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e610[0], _e610[1], _e610[2], _e610[3]), vec4<f32>(_e622[0], _e622[1], _e622[2], _e622[3]), vec4<f32>(_e634[0], _e634[1], _e634[2], _e634[3])), _e644, _e648);
                                            }
                                            let _e651 = phi_2142_;
                                            let _e663 = ((_e651.member[0].x - _e309) * _e314);
                                            let _e664 = ((_e651.member[0].y - _e309) * _e314);
                                            let _e665 = ((_e651.member[0].z - _e310) * _e314);
                                            let _e666 = ((_e651.member[0].w - _e310) * _e314);
                                            let _e676 = ((_e651.member[1].x - _e375) * _e380);
                                            let _e677 = ((_e651.member[1].y - _e375) * _e380);
                                            let _e678 = ((_e651.member[1].z - _e376) * _e380);
                                            let _e679 = ((_e651.member[1].w - _e376) * _e380);
                                            let _e689 = ((_e651.member[2].x - _e441) * _e446);
                                            let _e690 = ((_e651.member[2].y - _e441) * _e446);
                                            let _e691 = ((_e651.member[2].z - _e442) * _e446);
                                            let _e692 = ((_e651.member[2].w - _e442) * _e446);
                                            let _e694 = select(_e691, _e689, (_e689 < _e691));
                                            let _e696 = select(_e692, _e690, (_e690 < _e692));
                                            let _e698 = select(_e691, _e689, (_e689 > _e691));
                                            let _e700 = select(_e692, _e690, (_e690 > _e692));
                                            let _e702 = select(_e665, _e663, (_e663 < _e665));
                                            let _e704 = select(_e666, _e664, (_e664 < _e666));
                                            let _e706 = select(_e678, _e676, (_e676 < _e678));
                                            let _e708 = select(_e679, _e677, (_e677 < _e679));
                                            let _e710 = select(_e706, _e702, (_e702 > _e706));
                                            let _e712 = select(_e708, _e704, (_e704 > _e708));
                                            let _e714 = select(_e694, _e710, (_e710 > _e694));
                                            let _e716 = select(_e696, _e712, (_e712 > _e696));
                                            let _e718 = select(_e665, _e663, (_e663 > _e665));
                                            let _e720 = select(_e666, _e664, (_e664 > _e666));
                                            let _e722 = select(_e678, _e676, (_e676 > _e678));
                                            let _e724 = select(_e679, _e677, (_e677 > _e679));
                                            let _e726 = select(_e722, _e718, (_e718 < _e722));
                                            let _e728 = select(_e724, _e720, (_e720 < _e724));
                                            let _e733 = -(_e694);
                                            let _e734 = -(_e696);
                                            let _e741 = (select(_e698, _e726, (_e726 < _e698)) + (select(_e733, _e698, (_e698 > _e733)) * 0.0000019073523f));
                                            let _e742 = (select(_e700, _e728, (_e728 < _e700)) + (select(_e734, _e700, (_e700 > _e734)) * 0.0000019073523f));
                                            let _e744 = select(_e557, _e714, (_e714 > _e557));
                                            let _e746 = select(_e557, _e716, (_e716 > _e557));
                                            let _e751 = (_e744 <= select(_e567.member, _e741, (_e741 < _e567.member)));
                                            let _e752 = (_e746 <= select(_e567.member, _e742, (_e742 < _e567.member)));
                                            let _e753 = (_e744 <= _e746);
                                            if _e751 {
                                                if _e752 {
                                                    if _e753 {
                                                        phi_2504_ = _e651.member_2;
                                                    } else {
                                                        phi_2504_ = _e651.member_1;
                                                    }
                                                    let _e757 = phi_2504_;
                                                    let _e760 = (_e592 % 128u);
                                                    let _e761 = (_e760 < 128u);
                                                    if _e761 {
                                                    } else {
                                                        phi_2800_ = true;
                                                        break;
                                                    }
                                                    local_1[_e760] = _e757;
                                                    if _e761 {
                                                    } else {
                                                        phi_2800_ = true;
                                                        break;
                                                    }
                                                    local[_e760] = select(_e746, _e744, !(_e753));
                                                    if _e753 {
                                                        phi_2532_ = _e651.member_1;
                                                    } else {
                                                        phi_2532_ = _e651.member_2;
                                                    }
                                                    let _e768 = phi_2532_;
                                                    phi_2533_ = (_e592 + 1u);
                                                    phi_2534_ = _e768;
                                                } else {
                                                    phi_2533_ = u32();
                                                    phi_2534_ = u32();
                                                }
                                                let _e770 = phi_2533_;
                                                let _e772 = phi_2534_;
                                                phi_2536_ = _e770;
                                                phi_2537_ = _e772;
                                                phi_2538_ = select(true, false, _e752);
                                            } else {
                                                phi_2536_ = u32();
                                                phi_2537_ = u32();
                                                phi_2538_ = true;
                                            }
                                            let _e775 = phi_2536_;
                                            let _e777 = phi_2537_;
                                            let _e779 = phi_2538_;
                                            if _e779 {
                                                if _e751 {
                                                    phi_2547_ = _e651.member_1;
                                                } else {
                                                    phi_2547_ = _e651.member_2;
                                                }
                                                let _e783 = phi_2547_;
                                                phi_2552_ = select(_e752, true, _e751);
                                                phi_2554_ = _e783;
                                            } else {
                                                phi_2552_ = _e590;
                                                phi_2554_ = _e777;
                                            }
                                            let _e786 = phi_2552_;
                                            let _e788 = phi_2554_;
                                            phi_2804_ = _e565;
                                            phi_2558_ = _e567;
                                            phi_2559_ = _e786;
                                            phi_2560_ = select(_e775, _e592, _e779);
                                            phi_2561_ = _e788;
                                        }
                                        let _e1375 = phi_2804_;
                                        let _e1377 = phi_2558_;
                                        let _e1379 = phi_2559_;
                                        let _e1381 = phi_2560_;
                                        let _e1383 = phi_2561_;
                                        phi_2803_ = _e1375;
                                        phi_2562_ = _e1377;
                                        phi_2563_ = _e1379;
                                        phi_2564_ = (_e571 - 1u);
                                        phi_2565_ = _e1381;
                                        phi_2566_ = _e1383;
                                    } else {
                                        phi_2803_ = _e565;
                                        phi_2562_ = _e567;
                                        phi_2563_ = _e590;
                                        phi_2564_ = _e571;
                                        phi_2565_ = _e592;
                                        phi_2566_ = _e594;
                                    }
                                    let _e1385 = phi_2803_;
                                    let _e1387 = phi_2562_;
                                    let _e1389 = phi_2563_;
                                    let _e1391 = phi_2564_;
                                    let _e1393 = phi_2565_;
                                    let _e1395 = phi_2566_;
                                    phi_2802_ = _e1385;
                                    phi_2567_ = _e1387;
                                    phi_2568_ = _e1389;
                                    phi_2569_ = _e1391;
                                    phi_2570_ = _e1393;
                                    phi_2571_ = _e1395;
                                } else {
                                    phi_2802_ = _e565;
                                    phi_2567_ = type_48();
                                    phi_2568_ = bool();
                                    phi_2569_ = u32();
                                    phi_2570_ = u32();
                                    phi_2571_ = u32();
                                }
                                let _e1397 = phi_2802_;
                                let _e1399 = phi_2567_;
                                let _e1401 = phi_2568_;
                                let _e1403 = phi_2569_;
                                let _e1405 = phi_2570_;
                                let _e1407 = phi_2571_;
                                phi_2801_ = _e1397;
                                phi_952_ = _e1399;
                                phi_955_ = _e1401;
                                phi_957_ = _e1403;
                                phi_959_ = _e1405;
                                phi_961_ = _e1407;
                                phi_2572_ = _e579;
                            } else {
                                phi_2801_ = _e565;
                                phi_952_ = type_48();
                                phi_955_ = bool();
                                phi_957_ = u32();
                                phi_959_ = u32();
                                phi_961_ = u32();
                                phi_2572_ = false;
                            }
                            let _e1409 = phi_2801_;
                            let _e1411 = phi_952_;
                            let _e1413 = phi_955_;
                            let _e1415 = phi_957_;
                            let _e1417 = phi_959_;
                            let _e1419 = phi_961_;
                            let _e1421 = phi_2572_;
                            continue;
                            continuing {
                                phi_2645_ = _e1409;
                                phi_951_ = _e1411;
                                phi_954_ = _e1413;
                                phi_956_ = _e1415;
                                phi_958_ = _e1417;
                                phi_960_ = _e1419;
                                phi_2800_ = _e1409;
                                break if !(_e1421);
                            }
                        }
                        let _e1424 = phi_2800_;
                        if _e1424 {
                            break;
                        }
                        let _e1426 = local_3;
                        if _e1426.member_1 {
                        } else {
                            if _e92 {
                            } else {
                                break;
                            }
                            let _e1430 = global_5.member[_e84];
                            if _e85 {
                            } else {
                                break;
                            }
                            let _e1434 = global_4.member[_e84].member_1;
                            if _e92 {
                            } else {
                                break;
                            }
                            global_5.member[_e84] = type_24(_e1430.member, _e1430.member_1, _e1430.member_2, array<f32, 3>((_e1430.member_3[0] + (_e1434[0] * _e1430.member_1[0])), (_e1430.member_3[1] + (_e1434[1] * _e1430.member_1[1])), (_e1430.member_3[2] + (_e1434[2] * _e1430.member_1[2]))), _e1430.member_4);
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
