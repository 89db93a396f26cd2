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
    var phi_124_: u32;
    var phi_145_: u32;
    var phi_162_: u32;
    var phi_210_: array<u32, 2>;
    var phi_226_: array<u32, 2>;
    var phi_241_: u32;
    var phi_242_: i32;
    var phi_243_: u32;
    var phi_250_: i32;
    var phi_270_: array<u32, 2>;
    var phi_286_: array<u32, 2>;
    var phi_301_: u32;
    var phi_302_: i32;
    var phi_303_: u32;
    var phi_310_: i32;
    var phi_317_: type_28;
    var phi_323_: type_7;
    var phi_326_: i32;
    var phi_324_: type_7;
    var phi_349_: type_7;
    var phi_377_: array<u32, 2>;
    var phi_393_: array<u32, 2>;
    var phi_408_: u32;
    var phi_409_: i32;
    var phi_410_: u32;
    var phi_417_: i32;
    var phi_423_: i32;
    var phi_327_: i32;
    var phi_425_: bool;
    var phi_879_: bool;
    var local: i32;
    var phi_435_: type_7;
    var phi_438_: i32;
    var phi_440_: i32;
    var phi_436_: type_7;
    var phi_463_: type_7;
    var phi_495_: array<u32, 2>;
    var phi_511_: array<u32, 2>;
    var phi_526_: u32;
    var phi_527_: i32;
    var phi_528_: u32;
    var phi_535_: i32;
    var phi_549_: i32;
    var phi_550_: i32;
    var phi_439_: i32;
    var phi_441_: i32;
    var phi_552_: bool;
    var phi_903_: bool;
    var local_1: i32;
    var phi_573_: array<u32, 2>;
    var phi_589_: array<u32, 2>;
    var phi_604_: u32;
    var phi_605_: i32;
    var phi_606_: u32;
    var phi_613_: i32;
    var phi_616_: type_7;
    var phi_619_: i32;
    var phi_621_: i32;
    var phi_617_: type_7;
    var phi_644_: type_7;
    var phi_680_: array<u32, 2>;
    var phi_696_: array<u32, 2>;
    var phi_711_: u32;
    var phi_712_: i32;
    var phi_713_: u32;
    var phi_720_: i32;
    var phi_732_: i32;
    var phi_620_: i32;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_914_: bool;
    var phi_878_: bool;
    var phi_876_: i32;
    var local_2: i32;
    var phi_772_: u32;
    var phi_789_: u32;
    var phi_795_: u32;
    var phi_814_: u32;
    var phi_831_: u32;
    var phi_838_: u32;
    var phi_189_: u32;
    var phi_842_: type_29;
    var local_3: i32;
    var local_4: i32;

    switch bitcast<i32>(0u) {
        default: {
            let _e42 = global;
            let _e45 = arrayLength((&global_3.member));
            let _e47 = arrayLength((&global_4.member));
            let _e49 = arrayLength((&global_5.member));
            let _e57 = (_e42.x + (_e42.y * 2097152u));
            let _e60 = global_1.member[0u];
            let _e62 = (_e57 >> bitcast<u32>(5i));
            let _e63 = (_e62 < _e47);
            if _e63 {
                if _e63 {
                } else {
                    break;
                }
                let _e66 = global_4.member[_e62];
                phi_124_ = _e66;
            } else {
                phi_124_ = 0u;
            }
            let _e68 = phi_124_;
            let _e70 = ((_e57 & 31u) & 31u);
            if (((_e68 >> bitcast<u32>(_e70)) & 1u) == 1u) {
                if _e63 {
                    if _e63 {
                    } else {
                        break;
                    }
                    let _e77 = global_4.member[_e62];
                    phi_145_ = _e77;
                } else {
                    phi_145_ = 0u;
                }
                let _e79 = phi_145_;
                let _e84 = (_e62 < _e49);
                if _e84 {
                    if _e84 {
                    } else {
                        break;
                    }
                    let _e87 = global_5.member[_e62];
                    phi_162_ = _e87;
                } else {
                    phi_162_ = 0u;
                }
                let _e89 = phi_162_;
                let _e91 = (_e89 + countOneBits((_e79 & ~((4294967295u << bitcast<u32>(_e70))))));
                if (_e60 <= 4u) {
                    let _e538 = (2147483648u | (_e60 << bitcast<u32>(28u)));
                    if ((_e538 & 2147483648u) != 0u) {
                        phi_189_ = (((_e538 & 268435455u) + ((_e538 >> bitcast<u32>(28u)) & 7u)) - 1u);
                    } else {
                        phi_189_ = 0u;
                    }
                    let _e552 = phi_189_;
                    phi_842_ = type_29(type_23(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e538, 2147483648u, 0u, (_e60 - select(0u, 1u, (_e60 > 0u)))), _e552);
                } else {
                    let _e93 = (_e57 + 1u);
                    if (_e93 < _e60) {
                        let _e95 = (_e57 < _e45);
                        if _e95 {
                            if _e95 {
                            } else {
                                break;
                            }
                            let _e97 = global_3.member[_e57];
                            phi_210_ = _e97;
                        } else {
                            phi_210_ = array<u32, 2>(0u, 0u);
                        }
                        let _e99 = phi_210_;
                        let _e102 = (_e93 < _e45);
                        if _e102 {
                            if _e102 {
                            } else {
                                break;
                            }
                            let _e104 = global_3.member[_e93];
                            phi_226_ = _e104;
                        } else {
                            phi_226_ = array<u32, 2>(0u, 0u);
                        }
                        let _e106 = phi_226_;
                        let _e109 = (_e99[0] ^ _e106[0]);
                        let _e110 = (_e99[1] ^ _e106[1]);
                        if (_e109 == 0u) {
                            let _e112 = (_e110 == 0u);
                            if _e112 {
                                phi_241_ = (_e57 ^ _e93);
                            } else {
                                phi_241_ = _e110;
                            }
                            let _e115 = phi_241_;
                            phi_242_ = select(32i, 64i, _e112);
                            phi_243_ = _e115;
                        } else {
                            phi_242_ = 0i;
                            phi_243_ = _e109;
                        }
                        let _e118 = phi_242_;
                        let _e120 = phi_243_;
                        phi_250_ = (_e118 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e120)), 32u, (_e120 == 0u))));
                    } else {
                        phi_250_ = -1i;
                    }
                    let _e129 = phi_250_;
                    let _e130 = (_e57 + 4294967295u);
                    if (_e130 < _e60) {
                        let _e132 = (_e57 < _e45);
                        if _e132 {
                            if _e132 {
                            } else {
                                break;
                            }
                            let _e134 = global_3.member[_e57];
                            phi_270_ = _e134;
                        } else {
                            phi_270_ = array<u32, 2>(0u, 0u);
                        }
                        let _e136 = phi_270_;
                        let _e139 = (_e130 < _e45);
                        if _e139 {
                            if _e139 {
                            } else {
                                break;
                            }
                            let _e141 = global_3.member[_e130];
                            phi_286_ = _e141;
                        } else {
                            phi_286_ = array<u32, 2>(0u, 0u);
                        }
                        let _e143 = phi_286_;
                        let _e146 = (_e136[0] ^ _e143[0]);
                        let _e147 = (_e136[1] ^ _e143[1]);
                        if (_e146 == 0u) {
                            let _e149 = (_e147 == 0u);
                            if _e149 {
                                phi_301_ = (_e57 ^ _e130);
                            } else {
                                phi_301_ = _e147;
                            }
                            let _e152 = phi_301_;
                            phi_302_ = select(32i, 64i, _e149);
                            phi_303_ = _e152;
                        } else {
                            phi_302_ = 0i;
                            phi_303_ = _e146;
                        }
                        let _e155 = phi_302_;
                        let _e157 = phi_303_;
                        phi_310_ = (_e155 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e157)), 32u, (_e157 == 0u))));
                    } else {
                        phi_310_ = -1i;
                    }
                    let _e166 = phi_310_;
                    if (_e129 > _e166) {
                        phi_317_ = type_28(1i, _e166);
                    } else {
                        phi_317_ = type_28(-1i, _e129);
                    }
                    let _e171 = phi_317_;
                    phi_323_ = type_7(0u, 31u);
                    phi_326_ = 4i;
                    loop {
                        let _e175 = phi_323_;
                        let _e177 = phi_326_;
                        local = _e177;
                        local_3 = _e177;
                        if (_e175.member < _e175.member_1) {
                            phi_324_ = type_7((_e175.member + 1u), _e175.member_1);
                            phi_349_ = type_7(1u, _e175.member);
                        } else {
                            phi_324_ = _e175;
                            phi_349_ = type_7(0u, type_7().member_1);
                        }
                        let _e190 = phi_324_;
                        let _e192 = phi_349_;
                        if (bitcast<i32>(_e192.member) != 0i) {
                            let _e199 = (_e57 + bitcast<u32>(((2i * _e177) * _e171.member)));
                            if (_e199 < _e60) {
                                let _e201 = (_e57 < _e45);
                                if _e201 {
                                    if _e201 {
                                    } else {
                                        phi_879_ = true;
                                        break;
                                    }
                                    let _e203 = global_3.member[_e57];
                                    phi_377_ = _e203;
                                } else {
                                    phi_377_ = array<u32, 2>(0u, 0u);
                                }
                                let _e205 = phi_377_;
                                let _e208 = (_e199 < _e45);
                                if _e208 {
                                    if _e208 {
                                    } else {
                                        phi_879_ = true;
                                        break;
                                    }
                                    let _e210 = global_3.member[_e199];
                                    phi_393_ = _e210;
                                } else {
                                    phi_393_ = array<u32, 2>(0u, 0u);
                                }
                                let _e212 = phi_393_;
                                let _e215 = (_e205[0] ^ _e212[0]);
                                let _e216 = (_e205[1] ^ _e212[1]);
                                if (_e215 == 0u) {
                                    let _e218 = (_e216 == 0u);
                                    if _e218 {
                                        phi_408_ = (_e57 ^ _e199);
                                    } else {
                                        phi_408_ = _e216;
                                    }
                                    let _e221 = phi_408_;
                                    phi_409_ = select(32i, 64i, _e218);
                                    phi_410_ = _e221;
                                } else {
                                    phi_409_ = 0i;
                                    phi_410_ = _e215;
                                }
                                let _e224 = phi_409_;
                                let _e226 = phi_410_;
                                phi_417_ = (_e224 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                            } else {
                                phi_417_ = -1i;
                            }
                            let _e235 = phi_417_;
                            let _e236 = (_e235 <= _e171.member_1);
                            if _e236 {
                                phi_423_ = i32();
                            } else {
                                phi_423_ = (_e177 * 2i);
                            }
                            let _e239 = phi_423_;
                            phi_327_ = _e239;
                            phi_425_ = select(true, false, _e236);
                        } else {
                            phi_327_ = i32();
                            phi_425_ = false;
                        }
                        let _e242 = phi_327_;
                        let _e244 = phi_425_;
                        continue;
                        continuing {
                            phi_323_ = _e190;
                            phi_326_ = _e242;
                            phi_879_ = false;
                            break if !(_e244);
                        }
                    }
                    let _e247 = phi_879_;
                    if _e247 {
                        break;
                    }
                    let _e249 = local;
                    phi_435_ = type_7(0u, 31u);
                    phi_438_ = (_e249 / 2i);
                    let _e599 = local_3;
                    phi_440_ = _e599;
                    loop {
                        let _e252 = phi_435_;
                        let _e254 = phi_438_;
                        let _e256 = phi_440_;
                        local_1 = _e256;
                        local_4 = _e256;
                        if (_e252.member < _e252.member_1) {
                            phi_436_ = type_7((_e252.member + 1u), _e252.member_1);
                            phi_463_ = type_7(1u, _e252.member);
                        } else {
                            phi_436_ = _e252;
                            phi_463_ = type_7(0u, type_7().member_1);
                        }
                        let _e269 = phi_436_;
                        let _e271 = phi_463_;
                        if (bitcast<i32>(_e271.member) != 0i) {
                            let _e275 = (_e254 == 0i);
                            if _e275 {
                                phi_549_ = i32();
                                phi_550_ = i32();
                            } else {
                                let _e276 = (_e256 + _e254);
                                let _e279 = (_e57 + bitcast<u32>((_e276 * _e171.member)));
                                if (_e279 < _e60) {
                                    let _e281 = (_e57 < _e45);
                                    if _e281 {
                                        if _e281 {
                                        } else {
                                            phi_903_ = true;
                                            break;
                                        }
                                        let _e283 = global_3.member[_e57];
                                        phi_495_ = _e283;
                                    } else {
                                        phi_495_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e285 = phi_495_;
                                    let _e288 = (_e279 < _e45);
                                    if _e288 {
                                        if _e288 {
                                        } else {
                                            phi_903_ = true;
                                            break;
                                        }
                                        let _e290 = global_3.member[_e279];
                                        phi_511_ = _e290;
                                    } else {
                                        phi_511_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e292 = phi_511_;
                                    let _e295 = (_e285[0] ^ _e292[0]);
                                    let _e296 = (_e285[1] ^ _e292[1]);
                                    if (_e295 == 0u) {
                                        let _e298 = (_e296 == 0u);
                                        if _e298 {
                                            phi_526_ = (_e57 ^ _e279);
                                        } else {
                                            phi_526_ = _e296;
                                        }
                                        let _e301 = phi_526_;
                                        phi_527_ = select(32i, 64i, _e298);
                                        phi_528_ = _e301;
                                    } else {
                                        phi_527_ = 0i;
                                        phi_528_ = _e295;
                                    }
                                    let _e304 = phi_527_;
                                    let _e306 = phi_528_;
                                    phi_535_ = (_e304 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e306)), 32u, (_e306 == 0u))));
                                } else {
                                    phi_535_ = -1i;
                                }
                                let _e315 = phi_535_;
                                phi_549_ = (_e254 / 2i);
                                phi_550_ = select(_e256, _e276, (_e315 > _e171.member_1));
                            }
                            let _e320 = phi_549_;
                            let _e322 = phi_550_;
                            phi_439_ = _e320;
                            phi_441_ = _e322;
                            phi_552_ = select(true, false, _e275);
                        } else {
                            phi_439_ = i32();
                            phi_441_ = i32();
                            phi_552_ = false;
                        }
                        let _e325 = phi_439_;
                        let _e327 = phi_441_;
                        let _e329 = phi_552_;
                        continue;
                        continuing {
                            phi_435_ = _e269;
                            phi_438_ = _e325;
                            phi_440_ = _e327;
                            phi_903_ = _e247;
                            break if !(_e329);
                        }
                    }
                    let _e332 = phi_903_;
                    if _e332 {
                        break;
                    }
                    let _e334 = local_1;
                    let _e337 = (_e57 + bitcast<u32>((_e334 * _e171.member)));
                    if (_e337 < _e60) {
                        let _e339 = (_e57 < _e45);
                        if _e339 {
                            if _e339 {
                            } else {
                                break;
                            }
                            let _e341 = global_3.member[_e57];
                            phi_573_ = _e341;
                        } else {
                            phi_573_ = array<u32, 2>(0u, 0u);
                        }
                        let _e343 = phi_573_;
                        let _e346 = (_e337 < _e45);
                        if _e346 {
                            if _e346 {
                            } else {
                                break;
                            }
                            let _e348 = global_3.member[_e337];
                            phi_589_ = _e348;
                        } else {
                            phi_589_ = array<u32, 2>(0u, 0u);
                        }
                        let _e350 = phi_589_;
                        let _e353 = (_e343[0] ^ _e350[0]);
                        let _e354 = (_e343[1] ^ _e350[1]);
                        if (_e353 == 0u) {
                            let _e356 = (_e354 == 0u);
                            if _e356 {
                                phi_604_ = (_e57 ^ _e337);
                            } else {
                                phi_604_ = _e354;
                            }
                            let _e359 = phi_604_;
                            phi_605_ = select(32i, 64i, _e356);
                            phi_606_ = _e359;
                        } else {
                            phi_605_ = 0i;
                            phi_606_ = _e353;
                        }
                        let _e362 = phi_605_;
                        let _e364 = phi_606_;
                        phi_613_ = (_e362 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e364)), 32u, (_e364 == 0u))));
                    } else {
                        phi_613_ = -1i;
                    }
                    let _e373 = phi_613_;
                    phi_616_ = type_7(0u, 32u);
                    let _e624 = local_4;
                    phi_619_ = _e624;
                    phi_621_ = 0i;
                    loop {
                        let _e375 = phi_616_;
                        let _e377 = phi_619_;
                        let _e379 = phi_621_;
                        local_2 = _e379;
                        if (_e375.member < _e375.member_1) {
                            phi_617_ = type_7((_e375.member + 1u), _e375.member_1);
                            phi_644_ = type_7(1u, _e375.member);
                        } else {
                            phi_617_ = _e375;
                            phi_644_ = type_7(0u, type_7().member_1);
                        }
                        let _e392 = phi_617_;
                        let _e394 = phi_644_;
                        if (bitcast<i32>(_e394.member) != 0i) {
                            let _e399 = ((_e377 + 1i) / 2i);
                            let _e400 = (_e379 + _e399);
                            let _e403 = (_e57 + bitcast<u32>((_e400 * _e171.member)));
                            if (_e403 < _e60) {
                                let _e405 = (_e57 < _e45);
                                if _e405 {
                                    if _e405 {
                                    } else {
                                        phi_914_ = true;
                                        phi_878_ = bool();
                                        phi_876_ = i32();
                                        break;
                                    }
                                    let _e407 = global_3.member[_e57];
                                    phi_680_ = _e407;
                                } else {
                                    phi_680_ = array<u32, 2>(0u, 0u);
                                }
                                let _e409 = phi_680_;
                                let _e412 = (_e403 < _e45);
                                if _e412 {
                                    if _e412 {
                                    } else {
                                        phi_914_ = true;
                                        phi_878_ = bool();
                                        phi_876_ = i32();
                                        break;
                                    }
                                    let _e414 = global_3.member[_e403];
                                    phi_696_ = _e414;
                                } else {
                                    phi_696_ = array<u32, 2>(0u, 0u);
                                }
                                let _e416 = phi_696_;
                                let _e419 = (_e409[0] ^ _e416[0]);
                                let _e420 = (_e409[1] ^ _e416[1]);
                                if (_e419 == 0u) {
                                    let _e422 = (_e420 == 0u);
                                    if _e422 {
                                        phi_711_ = (_e57 ^ _e403);
                                    } else {
                                        phi_711_ = _e420;
                                    }
                                    let _e425 = phi_711_;
                                    phi_712_ = select(32i, 64i, _e422);
                                    phi_713_ = _e425;
                                } else {
                                    phi_712_ = 0i;
                                    phi_713_ = _e419;
                                }
                                let _e428 = phi_712_;
                                let _e430 = phi_713_;
                                phi_720_ = (_e428 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e430)), 32u, (_e430 == 0u))));
                            } else {
                                phi_720_ = -1i;
                            }
                            let _e439 = phi_720_;
                            let _e442 = (_e399 <= 1i);
                            phi_732_ = select(_e379, _e400, (_e439 > _e373));
                            phi_620_ = _e399;
                            phi_733_ = select(true, false, _e442);
                            phi_734_ = _e442;
                        } else {
                            phi_732_ = i32();
                            phi_620_ = i32();
                            phi_733_ = false;
                            phi_734_ = false;
                        }
                        let _e445 = phi_732_;
                        let _e447 = phi_620_;
                        let _e449 = phi_733_;
                        let _e451 = phi_734_;
                        continue;
                        continuing {
                            phi_616_ = _e392;
                            phi_619_ = _e447;
                            phi_621_ = _e445;
                            phi_914_ = _e332;
                            phi_878_ = _e451;
                            phi_876_ = _e445;
                            break if !(_e449);
                        }
                    }
                    let _e454 = phi_914_;
                    let _e456 = phi_878_;
                    let _e458 = phi_876_;
                    if _e454 {
                        break;
                    }
                    let _e460 = local_2;
                    let _e462 = (_e171.member > 0i);
                    let _e463 = select(_e337, _e57, _e462);
                    let _e464 = select(_e57, _e337, _e462);
                    let _e470 = ((_e57 + bitcast<u32>((select(_e460, _e458, _e456) * _e171.member))) - select(0u, 1u, (_e171.member < 0i)));
                    let _e472 = ((_e470 - _e463) + 1u);
                    if (_e472 > 4u) {
                        let _e479 = (_e470 >> bitcast<u32>(5i));
                        let _e480 = (_e479 < _e47);
                        if _e480 {
                            if _e480 {
                            } else {
                                break;
                            }
                            let _e483 = global_4.member[_e479];
                            phi_772_ = _e483;
                        } else {
                            phi_772_ = 0u;
                        }
                        let _e485 = phi_772_;
                        let _e492 = (_e479 < _e49);
                        if _e492 {
                            if _e492 {
                            } else {
                                break;
                            }
                            let _e495 = global_5.member[_e479];
                            phi_789_ = _e495;
                        } else {
                            phi_789_ = 0u;
                        }
                        let _e497 = phi_789_;
                        phi_795_ = (_e497 + countOneBits((_e485 & ~((4294967295u << bitcast<u32>(((_e470 & 31u) & 31u)))))));
                    } else {
                        phi_795_ = ((2147483648u | (_e472 << bitcast<u32>(28u))) | _e463);
                    }
                    let _e501 = phi_795_;
                    let _e502 = (_e464 - _e470);
                    if (_e502 > 4u) {
                        let _e509 = (_e470 + 1u);
                        let _e511 = (_e509 >> bitcast<u32>(5i));
                        let _e512 = (_e511 < _e47);
                        if _e512 {
                            if _e512 {
                            } else {
                                break;
                            }
                            let _e515 = global_4.member[_e511];
                            phi_814_ = _e515;
                        } else {
                            phi_814_ = 0u;
                        }
                        let _e517 = phi_814_;
                        let _e524 = (_e511 < _e49);
                        if _e524 {
                            if _e524 {
                            } else {
                                break;
                            }
                            let _e527 = global_5.member[_e511];
                            phi_831_ = _e527;
                        } else {
                            phi_831_ = 0u;
                        }
                        let _e529 = phi_831_;
                        phi_838_ = (_e529 + countOneBits((_e517 & ~((4294967295u << bitcast<u32>(((_e509 & 31u) & 31u)))))));
                    } else {
                        phi_838_ = ((2147483648u | (_e502 << bitcast<u32>(28u))) | (_e470 + 1u));
                    }
                    let _e533 = phi_838_;
                    phi_842_ = type_29(type_23(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e501, _e533, _e463, _e464), _e470);
                }
                let _e555 = phi_842_;
                let _e558 = (_e91 < arrayLength((&global_2.member)));
                if _e558 {
                    let _e559 = (_e91 < arrayLength((&global_6.member)));
                    if _e559 {
                        if _e558 {
                        } else {
                            break;
                        }
                        global_2.member[_e91] = _e555.member;
                        if _e559 {
                        } else {
                            break;
                        }
                        global_6.member[_e91] = _e555.member_1;
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
