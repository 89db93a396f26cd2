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

struct type_34 {
    member: type_18,
    member_1: f32,
}

struct type_38 {
    member: type_34,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<array<u32, 7>>,
}

struct type_49 {
    member: type_30,
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
var<storage, read_write> global_1: type_20;
@group(0) @binding(0) 
var<uniform> global_2: type_40;
@group(0) @binding(3) 
var<storage> global_3: type_25;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_55;
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
    var phi_402_: i32;
    var phi_403_: i32;
    var phi_413_: bool;
    var phi_423_: u32;
    var phi_424_: u32;
    var phi_426_: bool;
    var phi_431_: u32;
    var phi_463_: i32;
    var phi_481_: f32;
    var phi_487_: f32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_527_: f32;
    var phi_538_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_593_: f32;
    var phi_604_: f32;
    var phi_613_: f32;
    var phi_619_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_659_: f32;
    var phi_670_: f32;
    var phi_770_: f32;
    var phi_771_: f32;
    var phi_4222_: bool;
    var phi_869_: type_38;
    var phi_872_: type_49;
    var phi_874_: u32;
    var phi_876_: bool;
    var phi_878_: u32;
    var phi_889_: bool;
    var phi_975_: type_49;
    var phi_976_: bool;
    var phi_977_: u32;
    var phi_3096_: u32;
    var phi_3102_: u32;
    var phi_3356_: u32;
    var phi_3357_: u32;
    var phi_3367_: u32;
    var phi_3369_: u32;
    var phi_3370_: bool;
    var phi_3390_: u32;
    var phi_3391_: u32;
    var phi_3395_: type_50;
    var phi_3739_: type_49;
    var phi_3816_: type_49;
    var phi_3817_: type_49;
    var phi_3818_: u32;
    var phi_3820_: type_49;
    var phi_3821_: u32;
    var phi_3822_: bool;
    var phi_3831_: type_49;
    var phi_3836_: type_49;
    var phi_3837_: bool;
    var phi_996_: type_38;
    var phi_999_: type_8;
    var phi_1000_: type_8;
    var phi_1022_: type_8;
    var phi_1066_: u32;
    var phi_1072_: u32;
    var phi_1082_: u32;
    var phi_1098_: u32;
    var phi_1131_: u32;
    var phi_1137_: u32;
    var phi_1564_: u32;
    var phi_1582_: u32;
    var phi_1600_: u32;
    var phi_1620_: u32;
    var phi_1638_: u32;
    var phi_1656_: u32;
    var phi_1676_: u32;
    var phi_1694_: u32;
    var phi_1712_: u32;
    var phi_1290_: u32;
    var phi_1305_: u32;
    var phi_1315_: u32;
    var phi_1335_: u32;
    var phi_1355_: u32;
    var phi_1381_: u32;
    var phi_1396_: u32;
    var phi_1406_: u32;
    var phi_1426_: u32;
    var phi_1446_: u32;
    var phi_1472_: u32;
    var phi_1487_: u32;
    var phi_1497_: u32;
    var phi_1517_: u32;
    var phi_1537_: u32;
    var phi_1161_: u32;
    var phi_1204_: u32;
    var phi_1247_: u32;
    var phi_1718_: array<array<f32, 3>, 3>;
    var phi_1835_: bool;
    var phi_1864_: bool;
    var phi_2265_: f32;
    var phi_2266_: f32;
    var phi_2267_: f32;
    var phi_2268_: f32;
    var phi_2269_: vec3<f32>;
    var phi_2270_: vec3<f32>;
    var phi_2271_: vec3<f32>;
    var phi_2272_: vec3<f32>;
    var phi_2303_: bool;
    var phi_2312_: vec3<f32>;
    var phi_2479_: bool;
    var phi_2503_: f32;
    var phi_2504_: f32;
    var phi_2527_: type_18;
    var phi_2529_: type_18;
    var phi_2530_: bool;
    var phi_2534_: type_18;
    var phi_2535_: type_18;
    var phi_2536_: type_18;
    var phi_2537_: bool;
    var phi_2541_: type_18;
    var phi_2542_: bool;
    var phi_2543_: type_18;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2546_: type_18;
    var phi_2547_: bool;
    var phi_2548_: bool;
    var phi_2556_: type_18;
    var phi_2557_: bool;
    var phi_2561_: type_18;
    var phi_2586_: bool;
    var phi_2587_: bool;
    var phi_2594_: type_38;
    var phi_2595_: type_38;
    var phi_2596_: type_38;
    var phi_997_: type_38;
    var phi_4216_: bool;
    var phi_4409_: bool;
    var phi_3839_: type_38;
    var phi_3840_: type_49;
    var phi_3841_: bool;
    var phi_3842_: u32;
    var phi_4408_: bool;
    var phi_3843_: type_38;
    var phi_3844_: type_49;
    var phi_3845_: u32;
    var phi_3846_: bool;
    var phi_3847_: u32;
    var phi_4407_: bool;
    var phi_3848_: type_38;
    var phi_3849_: type_49;
    var phi_3850_: u32;
    var phi_3851_: bool;
    var phi_3852_: u32;
    var phi_4406_: bool;
    var phi_870_: type_38;
    var phi_873_: type_49;
    var phi_875_: u32;
    var phi_877_: bool;
    var phi_879_: u32;
    var phi_3853_: bool;
    var phi_4405_: bool;
    var local_10: type_38;
    var phi_3905_: type_18;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_6.member));
            let _e93 = arrayLength((&global_7.member));
            let _e101 = arrayLength((&global_5.member));
            let _e105 = global_2.member[0u][0u];
            let _e109 = global_2.member[0u][1u];
            let _e113 = global_2.member[0u][2u];
            let _e117 = global_2.member[0u][3u];
            let _e121 = global_2.member[1u][0u];
            let _e125 = global_2.member[1u][1u];
            let _e129 = global_2.member[1u][2u];
            let _e133 = (_e88.x + (_e88.y * 2097152u));
            let _e145 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e117) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e105), bitcast<i32>(_e109), bitcast<i32>(_e113));
            local = array<i32, 3>(bitcast<i32>(_e121), bitcast<i32>(_e125), bitcast<i32>(_e129));
            let _e148 = (_e133 < arrayLength((&global_3.member)));
            if _e148 {
                let _e149 = (_e133 < arrayLength((&global_1.member)));
                if _e149 {
                    let _e150 = (_e133 < arrayLength((&global_4.member)));
                    if _e150 {
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e160 = global_3.member[_e133].member.member_2[0u];
                        let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                        let _e168 = global_3.member[_e133].member.member_2[1u];
                        let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                        let _e176 = global_3.member[_e133].member.member_2[2u];
                        let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                        let _e184 = global_3.member[_e133].member.member[0u];
                        let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                        let _e192 = global_3.member[_e133].member.member[1u];
                        let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                        let _e200 = global_3.member[_e133].member.member[2u];
                        let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                        let _e204 = select(_e170, _e162, (_e170 < _e162));
                        let _e206 = select(_e178, _e204, (_e178 < _e204));
                        let _e208 = select(_e186, _e206, (_e186 < _e206));
                        let _e210 = select(_e194, _e208, (_e194 < _e208));
                        let _e212 = select(_e202, _e210, (_e202 < _e210));
                        let _e217 = global_3.member[_e133].member.member_1;
                        let _e219 = (bitcast<u32>(_e217) & 2147483647u);
                        let _e227 = global_3.member[_e133].member.member_3;
                        let _e233 = (((select(_e219, _e212, (_e219 < _e212)) < 2139095040u) && ((bitcast<u32>(_e227) & 2147483647u) <= 2139095040u)) && (_e206 > 0u));
                        if _e233 {
                            let _e236 = (bitcast<u32>(bitcast<f32>(_e206)) & 2147483647u);
                            if (_e236 >= 8388608u) {
                                phi_402_ = (bitcast<i32>((_e236 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_402_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e236)), 32u, (_e236 == 0u))));
                            }
                            let _e250 = phi_402_;
                            phi_403_ = _e250;
                        } else {
                            phi_403_ = 0i;
                        }
                        let _e252 = phi_403_;
                        let _e253 = (_e162 == _e206);
                        if _e253 {
                            phi_413_ = true;
                        } else {
                            phi_413_ = (_e170 == _e206);
                        }
                        let _e256 = phi_413_;
                        let _e257 = select(1u, 0u, _e253);
                        if _e256 {
                            let _e258 = (_e257 + 1u);
                            phi_423_ = _e258;
                            phi_424_ = _e258;
                            phi_426_ = select(true, false, (_e258 == 2u));
                        } else {
                            phi_423_ = u32();
                            phi_424_ = 0u;
                            phi_426_ = true;
                        }
                        let _e262 = phi_423_;
                        let _e264 = phi_424_;
                        let _e266 = phi_426_;
                        if _e266 {
                            phi_431_ = (_e264 + 1u);
                        } else {
                            phi_431_ = 0u;
                        }
                        let _e270 = phi_431_;
                        let _e271 = select(_e262, _e264, _e266);
                        let _e272 = select(_e257, select(2u, _e257, _e256), _e266);
                        let _e273 = -(_e252);
                        if (_e273 < -126i) {
                            phi_463_ = -126i;
                        } else {
                            phi_463_ = select(_e273, 127i, (_e273 > 127i));
                        }
                        let _e278 = phi_463_;
                        let _e283 = bitcast<f32>((bitcast<u32>((_e278 + 127i)) << bitcast<u32>(23i)));
                        let _e289 = bitcast<f32>((bitcast<u32>(((_e273 - _e278) + 127i)) << bitcast<u32>(23i)));
                        let _e294 = global_3.member[_e133].member.member;
                        let _e295 = (_e271 == 0u);
                        if _e295 {
                            phi_481_ = _e294[0];
                        } else {
                            phi_481_ = _e294[1];
                        }
                        let _e299 = phi_481_;
                        let _e300 = (_e271 == 2u);
                        if _e300 {
                            phi_487_ = _e294[2];
                        } else {
                            phi_487_ = _e299;
                        }
                        let _e303 = phi_487_;
                        let _e304 = global_3.member[_e133].member.member_2;
                        if _e295 {
                            phi_498_ = _e304[0];
                        } else {
                            phi_498_ = _e304[1];
                        }
                        let _e308 = phi_498_;
                        if _e300 {
                            phi_504_ = _e304[2];
                        } else {
                            phi_504_ = _e308;
                        }
                        let _e311 = phi_504_;
                        let _e313 = ((_e311 * _e283) * _e289);
                        let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e317 {
                            let _e321 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) * 0.00000011920929f);
                            phi_527_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                        } else {
                            phi_527_ = 0f;
                        }
                        let _e325 = phi_527_;
                        let _e326 = (_e303 + _e325);
                        let _e327 = (_e303 - _e325);
                        let _e328 = select(_e313, 0f, _e317);
                        if _e317 {
                            phi_538_ = 38685626000000000000000000f;
                        } else {
                            phi_538_ = (1f / _e313);
                        }
                        let _e331 = phi_538_;
                        let _e332 = (_e270 == 0u);
                        if _e332 {
                            phi_547_ = _e294[0];
                        } else {
                            phi_547_ = _e294[1];
                        }
                        let _e336 = phi_547_;
                        let _e337 = (_e270 == 2u);
                        if _e337 {
                            phi_553_ = _e294[2];
                        } else {
                            phi_553_ = _e336;
                        }
                        let _e340 = phi_553_;
                        if _e332 {
                            phi_564_ = _e304[0];
                        } else {
                            phi_564_ = _e304[1];
                        }
                        let _e344 = phi_564_;
                        if _e337 {
                            phi_570_ = _e304[2];
                        } else {
                            phi_570_ = _e344;
                        }
                        let _e347 = phi_570_;
                        let _e349 = ((_e347 * _e283) * _e289);
                        let _e353 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e353 {
                            let _e357 = (bitcast<f32>((bitcast<u32>(_e340) & 2147483647u)) * 0.00000011920929f);
                            phi_593_ = select(0.00000000000011368684f, _e357, (_e357 > 0.00000000000011368684f));
                        } else {
                            phi_593_ = 0f;
                        }
                        let _e361 = phi_593_;
                        let _e362 = (_e340 + _e361);
                        let _e363 = (_e340 - _e361);
                        let _e364 = select(_e349, 0f, _e353);
                        if _e353 {
                            phi_604_ = 38685626000000000000000000f;
                        } else {
                            phi_604_ = (1f / _e349);
                        }
                        let _e367 = phi_604_;
                        let _e368 = (_e272 == 0u);
                        if _e368 {
                            phi_613_ = _e294[0];
                        } else {
                            phi_613_ = _e294[1];
                        }
                        let _e372 = phi_613_;
                        let _e373 = (_e272 == 2u);
                        if _e373 {
                            phi_619_ = _e294[2];
                        } else {
                            phi_619_ = _e372;
                        }
                        let _e376 = phi_619_;
                        if _e368 {
                            phi_630_ = _e304[0];
                        } else {
                            phi_630_ = _e304[1];
                        }
                        let _e380 = phi_630_;
                        if _e373 {
                            phi_636_ = _e304[2];
                        } else {
                            phi_636_ = _e380;
                        }
                        let _e383 = phi_636_;
                        let _e385 = ((_e383 * _e283) * _e289);
                        let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e389 {
                            let _e393 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                            phi_659_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                        } else {
                            phi_659_ = 0f;
                        }
                        let _e397 = phi_659_;
                        let _e398 = (_e376 + _e397);
                        let _e399 = (_e376 - _e397);
                        let _e400 = select(_e385, 0f, _e389);
                        if _e389 {
                            phi_670_ = 38685626000000000000000000f;
                        } else {
                            phi_670_ = (1f / _e385);
                        }
                        let _e403 = phi_670_;
                        let _e406 = bitcast<f32>((bitcast<u32>(_e303) & 2147483647u));
                        let _e409 = bitcast<f32>((bitcast<u32>(_e340) & 2147483647u));
                        let _e411 = select(_e409, _e406, (_e406 > _e409));
                        let _e414 = bitcast<f32>((bitcast<u32>(_e376) & 2147483647u));
                        if (_e233 && (select(_e414, _e411, (_e411 > _e414)) <= 1099511600000f)) {
                            let _e419 = (_e252 / 3i);
                            let _e426 = bitcast<f32>((bitcast<u32>((_e419 + 127i)) << bitcast<u32>(23i)));
                            let _e433 = bitcast<f32>((bitcast<u32>(((_e252 - (2i * _e419)) + 127i)) << bitcast<u32>(23i)));
                            let _e434 = (((_e217 * _e426) * _e426) * _e433);
                            let _e436 = select(340282350000000000000000000000000000000f, _e434, (_e434 < 340282350000000000000000000000000000000f));
                            let _e441 = (((_e227 * _e426) * _e426) * _e433);
                            let _e443 = select(340282350000000000000000000000000000000f, _e441, (_e441 < 340282350000000000000000000000000000000f));
                            phi_770_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                            phi_771_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_770_ = 0f;
                            phi_771_ = 1f;
                        }
                        let _e447 = phi_770_;
                        let _e449 = phi_771_;
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e455 = global_3.member[_e133].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e458 = (_e271 % 3u);
                        let _e459 = (_e458 < 3u);
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e461 = local_1[_e458];
                        let _e464 = (_e270 % 3u);
                        let _e465 = (_e464 < 3u);
                        if _e465 {
                        } else {
                            break;
                        }
                        let _e467 = local_1[_e464];
                        let _e470 = (_e272 % 3u);
                        let _e471 = (_e470 < 3u);
                        if _e471 {
                        } else {
                            break;
                        }
                        let _e473 = local_1[_e470];
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e478 = local[_e458];
                        if _e465 {
                        } else {
                            break;
                        }
                        let _e482 = local[_e464];
                        if _e471 {
                        } else {
                            break;
                        }
                        let _e486 = local[_e470];
                        phi_4222_ = false;
                        phi_869_ = type_38(type_34(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e447), 0u, 0u);
                        phi_872_ = type_49(type_30(vec4<f32>((f32(_e461) * _e145), (f32(_e467) * _e145), (f32(_e473) * _e145), 0f), vec4<f32>((f32(_e478) * _e145), (f32(_e482) * _e145), (f32(_e486) * _e145), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                        phi_874_ = ((3u * _e90) + 1u);
                        phi_876_ = (_e449 <= _e447);
                        phi_878_ = 0u;
                        loop {
                            let _e496 = phi_4222_;
                            let _e498 = phi_869_;
                            let _e500 = phi_872_;
                            let _e502 = phi_874_;
                            let _e504 = phi_876_;
                            let _e506 = phi_878_;
                            local_10 = _e498;
                            local_11 = _e498;
                            if _e504 {
                                phi_889_ = true;
                            } else {
                                phi_889_ = (_e506 > 0u);
                            }
                            let _e509 = phi_889_;
                            if _e509 {
                                let _e510 = (_e502 > 0u);
                                if _e510 {
                                    if _e504 {
                                        phi_975_ = _e500;
                                        phi_976_ = _e504;
                                        phi_977_ = _e506;
                                    } else {
                                        let _e511 = (_e506 - 1u);
                                        let _e512 = (_e511 % 128u);
                                        let _e513 = (_e512 < 128u);
                                        if _e513 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e515 = local_7[_e512];
                                        if _e513 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e517 = local_6[_e512];
                                        if _e513 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e519 = local_5[_e512];
                                        if _e513 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e521 = local_4[_e512];
                                        if _e513 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e523 = local_3[_e512];
                                        if _e513 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e525 = local_2[_e512];
                                        if _e513 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e530 = local_8[_e512];
                                        if _e513 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e533 = local_9[_e512];
                                        phi_975_ = type_49(type_30(vec4<f32>(_e515, _e517, _e519, 0f), vec4<f32>(_e521, _e523, _e525, 0f)), _e530);
                                        phi_976_ = (_e533 <= _e498.member.member_1);
                                        phi_977_ = _e511;
                                    }
                                    let _e538 = phi_975_;
                                    let _e540 = phi_976_;
                                    let _e542 = phi_977_;
                                    if _e540 {
                                        let _e547 = (_e538.member_1 & 268435455u);
                                        if ((_e538.member_1 & 2147483648u) != 0u) {
                                            phi_996_ = _e498;
                                            phi_999_ = type_8(0u, ((_e538.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1032 = phi_996_;
                                                let _e1034 = phi_999_;
                                                local_12 = _e1032;
                                                if (_e1034.member < _e1034.member_1) {
                                                    phi_1000_ = type_8((_e1034.member + 1u), _e1034.member_1);
                                                    phi_1022_ = type_8(1u, _e1034.member);
                                                } else {
                                                    phi_1000_ = _e1034;
                                                    phi_1022_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1047 = phi_1000_;
                                                let _e1049 = phi_1022_;
                                                let _e1053 = (bitcast<i32>(_e1049.member) != 0i);
                                                if _e1053 {
                                                    let _e1059 = type_38(_e1032.member, _e1032.member_1, (_e1032.member_2 + 1u));
                                                    let _e1064 = (_e538.member.member_1.x - _e538.member.member.x);
                                                    let _e1067 = (_e538.member.member_1.y - _e538.member.member.y);
                                                    let _e1070 = (_e538.member.member_1.z - _e538.member.member.z);
                                                    let _e1072 = select(_e1067, _e1064, (_e1064 > _e1067));
                                                    let _e1074 = select(_e1070, _e1072, (_e1072 > _e1070));
                                                    let _e1076 = (_e1074 < (1024f * _e145));
                                                    if _e1076 {
                                                        phi_1066_ = 0u;
                                                    } else {
                                                        phi_1066_ = select(2u, 1u, (_e1074 < (2097152f * _e145)));
                                                    }
                                                    let _e1081 = phi_1066_;
                                                    switch bitcast<i32>(_e1081) {
                                                        case 0: {
                                                            phi_1072_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1072_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1072_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1072_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1084 = phi_1072_;
                                                    switch bitcast<i32>(_e1081) {
                                                        case 0: {
                                                            phi_1082_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1082_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1082_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1082_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1091 = phi_1082_;
                                                    let _e1093 = ((_e547 + (_e1049.member_1 * ((3u * _e1084) + 1u))) + (3u * _e1091));
                                                    let _e1094 = (_e1093 < _e93);
                                                    if _e1094 {
                                                        if _e1094 {
                                                        } else {
                                                            phi_4216_ = true;
                                                            break;
                                                        }
                                                        let _e1096 = global_7.member[_e1093];
                                                        phi_1098_ = _e1096;
                                                    } else {
                                                        phi_1098_ = 4294967295u;
                                                    }
                                                    let _e1098 = phi_1098_;
                                                    if _e1076 {
                                                        phi_1131_ = 0u;
                                                    } else {
                                                        phi_1131_ = select(2u, 1u, (_e1074 < (2097152f * _e145)));
                                                    }
                                                    let _e1103 = phi_1131_;
                                                    switch bitcast<i32>(_e1103) {
                                                        case 0: {
                                                            phi_1137_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1137_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1137_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1137_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1106 = phi_1137_;
                                                    let _e1110 = (_e547 + (_e1049.member_1 * ((3u * _e1106) + 1u)));
                                                    switch bitcast<i32>(_e1103) {
                                                        case 0: {
                                                            let _e1376 = (_e1110 < _e93);
                                                            if _e1376 {
                                                                if _e1376 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1378 = global_7.member[_e1110];
                                                                phi_1161_ = _e1378;
                                                            } else {
                                                                phi_1161_ = 0u;
                                                            }
                                                            let _e1380 = phi_1161_;
                                                            let _e1382 = ((10u * _e271) & 31u);
                                                            let _e1391 = ((10u * _e270) & 31u);
                                                            let _e1400 = ((10u * _e272) & 31u);
                                                            let _e1409 = (_e1110 + 1u);
                                                            let _e1410 = (_e1409 < _e93);
                                                            if _e1410 {
                                                                if _e1410 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1412 = global_7.member[_e1409];
                                                                phi_1204_ = _e1412;
                                                            } else {
                                                                phi_1204_ = 0u;
                                                            }
                                                            let _e1414 = phi_1204_;
                                                            let _e1437 = (_e1110 + 2u);
                                                            let _e1438 = (_e1437 < _e93);
                                                            if _e1438 {
                                                                if _e1438 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1440 = global_7.member[_e1437];
                                                                phi_1247_ = _e1440;
                                                            } else {
                                                                phi_1247_ = 0u;
                                                            }
                                                            let _e1442 = phi_1247_;
                                                            phi_1718_ = array<array<f32, 3>, 3>(array<f32, 3>((_e538.member.member.x + (f32(bitcast<i32>(((_e1380 >> bitcast<u32>(_e1382)) & 1023u))) * _e145)), (_e538.member.member.y + (f32(bitcast<i32>(((_e1380 >> bitcast<u32>(_e1391)) & 1023u))) * _e145)), (_e538.member.member.z + (f32(bitcast<i32>(((_e1380 >> bitcast<u32>(_e1400)) & 1023u))) * _e145))), array<f32, 3>((_e538.member.member.x + (f32(bitcast<i32>(((_e1414 >> bitcast<u32>(_e1382)) & 1023u))) * _e145)), (_e538.member.member.y + (f32(bitcast<i32>(((_e1414 >> bitcast<u32>(_e1391)) & 1023u))) * _e145)), (_e538.member.member.z + (f32(bitcast<i32>(((_e1414 >> bitcast<u32>(_e1400)) & 1023u))) * _e145))), array<f32, 3>((_e538.member.member.x + (f32(bitcast<i32>(((_e1442 >> bitcast<u32>(_e1382)) & 1023u))) * _e145)), (_e538.member.member.y + (f32(bitcast<i32>(((_e1442 >> bitcast<u32>(_e1391)) & 1023u))) * _e145)), (_e538.member.member.z + (f32(bitcast<i32>(((_e1442 >> bitcast<u32>(_e1400)) & 1023u))) * _e145))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1199 = (_e1110 < _e93);
                                                            if _e1199 {
                                                                if _e1199 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1201 = global_7.member[_e1110];
                                                                phi_1290_ = _e1201;
                                                            } else {
                                                                phi_1290_ = 0u;
                                                            }
                                                            let _e1203 = phi_1290_;
                                                            let _e1204 = (_e1110 + 1u);
                                                            let _e1205 = (_e1204 < _e93);
                                                            if _e1205 {
                                                                if _e1205 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1207 = global_7.member[_e1204];
                                                                phi_1305_ = _e1207;
                                                            } else {
                                                                phi_1305_ = 0u;
                                                            }
                                                            let _e1209 = phi_1305_;
                                                            let _e1210 = (_e271 == 1u);
                                                            if _e1210 {
                                                                phi_1315_ = ((_e1203 >> bitcast<u32>(21i)) | (_e1209 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1315_ = (_e1209 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1219 = phi_1315_;
                                                            let _e1226 = (_e270 == 1u);
                                                            if _e1226 {
                                                                phi_1335_ = ((_e1203 >> bitcast<u32>(21i)) | (_e1209 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1335_ = (_e1209 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1235 = phi_1335_;
                                                            let _e1242 = (_e272 == 1u);
                                                            if _e1242 {
                                                                phi_1355_ = ((_e1203 >> bitcast<u32>(21i)) | (_e1209 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1355_ = (_e1209 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1251 = phi_1355_;
                                                            let _e1259 = (_e1110 + 2u);
                                                            let _e1260 = (_e1259 < _e93);
                                                            if _e1260 {
                                                                if _e1260 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1262 = global_7.member[_e1259];
                                                                phi_1381_ = _e1262;
                                                            } else {
                                                                phi_1381_ = 0u;
                                                            }
                                                            let _e1264 = phi_1381_;
                                                            let _e1265 = (_e1110 + 3u);
                                                            let _e1266 = (_e1265 < _e93);
                                                            if _e1266 {
                                                                if _e1266 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1268 = global_7.member[_e1265];
                                                                phi_1396_ = _e1268;
                                                            } else {
                                                                phi_1396_ = 0u;
                                                            }
                                                            let _e1270 = phi_1396_;
                                                            if _e1210 {
                                                                phi_1406_ = ((_e1264 >> bitcast<u32>(21i)) | (_e1270 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1406_ = (_e1270 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1279 = phi_1406_;
                                                            if _e1226 {
                                                                phi_1426_ = ((_e1264 >> bitcast<u32>(21i)) | (_e1270 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1426_ = (_e1270 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1294 = phi_1426_;
                                                            if _e1242 {
                                                                phi_1446_ = ((_e1264 >> bitcast<u32>(21i)) | (_e1270 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1446_ = (_e1270 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1309 = phi_1446_;
                                                            let _e1317 = (_e1110 + 4u);
                                                            let _e1318 = (_e1317 < _e93);
                                                            if _e1318 {
                                                                if _e1318 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1320 = global_7.member[_e1317];
                                                                phi_1472_ = _e1320;
                                                            } else {
                                                                phi_1472_ = 0u;
                                                            }
                                                            let _e1322 = phi_1472_;
                                                            let _e1323 = (_e1110 + 5u);
                                                            let _e1324 = (_e1323 < _e93);
                                                            if _e1324 {
                                                                if _e1324 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1326 = global_7.member[_e1323];
                                                                phi_1487_ = _e1326;
                                                            } else {
                                                                phi_1487_ = 0u;
                                                            }
                                                            let _e1328 = phi_1487_;
                                                            if _e1210 {
                                                                phi_1497_ = ((_e1322 >> bitcast<u32>(21i)) | (_e1328 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1497_ = (_e1328 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1337 = phi_1497_;
                                                            if _e1226 {
                                                                phi_1517_ = ((_e1322 >> bitcast<u32>(21i)) | (_e1328 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1517_ = (_e1328 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1352 = phi_1517_;
                                                            if _e1242 {
                                                                phi_1537_ = ((_e1322 >> bitcast<u32>(21i)) | (_e1328 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1537_ = (_e1328 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1367 = phi_1537_;
                                                            phi_1718_ = array<array<f32, 3>, 3>(array<f32, 3>((_e538.member.member.x + (f32(bitcast<i32>((select(_e1219, _e1203, _e295) & 2097151u))) * _e145)), (_e538.member.member.y + (f32(bitcast<i32>((select(_e1235, _e1203, _e332) & 2097151u))) * _e145)), (_e538.member.member.z + (f32(bitcast<i32>((select(_e1251, _e1203, _e368) & 2097151u))) * _e145))), array<f32, 3>((_e538.member.member.x + (f32(bitcast<i32>((select(_e1279, _e1264, _e295) & 2097151u))) * _e145)), (_e538.member.member.y + (f32(bitcast<i32>((select(_e1294, _e1264, _e332) & 2097151u))) * _e145)), (_e538.member.member.z + (f32(bitcast<i32>((select(_e1309, _e1264, _e368) & 2097151u))) * _e145))), array<f32, 3>((_e538.member.member.x + (f32(bitcast<i32>((select(_e1337, _e1322, _e295) & 2097151u))) * _e145)), (_e538.member.member.y + (f32(bitcast<i32>((select(_e1352, _e1322, _e332) & 2097151u))) * _e145)), (_e538.member.member.z + (f32(bitcast<i32>((select(_e1367, _e1322, _e368) & 2097151u))) * _e145))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1112 = (_e1110 + _e271);
                                                            let _e1113 = (_e1112 < _e93);
                                                            if _e1113 {
                                                                if _e1113 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1115 = global_7.member[_e1112];
                                                                phi_1564_ = _e1115;
                                                            } else {
                                                                phi_1564_ = 0u;
                                                            }
                                                            let _e1117 = phi_1564_;
                                                            let _e1121 = (_e1110 + _e270);
                                                            let _e1122 = (_e1121 < _e93);
                                                            if _e1122 {
                                                                if _e1122 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1124 = global_7.member[_e1121];
                                                                phi_1582_ = _e1124;
                                                            } else {
                                                                phi_1582_ = 0u;
                                                            }
                                                            let _e1126 = phi_1582_;
                                                            let _e1130 = (_e1110 + _e272);
                                                            let _e1131 = (_e1130 < _e93);
                                                            if _e1131 {
                                                                if _e1131 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1133 = global_7.member[_e1130];
                                                                phi_1600_ = _e1133;
                                                            } else {
                                                                phi_1600_ = 0u;
                                                            }
                                                            let _e1135 = phi_1600_;
                                                            let _e1140 = (_e1110 + 3u);
                                                            let _e1141 = (_e1140 + _e271);
                                                            let _e1142 = (_e1141 < _e93);
                                                            if _e1142 {
                                                                if _e1142 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1144 = global_7.member[_e1141];
                                                                phi_1620_ = _e1144;
                                                            } else {
                                                                phi_1620_ = 0u;
                                                            }
                                                            let _e1146 = phi_1620_;
                                                            let _e1150 = (_e1140 + _e270);
                                                            let _e1151 = (_e1150 < _e93);
                                                            if _e1151 {
                                                                if _e1151 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1153 = global_7.member[_e1150];
                                                                phi_1638_ = _e1153;
                                                            } else {
                                                                phi_1638_ = 0u;
                                                            }
                                                            let _e1155 = phi_1638_;
                                                            let _e1159 = (_e1140 + _e272);
                                                            let _e1160 = (_e1159 < _e93);
                                                            if _e1160 {
                                                                if _e1160 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1162 = global_7.member[_e1159];
                                                                phi_1656_ = _e1162;
                                                            } else {
                                                                phi_1656_ = 0u;
                                                            }
                                                            let _e1164 = phi_1656_;
                                                            let _e1169 = (_e1110 + 6u);
                                                            let _e1170 = (_e1169 + _e271);
                                                            let _e1171 = (_e1170 < _e93);
                                                            if _e1171 {
                                                                if _e1171 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1173 = global_7.member[_e1170];
                                                                phi_1676_ = _e1173;
                                                            } else {
                                                                phi_1676_ = 0u;
                                                            }
                                                            let _e1175 = phi_1676_;
                                                            let _e1179 = (_e1169 + _e270);
                                                            let _e1180 = (_e1179 < _e93);
                                                            if _e1180 {
                                                                if _e1180 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1182 = global_7.member[_e1179];
                                                                phi_1694_ = _e1182;
                                                            } else {
                                                                phi_1694_ = 0u;
                                                            }
                                                            let _e1184 = phi_1694_;
                                                            let _e1188 = (_e1169 + _e272);
                                                            let _e1189 = (_e1188 < _e93);
                                                            if _e1189 {
                                                                if _e1189 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1191 = global_7.member[_e1188];
                                                                phi_1712_ = _e1191;
                                                            } else {
                                                                phi_1712_ = 0u;
                                                            }
                                                            let _e1193 = phi_1712_;
                                                            phi_1718_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1117)) * _e145), (f32(bitcast<i32>(_e1126)) * _e145), (f32(bitcast<i32>(_e1135)) * _e145)), array<f32, 3>((f32(bitcast<i32>(_e1146)) * _e145), (f32(bitcast<i32>(_e1155)) * _e145), (f32(bitcast<i32>(_e1164)) * _e145)), array<f32, 3>((f32(bitcast<i32>(_e1175)) * _e145), (f32(bitcast<i32>(_e1184)) * _e145), (f32(bitcast<i32>(_e1193)) * _e145)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1718_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1467 = phi_1718_;
                                                    let _e1476 = (_e1467[0][2] - _e376);
                                                    let _e1479 = (((_e1467[0][0] - _e303) * _e400) - (_e1476 * _e328));
                                                    let _e1482 = (((_e1467[0][1] - _e340) * _e400) - (_e1476 * _e364));
                                                    let _e1489 = (_e1467[1][2] - _e376);
                                                    let _e1492 = (((_e1467[1][0] - _e303) * _e400) - (_e1489 * _e328));
                                                    let _e1495 = (((_e1467[1][1] - _e340) * _e400) - (_e1489 * _e364));
                                                    let _e1502 = (_e1467[2][2] - _e376);
                                                    let _e1505 = (((_e1467[2][0] - _e303) * _e400) - (_e1502 * _e328));
                                                    let _e1508 = (((_e1467[2][1] - _e340) * _e400) - (_e1502 * _e364));
                                                    let _e1509 = (_e1505 * _e1495);
                                                    let _e1510 = (_e1508 * _e1492);
                                                    let _e1511 = (_e1479 * _e1508);
                                                    let _e1512 = (_e1482 * _e1505);
                                                    let _e1513 = (_e1492 * _e1482);
                                                    let _e1514 = (_e1495 * _e1479);
                                                    let _e1519 = (((_e1509 >= _e1510) && (_e1511 >= _e1512)) && (_e1513 >= _e1514));
                                                    if (_e1519 || (((_e1509 <= _e1510) && (_e1511 <= _e1512)) && (_e1513 <= _e1514))) {
                                                        let _e1526 = select(-1f, 1f, _e1519);
                                                        let _e1528 = ((_e1509 - _e1510) * _e1526);
                                                        let _e1530 = select(0f, _e1528, (_e1528 > 0f));
                                                        let _e1532 = ((_e1511 - _e1512) * _e1526);
                                                        let _e1534 = select(0f, _e1532, (_e1532 > 0f));
                                                        let _e1536 = ((_e1513 - _e1514) * _e1526);
                                                        let _e1538 = select(0f, _e1536, (_e1536 > 0f));
                                                        let _e1540 = ((_e1530 + _e1534) + _e1538);
                                                        if (_e1540 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2546_ = type_18();
                                                            phi_2547_ = true;
                                                            phi_2548_ = false;
                                                        } else {
                                                            let _e1543 = select(_e1492, _e1479, (_e1479 < _e1492));
                                                            if (select(_e1505, _e1543, (_e1543 < _e1505)) > 0f) {
                                                                phi_1835_ = true;
                                                            } else {
                                                                let _e1548 = select(_e1492, _e1479, (_e1479 > _e1492));
                                                                phi_1835_ = (select(_e1505, _e1548, (_e1548 > _e1505)) < 0f);
                                                            }
                                                            let _e1553 = phi_1835_;
                                                            if _e1553 {
                                                                phi_2543_ = type_18();
                                                                phi_2544_ = true;
                                                                phi_2545_ = false;
                                                            } else {
                                                                let _e1555 = select(_e1495, _e1482, (_e1482 < _e1495));
                                                                if (select(_e1508, _e1555, (_e1555 < _e1508)) > 0f) {
                                                                    phi_1864_ = true;
                                                                } else {
                                                                    let _e1560 = select(_e1495, _e1482, (_e1482 > _e1495));
                                                                    phi_1864_ = (select(_e1508, _e1560, (_e1560 > _e1508)) < 0f);
                                                                }
                                                                let _e1565 = phi_1864_;
                                                                if _e1565 {
                                                                    phi_2541_ = type_18();
                                                                    phi_2542_ = false;
                                                                } else {
                                                                    let _e1567 = select(_e1467[1][0], _e1467[0][0], (_e1467[0][0] < _e1467[1][0]));
                                                                    let _e1571 = select(_e1467[1][0], _e1467[0][0], (_e1467[0][0] > _e1467[1][0]));
                                                                    let _e1575 = select(_e1467[1][1], _e1467[0][1], (_e1467[0][1] < _e1467[1][1]));
                                                                    let _e1579 = select(_e1467[1][1], _e1467[0][1], (_e1467[0][1] > _e1467[1][1]));
                                                                    let _e1583 = select(_e1467[1][2], _e1467[0][2], (_e1467[0][2] < _e1467[1][2]));
                                                                    let _e1587 = select(_e1467[1][2], _e1467[0][2], (_e1467[0][2] > _e1467[1][2]));
                                                                    let _e1592 = ((select(_e1467[2][0], _e1567, (_e1567 < _e1467[2][0])) - _e326) * _e331);
                                                                    let _e1593 = ((select(_e1467[2][0], _e1571, (_e1571 > _e1467[2][0])) - _e327) * _e331);
                                                                    let _e1596 = ((select(_e1467[2][1], _e1575, (_e1575 < _e1467[2][1])) - _e362) * _e367);
                                                                    let _e1597 = ((select(_e1467[2][1], _e1579, (_e1579 > _e1467[2][1])) - _e363) * _e367);
                                                                    let _e1600 = ((select(_e1467[2][2], _e1583, (_e1583 < _e1467[2][2])) - _e398) * _e403);
                                                                    let _e1601 = ((select(_e1467[2][2], _e1587, (_e1587 > _e1467[2][2])) - _e399) * _e403);
                                                                    let _e1603 = select(_e1601, _e1600, (_e1600 < _e1601));
                                                                    let _e1605 = select(_e1601, _e1600, (_e1600 > _e1601));
                                                                    let _e1607 = select(_e1593, _e1592, (_e1592 < _e1593));
                                                                    let _e1609 = select(_e1597, _e1596, (_e1596 < _e1597));
                                                                    let _e1611 = select(_e1609, _e1607, (_e1607 > _e1609));
                                                                    let _e1613 = select(_e1603, _e1611, (_e1611 > _e1603));
                                                                    let _e1615 = select(_e1593, _e1592, (_e1592 > _e1593));
                                                                    let _e1617 = select(_e1597, _e1596, (_e1596 > _e1597));
                                                                    let _e1619 = select(_e1617, _e1615, (_e1615 < _e1617));
                                                                    let _e1621 = select(_e1605, _e1619, (_e1619 < _e1605));
                                                                    let _e1622 = -(_e1603);
                                                                    let _e1628 = select(_e449, _e1613, (_e1613 > _e449));
                                                                    if (_e1628 > (_e1621 + (select(_e1622, _e1605, (_e1605 > _e1622)) * 0.0000019073523f))) {
                                                                        phi_2536_ = type_18();
                                                                        phi_2537_ = true;
                                                                    } else {
                                                                        let _e1630 = (_e1628 > _e1032.member.member_1);
                                                                        if _e1630 {
                                                                            phi_2535_ = type_18();
                                                                        } else {
                                                                            let _e1631 = vec3<f32>(_e1467[0][0], _e1467[0][1], _e1467[0][2]);
                                                                            let _e1632 = vec3<f32>(_e1467[1][0], _e1467[1][1], _e1467[1][2]);
                                                                            let _e1633 = vec3<f32>(_e1467[2][0], _e1467[2][1], _e1467[2][2]);
                                                                            let _e1634 = (_e1467[1][0] - _e1467[0][0]);
                                                                            let _e1635 = (_e1467[1][1] - _e1467[0][1]);
                                                                            let _e1636 = (_e1467[1][2] - _e1467[0][2]);
                                                                            let _e1637 = vec3<f32>(_e1634, _e1635, _e1636);
                                                                            let _e1638 = (_e1467[2][0] - _e1467[1][0]);
                                                                            let _e1639 = (_e1467[2][1] - _e1467[1][1]);
                                                                            let _e1640 = (_e1467[2][2] - _e1467[1][2]);
                                                                            let _e1641 = vec3<f32>(_e1638, _e1639, _e1640);
                                                                            let _e1642 = (_e1467[0][0] - _e1467[2][0]);
                                                                            let _e1643 = (_e1467[0][1] - _e1467[2][1]);
                                                                            let _e1644 = (_e1467[0][2] - _e1467[2][2]);
                                                                            let _e1645 = vec3<f32>(_e1642, _e1643, _e1644);
                                                                            let _e1648 = bitcast<f32>((bitcast<u32>(_e1634) & 2147483647u));
                                                                            let _e1651 = bitcast<f32>((bitcast<u32>(_e1635) & 2147483647u));
                                                                            let _e1653 = select(_e1651, _e1648, (_e1648 > _e1651));
                                                                            let _e1656 = bitcast<f32>((bitcast<u32>(_e1636) & 2147483647u));
                                                                            let _e1658 = select(_e1656, _e1653, (_e1653 > _e1656));
                                                                            let _e1661 = bitcast<f32>((bitcast<u32>(_e1638) & 2147483647u));
                                                                            let _e1664 = bitcast<f32>((bitcast<u32>(_e1639) & 2147483647u));
                                                                            let _e1666 = select(_e1664, _e1661, (_e1661 > _e1664));
                                                                            let _e1669 = bitcast<f32>((bitcast<u32>(_e1640) & 2147483647u));
                                                                            let _e1671 = select(_e1669, _e1666, (_e1666 > _e1669));
                                                                            let _e1674 = bitcast<f32>((bitcast<u32>(_e1642) & 2147483647u));
                                                                            let _e1677 = bitcast<f32>((bitcast<u32>(_e1643) & 2147483647u));
                                                                            let _e1679 = select(_e1677, _e1674, (_e1674 > _e1677));
                                                                            let _e1682 = bitcast<f32>((bitcast<u32>(_e1644) & 2147483647u));
                                                                            let _e1684 = select(_e1682, _e1679, (_e1679 > _e1682));
                                                                            let _e1686 = select(_e1671, _e1658, (_e1658 > _e1671));
                                                                            let _e1688 = select(_e1684, _e1686, (_e1686 > _e1684));
                                                                            if (_e1658 == _e1688) {
                                                                                phi_2265_ = _e1495;
                                                                                phi_2266_ = _e1492;
                                                                                phi_2267_ = _e1482;
                                                                                phi_2268_ = _e1479;
                                                                                phi_2269_ = _e1631;
                                                                                phi_2270_ = _e1645;
                                                                                phi_2271_ = _e1641;
                                                                                phi_2272_ = _e1637;
                                                                            } else {
                                                                                let _e1690 = (_e1671 == _e1688);
                                                                                let _e1695 = vec3(_e1690);
                                                                                phi_2265_ = select(_e1482, _e1508, _e1690);
                                                                                phi_2266_ = select(_e1479, _e1505, _e1690);
                                                                                phi_2267_ = select(_e1508, _e1495, _e1690);
                                                                                phi_2268_ = select(_e1505, _e1492, _e1690);
                                                                                phi_2269_ = select(_e1633, _e1632, _e1695);
                                                                                phi_2270_ = select(_e1641, _e1637, _e1695);
                                                                                phi_2271_ = select(_e1637, _e1645, _e1695);
                                                                                phi_2272_ = select(_e1645, _e1641, _e1695);
                                                                            }
                                                                            let _e1701 = phi_2265_;
                                                                            let _e1703 = phi_2266_;
                                                                            let _e1705 = phi_2267_;
                                                                            let _e1707 = phi_2268_;
                                                                            let _e1709 = phi_2269_;
                                                                            let _e1711 = phi_2270_;
                                                                            let _e1713 = phi_2271_;
                                                                            let _e1715 = phi_2272_;
                                                                            let _e1722 = ((_e1713.y * _e1711.z) - (_e1711.y * _e1713.z));
                                                                            let _e1727 = ((_e1713.z * _e1711.x) - (_e1711.z * _e1713.x));
                                                                            let _e1730 = ((_e1713.x * _e1711.y) - (_e1711.x * _e1713.y));
                                                                            if (_e1530 >= _e1534) {
                                                                                phi_2303_ = select(true, false, (_e1530 >= _e1538));
                                                                            } else {
                                                                                phi_2303_ = true;
                                                                            }
                                                                            let _e1735 = phi_2303_;
                                                                            if _e1735 {
                                                                                phi_2312_ = select(_e1633, _e1632, vec3((_e1534 >= _e1538)));
                                                                            } else {
                                                                                phi_2312_ = _e1631;
                                                                            }
                                                                            let _e1740 = phi_2312_;
                                                                            let _e1745 = (((_e1722 * _e328) + (_e1727 * _e364)) + (_e1730 * _e400));
                                                                            let _e1756 = (((_e1722 * (_e1740.x - _e303)) + (_e1727 * (_e1740.y - _e340))) + (_e1730 * (_e1740.z - _e376)));
                                                                            let _e1758 = (_e1703 - _e1707);
                                                                            let _e1759 = (_e1701 - _e1705);
                                                                            let _e1767 = (-(((_e1707 * _e1758) + (_e1705 * _e1759))) / ((_e1758 * _e1758) + (_e1759 * _e1759)));
                                                                            let _e1769 = select(1f, _e1767, (_e1767 < 1f));
                                                                            let _e1771 = select(0f, _e1769, (_e1769 > 0f));
                                                                            let _e1784 = ((_e1709.x + (_e1715.x * _e1771)) - _e303);
                                                                            let _e1785 = ((_e1709.y + (_e1715.y * _e1771)) - _e340);
                                                                            let _e1786 = ((_e1709.z + (_e1715.z * _e1771)) - _e376);
                                                                            let _e1787 = (_e1786 / _e400);
                                                                            let _e1799 = bitcast<f32>((bitcast<u32>(_e1784) & 2147483647u));
                                                                            let _e1802 = bitcast<f32>((bitcast<u32>(_e1785) & 2147483647u));
                                                                            let _e1804 = select(_e1802, _e1799, (_e1799 > _e1802));
                                                                            let _e1807 = bitcast<f32>((bitcast<u32>(_e1786) & 2147483647u));
                                                                            let _e1809 = select(_e1807, _e1804, (_e1804 > _e1807));
                                                                            let _e1815 = bitcast<f32>((bitcast<u32>(_e1722) & 2147483647u));
                                                                            let _e1818 = bitcast<f32>((bitcast<u32>(_e1727) & 2147483647u));
                                                                            let _e1820 = select(_e1818, _e1815, (_e1815 > _e1818));
                                                                            let _e1823 = bitcast<f32>((bitcast<u32>(_e1730) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1722 * _e1784) + (_e1727 * _e1785)) + (_e1730 * _e1786)) - _e1756)) & 2147483647u)) <= ((0.0000009536743f * select(_e1688, _e1809, (_e1809 > _e1688))) * select(_e1823, _e1820, (_e1820 > _e1823)))) {
                                                                                let _e1833 = bitcast<f32>((bitcast<u32>(_e1713.x) & 2147483647u));
                                                                                let _e1836 = bitcast<f32>((bitcast<u32>(_e1713.y) & 2147483647u));
                                                                                let _e1838 = select(_e1836, _e1833, (_e1833 > _e1836));
                                                                                let _e1841 = bitcast<f32>((bitcast<u32>(_e1713.z) & 2147483647u));
                                                                                let _e1847 = bitcast<f32>((bitcast<u32>(_e1711.x) & 2147483647u));
                                                                                let _e1850 = bitcast<f32>((bitcast<u32>(_e1711.y) & 2147483647u));
                                                                                let _e1852 = select(_e1850, _e1847, (_e1847 > _e1850));
                                                                                let _e1855 = bitcast<f32>((bitcast<u32>(_e1711.z) & 2147483647u));
                                                                                phi_2479_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1745) & 2147483647u)) > ((0.0000038146973f * select(_e1841, _e1838, (_e1838 > _e1841))) * select(_e1855, _e1852, (_e1852 > _e1855)))));
                                                                            } else {
                                                                                phi_2479_ = true;
                                                                            }
                                                                            let _e1862 = phi_2479_;
                                                                            if _e1862 {
                                                                                let _e1873 = ((((_e1722 * (_e1784 - (_e328 * _e1787))) + (_e1727 * (_e1785 - (_e364 * _e1787)))) + (_e1730 * (_e1786 - _e1786))) / _e1745);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1873) & 2147483647u)) <= _e1688) {
                                                                                    phi_2503_ = (_e1787 + _e1873);
                                                                                } else {
                                                                                    phi_2503_ = _e1787;
                                                                                }
                                                                                let _e1880 = phi_2503_;
                                                                                phi_2504_ = _e1880;
                                                                            } else {
                                                                                phi_2504_ = (_e1756 / _e1745);
                                                                            }
                                                                            let _e1882 = phi_2504_;
                                                                            let _e1884 = select(_e1621, _e1882, (_e1882 < _e1621));
                                                                            let _e1886 = select(_e1613, _e1884, (_e1884 > _e1613));
                                                                            if (_e1886 >= _e449) {
                                                                                let _e1888 = (_e1886 <= _e1032.member.member_1);
                                                                                if _e1888 {
                                                                                    let _e1889 = (1f / _e1540);
                                                                                    phi_2527_ = type_18(_e1886, (_e1534 * _e1889), (_e1538 * _e1889), _e1098);
                                                                                } else {
                                                                                    phi_2527_ = type_18();
                                                                                }
                                                                                let _e1894 = phi_2527_;
                                                                                phi_2529_ = _e1894;
                                                                                phi_2530_ = select(true, false, _e1888);
                                                                            } else {
                                                                                phi_2529_ = type_18();
                                                                                phi_2530_ = true;
                                                                            }
                                                                            let _e1897 = phi_2529_;
                                                                            let _e1899 = phi_2530_;
                                                                            if _e1899 {
                                                                                phi_2534_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2534_ = _e1897;
                                                                            }
                                                                            let _e1901 = phi_2534_;
                                                                            phi_2535_ = _e1901;
                                                                        }
                                                                        let _e1903 = phi_2535_;
                                                                        phi_2536_ = _e1903;
                                                                        phi_2537_ = _e1630;
                                                                    }
                                                                    let _e1905 = phi_2536_;
                                                                    let _e1907 = phi_2537_;
                                                                    phi_2541_ = _e1905;
                                                                    phi_2542_ = _e1907;
                                                                }
                                                                let _e1909 = phi_2541_;
                                                                let _e1911 = phi_2542_;
                                                                phi_2543_ = _e1909;
                                                                phi_2544_ = _e1565;
                                                                phi_2545_ = _e1911;
                                                            }
                                                            let _e1913 = phi_2543_;
                                                            let _e1915 = phi_2544_;
                                                            let _e1917 = phi_2545_;
                                                            phi_2546_ = _e1913;
                                                            phi_2547_ = _e1915;
                                                            phi_2548_ = _e1917;
                                                        }
                                                        let _e1919 = phi_2546_;
                                                        let _e1921 = phi_2547_;
                                                        let _e1923 = phi_2548_;
                                                        phi_2556_ = _e1919;
                                                        phi_2557_ = select(_e1923, true, _e1921);
                                                    } else {
                                                        phi_2556_ = type_18();
                                                        phi_2557_ = true;
                                                    }
                                                    let _e1926 = phi_2556_;
                                                    let _e1928 = phi_2557_;
                                                    if _e1928 {
                                                        phi_2561_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2561_ = _e1926;
                                                    }
                                                    let _e1930 = phi_2561_;
                                                    if (_e1930.member_3 != 4294967295u) {
                                                        if (_e1098 != _e455) {
                                                            if (_e1930.member < _e1032.member.member.member) {
                                                                phi_2587_ = true;
                                                            } else {
                                                                if (_e1930.member == _e1032.member.member.member) {
                                                                    phi_2586_ = (_e1930.member_3 < _e1032.member.member.member_3);
                                                                } else {
                                                                    phi_2586_ = false;
                                                                }
                                                                let _e1945 = phi_2586_;
                                                                phi_2587_ = _e1945;
                                                            }
                                                            let _e1947 = phi_2587_;
                                                            if _e1947 {
                                                                phi_2594_ = type_38(type_34(_e1930, _e1930.member), _e1059.member_1, _e1059.member_2);
                                                            } else {
                                                                phi_2594_ = _e1059;
                                                            }
                                                            let _e1954 = phi_2594_;
                                                            phi_2595_ = _e1954;
                                                        } else {
                                                            phi_2595_ = _e1059;
                                                        }
                                                        let _e1956 = phi_2595_;
                                                        phi_2596_ = _e1956;
                                                    } else {
                                                        phi_2596_ = _e1059;
                                                    }
                                                    let _e1958 = phi_2596_;
                                                    phi_997_ = _e1958;
                                                } else {
                                                    phi_997_ = type_38();
                                                }
                                                let _e1960 = phi_997_;
                                                continue;
                                                continuing {
                                                    phi_996_ = _e1960;
                                                    phi_999_ = _e1047;
                                                    phi_4216_ = _e496;
                                                    break if !(_e1053);
                                                }
                                            }
                                            let _e1963 = phi_4216_;
                                            phi_4405_ = _e1963;
                                            if _e1963 {
                                                break;
                                            }
                                            phi_4409_ = _e1963;
                                            let _e2231 = local_12;
                                            phi_3839_ = _e2231;
                                            phi_3840_ = _e538;
                                            phi_3841_ = false;
                                            phi_3842_ = _e542;
                                        } else {
                                            if (_e538.member_1 >= _e90) {
                                                phi_3395_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e538.member_1 < _e90) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e560 = (_e271 * 2u);
                                                let _e562 = ((1u + _e560) % 7u);
                                                if (_e562 < 7u) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e567 = global_6.member[_e538.member_1][_e562];
                                                let _e569 = ((_e560 + 2u) % 7u);
                                                if (_e569 < 7u) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e574 = global_6.member[_e538.member_1][_e569];
                                                let _e575 = (_e270 * 2u);
                                                let _e577 = ((1u + _e575) % 7u);
                                                if (_e577 < 7u) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e582 = global_6.member[_e538.member_1][_e577];
                                                let _e584 = ((_e575 + 2u) % 7u);
                                                if (_e584 < 7u) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e589 = global_6.member[_e538.member_1][_e584];
                                                let _e590 = (_e272 * 2u);
                                                let _e592 = ((1u + _e590) % 7u);
                                                if (_e592 < 7u) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e597 = global_6.member[_e538.member_1][_e592];
                                                let _e599 = ((_e590 + 2u) % 7u);
                                                if (_e599 < 7u) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e604 = global_6.member[_e538.member_1][_e599];
                                                let _e627 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.x - _e538.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e628 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.y - _e538.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e629 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.z - _e538.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e631 = select(_e145, _e627, (_e627 > _e145));
                                                let _e633 = select(_e145, _e628, (_e628 > _e145));
                                                let _e635 = select(_e145, _e629, (_e629 > _e145));
                                                let _e660 = bitcast<u32>((f32(bitcast<i32>((_e567 & 2097151u))) * _e631));
                                                let _e665 = (bitcast<i32>((_e567 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                                let _e669 = bitcast<u32>((f32(bitcast<i32>((_e582 & 2097151u))) * _e633));
                                                let _e674 = (bitcast<i32>((_e582 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e677 = bitcast<f32>((_e669 & bitcast<u32>(_e674)));
                                                let _e678 = bitcast<u32>((f32(bitcast<i32>((_e597 & 2097151u))) * _e635));
                                                let _e683 = (bitcast<i32>((_e597 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e686 = bitcast<f32>((_e678 & bitcast<u32>(_e683)));
                                                let _e690 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                                let _e694 = bitcast<f32>((_e669 & bitcast<u32>(~(_e674))));
                                                let _e698 = bitcast<f32>((_e678 & bitcast<u32>(~(_e683))));
                                                let _e699 = bitcast<u32>((f32(bitcast<i32>((_e574 & 2097151u))) * _e631));
                                                let _e704 = (bitcast<i32>((_e574 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                                let _e708 = bitcast<u32>((f32(bitcast<i32>((_e589 & 2097151u))) * _e633));
                                                let _e713 = (bitcast<i32>((_e589 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e716 = bitcast<f32>((_e708 & bitcast<u32>(_e713)));
                                                let _e717 = bitcast<u32>((f32(bitcast<i32>((_e604 & 2097151u))) * _e635));
                                                let _e722 = (bitcast<i32>((_e604 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e725 = bitcast<f32>((_e717 & bitcast<u32>(_e722)));
                                                let _e729 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                                let _e733 = bitcast<f32>((_e708 & bitcast<u32>(~(_e713))));
                                                let _e737 = bitcast<f32>((_e717 & bitcast<u32>(~(_e722))));
                                                let _e738 = (_e538.member.member.x + _e668);
                                                let _e739 = (_e538.member.member.y + _e677);
                                                let _e740 = (_e538.member.member.z + _e686);
                                                let _e743 = (_e538.member.member_1.x - _e707);
                                                let _e744 = (_e538.member.member_1.y - _e716);
                                                let _e745 = (_e538.member.member_1.z - _e725);
                                                let _e764 = (_e743 - _e738);
                                                let _e765 = (_e744 - _e739);
                                                let _e766 = (_e745 - _e740);
                                                let _e768 = select(_e765, _e764, (_e764 > _e765));
                                                let _e770 = select(_e766, _e768, (_e768 > _e766));
                                                if (_e770 < (1024f * _e145)) {
                                                    phi_3096_ = 0u;
                                                } else {
                                                    phi_3096_ = select(2u, 1u, (_e770 < (2097152f * _e145)));
                                                }
                                                let _e777 = phi_3096_;
                                                switch bitcast<i32>(_e777) {
                                                    case 0: {
                                                        phi_3102_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3102_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3102_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3102_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e780 = phi_3102_;
                                                let _e786 = global_6.member[_e538.member_1][0u];
                                                let _e790 = global_6.member[_e538.member_1][2u];
                                                let _e794 = global_6.member[_e538.member_1][4u];
                                                let _e798 = global_6.member[_e538.member_1][6u];
                                                let _e810 = (((_e790 >> bitcast<u32>(22i)) | ((_e794 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e798 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e811 = (_e786 & 268435455u);
                                                let _e812 = (_e810 & 268435455u);
                                                let _e815 = ((_e786 >> bitcast<u32>(28u)) & 7u);
                                                let _e823 = ((_e786 >> bitcast<u32>(31i)) | (((_e810 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e824 = (_e815 != 0u);
                                                if (_e815 == 0u) {
                                                    phi_3357_ = _e811;
                                                } else {
                                                    if (_e815 == 7u) {
                                                        phi_3356_ = 2147483648u;
                                                    } else {
                                                        phi_3356_ = ((2147483648u | (_e815 << bitcast<u32>(28u))) | (_e812 & 268435455u));
                                                    }
                                                    let _e833 = phi_3356_;
                                                    phi_3357_ = _e833;
                                                }
                                                let _e835 = phi_3357_;
                                                if _e824 {
                                                    let _e836 = (_e815 != 7u);
                                                    if _e836 {
                                                        phi_3367_ = (_e812 + (_e815 * ((3u * _e780) + 1u)));
                                                    } else {
                                                        phi_3367_ = u32();
                                                    }
                                                    let _e840 = phi_3367_;
                                                    phi_3369_ = _e840;
                                                    phi_3370_ = select(true, false, _e836);
                                                } else {
                                                    phi_3369_ = u32();
                                                    phi_3370_ = true;
                                                }
                                                let _e843 = phi_3369_;
                                                let _e845 = phi_3370_;
                                                if (_e823 == 0u) {
                                                    phi_3391_ = (_e811 + select(0u, 1u, !(_e824)));
                                                } else {
                                                    if (_e823 == 7u) {
                                                        phi_3390_ = 2147483648u;
                                                    } else {
                                                        phi_3390_ = ((2147483648u | (_e823 << bitcast<u32>(28u))) | (select(_e843, _e812, _e845) & 268435455u));
                                                    }
                                                    let _e858 = phi_3390_;
                                                    phi_3391_ = _e858;
                                                }
                                                let _e860 = phi_3391_;
                                                phi_3395_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e738, (_e538.member.member.x + _e690), _e743, (_e538.member.member_1.x - _e729)), vec4<f32>(_e739, (_e538.member.member.y + _e694), _e744, (_e538.member.member_1.y - _e733)), vec4<f32>(_e740, (_e538.member.member.z + _e698), _e745, (_e538.member.member_1.z - _e737))), type_49(type_30((_e538.member.member + vec4<f32>(_e668, _e677, _e686, 0f)), (_e538.member.member_1 - vec4<f32>(_e707, _e716, _e725, 0f))), _e835), type_49(type_30((_e538.member.member + vec4<f32>(_e690, _e694, _e698, 0f)), (_e538.member.member_1 - vec4<f32>(_e729, _e733, _e737, 0f))), _e860));
                                            }
                                            let _e865 = phi_3395_;
                                            let _e878 = ((_e865.member[0].x - _e326) * _e331);
                                            let _e879 = ((_e865.member[0].y - _e326) * _e331);
                                            let _e880 = ((_e865.member[0].z - _e327) * _e331);
                                            let _e881 = ((_e865.member[0].w - _e327) * _e331);
                                            let _e891 = ((_e865.member[1].x - _e362) * _e367);
                                            let _e892 = ((_e865.member[1].y - _e362) * _e367);
                                            let _e893 = ((_e865.member[1].z - _e363) * _e367);
                                            let _e894 = ((_e865.member[1].w - _e363) * _e367);
                                            let _e904 = ((_e865.member[2].x - _e398) * _e403);
                                            let _e905 = ((_e865.member[2].y - _e398) * _e403);
                                            let _e906 = ((_e865.member[2].z - _e399) * _e403);
                                            let _e907 = ((_e865.member[2].w - _e399) * _e403);
                                            let _e909 = select(_e906, _e904, (_e904 < _e906));
                                            let _e911 = select(_e907, _e905, (_e905 < _e907));
                                            let _e913 = select(_e906, _e904, (_e904 > _e906));
                                            let _e915 = select(_e907, _e905, (_e905 > _e907));
                                            let _e917 = select(_e880, _e878, (_e878 < _e880));
                                            let _e919 = select(_e881, _e879, (_e879 < _e881));
                                            let _e921 = select(_e893, _e891, (_e891 < _e893));
                                            let _e923 = select(_e894, _e892, (_e892 < _e894));
                                            let _e925 = select(_e921, _e917, (_e917 > _e921));
                                            let _e927 = select(_e923, _e919, (_e919 > _e923));
                                            let _e929 = select(_e909, _e925, (_e925 > _e909));
                                            let _e931 = select(_e911, _e927, (_e927 > _e911));
                                            let _e933 = select(_e880, _e878, (_e878 > _e880));
                                            let _e935 = select(_e881, _e879, (_e879 > _e881));
                                            let _e937 = select(_e893, _e891, (_e891 > _e893));
                                            let _e939 = select(_e894, _e892, (_e892 > _e894));
                                            let _e941 = select(_e937, _e933, (_e933 < _e937));
                                            let _e943 = select(_e939, _e935, (_e935 < _e939));
                                            let _e948 = -(_e909);
                                            let _e949 = -(_e911);
                                            let _e956 = (select(_e913, _e941, (_e941 < _e913)) + (select(_e948, _e913, (_e913 > _e948)) * 0.0000019073523f));
                                            let _e957 = (select(_e915, _e943, (_e943 < _e915)) + (select(_e949, _e915, (_e915 > _e949)) * 0.0000019073523f));
                                            let _e959 = select(_e449, _e929, (_e929 > _e449));
                                            let _e961 = select(_e449, _e931, (_e931 > _e449));
                                            let _e966 = (_e959 <= select(_e498.member.member_1, _e956, (_e956 < _e498.member.member_1)));
                                            let _e967 = (_e961 <= select(_e498.member.member_1, _e957, (_e957 < _e498.member.member_1)));
                                            let _e968 = (_e959 <= _e961);
                                            if _e966 {
                                                if _e967 {
                                                    if _e968 {
                                                        phi_3739_ = _e865.member_2;
                                                    } else {
                                                        phi_3739_ = _e865.member_1;
                                                    }
                                                    let _e972 = phi_3739_;
                                                    let _e994 = (_e542 % 128u);
                                                    let _e995 = (_e994 < 128u);
                                                    if _e995 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_8[_e994] = _e972.member_1;
                                                    if _e995 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_7[_e994] = _e972.member.member.x;
                                                    if _e995 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_6[_e994] = _e972.member.member.y;
                                                    if _e995 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_5[_e994] = _e972.member.member.z;
                                                    if _e995 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_4[_e994] = _e972.member.member_1.x;
                                                    if _e995 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_3[_e994] = _e972.member.member_1.y;
                                                    if _e995 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_2[_e994] = _e972.member.member_1.z;
                                                    if _e995 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_9[_e994] = select(_e961, _e959, (_e959 > _e961));
                                                    if _e968 {
                                                        phi_3816_ = _e865.member_1;
                                                    } else {
                                                        phi_3816_ = _e865.member_2;
                                                    }
                                                    let _e1008 = phi_3816_;
                                                    phi_3817_ = _e1008;
                                                    phi_3818_ = (_e542 + 1u);
                                                } else {
                                                    phi_3817_ = type_49();
                                                    phi_3818_ = u32();
                                                }
                                                let _e1010 = phi_3817_;
                                                let _e1012 = phi_3818_;
                                                phi_3820_ = _e1010;
                                                phi_3821_ = _e1012;
                                                phi_3822_ = select(true, false, _e967);
                                            } else {
                                                phi_3820_ = type_49();
                                                phi_3821_ = u32();
                                                phi_3822_ = true;
                                            }
                                            let _e1015 = phi_3820_;
                                            let _e1017 = phi_3821_;
                                            let _e1019 = phi_3822_;
                                            if _e1019 {
                                                if _e966 {
                                                    phi_3831_ = _e865.member_1;
                                                } else {
                                                    phi_3831_ = _e865.member_2;
                                                }
                                                let _e1023 = phi_3831_;
                                                phi_3836_ = _e1023;
                                                phi_3837_ = select(_e967, true, _e966);
                                            } else {
                                                phi_3836_ = _e1015;
                                                phi_3837_ = _e540;
                                            }
                                            let _e1026 = phi_3836_;
                                            let _e1028 = phi_3837_;
                                            phi_4409_ = _e496;
                                            phi_3839_ = type_38(_e498.member, (_e498.member_1 + 1u), _e498.member_2);
                                            phi_3840_ = _e1026;
                                            phi_3841_ = _e1028;
                                            phi_3842_ = select(_e1017, _e542, _e1019);
                                        }
                                        let _e1965 = phi_4409_;
                                        let _e1967 = phi_3839_;
                                        let _e1969 = phi_3840_;
                                        let _e1971 = phi_3841_;
                                        let _e1973 = phi_3842_;
                                        phi_4408_ = _e1965;
                                        phi_3843_ = _e1967;
                                        phi_3844_ = _e1969;
                                        phi_3845_ = (_e502 - 1u);
                                        phi_3846_ = _e1971;
                                        phi_3847_ = _e1973;
                                    } else {
                                        phi_4408_ = _e496;
                                        phi_3843_ = _e498;
                                        phi_3844_ = _e538;
                                        phi_3845_ = _e502;
                                        phi_3846_ = _e540;
                                        phi_3847_ = _e542;
                                    }
                                    let _e1975 = phi_4408_;
                                    let _e1977 = phi_3843_;
                                    let _e1979 = phi_3844_;
                                    let _e1981 = phi_3845_;
                                    let _e1983 = phi_3846_;
                                    let _e1985 = phi_3847_;
                                    phi_4407_ = _e1975;
                                    phi_3848_ = _e1977;
                                    phi_3849_ = _e1979;
                                    phi_3850_ = _e1981;
                                    phi_3851_ = _e1983;
                                    phi_3852_ = _e1985;
                                } else {
                                    phi_4407_ = _e496;
                                    phi_3848_ = type_38();
                                    phi_3849_ = type_49();
                                    phi_3850_ = u32();
                                    phi_3851_ = bool();
                                    phi_3852_ = u32();
                                }
                                let _e1987 = phi_4407_;
                                let _e1989 = phi_3848_;
                                let _e1991 = phi_3849_;
                                let _e1993 = phi_3850_;
                                let _e1995 = phi_3851_;
                                let _e1997 = phi_3852_;
                                phi_4406_ = _e1987;
                                phi_870_ = _e1989;
                                phi_873_ = _e1991;
                                phi_875_ = _e1993;
                                phi_877_ = _e1995;
                                phi_879_ = _e1997;
                                phi_3853_ = _e510;
                            } else {
                                phi_4406_ = _e496;
                                phi_870_ = type_38();
                                phi_873_ = type_49();
                                phi_875_ = u32();
                                phi_877_ = bool();
                                phi_879_ = u32();
                                phi_3853_ = false;
                            }
                            let _e1999 = phi_4406_;
                            let _e2001 = phi_870_;
                            let _e2003 = phi_873_;
                            let _e2005 = phi_875_;
                            let _e2007 = phi_877_;
                            let _e2009 = phi_879_;
                            let _e2011 = phi_3853_;
                            continue;
                            continuing {
                                phi_4222_ = _e1999;
                                phi_869_ = _e2001;
                                phi_872_ = _e2003;
                                phi_874_ = _e2005;
                                phi_876_ = _e2007;
                                phi_878_ = _e2009;
                                phi_4405_ = _e1999;
                                break if !(_e2011);
                            }
                        }
                        let _e2014 = phi_4405_;
                        if _e2014 {
                            break;
                        }
                        let _e2016 = local_10;
                        if (_e2016.member.member.member_3 != 4294967295u) {
                            let _e2022 = (_e273 / 3i);
                            let _e2029 = bitcast<f32>((bitcast<u32>((_e2022 + 127i)) << bitcast<u32>(23i)));
                            let _e2037 = (((_e2016.member.member.member * _e2029) * _e2029) * bitcast<f32>((bitcast<u32>(((_e273 - (2i * _e2022)) + 127i)) << bitcast<u32>(23i))));
                            let _e2039 = select(340282350000000000000000000000000000000f, _e2037, (_e2037 < 340282350000000000000000000000000000000f));
                            phi_3905_ = type_18(select(-340282350000000000000000000000000000000f, _e2039, (_e2039 > -340282350000000000000000000000000000000f)), _e2016.member.member.member_1, _e2016.member.member.member_2, _e2016.member.member.member_3);
                        } else {
                            phi_3905_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2046 = phi_3905_;
                        if _e149 {
                        } else {
                            break;
                        }
                        global_1.member[_e133] = _e2046;
                        let _e2050 = local_11;
                        if _e150 {
                        } else {
                            break;
                        }
                        global_4.member[_e133] = _e2050.member_1;
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e2055 = select(0u, 1u, (_e217 <= _e227));
                        if (_e2055 > 0u) {
                            let _e2057 = (1u < _e101);
                            if _e2057 {
                                if (0u < _e101) {
                                } else {
                                    break;
                                }
                                let _e2061 = atomicAdd((&global_5.member[0u]), _e2055);
                                if ((_e2061 + _e2055) < _e2061) {
                                    if _e2057 {
                                    } else {
                                        break;
                                    }
                                    let _e2066 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2069 = select(0u, 1u, (_e2046.member_3 != 4294967295u));
                        if (_e2069 > 0u) {
                            let _e2071 = (3u < _e101);
                            if _e2071 {
                                if (2u < _e101) {
                                } else {
                                    break;
                                }
                                let _e2075 = atomicAdd((&global_5.member[2u]), _e2069);
                                if ((_e2075 + _e2069) < _e2075) {
                                    if _e2071 {
                                    } else {
                                        break;
                                    }
                                    let _e2080 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2050.member_1 > 0u) {
                            let _e2082 = (5u < _e101);
                            if _e2082 {
                                if (4u < _e101) {
                                } else {
                                    break;
                                }
                                let _e2086 = atomicAdd((&global_5.member[4u]), _e2050.member_1);
                                if ((_e2086 + _e2050.member_1) < _e2086) {
                                    if _e2082 {
                                    } else {
                                        break;
                                    }
                                    let _e2091 = atomicAdd((&global_5.member[5u]), 1u);
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
