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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
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
    member: type_25,
    member_1: f32,
}

struct type_42 {
    member: array<type_29>,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: type_33,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_45;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_42;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_27;

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
    var phi_381_: i32;
    var phi_382_: i32;
    var phi_392_: bool;
    var phi_402_: u32;
    var phi_403_: u32;
    var phi_405_: bool;
    var phi_410_: u32;
    var phi_422_: i32;
    var phi_442_: i32;
    var phi_460_: f32;
    var phi_466_: f32;
    var phi_477_: f32;
    var phi_483_: f32;
    var phi_506_: f32;
    var phi_517_: f32;
    var phi_526_: f32;
    var phi_532_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_572_: f32;
    var phi_583_: f32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_638_: f32;
    var phi_649_: f32;
    var phi_749_: f32;
    var phi_750_: f32;
    var phi_3450_: bool;
    var phi_839_: type_37;
    var phi_842_: type_50;
    var phi_844_: u32;
    var phi_846_: bool;
    var phi_848_: u32;
    var phi_859_: bool;
    var phi_945_: type_50;
    var phi_946_: bool;
    var phi_947_: u32;
    var phi_2697_: u32;
    var phi_2698_: u32;
    var phi_2708_: u32;
    var phi_2710_: u32;
    var phi_2711_: bool;
    var phi_2731_: u32;
    var phi_2732_: u32;
    var phi_2736_: type_51;
    var phi_3080_: type_50;
    var phi_3157_: type_50;
    var phi_3158_: type_50;
    var phi_3159_: u32;
    var phi_3161_: type_50;
    var phi_3162_: u32;
    var phi_3163_: bool;
    var phi_3172_: type_50;
    var phi_3177_: type_50;
    var phi_3178_: bool;
    var phi_965_: type_37;
    var phi_968_: type_4;
    var phi_969_: type_4;
    var phi_991_: type_4;
    var phi_1012_: u32;
    var phi_1101_: array<array<f32, 3>, 3>;
    var phi_1218_: bool;
    var phi_1247_: bool;
    var phi_1648_: f32;
    var phi_1649_: f32;
    var phi_1650_: f32;
    var phi_1651_: f32;
    var phi_1652_: vec3<f32>;
    var phi_1653_: vec3<f32>;
    var phi_1654_: vec3<f32>;
    var phi_1655_: vec3<f32>;
    var phi_1686_: bool;
    var phi_1695_: vec3<f32>;
    var phi_1860_: f32;
    var phi_1862_: f32;
    var phi_1863_: bool;
    var phi_1883_: f32;
    var phi_1884_: f32;
    var phi_1907_: type_25;
    var phi_1909_: type_25;
    var phi_1910_: bool;
    var phi_1914_: type_25;
    var phi_1915_: type_25;
    var phi_1916_: type_25;
    var phi_1917_: bool;
    var phi_1921_: type_25;
    var phi_1922_: bool;
    var phi_1923_: type_25;
    var phi_1924_: bool;
    var phi_1925_: bool;
    var phi_1926_: type_25;
    var phi_1927_: bool;
    var phi_1928_: bool;
    var phi_1936_: type_25;
    var phi_1937_: bool;
    var phi_1941_: type_25;
    var phi_1966_: bool;
    var phi_1967_: bool;
    var phi_1973_: type_37;
    var phi_1974_: type_37;
    var phi_1975_: type_37;
    var phi_966_: type_37;
    var phi_3444_: bool;
    var phi_3590_: bool;
    var phi_3180_: type_37;
    var phi_3181_: type_50;
    var phi_3182_: bool;
    var phi_3183_: u32;
    var phi_3589_: bool;
    var phi_3184_: type_37;
    var phi_3185_: type_50;
    var phi_3186_: u32;
    var phi_3187_: bool;
    var phi_3188_: u32;
    var phi_3588_: bool;
    var phi_3189_: type_37;
    var phi_3190_: type_50;
    var phi_3191_: u32;
    var phi_3192_: bool;
    var phi_3193_: u32;
    var phi_3587_: bool;
    var phi_840_: type_37;
    var phi_843_: type_50;
    var phi_845_: u32;
    var phi_847_: bool;
    var phi_849_: u32;
    var phi_3194_: bool;
    var phi_3586_: bool;
    var local_10: type_37;
    var phi_3246_: type_25;
    var local_11: type_37;

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
                            phi_381_ = (bitcast<i32>((_e222 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_381_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e222)), 32u, (_e222 == 0u))));
                        }
                        let _e236 = phi_381_;
                        phi_382_ = _e236;
                    } else {
                        phi_382_ = 0i;
                    }
                    let _e238 = phi_382_;
                    let _e239 = (_e155 == _e194);
                    if _e239 {
                        phi_392_ = true;
                    } else {
                        phi_392_ = (_e162 == _e194);
                    }
                    let _e242 = phi_392_;
                    let _e243 = select(1u, 0u, _e239);
                    if _e242 {
                        let _e244 = (_e243 + 1u);
                        phi_402_ = _e244;
                        phi_403_ = _e244;
                        phi_405_ = select(true, false, (_e244 == 2u));
                    } else {
                        phi_402_ = u32();
                        phi_403_ = 0u;
                        phi_405_ = true;
                    }
                    let _e248 = phi_402_;
                    let _e250 = phi_403_;
                    let _e252 = phi_405_;
                    if _e252 {
                        phi_410_ = (_e250 + 1u);
                    } else {
                        phi_410_ = 0u;
                    }
                    let _e256 = phi_410_;
                    let _e257 = select(_e248, _e250, _e252);
                    let _e258 = select(_e243, select(2u, _e243, _e242), _e252);
                    if (_e125 < -126i) {
                        phi_422_ = -126i;
                    } else {
                        phi_422_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e263 = phi_422_;
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e125 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e275 = -(_e238);
                    if (_e275 < -126i) {
                        phi_442_ = -126i;
                    } else {
                        phi_442_ = select(_e275, 127i, (_e275 > 127i));
                    }
                    let _e280 = phi_442_;
                    let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
                    let _e291 = bitcast<f32>((bitcast<u32>(((_e275 - _e280) + 127i)) << bitcast<u32>(23i)));
                    let _e295 = global_5.member[_e143].member;
                    let _e296 = (_e257 == 0u);
                    if _e296 {
                        phi_460_ = _e295[0];
                    } else {
                        phi_460_ = _e295[1];
                    }
                    let _e300 = phi_460_;
                    let _e301 = (_e257 == 2u);
                    if _e301 {
                        phi_466_ = _e295[2];
                    } else {
                        phi_466_ = _e300;
                    }
                    let _e304 = phi_466_;
                    let _e306 = ((_e304 * _e268) * _e274);
                    let _e307 = global_5.member[_e143].member_2;
                    if _e296 {
                        phi_477_ = _e307[0];
                    } else {
                        phi_477_ = _e307[1];
                    }
                    let _e311 = phi_477_;
                    if _e301 {
                        phi_483_ = _e307[2];
                    } else {
                        phi_483_ = _e311;
                    }
                    let _e314 = phi_483_;
                    let _e316 = ((_e314 * _e285) * _e291);
                    let _e320 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e320 {
                        let _e324 = (bitcast<f32>((bitcast<u32>(_e306) & 2147483647u)) * 0.00000011920929f);
                        phi_506_ = select(0.00000000000011368684f, _e324, (_e324 > 0.00000000000011368684f));
                    } else {
                        phi_506_ = 0f;
                    }
                    let _e328 = phi_506_;
                    let _e329 = (_e306 + _e328);
                    let _e330 = (_e306 - _e328);
                    let _e331 = select(_e316, 0f, _e320);
                    if _e320 {
                        phi_517_ = 38685626000000000000000000f;
                    } else {
                        phi_517_ = (1f / _e316);
                    }
                    let _e334 = phi_517_;
                    let _e335 = (_e256 == 0u);
                    if _e335 {
                        phi_526_ = _e295[0];
                    } else {
                        phi_526_ = _e295[1];
                    }
                    let _e339 = phi_526_;
                    let _e340 = (_e256 == 2u);
                    if _e340 {
                        phi_532_ = _e295[2];
                    } else {
                        phi_532_ = _e339;
                    }
                    let _e343 = phi_532_;
                    let _e345 = ((_e343 * _e268) * _e274);
                    if _e335 {
                        phi_543_ = _e307[0];
                    } else {
                        phi_543_ = _e307[1];
                    }
                    let _e349 = phi_543_;
                    if _e340 {
                        phi_549_ = _e307[2];
                    } else {
                        phi_549_ = _e349;
                    }
                    let _e352 = phi_549_;
                    let _e354 = ((_e352 * _e285) * _e291);
                    let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e358 {
                        let _e362 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) * 0.00000011920929f);
                        phi_572_ = select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f));
                    } else {
                        phi_572_ = 0f;
                    }
                    let _e366 = phi_572_;
                    let _e367 = (_e345 + _e366);
                    let _e368 = (_e345 - _e366);
                    let _e369 = select(_e354, 0f, _e358);
                    if _e358 {
                        phi_583_ = 38685626000000000000000000f;
                    } else {
                        phi_583_ = (1f / _e354);
                    }
                    let _e372 = phi_583_;
                    let _e373 = (_e258 == 0u);
                    if _e373 {
                        phi_592_ = _e295[0];
                    } else {
                        phi_592_ = _e295[1];
                    }
                    let _e377 = phi_592_;
                    let _e378 = (_e258 == 2u);
                    if _e378 {
                        phi_598_ = _e295[2];
                    } else {
                        phi_598_ = _e377;
                    }
                    let _e381 = phi_598_;
                    let _e383 = ((_e381 * _e268) * _e274);
                    if _e373 {
                        phi_609_ = _e307[0];
                    } else {
                        phi_609_ = _e307[1];
                    }
                    let _e387 = phi_609_;
                    if _e378 {
                        phi_615_ = _e307[2];
                    } else {
                        phi_615_ = _e387;
                    }
                    let _e390 = phi_615_;
                    let _e392 = ((_e390 * _e285) * _e291);
                    let _e396 = (bitcast<f32>((bitcast<u32>(_e392) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e396 {
                        let _e400 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) * 0.00000011920929f);
                        phi_638_ = select(0.00000000000011368684f, _e400, (_e400 > 0.00000000000011368684f));
                    } else {
                        phi_638_ = 0f;
                    }
                    let _e404 = phi_638_;
                    let _e405 = (_e383 + _e404);
                    let _e406 = (_e383 - _e404);
                    let _e407 = select(_e392, 0f, _e396);
                    if _e396 {
                        phi_649_ = 38685626000000000000000000f;
                    } else {
                        phi_649_ = (1f / _e392);
                    }
                    let _e410 = phi_649_;
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
                        phi_749_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                        phi_750_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_749_ = 0f;
                        phi_750_ = 1f;
                    }
                    let _e455 = phi_749_;
                    let _e457 = phi_750_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e461 = (_e257 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_1[_e461];
                    let _e467 = (_e256 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_1[_e467];
                    let _e473 = (_e258 % 3u);
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
                    phi_3450_ = false;
                    phi_839_ = type_37(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e455);
                    phi_842_ = type_50(type_33(vec4<f32>((f32(_e464) * _e137), (f32(_e470) * _e137), (f32(_e476) * _e137), 0f), vec4<f32>((f32(_e481) * _e137), (f32(_e485) * _e137), (f32(_e489) * _e137), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_844_ = ((3u * _e87) + 1u);
                    phi_846_ = (_e457 <= _e455);
                    phi_848_ = 0u;
                    loop {
                        let _e499 = phi_3450_;
                        let _e501 = phi_839_;
                        let _e503 = phi_842_;
                        let _e505 = phi_844_;
                        let _e507 = phi_846_;
                        let _e509 = phi_848_;
                        local_10 = _e501;
                        if _e507 {
                            phi_859_ = true;
                        } else {
                            phi_859_ = (_e509 > 0u);
                        }
                        let _e512 = phi_859_;
                        if _e512 {
                            let _e513 = (_e505 > 0u);
                            if _e513 {
                                if _e507 {
                                    phi_945_ = _e503;
                                    phi_946_ = _e507;
                                    phi_947_ = _e509;
                                } else {
                                    let _e514 = (_e509 - 1u);
                                    let _e515 = (_e514 % 128u);
                                    let _e516 = (_e515 < 128u);
                                    if _e516 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e518 = local_7[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e520 = local_6[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e522 = local_5[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e524 = local_4[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e526 = local_3[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e528 = local_2[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e533 = local_8[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e536 = local_9[_e515];
                                    phi_945_ = type_50(type_33(vec4<f32>(_e518, _e520, _e522, 0f), vec4<f32>(_e524, _e526, _e528, 0f)), _e533);
                                    phi_946_ = (_e536 <= _e501.member_1);
                                    phi_947_ = _e514;
                                }
                                let _e540 = phi_945_;
                                let _e542 = phi_946_;
                                let _e544 = phi_947_;
                                if _e542 {
                                    if ((_e540.member_1 & 2147483648u) != 0u) {
                                        phi_965_ = _e501;
                                        phi_968_ = type_4(0u, ((_e540.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e988 = phi_965_;
                                            let _e990 = phi_968_;
                                            local_11 = _e988;
                                            if (_e990.member < _e990.member_1) {
                                                phi_969_ = type_4((_e990.member + 1u), _e990.member_1);
                                                phi_991_ = type_4(1u, _e990.member);
                                            } else {
                                                phi_969_ = _e990;
                                                phi_991_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1003 = phi_969_;
                                            let _e1005 = phi_991_;
                                            let _e1009 = (bitcast<i32>(_e1005.member) != 0i);
                                            if _e1009 {
                                                let _e1010 = ((_e540.member_1 & 268435455u) + _e1005.member_1);
                                                let _e1011 = (_e1010 < _e89);
                                                if _e1011 {
                                                    if _e1011 {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1015 = global_2.member[_e1010].member_1;
                                                    phi_1012_ = _e1015;
                                                } else {
                                                    phi_1012_ = 4294967295u;
                                                }
                                                let _e1017 = phi_1012_;
                                                if (_e1010 >= _e89) {
                                                    phi_1101_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1011 {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    if (_e461 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1024 = global_2.member[_e1010].member[_e461];
                                                    if (_e467 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1030 = global_2.member[_e1010].member[_e467];
                                                    if (_e473 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1036 = global_2.member[_e1010].member[_e473];
                                                    let _e1038 = (3u + _e461);
                                                    if (_e1038 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1044 = global_2.member[_e1010].member[_e1038];
                                                    let _e1045 = (3u + _e467);
                                                    if (_e1045 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1051 = global_2.member[_e1010].member[_e1045];
                                                    let _e1052 = (3u + _e473);
                                                    if (_e1052 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1058 = global_2.member[_e1010].member[_e1052];
                                                    let _e1060 = (6u + _e461);
                                                    if (_e1060 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1066 = global_2.member[_e1010].member[_e1060];
                                                    let _e1067 = (6u + _e467);
                                                    if (_e1067 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1073 = global_2.member[_e1010].member[_e1067];
                                                    let _e1074 = (6u + _e473);
                                                    if (_e1074 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_2.member[_e1010].member[_e1074];
                                                    phi_1101_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1024, _e1030, _e1036), array<f32, 3>(_e1044, _e1051, _e1058), array<f32, 3>(_e1066, _e1073, _e1080));
                                                }
                                                let _e1084 = phi_1101_;
                                                let _e1092 = (_e1084[0][2] - _e383);
                                                let _e1095 = (((_e1084[0][0] - _e306) * _e407) - (_e1092 * _e331));
                                                let _e1098 = (((_e1084[0][1] - _e345) * _e407) - (_e1092 * _e369));
                                                let _e1105 = (_e1084[1][2] - _e383);
                                                let _e1108 = (((_e1084[1][0] - _e306) * _e407) - (_e1105 * _e331));
                                                let _e1111 = (((_e1084[1][1] - _e345) * _e407) - (_e1105 * _e369));
                                                let _e1118 = (_e1084[2][2] - _e383);
                                                let _e1121 = (((_e1084[2][0] - _e306) * _e407) - (_e1118 * _e331));
                                                let _e1124 = (((_e1084[2][1] - _e345) * _e407) - (_e1118 * _e369));
                                                let _e1125 = (_e1121 * _e1111);
                                                let _e1126 = (_e1124 * _e1108);
                                                let _e1127 = (_e1095 * _e1124);
                                                let _e1128 = (_e1098 * _e1121);
                                                let _e1129 = (_e1108 * _e1098);
                                                let _e1130 = (_e1111 * _e1095);
                                                let _e1135 = (((_e1125 >= _e1126) && (_e1127 >= _e1128)) && (_e1129 >= _e1130));
                                                if (_e1135 || (((_e1125 <= _e1126) && (_e1127 <= _e1128)) && (_e1129 <= _e1130))) {
                                                    let _e1142 = select(-1f, 1f, _e1135);
                                                    let _e1144 = ((_e1125 - _e1126) * _e1142);
                                                    let _e1146 = select(0f, _e1144, (_e1144 > 0f));
                                                    let _e1148 = ((_e1127 - _e1128) * _e1142);
                                                    let _e1150 = select(0f, _e1148, (_e1148 > 0f));
                                                    let _e1152 = ((_e1129 - _e1130) * _e1142);
                                                    let _e1154 = select(0f, _e1152, (_e1152 > 0f));
                                                    let _e1156 = ((_e1146 + _e1150) + _e1154);
                                                    if (_e1156 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1926_ = type_25();
                                                        phi_1927_ = true;
                                                        phi_1928_ = false;
                                                    } else {
                                                        let _e1159 = select(_e1108, _e1095, (_e1095 < _e1108));
                                                        if (select(_e1121, _e1159, (_e1159 < _e1121)) > 0f) {
                                                            phi_1218_ = true;
                                                        } else {
                                                            let _e1164 = select(_e1108, _e1095, (_e1095 > _e1108));
                                                            phi_1218_ = (select(_e1121, _e1164, (_e1164 > _e1121)) < 0f);
                                                        }
                                                        let _e1169 = phi_1218_;
                                                        if _e1169 {
                                                            phi_1923_ = type_25();
                                                            phi_1924_ = true;
                                                            phi_1925_ = false;
                                                        } else {
                                                            let _e1171 = select(_e1111, _e1098, (_e1098 < _e1111));
                                                            if (select(_e1124, _e1171, (_e1171 < _e1124)) > 0f) {
                                                                phi_1247_ = true;
                                                            } else {
                                                                let _e1176 = select(_e1111, _e1098, (_e1098 > _e1111));
                                                                phi_1247_ = (select(_e1124, _e1176, (_e1176 > _e1124)) < 0f);
                                                            }
                                                            let _e1181 = phi_1247_;
                                                            if _e1181 {
                                                                phi_1921_ = type_25();
                                                                phi_1922_ = false;
                                                            } else {
                                                                let _e1183 = select(_e1084[1][0], _e1084[0][0], (_e1084[0][0] < _e1084[1][0]));
                                                                let _e1187 = select(_e1084[1][0], _e1084[0][0], (_e1084[0][0] > _e1084[1][0]));
                                                                let _e1191 = select(_e1084[1][1], _e1084[0][1], (_e1084[0][1] < _e1084[1][1]));
                                                                let _e1195 = select(_e1084[1][1], _e1084[0][1], (_e1084[0][1] > _e1084[1][1]));
                                                                let _e1199 = select(_e1084[1][2], _e1084[0][2], (_e1084[0][2] < _e1084[1][2]));
                                                                let _e1203 = select(_e1084[1][2], _e1084[0][2], (_e1084[0][2] > _e1084[1][2]));
                                                                let _e1208 = ((select(_e1084[2][0], _e1183, (_e1183 < _e1084[2][0])) - _e329) * _e334);
                                                                let _e1209 = ((select(_e1084[2][0], _e1187, (_e1187 > _e1084[2][0])) - _e330) * _e334);
                                                                let _e1212 = ((select(_e1084[2][1], _e1191, (_e1191 < _e1084[2][1])) - _e367) * _e372);
                                                                let _e1213 = ((select(_e1084[2][1], _e1195, (_e1195 > _e1084[2][1])) - _e368) * _e372);
                                                                let _e1216 = ((select(_e1084[2][2], _e1199, (_e1199 < _e1084[2][2])) - _e405) * _e410);
                                                                let _e1217 = ((select(_e1084[2][2], _e1203, (_e1203 > _e1084[2][2])) - _e406) * _e410);
                                                                let _e1219 = select(_e1217, _e1216, (_e1216 < _e1217));
                                                                let _e1221 = select(_e1217, _e1216, (_e1216 > _e1217));
                                                                let _e1223 = select(_e1209, _e1208, (_e1208 < _e1209));
                                                                let _e1225 = select(_e1213, _e1212, (_e1212 < _e1213));
                                                                let _e1227 = select(_e1225, _e1223, (_e1223 > _e1225));
                                                                let _e1229 = select(_e1219, _e1227, (_e1227 > _e1219));
                                                                let _e1231 = select(_e1209, _e1208, (_e1208 > _e1209));
                                                                let _e1233 = select(_e1213, _e1212, (_e1212 > _e1213));
                                                                let _e1235 = select(_e1233, _e1231, (_e1231 < _e1233));
                                                                let _e1237 = select(_e1221, _e1235, (_e1235 < _e1221));
                                                                let _e1238 = -(_e1219);
                                                                let _e1244 = select(_e457, _e1229, (_e1229 > _e457));
                                                                if (_e1244 > (_e1237 + (select(_e1238, _e1221, (_e1221 > _e1238)) * 0.0000019073523f))) {
                                                                    phi_1916_ = type_25();
                                                                    phi_1917_ = true;
                                                                } else {
                                                                    let _e1246 = (_e1244 > _e988.member_1);
                                                                    if _e1246 {
                                                                        phi_1915_ = type_25();
                                                                    } else {
                                                                        let _e1247 = vec3<f32>(_e1084[0][0], _e1084[0][1], _e1084[0][2]);
                                                                        let _e1248 = vec3<f32>(_e1084[1][0], _e1084[1][1], _e1084[1][2]);
                                                                        let _e1249 = vec3<f32>(_e1084[2][0], _e1084[2][1], _e1084[2][2]);
                                                                        let _e1250 = (_e1084[1][0] - _e1084[0][0]);
                                                                        let _e1251 = (_e1084[1][1] - _e1084[0][1]);
                                                                        let _e1252 = (_e1084[1][2] - _e1084[0][2]);
                                                                        let _e1253 = vec3<f32>(_e1250, _e1251, _e1252);
                                                                        let _e1254 = (_e1084[2][0] - _e1084[1][0]);
                                                                        let _e1255 = (_e1084[2][1] - _e1084[1][1]);
                                                                        let _e1256 = (_e1084[2][2] - _e1084[1][2]);
                                                                        let _e1257 = vec3<f32>(_e1254, _e1255, _e1256);
                                                                        let _e1258 = (_e1084[0][0] - _e1084[2][0]);
                                                                        let _e1259 = (_e1084[0][1] - _e1084[2][1]);
                                                                        let _e1260 = (_e1084[0][2] - _e1084[2][2]);
                                                                        let _e1261 = vec3<f32>(_e1258, _e1259, _e1260);
                                                                        let _e1264 = bitcast<f32>((bitcast<u32>(_e1250) & 2147483647u));
                                                                        let _e1267 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                                        let _e1269 = select(_e1267, _e1264, (_e1264 > _e1267));
                                                                        let _e1272 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
                                                                        let _e1274 = select(_e1272, _e1269, (_e1269 > _e1272));
                                                                        let _e1277 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                                        let _e1280 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
                                                                        let _e1282 = select(_e1280, _e1277, (_e1277 > _e1280));
                                                                        let _e1285 = bitcast<f32>((bitcast<u32>(_e1256) & 2147483647u));
                                                                        let _e1287 = select(_e1285, _e1282, (_e1282 > _e1285));
                                                                        let _e1290 = bitcast<f32>((bitcast<u32>(_e1258) & 2147483647u));
                                                                        let _e1293 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                                        let _e1295 = select(_e1293, _e1290, (_e1290 > _e1293));
                                                                        let _e1298 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                        let _e1300 = select(_e1298, _e1295, (_e1295 > _e1298));
                                                                        let _e1302 = select(_e1287, _e1274, (_e1274 > _e1287));
                                                                        let _e1304 = select(_e1300, _e1302, (_e1302 > _e1300));
                                                                        if (_e1274 == _e1304) {
                                                                            phi_1648_ = _e1111;
                                                                            phi_1649_ = _e1108;
                                                                            phi_1650_ = _e1098;
                                                                            phi_1651_ = _e1095;
                                                                            phi_1652_ = _e1247;
                                                                            phi_1653_ = _e1261;
                                                                            phi_1654_ = _e1257;
                                                                            phi_1655_ = _e1253;
                                                                        } else {
                                                                            let _e1306 = (_e1287 == _e1304);
                                                                            let _e1311 = vec3(_e1306);
                                                                            phi_1648_ = select(_e1098, _e1124, _e1306);
                                                                            phi_1649_ = select(_e1095, _e1121, _e1306);
                                                                            phi_1650_ = select(_e1124, _e1111, _e1306);
                                                                            phi_1651_ = select(_e1121, _e1108, _e1306);
                                                                            phi_1652_ = select(_e1249, _e1248, _e1311);
                                                                            phi_1653_ = select(_e1257, _e1253, _e1311);
                                                                            phi_1654_ = select(_e1253, _e1261, _e1311);
                                                                            phi_1655_ = select(_e1261, _e1257, _e1311);
                                                                        }
                                                                        let _e1317 = phi_1648_;
                                                                        let _e1319 = phi_1649_;
                                                                        let _e1321 = phi_1650_;
                                                                        let _e1323 = phi_1651_;
                                                                        let _e1325 = phi_1652_;
                                                                        let _e1327 = phi_1653_;
                                                                        let _e1329 = phi_1654_;
                                                                        let _e1331 = phi_1655_;
                                                                        let _e1338 = ((_e1329.y * _e1327.z) - (_e1327.y * _e1329.z));
                                                                        let _e1343 = ((_e1329.z * _e1327.x) - (_e1327.z * _e1329.x));
                                                                        let _e1346 = ((_e1329.x * _e1327.y) - (_e1327.x * _e1329.y));
                                                                        if (_e1146 >= _e1150) {
                                                                            phi_1686_ = select(true, false, (_e1146 >= _e1154));
                                                                        } else {
                                                                            phi_1686_ = true;
                                                                        }
                                                                        let _e1351 = phi_1686_;
                                                                        if _e1351 {
                                                                            phi_1695_ = select(_e1249, _e1248, vec3((_e1150 >= _e1154)));
                                                                        } else {
                                                                            phi_1695_ = _e1247;
                                                                        }
                                                                        let _e1356 = phi_1695_;
                                                                        let _e1367 = (((_e1338 * (_e1356.x - _e306)) + (_e1343 * (_e1356.y - _e345))) + (_e1346 * (_e1356.z - _e383)));
                                                                        let _e1372 = (((_e1338 * _e331) + (_e1343 * _e369)) + (_e1346 * _e407));
                                                                        let _e1373 = (_e1319 - _e1323);
                                                                        let _e1374 = (_e1317 - _e1321);
                                                                        let _e1382 = (-(((_e1323 * _e1373) + (_e1321 * _e1374))) / ((_e1373 * _e1373) + (_e1374 * _e1374)));
                                                                        let _e1384 = select(1f, _e1382, (_e1382 < 1f));
                                                                        let _e1386 = select(0f, _e1384, (_e1384 > 0f));
                                                                        let _e1399 = ((_e1325.x + (_e1331.x * _e1386)) - _e306);
                                                                        let _e1400 = ((_e1325.y + (_e1331.y * _e1386)) - _e345);
                                                                        let _e1401 = ((_e1325.z + (_e1331.z * _e1386)) - _e383);
                                                                        let _e1402 = (_e1401 / _e407);
                                                                        let _e1414 = bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u));
                                                                        let _e1417 = bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u));
                                                                        let _e1419 = select(_e1417, _e1414, (_e1414 > _e1417));
                                                                        let _e1422 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                                        let _e1424 = select(_e1422, _e1419, (_e1419 > _e1422));
                                                                        let _e1430 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                        let _e1433 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                        let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1338 * _e1399) + (_e1343 * _e1400)) + (_e1346 * _e1401)) - _e1367)) & 2147483647u)) <= ((0.0000009536743f * select(_e1304, _e1424, (_e1424 > _e1304))) * select(_e1438, _e1435, (_e1435 > _e1438)))) {
                                                                            let _e1448 = bitcast<f32>((bitcast<u32>(_e1329.x) & 2147483647u));
                                                                            let _e1451 = bitcast<f32>((bitcast<u32>(_e1329.y) & 2147483647u));
                                                                            let _e1453 = select(_e1451, _e1448, (_e1448 > _e1451));
                                                                            let _e1456 = bitcast<f32>((bitcast<u32>(_e1329.z) & 2147483647u));
                                                                            let _e1462 = bitcast<f32>((bitcast<u32>(_e1327.x) & 2147483647u));
                                                                            let _e1465 = bitcast<f32>((bitcast<u32>(_e1327.y) & 2147483647u));
                                                                            let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                            let _e1470 = bitcast<f32>((bitcast<u32>(_e1327.z) & 2147483647u));
                                                                            let _e1474 = (bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u)) > ((0.0000038146973f * select(_e1456, _e1453, (_e1453 > _e1456))) * select(_e1470, _e1467, (_e1467 > _e1470))));
                                                                            if _e1474 {
                                                                                phi_1860_ = (_e1367 / _e1372);
                                                                            } else {
                                                                                phi_1860_ = f32();
                                                                            }
                                                                            let _e1477 = phi_1860_;
                                                                            phi_1862_ = _e1477;
                                                                            phi_1863_ = select(true, false, _e1474);
                                                                        } else {
                                                                            phi_1862_ = f32();
                                                                            phi_1863_ = true;
                                                                        }
                                                                        let _e1480 = phi_1862_;
                                                                        let _e1482 = phi_1863_;
                                                                        if _e1482 {
                                                                            let _e1490 = (((_e1338 * (_e1399 - (_e331 * _e1402))) + (_e1343 * (_e1400 - (_e369 * _e1402)))) / _e1372);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u)) <= _e1304) {
                                                                                phi_1883_ = (_e1402 + _e1490);
                                                                            } else {
                                                                                phi_1883_ = _e1402;
                                                                            }
                                                                            let _e1497 = phi_1883_;
                                                                            phi_1884_ = _e1497;
                                                                        } else {
                                                                            phi_1884_ = _e1480;
                                                                        }
                                                                        let _e1499 = phi_1884_;
                                                                        let _e1501 = select(_e1237, _e1499, (_e1499 < _e1237));
                                                                        let _e1503 = select(_e1229, _e1501, (_e1501 > _e1229));
                                                                        if (_e1503 >= _e457) {
                                                                            let _e1505 = (_e1503 <= _e988.member_1);
                                                                            if _e1505 {
                                                                                let _e1506 = (1f / _e1156);
                                                                                phi_1907_ = type_25(_e1503, (_e1150 * _e1506), (_e1154 * _e1506), _e1017);
                                                                            } else {
                                                                                phi_1907_ = type_25();
                                                                            }
                                                                            let _e1511 = phi_1907_;
                                                                            phi_1909_ = _e1511;
                                                                            phi_1910_ = select(true, false, _e1505);
                                                                        } else {
                                                                            phi_1909_ = type_25();
                                                                            phi_1910_ = true;
                                                                        }
                                                                        let _e1514 = phi_1909_;
                                                                        let _e1516 = phi_1910_;
                                                                        if _e1516 {
                                                                            phi_1914_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1914_ = _e1514;
                                                                        }
                                                                        let _e1518 = phi_1914_;
                                                                        phi_1915_ = _e1518;
                                                                    }
                                                                    let _e1520 = phi_1915_;
                                                                    phi_1916_ = _e1520;
                                                                    phi_1917_ = _e1246;
                                                                }
                                                                let _e1522 = phi_1916_;
                                                                let _e1524 = phi_1917_;
                                                                phi_1921_ = _e1522;
                                                                phi_1922_ = _e1524;
                                                            }
                                                            let _e1526 = phi_1921_;
                                                            let _e1528 = phi_1922_;
                                                            phi_1923_ = _e1526;
                                                            phi_1924_ = _e1181;
                                                            phi_1925_ = _e1528;
                                                        }
                                                        let _e1530 = phi_1923_;
                                                        let _e1532 = phi_1924_;
                                                        let _e1534 = phi_1925_;
                                                        phi_1926_ = _e1530;
                                                        phi_1927_ = _e1532;
                                                        phi_1928_ = _e1534;
                                                    }
                                                    let _e1536 = phi_1926_;
                                                    let _e1538 = phi_1927_;
                                                    let _e1540 = phi_1928_;
                                                    phi_1936_ = _e1536;
                                                    phi_1937_ = select(_e1540, true, _e1538);
                                                } else {
                                                    phi_1936_ = type_25();
                                                    phi_1937_ = true;
                                                }
                                                let _e1543 = phi_1936_;
                                                let _e1545 = phi_1937_;
                                                if _e1545 {
                                                    phi_1941_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1941_ = _e1543;
                                                }
                                                let _e1547 = phi_1941_;
                                                if (_e1547.member_3 != 4294967295u) {
                                                    if (_e1017 != 4294967295u) {
                                                        if (_e1547.member < _e988.member.member) {
                                                            phi_1967_ = true;
                                                        } else {
                                                            if (_e1547.member == _e988.member.member) {
                                                                phi_1966_ = (_e1547.member_3 < _e988.member.member_3);
                                                            } else {
                                                                phi_1966_ = false;
                                                            }
                                                            let _e1560 = phi_1966_;
                                                            phi_1967_ = _e1560;
                                                        }
                                                        let _e1562 = phi_1967_;
                                                        if _e1562 {
                                                            phi_1973_ = type_37(_e1547, _e1547.member);
                                                        } else {
                                                            phi_1973_ = _e988;
                                                        }
                                                        let _e1565 = phi_1973_;
                                                        phi_1974_ = _e1565;
                                                    } else {
                                                        phi_1974_ = _e988;
                                                    }
                                                    let _e1567 = phi_1974_;
                                                    phi_1975_ = _e1567;
                                                } else {
                                                    phi_1975_ = _e988;
                                                }
                                                let _e1569 = phi_1975_;
                                                phi_966_ = _e1569;
                                            } else {
                                                phi_966_ = type_37();
                                            }
                                            let _e1571 = phi_966_;
                                            continue;
                                            continuing {
                                                phi_965_ = _e1571;
                                                phi_968_ = _e1003;
                                                phi_3444_ = _e499;
                                                break if !(_e1009);
                                            }
                                        }
                                        let _e1574 = phi_3444_;
                                        phi_3586_ = _e1574;
                                        if _e1574 {
                                            break;
                                        }
                                        phi_3590_ = _e1574;
                                        let _e1768 = local_11;
                                        phi_3180_ = _e1768;
                                        phi_3181_ = _e540;
                                        phi_3182_ = false;
                                        phi_3183_ = _e544;
                                    } else {
                                        if (_e540.member_1 >= _e87) {
                                            phi_2736_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e540.member_1 < _e87) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e556 = ((1u + _e257) % 4u);
                                            if (_e556 < 4u) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e561 = global_4.member[_e540.member_1][_e556];
                                            let _e563 = (_e561 >> bitcast<u32>(11u));
                                            let _e565 = ((1u + _e256) % 4u);
                                            if (_e565 < 4u) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e570 = global_4.member[_e540.member_1][_e565];
                                            let _e572 = (_e570 >> bitcast<u32>(11u));
                                            let _e574 = ((1u + _e258) % 4u);
                                            if (_e574 < 4u) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e579 = global_4.member[_e540.member_1][_e574];
                                            let _e581 = (_e579 >> bitcast<u32>(11u));
                                            let _e604 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.x - _e540.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e605 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.y - _e540.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e606 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.z - _e540.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e608 = select(_e137, _e604, (_e604 > _e137));
                                            let _e610 = select(_e137, _e605, (_e605 > _e137));
                                            let _e612 = select(_e137, _e606, (_e606 > _e137));
                                            let _e637 = bitcast<u32>((f32(bitcast<i32>((_e561 & 1023u))) * _e608));
                                            let _e642 = (bitcast<i32>((_e561 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e645 = bitcast<f32>((_e637 & bitcast<u32>(_e642)));
                                            let _e646 = bitcast<u32>((f32(bitcast<i32>((_e570 & 1023u))) * _e610));
                                            let _e651 = (bitcast<i32>((_e570 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e654 = bitcast<f32>((_e646 & bitcast<u32>(_e651)));
                                            let _e655 = bitcast<u32>((f32(bitcast<i32>((_e579 & 1023u))) * _e612));
                                            let _e660 = (bitcast<i32>((_e579 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e663 = bitcast<f32>((_e655 & bitcast<u32>(_e660)));
                                            let _e667 = bitcast<f32>((_e637 & bitcast<u32>(~(_e642))));
                                            let _e671 = bitcast<f32>((_e646 & bitcast<u32>(~(_e651))));
                                            let _e675 = bitcast<f32>((_e655 & bitcast<u32>(~(_e660))));
                                            let _e676 = bitcast<u32>((f32(bitcast<i32>((_e563 & 1023u))) * _e608));
                                            let _e681 = (bitcast<i32>((_e563 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e684 = bitcast<f32>((_e676 & bitcast<u32>(_e681)));
                                            let _e685 = bitcast<u32>((f32(bitcast<i32>((_e572 & 1023u))) * _e610));
                                            let _e690 = (bitcast<i32>((_e572 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e693 = bitcast<f32>((_e685 & bitcast<u32>(_e690)));
                                            let _e694 = bitcast<u32>((f32(bitcast<i32>((_e581 & 1023u))) * _e612));
                                            let _e699 = (bitcast<i32>((_e581 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e702 = bitcast<f32>((_e694 & bitcast<u32>(_e699)));
                                            let _e706 = bitcast<f32>((_e676 & bitcast<u32>(~(_e681))));
                                            let _e710 = bitcast<f32>((_e685 & bitcast<u32>(~(_e690))));
                                            let _e714 = bitcast<f32>((_e694 & bitcast<u32>(~(_e699))));
                                            let _e744 = global_4.member[_e540.member_1][0u];
                                            let _e748 = global_4.member[_e540.member_1][1u];
                                            let _e752 = global_4.member[_e540.member_1][2u];
                                            let _e756 = global_4.member[_e540.member_1][3u];
                                            let _e768 = (((_e748 >> bitcast<u32>(22i)) | ((_e752 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e756 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e769 = (_e744 & 268435455u);
                                            let _e770 = (_e768 & 268435455u);
                                            let _e773 = ((_e744 >> bitcast<u32>(28u)) & 7u);
                                            let _e781 = ((_e744 >> bitcast<u32>(31i)) | (((_e768 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e782 = (_e773 != 0u);
                                            if (_e773 == 0u) {
                                                phi_2698_ = _e769;
                                            } else {
                                                if (_e773 == 7u) {
                                                    phi_2697_ = 2147483648u;
                                                } else {
                                                    phi_2697_ = ((2147483648u | (_e773 << bitcast<u32>(28u))) | (_e770 & 268435455u));
                                                }
                                                let _e791 = phi_2697_;
                                                phi_2698_ = _e791;
                                            }
                                            let _e793 = phi_2698_;
                                            if _e782 {
                                                let _e794 = (_e773 != 7u);
                                                if _e794 {
                                                    phi_2708_ = (_e770 + _e773);
                                                } else {
                                                    phi_2708_ = u32();
                                                }
                                                let _e797 = phi_2708_;
                                                phi_2710_ = _e797;
                                                phi_2711_ = select(true, false, _e794);
                                            } else {
                                                phi_2710_ = u32();
                                                phi_2711_ = true;
                                            }
                                            let _e800 = phi_2710_;
                                            let _e802 = phi_2711_;
                                            if (_e781 == 0u) {
                                                phi_2732_ = (_e769 + select(0u, 1u, !(_e782)));
                                            } else {
                                                if (_e781 == 7u) {
                                                    phi_2731_ = 2147483648u;
                                                } else {
                                                    phi_2731_ = ((2147483648u | (_e781 << bitcast<u32>(28u))) | (select(_e800, _e770, _e802) & 268435455u));
                                                }
                                                let _e815 = phi_2731_;
                                                phi_2732_ = _e815;
                                            }
                                            let _e817 = phi_2732_;
                                            phi_2736_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e540.member.member.x + _e645), (_e540.member.member.x + _e667), (_e540.member.member_1.x - _e684), (_e540.member.member_1.x - _e706)), vec4<f32>((_e540.member.member.y + _e654), (_e540.member.member.y + _e671), (_e540.member.member_1.y - _e693), (_e540.member.member_1.y - _e710)), vec4<f32>((_e540.member.member.z + _e663), (_e540.member.member.z + _e675), (_e540.member.member_1.z - _e702), (_e540.member.member_1.z - _e714))), type_50(type_33((_e540.member.member + vec4<f32>(_e645, _e654, _e663, 0f)), (_e540.member.member_1 - vec4<f32>(_e684, _e693, _e702, 0f))), _e793), type_50(type_33((_e540.member.member + vec4<f32>(_e667, _e671, _e675, 0f)), (_e540.member.member_1 - vec4<f32>(_e706, _e710, _e714, 0f))), _e817));
                                        }
                                        let _e822 = phi_2736_;
                                        let _e834 = ((_e822.member[0].x - _e329) * _e334);
                                        let _e835 = ((_e822.member[0].y - _e329) * _e334);
                                        let _e836 = ((_e822.member[0].z - _e330) * _e334);
                                        let _e837 = ((_e822.member[0].w - _e330) * _e334);
                                        let _e847 = ((_e822.member[1].x - _e367) * _e372);
                                        let _e848 = ((_e822.member[1].y - _e367) * _e372);
                                        let _e849 = ((_e822.member[1].z - _e368) * _e372);
                                        let _e850 = ((_e822.member[1].w - _e368) * _e372);
                                        let _e860 = ((_e822.member[2].x - _e405) * _e410);
                                        let _e861 = ((_e822.member[2].y - _e405) * _e410);
                                        let _e862 = ((_e822.member[2].z - _e406) * _e410);
                                        let _e863 = ((_e822.member[2].w - _e406) * _e410);
                                        let _e865 = select(_e862, _e860, (_e860 < _e862));
                                        let _e867 = select(_e863, _e861, (_e861 < _e863));
                                        let _e869 = select(_e862, _e860, (_e860 > _e862));
                                        let _e871 = select(_e863, _e861, (_e861 > _e863));
                                        let _e873 = select(_e836, _e834, (_e834 < _e836));
                                        let _e875 = select(_e837, _e835, (_e835 < _e837));
                                        let _e877 = select(_e849, _e847, (_e847 < _e849));
                                        let _e879 = select(_e850, _e848, (_e848 < _e850));
                                        let _e881 = select(_e877, _e873, (_e873 > _e877));
                                        let _e883 = select(_e879, _e875, (_e875 > _e879));
                                        let _e885 = select(_e865, _e881, (_e881 > _e865));
                                        let _e887 = select(_e867, _e883, (_e883 > _e867));
                                        let _e889 = select(_e836, _e834, (_e834 > _e836));
                                        let _e891 = select(_e837, _e835, (_e835 > _e837));
                                        let _e893 = select(_e849, _e847, (_e847 > _e849));
                                        let _e895 = select(_e850, _e848, (_e848 > _e850));
                                        let _e897 = select(_e893, _e889, (_e889 < _e893));
                                        let _e899 = select(_e895, _e891, (_e891 < _e895));
                                        let _e904 = -(_e865);
                                        let _e905 = -(_e867);
                                        let _e912 = (select(_e869, _e897, (_e897 < _e869)) + (select(_e904, _e869, (_e869 > _e904)) * 0.0000019073523f));
                                        let _e913 = (select(_e871, _e899, (_e899 < _e871)) + (select(_e905, _e871, (_e871 > _e905)) * 0.0000019073523f));
                                        let _e915 = select(_e457, _e885, (_e885 > _e457));
                                        let _e917 = select(_e457, _e887, (_e887 > _e457));
                                        let _e922 = (_e915 <= select(_e501.member_1, _e912, (_e912 < _e501.member_1)));
                                        let _e923 = (_e917 <= select(_e501.member_1, _e913, (_e913 < _e501.member_1)));
                                        let _e924 = (_e915 <= _e917);
                                        if _e922 {
                                            if _e923 {
                                                if _e924 {
                                                    phi_3080_ = _e822.member_2;
                                                } else {
                                                    phi_3080_ = _e822.member_1;
                                                }
                                                let _e928 = phi_3080_;
                                                let _e950 = (_e544 % 128u);
                                                let _e951 = (_e950 < 128u);
                                                if _e951 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_8[_e950] = _e928.member_1;
                                                if _e951 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_7[_e950] = _e928.member.member.x;
                                                if _e951 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_6[_e950] = _e928.member.member.y;
                                                if _e951 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_5[_e950] = _e928.member.member.z;
                                                if _e951 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_4[_e950] = _e928.member.member_1.x;
                                                if _e951 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_3[_e950] = _e928.member.member_1.y;
                                                if _e951 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_2[_e950] = _e928.member.member_1.z;
                                                if _e951 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_9[_e950] = select(_e917, _e915, (_e915 > _e917));
                                                if _e924 {
                                                    phi_3157_ = _e822.member_1;
                                                } else {
                                                    phi_3157_ = _e822.member_2;
                                                }
                                                let _e964 = phi_3157_;
                                                phi_3158_ = _e964;
                                                phi_3159_ = (_e544 + 1u);
                                            } else {
                                                phi_3158_ = type_50();
                                                phi_3159_ = u32();
                                            }
                                            let _e966 = phi_3158_;
                                            let _e968 = phi_3159_;
                                            phi_3161_ = _e966;
                                            phi_3162_ = _e968;
                                            phi_3163_ = select(true, false, _e923);
                                        } else {
                                            phi_3161_ = type_50();
                                            phi_3162_ = u32();
                                            phi_3163_ = true;
                                        }
                                        let _e971 = phi_3161_;
                                        let _e973 = phi_3162_;
                                        let _e975 = phi_3163_;
                                        if _e975 {
                                            if _e922 {
                                                phi_3172_ = _e822.member_1;
                                            } else {
                                                phi_3172_ = _e822.member_2;
                                            }
                                            let _e979 = phi_3172_;
                                            phi_3177_ = _e979;
                                            phi_3178_ = select(_e923, true, _e922);
                                        } else {
                                            phi_3177_ = _e971;
                                            phi_3178_ = _e542;
                                        }
                                        let _e982 = phi_3177_;
                                        let _e984 = phi_3178_;
                                        phi_3590_ = _e499;
                                        phi_3180_ = _e501;
                                        phi_3181_ = _e982;
                                        phi_3182_ = _e984;
                                        phi_3183_ = select(_e973, _e544, _e975);
                                    }
                                    let _e1576 = phi_3590_;
                                    let _e1578 = phi_3180_;
                                    let _e1580 = phi_3181_;
                                    let _e1582 = phi_3182_;
                                    let _e1584 = phi_3183_;
                                    phi_3589_ = _e1576;
                                    phi_3184_ = _e1578;
                                    phi_3185_ = _e1580;
                                    phi_3186_ = (_e505 - 1u);
                                    phi_3187_ = _e1582;
                                    phi_3188_ = _e1584;
                                } else {
                                    phi_3589_ = _e499;
                                    phi_3184_ = _e501;
                                    phi_3185_ = _e540;
                                    phi_3186_ = _e505;
                                    phi_3187_ = _e542;
                                    phi_3188_ = _e544;
                                }
                                let _e1586 = phi_3589_;
                                let _e1588 = phi_3184_;
                                let _e1590 = phi_3185_;
                                let _e1592 = phi_3186_;
                                let _e1594 = phi_3187_;
                                let _e1596 = phi_3188_;
                                phi_3588_ = _e1586;
                                phi_3189_ = _e1588;
                                phi_3190_ = _e1590;
                                phi_3191_ = _e1592;
                                phi_3192_ = _e1594;
                                phi_3193_ = _e1596;
                            } else {
                                phi_3588_ = _e499;
                                phi_3189_ = type_37();
                                phi_3190_ = type_50();
                                phi_3191_ = u32();
                                phi_3192_ = bool();
                                phi_3193_ = u32();
                            }
                            let _e1598 = phi_3588_;
                            let _e1600 = phi_3189_;
                            let _e1602 = phi_3190_;
                            let _e1604 = phi_3191_;
                            let _e1606 = phi_3192_;
                            let _e1608 = phi_3193_;
                            phi_3587_ = _e1598;
                            phi_840_ = _e1600;
                            phi_843_ = _e1602;
                            phi_845_ = _e1604;
                            phi_847_ = _e1606;
                            phi_849_ = _e1608;
                            phi_3194_ = _e513;
                        } else {
                            phi_3587_ = _e499;
                            phi_840_ = type_37();
                            phi_843_ = type_50();
                            phi_845_ = u32();
                            phi_847_ = bool();
                            phi_849_ = u32();
                            phi_3194_ = false;
                        }
                        let _e1610 = phi_3587_;
                        let _e1612 = phi_840_;
                        let _e1614 = phi_843_;
                        let _e1616 = phi_845_;
                        let _e1618 = phi_847_;
                        let _e1620 = phi_849_;
                        let _e1622 = phi_3194_;
                        continue;
                        continuing {
                            phi_3450_ = _e1610;
                            phi_839_ = _e1612;
                            phi_842_ = _e1614;
                            phi_844_ = _e1616;
                            phi_846_ = _e1618;
                            phi_848_ = _e1620;
                            phi_3586_ = _e1610;
                            break if !(_e1622);
                        }
                    }
                    let _e1625 = phi_3586_;
                    if _e1625 {
                        break;
                    }
                    let _e1627 = local_10;
                    if (_e1627.member.member_3 != 4294967295u) {
                        let _e1632 = -(_e424);
                        let _e1633 = (_e1632 / 3i);
                        let _e1640 = bitcast<f32>((bitcast<u32>((_e1633 + 127i)) << bitcast<u32>(23i)));
                        let _e1648 = (((_e1627.member.member * _e1640) * _e1640) * bitcast<f32>((bitcast<u32>(((_e1632 - (2i * _e1633)) + 127i)) << bitcast<u32>(23i))));
                        let _e1650 = select(340282350000000000000000000000000000000f, _e1648, (_e1648 < 340282350000000000000000000000000000000f));
                        phi_3246_ = type_25(select(-340282350000000000000000000000000000000f, _e1650, (_e1650 > -340282350000000000000000000000000000000f)), _e1627.member.member_1, _e1627.member.member_2, _e1627.member.member_3);
                    } else {
                        phi_3246_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1657 = phi_3246_;
                    if _e145 {
                    } else {
                        break;
                    }
                    global_6.member[_e143] = _e1657;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
