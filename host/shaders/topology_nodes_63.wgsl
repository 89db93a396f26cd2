struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<u32, 2>>,
}

struct type_23 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_28 {
    member: i32,
    member_1: i32,
}

struct type_29 {
    member: type_23,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(1) 
var<storage> global_3: type_17;
@group(0) @binding(2) 
var<storage> global_4: type_4;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

fn function_() {
    var phi_125_: u32;
    var phi_146_: u32;
    var phi_163_: u32;
    var phi_211_: array<u32, 2>;
    var phi_227_: array<u32, 2>;
    var phi_242_: u32;
    var phi_243_: i32;
    var phi_244_: u32;
    var phi_251_: i32;
    var phi_271_: array<u32, 2>;
    var phi_287_: array<u32, 2>;
    var phi_302_: u32;
    var phi_303_: i32;
    var phi_304_: u32;
    var phi_311_: i32;
    var phi_318_: type_28;
    var phi_324_: type_7;
    var phi_327_: i32;
    var phi_325_: type_7;
    var phi_350_: type_7;
    var phi_378_: array<u32, 2>;
    var phi_394_: array<u32, 2>;
    var phi_409_: u32;
    var phi_410_: i32;
    var phi_411_: u32;
    var phi_418_: i32;
    var phi_424_: i32;
    var phi_328_: i32;
    var phi_426_: bool;
    var phi_880_: bool;
    var local: i32;
    var phi_436_: type_7;
    var phi_439_: i32;
    var phi_441_: i32;
    var phi_437_: type_7;
    var phi_464_: type_7;
    var phi_496_: array<u32, 2>;
    var phi_512_: array<u32, 2>;
    var phi_527_: u32;
    var phi_528_: i32;
    var phi_529_: u32;
    var phi_536_: i32;
    var phi_550_: i32;
    var phi_551_: i32;
    var phi_440_: i32;
    var phi_442_: i32;
    var phi_553_: bool;
    var phi_904_: bool;
    var local_1: i32;
    var phi_574_: array<u32, 2>;
    var phi_590_: array<u32, 2>;
    var phi_605_: u32;
    var phi_606_: i32;
    var phi_607_: u32;
    var phi_614_: i32;
    var phi_617_: type_7;
    var phi_620_: i32;
    var phi_622_: i32;
    var phi_618_: type_7;
    var phi_645_: type_7;
    var phi_681_: array<u32, 2>;
    var phi_697_: array<u32, 2>;
    var phi_712_: u32;
    var phi_713_: i32;
    var phi_714_: u32;
    var phi_721_: i32;
    var phi_733_: i32;
    var phi_621_: i32;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_915_: bool;
    var phi_879_: bool;
    var phi_877_: i32;
    var local_2: i32;
    var phi_773_: u32;
    var phi_790_: u32;
    var phi_796_: u32;
    var phi_815_: u32;
    var phi_832_: u32;
    var phi_839_: u32;
    var phi_190_: u32;
    var phi_843_: type_29;
    var local_3: i32;
    var local_4: i32;

    switch bitcast<i32>(0u) {
        default: {
            let _e43 = global;
            let _e46 = arrayLength((&global_3.member));
            let _e48 = arrayLength((&global_4.member));
            let _e50 = arrayLength((&global_5.member));
            let _e58 = (_e43.x + (_e43.y * 2097152u));
            let _e61 = global_1.member[0u];
            let _e63 = (_e58 >> bitcast<u32>(5i));
            let _e64 = (_e63 < _e48);
            if _e64 {
                if _e64 {
                } else {
                    break;
                }
                let _e67 = global_4.member[_e63];
                phi_125_ = _e67;
            } else {
                phi_125_ = 0u;
            }
            let _e69 = phi_125_;
            let _e71 = ((_e58 & 31u) & 31u);
            if (((_e69 >> bitcast<u32>(_e71)) & 1u) == 1u) {
                if _e64 {
                    if _e64 {
                    } else {
                        break;
                    }
                    let _e78 = global_4.member[_e63];
                    phi_146_ = _e78;
                } else {
                    phi_146_ = 0u;
                }
                let _e80 = phi_146_;
                let _e85 = (_e63 < _e50);
                if _e85 {
                    if _e85 {
                    } else {
                        break;
                    }
                    let _e88 = global_5.member[_e63];
                    phi_163_ = _e88;
                } else {
                    phi_163_ = 0u;
                }
                let _e90 = phi_163_;
                let _e92 = (_e90 + countOneBits((_e80 & ~((4294967295u << bitcast<u32>(_e71))))));
                if (_e61 <= 6u) {
                    let _e539 = (2147483648u | (_e61 << bitcast<u32>(28u)));
                    if ((_e539 & 2147483648u) != 0u) {
                        phi_190_ = (((_e539 & 268435455u) + ((_e539 >> bitcast<u32>(28u)) & 7u)) - 1u);
                    } else {
                        phi_190_ = 0u;
                    }
                    let _e553 = phi_190_;
                    phi_843_ = type_29(type_23(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e539, 2147483648u, 0u, (_e61 - select(0u, 1u, (_e61 > 0u)))), _e553);
                } else {
                    let _e94 = (_e58 + 1u);
                    if (_e94 < _e61) {
                        let _e96 = (_e58 < _e46);
                        if _e96 {
                            if _e96 {
                            } else {
                                break;
                            }
                            let _e98 = global_3.member[_e58];
                            phi_211_ = _e98;
                        } else {
                            phi_211_ = array<u32, 2>(0u, 0u);
                        }
                        let _e100 = phi_211_;
                        let _e103 = (_e94 < _e46);
                        if _e103 {
                            if _e103 {
                            } else {
                                break;
                            }
                            let _e105 = global_3.member[_e94];
                            phi_227_ = _e105;
                        } else {
                            phi_227_ = array<u32, 2>(0u, 0u);
                        }
                        let _e107 = phi_227_;
                        let _e110 = (_e100[0] ^ _e107[0]);
                        let _e111 = (_e100[1] ^ _e107[1]);
                        if (_e110 == 0u) {
                            let _e113 = (_e111 == 0u);
                            if _e113 {
                                phi_242_ = (_e58 ^ _e94);
                            } else {
                                phi_242_ = _e111;
                            }
                            let _e116 = phi_242_;
                            phi_243_ = select(32i, 64i, _e113);
                            phi_244_ = _e116;
                        } else {
                            phi_243_ = 0i;
                            phi_244_ = _e110;
                        }
                        let _e119 = phi_243_;
                        let _e121 = phi_244_;
                        phi_251_ = (_e119 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e121)), 32u, (_e121 == 0u))));
                    } else {
                        phi_251_ = -1i;
                    }
                    let _e130 = phi_251_;
                    let _e131 = (_e58 + 4294967295u);
                    if (_e131 < _e61) {
                        let _e133 = (_e58 < _e46);
                        if _e133 {
                            if _e133 {
                            } else {
                                break;
                            }
                            let _e135 = global_3.member[_e58];
                            phi_271_ = _e135;
                        } else {
                            phi_271_ = array<u32, 2>(0u, 0u);
                        }
                        let _e137 = phi_271_;
                        let _e140 = (_e131 < _e46);
                        if _e140 {
                            if _e140 {
                            } else {
                                break;
                            }
                            let _e142 = global_3.member[_e131];
                            phi_287_ = _e142;
                        } else {
                            phi_287_ = array<u32, 2>(0u, 0u);
                        }
                        let _e144 = phi_287_;
                        let _e147 = (_e137[0] ^ _e144[0]);
                        let _e148 = (_e137[1] ^ _e144[1]);
                        if (_e147 == 0u) {
                            let _e150 = (_e148 == 0u);
                            if _e150 {
                                phi_302_ = (_e58 ^ _e131);
                            } else {
                                phi_302_ = _e148;
                            }
                            let _e153 = phi_302_;
                            phi_303_ = select(32i, 64i, _e150);
                            phi_304_ = _e153;
                        } else {
                            phi_303_ = 0i;
                            phi_304_ = _e147;
                        }
                        let _e156 = phi_303_;
                        let _e158 = phi_304_;
                        phi_311_ = (_e156 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e158)), 32u, (_e158 == 0u))));
                    } else {
                        phi_311_ = -1i;
                    }
                    let _e167 = phi_311_;
                    if (_e130 > _e167) {
                        phi_318_ = type_28(1i, _e167);
                    } else {
                        phi_318_ = type_28(-1i, _e130);
                    }
                    let _e172 = phi_318_;
                    phi_324_ = type_7(0u, 31u);
                    phi_327_ = 4i;
                    loop {
                        let _e176 = phi_324_;
                        let _e178 = phi_327_;
                        local = _e178;
                        local_3 = _e178;
                        if (_e176.member < _e176.member_1) {
                            phi_325_ = type_7((_e176.member + 1u), _e176.member_1);
                            phi_350_ = type_7(1u, _e176.member);
                        } else {
                            phi_325_ = _e176;
                            phi_350_ = type_7(0u, type_7().member_1);
                        }
                        let _e191 = phi_325_;
                        let _e193 = phi_350_;
                        if (bitcast<i32>(_e193.member) != 0i) {
                            let _e200 = (_e58 + bitcast<u32>(((2i * _e178) * _e172.member)));
                            if (_e200 < _e61) {
                                let _e202 = (_e58 < _e46);
                                if _e202 {
                                    if _e202 {
                                    } else {
                                        phi_880_ = true;
                                        break;
                                    }
                                    let _e204 = global_3.member[_e58];
                                    phi_378_ = _e204;
                                } else {
                                    phi_378_ = array<u32, 2>(0u, 0u);
                                }
                                let _e206 = phi_378_;
                                let _e209 = (_e200 < _e46);
                                if _e209 {
                                    if _e209 {
                                    } else {
                                        phi_880_ = true;
                                        break;
                                    }
                                    let _e211 = global_3.member[_e200];
                                    phi_394_ = _e211;
                                } else {
                                    phi_394_ = array<u32, 2>(0u, 0u);
                                }
                                let _e213 = phi_394_;
                                let _e216 = (_e206[0] ^ _e213[0]);
                                let _e217 = (_e206[1] ^ _e213[1]);
                                if (_e216 == 0u) {
                                    let _e219 = (_e217 == 0u);
                                    if _e219 {
                                        phi_409_ = (_e58 ^ _e200);
                                    } else {
                                        phi_409_ = _e217;
                                    }
                                    let _e222 = phi_409_;
                                    phi_410_ = select(32i, 64i, _e219);
                                    phi_411_ = _e222;
                                } else {
                                    phi_410_ = 0i;
                                    phi_411_ = _e216;
                                }
                                let _e225 = phi_410_;
                                let _e227 = phi_411_;
                                phi_418_ = (_e225 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                            } else {
                                phi_418_ = -1i;
                            }
                            let _e236 = phi_418_;
                            let _e237 = (_e236 <= _e172.member_1);
                            if _e237 {
                                phi_424_ = i32();
                            } else {
                                phi_424_ = (_e178 * 2i);
                            }
                            let _e240 = phi_424_;
                            phi_328_ = _e240;
                            phi_426_ = select(true, false, _e237);
                        } else {
                            phi_328_ = i32();
                            phi_426_ = false;
                        }
                        let _e243 = phi_328_;
                        let _e245 = phi_426_;
                        continue;
                        continuing {
                            phi_324_ = _e191;
                            phi_327_ = _e243;
                            phi_880_ = false;
                            break if !(_e245);
                        }
                    }
                    let _e248 = phi_880_;
                    if _e248 {
                        break;
                    }
                    let _e250 = local;
                    phi_436_ = type_7(0u, 31u);
                    phi_439_ = (_e250 / 2i);
                    let _e600 = local_3;
                    phi_441_ = _e600;
                    loop {
                        let _e253 = phi_436_;
                        let _e255 = phi_439_;
                        let _e257 = phi_441_;
                        local_1 = _e257;
                        local_4 = _e257;
                        if (_e253.member < _e253.member_1) {
                            phi_437_ = type_7((_e253.member + 1u), _e253.member_1);
                            phi_464_ = type_7(1u, _e253.member);
                        } else {
                            phi_437_ = _e253;
                            phi_464_ = type_7(0u, type_7().member_1);
                        }
                        let _e270 = phi_437_;
                        let _e272 = phi_464_;
                        if (bitcast<i32>(_e272.member) != 0i) {
                            let _e276 = (_e255 == 0i);
                            if _e276 {
                                phi_550_ = i32();
                                phi_551_ = i32();
                            } else {
                                let _e277 = (_e257 + _e255);
                                let _e280 = (_e58 + bitcast<u32>((_e277 * _e172.member)));
                                if (_e280 < _e61) {
                                    let _e282 = (_e58 < _e46);
                                    if _e282 {
                                        if _e282 {
                                        } else {
                                            phi_904_ = true;
                                            break;
                                        }
                                        let _e284 = global_3.member[_e58];
                                        phi_496_ = _e284;
                                    } else {
                                        phi_496_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e286 = phi_496_;
                                    let _e289 = (_e280 < _e46);
                                    if _e289 {
                                        if _e289 {
                                        } else {
                                            phi_904_ = true;
                                            break;
                                        }
                                        let _e291 = global_3.member[_e280];
                                        phi_512_ = _e291;
                                    } else {
                                        phi_512_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e293 = phi_512_;
                                    let _e296 = (_e286[0] ^ _e293[0]);
                                    let _e297 = (_e286[1] ^ _e293[1]);
                                    if (_e296 == 0u) {
                                        let _e299 = (_e297 == 0u);
                                        if _e299 {
                                            phi_527_ = (_e58 ^ _e280);
                                        } else {
                                            phi_527_ = _e297;
                                        }
                                        let _e302 = phi_527_;
                                        phi_528_ = select(32i, 64i, _e299);
                                        phi_529_ = _e302;
                                    } else {
                                        phi_528_ = 0i;
                                        phi_529_ = _e296;
                                    }
                                    let _e305 = phi_528_;
                                    let _e307 = phi_529_;
                                    phi_536_ = (_e305 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e307)), 32u, (_e307 == 0u))));
                                } else {
                                    phi_536_ = -1i;
                                }
                                let _e316 = phi_536_;
                                phi_550_ = (_e255 / 2i);
                                phi_551_ = select(_e257, _e277, (_e316 > _e172.member_1));
                            }
                            let _e321 = phi_550_;
                            let _e323 = phi_551_;
                            phi_440_ = _e321;
                            phi_442_ = _e323;
                            phi_553_ = select(true, false, _e276);
                        } else {
                            phi_440_ = i32();
                            phi_442_ = i32();
                            phi_553_ = false;
                        }
                        let _e326 = phi_440_;
                        let _e328 = phi_442_;
                        let _e330 = phi_553_;
                        continue;
                        continuing {
                            phi_436_ = _e270;
                            phi_439_ = _e326;
                            phi_441_ = _e328;
                            phi_904_ = _e248;
                            break if !(_e330);
                        }
                    }
                    let _e333 = phi_904_;
                    if _e333 {
                        break;
                    }
                    let _e335 = local_1;
                    let _e338 = (_e58 + bitcast<u32>((_e335 * _e172.member)));
                    if (_e338 < _e61) {
                        let _e340 = (_e58 < _e46);
                        if _e340 {
                            if _e340 {
                            } else {
                                break;
                            }
                            let _e342 = global_3.member[_e58];
                            phi_574_ = _e342;
                        } else {
                            phi_574_ = array<u32, 2>(0u, 0u);
                        }
                        let _e344 = phi_574_;
                        let _e347 = (_e338 < _e46);
                        if _e347 {
                            if _e347 {
                            } else {
                                break;
                            }
                            let _e349 = global_3.member[_e338];
                            phi_590_ = _e349;
                        } else {
                            phi_590_ = array<u32, 2>(0u, 0u);
                        }
                        let _e351 = phi_590_;
                        let _e354 = (_e344[0] ^ _e351[0]);
                        let _e355 = (_e344[1] ^ _e351[1]);
                        if (_e354 == 0u) {
                            let _e357 = (_e355 == 0u);
                            if _e357 {
                                phi_605_ = (_e58 ^ _e338);
                            } else {
                                phi_605_ = _e355;
                            }
                            let _e360 = phi_605_;
                            phi_606_ = select(32i, 64i, _e357);
                            phi_607_ = _e360;
                        } else {
                            phi_606_ = 0i;
                            phi_607_ = _e354;
                        }
                        let _e363 = phi_606_;
                        let _e365 = phi_607_;
                        phi_614_ = (_e363 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e365)), 32u, (_e365 == 0u))));
                    } else {
                        phi_614_ = -1i;
                    }
                    let _e374 = phi_614_;
                    phi_617_ = type_7(0u, 32u);
                    let _e625 = local_4;
                    phi_620_ = _e625;
                    phi_622_ = 0i;
                    loop {
                        let _e376 = phi_617_;
                        let _e378 = phi_620_;
                        let _e380 = phi_622_;
                        local_2 = _e380;
                        if (_e376.member < _e376.member_1) {
                            phi_618_ = type_7((_e376.member + 1u), _e376.member_1);
                            phi_645_ = type_7(1u, _e376.member);
                        } else {
                            phi_618_ = _e376;
                            phi_645_ = type_7(0u, type_7().member_1);
                        }
                        let _e393 = phi_618_;
                        let _e395 = phi_645_;
                        if (bitcast<i32>(_e395.member) != 0i) {
                            let _e400 = ((_e378 + 1i) / 2i);
                            let _e401 = (_e380 + _e400);
                            let _e404 = (_e58 + bitcast<u32>((_e401 * _e172.member)));
                            if (_e404 < _e61) {
                                let _e406 = (_e58 < _e46);
                                if _e406 {
                                    if _e406 {
                                    } else {
                                        phi_915_ = true;
                                        phi_879_ = bool();
                                        phi_877_ = i32();
                                        break;
                                    }
                                    let _e408 = global_3.member[_e58];
                                    phi_681_ = _e408;
                                } else {
                                    phi_681_ = array<u32, 2>(0u, 0u);
                                }
                                let _e410 = phi_681_;
                                let _e413 = (_e404 < _e46);
                                if _e413 {
                                    if _e413 {
                                    } else {
                                        phi_915_ = true;
                                        phi_879_ = bool();
                                        phi_877_ = i32();
                                        break;
                                    }
                                    let _e415 = global_3.member[_e404];
                                    phi_697_ = _e415;
                                } else {
                                    phi_697_ = array<u32, 2>(0u, 0u);
                                }
                                let _e417 = phi_697_;
                                let _e420 = (_e410[0] ^ _e417[0]);
                                let _e421 = (_e410[1] ^ _e417[1]);
                                if (_e420 == 0u) {
                                    let _e423 = (_e421 == 0u);
                                    if _e423 {
                                        phi_712_ = (_e58 ^ _e404);
                                    } else {
                                        phi_712_ = _e421;
                                    }
                                    let _e426 = phi_712_;
                                    phi_713_ = select(32i, 64i, _e423);
                                    phi_714_ = _e426;
                                } else {
                                    phi_713_ = 0i;
                                    phi_714_ = _e420;
                                }
                                let _e429 = phi_713_;
                                let _e431 = phi_714_;
                                phi_721_ = (_e429 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e431)), 32u, (_e431 == 0u))));
                            } else {
                                phi_721_ = -1i;
                            }
                            let _e440 = phi_721_;
                            let _e443 = (_e400 <= 1i);
                            phi_733_ = select(_e380, _e401, (_e440 > _e374));
                            phi_621_ = _e400;
                            phi_734_ = select(true, false, _e443);
                            phi_735_ = _e443;
                        } else {
                            phi_733_ = i32();
                            phi_621_ = i32();
                            phi_734_ = false;
                            phi_735_ = false;
                        }
                        let _e446 = phi_733_;
                        let _e448 = phi_621_;
                        let _e450 = phi_734_;
                        let _e452 = phi_735_;
                        continue;
                        continuing {
                            phi_617_ = _e393;
                            phi_620_ = _e448;
                            phi_622_ = _e446;
                            phi_915_ = _e333;
                            phi_879_ = _e452;
                            phi_877_ = _e446;
                            break if !(_e450);
                        }
                    }
                    let _e455 = phi_915_;
                    let _e457 = phi_879_;
                    let _e459 = phi_877_;
                    if _e455 {
                        break;
                    }
                    let _e461 = local_2;
                    let _e463 = (_e172.member > 0i);
                    let _e464 = select(_e338, _e58, _e463);
                    let _e465 = select(_e58, _e338, _e463);
                    let _e471 = ((_e58 + bitcast<u32>((select(_e461, _e459, _e457) * _e172.member))) - select(0u, 1u, (_e172.member < 0i)));
                    let _e473 = ((_e471 - _e464) + 1u);
                    if (_e473 > 6u) {
                        let _e480 = (_e471 >> bitcast<u32>(5i));
                        let _e481 = (_e480 < _e48);
                        if _e481 {
                            if _e481 {
                            } else {
                                break;
                            }
                            let _e484 = global_4.member[_e480];
                            phi_773_ = _e484;
                        } else {
                            phi_773_ = 0u;
                        }
                        let _e486 = phi_773_;
                        let _e493 = (_e480 < _e50);
                        if _e493 {
                            if _e493 {
                            } else {
                                break;
                            }
                            let _e496 = global_5.member[_e480];
                            phi_790_ = _e496;
                        } else {
                            phi_790_ = 0u;
                        }
                        let _e498 = phi_790_;
                        phi_796_ = (_e498 + countOneBits((_e486 & ~((4294967295u << bitcast<u32>(((_e471 & 31u) & 31u)))))));
                    } else {
                        phi_796_ = ((2147483648u | (_e473 << bitcast<u32>(28u))) | _e464);
                    }
                    let _e502 = phi_796_;
                    let _e503 = (_e465 - _e471);
                    if (_e503 > 6u) {
                        let _e510 = (_e471 + 1u);
                        let _e512 = (_e510 >> bitcast<u32>(5i));
                        let _e513 = (_e512 < _e48);
                        if _e513 {
                            if _e513 {
                            } else {
                                break;
                            }
                            let _e516 = global_4.member[_e512];
                            phi_815_ = _e516;
                        } else {
                            phi_815_ = 0u;
                        }
                        let _e518 = phi_815_;
                        let _e525 = (_e512 < _e50);
                        if _e525 {
                            if _e525 {
                            } else {
                                break;
                            }
                            let _e528 = global_5.member[_e512];
                            phi_832_ = _e528;
                        } else {
                            phi_832_ = 0u;
                        }
                        let _e530 = phi_832_;
                        phi_839_ = (_e530 + countOneBits((_e518 & ~((4294967295u << bitcast<u32>(((_e510 & 31u) & 31u)))))));
                    } else {
                        phi_839_ = ((2147483648u | (_e503 << bitcast<u32>(28u))) | (_e471 + 1u));
                    }
                    let _e534 = phi_839_;
                    phi_843_ = type_29(type_23(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e502, _e534, _e464, _e465), _e471);
                }
                let _e556 = phi_843_;
                let _e559 = (_e92 < arrayLength((&global_2.member)));
                if _e559 {
                    let _e560 = (_e92 < arrayLength((&global_6.member)));
                    if _e560 {
                        if _e559 {
                        } else {
                            break;
                        }
                        global_2.member[_e92] = _e556.member;
                        if _e560 {
                        } else {
                            break;
                        }
                        global_6.member[_e92] = _e556.member_1;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn topology_nodes_63_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
