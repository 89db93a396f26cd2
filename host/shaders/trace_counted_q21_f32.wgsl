struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: type_25,
    member_1: f32,
}

struct type_38 {
    member: array<type_26>,
}

struct type_40 {
    member: type_33,
    member_1: u32,
    member_2: u32,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_29,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(4) 
var<storage> global_4: type_38;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

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
    var phi_382_: i32;
    var phi_383_: i32;
    var phi_393_: bool;
    var phi_403_: u32;
    var phi_404_: u32;
    var phi_406_: bool;
    var phi_411_: u32;
    var phi_423_: i32;
    var phi_443_: i32;
    var phi_461_: f32;
    var phi_467_: f32;
    var phi_478_: f32;
    var phi_484_: f32;
    var phi_507_: f32;
    var phi_518_: f32;
    var phi_527_: f32;
    var phi_533_: f32;
    var phi_544_: f32;
    var phi_550_: f32;
    var phi_573_: f32;
    var phi_584_: f32;
    var phi_593_: f32;
    var phi_599_: f32;
    var phi_610_: f32;
    var phi_616_: f32;
    var phi_639_: f32;
    var phi_650_: f32;
    var phi_750_: f32;
    var phi_751_: f32;
    var phi_3415_: bool;
    var phi_841_: type_40;
    var phi_844_: type_51;
    var phi_846_: u32;
    var phi_848_: bool;
    var phi_850_: u32;
    var phi_861_: bool;
    var phi_947_: type_51;
    var phi_948_: bool;
    var phi_949_: u32;
    var phi_2706_: u32;
    var phi_2707_: u32;
    var phi_2717_: u32;
    var phi_2719_: u32;
    var phi_2720_: bool;
    var phi_2740_: u32;
    var phi_2741_: u32;
    var phi_2745_: type_52;
    var phi_3089_: type_51;
    var phi_3166_: type_51;
    var phi_3167_: type_51;
    var phi_3168_: u32;
    var phi_3170_: type_51;
    var phi_3171_: u32;
    var phi_3172_: bool;
    var phi_3181_: type_51;
    var phi_3186_: type_51;
    var phi_3187_: bool;
    var phi_967_: type_40;
    var phi_970_: type_4;
    var phi_971_: type_4;
    var phi_993_: type_4;
    var phi_1017_: u32;
    var phi_1106_: array<array<f32, 3>, 3>;
    var phi_1223_: bool;
    var phi_1252_: bool;
    var phi_1653_: f32;
    var phi_1654_: f32;
    var phi_1655_: f32;
    var phi_1656_: f32;
    var phi_1657_: vec3<f32>;
    var phi_1658_: vec3<f32>;
    var phi_1659_: vec3<f32>;
    var phi_1660_: vec3<f32>;
    var phi_1691_: bool;
    var phi_1700_: vec3<f32>;
    var phi_1865_: f32;
    var phi_1867_: f32;
    var phi_1868_: bool;
    var phi_1888_: f32;
    var phi_1889_: f32;
    var phi_1912_: type_25;
    var phi_1914_: type_25;
    var phi_1915_: bool;
    var phi_1919_: type_25;
    var phi_1920_: type_25;
    var phi_1921_: type_25;
    var phi_1922_: bool;
    var phi_1926_: type_25;
    var phi_1927_: bool;
    var phi_1928_: type_25;
    var phi_1929_: bool;
    var phi_1930_: bool;
    var phi_1931_: type_25;
    var phi_1932_: bool;
    var phi_1933_: bool;
    var phi_1941_: type_25;
    var phi_1942_: bool;
    var phi_1946_: type_25;
    var phi_1971_: bool;
    var phi_1972_: bool;
    var phi_1979_: type_40;
    var phi_1980_: type_40;
    var phi_1981_: type_40;
    var phi_968_: type_40;
    var phi_3409_: bool;
    var phi_3555_: bool;
    var phi_3189_: type_40;
    var phi_3190_: type_51;
    var phi_3191_: bool;
    var phi_3192_: u32;
    var phi_3554_: bool;
    var phi_3193_: type_40;
    var phi_3194_: type_51;
    var phi_3195_: u32;
    var phi_3196_: bool;
    var phi_3197_: u32;
    var phi_3553_: bool;
    var phi_3198_: type_40;
    var phi_3199_: type_51;
    var phi_3200_: u32;
    var phi_3201_: bool;
    var phi_3202_: u32;
    var phi_3552_: bool;
    var phi_842_: type_40;
    var phi_845_: type_51;
    var phi_847_: u32;
    var phi_849_: bool;
    var phi_851_: u32;
    var phi_3203_: bool;
    var phi_3551_: bool;
    var local_10: type_40;
    var local_11: type_40;
    var local_12: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e83 = global;
            let _e85 = arrayLength((&global_5.member));
            let _e87 = arrayLength((&global_2.member));
            let _e95 = global_3.member[0u][0u];
            let _e99 = global_3.member[0u][1u];
            let _e103 = global_3.member[0u][2u];
            let _e107 = global_3.member[0u][3u];
            let _e111 = global_3.member[1u][0u];
            let _e115 = global_3.member[1u][1u];
            let _e119 = global_3.member[1u][2u];
            let _e122 = global_1.member[0u];
            let _e123 = bitcast<i32>(_e122);
            let _e135 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e107) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e95), bitcast<i32>(_e99), bitcast<i32>(_e103));
            local = array<i32, 3>(bitcast<i32>(_e111), bitcast<i32>(_e115), bitcast<i32>(_e119));
            let _e141 = (_e83.x + (_e83.y * 2097152u));
            let _e142 = (_e141 < arrayLength((&global_4.member)));
            if _e142 {
                let _e143 = (_e141 < arrayLength((&global_6.member)));
                if _e143 {
                    if _e142 {
                    } else {
                        break;
                    }
                    let _e151 = global_4.member[_e141].member_2[0u];
                    let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                    let _e158 = global_4.member[_e141].member_2[1u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_4.member[_e141].member_2[2u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_4.member[_e141].member[0u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e179 = global_4.member[_e141].member[1u];
                    let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                    let _e186 = global_4.member[_e141].member[2u];
                    let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                    let _e190 = select(_e160, _e153, (_e160 < _e153));
                    let _e192 = select(_e167, _e190, (_e167 < _e190));
                    let _e194 = select(_e174, _e192, (_e174 < _e192));
                    let _e196 = select(_e181, _e194, (_e181 < _e194));
                    let _e198 = select(_e188, _e196, (_e188 < _e196));
                    let _e202 = global_4.member[_e141].member_1;
                    let _e204 = (bitcast<u32>(_e202) & 2147483647u);
                    let _e211 = global_4.member[_e141].member_3;
                    let _e217 = (((select(_e204, _e198, (_e204 < _e198)) < 2139095040u) && ((bitcast<u32>(_e211) & 2147483647u) <= 2139095040u)) && (_e192 > 0u));
                    if _e217 {
                        let _e220 = (bitcast<u32>(bitcast<f32>(_e192)) & 2147483647u);
                        if (_e220 >= 8388608u) {
                            phi_382_ = (bitcast<i32>((_e220 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_382_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e220)), 32u, (_e220 == 0u))));
                        }
                        let _e234 = phi_382_;
                        phi_383_ = _e234;
                    } else {
                        phi_383_ = 0i;
                    }
                    let _e236 = phi_383_;
                    let _e237 = (_e153 == _e192);
                    if _e237 {
                        phi_393_ = true;
                    } else {
                        phi_393_ = (_e160 == _e192);
                    }
                    let _e240 = phi_393_;
                    let _e241 = select(1u, 0u, _e237);
                    if _e240 {
                        let _e242 = (_e241 + 1u);
                        phi_403_ = _e242;
                        phi_404_ = _e242;
                        phi_406_ = select(true, false, (_e242 == 2u));
                    } else {
                        phi_403_ = u32();
                        phi_404_ = 0u;
                        phi_406_ = true;
                    }
                    let _e246 = phi_403_;
                    let _e248 = phi_404_;
                    let _e250 = phi_406_;
                    if _e250 {
                        phi_411_ = (_e248 + 1u);
                    } else {
                        phi_411_ = 0u;
                    }
                    let _e254 = phi_411_;
                    let _e255 = select(_e246, _e248, _e250);
                    let _e256 = select(_e241, select(2u, _e241, _e240), _e250);
                    if (_e123 < -126i) {
                        phi_423_ = -126i;
                    } else {
                        phi_423_ = select(_e123, 127i, (_e123 > 127i));
                    }
                    let _e261 = phi_423_;
                    let _e266 = bitcast<f32>((bitcast<u32>((_e261 + 127i)) << bitcast<u32>(23i)));
                    let _e272 = bitcast<f32>((bitcast<u32>(((_e123 - _e261) + 127i)) << bitcast<u32>(23i)));
                    let _e273 = -(_e236);
                    if (_e273 < -126i) {
                        phi_443_ = -126i;
                    } else {
                        phi_443_ = select(_e273, 127i, (_e273 > 127i));
                    }
                    let _e278 = phi_443_;
                    let _e283 = bitcast<f32>((bitcast<u32>((_e278 + 127i)) << bitcast<u32>(23i)));
                    let _e289 = bitcast<f32>((bitcast<u32>(((_e273 - _e278) + 127i)) << bitcast<u32>(23i)));
                    let _e293 = global_4.member[_e141].member;
                    let _e294 = (_e255 == 0u);
                    if _e294 {
                        phi_461_ = _e293[0];
                    } else {
                        phi_461_ = _e293[1];
                    }
                    let _e298 = phi_461_;
                    let _e299 = (_e255 == 2u);
                    if _e299 {
                        phi_467_ = _e293[2];
                    } else {
                        phi_467_ = _e298;
                    }
                    let _e302 = phi_467_;
                    let _e304 = ((_e302 * _e266) * _e272);
                    let _e305 = global_4.member[_e141].member_2;
                    if _e294 {
                        phi_478_ = _e305[0];
                    } else {
                        phi_478_ = _e305[1];
                    }
                    let _e309 = phi_478_;
                    if _e299 {
                        phi_484_ = _e305[2];
                    } else {
                        phi_484_ = _e309;
                    }
                    let _e312 = phi_484_;
                    let _e314 = ((_e312 * _e283) * _e289);
                    let _e318 = (bitcast<f32>((bitcast<u32>(_e314) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e318 {
                        let _e322 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) * 0.00000011920929f);
                        phi_507_ = select(0.00000000000011368684f, _e322, (_e322 > 0.00000000000011368684f));
                    } else {
                        phi_507_ = 0f;
                    }
                    let _e326 = phi_507_;
                    let _e327 = (_e304 + _e326);
                    let _e328 = (_e304 - _e326);
                    let _e329 = select(_e314, 0f, _e318);
                    if _e318 {
                        phi_518_ = 38685626000000000000000000f;
                    } else {
                        phi_518_ = (1f / _e314);
                    }
                    let _e332 = phi_518_;
                    let _e333 = (_e254 == 0u);
                    if _e333 {
                        phi_527_ = _e293[0];
                    } else {
                        phi_527_ = _e293[1];
                    }
                    let _e337 = phi_527_;
                    let _e338 = (_e254 == 2u);
                    if _e338 {
                        phi_533_ = _e293[2];
                    } else {
                        phi_533_ = _e337;
                    }
                    let _e341 = phi_533_;
                    let _e343 = ((_e341 * _e266) * _e272);
                    if _e333 {
                        phi_544_ = _e305[0];
                    } else {
                        phi_544_ = _e305[1];
                    }
                    let _e347 = phi_544_;
                    if _e338 {
                        phi_550_ = _e305[2];
                    } else {
                        phi_550_ = _e347;
                    }
                    let _e350 = phi_550_;
                    let _e352 = ((_e350 * _e283) * _e289);
                    let _e356 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e356 {
                        let _e360 = (bitcast<f32>((bitcast<u32>(_e343) & 2147483647u)) * 0.00000011920929f);
                        phi_573_ = select(0.00000000000011368684f, _e360, (_e360 > 0.00000000000011368684f));
                    } else {
                        phi_573_ = 0f;
                    }
                    let _e364 = phi_573_;
                    let _e365 = (_e343 + _e364);
                    let _e366 = (_e343 - _e364);
                    let _e367 = select(_e352, 0f, _e356);
                    if _e356 {
                        phi_584_ = 38685626000000000000000000f;
                    } else {
                        phi_584_ = (1f / _e352);
                    }
                    let _e370 = phi_584_;
                    let _e371 = (_e256 == 0u);
                    if _e371 {
                        phi_593_ = _e293[0];
                    } else {
                        phi_593_ = _e293[1];
                    }
                    let _e375 = phi_593_;
                    let _e376 = (_e256 == 2u);
                    if _e376 {
                        phi_599_ = _e293[2];
                    } else {
                        phi_599_ = _e375;
                    }
                    let _e379 = phi_599_;
                    let _e381 = ((_e379 * _e266) * _e272);
                    if _e371 {
                        phi_610_ = _e305[0];
                    } else {
                        phi_610_ = _e305[1];
                    }
                    let _e385 = phi_610_;
                    if _e376 {
                        phi_616_ = _e305[2];
                    } else {
                        phi_616_ = _e385;
                    }
                    let _e388 = phi_616_;
                    let _e390 = ((_e388 * _e283) * _e289);
                    let _e394 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e394 {
                        let _e398 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) * 0.00000011920929f);
                        phi_639_ = select(0.00000000000011368684f, _e398, (_e398 > 0.00000000000011368684f));
                    } else {
                        phi_639_ = 0f;
                    }
                    let _e402 = phi_639_;
                    let _e403 = (_e381 + _e402);
                    let _e404 = (_e381 - _e402);
                    let _e405 = select(_e390, 0f, _e394);
                    if _e394 {
                        phi_650_ = 38685626000000000000000000f;
                    } else {
                        phi_650_ = (1f / _e390);
                    }
                    let _e408 = phi_650_;
                    let _e411 = bitcast<f32>((bitcast<u32>(_e304) & 2147483647u));
                    let _e414 = bitcast<f32>((bitcast<u32>(_e343) & 2147483647u));
                    let _e416 = select(_e414, _e411, (_e411 > _e414));
                    let _e419 = bitcast<f32>((bitcast<u32>(_e381) & 2147483647u));
                    let _e422 = (_e123 + _e236);
                    if (_e217 && (select(_e419, _e416, (_e416 > _e419)) <= 1099511600000f)) {
                        let _e425 = (_e422 / 3i);
                        let _e432 = bitcast<f32>((bitcast<u32>((_e425 + 127i)) << bitcast<u32>(23i)));
                        let _e439 = bitcast<f32>((bitcast<u32>(((_e422 - (2i * _e425)) + 127i)) << bitcast<u32>(23i)));
                        let _e440 = (((_e202 * _e432) * _e432) * _e439);
                        let _e442 = select(340282350000000000000000000000000000000f, _e440, (_e440 < 340282350000000000000000000000000000000f));
                        let _e447 = (((_e211 * _e432) * _e432) * _e439);
                        let _e449 = select(340282350000000000000000000000000000000f, _e447, (_e447 < 340282350000000000000000000000000000000f));
                        phi_750_ = select(-340282350000000000000000000000000000000f, _e449, (_e449 > -340282350000000000000000000000000000000f));
                        phi_751_ = select(-340282350000000000000000000000000000000f, _e442, (_e442 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_750_ = 0f;
                        phi_751_ = 1f;
                    }
                    let _e453 = phi_750_;
                    let _e455 = phi_751_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e460 = (_e255 % 3u);
                    let _e461 = (_e460 < 3u);
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e463 = local_1[_e460];
                    let _e466 = (_e254 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    let _e472 = (_e256 % 3u);
                    let _e473 = (_e472 < 3u);
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e475 = local_1[_e472];
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e480 = local[_e460];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e484 = local[_e466];
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e472];
                    phi_3415_ = false;
                    phi_841_ = type_40(type_33(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e453), 0u, 0u);
                    phi_844_ = type_51(type_29(vec4<f32>((f32(_e463) * _e135), (f32(_e469) * _e135), (f32(_e475) * _e135), 0f), vec4<f32>((f32(_e480) * _e135), (f32(_e484) * _e135), (f32(_e488) * _e135), 0f)), select(0u, 2147483648u, (_e85 == 0u)));
                    phi_846_ = ((3u * _e85) + 1u);
                    phi_848_ = (_e455 <= _e453);
                    phi_850_ = 0u;
                    loop {
                        let _e498 = phi_3415_;
                        let _e500 = phi_841_;
                        let _e502 = phi_844_;
                        let _e504 = phi_846_;
                        let _e506 = phi_848_;
                        let _e508 = phi_850_;
                        local_10 = _e500;
                        local_11 = _e500;
                        if _e506 {
                            phi_861_ = true;
                        } else {
                            phi_861_ = (_e508 > 0u);
                        }
                        let _e511 = phi_861_;
                        if _e511 {
                            let _e512 = (_e504 > 0u);
                            if _e512 {
                                if _e506 {
                                    phi_947_ = _e502;
                                    phi_948_ = _e506;
                                    phi_949_ = _e508;
                                } else {
                                    let _e513 = (_e508 - 1u);
                                    let _e514 = (_e513 % 128u);
                                    let _e515 = (_e514 < 128u);
                                    if _e515 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e517 = local_7[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e519 = local_6[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e521 = local_5[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e523 = local_4[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e525 = local_3[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e527 = local_2[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e532 = local_8[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e535 = local_9[_e514];
                                    phi_947_ = type_51(type_29(vec4<f32>(_e517, _e519, _e521, 0f), vec4<f32>(_e523, _e525, _e527, 0f)), _e532);
                                    phi_948_ = (_e535 <= _e500.member.member_1);
                                    phi_949_ = _e513;
                                }
                                let _e540 = phi_947_;
                                let _e542 = phi_948_;
                                let _e544 = phi_949_;
                                if _e542 {
                                    if ((_e540.member_1 & 2147483648u) != 0u) {
                                        phi_967_ = _e500;
                                        phi_970_ = type_4(0u, ((_e540.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1013 = phi_967_;
                                            let _e1015 = phi_970_;
                                            local_12 = _e1013;
                                            if (_e1015.member < _e1015.member_1) {
                                                phi_971_ = type_4((_e1015.member + 1u), _e1015.member_1);
                                                phi_993_ = type_4(1u, _e1015.member);
                                            } else {
                                                phi_971_ = _e1015;
                                                phi_993_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1028 = phi_971_;
                                            let _e1030 = phi_993_;
                                            let _e1034 = (bitcast<i32>(_e1030.member) != 0i);
                                            if _e1034 {
                                                let _e1040 = type_40(_e1013.member, _e1013.member_1, (_e1013.member_2 + 1u));
                                                let _e1041 = ((_e540.member_1 & 268435455u) + _e1030.member_1);
                                                let _e1042 = (_e1041 < _e87);
                                                if _e1042 {
                                                    if _e1042 {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1046 = global_2.member[_e1041].member_1;
                                                    phi_1017_ = _e1046;
                                                } else {
                                                    phi_1017_ = 4294967295u;
                                                }
                                                let _e1048 = phi_1017_;
                                                if (_e1041 >= _e87) {
                                                    phi_1106_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1042 {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    if (_e460 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1055 = global_2.member[_e1041].member[_e460];
                                                    if (_e466 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1061 = global_2.member[_e1041].member[_e466];
                                                    if (_e472 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1067 = global_2.member[_e1041].member[_e472];
                                                    let _e1069 = (3u + _e460);
                                                    if (_e1069 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1075 = global_2.member[_e1041].member[_e1069];
                                                    let _e1076 = (3u + _e466);
                                                    if (_e1076 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1082 = global_2.member[_e1041].member[_e1076];
                                                    let _e1083 = (3u + _e472);
                                                    if (_e1083 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1089 = global_2.member[_e1041].member[_e1083];
                                                    let _e1091 = (6u + _e460);
                                                    if (_e1091 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1097 = global_2.member[_e1041].member[_e1091];
                                                    let _e1098 = (6u + _e466);
                                                    if (_e1098 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1104 = global_2.member[_e1041].member[_e1098];
                                                    let _e1105 = (6u + _e472);
                                                    if (_e1105 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1111 = global_2.member[_e1041].member[_e1105];
                                                    phi_1106_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1055, _e1061, _e1067), array<f32, 3>(_e1075, _e1082, _e1089), array<f32, 3>(_e1097, _e1104, _e1111));
                                                }
                                                let _e1115 = phi_1106_;
                                                let _e1124 = (_e1115[0][2] - _e381);
                                                let _e1127 = (((_e1115[0][0] - _e304) * _e405) - (_e1124 * _e329));
                                                let _e1130 = (((_e1115[0][1] - _e343) * _e405) - (_e1124 * _e367));
                                                let _e1137 = (_e1115[1][2] - _e381);
                                                let _e1140 = (((_e1115[1][0] - _e304) * _e405) - (_e1137 * _e329));
                                                let _e1143 = (((_e1115[1][1] - _e343) * _e405) - (_e1137 * _e367));
                                                let _e1150 = (_e1115[2][2] - _e381);
                                                let _e1153 = (((_e1115[2][0] - _e304) * _e405) - (_e1150 * _e329));
                                                let _e1156 = (((_e1115[2][1] - _e343) * _e405) - (_e1150 * _e367));
                                                let _e1157 = (_e1153 * _e1143);
                                                let _e1158 = (_e1156 * _e1140);
                                                let _e1159 = (_e1127 * _e1156);
                                                let _e1160 = (_e1130 * _e1153);
                                                let _e1161 = (_e1140 * _e1130);
                                                let _e1162 = (_e1143 * _e1127);
                                                let _e1167 = (((_e1157 >= _e1158) && (_e1159 >= _e1160)) && (_e1161 >= _e1162));
                                                if (_e1167 || (((_e1157 <= _e1158) && (_e1159 <= _e1160)) && (_e1161 <= _e1162))) {
                                                    let _e1174 = select(-1f, 1f, _e1167);
                                                    let _e1176 = ((_e1157 - _e1158) * _e1174);
                                                    let _e1178 = select(0f, _e1176, (_e1176 > 0f));
                                                    let _e1180 = ((_e1159 - _e1160) * _e1174);
                                                    let _e1182 = select(0f, _e1180, (_e1180 > 0f));
                                                    let _e1184 = ((_e1161 - _e1162) * _e1174);
                                                    let _e1186 = select(0f, _e1184, (_e1184 > 0f));
                                                    let _e1188 = ((_e1178 + _e1182) + _e1186);
                                                    if (_e1188 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1931_ = type_25();
                                                        phi_1932_ = true;
                                                        phi_1933_ = false;
                                                    } else {
                                                        let _e1191 = select(_e1140, _e1127, (_e1127 < _e1140));
                                                        if (select(_e1153, _e1191, (_e1191 < _e1153)) > 0f) {
                                                            phi_1223_ = true;
                                                        } else {
                                                            let _e1196 = select(_e1140, _e1127, (_e1127 > _e1140));
                                                            phi_1223_ = (select(_e1153, _e1196, (_e1196 > _e1153)) < 0f);
                                                        }
                                                        let _e1201 = phi_1223_;
                                                        if _e1201 {
                                                            phi_1928_ = type_25();
                                                            phi_1929_ = true;
                                                            phi_1930_ = false;
                                                        } else {
                                                            let _e1203 = select(_e1143, _e1130, (_e1130 < _e1143));
                                                            if (select(_e1156, _e1203, (_e1203 < _e1156)) > 0f) {
                                                                phi_1252_ = true;
                                                            } else {
                                                                let _e1208 = select(_e1143, _e1130, (_e1130 > _e1143));
                                                                phi_1252_ = (select(_e1156, _e1208, (_e1208 > _e1156)) < 0f);
                                                            }
                                                            let _e1213 = phi_1252_;
                                                            if _e1213 {
                                                                phi_1926_ = type_25();
                                                                phi_1927_ = false;
                                                            } else {
                                                                let _e1215 = select(_e1115[1][0], _e1115[0][0], (_e1115[0][0] < _e1115[1][0]));
                                                                let _e1219 = select(_e1115[1][0], _e1115[0][0], (_e1115[0][0] > _e1115[1][0]));
                                                                let _e1223 = select(_e1115[1][1], _e1115[0][1], (_e1115[0][1] < _e1115[1][1]));
                                                                let _e1227 = select(_e1115[1][1], _e1115[0][1], (_e1115[0][1] > _e1115[1][1]));
                                                                let _e1231 = select(_e1115[1][2], _e1115[0][2], (_e1115[0][2] < _e1115[1][2]));
                                                                let _e1235 = select(_e1115[1][2], _e1115[0][2], (_e1115[0][2] > _e1115[1][2]));
                                                                let _e1240 = ((select(_e1115[2][0], _e1215, (_e1215 < _e1115[2][0])) - _e327) * _e332);
                                                                let _e1241 = ((select(_e1115[2][0], _e1219, (_e1219 > _e1115[2][0])) - _e328) * _e332);
                                                                let _e1244 = ((select(_e1115[2][1], _e1223, (_e1223 < _e1115[2][1])) - _e365) * _e370);
                                                                let _e1245 = ((select(_e1115[2][1], _e1227, (_e1227 > _e1115[2][1])) - _e366) * _e370);
                                                                let _e1248 = ((select(_e1115[2][2], _e1231, (_e1231 < _e1115[2][2])) - _e403) * _e408);
                                                                let _e1249 = ((select(_e1115[2][2], _e1235, (_e1235 > _e1115[2][2])) - _e404) * _e408);
                                                                let _e1251 = select(_e1249, _e1248, (_e1248 < _e1249));
                                                                let _e1253 = select(_e1249, _e1248, (_e1248 > _e1249));
                                                                let _e1255 = select(_e1241, _e1240, (_e1240 < _e1241));
                                                                let _e1257 = select(_e1245, _e1244, (_e1244 < _e1245));
                                                                let _e1259 = select(_e1257, _e1255, (_e1255 > _e1257));
                                                                let _e1261 = select(_e1251, _e1259, (_e1259 > _e1251));
                                                                let _e1263 = select(_e1241, _e1240, (_e1240 > _e1241));
                                                                let _e1265 = select(_e1245, _e1244, (_e1244 > _e1245));
                                                                let _e1267 = select(_e1265, _e1263, (_e1263 < _e1265));
                                                                let _e1269 = select(_e1253, _e1267, (_e1267 < _e1253));
                                                                let _e1270 = -(_e1251);
                                                                let _e1276 = select(_e455, _e1261, (_e1261 > _e455));
                                                                if (_e1276 > (_e1269 + (select(_e1270, _e1253, (_e1253 > _e1270)) * 0.0000019073523f))) {
                                                                    phi_1921_ = type_25();
                                                                    phi_1922_ = true;
                                                                } else {
                                                                    let _e1278 = (_e1276 > _e1013.member.member_1);
                                                                    if _e1278 {
                                                                        phi_1920_ = type_25();
                                                                    } else {
                                                                        let _e1279 = vec3<f32>(_e1115[0][0], _e1115[0][1], _e1115[0][2]);
                                                                        let _e1280 = vec3<f32>(_e1115[1][0], _e1115[1][1], _e1115[1][2]);
                                                                        let _e1281 = vec3<f32>(_e1115[2][0], _e1115[2][1], _e1115[2][2]);
                                                                        let _e1282 = (_e1115[1][0] - _e1115[0][0]);
                                                                        let _e1283 = (_e1115[1][1] - _e1115[0][1]);
                                                                        let _e1284 = (_e1115[1][2] - _e1115[0][2]);
                                                                        let _e1285 = vec3<f32>(_e1282, _e1283, _e1284);
                                                                        let _e1286 = (_e1115[2][0] - _e1115[1][0]);
                                                                        let _e1287 = (_e1115[2][1] - _e1115[1][1]);
                                                                        let _e1288 = (_e1115[2][2] - _e1115[1][2]);
                                                                        let _e1289 = vec3<f32>(_e1286, _e1287, _e1288);
                                                                        let _e1290 = (_e1115[0][0] - _e1115[2][0]);
                                                                        let _e1291 = (_e1115[0][1] - _e1115[2][1]);
                                                                        let _e1292 = (_e1115[0][2] - _e1115[2][2]);
                                                                        let _e1293 = vec3<f32>(_e1290, _e1291, _e1292);
                                                                        let _e1296 = bitcast<f32>((bitcast<u32>(_e1282) & 2147483647u));
                                                                        let _e1299 = bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u));
                                                                        let _e1301 = select(_e1299, _e1296, (_e1296 > _e1299));
                                                                        let _e1304 = bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u));
                                                                        let _e1306 = select(_e1304, _e1301, (_e1301 > _e1304));
                                                                        let _e1309 = bitcast<f32>((bitcast<u32>(_e1286) & 2147483647u));
                                                                        let _e1312 = bitcast<f32>((bitcast<u32>(_e1287) & 2147483647u));
                                                                        let _e1314 = select(_e1312, _e1309, (_e1309 > _e1312));
                                                                        let _e1317 = bitcast<f32>((bitcast<u32>(_e1288) & 2147483647u));
                                                                        let _e1319 = select(_e1317, _e1314, (_e1314 > _e1317));
                                                                        let _e1322 = bitcast<f32>((bitcast<u32>(_e1290) & 2147483647u));
                                                                        let _e1325 = bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u));
                                                                        let _e1327 = select(_e1325, _e1322, (_e1322 > _e1325));
                                                                        let _e1330 = bitcast<f32>((bitcast<u32>(_e1292) & 2147483647u));
                                                                        let _e1332 = select(_e1330, _e1327, (_e1327 > _e1330));
                                                                        let _e1334 = select(_e1319, _e1306, (_e1306 > _e1319));
                                                                        let _e1336 = select(_e1332, _e1334, (_e1334 > _e1332));
                                                                        if (_e1306 == _e1336) {
                                                                            phi_1653_ = _e1143;
                                                                            phi_1654_ = _e1140;
                                                                            phi_1655_ = _e1130;
                                                                            phi_1656_ = _e1127;
                                                                            phi_1657_ = _e1279;
                                                                            phi_1658_ = _e1293;
                                                                            phi_1659_ = _e1289;
                                                                            phi_1660_ = _e1285;
                                                                        } else {
                                                                            let _e1338 = (_e1319 == _e1336);
                                                                            let _e1343 = vec3(_e1338);
                                                                            phi_1653_ = select(_e1130, _e1156, _e1338);
                                                                            phi_1654_ = select(_e1127, _e1153, _e1338);
                                                                            phi_1655_ = select(_e1156, _e1143, _e1338);
                                                                            phi_1656_ = select(_e1153, _e1140, _e1338);
                                                                            phi_1657_ = select(_e1281, _e1280, _e1343);
                                                                            phi_1658_ = select(_e1289, _e1285, _e1343);
                                                                            phi_1659_ = select(_e1285, _e1293, _e1343);
                                                                            phi_1660_ = select(_e1293, _e1289, _e1343);
                                                                        }
                                                                        let _e1349 = phi_1653_;
                                                                        let _e1351 = phi_1654_;
                                                                        let _e1353 = phi_1655_;
                                                                        let _e1355 = phi_1656_;
                                                                        let _e1357 = phi_1657_;
                                                                        let _e1359 = phi_1658_;
                                                                        let _e1361 = phi_1659_;
                                                                        let _e1363 = phi_1660_;
                                                                        let _e1370 = ((_e1361.y * _e1359.z) - (_e1359.y * _e1361.z));
                                                                        let _e1375 = ((_e1361.z * _e1359.x) - (_e1359.z * _e1361.x));
                                                                        let _e1378 = ((_e1361.x * _e1359.y) - (_e1359.x * _e1361.y));
                                                                        if (_e1178 >= _e1182) {
                                                                            phi_1691_ = select(true, false, (_e1178 >= _e1186));
                                                                        } else {
                                                                            phi_1691_ = true;
                                                                        }
                                                                        let _e1383 = phi_1691_;
                                                                        if _e1383 {
                                                                            phi_1700_ = select(_e1281, _e1280, vec3((_e1182 >= _e1186)));
                                                                        } else {
                                                                            phi_1700_ = _e1279;
                                                                        }
                                                                        let _e1388 = phi_1700_;
                                                                        let _e1399 = (((_e1370 * (_e1388.x - _e304)) + (_e1375 * (_e1388.y - _e343))) + (_e1378 * (_e1388.z - _e381)));
                                                                        let _e1404 = (((_e1370 * _e329) + (_e1375 * _e367)) + (_e1378 * _e405));
                                                                        let _e1405 = (_e1351 - _e1355);
                                                                        let _e1406 = (_e1349 - _e1353);
                                                                        let _e1414 = (-(((_e1355 * _e1405) + (_e1353 * _e1406))) / ((_e1405 * _e1405) + (_e1406 * _e1406)));
                                                                        let _e1416 = select(1f, _e1414, (_e1414 < 1f));
                                                                        let _e1418 = select(0f, _e1416, (_e1416 > 0f));
                                                                        let _e1431 = ((_e1357.x + (_e1363.x * _e1418)) - _e304);
                                                                        let _e1432 = ((_e1357.y + (_e1363.y * _e1418)) - _e343);
                                                                        let _e1433 = ((_e1357.z + (_e1363.z * _e1418)) - _e381);
                                                                        let _e1434 = (_e1433 / _e405);
                                                                        let _e1446 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
                                                                        let _e1449 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                        let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                        let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                                                        let _e1462 = bitcast<f32>((bitcast<u32>(_e1370) & 2147483647u));
                                                                        let _e1465 = bitcast<f32>((bitcast<u32>(_e1375) & 2147483647u));
                                                                        let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                        let _e1470 = bitcast<f32>((bitcast<u32>(_e1378) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1370 * _e1431) + (_e1375 * _e1432)) + (_e1378 * _e1433)) - _e1399)) & 2147483647u)) <= ((0.0000009536743f * select(_e1336, _e1456, (_e1456 > _e1336))) * select(_e1470, _e1467, (_e1467 > _e1470)))) {
                                                                            let _e1480 = bitcast<f32>((bitcast<u32>(_e1361.x) & 2147483647u));
                                                                            let _e1483 = bitcast<f32>((bitcast<u32>(_e1361.y) & 2147483647u));
                                                                            let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                                            let _e1488 = bitcast<f32>((bitcast<u32>(_e1361.z) & 2147483647u));
                                                                            let _e1494 = bitcast<f32>((bitcast<u32>(_e1359.x) & 2147483647u));
                                                                            let _e1497 = bitcast<f32>((bitcast<u32>(_e1359.y) & 2147483647u));
                                                                            let _e1499 = select(_e1497, _e1494, (_e1494 > _e1497));
                                                                            let _e1502 = bitcast<f32>((bitcast<u32>(_e1359.z) & 2147483647u));
                                                                            let _e1506 = (bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u)) > ((0.0000038146973f * select(_e1488, _e1485, (_e1485 > _e1488))) * select(_e1502, _e1499, (_e1499 > _e1502))));
                                                                            if _e1506 {
                                                                                phi_1865_ = (_e1399 / _e1404);
                                                                            } else {
                                                                                phi_1865_ = f32();
                                                                            }
                                                                            let _e1509 = phi_1865_;
                                                                            phi_1867_ = _e1509;
                                                                            phi_1868_ = select(true, false, _e1506);
                                                                        } else {
                                                                            phi_1867_ = f32();
                                                                            phi_1868_ = true;
                                                                        }
                                                                        let _e1512 = phi_1867_;
                                                                        let _e1514 = phi_1868_;
                                                                        if _e1514 {
                                                                            let _e1522 = (((_e1370 * (_e1431 - (_e329 * _e1434))) + (_e1375 * (_e1432 - (_e367 * _e1434)))) / _e1404);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1522) & 2147483647u)) <= _e1336) {
                                                                                phi_1888_ = (_e1434 + _e1522);
                                                                            } else {
                                                                                phi_1888_ = _e1434;
                                                                            }
                                                                            let _e1529 = phi_1888_;
                                                                            phi_1889_ = _e1529;
                                                                        } else {
                                                                            phi_1889_ = _e1512;
                                                                        }
                                                                        let _e1531 = phi_1889_;
                                                                        let _e1533 = select(_e1269, _e1531, (_e1531 < _e1269));
                                                                        let _e1535 = select(_e1261, _e1533, (_e1533 > _e1261));
                                                                        if (_e1535 >= _e455) {
                                                                            let _e1537 = (_e1535 <= _e1013.member.member_1);
                                                                            if _e1537 {
                                                                                let _e1538 = (1f / _e1188);
                                                                                phi_1912_ = type_25(_e1535, (_e1182 * _e1538), (_e1186 * _e1538), _e1048);
                                                                            } else {
                                                                                phi_1912_ = type_25();
                                                                            }
                                                                            let _e1543 = phi_1912_;
                                                                            phi_1914_ = _e1543;
                                                                            phi_1915_ = select(true, false, _e1537);
                                                                        } else {
                                                                            phi_1914_ = type_25();
                                                                            phi_1915_ = true;
                                                                        }
                                                                        let _e1546 = phi_1914_;
                                                                        let _e1548 = phi_1915_;
                                                                        if _e1548 {
                                                                            phi_1919_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1919_ = _e1546;
                                                                        }
                                                                        let _e1550 = phi_1919_;
                                                                        phi_1920_ = _e1550;
                                                                    }
                                                                    let _e1552 = phi_1920_;
                                                                    phi_1921_ = _e1552;
                                                                    phi_1922_ = _e1278;
                                                                }
                                                                let _e1554 = phi_1921_;
                                                                let _e1556 = phi_1922_;
                                                                phi_1926_ = _e1554;
                                                                phi_1927_ = _e1556;
                                                            }
                                                            let _e1558 = phi_1926_;
                                                            let _e1560 = phi_1927_;
                                                            phi_1928_ = _e1558;
                                                            phi_1929_ = _e1213;
                                                            phi_1930_ = _e1560;
                                                        }
                                                        let _e1562 = phi_1928_;
                                                        let _e1564 = phi_1929_;
                                                        let _e1566 = phi_1930_;
                                                        phi_1931_ = _e1562;
                                                        phi_1932_ = _e1564;
                                                        phi_1933_ = _e1566;
                                                    }
                                                    let _e1568 = phi_1931_;
                                                    let _e1570 = phi_1932_;
                                                    let _e1572 = phi_1933_;
                                                    phi_1941_ = _e1568;
                                                    phi_1942_ = select(_e1572, true, _e1570);
                                                } else {
                                                    phi_1941_ = type_25();
                                                    phi_1942_ = true;
                                                }
                                                let _e1575 = phi_1941_;
                                                let _e1577 = phi_1942_;
                                                if _e1577 {
                                                    phi_1946_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1946_ = _e1575;
                                                }
                                                let _e1579 = phi_1946_;
                                                if (_e1579.member_3 != 4294967295u) {
                                                    if (_e1048 != 4294967295u) {
                                                        if (_e1579.member < _e1013.member.member.member) {
                                                            phi_1972_ = true;
                                                        } else {
                                                            if (_e1579.member == _e1013.member.member.member) {
                                                                phi_1971_ = (_e1579.member_3 < _e1013.member.member.member_3);
                                                            } else {
                                                                phi_1971_ = false;
                                                            }
                                                            let _e1594 = phi_1971_;
                                                            phi_1972_ = _e1594;
                                                        }
                                                        let _e1596 = phi_1972_;
                                                        if _e1596 {
                                                            phi_1979_ = type_40(type_33(_e1579, _e1579.member), _e1040.member_1, _e1040.member_2);
                                                        } else {
                                                            phi_1979_ = _e1040;
                                                        }
                                                        let _e1603 = phi_1979_;
                                                        phi_1980_ = _e1603;
                                                    } else {
                                                        phi_1980_ = _e1040;
                                                    }
                                                    let _e1605 = phi_1980_;
                                                    phi_1981_ = _e1605;
                                                } else {
                                                    phi_1981_ = _e1040;
                                                }
                                                let _e1607 = phi_1981_;
                                                phi_968_ = _e1607;
                                            } else {
                                                phi_968_ = type_40();
                                            }
                                            let _e1609 = phi_968_;
                                            continue;
                                            continuing {
                                                phi_967_ = _e1609;
                                                phi_970_ = _e1028;
                                                phi_3409_ = _e498;
                                                break if !(_e1034);
                                            }
                                        }
                                        let _e1612 = phi_3409_;
                                        phi_3551_ = _e1612;
                                        if _e1612 {
                                            break;
                                        }
                                        phi_3555_ = _e1612;
                                        let _e1784 = local_12;
                                        phi_3189_ = _e1784;
                                        phi_3190_ = _e540;
                                        phi_3191_ = false;
                                        phi_3192_ = _e544;
                                    } else {
                                        if (_e540.member_1 >= _e85) {
                                            phi_2745_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e540.member_1 < _e85) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e561 = (_e255 * 2u);
                                            let _e563 = ((1u + _e561) % 7u);
                                            if (_e563 < 7u) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e568 = global_5.member[_e540.member_1][_e563];
                                            let _e570 = ((_e561 + 2u) % 7u);
                                            if (_e570 < 7u) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e575 = global_5.member[_e540.member_1][_e570];
                                            let _e576 = (_e254 * 2u);
                                            let _e578 = ((1u + _e576) % 7u);
                                            if (_e578 < 7u) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e583 = global_5.member[_e540.member_1][_e578];
                                            let _e585 = ((_e576 + 2u) % 7u);
                                            if (_e585 < 7u) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e590 = global_5.member[_e540.member_1][_e585];
                                            let _e591 = (_e256 * 2u);
                                            let _e593 = ((1u + _e591) % 7u);
                                            if (_e593 < 7u) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e598 = global_5.member[_e540.member_1][_e593];
                                            let _e600 = ((_e591 + 2u) % 7u);
                                            if (_e600 < 7u) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e605 = global_5.member[_e540.member_1][_e600];
                                            let _e628 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.x - _e540.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e629 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.y - _e540.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e630 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.z - _e540.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e632 = select(_e135, _e628, (_e628 > _e135));
                                            let _e634 = select(_e135, _e629, (_e629 > _e135));
                                            let _e636 = select(_e135, _e630, (_e630 > _e135));
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
                                            let _e768 = global_5.member[_e540.member_1][0u];
                                            let _e772 = global_5.member[_e540.member_1][2u];
                                            let _e776 = global_5.member[_e540.member_1][4u];
                                            let _e780 = global_5.member[_e540.member_1][6u];
                                            let _e792 = (((_e772 >> bitcast<u32>(22i)) | ((_e776 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e780 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e793 = (_e768 & 268435455u);
                                            let _e794 = (_e792 & 268435455u);
                                            let _e797 = ((_e768 >> bitcast<u32>(28u)) & 7u);
                                            let _e805 = ((_e768 >> bitcast<u32>(31i)) | (((_e792 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e806 = (_e797 != 0u);
                                            if (_e797 == 0u) {
                                                phi_2707_ = _e793;
                                            } else {
                                                if (_e797 == 7u) {
                                                    phi_2706_ = 2147483648u;
                                                } else {
                                                    phi_2706_ = ((2147483648u | (_e797 << bitcast<u32>(28u))) | (_e794 & 268435455u));
                                                }
                                                let _e815 = phi_2706_;
                                                phi_2707_ = _e815;
                                            }
                                            let _e817 = phi_2707_;
                                            if _e806 {
                                                let _e818 = (_e797 != 7u);
                                                if _e818 {
                                                    phi_2717_ = (_e794 + _e797);
                                                } else {
                                                    phi_2717_ = u32();
                                                }
                                                let _e821 = phi_2717_;
                                                phi_2719_ = _e821;
                                                phi_2720_ = select(true, false, _e818);
                                            } else {
                                                phi_2719_ = u32();
                                                phi_2720_ = true;
                                            }
                                            let _e824 = phi_2719_;
                                            let _e826 = phi_2720_;
                                            if (_e805 == 0u) {
                                                phi_2741_ = (_e793 + select(0u, 1u, !(_e806)));
                                            } else {
                                                if (_e805 == 7u) {
                                                    phi_2740_ = 2147483648u;
                                                } else {
                                                    phi_2740_ = ((2147483648u | (_e805 << bitcast<u32>(28u))) | (select(_e824, _e794, _e826) & 268435455u));
                                                }
                                                let _e839 = phi_2740_;
                                                phi_2741_ = _e839;
                                            }
                                            let _e841 = phi_2741_;
                                            phi_2745_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e540.member.member.x + _e669), (_e540.member.member.x + _e691), (_e540.member.member_1.x - _e708), (_e540.member.member_1.x - _e730)), vec4<f32>((_e540.member.member.y + _e678), (_e540.member.member.y + _e695), (_e540.member.member_1.y - _e717), (_e540.member.member_1.y - _e734)), vec4<f32>((_e540.member.member.z + _e687), (_e540.member.member.z + _e699), (_e540.member.member_1.z - _e726), (_e540.member.member_1.z - _e738))), type_51(type_29((_e540.member.member + vec4<f32>(_e669, _e678, _e687, 0f)), (_e540.member.member_1 - vec4<f32>(_e708, _e717, _e726, 0f))), _e817), type_51(type_29((_e540.member.member + vec4<f32>(_e691, _e695, _e699, 0f)), (_e540.member.member_1 - vec4<f32>(_e730, _e734, _e738, 0f))), _e841));
                                        }
                                        let _e846 = phi_2745_;
                                        let _e859 = ((_e846.member[0].x - _e327) * _e332);
                                        let _e860 = ((_e846.member[0].y - _e327) * _e332);
                                        let _e861 = ((_e846.member[0].z - _e328) * _e332);
                                        let _e862 = ((_e846.member[0].w - _e328) * _e332);
                                        let _e872 = ((_e846.member[1].x - _e365) * _e370);
                                        let _e873 = ((_e846.member[1].y - _e365) * _e370);
                                        let _e874 = ((_e846.member[1].z - _e366) * _e370);
                                        let _e875 = ((_e846.member[1].w - _e366) * _e370);
                                        let _e885 = ((_e846.member[2].x - _e403) * _e408);
                                        let _e886 = ((_e846.member[2].y - _e403) * _e408);
                                        let _e887 = ((_e846.member[2].z - _e404) * _e408);
                                        let _e888 = ((_e846.member[2].w - _e404) * _e408);
                                        let _e890 = select(_e887, _e885, (_e885 < _e887));
                                        let _e892 = select(_e888, _e886, (_e886 < _e888));
                                        let _e894 = select(_e887, _e885, (_e885 > _e887));
                                        let _e896 = select(_e888, _e886, (_e886 > _e888));
                                        let _e898 = select(_e861, _e859, (_e859 < _e861));
                                        let _e900 = select(_e862, _e860, (_e860 < _e862));
                                        let _e902 = select(_e874, _e872, (_e872 < _e874));
                                        let _e904 = select(_e875, _e873, (_e873 < _e875));
                                        let _e906 = select(_e902, _e898, (_e898 > _e902));
                                        let _e908 = select(_e904, _e900, (_e900 > _e904));
                                        let _e910 = select(_e890, _e906, (_e906 > _e890));
                                        let _e912 = select(_e892, _e908, (_e908 > _e892));
                                        let _e914 = select(_e861, _e859, (_e859 > _e861));
                                        let _e916 = select(_e862, _e860, (_e860 > _e862));
                                        let _e918 = select(_e874, _e872, (_e872 > _e874));
                                        let _e920 = select(_e875, _e873, (_e873 > _e875));
                                        let _e922 = select(_e918, _e914, (_e914 < _e918));
                                        let _e924 = select(_e920, _e916, (_e916 < _e920));
                                        let _e929 = -(_e890);
                                        let _e930 = -(_e892);
                                        let _e937 = (select(_e894, _e922, (_e922 < _e894)) + (select(_e929, _e894, (_e894 > _e929)) * 0.0000019073523f));
                                        let _e938 = (select(_e896, _e924, (_e924 < _e896)) + (select(_e930, _e896, (_e896 > _e930)) * 0.0000019073523f));
                                        let _e940 = select(_e455, _e910, (_e910 > _e455));
                                        let _e942 = select(_e455, _e912, (_e912 > _e455));
                                        let _e947 = (_e940 <= select(_e500.member.member_1, _e937, (_e937 < _e500.member.member_1)));
                                        let _e948 = (_e942 <= select(_e500.member.member_1, _e938, (_e938 < _e500.member.member_1)));
                                        let _e949 = (_e940 <= _e942);
                                        if _e947 {
                                            if _e948 {
                                                if _e949 {
                                                    phi_3089_ = _e846.member_2;
                                                } else {
                                                    phi_3089_ = _e846.member_1;
                                                }
                                                let _e953 = phi_3089_;
                                                let _e975 = (_e544 % 128u);
                                                let _e976 = (_e975 < 128u);
                                                if _e976 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_8[_e975] = _e953.member_1;
                                                if _e976 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_7[_e975] = _e953.member.member.x;
                                                if _e976 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_6[_e975] = _e953.member.member.y;
                                                if _e976 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_5[_e975] = _e953.member.member.z;
                                                if _e976 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_4[_e975] = _e953.member.member_1.x;
                                                if _e976 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_3[_e975] = _e953.member.member_1.y;
                                                if _e976 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_2[_e975] = _e953.member.member_1.z;
                                                if _e976 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_9[_e975] = select(_e942, _e940, (_e940 > _e942));
                                                if _e949 {
                                                    phi_3166_ = _e846.member_1;
                                                } else {
                                                    phi_3166_ = _e846.member_2;
                                                }
                                                let _e989 = phi_3166_;
                                                phi_3167_ = _e989;
                                                phi_3168_ = (_e544 + 1u);
                                            } else {
                                                phi_3167_ = type_51();
                                                phi_3168_ = u32();
                                            }
                                            let _e991 = phi_3167_;
                                            let _e993 = phi_3168_;
                                            phi_3170_ = _e991;
                                            phi_3171_ = _e993;
                                            phi_3172_ = select(true, false, _e948);
                                        } else {
                                            phi_3170_ = type_51();
                                            phi_3171_ = u32();
                                            phi_3172_ = true;
                                        }
                                        let _e996 = phi_3170_;
                                        let _e998 = phi_3171_;
                                        let _e1000 = phi_3172_;
                                        if _e1000 {
                                            if _e947 {
                                                phi_3181_ = _e846.member_1;
                                            } else {
                                                phi_3181_ = _e846.member_2;
                                            }
                                            let _e1004 = phi_3181_;
                                            phi_3186_ = _e1004;
                                            phi_3187_ = select(_e948, true, _e947);
                                        } else {
                                            phi_3186_ = _e996;
                                            phi_3187_ = _e542;
                                        }
                                        let _e1007 = phi_3186_;
                                        let _e1009 = phi_3187_;
                                        phi_3555_ = _e498;
                                        phi_3189_ = type_40(_e500.member, (_e500.member_1 + 1u), _e500.member_2);
                                        phi_3190_ = _e1007;
                                        phi_3191_ = _e1009;
                                        phi_3192_ = select(_e998, _e544, _e1000);
                                    }
                                    let _e1614 = phi_3555_;
                                    let _e1616 = phi_3189_;
                                    let _e1618 = phi_3190_;
                                    let _e1620 = phi_3191_;
                                    let _e1622 = phi_3192_;
                                    phi_3554_ = _e1614;
                                    phi_3193_ = _e1616;
                                    phi_3194_ = _e1618;
                                    phi_3195_ = (_e504 - 1u);
                                    phi_3196_ = _e1620;
                                    phi_3197_ = _e1622;
                                } else {
                                    phi_3554_ = _e498;
                                    phi_3193_ = _e500;
                                    phi_3194_ = _e540;
                                    phi_3195_ = _e504;
                                    phi_3196_ = _e542;
                                    phi_3197_ = _e544;
                                }
                                let _e1624 = phi_3554_;
                                let _e1626 = phi_3193_;
                                let _e1628 = phi_3194_;
                                let _e1630 = phi_3195_;
                                let _e1632 = phi_3196_;
                                let _e1634 = phi_3197_;
                                phi_3553_ = _e1624;
                                phi_3198_ = _e1626;
                                phi_3199_ = _e1628;
                                phi_3200_ = _e1630;
                                phi_3201_ = _e1632;
                                phi_3202_ = _e1634;
                            } else {
                                phi_3553_ = _e498;
                                phi_3198_ = type_40();
                                phi_3199_ = type_51();
                                phi_3200_ = u32();
                                phi_3201_ = bool();
                                phi_3202_ = u32();
                            }
                            let _e1636 = phi_3553_;
                            let _e1638 = phi_3198_;
                            let _e1640 = phi_3199_;
                            let _e1642 = phi_3200_;
                            let _e1644 = phi_3201_;
                            let _e1646 = phi_3202_;
                            phi_3552_ = _e1636;
                            phi_842_ = _e1638;
                            phi_845_ = _e1640;
                            phi_847_ = _e1642;
                            phi_849_ = _e1644;
                            phi_851_ = _e1646;
                            phi_3203_ = _e512;
                        } else {
                            phi_3552_ = _e498;
                            phi_842_ = type_40();
                            phi_845_ = type_51();
                            phi_847_ = u32();
                            phi_849_ = bool();
                            phi_851_ = u32();
                            phi_3203_ = false;
                        }
                        let _e1648 = phi_3552_;
                        let _e1650 = phi_842_;
                        let _e1652 = phi_845_;
                        let _e1654 = phi_847_;
                        let _e1656 = phi_849_;
                        let _e1658 = phi_851_;
                        let _e1660 = phi_3203_;
                        continue;
                        continuing {
                            phi_3415_ = _e1648;
                            phi_841_ = _e1650;
                            phi_844_ = _e1652;
                            phi_846_ = _e1654;
                            phi_848_ = _e1656;
                            phi_850_ = _e1658;
                            phi_3551_ = _e1648;
                            break if !(_e1660);
                        }
                    }
                    let _e1663 = phi_3551_;
                    if _e1663 {
                        break;
                    }
                    let _e1665 = local_10;
                    let _e1668 = local_11;
                    if _e143 {
                    } else {
                        break;
                    }
                    global_6.member[_e141][0u] = _e1665.member_1;
                    global_6.member[_e141][1u] = _e1668.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
