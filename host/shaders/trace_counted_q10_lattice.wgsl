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

struct type_16 {
    member: vec4<u32>,
}

struct type_24 {
    member: array<array<u32, 2>>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_37 {
    member: type_28,
    member_1: f32,
}

struct type_41 {
    member: array<type_29>,
}

struct type_43 {
    member: type_37,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_54 {
    member: type_32,
    member_1: u32,
}

struct type_55 {
    member: array<vec4<f32>, 3>,
    member_1: type_54,
    member_2: type_54,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_45;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_41;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

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
    var phi_402_: i32;
    var phi_403_: i32;
    var phi_413_: bool;
    var phi_423_: u32;
    var phi_424_: u32;
    var phi_426_: bool;
    var phi_431_: u32;
    var phi_444_: i32;
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
    var phi_3451_: bool;
    var phi_862_: type_43;
    var phi_865_: type_54;
    var phi_867_: u32;
    var phi_869_: bool;
    var phi_871_: u32;
    var phi_882_: bool;
    var phi_968_: type_54;
    var phi_969_: bool;
    var phi_970_: u32;
    var phi_2459_: u32;
    var phi_2465_: u32;
    var phi_2719_: u32;
    var phi_2720_: u32;
    var phi_2730_: u32;
    var phi_2732_: u32;
    var phi_2733_: bool;
    var phi_2753_: u32;
    var phi_2754_: u32;
    var phi_2758_: type_55;
    var phi_3102_: type_54;
    var phi_3179_: type_54;
    var phi_3180_: type_54;
    var phi_3181_: u32;
    var phi_3183_: type_54;
    var phi_3184_: u32;
    var phi_3185_: bool;
    var phi_3194_: type_54;
    var phi_3199_: type_54;
    var phi_3200_: bool;
    var phi_3448_: bool;
    var phi_989_: type_43;
    var phi_992_: type_8;
    var phi_993_: type_8;
    var phi_1015_: type_8;
    var phi_1059_: u32;
    var phi_1065_: u32;
    var phi_1075_: u32;
    var phi_1091_: u32;
    var phi_1128_: u32;
    var phi_1134_: u32;
    var phi_1144_: u32;
    var phi_3433_: bool;
    var phi_1160_: type_8;
    var phi_1161_: type_8;
    var phi_1184_: type_8;
    var phi_1207_: u32;
    var phi_1222_: u32;
    var phi_1225_: type_8;
    var phi_1226_: type_8;
    var phi_1249_: type_8;
    var phi_1315_: u32;
    var phi_1295_: u32;
    var phi_1296_: u32;
    var phi_1319_: f32;
    var phi_3426_: bool;
    var phi_3505_: bool;
    var phi_3504_: bool;
    var phi_1819_: vec3<f32>;
    var phi_1820_: vec3<f32>;
    var phi_1851_: bool;
    var phi_1860_: vec3<f32>;
    var phi_1900_: type_28;
    var phi_1902_: type_28;
    var phi_1903_: bool;
    var phi_1907_: type_28;
    var phi_1908_: type_28;
    var phi_1909_: type_28;
    var phi_1910_: bool;
    var phi_1914_: type_28;
    var phi_1915_: bool;
    var phi_1919_: type_28;
    var phi_1920_: bool;
    var phi_1924_: type_28;
    var phi_1949_: bool;
    var phi_1950_: bool;
    var phi_1957_: type_43;
    var phi_1958_: type_43;
    var phi_1959_: type_43;
    var phi_3507_: bool;
    var phi_990_: type_43;
    var phi_3506_: bool;
    var phi_3569_: bool;
    var phi_3202_: type_43;
    var phi_3203_: type_54;
    var phi_3204_: bool;
    var phi_3205_: u32;
    var phi_3568_: bool;
    var phi_3206_: type_43;
    var phi_3207_: type_54;
    var phi_3208_: u32;
    var phi_3209_: bool;
    var phi_3210_: u32;
    var phi_3567_: bool;
    var phi_3211_: type_43;
    var phi_3212_: type_54;
    var phi_3213_: u32;
    var phi_3214_: bool;
    var phi_3215_: u32;
    var phi_3566_: bool;
    var phi_863_: type_43;
    var phi_866_: type_54;
    var phi_868_: u32;
    var phi_870_: bool;
    var phi_872_: u32;
    var phi_3216_: bool;
    var phi_3565_: bool;
    var local_13: type_43;
    var local_14: type_43;
    var local_15: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e93 = arrayLength((&global_3.member));
            let _e96 = arrayLength((&global_5.member));
            let _e104 = global_2.member[0u][0u];
            let _e108 = global_2.member[0u][1u];
            let _e112 = global_2.member[0u][2u];
            let _e116 = global_2.member[0u][3u];
            let _e120 = global_2.member[1u][0u];
            let _e124 = global_2.member[1u][1u];
            let _e128 = global_2.member[1u][2u];
            let _e131 = global_1.member[0u];
            let _e132 = bitcast<i32>(_e131);
            let _e144 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e116) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e104), bitcast<i32>(_e108), bitcast<i32>(_e112));
            local = array<i32, 3>(bitcast<i32>(_e120), bitcast<i32>(_e124), bitcast<i32>(_e128));
            let _e150 = (_e91.x + (_e91.y * 2097152u));
            let _e151 = (_e150 < arrayLength((&global_4.member)));
            if _e151 {
                let _e152 = (_e150 < arrayLength((&global_6.member)));
                if _e152 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e160 = global_4.member[_e150].member_2[0u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_4.member[_e150].member_2[1u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_4.member[_e150].member_2[2u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_4.member[_e150].member[0u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_4.member[_e150].member[1u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e195 = global_4.member[_e150].member[2u];
                    let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                    let _e199 = select(_e169, _e162, (_e169 < _e162));
                    let _e201 = select(_e176, _e199, (_e176 < _e199));
                    let _e203 = select(_e183, _e201, (_e183 < _e201));
                    let _e205 = select(_e190, _e203, (_e190 < _e203));
                    let _e207 = select(_e197, _e205, (_e197 < _e205));
                    let _e211 = global_4.member[_e150].member_1;
                    let _e213 = (bitcast<u32>(_e211) & 2147483647u);
                    let _e220 = global_4.member[_e150].member_3;
                    let _e226 = (((select(_e213, _e207, (_e213 < _e207)) < 2139095040u) && ((bitcast<u32>(_e220) & 2147483647u) <= 2139095040u)) && (_e201 > 0u));
                    if _e226 {
                        let _e229 = (bitcast<u32>(bitcast<f32>(_e201)) & 2147483647u);
                        if (_e229 >= 8388608u) {
                            phi_402_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_402_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_402_;
                        phi_403_ = _e243;
                    } else {
                        phi_403_ = 0i;
                    }
                    let _e245 = phi_403_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_413_ = true;
                    } else {
                        phi_413_ = (_e169 == _e201);
                    }
                    let _e249 = phi_413_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_423_ = _e251;
                        phi_424_ = _e251;
                        phi_426_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_423_ = u32();
                        phi_424_ = 0u;
                        phi_426_ = true;
                    }
                    let _e255 = phi_423_;
                    let _e257 = phi_424_;
                    let _e259 = phi_426_;
                    if _e259 {
                        phi_431_ = (_e257 + 1u);
                    } else {
                        phi_431_ = 0u;
                    }
                    let _e263 = phi_431_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_444_ = -126i;
                    } else {
                        phi_444_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_444_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_464_ = -126i;
                    } else {
                        phi_464_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_464_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_4.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_482_ = _e302[0];
                    } else {
                        phi_482_ = _e302[1];
                    }
                    let _e307 = phi_482_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_488_ = _e302[2];
                    } else {
                        phi_488_ = _e307;
                    }
                    let _e311 = phi_488_;
                    let _e313 = ((_e311 * _e275) * _e281);
                    let _e314 = global_4.member[_e150].member_2;
                    if _e303 {
                        phi_499_ = _e314[0];
                    } else {
                        phi_499_ = _e314[1];
                    }
                    let _e318 = phi_499_;
                    if _e308 {
                        phi_505_ = _e314[2];
                    } else {
                        phi_505_ = _e318;
                    }
                    let _e321 = phi_505_;
                    let _e323 = ((_e321 * _e292) * _e298);
                    let _e327 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e327 {
                        let _e331 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) * 0.00000011920929f);
                        phi_528_ = select(0.00000000000011368684f, _e331, (_e331 > 0.00000000000011368684f));
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e335 = phi_528_;
                    let _e336 = (_e313 + _e335);
                    let _e337 = (_e313 - _e335);
                    let _e338 = select(_e323, 0f, _e327);
                    if _e327 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e323);
                    }
                    let _e341 = phi_539_;
                    let _e342 = (_e263 == 0u);
                    if _e342 {
                        phi_548_ = _e302[0];
                    } else {
                        phi_548_ = _e302[1];
                    }
                    let _e346 = phi_548_;
                    let _e347 = (_e263 == 2u);
                    if _e347 {
                        phi_554_ = _e302[2];
                    } else {
                        phi_554_ = _e346;
                    }
                    let _e350 = phi_554_;
                    let _e352 = ((_e350 * _e275) * _e281);
                    if _e342 {
                        phi_565_ = _e314[0];
                    } else {
                        phi_565_ = _e314[1];
                    }
                    let _e356 = phi_565_;
                    if _e347 {
                        phi_571_ = _e314[2];
                    } else {
                        phi_571_ = _e356;
                    }
                    let _e359 = phi_571_;
                    let _e361 = ((_e359 * _e292) * _e298);
                    let _e365 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e365 {
                        let _e369 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) * 0.00000011920929f);
                        phi_594_ = select(0.00000000000011368684f, _e369, (_e369 > 0.00000000000011368684f));
                    } else {
                        phi_594_ = 0f;
                    }
                    let _e373 = phi_594_;
                    let _e374 = (_e352 + _e373);
                    let _e375 = (_e352 - _e373);
                    let _e376 = select(_e361, 0f, _e365);
                    if _e365 {
                        phi_605_ = 38685626000000000000000000f;
                    } else {
                        phi_605_ = (1f / _e361);
                    }
                    let _e379 = phi_605_;
                    let _e380 = (_e265 == 0u);
                    if _e380 {
                        phi_614_ = _e302[0];
                    } else {
                        phi_614_ = _e302[1];
                    }
                    let _e384 = phi_614_;
                    let _e385 = (_e265 == 2u);
                    if _e385 {
                        phi_620_ = _e302[2];
                    } else {
                        phi_620_ = _e384;
                    }
                    let _e388 = phi_620_;
                    let _e390 = ((_e388 * _e275) * _e281);
                    if _e380 {
                        phi_631_ = _e314[0];
                    } else {
                        phi_631_ = _e314[1];
                    }
                    let _e394 = phi_631_;
                    if _e385 {
                        phi_637_ = _e314[2];
                    } else {
                        phi_637_ = _e394;
                    }
                    let _e397 = phi_637_;
                    let _e399 = ((_e397 * _e292) * _e298);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e403 {
                        let _e407 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                        phi_660_ = select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f));
                    } else {
                        phi_660_ = 0f;
                    }
                    let _e411 = phi_660_;
                    let _e412 = (_e390 + _e411);
                    let _e413 = (_e390 - _e411);
                    let _e414 = select(_e399, 0f, _e403);
                    if _e403 {
                        phi_671_ = 38685626000000000000000000f;
                    } else {
                        phi_671_ = (1f / _e399);
                    }
                    let _e417 = phi_671_;
                    let _e420 = bitcast<f32>((bitcast<u32>(_e313) & 2147483647u));
                    let _e423 = bitcast<f32>((bitcast<u32>(_e352) & 2147483647u));
                    let _e425 = select(_e423, _e420, (_e420 > _e423));
                    let _e428 = bitcast<f32>((bitcast<u32>(_e390) & 2147483647u));
                    let _e431 = (_e132 + _e245);
                    if (_e226 && (select(_e428, _e425, (_e425 > _e428)) <= 1099511600000f)) {
                        let _e434 = (_e431 / 3i);
                        let _e441 = bitcast<f32>((bitcast<u32>((_e434 + 127i)) << bitcast<u32>(23i)));
                        let _e448 = bitcast<f32>((bitcast<u32>(((_e431 - (2i * _e434)) + 127i)) << bitcast<u32>(23i)));
                        let _e449 = (((_e211 * _e441) * _e441) * _e448);
                        let _e451 = select(340282350000000000000000000000000000000f, _e449, (_e449 < 340282350000000000000000000000000000000f));
                        let _e456 = (((_e220 * _e441) * _e441) * _e448);
                        let _e458 = select(340282350000000000000000000000000000000f, _e456, (_e456 < 340282350000000000000000000000000000000f));
                        phi_771_ = select(-340282350000000000000000000000000000000f, _e458, (_e458 > -340282350000000000000000000000000000000f));
                        phi_772_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_771_ = 0f;
                        phi_772_ = 1f;
                    }
                    let _e462 = phi_771_;
                    let _e464 = phi_772_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e469 = (_e264 % 3u);
                    let _e470 = (_e469 < 3u);
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e472 = local_1[_e469];
                    let _e475 = (_e263 % 3u);
                    let _e476 = (_e475 < 3u);
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e478 = local_1[_e475];
                    let _e481 = (_e265 % 3u);
                    let _e482 = (_e481 < 3u);
                    if _e482 {
                    } else {
                        break;
                    }
                    let _e484 = local_1[_e481];
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e489 = local[_e469];
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e493 = local[_e475];
                    if _e482 {
                    } else {
                        break;
                    }
                    let _e497 = local[_e481];
                    phi_3451_ = false;
                    phi_862_ = type_43(type_37(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e462), 0u, 0u);
                    phi_865_ = type_54(type_32(vec4<f32>((f32(_e472) * _e144), (f32(_e478) * _e144), (f32(_e484) * _e144), 0f), vec4<f32>((f32(_e489) * _e144), (f32(_e493) * _e144), (f32(_e497) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_867_ = ((3u * _e93) + 1u);
                    phi_869_ = (_e464 <= _e462);
                    phi_871_ = 0u;
                    loop {
                        let _e507 = phi_3451_;
                        let _e509 = phi_862_;
                        let _e511 = phi_865_;
                        let _e513 = phi_867_;
                        let _e515 = phi_869_;
                        let _e517 = phi_871_;
                        local_13 = _e509;
                        local_14 = _e509;
                        if _e515 {
                            phi_882_ = true;
                        } else {
                            phi_882_ = (_e517 > 0u);
                        }
                        let _e520 = phi_882_;
                        if _e520 {
                            let _e521 = (_e513 > 0u);
                            if _e521 {
                                if _e515 {
                                    phi_968_ = _e511;
                                    phi_969_ = _e515;
                                    phi_970_ = _e517;
                                } else {
                                    let _e522 = (_e517 - 1u);
                                    let _e523 = (_e522 % 128u);
                                    let _e524 = (_e523 < 128u);
                                    if _e524 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e526 = local_7[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e528 = local_6[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e530 = local_5[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e532 = local_4[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e534 = local_3[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e536 = local_2[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e541 = local_8[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e544 = local_9[_e523];
                                    phi_968_ = type_54(type_32(vec4<f32>(_e526, _e528, _e530, 0f), vec4<f32>(_e532, _e534, _e536, 0f)), _e541);
                                    phi_969_ = (_e544 <= _e509.member.member_1);
                                    phi_970_ = _e522;
                                }
                                let _e549 = phi_968_;
                                let _e551 = phi_969_;
                                let _e553 = phi_970_;
                                if _e551 {
                                    let _e558 = (_e549.member_1 & 268435455u);
                                    if ((_e549.member_1 & 2147483648u) != 0u) {
                                        phi_3448_ = _e507;
                                        phi_989_ = _e509;
                                        phi_992_ = type_8(0u, ((_e549.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1025 = phi_3448_;
                                            let _e1027 = phi_989_;
                                            let _e1029 = phi_992_;
                                            local_15 = _e1027;
                                            if (_e1029.member < _e1029.member_1) {
                                                phi_993_ = type_8((_e1029.member + 1u), _e1029.member_1);
                                                phi_1015_ = type_8(1u, _e1029.member);
                                            } else {
                                                phi_993_ = _e1029;
                                                phi_1015_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1042 = phi_993_;
                                            let _e1044 = phi_1015_;
                                            let _e1048 = (bitcast<i32>(_e1044.member) != 0i);
                                            if _e1048 {
                                                let _e1054 = type_43(_e1027.member, _e1027.member_1, (_e1027.member_2 + 1u));
                                                let _e1059 = (_e549.member.member_1.x - _e549.member.member.x);
                                                let _e1062 = (_e549.member.member_1.y - _e549.member.member.y);
                                                let _e1065 = (_e549.member.member_1.z - _e549.member.member.z);
                                                let _e1067 = select(_e1062, _e1059, (_e1059 > _e1062));
                                                let _e1069 = select(_e1065, _e1067, (_e1067 > _e1065));
                                                let _e1071 = (_e1069 < (1024f * _e144));
                                                if _e1071 {
                                                    phi_1059_ = 0u;
                                                } else {
                                                    phi_1059_ = select(2u, 1u, (_e1069 < (2097152f * _e144)));
                                                }
                                                let _e1076 = phi_1059_;
                                                switch bitcast<i32>(_e1076) {
                                                    case 0: {
                                                        phi_1065_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1065_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1065_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1065_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1079 = phi_1065_;
                                                switch bitcast<i32>(_e1076) {
                                                    case 0: {
                                                        phi_1075_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1075_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1075_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1075_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1086 = phi_1075_;
                                                let _e1088 = ((_e558 + (_e1044.member_1 * ((3u * _e1079) + 1u))) + (3u * _e1086));
                                                let _e1089 = (_e1088 < _e96);
                                                if _e1089 {
                                                    if _e1089 {
                                                    } else {
                                                        phi_3506_ = true;
                                                        break;
                                                    }
                                                    let _e1091 = global_5.member[_e1088];
                                                    phi_1091_ = _e1091;
                                                } else {
                                                    phi_1091_ = 4294967295u;
                                                }
                                                let _e1093 = phi_1091_;
                                                local_10 = array<u32, 3>(_e264, _e263, _e265);
                                                if _e1071 {
                                                    phi_1128_ = 0u;
                                                } else {
                                                    phi_1128_ = select(2u, 1u, (_e1069 < (2097152f * _e144)));
                                                }
                                                let _e1099 = phi_1128_;
                                                switch bitcast<i32>(_e1099) {
                                                    case 0: {
                                                        phi_1134_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1134_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1134_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1134_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1102 = phi_1134_;
                                                switch bitcast<i32>(_e1099) {
                                                    case 0: {
                                                        phi_1144_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1144_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1144_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1144_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1109 = phi_1144_;
                                                local_12 = array<f32, 4>(_e549.member.member.x, _e549.member.member.y, _e549.member.member.z, _e549.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3433_ = _e1025;
                                                phi_1160_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1123 = phi_3433_;
                                                    let _e1125 = phi_1160_;
                                                    if (_e1125.member < _e1125.member_1) {
                                                        phi_1161_ = type_8((_e1125.member + 1u), _e1125.member_1);
                                                        phi_1184_ = type_8(1u, _e1125.member);
                                                    } else {
                                                        phi_1161_ = _e1125;
                                                        phi_1184_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1138 = phi_1161_;
                                                    let _e1140 = phi_1184_;
                                                    let _e1144 = (bitcast<i32>(_e1140.member) != 0i);
                                                    if _e1144 {
                                                        let _e1146 = ((_e558 + (_e1044.member_1 * ((3u * _e1102) + 1u))) + (_e1140.member_1 * _e1109));
                                                        let _e1147 = (_e1146 < _e96);
                                                        if _e1147 {
                                                            if _e1147 {
                                                            } else {
                                                                phi_3504_ = true;
                                                                break;
                                                            }
                                                            let _e1149 = global_5.member[_e1146];
                                                            phi_1207_ = _e1149;
                                                        } else {
                                                            phi_1207_ = 0u;
                                                        }
                                                        let _e1151 = phi_1207_;
                                                        let _e1152 = (_e1146 + 1u);
                                                        let _e1153 = (_e1152 < _e96);
                                                        if _e1153 {
                                                            if _e1153 {
                                                            } else {
                                                                phi_3504_ = true;
                                                                break;
                                                            }
                                                            let _e1155 = global_5.member[_e1152];
                                                            phi_1222_ = _e1155;
                                                        } else {
                                                            phi_1222_ = 0u;
                                                        }
                                                        let _e1157 = phi_1222_;
                                                        phi_1225_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1159 = phi_1225_;
                                                            if (_e1159.member < _e1159.member_1) {
                                                                phi_1226_ = type_8((_e1159.member + 1u), _e1159.member_1);
                                                                phi_1249_ = type_8(1u, _e1159.member);
                                                            } else {
                                                                phi_1226_ = _e1159;
                                                                phi_1249_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1172 = phi_1226_;
                                                            let _e1174 = phi_1249_;
                                                            let _e1178 = (bitcast<i32>(_e1174.member) != 0i);
                                                            if _e1178 {
                                                                let _e1179 = (_e1174.member_1 < 3u);
                                                                if _e1179 {
                                                                } else {
                                                                    phi_3426_ = true;
                                                                    break;
                                                                }
                                                                let _e1181 = local_10[_e1174.member_1];
                                                                if (_e1174.member_1 < 4u) {
                                                                } else {
                                                                    phi_3426_ = true;
                                                                    break;
                                                                }
                                                                let _e1184 = local_12[_e1174.member_1];
                                                                switch bitcast<i32>(_e1099) {
                                                                    case 0: {
                                                                        phi_1319_ = (_e1184 + (f32(((_e1151 >> bitcast<u32>(((10u * _e1181) & 31u))) & 1023u)) * _e144));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1181 == 0u) {
                                                                            phi_1296_ = _e1151;
                                                                        } else {
                                                                            if (_e1181 == 1u) {
                                                                                phi_1295_ = ((_e1151 >> bitcast<u32>(21i)) | (_e1157 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1295_ = (_e1157 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1205 = phi_1295_;
                                                                            phi_1296_ = _e1205;
                                                                        }
                                                                        let _e1207 = phi_1296_;
                                                                        phi_1319_ = (_e1184 + (f32((_e1207 & 2097151u)) * _e144));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1186 = (_e1146 + _e1181);
                                                                        let _e1187 = (_e1186 < _e96);
                                                                        if _e1187 {
                                                                            if _e1187 {
                                                                            } else {
                                                                                phi_3426_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1189 = global_5.member[_e1186];
                                                                            phi_1315_ = _e1189;
                                                                        } else {
                                                                            phi_1315_ = 0u;
                                                                        }
                                                                        let _e1191 = phi_1315_;
                                                                        phi_1319_ = (f32(bitcast<i32>(_e1191)) * _e144);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1319_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1221 = phi_1319_;
                                                                if (_e1140.member_1 < 3u) {
                                                                } else {
                                                                    phi_3426_ = true;
                                                                    break;
                                                                }
                                                                if _e1179 {
                                                                } else {
                                                                    phi_3426_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1140.member_1][_e1174.member_1] = _e1221;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1225_ = _e1172;
                                                                phi_3426_ = _e1123;
                                                                break if !(_e1178);
                                                            }
                                                        }
                                                        let _e1227 = phi_3426_;
                                                        phi_3504_ = _e1227;
                                                        if _e1227 {
                                                            break;
                                                        }
                                                        phi_3505_ = _e1227;
                                                    } else {
                                                        phi_3505_ = _e1123;
                                                    }
                                                    let _e1229 = phi_3505_;
                                                    continue;
                                                    continuing {
                                                        phi_3433_ = _e1229;
                                                        phi_1160_ = _e1138;
                                                        phi_3504_ = _e1229;
                                                        break if !(_e1144);
                                                    }
                                                }
                                                let _e1232 = phi_3504_;
                                                phi_3506_ = _e1232;
                                                if _e1232 {
                                                    break;
                                                }
                                                let _e1233 = local_11;
                                                let _e1250 = (_e1233[0][2] - _e390);
                                                let _e1253 = (((_e1233[0][0] - _e313) * _e414) - (_e1250 * _e338));
                                                let _e1256 = (((_e1233[0][1] - _e352) * _e414) - (_e1250 * _e376));
                                                let _e1259 = (_e1233[1][2] - _e390);
                                                let _e1262 = (((_e1233[1][0] - _e313) * _e414) - (_e1259 * _e338));
                                                let _e1265 = (((_e1233[1][1] - _e352) * _e414) - (_e1259 * _e376));
                                                let _e1268 = (_e1233[2][2] - _e390);
                                                let _e1271 = (((_e1233[2][0] - _e313) * _e414) - (_e1268 * _e338));
                                                let _e1274 = (((_e1233[2][1] - _e352) * _e414) - (_e1268 * _e376));
                                                let _e1275 = (_e1271 * _e1265);
                                                let _e1276 = (_e1274 * _e1262);
                                                let _e1277 = (_e1253 * _e1274);
                                                let _e1278 = (_e1256 * _e1271);
                                                let _e1279 = (_e1262 * _e1256);
                                                let _e1280 = (_e1265 * _e1253);
                                                let _e1285 = (((_e1275 >= _e1276) && (_e1277 >= _e1278)) && (_e1279 >= _e1280));
                                                if (_e1285 || (((_e1275 <= _e1276) && (_e1277 <= _e1278)) && (_e1279 <= _e1280))) {
                                                    let _e1292 = select(-1f, 1f, _e1285);
                                                    let _e1294 = ((_e1275 - _e1276) * _e1292);
                                                    let _e1296 = select(0f, _e1294, (_e1294 > 0f));
                                                    let _e1298 = ((_e1277 - _e1278) * _e1292);
                                                    let _e1300 = select(0f, _e1298, (_e1298 > 0f));
                                                    let _e1302 = ((_e1279 - _e1280) * _e1292);
                                                    let _e1304 = select(0f, _e1302, (_e1302 > 0f));
                                                    let _e1306 = ((_e1296 + _e1300) + _e1304);
                                                    if (_e1306 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1914_ = type_28();
                                                        phi_1915_ = true;
                                                    } else {
                                                        let _e1309 = select(_e1233[1][0], _e1233[0][0], (_e1233[0][0] < _e1233[1][0]));
                                                        let _e1313 = select(_e1233[1][0], _e1233[0][0], (_e1233[0][0] > _e1233[1][0]));
                                                        let _e1317 = select(_e1233[1][1], _e1233[0][1], (_e1233[0][1] < _e1233[1][1]));
                                                        let _e1321 = select(_e1233[1][1], _e1233[0][1], (_e1233[0][1] > _e1233[1][1]));
                                                        let _e1325 = select(_e1233[1][2], _e1233[0][2], (_e1233[0][2] < _e1233[1][2]));
                                                        let _e1329 = select(_e1233[1][2], _e1233[0][2], (_e1233[0][2] > _e1233[1][2]));
                                                        let _e1334 = ((select(_e1233[2][0], _e1309, (_e1309 < _e1233[2][0])) - _e336) * _e341);
                                                        let _e1335 = ((select(_e1233[2][0], _e1313, (_e1313 > _e1233[2][0])) - _e337) * _e341);
                                                        let _e1338 = ((select(_e1233[2][1], _e1317, (_e1317 < _e1233[2][1])) - _e374) * _e379);
                                                        let _e1339 = ((select(_e1233[2][1], _e1321, (_e1321 > _e1233[2][1])) - _e375) * _e379);
                                                        let _e1342 = ((select(_e1233[2][2], _e1325, (_e1325 < _e1233[2][2])) - _e412) * _e417);
                                                        let _e1343 = ((select(_e1233[2][2], _e1329, (_e1329 > _e1233[2][2])) - _e413) * _e417);
                                                        let _e1345 = select(_e1343, _e1342, (_e1342 < _e1343));
                                                        let _e1347 = select(_e1343, _e1342, (_e1342 > _e1343));
                                                        let _e1349 = select(_e1335, _e1334, (_e1334 < _e1335));
                                                        let _e1351 = select(_e1339, _e1338, (_e1338 < _e1339));
                                                        let _e1353 = select(_e1351, _e1349, (_e1349 > _e1351));
                                                        let _e1355 = select(_e1345, _e1353, (_e1353 > _e1345));
                                                        let _e1357 = select(_e1335, _e1334, (_e1334 > _e1335));
                                                        let _e1359 = select(_e1339, _e1338, (_e1338 > _e1339));
                                                        let _e1361 = select(_e1359, _e1357, (_e1357 < _e1359));
                                                        let _e1363 = select(_e1347, _e1361, (_e1361 < _e1347));
                                                        let _e1364 = -(_e1345);
                                                        let _e1370 = select(_e464, _e1355, (_e1355 > _e464));
                                                        if (_e1370 > (_e1363 + (select(_e1364, _e1347, (_e1347 > _e1364)) * 0.0000019073523f))) {
                                                            phi_1909_ = type_28();
                                                            phi_1910_ = true;
                                                        } else {
                                                            let _e1372 = (_e1370 > _e1027.member.member_1);
                                                            if _e1372 {
                                                                phi_1908_ = type_28();
                                                            } else {
                                                                let _e1376 = (_e1233[1][0] - _e1233[0][0]);
                                                                let _e1377 = (_e1233[1][1] - _e1233[0][1]);
                                                                let _e1378 = (_e1233[1][2] - _e1233[0][2]);
                                                                let _e1379 = vec3<f32>(_e1376, _e1377, _e1378);
                                                                let _e1380 = (_e1233[2][0] - _e1233[1][0]);
                                                                let _e1381 = (_e1233[2][1] - _e1233[1][1]);
                                                                let _e1382 = (_e1233[2][2] - _e1233[1][2]);
                                                                let _e1383 = vec3<f32>(_e1380, _e1381, _e1382);
                                                                let _e1384 = (_e1233[0][0] - _e1233[2][0]);
                                                                let _e1385 = (_e1233[0][1] - _e1233[2][1]);
                                                                let _e1386 = (_e1233[0][2] - _e1233[2][2]);
                                                                let _e1387 = vec3<f32>(_e1384, _e1385, _e1386);
                                                                let _e1390 = bitcast<f32>((bitcast<u32>(_e1376) & 2147483647u));
                                                                let _e1393 = bitcast<f32>((bitcast<u32>(_e1377) & 2147483647u));
                                                                let _e1395 = select(_e1393, _e1390, (_e1390 > _e1393));
                                                                let _e1398 = bitcast<f32>((bitcast<u32>(_e1378) & 2147483647u));
                                                                let _e1400 = select(_e1398, _e1395, (_e1395 > _e1398));
                                                                let _e1403 = bitcast<f32>((bitcast<u32>(_e1380) & 2147483647u));
                                                                let _e1406 = bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u));
                                                                let _e1408 = select(_e1406, _e1403, (_e1403 > _e1406));
                                                                let _e1411 = bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u));
                                                                let _e1413 = select(_e1411, _e1408, (_e1408 > _e1411));
                                                                let _e1416 = bitcast<f32>((bitcast<u32>(_e1384) & 2147483647u));
                                                                let _e1419 = bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u));
                                                                let _e1421 = select(_e1419, _e1416, (_e1416 > _e1419));
                                                                let _e1424 = bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u));
                                                                let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                                let _e1428 = select(_e1413, _e1400, (_e1400 > _e1413));
                                                                let _e1430 = select(_e1426, _e1428, (_e1428 > _e1426));
                                                                if (_e1400 == _e1430) {
                                                                    phi_1819_ = _e1383;
                                                                    phi_1820_ = _e1387;
                                                                } else {
                                                                    let _e1433 = vec3((_e1413 == _e1430));
                                                                    phi_1819_ = select(_e1379, _e1387, _e1433);
                                                                    phi_1820_ = select(_e1383, _e1379, _e1433);
                                                                }
                                                                let _e1437 = phi_1819_;
                                                                let _e1439 = phi_1820_;
                                                                let _e1446 = ((_e1437.y * _e1439.z) - (_e1439.y * _e1437.z));
                                                                let _e1451 = ((_e1437.z * _e1439.x) - (_e1439.z * _e1437.x));
                                                                let _e1454 = ((_e1437.x * _e1439.y) - (_e1439.x * _e1437.y));
                                                                if (_e1296 >= _e1300) {
                                                                    phi_1851_ = select(true, false, (_e1296 >= _e1304));
                                                                } else {
                                                                    phi_1851_ = true;
                                                                }
                                                                let _e1459 = phi_1851_;
                                                                if _e1459 {
                                                                    phi_1860_ = select(vec3<f32>(_e1233[2][0], _e1233[2][1], _e1233[2][2]), vec3<f32>(_e1233[1][0], _e1233[1][1], _e1233[1][2]), vec3((_e1300 >= _e1304)));
                                                                } else {
                                                                    phi_1860_ = vec3<f32>(_e1233[0][0], _e1233[0][1], _e1233[0][2]);
                                                                }
                                                                let _e1464 = phi_1860_;
                                                                let _e1481 = ((((_e1446 * (_e1464.x - _e313)) + (_e1451 * (_e1464.y - _e352))) + (_e1454 * (_e1464.z - _e390))) / (((_e1446 * _e338) + (_e1451 * _e376)) + (_e1454 * _e414)));
                                                                let _e1483 = select(_e1363, _e1481, (_e1481 < _e1363));
                                                                let _e1485 = select(_e1355, _e1483, (_e1483 > _e1355));
                                                                if (_e1485 >= _e464) {
                                                                    let _e1487 = (_e1485 <= _e1027.member.member_1);
                                                                    if _e1487 {
                                                                        let _e1488 = (1f / _e1306);
                                                                        phi_1900_ = type_28(_e1485, (_e1300 * _e1488), (_e1304 * _e1488), _e1093);
                                                                    } else {
                                                                        phi_1900_ = type_28();
                                                                    }
                                                                    let _e1493 = phi_1900_;
                                                                    phi_1902_ = _e1493;
                                                                    phi_1903_ = select(true, false, _e1487);
                                                                } else {
                                                                    phi_1902_ = type_28();
                                                                    phi_1903_ = true;
                                                                }
                                                                let _e1496 = phi_1902_;
                                                                let _e1498 = phi_1903_;
                                                                if _e1498 {
                                                                    phi_1907_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1907_ = _e1496;
                                                                }
                                                                let _e1500 = phi_1907_;
                                                                phi_1908_ = _e1500;
                                                            }
                                                            let _e1502 = phi_1908_;
                                                            phi_1909_ = _e1502;
                                                            phi_1910_ = _e1372;
                                                        }
                                                        let _e1504 = phi_1909_;
                                                        let _e1506 = phi_1910_;
                                                        phi_1914_ = _e1504;
                                                        phi_1915_ = _e1506;
                                                    }
                                                    let _e1508 = phi_1914_;
                                                    let _e1510 = phi_1915_;
                                                    phi_1919_ = _e1508;
                                                    phi_1920_ = _e1510;
                                                } else {
                                                    phi_1919_ = type_28();
                                                    phi_1920_ = true;
                                                }
                                                let _e1512 = phi_1919_;
                                                let _e1514 = phi_1920_;
                                                if _e1514 {
                                                    phi_1924_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1924_ = _e1512;
                                                }
                                                let _e1516 = phi_1924_;
                                                if (_e1516.member_3 != 4294967295u) {
                                                    if (_e1093 != 4294967295u) {
                                                        if (_e1516.member < _e1027.member.member.member) {
                                                            phi_1950_ = true;
                                                        } else {
                                                            if (_e1516.member == _e1027.member.member.member) {
                                                                phi_1949_ = (_e1516.member_3 < _e1027.member.member.member_3);
                                                            } else {
                                                                phi_1949_ = false;
                                                            }
                                                            let _e1531 = phi_1949_;
                                                            phi_1950_ = _e1531;
                                                        }
                                                        let _e1533 = phi_1950_;
                                                        if _e1533 {
                                                            phi_1957_ = type_43(type_37(_e1516, _e1516.member), _e1054.member_1, _e1054.member_2);
                                                        } else {
                                                            phi_1957_ = _e1054;
                                                        }
                                                        let _e1540 = phi_1957_;
                                                        phi_1958_ = _e1540;
                                                    } else {
                                                        phi_1958_ = _e1054;
                                                    }
                                                    let _e1542 = phi_1958_;
                                                    phi_1959_ = _e1542;
                                                } else {
                                                    phi_1959_ = _e1054;
                                                }
                                                let _e1544 = phi_1959_;
                                                phi_3507_ = _e1232;
                                                phi_990_ = _e1544;
                                            } else {
                                                phi_3507_ = _e1025;
                                                phi_990_ = type_43();
                                            }
                                            let _e1546 = phi_3507_;
                                            let _e1548 = phi_990_;
                                            continue;
                                            continuing {
                                                phi_3448_ = _e1546;
                                                phi_989_ = _e1548;
                                                phi_992_ = _e1042;
                                                phi_3506_ = _e1546;
                                                break if !(_e1048);
                                            }
                                        }
                                        let _e1551 = phi_3506_;
                                        phi_3565_ = _e1551;
                                        if _e1551 {
                                            break;
                                        }
                                        phi_3569_ = _e1551;
                                        let _e1729 = local_15;
                                        phi_3202_ = _e1729;
                                        phi_3203_ = _e549;
                                        phi_3204_ = false;
                                        phi_3205_ = _e553;
                                    } else {
                                        if (_e549.member_1 >= _e93) {
                                            phi_2758_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e549.member_1 < _e93) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e572 = ((1u + _e264) % 4u);
                                            if (_e572 < 4u) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e577 = global_3.member[_e549.member_1][_e572];
                                            let _e579 = (_e577 >> bitcast<u32>(11u));
                                            let _e581 = ((1u + _e263) % 4u);
                                            if (_e581 < 4u) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e586 = global_3.member[_e549.member_1][_e581];
                                            let _e588 = (_e586 >> bitcast<u32>(11u));
                                            let _e590 = ((1u + _e265) % 4u);
                                            if (_e590 < 4u) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e595 = global_3.member[_e549.member_1][_e590];
                                            let _e597 = (_e595 >> bitcast<u32>(11u));
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.x - _e549.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.y - _e549.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.z - _e549.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e624 = select(_e144, _e620, (_e620 > _e144));
                                            let _e626 = select(_e144, _e621, (_e621 > _e144));
                                            let _e628 = select(_e144, _e622, (_e622 > _e144));
                                            let _e653 = bitcast<u32>((f32(bitcast<i32>((_e577 & 1023u))) * _e624));
                                            let _e658 = (bitcast<i32>((_e577 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e586 & 1023u))) * _e626));
                                            let _e667 = (bitcast<i32>((_e586 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e671 = bitcast<u32>((f32(bitcast<i32>((_e595 & 1023u))) * _e628));
                                            let _e676 = (bitcast<i32>((_e595 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                            let _e683 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                            let _e687 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e691 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                            let _e692 = bitcast<u32>((f32(bitcast<i32>((_e579 & 1023u))) * _e624));
                                            let _e697 = (bitcast<i32>((_e579 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e588 & 1023u))) * _e626));
                                            let _e706 = (bitcast<i32>((_e588 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e710 = bitcast<u32>((f32(bitcast<i32>((_e597 & 1023u))) * _e628));
                                            let _e715 = (bitcast<i32>((_e597 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e718 = bitcast<f32>((_e710 & bitcast<u32>(_e715)));
                                            let _e722 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                            let _e726 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e730 = bitcast<f32>((_e710 & bitcast<u32>(~(_e715))));
                                            let _e731 = (_e549.member.member.x + _e661);
                                            let _e732 = (_e549.member.member.y + _e670);
                                            let _e733 = (_e549.member.member.z + _e679);
                                            let _e736 = (_e549.member.member_1.x - _e700);
                                            let _e737 = (_e549.member.member_1.y - _e709);
                                            let _e738 = (_e549.member.member_1.z - _e718);
                                            let _e757 = (_e736 - _e731);
                                            let _e758 = (_e737 - _e732);
                                            let _e759 = (_e738 - _e733);
                                            let _e761 = select(_e758, _e757, (_e757 > _e758));
                                            let _e763 = select(_e759, _e761, (_e761 > _e759));
                                            if (_e763 < (1024f * _e144)) {
                                                phi_2459_ = 0u;
                                            } else {
                                                phi_2459_ = select(2u, 1u, (_e763 < (2097152f * _e144)));
                                            }
                                            let _e770 = phi_2459_;
                                            switch bitcast<i32>(_e770) {
                                                case 0: {
                                                    phi_2465_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2465_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2465_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2465_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e773 = phi_2465_;
                                            let _e779 = global_3.member[_e549.member_1][0u];
                                            let _e783 = global_3.member[_e549.member_1][1u];
                                            let _e787 = global_3.member[_e549.member_1][2u];
                                            let _e791 = global_3.member[_e549.member_1][3u];
                                            let _e803 = (((_e783 >> bitcast<u32>(22i)) | ((_e787 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e791 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e804 = (_e779 & 268435455u);
                                            let _e805 = (_e803 & 268435455u);
                                            let _e808 = ((_e779 >> bitcast<u32>(28u)) & 7u);
                                            let _e816 = ((_e779 >> bitcast<u32>(31i)) | (((_e803 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e817 = (_e808 != 0u);
                                            if (_e808 == 0u) {
                                                phi_2720_ = _e804;
                                            } else {
                                                if (_e808 == 7u) {
                                                    phi_2719_ = 2147483648u;
                                                } else {
                                                    phi_2719_ = ((2147483648u | (_e808 << bitcast<u32>(28u))) | (_e805 & 268435455u));
                                                }
                                                let _e826 = phi_2719_;
                                                phi_2720_ = _e826;
                                            }
                                            let _e828 = phi_2720_;
                                            if _e817 {
                                                let _e829 = (_e808 != 7u);
                                                if _e829 {
                                                    phi_2730_ = (_e805 + (_e808 * ((3u * _e773) + 1u)));
                                                } else {
                                                    phi_2730_ = u32();
                                                }
                                                let _e833 = phi_2730_;
                                                phi_2732_ = _e833;
                                                phi_2733_ = select(true, false, _e829);
                                            } else {
                                                phi_2732_ = u32();
                                                phi_2733_ = true;
                                            }
                                            let _e836 = phi_2732_;
                                            let _e838 = phi_2733_;
                                            if (_e816 == 0u) {
                                                phi_2754_ = (_e804 + select(0u, 1u, !(_e817)));
                                            } else {
                                                if (_e816 == 7u) {
                                                    phi_2753_ = 2147483648u;
                                                } else {
                                                    phi_2753_ = ((2147483648u | (_e816 << bitcast<u32>(28u))) | (select(_e836, _e805, _e838) & 268435455u));
                                                }
                                                let _e851 = phi_2753_;
                                                phi_2754_ = _e851;
                                            }
                                            let _e853 = phi_2754_;
                                            phi_2758_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e731, (_e549.member.member.x + _e683), _e736, (_e549.member.member_1.x - _e722)), vec4<f32>(_e732, (_e549.member.member.y + _e687), _e737, (_e549.member.member_1.y - _e726)), vec4<f32>(_e733, (_e549.member.member.z + _e691), _e738, (_e549.member.member_1.z - _e730))), type_54(type_32((_e549.member.member + vec4<f32>(_e661, _e670, _e679, 0f)), (_e549.member.member_1 - vec4<f32>(_e700, _e709, _e718, 0f))), _e828), type_54(type_32((_e549.member.member + vec4<f32>(_e683, _e687, _e691, 0f)), (_e549.member.member_1 - vec4<f32>(_e722, _e726, _e730, 0f))), _e853));
                                        }
                                        let _e858 = phi_2758_;
                                        let _e871 = ((_e858.member[0].x - _e336) * _e341);
                                        let _e872 = ((_e858.member[0].y - _e336) * _e341);
                                        let _e873 = ((_e858.member[0].z - _e337) * _e341);
                                        let _e874 = ((_e858.member[0].w - _e337) * _e341);
                                        let _e884 = ((_e858.member[1].x - _e374) * _e379);
                                        let _e885 = ((_e858.member[1].y - _e374) * _e379);
                                        let _e886 = ((_e858.member[1].z - _e375) * _e379);
                                        let _e887 = ((_e858.member[1].w - _e375) * _e379);
                                        let _e897 = ((_e858.member[2].x - _e412) * _e417);
                                        let _e898 = ((_e858.member[2].y - _e412) * _e417);
                                        let _e899 = ((_e858.member[2].z - _e413) * _e417);
                                        let _e900 = ((_e858.member[2].w - _e413) * _e417);
                                        let _e902 = select(_e899, _e897, (_e897 < _e899));
                                        let _e904 = select(_e900, _e898, (_e898 < _e900));
                                        let _e906 = select(_e899, _e897, (_e897 > _e899));
                                        let _e908 = select(_e900, _e898, (_e898 > _e900));
                                        let _e910 = select(_e873, _e871, (_e871 < _e873));
                                        let _e912 = select(_e874, _e872, (_e872 < _e874));
                                        let _e914 = select(_e886, _e884, (_e884 < _e886));
                                        let _e916 = select(_e887, _e885, (_e885 < _e887));
                                        let _e918 = select(_e914, _e910, (_e910 > _e914));
                                        let _e920 = select(_e916, _e912, (_e912 > _e916));
                                        let _e922 = select(_e902, _e918, (_e918 > _e902));
                                        let _e924 = select(_e904, _e920, (_e920 > _e904));
                                        let _e926 = select(_e873, _e871, (_e871 > _e873));
                                        let _e928 = select(_e874, _e872, (_e872 > _e874));
                                        let _e930 = select(_e886, _e884, (_e884 > _e886));
                                        let _e932 = select(_e887, _e885, (_e885 > _e887));
                                        let _e934 = select(_e930, _e926, (_e926 < _e930));
                                        let _e936 = select(_e932, _e928, (_e928 < _e932));
                                        let _e941 = -(_e902);
                                        let _e942 = -(_e904);
                                        let _e949 = (select(_e906, _e934, (_e934 < _e906)) + (select(_e941, _e906, (_e906 > _e941)) * 0.0000019073523f));
                                        let _e950 = (select(_e908, _e936, (_e936 < _e908)) + (select(_e942, _e908, (_e908 > _e942)) * 0.0000019073523f));
                                        let _e952 = select(_e464, _e922, (_e922 > _e464));
                                        let _e954 = select(_e464, _e924, (_e924 > _e464));
                                        let _e959 = (_e952 <= select(_e509.member.member_1, _e949, (_e949 < _e509.member.member_1)));
                                        let _e960 = (_e954 <= select(_e509.member.member_1, _e950, (_e950 < _e509.member.member_1)));
                                        let _e961 = (_e952 <= _e954);
                                        if _e959 {
                                            if _e960 {
                                                if _e961 {
                                                    phi_3102_ = _e858.member_2;
                                                } else {
                                                    phi_3102_ = _e858.member_1;
                                                }
                                                let _e965 = phi_3102_;
                                                let _e987 = (_e553 % 128u);
                                                let _e988 = (_e987 < 128u);
                                                if _e988 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_8[_e987] = _e965.member_1;
                                                if _e988 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_7[_e987] = _e965.member.member.x;
                                                if _e988 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_6[_e987] = _e965.member.member.y;
                                                if _e988 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_5[_e987] = _e965.member.member.z;
                                                if _e988 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_4[_e987] = _e965.member.member_1.x;
                                                if _e988 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_3[_e987] = _e965.member.member_1.y;
                                                if _e988 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_2[_e987] = _e965.member.member_1.z;
                                                if _e988 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_9[_e987] = select(_e954, _e952, (_e952 > _e954));
                                                if _e961 {
                                                    phi_3179_ = _e858.member_1;
                                                } else {
                                                    phi_3179_ = _e858.member_2;
                                                }
                                                let _e1001 = phi_3179_;
                                                phi_3180_ = _e1001;
                                                phi_3181_ = (_e553 + 1u);
                                            } else {
                                                phi_3180_ = type_54();
                                                phi_3181_ = u32();
                                            }
                                            let _e1003 = phi_3180_;
                                            let _e1005 = phi_3181_;
                                            phi_3183_ = _e1003;
                                            phi_3184_ = _e1005;
                                            phi_3185_ = select(true, false, _e960);
                                        } else {
                                            phi_3183_ = type_54();
                                            phi_3184_ = u32();
                                            phi_3185_ = true;
                                        }
                                        let _e1008 = phi_3183_;
                                        let _e1010 = phi_3184_;
                                        let _e1012 = phi_3185_;
                                        if _e1012 {
                                            if _e959 {
                                                phi_3194_ = _e858.member_1;
                                            } else {
                                                phi_3194_ = _e858.member_2;
                                            }
                                            let _e1016 = phi_3194_;
                                            phi_3199_ = _e1016;
                                            phi_3200_ = select(_e960, true, _e959);
                                        } else {
                                            phi_3199_ = _e1008;
                                            phi_3200_ = _e551;
                                        }
                                        let _e1019 = phi_3199_;
                                        let _e1021 = phi_3200_;
                                        phi_3569_ = _e507;
                                        phi_3202_ = type_43(_e509.member, (_e509.member_1 + 1u), _e509.member_2);
                                        phi_3203_ = _e1019;
                                        phi_3204_ = _e1021;
                                        phi_3205_ = select(_e1010, _e553, _e1012);
                                    }
                                    let _e1553 = phi_3569_;
                                    let _e1555 = phi_3202_;
                                    let _e1557 = phi_3203_;
                                    let _e1559 = phi_3204_;
                                    let _e1561 = phi_3205_;
                                    phi_3568_ = _e1553;
                                    phi_3206_ = _e1555;
                                    phi_3207_ = _e1557;
                                    phi_3208_ = (_e513 - 1u);
                                    phi_3209_ = _e1559;
                                    phi_3210_ = _e1561;
                                } else {
                                    phi_3568_ = _e507;
                                    phi_3206_ = _e509;
                                    phi_3207_ = _e549;
                                    phi_3208_ = _e513;
                                    phi_3209_ = _e551;
                                    phi_3210_ = _e553;
                                }
                                let _e1563 = phi_3568_;
                                let _e1565 = phi_3206_;
                                let _e1567 = phi_3207_;
                                let _e1569 = phi_3208_;
                                let _e1571 = phi_3209_;
                                let _e1573 = phi_3210_;
                                phi_3567_ = _e1563;
                                phi_3211_ = _e1565;
                                phi_3212_ = _e1567;
                                phi_3213_ = _e1569;
                                phi_3214_ = _e1571;
                                phi_3215_ = _e1573;
                            } else {
                                phi_3567_ = _e507;
                                phi_3211_ = type_43();
                                phi_3212_ = type_54();
                                phi_3213_ = u32();
                                phi_3214_ = bool();
                                phi_3215_ = u32();
                            }
                            let _e1575 = phi_3567_;
                            let _e1577 = phi_3211_;
                            let _e1579 = phi_3212_;
                            let _e1581 = phi_3213_;
                            let _e1583 = phi_3214_;
                            let _e1585 = phi_3215_;
                            phi_3566_ = _e1575;
                            phi_863_ = _e1577;
                            phi_866_ = _e1579;
                            phi_868_ = _e1581;
                            phi_870_ = _e1583;
                            phi_872_ = _e1585;
                            phi_3216_ = _e521;
                        } else {
                            phi_3566_ = _e507;
                            phi_863_ = type_43();
                            phi_866_ = type_54();
                            phi_868_ = u32();
                            phi_870_ = bool();
                            phi_872_ = u32();
                            phi_3216_ = false;
                        }
                        let _e1587 = phi_3566_;
                        let _e1589 = phi_863_;
                        let _e1591 = phi_866_;
                        let _e1593 = phi_868_;
                        let _e1595 = phi_870_;
                        let _e1597 = phi_872_;
                        let _e1599 = phi_3216_;
                        continue;
                        continuing {
                            phi_3451_ = _e1587;
                            phi_862_ = _e1589;
                            phi_865_ = _e1591;
                            phi_867_ = _e1593;
                            phi_869_ = _e1595;
                            phi_871_ = _e1597;
                            phi_3565_ = _e1587;
                            break if !(_e1599);
                        }
                    }
                    let _e1602 = phi_3565_;
                    if _e1602 {
                        break;
                    }
                    let _e1604 = local_13;
                    let _e1607 = local_14;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150][0u] = _e1604.member_1;
                    global_6.member[_e150][1u] = _e1607.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
