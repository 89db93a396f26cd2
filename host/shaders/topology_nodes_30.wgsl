struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_18 {
    member: i32,
    member_1: i32,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_4;
@group(0) @binding(0) 
var<storage> global_2: type_4;
@group(0) @binding(1) 
var<storage> global_3: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_15;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;

fn function_() {
    var phi_131_: u32;
    var phi_151_: u32;
    var phi_163_: u32;
    var phi_171_: u32;
    var phi_178_: i32;
    var phi_196_: u32;
    var phi_208_: u32;
    var phi_216_: u32;
    var phi_223_: i32;
    var phi_230_: type_18;
    var phi_236_: type_7;
    var phi_239_: i32;
    var phi_237_: type_7;
    var phi_262_: type_7;
    var phi_288_: u32;
    var phi_300_: u32;
    var phi_308_: u32;
    var phi_315_: i32;
    var phi_321_: i32;
    var phi_240_: i32;
    var phi_323_: bool;
    var phi_728_: bool;
    var local: i32;
    var phi_333_: type_7;
    var phi_336_: i32;
    var phi_338_: i32;
    var phi_334_: type_7;
    var phi_361_: type_7;
    var phi_391_: u32;
    var phi_403_: u32;
    var phi_411_: u32;
    var phi_418_: i32;
    var phi_432_: i32;
    var phi_433_: i32;
    var phi_337_: i32;
    var phi_339_: i32;
    var phi_435_: bool;
    var phi_748_: bool;
    var local_1: i32;
    var phi_454_: u32;
    var phi_466_: u32;
    var phi_474_: u32;
    var phi_481_: i32;
    var phi_484_: type_7;
    var phi_487_: i32;
    var phi_489_: i32;
    var phi_485_: type_7;
    var phi_512_: type_7;
    var phi_546_: u32;
    var phi_558_: u32;
    var phi_566_: u32;
    var phi_573_: i32;
    var phi_585_: i32;
    var phi_488_: i32;
    var phi_586_: bool;
    var phi_587_: bool;
    var phi_758_: bool;
    var phi_727_: bool;
    var phi_725_: i32;
    var local_2: i32;
    var phi_625_: u32;
    var phi_642_: u32;
    var phi_648_: u32;
    var phi_667_: u32;
    var phi_684_: u32;
    var phi_691_: u32;
    var local_3: i32;
    var local_4: i32;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = global;
            let _e38 = arrayLength((&global_2.member));
            let _e40 = arrayLength((&global_3.member));
            let _e42 = arrayLength((&global_1.member));
            let _e50 = (_e36.x + (_e36.y * 2097152u));
            let _e52 = (_e50 >> bitcast<u32>(5i));
            let _e53 = (_e52 < _e40);
            if _e53 {
                if _e53 {
                } else {
                    break;
                }
                let _e56 = global_3.member[_e52];
                let _e58 = ((_e50 & 31u) & 31u);
                if (((_e56 >> bitcast<u32>(_e58)) & 1u) == 1u) {
                    if _e53 {
                        if _e53 {
                        } else {
                            break;
                        }
                    }
                    let _e68 = (_e52 < _e42);
                    if _e68 {
                        if _e68 {
                        } else {
                            break;
                        }
                        let _e71 = global_1.member[_e52];
                        phi_131_ = _e71;
                    } else {
                        phi_131_ = 0u;
                    }
                    let _e73 = phi_131_;
                    let _e75 = (_e73 + countOneBits((select(0u, _e56, _e53) & ~((4294967295u << bitcast<u32>(_e58))))));
                    let _e76 = (_e50 + 1u);
                    let _e77 = (_e76 < _e38);
                    if _e77 {
                        let _e78 = (_e50 < _e38);
                        if _e78 {
                            if _e78 {
                            } else {
                                break;
                            }
                            let _e81 = global_2.member[_e50];
                            phi_151_ = _e81;
                        } else {
                            phi_151_ = 0u;
                        }
                        let _e83 = phi_151_;
                        if _e77 {
                            if _e77 {
                            } else {
                                break;
                            }
                            let _e86 = global_2.member[_e76];
                            phi_163_ = _e86;
                        } else {
                            phi_163_ = 0u;
                        }
                        let _e88 = phi_163_;
                        let _e89 = (_e83 ^ _e88);
                        let _e90 = (_e89 == 0u);
                        if _e90 {
                            phi_171_ = (_e50 ^ _e76);
                        } else {
                            phi_171_ = _e89;
                        }
                        let _e93 = phi_171_;
                        phi_178_ = (select(0i, 32i, _e90) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e93)), 32u, (_e93 == 0u))));
                    } else {
                        phi_178_ = -1i;
                    }
                    let _e103 = phi_178_;
                    let _e104 = (_e50 + 4294967295u);
                    let _e105 = (_e104 < _e38);
                    if _e105 {
                        let _e106 = (_e50 < _e38);
                        if _e106 {
                            if _e106 {
                            } else {
                                break;
                            }
                            let _e109 = global_2.member[_e50];
                            phi_196_ = _e109;
                        } else {
                            phi_196_ = 0u;
                        }
                        let _e111 = phi_196_;
                        if _e105 {
                            if _e105 {
                            } else {
                                break;
                            }
                            let _e114 = global_2.member[_e104];
                            phi_208_ = _e114;
                        } else {
                            phi_208_ = 0u;
                        }
                        let _e116 = phi_208_;
                        let _e117 = (_e111 ^ _e116);
                        let _e118 = (_e117 == 0u);
                        if _e118 {
                            phi_216_ = (_e50 ^ _e104);
                        } else {
                            phi_216_ = _e117;
                        }
                        let _e121 = phi_216_;
                        phi_223_ = (select(0i, 32i, _e118) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e121)), 32u, (_e121 == 0u))));
                    } else {
                        phi_223_ = -1i;
                    }
                    let _e131 = phi_223_;
                    if (_e103 > _e131) {
                        phi_230_ = type_18(1i, _e131);
                    } else {
                        phi_230_ = type_18(-1i, _e103);
                    }
                    let _e136 = phi_230_;
                    phi_236_ = type_7(0u, 31u);
                    phi_239_ = 4i;
                    loop {
                        let _e140 = phi_236_;
                        let _e142 = phi_239_;
                        local = _e142;
                        local_3 = _e142;
                        if (_e140.member < _e140.member_1) {
                            phi_237_ = type_7((_e140.member + 1u), _e140.member_1);
                            phi_262_ = type_7(1u, _e140.member);
                        } else {
                            phi_237_ = _e140;
                            phi_262_ = type_7(0u, type_7().member_1);
                        }
                        let _e155 = phi_237_;
                        let _e157 = phi_262_;
                        if (bitcast<i32>(_e157.member) != 0i) {
                            let _e164 = (_e50 + bitcast<u32>(((2i * _e142) * _e136.member)));
                            let _e165 = (_e164 < _e38);
                            if _e165 {
                                let _e166 = (_e50 < _e38);
                                if _e166 {
                                    if _e166 {
                                    } else {
                                        phi_728_ = true;
                                        break;
                                    }
                                    let _e169 = global_2.member[_e50];
                                    phi_288_ = _e169;
                                } else {
                                    phi_288_ = 0u;
                                }
                                let _e171 = phi_288_;
                                if _e165 {
                                    if _e165 {
                                    } else {
                                        phi_728_ = true;
                                        break;
                                    }
                                    let _e174 = global_2.member[_e164];
                                    phi_300_ = _e174;
                                } else {
                                    phi_300_ = 0u;
                                }
                                let _e176 = phi_300_;
                                let _e177 = (_e171 ^ _e176);
                                let _e178 = (_e177 == 0u);
                                if _e178 {
                                    phi_308_ = (_e50 ^ _e164);
                                } else {
                                    phi_308_ = _e177;
                                }
                                let _e181 = phi_308_;
                                phi_315_ = (select(0i, 32i, _e178) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e181)), 32u, (_e181 == 0u))));
                            } else {
                                phi_315_ = -1i;
                            }
                            let _e191 = phi_315_;
                            let _e192 = (_e191 <= _e136.member_1);
                            if _e192 {
                                phi_321_ = i32();
                            } else {
                                phi_321_ = (_e142 * 2i);
                            }
                            let _e195 = phi_321_;
                            phi_240_ = _e195;
                            phi_323_ = select(true, false, _e192);
                        } else {
                            phi_240_ = i32();
                            phi_323_ = false;
                        }
                        let _e198 = phi_240_;
                        let _e200 = phi_323_;
                        continue;
                        continuing {
                            phi_236_ = _e155;
                            phi_239_ = _e198;
                            phi_728_ = false;
                            break if !(_e200);
                        }
                    }
                    let _e203 = phi_728_;
                    if _e203 {
                        break;
                    }
                    let _e205 = local;
                    phi_333_ = type_7(0u, 31u);
                    phi_336_ = (_e205 / 2i);
                    let _e497 = local_3;
                    phi_338_ = _e497;
                    loop {
                        let _e208 = phi_333_;
                        let _e210 = phi_336_;
                        let _e212 = phi_338_;
                        local_1 = _e212;
                        local_4 = _e212;
                        if (_e208.member < _e208.member_1) {
                            phi_334_ = type_7((_e208.member + 1u), _e208.member_1);
                            phi_361_ = type_7(1u, _e208.member);
                        } else {
                            phi_334_ = _e208;
                            phi_361_ = type_7(0u, type_7().member_1);
                        }
                        let _e225 = phi_334_;
                        let _e227 = phi_361_;
                        if (bitcast<i32>(_e227.member) != 0i) {
                            let _e231 = (_e210 == 0i);
                            if _e231 {
                                phi_432_ = i32();
                                phi_433_ = i32();
                            } else {
                                let _e232 = (_e212 + _e210);
                                let _e235 = (_e50 + bitcast<u32>((_e232 * _e136.member)));
                                let _e236 = (_e235 < _e38);
                                if _e236 {
                                    let _e237 = (_e50 < _e38);
                                    if _e237 {
                                        if _e237 {
                                        } else {
                                            phi_748_ = true;
                                            break;
                                        }
                                        let _e240 = global_2.member[_e50];
                                        phi_391_ = _e240;
                                    } else {
                                        phi_391_ = 0u;
                                    }
                                    let _e242 = phi_391_;
                                    if _e236 {
                                        if _e236 {
                                        } else {
                                            phi_748_ = true;
                                            break;
                                        }
                                        let _e245 = global_2.member[_e235];
                                        phi_403_ = _e245;
                                    } else {
                                        phi_403_ = 0u;
                                    }
                                    let _e247 = phi_403_;
                                    let _e248 = (_e242 ^ _e247);
                                    let _e249 = (_e248 == 0u);
                                    if _e249 {
                                        phi_411_ = (_e50 ^ _e235);
                                    } else {
                                        phi_411_ = _e248;
                                    }
                                    let _e252 = phi_411_;
                                    phi_418_ = (select(0i, 32i, _e249) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e252)), 32u, (_e252 == 0u))));
                                } else {
                                    phi_418_ = -1i;
                                }
                                let _e262 = phi_418_;
                                phi_432_ = (_e210 / 2i);
                                phi_433_ = select(_e212, _e232, (_e262 > _e136.member_1));
                            }
                            let _e267 = phi_432_;
                            let _e269 = phi_433_;
                            phi_337_ = _e267;
                            phi_339_ = _e269;
                            phi_435_ = select(true, false, _e231);
                        } else {
                            phi_337_ = i32();
                            phi_339_ = i32();
                            phi_435_ = false;
                        }
                        let _e272 = phi_337_;
                        let _e274 = phi_339_;
                        let _e276 = phi_435_;
                        continue;
                        continuing {
                            phi_333_ = _e225;
                            phi_336_ = _e272;
                            phi_338_ = _e274;
                            phi_748_ = _e203;
                            break if !(_e276);
                        }
                    }
                    let _e279 = phi_748_;
                    if _e279 {
                        break;
                    }
                    let _e281 = local_1;
                    let _e284 = (_e50 + bitcast<u32>((_e281 * _e136.member)));
                    let _e285 = (_e284 < _e38);
                    if _e285 {
                        let _e286 = (_e50 < _e38);
                        if _e286 {
                            if _e286 {
                            } else {
                                break;
                            }
                            let _e289 = global_2.member[_e50];
                            phi_454_ = _e289;
                        } else {
                            phi_454_ = 0u;
                        }
                        let _e291 = phi_454_;
                        if _e285 {
                            if _e285 {
                            } else {
                                break;
                            }
                            let _e294 = global_2.member[_e284];
                            phi_466_ = _e294;
                        } else {
                            phi_466_ = 0u;
                        }
                        let _e296 = phi_466_;
                        let _e297 = (_e291 ^ _e296);
                        let _e298 = (_e297 == 0u);
                        if _e298 {
                            phi_474_ = (_e50 ^ _e284);
                        } else {
                            phi_474_ = _e297;
                        }
                        let _e301 = phi_474_;
                        phi_481_ = (select(0i, 32i, _e298) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e301)), 32u, (_e301 == 0u))));
                    } else {
                        phi_481_ = -1i;
                    }
                    let _e311 = phi_481_;
                    phi_484_ = type_7(0u, 32u);
                    let _e518 = local_4;
                    phi_487_ = _e518;
                    phi_489_ = 0i;
                    loop {
                        let _e313 = phi_484_;
                        let _e315 = phi_487_;
                        let _e317 = phi_489_;
                        local_2 = _e317;
                        if (_e313.member < _e313.member_1) {
                            phi_485_ = type_7((_e313.member + 1u), _e313.member_1);
                            phi_512_ = type_7(1u, _e313.member);
                        } else {
                            phi_485_ = _e313;
                            phi_512_ = type_7(0u, type_7().member_1);
                        }
                        let _e330 = phi_485_;
                        let _e332 = phi_512_;
                        if (bitcast<i32>(_e332.member) != 0i) {
                            let _e337 = ((_e315 + 1i) / 2i);
                            let _e338 = (_e317 + _e337);
                            let _e341 = (_e50 + bitcast<u32>((_e338 * _e136.member)));
                            let _e342 = (_e341 < _e38);
                            if _e342 {
                                let _e343 = (_e50 < _e38);
                                if _e343 {
                                    if _e343 {
                                    } else {
                                        phi_758_ = true;
                                        phi_727_ = bool();
                                        phi_725_ = i32();
                                        break;
                                    }
                                    let _e346 = global_2.member[_e50];
                                    phi_546_ = _e346;
                                } else {
                                    phi_546_ = 0u;
                                }
                                let _e348 = phi_546_;
                                if _e342 {
                                    if _e342 {
                                    } else {
                                        phi_758_ = true;
                                        phi_727_ = bool();
                                        phi_725_ = i32();
                                        break;
                                    }
                                    let _e351 = global_2.member[_e341];
                                    phi_558_ = _e351;
                                } else {
                                    phi_558_ = 0u;
                                }
                                let _e353 = phi_558_;
                                let _e354 = (_e348 ^ _e353);
                                let _e355 = (_e354 == 0u);
                                if _e355 {
                                    phi_566_ = (_e50 ^ _e341);
                                } else {
                                    phi_566_ = _e354;
                                }
                                let _e358 = phi_566_;
                                phi_573_ = (select(0i, 32i, _e355) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e358)), 32u, (_e358 == 0u))));
                            } else {
                                phi_573_ = -1i;
                            }
                            let _e368 = phi_573_;
                            let _e371 = (_e337 <= 1i);
                            phi_585_ = select(_e317, _e338, (_e368 > _e311));
                            phi_488_ = _e337;
                            phi_586_ = select(true, false, _e371);
                            phi_587_ = _e371;
                        } else {
                            phi_585_ = i32();
                            phi_488_ = i32();
                            phi_586_ = false;
                            phi_587_ = false;
                        }
                        let _e374 = phi_585_;
                        let _e376 = phi_488_;
                        let _e378 = phi_586_;
                        let _e380 = phi_587_;
                        continue;
                        continuing {
                            phi_484_ = _e330;
                            phi_487_ = _e376;
                            phi_489_ = _e374;
                            phi_758_ = _e279;
                            phi_727_ = _e380;
                            phi_725_ = _e374;
                            break if !(_e378);
                        }
                    }
                    let _e383 = phi_758_;
                    let _e385 = phi_727_;
                    let _e387 = phi_725_;
                    if _e383 {
                        break;
                    }
                    let _e389 = local_2;
                    let _e391 = (_e136.member > 0i);
                    let _e392 = select(_e284, _e50, _e391);
                    let _e393 = select(_e50, _e284, _e391);
                    let _e399 = ((_e50 + bitcast<u32>((select(_e389, _e387, _e385) * _e136.member))) - select(0u, 1u, (_e136.member < 0i)));
                    let _e401 = ((_e399 - _e392) + 1u);
                    if (_e401 > 4u) {
                        let _e408 = (_e399 >> bitcast<u32>(5i));
                        let _e409 = (_e408 < _e40);
                        if _e409 {
                            if _e409 {
                            } else {
                                break;
                            }
                            let _e412 = global_3.member[_e408];
                            phi_625_ = _e412;
                        } else {
                            phi_625_ = 0u;
                        }
                        let _e414 = phi_625_;
                        let _e421 = (_e408 < _e42);
                        if _e421 {
                            if _e421 {
                            } else {
                                break;
                            }
                            let _e424 = global_1.member[_e408];
                            phi_642_ = _e424;
                        } else {
                            phi_642_ = 0u;
                        }
                        let _e426 = phi_642_;
                        phi_648_ = (_e426 + countOneBits((_e414 & ~((4294967295u << bitcast<u32>(((_e399 & 31u) & 31u)))))));
                    } else {
                        phi_648_ = ((2147483648u | (_e401 << bitcast<u32>(28u))) | _e392);
                    }
                    let _e430 = phi_648_;
                    let _e431 = (_e393 - _e399);
                    if (_e431 > 4u) {
                        let _e438 = (_e399 + 1u);
                        let _e440 = (_e438 >> bitcast<u32>(5i));
                        let _e441 = (_e440 < _e40);
                        if _e441 {
                            if _e441 {
                            } else {
                                break;
                            }
                            let _e444 = global_3.member[_e440];
                            phi_667_ = _e444;
                        } else {
                            phi_667_ = 0u;
                        }
                        let _e446 = phi_667_;
                        let _e453 = (_e440 < _e42);
                        if _e453 {
                            if _e453 {
                            } else {
                                break;
                            }
                            let _e456 = global_1.member[_e440];
                            phi_684_ = _e456;
                        } else {
                            phi_684_ = 0u;
                        }
                        let _e458 = phi_684_;
                        phi_691_ = (_e458 + countOneBits((_e446 & ~((4294967295u << bitcast<u32>(((_e438 & 31u) & 31u)))))));
                    } else {
                        phi_691_ = ((2147483648u | (_e431 << bitcast<u32>(28u))) | (_e399 + 1u));
                    }
                    let _e462 = phi_691_;
                    let _e464 = (_e75 < arrayLength((&global_4.member)));
                    if _e464 {
                        let _e465 = (_e75 < arrayLength((&global_5.member)));
                        if _e465 {
                            if _e464 {
                            } else {
                                break;
                            }
                            global_4.member[_e75] = type_13(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e430, _e462, _e392, _e393);
                            if _e465 {
                            } else {
                                break;
                            }
                            global_5.member[_e75] = _e399;
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
fn topology_nodes_30_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
