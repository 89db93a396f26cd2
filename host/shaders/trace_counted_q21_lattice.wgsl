struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_20 {
    member: array<array<u32, 2>>,
}

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: type_24,
    member_1: f32,
}

struct type_37 {
    member: array<type_25>,
}

struct type_39 {
    member: type_33,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_54 {
    member: type_28,
    member_1: u32,
}

struct type_55 {
    member: array<vec4<f32>, 3>,
    member_1: type_54,
    member_2: type_54,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(4) 
var<storage> global_3: type_37;
@group(0) @binding(2) 
var<storage> global_4: type_45;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_20;

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
    var phi_862_: type_39;
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
    var phi_989_: type_39;
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
    var phi_1900_: type_24;
    var phi_1902_: type_24;
    var phi_1903_: bool;
    var phi_1907_: type_24;
    var phi_1908_: type_24;
    var phi_1909_: type_24;
    var phi_1910_: bool;
    var phi_1914_: type_24;
    var phi_1915_: bool;
    var phi_1919_: type_24;
    var phi_1920_: bool;
    var phi_1924_: type_24;
    var phi_1949_: bool;
    var phi_1950_: bool;
    var phi_1957_: type_39;
    var phi_1958_: type_39;
    var phi_1959_: type_39;
    var phi_3507_: bool;
    var phi_990_: type_39;
    var phi_3506_: bool;
    var phi_3569_: bool;
    var phi_3202_: type_39;
    var phi_3203_: type_54;
    var phi_3204_: bool;
    var phi_3205_: u32;
    var phi_3568_: bool;
    var phi_3206_: type_39;
    var phi_3207_: type_54;
    var phi_3208_: u32;
    var phi_3209_: bool;
    var phi_3210_: u32;
    var phi_3567_: bool;
    var phi_3211_: type_39;
    var phi_3212_: type_54;
    var phi_3213_: u32;
    var phi_3214_: bool;
    var phi_3215_: u32;
    var phi_3566_: bool;
    var phi_863_: type_39;
    var phi_866_: type_54;
    var phi_868_: u32;
    var phi_870_: bool;
    var phi_872_: u32;
    var phi_3216_: bool;
    var phi_3565_: bool;
    var local_13: type_39;
    var local_14: type_39;
    var local_15: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e92 = arrayLength((&global_4.member));
            let _e95 = arrayLength((&global_5.member));
            let _e103 = global_2.member[0u][0u];
            let _e107 = global_2.member[0u][1u];
            let _e111 = global_2.member[0u][2u];
            let _e115 = global_2.member[0u][3u];
            let _e119 = global_2.member[1u][0u];
            let _e123 = global_2.member[1u][1u];
            let _e127 = global_2.member[1u][2u];
            let _e130 = global_1.member[0u];
            let _e131 = bitcast<i32>(_e130);
            let _e143 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e115) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e103), bitcast<i32>(_e107), bitcast<i32>(_e111));
            local = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            let _e149 = (_e90.x + (_e90.y * 2097152u));
            let _e150 = (_e149 < arrayLength((&global_3.member)));
            if _e150 {
                let _e151 = (_e149 < arrayLength((&global_6.member)));
                if _e151 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e159 = global_3.member[_e149].member_2[0u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_3.member[_e149].member_2[1u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_3.member[_e149].member_2[2u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_3.member[_e149].member[0u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_3.member[_e149].member[1u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_3.member[_e149].member[2u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e198 = select(_e168, _e161, (_e168 < _e161));
                    let _e200 = select(_e175, _e198, (_e175 < _e198));
                    let _e202 = select(_e182, _e200, (_e182 < _e200));
                    let _e204 = select(_e189, _e202, (_e189 < _e202));
                    let _e206 = select(_e196, _e204, (_e196 < _e204));
                    let _e210 = global_3.member[_e149].member_1;
                    let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                    let _e219 = global_3.member[_e149].member_3;
                    let _e225 = (((select(_e212, _e206, (_e212 < _e206)) < 2139095040u) && ((bitcast<u32>(_e219) & 2147483647u) <= 2139095040u)) && (_e200 > 0u));
                    if _e225 {
                        let _e228 = (bitcast<u32>(bitcast<f32>(_e200)) & 2147483647u);
                        if (_e228 >= 8388608u) {
                            phi_402_ = (bitcast<i32>((_e228 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_402_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u))));
                        }
                        let _e242 = phi_402_;
                        phi_403_ = _e242;
                    } else {
                        phi_403_ = 0i;
                    }
                    let _e244 = phi_403_;
                    let _e245 = (_e161 == _e200);
                    if _e245 {
                        phi_413_ = true;
                    } else {
                        phi_413_ = (_e168 == _e200);
                    }
                    let _e248 = phi_413_;
                    let _e249 = select(1u, 0u, _e245);
                    if _e248 {
                        let _e250 = (_e249 + 1u);
                        phi_423_ = _e250;
                        phi_424_ = _e250;
                        phi_426_ = select(true, false, (_e250 == 2u));
                    } else {
                        phi_423_ = u32();
                        phi_424_ = 0u;
                        phi_426_ = true;
                    }
                    let _e254 = phi_423_;
                    let _e256 = phi_424_;
                    let _e258 = phi_426_;
                    if _e258 {
                        phi_431_ = (_e256 + 1u);
                    } else {
                        phi_431_ = 0u;
                    }
                    let _e262 = phi_431_;
                    let _e263 = select(_e254, _e256, _e258);
                    let _e264 = select(_e249, select(2u, _e249, _e248), _e258);
                    if (_e131 < -126i) {
                        phi_444_ = -126i;
                    } else {
                        phi_444_ = select(_e131, 127i, (_e131 > 127i));
                    }
                    let _e269 = phi_444_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e131 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e281 = -(_e244);
                    if (_e281 < -126i) {
                        phi_464_ = -126i;
                    } else {
                        phi_464_ = select(_e281, 127i, (_e281 > 127i));
                    }
                    let _e286 = phi_464_;
                    let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
                    let _e297 = bitcast<f32>((bitcast<u32>(((_e281 - _e286) + 127i)) << bitcast<u32>(23i)));
                    let _e301 = global_3.member[_e149].member;
                    let _e302 = (_e263 == 0u);
                    if _e302 {
                        phi_482_ = _e301[0];
                    } else {
                        phi_482_ = _e301[1];
                    }
                    let _e306 = phi_482_;
                    let _e307 = (_e263 == 2u);
                    if _e307 {
                        phi_488_ = _e301[2];
                    } else {
                        phi_488_ = _e306;
                    }
                    let _e310 = phi_488_;
                    let _e312 = ((_e310 * _e274) * _e280);
                    let _e313 = global_3.member[_e149].member_2;
                    if _e302 {
                        phi_499_ = _e313[0];
                    } else {
                        phi_499_ = _e313[1];
                    }
                    let _e317 = phi_499_;
                    if _e307 {
                        phi_505_ = _e313[2];
                    } else {
                        phi_505_ = _e317;
                    }
                    let _e320 = phi_505_;
                    let _e322 = ((_e320 * _e291) * _e297);
                    let _e326 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e326 {
                        let _e330 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) * 0.00000011920929f);
                        phi_528_ = select(0.00000000000011368684f, _e330, (_e330 > 0.00000000000011368684f));
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e334 = phi_528_;
                    let _e335 = (_e312 + _e334);
                    let _e336 = (_e312 - _e334);
                    let _e337 = select(_e322, 0f, _e326);
                    if _e326 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e322);
                    }
                    let _e340 = phi_539_;
                    let _e341 = (_e262 == 0u);
                    if _e341 {
                        phi_548_ = _e301[0];
                    } else {
                        phi_548_ = _e301[1];
                    }
                    let _e345 = phi_548_;
                    let _e346 = (_e262 == 2u);
                    if _e346 {
                        phi_554_ = _e301[2];
                    } else {
                        phi_554_ = _e345;
                    }
                    let _e349 = phi_554_;
                    let _e351 = ((_e349 * _e274) * _e280);
                    if _e341 {
                        phi_565_ = _e313[0];
                    } else {
                        phi_565_ = _e313[1];
                    }
                    let _e355 = phi_565_;
                    if _e346 {
                        phi_571_ = _e313[2];
                    } else {
                        phi_571_ = _e355;
                    }
                    let _e358 = phi_571_;
                    let _e360 = ((_e358 * _e291) * _e297);
                    let _e364 = (bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e364 {
                        let _e368 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) * 0.00000011920929f);
                        phi_594_ = select(0.00000000000011368684f, _e368, (_e368 > 0.00000000000011368684f));
                    } else {
                        phi_594_ = 0f;
                    }
                    let _e372 = phi_594_;
                    let _e373 = (_e351 + _e372);
                    let _e374 = (_e351 - _e372);
                    let _e375 = select(_e360, 0f, _e364);
                    if _e364 {
                        phi_605_ = 38685626000000000000000000f;
                    } else {
                        phi_605_ = (1f / _e360);
                    }
                    let _e378 = phi_605_;
                    let _e379 = (_e264 == 0u);
                    if _e379 {
                        phi_614_ = _e301[0];
                    } else {
                        phi_614_ = _e301[1];
                    }
                    let _e383 = phi_614_;
                    let _e384 = (_e264 == 2u);
                    if _e384 {
                        phi_620_ = _e301[2];
                    } else {
                        phi_620_ = _e383;
                    }
                    let _e387 = phi_620_;
                    let _e389 = ((_e387 * _e274) * _e280);
                    if _e379 {
                        phi_631_ = _e313[0];
                    } else {
                        phi_631_ = _e313[1];
                    }
                    let _e393 = phi_631_;
                    if _e384 {
                        phi_637_ = _e313[2];
                    } else {
                        phi_637_ = _e393;
                    }
                    let _e396 = phi_637_;
                    let _e398 = ((_e396 * _e291) * _e297);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) * 0.00000011920929f);
                        phi_660_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_660_ = 0f;
                    }
                    let _e410 = phi_660_;
                    let _e411 = (_e389 + _e410);
                    let _e412 = (_e389 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_671_ = 38685626000000000000000000f;
                    } else {
                        phi_671_ = (1f / _e398);
                    }
                    let _e416 = phi_671_;
                    let _e419 = bitcast<f32>((bitcast<u32>(_e312) & 2147483647u));
                    let _e422 = bitcast<f32>((bitcast<u32>(_e351) & 2147483647u));
                    let _e424 = select(_e422, _e419, (_e419 > _e422));
                    let _e427 = bitcast<f32>((bitcast<u32>(_e389) & 2147483647u));
                    let _e430 = (_e131 + _e244);
                    if (_e225 && (select(_e427, _e424, (_e424 > _e427)) <= 1099511600000f)) {
                        let _e433 = (_e430 / 3i);
                        let _e440 = bitcast<f32>((bitcast<u32>((_e433 + 127i)) << bitcast<u32>(23i)));
                        let _e447 = bitcast<f32>((bitcast<u32>(((_e430 - (2i * _e433)) + 127i)) << bitcast<u32>(23i)));
                        let _e448 = (((_e210 * _e440) * _e440) * _e447);
                        let _e450 = select(340282350000000000000000000000000000000f, _e448, (_e448 < 340282350000000000000000000000000000000f));
                        let _e455 = (((_e219 * _e440) * _e440) * _e447);
                        let _e457 = select(340282350000000000000000000000000000000f, _e455, (_e455 < 340282350000000000000000000000000000000f));
                        phi_771_ = select(-340282350000000000000000000000000000000f, _e457, (_e457 > -340282350000000000000000000000000000000f));
                        phi_772_ = select(-340282350000000000000000000000000000000f, _e450, (_e450 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_771_ = 0f;
                        phi_772_ = 1f;
                    }
                    let _e461 = phi_771_;
                    let _e463 = phi_772_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e468 = (_e263 % 3u);
                    let _e469 = (_e468 < 3u);
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e471 = local_1[_e468];
                    let _e474 = (_e262 % 3u);
                    let _e475 = (_e474 < 3u);
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e477 = local_1[_e474];
                    let _e480 = (_e264 % 3u);
                    let _e481 = (_e480 < 3u);
                    if _e481 {
                    } else {
                        break;
                    }
                    let _e483 = local_1[_e480];
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e468];
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e492 = local[_e474];
                    if _e481 {
                    } else {
                        break;
                    }
                    let _e496 = local[_e480];
                    phi_3451_ = false;
                    phi_862_ = type_39(type_33(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e461), 0u, 0u);
                    phi_865_ = type_54(type_28(vec4<f32>((f32(_e471) * _e143), (f32(_e477) * _e143), (f32(_e483) * _e143), 0f), vec4<f32>((f32(_e488) * _e143), (f32(_e492) * _e143), (f32(_e496) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_867_ = ((3u * _e92) + 1u);
                    phi_869_ = (_e463 <= _e461);
                    phi_871_ = 0u;
                    loop {
                        let _e506 = phi_3451_;
                        let _e508 = phi_862_;
                        let _e510 = phi_865_;
                        let _e512 = phi_867_;
                        let _e514 = phi_869_;
                        let _e516 = phi_871_;
                        local_13 = _e508;
                        local_14 = _e508;
                        if _e514 {
                            phi_882_ = true;
                        } else {
                            phi_882_ = (_e516 > 0u);
                        }
                        let _e519 = phi_882_;
                        if _e519 {
                            let _e520 = (_e512 > 0u);
                            if _e520 {
                                if _e514 {
                                    phi_968_ = _e510;
                                    phi_969_ = _e514;
                                    phi_970_ = _e516;
                                } else {
                                    let _e521 = (_e516 - 1u);
                                    let _e522 = (_e521 % 128u);
                                    let _e523 = (_e522 < 128u);
                                    if _e523 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e525 = local_7[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e527 = local_6[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e529 = local_5[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e531 = local_4[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e533 = local_3[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e535 = local_2[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e540 = local_8[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3565_ = true;
                                        break;
                                    }
                                    let _e543 = local_9[_e522];
                                    phi_968_ = type_54(type_28(vec4<f32>(_e525, _e527, _e529, 0f), vec4<f32>(_e531, _e533, _e535, 0f)), _e540);
                                    phi_969_ = (_e543 <= _e508.member.member_1);
                                    phi_970_ = _e521;
                                }
                                let _e548 = phi_968_;
                                let _e550 = phi_969_;
                                let _e552 = phi_970_;
                                if _e550 {
                                    let _e557 = (_e548.member_1 & 268435455u);
                                    if ((_e548.member_1 & 2147483648u) != 0u) {
                                        phi_3448_ = _e506;
                                        phi_989_ = _e508;
                                        phi_992_ = type_8(0u, ((_e548.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1042 = phi_3448_;
                                            let _e1044 = phi_989_;
                                            let _e1046 = phi_992_;
                                            local_15 = _e1044;
                                            if (_e1046.member < _e1046.member_1) {
                                                phi_993_ = type_8((_e1046.member + 1u), _e1046.member_1);
                                                phi_1015_ = type_8(1u, _e1046.member);
                                            } else {
                                                phi_993_ = _e1046;
                                                phi_1015_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1059 = phi_993_;
                                            let _e1061 = phi_1015_;
                                            let _e1065 = (bitcast<i32>(_e1061.member) != 0i);
                                            if _e1065 {
                                                let _e1071 = type_39(_e1044.member, _e1044.member_1, (_e1044.member_2 + 1u));
                                                let _e1076 = (_e548.member.member_1.x - _e548.member.member.x);
                                                let _e1079 = (_e548.member.member_1.y - _e548.member.member.y);
                                                let _e1082 = (_e548.member.member_1.z - _e548.member.member.z);
                                                let _e1084 = select(_e1079, _e1076, (_e1076 > _e1079));
                                                let _e1086 = select(_e1082, _e1084, (_e1084 > _e1082));
                                                let _e1088 = (_e1086 < (1024f * _e143));
                                                if _e1088 {
                                                    phi_1059_ = 0u;
                                                } else {
                                                    phi_1059_ = select(2u, 1u, (_e1086 < (2097152f * _e143)));
                                                }
                                                let _e1093 = phi_1059_;
                                                switch bitcast<i32>(_e1093) {
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
                                                let _e1096 = phi_1065_;
                                                switch bitcast<i32>(_e1093) {
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
                                                let _e1103 = phi_1075_;
                                                let _e1105 = ((_e557 + (_e1061.member_1 * ((3u * _e1096) + 1u))) + (3u * _e1103));
                                                let _e1106 = (_e1105 < _e95);
                                                if _e1106 {
                                                    if _e1106 {
                                                    } else {
                                                        phi_3506_ = true;
                                                        break;
                                                    }
                                                    let _e1108 = global_5.member[_e1105];
                                                    phi_1091_ = _e1108;
                                                } else {
                                                    phi_1091_ = 4294967295u;
                                                }
                                                let _e1110 = phi_1091_;
                                                local_10 = array<u32, 3>(_e263, _e262, _e264);
                                                if _e1088 {
                                                    phi_1128_ = 0u;
                                                } else {
                                                    phi_1128_ = select(2u, 1u, (_e1086 < (2097152f * _e143)));
                                                }
                                                let _e1116 = phi_1128_;
                                                switch bitcast<i32>(_e1116) {
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
                                                let _e1119 = phi_1134_;
                                                switch bitcast<i32>(_e1116) {
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
                                                let _e1126 = phi_1144_;
                                                local_12 = array<f32, 4>(_e548.member.member.x, _e548.member.member.y, _e548.member.member.z, _e548.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3433_ = _e1042;
                                                phi_1160_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1140 = phi_3433_;
                                                    let _e1142 = phi_1160_;
                                                    if (_e1142.member < _e1142.member_1) {
                                                        phi_1161_ = type_8((_e1142.member + 1u), _e1142.member_1);
                                                        phi_1184_ = type_8(1u, _e1142.member);
                                                    } else {
                                                        phi_1161_ = _e1142;
                                                        phi_1184_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1155 = phi_1161_;
                                                    let _e1157 = phi_1184_;
                                                    let _e1161 = (bitcast<i32>(_e1157.member) != 0i);
                                                    if _e1161 {
                                                        let _e1163 = ((_e557 + (_e1061.member_1 * ((3u * _e1119) + 1u))) + (_e1157.member_1 * _e1126));
                                                        let _e1164 = (_e1163 < _e95);
                                                        if _e1164 {
                                                            if _e1164 {
                                                            } else {
                                                                phi_3504_ = true;
                                                                break;
                                                            }
                                                            let _e1166 = global_5.member[_e1163];
                                                            phi_1207_ = _e1166;
                                                        } else {
                                                            phi_1207_ = 0u;
                                                        }
                                                        let _e1168 = phi_1207_;
                                                        let _e1169 = (_e1163 + 1u);
                                                        let _e1170 = (_e1169 < _e95);
                                                        if _e1170 {
                                                            if _e1170 {
                                                            } else {
                                                                phi_3504_ = true;
                                                                break;
                                                            }
                                                            let _e1172 = global_5.member[_e1169];
                                                            phi_1222_ = _e1172;
                                                        } else {
                                                            phi_1222_ = 0u;
                                                        }
                                                        let _e1174 = phi_1222_;
                                                        phi_1225_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1176 = phi_1225_;
                                                            if (_e1176.member < _e1176.member_1) {
                                                                phi_1226_ = type_8((_e1176.member + 1u), _e1176.member_1);
                                                                phi_1249_ = type_8(1u, _e1176.member);
                                                            } else {
                                                                phi_1226_ = _e1176;
                                                                phi_1249_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1189 = phi_1226_;
                                                            let _e1191 = phi_1249_;
                                                            let _e1195 = (bitcast<i32>(_e1191.member) != 0i);
                                                            if _e1195 {
                                                                let _e1196 = (_e1191.member_1 < 3u);
                                                                if _e1196 {
                                                                } else {
                                                                    phi_3426_ = true;
                                                                    break;
                                                                }
                                                                let _e1198 = local_10[_e1191.member_1];
                                                                if (_e1191.member_1 < 4u) {
                                                                } else {
                                                                    phi_3426_ = true;
                                                                    break;
                                                                }
                                                                let _e1201 = local_12[_e1191.member_1];
                                                                switch bitcast<i32>(_e1116) {
                                                                    case 0: {
                                                                        phi_1319_ = (_e1201 + (f32(((_e1168 >> bitcast<u32>(((10u * _e1198) & 31u))) & 1023u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1198 == 0u) {
                                                                            phi_1296_ = _e1168;
                                                                        } else {
                                                                            if (_e1198 == 1u) {
                                                                                phi_1295_ = ((_e1168 >> bitcast<u32>(21i)) | (_e1174 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1295_ = (_e1174 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1222 = phi_1295_;
                                                                            phi_1296_ = _e1222;
                                                                        }
                                                                        let _e1224 = phi_1296_;
                                                                        phi_1319_ = (_e1201 + (f32((_e1224 & 2097151u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1203 = (_e1163 + _e1198);
                                                                        let _e1204 = (_e1203 < _e95);
                                                                        if _e1204 {
                                                                            if _e1204 {
                                                                            } else {
                                                                                phi_3426_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1206 = global_5.member[_e1203];
                                                                            phi_1315_ = _e1206;
                                                                        } else {
                                                                            phi_1315_ = 0u;
                                                                        }
                                                                        let _e1208 = phi_1315_;
                                                                        phi_1319_ = (f32(bitcast<i32>(_e1208)) * _e143);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1319_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1238 = phi_1319_;
                                                                if (_e1157.member_1 < 3u) {
                                                                } else {
                                                                    phi_3426_ = true;
                                                                    break;
                                                                }
                                                                if _e1196 {
                                                                } else {
                                                                    phi_3426_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1157.member_1][_e1191.member_1] = _e1238;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1225_ = _e1189;
                                                                phi_3426_ = _e1140;
                                                                break if !(_e1195);
                                                            }
                                                        }
                                                        let _e1244 = phi_3426_;
                                                        phi_3504_ = _e1244;
                                                        if _e1244 {
                                                            break;
                                                        }
                                                        phi_3505_ = _e1244;
                                                    } else {
                                                        phi_3505_ = _e1140;
                                                    }
                                                    let _e1246 = phi_3505_;
                                                    continue;
                                                    continuing {
                                                        phi_3433_ = _e1246;
                                                        phi_1160_ = _e1155;
                                                        phi_3504_ = _e1246;
                                                        break if !(_e1161);
                                                    }
                                                }
                                                let _e1249 = phi_3504_;
                                                phi_3506_ = _e1249;
                                                if _e1249 {
                                                    break;
                                                }
                                                let _e1250 = local_11;
                                                let _e1267 = (_e1250[0][2] - _e389);
                                                let _e1270 = (((_e1250[0][0] - _e312) * _e413) - (_e1267 * _e337));
                                                let _e1273 = (((_e1250[0][1] - _e351) * _e413) - (_e1267 * _e375));
                                                let _e1276 = (_e1250[1][2] - _e389);
                                                let _e1279 = (((_e1250[1][0] - _e312) * _e413) - (_e1276 * _e337));
                                                let _e1282 = (((_e1250[1][1] - _e351) * _e413) - (_e1276 * _e375));
                                                let _e1285 = (_e1250[2][2] - _e389);
                                                let _e1288 = (((_e1250[2][0] - _e312) * _e413) - (_e1285 * _e337));
                                                let _e1291 = (((_e1250[2][1] - _e351) * _e413) - (_e1285 * _e375));
                                                let _e1292 = (_e1288 * _e1282);
                                                let _e1293 = (_e1291 * _e1279);
                                                let _e1294 = (_e1270 * _e1291);
                                                let _e1295 = (_e1273 * _e1288);
                                                let _e1296 = (_e1279 * _e1273);
                                                let _e1297 = (_e1282 * _e1270);
                                                let _e1302 = (((_e1292 >= _e1293) && (_e1294 >= _e1295)) && (_e1296 >= _e1297));
                                                if (_e1302 || (((_e1292 <= _e1293) && (_e1294 <= _e1295)) && (_e1296 <= _e1297))) {
                                                    let _e1309 = select(-1f, 1f, _e1302);
                                                    let _e1311 = ((_e1292 - _e1293) * _e1309);
                                                    let _e1313 = select(0f, _e1311, (_e1311 > 0f));
                                                    let _e1315 = ((_e1294 - _e1295) * _e1309);
                                                    let _e1317 = select(0f, _e1315, (_e1315 > 0f));
                                                    let _e1319 = ((_e1296 - _e1297) * _e1309);
                                                    let _e1321 = select(0f, _e1319, (_e1319 > 0f));
                                                    let _e1323 = ((_e1313 + _e1317) + _e1321);
                                                    if (_e1323 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1914_ = type_24();
                                                        phi_1915_ = true;
                                                    } else {
                                                        let _e1326 = select(_e1250[1][0], _e1250[0][0], (_e1250[0][0] < _e1250[1][0]));
                                                        let _e1330 = select(_e1250[1][0], _e1250[0][0], (_e1250[0][0] > _e1250[1][0]));
                                                        let _e1334 = select(_e1250[1][1], _e1250[0][1], (_e1250[0][1] < _e1250[1][1]));
                                                        let _e1338 = select(_e1250[1][1], _e1250[0][1], (_e1250[0][1] > _e1250[1][1]));
                                                        let _e1342 = select(_e1250[1][2], _e1250[0][2], (_e1250[0][2] < _e1250[1][2]));
                                                        let _e1346 = select(_e1250[1][2], _e1250[0][2], (_e1250[0][2] > _e1250[1][2]));
                                                        let _e1351 = ((select(_e1250[2][0], _e1326, (_e1326 < _e1250[2][0])) - _e335) * _e340);
                                                        let _e1352 = ((select(_e1250[2][0], _e1330, (_e1330 > _e1250[2][0])) - _e336) * _e340);
                                                        let _e1355 = ((select(_e1250[2][1], _e1334, (_e1334 < _e1250[2][1])) - _e373) * _e378);
                                                        let _e1356 = ((select(_e1250[2][1], _e1338, (_e1338 > _e1250[2][1])) - _e374) * _e378);
                                                        let _e1359 = ((select(_e1250[2][2], _e1342, (_e1342 < _e1250[2][2])) - _e411) * _e416);
                                                        let _e1360 = ((select(_e1250[2][2], _e1346, (_e1346 > _e1250[2][2])) - _e412) * _e416);
                                                        let _e1362 = select(_e1360, _e1359, (_e1359 < _e1360));
                                                        let _e1364 = select(_e1360, _e1359, (_e1359 > _e1360));
                                                        let _e1366 = select(_e1352, _e1351, (_e1351 < _e1352));
                                                        let _e1368 = select(_e1356, _e1355, (_e1355 < _e1356));
                                                        let _e1370 = select(_e1368, _e1366, (_e1366 > _e1368));
                                                        let _e1372 = select(_e1362, _e1370, (_e1370 > _e1362));
                                                        let _e1374 = select(_e1352, _e1351, (_e1351 > _e1352));
                                                        let _e1376 = select(_e1356, _e1355, (_e1355 > _e1356));
                                                        let _e1378 = select(_e1376, _e1374, (_e1374 < _e1376));
                                                        let _e1380 = select(_e1364, _e1378, (_e1378 < _e1364));
                                                        let _e1381 = -(_e1362);
                                                        let _e1387 = select(_e463, _e1372, (_e1372 > _e463));
                                                        if (_e1387 > (_e1380 + (select(_e1381, _e1364, (_e1364 > _e1381)) * 0.0000019073523f))) {
                                                            phi_1909_ = type_24();
                                                            phi_1910_ = true;
                                                        } else {
                                                            let _e1389 = (_e1387 > _e1044.member.member_1);
                                                            if _e1389 {
                                                                phi_1908_ = type_24();
                                                            } else {
                                                                let _e1393 = (_e1250[1][0] - _e1250[0][0]);
                                                                let _e1394 = (_e1250[1][1] - _e1250[0][1]);
                                                                let _e1395 = (_e1250[1][2] - _e1250[0][2]);
                                                                let _e1396 = vec3<f32>(_e1393, _e1394, _e1395);
                                                                let _e1397 = (_e1250[2][0] - _e1250[1][0]);
                                                                let _e1398 = (_e1250[2][1] - _e1250[1][1]);
                                                                let _e1399 = (_e1250[2][2] - _e1250[1][2]);
                                                                let _e1400 = vec3<f32>(_e1397, _e1398, _e1399);
                                                                let _e1401 = (_e1250[0][0] - _e1250[2][0]);
                                                                let _e1402 = (_e1250[0][1] - _e1250[2][1]);
                                                                let _e1403 = (_e1250[0][2] - _e1250[2][2]);
                                                                let _e1404 = vec3<f32>(_e1401, _e1402, _e1403);
                                                                let _e1407 = bitcast<f32>((bitcast<u32>(_e1393) & 2147483647u));
                                                                let _e1410 = bitcast<f32>((bitcast<u32>(_e1394) & 2147483647u));
                                                                let _e1412 = select(_e1410, _e1407, (_e1407 > _e1410));
                                                                let _e1415 = bitcast<f32>((bitcast<u32>(_e1395) & 2147483647u));
                                                                let _e1417 = select(_e1415, _e1412, (_e1412 > _e1415));
                                                                let _e1420 = bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u));
                                                                let _e1423 = bitcast<f32>((bitcast<u32>(_e1398) & 2147483647u));
                                                                let _e1425 = select(_e1423, _e1420, (_e1420 > _e1423));
                                                                let _e1428 = bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u));
                                                                let _e1430 = select(_e1428, _e1425, (_e1425 > _e1428));
                                                                let _e1433 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                                let _e1436 = bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u));
                                                                let _e1438 = select(_e1436, _e1433, (_e1433 > _e1436));
                                                                let _e1441 = bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u));
                                                                let _e1443 = select(_e1441, _e1438, (_e1438 > _e1441));
                                                                let _e1445 = select(_e1430, _e1417, (_e1417 > _e1430));
                                                                let _e1447 = select(_e1443, _e1445, (_e1445 > _e1443));
                                                                if (_e1417 == _e1447) {
                                                                    phi_1819_ = _e1400;
                                                                    phi_1820_ = _e1404;
                                                                } else {
                                                                    let _e1450 = vec3((_e1430 == _e1447));
                                                                    phi_1819_ = select(_e1396, _e1404, _e1450);
                                                                    phi_1820_ = select(_e1400, _e1396, _e1450);
                                                                }
                                                                let _e1454 = phi_1819_;
                                                                let _e1456 = phi_1820_;
                                                                let _e1463 = ((_e1454.y * _e1456.z) - (_e1456.y * _e1454.z));
                                                                let _e1468 = ((_e1454.z * _e1456.x) - (_e1456.z * _e1454.x));
                                                                let _e1471 = ((_e1454.x * _e1456.y) - (_e1456.x * _e1454.y));
                                                                if (_e1313 >= _e1317) {
                                                                    phi_1851_ = select(true, false, (_e1313 >= _e1321));
                                                                } else {
                                                                    phi_1851_ = true;
                                                                }
                                                                let _e1476 = phi_1851_;
                                                                if _e1476 {
                                                                    phi_1860_ = select(vec3<f32>(_e1250[2][0], _e1250[2][1], _e1250[2][2]), vec3<f32>(_e1250[1][0], _e1250[1][1], _e1250[1][2]), vec3((_e1317 >= _e1321)));
                                                                } else {
                                                                    phi_1860_ = vec3<f32>(_e1250[0][0], _e1250[0][1], _e1250[0][2]);
                                                                }
                                                                let _e1481 = phi_1860_;
                                                                let _e1498 = ((((_e1463 * (_e1481.x - _e312)) + (_e1468 * (_e1481.y - _e351))) + (_e1471 * (_e1481.z - _e389))) / (((_e1463 * _e337) + (_e1468 * _e375)) + (_e1471 * _e413)));
                                                                let _e1500 = select(_e1380, _e1498, (_e1498 < _e1380));
                                                                let _e1502 = select(_e1372, _e1500, (_e1500 > _e1372));
                                                                if (_e1502 >= _e463) {
                                                                    let _e1504 = (_e1502 <= _e1044.member.member_1);
                                                                    if _e1504 {
                                                                        let _e1505 = (1f / _e1323);
                                                                        phi_1900_ = type_24(_e1502, (_e1317 * _e1505), (_e1321 * _e1505), _e1110);
                                                                    } else {
                                                                        phi_1900_ = type_24();
                                                                    }
                                                                    let _e1510 = phi_1900_;
                                                                    phi_1902_ = _e1510;
                                                                    phi_1903_ = select(true, false, _e1504);
                                                                } else {
                                                                    phi_1902_ = type_24();
                                                                    phi_1903_ = true;
                                                                }
                                                                let _e1513 = phi_1902_;
                                                                let _e1515 = phi_1903_;
                                                                if _e1515 {
                                                                    phi_1907_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1907_ = _e1513;
                                                                }
                                                                let _e1517 = phi_1907_;
                                                                phi_1908_ = _e1517;
                                                            }
                                                            let _e1519 = phi_1908_;
                                                            phi_1909_ = _e1519;
                                                            phi_1910_ = _e1389;
                                                        }
                                                        let _e1521 = phi_1909_;
                                                        let _e1523 = phi_1910_;
                                                        phi_1914_ = _e1521;
                                                        phi_1915_ = _e1523;
                                                    }
                                                    let _e1525 = phi_1914_;
                                                    let _e1527 = phi_1915_;
                                                    phi_1919_ = _e1525;
                                                    phi_1920_ = _e1527;
                                                } else {
                                                    phi_1919_ = type_24();
                                                    phi_1920_ = true;
                                                }
                                                let _e1529 = phi_1919_;
                                                let _e1531 = phi_1920_;
                                                if _e1531 {
                                                    phi_1924_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1924_ = _e1529;
                                                }
                                                let _e1533 = phi_1924_;
                                                if (_e1533.member_3 != 4294967295u) {
                                                    if (_e1110 != 4294967295u) {
                                                        if (_e1533.member < _e1044.member.member.member) {
                                                            phi_1950_ = true;
                                                        } else {
                                                            if (_e1533.member == _e1044.member.member.member) {
                                                                phi_1949_ = (_e1533.member_3 < _e1044.member.member.member_3);
                                                            } else {
                                                                phi_1949_ = false;
                                                            }
                                                            let _e1548 = phi_1949_;
                                                            phi_1950_ = _e1548;
                                                        }
                                                        let _e1550 = phi_1950_;
                                                        if _e1550 {
                                                            phi_1957_ = type_39(type_33(_e1533, _e1533.member), _e1071.member_1, _e1071.member_2);
                                                        } else {
                                                            phi_1957_ = _e1071;
                                                        }
                                                        let _e1557 = phi_1957_;
                                                        phi_1958_ = _e1557;
                                                    } else {
                                                        phi_1958_ = _e1071;
                                                    }
                                                    let _e1559 = phi_1958_;
                                                    phi_1959_ = _e1559;
                                                } else {
                                                    phi_1959_ = _e1071;
                                                }
                                                let _e1561 = phi_1959_;
                                                phi_3507_ = _e1249;
                                                phi_990_ = _e1561;
                                            } else {
                                                phi_3507_ = _e1042;
                                                phi_990_ = type_39();
                                            }
                                            let _e1563 = phi_3507_;
                                            let _e1565 = phi_990_;
                                            continue;
                                            continuing {
                                                phi_3448_ = _e1563;
                                                phi_989_ = _e1565;
                                                phi_992_ = _e1059;
                                                phi_3506_ = _e1563;
                                                break if !(_e1065);
                                            }
                                        }
                                        let _e1568 = phi_3506_;
                                        phi_3565_ = _e1568;
                                        if _e1568 {
                                            break;
                                        }
                                        phi_3569_ = _e1568;
                                        let _e1746 = local_15;
                                        phi_3202_ = _e1746;
                                        phi_3203_ = _e548;
                                        phi_3204_ = false;
                                        phi_3205_ = _e552;
                                    } else {
                                        if (_e548.member_1 >= _e92) {
                                            phi_2758_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e548.member_1 < _e92) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e570 = (_e263 * 2u);
                                            let _e572 = ((1u + _e570) % 7u);
                                            if (_e572 < 7u) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e577 = global_4.member[_e548.member_1][_e572];
                                            let _e579 = ((_e570 + 2u) % 7u);
                                            if (_e579 < 7u) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e584 = global_4.member[_e548.member_1][_e579];
                                            let _e585 = (_e262 * 2u);
                                            let _e587 = ((1u + _e585) % 7u);
                                            if (_e587 < 7u) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e592 = global_4.member[_e548.member_1][_e587];
                                            let _e594 = ((_e585 + 2u) % 7u);
                                            if (_e594 < 7u) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e599 = global_4.member[_e548.member_1][_e594];
                                            let _e600 = (_e264 * 2u);
                                            let _e602 = ((1u + _e600) % 7u);
                                            if (_e602 < 7u) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e607 = global_4.member[_e548.member_1][_e602];
                                            let _e609 = ((_e600 + 2u) % 7u);
                                            if (_e609 < 7u) {
                                            } else {
                                                phi_3565_ = true;
                                                break;
                                            }
                                            let _e614 = global_4.member[_e548.member_1][_e609];
                                            let _e637 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.x - _e548.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e638 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.y - _e548.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e639 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.z - _e548.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e641 = select(_e143, _e637, (_e637 > _e143));
                                            let _e643 = select(_e143, _e638, (_e638 > _e143));
                                            let _e645 = select(_e143, _e639, (_e639 > _e143));
                                            let _e670 = bitcast<u32>((f32(bitcast<i32>((_e577 & 2097151u))) * _e641));
                                            let _e675 = (bitcast<i32>((_e577 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e678 = bitcast<f32>((_e670 & bitcast<u32>(_e675)));
                                            let _e679 = bitcast<u32>((f32(bitcast<i32>((_e592 & 2097151u))) * _e643));
                                            let _e684 = (bitcast<i32>((_e592 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e687 = bitcast<f32>((_e679 & bitcast<u32>(_e684)));
                                            let _e688 = bitcast<u32>((f32(bitcast<i32>((_e607 & 2097151u))) * _e645));
                                            let _e693 = (bitcast<i32>((_e607 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e696 = bitcast<f32>((_e688 & bitcast<u32>(_e693)));
                                            let _e700 = bitcast<f32>((_e670 & bitcast<u32>(~(_e675))));
                                            let _e704 = bitcast<f32>((_e679 & bitcast<u32>(~(_e684))));
                                            let _e708 = bitcast<f32>((_e688 & bitcast<u32>(~(_e693))));
                                            let _e709 = bitcast<u32>((f32(bitcast<i32>((_e584 & 2097151u))) * _e641));
                                            let _e714 = (bitcast<i32>((_e584 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e717 = bitcast<f32>((_e709 & bitcast<u32>(_e714)));
                                            let _e718 = bitcast<u32>((f32(bitcast<i32>((_e599 & 2097151u))) * _e643));
                                            let _e723 = (bitcast<i32>((_e599 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e726 = bitcast<f32>((_e718 & bitcast<u32>(_e723)));
                                            let _e727 = bitcast<u32>((f32(bitcast<i32>((_e614 & 2097151u))) * _e645));
                                            let _e732 = (bitcast<i32>((_e614 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e735 = bitcast<f32>((_e727 & bitcast<u32>(_e732)));
                                            let _e739 = bitcast<f32>((_e709 & bitcast<u32>(~(_e714))));
                                            let _e743 = bitcast<f32>((_e718 & bitcast<u32>(~(_e723))));
                                            let _e747 = bitcast<f32>((_e727 & bitcast<u32>(~(_e732))));
                                            let _e748 = (_e548.member.member.x + _e678);
                                            let _e749 = (_e548.member.member.y + _e687);
                                            let _e750 = (_e548.member.member.z + _e696);
                                            let _e753 = (_e548.member.member_1.x - _e717);
                                            let _e754 = (_e548.member.member_1.y - _e726);
                                            let _e755 = (_e548.member.member_1.z - _e735);
                                            let _e774 = (_e753 - _e748);
                                            let _e775 = (_e754 - _e749);
                                            let _e776 = (_e755 - _e750);
                                            let _e778 = select(_e775, _e774, (_e774 > _e775));
                                            let _e780 = select(_e776, _e778, (_e778 > _e776));
                                            if (_e780 < (1024f * _e143)) {
                                                phi_2459_ = 0u;
                                            } else {
                                                phi_2459_ = select(2u, 1u, (_e780 < (2097152f * _e143)));
                                            }
                                            let _e787 = phi_2459_;
                                            switch bitcast<i32>(_e787) {
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
                                            let _e790 = phi_2465_;
                                            let _e796 = global_4.member[_e548.member_1][0u];
                                            let _e800 = global_4.member[_e548.member_1][2u];
                                            let _e804 = global_4.member[_e548.member_1][4u];
                                            let _e808 = global_4.member[_e548.member_1][6u];
                                            let _e820 = (((_e800 >> bitcast<u32>(22i)) | ((_e804 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e808 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e821 = (_e796 & 268435455u);
                                            let _e822 = (_e820 & 268435455u);
                                            let _e825 = ((_e796 >> bitcast<u32>(28u)) & 7u);
                                            let _e833 = ((_e796 >> bitcast<u32>(31i)) | (((_e820 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e834 = (_e825 != 0u);
                                            if (_e825 == 0u) {
                                                phi_2720_ = _e821;
                                            } else {
                                                if (_e825 == 7u) {
                                                    phi_2719_ = 2147483648u;
                                                } else {
                                                    phi_2719_ = ((2147483648u | (_e825 << bitcast<u32>(28u))) | (_e822 & 268435455u));
                                                }
                                                let _e843 = phi_2719_;
                                                phi_2720_ = _e843;
                                            }
                                            let _e845 = phi_2720_;
                                            if _e834 {
                                                let _e846 = (_e825 != 7u);
                                                if _e846 {
                                                    phi_2730_ = (_e822 + (_e825 * ((3u * _e790) + 1u)));
                                                } else {
                                                    phi_2730_ = u32();
                                                }
                                                let _e850 = phi_2730_;
                                                phi_2732_ = _e850;
                                                phi_2733_ = select(true, false, _e846);
                                            } else {
                                                phi_2732_ = u32();
                                                phi_2733_ = true;
                                            }
                                            let _e853 = phi_2732_;
                                            let _e855 = phi_2733_;
                                            if (_e833 == 0u) {
                                                phi_2754_ = (_e821 + select(0u, 1u, !(_e834)));
                                            } else {
                                                if (_e833 == 7u) {
                                                    phi_2753_ = 2147483648u;
                                                } else {
                                                    phi_2753_ = ((2147483648u | (_e833 << bitcast<u32>(28u))) | (select(_e853, _e822, _e855) & 268435455u));
                                                }
                                                let _e868 = phi_2753_;
                                                phi_2754_ = _e868;
                                            }
                                            let _e870 = phi_2754_;
                                            phi_2758_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e748, (_e548.member.member.x + _e700), _e753, (_e548.member.member_1.x - _e739)), vec4<f32>(_e749, (_e548.member.member.y + _e704), _e754, (_e548.member.member_1.y - _e743)), vec4<f32>(_e750, (_e548.member.member.z + _e708), _e755, (_e548.member.member_1.z - _e747))), type_54(type_28((_e548.member.member + vec4<f32>(_e678, _e687, _e696, 0f)), (_e548.member.member_1 - vec4<f32>(_e717, _e726, _e735, 0f))), _e845), type_54(type_28((_e548.member.member + vec4<f32>(_e700, _e704, _e708, 0f)), (_e548.member.member_1 - vec4<f32>(_e739, _e743, _e747, 0f))), _e870));
                                        }
                                        let _e875 = phi_2758_;
                                        let _e888 = ((_e875.member[0].x - _e335) * _e340);
                                        let _e889 = ((_e875.member[0].y - _e335) * _e340);
                                        let _e890 = ((_e875.member[0].z - _e336) * _e340);
                                        let _e891 = ((_e875.member[0].w - _e336) * _e340);
                                        let _e901 = ((_e875.member[1].x - _e373) * _e378);
                                        let _e902 = ((_e875.member[1].y - _e373) * _e378);
                                        let _e903 = ((_e875.member[1].z - _e374) * _e378);
                                        let _e904 = ((_e875.member[1].w - _e374) * _e378);
                                        let _e914 = ((_e875.member[2].x - _e411) * _e416);
                                        let _e915 = ((_e875.member[2].y - _e411) * _e416);
                                        let _e916 = ((_e875.member[2].z - _e412) * _e416);
                                        let _e917 = ((_e875.member[2].w - _e412) * _e416);
                                        let _e919 = select(_e916, _e914, (_e914 < _e916));
                                        let _e921 = select(_e917, _e915, (_e915 < _e917));
                                        let _e923 = select(_e916, _e914, (_e914 > _e916));
                                        let _e925 = select(_e917, _e915, (_e915 > _e917));
                                        let _e927 = select(_e890, _e888, (_e888 < _e890));
                                        let _e929 = select(_e891, _e889, (_e889 < _e891));
                                        let _e931 = select(_e903, _e901, (_e901 < _e903));
                                        let _e933 = select(_e904, _e902, (_e902 < _e904));
                                        let _e935 = select(_e931, _e927, (_e927 > _e931));
                                        let _e937 = select(_e933, _e929, (_e929 > _e933));
                                        let _e939 = select(_e919, _e935, (_e935 > _e919));
                                        let _e941 = select(_e921, _e937, (_e937 > _e921));
                                        let _e943 = select(_e890, _e888, (_e888 > _e890));
                                        let _e945 = select(_e891, _e889, (_e889 > _e891));
                                        let _e947 = select(_e903, _e901, (_e901 > _e903));
                                        let _e949 = select(_e904, _e902, (_e902 > _e904));
                                        let _e951 = select(_e947, _e943, (_e943 < _e947));
                                        let _e953 = select(_e949, _e945, (_e945 < _e949));
                                        let _e958 = -(_e919);
                                        let _e959 = -(_e921);
                                        let _e966 = (select(_e923, _e951, (_e951 < _e923)) + (select(_e958, _e923, (_e923 > _e958)) * 0.0000019073523f));
                                        let _e967 = (select(_e925, _e953, (_e953 < _e925)) + (select(_e959, _e925, (_e925 > _e959)) * 0.0000019073523f));
                                        let _e969 = select(_e463, _e939, (_e939 > _e463));
                                        let _e971 = select(_e463, _e941, (_e941 > _e463));
                                        let _e976 = (_e969 <= select(_e508.member.member_1, _e966, (_e966 < _e508.member.member_1)));
                                        let _e977 = (_e971 <= select(_e508.member.member_1, _e967, (_e967 < _e508.member.member_1)));
                                        let _e978 = (_e969 <= _e971);
                                        if _e976 {
                                            if _e977 {
                                                if _e978 {
                                                    phi_3102_ = _e875.member_2;
                                                } else {
                                                    phi_3102_ = _e875.member_1;
                                                }
                                                let _e982 = phi_3102_;
                                                let _e1004 = (_e552 % 128u);
                                                let _e1005 = (_e1004 < 128u);
                                                if _e1005 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_8[_e1004] = _e982.member_1;
                                                if _e1005 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_7[_e1004] = _e982.member.member.x;
                                                if _e1005 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_6[_e1004] = _e982.member.member.y;
                                                if _e1005 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_5[_e1004] = _e982.member.member.z;
                                                if _e1005 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_4[_e1004] = _e982.member.member_1.x;
                                                if _e1005 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_3[_e1004] = _e982.member.member_1.y;
                                                if _e1005 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_2[_e1004] = _e982.member.member_1.z;
                                                if _e1005 {
                                                } else {
                                                    phi_3565_ = true;
                                                    break;
                                                }
                                                local_9[_e1004] = select(_e971, _e969, (_e969 > _e971));
                                                if _e978 {
                                                    phi_3179_ = _e875.member_1;
                                                } else {
                                                    phi_3179_ = _e875.member_2;
                                                }
                                                let _e1018 = phi_3179_;
                                                phi_3180_ = _e1018;
                                                phi_3181_ = (_e552 + 1u);
                                            } else {
                                                phi_3180_ = type_54();
                                                phi_3181_ = u32();
                                            }
                                            let _e1020 = phi_3180_;
                                            let _e1022 = phi_3181_;
                                            phi_3183_ = _e1020;
                                            phi_3184_ = _e1022;
                                            phi_3185_ = select(true, false, _e977);
                                        } else {
                                            phi_3183_ = type_54();
                                            phi_3184_ = u32();
                                            phi_3185_ = true;
                                        }
                                        let _e1025 = phi_3183_;
                                        let _e1027 = phi_3184_;
                                        let _e1029 = phi_3185_;
                                        if _e1029 {
                                            if _e976 {
                                                phi_3194_ = _e875.member_1;
                                            } else {
                                                phi_3194_ = _e875.member_2;
                                            }
                                            let _e1033 = phi_3194_;
                                            phi_3199_ = _e1033;
                                            phi_3200_ = select(_e977, true, _e976);
                                        } else {
                                            phi_3199_ = _e1025;
                                            phi_3200_ = _e550;
                                        }
                                        let _e1036 = phi_3199_;
                                        let _e1038 = phi_3200_;
                                        phi_3569_ = _e506;
                                        phi_3202_ = type_39(_e508.member, (_e508.member_1 + 1u), _e508.member_2);
                                        phi_3203_ = _e1036;
                                        phi_3204_ = _e1038;
                                        phi_3205_ = select(_e1027, _e552, _e1029);
                                    }
                                    let _e1570 = phi_3569_;
                                    let _e1572 = phi_3202_;
                                    let _e1574 = phi_3203_;
                                    let _e1576 = phi_3204_;
                                    let _e1578 = phi_3205_;
                                    phi_3568_ = _e1570;
                                    phi_3206_ = _e1572;
                                    phi_3207_ = _e1574;
                                    phi_3208_ = (_e512 - 1u);
                                    phi_3209_ = _e1576;
                                    phi_3210_ = _e1578;
                                } else {
                                    phi_3568_ = _e506;
                                    phi_3206_ = _e508;
                                    phi_3207_ = _e548;
                                    phi_3208_ = _e512;
                                    phi_3209_ = _e550;
                                    phi_3210_ = _e552;
                                }
                                let _e1580 = phi_3568_;
                                let _e1582 = phi_3206_;
                                let _e1584 = phi_3207_;
                                let _e1586 = phi_3208_;
                                let _e1588 = phi_3209_;
                                let _e1590 = phi_3210_;
                                phi_3567_ = _e1580;
                                phi_3211_ = _e1582;
                                phi_3212_ = _e1584;
                                phi_3213_ = _e1586;
                                phi_3214_ = _e1588;
                                phi_3215_ = _e1590;
                            } else {
                                phi_3567_ = _e506;
                                phi_3211_ = type_39();
                                phi_3212_ = type_54();
                                phi_3213_ = u32();
                                phi_3214_ = bool();
                                phi_3215_ = u32();
                            }
                            let _e1592 = phi_3567_;
                            let _e1594 = phi_3211_;
                            let _e1596 = phi_3212_;
                            let _e1598 = phi_3213_;
                            let _e1600 = phi_3214_;
                            let _e1602 = phi_3215_;
                            phi_3566_ = _e1592;
                            phi_863_ = _e1594;
                            phi_866_ = _e1596;
                            phi_868_ = _e1598;
                            phi_870_ = _e1600;
                            phi_872_ = _e1602;
                            phi_3216_ = _e520;
                        } else {
                            phi_3566_ = _e506;
                            phi_863_ = type_39();
                            phi_866_ = type_54();
                            phi_868_ = u32();
                            phi_870_ = bool();
                            phi_872_ = u32();
                            phi_3216_ = false;
                        }
                        let _e1604 = phi_3566_;
                        let _e1606 = phi_863_;
                        let _e1608 = phi_866_;
                        let _e1610 = phi_868_;
                        let _e1612 = phi_870_;
                        let _e1614 = phi_872_;
                        let _e1616 = phi_3216_;
                        continue;
                        continuing {
                            phi_3451_ = _e1604;
                            phi_862_ = _e1606;
                            phi_865_ = _e1608;
                            phi_867_ = _e1610;
                            phi_869_ = _e1612;
                            phi_871_ = _e1614;
                            phi_3565_ = _e1604;
                            break if !(_e1616);
                        }
                    }
                    let _e1619 = phi_3565_;
                    if _e1619 {
                        break;
                    }
                    let _e1621 = local_13;
                    let _e1624 = local_14;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_6.member[_e149][0u] = _e1621.member_1;
                    global_6.member[_e149][1u] = _e1624.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
