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
    var phi_870_: type_38;
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
    var phi_997_: type_38;
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
    var phi_2525_: type_18;
    var phi_2527_: type_18;
    var phi_2528_: bool;
    var phi_2532_: type_18;
    var phi_2533_: type_18;
    var phi_2534_: type_18;
    var phi_2535_: bool;
    var phi_2539_: type_18;
    var phi_2540_: bool;
    var phi_2541_: type_18;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: type_18;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2554_: type_18;
    var phi_2555_: bool;
    var phi_2559_: type_18;
    var phi_2584_: bool;
    var phi_2585_: bool;
    var phi_2592_: type_38;
    var phi_2593_: type_38;
    var phi_2594_: type_38;
    var phi_998_: type_38;
    var phi_4214_: bool;
    var phi_4407_: bool;
    var phi_3837_: type_38;
    var phi_3838_: type_49;
    var phi_3839_: bool;
    var phi_3840_: u32;
    var phi_4406_: bool;
    var phi_3841_: type_38;
    var phi_3842_: type_49;
    var phi_3843_: u32;
    var phi_3844_: bool;
    var phi_3845_: u32;
    var phi_4405_: bool;
    var phi_3846_: type_38;
    var phi_3847_: type_49;
    var phi_3848_: u32;
    var phi_3849_: bool;
    var phi_3850_: u32;
    var phi_4404_: bool;
    var phi_871_: type_38;
    var phi_874_: type_49;
    var phi_876_: u32;
    var phi_878_: bool;
    var phi_880_: u32;
    var phi_3851_: bool;
    var phi_4403_: bool;
    var local_10: type_38;
    var phi_3903_: type_18;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e89 = global;
            let _e91 = arrayLength((&global_6.member));
            let _e94 = arrayLength((&global_7.member));
            let _e102 = arrayLength((&global_5.member));
            let _e106 = global_2.member[0u][0u];
            let _e110 = global_2.member[0u][1u];
            let _e114 = global_2.member[0u][2u];
            let _e118 = global_2.member[0u][3u];
            let _e122 = global_2.member[1u][0u];
            let _e126 = global_2.member[1u][1u];
            let _e130 = global_2.member[1u][2u];
            let _e134 = (_e89.x + (_e89.y * 2097152u));
            let _e146 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e118) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e106), bitcast<i32>(_e110), bitcast<i32>(_e114));
            local = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            let _e149 = (_e134 < arrayLength((&global_3.member)));
            if _e149 {
                let _e150 = (_e134 < arrayLength((&global_1.member)));
                if _e150 {
                    let _e151 = (_e134 < arrayLength((&global_4.member)));
                    if _e151 {
                        if _e149 {
                        } else {
                            break;
                        }
                        let _e161 = global_3.member[_e134].member.member_2[0u];
                        let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                        let _e169 = global_3.member[_e134].member.member_2[1u];
                        let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                        let _e177 = global_3.member[_e134].member.member_2[2u];
                        let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                        let _e185 = global_3.member[_e134].member.member[0u];
                        let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                        let _e193 = global_3.member[_e134].member.member[1u];
                        let _e195 = (bitcast<u32>(_e193) & 2147483647u);
                        let _e201 = global_3.member[_e134].member.member[2u];
                        let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                        let _e205 = select(_e171, _e163, (_e171 < _e163));
                        let _e207 = select(_e179, _e205, (_e179 < _e205));
                        let _e209 = select(_e187, _e207, (_e187 < _e207));
                        let _e211 = select(_e195, _e209, (_e195 < _e209));
                        let _e213 = select(_e203, _e211, (_e203 < _e211));
                        let _e218 = global_3.member[_e134].member.member_1;
                        let _e220 = (bitcast<u32>(_e218) & 2147483647u);
                        let _e228 = global_3.member[_e134].member.member_3;
                        let _e234 = (((select(_e220, _e213, (_e220 < _e213)) < 2139095040u) && ((bitcast<u32>(_e228) & 2147483647u) <= 2139095040u)) && (_e207 > 0u));
                        if _e234 {
                            let _e237 = (bitcast<u32>(bitcast<f32>(_e207)) & 2147483647u);
                            if (_e237 >= 8388608u) {
                                phi_403_ = (bitcast<i32>((_e237 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_403_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e237)), 32u, (_e237 == 0u))));
                            }
                            let _e251 = phi_403_;
                            phi_404_ = _e251;
                        } else {
                            phi_404_ = 0i;
                        }
                        let _e253 = phi_404_;
                        let _e254 = (_e163 == _e207);
                        if _e254 {
                            phi_414_ = true;
                        } else {
                            phi_414_ = (_e171 == _e207);
                        }
                        let _e257 = phi_414_;
                        let _e258 = select(1u, 0u, _e254);
                        if _e257 {
                            let _e259 = (_e258 + 1u);
                            phi_424_ = _e259;
                            phi_425_ = _e259;
                            phi_427_ = select(true, false, (_e259 == 2u));
                        } else {
                            phi_424_ = u32();
                            phi_425_ = 0u;
                            phi_427_ = true;
                        }
                        let _e263 = phi_424_;
                        let _e265 = phi_425_;
                        let _e267 = phi_427_;
                        if _e267 {
                            phi_432_ = (_e265 + 1u);
                        } else {
                            phi_432_ = 0u;
                        }
                        let _e271 = phi_432_;
                        let _e272 = select(_e263, _e265, _e267);
                        let _e273 = select(_e258, select(2u, _e258, _e257), _e267);
                        let _e274 = -(_e253);
                        if (_e274 < -126i) {
                            phi_464_ = -126i;
                        } else {
                            phi_464_ = select(_e274, 127i, (_e274 > 127i));
                        }
                        let _e279 = phi_464_;
                        let _e284 = bitcast<f32>((bitcast<u32>((_e279 + 127i)) << bitcast<u32>(23i)));
                        let _e290 = bitcast<f32>((bitcast<u32>(((_e274 - _e279) + 127i)) << bitcast<u32>(23i)));
                        let _e295 = global_3.member[_e134].member.member;
                        let _e296 = (_e272 == 0u);
                        if _e296 {
                            phi_482_ = _e295[0];
                        } else {
                            phi_482_ = _e295[1];
                        }
                        let _e300 = phi_482_;
                        let _e301 = (_e272 == 2u);
                        if _e301 {
                            phi_488_ = _e295[2];
                        } else {
                            phi_488_ = _e300;
                        }
                        let _e304 = phi_488_;
                        let _e305 = global_3.member[_e134].member.member_2;
                        if _e296 {
                            phi_499_ = _e305[0];
                        } else {
                            phi_499_ = _e305[1];
                        }
                        let _e309 = phi_499_;
                        if _e301 {
                            phi_505_ = _e305[2];
                        } else {
                            phi_505_ = _e309;
                        }
                        let _e312 = phi_505_;
                        let _e314 = ((_e312 * _e284) * _e290);
                        let _e318 = (bitcast<f32>((bitcast<u32>(_e314) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e318 {
                            let _e322 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) * 0.00000011920929f);
                            phi_528_ = select(0.00000000000011368684f, _e322, (_e322 > 0.00000000000011368684f));
                        } else {
                            phi_528_ = 0f;
                        }
                        let _e326 = phi_528_;
                        let _e327 = (_e304 + _e326);
                        let _e328 = (_e304 - _e326);
                        let _e329 = select(_e314, 0f, _e318);
                        if _e318 {
                            phi_539_ = 38685626000000000000000000f;
                        } else {
                            phi_539_ = (1f / _e314);
                        }
                        let _e332 = phi_539_;
                        let _e333 = (_e271 == 0u);
                        if _e333 {
                            phi_548_ = _e295[0];
                        } else {
                            phi_548_ = _e295[1];
                        }
                        let _e337 = phi_548_;
                        let _e338 = (_e271 == 2u);
                        if _e338 {
                            phi_554_ = _e295[2];
                        } else {
                            phi_554_ = _e337;
                        }
                        let _e341 = phi_554_;
                        if _e333 {
                            phi_565_ = _e305[0];
                        } else {
                            phi_565_ = _e305[1];
                        }
                        let _e345 = phi_565_;
                        if _e338 {
                            phi_571_ = _e305[2];
                        } else {
                            phi_571_ = _e345;
                        }
                        let _e348 = phi_571_;
                        let _e350 = ((_e348 * _e284) * _e290);
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e354 {
                            let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                            phi_594_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                        } else {
                            phi_594_ = 0f;
                        }
                        let _e362 = phi_594_;
                        let _e363 = (_e341 + _e362);
                        let _e364 = (_e341 - _e362);
                        let _e365 = select(_e350, 0f, _e354);
                        if _e354 {
                            phi_605_ = 38685626000000000000000000f;
                        } else {
                            phi_605_ = (1f / _e350);
                        }
                        let _e368 = phi_605_;
                        let _e369 = (_e273 == 0u);
                        if _e369 {
                            phi_614_ = _e295[0];
                        } else {
                            phi_614_ = _e295[1];
                        }
                        let _e373 = phi_614_;
                        let _e374 = (_e273 == 2u);
                        if _e374 {
                            phi_620_ = _e295[2];
                        } else {
                            phi_620_ = _e373;
                        }
                        let _e377 = phi_620_;
                        if _e369 {
                            phi_631_ = _e305[0];
                        } else {
                            phi_631_ = _e305[1];
                        }
                        let _e381 = phi_631_;
                        if _e374 {
                            phi_637_ = _e305[2];
                        } else {
                            phi_637_ = _e381;
                        }
                        let _e384 = phi_637_;
                        let _e386 = ((_e384 * _e284) * _e290);
                        let _e390 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e390 {
                            let _e394 = (bitcast<f32>((bitcast<u32>(_e377) & 2147483647u)) * 0.00000011920929f);
                            phi_660_ = select(0.00000000000011368684f, _e394, (_e394 > 0.00000000000011368684f));
                        } else {
                            phi_660_ = 0f;
                        }
                        let _e398 = phi_660_;
                        let _e399 = (_e377 + _e398);
                        let _e400 = (_e377 - _e398);
                        let _e401 = select(_e386, 0f, _e390);
                        if _e390 {
                            phi_671_ = 38685626000000000000000000f;
                        } else {
                            phi_671_ = (1f / _e386);
                        }
                        let _e404 = phi_671_;
                        let _e407 = bitcast<f32>((bitcast<u32>(_e304) & 2147483647u));
                        let _e410 = bitcast<f32>((bitcast<u32>(_e341) & 2147483647u));
                        let _e412 = select(_e410, _e407, (_e407 > _e410));
                        let _e415 = bitcast<f32>((bitcast<u32>(_e377) & 2147483647u));
                        if (_e234 && (select(_e415, _e412, (_e412 > _e415)) <= 1099511600000f)) {
                            let _e420 = (_e253 / 3i);
                            let _e427 = bitcast<f32>((bitcast<u32>((_e420 + 127i)) << bitcast<u32>(23i)));
                            let _e434 = bitcast<f32>((bitcast<u32>(((_e253 - (2i * _e420)) + 127i)) << bitcast<u32>(23i)));
                            let _e435 = (((_e218 * _e427) * _e427) * _e434);
                            let _e437 = select(340282350000000000000000000000000000000f, _e435, (_e435 < 340282350000000000000000000000000000000f));
                            let _e442 = (((_e228 * _e427) * _e427) * _e434);
                            let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                            phi_771_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                            phi_772_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_771_ = 0f;
                            phi_772_ = 1f;
                        }
                        let _e448 = phi_771_;
                        let _e450 = phi_772_;
                        if _e149 {
                        } else {
                            break;
                        }
                        let _e456 = global_3.member[_e134].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e459 = (_e272 % 3u);
                        let _e460 = (_e459 < 3u);
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e462 = local_1[_e459];
                        let _e465 = (_e271 % 3u);
                        let _e466 = (_e465 < 3u);
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e468 = local_1[_e465];
                        let _e471 = (_e273 % 3u);
                        let _e472 = (_e471 < 3u);
                        if _e472 {
                        } else {
                            break;
                        }
                        let _e474 = local_1[_e471];
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e479 = local[_e459];
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e483 = local[_e465];
                        if _e472 {
                        } else {
                            break;
                        }
                        let _e487 = local[_e471];
                        phi_4220_ = false;
                        phi_870_ = type_38(type_34(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e448), 0u, 0u);
                        phi_873_ = type_49(type_30(vec4<f32>((f32(_e462) * _e146), (f32(_e468) * _e146), (f32(_e474) * _e146), 0f), vec4<f32>((f32(_e479) * _e146), (f32(_e483) * _e146), (f32(_e487) * _e146), 0f)), select(0u, 2147483648u, (_e91 == 0u)));
                        phi_875_ = ((3u * _e91) + 1u);
                        phi_877_ = (_e450 <= _e448);
                        phi_879_ = 0u;
                        loop {
                            let _e497 = phi_4220_;
                            let _e499 = phi_870_;
                            let _e501 = phi_873_;
                            let _e503 = phi_875_;
                            let _e505 = phi_877_;
                            let _e507 = phi_879_;
                            local_10 = _e499;
                            local_11 = _e499;
                            if _e505 {
                                phi_890_ = true;
                            } else {
                                phi_890_ = (_e507 > 0u);
                            }
                            let _e510 = phi_890_;
                            if _e510 {
                                let _e511 = (_e503 > 0u);
                                if _e511 {
                                    if _e505 {
                                        phi_976_ = _e501;
                                        phi_977_ = _e505;
                                        phi_978_ = _e507;
                                    } else {
                                        let _e512 = (_e507 - 1u);
                                        let _e513 = (_e512 % 128u);
                                        let _e514 = (_e513 < 128u);
                                        if _e514 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e516 = local_7[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e518 = local_6[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e520 = local_5[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e522 = local_4[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e524 = local_3[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e526 = local_2[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e531 = local_8[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4403_ = true;
                                            break;
                                        }
                                        let _e534 = local_9[_e513];
                                        phi_976_ = type_49(type_30(vec4<f32>(_e516, _e518, _e520, 0f), vec4<f32>(_e522, _e524, _e526, 0f)), _e531);
                                        phi_977_ = (_e534 <= _e499.member.member_1);
                                        phi_978_ = _e512;
                                    }
                                    let _e539 = phi_976_;
                                    let _e541 = phi_977_;
                                    let _e543 = phi_978_;
                                    if _e541 {
                                        let _e548 = (_e539.member_1 & 268435455u);
                                        if ((_e539.member_1 & 2147483648u) != 0u) {
                                            phi_997_ = _e499;
                                            phi_1000_ = type_8(0u, ((_e539.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1033 = phi_997_;
                                                let _e1035 = phi_1000_;
                                                local_12 = _e1033;
                                                if (_e1035.member < _e1035.member_1) {
                                                    phi_1001_ = type_8((_e1035.member + 1u), _e1035.member_1);
                                                    phi_1023_ = type_8(1u, _e1035.member);
                                                } else {
                                                    phi_1001_ = _e1035;
                                                    phi_1023_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1048 = phi_1001_;
                                                let _e1050 = phi_1023_;
                                                let _e1054 = (bitcast<i32>(_e1050.member) != 0i);
                                                if _e1054 {
                                                    let _e1060 = type_38(_e1033.member, _e1033.member_1, (_e1033.member_2 + 1u));
                                                    let _e1065 = (_e539.member.member_1.x - _e539.member.member.x);
                                                    let _e1068 = (_e539.member.member_1.y - _e539.member.member.y);
                                                    let _e1071 = (_e539.member.member_1.z - _e539.member.member.z);
                                                    let _e1073 = select(_e1068, _e1065, (_e1065 > _e1068));
                                                    let _e1075 = select(_e1071, _e1073, (_e1073 > _e1071));
                                                    let _e1077 = (_e1075 < (1024f * _e146));
                                                    if _e1077 {
                                                        phi_1067_ = 0u;
                                                    } else {
                                                        phi_1067_ = select(2u, 1u, (_e1075 < (2097152f * _e146)));
                                                    }
                                                    let _e1082 = phi_1067_;
                                                    switch bitcast<i32>(_e1082) {
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
                                                    let _e1085 = phi_1073_;
                                                    switch bitcast<i32>(_e1082) {
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
                                                    let _e1092 = phi_1083_;
                                                    let _e1094 = ((_e548 + (_e1050.member_1 * ((3u * _e1085) + 1u))) + (3u * _e1092));
                                                    let _e1095 = (_e1094 < _e94);
                                                    if _e1095 {
                                                        if _e1095 {
                                                        } else {
                                                            phi_4214_ = true;
                                                            break;
                                                        }
                                                        let _e1097 = global_7.member[_e1094];
                                                        phi_1099_ = _e1097;
                                                    } else {
                                                        phi_1099_ = 4294967295u;
                                                    }
                                                    let _e1099 = phi_1099_;
                                                    if _e1077 {
                                                        phi_1132_ = 0u;
                                                    } else {
                                                        phi_1132_ = select(2u, 1u, (_e1075 < (2097152f * _e146)));
                                                    }
                                                    let _e1104 = phi_1132_;
                                                    switch bitcast<i32>(_e1104) {
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
                                                    let _e1107 = phi_1138_;
                                                    let _e1111 = (_e548 + (_e1050.member_1 * ((3u * _e1107) + 1u)));
                                                    switch bitcast<i32>(_e1104) {
                                                        case 0: {
                                                            let _e1377 = (_e1111 < _e94);
                                                            if _e1377 {
                                                                if _e1377 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1379 = global_7.member[_e1111];
                                                                phi_1162_ = _e1379;
                                                            } else {
                                                                phi_1162_ = 0u;
                                                            }
                                                            let _e1381 = phi_1162_;
                                                            let _e1383 = ((10u * _e272) & 31u);
                                                            let _e1392 = ((10u * _e271) & 31u);
                                                            let _e1401 = ((10u * _e273) & 31u);
                                                            let _e1410 = (_e1111 + 1u);
                                                            let _e1411 = (_e1410 < _e94);
                                                            if _e1411 {
                                                                if _e1411 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1413 = global_7.member[_e1410];
                                                                phi_1205_ = _e1413;
                                                            } else {
                                                                phi_1205_ = 0u;
                                                            }
                                                            let _e1415 = phi_1205_;
                                                            let _e1438 = (_e1111 + 2u);
                                                            let _e1439 = (_e1438 < _e94);
                                                            if _e1439 {
                                                                if _e1439 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1441 = global_7.member[_e1438];
                                                                phi_1248_ = _e1441;
                                                            } else {
                                                                phi_1248_ = 0u;
                                                            }
                                                            let _e1443 = phi_1248_;
                                                            phi_1719_ = array<array<f32, 3>, 3>(array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>(((_e1381 >> bitcast<u32>(_e1383)) & 1023u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>(((_e1381 >> bitcast<u32>(_e1392)) & 1023u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>(((_e1381 >> bitcast<u32>(_e1401)) & 1023u))) * _e146))), array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>(((_e1415 >> bitcast<u32>(_e1383)) & 1023u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>(((_e1415 >> bitcast<u32>(_e1392)) & 1023u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>(((_e1415 >> bitcast<u32>(_e1401)) & 1023u))) * _e146))), array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>(((_e1443 >> bitcast<u32>(_e1383)) & 1023u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>(((_e1443 >> bitcast<u32>(_e1392)) & 1023u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>(((_e1443 >> bitcast<u32>(_e1401)) & 1023u))) * _e146))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1200 = (_e1111 < _e94);
                                                            if _e1200 {
                                                                if _e1200 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1202 = global_7.member[_e1111];
                                                                phi_1291_ = _e1202;
                                                            } else {
                                                                phi_1291_ = 0u;
                                                            }
                                                            let _e1204 = phi_1291_;
                                                            let _e1205 = (_e1111 + 1u);
                                                            let _e1206 = (_e1205 < _e94);
                                                            if _e1206 {
                                                                if _e1206 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1208 = global_7.member[_e1205];
                                                                phi_1306_ = _e1208;
                                                            } else {
                                                                phi_1306_ = 0u;
                                                            }
                                                            let _e1210 = phi_1306_;
                                                            let _e1211 = (_e272 == 1u);
                                                            if _e1211 {
                                                                phi_1316_ = ((_e1204 >> bitcast<u32>(21i)) | (_e1210 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1316_ = (_e1210 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1220 = phi_1316_;
                                                            let _e1227 = (_e271 == 1u);
                                                            if _e1227 {
                                                                phi_1336_ = ((_e1204 >> bitcast<u32>(21i)) | (_e1210 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1336_ = (_e1210 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1236 = phi_1336_;
                                                            let _e1243 = (_e273 == 1u);
                                                            if _e1243 {
                                                                phi_1356_ = ((_e1204 >> bitcast<u32>(21i)) | (_e1210 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1356_ = (_e1210 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1252 = phi_1356_;
                                                            let _e1260 = (_e1111 + 2u);
                                                            let _e1261 = (_e1260 < _e94);
                                                            if _e1261 {
                                                                if _e1261 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1263 = global_7.member[_e1260];
                                                                phi_1382_ = _e1263;
                                                            } else {
                                                                phi_1382_ = 0u;
                                                            }
                                                            let _e1265 = phi_1382_;
                                                            let _e1266 = (_e1111 + 3u);
                                                            let _e1267 = (_e1266 < _e94);
                                                            if _e1267 {
                                                                if _e1267 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1269 = global_7.member[_e1266];
                                                                phi_1397_ = _e1269;
                                                            } else {
                                                                phi_1397_ = 0u;
                                                            }
                                                            let _e1271 = phi_1397_;
                                                            if _e1211 {
                                                                phi_1407_ = ((_e1265 >> bitcast<u32>(21i)) | (_e1271 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1407_ = (_e1271 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1280 = phi_1407_;
                                                            if _e1227 {
                                                                phi_1427_ = ((_e1265 >> bitcast<u32>(21i)) | (_e1271 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1427_ = (_e1271 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1295 = phi_1427_;
                                                            if _e1243 {
                                                                phi_1447_ = ((_e1265 >> bitcast<u32>(21i)) | (_e1271 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1447_ = (_e1271 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1310 = phi_1447_;
                                                            let _e1318 = (_e1111 + 4u);
                                                            let _e1319 = (_e1318 < _e94);
                                                            if _e1319 {
                                                                if _e1319 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1321 = global_7.member[_e1318];
                                                                phi_1473_ = _e1321;
                                                            } else {
                                                                phi_1473_ = 0u;
                                                            }
                                                            let _e1323 = phi_1473_;
                                                            let _e1324 = (_e1111 + 5u);
                                                            let _e1325 = (_e1324 < _e94);
                                                            if _e1325 {
                                                                if _e1325 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1327 = global_7.member[_e1324];
                                                                phi_1488_ = _e1327;
                                                            } else {
                                                                phi_1488_ = 0u;
                                                            }
                                                            let _e1329 = phi_1488_;
                                                            if _e1211 {
                                                                phi_1498_ = ((_e1323 >> bitcast<u32>(21i)) | (_e1329 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1498_ = (_e1329 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1338 = phi_1498_;
                                                            if _e1227 {
                                                                phi_1518_ = ((_e1323 >> bitcast<u32>(21i)) | (_e1329 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1518_ = (_e1329 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1353 = phi_1518_;
                                                            if _e1243 {
                                                                phi_1538_ = ((_e1323 >> bitcast<u32>(21i)) | (_e1329 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1538_ = (_e1329 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1368 = phi_1538_;
                                                            phi_1719_ = array<array<f32, 3>, 3>(array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>((select(_e1220, _e1204, _e296) & 2097151u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>((select(_e1236, _e1204, _e333) & 2097151u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>((select(_e1252, _e1204, _e369) & 2097151u))) * _e146))), array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>((select(_e1280, _e1265, _e296) & 2097151u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>((select(_e1295, _e1265, _e333) & 2097151u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>((select(_e1310, _e1265, _e369) & 2097151u))) * _e146))), array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>((select(_e1338, _e1323, _e296) & 2097151u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>((select(_e1353, _e1323, _e333) & 2097151u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>((select(_e1368, _e1323, _e369) & 2097151u))) * _e146))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1113 = (_e1111 + _e272);
                                                            let _e1114 = (_e1113 < _e94);
                                                            if _e1114 {
                                                                if _e1114 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1116 = global_7.member[_e1113];
                                                                phi_1565_ = _e1116;
                                                            } else {
                                                                phi_1565_ = 0u;
                                                            }
                                                            let _e1118 = phi_1565_;
                                                            let _e1122 = (_e1111 + _e271);
                                                            let _e1123 = (_e1122 < _e94);
                                                            if _e1123 {
                                                                if _e1123 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1125 = global_7.member[_e1122];
                                                                phi_1583_ = _e1125;
                                                            } else {
                                                                phi_1583_ = 0u;
                                                            }
                                                            let _e1127 = phi_1583_;
                                                            let _e1131 = (_e1111 + _e273);
                                                            let _e1132 = (_e1131 < _e94);
                                                            if _e1132 {
                                                                if _e1132 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1134 = global_7.member[_e1131];
                                                                phi_1601_ = _e1134;
                                                            } else {
                                                                phi_1601_ = 0u;
                                                            }
                                                            let _e1136 = phi_1601_;
                                                            let _e1141 = (_e1111 + 3u);
                                                            let _e1142 = (_e1141 + _e272);
                                                            let _e1143 = (_e1142 < _e94);
                                                            if _e1143 {
                                                                if _e1143 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1145 = global_7.member[_e1142];
                                                                phi_1621_ = _e1145;
                                                            } else {
                                                                phi_1621_ = 0u;
                                                            }
                                                            let _e1147 = phi_1621_;
                                                            let _e1151 = (_e1141 + _e271);
                                                            let _e1152 = (_e1151 < _e94);
                                                            if _e1152 {
                                                                if _e1152 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1154 = global_7.member[_e1151];
                                                                phi_1639_ = _e1154;
                                                            } else {
                                                                phi_1639_ = 0u;
                                                            }
                                                            let _e1156 = phi_1639_;
                                                            let _e1160 = (_e1141 + _e273);
                                                            let _e1161 = (_e1160 < _e94);
                                                            if _e1161 {
                                                                if _e1161 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1163 = global_7.member[_e1160];
                                                                phi_1657_ = _e1163;
                                                            } else {
                                                                phi_1657_ = 0u;
                                                            }
                                                            let _e1165 = phi_1657_;
                                                            let _e1170 = (_e1111 + 6u);
                                                            let _e1171 = (_e1170 + _e272);
                                                            let _e1172 = (_e1171 < _e94);
                                                            if _e1172 {
                                                                if _e1172 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1174 = global_7.member[_e1171];
                                                                phi_1677_ = _e1174;
                                                            } else {
                                                                phi_1677_ = 0u;
                                                            }
                                                            let _e1176 = phi_1677_;
                                                            let _e1180 = (_e1170 + _e271);
                                                            let _e1181 = (_e1180 < _e94);
                                                            if _e1181 {
                                                                if _e1181 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1183 = global_7.member[_e1180];
                                                                phi_1695_ = _e1183;
                                                            } else {
                                                                phi_1695_ = 0u;
                                                            }
                                                            let _e1185 = phi_1695_;
                                                            let _e1189 = (_e1170 + _e273);
                                                            let _e1190 = (_e1189 < _e94);
                                                            if _e1190 {
                                                                if _e1190 {
                                                                } else {
                                                                    phi_4214_ = true;
                                                                    break;
                                                                }
                                                                let _e1192 = global_7.member[_e1189];
                                                                phi_1713_ = _e1192;
                                                            } else {
                                                                phi_1713_ = 0u;
                                                            }
                                                            let _e1194 = phi_1713_;
                                                            phi_1719_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1118)) * _e146), (f32(bitcast<i32>(_e1127)) * _e146), (f32(bitcast<i32>(_e1136)) * _e146)), array<f32, 3>((f32(bitcast<i32>(_e1147)) * _e146), (f32(bitcast<i32>(_e1156)) * _e146), (f32(bitcast<i32>(_e1165)) * _e146)), array<f32, 3>((f32(bitcast<i32>(_e1176)) * _e146), (f32(bitcast<i32>(_e1185)) * _e146), (f32(bitcast<i32>(_e1194)) * _e146)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1719_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1468 = phi_1719_;
                                                    let _e1477 = (_e1468[0][2] - _e377);
                                                    let _e1480 = (((_e1468[0][0] - _e304) * _e401) - (_e1477 * _e329));
                                                    let _e1483 = (((_e1468[0][1] - _e341) * _e401) - (_e1477 * _e365));
                                                    let _e1490 = (_e1468[1][2] - _e377);
                                                    let _e1493 = (((_e1468[1][0] - _e304) * _e401) - (_e1490 * _e329));
                                                    let _e1496 = (((_e1468[1][1] - _e341) * _e401) - (_e1490 * _e365));
                                                    let _e1503 = (_e1468[2][2] - _e377);
                                                    let _e1506 = (((_e1468[2][0] - _e304) * _e401) - (_e1503 * _e329));
                                                    let _e1509 = (((_e1468[2][1] - _e341) * _e401) - (_e1503 * _e365));
                                                    let _e1510 = (_e1506 * _e1496);
                                                    let _e1511 = (_e1509 * _e1493);
                                                    let _e1512 = (_e1480 * _e1509);
                                                    let _e1513 = (_e1483 * _e1506);
                                                    let _e1514 = (_e1493 * _e1483);
                                                    let _e1515 = (_e1496 * _e1480);
                                                    let _e1520 = (((_e1510 >= _e1511) && (_e1512 >= _e1513)) && (_e1514 >= _e1515));
                                                    if (_e1520 || (((_e1510 <= _e1511) && (_e1512 <= _e1513)) && (_e1514 <= _e1515))) {
                                                        let _e1527 = select(-1f, 1f, _e1520);
                                                        let _e1529 = ((_e1510 - _e1511) * _e1527);
                                                        let _e1531 = select(0f, _e1529, (_e1529 > 0f));
                                                        let _e1533 = ((_e1512 - _e1513) * _e1527);
                                                        let _e1535 = select(0f, _e1533, (_e1533 > 0f));
                                                        let _e1537 = ((_e1514 - _e1515) * _e1527);
                                                        let _e1539 = select(0f, _e1537, (_e1537 > 0f));
                                                        let _e1541 = ((_e1531 + _e1535) + _e1539);
                                                        if (_e1541 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2544_ = type_18();
                                                            phi_2545_ = true;
                                                            phi_2546_ = false;
                                                        } else {
                                                            let _e1544 = select(_e1493, _e1480, (_e1480 < _e1493));
                                                            if (select(_e1506, _e1544, (_e1544 < _e1506)) > 0f) {
                                                                phi_1836_ = true;
                                                            } else {
                                                                let _e1549 = select(_e1493, _e1480, (_e1480 > _e1493));
                                                                phi_1836_ = (select(_e1506, _e1549, (_e1549 > _e1506)) < 0f);
                                                            }
                                                            let _e1554 = phi_1836_;
                                                            if _e1554 {
                                                                phi_2541_ = type_18();
                                                                phi_2542_ = true;
                                                                phi_2543_ = false;
                                                            } else {
                                                                let _e1556 = select(_e1496, _e1483, (_e1483 < _e1496));
                                                                if (select(_e1509, _e1556, (_e1556 < _e1509)) > 0f) {
                                                                    phi_1865_ = true;
                                                                } else {
                                                                    let _e1561 = select(_e1496, _e1483, (_e1483 > _e1496));
                                                                    phi_1865_ = (select(_e1509, _e1561, (_e1561 > _e1509)) < 0f);
                                                                }
                                                                let _e1566 = phi_1865_;
                                                                if _e1566 {
                                                                    phi_2539_ = type_18();
                                                                    phi_2540_ = false;
                                                                } else {
                                                                    let _e1568 = select(_e1468[1][0], _e1468[0][0], (_e1468[0][0] < _e1468[1][0]));
                                                                    let _e1572 = select(_e1468[1][0], _e1468[0][0], (_e1468[0][0] > _e1468[1][0]));
                                                                    let _e1576 = select(_e1468[1][1], _e1468[0][1], (_e1468[0][1] < _e1468[1][1]));
                                                                    let _e1580 = select(_e1468[1][1], _e1468[0][1], (_e1468[0][1] > _e1468[1][1]));
                                                                    let _e1584 = select(_e1468[1][2], _e1468[0][2], (_e1468[0][2] < _e1468[1][2]));
                                                                    let _e1588 = select(_e1468[1][2], _e1468[0][2], (_e1468[0][2] > _e1468[1][2]));
                                                                    let _e1593 = ((select(_e1468[2][0], _e1568, (_e1568 < _e1468[2][0])) - _e327) * _e332);
                                                                    let _e1594 = ((select(_e1468[2][0], _e1572, (_e1572 > _e1468[2][0])) - _e328) * _e332);
                                                                    let _e1597 = ((select(_e1468[2][1], _e1576, (_e1576 < _e1468[2][1])) - _e363) * _e368);
                                                                    let _e1598 = ((select(_e1468[2][1], _e1580, (_e1580 > _e1468[2][1])) - _e364) * _e368);
                                                                    let _e1601 = ((select(_e1468[2][2], _e1584, (_e1584 < _e1468[2][2])) - _e399) * _e404);
                                                                    let _e1602 = ((select(_e1468[2][2], _e1588, (_e1588 > _e1468[2][2])) - _e400) * _e404);
                                                                    let _e1604 = select(_e1602, _e1601, (_e1601 < _e1602));
                                                                    let _e1606 = select(_e1602, _e1601, (_e1601 > _e1602));
                                                                    let _e1608 = select(_e1594, _e1593, (_e1593 < _e1594));
                                                                    let _e1610 = select(_e1598, _e1597, (_e1597 < _e1598));
                                                                    let _e1612 = select(_e1610, _e1608, (_e1608 > _e1610));
                                                                    let _e1614 = select(_e1604, _e1612, (_e1612 > _e1604));
                                                                    let _e1616 = select(_e1594, _e1593, (_e1593 > _e1594));
                                                                    let _e1618 = select(_e1598, _e1597, (_e1597 > _e1598));
                                                                    let _e1620 = select(_e1618, _e1616, (_e1616 < _e1618));
                                                                    let _e1622 = select(_e1606, _e1620, (_e1620 < _e1606));
                                                                    let _e1623 = -(_e1604);
                                                                    let _e1629 = select(_e450, _e1614, (_e1614 > _e450));
                                                                    if (_e1629 > (_e1622 + (select(_e1623, _e1606, (_e1606 > _e1623)) * 0.0000019073523f))) {
                                                                        phi_2534_ = type_18();
                                                                        phi_2535_ = true;
                                                                    } else {
                                                                        let _e1631 = (_e1629 > _e1033.member.member_1);
                                                                        if _e1631 {
                                                                            phi_2533_ = type_18();
                                                                        } else {
                                                                            let _e1632 = vec3<f32>(_e1468[0][0], _e1468[0][1], _e1468[0][2]);
                                                                            let _e1633 = vec3<f32>(_e1468[1][0], _e1468[1][1], _e1468[1][2]);
                                                                            let _e1634 = vec3<f32>(_e1468[2][0], _e1468[2][1], _e1468[2][2]);
                                                                            let _e1635 = (_e1468[1][0] - _e1468[0][0]);
                                                                            let _e1636 = (_e1468[1][1] - _e1468[0][1]);
                                                                            let _e1637 = (_e1468[1][2] - _e1468[0][2]);
                                                                            let _e1638 = vec3<f32>(_e1635, _e1636, _e1637);
                                                                            let _e1639 = (_e1468[2][0] - _e1468[1][0]);
                                                                            let _e1640 = (_e1468[2][1] - _e1468[1][1]);
                                                                            let _e1641 = (_e1468[2][2] - _e1468[1][2]);
                                                                            let _e1642 = vec3<f32>(_e1639, _e1640, _e1641);
                                                                            let _e1643 = (_e1468[0][0] - _e1468[2][0]);
                                                                            let _e1644 = (_e1468[0][1] - _e1468[2][1]);
                                                                            let _e1645 = (_e1468[0][2] - _e1468[2][2]);
                                                                            let _e1646 = vec3<f32>(_e1643, _e1644, _e1645);
                                                                            let _e1649 = bitcast<f32>((bitcast<u32>(_e1635) & 2147483647u));
                                                                            let _e1652 = bitcast<f32>((bitcast<u32>(_e1636) & 2147483647u));
                                                                            let _e1654 = select(_e1652, _e1649, (_e1649 > _e1652));
                                                                            let _e1657 = bitcast<f32>((bitcast<u32>(_e1637) & 2147483647u));
                                                                            let _e1659 = select(_e1657, _e1654, (_e1654 > _e1657));
                                                                            let _e1662 = bitcast<f32>((bitcast<u32>(_e1639) & 2147483647u));
                                                                            let _e1665 = bitcast<f32>((bitcast<u32>(_e1640) & 2147483647u));
                                                                            let _e1667 = select(_e1665, _e1662, (_e1662 > _e1665));
                                                                            let _e1670 = bitcast<f32>((bitcast<u32>(_e1641) & 2147483647u));
                                                                            let _e1672 = select(_e1670, _e1667, (_e1667 > _e1670));
                                                                            let _e1675 = bitcast<f32>((bitcast<u32>(_e1643) & 2147483647u));
                                                                            let _e1678 = bitcast<f32>((bitcast<u32>(_e1644) & 2147483647u));
                                                                            let _e1680 = select(_e1678, _e1675, (_e1675 > _e1678));
                                                                            let _e1683 = bitcast<f32>((bitcast<u32>(_e1645) & 2147483647u));
                                                                            let _e1685 = select(_e1683, _e1680, (_e1680 > _e1683));
                                                                            let _e1687 = select(_e1672, _e1659, (_e1659 > _e1672));
                                                                            let _e1689 = select(_e1685, _e1687, (_e1687 > _e1685));
                                                                            if (_e1659 == _e1689) {
                                                                                phi_2266_ = _e1496;
                                                                                phi_2267_ = _e1493;
                                                                                phi_2268_ = _e1483;
                                                                                phi_2269_ = _e1480;
                                                                                phi_2270_ = _e1632;
                                                                                phi_2271_ = _e1646;
                                                                                phi_2272_ = _e1642;
                                                                                phi_2273_ = _e1638;
                                                                            } else {
                                                                                let _e1691 = (_e1672 == _e1689);
                                                                                let _e1696 = vec3(_e1691);
                                                                                phi_2266_ = select(_e1483, _e1509, _e1691);
                                                                                phi_2267_ = select(_e1480, _e1506, _e1691);
                                                                                phi_2268_ = select(_e1509, _e1496, _e1691);
                                                                                phi_2269_ = select(_e1506, _e1493, _e1691);
                                                                                phi_2270_ = select(_e1634, _e1633, _e1696);
                                                                                phi_2271_ = select(_e1642, _e1638, _e1696);
                                                                                phi_2272_ = select(_e1638, _e1646, _e1696);
                                                                                phi_2273_ = select(_e1646, _e1642, _e1696);
                                                                            }
                                                                            let _e1702 = phi_2266_;
                                                                            let _e1704 = phi_2267_;
                                                                            let _e1706 = phi_2268_;
                                                                            let _e1708 = phi_2269_;
                                                                            let _e1710 = phi_2270_;
                                                                            let _e1712 = phi_2271_;
                                                                            let _e1714 = phi_2272_;
                                                                            let _e1716 = phi_2273_;
                                                                            let _e1723 = ((_e1714.y * _e1712.z) - (_e1712.y * _e1714.z));
                                                                            let _e1728 = ((_e1714.z * _e1712.x) - (_e1712.z * _e1714.x));
                                                                            let _e1731 = ((_e1714.x * _e1712.y) - (_e1712.x * _e1714.y));
                                                                            if (_e1531 >= _e1535) {
                                                                                phi_2304_ = select(true, false, (_e1531 >= _e1539));
                                                                            } else {
                                                                                phi_2304_ = true;
                                                                            }
                                                                            let _e1736 = phi_2304_;
                                                                            if _e1736 {
                                                                                phi_2313_ = select(_e1634, _e1633, vec3((_e1535 >= _e1539)));
                                                                            } else {
                                                                                phi_2313_ = _e1632;
                                                                            }
                                                                            let _e1741 = phi_2313_;
                                                                            let _e1752 = (((_e1723 * (_e1741.x - _e304)) + (_e1728 * (_e1741.y - _e341))) + (_e1731 * (_e1741.z - _e377)));
                                                                            let _e1757 = (((_e1723 * _e329) + (_e1728 * _e365)) + (_e1731 * _e401));
                                                                            let _e1758 = (_e1704 - _e1708);
                                                                            let _e1759 = (_e1702 - _e1706);
                                                                            let _e1767 = (-(((_e1708 * _e1758) + (_e1706 * _e1759))) / ((_e1758 * _e1758) + (_e1759 * _e1759)));
                                                                            let _e1769 = select(1f, _e1767, (_e1767 < 1f));
                                                                            let _e1771 = select(0f, _e1769, (_e1769 > 0f));
                                                                            let _e1784 = ((_e1710.x + (_e1716.x * _e1771)) - _e304);
                                                                            let _e1785 = ((_e1710.y + (_e1716.y * _e1771)) - _e341);
                                                                            let _e1786 = ((_e1710.z + (_e1716.z * _e1771)) - _e377);
                                                                            let _e1787 = (_e1786 / _e401);
                                                                            let _e1799 = bitcast<f32>((bitcast<u32>(_e1784) & 2147483647u));
                                                                            let _e1802 = bitcast<f32>((bitcast<u32>(_e1785) & 2147483647u));
                                                                            let _e1804 = select(_e1802, _e1799, (_e1799 > _e1802));
                                                                            let _e1807 = bitcast<f32>((bitcast<u32>(_e1786) & 2147483647u));
                                                                            let _e1809 = select(_e1807, _e1804, (_e1804 > _e1807));
                                                                            let _e1815 = bitcast<f32>((bitcast<u32>(_e1723) & 2147483647u));
                                                                            let _e1818 = bitcast<f32>((bitcast<u32>(_e1728) & 2147483647u));
                                                                            let _e1820 = select(_e1818, _e1815, (_e1815 > _e1818));
                                                                            let _e1823 = bitcast<f32>((bitcast<u32>(_e1731) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1723 * _e1784) + (_e1728 * _e1785)) + (_e1731 * _e1786)) - _e1752)) & 2147483647u)) <= ((0.0000009536743f * select(_e1689, _e1809, (_e1809 > _e1689))) * select(_e1823, _e1820, (_e1820 > _e1823)))) {
                                                                                let _e1833 = bitcast<f32>((bitcast<u32>(_e1714.x) & 2147483647u));
                                                                                let _e1836 = bitcast<f32>((bitcast<u32>(_e1714.y) & 2147483647u));
                                                                                let _e1838 = select(_e1836, _e1833, (_e1833 > _e1836));
                                                                                let _e1841 = bitcast<f32>((bitcast<u32>(_e1714.z) & 2147483647u));
                                                                                let _e1847 = bitcast<f32>((bitcast<u32>(_e1712.x) & 2147483647u));
                                                                                let _e1850 = bitcast<f32>((bitcast<u32>(_e1712.y) & 2147483647u));
                                                                                let _e1852 = select(_e1850, _e1847, (_e1847 > _e1850));
                                                                                let _e1855 = bitcast<f32>((bitcast<u32>(_e1712.z) & 2147483647u));
                                                                                let _e1859 = (bitcast<f32>((bitcast<u32>(_e1757) & 2147483647u)) > ((0.0000038146973f * select(_e1841, _e1838, (_e1838 > _e1841))) * select(_e1855, _e1852, (_e1852 > _e1855))));
                                                                                if _e1859 {
                                                                                    phi_2478_ = (_e1752 / _e1757);
                                                                                } else {
                                                                                    phi_2478_ = f32();
                                                                                }
                                                                                let _e1862 = phi_2478_;
                                                                                phi_2480_ = _e1862;
                                                                                phi_2481_ = select(true, false, _e1859);
                                                                            } else {
                                                                                phi_2480_ = f32();
                                                                                phi_2481_ = true;
                                                                            }
                                                                            let _e1865 = phi_2480_;
                                                                            let _e1867 = phi_2481_;
                                                                            if _e1867 {
                                                                                let _e1875 = (((_e1723 * (_e1784 - (_e329 * _e1787))) + (_e1728 * (_e1785 - (_e365 * _e1787)))) / _e1757);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1875) & 2147483647u)) <= _e1689) {
                                                                                    phi_2501_ = (_e1787 + _e1875);
                                                                                } else {
                                                                                    phi_2501_ = _e1787;
                                                                                }
                                                                                let _e1882 = phi_2501_;
                                                                                phi_2502_ = _e1882;
                                                                            } else {
                                                                                phi_2502_ = _e1865;
                                                                            }
                                                                            let _e1884 = phi_2502_;
                                                                            let _e1886 = select(_e1622, _e1884, (_e1884 < _e1622));
                                                                            let _e1888 = select(_e1614, _e1886, (_e1886 > _e1614));
                                                                            if (_e1888 >= _e450) {
                                                                                let _e1890 = (_e1888 <= _e1033.member.member_1);
                                                                                if _e1890 {
                                                                                    let _e1891 = (1f / _e1541);
                                                                                    phi_2525_ = type_18(_e1888, (_e1535 * _e1891), (_e1539 * _e1891), _e1099);
                                                                                } else {
                                                                                    phi_2525_ = type_18();
                                                                                }
                                                                                let _e1896 = phi_2525_;
                                                                                phi_2527_ = _e1896;
                                                                                phi_2528_ = select(true, false, _e1890);
                                                                            } else {
                                                                                phi_2527_ = type_18();
                                                                                phi_2528_ = true;
                                                                            }
                                                                            let _e1899 = phi_2527_;
                                                                            let _e1901 = phi_2528_;
                                                                            if _e1901 {
                                                                                phi_2532_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2532_ = _e1899;
                                                                            }
                                                                            let _e1903 = phi_2532_;
                                                                            phi_2533_ = _e1903;
                                                                        }
                                                                        let _e1905 = phi_2533_;
                                                                        phi_2534_ = _e1905;
                                                                        phi_2535_ = _e1631;
                                                                    }
                                                                    let _e1907 = phi_2534_;
                                                                    let _e1909 = phi_2535_;
                                                                    phi_2539_ = _e1907;
                                                                    phi_2540_ = _e1909;
                                                                }
                                                                let _e1911 = phi_2539_;
                                                                let _e1913 = phi_2540_;
                                                                phi_2541_ = _e1911;
                                                                phi_2542_ = _e1566;
                                                                phi_2543_ = _e1913;
                                                            }
                                                            let _e1915 = phi_2541_;
                                                            let _e1917 = phi_2542_;
                                                            let _e1919 = phi_2543_;
                                                            phi_2544_ = _e1915;
                                                            phi_2545_ = _e1917;
                                                            phi_2546_ = _e1919;
                                                        }
                                                        let _e1921 = phi_2544_;
                                                        let _e1923 = phi_2545_;
                                                        let _e1925 = phi_2546_;
                                                        phi_2554_ = _e1921;
                                                        phi_2555_ = select(_e1925, true, _e1923);
                                                    } else {
                                                        phi_2554_ = type_18();
                                                        phi_2555_ = true;
                                                    }
                                                    let _e1928 = phi_2554_;
                                                    let _e1930 = phi_2555_;
                                                    if _e1930 {
                                                        phi_2559_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2559_ = _e1928;
                                                    }
                                                    let _e1932 = phi_2559_;
                                                    if (_e1932.member_3 != 4294967295u) {
                                                        if (_e1099 != _e456) {
                                                            if (_e1932.member < _e1033.member.member.member) {
                                                                phi_2585_ = true;
                                                            } else {
                                                                if (_e1932.member == _e1033.member.member.member) {
                                                                    phi_2584_ = (_e1932.member_3 < _e1033.member.member.member_3);
                                                                } else {
                                                                    phi_2584_ = false;
                                                                }
                                                                let _e1947 = phi_2584_;
                                                                phi_2585_ = _e1947;
                                                            }
                                                            let _e1949 = phi_2585_;
                                                            if _e1949 {
                                                                phi_2592_ = type_38(type_34(_e1932, _e1932.member), _e1060.member_1, _e1060.member_2);
                                                            } else {
                                                                phi_2592_ = _e1060;
                                                            }
                                                            let _e1956 = phi_2592_;
                                                            phi_2593_ = _e1956;
                                                        } else {
                                                            phi_2593_ = _e1060;
                                                        }
                                                        let _e1958 = phi_2593_;
                                                        phi_2594_ = _e1958;
                                                    } else {
                                                        phi_2594_ = _e1060;
                                                    }
                                                    let _e1960 = phi_2594_;
                                                    phi_998_ = _e1960;
                                                } else {
                                                    phi_998_ = type_38();
                                                }
                                                let _e1962 = phi_998_;
                                                continue;
                                                continuing {
                                                    phi_997_ = _e1962;
                                                    phi_1000_ = _e1048;
                                                    phi_4214_ = _e497;
                                                    break if !(_e1054);
                                                }
                                            }
                                            let _e1965 = phi_4214_;
                                            phi_4403_ = _e1965;
                                            if _e1965 {
                                                break;
                                            }
                                            phi_4407_ = _e1965;
                                            let _e2235 = local_12;
                                            phi_3837_ = _e2235;
                                            phi_3838_ = _e539;
                                            phi_3839_ = false;
                                            phi_3840_ = _e543;
                                        } else {
                                            if (_e539.member_1 >= _e91) {
                                                phi_3393_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e539.member_1 < _e91) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e561 = (_e272 * 2u);
                                                let _e563 = ((1u + _e561) % 7u);
                                                if (_e563 < 7u) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e568 = global_6.member[_e539.member_1][_e563];
                                                let _e570 = ((_e561 + 2u) % 7u);
                                                if (_e570 < 7u) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e575 = global_6.member[_e539.member_1][_e570];
                                                let _e576 = (_e271 * 2u);
                                                let _e578 = ((1u + _e576) % 7u);
                                                if (_e578 < 7u) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e583 = global_6.member[_e539.member_1][_e578];
                                                let _e585 = ((_e576 + 2u) % 7u);
                                                if (_e585 < 7u) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e590 = global_6.member[_e539.member_1][_e585];
                                                let _e591 = (_e273 * 2u);
                                                let _e593 = ((1u + _e591) % 7u);
                                                if (_e593 < 7u) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e598 = global_6.member[_e539.member_1][_e593];
                                                let _e600 = ((_e591 + 2u) % 7u);
                                                if (_e600 < 7u) {
                                                } else {
                                                    phi_4403_ = true;
                                                    break;
                                                }
                                                let _e605 = global_6.member[_e539.member_1][_e600];
                                                let _e628 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.x - _e539.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e629 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.y - _e539.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e630 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.z - _e539.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e632 = select(_e146, _e628, (_e628 > _e146));
                                                let _e634 = select(_e146, _e629, (_e629 > _e146));
                                                let _e636 = select(_e146, _e630, (_e630 > _e146));
                                                let _e661 = bitcast<u32>((f32(bitcast<i32>((_e568 & 2097151u))) * _e632));
                                                let _e666 = (bitcast<i32>((_e568 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e669 = bitcast<f32>((_e661 & bitcast<u32>(_e666)));
                                                let _e670 = bitcast<u32>((f32(bitcast<i32>((_e583 & 2097151u))) * _e634));
                                                let _e675 = (bitcast<i32>((_e583 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e678 = bitcast<f32>((_e670 & bitcast<u32>(_e675)));
                                                let _e679 = bitcast<u32>((f32(bitcast<i32>((_e598 & 2097151u))) * _e636));
                                                let _e684 = (bitcast<i32>((_e598 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e687 = bitcast<f32>((_e679 & bitcast<u32>(_e684)));
                                                let _e691 = bitcast<f32>((_e661 & bitcast<u32>(~(_e666))));
                                                let _e695 = bitcast<f32>((_e670 & bitcast<u32>(~(_e675))));
                                                let _e699 = bitcast<f32>((_e679 & bitcast<u32>(~(_e684))));
                                                let _e700 = bitcast<u32>((f32(bitcast<i32>((_e575 & 2097151u))) * _e632));
                                                let _e705 = (bitcast<i32>((_e575 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e708 = bitcast<f32>((_e700 & bitcast<u32>(_e705)));
                                                let _e709 = bitcast<u32>((f32(bitcast<i32>((_e590 & 2097151u))) * _e634));
                                                let _e714 = (bitcast<i32>((_e590 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e717 = bitcast<f32>((_e709 & bitcast<u32>(_e714)));
                                                let _e718 = bitcast<u32>((f32(bitcast<i32>((_e605 & 2097151u))) * _e636));
                                                let _e723 = (bitcast<i32>((_e605 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e726 = bitcast<f32>((_e718 & bitcast<u32>(_e723)));
                                                let _e730 = bitcast<f32>((_e700 & bitcast<u32>(~(_e705))));
                                                let _e734 = bitcast<f32>((_e709 & bitcast<u32>(~(_e714))));
                                                let _e738 = bitcast<f32>((_e718 & bitcast<u32>(~(_e723))));
                                                let _e739 = (_e539.member.member.x + _e669);
                                                let _e740 = (_e539.member.member.y + _e678);
                                                let _e741 = (_e539.member.member.z + _e687);
                                                let _e744 = (_e539.member.member_1.x - _e708);
                                                let _e745 = (_e539.member.member_1.y - _e717);
                                                let _e746 = (_e539.member.member_1.z - _e726);
                                                let _e765 = (_e744 - _e739);
                                                let _e766 = (_e745 - _e740);
                                                let _e767 = (_e746 - _e741);
                                                let _e769 = select(_e766, _e765, (_e765 > _e766));
                                                let _e771 = select(_e767, _e769, (_e769 > _e767));
                                                if (_e771 < (1024f * _e146)) {
                                                    phi_3094_ = 0u;
                                                } else {
                                                    phi_3094_ = select(2u, 1u, (_e771 < (2097152f * _e146)));
                                                }
                                                let _e778 = phi_3094_;
                                                switch bitcast<i32>(_e778) {
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
                                                let _e781 = phi_3100_;
                                                let _e787 = global_6.member[_e539.member_1][0u];
                                                let _e791 = global_6.member[_e539.member_1][2u];
                                                let _e795 = global_6.member[_e539.member_1][4u];
                                                let _e799 = global_6.member[_e539.member_1][6u];
                                                let _e811 = (((_e791 >> bitcast<u32>(22i)) | ((_e795 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e799 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e812 = (_e787 & 268435455u);
                                                let _e813 = (_e811 & 268435455u);
                                                let _e816 = ((_e787 >> bitcast<u32>(28u)) & 7u);
                                                let _e824 = ((_e787 >> bitcast<u32>(31i)) | (((_e811 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e825 = (_e816 != 0u);
                                                if (_e816 == 0u) {
                                                    phi_3355_ = _e812;
                                                } else {
                                                    if (_e816 == 7u) {
                                                        phi_3354_ = 2147483648u;
                                                    } else {
                                                        phi_3354_ = ((2147483648u | (_e816 << bitcast<u32>(28u))) | (_e813 & 268435455u));
                                                    }
                                                    let _e834 = phi_3354_;
                                                    phi_3355_ = _e834;
                                                }
                                                let _e836 = phi_3355_;
                                                if _e825 {
                                                    let _e837 = (_e816 != 7u);
                                                    if _e837 {
                                                        phi_3365_ = (_e813 + (_e816 * ((3u * _e781) + 1u)));
                                                    } else {
                                                        phi_3365_ = u32();
                                                    }
                                                    let _e841 = phi_3365_;
                                                    phi_3367_ = _e841;
                                                    phi_3368_ = select(true, false, _e837);
                                                } else {
                                                    phi_3367_ = u32();
                                                    phi_3368_ = true;
                                                }
                                                let _e844 = phi_3367_;
                                                let _e846 = phi_3368_;
                                                if (_e824 == 0u) {
                                                    phi_3389_ = (_e812 + select(0u, 1u, !(_e825)));
                                                } else {
                                                    if (_e824 == 7u) {
                                                        phi_3388_ = 2147483648u;
                                                    } else {
                                                        phi_3388_ = ((2147483648u | (_e824 << bitcast<u32>(28u))) | (select(_e844, _e813, _e846) & 268435455u));
                                                    }
                                                    let _e859 = phi_3388_;
                                                    phi_3389_ = _e859;
                                                }
                                                let _e861 = phi_3389_;
                                                phi_3393_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e739, (_e539.member.member.x + _e691), _e744, (_e539.member.member_1.x - _e730)), vec4<f32>(_e740, (_e539.member.member.y + _e695), _e745, (_e539.member.member_1.y - _e734)), vec4<f32>(_e741, (_e539.member.member.z + _e699), _e746, (_e539.member.member_1.z - _e738))), type_49(type_30((_e539.member.member + vec4<f32>(_e669, _e678, _e687, 0f)), (_e539.member.member_1 - vec4<f32>(_e708, _e717, _e726, 0f))), _e836), type_49(type_30((_e539.member.member + vec4<f32>(_e691, _e695, _e699, 0f)), (_e539.member.member_1 - vec4<f32>(_e730, _e734, _e738, 0f))), _e861));
                                            }
                                            let _e866 = phi_3393_;
                                            let _e879 = ((_e866.member[0].x - _e327) * _e332);
                                            let _e880 = ((_e866.member[0].y - _e327) * _e332);
                                            let _e881 = ((_e866.member[0].z - _e328) * _e332);
                                            let _e882 = ((_e866.member[0].w - _e328) * _e332);
                                            let _e892 = ((_e866.member[1].x - _e363) * _e368);
                                            let _e893 = ((_e866.member[1].y - _e363) * _e368);
                                            let _e894 = ((_e866.member[1].z - _e364) * _e368);
                                            let _e895 = ((_e866.member[1].w - _e364) * _e368);
                                            let _e905 = ((_e866.member[2].x - _e399) * _e404);
                                            let _e906 = ((_e866.member[2].y - _e399) * _e404);
                                            let _e907 = ((_e866.member[2].z - _e400) * _e404);
                                            let _e908 = ((_e866.member[2].w - _e400) * _e404);
                                            let _e910 = select(_e907, _e905, (_e905 < _e907));
                                            let _e912 = select(_e908, _e906, (_e906 < _e908));
                                            let _e914 = select(_e907, _e905, (_e905 > _e907));
                                            let _e916 = select(_e908, _e906, (_e906 > _e908));
                                            let _e918 = select(_e881, _e879, (_e879 < _e881));
                                            let _e920 = select(_e882, _e880, (_e880 < _e882));
                                            let _e922 = select(_e894, _e892, (_e892 < _e894));
                                            let _e924 = select(_e895, _e893, (_e893 < _e895));
                                            let _e926 = select(_e922, _e918, (_e918 > _e922));
                                            let _e928 = select(_e924, _e920, (_e920 > _e924));
                                            let _e930 = select(_e910, _e926, (_e926 > _e910));
                                            let _e932 = select(_e912, _e928, (_e928 > _e912));
                                            let _e934 = select(_e881, _e879, (_e879 > _e881));
                                            let _e936 = select(_e882, _e880, (_e880 > _e882));
                                            let _e938 = select(_e894, _e892, (_e892 > _e894));
                                            let _e940 = select(_e895, _e893, (_e893 > _e895));
                                            let _e942 = select(_e938, _e934, (_e934 < _e938));
                                            let _e944 = select(_e940, _e936, (_e936 < _e940));
                                            let _e949 = -(_e910);
                                            let _e950 = -(_e912);
                                            let _e957 = (select(_e914, _e942, (_e942 < _e914)) + (select(_e949, _e914, (_e914 > _e949)) * 0.0000019073523f));
                                            let _e958 = (select(_e916, _e944, (_e944 < _e916)) + (select(_e950, _e916, (_e916 > _e950)) * 0.0000019073523f));
                                            let _e960 = select(_e450, _e930, (_e930 > _e450));
                                            let _e962 = select(_e450, _e932, (_e932 > _e450));
                                            let _e967 = (_e960 <= select(_e499.member.member_1, _e957, (_e957 < _e499.member.member_1)));
                                            let _e968 = (_e962 <= select(_e499.member.member_1, _e958, (_e958 < _e499.member.member_1)));
                                            let _e969 = (_e960 <= _e962);
                                            if _e967 {
                                                if _e968 {
                                                    if _e969 {
                                                        phi_3737_ = _e866.member_2;
                                                    } else {
                                                        phi_3737_ = _e866.member_1;
                                                    }
                                                    let _e973 = phi_3737_;
                                                    let _e995 = (_e543 % 128u);
                                                    let _e996 = (_e995 < 128u);
                                                    if _e996 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_8[_e995] = _e973.member_1;
                                                    if _e996 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_7[_e995] = _e973.member.member.x;
                                                    if _e996 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_6[_e995] = _e973.member.member.y;
                                                    if _e996 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_5[_e995] = _e973.member.member.z;
                                                    if _e996 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_4[_e995] = _e973.member.member_1.x;
                                                    if _e996 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_3[_e995] = _e973.member.member_1.y;
                                                    if _e996 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_2[_e995] = _e973.member.member_1.z;
                                                    if _e996 {
                                                    } else {
                                                        phi_4403_ = true;
                                                        break;
                                                    }
                                                    local_9[_e995] = select(_e962, _e960, (_e960 > _e962));
                                                    if _e969 {
                                                        phi_3814_ = _e866.member_1;
                                                    } else {
                                                        phi_3814_ = _e866.member_2;
                                                    }
                                                    let _e1009 = phi_3814_;
                                                    phi_3815_ = _e1009;
                                                    phi_3816_ = (_e543 + 1u);
                                                } else {
                                                    phi_3815_ = type_49();
                                                    phi_3816_ = u32();
                                                }
                                                let _e1011 = phi_3815_;
                                                let _e1013 = phi_3816_;
                                                phi_3818_ = _e1011;
                                                phi_3819_ = _e1013;
                                                phi_3820_ = select(true, false, _e968);
                                            } else {
                                                phi_3818_ = type_49();
                                                phi_3819_ = u32();
                                                phi_3820_ = true;
                                            }
                                            let _e1016 = phi_3818_;
                                            let _e1018 = phi_3819_;
                                            let _e1020 = phi_3820_;
                                            if _e1020 {
                                                if _e967 {
                                                    phi_3829_ = _e866.member_1;
                                                } else {
                                                    phi_3829_ = _e866.member_2;
                                                }
                                                let _e1024 = phi_3829_;
                                                phi_3834_ = _e1024;
                                                phi_3835_ = select(_e968, true, _e967);
                                            } else {
                                                phi_3834_ = _e1016;
                                                phi_3835_ = _e541;
                                            }
                                            let _e1027 = phi_3834_;
                                            let _e1029 = phi_3835_;
                                            phi_4407_ = _e497;
                                            phi_3837_ = type_38(_e499.member, (_e499.member_1 + 1u), _e499.member_2);
                                            phi_3838_ = _e1027;
                                            phi_3839_ = _e1029;
                                            phi_3840_ = select(_e1018, _e543, _e1020);
                                        }
                                        let _e1967 = phi_4407_;
                                        let _e1969 = phi_3837_;
                                        let _e1971 = phi_3838_;
                                        let _e1973 = phi_3839_;
                                        let _e1975 = phi_3840_;
                                        phi_4406_ = _e1967;
                                        phi_3841_ = _e1969;
                                        phi_3842_ = _e1971;
                                        phi_3843_ = (_e503 - 1u);
                                        phi_3844_ = _e1973;
                                        phi_3845_ = _e1975;
                                    } else {
                                        phi_4406_ = _e497;
                                        phi_3841_ = _e499;
                                        phi_3842_ = _e539;
                                        phi_3843_ = _e503;
                                        phi_3844_ = _e541;
                                        phi_3845_ = _e543;
                                    }
                                    let _e1977 = phi_4406_;
                                    let _e1979 = phi_3841_;
                                    let _e1981 = phi_3842_;
                                    let _e1983 = phi_3843_;
                                    let _e1985 = phi_3844_;
                                    let _e1987 = phi_3845_;
                                    phi_4405_ = _e1977;
                                    phi_3846_ = _e1979;
                                    phi_3847_ = _e1981;
                                    phi_3848_ = _e1983;
                                    phi_3849_ = _e1985;
                                    phi_3850_ = _e1987;
                                } else {
                                    phi_4405_ = _e497;
                                    phi_3846_ = type_38();
                                    phi_3847_ = type_49();
                                    phi_3848_ = u32();
                                    phi_3849_ = bool();
                                    phi_3850_ = u32();
                                }
                                let _e1989 = phi_4405_;
                                let _e1991 = phi_3846_;
                                let _e1993 = phi_3847_;
                                let _e1995 = phi_3848_;
                                let _e1997 = phi_3849_;
                                let _e1999 = phi_3850_;
                                phi_4404_ = _e1989;
                                phi_871_ = _e1991;
                                phi_874_ = _e1993;
                                phi_876_ = _e1995;
                                phi_878_ = _e1997;
                                phi_880_ = _e1999;
                                phi_3851_ = _e511;
                            } else {
                                phi_4404_ = _e497;
                                phi_871_ = type_38();
                                phi_874_ = type_49();
                                phi_876_ = u32();
                                phi_878_ = bool();
                                phi_880_ = u32();
                                phi_3851_ = false;
                            }
                            let _e2001 = phi_4404_;
                            let _e2003 = phi_871_;
                            let _e2005 = phi_874_;
                            let _e2007 = phi_876_;
                            let _e2009 = phi_878_;
                            let _e2011 = phi_880_;
                            let _e2013 = phi_3851_;
                            continue;
                            continuing {
                                phi_4220_ = _e2001;
                                phi_870_ = _e2003;
                                phi_873_ = _e2005;
                                phi_875_ = _e2007;
                                phi_877_ = _e2009;
                                phi_879_ = _e2011;
                                phi_4403_ = _e2001;
                                break if !(_e2013);
                            }
                        }
                        let _e2016 = phi_4403_;
                        if _e2016 {
                            break;
                        }
                        let _e2018 = local_10;
                        if (_e2018.member.member.member_3 != 4294967295u) {
                            let _e2024 = (_e274 / 3i);
                            let _e2031 = bitcast<f32>((bitcast<u32>((_e2024 + 127i)) << bitcast<u32>(23i)));
                            let _e2039 = (((_e2018.member.member.member * _e2031) * _e2031) * bitcast<f32>((bitcast<u32>(((_e274 - (2i * _e2024)) + 127i)) << bitcast<u32>(23i))));
                            let _e2041 = select(340282350000000000000000000000000000000f, _e2039, (_e2039 < 340282350000000000000000000000000000000f));
                            phi_3903_ = type_18(select(-340282350000000000000000000000000000000f, _e2041, (_e2041 > -340282350000000000000000000000000000000f)), _e2018.member.member.member_1, _e2018.member.member.member_2, _e2018.member.member.member_3);
                        } else {
                            phi_3903_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2048 = phi_3903_;
                        if _e150 {
                        } else {
                            break;
                        }
                        global_1.member[_e134] = _e2048;
                        let _e2052 = local_11;
                        if _e151 {
                        } else {
                            break;
                        }
                        global_4.member[_e134] = _e2052.member_1;
                        if _e149 {
                        } else {
                            break;
                        }
                        let _e2057 = select(0u, 1u, (_e218 <= _e228));
                        if (_e2057 > 0u) {
                            let _e2059 = (1u < _e102);
                            if _e2059 {
                                if (0u < _e102) {
                                } else {
                                    break;
                                }
                                let _e2063 = atomicAdd((&global_5.member[0u]), _e2057);
                                if ((_e2063 + _e2057) < _e2063) {
                                    if _e2059 {
                                    } else {
                                        break;
                                    }
                                    let _e2068 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2071 = select(0u, 1u, (_e2048.member_3 != 4294967295u));
                        if (_e2071 > 0u) {
                            let _e2073 = (3u < _e102);
                            if _e2073 {
                                if (2u < _e102) {
                                } else {
                                    break;
                                }
                                let _e2077 = atomicAdd((&global_5.member[2u]), _e2071);
                                if ((_e2077 + _e2071) < _e2077) {
                                    if _e2073 {
                                    } else {
                                        break;
                                    }
                                    let _e2082 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2052.member_1 > 0u) {
                            let _e2084 = (5u < _e102);
                            if _e2084 {
                                if (4u < _e102) {
                                } else {
                                    break;
                                }
                                let _e2088 = atomicAdd((&global_5.member[4u]), _e2052.member_1);
                                if ((_e2088 + _e2052.member_1) < _e2088) {
                                    if _e2084 {
                                    } else {
                                        break;
                                    }
                                    let _e2093 = atomicAdd((&global_5.member[5u]), 1u);
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
