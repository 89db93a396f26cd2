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
    var phi_105_: u32;
    var phi_126_: u32;
    var phi_143_: u32;
    var phi_163_: array<u32, 2>;
    var phi_177_: array<u32, 2>;
    var phi_192_: u32;
    var phi_193_: i32;
    var phi_194_: u32;
    var phi_201_: i32;
    var phi_219_: array<u32, 2>;
    var phi_233_: array<u32, 2>;
    var phi_248_: u32;
    var phi_249_: i32;
    var phi_250_: u32;
    var phi_257_: i32;
    var phi_264_: type_23;
    var phi_270_: type_7;
    var phi_273_: i32;
    var phi_271_: type_7;
    var phi_296_: type_7;
    var phi_322_: array<u32, 2>;
    var phi_336_: array<u32, 2>;
    var phi_351_: u32;
    var phi_352_: i32;
    var phi_353_: u32;
    var phi_360_: i32;
    var phi_366_: i32;
    var phi_274_: i32;
    var phi_368_: bool;
    var phi_806_: bool;
    var local: i32;
    var phi_378_: type_7;
    var phi_381_: i32;
    var phi_383_: i32;
    var phi_379_: type_7;
    var phi_406_: type_7;
    var phi_436_: array<u32, 2>;
    var phi_450_: array<u32, 2>;
    var phi_465_: u32;
    var phi_466_: i32;
    var phi_467_: u32;
    var phi_474_: i32;
    var phi_488_: i32;
    var phi_489_: i32;
    var phi_382_: i32;
    var phi_384_: i32;
    var phi_491_: bool;
    var phi_830_: bool;
    var local_1: i32;
    var phi_510_: array<u32, 2>;
    var phi_524_: array<u32, 2>;
    var phi_539_: u32;
    var phi_540_: i32;
    var phi_541_: u32;
    var phi_548_: i32;
    var phi_551_: type_7;
    var phi_554_: i32;
    var phi_556_: i32;
    var phi_552_: type_7;
    var phi_579_: type_7;
    var phi_613_: array<u32, 2>;
    var phi_627_: array<u32, 2>;
    var phi_642_: u32;
    var phi_643_: i32;
    var phi_644_: u32;
    var phi_651_: i32;
    var phi_663_: i32;
    var phi_555_: i32;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_841_: bool;
    var phi_805_: bool;
    var phi_803_: i32;
    var local_2: i32;
    var phi_703_: u32;
    var phi_720_: u32;
    var phi_726_: u32;
    var phi_745_: u32;
    var phi_762_: u32;
    var phi_769_: u32;
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
                phi_105_ = _e59;
            } else {
                phi_105_ = 0u;
            }
            let _e61 = phi_105_;
            let _e63 = ((_e53 & 31u) & 31u);
            if (((_e61 >> bitcast<u32>(_e63)) & 1u) == 1u) {
                if _e56 {
                    if _e56 {
                    } else {
                        break;
                    }
                    let _e70 = global_3.member[_e55];
                    phi_126_ = _e70;
                } else {
                    phi_126_ = 0u;
                }
                let _e72 = phi_126_;
                let _e77 = (_e55 < _e45);
                if _e77 {
                    if _e77 {
                    } else {
                        break;
                    }
                    let _e80 = global_1.member[_e55];
                    phi_143_ = _e80;
                } else {
                    phi_143_ = 0u;
                }
                let _e82 = phi_143_;
                let _e84 = (_e82 + countOneBits((_e72 & ~((4294967295u << bitcast<u32>(_e63))))));
                let _e85 = (_e53 + 1u);
                let _e86 = (_e85 < _e41);
                if _e86 {
                    let _e87 = (_e53 < _e41);
                    if _e87 {
                        if _e87 {
                        } else {
                            break;
                        }
                        let _e90 = global_2.member[_e53];
                        phi_163_ = _e90;
                    } else {
                        phi_163_ = array<u32, 2>(0u, 0u);
                    }
                    let _e92 = phi_163_;
                    if _e86 {
                        if _e86 {
                        } else {
                            break;
                        }
                        let _e97 = global_2.member[_e85];
                        phi_177_ = _e97;
                    } else {
                        phi_177_ = array<u32, 2>(0u, 0u);
                    }
                    let _e99 = phi_177_;
                    let _e102 = (_e92[0] ^ _e99[0]);
                    let _e103 = (_e92[1] ^ _e99[1]);
                    if (_e102 == 0u) {
                        let _e105 = (_e103 == 0u);
                        if _e105 {
                            phi_192_ = (_e53 ^ _e85);
                        } else {
                            phi_192_ = _e103;
                        }
                        let _e108 = phi_192_;
                        phi_193_ = select(32i, 64i, _e105);
                        phi_194_ = _e108;
                    } else {
                        phi_193_ = 0i;
                        phi_194_ = _e102;
                    }
                    let _e111 = phi_193_;
                    let _e113 = phi_194_;
                    phi_201_ = (_e111 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e113)), 32u, (_e113 == 0u))));
                } else {
                    phi_201_ = -1i;
                }
                let _e122 = phi_201_;
                let _e123 = (_e53 + 4294967295u);
                let _e124 = (_e123 < _e41);
                if _e124 {
                    let _e125 = (_e53 < _e41);
                    if _e125 {
                        if _e125 {
                        } else {
                            break;
                        }
                        let _e128 = global_2.member[_e53];
                        phi_219_ = _e128;
                    } else {
                        phi_219_ = array<u32, 2>(0u, 0u);
                    }
                    let _e130 = phi_219_;
                    if _e124 {
                        if _e124 {
                        } else {
                            break;
                        }
                        let _e135 = global_2.member[_e123];
                        phi_233_ = _e135;
                    } else {
                        phi_233_ = array<u32, 2>(0u, 0u);
                    }
                    let _e137 = phi_233_;
                    let _e140 = (_e130[0] ^ _e137[0]);
                    let _e141 = (_e130[1] ^ _e137[1]);
                    if (_e140 == 0u) {
                        let _e143 = (_e141 == 0u);
                        if _e143 {
                            phi_248_ = (_e53 ^ _e123);
                        } else {
                            phi_248_ = _e141;
                        }
                        let _e146 = phi_248_;
                        phi_249_ = select(32i, 64i, _e143);
                        phi_250_ = _e146;
                    } else {
                        phi_249_ = 0i;
                        phi_250_ = _e140;
                    }
                    let _e149 = phi_249_;
                    let _e151 = phi_250_;
                    phi_257_ = (_e149 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e151)), 32u, (_e151 == 0u))));
                } else {
                    phi_257_ = -1i;
                }
                let _e160 = phi_257_;
                if (_e122 > _e160) {
                    phi_264_ = type_23(1i, _e160);
                } else {
                    phi_264_ = type_23(-1i, _e122);
                }
                let _e165 = phi_264_;
                phi_270_ = type_7(0u, 31u);
                phi_273_ = 4i;
                loop {
                    let _e169 = phi_270_;
                    let _e171 = phi_273_;
                    local = _e171;
                    local_3 = _e171;
                    if (_e169.member < _e169.member_1) {
                        phi_271_ = type_7((_e169.member + 1u), _e169.member_1);
                        phi_296_ = type_7(1u, _e169.member);
                    } else {
                        phi_271_ = _e169;
                        phi_296_ = type_7(0u, type_7().member_1);
                    }
                    let _e184 = phi_271_;
                    let _e186 = phi_296_;
                    if (bitcast<i32>(_e186.member) != 0i) {
                        let _e193 = (_e53 + bitcast<u32>(((2i * _e171) * _e165.member)));
                        let _e194 = (_e193 < _e41);
                        if _e194 {
                            let _e195 = (_e53 < _e41);
                            if _e195 {
                                if _e195 {
                                } else {
                                    phi_806_ = true;
                                    break;
                                }
                                let _e198 = global_2.member[_e53];
                                phi_322_ = _e198;
                            } else {
                                phi_322_ = array<u32, 2>(0u, 0u);
                            }
                            let _e200 = phi_322_;
                            if _e194 {
                                if _e194 {
                                } else {
                                    phi_806_ = true;
                                    break;
                                }
                                let _e205 = global_2.member[_e193];
                                phi_336_ = _e205;
                            } else {
                                phi_336_ = array<u32, 2>(0u, 0u);
                            }
                            let _e207 = phi_336_;
                            let _e210 = (_e200[0] ^ _e207[0]);
                            let _e211 = (_e200[1] ^ _e207[1]);
                            if (_e210 == 0u) {
                                let _e213 = (_e211 == 0u);
                                if _e213 {
                                    phi_351_ = (_e53 ^ _e193);
                                } else {
                                    phi_351_ = _e211;
                                }
                                let _e216 = phi_351_;
                                phi_352_ = select(32i, 64i, _e213);
                                phi_353_ = _e216;
                            } else {
                                phi_352_ = 0i;
                                phi_353_ = _e210;
                            }
                            let _e219 = phi_352_;
                            let _e221 = phi_353_;
                            phi_360_ = (_e219 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e221)), 32u, (_e221 == 0u))));
                        } else {
                            phi_360_ = -1i;
                        }
                        let _e230 = phi_360_;
                        let _e231 = (_e230 <= _e165.member_1);
                        if _e231 {
                            phi_366_ = i32();
                        } else {
                            phi_366_ = (_e171 * 2i);
                        }
                        let _e234 = phi_366_;
                        phi_274_ = _e234;
                        phi_368_ = select(true, false, _e231);
                    } else {
                        phi_274_ = i32();
                        phi_368_ = false;
                    }
                    let _e237 = phi_274_;
                    let _e239 = phi_368_;
                    continue;
                    continuing {
                        phi_270_ = _e184;
                        phi_273_ = _e237;
                        phi_806_ = false;
                        break if !(_e239);
                    }
                }
                let _e242 = phi_806_;
                if _e242 {
                    break;
                }
                let _e244 = local;
                phi_378_ = type_7(0u, 31u);
                phi_381_ = (_e244 / 2i);
                let _e574 = local_3;
                phi_383_ = _e574;
                loop {
                    let _e247 = phi_378_;
                    let _e249 = phi_381_;
                    let _e251 = phi_383_;
                    local_1 = _e251;
                    local_4 = _e251;
                    if (_e247.member < _e247.member_1) {
                        phi_379_ = type_7((_e247.member + 1u), _e247.member_1);
                        phi_406_ = type_7(1u, _e247.member);
                    } else {
                        phi_379_ = _e247;
                        phi_406_ = type_7(0u, type_7().member_1);
                    }
                    let _e264 = phi_379_;
                    let _e266 = phi_406_;
                    if (bitcast<i32>(_e266.member) != 0i) {
                        let _e270 = (_e249 == 0i);
                        if _e270 {
                            phi_488_ = i32();
                            phi_489_ = i32();
                        } else {
                            let _e271 = (_e251 + _e249);
                            let _e274 = (_e53 + bitcast<u32>((_e271 * _e165.member)));
                            let _e275 = (_e274 < _e41);
                            if _e275 {
                                let _e276 = (_e53 < _e41);
                                if _e276 {
                                    if _e276 {
                                    } else {
                                        phi_830_ = true;
                                        break;
                                    }
                                    let _e279 = global_2.member[_e53];
                                    phi_436_ = _e279;
                                } else {
                                    phi_436_ = array<u32, 2>(0u, 0u);
                                }
                                let _e281 = phi_436_;
                                if _e275 {
                                    if _e275 {
                                    } else {
                                        phi_830_ = true;
                                        break;
                                    }
                                    let _e286 = global_2.member[_e274];
                                    phi_450_ = _e286;
                                } else {
                                    phi_450_ = array<u32, 2>(0u, 0u);
                                }
                                let _e288 = phi_450_;
                                let _e291 = (_e281[0] ^ _e288[0]);
                                let _e292 = (_e281[1] ^ _e288[1]);
                                if (_e291 == 0u) {
                                    let _e294 = (_e292 == 0u);
                                    if _e294 {
                                        phi_465_ = (_e53 ^ _e274);
                                    } else {
                                        phi_465_ = _e292;
                                    }
                                    let _e297 = phi_465_;
                                    phi_466_ = select(32i, 64i, _e294);
                                    phi_467_ = _e297;
                                } else {
                                    phi_466_ = 0i;
                                    phi_467_ = _e291;
                                }
                                let _e300 = phi_466_;
                                let _e302 = phi_467_;
                                phi_474_ = (_e300 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e302)), 32u, (_e302 == 0u))));
                            } else {
                                phi_474_ = -1i;
                            }
                            let _e311 = phi_474_;
                            phi_488_ = (_e249 / 2i);
                            phi_489_ = select(_e251, _e271, (_e311 > _e165.member_1));
                        }
                        let _e316 = phi_488_;
                        let _e318 = phi_489_;
                        phi_382_ = _e316;
                        phi_384_ = _e318;
                        phi_491_ = select(true, false, _e270);
                    } else {
                        phi_382_ = i32();
                        phi_384_ = i32();
                        phi_491_ = false;
                    }
                    let _e321 = phi_382_;
                    let _e323 = phi_384_;
                    let _e325 = phi_491_;
                    continue;
                    continuing {
                        phi_378_ = _e264;
                        phi_381_ = _e321;
                        phi_383_ = _e323;
                        phi_830_ = _e242;
                        break if !(_e325);
                    }
                }
                let _e328 = phi_830_;
                if _e328 {
                    break;
                }
                let _e330 = local_1;
                let _e333 = (_e53 + bitcast<u32>((_e330 * _e165.member)));
                let _e334 = (_e333 < _e41);
                if _e334 {
                    let _e335 = (_e53 < _e41);
                    if _e335 {
                        if _e335 {
                        } else {
                            break;
                        }
                        let _e338 = global_2.member[_e53];
                        phi_510_ = _e338;
                    } else {
                        phi_510_ = array<u32, 2>(0u, 0u);
                    }
                    let _e340 = phi_510_;
                    if _e334 {
                        if _e334 {
                        } else {
                            break;
                        }
                        let _e345 = global_2.member[_e333];
                        phi_524_ = _e345;
                    } else {
                        phi_524_ = array<u32, 2>(0u, 0u);
                    }
                    let _e347 = phi_524_;
                    let _e350 = (_e340[0] ^ _e347[0]);
                    let _e351 = (_e340[1] ^ _e347[1]);
                    if (_e350 == 0u) {
                        let _e353 = (_e351 == 0u);
                        if _e353 {
                            phi_539_ = (_e53 ^ _e333);
                        } else {
                            phi_539_ = _e351;
                        }
                        let _e356 = phi_539_;
                        phi_540_ = select(32i, 64i, _e353);
                        phi_541_ = _e356;
                    } else {
                        phi_540_ = 0i;
                        phi_541_ = _e350;
                    }
                    let _e359 = phi_540_;
                    let _e361 = phi_541_;
                    phi_548_ = (_e359 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e361)), 32u, (_e361 == 0u))));
                } else {
                    phi_548_ = -1i;
                }
                let _e370 = phi_548_;
                phi_551_ = type_7(0u, 32u);
                let _e599 = local_4;
                phi_554_ = _e599;
                phi_556_ = 0i;
                loop {
                    let _e372 = phi_551_;
                    let _e374 = phi_554_;
                    let _e376 = phi_556_;
                    local_2 = _e376;
                    if (_e372.member < _e372.member_1) {
                        phi_552_ = type_7((_e372.member + 1u), _e372.member_1);
                        phi_579_ = type_7(1u, _e372.member);
                    } else {
                        phi_552_ = _e372;
                        phi_579_ = type_7(0u, type_7().member_1);
                    }
                    let _e389 = phi_552_;
                    let _e391 = phi_579_;
                    if (bitcast<i32>(_e391.member) != 0i) {
                        let _e396 = ((_e374 + 1i) / 2i);
                        let _e397 = (_e376 + _e396);
                        let _e400 = (_e53 + bitcast<u32>((_e397 * _e165.member)));
                        let _e401 = (_e400 < _e41);
                        if _e401 {
                            let _e402 = (_e53 < _e41);
                            if _e402 {
                                if _e402 {
                                } else {
                                    phi_841_ = true;
                                    phi_805_ = bool();
                                    phi_803_ = i32();
                                    break;
                                }
                                let _e405 = global_2.member[_e53];
                                phi_613_ = _e405;
                            } else {
                                phi_613_ = array<u32, 2>(0u, 0u);
                            }
                            let _e407 = phi_613_;
                            if _e401 {
                                if _e401 {
                                } else {
                                    phi_841_ = true;
                                    phi_805_ = bool();
                                    phi_803_ = i32();
                                    break;
                                }
                                let _e412 = global_2.member[_e400];
                                phi_627_ = _e412;
                            } else {
                                phi_627_ = array<u32, 2>(0u, 0u);
                            }
                            let _e414 = phi_627_;
                            let _e417 = (_e407[0] ^ _e414[0]);
                            let _e418 = (_e407[1] ^ _e414[1]);
                            if (_e417 == 0u) {
                                let _e420 = (_e418 == 0u);
                                if _e420 {
                                    phi_642_ = (_e53 ^ _e400);
                                } else {
                                    phi_642_ = _e418;
                                }
                                let _e423 = phi_642_;
                                phi_643_ = select(32i, 64i, _e420);
                                phi_644_ = _e423;
                            } else {
                                phi_643_ = 0i;
                                phi_644_ = _e417;
                            }
                            let _e426 = phi_643_;
                            let _e428 = phi_644_;
                            phi_651_ = (_e426 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e428)), 32u, (_e428 == 0u))));
                        } else {
                            phi_651_ = -1i;
                        }
                        let _e437 = phi_651_;
                        let _e440 = (_e396 <= 1i);
                        phi_663_ = select(_e376, _e397, (_e437 > _e370));
                        phi_555_ = _e396;
                        phi_664_ = select(true, false, _e440);
                        phi_665_ = _e440;
                    } else {
                        phi_663_ = i32();
                        phi_555_ = i32();
                        phi_664_ = false;
                        phi_665_ = false;
                    }
                    let _e443 = phi_663_;
                    let _e445 = phi_555_;
                    let _e447 = phi_664_;
                    let _e449 = phi_665_;
                    continue;
                    continuing {
                        phi_551_ = _e389;
                        phi_554_ = _e445;
                        phi_556_ = _e443;
                        phi_841_ = _e328;
                        phi_805_ = _e449;
                        phi_803_ = _e443;
                        break if !(_e447);
                    }
                }
                let _e452 = phi_841_;
                let _e454 = phi_805_;
                let _e456 = phi_803_;
                if _e452 {
                    break;
                }
                let _e458 = local_2;
                let _e460 = (_e165.member > 0i);
                let _e461 = select(_e333, _e53, _e460);
                let _e462 = select(_e53, _e333, _e460);
                let _e468 = ((_e53 + bitcast<u32>((select(_e458, _e456, _e454) * _e165.member))) - select(0u, 1u, (_e165.member < 0i)));
                let _e470 = ((_e468 - _e461) + 1u);
                if (_e470 > 4u) {
                    let _e477 = (_e468 >> bitcast<u32>(5i));
                    let _e478 = (_e477 < _e43);
                    if _e478 {
                        if _e478 {
                        } else {
                            break;
                        }
                        let _e481 = global_3.member[_e477];
                        phi_703_ = _e481;
                    } else {
                        phi_703_ = 0u;
                    }
                    let _e483 = phi_703_;
                    let _e490 = (_e477 < _e45);
                    if _e490 {
                        if _e490 {
                        } else {
                            break;
                        }
                        let _e493 = global_1.member[_e477];
                        phi_720_ = _e493;
                    } else {
                        phi_720_ = 0u;
                    }
                    let _e495 = phi_720_;
                    phi_726_ = (_e495 + countOneBits((_e483 & ~((4294967295u << bitcast<u32>(((_e468 & 31u) & 31u)))))));
                } else {
                    phi_726_ = ((2147483648u | (_e470 << bitcast<u32>(28u))) | _e461);
                }
                let _e499 = phi_726_;
                let _e500 = (_e462 - _e468);
                if (_e500 > 4u) {
                    let _e507 = (_e468 + 1u);
                    let _e509 = (_e507 >> bitcast<u32>(5i));
                    let _e510 = (_e509 < _e43);
                    if _e510 {
                        if _e510 {
                        } else {
                            break;
                        }
                        let _e513 = global_3.member[_e509];
                        phi_745_ = _e513;
                    } else {
                        phi_745_ = 0u;
                    }
                    let _e515 = phi_745_;
                    let _e522 = (_e509 < _e45);
                    if _e522 {
                        if _e522 {
                        } else {
                            break;
                        }
                        let _e525 = global_1.member[_e509];
                        phi_762_ = _e525;
                    } else {
                        phi_762_ = 0u;
                    }
                    let _e527 = phi_762_;
                    phi_769_ = (_e527 + countOneBits((_e515 & ~((4294967295u << bitcast<u32>(((_e507 & 31u) & 31u)))))));
                } else {
                    phi_769_ = ((2147483648u | (_e500 << bitcast<u32>(28u))) | (_e468 + 1u));
                }
                let _e531 = phi_769_;
                let _e533 = (_e84 < arrayLength((&global_4.member)));
                if _e533 {
                    let _e534 = (_e84 < arrayLength((&global_5.member)));
                    if _e534 {
                        if _e533 {
                        } else {
                            break;
                        }
                        global_4.member[_e84] = type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e499, _e531, _e461, _e462);
                        if _e534 {
                        } else {
                            break;
                        }
                        global_5.member[_e84] = _e468;
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
