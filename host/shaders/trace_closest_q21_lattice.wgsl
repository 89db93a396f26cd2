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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
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
    member: type_20,
    member_1: f32,
}

struct type_37 {
    member: array<type_24>,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<array<u32, 7>>,
}

struct type_53 {
    member: type_28,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(4) 
var<storage> global_3: type_37;
@group(0) @binding(2) 
var<storage> global_4: type_47;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_22;

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
    var phi_3629_: bool;
    var phi_861_: type_33;
    var phi_864_: type_53;
    var phi_866_: u32;
    var phi_868_: bool;
    var phi_870_: u32;
    var phi_881_: bool;
    var phi_967_: type_53;
    var phi_968_: bool;
    var phi_969_: u32;
    var phi_2593_: u32;
    var phi_2599_: u32;
    var phi_2853_: u32;
    var phi_2854_: u32;
    var phi_2864_: u32;
    var phi_2866_: u32;
    var phi_2867_: bool;
    var phi_2887_: u32;
    var phi_2888_: u32;
    var phi_2892_: type_54;
    var phi_3236_: type_53;
    var phi_3313_: type_53;
    var phi_3314_: type_53;
    var phi_3315_: u32;
    var phi_3317_: type_53;
    var phi_3318_: u32;
    var phi_3319_: bool;
    var phi_3328_: type_53;
    var phi_3333_: type_53;
    var phi_3334_: bool;
    var phi_3626_: bool;
    var phi_988_: type_33;
    var phi_991_: type_8;
    var phi_992_: type_8;
    var phi_1014_: type_8;
    var phi_1055_: u32;
    var phi_1061_: u32;
    var phi_1071_: u32;
    var phi_1087_: u32;
    var phi_1124_: u32;
    var phi_1130_: u32;
    var phi_1140_: u32;
    var phi_3611_: bool;
    var phi_1156_: type_8;
    var phi_1157_: type_8;
    var phi_1180_: type_8;
    var phi_1203_: u32;
    var phi_1218_: u32;
    var phi_1221_: type_8;
    var phi_1222_: type_8;
    var phi_1245_: type_8;
    var phi_1311_: u32;
    var phi_1291_: u32;
    var phi_1292_: u32;
    var phi_1315_: f32;
    var phi_3604_: bool;
    var phi_3683_: bool;
    var phi_3682_: bool;
    var phi_1815_: vec3<f32>;
    var phi_1816_: vec3<f32>;
    var phi_1847_: bool;
    var phi_1856_: vec3<f32>;
    var phi_1896_: type_20;
    var phi_1898_: type_20;
    var phi_1899_: bool;
    var phi_1903_: type_20;
    var phi_1904_: type_20;
    var phi_1905_: type_20;
    var phi_1906_: bool;
    var phi_1910_: type_20;
    var phi_1911_: bool;
    var phi_1915_: type_20;
    var phi_1916_: bool;
    var phi_1920_: type_20;
    var phi_1945_: bool;
    var phi_1946_: bool;
    var phi_1952_: type_33;
    var phi_1953_: type_33;
    var phi_1954_: type_33;
    var phi_3685_: bool;
    var phi_989_: type_33;
    var phi_3684_: bool;
    var phi_3747_: bool;
    var phi_3336_: type_33;
    var phi_3337_: type_53;
    var phi_3338_: bool;
    var phi_3339_: u32;
    var phi_3746_: bool;
    var phi_3340_: type_33;
    var phi_3341_: type_53;
    var phi_3342_: u32;
    var phi_3343_: bool;
    var phi_3344_: u32;
    var phi_3745_: bool;
    var phi_3345_: type_33;
    var phi_3346_: type_53;
    var phi_3347_: u32;
    var phi_3348_: bool;
    var phi_3349_: u32;
    var phi_3744_: bool;
    var phi_862_: type_33;
    var phi_865_: type_53;
    var phi_867_: u32;
    var phi_869_: bool;
    var phi_871_: u32;
    var phi_3350_: bool;
    var phi_3743_: bool;
    var local_13: type_33;
    var phi_3402_: type_20;
    var local_14: type_33;

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
                    let _e467 = (_e263 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_1[_e467];
                    let _e473 = (_e262 % 3u);
                    let _e474 = (_e473 < 3u);
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e476 = local_1[_e473];
                    let _e479 = (_e264 % 3u);
                    let _e480 = (_e479 < 3u);
                    if _e480 {
                    } else {
                        break;
                    }
                    let _e482 = local_1[_e479];
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e487 = local[_e467];
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e491 = local[_e473];
                    if _e480 {
                    } else {
                        break;
                    }
                    let _e495 = local[_e479];
                    phi_3629_ = false;
                    phi_861_ = type_33(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e461);
                    phi_864_ = type_53(type_28(vec4<f32>((f32(_e470) * _e143), (f32(_e476) * _e143), (f32(_e482) * _e143), 0f), vec4<f32>((f32(_e487) * _e143), (f32(_e491) * _e143), (f32(_e495) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_866_ = ((3u * _e92) + 1u);
                    phi_868_ = (_e463 <= _e461);
                    phi_870_ = 0u;
                    loop {
                        let _e505 = phi_3629_;
                        let _e507 = phi_861_;
                        let _e509 = phi_864_;
                        let _e511 = phi_866_;
                        let _e513 = phi_868_;
                        let _e515 = phi_870_;
                        local_13 = _e507;
                        if _e513 {
                            phi_881_ = true;
                        } else {
                            phi_881_ = (_e515 > 0u);
                        }
                        let _e518 = phi_881_;
                        if _e518 {
                            let _e519 = (_e511 > 0u);
                            if _e519 {
                                if _e513 {
                                    phi_967_ = _e509;
                                    phi_968_ = _e513;
                                    phi_969_ = _e515;
                                } else {
                                    let _e520 = (_e515 - 1u);
                                    let _e521 = (_e520 % 128u);
                                    let _e522 = (_e521 < 128u);
                                    if _e522 {
                                    } else {
                                        phi_3743_ = true;
                                        break;
                                    }
                                    let _e524 = local_7[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3743_ = true;
                                        break;
                                    }
                                    let _e526 = local_6[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3743_ = true;
                                        break;
                                    }
                                    let _e528 = local_5[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3743_ = true;
                                        break;
                                    }
                                    let _e530 = local_4[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3743_ = true;
                                        break;
                                    }
                                    let _e532 = local_3[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3743_ = true;
                                        break;
                                    }
                                    let _e534 = local_2[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3743_ = true;
                                        break;
                                    }
                                    let _e539 = local_8[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3743_ = true;
                                        break;
                                    }
                                    let _e542 = local_9[_e521];
                                    phi_967_ = type_53(type_28(vec4<f32>(_e524, _e526, _e528, 0f), vec4<f32>(_e530, _e532, _e534, 0f)), _e539);
                                    phi_968_ = (_e542 <= _e507.member_1);
                                    phi_969_ = _e520;
                                }
                                let _e546 = phi_967_;
                                let _e548 = phi_968_;
                                let _e550 = phi_969_;
                                if _e548 {
                                    let _e555 = (_e546.member_1 & 268435455u);
                                    if ((_e546.member_1 & 2147483648u) != 0u) {
                                        phi_3626_ = _e505;
                                        phi_988_ = _e507;
                                        phi_991_ = type_8(0u, ((_e546.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1036 = phi_3626_;
                                            let _e1038 = phi_988_;
                                            let _e1040 = phi_991_;
                                            local_14 = _e1038;
                                            if (_e1040.member < _e1040.member_1) {
                                                phi_992_ = type_8((_e1040.member + 1u), _e1040.member_1);
                                                phi_1014_ = type_8(1u, _e1040.member);
                                            } else {
                                                phi_992_ = _e1040;
                                                phi_1014_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1053 = phi_992_;
                                            let _e1055 = phi_1014_;
                                            let _e1059 = (bitcast<i32>(_e1055.member) != 0i);
                                            if _e1059 {
                                                let _e1064 = (_e546.member.member_1.x - _e546.member.member.x);
                                                let _e1067 = (_e546.member.member_1.y - _e546.member.member.y);
                                                let _e1070 = (_e546.member.member_1.z - _e546.member.member.z);
                                                let _e1072 = select(_e1067, _e1064, (_e1064 > _e1067));
                                                let _e1074 = select(_e1070, _e1072, (_e1072 > _e1070));
                                                let _e1076 = (_e1074 < (1024f * _e143));
                                                if _e1076 {
                                                    phi_1055_ = 0u;
                                                } else {
                                                    phi_1055_ = select(2u, 1u, (_e1074 < (2097152f * _e143)));
                                                }
                                                let _e1081 = phi_1055_;
                                                switch bitcast<i32>(_e1081) {
                                                    case 0: {
                                                        phi_1061_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1061_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1061_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1061_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1084 = phi_1061_;
                                                switch bitcast<i32>(_e1081) {
                                                    case 0: {
                                                        phi_1071_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1071_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1071_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1071_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1091 = phi_1071_;
                                                let _e1093 = ((_e555 + (_e1055.member_1 * ((3u * _e1084) + 1u))) + (3u * _e1091));
                                                let _e1094 = (_e1093 < _e95);
                                                if _e1094 {
                                                    if _e1094 {
                                                    } else {
                                                        phi_3684_ = true;
                                                        break;
                                                    }
                                                    let _e1096 = global_5.member[_e1093];
                                                    phi_1087_ = _e1096;
                                                } else {
                                                    phi_1087_ = 4294967295u;
                                                }
                                                let _e1098 = phi_1087_;
                                                local_10 = array<u32, 3>(_e263, _e262, _e264);
                                                if _e1076 {
                                                    phi_1124_ = 0u;
                                                } else {
                                                    phi_1124_ = select(2u, 1u, (_e1074 < (2097152f * _e143)));
                                                }
                                                let _e1104 = phi_1124_;
                                                switch bitcast<i32>(_e1104) {
                                                    case 0: {
                                                        phi_1130_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1130_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1130_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1130_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1107 = phi_1130_;
                                                switch bitcast<i32>(_e1104) {
                                                    case 0: {
                                                        phi_1140_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1140_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1140_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1140_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1114 = phi_1140_;
                                                local_12 = array<f32, 4>(_e546.member.member.x, _e546.member.member.y, _e546.member.member.z, _e546.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3611_ = _e1036;
                                                phi_1156_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1128 = phi_3611_;
                                                    let _e1130 = phi_1156_;
                                                    if (_e1130.member < _e1130.member_1) {
                                                        phi_1157_ = type_8((_e1130.member + 1u), _e1130.member_1);
                                                        phi_1180_ = type_8(1u, _e1130.member);
                                                    } else {
                                                        phi_1157_ = _e1130;
                                                        phi_1180_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1143 = phi_1157_;
                                                    let _e1145 = phi_1180_;
                                                    let _e1149 = (bitcast<i32>(_e1145.member) != 0i);
                                                    if _e1149 {
                                                        let _e1151 = ((_e555 + (_e1055.member_1 * ((3u * _e1107) + 1u))) + (_e1145.member_1 * _e1114));
                                                        let _e1152 = (_e1151 < _e95);
                                                        if _e1152 {
                                                            if _e1152 {
                                                            } else {
                                                                phi_3682_ = true;
                                                                break;
                                                            }
                                                            let _e1154 = global_5.member[_e1151];
                                                            phi_1203_ = _e1154;
                                                        } else {
                                                            phi_1203_ = 0u;
                                                        }
                                                        let _e1156 = phi_1203_;
                                                        let _e1157 = (_e1151 + 1u);
                                                        let _e1158 = (_e1157 < _e95);
                                                        if _e1158 {
                                                            if _e1158 {
                                                            } else {
                                                                phi_3682_ = true;
                                                                break;
                                                            }
                                                            let _e1160 = global_5.member[_e1157];
                                                            phi_1218_ = _e1160;
                                                        } else {
                                                            phi_1218_ = 0u;
                                                        }
                                                        let _e1162 = phi_1218_;
                                                        phi_1221_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1164 = phi_1221_;
                                                            if (_e1164.member < _e1164.member_1) {
                                                                phi_1222_ = type_8((_e1164.member + 1u), _e1164.member_1);
                                                                phi_1245_ = type_8(1u, _e1164.member);
                                                            } else {
                                                                phi_1222_ = _e1164;
                                                                phi_1245_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1177 = phi_1222_;
                                                            let _e1179 = phi_1245_;
                                                            let _e1183 = (bitcast<i32>(_e1179.member) != 0i);
                                                            if _e1183 {
                                                                let _e1184 = (_e1179.member_1 < 3u);
                                                                if _e1184 {
                                                                } else {
                                                                    phi_3604_ = true;
                                                                    break;
                                                                }
                                                                let _e1186 = local_10[_e1179.member_1];
                                                                if (_e1179.member_1 < 4u) {
                                                                } else {
                                                                    phi_3604_ = true;
                                                                    break;
                                                                }
                                                                let _e1189 = local_12[_e1179.member_1];
                                                                switch bitcast<i32>(_e1104) {
                                                                    case 0: {
                                                                        phi_1315_ = (_e1189 + (f32(((_e1156 >> bitcast<u32>(((10u * _e1186) & 31u))) & 1023u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1186 == 0u) {
                                                                            phi_1292_ = _e1156;
                                                                        } else {
                                                                            if (_e1186 == 1u) {
                                                                                phi_1291_ = ((_e1156 >> bitcast<u32>(21i)) | (_e1162 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1291_ = (_e1162 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1210 = phi_1291_;
                                                                            phi_1292_ = _e1210;
                                                                        }
                                                                        let _e1212 = phi_1292_;
                                                                        phi_1315_ = (_e1189 + (f32((_e1212 & 2097151u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1191 = (_e1151 + _e1186);
                                                                        let _e1192 = (_e1191 < _e95);
                                                                        if _e1192 {
                                                                            if _e1192 {
                                                                            } else {
                                                                                phi_3604_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1194 = global_5.member[_e1191];
                                                                            phi_1311_ = _e1194;
                                                                        } else {
                                                                            phi_1311_ = 0u;
                                                                        }
                                                                        let _e1196 = phi_1311_;
                                                                        phi_1315_ = (f32(bitcast<i32>(_e1196)) * _e143);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1315_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1226 = phi_1315_;
                                                                if (_e1145.member_1 < 3u) {
                                                                } else {
                                                                    phi_3604_ = true;
                                                                    break;
                                                                }
                                                                if _e1184 {
                                                                } else {
                                                                    phi_3604_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1145.member_1][_e1179.member_1] = _e1226;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1221_ = _e1177;
                                                                phi_3604_ = _e1128;
                                                                break if !(_e1183);
                                                            }
                                                        }
                                                        let _e1232 = phi_3604_;
                                                        phi_3682_ = _e1232;
                                                        if _e1232 {
                                                            break;
                                                        }
                                                        phi_3683_ = _e1232;
                                                    } else {
                                                        phi_3683_ = _e1128;
                                                    }
                                                    let _e1234 = phi_3683_;
                                                    continue;
                                                    continuing {
                                                        phi_3611_ = _e1234;
                                                        phi_1156_ = _e1143;
                                                        phi_3682_ = _e1234;
                                                        break if !(_e1149);
                                                    }
                                                }
                                                let _e1237 = phi_3682_;
                                                phi_3684_ = _e1237;
                                                if _e1237 {
                                                    break;
                                                }
                                                let _e1238 = local_11;
                                                let _e1254 = (_e1238[0][2] - _e389);
                                                let _e1257 = (((_e1238[0][0] - _e312) * _e413) - (_e1254 * _e337));
                                                let _e1260 = (((_e1238[0][1] - _e351) * _e413) - (_e1254 * _e375));
                                                let _e1263 = (_e1238[1][2] - _e389);
                                                let _e1266 = (((_e1238[1][0] - _e312) * _e413) - (_e1263 * _e337));
                                                let _e1269 = (((_e1238[1][1] - _e351) * _e413) - (_e1263 * _e375));
                                                let _e1272 = (_e1238[2][2] - _e389);
                                                let _e1275 = (((_e1238[2][0] - _e312) * _e413) - (_e1272 * _e337));
                                                let _e1278 = (((_e1238[2][1] - _e351) * _e413) - (_e1272 * _e375));
                                                let _e1279 = (_e1275 * _e1269);
                                                let _e1280 = (_e1278 * _e1266);
                                                let _e1281 = (_e1257 * _e1278);
                                                let _e1282 = (_e1260 * _e1275);
                                                let _e1283 = (_e1266 * _e1260);
                                                let _e1284 = (_e1269 * _e1257);
                                                let _e1289 = (((_e1279 >= _e1280) && (_e1281 >= _e1282)) && (_e1283 >= _e1284));
                                                if (_e1289 || (((_e1279 <= _e1280) && (_e1281 <= _e1282)) && (_e1283 <= _e1284))) {
                                                    let _e1296 = select(-1f, 1f, _e1289);
                                                    let _e1298 = ((_e1279 - _e1280) * _e1296);
                                                    let _e1300 = select(0f, _e1298, (_e1298 > 0f));
                                                    let _e1302 = ((_e1281 - _e1282) * _e1296);
                                                    let _e1304 = select(0f, _e1302, (_e1302 > 0f));
                                                    let _e1306 = ((_e1283 - _e1284) * _e1296);
                                                    let _e1308 = select(0f, _e1306, (_e1306 > 0f));
                                                    let _e1310 = ((_e1300 + _e1304) + _e1308);
                                                    if (_e1310 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1910_ = type_20();
                                                        phi_1911_ = true;
                                                    } else {
                                                        let _e1313 = select(_e1238[1][0], _e1238[0][0], (_e1238[0][0] < _e1238[1][0]));
                                                        let _e1317 = select(_e1238[1][0], _e1238[0][0], (_e1238[0][0] > _e1238[1][0]));
                                                        let _e1321 = select(_e1238[1][1], _e1238[0][1], (_e1238[0][1] < _e1238[1][1]));
                                                        let _e1325 = select(_e1238[1][1], _e1238[0][1], (_e1238[0][1] > _e1238[1][1]));
                                                        let _e1329 = select(_e1238[1][2], _e1238[0][2], (_e1238[0][2] < _e1238[1][2]));
                                                        let _e1333 = select(_e1238[1][2], _e1238[0][2], (_e1238[0][2] > _e1238[1][2]));
                                                        let _e1338 = ((select(_e1238[2][0], _e1313, (_e1313 < _e1238[2][0])) - _e335) * _e340);
                                                        let _e1339 = ((select(_e1238[2][0], _e1317, (_e1317 > _e1238[2][0])) - _e336) * _e340);
                                                        let _e1342 = ((select(_e1238[2][1], _e1321, (_e1321 < _e1238[2][1])) - _e373) * _e378);
                                                        let _e1343 = ((select(_e1238[2][1], _e1325, (_e1325 > _e1238[2][1])) - _e374) * _e378);
                                                        let _e1346 = ((select(_e1238[2][2], _e1329, (_e1329 < _e1238[2][2])) - _e411) * _e416);
                                                        let _e1347 = ((select(_e1238[2][2], _e1333, (_e1333 > _e1238[2][2])) - _e412) * _e416);
                                                        let _e1349 = select(_e1347, _e1346, (_e1346 < _e1347));
                                                        let _e1351 = select(_e1347, _e1346, (_e1346 > _e1347));
                                                        let _e1353 = select(_e1339, _e1338, (_e1338 < _e1339));
                                                        let _e1355 = select(_e1343, _e1342, (_e1342 < _e1343));
                                                        let _e1357 = select(_e1355, _e1353, (_e1353 > _e1355));
                                                        let _e1359 = select(_e1349, _e1357, (_e1357 > _e1349));
                                                        let _e1361 = select(_e1339, _e1338, (_e1338 > _e1339));
                                                        let _e1363 = select(_e1343, _e1342, (_e1342 > _e1343));
                                                        let _e1365 = select(_e1363, _e1361, (_e1361 < _e1363));
                                                        let _e1367 = select(_e1351, _e1365, (_e1365 < _e1351));
                                                        let _e1368 = -(_e1349);
                                                        let _e1374 = select(_e463, _e1359, (_e1359 > _e463));
                                                        if (_e1374 > (_e1367 + (select(_e1368, _e1351, (_e1351 > _e1368)) * 0.0000019073523f))) {
                                                            phi_1905_ = type_20();
                                                            phi_1906_ = true;
                                                        } else {
                                                            let _e1376 = (_e1374 > _e1038.member_1);
                                                            if _e1376 {
                                                                phi_1904_ = type_20();
                                                            } else {
                                                                let _e1380 = (_e1238[1][0] - _e1238[0][0]);
                                                                let _e1381 = (_e1238[1][1] - _e1238[0][1]);
                                                                let _e1382 = (_e1238[1][2] - _e1238[0][2]);
                                                                let _e1383 = vec3<f32>(_e1380, _e1381, _e1382);
                                                                let _e1384 = (_e1238[2][0] - _e1238[1][0]);
                                                                let _e1385 = (_e1238[2][1] - _e1238[1][1]);
                                                                let _e1386 = (_e1238[2][2] - _e1238[1][2]);
                                                                let _e1387 = vec3<f32>(_e1384, _e1385, _e1386);
                                                                let _e1388 = (_e1238[0][0] - _e1238[2][0]);
                                                                let _e1389 = (_e1238[0][1] - _e1238[2][1]);
                                                                let _e1390 = (_e1238[0][2] - _e1238[2][2]);
                                                                let _e1391 = vec3<f32>(_e1388, _e1389, _e1390);
                                                                let _e1394 = bitcast<f32>((bitcast<u32>(_e1380) & 2147483647u));
                                                                let _e1397 = bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u));
                                                                let _e1399 = select(_e1397, _e1394, (_e1394 > _e1397));
                                                                let _e1402 = bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u));
                                                                let _e1404 = select(_e1402, _e1399, (_e1399 > _e1402));
                                                                let _e1407 = bitcast<f32>((bitcast<u32>(_e1384) & 2147483647u));
                                                                let _e1410 = bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u));
                                                                let _e1412 = select(_e1410, _e1407, (_e1407 > _e1410));
                                                                let _e1415 = bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u));
                                                                let _e1417 = select(_e1415, _e1412, (_e1412 > _e1415));
                                                                let _e1420 = bitcast<f32>((bitcast<u32>(_e1388) & 2147483647u));
                                                                let _e1423 = bitcast<f32>((bitcast<u32>(_e1389) & 2147483647u));
                                                                let _e1425 = select(_e1423, _e1420, (_e1420 > _e1423));
                                                                let _e1428 = bitcast<f32>((bitcast<u32>(_e1390) & 2147483647u));
                                                                let _e1430 = select(_e1428, _e1425, (_e1425 > _e1428));
                                                                let _e1432 = select(_e1417, _e1404, (_e1404 > _e1417));
                                                                let _e1434 = select(_e1430, _e1432, (_e1432 > _e1430));
                                                                if (_e1404 == _e1434) {
                                                                    phi_1815_ = _e1387;
                                                                    phi_1816_ = _e1391;
                                                                } else {
                                                                    let _e1437 = vec3((_e1417 == _e1434));
                                                                    phi_1815_ = select(_e1383, _e1391, _e1437);
                                                                    phi_1816_ = select(_e1387, _e1383, _e1437);
                                                                }
                                                                let _e1441 = phi_1815_;
                                                                let _e1443 = phi_1816_;
                                                                let _e1450 = ((_e1441.y * _e1443.z) - (_e1443.y * _e1441.z));
                                                                let _e1455 = ((_e1441.z * _e1443.x) - (_e1443.z * _e1441.x));
                                                                let _e1458 = ((_e1441.x * _e1443.y) - (_e1443.x * _e1441.y));
                                                                if (_e1300 >= _e1304) {
                                                                    phi_1847_ = select(true, false, (_e1300 >= _e1308));
                                                                } else {
                                                                    phi_1847_ = true;
                                                                }
                                                                let _e1463 = phi_1847_;
                                                                if _e1463 {
                                                                    phi_1856_ = select(vec3<f32>(_e1238[2][0], _e1238[2][1], _e1238[2][2]), vec3<f32>(_e1238[1][0], _e1238[1][1], _e1238[1][2]), vec3((_e1304 >= _e1308)));
                                                                } else {
                                                                    phi_1856_ = vec3<f32>(_e1238[0][0], _e1238[0][1], _e1238[0][2]);
                                                                }
                                                                let _e1468 = phi_1856_;
                                                                let _e1485 = ((((_e1450 * (_e1468.x - _e312)) + (_e1455 * (_e1468.y - _e351))) + (_e1458 * (_e1468.z - _e389))) / (((_e1450 * _e337) + (_e1455 * _e375)) + (_e1458 * _e413)));
                                                                let _e1487 = select(_e1367, _e1485, (_e1485 < _e1367));
                                                                let _e1489 = select(_e1359, _e1487, (_e1487 > _e1359));
                                                                if (_e1489 >= _e463) {
                                                                    let _e1491 = (_e1489 <= _e1038.member_1);
                                                                    if _e1491 {
                                                                        let _e1492 = (1f / _e1310);
                                                                        phi_1896_ = type_20(_e1489, (_e1304 * _e1492), (_e1308 * _e1492), _e1098);
                                                                    } else {
                                                                        phi_1896_ = type_20();
                                                                    }
                                                                    let _e1497 = phi_1896_;
                                                                    phi_1898_ = _e1497;
                                                                    phi_1899_ = select(true, false, _e1491);
                                                                } else {
                                                                    phi_1898_ = type_20();
                                                                    phi_1899_ = true;
                                                                }
                                                                let _e1500 = phi_1898_;
                                                                let _e1502 = phi_1899_;
                                                                if _e1502 {
                                                                    phi_1903_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1903_ = _e1500;
                                                                }
                                                                let _e1504 = phi_1903_;
                                                                phi_1904_ = _e1504;
                                                            }
                                                            let _e1506 = phi_1904_;
                                                            phi_1905_ = _e1506;
                                                            phi_1906_ = _e1376;
                                                        }
                                                        let _e1508 = phi_1905_;
                                                        let _e1510 = phi_1906_;
                                                        phi_1910_ = _e1508;
                                                        phi_1911_ = _e1510;
                                                    }
                                                    let _e1512 = phi_1910_;
                                                    let _e1514 = phi_1911_;
                                                    phi_1915_ = _e1512;
                                                    phi_1916_ = _e1514;
                                                } else {
                                                    phi_1915_ = type_20();
                                                    phi_1916_ = true;
                                                }
                                                let _e1516 = phi_1915_;
                                                let _e1518 = phi_1916_;
                                                if _e1518 {
                                                    phi_1920_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1920_ = _e1516;
                                                }
                                                let _e1520 = phi_1920_;
                                                if (_e1520.member_3 != 4294967295u) {
                                                    if (_e1098 != 4294967295u) {
                                                        if (_e1520.member < _e1038.member.member) {
                                                            phi_1946_ = true;
                                                        } else {
                                                            if (_e1520.member == _e1038.member.member) {
                                                                phi_1945_ = (_e1520.member_3 < _e1038.member.member_3);
                                                            } else {
                                                                phi_1945_ = false;
                                                            }
                                                            let _e1533 = phi_1945_;
                                                            phi_1946_ = _e1533;
                                                        }
                                                        let _e1535 = phi_1946_;
                                                        if _e1535 {
                                                            phi_1952_ = type_33(_e1520, _e1520.member);
                                                        } else {
                                                            phi_1952_ = _e1038;
                                                        }
                                                        let _e1538 = phi_1952_;
                                                        phi_1953_ = _e1538;
                                                    } else {
                                                        phi_1953_ = _e1038;
                                                    }
                                                    let _e1540 = phi_1953_;
                                                    phi_1954_ = _e1540;
                                                } else {
                                                    phi_1954_ = _e1038;
                                                }
                                                let _e1542 = phi_1954_;
                                                phi_3685_ = _e1237;
                                                phi_989_ = _e1542;
                                            } else {
                                                phi_3685_ = _e1036;
                                                phi_989_ = type_33();
                                            }
                                            let _e1544 = phi_3685_;
                                            let _e1546 = phi_989_;
                                            continue;
                                            continuing {
                                                phi_3626_ = _e1544;
                                                phi_988_ = _e1546;
                                                phi_991_ = _e1053;
                                                phi_3684_ = _e1544;
                                                break if !(_e1059);
                                            }
                                        }
                                        let _e1549 = phi_3684_;
                                        phi_3743_ = _e1549;
                                        if _e1549 {
                                            break;
                                        }
                                        phi_3747_ = _e1549;
                                        let _e1749 = local_14;
                                        phi_3336_ = _e1749;
                                        phi_3337_ = _e546;
                                        phi_3338_ = false;
                                        phi_3339_ = _e550;
                                    } else {
                                        if (_e546.member_1 >= _e92) {
                                            phi_2892_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e546.member_1 < _e92) {
                                            } else {
                                                phi_3743_ = true;
                                                break;
                                            }
                                            let _e564 = ((1u + (_e263 * 2u)) % 7u);
                                            if (_e564 < 7u) {
                                            } else {
                                                phi_3743_ = true;
                                                break;
                                            }
                                            let _e569 = global_4.member[_e546.member_1][_e564];
                                            let _e572 = ((1u + (_e262 * 2u)) % 7u);
                                            if (_e572 < 7u) {
                                            } else {
                                                phi_3743_ = true;
                                                break;
                                            }
                                            let _e577 = global_4.member[_e546.member_1][_e572];
                                            let _e580 = ((1u + (_e264 * 2u)) % 7u);
                                            if (_e580 < 7u) {
                                            } else {
                                                phi_3743_ = true;
                                                break;
                                            }
                                            let _e585 = global_4.member[_e546.member_1][_e580];
                                            let _e588 = (((_e263 + 1u) * 2u) % 7u);
                                            if (_e588 < 7u) {
                                            } else {
                                                phi_3743_ = true;
                                                break;
                                            }
                                            let _e593 = global_4.member[_e546.member_1][_e588];
                                            let _e596 = (((_e262 + 1u) * 2u) % 7u);
                                            if (_e596 < 7u) {
                                            } else {
                                                phi_3743_ = true;
                                                break;
                                            }
                                            let _e601 = global_4.member[_e546.member_1][_e596];
                                            let _e604 = (((_e264 + 1u) * 2u) % 7u);
                                            if (_e604 < 7u) {
                                            } else {
                                                phi_3743_ = true;
                                                break;
                                            }
                                            let _e609 = global_4.member[_e546.member_1][_e604];
                                            let _e632 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.x - _e546.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e633 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.y - _e546.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e634 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.z - _e546.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e636 = select(_e143, _e632, (_e632 > _e143));
                                            let _e638 = select(_e143, _e633, (_e633 > _e143));
                                            let _e640 = select(_e143, _e634, (_e634 > _e143));
                                            let _e665 = bitcast<u32>((f32(bitcast<i32>((_e569 & 2097151u))) * _e636));
                                            let _e670 = (bitcast<i32>((_e569 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e673 = bitcast<f32>((_e665 & bitcast<u32>(_e670)));
                                            let _e674 = bitcast<u32>((f32(bitcast<i32>((_e577 & 2097151u))) * _e638));
                                            let _e679 = (bitcast<i32>((_e577 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e682 = bitcast<f32>((_e674 & bitcast<u32>(_e679)));
                                            let _e683 = bitcast<u32>((f32(bitcast<i32>((_e585 & 2097151u))) * _e640));
                                            let _e688 = (bitcast<i32>((_e585 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e691 = bitcast<f32>((_e683 & bitcast<u32>(_e688)));
                                            let _e695 = bitcast<f32>((_e665 & bitcast<u32>(~(_e670))));
                                            let _e699 = bitcast<f32>((_e674 & bitcast<u32>(~(_e679))));
                                            let _e703 = bitcast<f32>((_e683 & bitcast<u32>(~(_e688))));
                                            let _e704 = bitcast<u32>((f32(bitcast<i32>((_e593 & 2097151u))) * _e636));
                                            let _e709 = (bitcast<i32>((_e593 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e712 = bitcast<f32>((_e704 & bitcast<u32>(_e709)));
                                            let _e713 = bitcast<u32>((f32(bitcast<i32>((_e601 & 2097151u))) * _e638));
                                            let _e718 = (bitcast<i32>((_e601 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e721 = bitcast<f32>((_e713 & bitcast<u32>(_e718)));
                                            let _e722 = bitcast<u32>((f32(bitcast<i32>((_e609 & 2097151u))) * _e640));
                                            let _e727 = (bitcast<i32>((_e609 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e730 = bitcast<f32>((_e722 & bitcast<u32>(_e727)));
                                            let _e734 = bitcast<f32>((_e704 & bitcast<u32>(~(_e709))));
                                            let _e738 = bitcast<f32>((_e713 & bitcast<u32>(~(_e718))));
                                            let _e742 = bitcast<f32>((_e722 & bitcast<u32>(~(_e727))));
                                            let _e743 = (_e546.member.member.x + _e673);
                                            let _e744 = (_e546.member.member.y + _e682);
                                            let _e745 = (_e546.member.member.z + _e691);
                                            let _e748 = (_e546.member.member_1.x - _e712);
                                            let _e749 = (_e546.member.member_1.y - _e721);
                                            let _e750 = (_e546.member.member_1.z - _e730);
                                            let _e769 = (_e748 - _e743);
                                            let _e770 = (_e749 - _e744);
                                            let _e771 = (_e750 - _e745);
                                            let _e773 = select(_e770, _e769, (_e769 > _e770));
                                            let _e775 = select(_e771, _e773, (_e773 > _e771));
                                            if (_e775 < (1024f * _e143)) {
                                                phi_2593_ = 0u;
                                            } else {
                                                phi_2593_ = select(2u, 1u, (_e775 < (2097152f * _e143)));
                                            }
                                            let _e782 = phi_2593_;
                                            switch bitcast<i32>(_e782) {
                                                case 0: {
                                                    phi_2599_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2599_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2599_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2599_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e785 = phi_2599_;
                                            let _e791 = global_4.member[_e546.member_1][0u];
                                            let _e795 = global_4.member[_e546.member_1][2u];
                                            let _e799 = global_4.member[_e546.member_1][4u];
                                            let _e803 = global_4.member[_e546.member_1][6u];
                                            let _e815 = (((_e795 >> bitcast<u32>(22i)) | ((_e799 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e803 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e816 = (_e791 & 268435455u);
                                            let _e817 = (_e815 & 268435455u);
                                            let _e820 = ((_e791 >> bitcast<u32>(28u)) & 7u);
                                            let _e828 = ((_e791 >> bitcast<u32>(31i)) | (((_e815 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e829 = (_e820 != 0u);
                                            if (_e820 == 0u) {
                                                phi_2854_ = _e816;
                                            } else {
                                                if (_e820 == 7u) {
                                                    phi_2853_ = 2147483648u;
                                                } else {
                                                    phi_2853_ = ((2147483648u | (_e820 << bitcast<u32>(28u))) | (_e817 & 268435455u));
                                                }
                                                let _e838 = phi_2853_;
                                                phi_2854_ = _e838;
                                            }
                                            let _e840 = phi_2854_;
                                            if _e829 {
                                                let _e841 = (_e820 != 7u);
                                                if _e841 {
                                                    phi_2864_ = (_e817 + (_e820 * ((3u * _e785) + 1u)));
                                                } else {
                                                    phi_2864_ = u32();
                                                }
                                                let _e845 = phi_2864_;
                                                phi_2866_ = _e845;
                                                phi_2867_ = select(true, false, _e841);
                                            } else {
                                                phi_2866_ = u32();
                                                phi_2867_ = true;
                                            }
                                            let _e848 = phi_2866_;
                                            let _e850 = phi_2867_;
                                            if (_e828 == 0u) {
                                                phi_2888_ = (_e816 + select(0u, 1u, !(_e829)));
                                            } else {
                                                if (_e828 == 7u) {
                                                    phi_2887_ = 2147483648u;
                                                } else {
                                                    phi_2887_ = ((2147483648u | (_e828 << bitcast<u32>(28u))) | (select(_e848, _e817, _e850) & 268435455u));
                                                }
                                                let _e863 = phi_2887_;
                                                phi_2888_ = _e863;
                                            }
                                            let _e865 = phi_2888_;
                                            phi_2892_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e743, (_e546.member.member.x + _e695), _e748, (_e546.member.member_1.x - _e734)), vec4<f32>(_e744, (_e546.member.member.y + _e699), _e749, (_e546.member.member_1.y - _e738)), vec4<f32>(_e745, (_e546.member.member.z + _e703), _e750, (_e546.member.member_1.z - _e742))), type_53(type_28((_e546.member.member + vec4<f32>(_e673, _e682, _e691, 0f)), (_e546.member.member_1 - vec4<f32>(_e712, _e721, _e730, 0f))), _e840), type_53(type_28((_e546.member.member + vec4<f32>(_e695, _e699, _e703, 0f)), (_e546.member.member_1 - vec4<f32>(_e734, _e738, _e742, 0f))), _e865));
                                        }
                                        let _e870 = phi_2892_;
                                        let _e882 = ((_e870.member[0].x - _e335) * _e340);
                                        let _e883 = ((_e870.member[0].y - _e335) * _e340);
                                        let _e884 = ((_e870.member[0].z - _e336) * _e340);
                                        let _e885 = ((_e870.member[0].w - _e336) * _e340);
                                        let _e895 = ((_e870.member[1].x - _e373) * _e378);
                                        let _e896 = ((_e870.member[1].y - _e373) * _e378);
                                        let _e897 = ((_e870.member[1].z - _e374) * _e378);
                                        let _e898 = ((_e870.member[1].w - _e374) * _e378);
                                        let _e908 = ((_e870.member[2].x - _e411) * _e416);
                                        let _e909 = ((_e870.member[2].y - _e411) * _e416);
                                        let _e910 = ((_e870.member[2].z - _e412) * _e416);
                                        let _e911 = ((_e870.member[2].w - _e412) * _e416);
                                        let _e913 = select(_e910, _e908, (_e908 < _e910));
                                        let _e915 = select(_e911, _e909, (_e909 < _e911));
                                        let _e917 = select(_e910, _e908, (_e908 > _e910));
                                        let _e919 = select(_e911, _e909, (_e909 > _e911));
                                        let _e921 = select(_e884, _e882, (_e882 < _e884));
                                        let _e923 = select(_e885, _e883, (_e883 < _e885));
                                        let _e925 = select(_e897, _e895, (_e895 < _e897));
                                        let _e927 = select(_e898, _e896, (_e896 < _e898));
                                        let _e929 = select(_e925, _e921, (_e921 > _e925));
                                        let _e931 = select(_e927, _e923, (_e923 > _e927));
                                        let _e933 = select(_e913, _e929, (_e929 > _e913));
                                        let _e935 = select(_e915, _e931, (_e931 > _e915));
                                        let _e937 = select(_e884, _e882, (_e882 > _e884));
                                        let _e939 = select(_e885, _e883, (_e883 > _e885));
                                        let _e941 = select(_e897, _e895, (_e895 > _e897));
                                        let _e943 = select(_e898, _e896, (_e896 > _e898));
                                        let _e945 = select(_e941, _e937, (_e937 < _e941));
                                        let _e947 = select(_e943, _e939, (_e939 < _e943));
                                        let _e952 = -(_e913);
                                        let _e953 = -(_e915);
                                        let _e960 = (select(_e917, _e945, (_e945 < _e917)) + (select(_e952, _e917, (_e917 > _e952)) * 0.0000019073523f));
                                        let _e961 = (select(_e919, _e947, (_e947 < _e919)) + (select(_e953, _e919, (_e919 > _e953)) * 0.0000019073523f));
                                        let _e963 = select(_e463, _e933, (_e933 > _e463));
                                        let _e965 = select(_e463, _e935, (_e935 > _e463));
                                        let _e970 = (_e963 <= select(_e507.member_1, _e960, (_e960 < _e507.member_1)));
                                        let _e971 = (_e965 <= select(_e507.member_1, _e961, (_e961 < _e507.member_1)));
                                        let _e972 = (_e963 <= _e965);
                                        if _e970 {
                                            if _e971 {
                                                if _e972 {
                                                    phi_3236_ = _e870.member_2;
                                                } else {
                                                    phi_3236_ = _e870.member_1;
                                                }
                                                let _e976 = phi_3236_;
                                                let _e998 = (_e550 % 128u);
                                                let _e999 = (_e998 < 128u);
                                                if _e999 {
                                                } else {
                                                    phi_3743_ = true;
                                                    break;
                                                }
                                                local_8[_e998] = _e976.member_1;
                                                if _e999 {
                                                } else {
                                                    phi_3743_ = true;
                                                    break;
                                                }
                                                local_7[_e998] = _e976.member.member.x;
                                                if _e999 {
                                                } else {
                                                    phi_3743_ = true;
                                                    break;
                                                }
                                                local_6[_e998] = _e976.member.member.y;
                                                if _e999 {
                                                } else {
                                                    phi_3743_ = true;
                                                    break;
                                                }
                                                local_5[_e998] = _e976.member.member.z;
                                                if _e999 {
                                                } else {
                                                    phi_3743_ = true;
                                                    break;
                                                }
                                                local_4[_e998] = _e976.member.member_1.x;
                                                if _e999 {
                                                } else {
                                                    phi_3743_ = true;
                                                    break;
                                                }
                                                local_3[_e998] = _e976.member.member_1.y;
                                                if _e999 {
                                                } else {
                                                    phi_3743_ = true;
                                                    break;
                                                }
                                                local_2[_e998] = _e976.member.member_1.z;
                                                if _e999 {
                                                } else {
                                                    phi_3743_ = true;
                                                    break;
                                                }
                                                local_9[_e998] = select(_e965, _e963, (_e963 > _e965));
                                                if _e972 {
                                                    phi_3313_ = _e870.member_1;
                                                } else {
                                                    phi_3313_ = _e870.member_2;
                                                }
                                                let _e1012 = phi_3313_;
                                                phi_3314_ = _e1012;
                                                phi_3315_ = (_e550 + 1u);
                                            } else {
                                                phi_3314_ = type_53();
                                                phi_3315_ = u32();
                                            }
                                            let _e1014 = phi_3314_;
                                            let _e1016 = phi_3315_;
                                            phi_3317_ = _e1014;
                                            phi_3318_ = _e1016;
                                            phi_3319_ = select(true, false, _e971);
                                        } else {
                                            phi_3317_ = type_53();
                                            phi_3318_ = u32();
                                            phi_3319_ = true;
                                        }
                                        let _e1019 = phi_3317_;
                                        let _e1021 = phi_3318_;
                                        let _e1023 = phi_3319_;
                                        if _e1023 {
                                            if _e970 {
                                                phi_3328_ = _e870.member_1;
                                            } else {
                                                phi_3328_ = _e870.member_2;
                                            }
                                            let _e1027 = phi_3328_;
                                            phi_3333_ = _e1027;
                                            phi_3334_ = select(_e971, true, _e970);
                                        } else {
                                            phi_3333_ = _e1019;
                                            phi_3334_ = _e548;
                                        }
                                        let _e1030 = phi_3333_;
                                        let _e1032 = phi_3334_;
                                        phi_3747_ = _e505;
                                        phi_3336_ = _e507;
                                        phi_3337_ = _e1030;
                                        phi_3338_ = _e1032;
                                        phi_3339_ = select(_e1021, _e550, _e1023);
                                    }
                                    let _e1551 = phi_3747_;
                                    let _e1553 = phi_3336_;
                                    let _e1555 = phi_3337_;
                                    let _e1557 = phi_3338_;
                                    let _e1559 = phi_3339_;
                                    phi_3746_ = _e1551;
                                    phi_3340_ = _e1553;
                                    phi_3341_ = _e1555;
                                    phi_3342_ = (_e511 - 1u);
                                    phi_3343_ = _e1557;
                                    phi_3344_ = _e1559;
                                } else {
                                    phi_3746_ = _e505;
                                    phi_3340_ = _e507;
                                    phi_3341_ = _e546;
                                    phi_3342_ = _e511;
                                    phi_3343_ = _e548;
                                    phi_3344_ = _e550;
                                }
                                let _e1561 = phi_3746_;
                                let _e1563 = phi_3340_;
                                let _e1565 = phi_3341_;
                                let _e1567 = phi_3342_;
                                let _e1569 = phi_3343_;
                                let _e1571 = phi_3344_;
                                phi_3745_ = _e1561;
                                phi_3345_ = _e1563;
                                phi_3346_ = _e1565;
                                phi_3347_ = _e1567;
                                phi_3348_ = _e1569;
                                phi_3349_ = _e1571;
                            } else {
                                phi_3745_ = _e505;
                                phi_3345_ = type_33();
                                phi_3346_ = type_53();
                                phi_3347_ = u32();
                                phi_3348_ = bool();
                                phi_3349_ = u32();
                            }
                            let _e1573 = phi_3745_;
                            let _e1575 = phi_3345_;
                            let _e1577 = phi_3346_;
                            let _e1579 = phi_3347_;
                            let _e1581 = phi_3348_;
                            let _e1583 = phi_3349_;
                            phi_3744_ = _e1573;
                            phi_862_ = _e1575;
                            phi_865_ = _e1577;
                            phi_867_ = _e1579;
                            phi_869_ = _e1581;
                            phi_871_ = _e1583;
                            phi_3350_ = _e519;
                        } else {
                            phi_3744_ = _e505;
                            phi_862_ = type_33();
                            phi_865_ = type_53();
                            phi_867_ = u32();
                            phi_869_ = bool();
                            phi_871_ = u32();
                            phi_3350_ = false;
                        }
                        let _e1585 = phi_3744_;
                        let _e1587 = phi_862_;
                        let _e1589 = phi_865_;
                        let _e1591 = phi_867_;
                        let _e1593 = phi_869_;
                        let _e1595 = phi_871_;
                        let _e1597 = phi_3350_;
                        continue;
                        continuing {
                            phi_3629_ = _e1585;
                            phi_861_ = _e1587;
                            phi_864_ = _e1589;
                            phi_866_ = _e1591;
                            phi_868_ = _e1593;
                            phi_870_ = _e1595;
                            phi_3743_ = _e1585;
                            break if !(_e1597);
                        }
                    }
                    let _e1600 = phi_3743_;
                    if _e1600 {
                        break;
                    }
                    let _e1602 = local_13;
                    if (_e1602.member.member_3 != 4294967295u) {
                        let _e1607 = -(_e430);
                        let _e1608 = (_e1607 / 3i);
                        let _e1615 = bitcast<f32>((bitcast<u32>((_e1608 + 127i)) << bitcast<u32>(23i)));
                        let _e1623 = (((_e1602.member.member * _e1615) * _e1615) * bitcast<f32>((bitcast<u32>(((_e1607 - (2i * _e1608)) + 127i)) << bitcast<u32>(23i))));
                        let _e1625 = select(340282350000000000000000000000000000000f, _e1623, (_e1623 < 340282350000000000000000000000000000000f));
                        phi_3402_ = type_20(select(-340282350000000000000000000000000000000f, _e1625, (_e1625 > -340282350000000000000000000000000000000f)), _e1602.member.member_1, _e1602.member.member_2, _e1602.member.member_3);
                    } else {
                        phi_3402_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1632 = phi_3402_;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_6.member[_e149] = _e1632;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
