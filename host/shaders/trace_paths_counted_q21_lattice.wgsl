struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_23 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: type_18,
    member_1: f32,
}

struct type_38 {
    member: type_35,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<array<u32, 7>>,
}

struct type_53 {
    member: type_30,
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
var<storage, read_write> global_1: type_20;
@group(0) @binding(0) 
var<uniform> global_2: type_40;
@group(0) @binding(3) 
var<storage> global_3: type_25;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_61;
@group(0) @binding(1) 
var<storage> global_6: type_44;
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
    var phi_878_: type_38;
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
    var phi_1005_: type_38;
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
    var phi_1916_: type_18;
    var phi_1918_: type_18;
    var phi_1919_: bool;
    var phi_1923_: type_18;
    var phi_1924_: type_18;
    var phi_1925_: type_18;
    var phi_1926_: bool;
    var phi_1930_: type_18;
    var phi_1931_: bool;
    var phi_1935_: type_18;
    var phi_1936_: bool;
    var phi_1940_: type_18;
    var phi_1965_: bool;
    var phi_1966_: bool;
    var phi_1973_: type_38;
    var phi_1974_: type_38;
    var phi_1975_: type_38;
    var phi_3680_: bool;
    var phi_1006_: type_38;
    var phi_3679_: bool;
    var phi_3742_: bool;
    var phi_3218_: type_38;
    var phi_3219_: type_53;
    var phi_3220_: bool;
    var phi_3221_: u32;
    var phi_3741_: bool;
    var phi_3222_: type_38;
    var phi_3223_: type_53;
    var phi_3224_: u32;
    var phi_3225_: bool;
    var phi_3226_: u32;
    var phi_3740_: bool;
    var phi_3227_: type_38;
    var phi_3228_: type_53;
    var phi_3229_: u32;
    var phi_3230_: bool;
    var phi_3231_: u32;
    var phi_3739_: bool;
    var phi_879_: type_38;
    var phi_882_: type_53;
    var phi_884_: u32;
    var phi_886_: bool;
    var phi_888_: u32;
    var phi_3232_: bool;
    var phi_3738_: bool;
    var local_13: type_38;
    var phi_3284_: type_18;
    var local_14: type_38;
    var local_15: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_6.member));
            let _e97 = arrayLength((&global_7.member));
            let _e105 = arrayLength((&global_5.member));
            let _e109 = global_2.member[0u][0u];
            let _e113 = global_2.member[0u][1u];
            let _e117 = global_2.member[0u][2u];
            let _e121 = global_2.member[0u][3u];
            let _e125 = global_2.member[1u][0u];
            let _e129 = global_2.member[1u][1u];
            let _e133 = global_2.member[1u][2u];
            let _e137 = (_e92.x + (_e92.y * 2097152u));
            let _e149 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e121) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e109), bitcast<i32>(_e113), bitcast<i32>(_e117));
            local = array<i32, 3>(bitcast<i32>(_e125), bitcast<i32>(_e129), bitcast<i32>(_e133));
            let _e152 = (_e137 < arrayLength((&global_3.member)));
            if _e152 {
                let _e153 = (_e137 < arrayLength((&global_1.member)));
                if _e153 {
                    let _e154 = (_e137 < arrayLength((&global_4.member)));
                    if _e154 {
                        if _e152 {
                        } else {
                            break;
                        }
                        let _e164 = global_3.member[_e137].member.member_2[0u];
                        let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                        let _e172 = global_3.member[_e137].member.member_2[1u];
                        let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                        let _e180 = global_3.member[_e137].member.member_2[2u];
                        let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                        let _e188 = global_3.member[_e137].member.member[0u];
                        let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                        let _e196 = global_3.member[_e137].member.member[1u];
                        let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                        let _e204 = global_3.member[_e137].member.member[2u];
                        let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                        let _e208 = select(_e174, _e166, (_e174 < _e166));
                        let _e210 = select(_e182, _e208, (_e182 < _e208));
                        let _e212 = select(_e190, _e210, (_e190 < _e210));
                        let _e214 = select(_e198, _e212, (_e198 < _e212));
                        let _e216 = select(_e206, _e214, (_e206 < _e214));
                        let _e221 = global_3.member[_e137].member.member_1;
                        let _e223 = (bitcast<u32>(_e221) & 2147483647u);
                        let _e231 = global_3.member[_e137].member.member_3;
                        let _e237 = (((select(_e223, _e216, (_e223 < _e216)) < 2139095040u) && ((bitcast<u32>(_e231) & 2147483647u) <= 2139095040u)) && (_e210 > 0u));
                        if _e237 {
                            let _e240 = (bitcast<u32>(bitcast<f32>(_e210)) & 2147483647u);
                            if (_e240 >= 8388608u) {
                                phi_410_ = (bitcast<i32>((_e240 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e240)), 32u, (_e240 == 0u))));
                            }
                            let _e254 = phi_410_;
                            phi_411_ = _e254;
                        } else {
                            phi_411_ = 0i;
                        }
                        let _e256 = phi_411_;
                        let _e257 = (_e166 == _e210);
                        if _e257 {
                            phi_421_ = true;
                        } else {
                            phi_421_ = (_e174 == _e210);
                        }
                        let _e260 = phi_421_;
                        let _e261 = select(1u, 0u, _e257);
                        if _e260 {
                            let _e262 = (_e261 + 1u);
                            phi_431_ = _e262;
                            phi_432_ = _e262;
                            phi_434_ = select(true, false, (_e262 == 2u));
                        } else {
                            phi_431_ = u32();
                            phi_432_ = 0u;
                            phi_434_ = true;
                        }
                        let _e266 = phi_431_;
                        let _e268 = phi_432_;
                        let _e270 = phi_434_;
                        if _e270 {
                            phi_439_ = (_e268 + 1u);
                        } else {
                            phi_439_ = 0u;
                        }
                        let _e274 = phi_439_;
                        let _e275 = select(_e266, _e268, _e270);
                        let _e276 = select(_e261, select(2u, _e261, _e260), _e270);
                        let _e277 = -(_e256);
                        if (_e277 < -126i) {
                            phi_472_ = -126i;
                        } else {
                            phi_472_ = select(_e277, 127i, (_e277 > 127i));
                        }
                        let _e282 = phi_472_;
                        let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                        let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                        let _e298 = global_3.member[_e137].member.member;
                        let _e299 = (_e275 == 0u);
                        if _e299 {
                            phi_490_ = _e298[0];
                        } else {
                            phi_490_ = _e298[1];
                        }
                        let _e303 = phi_490_;
                        let _e304 = (_e275 == 2u);
                        if _e304 {
                            phi_496_ = _e298[2];
                        } else {
                            phi_496_ = _e303;
                        }
                        let _e307 = phi_496_;
                        let _e308 = global_3.member[_e137].member.member_2;
                        if _e299 {
                            phi_507_ = _e308[0];
                        } else {
                            phi_507_ = _e308[1];
                        }
                        let _e312 = phi_507_;
                        if _e304 {
                            phi_513_ = _e308[2];
                        } else {
                            phi_513_ = _e312;
                        }
                        let _e315 = phi_513_;
                        let _e317 = ((_e315 * _e287) * _e293);
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e321 {
                            let _e325 = (bitcast<f32>((bitcast<u32>(_e307) & 2147483647u)) * 0.00000011920929f);
                            phi_536_ = select(0.00000000000011368684f, _e325, (_e325 > 0.00000000000011368684f));
                        } else {
                            phi_536_ = 0f;
                        }
                        let _e329 = phi_536_;
                        let _e330 = (_e307 + _e329);
                        let _e331 = (_e307 - _e329);
                        let _e332 = select(_e317, 0f, _e321);
                        if _e321 {
                            phi_547_ = 38685626000000000000000000f;
                        } else {
                            phi_547_ = (1f / _e317);
                        }
                        let _e335 = phi_547_;
                        let _e336 = (_e274 == 0u);
                        if _e336 {
                            phi_556_ = _e298[0];
                        } else {
                            phi_556_ = _e298[1];
                        }
                        let _e340 = phi_556_;
                        let _e341 = (_e274 == 2u);
                        if _e341 {
                            phi_562_ = _e298[2];
                        } else {
                            phi_562_ = _e340;
                        }
                        let _e344 = phi_562_;
                        if _e336 {
                            phi_573_ = _e308[0];
                        } else {
                            phi_573_ = _e308[1];
                        }
                        let _e348 = phi_573_;
                        if _e341 {
                            phi_579_ = _e308[2];
                        } else {
                            phi_579_ = _e348;
                        }
                        let _e351 = phi_579_;
                        let _e353 = ((_e351 * _e287) * _e293);
                        let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e357 {
                            let _e361 = (bitcast<f32>((bitcast<u32>(_e344) & 2147483647u)) * 0.00000011920929f);
                            phi_602_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                        } else {
                            phi_602_ = 0f;
                        }
                        let _e365 = phi_602_;
                        let _e366 = (_e344 + _e365);
                        let _e367 = (_e344 - _e365);
                        let _e368 = select(_e353, 0f, _e357);
                        if _e357 {
                            phi_613_ = 38685626000000000000000000f;
                        } else {
                            phi_613_ = (1f / _e353);
                        }
                        let _e371 = phi_613_;
                        let _e372 = (_e276 == 0u);
                        if _e372 {
                            phi_622_ = _e298[0];
                        } else {
                            phi_622_ = _e298[1];
                        }
                        let _e376 = phi_622_;
                        let _e377 = (_e276 == 2u);
                        if _e377 {
                            phi_628_ = _e298[2];
                        } else {
                            phi_628_ = _e376;
                        }
                        let _e380 = phi_628_;
                        if _e372 {
                            phi_639_ = _e308[0];
                        } else {
                            phi_639_ = _e308[1];
                        }
                        let _e384 = phi_639_;
                        if _e377 {
                            phi_645_ = _e308[2];
                        } else {
                            phi_645_ = _e384;
                        }
                        let _e387 = phi_645_;
                        let _e389 = ((_e387 * _e287) * _e293);
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e393 {
                            let _e397 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) * 0.00000011920929f);
                            phi_668_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                        } else {
                            phi_668_ = 0f;
                        }
                        let _e401 = phi_668_;
                        let _e402 = (_e380 + _e401);
                        let _e403 = (_e380 - _e401);
                        let _e404 = select(_e389, 0f, _e393);
                        if _e393 {
                            phi_679_ = 38685626000000000000000000f;
                        } else {
                            phi_679_ = (1f / _e389);
                        }
                        let _e407 = phi_679_;
                        let _e410 = bitcast<f32>((bitcast<u32>(_e307) & 2147483647u));
                        let _e413 = bitcast<f32>((bitcast<u32>(_e344) & 2147483647u));
                        let _e415 = select(_e413, _e410, (_e410 > _e413));
                        let _e418 = bitcast<f32>((bitcast<u32>(_e380) & 2147483647u));
                        if (_e237 && (select(_e418, _e415, (_e415 > _e418)) <= 1099511600000f)) {
                            let _e423 = (_e256 / 3i);
                            let _e430 = bitcast<f32>((bitcast<u32>((_e423 + 127i)) << bitcast<u32>(23i)));
                            let _e437 = bitcast<f32>((bitcast<u32>(((_e256 - (2i * _e423)) + 127i)) << bitcast<u32>(23i)));
                            let _e438 = (((_e221 * _e430) * _e430) * _e437);
                            let _e440 = select(340282350000000000000000000000000000000f, _e438, (_e438 < 340282350000000000000000000000000000000f));
                            let _e445 = (((_e231 * _e430) * _e430) * _e437);
                            let _e447 = select(340282350000000000000000000000000000000f, _e445, (_e445 < 340282350000000000000000000000000000000f));
                            phi_779_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                            phi_780_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_779_ = 0f;
                            phi_780_ = 1f;
                        }
                        let _e451 = phi_779_;
                        let _e453 = phi_780_;
                        if _e152 {
                        } else {
                            break;
                        }
                        let _e459 = global_3.member[_e137].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e462 = (_e275 % 3u);
                        let _e463 = (_e462 < 3u);
                        if _e463 {
                        } else {
                            break;
                        }
                        let _e465 = local_1[_e462];
                        let _e468 = (_e274 % 3u);
                        let _e469 = (_e468 < 3u);
                        if _e469 {
                        } else {
                            break;
                        }
                        let _e471 = local_1[_e468];
                        let _e474 = (_e276 % 3u);
                        let _e475 = (_e474 < 3u);
                        if _e475 {
                        } else {
                            break;
                        }
                        let _e477 = local_1[_e474];
                        if _e463 {
                        } else {
                            break;
                        }
                        let _e482 = local[_e462];
                        if _e469 {
                        } else {
                            break;
                        }
                        let _e486 = local[_e468];
                        if _e475 {
                        } else {
                            break;
                        }
                        let _e490 = local[_e474];
                        phi_3624_ = false;
                        phi_878_ = type_38(type_35(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e451), 0u, 0u);
                        phi_881_ = type_53(type_30(vec4<f32>((f32(_e465) * _e149), (f32(_e471) * _e149), (f32(_e477) * _e149), 0f), vec4<f32>((f32(_e482) * _e149), (f32(_e486) * _e149), (f32(_e490) * _e149), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                        phi_883_ = ((3u * _e94) + 1u);
                        phi_885_ = (_e453 <= _e451);
                        phi_887_ = 0u;
                        loop {
                            let _e500 = phi_3624_;
                            let _e502 = phi_878_;
                            let _e504 = phi_881_;
                            let _e506 = phi_883_;
                            let _e508 = phi_885_;
                            let _e510 = phi_887_;
                            local_13 = _e502;
                            local_14 = _e502;
                            if _e508 {
                                phi_898_ = true;
                            } else {
                                phi_898_ = (_e510 > 0u);
                            }
                            let _e513 = phi_898_;
                            if _e513 {
                                let _e514 = (_e506 > 0u);
                                if _e514 {
                                    if _e508 {
                                        phi_984_ = _e504;
                                        phi_985_ = _e508;
                                        phi_986_ = _e510;
                                    } else {
                                        let _e515 = (_e510 - 1u);
                                        let _e516 = (_e515 % 128u);
                                        let _e517 = (_e516 < 128u);
                                        if _e517 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e519 = local_7[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e521 = local_6[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e523 = local_5[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e525 = local_4[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e527 = local_3[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e529 = local_2[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e534 = local_8[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3738_ = true;
                                            break;
                                        }
                                        let _e537 = local_9[_e516];
                                        phi_984_ = type_53(type_30(vec4<f32>(_e519, _e521, _e523, 0f), vec4<f32>(_e525, _e527, _e529, 0f)), _e534);
                                        phi_985_ = (_e537 <= _e502.member.member_1);
                                        phi_986_ = _e515;
                                    }
                                    let _e542 = phi_984_;
                                    let _e544 = phi_985_;
                                    let _e546 = phi_986_;
                                    if _e544 {
                                        let _e551 = (_e542.member_1 & 268435455u);
                                        if ((_e542.member_1 & 2147483648u) != 0u) {
                                            phi_3621_ = _e500;
                                            phi_1005_ = _e502;
                                            phi_1008_ = type_8(0u, ((_e542.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1036 = phi_3621_;
                                                let _e1038 = phi_1005_;
                                                let _e1040 = phi_1008_;
                                                local_15 = _e1038;
                                                if (_e1040.member < _e1040.member_1) {
                                                    phi_1009_ = type_8((_e1040.member + 1u), _e1040.member_1);
                                                    phi_1031_ = type_8(1u, _e1040.member);
                                                } else {
                                                    phi_1009_ = _e1040;
                                                    phi_1031_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1053 = phi_1009_;
                                                let _e1055 = phi_1031_;
                                                let _e1059 = (bitcast<i32>(_e1055.member) != 0i);
                                                if _e1059 {
                                                    let _e1065 = type_38(_e1038.member, _e1038.member_1, (_e1038.member_2 + 1u));
                                                    let _e1070 = (_e542.member.member_1.x - _e542.member.member.x);
                                                    let _e1073 = (_e542.member.member_1.y - _e542.member.member.y);
                                                    let _e1076 = (_e542.member.member_1.z - _e542.member.member.z);
                                                    let _e1078 = select(_e1073, _e1070, (_e1070 > _e1073));
                                                    let _e1080 = select(_e1076, _e1078, (_e1078 > _e1076));
                                                    let _e1082 = (_e1080 < (1024f * _e149));
                                                    if _e1082 {
                                                        phi_1075_ = 0u;
                                                    } else {
                                                        phi_1075_ = select(2u, 1u, (_e1080 < (2097152f * _e149)));
                                                    }
                                                    let _e1087 = phi_1075_;
                                                    switch bitcast<i32>(_e1087) {
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
                                                    let _e1090 = phi_1081_;
                                                    switch bitcast<i32>(_e1087) {
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
                                                    let _e1097 = phi_1091_;
                                                    let _e1099 = ((_e551 + (_e1055.member_1 * ((3u * _e1090) + 1u))) + (3u * _e1097));
                                                    let _e1100 = (_e1099 < _e97);
                                                    if _e1100 {
                                                        if _e1100 {
                                                        } else {
                                                            phi_3679_ = true;
                                                            break;
                                                        }
                                                        let _e1102 = global_7.member[_e1099];
                                                        phi_1107_ = _e1102;
                                                    } else {
                                                        phi_1107_ = 4294967295u;
                                                    }
                                                    let _e1104 = phi_1107_;
                                                    local_10 = array<u32, 3>(_e275, _e274, _e276);
                                                    if _e1082 {
                                                        phi_1144_ = 0u;
                                                    } else {
                                                        phi_1144_ = select(2u, 1u, (_e1080 < (2097152f * _e149)));
                                                    }
                                                    let _e1110 = phi_1144_;
                                                    switch bitcast<i32>(_e1110) {
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
                                                    let _e1113 = phi_1150_;
                                                    switch bitcast<i32>(_e1110) {
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
                                                    let _e1120 = phi_1160_;
                                                    local_12 = array<f32, 4>(_e542.member.member.x, _e542.member.member.y, _e542.member.member.z, _e542.member.member.w);
                                                    local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_3606_ = _e1036;
                                                    phi_1176_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1134 = phi_3606_;
                                                        let _e1136 = phi_1176_;
                                                        if (_e1136.member < _e1136.member_1) {
                                                            phi_1177_ = type_8((_e1136.member + 1u), _e1136.member_1);
                                                            phi_1200_ = type_8(1u, _e1136.member);
                                                        } else {
                                                            phi_1177_ = _e1136;
                                                            phi_1200_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1149 = phi_1177_;
                                                        let _e1151 = phi_1200_;
                                                        let _e1155 = (bitcast<i32>(_e1151.member) != 0i);
                                                        if _e1155 {
                                                            let _e1157 = ((_e551 + (_e1055.member_1 * ((3u * _e1113) + 1u))) + (_e1151.member_1 * _e1120));
                                                            let _e1158 = (_e1157 < _e97);
                                                            if _e1158 {
                                                                if _e1158 {
                                                                } else {
                                                                    phi_3677_ = true;
                                                                    break;
                                                                }
                                                                let _e1160 = global_7.member[_e1157];
                                                                phi_1223_ = _e1160;
                                                            } else {
                                                                phi_1223_ = 0u;
                                                            }
                                                            let _e1162 = phi_1223_;
                                                            let _e1163 = (_e1157 + 1u);
                                                            let _e1164 = (_e1163 < _e97);
                                                            if _e1164 {
                                                                if _e1164 {
                                                                } else {
                                                                    phi_3677_ = true;
                                                                    break;
                                                                }
                                                                let _e1166 = global_7.member[_e1163];
                                                                phi_1238_ = _e1166;
                                                            } else {
                                                                phi_1238_ = 0u;
                                                            }
                                                            let _e1168 = phi_1238_;
                                                            phi_1241_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1170 = phi_1241_;
                                                                if (_e1170.member < _e1170.member_1) {
                                                                    phi_1242_ = type_8((_e1170.member + 1u), _e1170.member_1);
                                                                    phi_1265_ = type_8(1u, _e1170.member);
                                                                } else {
                                                                    phi_1242_ = _e1170;
                                                                    phi_1265_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1183 = phi_1242_;
                                                                let _e1185 = phi_1265_;
                                                                let _e1189 = (bitcast<i32>(_e1185.member) != 0i);
                                                                if _e1189 {
                                                                    let _e1190 = (_e1185.member_1 < 3u);
                                                                    if _e1190 {
                                                                    } else {
                                                                        phi_3599_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1192 = local_10[_e1185.member_1];
                                                                    if (_e1185.member_1 < 4u) {
                                                                    } else {
                                                                        phi_3599_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1195 = local_12[_e1185.member_1];
                                                                    switch bitcast<i32>(_e1110) {
                                                                        case 0: {
                                                                            phi_1335_ = (_e1195 + (f32(((_e1162 >> bitcast<u32>(((10u * _e1192) & 31u))) & 1023u)) * _e149));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1192 == 0u) {
                                                                                phi_1312_ = _e1162;
                                                                            } else {
                                                                                if (_e1192 == 1u) {
                                                                                    phi_1311_ = ((_e1162 >> bitcast<u32>(21i)) | (_e1168 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_1311_ = (_e1168 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1216 = phi_1311_;
                                                                                phi_1312_ = _e1216;
                                                                            }
                                                                            let _e1218 = phi_1312_;
                                                                            phi_1335_ = (_e1195 + (f32((_e1218 & 2097151u)) * _e149));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1197 = (_e1157 + _e1192);
                                                                            let _e1198 = (_e1197 < _e97);
                                                                            if _e1198 {
                                                                                if _e1198 {
                                                                                } else {
                                                                                    phi_3599_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1200 = global_7.member[_e1197];
                                                                                phi_1331_ = _e1200;
                                                                            } else {
                                                                                phi_1331_ = 0u;
                                                                            }
                                                                            let _e1202 = phi_1331_;
                                                                            phi_1335_ = (f32(bitcast<i32>(_e1202)) * _e149);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_1335_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1232 = phi_1335_;
                                                                    if (_e1151.member_1 < 3u) {
                                                                    } else {
                                                                        phi_3599_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1190 {
                                                                    } else {
                                                                        phi_3599_ = true;
                                                                        break;
                                                                    }
                                                                    local_11[_e1151.member_1][_e1185.member_1] = _e1232;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_1241_ = _e1183;
                                                                    phi_3599_ = _e1134;
                                                                    break if !(_e1189);
                                                                }
                                                            }
                                                            let _e1238 = phi_3599_;
                                                            phi_3677_ = _e1238;
                                                            if _e1238 {
                                                                break;
                                                            }
                                                            phi_3678_ = _e1238;
                                                        } else {
                                                            phi_3678_ = _e1134;
                                                        }
                                                        let _e1240 = phi_3678_;
                                                        continue;
                                                        continuing {
                                                            phi_3606_ = _e1240;
                                                            phi_1176_ = _e1149;
                                                            phi_3677_ = _e1240;
                                                            break if !(_e1155);
                                                        }
                                                    }
                                                    let _e1243 = phi_3677_;
                                                    phi_3679_ = _e1243;
                                                    if _e1243 {
                                                        break;
                                                    }
                                                    let _e1244 = local_11;
                                                    let _e1261 = (_e1244[0][2] - _e380);
                                                    let _e1264 = (((_e1244[0][0] - _e307) * _e404) - (_e1261 * _e332));
                                                    let _e1267 = (((_e1244[0][1] - _e344) * _e404) - (_e1261 * _e368));
                                                    let _e1270 = (_e1244[1][2] - _e380);
                                                    let _e1273 = (((_e1244[1][0] - _e307) * _e404) - (_e1270 * _e332));
                                                    let _e1276 = (((_e1244[1][1] - _e344) * _e404) - (_e1270 * _e368));
                                                    let _e1279 = (_e1244[2][2] - _e380);
                                                    let _e1282 = (((_e1244[2][0] - _e307) * _e404) - (_e1279 * _e332));
                                                    let _e1285 = (((_e1244[2][1] - _e344) * _e404) - (_e1279 * _e368));
                                                    let _e1286 = (_e1282 * _e1276);
                                                    let _e1287 = (_e1285 * _e1273);
                                                    let _e1288 = (_e1264 * _e1285);
                                                    let _e1289 = (_e1267 * _e1282);
                                                    let _e1290 = (_e1273 * _e1267);
                                                    let _e1291 = (_e1276 * _e1264);
                                                    let _e1296 = (((_e1286 >= _e1287) && (_e1288 >= _e1289)) && (_e1290 >= _e1291));
                                                    if (_e1296 || (((_e1286 <= _e1287) && (_e1288 <= _e1289)) && (_e1290 <= _e1291))) {
                                                        let _e1303 = select(-1f, 1f, _e1296);
                                                        let _e1305 = ((_e1286 - _e1287) * _e1303);
                                                        let _e1307 = select(0f, _e1305, (_e1305 > 0f));
                                                        let _e1309 = ((_e1288 - _e1289) * _e1303);
                                                        let _e1311 = select(0f, _e1309, (_e1309 > 0f));
                                                        let _e1313 = ((_e1290 - _e1291) * _e1303);
                                                        let _e1315 = select(0f, _e1313, (_e1313 > 0f));
                                                        let _e1317 = ((_e1307 + _e1311) + _e1315);
                                                        if (_e1317 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1930_ = type_18();
                                                            phi_1931_ = true;
                                                        } else {
                                                            let _e1320 = select(_e1244[1][0], _e1244[0][0], (_e1244[0][0] < _e1244[1][0]));
                                                            let _e1324 = select(_e1244[1][0], _e1244[0][0], (_e1244[0][0] > _e1244[1][0]));
                                                            let _e1328 = select(_e1244[1][1], _e1244[0][1], (_e1244[0][1] < _e1244[1][1]));
                                                            let _e1332 = select(_e1244[1][1], _e1244[0][1], (_e1244[0][1] > _e1244[1][1]));
                                                            let _e1336 = select(_e1244[1][2], _e1244[0][2], (_e1244[0][2] < _e1244[1][2]));
                                                            let _e1340 = select(_e1244[1][2], _e1244[0][2], (_e1244[0][2] > _e1244[1][2]));
                                                            let _e1345 = ((select(_e1244[2][0], _e1320, (_e1320 < _e1244[2][0])) - _e330) * _e335);
                                                            let _e1346 = ((select(_e1244[2][0], _e1324, (_e1324 > _e1244[2][0])) - _e331) * _e335);
                                                            let _e1349 = ((select(_e1244[2][1], _e1328, (_e1328 < _e1244[2][1])) - _e366) * _e371);
                                                            let _e1350 = ((select(_e1244[2][1], _e1332, (_e1332 > _e1244[2][1])) - _e367) * _e371);
                                                            let _e1353 = ((select(_e1244[2][2], _e1336, (_e1336 < _e1244[2][2])) - _e402) * _e407);
                                                            let _e1354 = ((select(_e1244[2][2], _e1340, (_e1340 > _e1244[2][2])) - _e403) * _e407);
                                                            let _e1356 = select(_e1354, _e1353, (_e1353 < _e1354));
                                                            let _e1358 = select(_e1354, _e1353, (_e1353 > _e1354));
                                                            let _e1360 = select(_e1346, _e1345, (_e1345 < _e1346));
                                                            let _e1362 = select(_e1350, _e1349, (_e1349 < _e1350));
                                                            let _e1364 = select(_e1362, _e1360, (_e1360 > _e1362));
                                                            let _e1366 = select(_e1356, _e1364, (_e1364 > _e1356));
                                                            let _e1368 = select(_e1346, _e1345, (_e1345 > _e1346));
                                                            let _e1370 = select(_e1350, _e1349, (_e1349 > _e1350));
                                                            let _e1372 = select(_e1370, _e1368, (_e1368 < _e1370));
                                                            let _e1374 = select(_e1358, _e1372, (_e1372 < _e1358));
                                                            let _e1375 = -(_e1356);
                                                            let _e1381 = select(_e453, _e1366, (_e1366 > _e453));
                                                            if (_e1381 > (_e1374 + (select(_e1375, _e1358, (_e1358 > _e1375)) * 0.0000019073523f))) {
                                                                phi_1925_ = type_18();
                                                                phi_1926_ = true;
                                                            } else {
                                                                let _e1383 = (_e1381 > _e1038.member.member_1);
                                                                if _e1383 {
                                                                    phi_1924_ = type_18();
                                                                } else {
                                                                    let _e1387 = (_e1244[1][0] - _e1244[0][0]);
                                                                    let _e1388 = (_e1244[1][1] - _e1244[0][1]);
                                                                    let _e1389 = (_e1244[1][2] - _e1244[0][2]);
                                                                    let _e1390 = vec3<f32>(_e1387, _e1388, _e1389);
                                                                    let _e1391 = (_e1244[2][0] - _e1244[1][0]);
                                                                    let _e1392 = (_e1244[2][1] - _e1244[1][1]);
                                                                    let _e1393 = (_e1244[2][2] - _e1244[1][2]);
                                                                    let _e1394 = vec3<f32>(_e1391, _e1392, _e1393);
                                                                    let _e1395 = (_e1244[0][0] - _e1244[2][0]);
                                                                    let _e1396 = (_e1244[0][1] - _e1244[2][1]);
                                                                    let _e1397 = (_e1244[0][2] - _e1244[2][2]);
                                                                    let _e1398 = vec3<f32>(_e1395, _e1396, _e1397);
                                                                    let _e1401 = bitcast<f32>((bitcast<u32>(_e1387) & 2147483647u));
                                                                    let _e1404 = bitcast<f32>((bitcast<u32>(_e1388) & 2147483647u));
                                                                    let _e1406 = select(_e1404, _e1401, (_e1401 > _e1404));
                                                                    let _e1409 = bitcast<f32>((bitcast<u32>(_e1389) & 2147483647u));
                                                                    let _e1411 = select(_e1409, _e1406, (_e1406 > _e1409));
                                                                    let _e1414 = bitcast<f32>((bitcast<u32>(_e1391) & 2147483647u));
                                                                    let _e1417 = bitcast<f32>((bitcast<u32>(_e1392) & 2147483647u));
                                                                    let _e1419 = select(_e1417, _e1414, (_e1414 > _e1417));
                                                                    let _e1422 = bitcast<f32>((bitcast<u32>(_e1393) & 2147483647u));
                                                                    let _e1424 = select(_e1422, _e1419, (_e1419 > _e1422));
                                                                    let _e1427 = bitcast<f32>((bitcast<u32>(_e1395) & 2147483647u));
                                                                    let _e1430 = bitcast<f32>((bitcast<u32>(_e1396) & 2147483647u));
                                                                    let _e1432 = select(_e1430, _e1427, (_e1427 > _e1430));
                                                                    let _e1435 = bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u));
                                                                    let _e1437 = select(_e1435, _e1432, (_e1432 > _e1435));
                                                                    let _e1439 = select(_e1424, _e1411, (_e1411 > _e1424));
                                                                    let _e1441 = select(_e1437, _e1439, (_e1439 > _e1437));
                                                                    if (_e1411 == _e1441) {
                                                                        phi_1835_ = _e1394;
                                                                        phi_1836_ = _e1398;
                                                                    } else {
                                                                        let _e1444 = vec3((_e1424 == _e1441));
                                                                        phi_1835_ = select(_e1390, _e1398, _e1444);
                                                                        phi_1836_ = select(_e1394, _e1390, _e1444);
                                                                    }
                                                                    let _e1448 = phi_1835_;
                                                                    let _e1450 = phi_1836_;
                                                                    let _e1457 = ((_e1448.y * _e1450.z) - (_e1450.y * _e1448.z));
                                                                    let _e1462 = ((_e1448.z * _e1450.x) - (_e1450.z * _e1448.x));
                                                                    let _e1465 = ((_e1448.x * _e1450.y) - (_e1450.x * _e1448.y));
                                                                    if (_e1307 >= _e1311) {
                                                                        phi_1867_ = select(true, false, (_e1307 >= _e1315));
                                                                    } else {
                                                                        phi_1867_ = true;
                                                                    }
                                                                    let _e1470 = phi_1867_;
                                                                    if _e1470 {
                                                                        phi_1876_ = select(vec3<f32>(_e1244[2][0], _e1244[2][1], _e1244[2][2]), vec3<f32>(_e1244[1][0], _e1244[1][1], _e1244[1][2]), vec3((_e1311 >= _e1315)));
                                                                    } else {
                                                                        phi_1876_ = vec3<f32>(_e1244[0][0], _e1244[0][1], _e1244[0][2]);
                                                                    }
                                                                    let _e1475 = phi_1876_;
                                                                    let _e1492 = ((((_e1457 * (_e1475.x - _e307)) + (_e1462 * (_e1475.y - _e344))) + (_e1465 * (_e1475.z - _e380))) / (((_e1457 * _e332) + (_e1462 * _e368)) + (_e1465 * _e404)));
                                                                    let _e1494 = select(_e1374, _e1492, (_e1492 < _e1374));
                                                                    let _e1496 = select(_e1366, _e1494, (_e1494 > _e1366));
                                                                    if (_e1496 >= _e453) {
                                                                        let _e1498 = (_e1496 <= _e1038.member.member_1);
                                                                        if _e1498 {
                                                                            let _e1499 = (1f / _e1317);
                                                                            phi_1916_ = type_18(_e1496, (_e1311 * _e1499), (_e1315 * _e1499), _e1104);
                                                                        } else {
                                                                            phi_1916_ = type_18();
                                                                        }
                                                                        let _e1504 = phi_1916_;
                                                                        phi_1918_ = _e1504;
                                                                        phi_1919_ = select(true, false, _e1498);
                                                                    } else {
                                                                        phi_1918_ = type_18();
                                                                        phi_1919_ = true;
                                                                    }
                                                                    let _e1507 = phi_1918_;
                                                                    let _e1509 = phi_1919_;
                                                                    if _e1509 {
                                                                        phi_1923_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1923_ = _e1507;
                                                                    }
                                                                    let _e1511 = phi_1923_;
                                                                    phi_1924_ = _e1511;
                                                                }
                                                                let _e1513 = phi_1924_;
                                                                phi_1925_ = _e1513;
                                                                phi_1926_ = _e1383;
                                                            }
                                                            let _e1515 = phi_1925_;
                                                            let _e1517 = phi_1926_;
                                                            phi_1930_ = _e1515;
                                                            phi_1931_ = _e1517;
                                                        }
                                                        let _e1519 = phi_1930_;
                                                        let _e1521 = phi_1931_;
                                                        phi_1935_ = _e1519;
                                                        phi_1936_ = _e1521;
                                                    } else {
                                                        phi_1935_ = type_18();
                                                        phi_1936_ = true;
                                                    }
                                                    let _e1523 = phi_1935_;
                                                    let _e1525 = phi_1936_;
                                                    if _e1525 {
                                                        phi_1940_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1940_ = _e1523;
                                                    }
                                                    let _e1527 = phi_1940_;
                                                    if (_e1527.member_3 != 4294967295u) {
                                                        if (_e1104 != _e459) {
                                                            if (_e1527.member < _e1038.member.member.member) {
                                                                phi_1966_ = true;
                                                            } else {
                                                                if (_e1527.member == _e1038.member.member.member) {
                                                                    phi_1965_ = (_e1527.member_3 < _e1038.member.member.member_3);
                                                                } else {
                                                                    phi_1965_ = false;
                                                                }
                                                                let _e1542 = phi_1965_;
                                                                phi_1966_ = _e1542;
                                                            }
                                                            let _e1544 = phi_1966_;
                                                            if _e1544 {
                                                                phi_1973_ = type_38(type_35(_e1527, _e1527.member), _e1065.member_1, _e1065.member_2);
                                                            } else {
                                                                phi_1973_ = _e1065;
                                                            }
                                                            let _e1551 = phi_1973_;
                                                            phi_1974_ = _e1551;
                                                        } else {
                                                            phi_1974_ = _e1065;
                                                        }
                                                        let _e1553 = phi_1974_;
                                                        phi_1975_ = _e1553;
                                                    } else {
                                                        phi_1975_ = _e1065;
                                                    }
                                                    let _e1555 = phi_1975_;
                                                    phi_3680_ = _e1243;
                                                    phi_1006_ = _e1555;
                                                } else {
                                                    phi_3680_ = _e1036;
                                                    phi_1006_ = type_38();
                                                }
                                                let _e1557 = phi_3680_;
                                                let _e1559 = phi_1006_;
                                                continue;
                                                continuing {
                                                    phi_3621_ = _e1557;
                                                    phi_1005_ = _e1559;
                                                    phi_1008_ = _e1053;
                                                    phi_3679_ = _e1557;
                                                    break if !(_e1059);
                                                }
                                            }
                                            let _e1562 = phi_3679_;
                                            phi_3738_ = _e1562;
                                            if _e1562 {
                                                break;
                                            }
                                            phi_3742_ = _e1562;
                                            let _e1804 = local_15;
                                            phi_3218_ = _e1804;
                                            phi_3219_ = _e542;
                                            phi_3220_ = false;
                                            phi_3221_ = _e546;
                                        } else {
                                            if (_e542.member_1 >= _e94) {
                                                phi_2774_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e542.member_1 < _e94) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e564 = (_e275 * 2u);
                                                let _e566 = ((1u + _e564) % 7u);
                                                if (_e566 < 7u) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e571 = global_6.member[_e542.member_1][_e566];
                                                let _e573 = ((_e564 + 2u) % 7u);
                                                if (_e573 < 7u) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e578 = global_6.member[_e542.member_1][_e573];
                                                let _e579 = (_e274 * 2u);
                                                let _e581 = ((1u + _e579) % 7u);
                                                if (_e581 < 7u) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e586 = global_6.member[_e542.member_1][_e581];
                                                let _e588 = ((_e579 + 2u) % 7u);
                                                if (_e588 < 7u) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e593 = global_6.member[_e542.member_1][_e588];
                                                let _e594 = (_e276 * 2u);
                                                let _e596 = ((1u + _e594) % 7u);
                                                if (_e596 < 7u) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e601 = global_6.member[_e542.member_1][_e596];
                                                let _e603 = ((_e594 + 2u) % 7u);
                                                if (_e603 < 7u) {
                                                } else {
                                                    phi_3738_ = true;
                                                    break;
                                                }
                                                let _e608 = global_6.member[_e542.member_1][_e603];
                                                let _e631 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.x - _e542.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e632 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.y - _e542.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e633 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.z - _e542.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e635 = select(_e149, _e631, (_e631 > _e149));
                                                let _e637 = select(_e149, _e632, (_e632 > _e149));
                                                let _e639 = select(_e149, _e633, (_e633 > _e149));
                                                let _e664 = bitcast<u32>((f32(bitcast<i32>((_e571 & 2097151u))) * _e635));
                                                let _e669 = (bitcast<i32>((_e571 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e672 = bitcast<f32>((_e664 & bitcast<u32>(_e669)));
                                                let _e673 = bitcast<u32>((f32(bitcast<i32>((_e586 & 2097151u))) * _e637));
                                                let _e678 = (bitcast<i32>((_e586 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e681 = bitcast<f32>((_e673 & bitcast<u32>(_e678)));
                                                let _e682 = bitcast<u32>((f32(bitcast<i32>((_e601 & 2097151u))) * _e639));
                                                let _e687 = (bitcast<i32>((_e601 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e690 = bitcast<f32>((_e682 & bitcast<u32>(_e687)));
                                                let _e694 = bitcast<f32>((_e664 & bitcast<u32>(~(_e669))));
                                                let _e698 = bitcast<f32>((_e673 & bitcast<u32>(~(_e678))));
                                                let _e702 = bitcast<f32>((_e682 & bitcast<u32>(~(_e687))));
                                                let _e703 = bitcast<u32>((f32(bitcast<i32>((_e578 & 2097151u))) * _e635));
                                                let _e708 = (bitcast<i32>((_e578 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e711 = bitcast<f32>((_e703 & bitcast<u32>(_e708)));
                                                let _e712 = bitcast<u32>((f32(bitcast<i32>((_e593 & 2097151u))) * _e637));
                                                let _e717 = (bitcast<i32>((_e593 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e720 = bitcast<f32>((_e712 & bitcast<u32>(_e717)));
                                                let _e721 = bitcast<u32>((f32(bitcast<i32>((_e608 & 2097151u))) * _e639));
                                                let _e726 = (bitcast<i32>((_e608 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e729 = bitcast<f32>((_e721 & bitcast<u32>(_e726)));
                                                let _e733 = bitcast<f32>((_e703 & bitcast<u32>(~(_e708))));
                                                let _e737 = bitcast<f32>((_e712 & bitcast<u32>(~(_e717))));
                                                let _e741 = bitcast<f32>((_e721 & bitcast<u32>(~(_e726))));
                                                let _e742 = (_e542.member.member.x + _e672);
                                                let _e743 = (_e542.member.member.y + _e681);
                                                let _e744 = (_e542.member.member.z + _e690);
                                                let _e747 = (_e542.member.member_1.x - _e711);
                                                let _e748 = (_e542.member.member_1.y - _e720);
                                                let _e749 = (_e542.member.member_1.z - _e729);
                                                let _e768 = (_e747 - _e742);
                                                let _e769 = (_e748 - _e743);
                                                let _e770 = (_e749 - _e744);
                                                let _e772 = select(_e769, _e768, (_e768 > _e769));
                                                let _e774 = select(_e770, _e772, (_e772 > _e770));
                                                if (_e774 < (1024f * _e149)) {
                                                    phi_2475_ = 0u;
                                                } else {
                                                    phi_2475_ = select(2u, 1u, (_e774 < (2097152f * _e149)));
                                                }
                                                let _e781 = phi_2475_;
                                                switch bitcast<i32>(_e781) {
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
                                                let _e784 = phi_2481_;
                                                let _e790 = global_6.member[_e542.member_1][0u];
                                                let _e794 = global_6.member[_e542.member_1][2u];
                                                let _e798 = global_6.member[_e542.member_1][4u];
                                                let _e802 = global_6.member[_e542.member_1][6u];
                                                let _e814 = (((_e794 >> bitcast<u32>(22i)) | ((_e798 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e802 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e815 = (_e790 & 268435455u);
                                                let _e816 = (_e814 & 268435455u);
                                                let _e819 = ((_e790 >> bitcast<u32>(28u)) & 7u);
                                                let _e827 = ((_e790 >> bitcast<u32>(31i)) | (((_e814 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e828 = (_e819 != 0u);
                                                if (_e819 == 0u) {
                                                    phi_2736_ = _e815;
                                                } else {
                                                    if (_e819 == 7u) {
                                                        phi_2735_ = 2147483648u;
                                                    } else {
                                                        phi_2735_ = ((2147483648u | (_e819 << bitcast<u32>(28u))) | (_e816 & 268435455u));
                                                    }
                                                    let _e837 = phi_2735_;
                                                    phi_2736_ = _e837;
                                                }
                                                let _e839 = phi_2736_;
                                                if _e828 {
                                                    let _e840 = (_e819 != 7u);
                                                    if _e840 {
                                                        phi_2746_ = (_e816 + (_e819 * ((3u * _e784) + 1u)));
                                                    } else {
                                                        phi_2746_ = u32();
                                                    }
                                                    let _e844 = phi_2746_;
                                                    phi_2748_ = _e844;
                                                    phi_2749_ = select(true, false, _e840);
                                                } else {
                                                    phi_2748_ = u32();
                                                    phi_2749_ = true;
                                                }
                                                let _e847 = phi_2748_;
                                                let _e849 = phi_2749_;
                                                if (_e827 == 0u) {
                                                    phi_2770_ = (_e815 + select(0u, 1u, !(_e828)));
                                                } else {
                                                    if (_e827 == 7u) {
                                                        phi_2769_ = 2147483648u;
                                                    } else {
                                                        phi_2769_ = ((2147483648u | (_e827 << bitcast<u32>(28u))) | (select(_e847, _e816, _e849) & 268435455u));
                                                    }
                                                    let _e862 = phi_2769_;
                                                    phi_2770_ = _e862;
                                                }
                                                let _e864 = phi_2770_;
                                                phi_2774_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e742, (_e542.member.member.x + _e694), _e747, (_e542.member.member_1.x - _e733)), vec4<f32>(_e743, (_e542.member.member.y + _e698), _e748, (_e542.member.member_1.y - _e737)), vec4<f32>(_e744, (_e542.member.member.z + _e702), _e749, (_e542.member.member_1.z - _e741))), type_53(type_30((_e542.member.member + vec4<f32>(_e672, _e681, _e690, 0f)), (_e542.member.member_1 - vec4<f32>(_e711, _e720, _e729, 0f))), _e839), type_53(type_30((_e542.member.member + vec4<f32>(_e694, _e698, _e702, 0f)), (_e542.member.member_1 - vec4<f32>(_e733, _e737, _e741, 0f))), _e864));
                                            }
                                            let _e869 = phi_2774_;
                                            let _e882 = ((_e869.member[0].x - _e330) * _e335);
                                            let _e883 = ((_e869.member[0].y - _e330) * _e335);
                                            let _e884 = ((_e869.member[0].z - _e331) * _e335);
                                            let _e885 = ((_e869.member[0].w - _e331) * _e335);
                                            let _e895 = ((_e869.member[1].x - _e366) * _e371);
                                            let _e896 = ((_e869.member[1].y - _e366) * _e371);
                                            let _e897 = ((_e869.member[1].z - _e367) * _e371);
                                            let _e898 = ((_e869.member[1].w - _e367) * _e371);
                                            let _e908 = ((_e869.member[2].x - _e402) * _e407);
                                            let _e909 = ((_e869.member[2].y - _e402) * _e407);
                                            let _e910 = ((_e869.member[2].z - _e403) * _e407);
                                            let _e911 = ((_e869.member[2].w - _e403) * _e407);
                                            let _e913 = select(_e910, _e908, (_e908 < _e910));
                                            let _e915 = select(_e911, _e909, (_e909 < _e911));
                                            let _e917 = select(_e910, _e908, (_e908 > _e910));
                                            let _e919 = select(_e911, _e909, (_e909 > _e911));
                                            let _e921 = select(_e884, _e882, (_e882 < _e884));
                                            let _e923 = select(_e885, _e883, (_e883 < _e885));
                                            let _e925 = select(_e897, _e895, (_e895 < _e897));
                                            let _e927 = select(_e898, _e896, (_e896 < _e898));
                                            let _e929 = select(_e925, _e921, (_e921 > _e925));
                                            let _e931 = select(_e927, _e923, (_e923 > _e927));
                                            let _e933 = select(_e913, _e929, (_e929 > _e913));
                                            let _e935 = select(_e915, _e931, (_e931 > _e915));
                                            let _e937 = select(_e884, _e882, (_e882 > _e884));
                                            let _e939 = select(_e885, _e883, (_e883 > _e885));
                                            let _e941 = select(_e897, _e895, (_e895 > _e897));
                                            let _e943 = select(_e898, _e896, (_e896 > _e898));
                                            let _e945 = select(_e941, _e937, (_e937 < _e941));
                                            let _e947 = select(_e943, _e939, (_e939 < _e943));
                                            let _e952 = -(_e913);
                                            let _e953 = -(_e915);
                                            let _e960 = (select(_e917, _e945, (_e945 < _e917)) + (select(_e952, _e917, (_e917 > _e952)) * 0.0000019073523f));
                                            let _e961 = (select(_e919, _e947, (_e947 < _e919)) + (select(_e953, _e919, (_e919 > _e953)) * 0.0000019073523f));
                                            let _e963 = select(_e453, _e933, (_e933 > _e453));
                                            let _e965 = select(_e453, _e935, (_e935 > _e453));
                                            let _e970 = (_e963 <= select(_e502.member.member_1, _e960, (_e960 < _e502.member.member_1)));
                                            let _e971 = (_e965 <= select(_e502.member.member_1, _e961, (_e961 < _e502.member.member_1)));
                                            let _e972 = (_e963 <= _e965);
                                            if _e970 {
                                                if _e971 {
                                                    if _e972 {
                                                        phi_3118_ = _e869.member_2;
                                                    } else {
                                                        phi_3118_ = _e869.member_1;
                                                    }
                                                    let _e976 = phi_3118_;
                                                    let _e998 = (_e546 % 128u);
                                                    let _e999 = (_e998 < 128u);
                                                    if _e999 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_8[_e998] = _e976.member_1;
                                                    if _e999 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_7[_e998] = _e976.member.member.x;
                                                    if _e999 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_6[_e998] = _e976.member.member.y;
                                                    if _e999 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_5[_e998] = _e976.member.member.z;
                                                    if _e999 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_4[_e998] = _e976.member.member_1.x;
                                                    if _e999 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_3[_e998] = _e976.member.member_1.y;
                                                    if _e999 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_2[_e998] = _e976.member.member_1.z;
                                                    if _e999 {
                                                    } else {
                                                        phi_3738_ = true;
                                                        break;
                                                    }
                                                    local_9[_e998] = select(_e965, _e963, (_e963 > _e965));
                                                    if _e972 {
                                                        phi_3195_ = _e869.member_1;
                                                    } else {
                                                        phi_3195_ = _e869.member_2;
                                                    }
                                                    let _e1012 = phi_3195_;
                                                    phi_3196_ = _e1012;
                                                    phi_3197_ = (_e546 + 1u);
                                                } else {
                                                    phi_3196_ = type_53();
                                                    phi_3197_ = u32();
                                                }
                                                let _e1014 = phi_3196_;
                                                let _e1016 = phi_3197_;
                                                phi_3199_ = _e1014;
                                                phi_3200_ = _e1016;
                                                phi_3201_ = select(true, false, _e971);
                                            } else {
                                                phi_3199_ = type_53();
                                                phi_3200_ = u32();
                                                phi_3201_ = true;
                                            }
                                            let _e1019 = phi_3199_;
                                            let _e1021 = phi_3200_;
                                            let _e1023 = phi_3201_;
                                            if _e1023 {
                                                if _e970 {
                                                    phi_3210_ = _e869.member_1;
                                                } else {
                                                    phi_3210_ = _e869.member_2;
                                                }
                                                let _e1027 = phi_3210_;
                                                phi_3215_ = _e1027;
                                                phi_3216_ = select(_e971, true, _e970);
                                            } else {
                                                phi_3215_ = _e1019;
                                                phi_3216_ = _e544;
                                            }
                                            let _e1030 = phi_3215_;
                                            let _e1032 = phi_3216_;
                                            phi_3742_ = _e500;
                                            phi_3218_ = type_38(_e502.member, (_e502.member_1 + 1u), _e502.member_2);
                                            phi_3219_ = _e1030;
                                            phi_3220_ = _e1032;
                                            phi_3221_ = select(_e1021, _e546, _e1023);
                                        }
                                        let _e1564 = phi_3742_;
                                        let _e1566 = phi_3218_;
                                        let _e1568 = phi_3219_;
                                        let _e1570 = phi_3220_;
                                        let _e1572 = phi_3221_;
                                        phi_3741_ = _e1564;
                                        phi_3222_ = _e1566;
                                        phi_3223_ = _e1568;
                                        phi_3224_ = (_e506 - 1u);
                                        phi_3225_ = _e1570;
                                        phi_3226_ = _e1572;
                                    } else {
                                        phi_3741_ = _e500;
                                        phi_3222_ = _e502;
                                        phi_3223_ = _e542;
                                        phi_3224_ = _e506;
                                        phi_3225_ = _e544;
                                        phi_3226_ = _e546;
                                    }
                                    let _e1574 = phi_3741_;
                                    let _e1576 = phi_3222_;
                                    let _e1578 = phi_3223_;
                                    let _e1580 = phi_3224_;
                                    let _e1582 = phi_3225_;
                                    let _e1584 = phi_3226_;
                                    phi_3740_ = _e1574;
                                    phi_3227_ = _e1576;
                                    phi_3228_ = _e1578;
                                    phi_3229_ = _e1580;
                                    phi_3230_ = _e1582;
                                    phi_3231_ = _e1584;
                                } else {
                                    phi_3740_ = _e500;
                                    phi_3227_ = type_38();
                                    phi_3228_ = type_53();
                                    phi_3229_ = u32();
                                    phi_3230_ = bool();
                                    phi_3231_ = u32();
                                }
                                let _e1586 = phi_3740_;
                                let _e1588 = phi_3227_;
                                let _e1590 = phi_3228_;
                                let _e1592 = phi_3229_;
                                let _e1594 = phi_3230_;
                                let _e1596 = phi_3231_;
                                phi_3739_ = _e1586;
                                phi_879_ = _e1588;
                                phi_882_ = _e1590;
                                phi_884_ = _e1592;
                                phi_886_ = _e1594;
                                phi_888_ = _e1596;
                                phi_3232_ = _e514;
                            } else {
                                phi_3739_ = _e500;
                                phi_879_ = type_38();
                                phi_882_ = type_53();
                                phi_884_ = u32();
                                phi_886_ = bool();
                                phi_888_ = u32();
                                phi_3232_ = false;
                            }
                            let _e1598 = phi_3739_;
                            let _e1600 = phi_879_;
                            let _e1602 = phi_882_;
                            let _e1604 = phi_884_;
                            let _e1606 = phi_886_;
                            let _e1608 = phi_888_;
                            let _e1610 = phi_3232_;
                            continue;
                            continuing {
                                phi_3624_ = _e1598;
                                phi_878_ = _e1600;
                                phi_881_ = _e1602;
                                phi_883_ = _e1604;
                                phi_885_ = _e1606;
                                phi_887_ = _e1608;
                                phi_3738_ = _e1598;
                                break if !(_e1610);
                            }
                        }
                        let _e1613 = phi_3738_;
                        if _e1613 {
                            break;
                        }
                        let _e1615 = local_13;
                        if (_e1615.member.member.member_3 != 4294967295u) {
                            let _e1621 = (_e277 / 3i);
                            let _e1628 = bitcast<f32>((bitcast<u32>((_e1621 + 127i)) << bitcast<u32>(23i)));
                            let _e1636 = (((_e1615.member.member.member * _e1628) * _e1628) * bitcast<f32>((bitcast<u32>(((_e277 - (2i * _e1621)) + 127i)) << bitcast<u32>(23i))));
                            let _e1638 = select(340282350000000000000000000000000000000f, _e1636, (_e1636 < 340282350000000000000000000000000000000f));
                            phi_3284_ = type_18(select(-340282350000000000000000000000000000000f, _e1638, (_e1638 > -340282350000000000000000000000000000000f)), _e1615.member.member.member_1, _e1615.member.member.member_2, _e1615.member.member.member_3);
                        } else {
                            phi_3284_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1645 = phi_3284_;
                        if _e153 {
                        } else {
                            break;
                        }
                        global_1.member[_e137] = _e1645;
                        let _e1649 = local_14;
                        if _e154 {
                        } else {
                            break;
                        }
                        global_4.member[_e137] = _e1649.member_1;
                        if _e152 {
                        } else {
                            break;
                        }
                        let _e1654 = select(0u, 1u, (_e221 <= _e231));
                        if (_e1654 > 0u) {
                            let _e1656 = (1u < _e105);
                            if _e1656 {
                                if (0u < _e105) {
                                } else {
                                    break;
                                }
                                let _e1660 = atomicAdd((&global_5.member[0u]), _e1654);
                                if ((_e1660 + _e1654) < _e1660) {
                                    if _e1656 {
                                    } else {
                                        break;
                                    }
                                    let _e1665 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1668 = select(0u, 1u, (_e1645.member_3 != 4294967295u));
                        if (_e1668 > 0u) {
                            let _e1670 = (3u < _e105);
                            if _e1670 {
                                if (2u < _e105) {
                                } else {
                                    break;
                                }
                                let _e1674 = atomicAdd((&global_5.member[2u]), _e1668);
                                if ((_e1674 + _e1668) < _e1674) {
                                    if _e1670 {
                                    } else {
                                        break;
                                    }
                                    let _e1679 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1649.member_1 > 0u) {
                            let _e1681 = (5u < _e105);
                            if _e1681 {
                                if (4u < _e105) {
                                } else {
                                    break;
                                }
                                let _e1685 = atomicAdd((&global_5.member[4u]), _e1649.member_1);
                                if ((_e1685 + _e1649.member_1) < _e1685) {
                                    if _e1681 {
                                    } else {
                                        break;
                                    }
                                    let _e1690 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
