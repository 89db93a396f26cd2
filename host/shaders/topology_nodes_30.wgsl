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

struct type_24 {
    member: type_18,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_20;
@group(0) @binding(1) 
var<storage> global_3: type_4;
@group(0) @binding(2) 
var<storage> global_4: type_4;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

fn function_() {
    var phi_116_: u32;
    var phi_137_: u32;
    var phi_154_: u32;
    var phi_202_: u32;
    var phi_216_: u32;
    var phi_224_: u32;
    var phi_231_: i32;
    var phi_251_: u32;
    var phi_265_: u32;
    var phi_273_: u32;
    var phi_280_: i32;
    var phi_287_: type_23;
    var phi_293_: type_8;
    var phi_296_: i32;
    var phi_294_: type_8;
    var phi_319_: type_8;
    var phi_347_: u32;
    var phi_361_: u32;
    var phi_369_: u32;
    var phi_376_: i32;
    var phi_382_: i32;
    var phi_297_: i32;
    var phi_384_: bool;
    var phi_805_: bool;
    var local: i32;
    var phi_394_: type_8;
    var phi_397_: i32;
    var phi_399_: i32;
    var phi_395_: type_8;
    var phi_422_: type_8;
    var phi_454_: u32;
    var phi_468_: u32;
    var phi_476_: u32;
    var phi_483_: i32;
    var phi_497_: i32;
    var phi_498_: i32;
    var phi_398_: i32;
    var phi_400_: i32;
    var phi_500_: bool;
    var phi_826_: bool;
    var local_1: i32;
    var phi_521_: u32;
    var phi_535_: u32;
    var phi_543_: u32;
    var phi_550_: i32;
    var phi_553_: type_8;
    var phi_556_: i32;
    var phi_558_: i32;
    var phi_554_: type_8;
    var phi_581_: type_8;
    var phi_617_: u32;
    var phi_631_: u32;
    var phi_639_: u32;
    var phi_646_: i32;
    var phi_658_: i32;
    var phi_557_: i32;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_836_: bool;
    var phi_804_: bool;
    var phi_802_: i32;
    var local_2: i32;
    var phi_698_: u32;
    var phi_715_: u32;
    var phi_721_: u32;
    var phi_740_: u32;
    var phi_757_: u32;
    var phi_764_: u32;
    var phi_181_: u32;
    var phi_768_: type_24;
    var local_3: i32;
    var local_4: i32;

    switch bitcast<i32>(0u) {
        default: {
            let _e40 = global;
            let _e43 = arrayLength((&global_3.member));
            let _e45 = arrayLength((&global_4.member));
            let _e47 = arrayLength((&global_5.member));
            let _e55 = (_e40.x + (_e40.y * 2097152u));
            let _e58 = global_1.member[0u];
            let _e60 = (_e55 >> bitcast<u32>(5i));
            let _e61 = (_e60 < _e45);
            if _e61 {
                if _e61 {
                } else {
                    break;
                }
                let _e64 = global_4.member[_e60];
                phi_116_ = _e64;
            } else {
                phi_116_ = 0u;
            }
            let _e66 = phi_116_;
            let _e68 = ((_e55 & 31u) & 31u);
            if (((_e66 >> bitcast<u32>(_e68)) & 1u) == 1u) {
                if _e61 {
                    if _e61 {
                    } else {
                        break;
                    }
                    let _e75 = global_4.member[_e60];
                    phi_137_ = _e75;
                } else {
                    phi_137_ = 0u;
                }
                let _e77 = phi_137_;
                let _e82 = (_e60 < _e47);
                if _e82 {
                    if _e82 {
                    } else {
                        break;
                    }
                    let _e85 = global_5.member[_e60];
                    phi_154_ = _e85;
                } else {
                    phi_154_ = 0u;
                }
                let _e87 = phi_154_;
                let _e89 = (_e87 + countOneBits((_e77 & ~((4294967295u << bitcast<u32>(_e68))))));
                if (_e58 <= 6u) {
                    let _e476 = (2147483648u | (_e58 << bitcast<u32>(28u)));
                    if ((_e476 & 2147483648u) != 0u) {
                        phi_181_ = (((_e476 & 268435455u) + ((_e476 >> bitcast<u32>(28u)) & 7u)) - 1u);
                    } else {
                        phi_181_ = 0u;
                    }
                    let _e490 = phi_181_;
                    phi_768_ = type_24(type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e476, 2147483648u, 0u, (_e58 - select(0u, 1u, (_e58 > 0u)))), _e490);
                } else {
                    let _e91 = (_e55 + 1u);
                    if (_e91 < _e58) {
                        let _e93 = (_e55 < _e43);
                        if _e93 {
                            if _e93 {
                            } else {
                                break;
                            }
                            let _e95 = global_3.member[_e55];
                            phi_202_ = _e95;
                        } else {
                            phi_202_ = 0u;
                        }
                        let _e97 = phi_202_;
                        let _e98 = (_e91 < _e43);
                        if _e98 {
                            if _e98 {
                            } else {
                                break;
                            }
                            let _e100 = global_3.member[_e91];
                            phi_216_ = _e100;
                        } else {
                            phi_216_ = 0u;
                        }
                        let _e102 = phi_216_;
                        let _e103 = (_e97 ^ _e102);
                        let _e104 = (_e103 == 0u);
                        if _e104 {
                            phi_224_ = (_e55 ^ _e91);
                        } else {
                            phi_224_ = _e103;
                        }
                        let _e107 = phi_224_;
                        phi_231_ = (select(0i, 32i, _e104) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e107)), 32u, (_e107 == 0u))));
                    } else {
                        phi_231_ = -1i;
                    }
                    let _e117 = phi_231_;
                    let _e118 = (_e55 + 4294967295u);
                    if (_e118 < _e58) {
                        let _e120 = (_e55 < _e43);
                        if _e120 {
                            if _e120 {
                            } else {
                                break;
                            }
                            let _e122 = global_3.member[_e55];
                            phi_251_ = _e122;
                        } else {
                            phi_251_ = 0u;
                        }
                        let _e124 = phi_251_;
                        let _e125 = (_e118 < _e43);
                        if _e125 {
                            if _e125 {
                            } else {
                                break;
                            }
                            let _e127 = global_3.member[_e118];
                            phi_265_ = _e127;
                        } else {
                            phi_265_ = 0u;
                        }
                        let _e129 = phi_265_;
                        let _e130 = (_e124 ^ _e129);
                        let _e131 = (_e130 == 0u);
                        if _e131 {
                            phi_273_ = (_e55 ^ _e118);
                        } else {
                            phi_273_ = _e130;
                        }
                        let _e134 = phi_273_;
                        phi_280_ = (select(0i, 32i, _e131) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e134)), 32u, (_e134 == 0u))));
                    } else {
                        phi_280_ = -1i;
                    }
                    let _e144 = phi_280_;
                    if (_e117 > _e144) {
                        phi_287_ = type_23(1i, _e144);
                    } else {
                        phi_287_ = type_23(-1i, _e117);
                    }
                    let _e149 = phi_287_;
                    phi_293_ = type_8(0u, 31u);
                    phi_296_ = 4i;
                    loop {
                        let _e153 = phi_293_;
                        let _e155 = phi_296_;
                        local = _e155;
                        local_3 = _e155;
                        if (_e153.member < _e153.member_1) {
                            phi_294_ = type_8((_e153.member + 1u), _e153.member_1);
                            phi_319_ = type_8(1u, _e153.member);
                        } else {
                            phi_294_ = _e153;
                            phi_319_ = type_8(0u, type_8().member_1);
                        }
                        let _e168 = phi_294_;
                        let _e170 = phi_319_;
                        if (bitcast<i32>(_e170.member) != 0i) {
                            let _e177 = (_e55 + bitcast<u32>(((2i * _e155) * _e149.member)));
                            if (_e177 < _e58) {
                                let _e179 = (_e55 < _e43);
                                if _e179 {
                                    if _e179 {
                                    } else {
                                        phi_805_ = true;
                                        break;
                                    }
                                    let _e181 = global_3.member[_e55];
                                    phi_347_ = _e181;
                                } else {
                                    phi_347_ = 0u;
                                }
                                let _e183 = phi_347_;
                                let _e184 = (_e177 < _e43);
                                if _e184 {
                                    if _e184 {
                                    } else {
                                        phi_805_ = true;
                                        break;
                                    }
                                    let _e186 = global_3.member[_e177];
                                    phi_361_ = _e186;
                                } else {
                                    phi_361_ = 0u;
                                }
                                let _e188 = phi_361_;
                                let _e189 = (_e183 ^ _e188);
                                let _e190 = (_e189 == 0u);
                                if _e190 {
                                    phi_369_ = (_e55 ^ _e177);
                                } else {
                                    phi_369_ = _e189;
                                }
                                let _e193 = phi_369_;
                                phi_376_ = (select(0i, 32i, _e190) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e193)), 32u, (_e193 == 0u))));
                            } else {
                                phi_376_ = -1i;
                            }
                            let _e203 = phi_376_;
                            let _e204 = (_e203 <= _e149.member_1);
                            if _e204 {
                                phi_382_ = i32();
                            } else {
                                phi_382_ = (_e155 * 2i);
                            }
                            let _e207 = phi_382_;
                            phi_297_ = _e207;
                            phi_384_ = select(true, false, _e204);
                        } else {
                            phi_297_ = i32();
                            phi_384_ = false;
                        }
                        let _e210 = phi_297_;
                        let _e212 = phi_384_;
                        continue;
                        continuing {
                            phi_293_ = _e168;
                            phi_296_ = _e210;
                            phi_805_ = false;
                            break if !(_e212);
                        }
                    }
                    let _e215 = phi_805_;
                    if _e215 {
                        break;
                    }
                    let _e217 = local;
                    phi_394_ = type_8(0u, 31u);
                    phi_397_ = (_e217 / 2i);
                    let _e531 = local_3;
                    phi_399_ = _e531;
                    loop {
                        let _e220 = phi_394_;
                        let _e222 = phi_397_;
                        let _e224 = phi_399_;
                        local_1 = _e224;
                        local_4 = _e224;
                        if (_e220.member < _e220.member_1) {
                            phi_395_ = type_8((_e220.member + 1u), _e220.member_1);
                            phi_422_ = type_8(1u, _e220.member);
                        } else {
                            phi_395_ = _e220;
                            phi_422_ = type_8(0u, type_8().member_1);
                        }
                        let _e237 = phi_395_;
                        let _e239 = phi_422_;
                        if (bitcast<i32>(_e239.member) != 0i) {
                            let _e243 = (_e222 == 0i);
                            if _e243 {
                                phi_497_ = i32();
                                phi_498_ = i32();
                            } else {
                                let _e244 = (_e224 + _e222);
                                let _e247 = (_e55 + bitcast<u32>((_e244 * _e149.member)));
                                if (_e247 < _e58) {
                                    let _e249 = (_e55 < _e43);
                                    if _e249 {
                                        if _e249 {
                                        } else {
                                            phi_826_ = true;
                                            break;
                                        }
                                        let _e251 = global_3.member[_e55];
                                        phi_454_ = _e251;
                                    } else {
                                        phi_454_ = 0u;
                                    }
                                    let _e253 = phi_454_;
                                    let _e254 = (_e247 < _e43);
                                    if _e254 {
                                        if _e254 {
                                        } else {
                                            phi_826_ = true;
                                            break;
                                        }
                                        let _e256 = global_3.member[_e247];
                                        phi_468_ = _e256;
                                    } else {
                                        phi_468_ = 0u;
                                    }
                                    let _e258 = phi_468_;
                                    let _e259 = (_e253 ^ _e258);
                                    let _e260 = (_e259 == 0u);
                                    if _e260 {
                                        phi_476_ = (_e55 ^ _e247);
                                    } else {
                                        phi_476_ = _e259;
                                    }
                                    let _e263 = phi_476_;
                                    phi_483_ = (select(0i, 32i, _e260) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e263)), 32u, (_e263 == 0u))));
                                } else {
                                    phi_483_ = -1i;
                                }
                                let _e273 = phi_483_;
                                phi_497_ = (_e222 / 2i);
                                phi_498_ = select(_e224, _e244, (_e273 > _e149.member_1));
                            }
                            let _e278 = phi_497_;
                            let _e280 = phi_498_;
                            phi_398_ = _e278;
                            phi_400_ = _e280;
                            phi_500_ = select(true, false, _e243);
                        } else {
                            phi_398_ = i32();
                            phi_400_ = i32();
                            phi_500_ = false;
                        }
                        let _e283 = phi_398_;
                        let _e285 = phi_400_;
                        let _e287 = phi_500_;
                        continue;
                        continuing {
                            phi_394_ = _e237;
                            phi_397_ = _e283;
                            phi_399_ = _e285;
                            phi_826_ = _e215;
                            break if !(_e287);
                        }
                    }
                    let _e290 = phi_826_;
                    if _e290 {
                        break;
                    }
                    let _e292 = local_1;
                    let _e295 = (_e55 + bitcast<u32>((_e292 * _e149.member)));
                    if (_e295 < _e58) {
                        let _e297 = (_e55 < _e43);
                        if _e297 {
                            if _e297 {
                            } else {
                                break;
                            }
                            let _e299 = global_3.member[_e55];
                            phi_521_ = _e299;
                        } else {
                            phi_521_ = 0u;
                        }
                        let _e301 = phi_521_;
                        let _e302 = (_e295 < _e43);
                        if _e302 {
                            if _e302 {
                            } else {
                                break;
                            }
                            let _e304 = global_3.member[_e295];
                            phi_535_ = _e304;
                        } else {
                            phi_535_ = 0u;
                        }
                        let _e306 = phi_535_;
                        let _e307 = (_e301 ^ _e306);
                        let _e308 = (_e307 == 0u);
                        if _e308 {
                            phi_543_ = (_e55 ^ _e295);
                        } else {
                            phi_543_ = _e307;
                        }
                        let _e311 = phi_543_;
                        phi_550_ = (select(0i, 32i, _e308) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e311)), 32u, (_e311 == 0u))));
                    } else {
                        phi_550_ = -1i;
                    }
                    let _e321 = phi_550_;
                    phi_553_ = type_8(0u, 32u);
                    let _e552 = local_4;
                    phi_556_ = _e552;
                    phi_558_ = 0i;
                    loop {
                        let _e323 = phi_553_;
                        let _e325 = phi_556_;
                        let _e327 = phi_558_;
                        local_2 = _e327;
                        if (_e323.member < _e323.member_1) {
                            phi_554_ = type_8((_e323.member + 1u), _e323.member_1);
                            phi_581_ = type_8(1u, _e323.member);
                        } else {
                            phi_554_ = _e323;
                            phi_581_ = type_8(0u, type_8().member_1);
                        }
                        let _e340 = phi_554_;
                        let _e342 = phi_581_;
                        if (bitcast<i32>(_e342.member) != 0i) {
                            let _e347 = ((_e325 + 1i) / 2i);
                            let _e348 = (_e327 + _e347);
                            let _e351 = (_e55 + bitcast<u32>((_e348 * _e149.member)));
                            if (_e351 < _e58) {
                                let _e353 = (_e55 < _e43);
                                if _e353 {
                                    if _e353 {
                                    } else {
                                        phi_836_ = true;
                                        phi_804_ = bool();
                                        phi_802_ = i32();
                                        break;
                                    }
                                    let _e355 = global_3.member[_e55];
                                    phi_617_ = _e355;
                                } else {
                                    phi_617_ = 0u;
                                }
                                let _e357 = phi_617_;
                                let _e358 = (_e351 < _e43);
                                if _e358 {
                                    if _e358 {
                                    } else {
                                        phi_836_ = true;
                                        phi_804_ = bool();
                                        phi_802_ = i32();
                                        break;
                                    }
                                    let _e360 = global_3.member[_e351];
                                    phi_631_ = _e360;
                                } else {
                                    phi_631_ = 0u;
                                }
                                let _e362 = phi_631_;
                                let _e363 = (_e357 ^ _e362);
                                let _e364 = (_e363 == 0u);
                                if _e364 {
                                    phi_639_ = (_e55 ^ _e351);
                                } else {
                                    phi_639_ = _e363;
                                }
                                let _e367 = phi_639_;
                                phi_646_ = (select(0i, 32i, _e364) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e367)), 32u, (_e367 == 0u))));
                            } else {
                                phi_646_ = -1i;
                            }
                            let _e377 = phi_646_;
                            let _e380 = (_e347 <= 1i);
                            phi_658_ = select(_e327, _e348, (_e377 > _e321));
                            phi_557_ = _e347;
                            phi_659_ = select(true, false, _e380);
                            phi_660_ = _e380;
                        } else {
                            phi_658_ = i32();
                            phi_557_ = i32();
                            phi_659_ = false;
                            phi_660_ = false;
                        }
                        let _e383 = phi_658_;
                        let _e385 = phi_557_;
                        let _e387 = phi_659_;
                        let _e389 = phi_660_;
                        continue;
                        continuing {
                            phi_553_ = _e340;
                            phi_556_ = _e385;
                            phi_558_ = _e383;
                            phi_836_ = _e290;
                            phi_804_ = _e389;
                            phi_802_ = _e383;
                            break if !(_e387);
                        }
                    }
                    let _e392 = phi_836_;
                    let _e394 = phi_804_;
                    let _e396 = phi_802_;
                    if _e392 {
                        break;
                    }
                    let _e398 = local_2;
                    let _e400 = (_e149.member > 0i);
                    let _e401 = select(_e295, _e55, _e400);
                    let _e402 = select(_e55, _e295, _e400);
                    let _e408 = ((_e55 + bitcast<u32>((select(_e398, _e396, _e394) * _e149.member))) - select(0u, 1u, (_e149.member < 0i)));
                    let _e410 = ((_e408 - _e401) + 1u);
                    if (_e410 > 6u) {
                        let _e417 = (_e408 >> bitcast<u32>(5i));
                        let _e418 = (_e417 < _e45);
                        if _e418 {
                            if _e418 {
                            } else {
                                break;
                            }
                            let _e421 = global_4.member[_e417];
                            phi_698_ = _e421;
                        } else {
                            phi_698_ = 0u;
                        }
                        let _e423 = phi_698_;
                        let _e430 = (_e417 < _e47);
                        if _e430 {
                            if _e430 {
                            } else {
                                break;
                            }
                            let _e433 = global_5.member[_e417];
                            phi_715_ = _e433;
                        } else {
                            phi_715_ = 0u;
                        }
                        let _e435 = phi_715_;
                        phi_721_ = (_e435 + countOneBits((_e423 & ~((4294967295u << bitcast<u32>(((_e408 & 31u) & 31u)))))));
                    } else {
                        phi_721_ = ((2147483648u | (_e410 << bitcast<u32>(28u))) | _e401);
                    }
                    let _e439 = phi_721_;
                    let _e440 = (_e402 - _e408);
                    if (_e440 > 6u) {
                        let _e447 = (_e408 + 1u);
                        let _e449 = (_e447 >> bitcast<u32>(5i));
                        let _e450 = (_e449 < _e45);
                        if _e450 {
                            if _e450 {
                            } else {
                                break;
                            }
                            let _e453 = global_4.member[_e449];
                            phi_740_ = _e453;
                        } else {
                            phi_740_ = 0u;
                        }
                        let _e455 = phi_740_;
                        let _e462 = (_e449 < _e47);
                        if _e462 {
                            if _e462 {
                            } else {
                                break;
                            }
                            let _e465 = global_5.member[_e449];
                            phi_757_ = _e465;
                        } else {
                            phi_757_ = 0u;
                        }
                        let _e467 = phi_757_;
                        phi_764_ = (_e467 + countOneBits((_e455 & ~((4294967295u << bitcast<u32>(((_e447 & 31u) & 31u)))))));
                    } else {
                        phi_764_ = ((2147483648u | (_e440 << bitcast<u32>(28u))) | (_e408 + 1u));
                    }
                    let _e471 = phi_764_;
                    phi_768_ = type_24(type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e439, _e471, _e401, _e402), _e408);
                }
                let _e493 = phi_768_;
                let _e496 = (_e89 < arrayLength((&global_2.member)));
                if _e496 {
                    let _e497 = (_e89 < arrayLength((&global_6.member)));
                    if _e497 {
                        if _e496 {
                        } else {
                            break;
                        }
                        global_2.member[_e89] = _e493.member;
                        if _e497 {
                        } else {
                            break;
                        }
                        global_6.member[_e89] = _e493.member_1;
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
