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

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_36 {
    member: array<type_34>,
}

struct type_42 {
    member: type_22,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_36;
@group(0) @binding(2) 
var<storage> global_3: type_29;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_24;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_51;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_183_: u32;
    var phi_288_: i32;
    var phi_289_: i32;
    var phi_299_: bool;
    var phi_309_: u32;
    var phi_310_: u32;
    var phi_312_: bool;
    var phi_317_: u32;
    var phi_349_: i32;
    var phi_367_: f32;
    var phi_373_: f32;
    var phi_384_: f32;
    var phi_390_: f32;
    var phi_413_: f32;
    var phi_424_: f32;
    var phi_433_: f32;
    var phi_439_: f32;
    var phi_450_: f32;
    var phi_456_: f32;
    var phi_479_: f32;
    var phi_490_: f32;
    var phi_499_: f32;
    var phi_505_: f32;
    var phi_516_: f32;
    var phi_522_: f32;
    var phi_545_: f32;
    var phi_556_: f32;
    var phi_656_: f32;
    var phi_657_: f32;
    var phi_2373_: bool;
    var phi_668_: type_42;
    var phi_671_: u32;
    var phi_673_: u32;
    var phi_675_: bool;
    var phi_677_: u32;
    var phi_688_: bool;
    var phi_720_: u32;
    var phi_721_: bool;
    var phi_722_: u32;
    var phi_1810_: type_47;
    var phi_2154_: u32;
    var phi_2182_: u32;
    var phi_2183_: u32;
    var phi_2184_: u32;
    var phi_2186_: u32;
    var phi_2187_: u32;
    var phi_2188_: bool;
    var phi_2197_: u32;
    var phi_2202_: u32;
    var phi_2203_: bool;
    var phi_737_: type_42;
    var phi_740_: type_7;
    var phi_741_: type_7;
    var phi_763_: type_7;
    var phi_784_: u32;
    var phi_873_: array<array<f32, 3>, 3>;
    var phi_990_: bool;
    var phi_1019_: bool;
    var phi_1420_: f32;
    var phi_1421_: f32;
    var phi_1422_: f32;
    var phi_1423_: f32;
    var phi_1424_: vec3<f32>;
    var phi_1425_: vec3<f32>;
    var phi_1426_: vec3<f32>;
    var phi_1427_: vec3<f32>;
    var phi_1458_: bool;
    var phi_1467_: vec3<f32>;
    var phi_1634_: bool;
    var phi_1658_: f32;
    var phi_1659_: f32;
    var phi_1682_: type_22;
    var phi_1684_: type_22;
    var phi_1685_: bool;
    var phi_1689_: type_22;
    var phi_1690_: type_22;
    var phi_1691_: type_22;
    var phi_1692_: bool;
    var phi_1696_: type_22;
    var phi_1697_: bool;
    var phi_1698_: type_22;
    var phi_1699_: bool;
    var phi_1700_: bool;
    var phi_1701_: type_22;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_1711_: type_22;
    var phi_1712_: bool;
    var phi_1716_: type_22;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1748_: type_42;
    var phi_1749_: type_42;
    var phi_1750_: type_42;
    var phi_738_: type_42;
    var phi_2367_: bool;
    var phi_2514_: bool;
    var phi_2205_: type_42;
    var phi_2206_: u32;
    var phi_2207_: bool;
    var phi_2208_: u32;
    var phi_2513_: bool;
    var phi_2209_: type_42;
    var phi_2210_: u32;
    var phi_2211_: u32;
    var phi_2212_: bool;
    var phi_2213_: u32;
    var phi_2512_: bool;
    var phi_2214_: type_42;
    var phi_2215_: u32;
    var phi_2216_: u32;
    var phi_2217_: bool;
    var phi_2218_: u32;
    var phi_2511_: bool;
    var phi_669_: type_42;
    var phi_672_: u32;
    var phi_674_: u32;
    var phi_676_: bool;
    var phi_678_: u32;
    var phi_2219_: bool;
    var phi_2510_: bool;
    var local_2: type_42;
    var phi_2271_: type_22;
    var local_3: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e65 = global;
            let _e67 = arrayLength((&global_2.member));
            let _e69 = arrayLength((&global_1.member));
            let _e75 = arrayLength((&global_5.member));
            let _e79 = (_e65.x + (_e65.y * 2097152u));
            let _e80 = (_e79 < arrayLength((&global_3.member)));
            if _e80 {
                if _e80 {
                } else {
                    break;
                }
                let _e84 = global_3.member[_e79].member_2;
                phi_183_ = _e84;
            } else {
                phi_183_ = 4294967295u;
            }
            let _e86 = phi_183_;
            if _e80 {
                let _e87 = (_e79 < arrayLength((&global_4.member)));
                if _e87 {
                    if _e80 {
                    } else {
                        break;
                    }
                    let _e97 = global_3.member[_e79].member.member_2[0u];
                    let _e99 = (bitcast<u32>(_e97) & 2147483647u);
                    let _e105 = global_3.member[_e79].member.member_2[1u];
                    let _e107 = (bitcast<u32>(_e105) & 2147483647u);
                    let _e113 = global_3.member[_e79].member.member_2[2u];
                    let _e115 = (bitcast<u32>(_e113) & 2147483647u);
                    let _e121 = global_3.member[_e79].member.member[0u];
                    let _e123 = (bitcast<u32>(_e121) & 2147483647u);
                    let _e129 = global_3.member[_e79].member.member[1u];
                    let _e131 = (bitcast<u32>(_e129) & 2147483647u);
                    let _e137 = global_3.member[_e79].member.member[2u];
                    let _e139 = (bitcast<u32>(_e137) & 2147483647u);
                    let _e141 = select(_e107, _e99, (_e107 < _e99));
                    let _e143 = select(_e115, _e141, (_e115 < _e141));
                    let _e145 = select(_e123, _e143, (_e123 < _e143));
                    let _e147 = select(_e131, _e145, (_e131 < _e145));
                    let _e149 = select(_e139, _e147, (_e139 < _e147));
                    let _e154 = global_3.member[_e79].member.member_1;
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e164 = global_3.member[_e79].member.member_3;
                    let _e170 = (((select(_e156, _e149, (_e156 < _e149)) < 2139095040u) && ((bitcast<u32>(_e164) & 2147483647u) <= 2139095040u)) && (_e143 > 0u));
                    if _e170 {
                        let _e173 = (bitcast<u32>(bitcast<f32>(_e143)) & 2147483647u);
                        if (_e173 >= 8388608u) {
                            phi_288_ = (bitcast<i32>((_e173 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_288_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e173)), 32u, (_e173 == 0u))));
                        }
                        let _e187 = phi_288_;
                        phi_289_ = _e187;
                    } else {
                        phi_289_ = 0i;
                    }
                    let _e189 = phi_289_;
                    let _e190 = (_e99 == _e143);
                    if _e190 {
                        phi_299_ = true;
                    } else {
                        phi_299_ = (_e107 == _e143);
                    }
                    let _e193 = phi_299_;
                    let _e194 = select(1u, 0u, _e190);
                    if _e193 {
                        let _e195 = (_e194 + 1u);
                        phi_309_ = _e195;
                        phi_310_ = _e195;
                        phi_312_ = select(true, false, (_e195 == 2u));
                    } else {
                        phi_309_ = u32();
                        phi_310_ = 0u;
                        phi_312_ = true;
                    }
                    let _e199 = phi_309_;
                    let _e201 = phi_310_;
                    let _e203 = phi_312_;
                    if _e203 {
                        phi_317_ = (_e201 + 1u);
                    } else {
                        phi_317_ = 0u;
                    }
                    let _e207 = phi_317_;
                    let _e208 = select(_e199, _e201, _e203);
                    let _e209 = select(_e194, select(2u, _e194, _e193), _e203);
                    let _e210 = -(_e189);
                    if (_e210 < -126i) {
                        phi_349_ = -126i;
                    } else {
                        phi_349_ = select(_e210, 127i, (_e210 > 127i));
                    }
                    let _e215 = phi_349_;
                    let _e220 = bitcast<f32>((bitcast<u32>((_e215 + 127i)) << bitcast<u32>(23i)));
                    let _e226 = bitcast<f32>((bitcast<u32>(((_e210 - _e215) + 127i)) << bitcast<u32>(23i)));
                    let _e231 = global_3.member[_e79].member.member;
                    let _e232 = (_e208 == 0u);
                    if _e232 {
                        phi_367_ = _e231[0];
                    } else {
                        phi_367_ = _e231[1];
                    }
                    let _e236 = phi_367_;
                    let _e237 = (_e208 == 2u);
                    if _e237 {
                        phi_373_ = _e231[2];
                    } else {
                        phi_373_ = _e236;
                    }
                    let _e240 = phi_373_;
                    let _e241 = global_3.member[_e79].member.member_2;
                    if _e232 {
                        phi_384_ = _e241[0];
                    } else {
                        phi_384_ = _e241[1];
                    }
                    let _e245 = phi_384_;
                    if _e237 {
                        phi_390_ = _e241[2];
                    } else {
                        phi_390_ = _e245;
                    }
                    let _e248 = phi_390_;
                    let _e250 = ((_e248 * _e220) * _e226);
                    let _e254 = (bitcast<f32>((bitcast<u32>(_e250) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e254 {
                        let _e258 = (bitcast<f32>((bitcast<u32>(_e240) & 2147483647u)) * 0.00000011920929f);
                        phi_413_ = select(0.00000000000011368684f, _e258, (_e258 > 0.00000000000011368684f));
                    } else {
                        phi_413_ = 0f;
                    }
                    let _e262 = phi_413_;
                    let _e263 = (_e240 + _e262);
                    let _e264 = (_e240 - _e262);
                    let _e265 = select(_e250, 0f, _e254);
                    if _e254 {
                        phi_424_ = 38685626000000000000000000f;
                    } else {
                        phi_424_ = (1f / _e250);
                    }
                    let _e268 = phi_424_;
                    let _e269 = (_e207 == 0u);
                    if _e269 {
                        phi_433_ = _e231[0];
                    } else {
                        phi_433_ = _e231[1];
                    }
                    let _e273 = phi_433_;
                    let _e274 = (_e207 == 2u);
                    if _e274 {
                        phi_439_ = _e231[2];
                    } else {
                        phi_439_ = _e273;
                    }
                    let _e277 = phi_439_;
                    if _e269 {
                        phi_450_ = _e241[0];
                    } else {
                        phi_450_ = _e241[1];
                    }
                    let _e281 = phi_450_;
                    if _e274 {
                        phi_456_ = _e241[2];
                    } else {
                        phi_456_ = _e281;
                    }
                    let _e284 = phi_456_;
                    let _e286 = ((_e284 * _e220) * _e226);
                    let _e290 = (bitcast<f32>((bitcast<u32>(_e286) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e290 {
                        let _e294 = (bitcast<f32>((bitcast<u32>(_e277) & 2147483647u)) * 0.00000011920929f);
                        phi_479_ = select(0.00000000000011368684f, _e294, (_e294 > 0.00000000000011368684f));
                    } else {
                        phi_479_ = 0f;
                    }
                    let _e298 = phi_479_;
                    let _e299 = (_e277 + _e298);
                    let _e300 = (_e277 - _e298);
                    let _e301 = select(_e286, 0f, _e290);
                    if _e290 {
                        phi_490_ = 38685626000000000000000000f;
                    } else {
                        phi_490_ = (1f / _e286);
                    }
                    let _e304 = phi_490_;
                    let _e305 = (_e209 == 0u);
                    if _e305 {
                        phi_499_ = _e231[0];
                    } else {
                        phi_499_ = _e231[1];
                    }
                    let _e309 = phi_499_;
                    let _e310 = (_e209 == 2u);
                    if _e310 {
                        phi_505_ = _e231[2];
                    } else {
                        phi_505_ = _e309;
                    }
                    let _e313 = phi_505_;
                    if _e305 {
                        phi_516_ = _e241[0];
                    } else {
                        phi_516_ = _e241[1];
                    }
                    let _e317 = phi_516_;
                    if _e310 {
                        phi_522_ = _e241[2];
                    } else {
                        phi_522_ = _e317;
                    }
                    let _e320 = phi_522_;
                    let _e322 = ((_e320 * _e220) * _e226);
                    let _e326 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e326 {
                        let _e330 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) * 0.00000011920929f);
                        phi_545_ = select(0.00000000000011368684f, _e330, (_e330 > 0.00000000000011368684f));
                    } else {
                        phi_545_ = 0f;
                    }
                    let _e334 = phi_545_;
                    let _e335 = (_e313 + _e334);
                    let _e336 = (_e313 - _e334);
                    let _e337 = select(_e322, 0f, _e326);
                    if _e326 {
                        phi_556_ = 38685626000000000000000000f;
                    } else {
                        phi_556_ = (1f / _e322);
                    }
                    let _e340 = phi_556_;
                    let _e343 = bitcast<f32>((bitcast<u32>(_e240) & 2147483647u));
                    let _e346 = bitcast<f32>((bitcast<u32>(_e277) & 2147483647u));
                    let _e348 = select(_e346, _e343, (_e343 > _e346));
                    let _e351 = bitcast<f32>((bitcast<u32>(_e313) & 2147483647u));
                    if (_e170 && (select(_e351, _e348, (_e348 > _e351)) <= 1099511600000f)) {
                        let _e356 = (_e189 / 3i);
                        let _e363 = bitcast<f32>((bitcast<u32>((_e356 + 127i)) << bitcast<u32>(23i)));
                        let _e370 = bitcast<f32>((bitcast<u32>(((_e189 - (2i * _e356)) + 127i)) << bitcast<u32>(23i)));
                        let _e371 = (((_e154 * _e363) * _e363) * _e370);
                        let _e373 = select(340282350000000000000000000000000000000f, _e371, (_e371 < 340282350000000000000000000000000000000f));
                        let _e378 = (((_e164 * _e363) * _e363) * _e370);
                        let _e380 = select(340282350000000000000000000000000000000f, _e378, (_e378 < 340282350000000000000000000000000000000f));
                        phi_656_ = select(-340282350000000000000000000000000000000f, _e380, (_e380 > -340282350000000000000000000000000000000f));
                        phi_657_ = select(-340282350000000000000000000000000000000f, _e373, (_e373 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_656_ = 0f;
                        phi_657_ = 1f;
                    }
                    let _e384 = phi_656_;
                    let _e386 = phi_657_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2373_ = false;
                    phi_668_ = type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e384);
                    phi_671_ = select(0u, 2147483648u, (_e67 == 0u));
                    phi_673_ = ((3u * _e67) + 1u);
                    phi_675_ = (_e386 <= _e384);
                    phi_677_ = 0u;
                    loop {
                        let _e394 = phi_2373_;
                        let _e396 = phi_668_;
                        let _e398 = phi_671_;
                        let _e400 = phi_673_;
                        let _e402 = phi_675_;
                        let _e404 = phi_677_;
                        local_2 = _e396;
                        if _e402 {
                            phi_688_ = true;
                        } else {
                            phi_688_ = (_e404 > 0u);
                        }
                        let _e407 = phi_688_;
                        if _e407 {
                            let _e408 = (_e400 > 0u);
                            if _e408 {
                                if _e402 {
                                    phi_720_ = _e398;
                                    phi_721_ = _e402;
                                    phi_722_ = _e404;
                                } else {
                                    let _e409 = (_e404 - 1u);
                                    let _e410 = (_e409 % 128u);
                                    let _e411 = (_e410 < 128u);
                                    if _e411 {
                                    } else {
                                        phi_2510_ = true;
                                        break;
                                    }
                                    let _e413 = local_1[_e410];
                                    if _e411 {
                                    } else {
                                        phi_2510_ = true;
                                        break;
                                    }
                                    let _e415 = local[_e410];
                                    phi_720_ = _e413;
                                    phi_721_ = (_e415 <= _e396.member_1);
                                    phi_722_ = _e409;
                                }
                                let _e419 = phi_720_;
                                let _e421 = phi_721_;
                                let _e423 = phi_722_;
                                if _e421 {
                                    if ((_e419 & 2147483648u) != 0u) {
                                        phi_737_ = _e396;
                                        phi_740_ = type_7(0u, ((_e419 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e621 = phi_737_;
                                            let _e623 = phi_740_;
                                            local_3 = _e621;
                                            if (_e623.member < _e623.member_1) {
                                                phi_741_ = type_7((_e623.member + 1u), _e623.member_1);
                                                phi_763_ = type_7(1u, _e623.member);
                                            } else {
                                                phi_741_ = _e623;
                                                phi_763_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e636 = phi_741_;
                                            let _e638 = phi_763_;
                                            let _e642 = (bitcast<i32>(_e638.member) != 0i);
                                            if _e642 {
                                                let _e643 = ((_e419 & 268435455u) + _e638.member_1);
                                                let _e644 = (_e643 < _e69);
                                                if _e644 {
                                                    if _e644 {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e648 = global_1.member[_e643].member_1;
                                                    phi_784_ = _e648;
                                                } else {
                                                    phi_784_ = 4294967295u;
                                                }
                                                let _e650 = phi_784_;
                                                if (_e643 >= _e69) {
                                                    phi_873_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e644 {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e652 = (_e208 % 3u);
                                                    let _e653 = (_e207 % 3u);
                                                    let _e654 = (_e209 % 3u);
                                                    if (_e652 < 9u) {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e660 = global_1.member[_e643].member[_e652];
                                                    if (_e653 < 9u) {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e666 = global_1.member[_e643].member[_e653];
                                                    if (_e654 < 9u) {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e672 = global_1.member[_e643].member[_e654];
                                                    let _e674 = (3u + _e652);
                                                    if (_e674 < 9u) {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e680 = global_1.member[_e643].member[_e674];
                                                    let _e681 = (3u + _e653);
                                                    if (_e681 < 9u) {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e687 = global_1.member[_e643].member[_e681];
                                                    let _e688 = (3u + _e654);
                                                    if (_e688 < 9u) {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e694 = global_1.member[_e643].member[_e688];
                                                    let _e696 = (6u + _e652);
                                                    if (_e696 < 9u) {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e702 = global_1.member[_e643].member[_e696];
                                                    let _e703 = (6u + _e653);
                                                    if (_e703 < 9u) {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e709 = global_1.member[_e643].member[_e703];
                                                    let _e710 = (6u + _e654);
                                                    if (_e710 < 9u) {
                                                    } else {
                                                        phi_2367_ = true;
                                                        break;
                                                    }
                                                    let _e716 = global_1.member[_e643].member[_e710];
                                                    phi_873_ = array<array<f32, 3>, 3>(array<f32, 3>(_e660, _e666, _e672), array<f32, 3>(_e680, _e687, _e694), array<f32, 3>(_e702, _e709, _e716));
                                                }
                                                let _e720 = phi_873_;
                                                let _e728 = (_e720[0][2] - _e313);
                                                let _e731 = (((_e720[0][0] - _e240) * _e337) - (_e728 * _e265));
                                                let _e734 = (((_e720[0][1] - _e277) * _e337) - (_e728 * _e301));
                                                let _e741 = (_e720[1][2] - _e313);
                                                let _e744 = (((_e720[1][0] - _e240) * _e337) - (_e741 * _e265));
                                                let _e747 = (((_e720[1][1] - _e277) * _e337) - (_e741 * _e301));
                                                let _e754 = (_e720[2][2] - _e313);
                                                let _e757 = (((_e720[2][0] - _e240) * _e337) - (_e754 * _e265));
                                                let _e760 = (((_e720[2][1] - _e277) * _e337) - (_e754 * _e301));
                                                let _e761 = (_e757 * _e747);
                                                let _e762 = (_e760 * _e744);
                                                let _e763 = (_e731 * _e760);
                                                let _e764 = (_e734 * _e757);
                                                let _e765 = (_e744 * _e734);
                                                let _e766 = (_e747 * _e731);
                                                let _e771 = (((_e761 >= _e762) && (_e763 >= _e764)) && (_e765 >= _e766));
                                                if (_e771 || (((_e761 <= _e762) && (_e763 <= _e764)) && (_e765 <= _e766))) {
                                                    let _e778 = select(-1f, 1f, _e771);
                                                    let _e780 = ((_e761 - _e762) * _e778);
                                                    let _e782 = select(0f, _e780, (_e780 > 0f));
                                                    let _e784 = ((_e763 - _e764) * _e778);
                                                    let _e786 = select(0f, _e784, (_e784 > 0f));
                                                    let _e788 = ((_e765 - _e766) * _e778);
                                                    let _e790 = select(0f, _e788, (_e788 > 0f));
                                                    let _e792 = ((_e782 + _e786) + _e790);
                                                    if (_e792 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1701_ = type_22();
                                                        phi_1702_ = true;
                                                        phi_1703_ = false;
                                                    } else {
                                                        let _e795 = select(_e744, _e731, (_e731 < _e744));
                                                        if (select(_e757, _e795, (_e795 < _e757)) > 0f) {
                                                            phi_990_ = true;
                                                        } else {
                                                            let _e800 = select(_e744, _e731, (_e731 > _e744));
                                                            phi_990_ = (select(_e757, _e800, (_e800 > _e757)) < 0f);
                                                        }
                                                        let _e805 = phi_990_;
                                                        if _e805 {
                                                            phi_1698_ = type_22();
                                                            phi_1699_ = true;
                                                            phi_1700_ = false;
                                                        } else {
                                                            let _e807 = select(_e747, _e734, (_e734 < _e747));
                                                            if (select(_e760, _e807, (_e807 < _e760)) > 0f) {
                                                                phi_1019_ = true;
                                                            } else {
                                                                let _e812 = select(_e747, _e734, (_e734 > _e747));
                                                                phi_1019_ = (select(_e760, _e812, (_e812 > _e760)) < 0f);
                                                            }
                                                            let _e817 = phi_1019_;
                                                            if _e817 {
                                                                phi_1696_ = type_22();
                                                                phi_1697_ = false;
                                                            } else {
                                                                let _e819 = select(_e720[1][0], _e720[0][0], (_e720[0][0] < _e720[1][0]));
                                                                let _e823 = select(_e720[1][0], _e720[0][0], (_e720[0][0] > _e720[1][0]));
                                                                let _e827 = select(_e720[1][1], _e720[0][1], (_e720[0][1] < _e720[1][1]));
                                                                let _e831 = select(_e720[1][1], _e720[0][1], (_e720[0][1] > _e720[1][1]));
                                                                let _e835 = select(_e720[1][2], _e720[0][2], (_e720[0][2] < _e720[1][2]));
                                                                let _e839 = select(_e720[1][2], _e720[0][2], (_e720[0][2] > _e720[1][2]));
                                                                let _e844 = ((select(_e720[2][0], _e819, (_e819 < _e720[2][0])) - _e263) * _e268);
                                                                let _e845 = ((select(_e720[2][0], _e823, (_e823 > _e720[2][0])) - _e264) * _e268);
                                                                let _e848 = ((select(_e720[2][1], _e827, (_e827 < _e720[2][1])) - _e299) * _e304);
                                                                let _e849 = ((select(_e720[2][1], _e831, (_e831 > _e720[2][1])) - _e300) * _e304);
                                                                let _e852 = ((select(_e720[2][2], _e835, (_e835 < _e720[2][2])) - _e335) * _e340);
                                                                let _e853 = ((select(_e720[2][2], _e839, (_e839 > _e720[2][2])) - _e336) * _e340);
                                                                let _e855 = select(_e853, _e852, (_e852 < _e853));
                                                                let _e857 = select(_e853, _e852, (_e852 > _e853));
                                                                let _e859 = select(_e845, _e844, (_e844 < _e845));
                                                                let _e861 = select(_e849, _e848, (_e848 < _e849));
                                                                let _e863 = select(_e861, _e859, (_e859 > _e861));
                                                                let _e865 = select(_e855, _e863, (_e863 > _e855));
                                                                let _e867 = select(_e845, _e844, (_e844 > _e845));
                                                                let _e869 = select(_e849, _e848, (_e848 > _e849));
                                                                let _e871 = select(_e869, _e867, (_e867 < _e869));
                                                                let _e873 = select(_e857, _e871, (_e871 < _e857));
                                                                let _e874 = -(_e855);
                                                                let _e880 = select(_e386, _e865, (_e865 > _e386));
                                                                if (_e880 > (_e873 + (select(_e874, _e857, (_e857 > _e874)) * 0.0000019073523f))) {
                                                                    phi_1691_ = type_22();
                                                                    phi_1692_ = true;
                                                                } else {
                                                                    let _e882 = (_e880 > _e621.member_1);
                                                                    if _e882 {
                                                                        phi_1690_ = type_22();
                                                                    } else {
                                                                        let _e883 = vec3<f32>(_e720[0][0], _e720[0][1], _e720[0][2]);
                                                                        let _e884 = vec3<f32>(_e720[1][0], _e720[1][1], _e720[1][2]);
                                                                        let _e885 = vec3<f32>(_e720[2][0], _e720[2][1], _e720[2][2]);
                                                                        let _e886 = (_e720[1][0] - _e720[0][0]);
                                                                        let _e887 = (_e720[1][1] - _e720[0][1]);
                                                                        let _e888 = (_e720[1][2] - _e720[0][2]);
                                                                        let _e889 = vec3<f32>(_e886, _e887, _e888);
                                                                        let _e890 = (_e720[2][0] - _e720[1][0]);
                                                                        let _e891 = (_e720[2][1] - _e720[1][1]);
                                                                        let _e892 = (_e720[2][2] - _e720[1][2]);
                                                                        let _e893 = vec3<f32>(_e890, _e891, _e892);
                                                                        let _e894 = (_e720[0][0] - _e720[2][0]);
                                                                        let _e895 = (_e720[0][1] - _e720[2][1]);
                                                                        let _e896 = (_e720[0][2] - _e720[2][2]);
                                                                        let _e897 = vec3<f32>(_e894, _e895, _e896);
                                                                        let _e900 = bitcast<f32>((bitcast<u32>(_e886) & 2147483647u));
                                                                        let _e903 = bitcast<f32>((bitcast<u32>(_e887) & 2147483647u));
                                                                        let _e905 = select(_e903, _e900, (_e900 > _e903));
                                                                        let _e908 = bitcast<f32>((bitcast<u32>(_e888) & 2147483647u));
                                                                        let _e910 = select(_e908, _e905, (_e905 > _e908));
                                                                        let _e913 = bitcast<f32>((bitcast<u32>(_e890) & 2147483647u));
                                                                        let _e916 = bitcast<f32>((bitcast<u32>(_e891) & 2147483647u));
                                                                        let _e918 = select(_e916, _e913, (_e913 > _e916));
                                                                        let _e921 = bitcast<f32>((bitcast<u32>(_e892) & 2147483647u));
                                                                        let _e923 = select(_e921, _e918, (_e918 > _e921));
                                                                        let _e926 = bitcast<f32>((bitcast<u32>(_e894) & 2147483647u));
                                                                        let _e929 = bitcast<f32>((bitcast<u32>(_e895) & 2147483647u));
                                                                        let _e931 = select(_e929, _e926, (_e926 > _e929));
                                                                        let _e934 = bitcast<f32>((bitcast<u32>(_e896) & 2147483647u));
                                                                        let _e936 = select(_e934, _e931, (_e931 > _e934));
                                                                        let _e938 = select(_e923, _e910, (_e910 > _e923));
                                                                        let _e940 = select(_e936, _e938, (_e938 > _e936));
                                                                        if (_e910 == _e940) {
                                                                            phi_1420_ = _e747;
                                                                            phi_1421_ = _e744;
                                                                            phi_1422_ = _e734;
                                                                            phi_1423_ = _e731;
                                                                            phi_1424_ = _e883;
                                                                            phi_1425_ = _e897;
                                                                            phi_1426_ = _e893;
                                                                            phi_1427_ = _e889;
                                                                        } else {
                                                                            let _e942 = (_e923 == _e940);
                                                                            let _e947 = vec3(_e942);
                                                                            phi_1420_ = select(_e734, _e760, _e942);
                                                                            phi_1421_ = select(_e731, _e757, _e942);
                                                                            phi_1422_ = select(_e760, _e747, _e942);
                                                                            phi_1423_ = select(_e757, _e744, _e942);
                                                                            phi_1424_ = select(_e885, _e884, _e947);
                                                                            phi_1425_ = select(_e893, _e889, _e947);
                                                                            phi_1426_ = select(_e889, _e897, _e947);
                                                                            phi_1427_ = select(_e897, _e893, _e947);
                                                                        }
                                                                        let _e953 = phi_1420_;
                                                                        let _e955 = phi_1421_;
                                                                        let _e957 = phi_1422_;
                                                                        let _e959 = phi_1423_;
                                                                        let _e961 = phi_1424_;
                                                                        let _e963 = phi_1425_;
                                                                        let _e965 = phi_1426_;
                                                                        let _e967 = phi_1427_;
                                                                        let _e974 = ((_e965.y * _e963.z) - (_e963.y * _e965.z));
                                                                        let _e979 = ((_e965.z * _e963.x) - (_e963.z * _e965.x));
                                                                        let _e982 = ((_e965.x * _e963.y) - (_e963.x * _e965.y));
                                                                        if (_e782 >= _e786) {
                                                                            phi_1458_ = select(true, false, (_e782 >= _e790));
                                                                        } else {
                                                                            phi_1458_ = true;
                                                                        }
                                                                        let _e987 = phi_1458_;
                                                                        if _e987 {
                                                                            phi_1467_ = select(_e885, _e884, vec3((_e786 >= _e790)));
                                                                        } else {
                                                                            phi_1467_ = _e883;
                                                                        }
                                                                        let _e992 = phi_1467_;
                                                                        let _e997 = (((_e974 * _e265) + (_e979 * _e301)) + (_e982 * _e337));
                                                                        let _e1008 = (((_e974 * (_e992.x - _e240)) + (_e979 * (_e992.y - _e277))) + (_e982 * (_e992.z - _e313)));
                                                                        let _e1010 = (_e955 - _e959);
                                                                        let _e1011 = (_e953 - _e957);
                                                                        let _e1019 = (-(((_e959 * _e1010) + (_e957 * _e1011))) / ((_e1010 * _e1010) + (_e1011 * _e1011)));
                                                                        let _e1021 = select(1f, _e1019, (_e1019 < 1f));
                                                                        let _e1023 = select(0f, _e1021, (_e1021 > 0f));
                                                                        let _e1036 = ((_e961.x + (_e967.x * _e1023)) - _e240);
                                                                        let _e1037 = ((_e961.y + (_e967.y * _e1023)) - _e277);
                                                                        let _e1038 = ((_e961.z + (_e967.z * _e1023)) - _e313);
                                                                        let _e1039 = (_e1038 / _e337);
                                                                        let _e1051 = bitcast<f32>((bitcast<u32>(_e1036) & 2147483647u));
                                                                        let _e1054 = bitcast<f32>((bitcast<u32>(_e1037) & 2147483647u));
                                                                        let _e1056 = select(_e1054, _e1051, (_e1051 > _e1054));
                                                                        let _e1059 = bitcast<f32>((bitcast<u32>(_e1038) & 2147483647u));
                                                                        let _e1061 = select(_e1059, _e1056, (_e1056 > _e1059));
                                                                        let _e1067 = bitcast<f32>((bitcast<u32>(_e974) & 2147483647u));
                                                                        let _e1070 = bitcast<f32>((bitcast<u32>(_e979) & 2147483647u));
                                                                        let _e1072 = select(_e1070, _e1067, (_e1067 > _e1070));
                                                                        let _e1075 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e974 * _e1036) + (_e979 * _e1037)) + (_e982 * _e1038)) - _e1008)) & 2147483647u)) <= ((0.0000009536743f * select(_e940, _e1061, (_e1061 > _e940))) * select(_e1075, _e1072, (_e1072 > _e1075)))) {
                                                                            let _e1085 = bitcast<f32>((bitcast<u32>(_e965.x) & 2147483647u));
                                                                            let _e1088 = bitcast<f32>((bitcast<u32>(_e965.y) & 2147483647u));
                                                                            let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                                                                            let _e1093 = bitcast<f32>((bitcast<u32>(_e965.z) & 2147483647u));
                                                                            let _e1099 = bitcast<f32>((bitcast<u32>(_e963.x) & 2147483647u));
                                                                            let _e1102 = bitcast<f32>((bitcast<u32>(_e963.y) & 2147483647u));
                                                                            let _e1104 = select(_e1102, _e1099, (_e1099 > _e1102));
                                                                            let _e1107 = bitcast<f32>((bitcast<u32>(_e963.z) & 2147483647u));
                                                                            phi_1634_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e997) & 2147483647u)) > ((0.0000038146973f * select(_e1093, _e1090, (_e1090 > _e1093))) * select(_e1107, _e1104, (_e1104 > _e1107)))));
                                                                        } else {
                                                                            phi_1634_ = true;
                                                                        }
                                                                        let _e1114 = phi_1634_;
                                                                        if _e1114 {
                                                                            let _e1125 = ((((_e974 * (_e1036 - (_e265 * _e1039))) + (_e979 * (_e1037 - (_e301 * _e1039)))) + (_e982 * (_e1038 - _e1038))) / _e997);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u)) <= _e940) {
                                                                                phi_1658_ = (_e1039 + _e1125);
                                                                            } else {
                                                                                phi_1658_ = _e1039;
                                                                            }
                                                                            let _e1132 = phi_1658_;
                                                                            phi_1659_ = _e1132;
                                                                        } else {
                                                                            phi_1659_ = (_e1008 / _e997);
                                                                        }
                                                                        let _e1134 = phi_1659_;
                                                                        let _e1136 = select(_e873, _e1134, (_e1134 < _e873));
                                                                        let _e1138 = select(_e865, _e1136, (_e1136 > _e865));
                                                                        if (_e1138 >= _e386) {
                                                                            let _e1140 = (_e1138 <= _e621.member_1);
                                                                            if _e1140 {
                                                                                let _e1141 = (1f / _e792);
                                                                                phi_1682_ = type_22(_e1138, (_e786 * _e1141), (_e790 * _e1141), _e650);
                                                                            } else {
                                                                                phi_1682_ = type_22();
                                                                            }
                                                                            let _e1146 = phi_1682_;
                                                                            phi_1684_ = _e1146;
                                                                            phi_1685_ = select(true, false, _e1140);
                                                                        } else {
                                                                            phi_1684_ = type_22();
                                                                            phi_1685_ = true;
                                                                        }
                                                                        let _e1149 = phi_1684_;
                                                                        let _e1151 = phi_1685_;
                                                                        if _e1151 {
                                                                            phi_1689_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1689_ = _e1149;
                                                                        }
                                                                        let _e1153 = phi_1689_;
                                                                        phi_1690_ = _e1153;
                                                                    }
                                                                    let _e1155 = phi_1690_;
                                                                    phi_1691_ = _e1155;
                                                                    phi_1692_ = _e882;
                                                                }
                                                                let _e1157 = phi_1691_;
                                                                let _e1159 = phi_1692_;
                                                                phi_1696_ = _e1157;
                                                                phi_1697_ = _e1159;
                                                            }
                                                            let _e1161 = phi_1696_;
                                                            let _e1163 = phi_1697_;
                                                            phi_1698_ = _e1161;
                                                            phi_1699_ = _e817;
                                                            phi_1700_ = _e1163;
                                                        }
                                                        let _e1165 = phi_1698_;
                                                        let _e1167 = phi_1699_;
                                                        let _e1169 = phi_1700_;
                                                        phi_1701_ = _e1165;
                                                        phi_1702_ = _e1167;
                                                        phi_1703_ = _e1169;
                                                    }
                                                    let _e1171 = phi_1701_;
                                                    let _e1173 = phi_1702_;
                                                    let _e1175 = phi_1703_;
                                                    phi_1711_ = _e1171;
                                                    phi_1712_ = select(_e1175, true, _e1173);
                                                } else {
                                                    phi_1711_ = type_22();
                                                    phi_1712_ = true;
                                                }
                                                let _e1178 = phi_1711_;
                                                let _e1180 = phi_1712_;
                                                if _e1180 {
                                                    phi_1716_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1716_ = _e1178;
                                                }
                                                let _e1182 = phi_1716_;
                                                if (_e1182.member_3 != 4294967295u) {
                                                    if (_e650 != _e86) {
                                                        if (_e1182.member < _e621.member.member) {
                                                            phi_1742_ = true;
                                                        } else {
                                                            if (_e1182.member == _e621.member.member) {
                                                                phi_1741_ = (_e1182.member_3 < _e621.member.member_3);
                                                            } else {
                                                                phi_1741_ = false;
                                                            }
                                                            let _e1195 = phi_1741_;
                                                            phi_1742_ = _e1195;
                                                        }
                                                        let _e1197 = phi_1742_;
                                                        if _e1197 {
                                                            phi_1748_ = type_42(_e1182, _e1182.member);
                                                        } else {
                                                            phi_1748_ = _e621;
                                                        }
                                                        let _e1200 = phi_1748_;
                                                        phi_1749_ = _e1200;
                                                    } else {
                                                        phi_1749_ = _e621;
                                                    }
                                                    let _e1202 = phi_1749_;
                                                    phi_1750_ = _e1202;
                                                } else {
                                                    phi_1750_ = _e621;
                                                }
                                                let _e1204 = phi_1750_;
                                                phi_738_ = _e1204;
                                            } else {
                                                phi_738_ = type_42();
                                            }
                                            let _e1206 = phi_738_;
                                            continue;
                                            continuing {
                                                phi_737_ = _e1206;
                                                phi_740_ = _e636;
                                                phi_2367_ = _e394;
                                                break if !(_e642);
                                            }
                                        }
                                        let _e1209 = phi_2367_;
                                        phi_2510_ = _e1209;
                                        if _e1209 {
                                            break;
                                        }
                                        phi_2514_ = _e1209;
                                        let _e1420 = local_3;
                                        phi_2205_ = _e1420;
                                        phi_2206_ = _e419;
                                        phi_2207_ = false;
                                        phi_2208_ = _e423;
                                    } else {
                                        if (_e419 >= _e67) {
                                            phi_1810_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e419 < _e67) {
                                            } else {
                                                phi_2510_ = true;
                                                break;
                                            }
                                            let _e433 = (_e208 % 3u);
                                            if (_e433 < 3u) {
                                            } else {
                                                phi_2510_ = true;
                                                break;
                                            }
                                            let _e439 = global_2.member[_e419].member[_e433];
                                            let _e445 = (_e207 % 3u);
                                            if (_e445 < 3u) {
                                            } else {
                                                phi_2510_ = true;
                                                break;
                                            }
                                            let _e451 = global_2.member[_e419].member[_e445];
                                            let _e457 = (_e209 % 3u);
                                            if (_e457 < 3u) {
                                            } else {
                                                phi_2510_ = true;
                                                break;
                                            }
                                            let _e463 = global_2.member[_e419].member[_e457];
                                            let _e473 = global_2.member[_e419].member_1;
                                            let _e477 = global_2.member[_e419].member_2;
                                            phi_1810_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e439[0], _e439[1], _e439[2], _e439[3]), vec4<f32>(_e451[0], _e451[1], _e451[2], _e451[3]), vec4<f32>(_e463[0], _e463[1], _e463[2], _e463[3])), _e473, _e477);
                                        }
                                        let _e480 = phi_1810_;
                                        let _e492 = ((_e480.member[0].x - _e263) * _e268);
                                        let _e493 = ((_e480.member[0].y - _e263) * _e268);
                                        let _e494 = ((_e480.member[0].z - _e264) * _e268);
                                        let _e495 = ((_e480.member[0].w - _e264) * _e268);
                                        let _e505 = ((_e480.member[1].x - _e299) * _e304);
                                        let _e506 = ((_e480.member[1].y - _e299) * _e304);
                                        let _e507 = ((_e480.member[1].z - _e300) * _e304);
                                        let _e508 = ((_e480.member[1].w - _e300) * _e304);
                                        let _e518 = ((_e480.member[2].x - _e335) * _e340);
                                        let _e519 = ((_e480.member[2].y - _e335) * _e340);
                                        let _e520 = ((_e480.member[2].z - _e336) * _e340);
                                        let _e521 = ((_e480.member[2].w - _e336) * _e340);
                                        let _e523 = select(_e520, _e518, (_e518 < _e520));
                                        let _e525 = select(_e521, _e519, (_e519 < _e521));
                                        let _e527 = select(_e520, _e518, (_e518 > _e520));
                                        let _e529 = select(_e521, _e519, (_e519 > _e521));
                                        let _e531 = select(_e494, _e492, (_e492 < _e494));
                                        let _e533 = select(_e495, _e493, (_e493 < _e495));
                                        let _e535 = select(_e507, _e505, (_e505 < _e507));
                                        let _e537 = select(_e508, _e506, (_e506 < _e508));
                                        let _e539 = select(_e535, _e531, (_e531 > _e535));
                                        let _e541 = select(_e537, _e533, (_e533 > _e537));
                                        let _e543 = select(_e523, _e539, (_e539 > _e523));
                                        let _e545 = select(_e525, _e541, (_e541 > _e525));
                                        let _e547 = select(_e494, _e492, (_e492 > _e494));
                                        let _e549 = select(_e495, _e493, (_e493 > _e495));
                                        let _e551 = select(_e507, _e505, (_e505 > _e507));
                                        let _e553 = select(_e508, _e506, (_e506 > _e508));
                                        let _e555 = select(_e551, _e547, (_e547 < _e551));
                                        let _e557 = select(_e553, _e549, (_e549 < _e553));
                                        let _e562 = -(_e523);
                                        let _e563 = -(_e525);
                                        let _e570 = (select(_e527, _e555, (_e555 < _e527)) + (select(_e562, _e527, (_e527 > _e562)) * 0.0000019073523f));
                                        let _e571 = (select(_e529, _e557, (_e557 < _e529)) + (select(_e563, _e529, (_e529 > _e563)) * 0.0000019073523f));
                                        let _e573 = select(_e386, _e543, (_e543 > _e386));
                                        let _e575 = select(_e386, _e545, (_e545 > _e386));
                                        let _e580 = (_e573 <= select(_e396.member_1, _e570, (_e570 < _e396.member_1)));
                                        let _e581 = (_e575 <= select(_e396.member_1, _e571, (_e571 < _e396.member_1)));
                                        let _e582 = (_e573 <= _e575);
                                        if _e580 {
                                            if _e581 {
                                                if _e582 {
                                                    phi_2154_ = _e480.member_2;
                                                } else {
                                                    phi_2154_ = _e480.member_1;
                                                }
                                                let _e586 = phi_2154_;
                                                let _e589 = (_e423 % 128u);
                                                let _e590 = (_e589 < 128u);
                                                if _e590 {
                                                } else {
                                                    phi_2510_ = true;
                                                    break;
                                                }
                                                local_1[_e589] = _e586;
                                                if _e590 {
                                                } else {
                                                    phi_2510_ = true;
                                                    break;
                                                }
                                                local[_e589] = select(_e575, _e573, (_e573 > _e575));
                                                if _e582 {
                                                    phi_2182_ = _e480.member_1;
                                                } else {
                                                    phi_2182_ = _e480.member_2;
                                                }
                                                let _e597 = phi_2182_;
                                                phi_2183_ = _e597;
                                                phi_2184_ = (_e423 + 1u);
                                            } else {
                                                phi_2183_ = u32();
                                                phi_2184_ = u32();
                                            }
                                            let _e599 = phi_2183_;
                                            let _e601 = phi_2184_;
                                            phi_2186_ = _e599;
                                            phi_2187_ = _e601;
                                            phi_2188_ = select(true, false, _e581);
                                        } else {
                                            phi_2186_ = u32();
                                            phi_2187_ = u32();
                                            phi_2188_ = true;
                                        }
                                        let _e604 = phi_2186_;
                                        let _e606 = phi_2187_;
                                        let _e608 = phi_2188_;
                                        if _e608 {
                                            if _e580 {
                                                phi_2197_ = _e480.member_1;
                                            } else {
                                                phi_2197_ = _e480.member_2;
                                            }
                                            let _e612 = phi_2197_;
                                            phi_2202_ = _e612;
                                            phi_2203_ = select(_e581, true, _e580);
                                        } else {
                                            phi_2202_ = _e604;
                                            phi_2203_ = _e421;
                                        }
                                        let _e615 = phi_2202_;
                                        let _e617 = phi_2203_;
                                        phi_2514_ = _e394;
                                        phi_2205_ = _e396;
                                        phi_2206_ = _e615;
                                        phi_2207_ = _e617;
                                        phi_2208_ = select(_e606, _e423, _e608);
                                    }
                                    let _e1211 = phi_2514_;
                                    let _e1213 = phi_2205_;
                                    let _e1215 = phi_2206_;
                                    let _e1217 = phi_2207_;
                                    let _e1219 = phi_2208_;
                                    phi_2513_ = _e1211;
                                    phi_2209_ = _e1213;
                                    phi_2210_ = _e1215;
                                    phi_2211_ = (_e400 - 1u);
                                    phi_2212_ = _e1217;
                                    phi_2213_ = _e1219;
                                } else {
                                    phi_2513_ = _e394;
                                    phi_2209_ = _e396;
                                    phi_2210_ = _e419;
                                    phi_2211_ = _e400;
                                    phi_2212_ = _e421;
                                    phi_2213_ = _e423;
                                }
                                let _e1221 = phi_2513_;
                                let _e1223 = phi_2209_;
                                let _e1225 = phi_2210_;
                                let _e1227 = phi_2211_;
                                let _e1229 = phi_2212_;
                                let _e1231 = phi_2213_;
                                phi_2512_ = _e1221;
                                phi_2214_ = _e1223;
                                phi_2215_ = _e1225;
                                phi_2216_ = _e1227;
                                phi_2217_ = _e1229;
                                phi_2218_ = _e1231;
                            } else {
                                phi_2512_ = _e394;
                                phi_2214_ = type_42();
                                phi_2215_ = u32();
                                phi_2216_ = u32();
                                phi_2217_ = bool();
                                phi_2218_ = u32();
                            }
                            let _e1233 = phi_2512_;
                            let _e1235 = phi_2214_;
                            let _e1237 = phi_2215_;
                            let _e1239 = phi_2216_;
                            let _e1241 = phi_2217_;
                            let _e1243 = phi_2218_;
                            phi_2511_ = _e1233;
                            phi_669_ = _e1235;
                            phi_672_ = _e1237;
                            phi_674_ = _e1239;
                            phi_676_ = _e1241;
                            phi_678_ = _e1243;
                            phi_2219_ = _e408;
                        } else {
                            phi_2511_ = _e394;
                            phi_669_ = type_42();
                            phi_672_ = u32();
                            phi_674_ = u32();
                            phi_676_ = bool();
                            phi_678_ = u32();
                            phi_2219_ = false;
                        }
                        let _e1245 = phi_2511_;
                        let _e1247 = phi_669_;
                        let _e1249 = phi_672_;
                        let _e1251 = phi_674_;
                        let _e1253 = phi_676_;
                        let _e1255 = phi_678_;
                        let _e1257 = phi_2219_;
                        continue;
                        continuing {
                            phi_2373_ = _e1245;
                            phi_668_ = _e1247;
                            phi_671_ = _e1249;
                            phi_673_ = _e1251;
                            phi_675_ = _e1253;
                            phi_677_ = _e1255;
                            phi_2510_ = _e1245;
                            break if !(_e1257);
                        }
                    }
                    let _e1260 = phi_2510_;
                    if _e1260 {
                        break;
                    }
                    let _e1262 = local_2;
                    if (_e1262.member.member_3 != 4294967295u) {
                        let _e1267 = (_e210 / 3i);
                        let _e1274 = bitcast<f32>((bitcast<u32>((_e1267 + 127i)) << bitcast<u32>(23i)));
                        let _e1282 = (((_e1262.member.member * _e1274) * _e1274) * bitcast<f32>((bitcast<u32>(((_e210 - (2i * _e1267)) + 127i)) << bitcast<u32>(23i))));
                        let _e1284 = select(340282350000000000000000000000000000000f, _e1282, (_e1282 < 340282350000000000000000000000000000000f));
                        phi_2271_ = type_22(select(-340282350000000000000000000000000000000f, _e1284, (_e1284 > -340282350000000000000000000000000000000f)), _e1262.member.member_1, _e1262.member.member_2, _e1262.member.member_3);
                    } else {
                        phi_2271_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1291 = phi_2271_;
                    if _e87 {
                    } else {
                        break;
                    }
                    global_4.member[_e79] = _e1291;
                    if _e80 {
                    } else {
                        break;
                    }
                    let _e1295 = select(0u, 1u, (_e154 <= _e164));
                    if (_e1295 > 0u) {
                        let _e1297 = (1u < _e75);
                        if _e1297 {
                            if (0u < _e75) {
                            } else {
                                break;
                            }
                            let _e1301 = atomicAdd((&global_5.member[0u]), _e1295);
                            if ((_e1301 + _e1295) < _e1301) {
                                if _e1297 {
                                } else {
                                    break;
                                }
                                let _e1306 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1309 = select(0u, 1u, (_e1291.member_3 != 4294967295u));
                    if (_e1309 > 0u) {
                        let _e1311 = (3u < _e75);
                        if _e1311 {
                            if (2u < _e75) {
                            } else {
                                break;
                            }
                            let _e1315 = atomicAdd((&global_5.member[2u]), _e1309);
                            if ((_e1315 + _e1309) < _e1315) {
                                if _e1311 {
                                } else {
                                    break;
                                }
                                let _e1320 = atomicAdd((&global_5.member[3u]), 1u);
                            }
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
fn trace_paths(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
