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
    var phi_869_: type_42;
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
    var phi_996_: type_42;
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
    var phi_2527_: type_22;
    var phi_2529_: type_22;
    var phi_2530_: bool;
    var phi_2534_: type_22;
    var phi_2535_: type_22;
    var phi_2536_: type_22;
    var phi_2537_: bool;
    var phi_2541_: type_22;
    var phi_2542_: bool;
    var phi_2543_: type_22;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2546_: type_22;
    var phi_2547_: bool;
    var phi_2548_: bool;
    var phi_2556_: type_22;
    var phi_2557_: bool;
    var phi_2561_: type_22;
    var phi_2586_: bool;
    var phi_2587_: bool;
    var phi_2594_: type_42;
    var phi_2595_: type_42;
    var phi_2596_: type_42;
    var phi_997_: type_42;
    var phi_4216_: bool;
    var phi_4409_: bool;
    var phi_3839_: type_42;
    var phi_3840_: type_49;
    var phi_3841_: bool;
    var phi_3842_: u32;
    var phi_4408_: bool;
    var phi_3843_: type_42;
    var phi_3844_: type_49;
    var phi_3845_: u32;
    var phi_3846_: bool;
    var phi_3847_: u32;
    var phi_4407_: bool;
    var phi_3848_: type_42;
    var phi_3849_: type_49;
    var phi_3850_: u32;
    var phi_3851_: bool;
    var phi_3852_: u32;
    var phi_4406_: bool;
    var phi_870_: type_42;
    var phi_873_: type_49;
    var phi_875_: u32;
    var phi_877_: bool;
    var phi_879_: u32;
    var phi_3853_: bool;
    var phi_4405_: bool;
    var local_10: type_42;
    var phi_3905_: type_22;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e93 = arrayLength((&global_3.member));
            let _e96 = arrayLength((&global_7.member));
            let _e104 = arrayLength((&global_6.member));
            let _e108 = global_2.member[0u][0u];
            let _e112 = global_2.member[0u][1u];
            let _e116 = global_2.member[0u][2u];
            let _e120 = global_2.member[0u][3u];
            let _e124 = global_2.member[1u][0u];
            let _e128 = global_2.member[1u][1u];
            let _e132 = global_2.member[1u][2u];
            let _e136 = (_e91.x + (_e91.y * 2097152u));
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e151 = (_e136 < arrayLength((&global_4.member)));
            if _e151 {
                let _e152 = (_e136 < arrayLength((&global_1.member)));
                if _e152 {
                    let _e153 = (_e136 < arrayLength((&global_5.member)));
                    if _e153 {
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e163 = global_4.member[_e136].member.member_2[0u];
                        let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                        let _e171 = global_4.member[_e136].member.member_2[1u];
                        let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                        let _e179 = global_4.member[_e136].member.member_2[2u];
                        let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                        let _e187 = global_4.member[_e136].member.member[0u];
                        let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                        let _e195 = global_4.member[_e136].member.member[1u];
                        let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                        let _e203 = global_4.member[_e136].member.member[2u];
                        let _e205 = (bitcast<u32>(_e203) & 2147483647u);
                        let _e207 = select(_e173, _e165, (_e173 < _e165));
                        let _e209 = select(_e181, _e207, (_e181 < _e207));
                        let _e211 = select(_e189, _e209, (_e189 < _e209));
                        let _e213 = select(_e197, _e211, (_e197 < _e211));
                        let _e215 = select(_e205, _e213, (_e205 < _e213));
                        let _e220 = global_4.member[_e136].member.member_1;
                        let _e222 = (bitcast<u32>(_e220) & 2147483647u);
                        let _e230 = global_4.member[_e136].member.member_3;
                        let _e236 = (((select(_e222, _e215, (_e222 < _e215)) < 2139095040u) && ((bitcast<u32>(_e230) & 2147483647u) <= 2139095040u)) && (_e209 > 0u));
                        if _e236 {
                            let _e239 = (bitcast<u32>(bitcast<f32>(_e209)) & 2147483647u);
                            if (_e239 >= 8388608u) {
                                phi_402_ = (bitcast<i32>((_e239 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_402_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e239)), 32u, (_e239 == 0u))));
                            }
                            let _e253 = phi_402_;
                            phi_403_ = _e253;
                        } else {
                            phi_403_ = 0i;
                        }
                        let _e255 = phi_403_;
                        let _e256 = (_e165 == _e209);
                        if _e256 {
                            phi_413_ = true;
                        } else {
                            phi_413_ = (_e173 == _e209);
                        }
                        let _e259 = phi_413_;
                        let _e260 = select(1u, 0u, _e256);
                        if _e259 {
                            let _e261 = (_e260 + 1u);
                            phi_423_ = _e261;
                            phi_424_ = _e261;
                            phi_426_ = select(true, false, (_e261 == 2u));
                        } else {
                            phi_423_ = u32();
                            phi_424_ = 0u;
                            phi_426_ = true;
                        }
                        let _e265 = phi_423_;
                        let _e267 = phi_424_;
                        let _e269 = phi_426_;
                        if _e269 {
                            phi_431_ = (_e267 + 1u);
                        } else {
                            phi_431_ = 0u;
                        }
                        let _e273 = phi_431_;
                        let _e274 = select(_e265, _e267, _e269);
                        let _e275 = select(_e260, select(2u, _e260, _e259), _e269);
                        let _e276 = -(_e255);
                        if (_e276 < -126i) {
                            phi_463_ = -126i;
                        } else {
                            phi_463_ = select(_e276, 127i, (_e276 > 127i));
                        }
                        let _e281 = phi_463_;
                        let _e286 = bitcast<f32>((bitcast<u32>((_e281 + 127i)) << bitcast<u32>(23i)));
                        let _e292 = bitcast<f32>((bitcast<u32>(((_e276 - _e281) + 127i)) << bitcast<u32>(23i)));
                        let _e297 = global_4.member[_e136].member.member;
                        let _e298 = (_e274 == 0u);
                        if _e298 {
                            phi_481_ = _e297[0];
                        } else {
                            phi_481_ = _e297[1];
                        }
                        let _e302 = phi_481_;
                        let _e303 = (_e274 == 2u);
                        if _e303 {
                            phi_487_ = _e297[2];
                        } else {
                            phi_487_ = _e302;
                        }
                        let _e306 = phi_487_;
                        let _e307 = global_4.member[_e136].member.member_2;
                        if _e298 {
                            phi_498_ = _e307[0];
                        } else {
                            phi_498_ = _e307[1];
                        }
                        let _e311 = phi_498_;
                        if _e303 {
                            phi_504_ = _e307[2];
                        } else {
                            phi_504_ = _e311;
                        }
                        let _e314 = phi_504_;
                        let _e316 = ((_e314 * _e286) * _e292);
                        let _e320 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e320 {
                            let _e324 = (bitcast<f32>((bitcast<u32>(_e306) & 2147483647u)) * 0.00000011920929f);
                            phi_527_ = select(0.00000000000011368684f, _e324, (_e324 > 0.00000000000011368684f));
                        } else {
                            phi_527_ = 0f;
                        }
                        let _e328 = phi_527_;
                        let _e329 = (_e306 + _e328);
                        let _e330 = (_e306 - _e328);
                        let _e331 = select(_e316, 0f, _e320);
                        if _e320 {
                            phi_538_ = 38685626000000000000000000f;
                        } else {
                            phi_538_ = (1f / _e316);
                        }
                        let _e334 = phi_538_;
                        let _e335 = (_e273 == 0u);
                        if _e335 {
                            phi_547_ = _e297[0];
                        } else {
                            phi_547_ = _e297[1];
                        }
                        let _e339 = phi_547_;
                        let _e340 = (_e273 == 2u);
                        if _e340 {
                            phi_553_ = _e297[2];
                        } else {
                            phi_553_ = _e339;
                        }
                        let _e343 = phi_553_;
                        if _e335 {
                            phi_564_ = _e307[0];
                        } else {
                            phi_564_ = _e307[1];
                        }
                        let _e347 = phi_564_;
                        if _e340 {
                            phi_570_ = _e307[2];
                        } else {
                            phi_570_ = _e347;
                        }
                        let _e350 = phi_570_;
                        let _e352 = ((_e350 * _e286) * _e292);
                        let _e356 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e356 {
                            let _e360 = (bitcast<f32>((bitcast<u32>(_e343) & 2147483647u)) * 0.00000011920929f);
                            phi_593_ = select(0.00000000000011368684f, _e360, (_e360 > 0.00000000000011368684f));
                        } else {
                            phi_593_ = 0f;
                        }
                        let _e364 = phi_593_;
                        let _e365 = (_e343 + _e364);
                        let _e366 = (_e343 - _e364);
                        let _e367 = select(_e352, 0f, _e356);
                        if _e356 {
                            phi_604_ = 38685626000000000000000000f;
                        } else {
                            phi_604_ = (1f / _e352);
                        }
                        let _e370 = phi_604_;
                        let _e371 = (_e275 == 0u);
                        if _e371 {
                            phi_613_ = _e297[0];
                        } else {
                            phi_613_ = _e297[1];
                        }
                        let _e375 = phi_613_;
                        let _e376 = (_e275 == 2u);
                        if _e376 {
                            phi_619_ = _e297[2];
                        } else {
                            phi_619_ = _e375;
                        }
                        let _e379 = phi_619_;
                        if _e371 {
                            phi_630_ = _e307[0];
                        } else {
                            phi_630_ = _e307[1];
                        }
                        let _e383 = phi_630_;
                        if _e376 {
                            phi_636_ = _e307[2];
                        } else {
                            phi_636_ = _e383;
                        }
                        let _e386 = phi_636_;
                        let _e388 = ((_e386 * _e286) * _e292);
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e392 {
                            let _e396 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                            phi_659_ = select(0.00000000000011368684f, _e396, (_e396 > 0.00000000000011368684f));
                        } else {
                            phi_659_ = 0f;
                        }
                        let _e400 = phi_659_;
                        let _e401 = (_e379 + _e400);
                        let _e402 = (_e379 - _e400);
                        let _e403 = select(_e388, 0f, _e392);
                        if _e392 {
                            phi_670_ = 38685626000000000000000000f;
                        } else {
                            phi_670_ = (1f / _e388);
                        }
                        let _e406 = phi_670_;
                        let _e409 = bitcast<f32>((bitcast<u32>(_e306) & 2147483647u));
                        let _e412 = bitcast<f32>((bitcast<u32>(_e343) & 2147483647u));
                        let _e414 = select(_e412, _e409, (_e409 > _e412));
                        let _e417 = bitcast<f32>((bitcast<u32>(_e379) & 2147483647u));
                        if (_e236 && (select(_e417, _e414, (_e414 > _e417)) <= 1099511600000f)) {
                            let _e422 = (_e255 / 3i);
                            let _e429 = bitcast<f32>((bitcast<u32>((_e422 + 127i)) << bitcast<u32>(23i)));
                            let _e436 = bitcast<f32>((bitcast<u32>(((_e255 - (2i * _e422)) + 127i)) << bitcast<u32>(23i)));
                            let _e437 = (((_e220 * _e429) * _e429) * _e436);
                            let _e439 = select(340282350000000000000000000000000000000f, _e437, (_e437 < 340282350000000000000000000000000000000f));
                            let _e444 = (((_e230 * _e429) * _e429) * _e436);
                            let _e446 = select(340282350000000000000000000000000000000f, _e444, (_e444 < 340282350000000000000000000000000000000f));
                            phi_770_ = select(-340282350000000000000000000000000000000f, _e446, (_e446 > -340282350000000000000000000000000000000f));
                            phi_771_ = select(-340282350000000000000000000000000000000f, _e439, (_e439 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_770_ = 0f;
                            phi_771_ = 1f;
                        }
                        let _e450 = phi_770_;
                        let _e452 = phi_771_;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e458 = global_4.member[_e136].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e461 = (_e274 % 3u);
                        let _e462 = (_e461 < 3u);
                        if _e462 {
                        } else {
                            break;
                        }
                        let _e464 = local_1[_e461];
                        let _e467 = (_e273 % 3u);
                        let _e468 = (_e467 < 3u);
                        if _e468 {
                        } else {
                            break;
                        }
                        let _e470 = local_1[_e467];
                        let _e473 = (_e275 % 3u);
                        let _e474 = (_e473 < 3u);
                        if _e474 {
                        } else {
                            break;
                        }
                        let _e476 = local_1[_e473];
                        if _e462 {
                        } else {
                            break;
                        }
                        let _e481 = local[_e461];
                        if _e468 {
                        } else {
                            break;
                        }
                        let _e485 = local[_e467];
                        if _e474 {
                        } else {
                            break;
                        }
                        let _e489 = local[_e473];
                        phi_4222_ = false;
                        phi_869_ = type_42(type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e450), 0u, 0u);
                        phi_872_ = type_49(type_34(vec4<f32>((f32(_e464) * _e148), (f32(_e470) * _e148), (f32(_e476) * _e148), 0f), vec4<f32>((f32(_e481) * _e148), (f32(_e485) * _e148), (f32(_e489) * _e148), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                        phi_874_ = ((3u * _e93) + 1u);
                        phi_876_ = (_e452 <= _e450);
                        phi_878_ = 0u;
                        loop {
                            let _e499 = phi_4222_;
                            let _e501 = phi_869_;
                            let _e503 = phi_872_;
                            let _e505 = phi_874_;
                            let _e507 = phi_876_;
                            let _e509 = phi_878_;
                            local_10 = _e501;
                            local_11 = _e501;
                            if _e507 {
                                phi_889_ = true;
                            } else {
                                phi_889_ = (_e509 > 0u);
                            }
                            let _e512 = phi_889_;
                            if _e512 {
                                let _e513 = (_e505 > 0u);
                                if _e513 {
                                    if _e507 {
                                        phi_975_ = _e503;
                                        phi_976_ = _e507;
                                        phi_977_ = _e509;
                                    } else {
                                        let _e514 = (_e509 - 1u);
                                        let _e515 = (_e514 % 128u);
                                        let _e516 = (_e515 < 128u);
                                        if _e516 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e518 = local_7[_e515];
                                        if _e516 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e520 = local_6[_e515];
                                        if _e516 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e522 = local_5[_e515];
                                        if _e516 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e524 = local_4[_e515];
                                        if _e516 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e526 = local_3[_e515];
                                        if _e516 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e528 = local_2[_e515];
                                        if _e516 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e533 = local_8[_e515];
                                        if _e516 {
                                        } else {
                                            phi_4405_ = true;
                                            break;
                                        }
                                        let _e536 = local_9[_e515];
                                        phi_975_ = type_49(type_34(vec4<f32>(_e518, _e520, _e522, 0f), vec4<f32>(_e524, _e526, _e528, 0f)), _e533);
                                        phi_976_ = (_e536 <= _e501.member.member_1);
                                        phi_977_ = _e514;
                                    }
                                    let _e541 = phi_975_;
                                    let _e543 = phi_976_;
                                    let _e545 = phi_977_;
                                    if _e543 {
                                        let _e550 = (_e541.member_1 & 268435455u);
                                        if ((_e541.member_1 & 2147483648u) != 0u) {
                                            phi_996_ = _e501;
                                            phi_999_ = type_8(0u, ((_e541.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1017 = phi_996_;
                                                let _e1019 = phi_999_;
                                                local_12 = _e1017;
                                                if (_e1019.member < _e1019.member_1) {
                                                    phi_1000_ = type_8((_e1019.member + 1u), _e1019.member_1);
                                                    phi_1022_ = type_8(1u, _e1019.member);
                                                } else {
                                                    phi_1000_ = _e1019;
                                                    phi_1022_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1032 = phi_1000_;
                                                let _e1034 = phi_1022_;
                                                let _e1038 = (bitcast<i32>(_e1034.member) != 0i);
                                                if _e1038 {
                                                    let _e1044 = type_42(_e1017.member, _e1017.member_1, (_e1017.member_2 + 1u));
                                                    let _e1049 = (_e541.member.member_1.x - _e541.member.member.x);
                                                    let _e1052 = (_e541.member.member_1.y - _e541.member.member.y);
                                                    let _e1055 = (_e541.member.member_1.z - _e541.member.member.z);
                                                    let _e1057 = select(_e1052, _e1049, (_e1049 > _e1052));
                                                    let _e1059 = select(_e1055, _e1057, (_e1057 > _e1055));
                                                    let _e1061 = (_e1059 < (1024f * _e148));
                                                    if _e1061 {
                                                        phi_1066_ = 0u;
                                                    } else {
                                                        phi_1066_ = select(2u, 1u, (_e1059 < (2097152f * _e148)));
                                                    }
                                                    let _e1066 = phi_1066_;
                                                    switch bitcast<i32>(_e1066) {
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
                                                    let _e1069 = phi_1072_;
                                                    switch bitcast<i32>(_e1066) {
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
                                                    let _e1076 = phi_1082_;
                                                    let _e1078 = ((_e550 + (_e1034.member_1 * ((3u * _e1069) + 1u))) + (3u * _e1076));
                                                    let _e1079 = (_e1078 < _e96);
                                                    if _e1079 {
                                                        if _e1079 {
                                                        } else {
                                                            phi_4216_ = true;
                                                            break;
                                                        }
                                                        let _e1081 = global_7.member[_e1078];
                                                        phi_1098_ = _e1081;
                                                    } else {
                                                        phi_1098_ = 4294967295u;
                                                    }
                                                    let _e1083 = phi_1098_;
                                                    if _e1061 {
                                                        phi_1131_ = 0u;
                                                    } else {
                                                        phi_1131_ = select(2u, 1u, (_e1059 < (2097152f * _e148)));
                                                    }
                                                    let _e1088 = phi_1131_;
                                                    switch bitcast<i32>(_e1088) {
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
                                                    let _e1091 = phi_1137_;
                                                    let _e1095 = (_e550 + (_e1034.member_1 * ((3u * _e1091) + 1u)));
                                                    switch bitcast<i32>(_e1088) {
                                                        case 0: {
                                                            let _e1361 = (_e1095 < _e96);
                                                            if _e1361 {
                                                                if _e1361 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1363 = global_7.member[_e1095];
                                                                phi_1161_ = _e1363;
                                                            } else {
                                                                phi_1161_ = 0u;
                                                            }
                                                            let _e1365 = phi_1161_;
                                                            let _e1367 = ((10u * _e274) & 31u);
                                                            let _e1376 = ((10u * _e273) & 31u);
                                                            let _e1385 = ((10u * _e275) & 31u);
                                                            let _e1394 = (_e1095 + 1u);
                                                            let _e1395 = (_e1394 < _e96);
                                                            if _e1395 {
                                                                if _e1395 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1397 = global_7.member[_e1394];
                                                                phi_1204_ = _e1397;
                                                            } else {
                                                                phi_1204_ = 0u;
                                                            }
                                                            let _e1399 = phi_1204_;
                                                            let _e1422 = (_e1095 + 2u);
                                                            let _e1423 = (_e1422 < _e96);
                                                            if _e1423 {
                                                                if _e1423 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1425 = global_7.member[_e1422];
                                                                phi_1247_ = _e1425;
                                                            } else {
                                                                phi_1247_ = 0u;
                                                            }
                                                            let _e1427 = phi_1247_;
                                                            phi_1718_ = array<array<f32, 3>, 3>(array<f32, 3>((_e541.member.member.x + (f32(bitcast<i32>(((_e1365 >> bitcast<u32>(_e1367)) & 1023u))) * _e148)), (_e541.member.member.y + (f32(bitcast<i32>(((_e1365 >> bitcast<u32>(_e1376)) & 1023u))) * _e148)), (_e541.member.member.z + (f32(bitcast<i32>(((_e1365 >> bitcast<u32>(_e1385)) & 1023u))) * _e148))), array<f32, 3>((_e541.member.member.x + (f32(bitcast<i32>(((_e1399 >> bitcast<u32>(_e1367)) & 1023u))) * _e148)), (_e541.member.member.y + (f32(bitcast<i32>(((_e1399 >> bitcast<u32>(_e1376)) & 1023u))) * _e148)), (_e541.member.member.z + (f32(bitcast<i32>(((_e1399 >> bitcast<u32>(_e1385)) & 1023u))) * _e148))), array<f32, 3>((_e541.member.member.x + (f32(bitcast<i32>(((_e1427 >> bitcast<u32>(_e1367)) & 1023u))) * _e148)), (_e541.member.member.y + (f32(bitcast<i32>(((_e1427 >> bitcast<u32>(_e1376)) & 1023u))) * _e148)), (_e541.member.member.z + (f32(bitcast<i32>(((_e1427 >> bitcast<u32>(_e1385)) & 1023u))) * _e148))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1184 = (_e1095 < _e96);
                                                            if _e1184 {
                                                                if _e1184 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1186 = global_7.member[_e1095];
                                                                phi_1290_ = _e1186;
                                                            } else {
                                                                phi_1290_ = 0u;
                                                            }
                                                            let _e1188 = phi_1290_;
                                                            let _e1189 = (_e1095 + 1u);
                                                            let _e1190 = (_e1189 < _e96);
                                                            if _e1190 {
                                                                if _e1190 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1192 = global_7.member[_e1189];
                                                                phi_1305_ = _e1192;
                                                            } else {
                                                                phi_1305_ = 0u;
                                                            }
                                                            let _e1194 = phi_1305_;
                                                            let _e1195 = (_e274 == 1u);
                                                            if _e1195 {
                                                                phi_1315_ = ((_e1188 >> bitcast<u32>(21i)) | (_e1194 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1315_ = (_e1194 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1204 = phi_1315_;
                                                            let _e1211 = (_e273 == 1u);
                                                            if _e1211 {
                                                                phi_1335_ = ((_e1188 >> bitcast<u32>(21i)) | (_e1194 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1335_ = (_e1194 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1220 = phi_1335_;
                                                            let _e1227 = (_e275 == 1u);
                                                            if _e1227 {
                                                                phi_1355_ = ((_e1188 >> bitcast<u32>(21i)) | (_e1194 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1355_ = (_e1194 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1236 = phi_1355_;
                                                            let _e1244 = (_e1095 + 2u);
                                                            let _e1245 = (_e1244 < _e96);
                                                            if _e1245 {
                                                                if _e1245 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1247 = global_7.member[_e1244];
                                                                phi_1381_ = _e1247;
                                                            } else {
                                                                phi_1381_ = 0u;
                                                            }
                                                            let _e1249 = phi_1381_;
                                                            let _e1250 = (_e1095 + 3u);
                                                            let _e1251 = (_e1250 < _e96);
                                                            if _e1251 {
                                                                if _e1251 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1253 = global_7.member[_e1250];
                                                                phi_1396_ = _e1253;
                                                            } else {
                                                                phi_1396_ = 0u;
                                                            }
                                                            let _e1255 = phi_1396_;
                                                            if _e1195 {
                                                                phi_1406_ = ((_e1249 >> bitcast<u32>(21i)) | (_e1255 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1406_ = (_e1255 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1264 = phi_1406_;
                                                            if _e1211 {
                                                                phi_1426_ = ((_e1249 >> bitcast<u32>(21i)) | (_e1255 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1426_ = (_e1255 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1279 = phi_1426_;
                                                            if _e1227 {
                                                                phi_1446_ = ((_e1249 >> bitcast<u32>(21i)) | (_e1255 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1446_ = (_e1255 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1294 = phi_1446_;
                                                            let _e1302 = (_e1095 + 4u);
                                                            let _e1303 = (_e1302 < _e96);
                                                            if _e1303 {
                                                                if _e1303 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1305 = global_7.member[_e1302];
                                                                phi_1472_ = _e1305;
                                                            } else {
                                                                phi_1472_ = 0u;
                                                            }
                                                            let _e1307 = phi_1472_;
                                                            let _e1308 = (_e1095 + 5u);
                                                            let _e1309 = (_e1308 < _e96);
                                                            if _e1309 {
                                                                if _e1309 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1311 = global_7.member[_e1308];
                                                                phi_1487_ = _e1311;
                                                            } else {
                                                                phi_1487_ = 0u;
                                                            }
                                                            let _e1313 = phi_1487_;
                                                            if _e1195 {
                                                                phi_1497_ = ((_e1307 >> bitcast<u32>(21i)) | (_e1313 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1497_ = (_e1313 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1322 = phi_1497_;
                                                            if _e1211 {
                                                                phi_1517_ = ((_e1307 >> bitcast<u32>(21i)) | (_e1313 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1517_ = (_e1313 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1337 = phi_1517_;
                                                            if _e1227 {
                                                                phi_1537_ = ((_e1307 >> bitcast<u32>(21i)) | (_e1313 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1537_ = (_e1313 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1352 = phi_1537_;
                                                            phi_1718_ = array<array<f32, 3>, 3>(array<f32, 3>((_e541.member.member.x + (f32(bitcast<i32>((select(_e1204, _e1188, _e298) & 2097151u))) * _e148)), (_e541.member.member.y + (f32(bitcast<i32>((select(_e1220, _e1188, _e335) & 2097151u))) * _e148)), (_e541.member.member.z + (f32(bitcast<i32>((select(_e1236, _e1188, _e371) & 2097151u))) * _e148))), array<f32, 3>((_e541.member.member.x + (f32(bitcast<i32>((select(_e1264, _e1249, _e298) & 2097151u))) * _e148)), (_e541.member.member.y + (f32(bitcast<i32>((select(_e1279, _e1249, _e335) & 2097151u))) * _e148)), (_e541.member.member.z + (f32(bitcast<i32>((select(_e1294, _e1249, _e371) & 2097151u))) * _e148))), array<f32, 3>((_e541.member.member.x + (f32(bitcast<i32>((select(_e1322, _e1307, _e298) & 2097151u))) * _e148)), (_e541.member.member.y + (f32(bitcast<i32>((select(_e1337, _e1307, _e335) & 2097151u))) * _e148)), (_e541.member.member.z + (f32(bitcast<i32>((select(_e1352, _e1307, _e371) & 2097151u))) * _e148))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1097 = (_e1095 + _e274);
                                                            let _e1098 = (_e1097 < _e96);
                                                            if _e1098 {
                                                                if _e1098 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1100 = global_7.member[_e1097];
                                                                phi_1564_ = _e1100;
                                                            } else {
                                                                phi_1564_ = 0u;
                                                            }
                                                            let _e1102 = phi_1564_;
                                                            let _e1106 = (_e1095 + _e273);
                                                            let _e1107 = (_e1106 < _e96);
                                                            if _e1107 {
                                                                if _e1107 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1109 = global_7.member[_e1106];
                                                                phi_1582_ = _e1109;
                                                            } else {
                                                                phi_1582_ = 0u;
                                                            }
                                                            let _e1111 = phi_1582_;
                                                            let _e1115 = (_e1095 + _e275);
                                                            let _e1116 = (_e1115 < _e96);
                                                            if _e1116 {
                                                                if _e1116 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1118 = global_7.member[_e1115];
                                                                phi_1600_ = _e1118;
                                                            } else {
                                                                phi_1600_ = 0u;
                                                            }
                                                            let _e1120 = phi_1600_;
                                                            let _e1125 = (_e1095 + 3u);
                                                            let _e1126 = (_e1125 + _e274);
                                                            let _e1127 = (_e1126 < _e96);
                                                            if _e1127 {
                                                                if _e1127 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1129 = global_7.member[_e1126];
                                                                phi_1620_ = _e1129;
                                                            } else {
                                                                phi_1620_ = 0u;
                                                            }
                                                            let _e1131 = phi_1620_;
                                                            let _e1135 = (_e1125 + _e273);
                                                            let _e1136 = (_e1135 < _e96);
                                                            if _e1136 {
                                                                if _e1136 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1138 = global_7.member[_e1135];
                                                                phi_1638_ = _e1138;
                                                            } else {
                                                                phi_1638_ = 0u;
                                                            }
                                                            let _e1140 = phi_1638_;
                                                            let _e1144 = (_e1125 + _e275);
                                                            let _e1145 = (_e1144 < _e96);
                                                            if _e1145 {
                                                                if _e1145 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1147 = global_7.member[_e1144];
                                                                phi_1656_ = _e1147;
                                                            } else {
                                                                phi_1656_ = 0u;
                                                            }
                                                            let _e1149 = phi_1656_;
                                                            let _e1154 = (_e1095 + 6u);
                                                            let _e1155 = (_e1154 + _e274);
                                                            let _e1156 = (_e1155 < _e96);
                                                            if _e1156 {
                                                                if _e1156 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1158 = global_7.member[_e1155];
                                                                phi_1676_ = _e1158;
                                                            } else {
                                                                phi_1676_ = 0u;
                                                            }
                                                            let _e1160 = phi_1676_;
                                                            let _e1164 = (_e1154 + _e273);
                                                            let _e1165 = (_e1164 < _e96);
                                                            if _e1165 {
                                                                if _e1165 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1167 = global_7.member[_e1164];
                                                                phi_1694_ = _e1167;
                                                            } else {
                                                                phi_1694_ = 0u;
                                                            }
                                                            let _e1169 = phi_1694_;
                                                            let _e1173 = (_e1154 + _e275);
                                                            let _e1174 = (_e1173 < _e96);
                                                            if _e1174 {
                                                                if _e1174 {
                                                                } else {
                                                                    phi_4216_ = true;
                                                                    break;
                                                                }
                                                                let _e1176 = global_7.member[_e1173];
                                                                phi_1712_ = _e1176;
                                                            } else {
                                                                phi_1712_ = 0u;
                                                            }
                                                            let _e1178 = phi_1712_;
                                                            phi_1718_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1102)) * _e148), (f32(bitcast<i32>(_e1111)) * _e148), (f32(bitcast<i32>(_e1120)) * _e148)), array<f32, 3>((f32(bitcast<i32>(_e1131)) * _e148), (f32(bitcast<i32>(_e1140)) * _e148), (f32(bitcast<i32>(_e1149)) * _e148)), array<f32, 3>((f32(bitcast<i32>(_e1160)) * _e148), (f32(bitcast<i32>(_e1169)) * _e148), (f32(bitcast<i32>(_e1178)) * _e148)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1718_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1452 = phi_1718_;
                                                    let _e1461 = (_e1452[0][2] - _e379);
                                                    let _e1464 = (((_e1452[0][0] - _e306) * _e403) - (_e1461 * _e331));
                                                    let _e1467 = (((_e1452[0][1] - _e343) * _e403) - (_e1461 * _e367));
                                                    let _e1474 = (_e1452[1][2] - _e379);
                                                    let _e1477 = (((_e1452[1][0] - _e306) * _e403) - (_e1474 * _e331));
                                                    let _e1480 = (((_e1452[1][1] - _e343) * _e403) - (_e1474 * _e367));
                                                    let _e1487 = (_e1452[2][2] - _e379);
                                                    let _e1490 = (((_e1452[2][0] - _e306) * _e403) - (_e1487 * _e331));
                                                    let _e1493 = (((_e1452[2][1] - _e343) * _e403) - (_e1487 * _e367));
                                                    let _e1494 = (_e1490 * _e1480);
                                                    let _e1495 = (_e1493 * _e1477);
                                                    let _e1496 = (_e1464 * _e1493);
                                                    let _e1497 = (_e1467 * _e1490);
                                                    let _e1498 = (_e1477 * _e1467);
                                                    let _e1499 = (_e1480 * _e1464);
                                                    let _e1504 = (((_e1494 >= _e1495) && (_e1496 >= _e1497)) && (_e1498 >= _e1499));
                                                    if (_e1504 || (((_e1494 <= _e1495) && (_e1496 <= _e1497)) && (_e1498 <= _e1499))) {
                                                        let _e1511 = select(-1f, 1f, _e1504);
                                                        let _e1513 = ((_e1494 - _e1495) * _e1511);
                                                        let _e1515 = select(0f, _e1513, (_e1513 > 0f));
                                                        let _e1517 = ((_e1496 - _e1497) * _e1511);
                                                        let _e1519 = select(0f, _e1517, (_e1517 > 0f));
                                                        let _e1521 = ((_e1498 - _e1499) * _e1511);
                                                        let _e1523 = select(0f, _e1521, (_e1521 > 0f));
                                                        let _e1525 = ((_e1515 + _e1519) + _e1523);
                                                        if (_e1525 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2546_ = type_22();
                                                            phi_2547_ = true;
                                                            phi_2548_ = false;
                                                        } else {
                                                            let _e1528 = select(_e1477, _e1464, (_e1464 < _e1477));
                                                            if (select(_e1490, _e1528, (_e1528 < _e1490)) > 0f) {
                                                                phi_1835_ = true;
                                                            } else {
                                                                let _e1533 = select(_e1477, _e1464, (_e1464 > _e1477));
                                                                phi_1835_ = (select(_e1490, _e1533, (_e1533 > _e1490)) < 0f);
                                                            }
                                                            let _e1538 = phi_1835_;
                                                            if _e1538 {
                                                                phi_2543_ = type_22();
                                                                phi_2544_ = true;
                                                                phi_2545_ = false;
                                                            } else {
                                                                let _e1540 = select(_e1480, _e1467, (_e1467 < _e1480));
                                                                if (select(_e1493, _e1540, (_e1540 < _e1493)) > 0f) {
                                                                    phi_1864_ = true;
                                                                } else {
                                                                    let _e1545 = select(_e1480, _e1467, (_e1467 > _e1480));
                                                                    phi_1864_ = (select(_e1493, _e1545, (_e1545 > _e1493)) < 0f);
                                                                }
                                                                let _e1550 = phi_1864_;
                                                                if _e1550 {
                                                                    phi_2541_ = type_22();
                                                                    phi_2542_ = false;
                                                                } else {
                                                                    let _e1552 = select(_e1452[1][0], _e1452[0][0], (_e1452[0][0] < _e1452[1][0]));
                                                                    let _e1556 = select(_e1452[1][0], _e1452[0][0], (_e1452[0][0] > _e1452[1][0]));
                                                                    let _e1560 = select(_e1452[1][1], _e1452[0][1], (_e1452[0][1] < _e1452[1][1]));
                                                                    let _e1564 = select(_e1452[1][1], _e1452[0][1], (_e1452[0][1] > _e1452[1][1]));
                                                                    let _e1568 = select(_e1452[1][2], _e1452[0][2], (_e1452[0][2] < _e1452[1][2]));
                                                                    let _e1572 = select(_e1452[1][2], _e1452[0][2], (_e1452[0][2] > _e1452[1][2]));
                                                                    let _e1577 = ((select(_e1452[2][0], _e1552, (_e1552 < _e1452[2][0])) - _e329) * _e334);
                                                                    let _e1578 = ((select(_e1452[2][0], _e1556, (_e1556 > _e1452[2][0])) - _e330) * _e334);
                                                                    let _e1581 = ((select(_e1452[2][1], _e1560, (_e1560 < _e1452[2][1])) - _e365) * _e370);
                                                                    let _e1582 = ((select(_e1452[2][1], _e1564, (_e1564 > _e1452[2][1])) - _e366) * _e370);
                                                                    let _e1585 = ((select(_e1452[2][2], _e1568, (_e1568 < _e1452[2][2])) - _e401) * _e406);
                                                                    let _e1586 = ((select(_e1452[2][2], _e1572, (_e1572 > _e1452[2][2])) - _e402) * _e406);
                                                                    let _e1588 = select(_e1586, _e1585, (_e1585 < _e1586));
                                                                    let _e1590 = select(_e1586, _e1585, (_e1585 > _e1586));
                                                                    let _e1592 = select(_e1578, _e1577, (_e1577 < _e1578));
                                                                    let _e1594 = select(_e1582, _e1581, (_e1581 < _e1582));
                                                                    let _e1596 = select(_e1594, _e1592, (_e1592 > _e1594));
                                                                    let _e1598 = select(_e1588, _e1596, (_e1596 > _e1588));
                                                                    let _e1600 = select(_e1578, _e1577, (_e1577 > _e1578));
                                                                    let _e1602 = select(_e1582, _e1581, (_e1581 > _e1582));
                                                                    let _e1604 = select(_e1602, _e1600, (_e1600 < _e1602));
                                                                    let _e1606 = select(_e1590, _e1604, (_e1604 < _e1590));
                                                                    let _e1607 = -(_e1588);
                                                                    let _e1613 = select(_e452, _e1598, (_e1598 > _e452));
                                                                    if (_e1613 > (_e1606 + (select(_e1607, _e1590, (_e1590 > _e1607)) * 0.0000019073523f))) {
                                                                        phi_2536_ = type_22();
                                                                        phi_2537_ = true;
                                                                    } else {
                                                                        let _e1615 = (_e1613 > _e1017.member.member_1);
                                                                        if _e1615 {
                                                                            phi_2535_ = type_22();
                                                                        } else {
                                                                            let _e1616 = vec3<f32>(_e1452[0][0], _e1452[0][1], _e1452[0][2]);
                                                                            let _e1617 = vec3<f32>(_e1452[1][0], _e1452[1][1], _e1452[1][2]);
                                                                            let _e1618 = vec3<f32>(_e1452[2][0], _e1452[2][1], _e1452[2][2]);
                                                                            let _e1619 = (_e1452[1][0] - _e1452[0][0]);
                                                                            let _e1620 = (_e1452[1][1] - _e1452[0][1]);
                                                                            let _e1621 = (_e1452[1][2] - _e1452[0][2]);
                                                                            let _e1622 = vec3<f32>(_e1619, _e1620, _e1621);
                                                                            let _e1623 = (_e1452[2][0] - _e1452[1][0]);
                                                                            let _e1624 = (_e1452[2][1] - _e1452[1][1]);
                                                                            let _e1625 = (_e1452[2][2] - _e1452[1][2]);
                                                                            let _e1626 = vec3<f32>(_e1623, _e1624, _e1625);
                                                                            let _e1627 = (_e1452[0][0] - _e1452[2][0]);
                                                                            let _e1628 = (_e1452[0][1] - _e1452[2][1]);
                                                                            let _e1629 = (_e1452[0][2] - _e1452[2][2]);
                                                                            let _e1630 = vec3<f32>(_e1627, _e1628, _e1629);
                                                                            let _e1633 = bitcast<f32>((bitcast<u32>(_e1619) & 2147483647u));
                                                                            let _e1636 = bitcast<f32>((bitcast<u32>(_e1620) & 2147483647u));
                                                                            let _e1638 = select(_e1636, _e1633, (_e1633 > _e1636));
                                                                            let _e1641 = bitcast<f32>((bitcast<u32>(_e1621) & 2147483647u));
                                                                            let _e1643 = select(_e1641, _e1638, (_e1638 > _e1641));
                                                                            let _e1646 = bitcast<f32>((bitcast<u32>(_e1623) & 2147483647u));
                                                                            let _e1649 = bitcast<f32>((bitcast<u32>(_e1624) & 2147483647u));
                                                                            let _e1651 = select(_e1649, _e1646, (_e1646 > _e1649));
                                                                            let _e1654 = bitcast<f32>((bitcast<u32>(_e1625) & 2147483647u));
                                                                            let _e1656 = select(_e1654, _e1651, (_e1651 > _e1654));
                                                                            let _e1659 = bitcast<f32>((bitcast<u32>(_e1627) & 2147483647u));
                                                                            let _e1662 = bitcast<f32>((bitcast<u32>(_e1628) & 2147483647u));
                                                                            let _e1664 = select(_e1662, _e1659, (_e1659 > _e1662));
                                                                            let _e1667 = bitcast<f32>((bitcast<u32>(_e1629) & 2147483647u));
                                                                            let _e1669 = select(_e1667, _e1664, (_e1664 > _e1667));
                                                                            let _e1671 = select(_e1656, _e1643, (_e1643 > _e1656));
                                                                            let _e1673 = select(_e1669, _e1671, (_e1671 > _e1669));
                                                                            if (_e1643 == _e1673) {
                                                                                phi_2265_ = _e1480;
                                                                                phi_2266_ = _e1477;
                                                                                phi_2267_ = _e1467;
                                                                                phi_2268_ = _e1464;
                                                                                phi_2269_ = _e1616;
                                                                                phi_2270_ = _e1630;
                                                                                phi_2271_ = _e1626;
                                                                                phi_2272_ = _e1622;
                                                                            } else {
                                                                                let _e1675 = (_e1656 == _e1673);
                                                                                let _e1680 = vec3(_e1675);
                                                                                phi_2265_ = select(_e1467, _e1493, _e1675);
                                                                                phi_2266_ = select(_e1464, _e1490, _e1675);
                                                                                phi_2267_ = select(_e1493, _e1480, _e1675);
                                                                                phi_2268_ = select(_e1490, _e1477, _e1675);
                                                                                phi_2269_ = select(_e1618, _e1617, _e1680);
                                                                                phi_2270_ = select(_e1626, _e1622, _e1680);
                                                                                phi_2271_ = select(_e1622, _e1630, _e1680);
                                                                                phi_2272_ = select(_e1630, _e1626, _e1680);
                                                                            }
                                                                            let _e1686 = phi_2265_;
                                                                            let _e1688 = phi_2266_;
                                                                            let _e1690 = phi_2267_;
                                                                            let _e1692 = phi_2268_;
                                                                            let _e1694 = phi_2269_;
                                                                            let _e1696 = phi_2270_;
                                                                            let _e1698 = phi_2271_;
                                                                            let _e1700 = phi_2272_;
                                                                            let _e1707 = ((_e1698.y * _e1696.z) - (_e1696.y * _e1698.z));
                                                                            let _e1712 = ((_e1698.z * _e1696.x) - (_e1696.z * _e1698.x));
                                                                            let _e1715 = ((_e1698.x * _e1696.y) - (_e1696.x * _e1698.y));
                                                                            if (_e1515 >= _e1519) {
                                                                                phi_2303_ = select(true, false, (_e1515 >= _e1523));
                                                                            } else {
                                                                                phi_2303_ = true;
                                                                            }
                                                                            let _e1720 = phi_2303_;
                                                                            if _e1720 {
                                                                                phi_2312_ = select(_e1618, _e1617, vec3((_e1519 >= _e1523)));
                                                                            } else {
                                                                                phi_2312_ = _e1616;
                                                                            }
                                                                            let _e1725 = phi_2312_;
                                                                            let _e1730 = (((_e1707 * _e331) + (_e1712 * _e367)) + (_e1715 * _e403));
                                                                            let _e1741 = (((_e1707 * (_e1725.x - _e306)) + (_e1712 * (_e1725.y - _e343))) + (_e1715 * (_e1725.z - _e379)));
                                                                            let _e1743 = (_e1688 - _e1692);
                                                                            let _e1744 = (_e1686 - _e1690);
                                                                            let _e1752 = (-(((_e1692 * _e1743) + (_e1690 * _e1744))) / ((_e1743 * _e1743) + (_e1744 * _e1744)));
                                                                            let _e1754 = select(1f, _e1752, (_e1752 < 1f));
                                                                            let _e1756 = select(0f, _e1754, (_e1754 > 0f));
                                                                            let _e1769 = ((_e1694.x + (_e1700.x * _e1756)) - _e306);
                                                                            let _e1770 = ((_e1694.y + (_e1700.y * _e1756)) - _e343);
                                                                            let _e1771 = ((_e1694.z + (_e1700.z * _e1756)) - _e379);
                                                                            let _e1772 = (_e1771 / _e403);
                                                                            let _e1784 = bitcast<f32>((bitcast<u32>(_e1769) & 2147483647u));
                                                                            let _e1787 = bitcast<f32>((bitcast<u32>(_e1770) & 2147483647u));
                                                                            let _e1789 = select(_e1787, _e1784, (_e1784 > _e1787));
                                                                            let _e1792 = bitcast<f32>((bitcast<u32>(_e1771) & 2147483647u));
                                                                            let _e1794 = select(_e1792, _e1789, (_e1789 > _e1792));
                                                                            let _e1800 = bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u));
                                                                            let _e1803 = bitcast<f32>((bitcast<u32>(_e1712) & 2147483647u));
                                                                            let _e1805 = select(_e1803, _e1800, (_e1800 > _e1803));
                                                                            let _e1808 = bitcast<f32>((bitcast<u32>(_e1715) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1707 * _e1769) + (_e1712 * _e1770)) + (_e1715 * _e1771)) - _e1741)) & 2147483647u)) <= ((0.0000009536743f * select(_e1673, _e1794, (_e1794 > _e1673))) * select(_e1808, _e1805, (_e1805 > _e1808)))) {
                                                                                let _e1818 = bitcast<f32>((bitcast<u32>(_e1698.x) & 2147483647u));
                                                                                let _e1821 = bitcast<f32>((bitcast<u32>(_e1698.y) & 2147483647u));
                                                                                let _e1823 = select(_e1821, _e1818, (_e1818 > _e1821));
                                                                                let _e1826 = bitcast<f32>((bitcast<u32>(_e1698.z) & 2147483647u));
                                                                                let _e1832 = bitcast<f32>((bitcast<u32>(_e1696.x) & 2147483647u));
                                                                                let _e1835 = bitcast<f32>((bitcast<u32>(_e1696.y) & 2147483647u));
                                                                                let _e1837 = select(_e1835, _e1832, (_e1832 > _e1835));
                                                                                let _e1840 = bitcast<f32>((bitcast<u32>(_e1696.z) & 2147483647u));
                                                                                phi_2479_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1730) & 2147483647u)) > ((0.0000038146973f * select(_e1826, _e1823, (_e1823 > _e1826))) * select(_e1840, _e1837, (_e1837 > _e1840)))));
                                                                            } else {
                                                                                phi_2479_ = true;
                                                                            }
                                                                            let _e1847 = phi_2479_;
                                                                            if _e1847 {
                                                                                let _e1858 = ((((_e1707 * (_e1769 - (_e331 * _e1772))) + (_e1712 * (_e1770 - (_e367 * _e1772)))) + (_e1715 * (_e1771 - _e1771))) / _e1730);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1858) & 2147483647u)) <= _e1673) {
                                                                                    phi_2503_ = (_e1772 + _e1858);
                                                                                } else {
                                                                                    phi_2503_ = _e1772;
                                                                                }
                                                                                let _e1865 = phi_2503_;
                                                                                phi_2504_ = _e1865;
                                                                            } else {
                                                                                phi_2504_ = (_e1741 / _e1730);
                                                                            }
                                                                            let _e1867 = phi_2504_;
                                                                            let _e1869 = select(_e1606, _e1867, (_e1867 < _e1606));
                                                                            let _e1871 = select(_e1598, _e1869, (_e1869 > _e1598));
                                                                            if (_e1871 >= _e452) {
                                                                                let _e1873 = (_e1871 <= _e1017.member.member_1);
                                                                                if _e1873 {
                                                                                    let _e1874 = (1f / _e1525);
                                                                                    phi_2527_ = type_22(_e1871, (_e1519 * _e1874), (_e1523 * _e1874), _e1083);
                                                                                } else {
                                                                                    phi_2527_ = type_22();
                                                                                }
                                                                                let _e1879 = phi_2527_;
                                                                                phi_2529_ = _e1879;
                                                                                phi_2530_ = select(true, false, _e1873);
                                                                            } else {
                                                                                phi_2529_ = type_22();
                                                                                phi_2530_ = true;
                                                                            }
                                                                            let _e1882 = phi_2529_;
                                                                            let _e1884 = phi_2530_;
                                                                            if _e1884 {
                                                                                phi_2534_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2534_ = _e1882;
                                                                            }
                                                                            let _e1886 = phi_2534_;
                                                                            phi_2535_ = _e1886;
                                                                        }
                                                                        let _e1888 = phi_2535_;
                                                                        phi_2536_ = _e1888;
                                                                        phi_2537_ = _e1615;
                                                                    }
                                                                    let _e1890 = phi_2536_;
                                                                    let _e1892 = phi_2537_;
                                                                    phi_2541_ = _e1890;
                                                                    phi_2542_ = _e1892;
                                                                }
                                                                let _e1894 = phi_2541_;
                                                                let _e1896 = phi_2542_;
                                                                phi_2543_ = _e1894;
                                                                phi_2544_ = _e1550;
                                                                phi_2545_ = _e1896;
                                                            }
                                                            let _e1898 = phi_2543_;
                                                            let _e1900 = phi_2544_;
                                                            let _e1902 = phi_2545_;
                                                            phi_2546_ = _e1898;
                                                            phi_2547_ = _e1900;
                                                            phi_2548_ = _e1902;
                                                        }
                                                        let _e1904 = phi_2546_;
                                                        let _e1906 = phi_2547_;
                                                        let _e1908 = phi_2548_;
                                                        phi_2556_ = _e1904;
                                                        phi_2557_ = select(_e1908, true, _e1906);
                                                    } else {
                                                        phi_2556_ = type_22();
                                                        phi_2557_ = true;
                                                    }
                                                    let _e1911 = phi_2556_;
                                                    let _e1913 = phi_2557_;
                                                    if _e1913 {
                                                        phi_2561_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2561_ = _e1911;
                                                    }
                                                    let _e1915 = phi_2561_;
                                                    if (_e1915.member_3 != 4294967295u) {
                                                        if (_e1083 != _e458) {
                                                            if (_e1915.member < _e1017.member.member.member) {
                                                                phi_2587_ = true;
                                                            } else {
                                                                if (_e1915.member == _e1017.member.member.member) {
                                                                    phi_2586_ = (_e1915.member_3 < _e1017.member.member.member_3);
                                                                } else {
                                                                    phi_2586_ = false;
                                                                }
                                                                let _e1930 = phi_2586_;
                                                                phi_2587_ = _e1930;
                                                            }
                                                            let _e1932 = phi_2587_;
                                                            if _e1932 {
                                                                phi_2594_ = type_42(type_38(_e1915, _e1915.member), _e1044.member_1, _e1044.member_2);
                                                            } else {
                                                                phi_2594_ = _e1044;
                                                            }
                                                            let _e1939 = phi_2594_;
                                                            phi_2595_ = _e1939;
                                                        } else {
                                                            phi_2595_ = _e1044;
                                                        }
                                                        let _e1941 = phi_2595_;
                                                        phi_2596_ = _e1941;
                                                    } else {
                                                        phi_2596_ = _e1044;
                                                    }
                                                    let _e1943 = phi_2596_;
                                                    phi_997_ = _e1943;
                                                } else {
                                                    phi_997_ = type_42();
                                                }
                                                let _e1945 = phi_997_;
                                                continue;
                                                continuing {
                                                    phi_996_ = _e1945;
                                                    phi_999_ = _e1032;
                                                    phi_4216_ = _e499;
                                                    break if !(_e1038);
                                                }
                                            }
                                            let _e1948 = phi_4216_;
                                            phi_4405_ = _e1948;
                                            if _e1948 {
                                                break;
                                            }
                                            phi_4409_ = _e1948;
                                            let _e2216 = local_12;
                                            phi_3839_ = _e2216;
                                            phi_3840_ = _e541;
                                            phi_3841_ = false;
                                            phi_3842_ = _e545;
                                        } else {
                                            if (_e541.member_1 >= _e93) {
                                                phi_3395_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e541.member_1 < _e93) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e564 = ((1u + _e274) % 4u);
                                                if (_e564 < 4u) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e569 = global_3.member[_e541.member_1][_e564];
                                                let _e571 = (_e569 >> bitcast<u32>(11u));
                                                let _e573 = ((1u + _e273) % 4u);
                                                if (_e573 < 4u) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e578 = global_3.member[_e541.member_1][_e573];
                                                let _e580 = (_e578 >> bitcast<u32>(11u));
                                                let _e582 = ((1u + _e275) % 4u);
                                                if (_e582 < 4u) {
                                                } else {
                                                    phi_4405_ = true;
                                                    break;
                                                }
                                                let _e587 = global_3.member[_e541.member_1][_e582];
                                                let _e589 = (_e587 >> bitcast<u32>(11u));
                                                let _e612 = (bitcast<f32>((bitcast<u32>((_e541.member.member_1.x - _e541.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e613 = (bitcast<f32>((bitcast<u32>((_e541.member.member_1.y - _e541.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e614 = (bitcast<f32>((bitcast<u32>((_e541.member.member_1.z - _e541.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e616 = select(_e148, _e612, (_e612 > _e148));
                                                let _e618 = select(_e148, _e613, (_e613 > _e148));
                                                let _e620 = select(_e148, _e614, (_e614 > _e148));
                                                let _e645 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e616));
                                                let _e650 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e653 = bitcast<f32>((_e645 & bitcast<u32>(_e650)));
                                                let _e654 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e618));
                                                let _e659 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                                let _e663 = bitcast<u32>((f32(bitcast<i32>((_e587 & 1023u))) * _e620));
                                                let _e668 = (bitcast<i32>((_e587 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e671 = bitcast<f32>((_e663 & bitcast<u32>(_e668)));
                                                let _e675 = bitcast<f32>((_e645 & bitcast<u32>(~(_e650))));
                                                let _e679 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                                let _e683 = bitcast<f32>((_e663 & bitcast<u32>(~(_e668))));
                                                let _e684 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e616));
                                                let _e689 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e692 = bitcast<f32>((_e684 & bitcast<u32>(_e689)));
                                                let _e693 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e618));
                                                let _e698 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                                let _e702 = bitcast<u32>((f32(bitcast<i32>((_e589 & 1023u))) * _e620));
                                                let _e707 = (bitcast<i32>((_e589 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e710 = bitcast<f32>((_e702 & bitcast<u32>(_e707)));
                                                let _e714 = bitcast<f32>((_e684 & bitcast<u32>(~(_e689))));
                                                let _e718 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                                let _e722 = bitcast<f32>((_e702 & bitcast<u32>(~(_e707))));
                                                let _e723 = (_e541.member.member.x + _e653);
                                                let _e724 = (_e541.member.member.y + _e662);
                                                let _e725 = (_e541.member.member.z + _e671);
                                                let _e728 = (_e541.member.member_1.x - _e692);
                                                let _e729 = (_e541.member.member_1.y - _e701);
                                                let _e730 = (_e541.member.member_1.z - _e710);
                                                let _e749 = (_e728 - _e723);
                                                let _e750 = (_e729 - _e724);
                                                let _e751 = (_e730 - _e725);
                                                let _e753 = select(_e750, _e749, (_e749 > _e750));
                                                let _e755 = select(_e751, _e753, (_e753 > _e751));
                                                if (_e755 < (1024f * _e148)) {
                                                    phi_3096_ = 0u;
                                                } else {
                                                    phi_3096_ = select(2u, 1u, (_e755 < (2097152f * _e148)));
                                                }
                                                let _e762 = phi_3096_;
                                                switch bitcast<i32>(_e762) {
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
                                                let _e765 = phi_3102_;
                                                let _e771 = global_3.member[_e541.member_1][0u];
                                                let _e775 = global_3.member[_e541.member_1][1u];
                                                let _e779 = global_3.member[_e541.member_1][2u];
                                                let _e783 = global_3.member[_e541.member_1][3u];
                                                let _e795 = (((_e775 >> bitcast<u32>(22i)) | ((_e779 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e783 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e796 = (_e771 & 268435455u);
                                                let _e797 = (_e795 & 268435455u);
                                                let _e800 = ((_e771 >> bitcast<u32>(28u)) & 7u);
                                                let _e808 = ((_e771 >> bitcast<u32>(31i)) | (((_e795 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e809 = (_e800 != 0u);
                                                if (_e800 == 0u) {
                                                    phi_3357_ = _e796;
                                                } else {
                                                    if (_e800 == 7u) {
                                                        phi_3356_ = 2147483648u;
                                                    } else {
                                                        phi_3356_ = ((2147483648u | (_e800 << bitcast<u32>(28u))) | (_e797 & 268435455u));
                                                    }
                                                    let _e818 = phi_3356_;
                                                    phi_3357_ = _e818;
                                                }
                                                let _e820 = phi_3357_;
                                                if _e809 {
                                                    let _e821 = (_e800 != 7u);
                                                    if _e821 {
                                                        phi_3367_ = (_e797 + (_e800 * ((3u * _e765) + 1u)));
                                                    } else {
                                                        phi_3367_ = u32();
                                                    }
                                                    let _e825 = phi_3367_;
                                                    phi_3369_ = _e825;
                                                    phi_3370_ = select(true, false, _e821);
                                                } else {
                                                    phi_3369_ = u32();
                                                    phi_3370_ = true;
                                                }
                                                let _e828 = phi_3369_;
                                                let _e830 = phi_3370_;
                                                if (_e808 == 0u) {
                                                    phi_3391_ = (_e796 + select(0u, 1u, !(_e809)));
                                                } else {
                                                    if (_e808 == 7u) {
                                                        phi_3390_ = 2147483648u;
                                                    } else {
                                                        phi_3390_ = ((2147483648u | (_e808 << bitcast<u32>(28u))) | (select(_e828, _e797, _e830) & 268435455u));
                                                    }
                                                    let _e843 = phi_3390_;
                                                    phi_3391_ = _e843;
                                                }
                                                let _e845 = phi_3391_;
                                                phi_3395_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e723, (_e541.member.member.x + _e675), _e728, (_e541.member.member_1.x - _e714)), vec4<f32>(_e724, (_e541.member.member.y + _e679), _e729, (_e541.member.member_1.y - _e718)), vec4<f32>(_e725, (_e541.member.member.z + _e683), _e730, (_e541.member.member_1.z - _e722))), type_49(type_34((_e541.member.member + vec4<f32>(_e653, _e662, _e671, 0f)), (_e541.member.member_1 - vec4<f32>(_e692, _e701, _e710, 0f))), _e820), type_49(type_34((_e541.member.member + vec4<f32>(_e675, _e679, _e683, 0f)), (_e541.member.member_1 - vec4<f32>(_e714, _e718, _e722, 0f))), _e845));
                                            }
                                            let _e850 = phi_3395_;
                                            let _e863 = ((_e850.member[0].x - _e329) * _e334);
                                            let _e864 = ((_e850.member[0].y - _e329) * _e334);
                                            let _e865 = ((_e850.member[0].z - _e330) * _e334);
                                            let _e866 = ((_e850.member[0].w - _e330) * _e334);
                                            let _e876 = ((_e850.member[1].x - _e365) * _e370);
                                            let _e877 = ((_e850.member[1].y - _e365) * _e370);
                                            let _e878 = ((_e850.member[1].z - _e366) * _e370);
                                            let _e879 = ((_e850.member[1].w - _e366) * _e370);
                                            let _e889 = ((_e850.member[2].x - _e401) * _e406);
                                            let _e890 = ((_e850.member[2].y - _e401) * _e406);
                                            let _e891 = ((_e850.member[2].z - _e402) * _e406);
                                            let _e892 = ((_e850.member[2].w - _e402) * _e406);
                                            let _e894 = select(_e891, _e889, (_e889 < _e891));
                                            let _e896 = select(_e892, _e890, (_e890 < _e892));
                                            let _e898 = select(_e891, _e889, (_e889 > _e891));
                                            let _e900 = select(_e892, _e890, (_e890 > _e892));
                                            let _e902 = select(_e865, _e863, (_e863 < _e865));
                                            let _e904 = select(_e866, _e864, (_e864 < _e866));
                                            let _e906 = select(_e878, _e876, (_e876 < _e878));
                                            let _e908 = select(_e879, _e877, (_e877 < _e879));
                                            let _e910 = select(_e906, _e902, (_e902 > _e906));
                                            let _e912 = select(_e908, _e904, (_e904 > _e908));
                                            let _e914 = select(_e894, _e910, (_e910 > _e894));
                                            let _e916 = select(_e896, _e912, (_e912 > _e896));
                                            let _e918 = select(_e865, _e863, (_e863 > _e865));
                                            let _e920 = select(_e866, _e864, (_e864 > _e866));
                                            let _e922 = select(_e878, _e876, (_e876 > _e878));
                                            let _e924 = select(_e879, _e877, (_e877 > _e879));
                                            let _e926 = select(_e922, _e918, (_e918 < _e922));
                                            let _e928 = select(_e924, _e920, (_e920 < _e924));
                                            let _e933 = -(_e894);
                                            let _e934 = -(_e896);
                                            let _e941 = (select(_e898, _e926, (_e926 < _e898)) + (select(_e933, _e898, (_e898 > _e933)) * 0.0000019073523f));
                                            let _e942 = (select(_e900, _e928, (_e928 < _e900)) + (select(_e934, _e900, (_e900 > _e934)) * 0.0000019073523f));
                                            let _e944 = select(_e452, _e914, (_e914 > _e452));
                                            let _e946 = select(_e452, _e916, (_e916 > _e452));
                                            let _e951 = (_e944 <= select(_e501.member.member_1, _e941, (_e941 < _e501.member.member_1)));
                                            let _e952 = (_e946 <= select(_e501.member.member_1, _e942, (_e942 < _e501.member.member_1)));
                                            let _e953 = (_e944 <= _e946);
                                            if _e951 {
                                                if _e952 {
                                                    if _e953 {
                                                        phi_3739_ = _e850.member_2;
                                                    } else {
                                                        phi_3739_ = _e850.member_1;
                                                    }
                                                    let _e957 = phi_3739_;
                                                    let _e979 = (_e545 % 128u);
                                                    let _e980 = (_e979 < 128u);
                                                    if _e980 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_8[_e979] = _e957.member_1;
                                                    if _e980 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_7[_e979] = _e957.member.member.x;
                                                    if _e980 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_6[_e979] = _e957.member.member.y;
                                                    if _e980 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_5[_e979] = _e957.member.member.z;
                                                    if _e980 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_4[_e979] = _e957.member.member_1.x;
                                                    if _e980 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_3[_e979] = _e957.member.member_1.y;
                                                    if _e980 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_2[_e979] = _e957.member.member_1.z;
                                                    if _e980 {
                                                    } else {
                                                        phi_4405_ = true;
                                                        break;
                                                    }
                                                    local_9[_e979] = select(_e946, _e944, (_e944 > _e946));
                                                    if _e953 {
                                                        phi_3816_ = _e850.member_1;
                                                    } else {
                                                        phi_3816_ = _e850.member_2;
                                                    }
                                                    let _e993 = phi_3816_;
                                                    phi_3817_ = _e993;
                                                    phi_3818_ = (_e545 + 1u);
                                                } else {
                                                    phi_3817_ = type_49();
                                                    phi_3818_ = u32();
                                                }
                                                let _e995 = phi_3817_;
                                                let _e997 = phi_3818_;
                                                phi_3820_ = _e995;
                                                phi_3821_ = _e997;
                                                phi_3822_ = select(true, false, _e952);
                                            } else {
                                                phi_3820_ = type_49();
                                                phi_3821_ = u32();
                                                phi_3822_ = true;
                                            }
                                            let _e1000 = phi_3820_;
                                            let _e1002 = phi_3821_;
                                            let _e1004 = phi_3822_;
                                            if _e1004 {
                                                if _e951 {
                                                    phi_3831_ = _e850.member_1;
                                                } else {
                                                    phi_3831_ = _e850.member_2;
                                                }
                                                let _e1008 = phi_3831_;
                                                phi_3836_ = _e1008;
                                                phi_3837_ = select(_e952, true, _e951);
                                            } else {
                                                phi_3836_ = _e1000;
                                                phi_3837_ = _e543;
                                            }
                                            let _e1011 = phi_3836_;
                                            let _e1013 = phi_3837_;
                                            phi_4409_ = _e499;
                                            phi_3839_ = type_42(_e501.member, (_e501.member_1 + 1u), _e501.member_2);
                                            phi_3840_ = _e1011;
                                            phi_3841_ = _e1013;
                                            phi_3842_ = select(_e1002, _e545, _e1004);
                                        }
                                        let _e1950 = phi_4409_;
                                        let _e1952 = phi_3839_;
                                        let _e1954 = phi_3840_;
                                        let _e1956 = phi_3841_;
                                        let _e1958 = phi_3842_;
                                        phi_4408_ = _e1950;
                                        phi_3843_ = _e1952;
                                        phi_3844_ = _e1954;
                                        phi_3845_ = (_e505 - 1u);
                                        phi_3846_ = _e1956;
                                        phi_3847_ = _e1958;
                                    } else {
                                        phi_4408_ = _e499;
                                        phi_3843_ = _e501;
                                        phi_3844_ = _e541;
                                        phi_3845_ = _e505;
                                        phi_3846_ = _e543;
                                        phi_3847_ = _e545;
                                    }
                                    let _e1960 = phi_4408_;
                                    let _e1962 = phi_3843_;
                                    let _e1964 = phi_3844_;
                                    let _e1966 = phi_3845_;
                                    let _e1968 = phi_3846_;
                                    let _e1970 = phi_3847_;
                                    phi_4407_ = _e1960;
                                    phi_3848_ = _e1962;
                                    phi_3849_ = _e1964;
                                    phi_3850_ = _e1966;
                                    phi_3851_ = _e1968;
                                    phi_3852_ = _e1970;
                                } else {
                                    phi_4407_ = _e499;
                                    phi_3848_ = type_42();
                                    phi_3849_ = type_49();
                                    phi_3850_ = u32();
                                    phi_3851_ = bool();
                                    phi_3852_ = u32();
                                }
                                let _e1972 = phi_4407_;
                                let _e1974 = phi_3848_;
                                let _e1976 = phi_3849_;
                                let _e1978 = phi_3850_;
                                let _e1980 = phi_3851_;
                                let _e1982 = phi_3852_;
                                phi_4406_ = _e1972;
                                phi_870_ = _e1974;
                                phi_873_ = _e1976;
                                phi_875_ = _e1978;
                                phi_877_ = _e1980;
                                phi_879_ = _e1982;
                                phi_3853_ = _e513;
                            } else {
                                phi_4406_ = _e499;
                                phi_870_ = type_42();
                                phi_873_ = type_49();
                                phi_875_ = u32();
                                phi_877_ = bool();
                                phi_879_ = u32();
                                phi_3853_ = false;
                            }
                            let _e1984 = phi_4406_;
                            let _e1986 = phi_870_;
                            let _e1988 = phi_873_;
                            let _e1990 = phi_875_;
                            let _e1992 = phi_877_;
                            let _e1994 = phi_879_;
                            let _e1996 = phi_3853_;
                            continue;
                            continuing {
                                phi_4222_ = _e1984;
                                phi_869_ = _e1986;
                                phi_872_ = _e1988;
                                phi_874_ = _e1990;
                                phi_876_ = _e1992;
                                phi_878_ = _e1994;
                                phi_4405_ = _e1984;
                                break if !(_e1996);
                            }
                        }
                        let _e1999 = phi_4405_;
                        if _e1999 {
                            break;
                        }
                        let _e2001 = local_10;
                        if (_e2001.member.member.member_3 != 4294967295u) {
                            let _e2007 = (_e276 / 3i);
                            let _e2014 = bitcast<f32>((bitcast<u32>((_e2007 + 127i)) << bitcast<u32>(23i)));
                            let _e2022 = (((_e2001.member.member.member * _e2014) * _e2014) * bitcast<f32>((bitcast<u32>(((_e276 - (2i * _e2007)) + 127i)) << bitcast<u32>(23i))));
                            let _e2024 = select(340282350000000000000000000000000000000f, _e2022, (_e2022 < 340282350000000000000000000000000000000f));
                            phi_3905_ = type_22(select(-340282350000000000000000000000000000000f, _e2024, (_e2024 > -340282350000000000000000000000000000000f)), _e2001.member.member.member_1, _e2001.member.member.member_2, _e2001.member.member.member_3);
                        } else {
                            phi_3905_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2031 = phi_3905_;
                        if _e152 {
                        } else {
                            break;
                        }
                        global_1.member[_e136] = _e2031;
                        let _e2035 = local_11;
                        if _e153 {
                        } else {
                            break;
                        }
                        global_5.member[_e136] = _e2035.member_1;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e2040 = select(0u, 1u, (_e220 <= _e230));
                        if (_e2040 > 0u) {
                            let _e2042 = (1u < _e104);
                            if _e2042 {
                                if (0u < _e104) {
                                } else {
                                    break;
                                }
                                let _e2046 = atomicAdd((&global_6.member[0u]), _e2040);
                                if ((_e2046 + _e2040) < _e2046) {
                                    if _e2042 {
                                    } else {
                                        break;
                                    }
                                    let _e2051 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2054 = select(0u, 1u, (_e2031.member_3 != 4294967295u));
                        if (_e2054 > 0u) {
                            let _e2056 = (3u < _e104);
                            if _e2056 {
                                if (2u < _e104) {
                                } else {
                                    break;
                                }
                                let _e2060 = atomicAdd((&global_6.member[2u]), _e2054);
                                if ((_e2060 + _e2054) < _e2060) {
                                    if _e2056 {
                                    } else {
                                        break;
                                    }
                                    let _e2065 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2035.member_1 > 0u) {
                            let _e2067 = (5u < _e104);
                            if _e2067 {
                                if (4u < _e104) {
                                } else {
                                    break;
                                }
                                let _e2071 = atomicAdd((&global_6.member[4u]), _e2035.member_1);
                                if ((_e2071 + _e2035.member_1) < _e2071) {
                                    if _e2067 {
                                    } else {
                                        break;
                                    }
                                    let _e2076 = atomicAdd((&global_6.member[5u]), 1u);
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
