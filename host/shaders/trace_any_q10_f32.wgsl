struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<array<u32, 4>>,
}

struct type_15 {
    member: vec4<u32>,
}

struct type_20 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_38 {
    member: array<type_28>,
}

struct type_40 {
    member: f32,
    member_1: bool,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: type_31,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_47,
    member_2: type_47,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_15;
@group(0) @binding(3) 
var<storage> global_2: type_22;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(2) 
var<storage> global_4: type_12;
@group(0) @binding(4) 
var<storage> global_5: type_38;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_47, 128>;
    var phi_362_: i32;
    var phi_363_: i32;
    var phi_373_: bool;
    var phi_383_: u32;
    var phi_384_: u32;
    var phi_386_: bool;
    var phi_391_: u32;
    var phi_404_: i32;
    var phi_424_: i32;
    var phi_442_: f32;
    var phi_448_: f32;
    var phi_459_: f32;
    var phi_465_: f32;
    var phi_488_: f32;
    var phi_499_: f32;
    var phi_508_: f32;
    var phi_514_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_554_: f32;
    var phi_565_: f32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_620_: f32;
    var phi_631_: f32;
    var phi_731_: f32;
    var phi_732_: f32;
    var phi_4182_: bool;
    var phi_1852_: type_40;
    var phi_1855_: type_47;
    var phi_1857_: u32;
    var phi_1859_: bool;
    var phi_1861_: u32;
    var phi_1872_: bool;
    var phi_1909_: type_47;
    var phi_1910_: bool;
    var phi_1911_: u32;
    var phi_3518_: u32;
    var phi_3519_: u32;
    var phi_3529_: u32;
    var phi_3531_: u32;
    var phi_3532_: bool;
    var phi_3552_: u32;
    var phi_3553_: u32;
    var phi_3557_: type_50;
    var phi_3901_: type_47;
    var phi_3934_: type_47;
    var phi_3935_: type_47;
    var phi_3936_: u32;
    var phi_3938_: type_47;
    var phi_3939_: u32;
    var phi_3940_: bool;
    var phi_3949_: type_47;
    var phi_3954_: type_47;
    var phi_3955_: bool;
    var phi_1929_: type_40;
    var phi_1932_: type_7;
    var phi_1933_: type_7;
    var phi_1955_: type_7;
    var phi_1976_: u32;
    var phi_2065_: array<array<f32, 3>, 3>;
    var phi_2536_: vec3<f32>;
    var phi_2537_: vec3<f32>;
    var phi_2568_: bool;
    var phi_2577_: vec3<f32>;
    var phi_2617_: type_27;
    var phi_2619_: type_27;
    var phi_2620_: bool;
    var phi_2624_: type_27;
    var phi_2625_: type_27;
    var phi_2626_: type_27;
    var phi_2627_: bool;
    var phi_2631_: type_27;
    var phi_2632_: bool;
    var phi_2636_: type_27;
    var phi_2637_: bool;
    var phi_2641_: type_27;
    var phi_2652_: type_40;
    var phi_2653_: type_40;
    var phi_1930_: type_40;
    var phi_4176_: bool;
    var local_4: type_40;
    var phi_4291_: bool;
    var phi_3957_: type_40;
    var phi_3958_: type_47;
    var phi_3959_: bool;
    var phi_3960_: u32;
    var phi_4290_: bool;
    var phi_3961_: type_40;
    var phi_3962_: type_47;
    var phi_3963_: u32;
    var phi_3964_: bool;
    var phi_3965_: u32;
    var phi_4289_: bool;
    var phi_3966_: type_40;
    var phi_3967_: type_47;
    var phi_3968_: u32;
    var phi_3969_: bool;
    var phi_3970_: u32;
    var phi_4288_: bool;
    var phi_1853_: type_40;
    var phi_1856_: type_47;
    var phi_1858_: u32;
    var phi_1860_: bool;
    var phi_1862_: u32;
    var phi_3971_: bool;
    var phi_4287_: bool;
    var local_5: type_40;
    var local_6: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = global;
            let _e80 = arrayLength((&global_4.member));
            let _e82 = arrayLength((&global_2.member));
            let _e90 = global_3.member[0u][0u];
            let _e94 = global_3.member[0u][1u];
            let _e98 = global_3.member[0u][2u];
            let _e102 = global_3.member[0u][3u];
            let _e106 = global_3.member[1u][0u];
            let _e110 = global_3.member[1u][1u];
            let _e114 = global_3.member[1u][2u];
            let _e117 = global_1.member[0u];
            let _e118 = bitcast<i32>(_e117);
            let _e130 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e102) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e90), bitcast<i32>(_e94), bitcast<i32>(_e98));
            local = array<i32, 3>(bitcast<i32>(_e106), bitcast<i32>(_e110), bitcast<i32>(_e114));
            let _e136 = (_e78.x + (_e78.y * 2097152u));
            let _e137 = (_e136 < arrayLength((&global_5.member)));
            if _e137 {
                let _e138 = (_e136 < arrayLength((&global_6.member)));
                if _e138 {
                    if _e137 {
                    } else {
                        break;
                    }
                    let _e146 = global_5.member[_e136].member_2[0u];
                    let _e148 = (bitcast<u32>(_e146) & 2147483647u);
                    let _e153 = global_5.member[_e136].member_2[1u];
                    let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                    let _e160 = global_5.member[_e136].member_2[2u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_5.member[_e136].member[0u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_5.member[_e136].member[1u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_5.member[_e136].member[2u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e185 = select(_e155, _e148, (_e155 < _e148));
                    let _e187 = select(_e162, _e185, (_e162 < _e185));
                    let _e189 = select(_e169, _e187, (_e169 < _e187));
                    let _e191 = select(_e176, _e189, (_e176 < _e189));
                    let _e193 = select(_e183, _e191, (_e183 < _e191));
                    let _e197 = global_5.member[_e136].member_1;
                    let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                    let _e206 = global_5.member[_e136].member_3;
                    let _e212 = (((select(_e199, _e193, (_e199 < _e193)) < 2139095040u) && ((bitcast<u32>(_e206) & 2147483647u) <= 2139095040u)) && (_e187 > 0u));
                    if _e212 {
                        let _e215 = (bitcast<u32>(bitcast<f32>(_e187)) & 2147483647u);
                        if (_e215 >= 8388608u) {
                            phi_362_ = (bitcast<i32>((_e215 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_362_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e215)), 32u, (_e215 == 0u))));
                        }
                        let _e229 = phi_362_;
                        phi_363_ = _e229;
                    } else {
                        phi_363_ = 0i;
                    }
                    let _e231 = phi_363_;
                    let _e232 = (_e148 == _e187);
                    if _e232 {
                        phi_373_ = true;
                    } else {
                        phi_373_ = (_e155 == _e187);
                    }
                    let _e235 = phi_373_;
                    let _e236 = select(1u, 0u, _e232);
                    if _e235 {
                        let _e237 = (_e236 + 1u);
                        phi_383_ = _e237;
                        phi_384_ = _e237;
                        phi_386_ = select(true, false, (_e237 == 2u));
                    } else {
                        phi_383_ = u32();
                        phi_384_ = 0u;
                        phi_386_ = true;
                    }
                    let _e241 = phi_383_;
                    let _e243 = phi_384_;
                    let _e245 = phi_386_;
                    if _e245 {
                        phi_391_ = (_e243 + 1u);
                    } else {
                        phi_391_ = 0u;
                    }
                    let _e249 = phi_391_;
                    let _e250 = select(_e241, _e243, _e245);
                    let _e251 = select(_e236, select(2u, _e236, _e235), _e245);
                    if (_e118 < -126i) {
                        phi_404_ = -126i;
                    } else {
                        phi_404_ = select(_e118, 127i, (_e118 > 127i));
                    }
                    let _e256 = phi_404_;
                    let _e261 = bitcast<f32>((bitcast<u32>((_e256 + 127i)) << bitcast<u32>(23i)));
                    let _e267 = bitcast<f32>((bitcast<u32>(((_e118 - _e256) + 127i)) << bitcast<u32>(23i)));
                    let _e268 = -(_e231);
                    if (_e268 < -126i) {
                        phi_424_ = -126i;
                    } else {
                        phi_424_ = select(_e268, 127i, (_e268 > 127i));
                    }
                    let _e273 = phi_424_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e268 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e288 = global_5.member[_e136].member;
                    let _e289 = (_e250 == 0u);
                    if _e289 {
                        phi_442_ = _e288[0];
                    } else {
                        phi_442_ = _e288[1];
                    }
                    let _e293 = phi_442_;
                    let _e294 = (_e250 == 2u);
                    if _e294 {
                        phi_448_ = _e288[2];
                    } else {
                        phi_448_ = _e293;
                    }
                    let _e297 = phi_448_;
                    let _e299 = ((_e297 * _e261) * _e267);
                    let _e300 = global_5.member[_e136].member_2;
                    if _e289 {
                        phi_459_ = _e300[0];
                    } else {
                        phi_459_ = _e300[1];
                    }
                    let _e304 = phi_459_;
                    if _e294 {
                        phi_465_ = _e300[2];
                    } else {
                        phi_465_ = _e304;
                    }
                    let _e307 = phi_465_;
                    let _e309 = ((_e307 * _e278) * _e284);
                    let _e313 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e313 {
                        let _e317 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) * 0.00000011920929f);
                        phi_488_ = select(0.00000000000011368684f, _e317, (_e317 > 0.00000000000011368684f));
                    } else {
                        phi_488_ = 0f;
                    }
                    let _e321 = phi_488_;
                    let _e322 = (_e299 + _e321);
                    let _e323 = (_e299 - _e321);
                    let _e324 = select(_e309, 0f, _e313);
                    if _e313 {
                        phi_499_ = 38685626000000000000000000f;
                    } else {
                        phi_499_ = (1f / _e309);
                    }
                    let _e327 = phi_499_;
                    let _e328 = (_e249 == 0u);
                    if _e328 {
                        phi_508_ = _e288[0];
                    } else {
                        phi_508_ = _e288[1];
                    }
                    let _e332 = phi_508_;
                    let _e333 = (_e249 == 2u);
                    if _e333 {
                        phi_514_ = _e288[2];
                    } else {
                        phi_514_ = _e332;
                    }
                    let _e336 = phi_514_;
                    let _e338 = ((_e336 * _e261) * _e267);
                    if _e328 {
                        phi_525_ = _e300[0];
                    } else {
                        phi_525_ = _e300[1];
                    }
                    let _e342 = phi_525_;
                    if _e333 {
                        phi_531_ = _e300[2];
                    } else {
                        phi_531_ = _e342;
                    }
                    let _e345 = phi_531_;
                    let _e347 = ((_e345 * _e278) * _e284);
                    let _e351 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e351 {
                        let _e355 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) * 0.00000011920929f);
                        phi_554_ = select(0.00000000000011368684f, _e355, (_e355 > 0.00000000000011368684f));
                    } else {
                        phi_554_ = 0f;
                    }
                    let _e359 = phi_554_;
                    let _e360 = (_e338 + _e359);
                    let _e361 = (_e338 - _e359);
                    let _e362 = select(_e347, 0f, _e351);
                    if _e351 {
                        phi_565_ = 38685626000000000000000000f;
                    } else {
                        phi_565_ = (1f / _e347);
                    }
                    let _e365 = phi_565_;
                    let _e366 = (_e251 == 0u);
                    if _e366 {
                        phi_574_ = _e288[0];
                    } else {
                        phi_574_ = _e288[1];
                    }
                    let _e370 = phi_574_;
                    let _e371 = (_e251 == 2u);
                    if _e371 {
                        phi_580_ = _e288[2];
                    } else {
                        phi_580_ = _e370;
                    }
                    let _e374 = phi_580_;
                    let _e376 = ((_e374 * _e261) * _e267);
                    if _e366 {
                        phi_591_ = _e300[0];
                    } else {
                        phi_591_ = _e300[1];
                    }
                    let _e380 = phi_591_;
                    if _e371 {
                        phi_597_ = _e300[2];
                    } else {
                        phi_597_ = _e380;
                    }
                    let _e383 = phi_597_;
                    let _e385 = ((_e383 * _e278) * _e284);
                    let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e389 {
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                        phi_620_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                    } else {
                        phi_620_ = 0f;
                    }
                    let _e397 = phi_620_;
                    let _e398 = (_e376 + _e397);
                    let _e399 = (_e376 - _e397);
                    let _e400 = select(_e385, 0f, _e389);
                    if _e389 {
                        phi_631_ = 38685626000000000000000000f;
                    } else {
                        phi_631_ = (1f / _e385);
                    }
                    let _e403 = phi_631_;
                    let _e406 = bitcast<f32>((bitcast<u32>(_e299) & 2147483647u));
                    let _e409 = bitcast<f32>((bitcast<u32>(_e338) & 2147483647u));
                    let _e411 = select(_e409, _e406, (_e406 > _e409));
                    let _e414 = bitcast<f32>((bitcast<u32>(_e376) & 2147483647u));
                    let _e417 = (_e118 + _e231);
                    if (_e212 && (select(_e414, _e411, (_e411 > _e414)) <= 1099511600000f)) {
                        let _e420 = (_e417 / 3i);
                        let _e427 = bitcast<f32>((bitcast<u32>((_e420 + 127i)) << bitcast<u32>(23i)));
                        let _e434 = bitcast<f32>((bitcast<u32>(((_e417 - (2i * _e420)) + 127i)) << bitcast<u32>(23i)));
                        let _e435 = (((_e197 * _e427) * _e427) * _e434);
                        let _e437 = select(340282350000000000000000000000000000000f, _e435, (_e435 < 340282350000000000000000000000000000000f));
                        let _e442 = (((_e206 * _e427) * _e427) * _e434);
                        let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                        phi_731_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                        phi_732_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_731_ = 0f;
                        phi_732_ = 1f;
                    }
                    let _e448 = phi_731_;
                    let _e450 = phi_732_;
                    local_3 = array<type_47, 128>(type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e454 = (_e250 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_1[_e454];
                    let _e460 = (_e249 % 3u);
                    let _e461 = (_e460 < 3u);
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e463 = local_1[_e460];
                    let _e466 = (_e251 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e474 = local[_e454];
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e478 = local[_e460];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e482 = local[_e466];
                    phi_4182_ = false;
                    phi_1852_ = type_40(_e448, false);
                    phi_1855_ = type_47(type_31(vec4<f32>((f32(_e457) * _e130), (f32(_e463) * _e130), (f32(_e469) * _e130), 0f), vec4<f32>((f32(_e474) * _e130), (f32(_e478) * _e130), (f32(_e482) * _e130), 0f)), select(0u, 2147483648u, (_e80 == 0u)));
                    phi_1857_ = ((3u * _e80) + 1u);
                    phi_1859_ = (_e450 <= _e448);
                    phi_1861_ = 0u;
                    loop {
                        let _e492 = phi_4182_;
                        let _e494 = phi_1852_;
                        let _e496 = phi_1855_;
                        let _e498 = phi_1857_;
                        let _e500 = phi_1859_;
                        let _e502 = phi_1861_;
                        local_5 = _e494;
                        if _e500 {
                            phi_1872_ = true;
                        } else {
                            phi_1872_ = (_e502 > 0u);
                        }
                        let _e505 = phi_1872_;
                        if _e505 {
                            let _e506 = (_e498 > 0u);
                            if _e506 {
                                if _e500 {
                                    phi_1909_ = _e496;
                                    phi_1910_ = _e500;
                                    phi_1911_ = _e502;
                                } else {
                                    let _e507 = (_e502 - 1u);
                                    let _e508 = (_e507 % 128u);
                                    let _e509 = (_e508 < 128u);
                                    if _e509 {
                                    } else {
                                        phi_4287_ = true;
                                        break;
                                    }
                                    let _e511 = local_3[_e508];
                                    if _e509 {
                                    } else {
                                        phi_4287_ = true;
                                        break;
                                    }
                                    let _e519 = local_2[_e508];
                                    phi_1909_ = type_47(type_31(_e511.member.member, _e511.member.member_1), _e511.member_1);
                                    phi_1910_ = (_e519 <= _e494.member);
                                    phi_1911_ = _e507;
                                }
                                let _e523 = phi_1909_;
                                let _e525 = phi_1910_;
                                let _e527 = phi_1911_;
                                if _e525 {
                                    if ((_e523.member_1 & 2147483648u) != 0u) {
                                        phi_1929_ = _e494;
                                        phi_1932_ = type_7(0u, ((_e523.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e973 = phi_1929_;
                                            let _e975 = phi_1932_;
                                            local_4 = _e973;
                                            local_6 = _e973;
                                            if (_e975.member < _e975.member_1) {
                                                phi_1933_ = type_7((_e975.member + 1u), _e975.member_1);
                                                phi_1955_ = type_7(1u, _e975.member);
                                            } else {
                                                phi_1933_ = _e975;
                                                phi_1955_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e988 = phi_1933_;
                                            let _e990 = phi_1955_;
                                            let _e994 = (bitcast<i32>(_e990.member) != 0i);
                                            if _e994 {
                                                let _e995 = ((_e523.member_1 & 268435455u) + _e990.member_1);
                                                let _e996 = (_e995 < _e82);
                                                if _e996 {
                                                    if _e996 {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    let _e1000 = global_2.member[_e995].member_1;
                                                    phi_1976_ = _e1000;
                                                } else {
                                                    phi_1976_ = 4294967295u;
                                                }
                                                let _e1002 = phi_1976_;
                                                if (_e995 >= _e82) {
                                                    phi_2065_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e996 {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    if (_e454 < 9u) {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    let _e1009 = global_2.member[_e995].member[_e454];
                                                    if (_e460 < 9u) {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    let _e1015 = global_2.member[_e995].member[_e460];
                                                    if (_e466 < 9u) {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    let _e1021 = global_2.member[_e995].member[_e466];
                                                    let _e1023 = (3u + _e454);
                                                    if (_e1023 < 9u) {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    let _e1029 = global_2.member[_e995].member[_e1023];
                                                    let _e1030 = (3u + _e460);
                                                    if (_e1030 < 9u) {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    let _e1036 = global_2.member[_e995].member[_e1030];
                                                    let _e1037 = (3u + _e466);
                                                    if (_e1037 < 9u) {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    let _e1043 = global_2.member[_e995].member[_e1037];
                                                    let _e1045 = (6u + _e454);
                                                    if (_e1045 < 9u) {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    let _e1051 = global_2.member[_e995].member[_e1045];
                                                    let _e1052 = (6u + _e460);
                                                    if (_e1052 < 9u) {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    let _e1058 = global_2.member[_e995].member[_e1052];
                                                    let _e1059 = (6u + _e466);
                                                    if (_e1059 < 9u) {
                                                    } else {
                                                        phi_4176_ = true;
                                                        break;
                                                    }
                                                    let _e1065 = global_2.member[_e995].member[_e1059];
                                                    phi_2065_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1009, _e1015, _e1021), array<f32, 3>(_e1029, _e1036, _e1043), array<f32, 3>(_e1051, _e1058, _e1065));
                                                }
                                                let _e1069 = phi_2065_;
                                                let _e1077 = (_e1069[0][2] - _e376);
                                                let _e1080 = (((_e1069[0][0] - _e299) * _e400) - (_e1077 * _e324));
                                                let _e1083 = (((_e1069[0][1] - _e338) * _e400) - (_e1077 * _e362));
                                                let _e1090 = (_e1069[1][2] - _e376);
                                                let _e1093 = (((_e1069[1][0] - _e299) * _e400) - (_e1090 * _e324));
                                                let _e1096 = (((_e1069[1][1] - _e338) * _e400) - (_e1090 * _e362));
                                                let _e1103 = (_e1069[2][2] - _e376);
                                                let _e1106 = (((_e1069[2][0] - _e299) * _e400) - (_e1103 * _e324));
                                                let _e1109 = (((_e1069[2][1] - _e338) * _e400) - (_e1103 * _e362));
                                                let _e1110 = (_e1106 * _e1096);
                                                let _e1111 = (_e1109 * _e1093);
                                                let _e1112 = (_e1080 * _e1109);
                                                let _e1113 = (_e1083 * _e1106);
                                                let _e1114 = (_e1093 * _e1083);
                                                let _e1115 = (_e1096 * _e1080);
                                                let _e1120 = (((_e1110 >= _e1111) && (_e1112 >= _e1113)) && (_e1114 >= _e1115));
                                                if (_e1120 || (((_e1110 <= _e1111) && (_e1112 <= _e1113)) && (_e1114 <= _e1115))) {
                                                    let _e1127 = select(-1f, 1f, _e1120);
                                                    let _e1129 = ((_e1110 - _e1111) * _e1127);
                                                    let _e1131 = select(0f, _e1129, (_e1129 > 0f));
                                                    let _e1133 = ((_e1112 - _e1113) * _e1127);
                                                    let _e1135 = select(0f, _e1133, (_e1133 > 0f));
                                                    let _e1137 = ((_e1114 - _e1115) * _e1127);
                                                    let _e1139 = select(0f, _e1137, (_e1137 > 0f));
                                                    let _e1141 = ((_e1131 + _e1135) + _e1139);
                                                    if (_e1141 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2631_ = type_27();
                                                        phi_2632_ = true;
                                                    } else {
                                                        let _e1144 = select(_e1069[1][0], _e1069[0][0], (_e1069[0][0] < _e1069[1][0]));
                                                        let _e1148 = select(_e1069[1][0], _e1069[0][0], (_e1069[0][0] > _e1069[1][0]));
                                                        let _e1152 = select(_e1069[1][1], _e1069[0][1], (_e1069[0][1] < _e1069[1][1]));
                                                        let _e1156 = select(_e1069[1][1], _e1069[0][1], (_e1069[0][1] > _e1069[1][1]));
                                                        let _e1160 = select(_e1069[1][2], _e1069[0][2], (_e1069[0][2] < _e1069[1][2]));
                                                        let _e1164 = select(_e1069[1][2], _e1069[0][2], (_e1069[0][2] > _e1069[1][2]));
                                                        let _e1169 = ((select(_e1069[2][0], _e1144, (_e1144 < _e1069[2][0])) - _e322) * _e327);
                                                        let _e1170 = ((select(_e1069[2][0], _e1148, (_e1148 > _e1069[2][0])) - _e323) * _e327);
                                                        let _e1173 = ((select(_e1069[2][1], _e1152, (_e1152 < _e1069[2][1])) - _e360) * _e365);
                                                        let _e1174 = ((select(_e1069[2][1], _e1156, (_e1156 > _e1069[2][1])) - _e361) * _e365);
                                                        let _e1177 = ((select(_e1069[2][2], _e1160, (_e1160 < _e1069[2][2])) - _e398) * _e403);
                                                        let _e1178 = ((select(_e1069[2][2], _e1164, (_e1164 > _e1069[2][2])) - _e399) * _e403);
                                                        let _e1180 = select(_e1178, _e1177, (_e1177 < _e1178));
                                                        let _e1182 = select(_e1178, _e1177, (_e1177 > _e1178));
                                                        let _e1184 = select(_e1170, _e1169, (_e1169 < _e1170));
                                                        let _e1186 = select(_e1174, _e1173, (_e1173 < _e1174));
                                                        let _e1188 = select(_e1186, _e1184, (_e1184 > _e1186));
                                                        let _e1190 = select(_e1180, _e1188, (_e1188 > _e1180));
                                                        let _e1192 = select(_e1170, _e1169, (_e1169 > _e1170));
                                                        let _e1194 = select(_e1174, _e1173, (_e1173 > _e1174));
                                                        let _e1196 = select(_e1194, _e1192, (_e1192 < _e1194));
                                                        let _e1198 = select(_e1182, _e1196, (_e1196 < _e1182));
                                                        let _e1199 = -(_e1180);
                                                        let _e1205 = select(_e450, _e1190, (_e1190 > _e450));
                                                        if (_e1205 > (_e1198 + (select(_e1199, _e1182, (_e1182 > _e1199)) * 0.0000019073523f))) {
                                                            phi_2626_ = type_27();
                                                            phi_2627_ = true;
                                                        } else {
                                                            let _e1207 = (_e1205 > _e973.member);
                                                            if _e1207 {
                                                                phi_2625_ = type_27();
                                                            } else {
                                                                let _e1211 = (_e1069[1][0] - _e1069[0][0]);
                                                                let _e1212 = (_e1069[1][1] - _e1069[0][1]);
                                                                let _e1213 = (_e1069[1][2] - _e1069[0][2]);
                                                                let _e1214 = vec3<f32>(_e1211, _e1212, _e1213);
                                                                let _e1215 = (_e1069[2][0] - _e1069[1][0]);
                                                                let _e1216 = (_e1069[2][1] - _e1069[1][1]);
                                                                let _e1217 = (_e1069[2][2] - _e1069[1][2]);
                                                                let _e1218 = vec3<f32>(_e1215, _e1216, _e1217);
                                                                let _e1219 = (_e1069[0][0] - _e1069[2][0]);
                                                                let _e1220 = (_e1069[0][1] - _e1069[2][1]);
                                                                let _e1221 = (_e1069[0][2] - _e1069[2][2]);
                                                                let _e1222 = vec3<f32>(_e1219, _e1220, _e1221);
                                                                let _e1225 = bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u));
                                                                let _e1228 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                let _e1230 = select(_e1228, _e1225, (_e1225 > _e1228));
                                                                let _e1233 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                let _e1235 = select(_e1233, _e1230, (_e1230 > _e1233));
                                                                let _e1238 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                let _e1241 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                let _e1243 = select(_e1241, _e1238, (_e1238 > _e1241));
                                                                let _e1246 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                let _e1248 = select(_e1246, _e1243, (_e1243 > _e1246));
                                                                let _e1251 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                let _e1254 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                let _e1256 = select(_e1254, _e1251, (_e1251 > _e1254));
                                                                let _e1259 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                let _e1261 = select(_e1259, _e1256, (_e1256 > _e1259));
                                                                let _e1263 = select(_e1248, _e1235, (_e1235 > _e1248));
                                                                let _e1265 = select(_e1261, _e1263, (_e1263 > _e1261));
                                                                if (_e1235 == _e1265) {
                                                                    phi_2536_ = _e1218;
                                                                    phi_2537_ = _e1222;
                                                                } else {
                                                                    let _e1268 = vec3((_e1248 == _e1265));
                                                                    phi_2536_ = select(_e1214, _e1222, _e1268);
                                                                    phi_2537_ = select(_e1218, _e1214, _e1268);
                                                                }
                                                                let _e1272 = phi_2536_;
                                                                let _e1274 = phi_2537_;
                                                                let _e1281 = ((_e1272.y * _e1274.z) - (_e1274.y * _e1272.z));
                                                                let _e1286 = ((_e1272.z * _e1274.x) - (_e1274.z * _e1272.x));
                                                                let _e1289 = ((_e1272.x * _e1274.y) - (_e1274.x * _e1272.y));
                                                                if (_e1131 >= _e1135) {
                                                                    phi_2568_ = select(true, false, (_e1131 >= _e1139));
                                                                } else {
                                                                    phi_2568_ = true;
                                                                }
                                                                let _e1294 = phi_2568_;
                                                                if _e1294 {
                                                                    phi_2577_ = select(vec3<f32>(_e1069[2][0], _e1069[2][1], _e1069[2][2]), vec3<f32>(_e1069[1][0], _e1069[1][1], _e1069[1][2]), vec3((_e1135 >= _e1139)));
                                                                } else {
                                                                    phi_2577_ = vec3<f32>(_e1069[0][0], _e1069[0][1], _e1069[0][2]);
                                                                }
                                                                let _e1299 = phi_2577_;
                                                                let _e1316 = ((((_e1281 * (_e1299.x - _e299)) + (_e1286 * (_e1299.y - _e338))) + (_e1289 * (_e1299.z - _e376))) / (((_e1281 * _e324) + (_e1286 * _e362)) + (_e1289 * _e400)));
                                                                let _e1318 = select(_e1198, _e1316, (_e1316 < _e1198));
                                                                let _e1320 = select(_e1190, _e1318, (_e1318 > _e1190));
                                                                if (_e1320 >= _e450) {
                                                                    let _e1322 = (_e1320 <= _e973.member);
                                                                    if _e1322 {
                                                                        let _e1323 = (1f / _e1141);
                                                                        phi_2617_ = type_27(_e1320, (_e1135 * _e1323), (_e1139 * _e1323), _e1002);
                                                                    } else {
                                                                        phi_2617_ = type_27();
                                                                    }
                                                                    let _e1328 = phi_2617_;
                                                                    phi_2619_ = _e1328;
                                                                    phi_2620_ = select(true, false, _e1322);
                                                                } else {
                                                                    phi_2619_ = type_27();
                                                                    phi_2620_ = true;
                                                                }
                                                                let _e1331 = phi_2619_;
                                                                let _e1333 = phi_2620_;
                                                                if _e1333 {
                                                                    phi_2624_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2624_ = _e1331;
                                                                }
                                                                let _e1335 = phi_2624_;
                                                                phi_2625_ = _e1335;
                                                            }
                                                            let _e1337 = phi_2625_;
                                                            phi_2626_ = _e1337;
                                                            phi_2627_ = _e1207;
                                                        }
                                                        let _e1339 = phi_2626_;
                                                        let _e1341 = phi_2627_;
                                                        phi_2631_ = _e1339;
                                                        phi_2632_ = _e1341;
                                                    }
                                                    let _e1343 = phi_2631_;
                                                    let _e1345 = phi_2632_;
                                                    phi_2636_ = _e1343;
                                                    phi_2637_ = _e1345;
                                                } else {
                                                    phi_2636_ = type_27();
                                                    phi_2637_ = true;
                                                }
                                                let _e1347 = phi_2636_;
                                                let _e1349 = phi_2637_;
                                                if _e1349 {
                                                    phi_2641_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2641_ = _e1347;
                                                }
                                                let _e1351 = phi_2641_;
                                                if (_e1351.member_3 != 4294967295u) {
                                                    if (_e1002 != 4294967295u) {
                                                        phi_2652_ = type_40(_e973.member, true);
                                                    } else {
                                                        phi_2652_ = _e973;
                                                    }
                                                    let _e1359 = phi_2652_;
                                                    phi_2653_ = _e1359;
                                                } else {
                                                    phi_2653_ = _e973;
                                                }
                                                let _e1361 = phi_2653_;
                                                phi_1930_ = _e1361;
                                            } else {
                                                phi_1930_ = type_40();
                                            }
                                            let _e1363 = phi_1930_;
                                            continue;
                                            continuing {
                                                phi_1929_ = _e1363;
                                                phi_1932_ = _e988;
                                                phi_4176_ = _e492;
                                                break if !(_e994);
                                            }
                                        }
                                        let _e1366 = phi_4176_;
                                        phi_4287_ = _e1366;
                                        if _e1366 {
                                            break;
                                        }
                                        let _e1368 = local_4;
                                        phi_4291_ = _e1366;
                                        let _e1515 = local_6;
                                        phi_3957_ = _e1515;
                                        phi_3958_ = _e523;
                                        phi_3959_ = false;
                                        phi_3960_ = select(_e527, 0u, _e1368.member_1);
                                    } else {
                                        if (_e523.member_1 >= _e80) {
                                            phi_3557_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e523.member_1 < _e80) {
                                            } else {
                                                phi_4287_ = true;
                                                break;
                                            }
                                            let _e539 = ((1u + _e250) % 4u);
                                            if (_e539 < 4u) {
                                            } else {
                                                phi_4287_ = true;
                                                break;
                                            }
                                            let _e544 = global_4.member[_e523.member_1][_e539];
                                            let _e546 = ((1u + _e249) % 4u);
                                            if (_e546 < 4u) {
                                            } else {
                                                phi_4287_ = true;
                                                break;
                                            }
                                            let _e551 = global_4.member[_e523.member_1][_e546];
                                            let _e553 = ((1u + _e251) % 4u);
                                            if (_e553 < 4u) {
                                            } else {
                                                phi_4287_ = true;
                                                break;
                                            }
                                            let _e558 = global_4.member[_e523.member_1][_e553];
                                            let _e560 = ((_e250 + 1u) % 4u);
                                            if (_e560 < 4u) {
                                            } else {
                                                phi_4287_ = true;
                                                break;
                                            }
                                            let _e565 = global_4.member[_e523.member_1][_e560];
                                            let _e567 = (_e565 >> bitcast<u32>(11u));
                                            let _e569 = ((_e249 + 1u) % 4u);
                                            if (_e569 < 4u) {
                                            } else {
                                                phi_4287_ = true;
                                                break;
                                            }
                                            let _e574 = global_4.member[_e523.member_1][_e569];
                                            let _e576 = (_e574 >> bitcast<u32>(11u));
                                            let _e578 = ((_e251 + 1u) % 4u);
                                            if (_e578 < 4u) {
                                            } else {
                                                phi_4287_ = true;
                                                break;
                                            }
                                            let _e583 = global_4.member[_e523.member_1][_e578];
                                            let _e585 = (_e583 >> bitcast<u32>(11u));
                                            let _e608 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.x - _e523.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e609 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.y - _e523.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e610 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.z - _e523.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e612 = select(_e130, _e608, (_e608 > _e130));
                                            let _e614 = select(_e130, _e609, (_e609 > _e130));
                                            let _e616 = select(_e130, _e610, (_e610 > _e130));
                                            let _e641 = bitcast<u32>((f32(bitcast<i32>((_e544 & 1023u))) * _e612));
                                            let _e646 = (bitcast<i32>((_e544 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e649 = bitcast<f32>((_e641 & bitcast<u32>(_e646)));
                                            let _e650 = bitcast<u32>((f32(bitcast<i32>((_e551 & 1023u))) * _e614));
                                            let _e655 = (bitcast<i32>((_e551 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e658 = bitcast<f32>((_e650 & bitcast<u32>(_e655)));
                                            let _e659 = bitcast<u32>((f32(bitcast<i32>((_e558 & 1023u))) * _e616));
                                            let _e664 = (bitcast<i32>((_e558 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e667 = bitcast<f32>((_e659 & bitcast<u32>(_e664)));
                                            let _e671 = bitcast<f32>((_e641 & bitcast<u32>(~(_e646))));
                                            let _e675 = bitcast<f32>((_e650 & bitcast<u32>(~(_e655))));
                                            let _e679 = bitcast<f32>((_e659 & bitcast<u32>(~(_e664))));
                                            let _e680 = bitcast<u32>((f32(bitcast<i32>((_e567 & 1023u))) * _e612));
                                            let _e685 = (bitcast<i32>((_e567 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e688 = bitcast<f32>((_e680 & bitcast<u32>(_e685)));
                                            let _e689 = bitcast<u32>((f32(bitcast<i32>((_e576 & 1023u))) * _e614));
                                            let _e694 = (bitcast<i32>((_e576 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e697 = bitcast<f32>((_e689 & bitcast<u32>(_e694)));
                                            let _e698 = bitcast<u32>((f32(bitcast<i32>((_e585 & 1023u))) * _e616));
                                            let _e703 = (bitcast<i32>((_e585 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e706 = bitcast<f32>((_e698 & bitcast<u32>(_e703)));
                                            let _e710 = bitcast<f32>((_e680 & bitcast<u32>(~(_e685))));
                                            let _e714 = bitcast<f32>((_e689 & bitcast<u32>(~(_e694))));
                                            let _e718 = bitcast<f32>((_e698 & bitcast<u32>(~(_e703))));
                                            let _e748 = global_4.member[_e523.member_1][0u];
                                            let _e752 = global_4.member[_e523.member_1][1u];
                                            let _e756 = global_4.member[_e523.member_1][2u];
                                            let _e760 = global_4.member[_e523.member_1][3u];
                                            let _e772 = (((_e752 >> bitcast<u32>(22i)) | ((_e756 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e760 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e773 = (_e748 & 268435455u);
                                            let _e774 = (_e772 & 268435455u);
                                            let _e777 = ((_e748 >> bitcast<u32>(28u)) & 7u);
                                            let _e785 = ((_e748 >> bitcast<u32>(31i)) | (((_e772 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e786 = (_e777 != 0u);
                                            if (_e777 == 0u) {
                                                phi_3519_ = _e773;
                                            } else {
                                                if (_e777 == 7u) {
                                                    phi_3518_ = 2147483648u;
                                                } else {
                                                    phi_3518_ = ((2147483648u | (_e777 << bitcast<u32>(28u))) | (_e774 & 268435455u));
                                                }
                                                let _e795 = phi_3518_;
                                                phi_3519_ = _e795;
                                            }
                                            let _e797 = phi_3519_;
                                            if _e786 {
                                                let _e798 = (_e777 != 7u);
                                                if _e798 {
                                                    phi_3529_ = (_e774 + _e777);
                                                } else {
                                                    phi_3529_ = u32();
                                                }
                                                let _e801 = phi_3529_;
                                                phi_3531_ = _e801;
                                                phi_3532_ = select(true, false, _e798);
                                            } else {
                                                phi_3531_ = u32();
                                                phi_3532_ = true;
                                            }
                                            let _e804 = phi_3531_;
                                            let _e806 = phi_3532_;
                                            if (_e785 == 0u) {
                                                phi_3553_ = (_e773 + select(0u, 1u, !(_e786)));
                                            } else {
                                                if (_e785 == 7u) {
                                                    phi_3552_ = 2147483648u;
                                                } else {
                                                    phi_3552_ = ((2147483648u | (_e785 << bitcast<u32>(28u))) | (select(_e804, _e774, _e806) & 268435455u));
                                                }
                                                let _e819 = phi_3552_;
                                                phi_3553_ = _e819;
                                            }
                                            let _e821 = phi_3553_;
                                            phi_3557_ = type_50(array<vec4<f32>, 3>(vec4<f32>((_e523.member.member.x + _e649), (_e523.member.member.x + _e671), (_e523.member.member_1.x - _e688), (_e523.member.member_1.x - _e710)), vec4<f32>((_e523.member.member.y + _e658), (_e523.member.member.y + _e675), (_e523.member.member_1.y - _e697), (_e523.member.member_1.y - _e714)), vec4<f32>((_e523.member.member.z + _e667), (_e523.member.member.z + _e679), (_e523.member.member_1.z - _e706), (_e523.member.member_1.z - _e718))), type_47(type_31((_e523.member.member + vec4<f32>(_e649, _e658, _e667, 0f)), (_e523.member.member_1 - vec4<f32>(_e688, _e697, _e706, 0f))), _e797), type_47(type_31((_e523.member.member + vec4<f32>(_e671, _e675, _e679, 0f)), (_e523.member.member_1 - vec4<f32>(_e710, _e714, _e718, 0f))), _e821));
                                        }
                                        let _e826 = phi_3557_;
                                        let _e838 = ((_e826.member[0].x - _e322) * _e327);
                                        let _e839 = ((_e826.member[0].y - _e322) * _e327);
                                        let _e840 = ((_e826.member[0].z - _e323) * _e327);
                                        let _e841 = ((_e826.member[0].w - _e323) * _e327);
                                        let _e851 = ((_e826.member[1].x - _e360) * _e365);
                                        let _e852 = ((_e826.member[1].y - _e360) * _e365);
                                        let _e853 = ((_e826.member[1].z - _e361) * _e365);
                                        let _e854 = ((_e826.member[1].w - _e361) * _e365);
                                        let _e864 = ((_e826.member[2].x - _e398) * _e403);
                                        let _e865 = ((_e826.member[2].y - _e398) * _e403);
                                        let _e866 = ((_e826.member[2].z - _e399) * _e403);
                                        let _e867 = ((_e826.member[2].w - _e399) * _e403);
                                        let _e869 = select(_e866, _e864, (_e864 < _e866));
                                        let _e871 = select(_e867, _e865, (_e865 < _e867));
                                        let _e873 = select(_e866, _e864, (_e864 > _e866));
                                        let _e875 = select(_e867, _e865, (_e865 > _e867));
                                        let _e877 = select(_e840, _e838, (_e838 < _e840));
                                        let _e879 = select(_e841, _e839, (_e839 < _e841));
                                        let _e881 = select(_e853, _e851, (_e851 < _e853));
                                        let _e883 = select(_e854, _e852, (_e852 < _e854));
                                        let _e885 = select(_e881, _e877, (_e877 > _e881));
                                        let _e887 = select(_e883, _e879, (_e879 > _e883));
                                        let _e889 = select(_e869, _e885, (_e885 > _e869));
                                        let _e891 = select(_e871, _e887, (_e887 > _e871));
                                        let _e893 = select(_e840, _e838, (_e838 > _e840));
                                        let _e895 = select(_e841, _e839, (_e839 > _e841));
                                        let _e897 = select(_e853, _e851, (_e851 > _e853));
                                        let _e899 = select(_e854, _e852, (_e852 > _e854));
                                        let _e901 = select(_e897, _e893, (_e893 < _e897));
                                        let _e903 = select(_e899, _e895, (_e895 < _e899));
                                        let _e908 = -(_e869);
                                        let _e909 = -(_e871);
                                        let _e916 = (select(_e873, _e901, (_e901 < _e873)) + (select(_e908, _e873, (_e873 > _e908)) * 0.0000019073523f));
                                        let _e917 = (select(_e875, _e903, (_e903 < _e875)) + (select(_e909, _e875, (_e875 > _e909)) * 0.0000019073523f));
                                        let _e919 = select(_e450, _e889, (_e889 > _e450));
                                        let _e921 = select(_e450, _e891, (_e891 > _e450));
                                        let _e926 = (_e919 <= select(_e494.member, _e916, (_e916 < _e494.member)));
                                        let _e927 = (_e921 <= select(_e494.member, _e917, (_e917 < _e494.member)));
                                        let _e928 = (_e919 <= _e921);
                                        if _e926 {
                                            if _e927 {
                                                if _e928 {
                                                    phi_3901_ = _e826.member_2;
                                                } else {
                                                    phi_3901_ = _e826.member_1;
                                                }
                                                let _e932 = phi_3901_;
                                                let _e933 = (_e527 % 128u);
                                                let _e934 = (_e933 < 128u);
                                                if _e934 {
                                                } else {
                                                    phi_4287_ = true;
                                                    break;
                                                }
                                                local_3[_e933] = type_47(type_31(_e932.member.member, _e932.member.member_1), _e932.member_1);
                                                if _e934 {
                                                } else {
                                                    phi_4287_ = true;
                                                    break;
                                                }
                                                local_2[_e933] = select(_e921, _e919, (_e919 > _e921));
                                                if _e928 {
                                                    phi_3934_ = _e826.member_1;
                                                } else {
                                                    phi_3934_ = _e826.member_2;
                                                }
                                                let _e949 = phi_3934_;
                                                phi_3935_ = _e949;
                                                phi_3936_ = (_e527 + 1u);
                                            } else {
                                                phi_3935_ = type_47();
                                                phi_3936_ = u32();
                                            }
                                            let _e951 = phi_3935_;
                                            let _e953 = phi_3936_;
                                            phi_3938_ = _e951;
                                            phi_3939_ = _e953;
                                            phi_3940_ = select(true, false, _e927);
                                        } else {
                                            phi_3938_ = type_47();
                                            phi_3939_ = u32();
                                            phi_3940_ = true;
                                        }
                                        let _e956 = phi_3938_;
                                        let _e958 = phi_3939_;
                                        let _e960 = phi_3940_;
                                        if _e960 {
                                            if _e926 {
                                                phi_3949_ = _e826.member_1;
                                            } else {
                                                phi_3949_ = _e826.member_2;
                                            }
                                            let _e964 = phi_3949_;
                                            phi_3954_ = _e964;
                                            phi_3955_ = select(_e927, true, _e926);
                                        } else {
                                            phi_3954_ = _e956;
                                            phi_3955_ = _e525;
                                        }
                                        let _e967 = phi_3954_;
                                        let _e969 = phi_3955_;
                                        phi_4291_ = _e492;
                                        phi_3957_ = _e494;
                                        phi_3958_ = _e967;
                                        phi_3959_ = _e969;
                                        phi_3960_ = select(_e958, _e527, _e960);
                                    }
                                    let _e1372 = phi_4291_;
                                    let _e1374 = phi_3957_;
                                    let _e1376 = phi_3958_;
                                    let _e1378 = phi_3959_;
                                    let _e1380 = phi_3960_;
                                    phi_4290_ = _e1372;
                                    phi_3961_ = _e1374;
                                    phi_3962_ = _e1376;
                                    phi_3963_ = (_e498 - 1u);
                                    phi_3964_ = _e1378;
                                    phi_3965_ = _e1380;
                                } else {
                                    phi_4290_ = _e492;
                                    phi_3961_ = _e494;
                                    phi_3962_ = _e523;
                                    phi_3963_ = _e498;
                                    phi_3964_ = _e525;
                                    phi_3965_ = _e527;
                                }
                                let _e1382 = phi_4290_;
                                let _e1384 = phi_3961_;
                                let _e1386 = phi_3962_;
                                let _e1388 = phi_3963_;
                                let _e1390 = phi_3964_;
                                let _e1392 = phi_3965_;
                                phi_4289_ = _e1382;
                                phi_3966_ = _e1384;
                                phi_3967_ = _e1386;
                                phi_3968_ = _e1388;
                                phi_3969_ = _e1390;
                                phi_3970_ = _e1392;
                            } else {
                                phi_4289_ = _e492;
                                phi_3966_ = type_40();
                                phi_3967_ = type_47();
                                phi_3968_ = u32();
                                phi_3969_ = bool();
                                phi_3970_ = u32();
                            }
                            let _e1394 = phi_4289_;
                            let _e1396 = phi_3966_;
                            let _e1398 = phi_3967_;
                            let _e1400 = phi_3968_;
                            let _e1402 = phi_3969_;
                            let _e1404 = phi_3970_;
                            phi_4288_ = _e1394;
                            phi_1853_ = _e1396;
                            phi_1856_ = _e1398;
                            phi_1858_ = _e1400;
                            phi_1860_ = _e1402;
                            phi_1862_ = _e1404;
                            phi_3971_ = _e506;
                        } else {
                            phi_4288_ = _e492;
                            phi_1853_ = type_40();
                            phi_1856_ = type_47();
                            phi_1858_ = u32();
                            phi_1860_ = bool();
                            phi_1862_ = u32();
                            phi_3971_ = false;
                        }
                        let _e1406 = phi_4288_;
                        let _e1408 = phi_1853_;
                        let _e1410 = phi_1856_;
                        let _e1412 = phi_1858_;
                        let _e1414 = phi_1860_;
                        let _e1416 = phi_1862_;
                        let _e1418 = phi_3971_;
                        continue;
                        continuing {
                            phi_4182_ = _e1406;
                            phi_1852_ = _e1408;
                            phi_1855_ = _e1410;
                            phi_1857_ = _e1412;
                            phi_1859_ = _e1414;
                            phi_1861_ = _e1416;
                            phi_4287_ = _e1406;
                            break if !(_e1418);
                        }
                    }
                    let _e1421 = phi_4287_;
                    if _e1421 {
                        break;
                    }
                    let _e1423 = local_5;
                    if _e138 {
                    } else {
                        break;
                    }
                    global_6.member[_e136] = select(0u, 1u, _e1423.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
