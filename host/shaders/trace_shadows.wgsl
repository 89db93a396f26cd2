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

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_47 {
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
    var phi_320_: i32;
    var phi_321_: i32;
    var phi_331_: bool;
    var phi_341_: u32;
    var phi_342_: u32;
    var phi_344_: bool;
    var phi_349_: u32;
    var phi_393_: f32;
    var phi_399_: f32;
    var phi_410_: f32;
    var phi_416_: f32;
    var phi_439_: f32;
    var phi_450_: f32;
    var phi_459_: f32;
    var phi_465_: f32;
    var phi_476_: f32;
    var phi_482_: f32;
    var phi_505_: f32;
    var phi_516_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_542_: f32;
    var phi_548_: f32;
    var phi_571_: f32;
    var phi_582_: f32;
    var phi_682_: f32;
    var phi_683_: f32;
    var phi_2294_: bool;
    var phi_957_: type_47;
    var phi_960_: u32;
    var phi_962_: u32;
    var phi_964_: bool;
    var phi_966_: u32;
    var phi_977_: bool;
    var phi_1008_: u32;
    var phi_1009_: bool;
    var phi_1010_: u32;
    var phi_1810_: type_46;
    var phi_2154_: u32;
    var phi_2181_: u32;
    var phi_2182_: u32;
    var phi_2183_: u32;
    var phi_2185_: u32;
    var phi_2186_: u32;
    var phi_2187_: bool;
    var phi_2196_: u32;
    var phi_2201_: u32;
    var phi_2202_: bool;
    var phi_1025_: type_47;
    var phi_1028_: type_7;
    var phi_1029_: type_7;
    var phi_1051_: type_7;
    var phi_1072_: u32;
    var phi_1161_: array<array<f32, 3>, 3>;
    var phi_1632_: vec3<f32>;
    var phi_1633_: vec3<f32>;
    var phi_1664_: bool;
    var phi_1673_: vec3<f32>;
    var phi_1713_: type_22;
    var phi_1715_: type_22;
    var phi_1716_: bool;
    var phi_1720_: type_22;
    var phi_1721_: type_22;
    var phi_1722_: type_22;
    var phi_1723_: bool;
    var phi_1727_: type_22;
    var phi_1728_: bool;
    var phi_1732_: type_22;
    var phi_1733_: bool;
    var phi_1737_: type_22;
    var phi_1748_: type_47;
    var phi_1749_: type_47;
    var phi_1026_: type_47;
    var phi_2288_: bool;
    var local_2: type_47;
    var phi_2402_: bool;
    var phi_2204_: type_47;
    var phi_2205_: u32;
    var phi_2206_: bool;
    var phi_2207_: u32;
    var phi_2401_: bool;
    var phi_2208_: type_47;
    var phi_2209_: u32;
    var phi_2210_: u32;
    var phi_2211_: bool;
    var phi_2212_: u32;
    var phi_2400_: bool;
    var phi_2213_: type_47;
    var phi_2214_: u32;
    var phi_2215_: u32;
    var phi_2216_: bool;
    var phi_2217_: u32;
    var phi_2399_: bool;
    var phi_958_: type_47;
    var phi_961_: u32;
    var phi_963_: u32;
    var phi_965_: bool;
    var phi_967_: u32;
    var phi_2218_: bool;
    var phi_2398_: bool;
    var local_3: type_47;
    var local_4: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e62 = global;
            let _e64 = arrayLength((&global_2.member));
            let _e66 = arrayLength((&global_1.member));
            let _e72 = arrayLength((&global_3.member));
            let _e76 = (_e62.x + (_e62.y * 2097152u));
            let _e77 = (_e76 < arrayLength((&global_4.member)));
            if _e77 {
                let _e78 = (_e76 < arrayLength((&global_5.member)));
                if _e78 {
                    if _e77 {
                    } else {
                        break;
                    }
                    let _e83 = global_4.member[_e76].member.member_1;
                    let _e88 = global_4.member[_e76].member.member_3;
                    if (_e83 <= _e88) {
                        let _e90 = (1u < _e72);
                        if _e90 {
                            if (0u < _e72) {
                            } else {
                                break;
                            }
                            let _e94 = atomicAdd((&global_3.member[0u]), 1u);
                            if ((_e94 + 1u) < _e94) {
                                if _e90 {
                                } else {
                                    break;
                                }
                                let _e99 = atomicAdd((&global_3.member[1u]), 1u);
                            }
                        }
                        if _e77 {
                        } else {
                            break;
                        }
                        if _e77 {
                        } else {
                            break;
                        }
                        let _e103 = global_4.member[_e76].member_2;
                        let _e113 = global_4.member[_e76].member.member_2[0u];
                        let _e115 = (bitcast<u32>(_e113) & 2147483647u);
                        let _e121 = global_4.member[_e76].member.member_2[1u];
                        let _e123 = (bitcast<u32>(_e121) & 2147483647u);
                        let _e129 = global_4.member[_e76].member.member_2[2u];
                        let _e131 = (bitcast<u32>(_e129) & 2147483647u);
                        let _e137 = global_4.member[_e76].member.member[0u];
                        let _e139 = (bitcast<u32>(_e137) & 2147483647u);
                        let _e145 = global_4.member[_e76].member.member[1u];
                        let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                        let _e153 = global_4.member[_e76].member.member[2u];
                        let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                        let _e157 = select(_e123, _e115, (_e123 < _e115));
                        let _e159 = select(_e131, _e157, (_e131 < _e157));
                        let _e161 = select(_e139, _e159, (_e139 < _e159));
                        let _e163 = select(_e147, _e161, (_e147 < _e161));
                        let _e165 = select(_e155, _e163, (_e155 < _e163));
                        let _e167 = (bitcast<u32>(_e83) & 2147483647u);
                        let _e176 = (((select(_e167, _e165, (_e167 < _e165)) < 2139095040u) && ((bitcast<u32>(_e88) & 2147483647u) <= 2139095040u)) && (_e159 > 0u));
                        if _e176 {
                            let _e179 = (bitcast<u32>(bitcast<f32>(_e159)) & 2147483647u);
                            if (_e179 >= 8388608u) {
                                phi_320_ = (bitcast<i32>((_e179 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_320_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e179)), 32u, (_e179 == 0u))));
                            }
                            let _e193 = phi_320_;
                            phi_321_ = _e193;
                        } else {
                            phi_321_ = 0i;
                        }
                        let _e195 = phi_321_;
                        let _e196 = (_e115 == _e159);
                        if _e196 {
                            phi_331_ = true;
                        } else {
                            phi_331_ = (_e123 == _e159);
                        }
                        let _e199 = phi_331_;
                        let _e200 = select(1u, 0u, _e196);
                        if _e199 {
                            let _e201 = (_e200 + 1u);
                            phi_341_ = _e201;
                            phi_342_ = _e201;
                            phi_344_ = select(true, false, (_e201 == 2u));
                        } else {
                            phi_341_ = u32();
                            phi_342_ = 0u;
                            phi_344_ = true;
                        }
                        let _e205 = phi_341_;
                        let _e207 = phi_342_;
                        let _e209 = phi_344_;
                        if _e209 {
                            phi_349_ = (_e207 + 1u);
                        } else {
                            phi_349_ = 0u;
                        }
                        let _e213 = phi_349_;
                        let _e214 = select(_e205, _e207, _e209);
                        let _e215 = select(_e200, select(2u, _e200, _e199), _e209);
                        let _e216 = -(_e195);
                        let _e217 = (_e216 / 2i);
                        let _e222 = bitcast<f32>((bitcast<u32>((_e217 + 127i)) << bitcast<u32>(23i)));
                        let _e228 = bitcast<f32>((bitcast<u32>(((_e216 - _e217) + 127i)) << bitcast<u32>(23i)));
                        let _e233 = global_4.member[_e76].member.member;
                        let _e234 = (_e214 == 0u);
                        if _e234 {
                            phi_393_ = _e233[0];
                        } else {
                            phi_393_ = _e233[1];
                        }
                        let _e238 = phi_393_;
                        let _e239 = (_e214 == 2u);
                        if _e239 {
                            phi_399_ = _e233[2];
                        } else {
                            phi_399_ = _e238;
                        }
                        let _e242 = phi_399_;
                        let _e243 = global_4.member[_e76].member.member_2;
                        if _e234 {
                            phi_410_ = _e243[0];
                        } else {
                            phi_410_ = _e243[1];
                        }
                        let _e247 = phi_410_;
                        if _e239 {
                            phi_416_ = _e243[2];
                        } else {
                            phi_416_ = _e247;
                        }
                        let _e250 = phi_416_;
                        let _e252 = ((_e250 * _e222) * _e228);
                        let _e256 = (bitcast<f32>((bitcast<u32>(_e252) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e256 {
                            let _e260 = (bitcast<f32>((bitcast<u32>(_e242) & 2147483647u)) * 0.00000011920929f);
                            phi_439_ = select(0.00000000000011368684f, _e260, (_e260 > 0.00000000000011368684f));
                        } else {
                            phi_439_ = 0f;
                        }
                        let _e264 = phi_439_;
                        let _e265 = (_e242 + _e264);
                        let _e266 = (_e242 - _e264);
                        let _e267 = select(_e252, 0f, _e256);
                        if _e256 {
                            phi_450_ = 38685626000000000000000000f;
                        } else {
                            phi_450_ = (1f / _e252);
                        }
                        let _e270 = phi_450_;
                        let _e271 = (_e213 == 0u);
                        if _e271 {
                            phi_459_ = _e233[0];
                        } else {
                            phi_459_ = _e233[1];
                        }
                        let _e275 = phi_459_;
                        let _e276 = (_e213 == 2u);
                        if _e276 {
                            phi_465_ = _e233[2];
                        } else {
                            phi_465_ = _e275;
                        }
                        let _e279 = phi_465_;
                        if _e271 {
                            phi_476_ = _e243[0];
                        } else {
                            phi_476_ = _e243[1];
                        }
                        let _e283 = phi_476_;
                        if _e276 {
                            phi_482_ = _e243[2];
                        } else {
                            phi_482_ = _e283;
                        }
                        let _e286 = phi_482_;
                        let _e288 = ((_e286 * _e222) * _e228);
                        let _e292 = (bitcast<f32>((bitcast<u32>(_e288) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e292 {
                            let _e296 = (bitcast<f32>((bitcast<u32>(_e279) & 2147483647u)) * 0.00000011920929f);
                            phi_505_ = select(0.00000000000011368684f, _e296, (_e296 > 0.00000000000011368684f));
                        } else {
                            phi_505_ = 0f;
                        }
                        let _e300 = phi_505_;
                        let _e301 = (_e279 + _e300);
                        let _e302 = (_e279 - _e300);
                        let _e303 = select(_e288, 0f, _e292);
                        if _e292 {
                            phi_516_ = 38685626000000000000000000f;
                        } else {
                            phi_516_ = (1f / _e288);
                        }
                        let _e306 = phi_516_;
                        let _e307 = (_e215 == 0u);
                        if _e307 {
                            phi_525_ = _e233[0];
                        } else {
                            phi_525_ = _e233[1];
                        }
                        let _e311 = phi_525_;
                        let _e312 = (_e215 == 2u);
                        if _e312 {
                            phi_531_ = _e233[2];
                        } else {
                            phi_531_ = _e311;
                        }
                        let _e315 = phi_531_;
                        if _e307 {
                            phi_542_ = _e243[0];
                        } else {
                            phi_542_ = _e243[1];
                        }
                        let _e319 = phi_542_;
                        if _e312 {
                            phi_548_ = _e243[2];
                        } else {
                            phi_548_ = _e319;
                        }
                        let _e322 = phi_548_;
                        let _e324 = ((_e322 * _e222) * _e228);
                        let _e328 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e328 {
                            let _e332 = (bitcast<f32>((bitcast<u32>(_e315) & 2147483647u)) * 0.00000011920929f);
                            phi_571_ = select(0.00000000000011368684f, _e332, (_e332 > 0.00000000000011368684f));
                        } else {
                            phi_571_ = 0f;
                        }
                        let _e336 = phi_571_;
                        let _e337 = (_e315 + _e336);
                        let _e338 = (_e315 - _e336);
                        let _e339 = select(_e324, 0f, _e328);
                        if _e328 {
                            phi_582_ = 38685626000000000000000000f;
                        } else {
                            phi_582_ = (1f / _e324);
                        }
                        let _e342 = phi_582_;
                        let _e345 = bitcast<f32>((bitcast<u32>(_e242) & 2147483647u));
                        let _e348 = bitcast<f32>((bitcast<u32>(_e279) & 2147483647u));
                        let _e350 = select(_e348, _e345, (_e345 > _e348));
                        let _e353 = bitcast<f32>((bitcast<u32>(_e315) & 2147483647u));
                        if (_e176 && (select(_e353, _e350, (_e350 > _e353)) <= 1099511600000f)) {
                            let _e358 = (_e195 / 3i);
                            let _e365 = bitcast<f32>((bitcast<u32>((_e358 + 127i)) << bitcast<u32>(23i)));
                            let _e372 = bitcast<f32>((bitcast<u32>(((_e195 - (2i * _e358)) + 127i)) << bitcast<u32>(23i)));
                            let _e373 = (((_e83 * _e365) * _e365) * _e372);
                            let _e375 = select(340282350000000000000000000000000000000f, _e373, (_e373 < 340282350000000000000000000000000000000f));
                            let _e380 = (((_e88 * _e365) * _e365) * _e372);
                            let _e382 = select(340282350000000000000000000000000000000f, _e380, (_e380 < 340282350000000000000000000000000000000f));
                            phi_682_ = select(-340282350000000000000000000000000000000f, _e382, (_e382 > -340282350000000000000000000000000000000f));
                            phi_683_ = select(-340282350000000000000000000000000000000f, _e375, (_e375 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_682_ = 0f;
                            phi_683_ = 1f;
                        }
                        let _e386 = phi_682_;
                        let _e388 = phi_683_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2294_ = false;
                        phi_957_ = type_47(_e386, false);
                        phi_960_ = select(0u, 2147483648u, (_e64 == 0u));
                        phi_962_ = ((3u * _e64) + 1u);
                        phi_964_ = (_e388 <= _e386);
                        phi_966_ = 0u;
                        loop {
                            let _e396 = phi_2294_;
                            let _e398 = phi_957_;
                            let _e400 = phi_960_;
                            let _e402 = phi_962_;
                            let _e404 = phi_964_;
                            let _e406 = phi_966_;
                            local_3 = _e398;
                            if _e404 {
                                phi_977_ = true;
                            } else {
                                phi_977_ = (_e406 > 0u);
                            }
                            let _e409 = phi_977_;
                            if _e409 {
                                let _e410 = (_e402 > 0u);
                                if _e410 {
                                    if _e404 {
                                        phi_1008_ = _e400;
                                        phi_1009_ = _e404;
                                        phi_1010_ = _e406;
                                    } else {
                                        let _e411 = (_e406 - 1u);
                                        let _e412 = (_e411 % 128u);
                                        let _e413 = (_e412 < 128u);
                                        if _e413 {
                                        } else {
                                            phi_2398_ = true;
                                            break;
                                        }
                                        let _e415 = local_1[_e412];
                                        if _e413 {
                                        } else {
                                            phi_2398_ = true;
                                            break;
                                        }
                                        let _e417 = local[_e412];
                                        phi_1008_ = _e415;
                                        phi_1009_ = (_e417 <= _e398.member);
                                        phi_1010_ = _e411;
                                    }
                                    let _e421 = phi_1008_;
                                    let _e423 = phi_1009_;
                                    let _e425 = phi_1010_;
                                    if _e423 {
                                        if ((_e421 & 2147483648u) != 0u) {
                                            phi_1025_ = _e398;
                                            phi_1028_ = type_7(0u, ((_e421 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e623 = phi_1025_;
                                                let _e625 = phi_1028_;
                                                local_2 = _e623;
                                                local_4 = _e623;
                                                if (_e625.member < _e625.member_1) {
                                                    phi_1029_ = type_7((_e625.member + 1u), _e625.member_1);
                                                    phi_1051_ = type_7(1u, _e625.member);
                                                } else {
                                                    phi_1029_ = _e625;
                                                    phi_1051_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e638 = phi_1029_;
                                                let _e640 = phi_1051_;
                                                let _e644 = (bitcast<i32>(_e640.member) != 0i);
                                                if _e644 {
                                                    let _e645 = ((_e421 & 268435455u) + _e640.member_1);
                                                    let _e646 = (_e645 < _e66);
                                                    if _e646 {
                                                        if _e646 {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e650 = global_1.member[_e645].member_1;
                                                        phi_1072_ = _e650;
                                                    } else {
                                                        phi_1072_ = 4294967295u;
                                                    }
                                                    let _e652 = phi_1072_;
                                                    if (_e645 >= _e66) {
                                                        phi_1161_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e646 {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e654 = (_e214 % 3u);
                                                        let _e655 = (_e213 % 3u);
                                                        let _e656 = (_e215 % 3u);
                                                        if (_e654 < 9u) {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e662 = global_1.member[_e645].member[_e654];
                                                        if (_e655 < 9u) {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e668 = global_1.member[_e645].member[_e655];
                                                        if (_e656 < 9u) {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e674 = global_1.member[_e645].member[_e656];
                                                        let _e676 = (3u + _e654);
                                                        if (_e676 < 9u) {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e682 = global_1.member[_e645].member[_e676];
                                                        let _e683 = (3u + _e655);
                                                        if (_e683 < 9u) {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e689 = global_1.member[_e645].member[_e683];
                                                        let _e690 = (3u + _e656);
                                                        if (_e690 < 9u) {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e696 = global_1.member[_e645].member[_e690];
                                                        let _e698 = (6u + _e654);
                                                        if (_e698 < 9u) {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e704 = global_1.member[_e645].member[_e698];
                                                        let _e705 = (6u + _e655);
                                                        if (_e705 < 9u) {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e711 = global_1.member[_e645].member[_e705];
                                                        let _e712 = (6u + _e656);
                                                        if (_e712 < 9u) {
                                                        } else {
                                                            phi_2288_ = true;
                                                            break;
                                                        }
                                                        let _e718 = global_1.member[_e645].member[_e712];
                                                        phi_1161_ = array<array<f32, 3>, 3>(array<f32, 3>(_e662, _e668, _e674), array<f32, 3>(_e682, _e689, _e696), array<f32, 3>(_e704, _e711, _e718));
                                                    }
                                                    let _e722 = phi_1161_;
                                                    let _e730 = (_e722[0][2] - _e315);
                                                    let _e733 = (((_e722[0][0] - _e242) * _e339) - (_e730 * _e267));
                                                    let _e736 = (((_e722[0][1] - _e279) * _e339) - (_e730 * _e303));
                                                    let _e743 = (_e722[1][2] - _e315);
                                                    let _e746 = (((_e722[1][0] - _e242) * _e339) - (_e743 * _e267));
                                                    let _e749 = (((_e722[1][1] - _e279) * _e339) - (_e743 * _e303));
                                                    let _e756 = (_e722[2][2] - _e315);
                                                    let _e759 = (((_e722[2][0] - _e242) * _e339) - (_e756 * _e267));
                                                    let _e762 = (((_e722[2][1] - _e279) * _e339) - (_e756 * _e303));
                                                    let _e763 = (_e759 * _e749);
                                                    let _e764 = (_e762 * _e746);
                                                    let _e765 = (_e733 * _e762);
                                                    let _e766 = (_e736 * _e759);
                                                    let _e767 = (_e746 * _e736);
                                                    let _e768 = (_e749 * _e733);
                                                    let _e773 = (((_e763 >= _e764) && (_e765 >= _e766)) && (_e767 >= _e768));
                                                    if (_e773 || (((_e763 <= _e764) && (_e765 <= _e766)) && (_e767 <= _e768))) {
                                                        let _e780 = select(-1f, 1f, _e773);
                                                        let _e782 = ((_e763 - _e764) * _e780);
                                                        let _e784 = select(0f, _e782, (_e782 > 0f));
                                                        let _e786 = ((_e765 - _e766) * _e780);
                                                        let _e788 = select(0f, _e786, (_e786 > 0f));
                                                        let _e790 = ((_e767 - _e768) * _e780);
                                                        let _e792 = select(0f, _e790, (_e790 > 0f));
                                                        let _e794 = ((_e784 + _e788) + _e792);
                                                        if (_e794 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1727_ = type_22();
                                                            phi_1728_ = true;
                                                        } else {
                                                            let _e797 = select(_e722[1][0], _e722[0][0], (_e722[0][0] < _e722[1][0]));
                                                            let _e801 = select(_e722[1][0], _e722[0][0], (_e722[0][0] > _e722[1][0]));
                                                            let _e805 = select(_e722[1][1], _e722[0][1], (_e722[0][1] < _e722[1][1]));
                                                            let _e809 = select(_e722[1][1], _e722[0][1], (_e722[0][1] > _e722[1][1]));
                                                            let _e813 = select(_e722[1][2], _e722[0][2], (_e722[0][2] < _e722[1][2]));
                                                            let _e817 = select(_e722[1][2], _e722[0][2], (_e722[0][2] > _e722[1][2]));
                                                            let _e822 = ((select(_e722[2][0], _e797, (_e797 < _e722[2][0])) - _e265) * _e270);
                                                            let _e823 = ((select(_e722[2][0], _e801, (_e801 > _e722[2][0])) - _e266) * _e270);
                                                            let _e826 = ((select(_e722[2][1], _e805, (_e805 < _e722[2][1])) - _e301) * _e306);
                                                            let _e827 = ((select(_e722[2][1], _e809, (_e809 > _e722[2][1])) - _e302) * _e306);
                                                            let _e830 = ((select(_e722[2][2], _e813, (_e813 < _e722[2][2])) - _e337) * _e342);
                                                            let _e831 = ((select(_e722[2][2], _e817, (_e817 > _e722[2][2])) - _e338) * _e342);
                                                            let _e833 = select(_e831, _e830, (_e830 < _e831));
                                                            let _e835 = select(_e831, _e830, (_e830 > _e831));
                                                            let _e837 = select(_e823, _e822, (_e822 < _e823));
                                                            let _e839 = select(_e827, _e826, (_e826 < _e827));
                                                            let _e841 = select(_e839, _e837, (_e837 > _e839));
                                                            let _e843 = select(_e833, _e841, (_e841 > _e833));
                                                            let _e845 = select(_e823, _e822, (_e822 > _e823));
                                                            let _e847 = select(_e827, _e826, (_e826 > _e827));
                                                            let _e849 = select(_e847, _e845, (_e845 < _e847));
                                                            let _e851 = select(_e835, _e849, (_e849 < _e835));
                                                            let _e852 = -(_e833);
                                                            let _e858 = select(_e388, _e843, (_e843 > _e388));
                                                            if (_e858 > (_e851 + (select(_e852, _e835, (_e835 > _e852)) * 0.0000019073523f))) {
                                                                phi_1722_ = type_22();
                                                                phi_1723_ = true;
                                                            } else {
                                                                let _e860 = (_e858 > _e623.member);
                                                                if _e860 {
                                                                    phi_1721_ = type_22();
                                                                } else {
                                                                    let _e864 = (_e722[1][0] - _e722[0][0]);
                                                                    let _e865 = (_e722[1][1] - _e722[0][1]);
                                                                    let _e866 = (_e722[1][2] - _e722[0][2]);
                                                                    let _e867 = vec3<f32>(_e864, _e865, _e866);
                                                                    let _e868 = (_e722[2][0] - _e722[1][0]);
                                                                    let _e869 = (_e722[2][1] - _e722[1][1]);
                                                                    let _e870 = (_e722[2][2] - _e722[1][2]);
                                                                    let _e871 = vec3<f32>(_e868, _e869, _e870);
                                                                    let _e872 = (_e722[0][0] - _e722[2][0]);
                                                                    let _e873 = (_e722[0][1] - _e722[2][1]);
                                                                    let _e874 = (_e722[0][2] - _e722[2][2]);
                                                                    let _e875 = vec3<f32>(_e872, _e873, _e874);
                                                                    let _e878 = bitcast<f32>((bitcast<u32>(_e864) & 2147483647u));
                                                                    let _e881 = bitcast<f32>((bitcast<u32>(_e865) & 2147483647u));
                                                                    let _e883 = select(_e881, _e878, (_e878 > _e881));
                                                                    let _e886 = bitcast<f32>((bitcast<u32>(_e866) & 2147483647u));
                                                                    let _e888 = select(_e886, _e883, (_e883 > _e886));
                                                                    let _e891 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                    let _e894 = bitcast<f32>((bitcast<u32>(_e869) & 2147483647u));
                                                                    let _e896 = select(_e894, _e891, (_e891 > _e894));
                                                                    let _e899 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                    let _e901 = select(_e899, _e896, (_e896 > _e899));
                                                                    let _e904 = bitcast<f32>((bitcast<u32>(_e872) & 2147483647u));
                                                                    let _e907 = bitcast<f32>((bitcast<u32>(_e873) & 2147483647u));
                                                                    let _e909 = select(_e907, _e904, (_e904 > _e907));
                                                                    let _e912 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                    let _e914 = select(_e912, _e909, (_e909 > _e912));
                                                                    let _e916 = select(_e901, _e888, (_e888 > _e901));
                                                                    let _e918 = select(_e914, _e916, (_e916 > _e914));
                                                                    if (_e888 == _e918) {
                                                                        phi_1632_ = _e871;
                                                                        phi_1633_ = _e875;
                                                                    } else {
                                                                        let _e921 = vec3((_e901 == _e918));
                                                                        phi_1632_ = select(_e867, _e875, _e921);
                                                                        phi_1633_ = select(_e871, _e867, _e921);
                                                                    }
                                                                    let _e925 = phi_1632_;
                                                                    let _e927 = phi_1633_;
                                                                    let _e934 = ((_e925.y * _e927.z) - (_e927.y * _e925.z));
                                                                    let _e939 = ((_e925.z * _e927.x) - (_e927.z * _e925.x));
                                                                    let _e942 = ((_e925.x * _e927.y) - (_e927.x * _e925.y));
                                                                    if (_e784 >= _e788) {
                                                                        phi_1664_ = select(true, false, (_e784 >= _e792));
                                                                    } else {
                                                                        phi_1664_ = true;
                                                                    }
                                                                    let _e947 = phi_1664_;
                                                                    if _e947 {
                                                                        phi_1673_ = select(vec3<f32>(_e722[2][0], _e722[2][1], _e722[2][2]), vec3<f32>(_e722[1][0], _e722[1][1], _e722[1][2]), vec3((_e788 >= _e792)));
                                                                    } else {
                                                                        phi_1673_ = vec3<f32>(_e722[0][0], _e722[0][1], _e722[0][2]);
                                                                    }
                                                                    let _e952 = phi_1673_;
                                                                    let _e969 = ((((_e934 * (_e952.x - _e242)) + (_e939 * (_e952.y - _e279))) + (_e942 * (_e952.z - _e315))) / (((_e934 * _e267) + (_e939 * _e303)) + (_e942 * _e339)));
                                                                    let _e971 = select(_e851, _e969, (_e969 < _e851));
                                                                    let _e973 = select(_e843, _e971, (_e971 > _e843));
                                                                    if (_e973 >= _e388) {
                                                                        let _e975 = (_e973 <= _e623.member);
                                                                        if _e975 {
                                                                            let _e976 = (1f / _e794);
                                                                            phi_1713_ = type_22(_e973, (_e788 * _e976), (_e792 * _e976), _e652);
                                                                        } else {
                                                                            phi_1713_ = type_22();
                                                                        }
                                                                        let _e981 = phi_1713_;
                                                                        phi_1715_ = _e981;
                                                                        phi_1716_ = select(true, false, _e975);
                                                                    } else {
                                                                        phi_1715_ = type_22();
                                                                        phi_1716_ = true;
                                                                    }
                                                                    let _e984 = phi_1715_;
                                                                    let _e986 = phi_1716_;
                                                                    if _e986 {
                                                                        phi_1720_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1720_ = _e984;
                                                                    }
                                                                    let _e988 = phi_1720_;
                                                                    phi_1721_ = _e988;
                                                                }
                                                                let _e990 = phi_1721_;
                                                                phi_1722_ = _e990;
                                                                phi_1723_ = _e860;
                                                            }
                                                            let _e992 = phi_1722_;
                                                            let _e994 = phi_1723_;
                                                            phi_1727_ = _e992;
                                                            phi_1728_ = _e994;
                                                        }
                                                        let _e996 = phi_1727_;
                                                        let _e998 = phi_1728_;
                                                        phi_1732_ = _e996;
                                                        phi_1733_ = _e998;
                                                    } else {
                                                        phi_1732_ = type_22();
                                                        phi_1733_ = true;
                                                    }
                                                    let _e1000 = phi_1732_;
                                                    let _e1002 = phi_1733_;
                                                    if _e1002 {
                                                        phi_1737_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1737_ = _e1000;
                                                    }
                                                    let _e1004 = phi_1737_;
                                                    if (_e1004.member_3 != 4294967295u) {
                                                        if (_e652 != _e103) {
                                                            phi_1748_ = type_47(_e623.member, true);
                                                        } else {
                                                            phi_1748_ = _e623;
                                                        }
                                                        let _e1012 = phi_1748_;
                                                        phi_1749_ = _e1012;
                                                    } else {
                                                        phi_1749_ = _e623;
                                                    }
                                                    let _e1014 = phi_1749_;
                                                    phi_1026_ = _e1014;
                                                } else {
                                                    phi_1026_ = type_47();
                                                }
                                                let _e1016 = phi_1026_;
                                                continue;
                                                continuing {
                                                    phi_1025_ = _e1016;
                                                    phi_1028_ = _e638;
                                                    phi_2288_ = _e396;
                                                    break if !(_e644);
                                                }
                                            }
                                            let _e1019 = phi_2288_;
                                            phi_2398_ = _e1019;
                                            if _e1019 {
                                                break;
                                            }
                                            let _e1021 = local_2;
                                            phi_2402_ = _e1019;
                                            let _e1185 = local_4;
                                            phi_2204_ = _e1185;
                                            phi_2205_ = _e421;
                                            phi_2206_ = false;
                                            phi_2207_ = select(_e425, 0u, _e1021.member_1);
                                        } else {
                                            if (_e421 >= _e64) {
                                                phi_1810_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e421 < _e64) {
                                                } else {
                                                    phi_2398_ = true;
                                                    break;
                                                }
                                                let _e435 = (_e214 % 3u);
                                                if (_e435 < 3u) {
                                                } else {
                                                    phi_2398_ = true;
                                                    break;
                                                }
                                                let _e441 = global_2.member[_e421].member[_e435];
                                                let _e447 = (_e213 % 3u);
                                                if (_e447 < 3u) {
                                                } else {
                                                    phi_2398_ = true;
                                                    break;
                                                }
                                                let _e453 = global_2.member[_e421].member[_e447];
                                                let _e459 = (_e215 % 3u);
                                                if (_e459 < 3u) {
                                                } else {
                                                    phi_2398_ = true;
                                                    break;
                                                }
                                                let _e465 = global_2.member[_e421].member[_e459];
                                                let _e475 = global_2.member[_e421].member_1;
                                                let _e479 = global_2.member[_e421].member_2;
                                                phi_1810_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e441[0], _e441[1], _e441[2], _e441[3]), vec4<f32>(_e453[0], _e453[1], _e453[2], _e453[3]), vec4<f32>(_e465[0], _e465[1], _e465[2], _e465[3])), _e475, _e479);
                                            }
                                            let _e482 = phi_1810_;
                                            let _e494 = ((_e482.member[0].x - _e265) * _e270);
                                            let _e495 = ((_e482.member[0].y - _e265) * _e270);
                                            let _e496 = ((_e482.member[0].z - _e266) * _e270);
                                            let _e497 = ((_e482.member[0].w - _e266) * _e270);
                                            let _e507 = ((_e482.member[1].x - _e301) * _e306);
                                            let _e508 = ((_e482.member[1].y - _e301) * _e306);
                                            let _e509 = ((_e482.member[1].z - _e302) * _e306);
                                            let _e510 = ((_e482.member[1].w - _e302) * _e306);
                                            let _e520 = ((_e482.member[2].x - _e337) * _e342);
                                            let _e521 = ((_e482.member[2].y - _e337) * _e342);
                                            let _e522 = ((_e482.member[2].z - _e338) * _e342);
                                            let _e523 = ((_e482.member[2].w - _e338) * _e342);
                                            let _e525 = select(_e522, _e520, (_e520 < _e522));
                                            let _e527 = select(_e523, _e521, (_e521 < _e523));
                                            let _e529 = select(_e522, _e520, (_e520 > _e522));
                                            let _e531 = select(_e523, _e521, (_e521 > _e523));
                                            let _e533 = select(_e496, _e494, (_e494 < _e496));
                                            let _e535 = select(_e497, _e495, (_e495 < _e497));
                                            let _e537 = select(_e509, _e507, (_e507 < _e509));
                                            let _e539 = select(_e510, _e508, (_e508 < _e510));
                                            let _e541 = select(_e537, _e533, (_e533 > _e537));
                                            let _e543 = select(_e539, _e535, (_e535 > _e539));
                                            let _e545 = select(_e525, _e541, (_e541 > _e525));
                                            let _e547 = select(_e527, _e543, (_e543 > _e527));
                                            let _e549 = select(_e496, _e494, (_e494 > _e496));
                                            let _e551 = select(_e497, _e495, (_e495 > _e497));
                                            let _e553 = select(_e509, _e507, (_e507 > _e509));
                                            let _e555 = select(_e510, _e508, (_e508 > _e510));
                                            let _e557 = select(_e553, _e549, (_e549 < _e553));
                                            let _e559 = select(_e555, _e551, (_e551 < _e555));
                                            let _e564 = -(_e525);
                                            let _e565 = -(_e527);
                                            let _e572 = (select(_e529, _e557, (_e557 < _e529)) + (select(_e564, _e529, (_e529 > _e564)) * 0.0000019073523f));
                                            let _e573 = (select(_e531, _e559, (_e559 < _e531)) + (select(_e565, _e531, (_e531 > _e565)) * 0.0000019073523f));
                                            let _e575 = select(_e388, _e545, (_e545 > _e388));
                                            let _e577 = select(_e388, _e547, (_e547 > _e388));
                                            let _e582 = (_e575 <= select(_e398.member, _e572, (_e572 < _e398.member)));
                                            let _e583 = (_e577 <= select(_e398.member, _e573, (_e573 < _e398.member)));
                                            let _e584 = (_e575 <= _e577);
                                            if _e582 {
                                                if _e583 {
                                                    if _e584 {
                                                        phi_2154_ = _e482.member_2;
                                                    } else {
                                                        phi_2154_ = _e482.member_1;
                                                    }
                                                    let _e588 = phi_2154_;
                                                    let _e589 = (_e425 % 128u);
                                                    let _e590 = (_e589 < 128u);
                                                    if _e590 {
                                                    } else {
                                                        phi_2398_ = true;
                                                        break;
                                                    }
                                                    local_1[_e589] = _e588;
                                                    if _e590 {
                                                    } else {
                                                        phi_2398_ = true;
                                                        break;
                                                    }
                                                    local[_e589] = select(_e577, _e575, (_e575 > _e577));
                                                    if _e584 {
                                                        phi_2181_ = _e482.member_1;
                                                    } else {
                                                        phi_2181_ = _e482.member_2;
                                                    }
                                                    let _e599 = phi_2181_;
                                                    phi_2182_ = _e599;
                                                    phi_2183_ = (_e425 + 1u);
                                                } else {
                                                    phi_2182_ = u32();
                                                    phi_2183_ = u32();
                                                }
                                                let _e601 = phi_2182_;
                                                let _e603 = phi_2183_;
                                                phi_2185_ = _e601;
                                                phi_2186_ = _e603;
                                                phi_2187_ = select(true, false, _e583);
                                            } else {
                                                phi_2185_ = u32();
                                                phi_2186_ = u32();
                                                phi_2187_ = true;
                                            }
                                            let _e606 = phi_2185_;
                                            let _e608 = phi_2186_;
                                            let _e610 = phi_2187_;
                                            if _e610 {
                                                if _e582 {
                                                    phi_2196_ = _e482.member_1;
                                                } else {
                                                    phi_2196_ = _e482.member_2;
                                                }
                                                let _e614 = phi_2196_;
                                                phi_2201_ = _e614;
                                                phi_2202_ = select(_e583, true, _e582);
                                            } else {
                                                phi_2201_ = _e606;
                                                phi_2202_ = _e423;
                                            }
                                            let _e617 = phi_2201_;
                                            let _e619 = phi_2202_;
                                            phi_2402_ = _e396;
                                            phi_2204_ = _e398;
                                            phi_2205_ = _e617;
                                            phi_2206_ = _e619;
                                            phi_2207_ = select(_e608, _e425, _e610);
                                        }
                                        let _e1025 = phi_2402_;
                                        let _e1027 = phi_2204_;
                                        let _e1029 = phi_2205_;
                                        let _e1031 = phi_2206_;
                                        let _e1033 = phi_2207_;
                                        phi_2401_ = _e1025;
                                        phi_2208_ = _e1027;
                                        phi_2209_ = _e1029;
                                        phi_2210_ = (_e402 - 1u);
                                        phi_2211_ = _e1031;
                                        phi_2212_ = _e1033;
                                    } else {
                                        phi_2401_ = _e396;
                                        phi_2208_ = _e398;
                                        phi_2209_ = _e421;
                                        phi_2210_ = _e402;
                                        phi_2211_ = _e423;
                                        phi_2212_ = _e425;
                                    }
                                    let _e1035 = phi_2401_;
                                    let _e1037 = phi_2208_;
                                    let _e1039 = phi_2209_;
                                    let _e1041 = phi_2210_;
                                    let _e1043 = phi_2211_;
                                    let _e1045 = phi_2212_;
                                    phi_2400_ = _e1035;
                                    phi_2213_ = _e1037;
                                    phi_2214_ = _e1039;
                                    phi_2215_ = _e1041;
                                    phi_2216_ = _e1043;
                                    phi_2217_ = _e1045;
                                } else {
                                    phi_2400_ = _e396;
                                    phi_2213_ = type_47();
                                    phi_2214_ = u32();
                                    phi_2215_ = u32();
                                    phi_2216_ = bool();
                                    phi_2217_ = u32();
                                }
                                let _e1047 = phi_2400_;
                                let _e1049 = phi_2213_;
                                let _e1051 = phi_2214_;
                                let _e1053 = phi_2215_;
                                let _e1055 = phi_2216_;
                                let _e1057 = phi_2217_;
                                phi_2399_ = _e1047;
                                phi_958_ = _e1049;
                                phi_961_ = _e1051;
                                phi_963_ = _e1053;
                                phi_965_ = _e1055;
                                phi_967_ = _e1057;
                                phi_2218_ = _e410;
                            } else {
                                phi_2399_ = _e396;
                                phi_958_ = type_47();
                                phi_961_ = u32();
                                phi_963_ = u32();
                                phi_965_ = bool();
                                phi_967_ = u32();
                                phi_2218_ = false;
                            }
                            let _e1059 = phi_2399_;
                            let _e1061 = phi_958_;
                            let _e1063 = phi_961_;
                            let _e1065 = phi_963_;
                            let _e1067 = phi_965_;
                            let _e1069 = phi_967_;
                            let _e1071 = phi_2218_;
                            continue;
                            continuing {
                                phi_2294_ = _e1059;
                                phi_957_ = _e1061;
                                phi_960_ = _e1063;
                                phi_962_ = _e1065;
                                phi_964_ = _e1067;
                                phi_966_ = _e1069;
                                phi_2398_ = _e1059;
                                break if !(_e1071);
                            }
                        }
                        let _e1074 = phi_2398_;
                        if _e1074 {
                            break;
                        }
                        let _e1076 = local_3;
                        if _e1076.member_1 {
                        } else {
                            if _e78 {
                            } else {
                                break;
                            }
                            let _e1080 = global_5.member[_e76];
                            if _e77 {
                            } else {
                                break;
                            }
                            let _e1084 = global_4.member[_e76].member_1;
                            if _e78 {
                            } else {
                                break;
                            }
                            global_5.member[_e76] = type_24(_e1080.member, _e1080.member_1, _e1080.member_2, array<f32, 3>((_e1080.member_3[0] + (_e1084[0] * _e1080.member_1[0])), (_e1080.member_3[1] + (_e1084[1] * _e1080.member_1[1])), (_e1080.member_3[2] + (_e1084[2] * _e1080.member_1[2]))), _e1080.member_4);
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
