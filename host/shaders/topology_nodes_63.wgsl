struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 2>>,
}

struct type_18 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_23 {
    member: i32,
    member_1: i32,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_4;
@group(0) @binding(0) 
var<storage> global_2: type_13;
@group(0) @binding(1) 
var<storage> global_3: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_20;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;

fn function_() {
    var phi_140_: u32;
    var phi_160_: array<u32, 2>;
    var phi_174_: array<u32, 2>;
    var phi_189_: u32;
    var phi_190_: i32;
    var phi_191_: u32;
    var phi_198_: i32;
    var phi_216_: array<u32, 2>;
    var phi_230_: array<u32, 2>;
    var phi_245_: u32;
    var phi_246_: i32;
    var phi_247_: u32;
    var phi_254_: i32;
    var phi_261_: type_23;
    var phi_267_: type_7;
    var phi_270_: i32;
    var phi_268_: type_7;
    var phi_293_: type_7;
    var phi_319_: array<u32, 2>;
    var phi_333_: array<u32, 2>;
    var phi_348_: u32;
    var phi_349_: i32;
    var phi_350_: u32;
    var phi_357_: i32;
    var phi_363_: i32;
    var phi_271_: i32;
    var phi_365_: bool;
    var phi_803_: bool;
    var local: i32;
    var phi_375_: type_7;
    var phi_378_: i32;
    var phi_380_: i32;
    var phi_376_: type_7;
    var phi_403_: type_7;
    var phi_433_: array<u32, 2>;
    var phi_447_: array<u32, 2>;
    var phi_462_: u32;
    var phi_463_: i32;
    var phi_464_: u32;
    var phi_471_: i32;
    var phi_485_: i32;
    var phi_486_: i32;
    var phi_379_: i32;
    var phi_381_: i32;
    var phi_488_: bool;
    var phi_826_: bool;
    var local_1: i32;
    var phi_507_: array<u32, 2>;
    var phi_521_: array<u32, 2>;
    var phi_536_: u32;
    var phi_537_: i32;
    var phi_538_: u32;
    var phi_545_: i32;
    var phi_548_: type_7;
    var phi_551_: i32;
    var phi_553_: i32;
    var phi_549_: type_7;
    var phi_576_: type_7;
    var phi_610_: array<u32, 2>;
    var phi_624_: array<u32, 2>;
    var phi_639_: u32;
    var phi_640_: i32;
    var phi_641_: u32;
    var phi_648_: i32;
    var phi_660_: i32;
    var phi_552_: i32;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_837_: bool;
    var phi_802_: bool;
    var phi_800_: i32;
    var local_2: i32;
    var phi_700_: u32;
    var phi_717_: u32;
    var phi_723_: u32;
    var phi_742_: u32;
    var phi_759_: u32;
    var phi_766_: u32;
    var local_3: i32;
    var local_4: i32;

    switch bitcast<i32>(0u) {
        default: {
            let _e39 = global;
            let _e41 = arrayLength((&global_2.member));
            let _e43 = arrayLength((&global_3.member));
            let _e45 = arrayLength((&global_1.member));
            let _e53 = (_e39.x + (_e39.y * 2097152u));
            let _e55 = (_e53 >> bitcast<u32>(5i));
            let _e56 = (_e55 < _e43);
            if _e56 {
                if _e56 {
                } else {
                    break;
                }
                let _e59 = global_3.member[_e55];
                let _e61 = ((_e53 & 31u) & 31u);
                if (((_e59 >> bitcast<u32>(_e61)) & 1u) == 1u) {
                    if _e56 {
                        if _e56 {
                        } else {
                            break;
                        }
                    }
                    let _e71 = (_e55 < _e45);
                    if _e71 {
                        if _e71 {
                        } else {
                            break;
                        }
                        let _e74 = global_1.member[_e55];
                        phi_140_ = _e74;
                    } else {
                        phi_140_ = 0u;
                    }
                    let _e76 = phi_140_;
                    let _e78 = (_e76 + countOneBits((select(0u, _e59, _e56) & ~((4294967295u << bitcast<u32>(_e61))))));
                    let _e79 = (_e53 + 1u);
                    let _e80 = (_e79 < _e41);
                    if _e80 {
                        let _e81 = (_e53 < _e41);
                        if _e81 {
                            if _e81 {
                            } else {
                                break;
                            }
                            let _e84 = global_2.member[_e53];
                            phi_160_ = _e84;
                        } else {
                            phi_160_ = array<u32, 2>(0u, 0u);
                        }
                        let _e86 = phi_160_;
                        if _e80 {
                            if _e80 {
                            } else {
                                break;
                            }
                            let _e91 = global_2.member[_e79];
                            phi_174_ = _e91;
                        } else {
                            phi_174_ = array<u32, 2>(0u, 0u);
                        }
                        let _e93 = phi_174_;
                        let _e96 = (_e86[0] ^ _e93[0]);
                        let _e97 = (_e86[1] ^ _e93[1]);
                        if (_e96 == 0u) {
                            let _e99 = (_e97 == 0u);
                            if _e99 {
                                phi_189_ = (_e53 ^ _e79);
                            } else {
                                phi_189_ = _e97;
                            }
                            let _e102 = phi_189_;
                            phi_190_ = select(32i, 64i, _e99);
                            phi_191_ = _e102;
                        } else {
                            phi_190_ = 0i;
                            phi_191_ = _e96;
                        }
                        let _e105 = phi_190_;
                        let _e107 = phi_191_;
                        phi_198_ = (_e105 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e107)), 32u, (_e107 == 0u))));
                    } else {
                        phi_198_ = -1i;
                    }
                    let _e116 = phi_198_;
                    let _e117 = (_e53 + 4294967295u);
                    let _e118 = (_e117 < _e41);
                    if _e118 {
                        let _e119 = (_e53 < _e41);
                        if _e119 {
                            if _e119 {
                            } else {
                                break;
                            }
                            let _e122 = global_2.member[_e53];
                            phi_216_ = _e122;
                        } else {
                            phi_216_ = array<u32, 2>(0u, 0u);
                        }
                        let _e124 = phi_216_;
                        if _e118 {
                            if _e118 {
                            } else {
                                break;
                            }
                            let _e129 = global_2.member[_e117];
                            phi_230_ = _e129;
                        } else {
                            phi_230_ = array<u32, 2>(0u, 0u);
                        }
                        let _e131 = phi_230_;
                        let _e134 = (_e124[0] ^ _e131[0]);
                        let _e135 = (_e124[1] ^ _e131[1]);
                        if (_e134 == 0u) {
                            let _e137 = (_e135 == 0u);
                            if _e137 {
                                phi_245_ = (_e53 ^ _e117);
                            } else {
                                phi_245_ = _e135;
                            }
                            let _e140 = phi_245_;
                            phi_246_ = select(32i, 64i, _e137);
                            phi_247_ = _e140;
                        } else {
                            phi_246_ = 0i;
                            phi_247_ = _e134;
                        }
                        let _e143 = phi_246_;
                        let _e145 = phi_247_;
                        phi_254_ = (_e143 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e145)), 32u, (_e145 == 0u))));
                    } else {
                        phi_254_ = -1i;
                    }
                    let _e154 = phi_254_;
                    if (_e116 > _e154) {
                        phi_261_ = type_23(1i, _e154);
                    } else {
                        phi_261_ = type_23(-1i, _e116);
                    }
                    let _e159 = phi_261_;
                    phi_267_ = type_7(0u, 31u);
                    phi_270_ = 4i;
                    loop {
                        let _e163 = phi_267_;
                        let _e165 = phi_270_;
                        local = _e165;
                        local_3 = _e165;
                        if (_e163.member < _e163.member_1) {
                            phi_268_ = type_7((_e163.member + 1u), _e163.member_1);
                            phi_293_ = type_7(1u, _e163.member);
                        } else {
                            phi_268_ = _e163;
                            phi_293_ = type_7(0u, type_7().member_1);
                        }
                        let _e178 = phi_268_;
                        let _e180 = phi_293_;
                        if (bitcast<i32>(_e180.member) != 0i) {
                            let _e187 = (_e53 + bitcast<u32>(((2i * _e165) * _e159.member)));
                            let _e188 = (_e187 < _e41);
                            if _e188 {
                                let _e189 = (_e53 < _e41);
                                if _e189 {
                                    if _e189 {
                                    } else {
                                        phi_803_ = true;
                                        break;
                                    }
                                    let _e192 = global_2.member[_e53];
                                    phi_319_ = _e192;
                                } else {
                                    phi_319_ = array<u32, 2>(0u, 0u);
                                }
                                let _e194 = phi_319_;
                                if _e188 {
                                    if _e188 {
                                    } else {
                                        phi_803_ = true;
                                        break;
                                    }
                                    let _e199 = global_2.member[_e187];
                                    phi_333_ = _e199;
                                } else {
                                    phi_333_ = array<u32, 2>(0u, 0u);
                                }
                                let _e201 = phi_333_;
                                let _e204 = (_e194[0] ^ _e201[0]);
                                let _e205 = (_e194[1] ^ _e201[1]);
                                if (_e204 == 0u) {
                                    let _e207 = (_e205 == 0u);
                                    if _e207 {
                                        phi_348_ = (_e53 ^ _e187);
                                    } else {
                                        phi_348_ = _e205;
                                    }
                                    let _e210 = phi_348_;
                                    phi_349_ = select(32i, 64i, _e207);
                                    phi_350_ = _e210;
                                } else {
                                    phi_349_ = 0i;
                                    phi_350_ = _e204;
                                }
                                let _e213 = phi_349_;
                                let _e215 = phi_350_;
                                phi_357_ = (_e213 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e215)), 32u, (_e215 == 0u))));
                            } else {
                                phi_357_ = -1i;
                            }
                            let _e224 = phi_357_;
                            let _e225 = (_e224 <= _e159.member_1);
                            if _e225 {
                                phi_363_ = i32();
                            } else {
                                phi_363_ = (_e165 * 2i);
                            }
                            let _e228 = phi_363_;
                            phi_271_ = _e228;
                            phi_365_ = select(true, false, _e225);
                        } else {
                            phi_271_ = i32();
                            phi_365_ = false;
                        }
                        let _e231 = phi_271_;
                        let _e233 = phi_365_;
                        continue;
                        continuing {
                            phi_267_ = _e178;
                            phi_270_ = _e231;
                            phi_803_ = false;
                            break if !(_e233);
                        }
                    }
                    let _e236 = phi_803_;
                    if _e236 {
                        break;
                    }
                    let _e238 = local;
                    phi_375_ = type_7(0u, 31u);
                    phi_378_ = (_e238 / 2i);
                    let _e566 = local_3;
                    phi_380_ = _e566;
                    loop {
                        let _e241 = phi_375_;
                        let _e243 = phi_378_;
                        let _e245 = phi_380_;
                        local_1 = _e245;
                        local_4 = _e245;
                        if (_e241.member < _e241.member_1) {
                            phi_376_ = type_7((_e241.member + 1u), _e241.member_1);
                            phi_403_ = type_7(1u, _e241.member);
                        } else {
                            phi_376_ = _e241;
                            phi_403_ = type_7(0u, type_7().member_1);
                        }
                        let _e258 = phi_376_;
                        let _e260 = phi_403_;
                        if (bitcast<i32>(_e260.member) != 0i) {
                            let _e264 = (_e243 == 0i);
                            if _e264 {
                                phi_485_ = i32();
                                phi_486_ = i32();
                            } else {
                                let _e265 = (_e245 + _e243);
                                let _e268 = (_e53 + bitcast<u32>((_e265 * _e159.member)));
                                let _e269 = (_e268 < _e41);
                                if _e269 {
                                    let _e270 = (_e53 < _e41);
                                    if _e270 {
                                        if _e270 {
                                        } else {
                                            phi_826_ = true;
                                            break;
                                        }
                                        let _e273 = global_2.member[_e53];
                                        phi_433_ = _e273;
                                    } else {
                                        phi_433_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e275 = phi_433_;
                                    if _e269 {
                                        if _e269 {
                                        } else {
                                            phi_826_ = true;
                                            break;
                                        }
                                        let _e280 = global_2.member[_e268];
                                        phi_447_ = _e280;
                                    } else {
                                        phi_447_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e282 = phi_447_;
                                    let _e285 = (_e275[0] ^ _e282[0]);
                                    let _e286 = (_e275[1] ^ _e282[1]);
                                    if (_e285 == 0u) {
                                        let _e288 = (_e286 == 0u);
                                        if _e288 {
                                            phi_462_ = (_e53 ^ _e268);
                                        } else {
                                            phi_462_ = _e286;
                                        }
                                        let _e291 = phi_462_;
                                        phi_463_ = select(32i, 64i, _e288);
                                        phi_464_ = _e291;
                                    } else {
                                        phi_463_ = 0i;
                                        phi_464_ = _e285;
                                    }
                                    let _e294 = phi_463_;
                                    let _e296 = phi_464_;
                                    phi_471_ = (_e294 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e296)), 32u, (_e296 == 0u))));
                                } else {
                                    phi_471_ = -1i;
                                }
                                let _e305 = phi_471_;
                                phi_485_ = (_e243 / 2i);
                                phi_486_ = select(_e245, _e265, (_e305 > _e159.member_1));
                            }
                            let _e310 = phi_485_;
                            let _e312 = phi_486_;
                            phi_379_ = _e310;
                            phi_381_ = _e312;
                            phi_488_ = select(true, false, _e264);
                        } else {
                            phi_379_ = i32();
                            phi_381_ = i32();
                            phi_488_ = false;
                        }
                        let _e315 = phi_379_;
                        let _e317 = phi_381_;
                        let _e319 = phi_488_;
                        continue;
                        continuing {
                            phi_375_ = _e258;
                            phi_378_ = _e315;
                            phi_380_ = _e317;
                            phi_826_ = _e236;
                            break if !(_e319);
                        }
                    }
                    let _e322 = phi_826_;
                    if _e322 {
                        break;
                    }
                    let _e324 = local_1;
                    let _e327 = (_e53 + bitcast<u32>((_e324 * _e159.member)));
                    let _e328 = (_e327 < _e41);
                    if _e328 {
                        let _e329 = (_e53 < _e41);
                        if _e329 {
                            if _e329 {
                            } else {
                                break;
                            }
                            let _e332 = global_2.member[_e53];
                            phi_507_ = _e332;
                        } else {
                            phi_507_ = array<u32, 2>(0u, 0u);
                        }
                        let _e334 = phi_507_;
                        if _e328 {
                            if _e328 {
                            } else {
                                break;
                            }
                            let _e339 = global_2.member[_e327];
                            phi_521_ = _e339;
                        } else {
                            phi_521_ = array<u32, 2>(0u, 0u);
                        }
                        let _e341 = phi_521_;
                        let _e344 = (_e334[0] ^ _e341[0]);
                        let _e345 = (_e334[1] ^ _e341[1]);
                        if (_e344 == 0u) {
                            let _e347 = (_e345 == 0u);
                            if _e347 {
                                phi_536_ = (_e53 ^ _e327);
                            } else {
                                phi_536_ = _e345;
                            }
                            let _e350 = phi_536_;
                            phi_537_ = select(32i, 64i, _e347);
                            phi_538_ = _e350;
                        } else {
                            phi_537_ = 0i;
                            phi_538_ = _e344;
                        }
                        let _e353 = phi_537_;
                        let _e355 = phi_538_;
                        phi_545_ = (_e353 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e355)), 32u, (_e355 == 0u))));
                    } else {
                        phi_545_ = -1i;
                    }
                    let _e364 = phi_545_;
                    phi_548_ = type_7(0u, 32u);
                    let _e591 = local_4;
                    phi_551_ = _e591;
                    phi_553_ = 0i;
                    loop {
                        let _e366 = phi_548_;
                        let _e368 = phi_551_;
                        let _e370 = phi_553_;
                        local_2 = _e370;
                        if (_e366.member < _e366.member_1) {
                            phi_549_ = type_7((_e366.member + 1u), _e366.member_1);
                            phi_576_ = type_7(1u, _e366.member);
                        } else {
                            phi_549_ = _e366;
                            phi_576_ = type_7(0u, type_7().member_1);
                        }
                        let _e383 = phi_549_;
                        let _e385 = phi_576_;
                        if (bitcast<i32>(_e385.member) != 0i) {
                            let _e390 = ((_e368 + 1i) / 2i);
                            let _e391 = (_e370 + _e390);
                            let _e394 = (_e53 + bitcast<u32>((_e391 * _e159.member)));
                            let _e395 = (_e394 < _e41);
                            if _e395 {
                                let _e396 = (_e53 < _e41);
                                if _e396 {
                                    if _e396 {
                                    } else {
                                        phi_837_ = true;
                                        phi_802_ = bool();
                                        phi_800_ = i32();
                                        break;
                                    }
                                    let _e399 = global_2.member[_e53];
                                    phi_610_ = _e399;
                                } else {
                                    phi_610_ = array<u32, 2>(0u, 0u);
                                }
                                let _e401 = phi_610_;
                                if _e395 {
                                    if _e395 {
                                    } else {
                                        phi_837_ = true;
                                        phi_802_ = bool();
                                        phi_800_ = i32();
                                        break;
                                    }
                                    let _e406 = global_2.member[_e394];
                                    phi_624_ = _e406;
                                } else {
                                    phi_624_ = array<u32, 2>(0u, 0u);
                                }
                                let _e408 = phi_624_;
                                let _e411 = (_e401[0] ^ _e408[0]);
                                let _e412 = (_e401[1] ^ _e408[1]);
                                if (_e411 == 0u) {
                                    let _e414 = (_e412 == 0u);
                                    if _e414 {
                                        phi_639_ = (_e53 ^ _e394);
                                    } else {
                                        phi_639_ = _e412;
                                    }
                                    let _e417 = phi_639_;
                                    phi_640_ = select(32i, 64i, _e414);
                                    phi_641_ = _e417;
                                } else {
                                    phi_640_ = 0i;
                                    phi_641_ = _e411;
                                }
                                let _e420 = phi_640_;
                                let _e422 = phi_641_;
                                phi_648_ = (_e420 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e422)), 32u, (_e422 == 0u))));
                            } else {
                                phi_648_ = -1i;
                            }
                            let _e431 = phi_648_;
                            let _e434 = (_e390 <= 1i);
                            phi_660_ = select(_e370, _e391, (_e431 > _e364));
                            phi_552_ = _e390;
                            phi_661_ = select(true, false, _e434);
                            phi_662_ = _e434;
                        } else {
                            phi_660_ = i32();
                            phi_552_ = i32();
                            phi_661_ = false;
                            phi_662_ = false;
                        }
                        let _e437 = phi_660_;
                        let _e439 = phi_552_;
                        let _e441 = phi_661_;
                        let _e443 = phi_662_;
                        continue;
                        continuing {
                            phi_548_ = _e383;
                            phi_551_ = _e439;
                            phi_553_ = _e437;
                            phi_837_ = _e322;
                            phi_802_ = _e443;
                            phi_800_ = _e437;
                            break if !(_e441);
                        }
                    }
                    let _e446 = phi_837_;
                    let _e448 = phi_802_;
                    let _e450 = phi_800_;
                    if _e446 {
                        break;
                    }
                    let _e452 = local_2;
                    let _e454 = (_e159.member > 0i);
                    let _e455 = select(_e327, _e53, _e454);
                    let _e456 = select(_e53, _e327, _e454);
                    let _e462 = ((_e53 + bitcast<u32>((select(_e452, _e450, _e448) * _e159.member))) - select(0u, 1u, (_e159.member < 0i)));
                    let _e464 = ((_e462 - _e455) + 1u);
                    if (_e464 > 4u) {
                        let _e471 = (_e462 >> bitcast<u32>(5i));
                        let _e472 = (_e471 < _e43);
                        if _e472 {
                            if _e472 {
                            } else {
                                break;
                            }
                            let _e475 = global_3.member[_e471];
                            phi_700_ = _e475;
                        } else {
                            phi_700_ = 0u;
                        }
                        let _e477 = phi_700_;
                        let _e484 = (_e471 < _e45);
                        if _e484 {
                            if _e484 {
                            } else {
                                break;
                            }
                            let _e487 = global_1.member[_e471];
                            phi_717_ = _e487;
                        } else {
                            phi_717_ = 0u;
                        }
                        let _e489 = phi_717_;
                        phi_723_ = (_e489 + countOneBits((_e477 & ~((4294967295u << bitcast<u32>(((_e462 & 31u) & 31u)))))));
                    } else {
                        phi_723_ = ((2147483648u | (_e464 << bitcast<u32>(28u))) | _e455);
                    }
                    let _e493 = phi_723_;
                    let _e494 = (_e456 - _e462);
                    if (_e494 > 4u) {
                        let _e501 = (_e462 + 1u);
                        let _e503 = (_e501 >> bitcast<u32>(5i));
                        let _e504 = (_e503 < _e43);
                        if _e504 {
                            if _e504 {
                            } else {
                                break;
                            }
                            let _e507 = global_3.member[_e503];
                            phi_742_ = _e507;
                        } else {
                            phi_742_ = 0u;
                        }
                        let _e509 = phi_742_;
                        let _e516 = (_e503 < _e45);
                        if _e516 {
                            if _e516 {
                            } else {
                                break;
                            }
                            let _e519 = global_1.member[_e503];
                            phi_759_ = _e519;
                        } else {
                            phi_759_ = 0u;
                        }
                        let _e521 = phi_759_;
                        phi_766_ = (_e521 + countOneBits((_e509 & ~((4294967295u << bitcast<u32>(((_e501 & 31u) & 31u)))))));
                    } else {
                        phi_766_ = ((2147483648u | (_e494 << bitcast<u32>(28u))) | (_e462 + 1u));
                    }
                    let _e525 = phi_766_;
                    let _e527 = (_e78 < arrayLength((&global_4.member)));
                    if _e527 {
                        let _e528 = (_e78 < arrayLength((&global_5.member)));
                        if _e528 {
                            if _e527 {
                            } else {
                                break;
                            }
                            global_4.member[_e78] = type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e493, _e525, _e455, _e456);
                            if _e528 {
                            } else {
                                break;
                            }
                            global_5.member[_e78] = _e462;
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
fn topology_nodes_63_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
