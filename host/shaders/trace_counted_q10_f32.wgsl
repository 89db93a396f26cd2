struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: array<array<u32, 2>>,
}

struct type_29 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_37 {
    member: type_29,
    member_1: f32,
}

struct type_42 {
    member: array<type_30>,
}

struct type_44 {
    member: type_37,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_33,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_46;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_42;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_25;

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
    var phi_841_: type_44;
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
    var phi_967_: type_44;
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
    var phi_1912_: type_29;
    var phi_1914_: type_29;
    var phi_1915_: bool;
    var phi_1919_: type_29;
    var phi_1920_: type_29;
    var phi_1921_: type_29;
    var phi_1922_: bool;
    var phi_1926_: type_29;
    var phi_1927_: bool;
    var phi_1928_: type_29;
    var phi_1929_: bool;
    var phi_1930_: bool;
    var phi_1931_: type_29;
    var phi_1932_: bool;
    var phi_1933_: bool;
    var phi_1941_: type_29;
    var phi_1942_: bool;
    var phi_1946_: type_29;
    var phi_1971_: bool;
    var phi_1972_: bool;
    var phi_1979_: type_44;
    var phi_1980_: type_44;
    var phi_1981_: type_44;
    var phi_968_: type_44;
    var phi_3409_: bool;
    var phi_3555_: bool;
    var phi_3189_: type_44;
    var phi_3190_: type_51;
    var phi_3191_: bool;
    var phi_3192_: u32;
    var phi_3554_: bool;
    var phi_3193_: type_44;
    var phi_3194_: type_51;
    var phi_3195_: u32;
    var phi_3196_: bool;
    var phi_3197_: u32;
    var phi_3553_: bool;
    var phi_3198_: type_44;
    var phi_3199_: type_51;
    var phi_3200_: u32;
    var phi_3201_: bool;
    var phi_3202_: u32;
    var phi_3552_: bool;
    var phi_842_: type_44;
    var phi_845_: type_51;
    var phi_847_: u32;
    var phi_849_: bool;
    var phi_851_: u32;
    var phi_3203_: bool;
    var phi_3551_: bool;
    var local_10: type_44;
    var local_11: type_44;
    var local_12: type_44;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e87 = arrayLength((&global_4.member));
            let _e89 = arrayLength((&global_2.member));
            let _e97 = global_3.member[0u][0u];
            let _e101 = global_3.member[0u][1u];
            let _e105 = global_3.member[0u][2u];
            let _e109 = global_3.member[0u][3u];
            let _e113 = global_3.member[1u][0u];
            let _e117 = global_3.member[1u][1u];
            let _e121 = global_3.member[1u][2u];
            let _e124 = global_1.member[0u];
            let _e125 = bitcast<i32>(_e124);
            let _e137 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e109) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e97), bitcast<i32>(_e101), bitcast<i32>(_e105));
            local = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            let _e143 = (_e85.x + (_e85.y * 2097152u));
            let _e144 = (_e143 < arrayLength((&global_5.member)));
            if _e144 {
                let _e145 = (_e143 < arrayLength((&global_6.member)));
                if _e145 {
                    if _e144 {
                    } else {
                        break;
                    }
                    let _e153 = global_5.member[_e143].member_2[0u];
                    let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                    let _e160 = global_5.member[_e143].member_2[1u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_5.member[_e143].member_2[2u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_5.member[_e143].member[0u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_5.member[_e143].member[1u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_5.member[_e143].member[2u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e192 = select(_e162, _e155, (_e162 < _e155));
                    let _e194 = select(_e169, _e192, (_e169 < _e192));
                    let _e196 = select(_e176, _e194, (_e176 < _e194));
                    let _e198 = select(_e183, _e196, (_e183 < _e196));
                    let _e200 = select(_e190, _e198, (_e190 < _e198));
                    let _e204 = global_5.member[_e143].member_1;
                    let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                    let _e213 = global_5.member[_e143].member_3;
                    let _e219 = (((select(_e206, _e200, (_e206 < _e200)) < 2139095040u) && ((bitcast<u32>(_e213) & 2147483647u) <= 2139095040u)) && (_e194 > 0u));
                    if _e219 {
                        let _e222 = (bitcast<u32>(bitcast<f32>(_e194)) & 2147483647u);
                        if (_e222 >= 8388608u) {
                            phi_382_ = (bitcast<i32>((_e222 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_382_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e222)), 32u, (_e222 == 0u))));
                        }
                        let _e236 = phi_382_;
                        phi_383_ = _e236;
                    } else {
                        phi_383_ = 0i;
                    }
                    let _e238 = phi_383_;
                    let _e239 = (_e155 == _e194);
                    if _e239 {
                        phi_393_ = true;
                    } else {
                        phi_393_ = (_e162 == _e194);
                    }
                    let _e242 = phi_393_;
                    let _e243 = select(1u, 0u, _e239);
                    if _e242 {
                        let _e244 = (_e243 + 1u);
                        phi_403_ = _e244;
                        phi_404_ = _e244;
                        phi_406_ = select(true, false, (_e244 == 2u));
                    } else {
                        phi_403_ = u32();
                        phi_404_ = 0u;
                        phi_406_ = true;
                    }
                    let _e248 = phi_403_;
                    let _e250 = phi_404_;
                    let _e252 = phi_406_;
                    if _e252 {
                        phi_411_ = (_e250 + 1u);
                    } else {
                        phi_411_ = 0u;
                    }
                    let _e256 = phi_411_;
                    let _e257 = select(_e248, _e250, _e252);
                    let _e258 = select(_e243, select(2u, _e243, _e242), _e252);
                    if (_e125 < -126i) {
                        phi_423_ = -126i;
                    } else {
                        phi_423_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e263 = phi_423_;
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e125 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e275 = -(_e238);
                    if (_e275 < -126i) {
                        phi_443_ = -126i;
                    } else {
                        phi_443_ = select(_e275, 127i, (_e275 > 127i));
                    }
                    let _e280 = phi_443_;
                    let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
                    let _e291 = bitcast<f32>((bitcast<u32>(((_e275 - _e280) + 127i)) << bitcast<u32>(23i)));
                    let _e295 = global_5.member[_e143].member;
                    let _e296 = (_e257 == 0u);
                    if _e296 {
                        phi_461_ = _e295[0];
                    } else {
                        phi_461_ = _e295[1];
                    }
                    let _e300 = phi_461_;
                    let _e301 = (_e257 == 2u);
                    if _e301 {
                        phi_467_ = _e295[2];
                    } else {
                        phi_467_ = _e300;
                    }
                    let _e304 = phi_467_;
                    let _e306 = ((_e304 * _e268) * _e274);
                    let _e307 = global_5.member[_e143].member_2;
                    if _e296 {
                        phi_478_ = _e307[0];
                    } else {
                        phi_478_ = _e307[1];
                    }
                    let _e311 = phi_478_;
                    if _e301 {
                        phi_484_ = _e307[2];
                    } else {
                        phi_484_ = _e311;
                    }
                    let _e314 = phi_484_;
                    let _e316 = ((_e314 * _e285) * _e291);
                    let _e320 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e320 {
                        let _e324 = (bitcast<f32>((bitcast<u32>(_e306) & 2147483647u)) * 0.00000011920929f);
                        phi_507_ = select(0.00000000000011368684f, _e324, (_e324 > 0.00000000000011368684f));
                    } else {
                        phi_507_ = 0f;
                    }
                    let _e328 = phi_507_;
                    let _e329 = (_e306 + _e328);
                    let _e330 = (_e306 - _e328);
                    let _e331 = select(_e316, 0f, _e320);
                    if _e320 {
                        phi_518_ = 38685626000000000000000000f;
                    } else {
                        phi_518_ = (1f / _e316);
                    }
                    let _e334 = phi_518_;
                    let _e335 = (_e256 == 0u);
                    if _e335 {
                        phi_527_ = _e295[0];
                    } else {
                        phi_527_ = _e295[1];
                    }
                    let _e339 = phi_527_;
                    let _e340 = (_e256 == 2u);
                    if _e340 {
                        phi_533_ = _e295[2];
                    } else {
                        phi_533_ = _e339;
                    }
                    let _e343 = phi_533_;
                    let _e345 = ((_e343 * _e268) * _e274);
                    if _e335 {
                        phi_544_ = _e307[0];
                    } else {
                        phi_544_ = _e307[1];
                    }
                    let _e349 = phi_544_;
                    if _e340 {
                        phi_550_ = _e307[2];
                    } else {
                        phi_550_ = _e349;
                    }
                    let _e352 = phi_550_;
                    let _e354 = ((_e352 * _e285) * _e291);
                    let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e358 {
                        let _e362 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) * 0.00000011920929f);
                        phi_573_ = select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f));
                    } else {
                        phi_573_ = 0f;
                    }
                    let _e366 = phi_573_;
                    let _e367 = (_e345 + _e366);
                    let _e368 = (_e345 - _e366);
                    let _e369 = select(_e354, 0f, _e358);
                    if _e358 {
                        phi_584_ = 38685626000000000000000000f;
                    } else {
                        phi_584_ = (1f / _e354);
                    }
                    let _e372 = phi_584_;
                    let _e373 = (_e258 == 0u);
                    if _e373 {
                        phi_593_ = _e295[0];
                    } else {
                        phi_593_ = _e295[1];
                    }
                    let _e377 = phi_593_;
                    let _e378 = (_e258 == 2u);
                    if _e378 {
                        phi_599_ = _e295[2];
                    } else {
                        phi_599_ = _e377;
                    }
                    let _e381 = phi_599_;
                    let _e383 = ((_e381 * _e268) * _e274);
                    if _e373 {
                        phi_610_ = _e307[0];
                    } else {
                        phi_610_ = _e307[1];
                    }
                    let _e387 = phi_610_;
                    if _e378 {
                        phi_616_ = _e307[2];
                    } else {
                        phi_616_ = _e387;
                    }
                    let _e390 = phi_616_;
                    let _e392 = ((_e390 * _e285) * _e291);
                    let _e396 = (bitcast<f32>((bitcast<u32>(_e392) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e396 {
                        let _e400 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) * 0.00000011920929f);
                        phi_639_ = select(0.00000000000011368684f, _e400, (_e400 > 0.00000000000011368684f));
                    } else {
                        phi_639_ = 0f;
                    }
                    let _e404 = phi_639_;
                    let _e405 = (_e383 + _e404);
                    let _e406 = (_e383 - _e404);
                    let _e407 = select(_e392, 0f, _e396);
                    if _e396 {
                        phi_650_ = 38685626000000000000000000f;
                    } else {
                        phi_650_ = (1f / _e392);
                    }
                    let _e410 = phi_650_;
                    let _e413 = bitcast<f32>((bitcast<u32>(_e306) & 2147483647u));
                    let _e416 = bitcast<f32>((bitcast<u32>(_e345) & 2147483647u));
                    let _e418 = select(_e416, _e413, (_e413 > _e416));
                    let _e421 = bitcast<f32>((bitcast<u32>(_e383) & 2147483647u));
                    let _e424 = (_e125 + _e238);
                    if (_e219 && (select(_e421, _e418, (_e418 > _e421)) <= 1099511600000f)) {
                        let _e427 = (_e424 / 3i);
                        let _e434 = bitcast<f32>((bitcast<u32>((_e427 + 127i)) << bitcast<u32>(23i)));
                        let _e441 = bitcast<f32>((bitcast<u32>(((_e424 - (2i * _e427)) + 127i)) << bitcast<u32>(23i)));
                        let _e442 = (((_e204 * _e434) * _e434) * _e441);
                        let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                        let _e449 = (((_e213 * _e434) * _e434) * _e441);
                        let _e451 = select(340282350000000000000000000000000000000f, _e449, (_e449 < 340282350000000000000000000000000000000f));
                        phi_750_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                        phi_751_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_750_ = 0f;
                        phi_751_ = 1f;
                    }
                    let _e455 = phi_750_;
                    let _e457 = phi_751_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e462 = (_e257 % 3u);
                    let _e463 = (_e462 < 3u);
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e465 = local_1[_e462];
                    let _e468 = (_e256 % 3u);
                    let _e469 = (_e468 < 3u);
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e471 = local_1[_e468];
                    let _e474 = (_e258 % 3u);
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
                    phi_3415_ = false;
                    phi_841_ = type_44(type_37(type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e455), 0u, 0u);
                    phi_844_ = type_51(type_33(vec4<f32>((f32(_e465) * _e137), (f32(_e471) * _e137), (f32(_e477) * _e137), 0f), vec4<f32>((f32(_e482) * _e137), (f32(_e486) * _e137), (f32(_e490) * _e137), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_846_ = ((3u * _e87) + 1u);
                    phi_848_ = (_e457 <= _e455);
                    phi_850_ = 0u;
                    loop {
                        let _e500 = phi_3415_;
                        let _e502 = phi_841_;
                        let _e504 = phi_844_;
                        let _e506 = phi_846_;
                        let _e508 = phi_848_;
                        let _e510 = phi_850_;
                        local_10 = _e502;
                        local_11 = _e502;
                        if _e508 {
                            phi_861_ = true;
                        } else {
                            phi_861_ = (_e510 > 0u);
                        }
                        let _e513 = phi_861_;
                        if _e513 {
                            let _e514 = (_e506 > 0u);
                            if _e514 {
                                if _e508 {
                                    phi_947_ = _e504;
                                    phi_948_ = _e508;
                                    phi_949_ = _e510;
                                } else {
                                    let _e515 = (_e510 - 1u);
                                    let _e516 = (_e515 % 128u);
                                    let _e517 = (_e516 < 128u);
                                    if _e517 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e519 = local_7[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e521 = local_6[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e523 = local_5[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e525 = local_4[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e527 = local_3[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e529 = local_2[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e534 = local_8[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3551_ = true;
                                        break;
                                    }
                                    let _e537 = local_9[_e516];
                                    phi_947_ = type_51(type_33(vec4<f32>(_e519, _e521, _e523, 0f), vec4<f32>(_e525, _e527, _e529, 0f)), _e534);
                                    phi_948_ = (_e537 <= _e502.member.member_1);
                                    phi_949_ = _e515;
                                }
                                let _e542 = phi_947_;
                                let _e544 = phi_948_;
                                let _e546 = phi_949_;
                                if _e544 {
                                    if ((_e542.member_1 & 2147483648u) != 0u) {
                                        phi_967_ = _e502;
                                        phi_970_ = type_4(0u, ((_e542.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e997 = phi_967_;
                                            let _e999 = phi_970_;
                                            local_12 = _e997;
                                            if (_e999.member < _e999.member_1) {
                                                phi_971_ = type_4((_e999.member + 1u), _e999.member_1);
                                                phi_993_ = type_4(1u, _e999.member);
                                            } else {
                                                phi_971_ = _e999;
                                                phi_993_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1012 = phi_971_;
                                            let _e1014 = phi_993_;
                                            let _e1018 = (bitcast<i32>(_e1014.member) != 0i);
                                            if _e1018 {
                                                let _e1024 = type_44(_e997.member, _e997.member_1, (_e997.member_2 + 1u));
                                                let _e1025 = ((_e542.member_1 & 268435455u) + _e1014.member_1);
                                                let _e1026 = (_e1025 < _e89);
                                                if _e1026 {
                                                    if _e1026 {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1030 = global_2.member[_e1025].member_1;
                                                    phi_1017_ = _e1030;
                                                } else {
                                                    phi_1017_ = 4294967295u;
                                                }
                                                let _e1032 = phi_1017_;
                                                if (_e1025 >= _e89) {
                                                    phi_1106_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1026 {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    if (_e462 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1039 = global_2.member[_e1025].member[_e462];
                                                    if (_e468 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1045 = global_2.member[_e1025].member[_e468];
                                                    if (_e474 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1051 = global_2.member[_e1025].member[_e474];
                                                    let _e1053 = (3u + _e462);
                                                    if (_e1053 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1059 = global_2.member[_e1025].member[_e1053];
                                                    let _e1060 = (3u + _e468);
                                                    if (_e1060 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1066 = global_2.member[_e1025].member[_e1060];
                                                    let _e1067 = (3u + _e474);
                                                    if (_e1067 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1073 = global_2.member[_e1025].member[_e1067];
                                                    let _e1075 = (6u + _e462);
                                                    if (_e1075 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1081 = global_2.member[_e1025].member[_e1075];
                                                    let _e1082 = (6u + _e468);
                                                    if (_e1082 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1088 = global_2.member[_e1025].member[_e1082];
                                                    let _e1089 = (6u + _e474);
                                                    if (_e1089 < 9u) {
                                                    } else {
                                                        phi_3409_ = true;
                                                        break;
                                                    }
                                                    let _e1095 = global_2.member[_e1025].member[_e1089];
                                                    phi_1106_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1039, _e1045, _e1051), array<f32, 3>(_e1059, _e1066, _e1073), array<f32, 3>(_e1081, _e1088, _e1095));
                                                }
                                                let _e1099 = phi_1106_;
                                                let _e1108 = (_e1099[0][2] - _e383);
                                                let _e1111 = (((_e1099[0][0] - _e306) * _e407) - (_e1108 * _e331));
                                                let _e1114 = (((_e1099[0][1] - _e345) * _e407) - (_e1108 * _e369));
                                                let _e1121 = (_e1099[1][2] - _e383);
                                                let _e1124 = (((_e1099[1][0] - _e306) * _e407) - (_e1121 * _e331));
                                                let _e1127 = (((_e1099[1][1] - _e345) * _e407) - (_e1121 * _e369));
                                                let _e1134 = (_e1099[2][2] - _e383);
                                                let _e1137 = (((_e1099[2][0] - _e306) * _e407) - (_e1134 * _e331));
                                                let _e1140 = (((_e1099[2][1] - _e345) * _e407) - (_e1134 * _e369));
                                                let _e1141 = (_e1137 * _e1127);
                                                let _e1142 = (_e1140 * _e1124);
                                                let _e1143 = (_e1111 * _e1140);
                                                let _e1144 = (_e1114 * _e1137);
                                                let _e1145 = (_e1124 * _e1114);
                                                let _e1146 = (_e1127 * _e1111);
                                                let _e1151 = (((_e1141 >= _e1142) && (_e1143 >= _e1144)) && (_e1145 >= _e1146));
                                                if (_e1151 || (((_e1141 <= _e1142) && (_e1143 <= _e1144)) && (_e1145 <= _e1146))) {
                                                    let _e1158 = select(-1f, 1f, _e1151);
                                                    let _e1160 = ((_e1141 - _e1142) * _e1158);
                                                    let _e1162 = select(0f, _e1160, (_e1160 > 0f));
                                                    let _e1164 = ((_e1143 - _e1144) * _e1158);
                                                    let _e1166 = select(0f, _e1164, (_e1164 > 0f));
                                                    let _e1168 = ((_e1145 - _e1146) * _e1158);
                                                    let _e1170 = select(0f, _e1168, (_e1168 > 0f));
                                                    let _e1172 = ((_e1162 + _e1166) + _e1170);
                                                    if (_e1172 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1931_ = type_29();
                                                        phi_1932_ = true;
                                                        phi_1933_ = false;
                                                    } else {
                                                        let _e1175 = select(_e1124, _e1111, (_e1111 < _e1124));
                                                        if (select(_e1137, _e1175, (_e1175 < _e1137)) > 0f) {
                                                            phi_1223_ = true;
                                                        } else {
                                                            let _e1180 = select(_e1124, _e1111, (_e1111 > _e1124));
                                                            phi_1223_ = (select(_e1137, _e1180, (_e1180 > _e1137)) < 0f);
                                                        }
                                                        let _e1185 = phi_1223_;
                                                        if _e1185 {
                                                            phi_1928_ = type_29();
                                                            phi_1929_ = true;
                                                            phi_1930_ = false;
                                                        } else {
                                                            let _e1187 = select(_e1127, _e1114, (_e1114 < _e1127));
                                                            if (select(_e1140, _e1187, (_e1187 < _e1140)) > 0f) {
                                                                phi_1252_ = true;
                                                            } else {
                                                                let _e1192 = select(_e1127, _e1114, (_e1114 > _e1127));
                                                                phi_1252_ = (select(_e1140, _e1192, (_e1192 > _e1140)) < 0f);
                                                            }
                                                            let _e1197 = phi_1252_;
                                                            if _e1197 {
                                                                phi_1926_ = type_29();
                                                                phi_1927_ = false;
                                                            } else {
                                                                let _e1199 = select(_e1099[1][0], _e1099[0][0], (_e1099[0][0] < _e1099[1][0]));
                                                                let _e1203 = select(_e1099[1][0], _e1099[0][0], (_e1099[0][0] > _e1099[1][0]));
                                                                let _e1207 = select(_e1099[1][1], _e1099[0][1], (_e1099[0][1] < _e1099[1][1]));
                                                                let _e1211 = select(_e1099[1][1], _e1099[0][1], (_e1099[0][1] > _e1099[1][1]));
                                                                let _e1215 = select(_e1099[1][2], _e1099[0][2], (_e1099[0][2] < _e1099[1][2]));
                                                                let _e1219 = select(_e1099[1][2], _e1099[0][2], (_e1099[0][2] > _e1099[1][2]));
                                                                let _e1224 = ((select(_e1099[2][0], _e1199, (_e1199 < _e1099[2][0])) - _e329) * _e334);
                                                                let _e1225 = ((select(_e1099[2][0], _e1203, (_e1203 > _e1099[2][0])) - _e330) * _e334);
                                                                let _e1228 = ((select(_e1099[2][1], _e1207, (_e1207 < _e1099[2][1])) - _e367) * _e372);
                                                                let _e1229 = ((select(_e1099[2][1], _e1211, (_e1211 > _e1099[2][1])) - _e368) * _e372);
                                                                let _e1232 = ((select(_e1099[2][2], _e1215, (_e1215 < _e1099[2][2])) - _e405) * _e410);
                                                                let _e1233 = ((select(_e1099[2][2], _e1219, (_e1219 > _e1099[2][2])) - _e406) * _e410);
                                                                let _e1235 = select(_e1233, _e1232, (_e1232 < _e1233));
                                                                let _e1237 = select(_e1233, _e1232, (_e1232 > _e1233));
                                                                let _e1239 = select(_e1225, _e1224, (_e1224 < _e1225));
                                                                let _e1241 = select(_e1229, _e1228, (_e1228 < _e1229));
                                                                let _e1243 = select(_e1241, _e1239, (_e1239 > _e1241));
                                                                let _e1245 = select(_e1235, _e1243, (_e1243 > _e1235));
                                                                let _e1247 = select(_e1225, _e1224, (_e1224 > _e1225));
                                                                let _e1249 = select(_e1229, _e1228, (_e1228 > _e1229));
                                                                let _e1251 = select(_e1249, _e1247, (_e1247 < _e1249));
                                                                let _e1253 = select(_e1237, _e1251, (_e1251 < _e1237));
                                                                let _e1254 = -(_e1235);
                                                                let _e1260 = select(_e457, _e1245, (_e1245 > _e457));
                                                                if (_e1260 > (_e1253 + (select(_e1254, _e1237, (_e1237 > _e1254)) * 0.0000019073523f))) {
                                                                    phi_1921_ = type_29();
                                                                    phi_1922_ = true;
                                                                } else {
                                                                    let _e1262 = (_e1260 > _e997.member.member_1);
                                                                    if _e1262 {
                                                                        phi_1920_ = type_29();
                                                                    } else {
                                                                        let _e1263 = vec3<f32>(_e1099[0][0], _e1099[0][1], _e1099[0][2]);
                                                                        let _e1264 = vec3<f32>(_e1099[1][0], _e1099[1][1], _e1099[1][2]);
                                                                        let _e1265 = vec3<f32>(_e1099[2][0], _e1099[2][1], _e1099[2][2]);
                                                                        let _e1266 = (_e1099[1][0] - _e1099[0][0]);
                                                                        let _e1267 = (_e1099[1][1] - _e1099[0][1]);
                                                                        let _e1268 = (_e1099[1][2] - _e1099[0][2]);
                                                                        let _e1269 = vec3<f32>(_e1266, _e1267, _e1268);
                                                                        let _e1270 = (_e1099[2][0] - _e1099[1][0]);
                                                                        let _e1271 = (_e1099[2][1] - _e1099[1][1]);
                                                                        let _e1272 = (_e1099[2][2] - _e1099[1][2]);
                                                                        let _e1273 = vec3<f32>(_e1270, _e1271, _e1272);
                                                                        let _e1274 = (_e1099[0][0] - _e1099[2][0]);
                                                                        let _e1275 = (_e1099[0][1] - _e1099[2][1]);
                                                                        let _e1276 = (_e1099[0][2] - _e1099[2][2]);
                                                                        let _e1277 = vec3<f32>(_e1274, _e1275, _e1276);
                                                                        let _e1280 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
                                                                        let _e1283 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
                                                                        let _e1285 = select(_e1283, _e1280, (_e1280 > _e1283));
                                                                        let _e1288 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                        let _e1290 = select(_e1288, _e1285, (_e1285 > _e1288));
                                                                        let _e1293 = bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u));
                                                                        let _e1296 = bitcast<f32>((bitcast<u32>(_e1271) & 2147483647u));
                                                                        let _e1298 = select(_e1296, _e1293, (_e1293 > _e1296));
                                                                        let _e1301 = bitcast<f32>((bitcast<u32>(_e1272) & 2147483647u));
                                                                        let _e1303 = select(_e1301, _e1298, (_e1298 > _e1301));
                                                                        let _e1306 = bitcast<f32>((bitcast<u32>(_e1274) & 2147483647u));
                                                                        let _e1309 = bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u));
                                                                        let _e1311 = select(_e1309, _e1306, (_e1306 > _e1309));
                                                                        let _e1314 = bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u));
                                                                        let _e1316 = select(_e1314, _e1311, (_e1311 > _e1314));
                                                                        let _e1318 = select(_e1303, _e1290, (_e1290 > _e1303));
                                                                        let _e1320 = select(_e1316, _e1318, (_e1318 > _e1316));
                                                                        if (_e1290 == _e1320) {
                                                                            phi_1653_ = _e1127;
                                                                            phi_1654_ = _e1124;
                                                                            phi_1655_ = _e1114;
                                                                            phi_1656_ = _e1111;
                                                                            phi_1657_ = _e1263;
                                                                            phi_1658_ = _e1277;
                                                                            phi_1659_ = _e1273;
                                                                            phi_1660_ = _e1269;
                                                                        } else {
                                                                            let _e1322 = (_e1303 == _e1320);
                                                                            let _e1327 = vec3(_e1322);
                                                                            phi_1653_ = select(_e1114, _e1140, _e1322);
                                                                            phi_1654_ = select(_e1111, _e1137, _e1322);
                                                                            phi_1655_ = select(_e1140, _e1127, _e1322);
                                                                            phi_1656_ = select(_e1137, _e1124, _e1322);
                                                                            phi_1657_ = select(_e1265, _e1264, _e1327);
                                                                            phi_1658_ = select(_e1273, _e1269, _e1327);
                                                                            phi_1659_ = select(_e1269, _e1277, _e1327);
                                                                            phi_1660_ = select(_e1277, _e1273, _e1327);
                                                                        }
                                                                        let _e1333 = phi_1653_;
                                                                        let _e1335 = phi_1654_;
                                                                        let _e1337 = phi_1655_;
                                                                        let _e1339 = phi_1656_;
                                                                        let _e1341 = phi_1657_;
                                                                        let _e1343 = phi_1658_;
                                                                        let _e1345 = phi_1659_;
                                                                        let _e1347 = phi_1660_;
                                                                        let _e1354 = ((_e1345.y * _e1343.z) - (_e1343.y * _e1345.z));
                                                                        let _e1359 = ((_e1345.z * _e1343.x) - (_e1343.z * _e1345.x));
                                                                        let _e1362 = ((_e1345.x * _e1343.y) - (_e1343.x * _e1345.y));
                                                                        if (_e1162 >= _e1166) {
                                                                            phi_1691_ = select(true, false, (_e1162 >= _e1170));
                                                                        } else {
                                                                            phi_1691_ = true;
                                                                        }
                                                                        let _e1367 = phi_1691_;
                                                                        if _e1367 {
                                                                            phi_1700_ = select(_e1265, _e1264, vec3((_e1166 >= _e1170)));
                                                                        } else {
                                                                            phi_1700_ = _e1263;
                                                                        }
                                                                        let _e1372 = phi_1700_;
                                                                        let _e1383 = (((_e1354 * (_e1372.x - _e306)) + (_e1359 * (_e1372.y - _e345))) + (_e1362 * (_e1372.z - _e383)));
                                                                        let _e1388 = (((_e1354 * _e331) + (_e1359 * _e369)) + (_e1362 * _e407));
                                                                        let _e1389 = (_e1335 - _e1339);
                                                                        let _e1390 = (_e1333 - _e1337);
                                                                        let _e1398 = (-(((_e1339 * _e1389) + (_e1337 * _e1390))) / ((_e1389 * _e1389) + (_e1390 * _e1390)));
                                                                        let _e1400 = select(1f, _e1398, (_e1398 < 1f));
                                                                        let _e1402 = select(0f, _e1400, (_e1400 > 0f));
                                                                        let _e1415 = ((_e1341.x + (_e1347.x * _e1402)) - _e306);
                                                                        let _e1416 = ((_e1341.y + (_e1347.y * _e1402)) - _e345);
                                                                        let _e1417 = ((_e1341.z + (_e1347.z * _e1402)) - _e383);
                                                                        let _e1418 = (_e1417 / _e407);
                                                                        let _e1430 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                                        let _e1433 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                                        let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                        let _e1440 = select(_e1438, _e1435, (_e1435 > _e1438));
                                                                        let _e1446 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                        let _e1449 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                        let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1354 * _e1415) + (_e1359 * _e1416)) + (_e1362 * _e1417)) - _e1383)) & 2147483647u)) <= ((0.0000009536743f * select(_e1320, _e1440, (_e1440 > _e1320))) * select(_e1454, _e1451, (_e1451 > _e1454)))) {
                                                                            let _e1464 = bitcast<f32>((bitcast<u32>(_e1345.x) & 2147483647u));
                                                                            let _e1467 = bitcast<f32>((bitcast<u32>(_e1345.y) & 2147483647u));
                                                                            let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                                                            let _e1472 = bitcast<f32>((bitcast<u32>(_e1345.z) & 2147483647u));
                                                                            let _e1478 = bitcast<f32>((bitcast<u32>(_e1343.x) & 2147483647u));
                                                                            let _e1481 = bitcast<f32>((bitcast<u32>(_e1343.y) & 2147483647u));
                                                                            let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                                            let _e1486 = bitcast<f32>((bitcast<u32>(_e1343.z) & 2147483647u));
                                                                            let _e1490 = (bitcast<f32>((bitcast<u32>(_e1388) & 2147483647u)) > ((0.0000038146973f * select(_e1472, _e1469, (_e1469 > _e1472))) * select(_e1486, _e1483, (_e1483 > _e1486))));
                                                                            if _e1490 {
                                                                                phi_1865_ = (_e1383 / _e1388);
                                                                            } else {
                                                                                phi_1865_ = f32();
                                                                            }
                                                                            let _e1493 = phi_1865_;
                                                                            phi_1867_ = _e1493;
                                                                            phi_1868_ = select(true, false, _e1490);
                                                                        } else {
                                                                            phi_1867_ = f32();
                                                                            phi_1868_ = true;
                                                                        }
                                                                        let _e1496 = phi_1867_;
                                                                        let _e1498 = phi_1868_;
                                                                        if _e1498 {
                                                                            let _e1506 = (((_e1354 * (_e1415 - (_e331 * _e1418))) + (_e1359 * (_e1416 - (_e369 * _e1418)))) / _e1388);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u)) <= _e1320) {
                                                                                phi_1888_ = (_e1418 + _e1506);
                                                                            } else {
                                                                                phi_1888_ = _e1418;
                                                                            }
                                                                            let _e1513 = phi_1888_;
                                                                            phi_1889_ = _e1513;
                                                                        } else {
                                                                            phi_1889_ = _e1496;
                                                                        }
                                                                        let _e1515 = phi_1889_;
                                                                        let _e1517 = select(_e1253, _e1515, (_e1515 < _e1253));
                                                                        let _e1519 = select(_e1245, _e1517, (_e1517 > _e1245));
                                                                        if (_e1519 >= _e457) {
                                                                            let _e1521 = (_e1519 <= _e997.member.member_1);
                                                                            if _e1521 {
                                                                                let _e1522 = (1f / _e1172);
                                                                                phi_1912_ = type_29(_e1519, (_e1166 * _e1522), (_e1170 * _e1522), _e1032);
                                                                            } else {
                                                                                phi_1912_ = type_29();
                                                                            }
                                                                            let _e1527 = phi_1912_;
                                                                            phi_1914_ = _e1527;
                                                                            phi_1915_ = select(true, false, _e1521);
                                                                        } else {
                                                                            phi_1914_ = type_29();
                                                                            phi_1915_ = true;
                                                                        }
                                                                        let _e1530 = phi_1914_;
                                                                        let _e1532 = phi_1915_;
                                                                        if _e1532 {
                                                                            phi_1919_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1919_ = _e1530;
                                                                        }
                                                                        let _e1534 = phi_1919_;
                                                                        phi_1920_ = _e1534;
                                                                    }
                                                                    let _e1536 = phi_1920_;
                                                                    phi_1921_ = _e1536;
                                                                    phi_1922_ = _e1262;
                                                                }
                                                                let _e1538 = phi_1921_;
                                                                let _e1540 = phi_1922_;
                                                                phi_1926_ = _e1538;
                                                                phi_1927_ = _e1540;
                                                            }
                                                            let _e1542 = phi_1926_;
                                                            let _e1544 = phi_1927_;
                                                            phi_1928_ = _e1542;
                                                            phi_1929_ = _e1197;
                                                            phi_1930_ = _e1544;
                                                        }
                                                        let _e1546 = phi_1928_;
                                                        let _e1548 = phi_1929_;
                                                        let _e1550 = phi_1930_;
                                                        phi_1931_ = _e1546;
                                                        phi_1932_ = _e1548;
                                                        phi_1933_ = _e1550;
                                                    }
                                                    let _e1552 = phi_1931_;
                                                    let _e1554 = phi_1932_;
                                                    let _e1556 = phi_1933_;
                                                    phi_1941_ = _e1552;
                                                    phi_1942_ = select(_e1556, true, _e1554);
                                                } else {
                                                    phi_1941_ = type_29();
                                                    phi_1942_ = true;
                                                }
                                                let _e1559 = phi_1941_;
                                                let _e1561 = phi_1942_;
                                                if _e1561 {
                                                    phi_1946_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1946_ = _e1559;
                                                }
                                                let _e1563 = phi_1946_;
                                                if (_e1563.member_3 != 4294967295u) {
                                                    if (_e1032 != 4294967295u) {
                                                        if (_e1563.member < _e997.member.member.member) {
                                                            phi_1972_ = true;
                                                        } else {
                                                            if (_e1563.member == _e997.member.member.member) {
                                                                phi_1971_ = (_e1563.member_3 < _e997.member.member.member_3);
                                                            } else {
                                                                phi_1971_ = false;
                                                            }
                                                            let _e1578 = phi_1971_;
                                                            phi_1972_ = _e1578;
                                                        }
                                                        let _e1580 = phi_1972_;
                                                        if _e1580 {
                                                            phi_1979_ = type_44(type_37(_e1563, _e1563.member), _e1024.member_1, _e1024.member_2);
                                                        } else {
                                                            phi_1979_ = _e1024;
                                                        }
                                                        let _e1587 = phi_1979_;
                                                        phi_1980_ = _e1587;
                                                    } else {
                                                        phi_1980_ = _e1024;
                                                    }
                                                    let _e1589 = phi_1980_;
                                                    phi_1981_ = _e1589;
                                                } else {
                                                    phi_1981_ = _e1024;
                                                }
                                                let _e1591 = phi_1981_;
                                                phi_968_ = _e1591;
                                            } else {
                                                phi_968_ = type_44();
                                            }
                                            let _e1593 = phi_968_;
                                            continue;
                                            continuing {
                                                phi_967_ = _e1593;
                                                phi_970_ = _e1012;
                                                phi_3409_ = _e500;
                                                break if !(_e1018);
                                            }
                                        }
                                        let _e1596 = phi_3409_;
                                        phi_3551_ = _e1596;
                                        if _e1596 {
                                            break;
                                        }
                                        phi_3555_ = _e1596;
                                        let _e1768 = local_12;
                                        phi_3189_ = _e1768;
                                        phi_3190_ = _e542;
                                        phi_3191_ = false;
                                        phi_3192_ = _e546;
                                    } else {
                                        if (_e542.member_1 >= _e87) {
                                            phi_2745_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e542.member_1 < _e87) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e564 = ((1u + _e257) % 4u);
                                            if (_e564 < 4u) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e569 = global_4.member[_e542.member_1][_e564];
                                            let _e571 = (_e569 >> bitcast<u32>(11u));
                                            let _e573 = ((1u + _e256) % 4u);
                                            if (_e573 < 4u) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e578 = global_4.member[_e542.member_1][_e573];
                                            let _e580 = (_e578 >> bitcast<u32>(11u));
                                            let _e582 = ((1u + _e258) % 4u);
                                            if (_e582 < 4u) {
                                            } else {
                                                phi_3551_ = true;
                                                break;
                                            }
                                            let _e587 = global_4.member[_e542.member_1][_e582];
                                            let _e589 = (_e587 >> bitcast<u32>(11u));
                                            let _e612 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.x - _e542.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e613 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.y - _e542.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e614 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.z - _e542.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e616 = select(_e137, _e612, (_e612 > _e137));
                                            let _e618 = select(_e137, _e613, (_e613 > _e137));
                                            let _e620 = select(_e137, _e614, (_e614 > _e137));
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
                                            let _e752 = global_4.member[_e542.member_1][0u];
                                            let _e756 = global_4.member[_e542.member_1][1u];
                                            let _e760 = global_4.member[_e542.member_1][2u];
                                            let _e764 = global_4.member[_e542.member_1][3u];
                                            let _e776 = (((_e756 >> bitcast<u32>(22i)) | ((_e760 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e764 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e777 = (_e752 & 268435455u);
                                            let _e778 = (_e776 & 268435455u);
                                            let _e781 = ((_e752 >> bitcast<u32>(28u)) & 7u);
                                            let _e789 = ((_e752 >> bitcast<u32>(31i)) | (((_e776 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e790 = (_e781 != 0u);
                                            if (_e781 == 0u) {
                                                phi_2707_ = _e777;
                                            } else {
                                                if (_e781 == 7u) {
                                                    phi_2706_ = 2147483648u;
                                                } else {
                                                    phi_2706_ = ((2147483648u | (_e781 << bitcast<u32>(28u))) | (_e778 & 268435455u));
                                                }
                                                let _e799 = phi_2706_;
                                                phi_2707_ = _e799;
                                            }
                                            let _e801 = phi_2707_;
                                            if _e790 {
                                                let _e802 = (_e781 != 7u);
                                                if _e802 {
                                                    phi_2717_ = (_e778 + _e781);
                                                } else {
                                                    phi_2717_ = u32();
                                                }
                                                let _e805 = phi_2717_;
                                                phi_2719_ = _e805;
                                                phi_2720_ = select(true, false, _e802);
                                            } else {
                                                phi_2719_ = u32();
                                                phi_2720_ = true;
                                            }
                                            let _e808 = phi_2719_;
                                            let _e810 = phi_2720_;
                                            if (_e789 == 0u) {
                                                phi_2741_ = (_e777 + select(0u, 1u, !(_e790)));
                                            } else {
                                                if (_e789 == 7u) {
                                                    phi_2740_ = 2147483648u;
                                                } else {
                                                    phi_2740_ = ((2147483648u | (_e789 << bitcast<u32>(28u))) | (select(_e808, _e778, _e810) & 268435455u));
                                                }
                                                let _e823 = phi_2740_;
                                                phi_2741_ = _e823;
                                            }
                                            let _e825 = phi_2741_;
                                            phi_2745_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e542.member.member.x + _e653), (_e542.member.member.x + _e675), (_e542.member.member_1.x - _e692), (_e542.member.member_1.x - _e714)), vec4<f32>((_e542.member.member.y + _e662), (_e542.member.member.y + _e679), (_e542.member.member_1.y - _e701), (_e542.member.member_1.y - _e718)), vec4<f32>((_e542.member.member.z + _e671), (_e542.member.member.z + _e683), (_e542.member.member_1.z - _e710), (_e542.member.member_1.z - _e722))), type_51(type_33((_e542.member.member + vec4<f32>(_e653, _e662, _e671, 0f)), (_e542.member.member_1 - vec4<f32>(_e692, _e701, _e710, 0f))), _e801), type_51(type_33((_e542.member.member + vec4<f32>(_e675, _e679, _e683, 0f)), (_e542.member.member_1 - vec4<f32>(_e714, _e718, _e722, 0f))), _e825));
                                        }
                                        let _e830 = phi_2745_;
                                        let _e843 = ((_e830.member[0].x - _e329) * _e334);
                                        let _e844 = ((_e830.member[0].y - _e329) * _e334);
                                        let _e845 = ((_e830.member[0].z - _e330) * _e334);
                                        let _e846 = ((_e830.member[0].w - _e330) * _e334);
                                        let _e856 = ((_e830.member[1].x - _e367) * _e372);
                                        let _e857 = ((_e830.member[1].y - _e367) * _e372);
                                        let _e858 = ((_e830.member[1].z - _e368) * _e372);
                                        let _e859 = ((_e830.member[1].w - _e368) * _e372);
                                        let _e869 = ((_e830.member[2].x - _e405) * _e410);
                                        let _e870 = ((_e830.member[2].y - _e405) * _e410);
                                        let _e871 = ((_e830.member[2].z - _e406) * _e410);
                                        let _e872 = ((_e830.member[2].w - _e406) * _e410);
                                        let _e874 = select(_e871, _e869, (_e869 < _e871));
                                        let _e876 = select(_e872, _e870, (_e870 < _e872));
                                        let _e878 = select(_e871, _e869, (_e869 > _e871));
                                        let _e880 = select(_e872, _e870, (_e870 > _e872));
                                        let _e882 = select(_e845, _e843, (_e843 < _e845));
                                        let _e884 = select(_e846, _e844, (_e844 < _e846));
                                        let _e886 = select(_e858, _e856, (_e856 < _e858));
                                        let _e888 = select(_e859, _e857, (_e857 < _e859));
                                        let _e890 = select(_e886, _e882, (_e882 > _e886));
                                        let _e892 = select(_e888, _e884, (_e884 > _e888));
                                        let _e894 = select(_e874, _e890, (_e890 > _e874));
                                        let _e896 = select(_e876, _e892, (_e892 > _e876));
                                        let _e898 = select(_e845, _e843, (_e843 > _e845));
                                        let _e900 = select(_e846, _e844, (_e844 > _e846));
                                        let _e902 = select(_e858, _e856, (_e856 > _e858));
                                        let _e904 = select(_e859, _e857, (_e857 > _e859));
                                        let _e906 = select(_e902, _e898, (_e898 < _e902));
                                        let _e908 = select(_e904, _e900, (_e900 < _e904));
                                        let _e913 = -(_e874);
                                        let _e914 = -(_e876);
                                        let _e921 = (select(_e878, _e906, (_e906 < _e878)) + (select(_e913, _e878, (_e878 > _e913)) * 0.0000019073523f));
                                        let _e922 = (select(_e880, _e908, (_e908 < _e880)) + (select(_e914, _e880, (_e880 > _e914)) * 0.0000019073523f));
                                        let _e924 = select(_e457, _e894, (_e894 > _e457));
                                        let _e926 = select(_e457, _e896, (_e896 > _e457));
                                        let _e931 = (_e924 <= select(_e502.member.member_1, _e921, (_e921 < _e502.member.member_1)));
                                        let _e932 = (_e926 <= select(_e502.member.member_1, _e922, (_e922 < _e502.member.member_1)));
                                        let _e933 = (_e924 <= _e926);
                                        if _e931 {
                                            if _e932 {
                                                if _e933 {
                                                    phi_3089_ = _e830.member_2;
                                                } else {
                                                    phi_3089_ = _e830.member_1;
                                                }
                                                let _e937 = phi_3089_;
                                                let _e959 = (_e546 % 128u);
                                                let _e960 = (_e959 < 128u);
                                                if _e960 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_8[_e959] = _e937.member_1;
                                                if _e960 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_7[_e959] = _e937.member.member.x;
                                                if _e960 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_6[_e959] = _e937.member.member.y;
                                                if _e960 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_5[_e959] = _e937.member.member.z;
                                                if _e960 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_4[_e959] = _e937.member.member_1.x;
                                                if _e960 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_3[_e959] = _e937.member.member_1.y;
                                                if _e960 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_2[_e959] = _e937.member.member_1.z;
                                                if _e960 {
                                                } else {
                                                    phi_3551_ = true;
                                                    break;
                                                }
                                                local_9[_e959] = select(_e926, _e924, (_e924 > _e926));
                                                if _e933 {
                                                    phi_3166_ = _e830.member_1;
                                                } else {
                                                    phi_3166_ = _e830.member_2;
                                                }
                                                let _e973 = phi_3166_;
                                                phi_3167_ = _e973;
                                                phi_3168_ = (_e546 + 1u);
                                            } else {
                                                phi_3167_ = type_51();
                                                phi_3168_ = u32();
                                            }
                                            let _e975 = phi_3167_;
                                            let _e977 = phi_3168_;
                                            phi_3170_ = _e975;
                                            phi_3171_ = _e977;
                                            phi_3172_ = select(true, false, _e932);
                                        } else {
                                            phi_3170_ = type_51();
                                            phi_3171_ = u32();
                                            phi_3172_ = true;
                                        }
                                        let _e980 = phi_3170_;
                                        let _e982 = phi_3171_;
                                        let _e984 = phi_3172_;
                                        if _e984 {
                                            if _e931 {
                                                phi_3181_ = _e830.member_1;
                                            } else {
                                                phi_3181_ = _e830.member_2;
                                            }
                                            let _e988 = phi_3181_;
                                            phi_3186_ = _e988;
                                            phi_3187_ = select(_e932, true, _e931);
                                        } else {
                                            phi_3186_ = _e980;
                                            phi_3187_ = _e544;
                                        }
                                        let _e991 = phi_3186_;
                                        let _e993 = phi_3187_;
                                        phi_3555_ = _e500;
                                        phi_3189_ = type_44(_e502.member, (_e502.member_1 + 1u), _e502.member_2);
                                        phi_3190_ = _e991;
                                        phi_3191_ = _e993;
                                        phi_3192_ = select(_e982, _e546, _e984);
                                    }
                                    let _e1598 = phi_3555_;
                                    let _e1600 = phi_3189_;
                                    let _e1602 = phi_3190_;
                                    let _e1604 = phi_3191_;
                                    let _e1606 = phi_3192_;
                                    phi_3554_ = _e1598;
                                    phi_3193_ = _e1600;
                                    phi_3194_ = _e1602;
                                    phi_3195_ = (_e506 - 1u);
                                    phi_3196_ = _e1604;
                                    phi_3197_ = _e1606;
                                } else {
                                    phi_3554_ = _e500;
                                    phi_3193_ = _e502;
                                    phi_3194_ = _e542;
                                    phi_3195_ = _e506;
                                    phi_3196_ = _e544;
                                    phi_3197_ = _e546;
                                }
                                let _e1608 = phi_3554_;
                                let _e1610 = phi_3193_;
                                let _e1612 = phi_3194_;
                                let _e1614 = phi_3195_;
                                let _e1616 = phi_3196_;
                                let _e1618 = phi_3197_;
                                phi_3553_ = _e1608;
                                phi_3198_ = _e1610;
                                phi_3199_ = _e1612;
                                phi_3200_ = _e1614;
                                phi_3201_ = _e1616;
                                phi_3202_ = _e1618;
                            } else {
                                phi_3553_ = _e500;
                                phi_3198_ = type_44();
                                phi_3199_ = type_51();
                                phi_3200_ = u32();
                                phi_3201_ = bool();
                                phi_3202_ = u32();
                            }
                            let _e1620 = phi_3553_;
                            let _e1622 = phi_3198_;
                            let _e1624 = phi_3199_;
                            let _e1626 = phi_3200_;
                            let _e1628 = phi_3201_;
                            let _e1630 = phi_3202_;
                            phi_3552_ = _e1620;
                            phi_842_ = _e1622;
                            phi_845_ = _e1624;
                            phi_847_ = _e1626;
                            phi_849_ = _e1628;
                            phi_851_ = _e1630;
                            phi_3203_ = _e514;
                        } else {
                            phi_3552_ = _e500;
                            phi_842_ = type_44();
                            phi_845_ = type_51();
                            phi_847_ = u32();
                            phi_849_ = bool();
                            phi_851_ = u32();
                            phi_3203_ = false;
                        }
                        let _e1632 = phi_3552_;
                        let _e1634 = phi_842_;
                        let _e1636 = phi_845_;
                        let _e1638 = phi_847_;
                        let _e1640 = phi_849_;
                        let _e1642 = phi_851_;
                        let _e1644 = phi_3203_;
                        continue;
                        continuing {
                            phi_3415_ = _e1632;
                            phi_841_ = _e1634;
                            phi_844_ = _e1636;
                            phi_846_ = _e1638;
                            phi_848_ = _e1640;
                            phi_850_ = _e1642;
                            phi_3551_ = _e1632;
                            break if !(_e1644);
                        }
                    }
                    let _e1647 = phi_3551_;
                    if _e1647 {
                        break;
                    }
                    let _e1649 = local_10;
                    let _e1652 = local_11;
                    if _e145 {
                    } else {
                        break;
                    }
                    global_6.member[_e143][0u] = _e1649.member_1;
                    global_6.member[_e143][1u] = _e1652.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
