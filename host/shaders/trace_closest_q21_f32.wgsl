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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
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
    member: type_21,
    member_1: f32,
}

struct type_38 {
    member: array<type_25>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_29,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
@group(0) @binding(4) 
var<storage> global_4: type_38;
@group(0) @binding(2) 
var<storage> global_5: type_45;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_23;

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
    var phi_380_: i32;
    var phi_381_: i32;
    var phi_391_: bool;
    var phi_401_: u32;
    var phi_402_: u32;
    var phi_404_: bool;
    var phi_409_: u32;
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
    var phi_3452_: bool;
    var phi_838_: type_33;
    var phi_841_: type_50;
    var phi_843_: u32;
    var phi_845_: bool;
    var phi_847_: u32;
    var phi_858_: bool;
    var phi_944_: type_50;
    var phi_945_: bool;
    var phi_946_: u32;
    var phi_2699_: u32;
    var phi_2700_: u32;
    var phi_2710_: u32;
    var phi_2712_: u32;
    var phi_2713_: bool;
    var phi_2733_: u32;
    var phi_2734_: u32;
    var phi_2738_: type_51;
    var phi_3082_: type_50;
    var phi_3159_: type_50;
    var phi_3160_: type_50;
    var phi_3161_: u32;
    var phi_3163_: type_50;
    var phi_3164_: u32;
    var phi_3165_: bool;
    var phi_3174_: type_50;
    var phi_3179_: type_50;
    var phi_3180_: bool;
    var phi_964_: type_33;
    var phi_967_: type_4;
    var phi_968_: type_4;
    var phi_990_: type_4;
    var phi_1011_: u32;
    var phi_1100_: array<array<f32, 3>, 3>;
    var phi_1217_: bool;
    var phi_1246_: bool;
    var phi_1647_: f32;
    var phi_1648_: f32;
    var phi_1649_: f32;
    var phi_1650_: f32;
    var phi_1651_: vec3<f32>;
    var phi_1652_: vec3<f32>;
    var phi_1653_: vec3<f32>;
    var phi_1654_: vec3<f32>;
    var phi_1685_: bool;
    var phi_1694_: vec3<f32>;
    var phi_1861_: bool;
    var phi_1885_: f32;
    var phi_1886_: f32;
    var phi_1909_: type_21;
    var phi_1911_: type_21;
    var phi_1912_: bool;
    var phi_1916_: type_21;
    var phi_1917_: type_21;
    var phi_1918_: type_21;
    var phi_1919_: bool;
    var phi_1923_: type_21;
    var phi_1924_: bool;
    var phi_1925_: type_21;
    var phi_1926_: bool;
    var phi_1927_: bool;
    var phi_1928_: type_21;
    var phi_1929_: bool;
    var phi_1930_: bool;
    var phi_1938_: type_21;
    var phi_1939_: bool;
    var phi_1943_: type_21;
    var phi_1968_: bool;
    var phi_1969_: bool;
    var phi_1975_: type_33;
    var phi_1976_: type_33;
    var phi_1977_: type_33;
    var phi_965_: type_33;
    var phi_3446_: bool;
    var phi_3592_: bool;
    var phi_3182_: type_33;
    var phi_3183_: type_50;
    var phi_3184_: bool;
    var phi_3185_: u32;
    var phi_3591_: bool;
    var phi_3186_: type_33;
    var phi_3187_: type_50;
    var phi_3188_: u32;
    var phi_3189_: bool;
    var phi_3190_: u32;
    var phi_3590_: bool;
    var phi_3191_: type_33;
    var phi_3192_: type_50;
    var phi_3193_: u32;
    var phi_3194_: bool;
    var phi_3195_: u32;
    var phi_3589_: bool;
    var phi_839_: type_33;
    var phi_842_: type_50;
    var phi_844_: u32;
    var phi_846_: bool;
    var phi_848_: u32;
    var phi_3196_: bool;
    var phi_3588_: bool;
    var local_10: type_33;
    var phi_3248_: type_21;
    var local_11: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e82 = global;
            let _e84 = arrayLength((&global_5.member));
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
            let _e141 = (_e140 < arrayLength((&global_4.member)));
            if _e141 {
                let _e142 = (_e140 < arrayLength((&global_6.member)));
                if _e142 {
                    if _e141 {
                    } else {
                        break;
                    }
                    let _e150 = global_4.member[_e140].member_2[0u];
                    let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                    let _e157 = global_4.member[_e140].member_2[1u];
                    let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                    let _e164 = global_4.member[_e140].member_2[2u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_4.member[_e140].member[0u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_4.member[_e140].member[1u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_4.member[_e140].member[2u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e189 = select(_e159, _e152, (_e159 < _e152));
                    let _e191 = select(_e166, _e189, (_e166 < _e189));
                    let _e193 = select(_e173, _e191, (_e173 < _e191));
                    let _e195 = select(_e180, _e193, (_e180 < _e193));
                    let _e197 = select(_e187, _e195, (_e187 < _e195));
                    let _e201 = global_4.member[_e140].member_1;
                    let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                    let _e210 = global_4.member[_e140].member_3;
                    let _e216 = (((select(_e203, _e197, (_e203 < _e197)) < 2139095040u) && ((bitcast<u32>(_e210) & 2147483647u) <= 2139095040u)) && (_e191 > 0u));
                    if _e216 {
                        let _e219 = (bitcast<u32>(bitcast<f32>(_e191)) & 2147483647u);
                        if (_e219 >= 8388608u) {
                            phi_380_ = (bitcast<i32>((_e219 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_380_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u))));
                        }
                        let _e233 = phi_380_;
                        phi_381_ = _e233;
                    } else {
                        phi_381_ = 0i;
                    }
                    let _e235 = phi_381_;
                    let _e236 = (_e152 == _e191);
                    if _e236 {
                        phi_391_ = true;
                    } else {
                        phi_391_ = (_e159 == _e191);
                    }
                    let _e239 = phi_391_;
                    let _e240 = select(1u, 0u, _e236);
                    if _e239 {
                        let _e241 = (_e240 + 1u);
                        phi_401_ = _e241;
                        phi_402_ = _e241;
                        phi_404_ = select(true, false, (_e241 == 2u));
                    } else {
                        phi_401_ = u32();
                        phi_402_ = 0u;
                        phi_404_ = true;
                    }
                    let _e245 = phi_401_;
                    let _e247 = phi_402_;
                    let _e249 = phi_404_;
                    if _e249 {
                        phi_409_ = (_e247 + 1u);
                    } else {
                        phi_409_ = 0u;
                    }
                    let _e253 = phi_409_;
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
                    let _e292 = global_4.member[_e140].member;
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
                    let _e304 = global_4.member[_e140].member_2;
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
                    let _e458 = (_e254 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_1[_e458];
                    let _e464 = (_e253 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e255 % 3u);
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
                    phi_3452_ = false;
                    phi_838_ = type_33(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e452);
                    phi_841_ = type_50(type_29(vec4<f32>((f32(_e461) * _e134), (f32(_e467) * _e134), (f32(_e473) * _e134), 0f), vec4<f32>((f32(_e478) * _e134), (f32(_e482) * _e134), (f32(_e486) * _e134), 0f)), select(0u, 2147483648u, (_e84 == 0u)));
                    phi_843_ = ((3u * _e84) + 1u);
                    phi_845_ = (_e454 <= _e452);
                    phi_847_ = 0u;
                    loop {
                        let _e496 = phi_3452_;
                        let _e498 = phi_838_;
                        let _e500 = phi_841_;
                        let _e502 = phi_843_;
                        let _e504 = phi_845_;
                        let _e506 = phi_847_;
                        local_10 = _e498;
                        if _e504 {
                            phi_858_ = true;
                        } else {
                            phi_858_ = (_e506 > 0u);
                        }
                        let _e509 = phi_858_;
                        if _e509 {
                            let _e510 = (_e502 > 0u);
                            if _e510 {
                                if _e504 {
                                    phi_944_ = _e500;
                                    phi_945_ = _e504;
                                    phi_946_ = _e506;
                                } else {
                                    let _e511 = (_e506 - 1u);
                                    let _e512 = (_e511 % 128u);
                                    let _e513 = (_e512 < 128u);
                                    if _e513 {
                                    } else {
                                        phi_3588_ = true;
                                        break;
                                    }
                                    let _e515 = local_7[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3588_ = true;
                                        break;
                                    }
                                    let _e517 = local_6[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3588_ = true;
                                        break;
                                    }
                                    let _e519 = local_5[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3588_ = true;
                                        break;
                                    }
                                    let _e521 = local_4[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3588_ = true;
                                        break;
                                    }
                                    let _e523 = local_3[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3588_ = true;
                                        break;
                                    }
                                    let _e525 = local_2[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3588_ = true;
                                        break;
                                    }
                                    let _e530 = local_8[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3588_ = true;
                                        break;
                                    }
                                    let _e533 = local_9[_e512];
                                    phi_944_ = type_50(type_29(vec4<f32>(_e515, _e517, _e519, 0f), vec4<f32>(_e521, _e523, _e525, 0f)), _e530);
                                    phi_945_ = (_e533 <= _e498.member_1);
                                    phi_946_ = _e511;
                                }
                                let _e537 = phi_944_;
                                let _e539 = phi_945_;
                                let _e541 = phi_946_;
                                if _e539 {
                                    if ((_e537.member_1 & 2147483648u) != 0u) {
                                        phi_964_ = _e498;
                                        phi_967_ = type_4(0u, ((_e537.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1003 = phi_964_;
                                            let _e1005 = phi_967_;
                                            local_11 = _e1003;
                                            if (_e1005.member < _e1005.member_1) {
                                                phi_968_ = type_4((_e1005.member + 1u), _e1005.member_1);
                                                phi_990_ = type_4(1u, _e1005.member);
                                            } else {
                                                phi_968_ = _e1005;
                                                phi_990_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1018 = phi_968_;
                                            let _e1020 = phi_990_;
                                            let _e1024 = (bitcast<i32>(_e1020.member) != 0i);
                                            if _e1024 {
                                                let _e1025 = ((_e537.member_1 & 268435455u) + _e1020.member_1);
                                                let _e1026 = (_e1025 < _e86);
                                                if _e1026 {
                                                    if _e1026 {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    let _e1030 = global_2.member[_e1025].member_1;
                                                    phi_1011_ = _e1030;
                                                } else {
                                                    phi_1011_ = 4294967295u;
                                                }
                                                let _e1032 = phi_1011_;
                                                if (_e1025 >= _e86) {
                                                    phi_1100_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1026 {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    if (_e458 < 9u) {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    let _e1039 = global_2.member[_e1025].member[_e458];
                                                    if (_e464 < 9u) {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    let _e1045 = global_2.member[_e1025].member[_e464];
                                                    if (_e470 < 9u) {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    let _e1051 = global_2.member[_e1025].member[_e470];
                                                    let _e1053 = (3u + _e458);
                                                    if (_e1053 < 9u) {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    let _e1059 = global_2.member[_e1025].member[_e1053];
                                                    let _e1060 = (3u + _e464);
                                                    if (_e1060 < 9u) {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    let _e1066 = global_2.member[_e1025].member[_e1060];
                                                    let _e1067 = (3u + _e470);
                                                    if (_e1067 < 9u) {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    let _e1073 = global_2.member[_e1025].member[_e1067];
                                                    let _e1075 = (6u + _e458);
                                                    if (_e1075 < 9u) {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    let _e1081 = global_2.member[_e1025].member[_e1075];
                                                    let _e1082 = (6u + _e464);
                                                    if (_e1082 < 9u) {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    let _e1088 = global_2.member[_e1025].member[_e1082];
                                                    let _e1089 = (6u + _e470);
                                                    if (_e1089 < 9u) {
                                                    } else {
                                                        phi_3446_ = true;
                                                        break;
                                                    }
                                                    let _e1095 = global_2.member[_e1025].member[_e1089];
                                                    phi_1100_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1039, _e1045, _e1051), array<f32, 3>(_e1059, _e1066, _e1073), array<f32, 3>(_e1081, _e1088, _e1095));
                                                }
                                                let _e1099 = phi_1100_;
                                                let _e1107 = (_e1099[0][2] - _e380);
                                                let _e1110 = (((_e1099[0][0] - _e303) * _e404) - (_e1107 * _e328));
                                                let _e1113 = (((_e1099[0][1] - _e342) * _e404) - (_e1107 * _e366));
                                                let _e1120 = (_e1099[1][2] - _e380);
                                                let _e1123 = (((_e1099[1][0] - _e303) * _e404) - (_e1120 * _e328));
                                                let _e1126 = (((_e1099[1][1] - _e342) * _e404) - (_e1120 * _e366));
                                                let _e1133 = (_e1099[2][2] - _e380);
                                                let _e1136 = (((_e1099[2][0] - _e303) * _e404) - (_e1133 * _e328));
                                                let _e1139 = (((_e1099[2][1] - _e342) * _e404) - (_e1133 * _e366));
                                                let _e1140 = (_e1136 * _e1126);
                                                let _e1141 = (_e1139 * _e1123);
                                                let _e1142 = (_e1110 * _e1139);
                                                let _e1143 = (_e1113 * _e1136);
                                                let _e1144 = (_e1123 * _e1113);
                                                let _e1145 = (_e1126 * _e1110);
                                                let _e1150 = (((_e1140 >= _e1141) && (_e1142 >= _e1143)) && (_e1144 >= _e1145));
                                                if (_e1150 || (((_e1140 <= _e1141) && (_e1142 <= _e1143)) && (_e1144 <= _e1145))) {
                                                    let _e1157 = select(-1f, 1f, _e1150);
                                                    let _e1159 = ((_e1140 - _e1141) * _e1157);
                                                    let _e1161 = select(0f, _e1159, (_e1159 > 0f));
                                                    let _e1163 = ((_e1142 - _e1143) * _e1157);
                                                    let _e1165 = select(0f, _e1163, (_e1163 > 0f));
                                                    let _e1167 = ((_e1144 - _e1145) * _e1157);
                                                    let _e1169 = select(0f, _e1167, (_e1167 > 0f));
                                                    let _e1171 = ((_e1161 + _e1165) + _e1169);
                                                    if (_e1171 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1928_ = type_21();
                                                        phi_1929_ = true;
                                                        phi_1930_ = false;
                                                    } else {
                                                        let _e1174 = select(_e1123, _e1110, (_e1110 < _e1123));
                                                        if (select(_e1136, _e1174, (_e1174 < _e1136)) > 0f) {
                                                            phi_1217_ = true;
                                                        } else {
                                                            let _e1179 = select(_e1123, _e1110, (_e1110 > _e1123));
                                                            phi_1217_ = (select(_e1136, _e1179, (_e1179 > _e1136)) < 0f);
                                                        }
                                                        let _e1184 = phi_1217_;
                                                        if _e1184 {
                                                            phi_1925_ = type_21();
                                                            phi_1926_ = true;
                                                            phi_1927_ = false;
                                                        } else {
                                                            let _e1186 = select(_e1126, _e1113, (_e1113 < _e1126));
                                                            if (select(_e1139, _e1186, (_e1186 < _e1139)) > 0f) {
                                                                phi_1246_ = true;
                                                            } else {
                                                                let _e1191 = select(_e1126, _e1113, (_e1113 > _e1126));
                                                                phi_1246_ = (select(_e1139, _e1191, (_e1191 > _e1139)) < 0f);
                                                            }
                                                            let _e1196 = phi_1246_;
                                                            if _e1196 {
                                                                phi_1923_ = type_21();
                                                                phi_1924_ = false;
                                                            } else {
                                                                let _e1198 = select(_e1099[1][0], _e1099[0][0], (_e1099[0][0] < _e1099[1][0]));
                                                                let _e1202 = select(_e1099[1][0], _e1099[0][0], (_e1099[0][0] > _e1099[1][0]));
                                                                let _e1206 = select(_e1099[1][1], _e1099[0][1], (_e1099[0][1] < _e1099[1][1]));
                                                                let _e1210 = select(_e1099[1][1], _e1099[0][1], (_e1099[0][1] > _e1099[1][1]));
                                                                let _e1214 = select(_e1099[1][2], _e1099[0][2], (_e1099[0][2] < _e1099[1][2]));
                                                                let _e1218 = select(_e1099[1][2], _e1099[0][2], (_e1099[0][2] > _e1099[1][2]));
                                                                let _e1223 = ((select(_e1099[2][0], _e1198, (_e1198 < _e1099[2][0])) - _e326) * _e331);
                                                                let _e1224 = ((select(_e1099[2][0], _e1202, (_e1202 > _e1099[2][0])) - _e327) * _e331);
                                                                let _e1227 = ((select(_e1099[2][1], _e1206, (_e1206 < _e1099[2][1])) - _e364) * _e369);
                                                                let _e1228 = ((select(_e1099[2][1], _e1210, (_e1210 > _e1099[2][1])) - _e365) * _e369);
                                                                let _e1231 = ((select(_e1099[2][2], _e1214, (_e1214 < _e1099[2][2])) - _e402) * _e407);
                                                                let _e1232 = ((select(_e1099[2][2], _e1218, (_e1218 > _e1099[2][2])) - _e403) * _e407);
                                                                let _e1234 = select(_e1232, _e1231, (_e1231 < _e1232));
                                                                let _e1236 = select(_e1232, _e1231, (_e1231 > _e1232));
                                                                let _e1238 = select(_e1224, _e1223, (_e1223 < _e1224));
                                                                let _e1240 = select(_e1228, _e1227, (_e1227 < _e1228));
                                                                let _e1242 = select(_e1240, _e1238, (_e1238 > _e1240));
                                                                let _e1244 = select(_e1234, _e1242, (_e1242 > _e1234));
                                                                let _e1246 = select(_e1224, _e1223, (_e1223 > _e1224));
                                                                let _e1248 = select(_e1228, _e1227, (_e1227 > _e1228));
                                                                let _e1250 = select(_e1248, _e1246, (_e1246 < _e1248));
                                                                let _e1252 = select(_e1236, _e1250, (_e1250 < _e1236));
                                                                let _e1253 = -(_e1234);
                                                                let _e1259 = select(_e454, _e1244, (_e1244 > _e454));
                                                                if (_e1259 > (_e1252 + (select(_e1253, _e1236, (_e1236 > _e1253)) * 0.0000019073523f))) {
                                                                    phi_1918_ = type_21();
                                                                    phi_1919_ = true;
                                                                } else {
                                                                    let _e1261 = (_e1259 > _e1003.member_1);
                                                                    if _e1261 {
                                                                        phi_1917_ = type_21();
                                                                    } else {
                                                                        let _e1262 = vec3<f32>(_e1099[0][0], _e1099[0][1], _e1099[0][2]);
                                                                        let _e1263 = vec3<f32>(_e1099[1][0], _e1099[1][1], _e1099[1][2]);
                                                                        let _e1264 = vec3<f32>(_e1099[2][0], _e1099[2][1], _e1099[2][2]);
                                                                        let _e1265 = (_e1099[1][0] - _e1099[0][0]);
                                                                        let _e1266 = (_e1099[1][1] - _e1099[0][1]);
                                                                        let _e1267 = (_e1099[1][2] - _e1099[0][2]);
                                                                        let _e1268 = vec3<f32>(_e1265, _e1266, _e1267);
                                                                        let _e1269 = (_e1099[2][0] - _e1099[1][0]);
                                                                        let _e1270 = (_e1099[2][1] - _e1099[1][1]);
                                                                        let _e1271 = (_e1099[2][2] - _e1099[1][2]);
                                                                        let _e1272 = vec3<f32>(_e1269, _e1270, _e1271);
                                                                        let _e1273 = (_e1099[0][0] - _e1099[2][0]);
                                                                        let _e1274 = (_e1099[0][1] - _e1099[2][1]);
                                                                        let _e1275 = (_e1099[0][2] - _e1099[2][2]);
                                                                        let _e1276 = vec3<f32>(_e1273, _e1274, _e1275);
                                                                        let _e1279 = bitcast<f32>((bitcast<u32>(_e1265) & 2147483647u));
                                                                        let _e1282 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
                                                                        let _e1284 = select(_e1282, _e1279, (_e1279 > _e1282));
                                                                        let _e1287 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
                                                                        let _e1289 = select(_e1287, _e1284, (_e1284 > _e1287));
                                                                        let _e1292 = bitcast<f32>((bitcast<u32>(_e1269) & 2147483647u));
                                                                        let _e1295 = bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u));
                                                                        let _e1297 = select(_e1295, _e1292, (_e1292 > _e1295));
                                                                        let _e1300 = bitcast<f32>((bitcast<u32>(_e1271) & 2147483647u));
                                                                        let _e1302 = select(_e1300, _e1297, (_e1297 > _e1300));
                                                                        let _e1305 = bitcast<f32>((bitcast<u32>(_e1273) & 2147483647u));
                                                                        let _e1308 = bitcast<f32>((bitcast<u32>(_e1274) & 2147483647u));
                                                                        let _e1310 = select(_e1308, _e1305, (_e1305 > _e1308));
                                                                        let _e1313 = bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u));
                                                                        let _e1315 = select(_e1313, _e1310, (_e1310 > _e1313));
                                                                        let _e1317 = select(_e1302, _e1289, (_e1289 > _e1302));
                                                                        let _e1319 = select(_e1315, _e1317, (_e1317 > _e1315));
                                                                        if (_e1289 == _e1319) {
                                                                            phi_1647_ = _e1126;
                                                                            phi_1648_ = _e1123;
                                                                            phi_1649_ = _e1113;
                                                                            phi_1650_ = _e1110;
                                                                            phi_1651_ = _e1262;
                                                                            phi_1652_ = _e1276;
                                                                            phi_1653_ = _e1272;
                                                                            phi_1654_ = _e1268;
                                                                        } else {
                                                                            let _e1321 = (_e1302 == _e1319);
                                                                            let _e1326 = vec3(_e1321);
                                                                            phi_1647_ = select(_e1113, _e1139, _e1321);
                                                                            phi_1648_ = select(_e1110, _e1136, _e1321);
                                                                            phi_1649_ = select(_e1139, _e1126, _e1321);
                                                                            phi_1650_ = select(_e1136, _e1123, _e1321);
                                                                            phi_1651_ = select(_e1264, _e1263, _e1326);
                                                                            phi_1652_ = select(_e1272, _e1268, _e1326);
                                                                            phi_1653_ = select(_e1268, _e1276, _e1326);
                                                                            phi_1654_ = select(_e1276, _e1272, _e1326);
                                                                        }
                                                                        let _e1332 = phi_1647_;
                                                                        let _e1334 = phi_1648_;
                                                                        let _e1336 = phi_1649_;
                                                                        let _e1338 = phi_1650_;
                                                                        let _e1340 = phi_1651_;
                                                                        let _e1342 = phi_1652_;
                                                                        let _e1344 = phi_1653_;
                                                                        let _e1346 = phi_1654_;
                                                                        let _e1353 = ((_e1344.y * _e1342.z) - (_e1342.y * _e1344.z));
                                                                        let _e1358 = ((_e1344.z * _e1342.x) - (_e1342.z * _e1344.x));
                                                                        let _e1361 = ((_e1344.x * _e1342.y) - (_e1342.x * _e1344.y));
                                                                        if (_e1161 >= _e1165) {
                                                                            phi_1685_ = select(true, false, (_e1161 >= _e1169));
                                                                        } else {
                                                                            phi_1685_ = true;
                                                                        }
                                                                        let _e1366 = phi_1685_;
                                                                        if _e1366 {
                                                                            phi_1694_ = select(_e1264, _e1263, vec3((_e1165 >= _e1169)));
                                                                        } else {
                                                                            phi_1694_ = _e1262;
                                                                        }
                                                                        let _e1371 = phi_1694_;
                                                                        let _e1376 = (((_e1353 * _e328) + (_e1358 * _e366)) + (_e1361 * _e404));
                                                                        let _e1387 = (((_e1353 * (_e1371.x - _e303)) + (_e1358 * (_e1371.y - _e342))) + (_e1361 * (_e1371.z - _e380)));
                                                                        let _e1389 = (_e1334 - _e1338);
                                                                        let _e1390 = (_e1332 - _e1336);
                                                                        let _e1398 = (-(((_e1338 * _e1389) + (_e1336 * _e1390))) / ((_e1389 * _e1389) + (_e1390 * _e1390)));
                                                                        let _e1400 = select(1f, _e1398, (_e1398 < 1f));
                                                                        let _e1402 = select(0f, _e1400, (_e1400 > 0f));
                                                                        let _e1415 = ((_e1340.x + (_e1346.x * _e1402)) - _e303);
                                                                        let _e1416 = ((_e1340.y + (_e1346.y * _e1402)) - _e342);
                                                                        let _e1417 = ((_e1340.z + (_e1346.z * _e1402)) - _e380);
                                                                        let _e1418 = (_e1417 / _e404);
                                                                        let _e1430 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                                        let _e1433 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                                        let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                        let _e1440 = select(_e1438, _e1435, (_e1435 > _e1438));
                                                                        let _e1446 = bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u));
                                                                        let _e1449 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                        let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1353 * _e1415) + (_e1358 * _e1416)) + (_e1361 * _e1417)) - _e1387)) & 2147483647u)) <= ((0.0000009536743f * select(_e1319, _e1440, (_e1440 > _e1319))) * select(_e1454, _e1451, (_e1451 > _e1454)))) {
                                                                            let _e1464 = bitcast<f32>((bitcast<u32>(_e1344.x) & 2147483647u));
                                                                            let _e1467 = bitcast<f32>((bitcast<u32>(_e1344.y) & 2147483647u));
                                                                            let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                                                            let _e1472 = bitcast<f32>((bitcast<u32>(_e1344.z) & 2147483647u));
                                                                            let _e1478 = bitcast<f32>((bitcast<u32>(_e1342.x) & 2147483647u));
                                                                            let _e1481 = bitcast<f32>((bitcast<u32>(_e1342.y) & 2147483647u));
                                                                            let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                                            let _e1486 = bitcast<f32>((bitcast<u32>(_e1342.z) & 2147483647u));
                                                                            phi_1861_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1376) & 2147483647u)) > ((0.0000038146973f * select(_e1472, _e1469, (_e1469 > _e1472))) * select(_e1486, _e1483, (_e1483 > _e1486)))));
                                                                        } else {
                                                                            phi_1861_ = true;
                                                                        }
                                                                        let _e1493 = phi_1861_;
                                                                        if _e1493 {
                                                                            let _e1504 = ((((_e1353 * (_e1415 - (_e328 * _e1418))) + (_e1358 * (_e1416 - (_e366 * _e1418)))) + (_e1361 * (_e1417 - _e1417))) / _e1376);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1504) & 2147483647u)) <= _e1319) {
                                                                                phi_1885_ = (_e1418 + _e1504);
                                                                            } else {
                                                                                phi_1885_ = _e1418;
                                                                            }
                                                                            let _e1511 = phi_1885_;
                                                                            phi_1886_ = _e1511;
                                                                        } else {
                                                                            phi_1886_ = (_e1387 / _e1376);
                                                                        }
                                                                        let _e1513 = phi_1886_;
                                                                        let _e1515 = select(_e1252, _e1513, (_e1513 < _e1252));
                                                                        let _e1517 = select(_e1244, _e1515, (_e1515 > _e1244));
                                                                        if (_e1517 >= _e454) {
                                                                            let _e1519 = (_e1517 <= _e1003.member_1);
                                                                            if _e1519 {
                                                                                let _e1520 = (1f / _e1171);
                                                                                phi_1909_ = type_21(_e1517, (_e1165 * _e1520), (_e1169 * _e1520), _e1032);
                                                                            } else {
                                                                                phi_1909_ = type_21();
                                                                            }
                                                                            let _e1525 = phi_1909_;
                                                                            phi_1911_ = _e1525;
                                                                            phi_1912_ = select(true, false, _e1519);
                                                                        } else {
                                                                            phi_1911_ = type_21();
                                                                            phi_1912_ = true;
                                                                        }
                                                                        let _e1528 = phi_1911_;
                                                                        let _e1530 = phi_1912_;
                                                                        if _e1530 {
                                                                            phi_1916_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1916_ = _e1528;
                                                                        }
                                                                        let _e1532 = phi_1916_;
                                                                        phi_1917_ = _e1532;
                                                                    }
                                                                    let _e1534 = phi_1917_;
                                                                    phi_1918_ = _e1534;
                                                                    phi_1919_ = _e1261;
                                                                }
                                                                let _e1536 = phi_1918_;
                                                                let _e1538 = phi_1919_;
                                                                phi_1923_ = _e1536;
                                                                phi_1924_ = _e1538;
                                                            }
                                                            let _e1540 = phi_1923_;
                                                            let _e1542 = phi_1924_;
                                                            phi_1925_ = _e1540;
                                                            phi_1926_ = _e1196;
                                                            phi_1927_ = _e1542;
                                                        }
                                                        let _e1544 = phi_1925_;
                                                        let _e1546 = phi_1926_;
                                                        let _e1548 = phi_1927_;
                                                        phi_1928_ = _e1544;
                                                        phi_1929_ = _e1546;
                                                        phi_1930_ = _e1548;
                                                    }
                                                    let _e1550 = phi_1928_;
                                                    let _e1552 = phi_1929_;
                                                    let _e1554 = phi_1930_;
                                                    phi_1938_ = _e1550;
                                                    phi_1939_ = select(_e1554, true, _e1552);
                                                } else {
                                                    phi_1938_ = type_21();
                                                    phi_1939_ = true;
                                                }
                                                let _e1557 = phi_1938_;
                                                let _e1559 = phi_1939_;
                                                if _e1559 {
                                                    phi_1943_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1943_ = _e1557;
                                                }
                                                let _e1561 = phi_1943_;
                                                if (_e1561.member_3 != 4294967295u) {
                                                    if (_e1032 != 4294967295u) {
                                                        if (_e1561.member < _e1003.member.member) {
                                                            phi_1969_ = true;
                                                        } else {
                                                            if (_e1561.member == _e1003.member.member) {
                                                                phi_1968_ = (_e1561.member_3 < _e1003.member.member_3);
                                                            } else {
                                                                phi_1968_ = false;
                                                            }
                                                            let _e1574 = phi_1968_;
                                                            phi_1969_ = _e1574;
                                                        }
                                                        let _e1576 = phi_1969_;
                                                        if _e1576 {
                                                            phi_1975_ = type_33(_e1561, _e1561.member);
                                                        } else {
                                                            phi_1975_ = _e1003;
                                                        }
                                                        let _e1579 = phi_1975_;
                                                        phi_1976_ = _e1579;
                                                    } else {
                                                        phi_1976_ = _e1003;
                                                    }
                                                    let _e1581 = phi_1976_;
                                                    phi_1977_ = _e1581;
                                                } else {
                                                    phi_1977_ = _e1003;
                                                }
                                                let _e1583 = phi_1977_;
                                                phi_965_ = _e1583;
                                            } else {
                                                phi_965_ = type_33();
                                            }
                                            let _e1585 = phi_965_;
                                            continue;
                                            continuing {
                                                phi_964_ = _e1585;
                                                phi_967_ = _e1018;
                                                phi_3446_ = _e496;
                                                break if !(_e1024);
                                            }
                                        }
                                        let _e1588 = phi_3446_;
                                        phi_3588_ = _e1588;
                                        if _e1588 {
                                            break;
                                        }
                                        phi_3592_ = _e1588;
                                        let _e1780 = local_11;
                                        phi_3182_ = _e1780;
                                        phi_3183_ = _e537;
                                        phi_3184_ = false;
                                        phi_3185_ = _e541;
                                    } else {
                                        if (_e537.member_1 >= _e84) {
                                            phi_2738_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e537.member_1 < _e84) {
                                            } else {
                                                phi_3588_ = true;
                                                break;
                                            }
                                            let _e552 = (_e254 * 2u);
                                            let _e554 = ((1u + _e552) % 7u);
                                            if (_e554 < 7u) {
                                            } else {
                                                phi_3588_ = true;
                                                break;
                                            }
                                            let _e559 = global_5.member[_e537.member_1][_e554];
                                            let _e561 = ((_e552 + 2u) % 7u);
                                            if (_e561 < 7u) {
                                            } else {
                                                phi_3588_ = true;
                                                break;
                                            }
                                            let _e566 = global_5.member[_e537.member_1][_e561];
                                            let _e567 = (_e253 * 2u);
                                            let _e569 = ((1u + _e567) % 7u);
                                            if (_e569 < 7u) {
                                            } else {
                                                phi_3588_ = true;
                                                break;
                                            }
                                            let _e574 = global_5.member[_e537.member_1][_e569];
                                            let _e576 = ((_e567 + 2u) % 7u);
                                            if (_e576 < 7u) {
                                            } else {
                                                phi_3588_ = true;
                                                break;
                                            }
                                            let _e581 = global_5.member[_e537.member_1][_e576];
                                            let _e582 = (_e255 * 2u);
                                            let _e584 = ((1u + _e582) % 7u);
                                            if (_e584 < 7u) {
                                            } else {
                                                phi_3588_ = true;
                                                break;
                                            }
                                            let _e589 = global_5.member[_e537.member_1][_e584];
                                            let _e591 = ((_e582 + 2u) % 7u);
                                            if (_e591 < 7u) {
                                            } else {
                                                phi_3588_ = true;
                                                break;
                                            }
                                            let _e596 = global_5.member[_e537.member_1][_e591];
                                            let _e619 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.x - _e537.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.y - _e537.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.z - _e537.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e623 = select(_e134, _e619, (_e619 > _e134));
                                            let _e625 = select(_e134, _e620, (_e620 > _e134));
                                            let _e627 = select(_e134, _e621, (_e621 > _e134));
                                            let _e652 = bitcast<u32>((f32(bitcast<i32>((_e559 & 2097151u))) * _e623));
                                            let _e657 = (bitcast<i32>((_e559 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e660 = bitcast<f32>((_e652 & bitcast<u32>(_e657)));
                                            let _e661 = bitcast<u32>((f32(bitcast<i32>((_e574 & 2097151u))) * _e625));
                                            let _e666 = (bitcast<i32>((_e574 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e669 = bitcast<f32>((_e661 & bitcast<u32>(_e666)));
                                            let _e670 = bitcast<u32>((f32(bitcast<i32>((_e589 & 2097151u))) * _e627));
                                            let _e675 = (bitcast<i32>((_e589 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e678 = bitcast<f32>((_e670 & bitcast<u32>(_e675)));
                                            let _e682 = bitcast<f32>((_e652 & bitcast<u32>(~(_e657))));
                                            let _e686 = bitcast<f32>((_e661 & bitcast<u32>(~(_e666))));
                                            let _e690 = bitcast<f32>((_e670 & bitcast<u32>(~(_e675))));
                                            let _e691 = bitcast<u32>((f32(bitcast<i32>((_e566 & 2097151u))) * _e623));
                                            let _e696 = (bitcast<i32>((_e566 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e699 = bitcast<f32>((_e691 & bitcast<u32>(_e696)));
                                            let _e700 = bitcast<u32>((f32(bitcast<i32>((_e581 & 2097151u))) * _e625));
                                            let _e705 = (bitcast<i32>((_e581 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e708 = bitcast<f32>((_e700 & bitcast<u32>(_e705)));
                                            let _e709 = bitcast<u32>((f32(bitcast<i32>((_e596 & 2097151u))) * _e627));
                                            let _e714 = (bitcast<i32>((_e596 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e717 = bitcast<f32>((_e709 & bitcast<u32>(_e714)));
                                            let _e721 = bitcast<f32>((_e691 & bitcast<u32>(~(_e696))));
                                            let _e725 = bitcast<f32>((_e700 & bitcast<u32>(~(_e705))));
                                            let _e729 = bitcast<f32>((_e709 & bitcast<u32>(~(_e714))));
                                            let _e759 = global_5.member[_e537.member_1][0u];
                                            let _e763 = global_5.member[_e537.member_1][2u];
                                            let _e767 = global_5.member[_e537.member_1][4u];
                                            let _e771 = global_5.member[_e537.member_1][6u];
                                            let _e783 = (((_e763 >> bitcast<u32>(22i)) | ((_e767 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e771 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e784 = (_e759 & 268435455u);
                                            let _e785 = (_e783 & 268435455u);
                                            let _e788 = ((_e759 >> bitcast<u32>(28u)) & 7u);
                                            let _e796 = ((_e759 >> bitcast<u32>(31i)) | (((_e783 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e797 = (_e788 != 0u);
                                            if (_e788 == 0u) {
                                                phi_2700_ = _e784;
                                            } else {
                                                if (_e788 == 7u) {
                                                    phi_2699_ = 2147483648u;
                                                } else {
                                                    phi_2699_ = ((2147483648u | (_e788 << bitcast<u32>(28u))) | (_e785 & 268435455u));
                                                }
                                                let _e806 = phi_2699_;
                                                phi_2700_ = _e806;
                                            }
                                            let _e808 = phi_2700_;
                                            if _e797 {
                                                let _e809 = (_e788 != 7u);
                                                if _e809 {
                                                    phi_2710_ = (_e785 + _e788);
                                                } else {
                                                    phi_2710_ = u32();
                                                }
                                                let _e812 = phi_2710_;
                                                phi_2712_ = _e812;
                                                phi_2713_ = select(true, false, _e809);
                                            } else {
                                                phi_2712_ = u32();
                                                phi_2713_ = true;
                                            }
                                            let _e815 = phi_2712_;
                                            let _e817 = phi_2713_;
                                            if (_e796 == 0u) {
                                                phi_2734_ = (_e784 + select(0u, 1u, !(_e797)));
                                            } else {
                                                if (_e796 == 7u) {
                                                    phi_2733_ = 2147483648u;
                                                } else {
                                                    phi_2733_ = ((2147483648u | (_e796 << bitcast<u32>(28u))) | (select(_e815, _e785, _e817) & 268435455u));
                                                }
                                                let _e830 = phi_2733_;
                                                phi_2734_ = _e830;
                                            }
                                            let _e832 = phi_2734_;
                                            phi_2738_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e537.member.member.x + _e660), (_e537.member.member.x + _e682), (_e537.member.member_1.x - _e699), (_e537.member.member_1.x - _e721)), vec4<f32>((_e537.member.member.y + _e669), (_e537.member.member.y + _e686), (_e537.member.member_1.y - _e708), (_e537.member.member_1.y - _e725)), vec4<f32>((_e537.member.member.z + _e678), (_e537.member.member.z + _e690), (_e537.member.member_1.z - _e717), (_e537.member.member_1.z - _e729))), type_50(type_29((_e537.member.member + vec4<f32>(_e660, _e669, _e678, 0f)), (_e537.member.member_1 - vec4<f32>(_e699, _e708, _e717, 0f))), _e808), type_50(type_29((_e537.member.member + vec4<f32>(_e682, _e686, _e690, 0f)), (_e537.member.member_1 - vec4<f32>(_e721, _e725, _e729, 0f))), _e832));
                                        }
                                        let _e837 = phi_2738_;
                                        let _e849 = ((_e837.member[0].x - _e326) * _e331);
                                        let _e850 = ((_e837.member[0].y - _e326) * _e331);
                                        let _e851 = ((_e837.member[0].z - _e327) * _e331);
                                        let _e852 = ((_e837.member[0].w - _e327) * _e331);
                                        let _e862 = ((_e837.member[1].x - _e364) * _e369);
                                        let _e863 = ((_e837.member[1].y - _e364) * _e369);
                                        let _e864 = ((_e837.member[1].z - _e365) * _e369);
                                        let _e865 = ((_e837.member[1].w - _e365) * _e369);
                                        let _e875 = ((_e837.member[2].x - _e402) * _e407);
                                        let _e876 = ((_e837.member[2].y - _e402) * _e407);
                                        let _e877 = ((_e837.member[2].z - _e403) * _e407);
                                        let _e878 = ((_e837.member[2].w - _e403) * _e407);
                                        let _e880 = select(_e877, _e875, (_e875 < _e877));
                                        let _e882 = select(_e878, _e876, (_e876 < _e878));
                                        let _e884 = select(_e877, _e875, (_e875 > _e877));
                                        let _e886 = select(_e878, _e876, (_e876 > _e878));
                                        let _e888 = select(_e851, _e849, (_e849 < _e851));
                                        let _e890 = select(_e852, _e850, (_e850 < _e852));
                                        let _e892 = select(_e864, _e862, (_e862 < _e864));
                                        let _e894 = select(_e865, _e863, (_e863 < _e865));
                                        let _e896 = select(_e892, _e888, (_e888 > _e892));
                                        let _e898 = select(_e894, _e890, (_e890 > _e894));
                                        let _e900 = select(_e880, _e896, (_e896 > _e880));
                                        let _e902 = select(_e882, _e898, (_e898 > _e882));
                                        let _e904 = select(_e851, _e849, (_e849 > _e851));
                                        let _e906 = select(_e852, _e850, (_e850 > _e852));
                                        let _e908 = select(_e864, _e862, (_e862 > _e864));
                                        let _e910 = select(_e865, _e863, (_e863 > _e865));
                                        let _e912 = select(_e908, _e904, (_e904 < _e908));
                                        let _e914 = select(_e910, _e906, (_e906 < _e910));
                                        let _e919 = -(_e880);
                                        let _e920 = -(_e882);
                                        let _e927 = (select(_e884, _e912, (_e912 < _e884)) + (select(_e919, _e884, (_e884 > _e919)) * 0.0000019073523f));
                                        let _e928 = (select(_e886, _e914, (_e914 < _e886)) + (select(_e920, _e886, (_e886 > _e920)) * 0.0000019073523f));
                                        let _e930 = select(_e454, _e900, (_e900 > _e454));
                                        let _e932 = select(_e454, _e902, (_e902 > _e454));
                                        let _e937 = (_e930 <= select(_e498.member_1, _e927, (_e927 < _e498.member_1)));
                                        let _e938 = (_e932 <= select(_e498.member_1, _e928, (_e928 < _e498.member_1)));
                                        let _e939 = (_e930 <= _e932);
                                        if _e937 {
                                            if _e938 {
                                                if _e939 {
                                                    phi_3082_ = _e837.member_2;
                                                } else {
                                                    phi_3082_ = _e837.member_1;
                                                }
                                                let _e943 = phi_3082_;
                                                let _e965 = (_e541 % 128u);
                                                let _e966 = (_e965 < 128u);
                                                if _e966 {
                                                } else {
                                                    phi_3588_ = true;
                                                    break;
                                                }
                                                local_8[_e965] = _e943.member_1;
                                                if _e966 {
                                                } else {
                                                    phi_3588_ = true;
                                                    break;
                                                }
                                                local_7[_e965] = _e943.member.member.x;
                                                if _e966 {
                                                } else {
                                                    phi_3588_ = true;
                                                    break;
                                                }
                                                local_6[_e965] = _e943.member.member.y;
                                                if _e966 {
                                                } else {
                                                    phi_3588_ = true;
                                                    break;
                                                }
                                                local_5[_e965] = _e943.member.member.z;
                                                if _e966 {
                                                } else {
                                                    phi_3588_ = true;
                                                    break;
                                                }
                                                local_4[_e965] = _e943.member.member_1.x;
                                                if _e966 {
                                                } else {
                                                    phi_3588_ = true;
                                                    break;
                                                }
                                                local_3[_e965] = _e943.member.member_1.y;
                                                if _e966 {
                                                } else {
                                                    phi_3588_ = true;
                                                    break;
                                                }
                                                local_2[_e965] = _e943.member.member_1.z;
                                                if _e966 {
                                                } else {
                                                    phi_3588_ = true;
                                                    break;
                                                }
                                                local_9[_e965] = select(_e932, _e930, (_e930 > _e932));
                                                if _e939 {
                                                    phi_3159_ = _e837.member_1;
                                                } else {
                                                    phi_3159_ = _e837.member_2;
                                                }
                                                let _e979 = phi_3159_;
                                                phi_3160_ = _e979;
                                                phi_3161_ = (_e541 + 1u);
                                            } else {
                                                phi_3160_ = type_50();
                                                phi_3161_ = u32();
                                            }
                                            let _e981 = phi_3160_;
                                            let _e983 = phi_3161_;
                                            phi_3163_ = _e981;
                                            phi_3164_ = _e983;
                                            phi_3165_ = select(true, false, _e938);
                                        } else {
                                            phi_3163_ = type_50();
                                            phi_3164_ = u32();
                                            phi_3165_ = true;
                                        }
                                        let _e986 = phi_3163_;
                                        let _e988 = phi_3164_;
                                        let _e990 = phi_3165_;
                                        if _e990 {
                                            if _e937 {
                                                phi_3174_ = _e837.member_1;
                                            } else {
                                                phi_3174_ = _e837.member_2;
                                            }
                                            let _e994 = phi_3174_;
                                            phi_3179_ = _e994;
                                            phi_3180_ = select(_e938, true, _e937);
                                        } else {
                                            phi_3179_ = _e986;
                                            phi_3180_ = _e539;
                                        }
                                        let _e997 = phi_3179_;
                                        let _e999 = phi_3180_;
                                        phi_3592_ = _e496;
                                        phi_3182_ = _e498;
                                        phi_3183_ = _e997;
                                        phi_3184_ = _e999;
                                        phi_3185_ = select(_e988, _e541, _e990);
                                    }
                                    let _e1590 = phi_3592_;
                                    let _e1592 = phi_3182_;
                                    let _e1594 = phi_3183_;
                                    let _e1596 = phi_3184_;
                                    let _e1598 = phi_3185_;
                                    phi_3591_ = _e1590;
                                    phi_3186_ = _e1592;
                                    phi_3187_ = _e1594;
                                    phi_3188_ = (_e502 - 1u);
                                    phi_3189_ = _e1596;
                                    phi_3190_ = _e1598;
                                } else {
                                    phi_3591_ = _e496;
                                    phi_3186_ = _e498;
                                    phi_3187_ = _e537;
                                    phi_3188_ = _e502;
                                    phi_3189_ = _e539;
                                    phi_3190_ = _e541;
                                }
                                let _e1600 = phi_3591_;
                                let _e1602 = phi_3186_;
                                let _e1604 = phi_3187_;
                                let _e1606 = phi_3188_;
                                let _e1608 = phi_3189_;
                                let _e1610 = phi_3190_;
                                phi_3590_ = _e1600;
                                phi_3191_ = _e1602;
                                phi_3192_ = _e1604;
                                phi_3193_ = _e1606;
                                phi_3194_ = _e1608;
                                phi_3195_ = _e1610;
                            } else {
                                phi_3590_ = _e496;
                                phi_3191_ = type_33();
                                phi_3192_ = type_50();
                                phi_3193_ = u32();
                                phi_3194_ = bool();
                                phi_3195_ = u32();
                            }
                            let _e1612 = phi_3590_;
                            let _e1614 = phi_3191_;
                            let _e1616 = phi_3192_;
                            let _e1618 = phi_3193_;
                            let _e1620 = phi_3194_;
                            let _e1622 = phi_3195_;
                            phi_3589_ = _e1612;
                            phi_839_ = _e1614;
                            phi_842_ = _e1616;
                            phi_844_ = _e1618;
                            phi_846_ = _e1620;
                            phi_848_ = _e1622;
                            phi_3196_ = _e510;
                        } else {
                            phi_3589_ = _e496;
                            phi_839_ = type_33();
                            phi_842_ = type_50();
                            phi_844_ = u32();
                            phi_846_ = bool();
                            phi_848_ = u32();
                            phi_3196_ = false;
                        }
                        let _e1624 = phi_3589_;
                        let _e1626 = phi_839_;
                        let _e1628 = phi_842_;
                        let _e1630 = phi_844_;
                        let _e1632 = phi_846_;
                        let _e1634 = phi_848_;
                        let _e1636 = phi_3196_;
                        continue;
                        continuing {
                            phi_3452_ = _e1624;
                            phi_838_ = _e1626;
                            phi_841_ = _e1628;
                            phi_843_ = _e1630;
                            phi_845_ = _e1632;
                            phi_847_ = _e1634;
                            phi_3588_ = _e1624;
                            break if !(_e1636);
                        }
                    }
                    let _e1639 = phi_3588_;
                    if _e1639 {
                        break;
                    }
                    let _e1641 = local_10;
                    if (_e1641.member.member_3 != 4294967295u) {
                        let _e1646 = -(_e421);
                        let _e1647 = (_e1646 / 3i);
                        let _e1654 = bitcast<f32>((bitcast<u32>((_e1647 + 127i)) << bitcast<u32>(23i)));
                        let _e1662 = (((_e1641.member.member * _e1654) * _e1654) * bitcast<f32>((bitcast<u32>(((_e1646 - (2i * _e1647)) + 127i)) << bitcast<u32>(23i))));
                        let _e1664 = select(340282350000000000000000000000000000000f, _e1662, (_e1662 < 340282350000000000000000000000000000000f));
                        phi_3248_ = type_21(select(-340282350000000000000000000000000000000f, _e1664, (_e1664 > -340282350000000000000000000000000000000f)), _e1641.member.member_1, _e1641.member.member_2, _e1641.member.member_3);
                    } else {
                        phi_3248_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1671 = phi_3248_;
                    if _e142 {
                    } else {
                        break;
                    }
                    global_6.member[_e140] = _e1671;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
