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

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_42 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_34,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

struct type_55 {
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
var<storage, read_write> global_6: type_55;
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
    var phi_403_: i32;
    var phi_404_: i32;
    var phi_414_: bool;
    var phi_424_: u32;
    var phi_425_: u32;
    var phi_427_: bool;
    var phi_432_: u32;
    var phi_464_: i32;
    var phi_482_: f32;
    var phi_488_: f32;
    var phi_499_: f32;
    var phi_505_: f32;
    var phi_528_: f32;
    var phi_539_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_565_: f32;
    var phi_571_: f32;
    var phi_594_: f32;
    var phi_605_: f32;
    var phi_614_: f32;
    var phi_620_: f32;
    var phi_631_: f32;
    var phi_637_: f32;
    var phi_660_: f32;
    var phi_671_: f32;
    var phi_771_: f32;
    var phi_772_: f32;
    var phi_4220_: bool;
    var phi_870_: type_42;
    var phi_873_: type_49;
    var phi_875_: u32;
    var phi_877_: bool;
    var phi_879_: u32;
    var phi_890_: bool;
    var phi_976_: type_49;
    var phi_977_: bool;
    var phi_978_: u32;
    var phi_3094_: u32;
    var phi_3100_: u32;
    var phi_3354_: u32;
    var phi_3355_: u32;
    var phi_3365_: u32;
    var phi_3367_: u32;
    var phi_3368_: bool;
    var phi_3388_: u32;
    var phi_3389_: u32;
    var phi_3393_: type_50;
    var phi_3737_: type_49;
    var phi_3814_: type_49;
    var phi_3815_: type_49;
    var phi_3816_: u32;
    var phi_3818_: type_49;
    var phi_3819_: u32;
    var phi_3820_: bool;
    var phi_3829_: type_49;
    var phi_3834_: type_49;
    var phi_3835_: bool;
    var phi_997_: type_42;
    var phi_1000_: type_8;
    var phi_1001_: type_8;
    var phi_1023_: type_8;
    var phi_1067_: u32;
    var phi_1073_: u32;
    var phi_1083_: u32;
    var phi_1099_: u32;
    var phi_1132_: u32;
    var phi_1138_: u32;
    var phi_1565_: u32;
    var phi_1583_: u32;
    var phi_1601_: u32;
    var phi_1621_: u32;
    var phi_1639_: u32;
    var phi_1657_: u32;
    var phi_1677_: u32;
    var phi_1695_: u32;
    var phi_1713_: u32;
    var phi_1291_: u32;
    var phi_1306_: u32;
    var phi_1316_: u32;
    var phi_1336_: u32;
    var phi_1356_: u32;
    var phi_1382_: u32;
    var phi_1397_: u32;
    var phi_1407_: u32;
    var phi_1427_: u32;
    var phi_1447_: u32;
    var phi_1473_: u32;
    var phi_1488_: u32;
    var phi_1498_: u32;
    var phi_1518_: u32;
    var phi_1538_: u32;
    var phi_1162_: u32;
    var phi_1205_: u32;
    var phi_1248_: u32;
    var phi_1719_: array<array<f32, 3>, 3>;
    var phi_1836_: bool;
    var phi_1865_: bool;
    var phi_2266_: f32;
    var phi_2267_: f32;
    var phi_2268_: f32;
    var phi_2269_: f32;
    var phi_2270_: vec3<f32>;
    var phi_2271_: vec3<f32>;
    var phi_2272_: vec3<f32>;
    var phi_2273_: vec3<f32>;
    var phi_2304_: bool;
    var phi_2313_: vec3<f32>;
    var phi_2478_: f32;
    var phi_2480_: f32;
    var phi_2481_: bool;
    var phi_2501_: f32;
    var phi_2502_: f32;
    var phi_2525_: type_22;
    var phi_2527_: type_22;
    var phi_2528_: bool;
    var phi_2532_: type_22;
    var phi_2533_: type_22;
    var phi_2534_: type_22;
    var phi_2535_: bool;
    var phi_2539_: type_22;
    var phi_2540_: bool;
    var phi_2541_: type_22;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: type_22;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2554_: type_22;
    var phi_2555_: bool;
    var phi_2559_: type_22;
    var phi_2584_: bool;
    var phi_2585_: bool;
    var phi_2592_: type_42;
    var phi_2593_: type_42;
    var phi_2594_: type_42;
    var phi_998_: type_42;
    var phi_4214_: bool;
    var phi_4407_: bool;
    var phi_3837_: type_42;
    var phi_3838_: type_49;
    var phi_3839_: bool;
    var phi_3840_: u32;
    var phi_4406_: bool;
    var phi_3841_: type_42;
    var phi_3842_: type_49;
    var phi_3843_: u32;
    var phi_3844_: bool;
    var phi_3845_: u32;
    var phi_4405_: bool;
    var phi_3846_: type_42;
    var phi_3847_: type_49;
    var phi_3848_: u32;
    var phi_3849_: bool;
    var phi_3850_: u32;
    var phi_4404_: bool;
    var phi_871_: type_42;
    var phi_874_: type_49;
    var phi_876_: u32;
    var phi_878_: bool;
    var phi_880_: u32;
    var phi_3851_: bool;
    var phi_4403_: bool;
    var local_10: type_42;
    var phi_3903_: type_22;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_3.member));
            let _e97 = arrayLength((&global_7.member));
            let _e105 = arrayLength((&global_6.member));
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
            let _e152 = (_e137 < arrayLength((&global_4.member)));
            if _e152 {
                let _e153 = (_e137 < arrayLength((&global_1.member)));
                if _e153 {
                    let _e154 = (_e137 < arrayLength((&global_5.member)));
                    if _e154 {
                        if _e152 {
                        } else {
                            break;
                        }
                        let _e164 = global_4.member[_e137].member.member_2[0u];
                        let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                        let _e172 = global_4.member[_e137].member.member_2[1u];
                        let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                        let _e180 = global_4.member[_e137].member.member_2[2u];
                        let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                        let _e188 = global_4.member[_e137].member.member[0u];
                        let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                        let _e196 = global_4.member[_e137].member.member[1u];
                        let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                        let _e204 = global_4.member[_e137].member.member[2u];
                        let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                        let _e208 = select(_e174, _e166, (_e174 < _e166));
                        let _e210 = select(_e182, _e208, (_e182 < _e208));
                        let _e212 = select(_e190, _e210, (_e190 < _e210));
                        let _e214 = select(_e198, _e212, (_e198 < _e212));
                        let _e216 = select(_e206, _e214, (_e206 < _e214));
                        let _e221 = global_4.member[_e137].member.member_1;
                        let _e223 = (bitcast<u32>(_e221) & 2147483647u);
                        let _e231 = global_4.member[_e137].member.member_3;
                        let _e237 = (((select(_e223, _e216, (_e223 < _e216)) < 2139095040u) && ((bitcast<u32>(_e231) & 2147483647u) <= 2139095040u)) && (_e210 > 0u));
                        if _e237 {
                            let _e240 = (bitcast<u32>(bitcast<f32>(_e210)) & 2147483647u);
                            if (_e240 >= 8388608u) {
                                phi_403_ = (bitcast<i32>((_e240 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_403_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e240)), 32u, (_e240 == 0u))));
                            }
                            let _e254 = phi_403_;
                            phi_404_ = _e254;
                        } else {
                            phi_404_ = 0i;
                        }
                        let _e256 = phi_404_;
                        let _e257 = (_e166 == _e210);
                        if _e257 {
                            phi_414_ = true;
                        } else {
                            phi_414_ = (_e174 == _e210);
                        }
                        let _e260 = phi_414_;
                        let _e261 = select(1u, 0u, _e257);
                        if _e260 {
                            let _e262 = (_e261 + 1u);
                            phi_424_ = _e262;
                            phi_425_ = _e262;
                            phi_427_ = select(true, false, (_e262 == 2u));
                        } else {
                            phi_424_ = u32();
                            phi_425_ = 0u;
                            phi_427_ = true;
                        }
                        let _e266 = phi_424_;
                        let _e268 = phi_425_;
                        let _e270 = phi_427_;
                        if _e270 {
                            phi_432_ = (_e268 + 1u);
                        } else {
                            phi_432_ = 0u;
                        }
                        let _e274 = phi_432_;
                        let _e275 = select(_e266, _e268, _e270);
                        let _e276 = select(_e261, select(2u, _e261, _e260), _e270);
                        let _e277 = -(_e256);
                        if (_e277 < -126i) {
                            phi_464_ = -126i;
                        } else {
                            phi_464_ = select(_e277, 127i, (_e277 > 127i));
                        }
                        let _e282 = phi_464_;
                        let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                        let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                        let _e298 = global_4.member[_e137].member.member;
                        let _e299 = (_e275 == 0u);
                        if _e299 {
                            phi_482_ = _e298[0];
                        } else {
                            phi_482_ = _e298[1];
                        }
                        let _e303 = phi_482_;
                        let _e304 = (_e275 == 2u);
                        if _e304 {
                            phi_488_ = _e298[2];
                        } else {
                            phi_488_ = _e303;
                        }
                        let _e307 = phi_488_;
                        let _e308 = global_4.member[_e137].member.member_2;
                        if _e299 {
                            phi_499_ = _e308[0];
                        } else {
                            phi_499_ = _e308[1];
                        }
                        let _e312 = phi_499_;
                        if _e304 {
                            phi_505_ = _e308[2];
                        } else {
                            phi_505_ = _e312;
                        }
                        let _e315 = phi_505_;
                        let _e317 = ((_e315 * _e287) * _e293);
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e321 {
                            let _e325 = (bitcast<f32>((bitcast<u32>(_e307) & 2147483647u)) * 0.00000011920929f);
                            phi_528_ = select(0.00000000000011368684f, _e325, (_e325 > 0.00000000000011368684f));
                        } else {
                            phi_528_ = 0f;
                        }
                        let _e329 = phi_528_;
                        let _e330 = (_e307 + _e329);
                        let _e331 = (_e307 - _e329);
                        let _e332 = select(_e317, 0f, _e321);
                        if _e321 {
                            phi_539_ = 38685626000000000000000000f;
                        } else {
                            phi_539_ = (1f / _e317);
                        }
                        let _e335 = phi_539_;
                        let _e336 = (_e274 == 0u);
                        if _e336 {
                            phi_548_ = _e298[0];
                        } else {
                            phi_548_ = _e298[1];
                        }
                        let _e340 = phi_548_;
                        let _e341 = (_e274 == 2u);
                        if _e341 {
                            phi_554_ = _e298[2];
                        } else {
                            phi_554_ = _e340;
                        }
                        let _e344 = phi_554_;
                        if _e336 {
                            phi_565_ = _e308[0];
                        } else {
                            phi_565_ = _e308[1];
                        }
                        let _e348 = phi_565_;
                        if _e341 {
                            phi_571_ = _e308[2];
                        } else {
                            phi_571_ = _e348;
                        }
                        let _e351 = phi_571_;
                        let _e353 = ((_e351 * _e287) * _e293);
                        let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e357 {
                            let _e361 = (bitcast<f32>((bitcast<u32>(_e344) & 2147483647u)) * 0.00000011920929f);
                            phi_594_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                        } else {
                            phi_594_ = 0f;
                        }
                        let _e365 = phi_594_;
                        let _e366 = (_e344 + _e365);
                        let _e367 = (_e344 - _e365);
                        let _e368 = select(_e353, 0f, _e357);
                        if _e357 {
                            phi_605_ = 38685626000000000000000000f;
                        } else {
                            phi_605_ = (1f / _e353);
                        }
                        let _e371 = phi_605_;
                        let _e372 = (_e276 == 0u);
                        if _e372 {
                            phi_614_ = _e298[0];
                        } else {
                            phi_614_ = _e298[1];
                        }
                        let _e376 = phi_614_;
                        let _e377 = (_e276 == 2u);
                        if _e377 {
                            phi_620_ = _e298[2];
                        } else {
                            phi_620_ = _e376;
                        }
                        let _e380 = phi_620_;
                        if _e372 {
                            phi_631_ = _e308[0];
                        } else {
                            phi_631_ = _e308[1];
                        }
                        let _e384 = phi_631_;
                        if _e377 {
                            phi_637_ = _e308[2];
                        } else {
                            phi_637_ = _e384;
                        }
                        let _e387 = phi_637_;
                        let _e389 = ((_e387 * _e287) * _e293);
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e393 {
                            let _e397 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) * 0.00000011920929f);
                            phi_660_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                        } else {
                            phi_660_ = 0f;
                        }
                        let _e401 = phi_660_;
                        let _e402 = (_e380 + _e401);
                        let _e403 = (_e380 - _e401);
                        let _e404 = select(_e389, 0f, _e393);
                        if _e393 {
                            phi_671_ = 38685626000000000000000000f;
                        } else {
                            phi_671_ = (1f / _e389);
                        }
                        let _e407 = phi_671_;
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
                            phi_771_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                            phi_772_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_771_ = 0f;
                            phi_772_ = 1f;
                        }
                        let _e451 = phi_771_;
                        let _e453 = phi_772_;
                        if _e152 {
                        } else {
                            break;
                        }
                        let _e459 = global_4.member[_e137].member_2;
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
                        phi_4220_ = false;
                        phi_870_ = type_42(type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e451), 0u, 0u);
                        phi_873_ = type_49(type_34(vec4<f32>((f32(_e465) * _e149), (f32(_e471) * _e149), (f32(_e477) * _e149), 0f), vec4<f32>((f32(_e482) * _e149), (f32(_e486) * _e149), (f32(_e490) * _e149), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                        phi_875_ = ((3u * _e94) + 1u);
                        phi_877_ = (_e453 <= _e451);
                        phi_879_ = 0u;
                        loop {
                            let _e500 = phi_4220_;
                            let _e502 = phi_870_;
                            let _e504 = phi_873_;
                            let _e506 = phi_875_;
                            let _e508 = phi_877_;
                            let _e510 = phi_879_;
                            local_10 = _e502;
                            local_11 = _e502;
                            if _e508 {
                                phi_890_ = true;
                            } else {
                                phi_890_ = (_e510 > 0u);
                            }
                            let _e513 = phi_890_;
                            if _e513 {
                                let _e514 = (_e506 > 0u);
                                if _e514 {
                                    if _e508 {
                                        phi_976_ = _e504;
                                        phi_977_ = _e508;
                                        phi_978_ = _e510;
                                    } else {
                                        let _e515 = (_e510 - 1u);
                                        let _e516 = (_e515 % 128u);
                                        let _e517 = (_e516 < 128u);
                                        if _e517 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e519 = local_7[_e516];
                                        if _e517 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e521 = local_6[_e516];
                                        if _e517 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e523 = local_5[_e516];
                                        if _e517 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e525 = local_4[_e516];
                                        if _e517 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e527 = local_3[_e516];
                                        if _e517 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e529 = local_2[_e516];
                                        if _e517 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e534 = local_8[_e516];
                                        if _e517 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e537 = local_9[_e516];
                                        phi_976_ = type_49(type_34(vec4<f32>(_e519, _e521, _e523, 0f), vec4<f32>(_e525, _e527, _e529, 0f)), _e534);
                                        phi_977_ = (_e537 <= _e502.member.member_1);
                                        phi_978_ = _e515;
                                    }
                                    let _e542 = phi_976_;
                                    let _e544 = phi_977_;
                                    let _e546 = phi_978_;
                                    if _e544 {
                                        let _e551 = (_e542.member_1 & 268435455u);
                                        if ((_e542.member_1 & 2147483648u) != 0u) {
                                            phi_997_ = _e502;
                                            phi_1000_ = type_8(0u, ((_e542.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1018 = phi_997_;
                                                let _e1020 = phi_1000_;
                                                local_12 = _e1018;
                                                if (_e1020.member < _e1020.member_1) {
                                                    phi_1001_ = type_8((_e1020.member + 1u), _e1020.member_1);
                                                    phi_1023_ = type_8(1u, _e1020.member);
                                                } else {
                                                    phi_1001_ = _e1020;
                                                    phi_1023_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1033 = phi_1001_;
                                                let _e1035 = phi_1023_;
                                                let _e1039 = (bitcast<i32>(_e1035.member) != 0i);
                                                if _e1039 {
                                                    let _e1045 = type_42(_e1018.member, _e1018.member_1, (_e1018.member_2 + 1u));
                                                    let _e1050 = (_e542.member.member_1.x - _e542.member.member.x);
                                                    let _e1053 = (_e542.member.member_1.y - _e542.member.member.y);
                                                    let _e1056 = (_e542.member.member_1.z - _e542.member.member.z);
                                                    let _e1058 = select(_e1053, _e1050, (_e1050 > _e1053));
                                                    let _e1060 = select(_e1056, _e1058, (_e1058 > _e1056));
                                                    let _e1062 = (_e1060 < (1024f * _e149));
                                                    if _e1062 {
                                                        phi_1067_ = 0u;
                                                    } else {
                                                        phi_1067_ = select(2u, 1u, (_e1060 < (2097152f * _e149)));
                                                    }
                                                    let _e1067 = phi_1067_;
                                                    switch bitcast<i32>(_e1067) {
                                                        case 0: {
                                                            phi_1073_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1073_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1073_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1073_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1070 = phi_1073_;
                                                    switch bitcast<i32>(_e1067) {
                                                        case 0: {
                                                            phi_1083_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1083_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1083_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1083_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1077 = phi_1083_;
                                                    let _e1079 = ((_e551 + (_e1035.member_1 * ((3u * _e1070) + 1u))) + (3u * _e1077));
                                                    let _e1080 = (_e1079 < _e97);
                                                    if _e1080 {
                                                        if _e1080 {
                                                        } else {
                                                            phi_4214_ = true;
                                                            break;
                                                        }
                                                        let _e1082 = global_7.member[_e1079];
                                                        phi_1099_ = _e1082;
                                                    } else {
                                                        phi_1099_ = 4294967295u;
                                                    }
                                                    let _e1084 = phi_1099_;
                                                    if _e1062 {
                                                        phi_1132_ = 0u;
                                                    } else {
                                                        phi_1132_ = select(2u, 1u, (_e1060 < (2097152f * _e149)));
                                                    }
                                                    let _e1089 = phi_1132_;
                                                    switch bitcast<i32>(_e1089) {
                                                        case 0: {
                                                            phi_1138_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1138_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1138_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1138_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1092 = phi_1138_;
                                                    let _e1096 = (_e551 + (_e1035.member_1 * ((3u * _e1092) + 1u)));
                                                    switch bitcast<i32>(_e1089) {
                                                        case 0: {
                                                            let _e1362 = (_e1096 < _e97);
                                                            if _e1362 {
                                                                if _e1362 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1364 = global_7.member[_e1096];
                                                                phi_1162_ = _e1364;
                                                            } else {
                                                                phi_1162_ = 0u;
                                                            }
                                                            let _e1366 = phi_1162_;
                                                            let _e1368 = ((10u * _e275) & 31u);
                                                            let _e1377 = ((10u * _e274) & 31u);
                                                            let _e1386 = ((10u * _e276) & 31u);
                                                            let _e1395 = (_e1096 + 1u);
                                                            let _e1396 = (_e1395 < _e97);
                                                            if _e1396 {
                                                                if _e1396 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1398 = global_7.member[_e1395];
                                                                phi_1205_ = _e1398;
                                                            } else {
                                                                phi_1205_ = 0u;
                                                            }
                                                            let _e1400 = phi_1205_;
                                                            let _e1423 = (_e1096 + 2u);
                                                            let _e1424 = (_e1423 < _e97);
                                                            if _e1424 {
                                                                if _e1424 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1426 = global_7.member[_e1423];
                                                                phi_1248_ = _e1426;
                                                            } else {
                                                                phi_1248_ = 0u;
                                                            }
                                                            let _e1428 = phi_1248_;
                                                            phi_1719_ = array<array<f32, 3>, 3>(array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>(((_e1366 >> bitcast<u32>(_e1368)) & 1023u))) * _e149)), (_e542.member.member.y + (f32(bitcast<i32>(((_e1366 >> bitcast<u32>(_e1377)) & 1023u))) * _e149)), (_e542.member.member.z + (f32(bitcast<i32>(((_e1366 >> bitcast<u32>(_e1386)) & 1023u))) * _e149))), array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>(((_e1400 >> bitcast<u32>(_e1368)) & 1023u))) * _e149)), (_e542.member.member.y + (f32(bitcast<i32>(((_e1400 >> bitcast<u32>(_e1377)) & 1023u))) * _e149)), (_e542.member.member.z + (f32(bitcast<i32>(((_e1400 >> bitcast<u32>(_e1386)) & 1023u))) * _e149))), array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>(((_e1428 >> bitcast<u32>(_e1368)) & 1023u))) * _e149)), (_e542.member.member.y + (f32(bitcast<i32>(((_e1428 >> bitcast<u32>(_e1377)) & 1023u))) * _e149)), (_e542.member.member.z + (f32(bitcast<i32>(((_e1428 >> bitcast<u32>(_e1386)) & 1023u))) * _e149))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1185 = (_e1096 < _e97);
                                                            if _e1185 {
                                                                if _e1185 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1187 = global_7.member[_e1096];
                                                                phi_1291_ = _e1187;
                                                            } else {
                                                                phi_1291_ = 0u;
                                                            }
                                                            let _e1189 = phi_1291_;
                                                            let _e1190 = (_e1096 + 1u);
                                                            let _e1191 = (_e1190 < _e97);
                                                            if _e1191 {
                                                                if _e1191 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1193 = global_7.member[_e1190];
                                                                phi_1306_ = _e1193;
                                                            } else {
                                                                phi_1306_ = 0u;
                                                            }
                                                            let _e1195 = phi_1306_;
                                                            let _e1196 = (_e275 == 1u);
                                                            if _e1196 {
                                                                phi_1316_ = ((_e1189 >> bitcast<u32>(21i)) | (_e1195 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1316_ = (_e1195 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1205 = phi_1316_;
                                                            let _e1212 = (_e274 == 1u);
                                                            if _e1212 {
                                                                phi_1336_ = ((_e1189 >> bitcast<u32>(21i)) | (_e1195 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1336_ = (_e1195 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1221 = phi_1336_;
                                                            let _e1228 = (_e276 == 1u);
                                                            if _e1228 {
                                                                phi_1356_ = ((_e1189 >> bitcast<u32>(21i)) | (_e1195 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1356_ = (_e1195 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1237 = phi_1356_;
                                                            let _e1245 = (_e1096 + 2u);
                                                            let _e1246 = (_e1245 < _e97);
                                                            if _e1246 {
                                                                if _e1246 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1248 = global_7.member[_e1245];
                                                                phi_1382_ = _e1248;
                                                            } else {
                                                                phi_1382_ = 0u;
                                                            }
                                                            let _e1250 = phi_1382_;
                                                            let _e1251 = (_e1096 + 3u);
                                                            let _e1252 = (_e1251 < _e97);
                                                            if _e1252 {
                                                                if _e1252 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1254 = global_7.member[_e1251];
                                                                phi_1397_ = _e1254;
                                                            } else {
                                                                phi_1397_ = 0u;
                                                            }
                                                            let _e1256 = phi_1397_;
                                                            if _e1196 {
                                                                phi_1407_ = ((_e1250 >> bitcast<u32>(21i)) | (_e1256 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1407_ = (_e1256 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1265 = phi_1407_;
                                                            if _e1212 {
                                                                phi_1427_ = ((_e1250 >> bitcast<u32>(21i)) | (_e1256 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1427_ = (_e1256 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1280 = phi_1427_;
                                                            if _e1228 {
                                                                phi_1447_ = ((_e1250 >> bitcast<u32>(21i)) | (_e1256 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1447_ = (_e1256 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1295 = phi_1447_;
                                                            let _e1303 = (_e1096 + 4u);
                                                            let _e1304 = (_e1303 < _e97);
                                                            if _e1304 {
                                                                if _e1304 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1306 = global_7.member[_e1303];
                                                                phi_1473_ = _e1306;
                                                            } else {
                                                                phi_1473_ = 0u;
                                                            }
                                                            let _e1308 = phi_1473_;
                                                            let _e1309 = (_e1096 + 5u);
                                                            let _e1310 = (_e1309 < _e97);
                                                            if _e1310 {
                                                                if _e1310 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1312 = global_7.member[_e1309];
                                                                phi_1488_ = _e1312;
                                                            } else {
                                                                phi_1488_ = 0u;
                                                            }
                                                            let _e1314 = phi_1488_;
                                                            if _e1196 {
                                                                phi_1498_ = ((_e1308 >> bitcast<u32>(21i)) | (_e1314 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1498_ = (_e1314 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1323 = phi_1498_;
                                                            if _e1212 {
                                                                phi_1518_ = ((_e1308 >> bitcast<u32>(21i)) | (_e1314 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1518_ = (_e1314 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1338 = phi_1518_;
                                                            if _e1228 {
                                                                phi_1538_ = ((_e1308 >> bitcast<u32>(21i)) | (_e1314 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1538_ = (_e1314 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1353 = phi_1538_;
                                                            phi_1719_ = array<array<f32, 3>, 3>(array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>((select(_e1205, _e1189, _e299) & 2097151u))) * _e149)), (_e542.member.member.y + (f32(bitcast<i32>((select(_e1221, _e1189, _e336) & 2097151u))) * _e149)), (_e542.member.member.z + (f32(bitcast<i32>((select(_e1237, _e1189, _e372) & 2097151u))) * _e149))), array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>((select(_e1265, _e1250, _e299) & 2097151u))) * _e149)), (_e542.member.member.y + (f32(bitcast<i32>((select(_e1280, _e1250, _e336) & 2097151u))) * _e149)), (_e542.member.member.z + (f32(bitcast<i32>((select(_e1295, _e1250, _e372) & 2097151u))) * _e149))), array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>((select(_e1323, _e1308, _e299) & 2097151u))) * _e149)), (_e542.member.member.y + (f32(bitcast<i32>((select(_e1338, _e1308, _e336) & 2097151u))) * _e149)), (_e542.member.member.z + (f32(bitcast<i32>((select(_e1353, _e1308, _e372) & 2097151u))) * _e149))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1098 = (_e1096 + _e275);
                                                            let _e1099 = (_e1098 < _e97);
                                                            if _e1099 {
                                                                if _e1099 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1101 = global_7.member[_e1098];
                                                                phi_1565_ = _e1101;
                                                            } else {
                                                                phi_1565_ = 0u;
                                                            }
                                                            let _e1103 = phi_1565_;
                                                            let _e1107 = (_e1096 + _e274);
                                                            let _e1108 = (_e1107 < _e97);
                                                            if _e1108 {
                                                                if _e1108 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1110 = global_7.member[_e1107];
                                                                phi_1583_ = _e1110;
                                                            } else {
                                                                phi_1583_ = 0u;
                                                            }
                                                            let _e1112 = phi_1583_;
                                                            let _e1116 = (_e1096 + _e276);
                                                            let _e1117 = (_e1116 < _e97);
                                                            if _e1117 {
                                                                if _e1117 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1119 = global_7.member[_e1116];
                                                                phi_1601_ = _e1119;
                                                            } else {
                                                                phi_1601_ = 0u;
                                                            }
                                                            let _e1121 = phi_1601_;
                                                            let _e1126 = (_e1096 + 3u);
                                                            let _e1127 = (_e1126 + _e275);
                                                            let _e1128 = (_e1127 < _e97);
                                                            if _e1128 {
                                                                if _e1128 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1130 = global_7.member[_e1127];
                                                                phi_1621_ = _e1130;
                                                            } else {
                                                                phi_1621_ = 0u;
                                                            }
                                                            let _e1132 = phi_1621_;
                                                            let _e1136 = (_e1126 + _e274);
                                                            let _e1137 = (_e1136 < _e97);
                                                            if _e1137 {
                                                                if _e1137 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1139 = global_7.member[_e1136];
                                                                phi_1639_ = _e1139;
                                                            } else {
                                                                phi_1639_ = 0u;
                                                            }
                                                            let _e1141 = phi_1639_;
                                                            let _e1145 = (_e1126 + _e276);
                                                            let _e1146 = (_e1145 < _e97);
                                                            if _e1146 {
                                                                if _e1146 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1148 = global_7.member[_e1145];
                                                                phi_1657_ = _e1148;
                                                            } else {
                                                                phi_1657_ = 0u;
                                                            }
                                                            let _e1150 = phi_1657_;
                                                            let _e1155 = (_e1096 + 6u);
                                                            let _e1156 = (_e1155 + _e275);
                                                            let _e1157 = (_e1156 < _e97);
                                                            if _e1157 {
                                                                if _e1157 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1159 = global_7.member[_e1156];
                                                                phi_1677_ = _e1159;
                                                            } else {
                                                                phi_1677_ = 0u;
                                                            }
                                                            let _e1161 = phi_1677_;
                                                            let _e1165 = (_e1155 + _e274);
                                                            let _e1166 = (_e1165 < _e97);
                                                            if _e1166 {
                                                                if _e1166 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1168 = global_7.member[_e1165];
                                                                phi_1695_ = _e1168;
                                                            } else {
                                                                phi_1695_ = 0u;
                                                            }
                                                            let _e1170 = phi_1695_;
                                                            let _e1174 = (_e1155 + _e276);
                                                            let _e1175 = (_e1174 < _e97);
                                                            if _e1175 {
                                                                if _e1175 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1177 = global_7.member[_e1174];
                                                                phi_1713_ = _e1177;
                                                            } else {
                                                                phi_1713_ = 0u;
                                                            }
                                                            let _e1179 = phi_1713_;
                                                            phi_1719_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1103)) * _e149), (f32(bitcast<i32>(_e1112)) * _e149), (f32(bitcast<i32>(_e1121)) * _e149)), array<f32, 3>((f32(bitcast<i32>(_e1132)) * _e149), (f32(bitcast<i32>(_e1141)) * _e149), (f32(bitcast<i32>(_e1150)) * _e149)), array<f32, 3>((f32(bitcast<i32>(_e1161)) * _e149), (f32(bitcast<i32>(_e1170)) * _e149), (f32(bitcast<i32>(_e1179)) * _e149)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1719_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1453 = phi_1719_;
                                                    let _e1462 = (_e1453[0][2] - _e380);
                                                    let _e1465 = (((_e1453[0][0] - _e307) * _e404) - (_e1462 * _e332));
                                                    let _e1468 = (((_e1453[0][1] - _e344) * _e404) - (_e1462 * _e368));
                                                    let _e1475 = (_e1453[1][2] - _e380);
                                                    let _e1478 = (((_e1453[1][0] - _e307) * _e404) - (_e1475 * _e332));
                                                    let _e1481 = (((_e1453[1][1] - _e344) * _e404) - (_e1475 * _e368));
                                                    let _e1488 = (_e1453[2][2] - _e380);
                                                    let _e1491 = (((_e1453[2][0] - _e307) * _e404) - (_e1488 * _e332));
                                                    let _e1494 = (((_e1453[2][1] - _e344) * _e404) - (_e1488 * _e368));
                                                    let _e1495 = (_e1491 * _e1481);
                                                    let _e1496 = (_e1494 * _e1478);
                                                    let _e1497 = (_e1465 * _e1494);
                                                    let _e1498 = (_e1468 * _e1491);
                                                    let _e1499 = (_e1478 * _e1468);
                                                    let _e1500 = (_e1481 * _e1465);
                                                    let _e1505 = (((_e1495 >= _e1496) && (_e1497 >= _e1498)) && (_e1499 >= _e1500));
                                                    if (_e1505 || (((_e1495 <= _e1496) && (_e1497 <= _e1498)) && (_e1499 <= _e1500))) {
                                                        let _e1512 = select(-1f, 1f, _e1505);
                                                        let _e1514 = ((_e1495 - _e1496) * _e1512);
                                                        let _e1516 = select(0f, _e1514, (_e1514 > 0f));
                                                        let _e1518 = ((_e1497 - _e1498) * _e1512);
                                                        let _e1520 = select(0f, _e1518, (_e1518 > 0f));
                                                        let _e1522 = ((_e1499 - _e1500) * _e1512);
                                                        let _e1524 = select(0f, _e1522, (_e1522 > 0f));
                                                        let _e1526 = ((_e1516 + _e1520) + _e1524);
                                                        if (_e1526 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2544_ = type_22();
                                                            phi_2545_ = true;
                                                            phi_2546_ = false;
                                                        } else {
                                                            let _e1529 = select(_e1478, _e1465, (_e1465 < _e1478));
                                                            if (select(_e1491, _e1529, (_e1529 < _e1491)) > 0f) {
                                                                phi_1836_ = true;
                                                            } else {
                                                                let _e1534 = select(_e1478, _e1465, (_e1465 > _e1478));
                                                                phi_1836_ = (select(_e1491, _e1534, (_e1534 > _e1491)) < 0f);
                                                            }
                                                            let _e1539 = phi_1836_;
                                                            if _e1539 {
                                                                phi_2541_ = type_22();
                                                                phi_2542_ = true;
                                                                phi_2543_ = false;
                                                            } else {
                                                                let _e1541 = select(_e1481, _e1468, (_e1468 < _e1481));
                                                                if (select(_e1494, _e1541, (_e1541 < _e1494)) > 0f) {
                                                                    phi_1865_ = true;
                                                                } else {
                                                                    let _e1546 = select(_e1481, _e1468, (_e1468 > _e1481));
                                                                    phi_1865_ = (select(_e1494, _e1546, (_e1546 > _e1494)) < 0f);
                                                                }
                                                                let _e1551 = phi_1865_;
                                                                if _e1551 {
                                                                    phi_2539_ = type_22();
                                                                    phi_2540_ = false;
                                                                } else {
                                                                    let _e1553 = select(_e1453[1][0], _e1453[0][0], (_e1453[0][0] < _e1453[1][0]));
                                                                    let _e1557 = select(_e1453[1][0], _e1453[0][0], (_e1453[0][0] > _e1453[1][0]));
                                                                    let _e1561 = select(_e1453[1][1], _e1453[0][1], (_e1453[0][1] < _e1453[1][1]));
                                                                    let _e1565 = select(_e1453[1][1], _e1453[0][1], (_e1453[0][1] > _e1453[1][1]));
                                                                    let _e1569 = select(_e1453[1][2], _e1453[0][2], (_e1453[0][2] < _e1453[1][2]));
                                                                    let _e1573 = select(_e1453[1][2], _e1453[0][2], (_e1453[0][2] > _e1453[1][2]));
                                                                    let _e1578 = ((select(_e1453[2][0], _e1553, (_e1553 < _e1453[2][0])) - _e330) * _e335);
                                                                    let _e1579 = ((select(_e1453[2][0], _e1557, (_e1557 > _e1453[2][0])) - _e331) * _e335);
                                                                    let _e1582 = ((select(_e1453[2][1], _e1561, (_e1561 < _e1453[2][1])) - _e366) * _e371);
                                                                    let _e1583 = ((select(_e1453[2][1], _e1565, (_e1565 > _e1453[2][1])) - _e367) * _e371);
                                                                    let _e1586 = ((select(_e1453[2][2], _e1569, (_e1569 < _e1453[2][2])) - _e402) * _e407);
                                                                    let _e1587 = ((select(_e1453[2][2], _e1573, (_e1573 > _e1453[2][2])) - _e403) * _e407);
                                                                    let _e1589 = select(_e1587, _e1586, (_e1586 < _e1587));
                                                                    let _e1591 = select(_e1587, _e1586, (_e1586 > _e1587));
                                                                    let _e1593 = select(_e1579, _e1578, (_e1578 < _e1579));
                                                                    let _e1595 = select(_e1583, _e1582, (_e1582 < _e1583));
                                                                    let _e1597 = select(_e1595, _e1593, (_e1593 > _e1595));
                                                                    let _e1599 = select(_e1589, _e1597, (_e1597 > _e1589));
                                                                    let _e1601 = select(_e1579, _e1578, (_e1578 > _e1579));
                                                                    let _e1603 = select(_e1583, _e1582, (_e1582 > _e1583));
                                                                    let _e1605 = select(_e1603, _e1601, (_e1601 < _e1603));
                                                                    let _e1607 = select(_e1591, _e1605, (_e1605 < _e1591));
                                                                    let _e1608 = -(_e1589);
                                                                    let _e1614 = select(_e453, _e1599, (_e1599 > _e453));
                                                                    if (_e1614 > (_e1607 + (select(_e1608, _e1591, (_e1591 > _e1608)) * 0.0000019073523f))) {
                                                                        phi_2534_ = type_22();
                                                                        phi_2535_ = true;
                                                                    } else {
                                                                        let _e1616 = (_e1614 > _e1018.member.member_1);
                                                                        if _e1616 {
                                                                            phi_2533_ = type_22();
                                                                        } else {
                                                                            let _e1617 = vec3<f32>(_e1453[0][0], _e1453[0][1], _e1453[0][2]);
                                                                            let _e1618 = vec3<f32>(_e1453[1][0], _e1453[1][1], _e1453[1][2]);
                                                                            let _e1619 = vec3<f32>(_e1453[2][0], _e1453[2][1], _e1453[2][2]);
                                                                            let _e1620 = (_e1453[1][0] - _e1453[0][0]);
                                                                            let _e1621 = (_e1453[1][1] - _e1453[0][1]);
                                                                            let _e1622 = (_e1453[1][2] - _e1453[0][2]);
                                                                            let _e1623 = vec3<f32>(_e1620, _e1621, _e1622);
                                                                            let _e1624 = (_e1453[2][0] - _e1453[1][0]);
                                                                            let _e1625 = (_e1453[2][1] - _e1453[1][1]);
                                                                            let _e1626 = (_e1453[2][2] - _e1453[1][2]);
                                                                            let _e1627 = vec3<f32>(_e1624, _e1625, _e1626);
                                                                            let _e1628 = (_e1453[0][0] - _e1453[2][0]);
                                                                            let _e1629 = (_e1453[0][1] - _e1453[2][1]);
                                                                            let _e1630 = (_e1453[0][2] - _e1453[2][2]);
                                                                            let _e1631 = vec3<f32>(_e1628, _e1629, _e1630);
                                                                            let _e1634 = bitcast<f32>((bitcast<u32>(_e1620) & 2147483647u));
                                                                            let _e1637 = bitcast<f32>((bitcast<u32>(_e1621) & 2147483647u));
                                                                            let _e1639 = select(_e1637, _e1634, (_e1634 > _e1637));
                                                                            let _e1642 = bitcast<f32>((bitcast<u32>(_e1622) & 2147483647u));
                                                                            let _e1644 = select(_e1642, _e1639, (_e1639 > _e1642));
                                                                            let _e1647 = bitcast<f32>((bitcast<u32>(_e1624) & 2147483647u));
                                                                            let _e1650 = bitcast<f32>((bitcast<u32>(_e1625) & 2147483647u));
                                                                            let _e1652 = select(_e1650, _e1647, (_e1647 > _e1650));
                                                                            let _e1655 = bitcast<f32>((bitcast<u32>(_e1626) & 2147483647u));
                                                                            let _e1657 = select(_e1655, _e1652, (_e1652 > _e1655));
                                                                            let _e1660 = bitcast<f32>((bitcast<u32>(_e1628) & 2147483647u));
                                                                            let _e1663 = bitcast<f32>((bitcast<u32>(_e1629) & 2147483647u));
                                                                            let _e1665 = select(_e1663, _e1660, (_e1660 > _e1663));
                                                                            let _e1668 = bitcast<f32>((bitcast<u32>(_e1630) & 2147483647u));
                                                                            let _e1670 = select(_e1668, _e1665, (_e1665 > _e1668));
                                                                            let _e1672 = select(_e1657, _e1644, (_e1644 > _e1657));
                                                                            let _e1674 = select(_e1670, _e1672, (_e1672 > _e1670));
                                                                            if (_e1644 == _e1674) {
                                                                                phi_2266_ = _e1481;
                                                                                phi_2267_ = _e1478;
                                                                                phi_2268_ = _e1468;
                                                                                phi_2269_ = _e1465;
                                                                                phi_2270_ = _e1617;
                                                                                phi_2271_ = _e1631;
                                                                                phi_2272_ = _e1627;
                                                                                phi_2273_ = _e1623;
                                                                            } else {
                                                                                let _e1676 = (_e1657 == _e1674);
                                                                                let _e1681 = vec3(_e1676);
                                                                                phi_2266_ = select(_e1468, _e1494, _e1676);
                                                                                phi_2267_ = select(_e1465, _e1491, _e1676);
                                                                                phi_2268_ = select(_e1494, _e1481, _e1676);
                                                                                phi_2269_ = select(_e1491, _e1478, _e1676);
                                                                                phi_2270_ = select(_e1619, _e1618, _e1681);
                                                                                phi_2271_ = select(_e1627, _e1623, _e1681);
                                                                                phi_2272_ = select(_e1623, _e1631, _e1681);
                                                                                phi_2273_ = select(_e1631, _e1627, _e1681);
                                                                            }
                                                                            let _e1687 = phi_2266_;
                                                                            let _e1689 = phi_2267_;
                                                                            let _e1691 = phi_2268_;
                                                                            let _e1693 = phi_2269_;
                                                                            let _e1695 = phi_2270_;
                                                                            let _e1697 = phi_2271_;
                                                                            let _e1699 = phi_2272_;
                                                                            let _e1701 = phi_2273_;
                                                                            let _e1708 = ((_e1699.y * _e1697.z) - (_e1697.y * _e1699.z));
                                                                            let _e1713 = ((_e1699.z * _e1697.x) - (_e1697.z * _e1699.x));
                                                                            let _e1716 = ((_e1699.x * _e1697.y) - (_e1697.x * _e1699.y));
                                                                            if (_e1516 >= _e1520) {
                                                                                phi_2304_ = select(true, false, (_e1516 >= _e1524));
                                                                            } else {
                                                                                phi_2304_ = true;
                                                                            }
                                                                            let _e1721 = phi_2304_;
                                                                            if _e1721 {
                                                                                phi_2313_ = select(_e1619, _e1618, vec3((_e1520 >= _e1524)));
                                                                            } else {
                                                                                phi_2313_ = _e1617;
                                                                            }
                                                                            let _e1726 = phi_2313_;
                                                                            let _e1737 = (((_e1708 * (_e1726.x - _e307)) + (_e1713 * (_e1726.y - _e344))) + (_e1716 * (_e1726.z - _e380)));
                                                                            let _e1742 = (((_e1708 * _e332) + (_e1713 * _e368)) + (_e1716 * _e404));
                                                                            let _e1743 = (_e1689 - _e1693);
                                                                            let _e1744 = (_e1687 - _e1691);
                                                                            let _e1752 = (-(((_e1693 * _e1743) + (_e1691 * _e1744))) / ((_e1743 * _e1743) + (_e1744 * _e1744)));
                                                                            let _e1754 = select(1f, _e1752, (_e1752 < 1f));
                                                                            let _e1756 = select(0f, _e1754, (_e1754 > 0f));
                                                                            let _e1769 = ((_e1695.x + (_e1701.x * _e1756)) - _e307);
                                                                            let _e1770 = ((_e1695.y + (_e1701.y * _e1756)) - _e344);
                                                                            let _e1771 = ((_e1695.z + (_e1701.z * _e1756)) - _e380);
                                                                            let _e1772 = (_e1771 / _e404);
                                                                            let _e1784 = bitcast<f32>((bitcast<u32>(_e1769) & 2147483647u));
                                                                            let _e1787 = bitcast<f32>((bitcast<u32>(_e1770) & 2147483647u));
                                                                            let _e1789 = select(_e1787, _e1784, (_e1784 > _e1787));
                                                                            let _e1792 = bitcast<f32>((bitcast<u32>(_e1771) & 2147483647u));
                                                                            let _e1794 = select(_e1792, _e1789, (_e1789 > _e1792));
                                                                            let _e1800 = bitcast<f32>((bitcast<u32>(_e1708) & 2147483647u));
                                                                            let _e1803 = bitcast<f32>((bitcast<u32>(_e1713) & 2147483647u));
                                                                            let _e1805 = select(_e1803, _e1800, (_e1800 > _e1803));
                                                                            let _e1808 = bitcast<f32>((bitcast<u32>(_e1716) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1708 * _e1769) + (_e1713 * _e1770)) + (_e1716 * _e1771)) - _e1737)) & 2147483647u)) <= ((0.0000009536743f * select(_e1674, _e1794, (_e1794 > _e1674))) * select(_e1808, _e1805, (_e1805 > _e1808)))) {
                                                                                let _e1818 = bitcast<f32>((bitcast<u32>(_e1699.x) & 2147483647u));
                                                                                let _e1821 = bitcast<f32>((bitcast<u32>(_e1699.y) & 2147483647u));
                                                                                let _e1823 = select(_e1821, _e1818, (_e1818 > _e1821));
                                                                                let _e1826 = bitcast<f32>((bitcast<u32>(_e1699.z) & 2147483647u));
                                                                                let _e1832 = bitcast<f32>((bitcast<u32>(_e1697.x) & 2147483647u));
                                                                                let _e1835 = bitcast<f32>((bitcast<u32>(_e1697.y) & 2147483647u));
                                                                                let _e1837 = select(_e1835, _e1832, (_e1832 > _e1835));
                                                                                let _e1840 = bitcast<f32>((bitcast<u32>(_e1697.z) & 2147483647u));
                                                                                let _e1844 = (bitcast<f32>((bitcast<u32>(_e1742) & 2147483647u)) > ((0.0000038146973f * select(_e1826, _e1823, (_e1823 > _e1826))) * select(_e1840, _e1837, (_e1837 > _e1840))));
                                                                                if _e1844 {
                                                                                    phi_2478_ = (_e1737 / _e1742);
                                                                                } else {
                                                                                    phi_2478_ = f32();
                                                                                }
                                                                                let _e1847 = phi_2478_;
                                                                                phi_2480_ = _e1847;
                                                                                phi_2481_ = select(true, false, _e1844);
                                                                            } else {
                                                                                phi_2480_ = f32();
                                                                                phi_2481_ = true;
                                                                            }
                                                                            let _e1850 = phi_2480_;
                                                                            let _e1852 = phi_2481_;
                                                                            if _e1852 {
                                                                                let _e1860 = (((_e1708 * (_e1769 - (_e332 * _e1772))) + (_e1713 * (_e1770 - (_e368 * _e1772)))) / _e1742);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1860) & 2147483647u)) <= _e1674) {
                                                                                    phi_2501_ = (_e1772 + _e1860);
                                                                                } else {
                                                                                    phi_2501_ = _e1772;
                                                                                }
                                                                                let _e1867 = phi_2501_;
                                                                                phi_2502_ = _e1867;
                                                                            } else {
                                                                                phi_2502_ = _e1850;
                                                                            }
                                                                            let _e1869 = phi_2502_;
                                                                            let _e1871 = select(_e1607, _e1869, (_e1869 < _e1607));
                                                                            let _e1873 = select(_e1599, _e1871, (_e1871 > _e1599));
                                                                            if (_e1873 >= _e453) {
                                                                                let _e1875 = (_e1873 <= _e1018.member.member_1);
                                                                                if _e1875 {
                                                                                    let _e1876 = (1f / _e1526);
                                                                                    phi_2525_ = type_22(_e1873, (_e1520 * _e1876), (_e1524 * _e1876), _e1084);
                                                                                } else {
                                                                                    phi_2525_ = type_22();
                                                                                }
                                                                                let _e1881 = phi_2525_;
                                                                                phi_2527_ = _e1881;
                                                                                phi_2528_ = select(true, false, _e1875);
                                                                            } else {
                                                                                phi_2527_ = type_22();
                                                                                phi_2528_ = true;
                                                                            }
                                                                            let _e1884 = phi_2527_;
                                                                            let _e1886 = phi_2528_;
                                                                            if _e1886 {
                                                                                phi_2532_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2532_ = _e1884;
                                                                            }
                                                                            let _e1888 = phi_2532_;
                                                                            phi_2533_ = _e1888;
                                                                        }
                                                                        let _e1890 = phi_2533_;
                                                                        phi_2534_ = _e1890;
                                                                        phi_2535_ = _e1616;
                                                                    }
                                                                    let _e1892 = phi_2534_;
                                                                    let _e1894 = phi_2535_;
                                                                    phi_2539_ = _e1892;
                                                                    phi_2540_ = _e1894;
                                                                }
                                                                let _e1896 = phi_2539_;
                                                                let _e1898 = phi_2540_;
                                                                phi_2541_ = _e1896;
                                                                phi_2542_ = _e1551;
                                                                phi_2543_ = _e1898;
                                                            }
                                                            let _e1900 = phi_2541_;
                                                            let _e1902 = phi_2542_;
                                                            let _e1904 = phi_2543_;
                                                            phi_2544_ = _e1900;
                                                            phi_2545_ = _e1902;
                                                            phi_2546_ = _e1904;
                                                        }
                                                        let _e1906 = phi_2544_;
                                                        let _e1908 = phi_2545_;
                                                        let _e1910 = phi_2546_;
                                                        phi_2554_ = _e1906;
                                                        phi_2555_ = select(_e1910, true, _e1908);
                                                    } else {
                                                        phi_2554_ = type_22();
                                                        phi_2555_ = true;
                                                    }
                                                    let _e1913 = phi_2554_;
                                                    let _e1915 = phi_2555_;
                                                    if _e1915 {
                                                        phi_2559_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2559_ = _e1913;
                                                    }
                                                    let _e1917 = phi_2559_;
                                                    if (_e1917.member_3 != 4294967295u) {
                                                        if (_e1084 != _e459) {
                                                            if (_e1917.member < _e1018.member.member.member) {
                                                                phi_2585_ = true;
                                                            } else {
                                                                if (_e1917.member == _e1018.member.member.member) {
                                                                    phi_2584_ = (_e1917.member_3 < _e1018.member.member.member_3);
                                                                } else {
                                                                    phi_2584_ = false;
                                                                }
                                                                let _e1932 = phi_2584_;
                                                                phi_2585_ = _e1932;
                                                            }
                                                            let _e1934 = phi_2585_;
                                                            if _e1934 {
                                                                phi_2592_ = type_42(type_38(_e1917, _e1917.member), _e1045.member_1, _e1045.member_2);
                                                            } else {
                                                                phi_2592_ = _e1045;
                                                            }
                                                            let _e1941 = phi_2592_;
                                                            phi_2593_ = _e1941;
                                                        } else {
                                                            phi_2593_ = _e1045;
                                                        }
                                                        let _e1943 = phi_2593_;
                                                        phi_2594_ = _e1943;
                                                    } else {
                                                        phi_2594_ = _e1045;
                                                    }
                                                    let _e1945 = phi_2594_;
                                                    phi_998_ = _e1945;
                                                } else {
                                                    phi_998_ = type_42();
                                                }
                                                let _e1947 = phi_998_;
                                                continue;
                                                continuing {
                                                    phi_997_ = _e1947;
                                                    phi_1000_ = _e1033;
                                                    phi_4214_ = _e500;
                                                    break if !(_e1039);
                                                }
                                            }
                                            let _e1950 = phi_4214_;
                                            phi_4403_ = _e1950;
                                            if _e1950 {
                                                break;
                                            }
                                            phi_4407_ = _e1950;
                                            let _e2220 = local_12;
                                            phi_3837_ = _e2220;
                                            phi_3838_ = _e542;
                                            phi_3839_ = false;
                                            phi_3840_ = _e546;
                                        } else {
                                            if (_e542.member_1 >= _e94) {
                                                phi_3393_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e542.member_1 < _e94) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e565 = ((1u + _e275) % 4u);
                                                if (_e565 < 4u) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e570 = global_3.member[_e542.member_1][_e565];
                                                let _e572 = (_e570 >> bitcast<u32>(11u));
                                                let _e574 = ((1u + _e274) % 4u);
                                                if (_e574 < 4u) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e579 = global_3.member[_e542.member_1][_e574];
                                                let _e581 = (_e579 >> bitcast<u32>(11u));
                                                let _e583 = ((1u + _e276) % 4u);
                                                if (_e583 < 4u) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e588 = global_3.member[_e542.member_1][_e583];
                                                let _e590 = (_e588 >> bitcast<u32>(11u));
                                                let _e613 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.x - _e542.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e614 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.y - _e542.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e615 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.z - _e542.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e617 = select(_e149, _e613, (_e613 > _e149));
                                                let _e619 = select(_e149, _e614, (_e614 > _e149));
                                                let _e621 = select(_e149, _e615, (_e615 > _e149));
                                                let _e646 = bitcast<u32>((f32(bitcast<i32>((_e570 & 1023u))) * _e617));
                                                let _e651 = (bitcast<i32>((_e570 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e654 = bitcast<f32>((_e646 & bitcast<u32>(_e651)));
                                                let _e655 = bitcast<u32>((f32(bitcast<i32>((_e579 & 1023u))) * _e619));
                                                let _e660 = (bitcast<i32>((_e579 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e663 = bitcast<f32>((_e655 & bitcast<u32>(_e660)));
                                                let _e664 = bitcast<u32>((f32(bitcast<i32>((_e588 & 1023u))) * _e621));
                                                let _e669 = (bitcast<i32>((_e588 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e672 = bitcast<f32>((_e664 & bitcast<u32>(_e669)));
                                                let _e676 = bitcast<f32>((_e646 & bitcast<u32>(~(_e651))));
                                                let _e680 = bitcast<f32>((_e655 & bitcast<u32>(~(_e660))));
                                                let _e684 = bitcast<f32>((_e664 & bitcast<u32>(~(_e669))));
                                                let _e685 = bitcast<u32>((f32(bitcast<i32>((_e572 & 1023u))) * _e617));
                                                let _e690 = (bitcast<i32>((_e572 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e693 = bitcast<f32>((_e685 & bitcast<u32>(_e690)));
                                                let _e694 = bitcast<u32>((f32(bitcast<i32>((_e581 & 1023u))) * _e619));
                                                let _e699 = (bitcast<i32>((_e581 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e702 = bitcast<f32>((_e694 & bitcast<u32>(_e699)));
                                                let _e703 = bitcast<u32>((f32(bitcast<i32>((_e590 & 1023u))) * _e621));
                                                let _e708 = (bitcast<i32>((_e590 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e711 = bitcast<f32>((_e703 & bitcast<u32>(_e708)));
                                                let _e715 = bitcast<f32>((_e685 & bitcast<u32>(~(_e690))));
                                                let _e719 = bitcast<f32>((_e694 & bitcast<u32>(~(_e699))));
                                                let _e723 = bitcast<f32>((_e703 & bitcast<u32>(~(_e708))));
                                                let _e724 = (_e542.member.member.x + _e654);
                                                let _e725 = (_e542.member.member.y + _e663);
                                                let _e726 = (_e542.member.member.z + _e672);
                                                let _e729 = (_e542.member.member_1.x - _e693);
                                                let _e730 = (_e542.member.member_1.y - _e702);
                                                let _e731 = (_e542.member.member_1.z - _e711);
                                                let _e750 = (_e729 - _e724);
                                                let _e751 = (_e730 - _e725);
                                                let _e752 = (_e731 - _e726);
                                                let _e754 = select(_e751, _e750, (_e750 > _e751));
                                                let _e756 = select(_e752, _e754, (_e754 > _e752));
                                                if (_e756 < (1024f * _e149)) {
                                                    phi_3094_ = 0u;
                                                } else {
                                                    phi_3094_ = select(2u, 1u, (_e756 < (2097152f * _e149)));
                                                }
                                                let _e763 = phi_3094_;
                                                switch bitcast<i32>(_e763) {
                                                    case 0: {
                                                        phi_3100_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3100_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3100_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3100_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e766 = phi_3100_;
                                                let _e772 = global_3.member[_e542.member_1][0u];
                                                let _e776 = global_3.member[_e542.member_1][1u];
                                                let _e780 = global_3.member[_e542.member_1][2u];
                                                let _e784 = global_3.member[_e542.member_1][3u];
                                                let _e796 = (((_e776 >> bitcast<u32>(22i)) | ((_e780 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e784 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e797 = (_e772 & 268435455u);
                                                let _e798 = (_e796 & 268435455u);
                                                let _e801 = ((_e772 >> bitcast<u32>(28u)) & 7u);
                                                let _e809 = ((_e772 >> bitcast<u32>(31i)) | (((_e796 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e810 = (_e801 != 0u);
                                                if (_e801 == 0u) {
                                                    phi_3355_ = _e797;
                                                } else {
                                                    if (_e801 == 7u) {
                                                        phi_3354_ = 2147483648u;
                                                    } else {
                                                        phi_3354_ = ((2147483648u | (_e801 << bitcast<u32>(28u))) | (_e798 & 268435455u));
                                                    }
                                                    let _e819 = phi_3354_;
                                                    phi_3355_ = _e819;
                                                }
                                                let _e821 = phi_3355_;
                                                if _e810 {
                                                    let _e822 = (_e801 != 7u);
                                                    if _e822 {
                                                        phi_3365_ = (_e798 + (_e801 * ((3u * _e766) + 1u)));
                                                    } else {
                                                        phi_3365_ = u32();
                                                    }
                                                    let _e826 = phi_3365_;
                                                    phi_3367_ = _e826;
                                                    phi_3368_ = select(true, false, _e822);
                                                } else {
                                                    phi_3367_ = u32();
                                                    phi_3368_ = true;
                                                }
                                                let _e829 = phi_3367_;
                                                let _e831 = phi_3368_;
                                                if (_e809 == 0u) {
                                                    phi_3389_ = (_e797 + select(0u, 1u, !(_e810)));
                                                } else {
                                                    if (_e809 == 7u) {
                                                        phi_3388_ = 2147483648u;
                                                    } else {
                                                        phi_3388_ = ((2147483648u | (_e809 << bitcast<u32>(28u))) | (select(_e829, _e798, _e831) & 268435455u));
                                                    }
                                                    let _e844 = phi_3388_;
                                                    phi_3389_ = _e844;
                                                }
                                                let _e846 = phi_3389_;
                                                phi_3393_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e724, (_e542.member.member.x + _e676), _e729, (_e542.member.member_1.x - _e715)), vec4<f32>(_e725, (_e542.member.member.y + _e680), _e730, (_e542.member.member_1.y - _e719)), vec4<f32>(_e726, (_e542.member.member.z + _e684), _e731, (_e542.member.member_1.z - _e723))), type_49(type_34((_e542.member.member + vec4<f32>(_e654, _e663, _e672, 0f)), (_e542.member.member_1 - vec4<f32>(_e693, _e702, _e711, 0f))), _e821), type_49(type_34((_e542.member.member + vec4<f32>(_e676, _e680, _e684, 0f)), (_e542.member.member_1 - vec4<f32>(_e715, _e719, _e723, 0f))), _e846));
                                            }
                                            let _e851 = phi_3393_;
                                            let _e864 = ((_e851.member[0].x - _e330) * _e335);
                                            let _e865 = ((_e851.member[0].y - _e330) * _e335);
                                            let _e866 = ((_e851.member[0].z - _e331) * _e335);
                                            let _e867 = ((_e851.member[0].w - _e331) * _e335);
                                            let _e877 = ((_e851.member[1].x - _e366) * _e371);
                                            let _e878 = ((_e851.member[1].y - _e366) * _e371);
                                            let _e879 = ((_e851.member[1].z - _e367) * _e371);
                                            let _e880 = ((_e851.member[1].w - _e367) * _e371);
                                            let _e890 = ((_e851.member[2].x - _e402) * _e407);
                                            let _e891 = ((_e851.member[2].y - _e402) * _e407);
                                            let _e892 = ((_e851.member[2].z - _e403) * _e407);
                                            let _e893 = ((_e851.member[2].w - _e403) * _e407);
                                            let _e895 = select(_e892, _e890, (_e890 < _e892));
                                            let _e897 = select(_e893, _e891, (_e891 < _e893));
                                            let _e899 = select(_e892, _e890, (_e890 > _e892));
                                            let _e901 = select(_e893, _e891, (_e891 > _e893));
                                            let _e903 = select(_e866, _e864, (_e864 < _e866));
                                            let _e905 = select(_e867, _e865, (_e865 < _e867));
                                            let _e907 = select(_e879, _e877, (_e877 < _e879));
                                            let _e909 = select(_e880, _e878, (_e878 < _e880));
                                            let _e911 = select(_e907, _e903, (_e903 > _e907));
                                            let _e913 = select(_e909, _e905, (_e905 > _e909));
                                            let _e915 = select(_e895, _e911, (_e911 > _e895));
                                            let _e917 = select(_e897, _e913, (_e913 > _e897));
                                            let _e919 = select(_e866, _e864, (_e864 > _e866));
                                            let _e921 = select(_e867, _e865, (_e865 > _e867));
                                            let _e923 = select(_e879, _e877, (_e877 > _e879));
                                            let _e925 = select(_e880, _e878, (_e878 > _e880));
                                            let _e927 = select(_e923, _e919, (_e919 < _e923));
                                            let _e929 = select(_e925, _e921, (_e921 < _e925));
                                            let _e934 = -(_e895);
                                            let _e935 = -(_e897);
                                            let _e942 = (select(_e899, _e927, (_e927 < _e899)) + (select(_e934, _e899, (_e899 > _e934)) * 0.0000019073523f));
                                            let _e943 = (select(_e901, _e929, (_e929 < _e901)) + (select(_e935, _e901, (_e901 > _e935)) * 0.0000019073523f));
                                            let _e945 = select(_e453, _e915, (_e915 > _e453));
                                            let _e947 = select(_e453, _e917, (_e917 > _e453));
                                            let _e952 = (_e945 <= select(_e502.member.member_1, _e942, (_e942 < _e502.member.member_1)));
                                            let _e953 = (_e947 <= select(_e502.member.member_1, _e943, (_e943 < _e502.member.member_1)));
                                            let _e954 = (_e945 <= _e947);
                                            if _e952 {
                                                if _e953 {
                                                    if _e954 {
                                                        phi_3737_ = _e851.member_2;
                                                    } else {
                                                        phi_3737_ = _e851.member_1;
                                                    }
                                                    let _e958 = phi_3737_;
                                                    let _e980 = (_e546 % 128u);
                                                    let _e981 = (_e980 < 128u);
                                                    if _e981 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_8[_e980] = _e958.member_1;
                                                    if _e981 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_7[_e980] = _e958.member.member.x;
                                                    if _e981 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_6[_e980] = _e958.member.member.y;
                                                    if _e981 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_5[_e980] = _e958.member.member.z;
                                                    if _e981 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_4[_e980] = _e958.member.member_1.x;
                                                    if _e981 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_3[_e980] = _e958.member.member_1.y;
                                                    if _e981 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_2[_e980] = _e958.member.member_1.z;
                                                    if _e981 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_9[_e980] = select(_e947, _e945, (_e945 > _e947));
                                                    if _e954 {
                                                        phi_3814_ = _e851.member_1;
                                                    } else {
                                                        phi_3814_ = _e851.member_2;
                                                    }
                                                    let _e994 = phi_3814_;
                                                    phi_3815_ = _e994;
                                                    phi_3816_ = (_e546 + 1u);
                                                } else {
                                                    phi_3815_ = type_49();
                                                    phi_3816_ = u32();
                                                }
                                                let _e996 = phi_3815_;
                                                let _e998 = phi_3816_;
                                                phi_3818_ = _e996;
                                                phi_3819_ = _e998;
                                                phi_3820_ = select(true, false, _e953);
                                            } else {
                                                phi_3818_ = type_49();
                                                phi_3819_ = u32();
                                                phi_3820_ = true;
                                            }
                                            let _e1001 = phi_3818_;
                                            let _e1003 = phi_3819_;
                                            let _e1005 = phi_3820_;
                                            if _e1005 {
                                                if _e952 {
                                                    phi_3829_ = _e851.member_1;
                                                } else {
                                                    phi_3829_ = _e851.member_2;
                                                }
                                                let _e1009 = phi_3829_;
                                                phi_3834_ = _e1009;
                                                phi_3835_ = select(_e953, true, _e952);
                                            } else {
                                                phi_3834_ = _e1001;
                                                phi_3835_ = _e544;
                                            }
                                            let _e1012 = phi_3834_;
                                            let _e1014 = phi_3835_;
                                            phi_4407_ = _e500;
                                            phi_3837_ = type_42(_e502.member, (_e502.member_1 + 1u), _e502.member_2);
                                            phi_3838_ = _e1012;
                                            phi_3839_ = _e1014;
                                            phi_3840_ = select(_e1003, _e546, _e1005);
                                        }
                                        let _e1952 = phi_4407_;
                                        let _e1954 = phi_3837_;
                                        let _e1956 = phi_3838_;
                                        let _e1958 = phi_3839_;
                                        let _e1960 = phi_3840_;
                                        phi_4406_ = _e1952;
                                        phi_3841_ = _e1954;
                                        phi_3842_ = _e1956;
                                        phi_3843_ = (_e506 - 1u);
                                        phi_3844_ = _e1958;
                                        phi_3845_ = _e1960;
                                    } else {
                                        phi_4406_ = _e500;
                                        phi_3841_ = _e502;
                                        phi_3842_ = _e542;
                                        phi_3843_ = _e506;
                                        phi_3844_ = _e544;
                                        phi_3845_ = _e546;
                                    }
                                    let _e1962 = phi_4406_;
                                    let _e1964 = phi_3841_;
                                    let _e1966 = phi_3842_;
                                    let _e1968 = phi_3843_;
                                    let _e1970 = phi_3844_;
                                    let _e1972 = phi_3845_;
                                    phi_4405_ = _e1962;
                                    phi_3846_ = _e1964;
                                    phi_3847_ = _e1966;
                                    phi_3848_ = _e1968;
                                    phi_3849_ = _e1970;
                                    phi_3850_ = _e1972;
                                } else {
                                    phi_4405_ = _e500;
                                    phi_3846_ = type_42();
                                    phi_3847_ = type_49();
                                    phi_3848_ = u32();
                                    phi_3849_ = bool();
                                    phi_3850_ = u32();
                                }
                                let _e1974 = phi_4405_;
                                let _e1976 = phi_3846_;
                                let _e1978 = phi_3847_;
                                let _e1980 = phi_3848_;
                                let _e1982 = phi_3849_;
                                let _e1984 = phi_3850_;
                                phi_4404_ = _e1974;
                                phi_871_ = _e1976;
                                phi_874_ = _e1978;
                                phi_876_ = _e1980;
                                phi_878_ = _e1982;
                                phi_880_ = _e1984;
                                phi_3851_ = _e514;
                            } else {
                                phi_4404_ = _e500;
                                phi_871_ = type_42();
                                phi_874_ = type_49();
                                phi_876_ = u32();
                                phi_878_ = bool();
                                phi_880_ = u32();
                                phi_3851_ = false;
                            }
                            let _e1986 = phi_4404_;
                            let _e1988 = phi_871_;
                            let _e1990 = phi_874_;
                            let _e1992 = phi_876_;
                            let _e1994 = phi_878_;
                            let _e1996 = phi_880_;
                            let _e1998 = phi_3851_;
                            continue;
                            continuing {
                                phi_4220_ = _e1986;
                                phi_870_ = _e1988;
                                phi_873_ = _e1990;
                                phi_875_ = _e1992;
                                phi_877_ = _e1994;
                                phi_879_ = _e1996;
                                phi_4403_ = _e1986;
                                break if !(_e1998);
                            }
                        }
                        let _e2001 = phi_4403_;
                        if _e2001 {
                            break;
                        }
                        let _e2003 = local_10;
                        if (_e2003.member.member.member_3 != 4294967295u) {
                            let _e2009 = (_e277 / 3i);
                            let _e2016 = bitcast<f32>((bitcast<u32>((_e2009 + 127i)) << bitcast<u32>(23i)));
                            let _e2024 = (((_e2003.member.member.member * _e2016) * _e2016) * bitcast<f32>((bitcast<u32>(((_e277 - (2i * _e2009)) + 127i)) << bitcast<u32>(23i))));
                            let _e2026 = select(340282350000000000000000000000000000000f, _e2024, (_e2024 < 340282350000000000000000000000000000000f));
                            phi_3903_ = type_22(select(-340282350000000000000000000000000000000f, _e2026, (_e2026 > -340282350000000000000000000000000000000f)), _e2003.member.member.member_1, _e2003.member.member.member_2, _e2003.member.member.member_3);
                        } else {
                            phi_3903_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2033 = phi_3903_;
                        if _e153 {
                        } else {
                            break;
                        }
                        global_1.member[_e137] = _e2033;
                        let _e2037 = local_11;
                        if _e154 {
                        } else {
                            break;
                        }
                        global_5.member[_e137] = _e2037.member_1;
                        if _e152 {
                        } else {
                            break;
                        }
                        let _e2042 = select(0u, 1u, (_e221 <= _e231));
                        if (_e2042 > 0u) {
                            let _e2044 = (1u < _e105);
                            if _e2044 {
                                if (0u < _e105) {
                                } else {
                                    break;
                                }
                                let _e2048 = atomicAdd((&global_6.member[0u]), _e2042);
                                if ((_e2048 + _e2042) < _e2048) {
                                    if _e2044 {
                                    } else {
                                        break;
                                    }
                                    let _e2053 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2056 = select(0u, 1u, (_e2033.member_3 != 4294967295u));
                        if (_e2056 > 0u) {
                            let _e2058 = (3u < _e105);
                            if _e2058 {
                                if (2u < _e105) {
                                } else {
                                    break;
                                }
                                let _e2062 = atomicAdd((&global_6.member[2u]), _e2056);
                                if ((_e2062 + _e2056) < _e2062) {
                                    if _e2058 {
                                    } else {
                                        break;
                                    }
                                    let _e2067 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2037.member_1 > 0u) {
                            let _e2069 = (5u < _e105);
                            if _e2069 {
                                if (4u < _e105) {
                                } else {
                                    break;
                                }
                                let _e2073 = atomicAdd((&global_6.member[4u]), _e2037.member_1);
                                if ((_e2073 + _e2037.member_1) < _e2073) {
                                    if _e2069 {
                                    } else {
                                        break;
                                    }
                                    let _e2078 = atomicAdd((&global_6.member[5u]), 1u);
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
