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

struct type_49 {
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
var<storage> global_5: type_49;
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
    var phi_379_: i32;
    var phi_380_: i32;
    var phi_390_: bool;
    var phi_400_: u32;
    var phi_401_: u32;
    var phi_403_: bool;
    var phi_408_: u32;
    var phi_421_: i32;
    var phi_441_: i32;
    var phi_459_: f32;
    var phi_465_: f32;
    var phi_476_: f32;
    var phi_482_: f32;
    var phi_505_: f32;
    var phi_516_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_542_: f32;
    var phi_548_: f32;
    var phi_571_: f32;
    var phi_582_: f32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_608_: f32;
    var phi_614_: f32;
    var phi_637_: f32;
    var phi_648_: f32;
    var phi_748_: f32;
    var phi_749_: f32;
    var phi_3291_: bool;
    var phi_839_: type_40;
    var phi_842_: type_51;
    var phi_844_: u32;
    var phi_846_: bool;
    var phi_848_: u32;
    var phi_859_: bool;
    var phi_945_: type_51;
    var phi_946_: bool;
    var phi_947_: u32;
    var phi_2582_: u32;
    var phi_2583_: u32;
    var phi_2593_: u32;
    var phi_2595_: u32;
    var phi_2596_: bool;
    var phi_2616_: u32;
    var phi_2617_: u32;
    var phi_2621_: type_52;
    var phi_2965_: type_51;
    var phi_3042_: type_51;
    var phi_3043_: type_51;
    var phi_3044_: u32;
    var phi_3046_: type_51;
    var phi_3047_: u32;
    var phi_3048_: bool;
    var phi_3057_: type_51;
    var phi_3062_: type_51;
    var phi_3063_: bool;
    var phi_965_: type_40;
    var phi_968_: type_4;
    var phi_969_: type_4;
    var phi_991_: type_4;
    var phi_1015_: u32;
    var phi_1104_: array<array<f32, 3>, 3>;
    var phi_1575_: vec3<f32>;
    var phi_1576_: vec3<f32>;
    var phi_1607_: bool;
    var phi_1616_: vec3<f32>;
    var phi_1656_: type_25;
    var phi_1658_: type_25;
    var phi_1659_: bool;
    var phi_1663_: type_25;
    var phi_1664_: type_25;
    var phi_1665_: type_25;
    var phi_1666_: bool;
    var phi_1670_: type_25;
    var phi_1671_: bool;
    var phi_1675_: type_25;
    var phi_1676_: bool;
    var phi_1680_: type_25;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1713_: type_40;
    var phi_1714_: type_40;
    var phi_1715_: type_40;
    var phi_966_: type_40;
    var phi_3285_: bool;
    var phi_3403_: bool;
    var phi_3065_: type_40;
    var phi_3066_: type_51;
    var phi_3067_: bool;
    var phi_3068_: u32;
    var phi_3402_: bool;
    var phi_3069_: type_40;
    var phi_3070_: type_51;
    var phi_3071_: u32;
    var phi_3072_: bool;
    var phi_3073_: u32;
    var phi_3401_: bool;
    var phi_3074_: type_40;
    var phi_3075_: type_51;
    var phi_3076_: u32;
    var phi_3077_: bool;
    var phi_3078_: u32;
    var phi_3400_: bool;
    var phi_840_: type_40;
    var phi_843_: type_51;
    var phi_845_: u32;
    var phi_847_: bool;
    var phi_849_: u32;
    var phi_3079_: bool;
    var phi_3399_: bool;
    var local_10: type_40;
    var local_11: type_40;
    var local_12: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e81 = global;
            let _e83 = arrayLength((&global_5.member));
            let _e85 = arrayLength((&global_2.member));
            let _e93 = global_3.member[0u][0u];
            let _e97 = global_3.member[0u][1u];
            let _e101 = global_3.member[0u][2u];
            let _e105 = global_3.member[0u][3u];
            let _e109 = global_3.member[1u][0u];
            let _e113 = global_3.member[1u][1u];
            let _e117 = global_3.member[1u][2u];
            let _e120 = global_1.member[0u];
            let _e121 = bitcast<i32>(_e120);
            let _e133 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e105) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e93), bitcast<i32>(_e97), bitcast<i32>(_e101));
            local = array<i32, 3>(bitcast<i32>(_e109), bitcast<i32>(_e113), bitcast<i32>(_e117));
            let _e139 = (_e81.x + (_e81.y * 2097152u));
            let _e140 = (_e139 < arrayLength((&global_4.member)));
            if _e140 {
                let _e141 = (_e139 < arrayLength((&global_6.member)));
                if _e141 {
                    if _e140 {
                    } else {
                        break;
                    }
                    let _e149 = global_4.member[_e139].member_2[0u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_4.member[_e139].member_2[1u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_4.member[_e139].member_2[2u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e139].member[0u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e139].member[1u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_4.member[_e139].member[2u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e188 = select(_e158, _e151, (_e158 < _e151));
                    let _e190 = select(_e165, _e188, (_e165 < _e188));
                    let _e192 = select(_e172, _e190, (_e172 < _e190));
                    let _e194 = select(_e179, _e192, (_e179 < _e192));
                    let _e196 = select(_e186, _e194, (_e186 < _e194));
                    let _e200 = global_4.member[_e139].member_1;
                    let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                    let _e209 = global_4.member[_e139].member_3;
                    let _e215 = (((select(_e202, _e196, (_e202 < _e196)) < 2139095040u) && ((bitcast<u32>(_e209) & 2147483647u) <= 2139095040u)) && (_e190 > 0u));
                    if _e215 {
                        let _e218 = (bitcast<u32>(bitcast<f32>(_e190)) & 2147483647u);
                        if (_e218 >= 8388608u) {
                            phi_379_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_379_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                        }
                        let _e232 = phi_379_;
                        phi_380_ = _e232;
                    } else {
                        phi_380_ = 0i;
                    }
                    let _e234 = phi_380_;
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_390_ = true;
                    } else {
                        phi_390_ = (_e158 == _e190);
                    }
                    let _e238 = phi_390_;
                    let _e239 = select(1u, 0u, _e235);
                    if _e238 {
                        let _e240 = (_e239 + 1u);
                        phi_400_ = _e240;
                        phi_401_ = _e240;
                        phi_403_ = select(true, false, (_e240 == 2u));
                    } else {
                        phi_400_ = u32();
                        phi_401_ = 0u;
                        phi_403_ = true;
                    }
                    let _e244 = phi_400_;
                    let _e246 = phi_401_;
                    let _e248 = phi_403_;
                    if _e248 {
                        phi_408_ = (_e246 + 1u);
                    } else {
                        phi_408_ = 0u;
                    }
                    let _e252 = phi_408_;
                    let _e253 = select(_e244, _e246, _e248);
                    let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                    if (_e121 < -126i) {
                        phi_421_ = -126i;
                    } else {
                        phi_421_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e259 = phi_421_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e121 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_441_ = -126i;
                    } else {
                        phi_441_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_441_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_4.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_459_ = _e291[0];
                    } else {
                        phi_459_ = _e291[1];
                    }
                    let _e296 = phi_459_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_465_ = _e291[2];
                    } else {
                        phi_465_ = _e296;
                    }
                    let _e300 = phi_465_;
                    let _e302 = ((_e300 * _e264) * _e270);
                    let _e303 = global_4.member[_e139].member_2;
                    if _e292 {
                        phi_476_ = _e303[0];
                    } else {
                        phi_476_ = _e303[1];
                    }
                    let _e307 = phi_476_;
                    if _e297 {
                        phi_482_ = _e303[2];
                    } else {
                        phi_482_ = _e307;
                    }
                    let _e310 = phi_482_;
                    let _e312 = ((_e310 * _e281) * _e287);
                    let _e316 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e316 {
                        let _e320 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) * 0.00000011920929f);
                        phi_505_ = select(0.00000000000011368684f, _e320, (_e320 > 0.00000000000011368684f));
                    } else {
                        phi_505_ = 0f;
                    }
                    let _e324 = phi_505_;
                    let _e325 = (_e302 + _e324);
                    let _e326 = (_e302 - _e324);
                    let _e327 = select(_e312, 0f, _e316);
                    if _e316 {
                        phi_516_ = 38685626000000000000000000f;
                    } else {
                        phi_516_ = (1f / _e312);
                    }
                    let _e330 = phi_516_;
                    let _e331 = (_e252 == 0u);
                    if _e331 {
                        phi_525_ = _e291[0];
                    } else {
                        phi_525_ = _e291[1];
                    }
                    let _e335 = phi_525_;
                    let _e336 = (_e252 == 2u);
                    if _e336 {
                        phi_531_ = _e291[2];
                    } else {
                        phi_531_ = _e335;
                    }
                    let _e339 = phi_531_;
                    let _e341 = ((_e339 * _e264) * _e270);
                    if _e331 {
                        phi_542_ = _e303[0];
                    } else {
                        phi_542_ = _e303[1];
                    }
                    let _e345 = phi_542_;
                    if _e336 {
                        phi_548_ = _e303[2];
                    } else {
                        phi_548_ = _e345;
                    }
                    let _e348 = phi_548_;
                    let _e350 = ((_e348 * _e281) * _e287);
                    let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e354 {
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                        phi_571_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                    } else {
                        phi_571_ = 0f;
                    }
                    let _e362 = phi_571_;
                    let _e363 = (_e341 + _e362);
                    let _e364 = (_e341 - _e362);
                    let _e365 = select(_e350, 0f, _e354);
                    if _e354 {
                        phi_582_ = 38685626000000000000000000f;
                    } else {
                        phi_582_ = (1f / _e350);
                    }
                    let _e368 = phi_582_;
                    let _e369 = (_e254 == 0u);
                    if _e369 {
                        phi_591_ = _e291[0];
                    } else {
                        phi_591_ = _e291[1];
                    }
                    let _e373 = phi_591_;
                    let _e374 = (_e254 == 2u);
                    if _e374 {
                        phi_597_ = _e291[2];
                    } else {
                        phi_597_ = _e373;
                    }
                    let _e377 = phi_597_;
                    let _e379 = ((_e377 * _e264) * _e270);
                    if _e369 {
                        phi_608_ = _e303[0];
                    } else {
                        phi_608_ = _e303[1];
                    }
                    let _e383 = phi_608_;
                    if _e374 {
                        phi_614_ = _e303[2];
                    } else {
                        phi_614_ = _e383;
                    }
                    let _e386 = phi_614_;
                    let _e388 = ((_e386 * _e281) * _e287);
                    let _e392 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e392 {
                        let _e396 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_637_ = select(0.00000000000011368684f, _e396, (_e396 > 0.00000000000011368684f));
                    } else {
                        phi_637_ = 0f;
                    }
                    let _e400 = phi_637_;
                    let _e401 = (_e379 + _e400);
                    let _e402 = (_e379 - _e400);
                    let _e403 = select(_e388, 0f, _e392);
                    if _e392 {
                        phi_648_ = 38685626000000000000000000f;
                    } else {
                        phi_648_ = (1f / _e388);
                    }
                    let _e406 = phi_648_;
                    let _e409 = bitcast<f32>((bitcast<u32>(_e302) & 2147483647u));
                    let _e412 = bitcast<f32>((bitcast<u32>(_e341) & 2147483647u));
                    let _e414 = select(_e412, _e409, (_e409 > _e412));
                    let _e417 = bitcast<f32>((bitcast<u32>(_e379) & 2147483647u));
                    let _e420 = (_e121 + _e234);
                    if (_e215 && (select(_e417, _e414, (_e414 > _e417)) <= 1099511600000f)) {
                        let _e423 = (_e420 / 3i);
                        let _e430 = bitcast<f32>((bitcast<u32>((_e423 + 127i)) << bitcast<u32>(23i)));
                        let _e437 = bitcast<f32>((bitcast<u32>(((_e420 - (2i * _e423)) + 127i)) << bitcast<u32>(23i)));
                        let _e438 = (((_e200 * _e430) * _e430) * _e437);
                        let _e440 = select(340282350000000000000000000000000000000f, _e438, (_e438 < 340282350000000000000000000000000000000f));
                        let _e445 = (((_e209 * _e430) * _e430) * _e437);
                        let _e447 = select(340282350000000000000000000000000000000f, _e445, (_e445 < 340282350000000000000000000000000000000f));
                        phi_748_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                        phi_749_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_748_ = 0f;
                        phi_749_ = 1f;
                    }
                    let _e451 = phi_748_;
                    let _e453 = phi_749_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e458 = (_e253 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_1[_e458];
                    let _e464 = (_e252 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e254 % 3u);
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
                    phi_3291_ = false;
                    phi_839_ = type_40(type_33(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e451), 0u, 0u);
                    phi_842_ = type_51(type_29(vec4<f32>((f32(_e461) * _e133), (f32(_e467) * _e133), (f32(_e473) * _e133), 0f), vec4<f32>((f32(_e478) * _e133), (f32(_e482) * _e133), (f32(_e486) * _e133), 0f)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_844_ = ((3u * _e83) + 1u);
                    phi_846_ = (_e453 <= _e451);
                    phi_848_ = 0u;
                    loop {
                        let _e496 = phi_3291_;
                        let _e498 = phi_839_;
                        let _e500 = phi_842_;
                        let _e502 = phi_844_;
                        let _e504 = phi_846_;
                        let _e506 = phi_848_;
                        local_10 = _e498;
                        local_11 = _e498;
                        if _e504 {
                            phi_859_ = true;
                        } else {
                            phi_859_ = (_e506 > 0u);
                        }
                        let _e509 = phi_859_;
                        if _e509 {
                            let _e510 = (_e502 > 0u);
                            if _e510 {
                                if _e504 {
                                    phi_945_ = _e500;
                                    phi_946_ = _e504;
                                    phi_947_ = _e506;
                                } else {
                                    let _e511 = (_e506 - 1u);
                                    let _e512 = (_e511 % 128u);
                                    let _e513 = (_e512 < 128u);
                                    if _e513 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e515 = local_7[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e517 = local_6[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e519 = local_5[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e521 = local_4[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e523 = local_3[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e525 = local_2[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e530 = local_8[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e533 = local_9[_e512];
                                    phi_945_ = type_51(type_29(vec4<f32>(_e515, _e517, _e519, 0f), vec4<f32>(_e521, _e523, _e525, 0f)), _e530);
                                    phi_946_ = (_e533 <= _e498.member.member_1);
                                    phi_947_ = _e511;
                                }
                                let _e538 = phi_945_;
                                let _e540 = phi_946_;
                                let _e542 = phi_947_;
                                if _e540 {
                                    if ((_e538.member_1 & 2147483648u) != 0u) {
                                        phi_965_ = _e498;
                                        phi_968_ = type_4(0u, ((_e538.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1014 = phi_965_;
                                            let _e1016 = phi_968_;
                                            local_12 = _e1014;
                                            if (_e1016.member < _e1016.member_1) {
                                                phi_969_ = type_4((_e1016.member + 1u), _e1016.member_1);
                                                phi_991_ = type_4(1u, _e1016.member);
                                            } else {
                                                phi_969_ = _e1016;
                                                phi_991_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1029 = phi_969_;
                                            let _e1031 = phi_991_;
                                            let _e1035 = (bitcast<i32>(_e1031.member) != 0i);
                                            if _e1035 {
                                                let _e1041 = type_40(_e1014.member, _e1014.member_1, (_e1014.member_2 + 1u));
                                                let _e1042 = ((_e538.member_1 & 268435455u) + _e1031.member_1);
                                                let _e1043 = (_e1042 < _e85);
                                                if _e1043 {
                                                    if _e1043 {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1047 = global_2.member[_e1042].member_1;
                                                    phi_1015_ = _e1047;
                                                } else {
                                                    phi_1015_ = 4294967295u;
                                                }
                                                let _e1049 = phi_1015_;
                                                if (_e1042 >= _e85) {
                                                    phi_1104_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1043 {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    if (_e458 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1056 = global_2.member[_e1042].member[_e458];
                                                    if (_e464 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1062 = global_2.member[_e1042].member[_e464];
                                                    if (_e470 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1068 = global_2.member[_e1042].member[_e470];
                                                    let _e1070 = (3u + _e458);
                                                    if (_e1070 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1076 = global_2.member[_e1042].member[_e1070];
                                                    let _e1077 = (3u + _e464);
                                                    if (_e1077 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1083 = global_2.member[_e1042].member[_e1077];
                                                    let _e1084 = (3u + _e470);
                                                    if (_e1084 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1090 = global_2.member[_e1042].member[_e1084];
                                                    let _e1092 = (6u + _e458);
                                                    if (_e1092 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1098 = global_2.member[_e1042].member[_e1092];
                                                    let _e1099 = (6u + _e464);
                                                    if (_e1099 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1105 = global_2.member[_e1042].member[_e1099];
                                                    let _e1106 = (6u + _e470);
                                                    if (_e1106 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1112 = global_2.member[_e1042].member[_e1106];
                                                    phi_1104_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1056, _e1062, _e1068), array<f32, 3>(_e1076, _e1083, _e1090), array<f32, 3>(_e1098, _e1105, _e1112));
                                                }
                                                let _e1116 = phi_1104_;
                                                let _e1125 = (_e1116[0][2] - _e379);
                                                let _e1128 = (((_e1116[0][0] - _e302) * _e403) - (_e1125 * _e327));
                                                let _e1131 = (((_e1116[0][1] - _e341) * _e403) - (_e1125 * _e365));
                                                let _e1138 = (_e1116[1][2] - _e379);
                                                let _e1141 = (((_e1116[1][0] - _e302) * _e403) - (_e1138 * _e327));
                                                let _e1144 = (((_e1116[1][1] - _e341) * _e403) - (_e1138 * _e365));
                                                let _e1151 = (_e1116[2][2] - _e379);
                                                let _e1154 = (((_e1116[2][0] - _e302) * _e403) - (_e1151 * _e327));
                                                let _e1157 = (((_e1116[2][1] - _e341) * _e403) - (_e1151 * _e365));
                                                let _e1158 = (_e1154 * _e1144);
                                                let _e1159 = (_e1157 * _e1141);
                                                let _e1160 = (_e1128 * _e1157);
                                                let _e1161 = (_e1131 * _e1154);
                                                let _e1162 = (_e1141 * _e1131);
                                                let _e1163 = (_e1144 * _e1128);
                                                let _e1168 = (((_e1158 >= _e1159) && (_e1160 >= _e1161)) && (_e1162 >= _e1163));
                                                if (_e1168 || (((_e1158 <= _e1159) && (_e1160 <= _e1161)) && (_e1162 <= _e1163))) {
                                                    let _e1175 = select(-1f, 1f, _e1168);
                                                    let _e1177 = ((_e1158 - _e1159) * _e1175);
                                                    let _e1179 = select(0f, _e1177, (_e1177 > 0f));
                                                    let _e1181 = ((_e1160 - _e1161) * _e1175);
                                                    let _e1183 = select(0f, _e1181, (_e1181 > 0f));
                                                    let _e1185 = ((_e1162 - _e1163) * _e1175);
                                                    let _e1187 = select(0f, _e1185, (_e1185 > 0f));
                                                    let _e1189 = ((_e1179 + _e1183) + _e1187);
                                                    if (_e1189 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1670_ = type_25();
                                                        phi_1671_ = true;
                                                    } else {
                                                        let _e1192 = select(_e1116[1][0], _e1116[0][0], (_e1116[0][0] < _e1116[1][0]));
                                                        let _e1196 = select(_e1116[1][0], _e1116[0][0], (_e1116[0][0] > _e1116[1][0]));
                                                        let _e1200 = select(_e1116[1][1], _e1116[0][1], (_e1116[0][1] < _e1116[1][1]));
                                                        let _e1204 = select(_e1116[1][1], _e1116[0][1], (_e1116[0][1] > _e1116[1][1]));
                                                        let _e1208 = select(_e1116[1][2], _e1116[0][2], (_e1116[0][2] < _e1116[1][2]));
                                                        let _e1212 = select(_e1116[1][2], _e1116[0][2], (_e1116[0][2] > _e1116[1][2]));
                                                        let _e1217 = ((select(_e1116[2][0], _e1192, (_e1192 < _e1116[2][0])) - _e325) * _e330);
                                                        let _e1218 = ((select(_e1116[2][0], _e1196, (_e1196 > _e1116[2][0])) - _e326) * _e330);
                                                        let _e1221 = ((select(_e1116[2][1], _e1200, (_e1200 < _e1116[2][1])) - _e363) * _e368);
                                                        let _e1222 = ((select(_e1116[2][1], _e1204, (_e1204 > _e1116[2][1])) - _e364) * _e368);
                                                        let _e1225 = ((select(_e1116[2][2], _e1208, (_e1208 < _e1116[2][2])) - _e401) * _e406);
                                                        let _e1226 = ((select(_e1116[2][2], _e1212, (_e1212 > _e1116[2][2])) - _e402) * _e406);
                                                        let _e1228 = select(_e1226, _e1225, (_e1225 < _e1226));
                                                        let _e1230 = select(_e1226, _e1225, (_e1225 > _e1226));
                                                        let _e1232 = select(_e1218, _e1217, (_e1217 < _e1218));
                                                        let _e1234 = select(_e1222, _e1221, (_e1221 < _e1222));
                                                        let _e1236 = select(_e1234, _e1232, (_e1232 > _e1234));
                                                        let _e1238 = select(_e1228, _e1236, (_e1236 > _e1228));
                                                        let _e1240 = select(_e1218, _e1217, (_e1217 > _e1218));
                                                        let _e1242 = select(_e1222, _e1221, (_e1221 > _e1222));
                                                        let _e1244 = select(_e1242, _e1240, (_e1240 < _e1242));
                                                        let _e1246 = select(_e1230, _e1244, (_e1244 < _e1230));
                                                        let _e1247 = -(_e1228);
                                                        let _e1253 = select(_e453, _e1238, (_e1238 > _e453));
                                                        if (_e1253 > (_e1246 + (select(_e1247, _e1230, (_e1230 > _e1247)) * 0.0000019073523f))) {
                                                            phi_1665_ = type_25();
                                                            phi_1666_ = true;
                                                        } else {
                                                            let _e1255 = (_e1253 > _e1014.member.member_1);
                                                            if _e1255 {
                                                                phi_1664_ = type_25();
                                                            } else {
                                                                let _e1259 = (_e1116[1][0] - _e1116[0][0]);
                                                                let _e1260 = (_e1116[1][1] - _e1116[0][1]);
                                                                let _e1261 = (_e1116[1][2] - _e1116[0][2]);
                                                                let _e1262 = vec3<f32>(_e1259, _e1260, _e1261);
                                                                let _e1263 = (_e1116[2][0] - _e1116[1][0]);
                                                                let _e1264 = (_e1116[2][1] - _e1116[1][1]);
                                                                let _e1265 = (_e1116[2][2] - _e1116[1][2]);
                                                                let _e1266 = vec3<f32>(_e1263, _e1264, _e1265);
                                                                let _e1267 = (_e1116[0][0] - _e1116[2][0]);
                                                                let _e1268 = (_e1116[0][1] - _e1116[2][1]);
                                                                let _e1269 = (_e1116[0][2] - _e1116[2][2]);
                                                                let _e1270 = vec3<f32>(_e1267, _e1268, _e1269);
                                                                let _e1273 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                                let _e1276 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                let _e1278 = select(_e1276, _e1273, (_e1273 > _e1276));
                                                                let _e1281 = bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u));
                                                                let _e1283 = select(_e1281, _e1278, (_e1278 > _e1281));
                                                                let _e1286 = bitcast<f32>((bitcast<u32>(_e1263) & 2147483647u));
                                                                let _e1289 = bitcast<f32>((bitcast<u32>(_e1264) & 2147483647u));
                                                                let _e1291 = select(_e1289, _e1286, (_e1286 > _e1289));
                                                                let _e1294 = bitcast<f32>((bitcast<u32>(_e1265) & 2147483647u));
                                                                let _e1296 = select(_e1294, _e1291, (_e1291 > _e1294));
                                                                let _e1299 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
                                                                let _e1302 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                let _e1304 = select(_e1302, _e1299, (_e1299 > _e1302));
                                                                let _e1307 = bitcast<f32>((bitcast<u32>(_e1269) & 2147483647u));
                                                                let _e1309 = select(_e1307, _e1304, (_e1304 > _e1307));
                                                                let _e1311 = select(_e1296, _e1283, (_e1283 > _e1296));
                                                                let _e1313 = select(_e1309, _e1311, (_e1311 > _e1309));
                                                                if (_e1283 == _e1313) {
                                                                    phi_1575_ = _e1266;
                                                                    phi_1576_ = _e1270;
                                                                } else {
                                                                    let _e1316 = vec3((_e1296 == _e1313));
                                                                    phi_1575_ = select(_e1262, _e1270, _e1316);
                                                                    phi_1576_ = select(_e1266, _e1262, _e1316);
                                                                }
                                                                let _e1320 = phi_1575_;
                                                                let _e1322 = phi_1576_;
                                                                let _e1329 = ((_e1320.y * _e1322.z) - (_e1322.y * _e1320.z));
                                                                let _e1334 = ((_e1320.z * _e1322.x) - (_e1322.z * _e1320.x));
                                                                let _e1337 = ((_e1320.x * _e1322.y) - (_e1322.x * _e1320.y));
                                                                if (_e1179 >= _e1183) {
                                                                    phi_1607_ = select(true, false, (_e1179 >= _e1187));
                                                                } else {
                                                                    phi_1607_ = true;
                                                                }
                                                                let _e1342 = phi_1607_;
                                                                if _e1342 {
                                                                    phi_1616_ = select(vec3<f32>(_e1116[2][0], _e1116[2][1], _e1116[2][2]), vec3<f32>(_e1116[1][0], _e1116[1][1], _e1116[1][2]), vec3((_e1183 >= _e1187)));
                                                                } else {
                                                                    phi_1616_ = vec3<f32>(_e1116[0][0], _e1116[0][1], _e1116[0][2]);
                                                                }
                                                                let _e1347 = phi_1616_;
                                                                let _e1364 = ((((_e1329 * (_e1347.x - _e302)) + (_e1334 * (_e1347.y - _e341))) + (_e1337 * (_e1347.z - _e379))) / (((_e1329 * _e327) + (_e1334 * _e365)) + (_e1337 * _e403)));
                                                                let _e1366 = select(_e1246, _e1364, (_e1364 < _e1246));
                                                                let _e1368 = select(_e1238, _e1366, (_e1366 > _e1238));
                                                                if (_e1368 >= _e453) {
                                                                    let _e1370 = (_e1368 <= _e1014.member.member_1);
                                                                    if _e1370 {
                                                                        let _e1371 = (1f / _e1189);
                                                                        phi_1656_ = type_25(_e1368, (_e1183 * _e1371), (_e1187 * _e1371), _e1049);
                                                                    } else {
                                                                        phi_1656_ = type_25();
                                                                    }
                                                                    let _e1376 = phi_1656_;
                                                                    phi_1658_ = _e1376;
                                                                    phi_1659_ = select(true, false, _e1370);
                                                                } else {
                                                                    phi_1658_ = type_25();
                                                                    phi_1659_ = true;
                                                                }
                                                                let _e1379 = phi_1658_;
                                                                let _e1381 = phi_1659_;
                                                                if _e1381 {
                                                                    phi_1663_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1663_ = _e1379;
                                                                }
                                                                let _e1383 = phi_1663_;
                                                                phi_1664_ = _e1383;
                                                            }
                                                            let _e1385 = phi_1664_;
                                                            phi_1665_ = _e1385;
                                                            phi_1666_ = _e1255;
                                                        }
                                                        let _e1387 = phi_1665_;
                                                        let _e1389 = phi_1666_;
                                                        phi_1670_ = _e1387;
                                                        phi_1671_ = _e1389;
                                                    }
                                                    let _e1391 = phi_1670_;
                                                    let _e1393 = phi_1671_;
                                                    phi_1675_ = _e1391;
                                                    phi_1676_ = _e1393;
                                                } else {
                                                    phi_1675_ = type_25();
                                                    phi_1676_ = true;
                                                }
                                                let _e1395 = phi_1675_;
                                                let _e1397 = phi_1676_;
                                                if _e1397 {
                                                    phi_1680_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1680_ = _e1395;
                                                }
                                                let _e1399 = phi_1680_;
                                                if (_e1399.member_3 != 4294967295u) {
                                                    if (_e1049 != 4294967295u) {
                                                        if (_e1399.member < _e1014.member.member.member) {
                                                            phi_1706_ = true;
                                                        } else {
                                                            if (_e1399.member == _e1014.member.member.member) {
                                                                phi_1705_ = (_e1399.member_3 < _e1014.member.member.member_3);
                                                            } else {
                                                                phi_1705_ = false;
                                                            }
                                                            let _e1414 = phi_1705_;
                                                            phi_1706_ = _e1414;
                                                        }
                                                        let _e1416 = phi_1706_;
                                                        if _e1416 {
                                                            phi_1713_ = type_40(type_33(_e1399, _e1399.member), _e1041.member_1, _e1041.member_2);
                                                        } else {
                                                            phi_1713_ = _e1041;
                                                        }
                                                        let _e1423 = phi_1713_;
                                                        phi_1714_ = _e1423;
                                                    } else {
                                                        phi_1714_ = _e1041;
                                                    }
                                                    let _e1425 = phi_1714_;
                                                    phi_1715_ = _e1425;
                                                } else {
                                                    phi_1715_ = _e1041;
                                                }
                                                let _e1427 = phi_1715_;
                                                phi_966_ = _e1427;
                                            } else {
                                                phi_966_ = type_40();
                                            }
                                            let _e1429 = phi_966_;
                                            continue;
                                            continuing {
                                                phi_965_ = _e1429;
                                                phi_968_ = _e1029;
                                                phi_3285_ = _e496;
                                                break if !(_e1035);
                                            }
                                        }
                                        let _e1432 = phi_3285_;
                                        phi_3399_ = _e1432;
                                        if _e1432 {
                                            break;
                                        }
                                        phi_3403_ = _e1432;
                                        let _e1585 = local_12;
                                        phi_3065_ = _e1585;
                                        phi_3066_ = _e538;
                                        phi_3067_ = false;
                                        phi_3068_ = _e542;
                                    } else {
                                        if (_e538.member_1 >= _e83) {
                                            phi_2621_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e538.member_1 < _e83) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e561 = ((1u + (_e253 * 2u)) % 7u);
                                            if (_e561 < 7u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e566 = global_5.member[_e538.member_1][_e561];
                                            let _e569 = ((1u + (_e252 * 2u)) % 7u);
                                            if (_e569 < 7u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e574 = global_5.member[_e538.member_1][_e569];
                                            let _e577 = ((1u + (_e254 * 2u)) % 7u);
                                            if (_e577 < 7u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e582 = global_5.member[_e538.member_1][_e577];
                                            let _e585 = (((_e253 + 1u) * 2u) % 7u);
                                            if (_e585 < 7u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e590 = global_5.member[_e538.member_1][_e585];
                                            let _e593 = (((_e252 + 1u) * 2u) % 7u);
                                            if (_e593 < 7u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e598 = global_5.member[_e538.member_1][_e593];
                                            let _e601 = (((_e254 + 1u) * 2u) % 7u);
                                            if (_e601 < 7u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e606 = global_5.member[_e538.member_1][_e601];
                                            let _e629 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.x - _e538.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e630 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.y - _e538.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e631 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.z - _e538.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e633 = select(_e133, _e629, (_e629 > _e133));
                                            let _e635 = select(_e133, _e630, (_e630 > _e133));
                                            let _e637 = select(_e133, _e631, (_e631 > _e133));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e566 & 2097151u))) * _e633));
                                            let _e667 = (bitcast<i32>((_e566 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e671 = bitcast<u32>((f32(bitcast<i32>((_e574 & 2097151u))) * _e635));
                                            let _e676 = (bitcast<i32>((_e574 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                            let _e680 = bitcast<u32>((f32(bitcast<i32>((_e582 & 2097151u))) * _e637));
                                            let _e685 = (bitcast<i32>((_e582 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e688 = bitcast<f32>((_e680 & bitcast<u32>(_e685)));
                                            let _e692 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e696 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                            let _e700 = bitcast<f32>((_e680 & bitcast<u32>(~(_e685))));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e590 & 2097151u))) * _e633));
                                            let _e706 = (bitcast<i32>((_e590 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e710 = bitcast<u32>((f32(bitcast<i32>((_e598 & 2097151u))) * _e635));
                                            let _e715 = (bitcast<i32>((_e598 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e718 = bitcast<f32>((_e710 & bitcast<u32>(_e715)));
                                            let _e719 = bitcast<u32>((f32(bitcast<i32>((_e606 & 2097151u))) * _e637));
                                            let _e724 = (bitcast<i32>((_e606 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e727 = bitcast<f32>((_e719 & bitcast<u32>(_e724)));
                                            let _e731 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e735 = bitcast<f32>((_e710 & bitcast<u32>(~(_e715))));
                                            let _e739 = bitcast<f32>((_e719 & bitcast<u32>(~(_e724))));
                                            let _e769 = global_5.member[_e538.member_1][0u];
                                            let _e773 = global_5.member[_e538.member_1][2u];
                                            let _e777 = global_5.member[_e538.member_1][4u];
                                            let _e781 = global_5.member[_e538.member_1][6u];
                                            let _e793 = (((_e773 >> bitcast<u32>(22i)) | ((_e777 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e781 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e794 = (_e769 & 268435455u);
                                            let _e795 = (_e793 & 268435455u);
                                            let _e798 = ((_e769 >> bitcast<u32>(28u)) & 7u);
                                            let _e806 = ((_e769 >> bitcast<u32>(31i)) | (((_e793 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e807 = (_e798 != 0u);
                                            if (_e798 == 0u) {
                                                phi_2583_ = _e794;
                                            } else {
                                                if (_e798 == 7u) {
                                                    phi_2582_ = 2147483648u;
                                                } else {
                                                    phi_2582_ = ((2147483648u | (_e798 << bitcast<u32>(28u))) | (_e795 & 268435455u));
                                                }
                                                let _e816 = phi_2582_;
                                                phi_2583_ = _e816;
                                            }
                                            let _e818 = phi_2583_;
                                            if _e807 {
                                                let _e819 = (_e798 != 7u);
                                                if _e819 {
                                                    phi_2593_ = (_e795 + _e798);
                                                } else {
                                                    phi_2593_ = u32();
                                                }
                                                let _e822 = phi_2593_;
                                                phi_2595_ = _e822;
                                                phi_2596_ = select(true, false, _e819);
                                            } else {
                                                phi_2595_ = u32();
                                                phi_2596_ = true;
                                            }
                                            let _e825 = phi_2595_;
                                            let _e827 = phi_2596_;
                                            if (_e806 == 0u) {
                                                phi_2617_ = (_e794 + select(0u, 1u, !(_e807)));
                                            } else {
                                                if (_e806 == 7u) {
                                                    phi_2616_ = 2147483648u;
                                                } else {
                                                    phi_2616_ = ((2147483648u | (_e806 << bitcast<u32>(28u))) | (select(_e825, _e795, _e827) & 268435455u));
                                                }
                                                let _e840 = phi_2616_;
                                                phi_2617_ = _e840;
                                            }
                                            let _e842 = phi_2617_;
                                            phi_2621_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e538.member.member.x + _e670), (_e538.member.member.x + _e692), (_e538.member.member_1.x - _e709), (_e538.member.member_1.x - _e731)), vec4<f32>((_e538.member.member.y + _e679), (_e538.member.member.y + _e696), (_e538.member.member_1.y - _e718), (_e538.member.member_1.y - _e735)), vec4<f32>((_e538.member.member.z + _e688), (_e538.member.member.z + _e700), (_e538.member.member_1.z - _e727), (_e538.member.member_1.z - _e739))), type_51(type_29((_e538.member.member + vec4<f32>(_e670, _e679, _e688, 0f)), (_e538.member.member_1 - vec4<f32>(_e709, _e718, _e727, 0f))), _e818), type_51(type_29((_e538.member.member + vec4<f32>(_e692, _e696, _e700, 0f)), (_e538.member.member_1 - vec4<f32>(_e731, _e735, _e739, 0f))), _e842));
                                        }
                                        let _e847 = phi_2621_;
                                        let _e860 = ((_e847.member[0].x - _e325) * _e330);
                                        let _e861 = ((_e847.member[0].y - _e325) * _e330);
                                        let _e862 = ((_e847.member[0].z - _e326) * _e330);
                                        let _e863 = ((_e847.member[0].w - _e326) * _e330);
                                        let _e873 = ((_e847.member[1].x - _e363) * _e368);
                                        let _e874 = ((_e847.member[1].y - _e363) * _e368);
                                        let _e875 = ((_e847.member[1].z - _e364) * _e368);
                                        let _e876 = ((_e847.member[1].w - _e364) * _e368);
                                        let _e886 = ((_e847.member[2].x - _e401) * _e406);
                                        let _e887 = ((_e847.member[2].y - _e401) * _e406);
                                        let _e888 = ((_e847.member[2].z - _e402) * _e406);
                                        let _e889 = ((_e847.member[2].w - _e402) * _e406);
                                        let _e891 = select(_e888, _e886, (_e886 < _e888));
                                        let _e893 = select(_e889, _e887, (_e887 < _e889));
                                        let _e895 = select(_e888, _e886, (_e886 > _e888));
                                        let _e897 = select(_e889, _e887, (_e887 > _e889));
                                        let _e899 = select(_e862, _e860, (_e860 < _e862));
                                        let _e901 = select(_e863, _e861, (_e861 < _e863));
                                        let _e903 = select(_e875, _e873, (_e873 < _e875));
                                        let _e905 = select(_e876, _e874, (_e874 < _e876));
                                        let _e907 = select(_e903, _e899, (_e899 > _e903));
                                        let _e909 = select(_e905, _e901, (_e901 > _e905));
                                        let _e911 = select(_e891, _e907, (_e907 > _e891));
                                        let _e913 = select(_e893, _e909, (_e909 > _e893));
                                        let _e915 = select(_e862, _e860, (_e860 > _e862));
                                        let _e917 = select(_e863, _e861, (_e861 > _e863));
                                        let _e919 = select(_e875, _e873, (_e873 > _e875));
                                        let _e921 = select(_e876, _e874, (_e874 > _e876));
                                        let _e923 = select(_e919, _e915, (_e915 < _e919));
                                        let _e925 = select(_e921, _e917, (_e917 < _e921));
                                        let _e930 = -(_e891);
                                        let _e931 = -(_e893);
                                        let _e938 = (select(_e895, _e923, (_e923 < _e895)) + (select(_e930, _e895, (_e895 > _e930)) * 0.0000019073523f));
                                        let _e939 = (select(_e897, _e925, (_e925 < _e897)) + (select(_e931, _e897, (_e897 > _e931)) * 0.0000019073523f));
                                        let _e941 = select(_e453, _e911, (_e911 > _e453));
                                        let _e943 = select(_e453, _e913, (_e913 > _e453));
                                        let _e948 = (_e941 <= select(_e498.member.member_1, _e938, (_e938 < _e498.member.member_1)));
                                        let _e949 = (_e943 <= select(_e498.member.member_1, _e939, (_e939 < _e498.member.member_1)));
                                        let _e950 = (_e941 <= _e943);
                                        if _e948 {
                                            if _e949 {
                                                if _e950 {
                                                    phi_2965_ = _e847.member_2;
                                                } else {
                                                    phi_2965_ = _e847.member_1;
                                                }
                                                let _e954 = phi_2965_;
                                                let _e976 = (_e542 % 128u);
                                                let _e977 = (_e976 < 128u);
                                                if _e977 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_8[_e976] = _e954.member_1;
                                                if _e977 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_7[_e976] = _e954.member.member.x;
                                                if _e977 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_6[_e976] = _e954.member.member.y;
                                                if _e977 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_5[_e976] = _e954.member.member.z;
                                                if _e977 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_4[_e976] = _e954.member.member_1.x;
                                                if _e977 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_3[_e976] = _e954.member.member_1.y;
                                                if _e977 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_2[_e976] = _e954.member.member_1.z;
                                                if _e977 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_9[_e976] = select(_e943, _e941, (_e941 > _e943));
                                                if _e950 {
                                                    phi_3042_ = _e847.member_1;
                                                } else {
                                                    phi_3042_ = _e847.member_2;
                                                }
                                                let _e990 = phi_3042_;
                                                phi_3043_ = _e990;
                                                phi_3044_ = (_e542 + 1u);
                                            } else {
                                                phi_3043_ = type_51();
                                                phi_3044_ = u32();
                                            }
                                            let _e992 = phi_3043_;
                                            let _e994 = phi_3044_;
                                            phi_3046_ = _e992;
                                            phi_3047_ = _e994;
                                            phi_3048_ = select(true, false, _e949);
                                        } else {
                                            phi_3046_ = type_51();
                                            phi_3047_ = u32();
                                            phi_3048_ = true;
                                        }
                                        let _e997 = phi_3046_;
                                        let _e999 = phi_3047_;
                                        let _e1001 = phi_3048_;
                                        if _e1001 {
                                            if _e948 {
                                                phi_3057_ = _e847.member_1;
                                            } else {
                                                phi_3057_ = _e847.member_2;
                                            }
                                            let _e1005 = phi_3057_;
                                            phi_3062_ = _e1005;
                                            phi_3063_ = select(_e949, true, _e948);
                                        } else {
                                            phi_3062_ = _e997;
                                            phi_3063_ = _e540;
                                        }
                                        let _e1008 = phi_3062_;
                                        let _e1010 = phi_3063_;
                                        phi_3403_ = _e496;
                                        phi_3065_ = type_40(_e498.member, (_e498.member_1 + 1u), _e498.member_2);
                                        phi_3066_ = _e1008;
                                        phi_3067_ = _e1010;
                                        phi_3068_ = select(_e999, _e542, _e1001);
                                    }
                                    let _e1434 = phi_3403_;
                                    let _e1436 = phi_3065_;
                                    let _e1438 = phi_3066_;
                                    let _e1440 = phi_3067_;
                                    let _e1442 = phi_3068_;
                                    phi_3402_ = _e1434;
                                    phi_3069_ = _e1436;
                                    phi_3070_ = _e1438;
                                    phi_3071_ = (_e502 - 1u);
                                    phi_3072_ = _e1440;
                                    phi_3073_ = _e1442;
                                } else {
                                    phi_3402_ = _e496;
                                    phi_3069_ = _e498;
                                    phi_3070_ = _e538;
                                    phi_3071_ = _e502;
                                    phi_3072_ = _e540;
                                    phi_3073_ = _e542;
                                }
                                let _e1444 = phi_3402_;
                                let _e1446 = phi_3069_;
                                let _e1448 = phi_3070_;
                                let _e1450 = phi_3071_;
                                let _e1452 = phi_3072_;
                                let _e1454 = phi_3073_;
                                phi_3401_ = _e1444;
                                phi_3074_ = _e1446;
                                phi_3075_ = _e1448;
                                phi_3076_ = _e1450;
                                phi_3077_ = _e1452;
                                phi_3078_ = _e1454;
                            } else {
                                phi_3401_ = _e496;
                                phi_3074_ = type_40();
                                phi_3075_ = type_51();
                                phi_3076_ = u32();
                                phi_3077_ = bool();
                                phi_3078_ = u32();
                            }
                            let _e1456 = phi_3401_;
                            let _e1458 = phi_3074_;
                            let _e1460 = phi_3075_;
                            let _e1462 = phi_3076_;
                            let _e1464 = phi_3077_;
                            let _e1466 = phi_3078_;
                            phi_3400_ = _e1456;
                            phi_840_ = _e1458;
                            phi_843_ = _e1460;
                            phi_845_ = _e1462;
                            phi_847_ = _e1464;
                            phi_849_ = _e1466;
                            phi_3079_ = _e510;
                        } else {
                            phi_3400_ = _e496;
                            phi_840_ = type_40();
                            phi_843_ = type_51();
                            phi_845_ = u32();
                            phi_847_ = bool();
                            phi_849_ = u32();
                            phi_3079_ = false;
                        }
                        let _e1468 = phi_3400_;
                        let _e1470 = phi_840_;
                        let _e1472 = phi_843_;
                        let _e1474 = phi_845_;
                        let _e1476 = phi_847_;
                        let _e1478 = phi_849_;
                        let _e1480 = phi_3079_;
                        continue;
                        continuing {
                            phi_3291_ = _e1468;
                            phi_839_ = _e1470;
                            phi_842_ = _e1472;
                            phi_844_ = _e1474;
                            phi_846_ = _e1476;
                            phi_848_ = _e1478;
                            phi_3399_ = _e1468;
                            break if !(_e1480);
                        }
                    }
                    let _e1483 = phi_3399_;
                    if _e1483 {
                        break;
                    }
                    let _e1485 = local_10;
                    let _e1488 = local_11;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_6.member[_e139][0u] = _e1485.member_1;
                    global_6.member[_e139][1u] = _e1488.member_2;
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
