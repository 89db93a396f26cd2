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
    var phi_839_: type_44;
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
    var phi_965_: type_44;
    var phi_968_: type_4;
    var phi_969_: type_4;
    var phi_991_: type_4;
    var phi_1015_: u32;
    var phi_1104_: array<array<f32, 3>, 3>;
    var phi_1575_: vec3<f32>;
    var phi_1576_: vec3<f32>;
    var phi_1607_: bool;
    var phi_1616_: vec3<f32>;
    var phi_1656_: type_29;
    var phi_1658_: type_29;
    var phi_1659_: bool;
    var phi_1663_: type_29;
    var phi_1664_: type_29;
    var phi_1665_: type_29;
    var phi_1666_: bool;
    var phi_1670_: type_29;
    var phi_1671_: bool;
    var phi_1675_: type_29;
    var phi_1676_: bool;
    var phi_1680_: type_29;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1713_: type_44;
    var phi_1714_: type_44;
    var phi_1715_: type_44;
    var phi_966_: type_44;
    var phi_3285_: bool;
    var phi_3403_: bool;
    var phi_3065_: type_44;
    var phi_3066_: type_51;
    var phi_3067_: bool;
    var phi_3068_: u32;
    var phi_3402_: bool;
    var phi_3069_: type_44;
    var phi_3070_: type_51;
    var phi_3071_: u32;
    var phi_3072_: bool;
    var phi_3073_: u32;
    var phi_3401_: bool;
    var phi_3074_: type_44;
    var phi_3075_: type_51;
    var phi_3076_: u32;
    var phi_3077_: bool;
    var phi_3078_: u32;
    var phi_3400_: bool;
    var phi_840_: type_44;
    var phi_843_: type_51;
    var phi_845_: u32;
    var phi_847_: bool;
    var phi_849_: u32;
    var phi_3079_: bool;
    var phi_3399_: bool;
    var local_10: type_44;
    var local_11: type_44;
    var local_12: type_44;

    switch bitcast<i32>(0u) {
        default: {
            let _e82 = global;
            let _e84 = arrayLength((&global_4.member));
            let _e86 = arrayLength((&global_2.member));
            let _e94 = global_3.member[0u][0u];
            let _e98 = global_3.member[0u][1u];
            let _e102 = global_3.member[0u][2u];
            let _e106 = global_3.member[0u][3u];
            let _e110 = global_3.member[1u][0u];
            let _e114 = global_3.member[1u][1u];
            let _e118 = global_3.member[1u][2u];
            let _e121 = global_1.member[0u];
            let _e122 = bitcast<i32>(_e121);
            let _e134 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e106) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e94), bitcast<i32>(_e98), bitcast<i32>(_e102));
            local = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            let _e140 = (_e82.x + (_e82.y * 2097152u));
            let _e141 = (_e140 < arrayLength((&global_5.member)));
            if _e141 {
                let _e142 = (_e140 < arrayLength((&global_6.member)));
                if _e142 {
                    if _e141 {
                    } else {
                        break;
                    }
                    let _e150 = global_5.member[_e140].member_2[0u];
                    let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                    let _e157 = global_5.member[_e140].member_2[1u];
                    let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                    let _e164 = global_5.member[_e140].member_2[2u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_5.member[_e140].member[0u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_5.member[_e140].member[1u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_5.member[_e140].member[2u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e189 = select(_e159, _e152, (_e159 < _e152));
                    let _e191 = select(_e166, _e189, (_e166 < _e189));
                    let _e193 = select(_e173, _e191, (_e173 < _e191));
                    let _e195 = select(_e180, _e193, (_e180 < _e193));
                    let _e197 = select(_e187, _e195, (_e187 < _e195));
                    let _e201 = global_5.member[_e140].member_1;
                    let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                    let _e210 = global_5.member[_e140].member_3;
                    let _e216 = (((select(_e203, _e197, (_e203 < _e197)) < 2139095040u) && ((bitcast<u32>(_e210) & 2147483647u) <= 2139095040u)) && (_e191 > 0u));
                    if _e216 {
                        let _e219 = (bitcast<u32>(bitcast<f32>(_e191)) & 2147483647u);
                        if (_e219 >= 8388608u) {
                            phi_379_ = (bitcast<i32>((_e219 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_379_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u))));
                        }
                        let _e233 = phi_379_;
                        phi_380_ = _e233;
                    } else {
                        phi_380_ = 0i;
                    }
                    let _e235 = phi_380_;
                    let _e236 = (_e152 == _e191);
                    if _e236 {
                        phi_390_ = true;
                    } else {
                        phi_390_ = (_e159 == _e191);
                    }
                    let _e239 = phi_390_;
                    let _e240 = select(1u, 0u, _e236);
                    if _e239 {
                        let _e241 = (_e240 + 1u);
                        phi_400_ = _e241;
                        phi_401_ = _e241;
                        phi_403_ = select(true, false, (_e241 == 2u));
                    } else {
                        phi_400_ = u32();
                        phi_401_ = 0u;
                        phi_403_ = true;
                    }
                    let _e245 = phi_400_;
                    let _e247 = phi_401_;
                    let _e249 = phi_403_;
                    if _e249 {
                        phi_408_ = (_e247 + 1u);
                    } else {
                        phi_408_ = 0u;
                    }
                    let _e253 = phi_408_;
                    let _e254 = select(_e245, _e247, _e249);
                    let _e255 = select(_e240, select(2u, _e240, _e239), _e249);
                    if (_e122 < -126i) {
                        phi_421_ = -126i;
                    } else {
                        phi_421_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e260 = phi_421_;
                    let _e265 = bitcast<f32>((bitcast<u32>((_e260 + 127i)) << bitcast<u32>(23i)));
                    let _e271 = bitcast<f32>((bitcast<u32>(((_e122 - _e260) + 127i)) << bitcast<u32>(23i)));
                    let _e272 = -(_e235);
                    if (_e272 < -126i) {
                        phi_441_ = -126i;
                    } else {
                        phi_441_ = select(_e272, 127i, (_e272 > 127i));
                    }
                    let _e277 = phi_441_;
                    let _e282 = bitcast<f32>((bitcast<u32>((_e277 + 127i)) << bitcast<u32>(23i)));
                    let _e288 = bitcast<f32>((bitcast<u32>(((_e272 - _e277) + 127i)) << bitcast<u32>(23i)));
                    let _e292 = global_5.member[_e140].member;
                    let _e293 = (_e254 == 0u);
                    if _e293 {
                        phi_459_ = _e292[0];
                    } else {
                        phi_459_ = _e292[1];
                    }
                    let _e297 = phi_459_;
                    let _e298 = (_e254 == 2u);
                    if _e298 {
                        phi_465_ = _e292[2];
                    } else {
                        phi_465_ = _e297;
                    }
                    let _e301 = phi_465_;
                    let _e303 = ((_e301 * _e265) * _e271);
                    let _e304 = global_5.member[_e140].member_2;
                    if _e293 {
                        phi_476_ = _e304[0];
                    } else {
                        phi_476_ = _e304[1];
                    }
                    let _e308 = phi_476_;
                    if _e298 {
                        phi_482_ = _e304[2];
                    } else {
                        phi_482_ = _e308;
                    }
                    let _e311 = phi_482_;
                    let _e313 = ((_e311 * _e282) * _e288);
                    let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e317 {
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) * 0.00000011920929f);
                        phi_505_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                    } else {
                        phi_505_ = 0f;
                    }
                    let _e325 = phi_505_;
                    let _e326 = (_e303 + _e325);
                    let _e327 = (_e303 - _e325);
                    let _e328 = select(_e313, 0f, _e317);
                    if _e317 {
                        phi_516_ = 38685626000000000000000000f;
                    } else {
                        phi_516_ = (1f / _e313);
                    }
                    let _e331 = phi_516_;
                    let _e332 = (_e253 == 0u);
                    if _e332 {
                        phi_525_ = _e292[0];
                    } else {
                        phi_525_ = _e292[1];
                    }
                    let _e336 = phi_525_;
                    let _e337 = (_e253 == 2u);
                    if _e337 {
                        phi_531_ = _e292[2];
                    } else {
                        phi_531_ = _e336;
                    }
                    let _e340 = phi_531_;
                    let _e342 = ((_e340 * _e265) * _e271);
                    if _e332 {
                        phi_542_ = _e304[0];
                    } else {
                        phi_542_ = _e304[1];
                    }
                    let _e346 = phi_542_;
                    if _e337 {
                        phi_548_ = _e304[2];
                    } else {
                        phi_548_ = _e346;
                    }
                    let _e349 = phi_548_;
                    let _e351 = ((_e349 * _e282) * _e288);
                    let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e355 {
                        let _e359 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) * 0.00000011920929f);
                        phi_571_ = select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f));
                    } else {
                        phi_571_ = 0f;
                    }
                    let _e363 = phi_571_;
                    let _e364 = (_e342 + _e363);
                    let _e365 = (_e342 - _e363);
                    let _e366 = select(_e351, 0f, _e355);
                    if _e355 {
                        phi_582_ = 38685626000000000000000000f;
                    } else {
                        phi_582_ = (1f / _e351);
                    }
                    let _e369 = phi_582_;
                    let _e370 = (_e255 == 0u);
                    if _e370 {
                        phi_591_ = _e292[0];
                    } else {
                        phi_591_ = _e292[1];
                    }
                    let _e374 = phi_591_;
                    let _e375 = (_e255 == 2u);
                    if _e375 {
                        phi_597_ = _e292[2];
                    } else {
                        phi_597_ = _e374;
                    }
                    let _e378 = phi_597_;
                    let _e380 = ((_e378 * _e265) * _e271);
                    if _e370 {
                        phi_608_ = _e304[0];
                    } else {
                        phi_608_ = _e304[1];
                    }
                    let _e384 = phi_608_;
                    if _e375 {
                        phi_614_ = _e304[2];
                    } else {
                        phi_614_ = _e384;
                    }
                    let _e387 = phi_614_;
                    let _e389 = ((_e387 * _e282) * _e288);
                    let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e393 {
                        let _e397 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) * 0.00000011920929f);
                        phi_637_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                    } else {
                        phi_637_ = 0f;
                    }
                    let _e401 = phi_637_;
                    let _e402 = (_e380 + _e401);
                    let _e403 = (_e380 - _e401);
                    let _e404 = select(_e389, 0f, _e393);
                    if _e393 {
                        phi_648_ = 38685626000000000000000000f;
                    } else {
                        phi_648_ = (1f / _e389);
                    }
                    let _e407 = phi_648_;
                    let _e410 = bitcast<f32>((bitcast<u32>(_e303) & 2147483647u));
                    let _e413 = bitcast<f32>((bitcast<u32>(_e342) & 2147483647u));
                    let _e415 = select(_e413, _e410, (_e410 > _e413));
                    let _e418 = bitcast<f32>((bitcast<u32>(_e380) & 2147483647u));
                    let _e421 = (_e122 + _e235);
                    if (_e216 && (select(_e418, _e415, (_e415 > _e418)) <= 1099511600000f)) {
                        let _e424 = (_e421 / 3i);
                        let _e431 = bitcast<f32>((bitcast<u32>((_e424 + 127i)) << bitcast<u32>(23i)));
                        let _e438 = bitcast<f32>((bitcast<u32>(((_e421 - (2i * _e424)) + 127i)) << bitcast<u32>(23i)));
                        let _e439 = (((_e201 * _e431) * _e431) * _e438);
                        let _e441 = select(340282350000000000000000000000000000000f, _e439, (_e439 < 340282350000000000000000000000000000000f));
                        let _e446 = (((_e210 * _e431) * _e431) * _e438);
                        let _e448 = select(340282350000000000000000000000000000000f, _e446, (_e446 < 340282350000000000000000000000000000000f));
                        phi_748_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                        phi_749_ = select(-340282350000000000000000000000000000000f, _e441, (_e441 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_748_ = 0f;
                        phi_749_ = 1f;
                    }
                    let _e452 = phi_748_;
                    let _e454 = phi_749_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e459 = (_e254 % 3u);
                    let _e460 = (_e459 < 3u);
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e462 = local_1[_e459];
                    let _e465 = (_e253 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_1[_e465];
                    let _e471 = (_e255 % 3u);
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
                    phi_3291_ = false;
                    phi_839_ = type_44(type_37(type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e452), 0u, 0u);
                    phi_842_ = type_51(type_33(vec4<f32>((f32(_e462) * _e134), (f32(_e468) * _e134), (f32(_e474) * _e134), 0f), vec4<f32>((f32(_e479) * _e134), (f32(_e483) * _e134), (f32(_e487) * _e134), 0f)), select(0u, 2147483648u, (_e84 == 0u)));
                    phi_844_ = ((3u * _e84) + 1u);
                    phi_846_ = (_e454 <= _e452);
                    phi_848_ = 0u;
                    loop {
                        let _e497 = phi_3291_;
                        let _e499 = phi_839_;
                        let _e501 = phi_842_;
                        let _e503 = phi_844_;
                        let _e505 = phi_846_;
                        let _e507 = phi_848_;
                        local_10 = _e499;
                        local_11 = _e499;
                        if _e505 {
                            phi_859_ = true;
                        } else {
                            phi_859_ = (_e507 > 0u);
                        }
                        let _e510 = phi_859_;
                        if _e510 {
                            let _e511 = (_e503 > 0u);
                            if _e511 {
                                if _e505 {
                                    phi_945_ = _e501;
                                    phi_946_ = _e505;
                                    phi_947_ = _e507;
                                } else {
                                    let _e512 = (_e507 - 1u);
                                    let _e513 = (_e512 % 128u);
                                    let _e514 = (_e513 < 128u);
                                    if _e514 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e516 = local_7[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e518 = local_6[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e520 = local_5[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e522 = local_4[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e524 = local_3[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e526 = local_2[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e531 = local_8[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3399_ = true;
                                        break;
                                    }
                                    let _e534 = local_9[_e513];
                                    phi_945_ = type_51(type_33(vec4<f32>(_e516, _e518, _e520, 0f), vec4<f32>(_e522, _e524, _e526, 0f)), _e531);
                                    phi_946_ = (_e534 <= _e499.member.member_1);
                                    phi_947_ = _e512;
                                }
                                let _e539 = phi_945_;
                                let _e541 = phi_946_;
                                let _e543 = phi_947_;
                                if _e541 {
                                    if ((_e539.member_1 & 2147483648u) != 0u) {
                                        phi_965_ = _e499;
                                        phi_968_ = type_4(0u, ((_e539.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1015 = phi_965_;
                                            let _e1017 = phi_968_;
                                            local_12 = _e1015;
                                            if (_e1017.member < _e1017.member_1) {
                                                phi_969_ = type_4((_e1017.member + 1u), _e1017.member_1);
                                                phi_991_ = type_4(1u, _e1017.member);
                                            } else {
                                                phi_969_ = _e1017;
                                                phi_991_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1030 = phi_969_;
                                            let _e1032 = phi_991_;
                                            let _e1036 = (bitcast<i32>(_e1032.member) != 0i);
                                            if _e1036 {
                                                let _e1042 = type_44(_e1015.member, _e1015.member_1, (_e1015.member_2 + 1u));
                                                let _e1043 = ((_e539.member_1 & 268435455u) + _e1032.member_1);
                                                let _e1044 = (_e1043 < _e86);
                                                if _e1044 {
                                                    if _e1044 {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1048 = global_2.member[_e1043].member_1;
                                                    phi_1015_ = _e1048;
                                                } else {
                                                    phi_1015_ = 4294967295u;
                                                }
                                                let _e1050 = phi_1015_;
                                                if (_e1043 >= _e86) {
                                                    phi_1104_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1044 {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    if (_e459 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1057 = global_2.member[_e1043].member[_e459];
                                                    if (_e465 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1063 = global_2.member[_e1043].member[_e465];
                                                    if (_e471 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1069 = global_2.member[_e1043].member[_e471];
                                                    let _e1071 = (3u + _e459);
                                                    if (_e1071 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1077 = global_2.member[_e1043].member[_e1071];
                                                    let _e1078 = (3u + _e465);
                                                    if (_e1078 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1084 = global_2.member[_e1043].member[_e1078];
                                                    let _e1085 = (3u + _e471);
                                                    if (_e1085 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1091 = global_2.member[_e1043].member[_e1085];
                                                    let _e1093 = (6u + _e459);
                                                    if (_e1093 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1099 = global_2.member[_e1043].member[_e1093];
                                                    let _e1100 = (6u + _e465);
                                                    if (_e1100 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1106 = global_2.member[_e1043].member[_e1100];
                                                    let _e1107 = (6u + _e471);
                                                    if (_e1107 < 9u) {
                                                    } else {
                                                        phi_3285_ = true;
                                                        break;
                                                    }
                                                    let _e1113 = global_2.member[_e1043].member[_e1107];
                                                    phi_1104_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1057, _e1063, _e1069), array<f32, 3>(_e1077, _e1084, _e1091), array<f32, 3>(_e1099, _e1106, _e1113));
                                                }
                                                let _e1117 = phi_1104_;
                                                let _e1126 = (_e1117[0][2] - _e380);
                                                let _e1129 = (((_e1117[0][0] - _e303) * _e404) - (_e1126 * _e328));
                                                let _e1132 = (((_e1117[0][1] - _e342) * _e404) - (_e1126 * _e366));
                                                let _e1139 = (_e1117[1][2] - _e380);
                                                let _e1142 = (((_e1117[1][0] - _e303) * _e404) - (_e1139 * _e328));
                                                let _e1145 = (((_e1117[1][1] - _e342) * _e404) - (_e1139 * _e366));
                                                let _e1152 = (_e1117[2][2] - _e380);
                                                let _e1155 = (((_e1117[2][0] - _e303) * _e404) - (_e1152 * _e328));
                                                let _e1158 = (((_e1117[2][1] - _e342) * _e404) - (_e1152 * _e366));
                                                let _e1159 = (_e1155 * _e1145);
                                                let _e1160 = (_e1158 * _e1142);
                                                let _e1161 = (_e1129 * _e1158);
                                                let _e1162 = (_e1132 * _e1155);
                                                let _e1163 = (_e1142 * _e1132);
                                                let _e1164 = (_e1145 * _e1129);
                                                let _e1169 = (((_e1159 >= _e1160) && (_e1161 >= _e1162)) && (_e1163 >= _e1164));
                                                if (_e1169 || (((_e1159 <= _e1160) && (_e1161 <= _e1162)) && (_e1163 <= _e1164))) {
                                                    let _e1176 = select(-1f, 1f, _e1169);
                                                    let _e1178 = ((_e1159 - _e1160) * _e1176);
                                                    let _e1180 = select(0f, _e1178, (_e1178 > 0f));
                                                    let _e1182 = ((_e1161 - _e1162) * _e1176);
                                                    let _e1184 = select(0f, _e1182, (_e1182 > 0f));
                                                    let _e1186 = ((_e1163 - _e1164) * _e1176);
                                                    let _e1188 = select(0f, _e1186, (_e1186 > 0f));
                                                    let _e1190 = ((_e1180 + _e1184) + _e1188);
                                                    if (_e1190 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1670_ = type_29();
                                                        phi_1671_ = true;
                                                    } else {
                                                        let _e1193 = select(_e1117[1][0], _e1117[0][0], (_e1117[0][0] < _e1117[1][0]));
                                                        let _e1197 = select(_e1117[1][0], _e1117[0][0], (_e1117[0][0] > _e1117[1][0]));
                                                        let _e1201 = select(_e1117[1][1], _e1117[0][1], (_e1117[0][1] < _e1117[1][1]));
                                                        let _e1205 = select(_e1117[1][1], _e1117[0][1], (_e1117[0][1] > _e1117[1][1]));
                                                        let _e1209 = select(_e1117[1][2], _e1117[0][2], (_e1117[0][2] < _e1117[1][2]));
                                                        let _e1213 = select(_e1117[1][2], _e1117[0][2], (_e1117[0][2] > _e1117[1][2]));
                                                        let _e1218 = ((select(_e1117[2][0], _e1193, (_e1193 < _e1117[2][0])) - _e326) * _e331);
                                                        let _e1219 = ((select(_e1117[2][0], _e1197, (_e1197 > _e1117[2][0])) - _e327) * _e331);
                                                        let _e1222 = ((select(_e1117[2][1], _e1201, (_e1201 < _e1117[2][1])) - _e364) * _e369);
                                                        let _e1223 = ((select(_e1117[2][1], _e1205, (_e1205 > _e1117[2][1])) - _e365) * _e369);
                                                        let _e1226 = ((select(_e1117[2][2], _e1209, (_e1209 < _e1117[2][2])) - _e402) * _e407);
                                                        let _e1227 = ((select(_e1117[2][2], _e1213, (_e1213 > _e1117[2][2])) - _e403) * _e407);
                                                        let _e1229 = select(_e1227, _e1226, (_e1226 < _e1227));
                                                        let _e1231 = select(_e1227, _e1226, (_e1226 > _e1227));
                                                        let _e1233 = select(_e1219, _e1218, (_e1218 < _e1219));
                                                        let _e1235 = select(_e1223, _e1222, (_e1222 < _e1223));
                                                        let _e1237 = select(_e1235, _e1233, (_e1233 > _e1235));
                                                        let _e1239 = select(_e1229, _e1237, (_e1237 > _e1229));
                                                        let _e1241 = select(_e1219, _e1218, (_e1218 > _e1219));
                                                        let _e1243 = select(_e1223, _e1222, (_e1222 > _e1223));
                                                        let _e1245 = select(_e1243, _e1241, (_e1241 < _e1243));
                                                        let _e1247 = select(_e1231, _e1245, (_e1245 < _e1231));
                                                        let _e1248 = -(_e1229);
                                                        let _e1254 = select(_e454, _e1239, (_e1239 > _e454));
                                                        if (_e1254 > (_e1247 + (select(_e1248, _e1231, (_e1231 > _e1248)) * 0.0000019073523f))) {
                                                            phi_1665_ = type_29();
                                                            phi_1666_ = true;
                                                        } else {
                                                            let _e1256 = (_e1254 > _e1015.member.member_1);
                                                            if _e1256 {
                                                                phi_1664_ = type_29();
                                                            } else {
                                                                let _e1260 = (_e1117[1][0] - _e1117[0][0]);
                                                                let _e1261 = (_e1117[1][1] - _e1117[0][1]);
                                                                let _e1262 = (_e1117[1][2] - _e1117[0][2]);
                                                                let _e1263 = vec3<f32>(_e1260, _e1261, _e1262);
                                                                let _e1264 = (_e1117[2][0] - _e1117[1][0]);
                                                                let _e1265 = (_e1117[2][1] - _e1117[1][1]);
                                                                let _e1266 = (_e1117[2][2] - _e1117[1][2]);
                                                                let _e1267 = vec3<f32>(_e1264, _e1265, _e1266);
                                                                let _e1268 = (_e1117[0][0] - _e1117[2][0]);
                                                                let _e1269 = (_e1117[0][1] - _e1117[2][1]);
                                                                let _e1270 = (_e1117[0][2] - _e1117[2][2]);
                                                                let _e1271 = vec3<f32>(_e1268, _e1269, _e1270);
                                                                let _e1274 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                let _e1277 = bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u));
                                                                let _e1279 = select(_e1277, _e1274, (_e1274 > _e1277));
                                                                let _e1282 = bitcast<f32>((bitcast<u32>(_e1262) & 2147483647u));
                                                                let _e1284 = select(_e1282, _e1279, (_e1279 > _e1282));
                                                                let _e1287 = bitcast<f32>((bitcast<u32>(_e1264) & 2147483647u));
                                                                let _e1290 = bitcast<f32>((bitcast<u32>(_e1265) & 2147483647u));
                                                                let _e1292 = select(_e1290, _e1287, (_e1287 > _e1290));
                                                                let _e1295 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
                                                                let _e1297 = select(_e1295, _e1292, (_e1292 > _e1295));
                                                                let _e1300 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                let _e1303 = bitcast<f32>((bitcast<u32>(_e1269) & 2147483647u));
                                                                let _e1305 = select(_e1303, _e1300, (_e1300 > _e1303));
                                                                let _e1308 = bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u));
                                                                let _e1310 = select(_e1308, _e1305, (_e1305 > _e1308));
                                                                let _e1312 = select(_e1297, _e1284, (_e1284 > _e1297));
                                                                let _e1314 = select(_e1310, _e1312, (_e1312 > _e1310));
                                                                if (_e1284 == _e1314) {
                                                                    phi_1575_ = _e1267;
                                                                    phi_1576_ = _e1271;
                                                                } else {
                                                                    let _e1317 = vec3((_e1297 == _e1314));
                                                                    phi_1575_ = select(_e1263, _e1271, _e1317);
                                                                    phi_1576_ = select(_e1267, _e1263, _e1317);
                                                                }
                                                                let _e1321 = phi_1575_;
                                                                let _e1323 = phi_1576_;
                                                                let _e1330 = ((_e1321.y * _e1323.z) - (_e1323.y * _e1321.z));
                                                                let _e1335 = ((_e1321.z * _e1323.x) - (_e1323.z * _e1321.x));
                                                                let _e1338 = ((_e1321.x * _e1323.y) - (_e1323.x * _e1321.y));
                                                                if (_e1180 >= _e1184) {
                                                                    phi_1607_ = select(true, false, (_e1180 >= _e1188));
                                                                } else {
                                                                    phi_1607_ = true;
                                                                }
                                                                let _e1343 = phi_1607_;
                                                                if _e1343 {
                                                                    phi_1616_ = select(vec3<f32>(_e1117[2][0], _e1117[2][1], _e1117[2][2]), vec3<f32>(_e1117[1][0], _e1117[1][1], _e1117[1][2]), vec3((_e1184 >= _e1188)));
                                                                } else {
                                                                    phi_1616_ = vec3<f32>(_e1117[0][0], _e1117[0][1], _e1117[0][2]);
                                                                }
                                                                let _e1348 = phi_1616_;
                                                                let _e1365 = ((((_e1330 * (_e1348.x - _e303)) + (_e1335 * (_e1348.y - _e342))) + (_e1338 * (_e1348.z - _e380))) / (((_e1330 * _e328) + (_e1335 * _e366)) + (_e1338 * _e404)));
                                                                let _e1367 = select(_e1247, _e1365, (_e1365 < _e1247));
                                                                let _e1369 = select(_e1239, _e1367, (_e1367 > _e1239));
                                                                if (_e1369 >= _e454) {
                                                                    let _e1371 = (_e1369 <= _e1015.member.member_1);
                                                                    if _e1371 {
                                                                        let _e1372 = (1f / _e1190);
                                                                        phi_1656_ = type_29(_e1369, (_e1184 * _e1372), (_e1188 * _e1372), _e1050);
                                                                    } else {
                                                                        phi_1656_ = type_29();
                                                                    }
                                                                    let _e1377 = phi_1656_;
                                                                    phi_1658_ = _e1377;
                                                                    phi_1659_ = select(true, false, _e1371);
                                                                } else {
                                                                    phi_1658_ = type_29();
                                                                    phi_1659_ = true;
                                                                }
                                                                let _e1380 = phi_1658_;
                                                                let _e1382 = phi_1659_;
                                                                if _e1382 {
                                                                    phi_1663_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1663_ = _e1380;
                                                                }
                                                                let _e1384 = phi_1663_;
                                                                phi_1664_ = _e1384;
                                                            }
                                                            let _e1386 = phi_1664_;
                                                            phi_1665_ = _e1386;
                                                            phi_1666_ = _e1256;
                                                        }
                                                        let _e1388 = phi_1665_;
                                                        let _e1390 = phi_1666_;
                                                        phi_1670_ = _e1388;
                                                        phi_1671_ = _e1390;
                                                    }
                                                    let _e1392 = phi_1670_;
                                                    let _e1394 = phi_1671_;
                                                    phi_1675_ = _e1392;
                                                    phi_1676_ = _e1394;
                                                } else {
                                                    phi_1675_ = type_29();
                                                    phi_1676_ = true;
                                                }
                                                let _e1396 = phi_1675_;
                                                let _e1398 = phi_1676_;
                                                if _e1398 {
                                                    phi_1680_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1680_ = _e1396;
                                                }
                                                let _e1400 = phi_1680_;
                                                if (_e1400.member_3 != 4294967295u) {
                                                    if (_e1050 != 4294967295u) {
                                                        if (_e1400.member < _e1015.member.member.member) {
                                                            phi_1706_ = true;
                                                        } else {
                                                            if (_e1400.member == _e1015.member.member.member) {
                                                                phi_1705_ = (_e1400.member_3 < _e1015.member.member.member_3);
                                                            } else {
                                                                phi_1705_ = false;
                                                            }
                                                            let _e1415 = phi_1705_;
                                                            phi_1706_ = _e1415;
                                                        }
                                                        let _e1417 = phi_1706_;
                                                        if _e1417 {
                                                            phi_1713_ = type_44(type_37(_e1400, _e1400.member), _e1042.member_1, _e1042.member_2);
                                                        } else {
                                                            phi_1713_ = _e1042;
                                                        }
                                                        let _e1424 = phi_1713_;
                                                        phi_1714_ = _e1424;
                                                    } else {
                                                        phi_1714_ = _e1042;
                                                    }
                                                    let _e1426 = phi_1714_;
                                                    phi_1715_ = _e1426;
                                                } else {
                                                    phi_1715_ = _e1042;
                                                }
                                                let _e1428 = phi_1715_;
                                                phi_966_ = _e1428;
                                            } else {
                                                phi_966_ = type_44();
                                            }
                                            let _e1430 = phi_966_;
                                            continue;
                                            continuing {
                                                phi_965_ = _e1430;
                                                phi_968_ = _e1030;
                                                phi_3285_ = _e497;
                                                break if !(_e1036);
                                            }
                                        }
                                        let _e1433 = phi_3285_;
                                        phi_3399_ = _e1433;
                                        if _e1433 {
                                            break;
                                        }
                                        phi_3403_ = _e1433;
                                        let _e1586 = local_12;
                                        phi_3065_ = _e1586;
                                        phi_3066_ = _e539;
                                        phi_3067_ = false;
                                        phi_3068_ = _e543;
                                    } else {
                                        if (_e539.member_1 >= _e84) {
                                            phi_2621_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e539.member_1 < _e84) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e561 = ((1u + _e254) % 4u);
                                            if (_e561 < 4u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e566 = global_4.member[_e539.member_1][_e561];
                                            let _e568 = ((1u + _e253) % 4u);
                                            if (_e568 < 4u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e573 = global_4.member[_e539.member_1][_e568];
                                            let _e575 = ((1u + _e255) % 4u);
                                            if (_e575 < 4u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e580 = global_4.member[_e539.member_1][_e575];
                                            let _e582 = ((_e254 + 1u) % 4u);
                                            if (_e582 < 4u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e587 = global_4.member[_e539.member_1][_e582];
                                            let _e589 = (_e587 >> bitcast<u32>(11u));
                                            let _e591 = ((_e253 + 1u) % 4u);
                                            if (_e591 < 4u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e596 = global_4.member[_e539.member_1][_e591];
                                            let _e598 = (_e596 >> bitcast<u32>(11u));
                                            let _e600 = ((_e255 + 1u) % 4u);
                                            if (_e600 < 4u) {
                                            } else {
                                                phi_3399_ = true;
                                                break;
                                            }
                                            let _e605 = global_4.member[_e539.member_1][_e600];
                                            let _e607 = (_e605 >> bitcast<u32>(11u));
                                            let _e630 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.x - _e539.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e631 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.y - _e539.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e632 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.z - _e539.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e634 = select(_e134, _e630, (_e630 > _e134));
                                            let _e636 = select(_e134, _e631, (_e631 > _e134));
                                            let _e638 = select(_e134, _e632, (_e632 > _e134));
                                            let _e663 = bitcast<u32>((f32(bitcast<i32>((_e566 & 1023u))) * _e634));
                                            let _e668 = (bitcast<i32>((_e566 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e671 = bitcast<f32>((_e663 & bitcast<u32>(_e668)));
                                            let _e672 = bitcast<u32>((f32(bitcast<i32>((_e573 & 1023u))) * _e636));
                                            let _e677 = (bitcast<i32>((_e573 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e680 = bitcast<f32>((_e672 & bitcast<u32>(_e677)));
                                            let _e681 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e638));
                                            let _e686 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e689 = bitcast<f32>((_e681 & bitcast<u32>(_e686)));
                                            let _e693 = bitcast<f32>((_e663 & bitcast<u32>(~(_e668))));
                                            let _e697 = bitcast<f32>((_e672 & bitcast<u32>(~(_e677))));
                                            let _e701 = bitcast<f32>((_e681 & bitcast<u32>(~(_e686))));
                                            let _e702 = bitcast<u32>((f32(bitcast<i32>((_e589 & 1023u))) * _e634));
                                            let _e707 = (bitcast<i32>((_e589 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e710 = bitcast<f32>((_e702 & bitcast<u32>(_e707)));
                                            let _e711 = bitcast<u32>((f32(bitcast<i32>((_e598 & 1023u))) * _e636));
                                            let _e716 = (bitcast<i32>((_e598 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e719 = bitcast<f32>((_e711 & bitcast<u32>(_e716)));
                                            let _e720 = bitcast<u32>((f32(bitcast<i32>((_e607 & 1023u))) * _e638));
                                            let _e725 = (bitcast<i32>((_e607 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e728 = bitcast<f32>((_e720 & bitcast<u32>(_e725)));
                                            let _e732 = bitcast<f32>((_e702 & bitcast<u32>(~(_e707))));
                                            let _e736 = bitcast<f32>((_e711 & bitcast<u32>(~(_e716))));
                                            let _e740 = bitcast<f32>((_e720 & bitcast<u32>(~(_e725))));
                                            let _e770 = global_4.member[_e539.member_1][0u];
                                            let _e774 = global_4.member[_e539.member_1][1u];
                                            let _e778 = global_4.member[_e539.member_1][2u];
                                            let _e782 = global_4.member[_e539.member_1][3u];
                                            let _e794 = (((_e774 >> bitcast<u32>(22i)) | ((_e778 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e782 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e795 = (_e770 & 268435455u);
                                            let _e796 = (_e794 & 268435455u);
                                            let _e799 = ((_e770 >> bitcast<u32>(28u)) & 7u);
                                            let _e807 = ((_e770 >> bitcast<u32>(31i)) | (((_e794 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e808 = (_e799 != 0u);
                                            if (_e799 == 0u) {
                                                phi_2583_ = _e795;
                                            } else {
                                                if (_e799 == 7u) {
                                                    phi_2582_ = 2147483648u;
                                                } else {
                                                    phi_2582_ = ((2147483648u | (_e799 << bitcast<u32>(28u))) | (_e796 & 268435455u));
                                                }
                                                let _e817 = phi_2582_;
                                                phi_2583_ = _e817;
                                            }
                                            let _e819 = phi_2583_;
                                            if _e808 {
                                                let _e820 = (_e799 != 7u);
                                                if _e820 {
                                                    phi_2593_ = (_e796 + _e799);
                                                } else {
                                                    phi_2593_ = u32();
                                                }
                                                let _e823 = phi_2593_;
                                                phi_2595_ = _e823;
                                                phi_2596_ = select(true, false, _e820);
                                            } else {
                                                phi_2595_ = u32();
                                                phi_2596_ = true;
                                            }
                                            let _e826 = phi_2595_;
                                            let _e828 = phi_2596_;
                                            if (_e807 == 0u) {
                                                phi_2617_ = (_e795 + select(0u, 1u, !(_e808)));
                                            } else {
                                                if (_e807 == 7u) {
                                                    phi_2616_ = 2147483648u;
                                                } else {
                                                    phi_2616_ = ((2147483648u | (_e807 << bitcast<u32>(28u))) | (select(_e826, _e796, _e828) & 268435455u));
                                                }
                                                let _e841 = phi_2616_;
                                                phi_2617_ = _e841;
                                            }
                                            let _e843 = phi_2617_;
                                            phi_2621_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e539.member.member.x + _e671), (_e539.member.member.x + _e693), (_e539.member.member_1.x - _e710), (_e539.member.member_1.x - _e732)), vec4<f32>((_e539.member.member.y + _e680), (_e539.member.member.y + _e697), (_e539.member.member_1.y - _e719), (_e539.member.member_1.y - _e736)), vec4<f32>((_e539.member.member.z + _e689), (_e539.member.member.z + _e701), (_e539.member.member_1.z - _e728), (_e539.member.member_1.z - _e740))), type_51(type_33((_e539.member.member + vec4<f32>(_e671, _e680, _e689, 0f)), (_e539.member.member_1 - vec4<f32>(_e710, _e719, _e728, 0f))), _e819), type_51(type_33((_e539.member.member + vec4<f32>(_e693, _e697, _e701, 0f)), (_e539.member.member_1 - vec4<f32>(_e732, _e736, _e740, 0f))), _e843));
                                        }
                                        let _e848 = phi_2621_;
                                        let _e861 = ((_e848.member[0].x - _e326) * _e331);
                                        let _e862 = ((_e848.member[0].y - _e326) * _e331);
                                        let _e863 = ((_e848.member[0].z - _e327) * _e331);
                                        let _e864 = ((_e848.member[0].w - _e327) * _e331);
                                        let _e874 = ((_e848.member[1].x - _e364) * _e369);
                                        let _e875 = ((_e848.member[1].y - _e364) * _e369);
                                        let _e876 = ((_e848.member[1].z - _e365) * _e369);
                                        let _e877 = ((_e848.member[1].w - _e365) * _e369);
                                        let _e887 = ((_e848.member[2].x - _e402) * _e407);
                                        let _e888 = ((_e848.member[2].y - _e402) * _e407);
                                        let _e889 = ((_e848.member[2].z - _e403) * _e407);
                                        let _e890 = ((_e848.member[2].w - _e403) * _e407);
                                        let _e892 = select(_e889, _e887, (_e887 < _e889));
                                        let _e894 = select(_e890, _e888, (_e888 < _e890));
                                        let _e896 = select(_e889, _e887, (_e887 > _e889));
                                        let _e898 = select(_e890, _e888, (_e888 > _e890));
                                        let _e900 = select(_e863, _e861, (_e861 < _e863));
                                        let _e902 = select(_e864, _e862, (_e862 < _e864));
                                        let _e904 = select(_e876, _e874, (_e874 < _e876));
                                        let _e906 = select(_e877, _e875, (_e875 < _e877));
                                        let _e908 = select(_e904, _e900, (_e900 > _e904));
                                        let _e910 = select(_e906, _e902, (_e902 > _e906));
                                        let _e912 = select(_e892, _e908, (_e908 > _e892));
                                        let _e914 = select(_e894, _e910, (_e910 > _e894));
                                        let _e916 = select(_e863, _e861, (_e861 > _e863));
                                        let _e918 = select(_e864, _e862, (_e862 > _e864));
                                        let _e920 = select(_e876, _e874, (_e874 > _e876));
                                        let _e922 = select(_e877, _e875, (_e875 > _e877));
                                        let _e924 = select(_e920, _e916, (_e916 < _e920));
                                        let _e926 = select(_e922, _e918, (_e918 < _e922));
                                        let _e931 = -(_e892);
                                        let _e932 = -(_e894);
                                        let _e939 = (select(_e896, _e924, (_e924 < _e896)) + (select(_e931, _e896, (_e896 > _e931)) * 0.0000019073523f));
                                        let _e940 = (select(_e898, _e926, (_e926 < _e898)) + (select(_e932, _e898, (_e898 > _e932)) * 0.0000019073523f));
                                        let _e942 = select(_e454, _e912, (_e912 > _e454));
                                        let _e944 = select(_e454, _e914, (_e914 > _e454));
                                        let _e949 = (_e942 <= select(_e499.member.member_1, _e939, (_e939 < _e499.member.member_1)));
                                        let _e950 = (_e944 <= select(_e499.member.member_1, _e940, (_e940 < _e499.member.member_1)));
                                        let _e951 = (_e942 <= _e944);
                                        if _e949 {
                                            if _e950 {
                                                if _e951 {
                                                    phi_2965_ = _e848.member_2;
                                                } else {
                                                    phi_2965_ = _e848.member_1;
                                                }
                                                let _e955 = phi_2965_;
                                                let _e977 = (_e543 % 128u);
                                                let _e978 = (_e977 < 128u);
                                                if _e978 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_8[_e977] = _e955.member_1;
                                                if _e978 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_7[_e977] = _e955.member.member.x;
                                                if _e978 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_6[_e977] = _e955.member.member.y;
                                                if _e978 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_5[_e977] = _e955.member.member.z;
                                                if _e978 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_4[_e977] = _e955.member.member_1.x;
                                                if _e978 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_3[_e977] = _e955.member.member_1.y;
                                                if _e978 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_2[_e977] = _e955.member.member_1.z;
                                                if _e978 {
                                                } else {
                                                    phi_3399_ = true;
                                                    break;
                                                }
                                                local_9[_e977] = select(_e944, _e942, (_e942 > _e944));
                                                if _e951 {
                                                    phi_3042_ = _e848.member_1;
                                                } else {
                                                    phi_3042_ = _e848.member_2;
                                                }
                                                let _e991 = phi_3042_;
                                                phi_3043_ = _e991;
                                                phi_3044_ = (_e543 + 1u);
                                            } else {
                                                phi_3043_ = type_51();
                                                phi_3044_ = u32();
                                            }
                                            let _e993 = phi_3043_;
                                            let _e995 = phi_3044_;
                                            phi_3046_ = _e993;
                                            phi_3047_ = _e995;
                                            phi_3048_ = select(true, false, _e950);
                                        } else {
                                            phi_3046_ = type_51();
                                            phi_3047_ = u32();
                                            phi_3048_ = true;
                                        }
                                        let _e998 = phi_3046_;
                                        let _e1000 = phi_3047_;
                                        let _e1002 = phi_3048_;
                                        if _e1002 {
                                            if _e949 {
                                                phi_3057_ = _e848.member_1;
                                            } else {
                                                phi_3057_ = _e848.member_2;
                                            }
                                            let _e1006 = phi_3057_;
                                            phi_3062_ = _e1006;
                                            phi_3063_ = select(_e950, true, _e949);
                                        } else {
                                            phi_3062_ = _e998;
                                            phi_3063_ = _e541;
                                        }
                                        let _e1009 = phi_3062_;
                                        let _e1011 = phi_3063_;
                                        phi_3403_ = _e497;
                                        phi_3065_ = type_44(_e499.member, (_e499.member_1 + 1u), _e499.member_2);
                                        phi_3066_ = _e1009;
                                        phi_3067_ = _e1011;
                                        phi_3068_ = select(_e1000, _e543, _e1002);
                                    }
                                    let _e1435 = phi_3403_;
                                    let _e1437 = phi_3065_;
                                    let _e1439 = phi_3066_;
                                    let _e1441 = phi_3067_;
                                    let _e1443 = phi_3068_;
                                    phi_3402_ = _e1435;
                                    phi_3069_ = _e1437;
                                    phi_3070_ = _e1439;
                                    phi_3071_ = (_e503 - 1u);
                                    phi_3072_ = _e1441;
                                    phi_3073_ = _e1443;
                                } else {
                                    phi_3402_ = _e497;
                                    phi_3069_ = _e499;
                                    phi_3070_ = _e539;
                                    phi_3071_ = _e503;
                                    phi_3072_ = _e541;
                                    phi_3073_ = _e543;
                                }
                                let _e1445 = phi_3402_;
                                let _e1447 = phi_3069_;
                                let _e1449 = phi_3070_;
                                let _e1451 = phi_3071_;
                                let _e1453 = phi_3072_;
                                let _e1455 = phi_3073_;
                                phi_3401_ = _e1445;
                                phi_3074_ = _e1447;
                                phi_3075_ = _e1449;
                                phi_3076_ = _e1451;
                                phi_3077_ = _e1453;
                                phi_3078_ = _e1455;
                            } else {
                                phi_3401_ = _e497;
                                phi_3074_ = type_44();
                                phi_3075_ = type_51();
                                phi_3076_ = u32();
                                phi_3077_ = bool();
                                phi_3078_ = u32();
                            }
                            let _e1457 = phi_3401_;
                            let _e1459 = phi_3074_;
                            let _e1461 = phi_3075_;
                            let _e1463 = phi_3076_;
                            let _e1465 = phi_3077_;
                            let _e1467 = phi_3078_;
                            phi_3400_ = _e1457;
                            phi_840_ = _e1459;
                            phi_843_ = _e1461;
                            phi_845_ = _e1463;
                            phi_847_ = _e1465;
                            phi_849_ = _e1467;
                            phi_3079_ = _e511;
                        } else {
                            phi_3400_ = _e497;
                            phi_840_ = type_44();
                            phi_843_ = type_51();
                            phi_845_ = u32();
                            phi_847_ = bool();
                            phi_849_ = u32();
                            phi_3079_ = false;
                        }
                        let _e1469 = phi_3400_;
                        let _e1471 = phi_840_;
                        let _e1473 = phi_843_;
                        let _e1475 = phi_845_;
                        let _e1477 = phi_847_;
                        let _e1479 = phi_849_;
                        let _e1481 = phi_3079_;
                        continue;
                        continuing {
                            phi_3291_ = _e1469;
                            phi_839_ = _e1471;
                            phi_842_ = _e1473;
                            phi_844_ = _e1475;
                            phi_846_ = _e1477;
                            phi_848_ = _e1479;
                            phi_3399_ = _e1469;
                            break if !(_e1481);
                        }
                    }
                    let _e1484 = phi_3399_;
                    if _e1484 {
                        break;
                    }
                    let _e1486 = local_10;
                    let _e1489 = local_11;
                    if _e142 {
                    } else {
                        break;
                    }
                    global_6.member[_e140][0u] = _e1486.member_1;
                    global_6.member[_e140][1u] = _e1489.member_2;
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
