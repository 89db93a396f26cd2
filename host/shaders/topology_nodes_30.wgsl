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
    var phi_96_: u32;
    var phi_117_: u32;
    var phi_134_: u32;
    var phi_154_: u32;
    var phi_166_: u32;
    var phi_174_: u32;
    var phi_181_: i32;
    var phi_199_: u32;
    var phi_211_: u32;
    var phi_219_: u32;
    var phi_226_: i32;
    var phi_233_: type_18;
    var phi_239_: type_7;
    var phi_242_: i32;
    var phi_240_: type_7;
    var phi_265_: type_7;
    var phi_291_: u32;
    var phi_303_: u32;
    var phi_311_: u32;
    var phi_318_: i32;
    var phi_324_: i32;
    var phi_243_: i32;
    var phi_326_: bool;
    var phi_731_: bool;
    var local: i32;
    var phi_336_: type_7;
    var phi_339_: i32;
    var phi_341_: i32;
    var phi_337_: type_7;
    var phi_364_: type_7;
    var phi_394_: u32;
    var phi_406_: u32;
    var phi_414_: u32;
    var phi_421_: i32;
    var phi_435_: i32;
    var phi_436_: i32;
    var phi_340_: i32;
    var phi_342_: i32;
    var phi_438_: bool;
    var phi_752_: bool;
    var local_1: i32;
    var phi_457_: u32;
    var phi_469_: u32;
    var phi_477_: u32;
    var phi_484_: i32;
    var phi_487_: type_7;
    var phi_490_: i32;
    var phi_492_: i32;
    var phi_488_: type_7;
    var phi_515_: type_7;
    var phi_549_: u32;
    var phi_561_: u32;
    var phi_569_: u32;
    var phi_576_: i32;
    var phi_588_: i32;
    var phi_491_: i32;
    var phi_589_: bool;
    var phi_590_: bool;
    var phi_762_: bool;
    var phi_730_: bool;
    var phi_728_: i32;
    var local_2: i32;
    var phi_628_: u32;
    var phi_645_: u32;
    var phi_651_: u32;
    var phi_670_: u32;
    var phi_687_: u32;
    var phi_694_: u32;
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
                phi_96_ = _e56;
            } else {
                phi_96_ = 0u;
            }
            let _e58 = phi_96_;
            let _e60 = ((_e50 & 31u) & 31u);
            if (((_e58 >> bitcast<u32>(_e60)) & 1u) == 1u) {
                if _e53 {
                    if _e53 {
                    } else {
                        break;
                    }
                    let _e67 = global_3.member[_e52];
                    phi_117_ = _e67;
                } else {
                    phi_117_ = 0u;
                }
                let _e69 = phi_117_;
                let _e74 = (_e52 < _e42);
                if _e74 {
                    if _e74 {
                    } else {
                        break;
                    }
                    let _e77 = global_1.member[_e52];
                    phi_134_ = _e77;
                } else {
                    phi_134_ = 0u;
                }
                let _e79 = phi_134_;
                let _e81 = (_e79 + countOneBits((_e69 & ~((4294967295u << bitcast<u32>(_e60))))));
                let _e82 = (_e50 + 1u);
                let _e83 = (_e82 < _e38);
                if _e83 {
                    let _e84 = (_e50 < _e38);
                    if _e84 {
                        if _e84 {
                        } else {
                            break;
                        }
                        let _e87 = global_2.member[_e50];
                        phi_154_ = _e87;
                    } else {
                        phi_154_ = 0u;
                    }
                    let _e89 = phi_154_;
                    if _e83 {
                        if _e83 {
                        } else {
                            break;
                        }
                        let _e92 = global_2.member[_e82];
                        phi_166_ = _e92;
                    } else {
                        phi_166_ = 0u;
                    }
                    let _e94 = phi_166_;
                    let _e95 = (_e89 ^ _e94);
                    let _e96 = (_e95 == 0u);
                    if _e96 {
                        phi_174_ = (_e50 ^ _e82);
                    } else {
                        phi_174_ = _e95;
                    }
                    let _e99 = phi_174_;
                    phi_181_ = (select(0i, 32i, _e96) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e99)), 32u, (_e99 == 0u))));
                } else {
                    phi_181_ = -1i;
                }
                let _e109 = phi_181_;
                let _e110 = (_e50 + 4294967295u);
                let _e111 = (_e110 < _e38);
                if _e111 {
                    let _e112 = (_e50 < _e38);
                    if _e112 {
                        if _e112 {
                        } else {
                            break;
                        }
                        let _e115 = global_2.member[_e50];
                        phi_199_ = _e115;
                    } else {
                        phi_199_ = 0u;
                    }
                    let _e117 = phi_199_;
                    if _e111 {
                        if _e111 {
                        } else {
                            break;
                        }
                        let _e120 = global_2.member[_e110];
                        phi_211_ = _e120;
                    } else {
                        phi_211_ = 0u;
                    }
                    let _e122 = phi_211_;
                    let _e123 = (_e117 ^ _e122);
                    let _e124 = (_e123 == 0u);
                    if _e124 {
                        phi_219_ = (_e50 ^ _e110);
                    } else {
                        phi_219_ = _e123;
                    }
                    let _e127 = phi_219_;
                    phi_226_ = (select(0i, 32i, _e124) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e127)), 32u, (_e127 == 0u))));
                } else {
                    phi_226_ = -1i;
                }
                let _e137 = phi_226_;
                if (_e109 > _e137) {
                    phi_233_ = type_18(1i, _e137);
                } else {
                    phi_233_ = type_18(-1i, _e109);
                }
                let _e142 = phi_233_;
                phi_239_ = type_7(0u, 31u);
                phi_242_ = 4i;
                loop {
                    let _e146 = phi_239_;
                    let _e148 = phi_242_;
                    local = _e148;
                    local_3 = _e148;
                    if (_e146.member < _e146.member_1) {
                        phi_240_ = type_7((_e146.member + 1u), _e146.member_1);
                        phi_265_ = type_7(1u, _e146.member);
                    } else {
                        phi_240_ = _e146;
                        phi_265_ = type_7(0u, type_7().member_1);
                    }
                    let _e161 = phi_240_;
                    let _e163 = phi_265_;
                    if (bitcast<i32>(_e163.member) != 0i) {
                        let _e170 = (_e50 + bitcast<u32>(((2i * _e148) * _e142.member)));
                        let _e171 = (_e170 < _e38);
                        if _e171 {
                            let _e172 = (_e50 < _e38);
                            if _e172 {
                                if _e172 {
                                } else {
                                    phi_731_ = true;
                                    break;
                                }
                                let _e175 = global_2.member[_e50];
                                phi_291_ = _e175;
                            } else {
                                phi_291_ = 0u;
                            }
                            let _e177 = phi_291_;
                            if _e171 {
                                if _e171 {
                                } else {
                                    phi_731_ = true;
                                    break;
                                }
                                let _e180 = global_2.member[_e170];
                                phi_303_ = _e180;
                            } else {
                                phi_303_ = 0u;
                            }
                            let _e182 = phi_303_;
                            let _e183 = (_e177 ^ _e182);
                            let _e184 = (_e183 == 0u);
                            if _e184 {
                                phi_311_ = (_e50 ^ _e170);
                            } else {
                                phi_311_ = _e183;
                            }
                            let _e187 = phi_311_;
                            phi_318_ = (select(0i, 32i, _e184) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e187)), 32u, (_e187 == 0u))));
                        } else {
                            phi_318_ = -1i;
                        }
                        let _e197 = phi_318_;
                        let _e198 = (_e197 <= _e142.member_1);
                        if _e198 {
                            phi_324_ = i32();
                        } else {
                            phi_324_ = (_e148 * 2i);
                        }
                        let _e201 = phi_324_;
                        phi_243_ = _e201;
                        phi_326_ = select(true, false, _e198);
                    } else {
                        phi_243_ = i32();
                        phi_326_ = false;
                    }
                    let _e204 = phi_243_;
                    let _e206 = phi_326_;
                    continue;
                    continuing {
                        phi_239_ = _e161;
                        phi_242_ = _e204;
                        phi_731_ = false;
                        break if !(_e206);
                    }
                }
                let _e209 = phi_731_;
                if _e209 {
                    break;
                }
                let _e211 = local;
                phi_336_ = type_7(0u, 31u);
                phi_339_ = (_e211 / 2i);
                let _e505 = local_3;
                phi_341_ = _e505;
                loop {
                    let _e214 = phi_336_;
                    let _e216 = phi_339_;
                    let _e218 = phi_341_;
                    local_1 = _e218;
                    local_4 = _e218;
                    if (_e214.member < _e214.member_1) {
                        phi_337_ = type_7((_e214.member + 1u), _e214.member_1);
                        phi_364_ = type_7(1u, _e214.member);
                    } else {
                        phi_337_ = _e214;
                        phi_364_ = type_7(0u, type_7().member_1);
                    }
                    let _e231 = phi_337_;
                    let _e233 = phi_364_;
                    if (bitcast<i32>(_e233.member) != 0i) {
                        let _e237 = (_e216 == 0i);
                        if _e237 {
                            phi_435_ = i32();
                            phi_436_ = i32();
                        } else {
                            let _e238 = (_e218 + _e216);
                            let _e241 = (_e50 + bitcast<u32>((_e238 * _e142.member)));
                            let _e242 = (_e241 < _e38);
                            if _e242 {
                                let _e243 = (_e50 < _e38);
                                if _e243 {
                                    if _e243 {
                                    } else {
                                        phi_752_ = true;
                                        break;
                                    }
                                    let _e246 = global_2.member[_e50];
                                    phi_394_ = _e246;
                                } else {
                                    phi_394_ = 0u;
                                }
                                let _e248 = phi_394_;
                                if _e242 {
                                    if _e242 {
                                    } else {
                                        phi_752_ = true;
                                        break;
                                    }
                                    let _e251 = global_2.member[_e241];
                                    phi_406_ = _e251;
                                } else {
                                    phi_406_ = 0u;
                                }
                                let _e253 = phi_406_;
                                let _e254 = (_e248 ^ _e253);
                                let _e255 = (_e254 == 0u);
                                if _e255 {
                                    phi_414_ = (_e50 ^ _e241);
                                } else {
                                    phi_414_ = _e254;
                                }
                                let _e258 = phi_414_;
                                phi_421_ = (select(0i, 32i, _e255) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e258)), 32u, (_e258 == 0u))));
                            } else {
                                phi_421_ = -1i;
                            }
                            let _e268 = phi_421_;
                            phi_435_ = (_e216 / 2i);
                            phi_436_ = select(_e218, _e238, (_e268 > _e142.member_1));
                        }
                        let _e273 = phi_435_;
                        let _e275 = phi_436_;
                        phi_340_ = _e273;
                        phi_342_ = _e275;
                        phi_438_ = select(true, false, _e237);
                    } else {
                        phi_340_ = i32();
                        phi_342_ = i32();
                        phi_438_ = false;
                    }
                    let _e278 = phi_340_;
                    let _e280 = phi_342_;
                    let _e282 = phi_438_;
                    continue;
                    continuing {
                        phi_336_ = _e231;
                        phi_339_ = _e278;
                        phi_341_ = _e280;
                        phi_752_ = _e209;
                        break if !(_e282);
                    }
                }
                let _e285 = phi_752_;
                if _e285 {
                    break;
                }
                let _e287 = local_1;
                let _e290 = (_e50 + bitcast<u32>((_e287 * _e142.member)));
                let _e291 = (_e290 < _e38);
                if _e291 {
                    let _e292 = (_e50 < _e38);
                    if _e292 {
                        if _e292 {
                        } else {
                            break;
                        }
                        let _e295 = global_2.member[_e50];
                        phi_457_ = _e295;
                    } else {
                        phi_457_ = 0u;
                    }
                    let _e297 = phi_457_;
                    if _e291 {
                        if _e291 {
                        } else {
                            break;
                        }
                        let _e300 = global_2.member[_e290];
                        phi_469_ = _e300;
                    } else {
                        phi_469_ = 0u;
                    }
                    let _e302 = phi_469_;
                    let _e303 = (_e297 ^ _e302);
                    let _e304 = (_e303 == 0u);
                    if _e304 {
                        phi_477_ = (_e50 ^ _e290);
                    } else {
                        phi_477_ = _e303;
                    }
                    let _e307 = phi_477_;
                    phi_484_ = (select(0i, 32i, _e304) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e307)), 32u, (_e307 == 0u))));
                } else {
                    phi_484_ = -1i;
                }
                let _e317 = phi_484_;
                phi_487_ = type_7(0u, 32u);
                let _e526 = local_4;
                phi_490_ = _e526;
                phi_492_ = 0i;
                loop {
                    let _e319 = phi_487_;
                    let _e321 = phi_490_;
                    let _e323 = phi_492_;
                    local_2 = _e323;
                    if (_e319.member < _e319.member_1) {
                        phi_488_ = type_7((_e319.member + 1u), _e319.member_1);
                        phi_515_ = type_7(1u, _e319.member);
                    } else {
                        phi_488_ = _e319;
                        phi_515_ = type_7(0u, type_7().member_1);
                    }
                    let _e336 = phi_488_;
                    let _e338 = phi_515_;
                    if (bitcast<i32>(_e338.member) != 0i) {
                        let _e343 = ((_e321 + 1i) / 2i);
                        let _e344 = (_e323 + _e343);
                        let _e347 = (_e50 + bitcast<u32>((_e344 * _e142.member)));
                        let _e348 = (_e347 < _e38);
                        if _e348 {
                            let _e349 = (_e50 < _e38);
                            if _e349 {
                                if _e349 {
                                } else {
                                    phi_762_ = true;
                                    phi_730_ = bool();
                                    phi_728_ = i32();
                                    break;
                                }
                                let _e352 = global_2.member[_e50];
                                phi_549_ = _e352;
                            } else {
                                phi_549_ = 0u;
                            }
                            let _e354 = phi_549_;
                            if _e348 {
                                if _e348 {
                                } else {
                                    phi_762_ = true;
                                    phi_730_ = bool();
                                    phi_728_ = i32();
                                    break;
                                }
                                let _e357 = global_2.member[_e347];
                                phi_561_ = _e357;
                            } else {
                                phi_561_ = 0u;
                            }
                            let _e359 = phi_561_;
                            let _e360 = (_e354 ^ _e359);
                            let _e361 = (_e360 == 0u);
                            if _e361 {
                                phi_569_ = (_e50 ^ _e347);
                            } else {
                                phi_569_ = _e360;
                            }
                            let _e364 = phi_569_;
                            phi_576_ = (select(0i, 32i, _e361) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e364)), 32u, (_e364 == 0u))));
                        } else {
                            phi_576_ = -1i;
                        }
                        let _e374 = phi_576_;
                        let _e377 = (_e343 <= 1i);
                        phi_588_ = select(_e323, _e344, (_e374 > _e317));
                        phi_491_ = _e343;
                        phi_589_ = select(true, false, _e377);
                        phi_590_ = _e377;
                    } else {
                        phi_588_ = i32();
                        phi_491_ = i32();
                        phi_589_ = false;
                        phi_590_ = false;
                    }
                    let _e380 = phi_588_;
                    let _e382 = phi_491_;
                    let _e384 = phi_589_;
                    let _e386 = phi_590_;
                    continue;
                    continuing {
                        phi_487_ = _e336;
                        phi_490_ = _e382;
                        phi_492_ = _e380;
                        phi_762_ = _e285;
                        phi_730_ = _e386;
                        phi_728_ = _e380;
                        break if !(_e384);
                    }
                }
                let _e389 = phi_762_;
                let _e391 = phi_730_;
                let _e393 = phi_728_;
                if _e389 {
                    break;
                }
                let _e395 = local_2;
                let _e397 = (_e142.member > 0i);
                let _e398 = select(_e290, _e50, _e397);
                let _e399 = select(_e50, _e290, _e397);
                let _e405 = ((_e50 + bitcast<u32>((select(_e395, _e393, _e391) * _e142.member))) - select(0u, 1u, (_e142.member < 0i)));
                let _e407 = ((_e405 - _e398) + 1u);
                if (_e407 > 4u) {
                    let _e414 = (_e405 >> bitcast<u32>(5i));
                    let _e415 = (_e414 < _e40);
                    if _e415 {
                        if _e415 {
                        } else {
                            break;
                        }
                        let _e418 = global_3.member[_e414];
                        phi_628_ = _e418;
                    } else {
                        phi_628_ = 0u;
                    }
                    let _e420 = phi_628_;
                    let _e427 = (_e414 < _e42);
                    if _e427 {
                        if _e427 {
                        } else {
                            break;
                        }
                        let _e430 = global_1.member[_e414];
                        phi_645_ = _e430;
                    } else {
                        phi_645_ = 0u;
                    }
                    let _e432 = phi_645_;
                    phi_651_ = (_e432 + countOneBits((_e420 & ~((4294967295u << bitcast<u32>(((_e405 & 31u) & 31u)))))));
                } else {
                    phi_651_ = ((2147483648u | (_e407 << bitcast<u32>(28u))) | _e398);
                }
                let _e436 = phi_651_;
                let _e437 = (_e399 - _e405);
                if (_e437 > 4u) {
                    let _e444 = (_e405 + 1u);
                    let _e446 = (_e444 >> bitcast<u32>(5i));
                    let _e447 = (_e446 < _e40);
                    if _e447 {
                        if _e447 {
                        } else {
                            break;
                        }
                        let _e450 = global_3.member[_e446];
                        phi_670_ = _e450;
                    } else {
                        phi_670_ = 0u;
                    }
                    let _e452 = phi_670_;
                    let _e459 = (_e446 < _e42);
                    if _e459 {
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e462 = global_1.member[_e446];
                        phi_687_ = _e462;
                    } else {
                        phi_687_ = 0u;
                    }
                    let _e464 = phi_687_;
                    phi_694_ = (_e464 + countOneBits((_e452 & ~((4294967295u << bitcast<u32>(((_e444 & 31u) & 31u)))))));
                } else {
                    phi_694_ = ((2147483648u | (_e437 << bitcast<u32>(28u))) | (_e405 + 1u));
                }
                let _e468 = phi_694_;
                let _e470 = (_e81 < arrayLength((&global_4.member)));
                if _e470 {
                    let _e471 = (_e81 < arrayLength((&global_5.member)));
                    if _e471 {
                        if _e470 {
                        } else {
                            break;
                        }
                        global_4.member[_e81] = type_13(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e436, _e468, _e398, _e399);
                        if _e471 {
                        } else {
                            break;
                        }
                        global_5.member[_e81] = _e405;
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
