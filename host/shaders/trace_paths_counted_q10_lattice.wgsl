struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
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
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: type_22,
    member_1: f32,
}

struct type_42 {
    member: type_39,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: type_34,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

struct type_61 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_24;
@group(0) @binding(0) 
var<uniform> global_2: type_44;
@group(0) @binding(1) 
var<storage> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_61;
@group(0) @binding(2) 
var<storage> global_7: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var local_10: array<u32, 3>;
    var local_11: array<array<f32, 3>, 3>;
    var local_12: array<f32, 4>;
    var phi_410_: i32;
    var phi_411_: i32;
    var phi_421_: bool;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_434_: bool;
    var phi_439_: u32;
    var phi_472_: i32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_507_: f32;
    var phi_513_: f32;
    var phi_536_: f32;
    var phi_547_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_602_: f32;
    var phi_613_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_668_: f32;
    var phi_679_: f32;
    var phi_779_: f32;
    var phi_780_: f32;
    var phi_3624_: bool;
    var phi_878_: type_42;
    var phi_881_: type_53;
    var phi_883_: u32;
    var phi_885_: bool;
    var phi_887_: u32;
    var phi_898_: bool;
    var phi_984_: type_53;
    var phi_985_: bool;
    var phi_986_: u32;
    var phi_2475_: u32;
    var phi_2481_: u32;
    var phi_2735_: u32;
    var phi_2736_: u32;
    var phi_2746_: u32;
    var phi_2748_: u32;
    var phi_2749_: bool;
    var phi_2769_: u32;
    var phi_2770_: u32;
    var phi_2774_: type_54;
    var phi_3118_: type_53;
    var phi_3195_: type_53;
    var phi_3196_: type_53;
    var phi_3197_: u32;
    var phi_3199_: type_53;
    var phi_3200_: u32;
    var phi_3201_: bool;
    var phi_3210_: type_53;
    var phi_3215_: type_53;
    var phi_3216_: bool;
    var phi_3621_: bool;
    var phi_1005_: type_42;
    var phi_1008_: type_8;
    var phi_1009_: type_8;
    var phi_1031_: type_8;
    var phi_1075_: u32;
    var phi_1081_: u32;
    var phi_1091_: u32;
    var phi_1107_: u32;
    var phi_1144_: u32;
    var phi_1150_: u32;
    var phi_1160_: u32;
    var phi_3606_: bool;
    var phi_1176_: type_8;
    var phi_1177_: type_8;
    var phi_1200_: type_8;
    var phi_1223_: u32;
    var phi_1238_: u32;
    var phi_1241_: type_8;
    var phi_1242_: type_8;
    var phi_1265_: type_8;
    var phi_1331_: u32;
    var phi_1311_: u32;
    var phi_1312_: u32;
    var phi_1335_: f32;
    var phi_3599_: bool;
    var phi_3678_: bool;
    var phi_3677_: bool;
    var phi_1835_: vec3<f32>;
    var phi_1836_: vec3<f32>;
    var phi_1867_: bool;
    var phi_1876_: vec3<f32>;
    var phi_1916_: type_22;
    var phi_1918_: type_22;
    var phi_1919_: bool;
    var phi_1923_: type_22;
    var phi_1924_: type_22;
    var phi_1925_: type_22;
    var phi_1926_: bool;
    var phi_1930_: type_22;
    var phi_1931_: bool;
    var phi_1935_: type_22;
    var phi_1936_: bool;
    var phi_1940_: type_22;
    var phi_1965_: bool;
    var phi_1966_: bool;
    var phi_1973_: type_42;
    var phi_1974_: type_42;
    var phi_1975_: type_42;
    var phi_3680_: bool;
    var phi_1006_: type_42;
    var phi_3679_: bool;
    var phi_3742_: bool;
    var phi_3218_: type_42;
    var phi_3219_: type_53;
    var phi_3220_: bool;
    var phi_3221_: u32;
    var phi_3741_: bool;
    var phi_3222_: type_42;
    var phi_3223_: type_53;
    var phi_3224_: u32;
    var phi_3225_: bool;
    var phi_3226_: u32;
    var phi_3740_: bool;
    var phi_3227_: type_42;
    var phi_3228_: type_53;
    var phi_3229_: u32;
    var phi_3230_: bool;
    var phi_3231_: u32;
    var phi_3739_: bool;
    var phi_879_: type_42;
    var phi_882_: type_53;
    var phi_884_: u32;
    var phi_886_: bool;
    var phi_888_: u32;
    var phi_3232_: bool;
    var phi_3738_: bool;
    var local_13: type_42;
    var phi_3284_: type_22;
    var local_14: type_42;
    var local_15: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e95 = arrayLength((&global_3.member));
            let _e98 = arrayLength((&global_7.member));
            let _e106 = arrayLength((&global_6.member));
            let _e110 = global_2.member[0u][0u];
            let _e114 = global_2.member[0u][1u];
            let _e118 = global_2.member[0u][2u];
            let _e122 = global_2.member[0u][3u];
            let _e126 = global_2.member[1u][0u];
            let _e130 = global_2.member[1u][1u];
            let _e134 = global_2.member[1u][2u];
            let _e138 = (_e93.x + (_e93.y * 2097152u));
            let _e150 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e122) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            local = array<i32, 3>(bitcast<i32>(_e126), bitcast<i32>(_e130), bitcast<i32>(_e134));
            let _e153 = (_e138 < arrayLength((&global_4.member)));
            if _e153 {
                let _e154 = (_e138 < arrayLength((&global_1.member)));
                if _e154 {
                    let _e155 = (_e138 < arrayLength((&global_5.member)));
                    if _e155 {
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e165 = global_4.member[_e138].member.member_2[0u];
                        let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                        let _e173 = global_4.member[_e138].member.member_2[1u];
                        let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                        let _e181 = global_4.member[_e138].member.member_2[2u];
                        let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                        let _e189 = global_4.member[_e138].member.member[0u];
                        let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                        let _e197 = global_4.member[_e138].member.member[1u];
                        let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                        let _e205 = global_4.member[_e138].member.member[2u];
                        let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                        let _e209 = select(_e175, _e167, (_e175 < _e167));
                        let _e211 = select(_e183, _e209, (_e183 < _e209));
                        let _e213 = select(_e191, _e211, (_e191 < _e211));
                        let _e215 = select(_e199, _e213, (_e199 < _e213));
                        let _e217 = select(_e207, _e215, (_e207 < _e215));
                        let _e222 = global_4.member[_e138].member.member_1;
                        let _e224 = (bitcast<u32>(_e222) & 2147483647u);
                        let _e232 = global_4.member[_e138].member.member_3;
                        let _e238 = (((select(_e224, _e217, (_e224 < _e217)) < 2139095040u) && ((bitcast<u32>(_e232) & 2147483647u) <= 2139095040u)) && (_e211 > 0u));
                        if _e238 {
                            let _e241 = (bitcast<u32>(bitcast<f32>(_e211)) & 2147483647u);
                            if (_e241 >= 8388608u) {
                                phi_410_ = (bitcast<i32>((_e241 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e241)), 32u, (_e241 == 0u))));
                            }
                            let _e255 = phi_410_;
                            phi_411_ = _e255;
                        } else {
                            phi_411_ = 0i;
                        }
                        let _e257 = phi_411_;
                        let _e258 = (_e167 == _e211);
                        if _e258 {
                            phi_421_ = true;
                        } else {
                            phi_421_ = (_e175 == _e211);
                        }
                        let _e261 = phi_421_;
                        let _e262 = select(1u, 0u, _e258);
                        if _e261 {
                            let _e263 = (_e262 + 1u);
                            phi_431_ = _e263;
                            phi_432_ = _e263;
                            phi_434_ = select(true, false, (_e263 == 2u));
                        } else {
                            phi_431_ = u32();
                            phi_432_ = 0u;
                            phi_434_ = true;
                        }
                        let _e267 = phi_431_;
                        let _e269 = phi_432_;
                        let _e271 = phi_434_;
                        if _e271 {
                            phi_439_ = (_e269 + 1u);
                        } else {
                            phi_439_ = 0u;
                        }
                        let _e275 = phi_439_;
                        let _e276 = select(_e267, _e269, _e271);
                        let _e277 = select(_e262, select(2u, _e262, _e261), _e271);
                        let _e278 = -(_e257);
                        if (_e278 < -126i) {
                            phi_472_ = -126i;
                        } else {
                            phi_472_ = select(_e278, 127i, (_e278 > 127i));
                        }
                        let _e283 = phi_472_;
                        let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                        let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                        let _e299 = global_4.member[_e138].member.member;
                        let _e300 = (_e276 == 0u);
                        if _e300 {
                            phi_490_ = _e299[0];
                        } else {
                            phi_490_ = _e299[1];
                        }
                        let _e304 = phi_490_;
                        let _e305 = (_e276 == 2u);
                        if _e305 {
                            phi_496_ = _e299[2];
                        } else {
                            phi_496_ = _e304;
                        }
                        let _e308 = phi_496_;
                        let _e309 = global_4.member[_e138].member.member_2;
                        if _e300 {
                            phi_507_ = _e309[0];
                        } else {
                            phi_507_ = _e309[1];
                        }
                        let _e313 = phi_507_;
                        if _e305 {
                            phi_513_ = _e309[2];
                        } else {
                            phi_513_ = _e313;
                        }
                        let _e316 = phi_513_;
                        let _e318 = ((_e316 * _e288) * _e294);
                        let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e322 {
                            let _e326 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                            phi_536_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                        } else {
                            phi_536_ = 0f;
                        }
                        let _e330 = phi_536_;
                        let _e331 = (_e308 + _e330);
                        let _e332 = (_e308 - _e330);
                        let _e333 = select(_e318, 0f, _e322);
                        if _e322 {
                            phi_547_ = 38685626000000000000000000f;
                        } else {
                            phi_547_ = (1f / _e318);
                        }
                        let _e336 = phi_547_;
                        let _e337 = (_e275 == 0u);
                        if _e337 {
                            phi_556_ = _e299[0];
                        } else {
                            phi_556_ = _e299[1];
                        }
                        let _e341 = phi_556_;
                        let _e342 = (_e275 == 2u);
                        if _e342 {
                            phi_562_ = _e299[2];
                        } else {
                            phi_562_ = _e341;
                        }
                        let _e345 = phi_562_;
                        if _e337 {
                            phi_573_ = _e309[0];
                        } else {
                            phi_573_ = _e309[1];
                        }
                        let _e349 = phi_573_;
                        if _e342 {
                            phi_579_ = _e309[2];
                        } else {
                            phi_579_ = _e349;
                        }
                        let _e352 = phi_579_;
                        let _e354 = ((_e352 * _e288) * _e294);
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e358 {
                            let _e362 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) * 0.00000011920929f);
                            phi_602_ = select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f));
                        } else {
                            phi_602_ = 0f;
                        }
                        let _e366 = phi_602_;
                        let _e367 = (_e345 + _e366);
                        let _e368 = (_e345 - _e366);
                        let _e369 = select(_e354, 0f, _e358);
                        if _e358 {
                            phi_613_ = 38685626000000000000000000f;
                        } else {
                            phi_613_ = (1f / _e354);
                        }
                        let _e372 = phi_613_;
                        let _e373 = (_e277 == 0u);
                        if _e373 {
                            phi_622_ = _e299[0];
                        } else {
                            phi_622_ = _e299[1];
                        }
                        let _e377 = phi_622_;
                        let _e378 = (_e277 == 2u);
                        if _e378 {
                            phi_628_ = _e299[2];
                        } else {
                            phi_628_ = _e377;
                        }
                        let _e381 = phi_628_;
                        if _e373 {
                            phi_639_ = _e309[0];
                        } else {
                            phi_639_ = _e309[1];
                        }
                        let _e385 = phi_639_;
                        if _e378 {
                            phi_645_ = _e309[2];
                        } else {
                            phi_645_ = _e385;
                        }
                        let _e388 = phi_645_;
                        let _e390 = ((_e388 * _e288) * _e294);
                        let _e394 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e394 {
                            let _e398 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) * 0.00000011920929f);
                            phi_668_ = select(0.00000000000011368684f, _e398, (_e398 > 0.00000000000011368684f));
                        } else {
                            phi_668_ = 0f;
                        }
                        let _e402 = phi_668_;
                        let _e403 = (_e381 + _e402);
                        let _e404 = (_e381 - _e402);
                        let _e405 = select(_e390, 0f, _e394);
                        if _e394 {
                            phi_679_ = 38685626000000000000000000f;
                        } else {
                            phi_679_ = (1f / _e390);
                        }
                        let _e408 = phi_679_;
                        let _e411 = bitcast<f32>((bitcast<u32>(_e308) & 2147483647u));
                        let _e414 = bitcast<f32>((bitcast<u32>(_e345) & 2147483647u));
                        let _e416 = select(_e414, _e411, (_e411 > _e414));
                        let _e419 = bitcast<f32>((bitcast<u32>(_e381) & 2147483647u));
                        if (_e238 && (select(_e419, _e416, (_e416 > _e419)) <= 1099511600000f)) {
                            let _e424 = (_e257 / 3i);
                            let _e431 = bitcast<f32>((bitcast<u32>((_e424 + 127i)) << bitcast<u32>(23i)));
                            let _e438 = bitcast<f32>((bitcast<u32>(((_e257 - (2i * _e424)) + 127i)) << bitcast<u32>(23i)));
                            let _e439 = (((_e222 * _e431) * _e431) * _e438);
                            let _e441 = select(340282350000000000000000000000000000000f, _e439, (_e439 < 340282350000000000000000000000000000000f));
                            let _e446 = (((_e232 * _e431) * _e431) * _e438);
                            let _e448 = select(340282350000000000000000000000000000000f, _e446, (_e446 < 340282350000000000000000000000000000000f));
                            phi_779_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                            phi_780_ = select(-340282350000000000000000000000000000000f, _e441, (_e441 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_779_ = 0f;
                            phi_780_ = 1f;
                        }
                        let _e452 = phi_779_;
                        let _e454 = phi_780_;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e460 = global_4.member[_e138].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e463 = (_e276 % 3u);
                        let _e464 = (_e463 < 3u);
                        if _e464 {
                        } else {
                            break;
                        }
                        let _e466 = local_1[_e463];
                        let _e469 = (_e275 % 3u);
                        let _e470 = (_e469 < 3u);
                        if _e470 {
                        } else {
                            break;
                        }
                        let _e472 = local_1[_e469];
                        let _e475 = (_e277 % 3u);
                        let _e476 = (_e475 < 3u);
                        if _e476 {
                        } else {
                            break;
                        }
                        let _e478 = local_1[_e475];
                        if _e464 {
                        } else {
                            break;
                        }
                        let _e483 = local[_e463];
                        if _e470 {
                        } else {
                            break;
                        }
                        let _e487 = local[_e469];
                        if _e476 {
                        } else {
                            break;
                        }
                        let _e491 = local[_e475];
                        phi_3624_ = false;
                        phi_878_ = type_42(type_39(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e452), 0u, 0u);
                        phi_881_ = type_53(type_34(vec4<f32>((f32(_e466) * _e150), (f32(_e472) * _e150), (f32(_e478) * _e150), 0f), vec4<f32>((f32(_e483) * _e150), (f32(_e487) * _e150), (f32(_e491) * _e150), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                        phi_883_ = ((3u * _e95) + 1u);
                        phi_885_ = (_e454 <= _e452);
                        phi_887_ = 0u;
                        loop {
                            let _e501 = phi_3624_;
                            let _e503 = phi_878_;
                            let _e505 = phi_881_;
                            let _e507 = phi_883_;
                            let _e509 = phi_885_;
                            let _e511 = phi_887_;
                            local_13 = _e503;
                            local_14 = _e503;
                            if _e509 {
                                phi_898_ = true;
                            } else {
                                phi_898_ = (_e511 > 0u);
                            }
                            let _e514 = phi_898_;
                            if _e514 {
                                let _e515 = (_e507 > 0u);
                                if _e515 {
                                    if _e509 {
                                        phi_984_ = _e505;
                                        phi_985_ = _e509;
                                        phi_986_ = _e511;
                                    } else {
                                        let _e516 = (_e511 - 1u);
                                        let _e517 = (_e516 % 128u);
                                        let _e518 = (_e517 < 128u);
                                        if _e518 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e520 = local_7[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e522 = local_6[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e524 = local_5[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e526 = local_4[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e528 = local_3[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e530 = local_2[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e535 = local_8[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e538 = local_9[_e517];
                                        phi_984_ = type_53(type_34(vec4<f32>(_e520, _e522, _e524, 0f), vec4<f32>(_e526, _e528, _e530, 0f)), _e535);
                                        phi_985_ = (_e538 <= _e503.member.member_1);
                                        phi_986_ = _e516;
                                    }
                                    let _e543 = phi_984_;
                                    let _e545 = phi_985_;
                                    let _e547 = phi_986_;
                                    if _e545 {
                                        let _e552 = (_e543.member_1 & 268435455u);
                                        if ((_e543.member_1 & 2147483648u) != 0u) {
                                            phi_3621_ = _e501;
                                            phi_1005_ = _e503;
                                            phi_1008_ = type_8(0u, ((_e543.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1019 = phi_3621_;
                                                let _e1021 = phi_1005_;
                                                let _e1023 = phi_1008_;
                                                local_15 = _e1021;
                                                if (_e1023.member < _e1023.member_1) {
                                                    phi_1009_ = type_8((_e1023.member + 1u), _e1023.member_1);
                                                    phi_1031_ = type_8(1u, _e1023.member);
                                                } else {
                                                    phi_1009_ = _e1023;
                                                    phi_1031_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1036 = phi_1009_;
                                                let _e1038 = phi_1031_;
                                                let _e1042 = (bitcast<i32>(_e1038.member) != 0i);
                                                if _e1042 {
                                                    let _e1048 = type_42(_e1021.member, _e1021.member_1, (_e1021.member_2 + 1u));
                                                    let _e1053 = (_e543.member.member_1.x - _e543.member.member.x);
                                                    let _e1056 = (_e543.member.member_1.y - _e543.member.member.y);
                                                    let _e1059 = (_e543.member.member_1.z - _e543.member.member.z);
                                                    let _e1061 = select(_e1056, _e1053, (_e1053 > _e1056));
                                                    let _e1063 = select(_e1059, _e1061, (_e1061 > _e1059));
                                                    let _e1065 = (_e1063 < (1024f * _e150));
                                                    if _e1065 {
                                                        phi_1075_ = 0u;
                                                    } else {
                                                        phi_1075_ = select(2u, 1u, (_e1063 < (2097152f * _e150)));
                                                    }
                                                    let _e1070 = phi_1075_;
                                                    switch bitcast<i32>(_e1070) {
                                                        case 0: {
                                                            phi_1081_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1081_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1081_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1081_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1073 = phi_1081_;
                                                    switch bitcast<i32>(_e1070) {
                                                        case 0: {
                                                            phi_1091_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1091_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1091_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1091_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1080 = phi_1091_;
                                                    let _e1082 = ((_e552 + (_e1038.member_1 * ((3u * _e1073) + 1u))) + (3u * _e1080));
                                                    let _e1083 = (_e1082 < _e98);
                                                    if _e1083 {
                                                        if _e1083 {
                                                        } else {
                                                            phi_3679_ = true;
                                                            break;
                                                        }
                                                        let _e1085 = global_7.member[_e1082];
                                                        phi_1107_ = _e1085;
                                                    } else {
                                                        phi_1107_ = 4294967295u;
                                                    }
                                                    let _e1087 = phi_1107_;
                                                    local_10 = array<u32, 3>(_e276, _e275, _e277);
                                                    if _e1065 {
                                                        phi_1144_ = 0u;
                                                    } else {
                                                        phi_1144_ = select(2u, 1u, (_e1063 < (2097152f * _e150)));
                                                    }
                                                    let _e1093 = phi_1144_;
                                                    switch bitcast<i32>(_e1093) {
                                                        case 0: {
                                                            phi_1150_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1150_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1150_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1150_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1096 = phi_1150_;
                                                    switch bitcast<i32>(_e1093) {
                                                        case 0: {
                                                            phi_1160_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1160_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1160_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1160_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1103 = phi_1160_;
                                                    local_12 = array<f32, 4>(_e543.member.member.x, _e543.member.member.y, _e543.member.member.z, _e543.member.member.w);
                                                    local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_3606_ = _e1019;
                                                    phi_1176_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1117 = phi_3606_;
                                                        let _e1119 = phi_1176_;
                                                        if (_e1119.member < _e1119.member_1) {
                                                            phi_1177_ = type_8((_e1119.member + 1u), _e1119.member_1);
                                                            phi_1200_ = type_8(1u, _e1119.member);
                                                        } else {
                                                            phi_1177_ = _e1119;
                                                            phi_1200_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1132 = phi_1177_;
                                                        let _e1134 = phi_1200_;
                                                        let _e1138 = (bitcast<i32>(_e1134.member) != 0i);
                                                        if _e1138 {
                                                            let _e1140 = ((_e552 + (_e1038.member_1 * ((3u * _e1096) + 1u))) + (_e1134.member_1 * _e1103));
                                                            let _e1141 = (_e1140 < _e98);
                                                            if _e1141 {
                                                                if _e1141 {
                                                                } else {
                                                                    phi_3677_ = true;
                                                                    break;
                                                                }
                                                                let _e1143 = global_7.member[_e1140];
                                                                phi_1223_ = _e1143;
                                                            } else {
                                                                phi_1223_ = 0u;
                                                            }
                                                            let _e1145 = phi_1223_;
                                                            let _e1146 = (_e1140 + 1u);
                                                            let _e1147 = (_e1146 < _e98);
                                                            if _e1147 {
                                                                if _e1147 {
                                                                } else {
                                                                    phi_3677_ = true;
                                                                    break;
                                                                }
                                                                let _e1149 = global_7.member[_e1146];
                                                                phi_1238_ = _e1149;
                                                            } else {
                                                                phi_1238_ = 0u;
                                                            }
                                                            let _e1151 = phi_1238_;
                                                            phi_1241_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1153 = phi_1241_;
                                                                if (_e1153.member < _e1153.member_1) {
                                                                    phi_1242_ = type_8((_e1153.member + 1u), _e1153.member_1);
                                                                    phi_1265_ = type_8(1u, _e1153.member);
                                                                } else {
                                                                    phi_1242_ = _e1153;
                                                                    phi_1265_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1166 = phi_1242_;
                                                                let _e1168 = phi_1265_;
                                                                let _e1172 = (bitcast<i32>(_e1168.member) != 0i);
                                                                if _e1172 {
                                                                    let _e1173 = (_e1168.member_1 < 3u);
                                                                    if _e1173 {
                                                                    } else {
                                                                        phi_3599_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1175 = local_10[_e1168.member_1];
                                                                    if (_e1168.member_1 < 4u) {
                                                                    } else {
                                                                        phi_3599_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1178 = local_12[_e1168.member_1];
                                                                    switch bitcast<i32>(_e1093) {
                                                                        case 0: {
                                                                            phi_1335_ = (_e1178 + (f32(((_e1145 >> bitcast<u32>(((10u * _e1175) & 31u))) & 1023u)) * _e150));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1175 == 0u) {
                                                                                phi_1312_ = _e1145;
                                                                            } else {
                                                                                if (_e1175 == 1u) {
                                                                                    phi_1311_ = ((_e1145 >> bitcast<u32>(21i)) | (_e1151 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_1311_ = (_e1151 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1199 = phi_1311_;
                                                                                phi_1312_ = _e1199;
                                                                            }
                                                                            let _e1201 = phi_1312_;
                                                                            phi_1335_ = (_e1178 + (f32((_e1201 & 2097151u)) * _e150));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1180 = (_e1140 + _e1175);
                                                                            let _e1181 = (_e1180 < _e98);
                                                                            if _e1181 {
                                                                                if _e1181 {
                                                                                } else {
                                                                                    phi_3599_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1183 = global_7.member[_e1180];
                                                                                phi_1331_ = _e1183;
                                                                            } else {
                                                                                phi_1331_ = 0u;
                                                                            }
                                                                            let _e1185 = phi_1331_;
                                                                            phi_1335_ = (f32(bitcast<i32>(_e1185)) * _e150);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_1335_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1215 = phi_1335_;
                                                                    if (_e1134.member_1 < 3u) {
                                                                    } else {
                                                                        phi_3599_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1173 {
                                                                    } else {
                                                                        phi_3599_ = true;
                                                                        break;
                                                                    }
                                                                    local_11[_e1134.member_1][_e1168.member_1] = _e1215;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_1241_ = _e1166;
                                                                    phi_3599_ = _e1117;
                                                                    break if !(_e1172);
                                                                }
                                                            }
                                                            let _e1221 = phi_3599_;
                                                            phi_3677_ = _e1221;
                                                            if _e1221 {
                                                                break;
                                                            }
                                                            phi_3678_ = _e1221;
                                                        } else {
                                                            phi_3678_ = _e1117;
                                                        }
                                                        let _e1223 = phi_3678_;
                                                        continue;
                                                        continuing {
                                                            phi_3606_ = _e1223;
                                                            phi_1176_ = _e1132;
                                                            phi_3677_ = _e1223;
                                                            break if !(_e1138);
                                                        }
                                                    }
                                                    let _e1226 = phi_3677_;
                                                    phi_3679_ = _e1226;
                                                    if _e1226 {
                                                        break;
                                                    }
                                                    let _e1227 = local_11;
                                                    let _e1244 = (_e1227[0][2] - _e381);
                                                    let _e1247 = (((_e1227[0][0] - _e308) * _e405) - (_e1244 * _e333));
                                                    let _e1250 = (((_e1227[0][1] - _e345) * _e405) - (_e1244 * _e369));
                                                    let _e1253 = (_e1227[1][2] - _e381);
                                                    let _e1256 = (((_e1227[1][0] - _e308) * _e405) - (_e1253 * _e333));
                                                    let _e1259 = (((_e1227[1][1] - _e345) * _e405) - (_e1253 * _e369));
                                                    let _e1262 = (_e1227[2][2] - _e381);
                                                    let _e1265 = (((_e1227[2][0] - _e308) * _e405) - (_e1262 * _e333));
                                                    let _e1268 = (((_e1227[2][1] - _e345) * _e405) - (_e1262 * _e369));
                                                    let _e1269 = (_e1265 * _e1259);
                                                    let _e1270 = (_e1268 * _e1256);
                                                    let _e1271 = (_e1247 * _e1268);
                                                    let _e1272 = (_e1250 * _e1265);
                                                    let _e1273 = (_e1256 * _e1250);
                                                    let _e1274 = (_e1259 * _e1247);
                                                    let _e1279 = (((_e1269 >= _e1270) && (_e1271 >= _e1272)) && (_e1273 >= _e1274));
                                                    if (_e1279 || (((_e1269 <= _e1270) && (_e1271 <= _e1272)) && (_e1273 <= _e1274))) {
                                                        let _e1286 = select(-1f, 1f, _e1279);
                                                        let _e1288 = ((_e1269 - _e1270) * _e1286);
                                                        let _e1290 = select(0f, _e1288, (_e1288 > 0f));
                                                        let _e1292 = ((_e1271 - _e1272) * _e1286);
                                                        let _e1294 = select(0f, _e1292, (_e1292 > 0f));
                                                        let _e1296 = ((_e1273 - _e1274) * _e1286);
                                                        let _e1298 = select(0f, _e1296, (_e1296 > 0f));
                                                        let _e1300 = ((_e1290 + _e1294) + _e1298);
                                                        if (_e1300 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1930_ = type_22();
                                                            phi_1931_ = true;
                                                        } else {
                                                            let _e1303 = select(_e1227[1][0], _e1227[0][0], (_e1227[0][0] < _e1227[1][0]));
                                                            let _e1307 = select(_e1227[1][0], _e1227[0][0], (_e1227[0][0] > _e1227[1][0]));
                                                            let _e1311 = select(_e1227[1][1], _e1227[0][1], (_e1227[0][1] < _e1227[1][1]));
                                                            let _e1315 = select(_e1227[1][1], _e1227[0][1], (_e1227[0][1] > _e1227[1][1]));
                                                            let _e1319 = select(_e1227[1][2], _e1227[0][2], (_e1227[0][2] < _e1227[1][2]));
                                                            let _e1323 = select(_e1227[1][2], _e1227[0][2], (_e1227[0][2] > _e1227[1][2]));
                                                            let _e1328 = ((select(_e1227[2][0], _e1303, (_e1303 < _e1227[2][0])) - _e331) * _e336);
                                                            let _e1329 = ((select(_e1227[2][0], _e1307, (_e1307 > _e1227[2][0])) - _e332) * _e336);
                                                            let _e1332 = ((select(_e1227[2][1], _e1311, (_e1311 < _e1227[2][1])) - _e367) * _e372);
                                                            let _e1333 = ((select(_e1227[2][1], _e1315, (_e1315 > _e1227[2][1])) - _e368) * _e372);
                                                            let _e1336 = ((select(_e1227[2][2], _e1319, (_e1319 < _e1227[2][2])) - _e403) * _e408);
                                                            let _e1337 = ((select(_e1227[2][2], _e1323, (_e1323 > _e1227[2][2])) - _e404) * _e408);
                                                            let _e1339 = select(_e1337, _e1336, (_e1336 < _e1337));
                                                            let _e1341 = select(_e1337, _e1336, (_e1336 > _e1337));
                                                            let _e1343 = select(_e1329, _e1328, (_e1328 < _e1329));
                                                            let _e1345 = select(_e1333, _e1332, (_e1332 < _e1333));
                                                            let _e1347 = select(_e1345, _e1343, (_e1343 > _e1345));
                                                            let _e1349 = select(_e1339, _e1347, (_e1347 > _e1339));
                                                            let _e1351 = select(_e1329, _e1328, (_e1328 > _e1329));
                                                            let _e1353 = select(_e1333, _e1332, (_e1332 > _e1333));
                                                            let _e1355 = select(_e1353, _e1351, (_e1351 < _e1353));
                                                            let _e1357 = select(_e1341, _e1355, (_e1355 < _e1341));
                                                            let _e1358 = -(_e1339);
                                                            let _e1364 = select(_e454, _e1349, (_e1349 > _e454));
                                                            if (_e1364 > (_e1357 + (select(_e1358, _e1341, (_e1341 > _e1358)) * 0.0000019073523f))) {
                                                                phi_1925_ = type_22();
                                                                phi_1926_ = true;
                                                            } else {
                                                                let _e1366 = (_e1364 > _e1021.member.member_1);
                                                                if _e1366 {
                                                                    phi_1924_ = type_22();
                                                                } else {
                                                                    let _e1370 = (_e1227[1][0] - _e1227[0][0]);
                                                                    let _e1371 = (_e1227[1][1] - _e1227[0][1]);
                                                                    let _e1372 = (_e1227[1][2] - _e1227[0][2]);
                                                                    let _e1373 = vec3<f32>(_e1370, _e1371, _e1372);
                                                                    let _e1374 = (_e1227[2][0] - _e1227[1][0]);
                                                                    let _e1375 = (_e1227[2][1] - _e1227[1][1]);
                                                                    let _e1376 = (_e1227[2][2] - _e1227[1][2]);
                                                                    let _e1377 = vec3<f32>(_e1374, _e1375, _e1376);
                                                                    let _e1378 = (_e1227[0][0] - _e1227[2][0]);
                                                                    let _e1379 = (_e1227[0][1] - _e1227[2][1]);
                                                                    let _e1380 = (_e1227[0][2] - _e1227[2][2]);
                                                                    let _e1381 = vec3<f32>(_e1378, _e1379, _e1380);
                                                                    let _e1384 = bitcast<f32>((bitcast<u32>(_e1370) & 2147483647u));
                                                                    let _e1387 = bitcast<f32>((bitcast<u32>(_e1371) & 2147483647u));
                                                                    let _e1389 = select(_e1387, _e1384, (_e1384 > _e1387));
                                                                    let _e1392 = bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u));
                                                                    let _e1394 = select(_e1392, _e1389, (_e1389 > _e1392));
                                                                    let _e1397 = bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u));
                                                                    let _e1400 = bitcast<f32>((bitcast<u32>(_e1375) & 2147483647u));
                                                                    let _e1402 = select(_e1400, _e1397, (_e1397 > _e1400));
                                                                    let _e1405 = bitcast<f32>((bitcast<u32>(_e1376) & 2147483647u));
                                                                    let _e1407 = select(_e1405, _e1402, (_e1402 > _e1405));
                                                                    let _e1410 = bitcast<f32>((bitcast<u32>(_e1378) & 2147483647u));
                                                                    let _e1413 = bitcast<f32>((bitcast<u32>(_e1379) & 2147483647u));
                                                                    let _e1415 = select(_e1413, _e1410, (_e1410 > _e1413));
                                                                    let _e1418 = bitcast<f32>((bitcast<u32>(_e1380) & 2147483647u));
                                                                    let _e1420 = select(_e1418, _e1415, (_e1415 > _e1418));
                                                                    let _e1422 = select(_e1407, _e1394, (_e1394 > _e1407));
                                                                    let _e1424 = select(_e1420, _e1422, (_e1422 > _e1420));
                                                                    if (_e1394 == _e1424) {
                                                                        phi_1835_ = _e1377;
                                                                        phi_1836_ = _e1381;
                                                                    } else {
                                                                        let _e1427 = vec3((_e1407 == _e1424));
                                                                        phi_1835_ = select(_e1373, _e1381, _e1427);
                                                                        phi_1836_ = select(_e1377, _e1373, _e1427);
                                                                    }
                                                                    let _e1431 = phi_1835_;
                                                                    let _e1433 = phi_1836_;
                                                                    let _e1440 = ((_e1431.y * _e1433.z) - (_e1433.y * _e1431.z));
                                                                    let _e1445 = ((_e1431.z * _e1433.x) - (_e1433.z * _e1431.x));
                                                                    let _e1448 = ((_e1431.x * _e1433.y) - (_e1433.x * _e1431.y));
                                                                    if (_e1290 >= _e1294) {
                                                                        phi_1867_ = select(true, false, (_e1290 >= _e1298));
                                                                    } else {
                                                                        phi_1867_ = true;
                                                                    }
                                                                    let _e1453 = phi_1867_;
                                                                    if _e1453 {
                                                                        phi_1876_ = select(vec3<f32>(_e1227[2][0], _e1227[2][1], _e1227[2][2]), vec3<f32>(_e1227[1][0], _e1227[1][1], _e1227[1][2]), vec3((_e1294 >= _e1298)));
                                                                    } else {
                                                                        phi_1876_ = vec3<f32>(_e1227[0][0], _e1227[0][1], _e1227[0][2]);
                                                                    }
                                                                    let _e1458 = phi_1876_;
                                                                    let _e1475 = ((((_e1440 * (_e1458.x - _e308)) + (_e1445 * (_e1458.y - _e345))) + (_e1448 * (_e1458.z - _e381))) / (((_e1440 * _e333) + (_e1445 * _e369)) + (_e1448 * _e405)));
                                                                    let _e1477 = select(_e1357, _e1475, (_e1475 < _e1357));
                                                                    let _e1479 = select(_e1349, _e1477, (_e1477 > _e1349));
                                                                    if (_e1479 >= _e454) {
                                                                        let _e1481 = (_e1479 <= _e1021.member.member_1);
                                                                        if _e1481 {
                                                                            let _e1482 = (1f / _e1300);
                                                                            phi_1916_ = type_22(_e1479, (_e1294 * _e1482), (_e1298 * _e1482), _e1087);
                                                                        } else {
                                                                            phi_1916_ = type_22();
                                                                        }
                                                                        let _e1487 = phi_1916_;
                                                                        phi_1918_ = _e1487;
                                                                        phi_1919_ = select(true, false, _e1481);
                                                                    } else {
                                                                        phi_1918_ = type_22();
                                                                        phi_1919_ = true;
                                                                    }
                                                                    let _e1490 = phi_1918_;
                                                                    let _e1492 = phi_1919_;
                                                                    if _e1492 {
                                                                        phi_1923_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1923_ = _e1490;
                                                                    }
                                                                    let _e1494 = phi_1923_;
                                                                    phi_1924_ = _e1494;
                                                                }
                                                                let _e1496 = phi_1924_;
                                                                phi_1925_ = _e1496;
                                                                phi_1926_ = _e1366;
                                                            }
                                                            let _e1498 = phi_1925_;
                                                            let _e1500 = phi_1926_;
                                                            phi_1930_ = _e1498;
                                                            phi_1931_ = _e1500;
                                                        }
                                                        let _e1502 = phi_1930_;
                                                        let _e1504 = phi_1931_;
                                                        phi_1935_ = _e1502;
                                                        phi_1936_ = _e1504;
                                                    } else {
                                                        phi_1935_ = type_22();
                                                        phi_1936_ = true;
                                                    }
                                                    let _e1506 = phi_1935_;
                                                    let _e1508 = phi_1936_;
                                                    if _e1508 {
                                                        phi_1940_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1940_ = _e1506;
                                                    }
                                                    let _e1510 = phi_1940_;
                                                    if (_e1510.member_3 != 4294967295u) {
                                                        if (_e1087 != _e460) {
                                                            if (_e1510.member < _e1021.member.member.member) {
                                                                phi_1966_ = true;
                                                            } else {
                                                                if (_e1510.member == _e1021.member.member.member) {
                                                                    phi_1965_ = (_e1510.member_3 < _e1021.member.member.member_3);
                                                                } else {
                                                                    phi_1965_ = false;
                                                                }
                                                                let _e1525 = phi_1965_;
                                                                phi_1966_ = _e1525;
                                                            }
                                                            let _e1527 = phi_1966_;
                                                            if _e1527 {
                                                                phi_1973_ = type_42(type_39(_e1510, _e1510.member), _e1048.member_1, _e1048.member_2);
                                                            } else {
                                                                phi_1973_ = _e1048;
                                                            }
                                                            let _e1534 = phi_1973_;
                                                            phi_1974_ = _e1534;
                                                        } else {
                                                            phi_1974_ = _e1048;
                                                        }
                                                        let _e1536 = phi_1974_;
                                                        phi_1975_ = _e1536;
                                                    } else {
                                                        phi_1975_ = _e1048;
                                                    }
                                                    let _e1538 = phi_1975_;
                                                    phi_3680_ = _e1226;
                                                    phi_1006_ = _e1538;
                                                } else {
                                                    phi_3680_ = _e1019;
                                                    phi_1006_ = type_42();
                                                }
                                                let _e1540 = phi_3680_;
                                                let _e1542 = phi_1006_;
                                                continue;
                                                continuing {
                                                    phi_3621_ = _e1540;
                                                    phi_1005_ = _e1542;
                                                    phi_1008_ = _e1036;
                                                    phi_3679_ = _e1540;
                                                    break if !(_e1042);
                                                }
                                            }
                                            let _e1545 = phi_3679_;
                                            phi_3738_ = _e1545;
                                            if _e1545 {
                                                break;
                                            }
                                            phi_3742_ = _e1545;
                                            let _e1787 = local_15;
                                            phi_3218_ = _e1787;
                                            phi_3219_ = _e543;
                                            phi_3220_ = false;
                                            phi_3221_ = _e547;
                                        } else {
                                            if (_e543.member_1 >= _e95) {
                                                phi_2774_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e543.member_1 < _e95) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e566 = ((1u + _e276) % 4u);
                                                if (_e566 < 4u) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e571 = global_3.member[_e543.member_1][_e566];
                                                let _e573 = (_e571 >> bitcast<u32>(11u));
                                                let _e575 = ((1u + _e275) % 4u);
                                                if (_e575 < 4u) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e580 = global_3.member[_e543.member_1][_e575];
                                                let _e582 = (_e580 >> bitcast<u32>(11u));
                                                let _e584 = ((1u + _e277) % 4u);
                                                if (_e584 < 4u) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e589 = global_3.member[_e543.member_1][_e584];
                                                let _e591 = (_e589 >> bitcast<u32>(11u));
                                                let _e614 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.x - _e543.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e615 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.y - _e543.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e616 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.z - _e543.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e618 = select(_e150, _e614, (_e614 > _e150));
                                                let _e620 = select(_e150, _e615, (_e615 > _e150));
                                                let _e622 = select(_e150, _e616, (_e616 > _e150));
                                                let _e647 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e618));
                                                let _e652 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e655 = bitcast<f32>((_e647 & bitcast<u32>(_e652)));
                                                let _e656 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e620));
                                                let _e661 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e664 = bitcast<f32>((_e656 & bitcast<u32>(_e661)));
                                                let _e665 = bitcast<u32>((f32(bitcast<i32>((_e589 & 1023u))) * _e622));
                                                let _e670 = (bitcast<i32>((_e589 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e673 = bitcast<f32>((_e665 & bitcast<u32>(_e670)));
                                                let _e677 = bitcast<f32>((_e647 & bitcast<u32>(~(_e652))));
                                                let _e681 = bitcast<f32>((_e656 & bitcast<u32>(~(_e661))));
                                                let _e685 = bitcast<f32>((_e665 & bitcast<u32>(~(_e670))));
                                                let _e686 = bitcast<u32>((f32(bitcast<i32>((_e573 & 1023u))) * _e618));
                                                let _e691 = (bitcast<i32>((_e573 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e694 = bitcast<f32>((_e686 & bitcast<u32>(_e691)));
                                                let _e695 = bitcast<u32>((f32(bitcast<i32>((_e582 & 1023u))) * _e620));
                                                let _e700 = (bitcast<i32>((_e582 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e703 = bitcast<f32>((_e695 & bitcast<u32>(_e700)));
                                                let _e704 = bitcast<u32>((f32(bitcast<i32>((_e591 & 1023u))) * _e622));
                                                let _e709 = (bitcast<i32>((_e591 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e712 = bitcast<f32>((_e704 & bitcast<u32>(_e709)));
                                                let _e716 = bitcast<f32>((_e686 & bitcast<u32>(~(_e691))));
                                                let _e720 = bitcast<f32>((_e695 & bitcast<u32>(~(_e700))));
                                                let _e724 = bitcast<f32>((_e704 & bitcast<u32>(~(_e709))));
                                                let _e725 = (_e543.member.member.x + _e655);
                                                let _e726 = (_e543.member.member.y + _e664);
                                                let _e727 = (_e543.member.member.z + _e673);
                                                let _e730 = (_e543.member.member_1.x - _e694);
                                                let _e731 = (_e543.member.member_1.y - _e703);
                                                let _e732 = (_e543.member.member_1.z - _e712);
                                                let _e751 = (_e730 - _e725);
                                                let _e752 = (_e731 - _e726);
                                                let _e753 = (_e732 - _e727);
                                                let _e755 = select(_e752, _e751, (_e751 > _e752));
                                                let _e757 = select(_e753, _e755, (_e755 > _e753));
                                                if (_e757 < (1024f * _e150)) {
                                                    phi_2475_ = 0u;
                                                } else {
                                                    phi_2475_ = select(2u, 1u, (_e757 < (2097152f * _e150)));
                                                }
                                                let _e764 = phi_2475_;
                                                switch bitcast<i32>(_e764) {
                                                    case 0: {
                                                        phi_2481_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2481_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2481_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2481_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e767 = phi_2481_;
                                                let _e773 = global_3.member[_e543.member_1][0u];
                                                let _e777 = global_3.member[_e543.member_1][1u];
                                                let _e781 = global_3.member[_e543.member_1][2u];
                                                let _e785 = global_3.member[_e543.member_1][3u];
                                                let _e797 = (((_e777 >> bitcast<u32>(22i)) | ((_e781 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e785 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e798 = (_e773 & 268435455u);
                                                let _e799 = (_e797 & 268435455u);
                                                let _e802 = ((_e773 >> bitcast<u32>(28u)) & 7u);
                                                let _e810 = ((_e773 >> bitcast<u32>(31i)) | (((_e797 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e811 = (_e802 != 0u);
                                                if (_e802 == 0u) {
                                                    phi_2736_ = _e798;
                                                } else {
                                                    if (_e802 == 7u) {
                                                        phi_2735_ = 2147483648u;
                                                    } else {
                                                        phi_2735_ = ((2147483648u | (_e802 << bitcast<u32>(28u))) | (_e799 & 268435455u));
                                                    }
                                                    let _e820 = phi_2735_;
                                                    phi_2736_ = _e820;
                                                }
                                                let _e822 = phi_2736_;
                                                if _e811 {
                                                    let _e823 = (_e802 != 7u);
                                                    if _e823 {
                                                        phi_2746_ = (_e799 + (_e802 * ((3u * _e767) + 1u)));
                                                    } else {
                                                        phi_2746_ = u32();
                                                    }
                                                    let _e827 = phi_2746_;
                                                    phi_2748_ = _e827;
                                                    phi_2749_ = select(true, false, _e823);
                                                } else {
                                                    phi_2748_ = u32();
                                                    phi_2749_ = true;
                                                }
                                                let _e830 = phi_2748_;
                                                let _e832 = phi_2749_;
                                                if (_e810 == 0u) {
                                                    phi_2770_ = (_e798 + select(0u, 1u, !(_e811)));
                                                } else {
                                                    if (_e810 == 7u) {
                                                        phi_2769_ = 2147483648u;
                                                    } else {
                                                        phi_2769_ = ((2147483648u | (_e810 << bitcast<u32>(28u))) | (select(_e830, _e799, _e832) & 268435455u));
                                                    }
                                                    let _e845 = phi_2769_;
                                                    phi_2770_ = _e845;
                                                }
                                                let _e847 = phi_2770_;
                                                phi_2774_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e725, (_e543.member.member.x + _e677), _e730, (_e543.member.member_1.x - _e716)), vec4<f32>(_e726, (_e543.member.member.y + _e681), _e731, (_e543.member.member_1.y - _e720)), vec4<f32>(_e727, (_e543.member.member.z + _e685), _e732, (_e543.member.member_1.z - _e724))), type_53(type_34((_e543.member.member + vec4<f32>(_e655, _e664, _e673, 0f)), (_e543.member.member_1 - vec4<f32>(_e694, _e703, _e712, 0f))), _e822), type_53(type_34((_e543.member.member + vec4<f32>(_e677, _e681, _e685, 0f)), (_e543.member.member_1 - vec4<f32>(_e716, _e720, _e724, 0f))), _e847));
                                            }
                                            let _e852 = phi_2774_;
                                            let _e865 = ((_e852.member[0].x - _e331) * _e336);
                                            let _e866 = ((_e852.member[0].y - _e331) * _e336);
                                            let _e867 = ((_e852.member[0].z - _e332) * _e336);
                                            let _e868 = ((_e852.member[0].w - _e332) * _e336);
                                            let _e878 = ((_e852.member[1].x - _e367) * _e372);
                                            let _e879 = ((_e852.member[1].y - _e367) * _e372);
                                            let _e880 = ((_e852.member[1].z - _e368) * _e372);
                                            let _e881 = ((_e852.member[1].w - _e368) * _e372);
                                            let _e891 = ((_e852.member[2].x - _e403) * _e408);
                                            let _e892 = ((_e852.member[2].y - _e403) * _e408);
                                            let _e893 = ((_e852.member[2].z - _e404) * _e408);
                                            let _e894 = ((_e852.member[2].w - _e404) * _e408);
                                            let _e896 = select(_e893, _e891, (_e891 < _e893));
                                            let _e898 = select(_e894, _e892, (_e892 < _e894));
                                            let _e900 = select(_e893, _e891, (_e891 > _e893));
                                            let _e902 = select(_e894, _e892, (_e892 > _e894));
                                            let _e904 = select(_e867, _e865, (_e865 < _e867));
                                            let _e906 = select(_e868, _e866, (_e866 < _e868));
                                            let _e908 = select(_e880, _e878, (_e878 < _e880));
                                            let _e910 = select(_e881, _e879, (_e879 < _e881));
                                            let _e912 = select(_e908, _e904, (_e904 > _e908));
                                            let _e914 = select(_e910, _e906, (_e906 > _e910));
                                            let _e916 = select(_e896, _e912, (_e912 > _e896));
                                            let _e918 = select(_e898, _e914, (_e914 > _e898));
                                            let _e920 = select(_e867, _e865, (_e865 > _e867));
                                            let _e922 = select(_e868, _e866, (_e866 > _e868));
                                            let _e924 = select(_e880, _e878, (_e878 > _e880));
                                            let _e926 = select(_e881, _e879, (_e879 > _e881));
                                            let _e928 = select(_e924, _e920, (_e920 < _e924));
                                            let _e930 = select(_e926, _e922, (_e922 < _e926));
                                            let _e935 = -(_e896);
                                            let _e936 = -(_e898);
                                            let _e943 = (select(_e900, _e928, (_e928 < _e900)) + (select(_e935, _e900, (_e900 > _e935)) * 0.0000019073523f));
                                            let _e944 = (select(_e902, _e930, (_e930 < _e902)) + (select(_e936, _e902, (_e902 > _e936)) * 0.0000019073523f));
                                            let _e946 = select(_e454, _e916, (_e916 > _e454));
                                            let _e948 = select(_e454, _e918, (_e918 > _e454));
                                            let _e953 = (_e946 <= select(_e503.member.member_1, _e943, (_e943 < _e503.member.member_1)));
                                            let _e954 = (_e948 <= select(_e503.member.member_1, _e944, (_e944 < _e503.member.member_1)));
                                            let _e955 = (_e946 <= _e948);
                                            if _e953 {
                                                if _e954 {
                                                    if _e955 {
                                                        phi_3118_ = _e852.member_2;
                                                    } else {
                                                        phi_3118_ = _e852.member_1;
                                                    }
                                                    let _e959 = phi_3118_;
                                                    let _e981 = (_e547 % 128u);
                                                    let _e982 = (_e981 < 128u);
                                                    if _e982 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_8[_e981] = _e959.member_1;
                                                    if _e982 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_7[_e981] = _e959.member.member.x;
                                                    if _e982 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_6[_e981] = _e959.member.member.y;
                                                    if _e982 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_5[_e981] = _e959.member.member.z;
                                                    if _e982 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_4[_e981] = _e959.member.member_1.x;
                                                    if _e982 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_3[_e981] = _e959.member.member_1.y;
                                                    if _e982 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_2[_e981] = _e959.member.member_1.z;
                                                    if _e982 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_9[_e981] = select(_e948, _e946, (_e946 > _e948));
                                                    if _e955 {
                                                        phi_3195_ = _e852.member_1;
                                                    } else {
                                                        phi_3195_ = _e852.member_2;
                                                    }
                                                    let _e995 = phi_3195_;
                                                    phi_3196_ = _e995;
                                                    phi_3197_ = (_e547 + 1u);
                                                } else {
                                                    phi_3196_ = type_53();
                                                    phi_3197_ = u32();
                                                }
                                                let _e997 = phi_3196_;
                                                let _e999 = phi_3197_;
                                                phi_3199_ = _e997;
                                                phi_3200_ = _e999;
                                                phi_3201_ = select(true, false, _e954);
                                            } else {
                                                phi_3199_ = type_53();
                                                phi_3200_ = u32();
                                                phi_3201_ = true;
                                            }
                                            let _e1002 = phi_3199_;
                                            let _e1004 = phi_3200_;
                                            let _e1006 = phi_3201_;
                                            if _e1006 {
                                                if _e953 {
                                                    phi_3210_ = _e852.member_1;
                                                } else {
                                                    phi_3210_ = _e852.member_2;
                                                }
                                                let _e1010 = phi_3210_;
                                                phi_3215_ = _e1010;
                                                phi_3216_ = select(_e954, true, _e953);
                                            } else {
                                                phi_3215_ = _e1002;
                                                phi_3216_ = _e545;
                                            }
                                            let _e1013 = phi_3215_;
                                            let _e1015 = phi_3216_;
                                            phi_3742_ = _e501;
                                            phi_3218_ = type_42(_e503.member, (_e503.member_1 + 1u), _e503.member_2);
                                            phi_3219_ = _e1013;
                                            phi_3220_ = _e1015;
                                            phi_3221_ = select(_e1004, _e547, _e1006);
                                        }
                                        let _e1547 = phi_3742_;
                                        let _e1549 = phi_3218_;
                                        let _e1551 = phi_3219_;
                                        let _e1553 = phi_3220_;
                                        let _e1555 = phi_3221_;
                                        phi_3741_ = _e1547;
                                        phi_3222_ = _e1549;
                                        phi_3223_ = _e1551;
                                        phi_3224_ = (_e507 - 1u);
                                        phi_3225_ = _e1553;
                                        phi_3226_ = _e1555;
                                    } else {
                                        phi_3741_ = _e501;
                                        phi_3222_ = _e503;
                                        phi_3223_ = _e543;
                                        phi_3224_ = _e507;
                                        phi_3225_ = _e545;
                                        phi_3226_ = _e547;
                                    }
                                    let _e1557 = phi_3741_;
                                    let _e1559 = phi_3222_;
                                    let _e1561 = phi_3223_;
                                    let _e1563 = phi_3224_;
                                    let _e1565 = phi_3225_;
                                    let _e1567 = phi_3226_;
                                    phi_3740_ = _e1557;
                                    phi_3227_ = _e1559;
                                    phi_3228_ = _e1561;
                                    phi_3229_ = _e1563;
                                    phi_3230_ = _e1565;
                                    phi_3231_ = _e1567;
                                } else {
                                    phi_3740_ = _e501;
                                    phi_3227_ = type_42();
                                    phi_3228_ = type_53();
                                    phi_3229_ = u32();
                                    phi_3230_ = bool();
                                    phi_3231_ = u32();
                                }
                                let _e1569 = phi_3740_;
                                let _e1571 = phi_3227_;
                                let _e1573 = phi_3228_;
                                let _e1575 = phi_3229_;
                                let _e1577 = phi_3230_;
                                let _e1579 = phi_3231_;
                                phi_3739_ = _e1569;
                                phi_879_ = _e1571;
                                phi_882_ = _e1573;
                                phi_884_ = _e1575;
                                phi_886_ = _e1577;
                                phi_888_ = _e1579;
                                phi_3232_ = _e515;
                            } else {
                                phi_3739_ = _e501;
                                phi_879_ = type_42();
                                phi_882_ = type_53();
                                phi_884_ = u32();
                                phi_886_ = bool();
                                phi_888_ = u32();
                                phi_3232_ = false;
                            }
                            let _e1581 = phi_3739_;
                            let _e1583 = phi_879_;
                            let _e1585 = phi_882_;
                            let _e1587 = phi_884_;
                            let _e1589 = phi_886_;
                            let _e1591 = phi_888_;
                            let _e1593 = phi_3232_;
                            continue;
                            continuing {
                                phi_3624_ = _e1581;
                                phi_878_ = _e1583;
                                phi_881_ = _e1585;
                                phi_883_ = _e1587;
                                phi_885_ = _e1589;
                                phi_887_ = _e1591;
                                phi_3738_ = _e1581;
                                break if !(_e1593);
                            }
                        }
                        let _e1596 = phi_3738_;
                        if _e1596 {
                            break;
                        }
                        let _e1598 = local_13;
                        if (_e1598.member.member.member_3 != 4294967295u) {
                            let _e1604 = (_e278 / 3i);
                            let _e1611 = bitcast<f32>((bitcast<u32>((_e1604 + 127i)) << bitcast<u32>(23i)));
                            let _e1619 = (((_e1598.member.member.member * _e1611) * _e1611) * bitcast<f32>((bitcast<u32>(((_e278 - (2i * _e1604)) + 127i)) << bitcast<u32>(23i))));
                            let _e1621 = select(340282350000000000000000000000000000000f, _e1619, (_e1619 < 340282350000000000000000000000000000000f));
                            phi_3284_ = type_22(select(-340282350000000000000000000000000000000f, _e1621, (_e1621 > -340282350000000000000000000000000000000f)), _e1598.member.member.member_1, _e1598.member.member.member_2, _e1598.member.member.member_3);
                        } else {
                            phi_3284_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1628 = phi_3284_;
                        if _e154 {
                        } else {
                            break;
                        }
                        global_1.member[_e138] = _e1628;
                        let _e1632 = local_14;
                        if _e155 {
                        } else {
                            break;
                        }
                        global_5.member[_e138] = _e1632.member_1;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e1637 = select(0u, 1u, (_e222 <= _e232));
                        if (_e1637 > 0u) {
                            let _e1639 = (1u < _e106);
                            if _e1639 {
                                if (0u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1643 = atomicAdd((&global_6.member[0u]), _e1637);
                                if ((_e1643 + _e1637) < _e1643) {
                                    if _e1639 {
                                    } else {
                                        break;
                                    }
                                    let _e1648 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1651 = select(0u, 1u, (_e1628.member_3 != 4294967295u));
                        if (_e1651 > 0u) {
                            let _e1653 = (3u < _e106);
                            if _e1653 {
                                if (2u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1657 = atomicAdd((&global_6.member[2u]), _e1651);
                                if ((_e1657 + _e1651) < _e1657) {
                                    if _e1653 {
                                    } else {
                                        break;
                                    }
                                    let _e1662 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1632.member_1 > 0u) {
                            let _e1664 = (5u < _e106);
                            if _e1664 {
                                if (4u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1668 = atomicAdd((&global_6.member[4u]), _e1632.member_1);
                                if ((_e1668 + _e1632.member_1) < _e1668) {
                                    if _e1664 {
                                    } else {
                                        break;
                                    }
                                    let _e1673 = atomicAdd((&global_6.member[5u]), 1u);
                                }
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
fn trace_paths_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
