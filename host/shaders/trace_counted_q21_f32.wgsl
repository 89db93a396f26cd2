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
    var phi_3417_: bool;
    var phi_840_: type_40;
    var phi_843_: type_51;
    var phi_845_: u32;
    var phi_847_: bool;
    var phi_849_: u32;
    var phi_860_: bool;
    var phi_946_: type_51;
    var phi_947_: bool;
    var phi_948_: u32;
    var phi_2708_: u32;
    var phi_2709_: u32;
    var phi_2719_: u32;
    var phi_2721_: u32;
    var phi_2722_: bool;
    var phi_2742_: u32;
    var phi_2743_: u32;
    var phi_2747_: type_52;
    var phi_3091_: type_51;
    var phi_3168_: type_51;
    var phi_3169_: type_51;
    var phi_3170_: u32;
    var phi_3172_: type_51;
    var phi_3173_: u32;
    var phi_3174_: bool;
    var phi_3183_: type_51;
    var phi_3188_: type_51;
    var phi_3189_: bool;
    var phi_966_: type_40;
    var phi_969_: type_4;
    var phi_970_: type_4;
    var phi_992_: type_4;
    var phi_1016_: u32;
    var phi_1105_: array<array<f32, 3>, 3>;
    var phi_1222_: bool;
    var phi_1251_: bool;
    var phi_1652_: f32;
    var phi_1653_: f32;
    var phi_1654_: f32;
    var phi_1655_: f32;
    var phi_1656_: vec3<f32>;
    var phi_1657_: vec3<f32>;
    var phi_1658_: vec3<f32>;
    var phi_1659_: vec3<f32>;
    var phi_1690_: bool;
    var phi_1699_: vec3<f32>;
    var phi_1866_: bool;
    var phi_1890_: f32;
    var phi_1891_: f32;
    var phi_1914_: type_25;
    var phi_1916_: type_25;
    var phi_1917_: bool;
    var phi_1921_: type_25;
    var phi_1922_: type_25;
    var phi_1923_: type_25;
    var phi_1924_: bool;
    var phi_1928_: type_25;
    var phi_1929_: bool;
    var phi_1930_: type_25;
    var phi_1931_: bool;
    var phi_1932_: bool;
    var phi_1933_: type_25;
    var phi_1934_: bool;
    var phi_1935_: bool;
    var phi_1943_: type_25;
    var phi_1944_: bool;
    var phi_1948_: type_25;
    var phi_1973_: bool;
    var phi_1974_: bool;
    var phi_1981_: type_40;
    var phi_1982_: type_40;
    var phi_1983_: type_40;
    var phi_967_: type_40;
    var phi_3411_: bool;
    var phi_3557_: bool;
    var phi_3191_: type_40;
    var phi_3192_: type_51;
    var phi_3193_: bool;
    var phi_3194_: u32;
    var phi_3556_: bool;
    var phi_3195_: type_40;
    var phi_3196_: type_51;
    var phi_3197_: u32;
    var phi_3198_: bool;
    var phi_3199_: u32;
    var phi_3555_: bool;
    var phi_3200_: type_40;
    var phi_3201_: type_51;
    var phi_3202_: u32;
    var phi_3203_: bool;
    var phi_3204_: u32;
    var phi_3554_: bool;
    var phi_841_: type_40;
    var phi_844_: type_51;
    var phi_846_: u32;
    var phi_848_: bool;
    var phi_850_: u32;
    var phi_3205_: bool;
    var phi_3553_: bool;
    var local_10: type_40;
    var local_11: type_40;
    var local_12: type_40;

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
                            phi_381_ = (bitcast<i32>((_e219 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_381_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u))));
                        }
                        let _e233 = phi_381_;
                        phi_382_ = _e233;
                    } else {
                        phi_382_ = 0i;
                    }
                    let _e235 = phi_382_;
                    let _e236 = (_e152 == _e191);
                    if _e236 {
                        phi_392_ = true;
                    } else {
                        phi_392_ = (_e159 == _e191);
                    }
                    let _e239 = phi_392_;
                    let _e240 = select(1u, 0u, _e236);
                    if _e239 {
                        let _e241 = (_e240 + 1u);
                        phi_402_ = _e241;
                        phi_403_ = _e241;
                        phi_405_ = select(true, false, (_e241 == 2u));
                    } else {
                        phi_402_ = u32();
                        phi_403_ = 0u;
                        phi_405_ = true;
                    }
                    let _e245 = phi_402_;
                    let _e247 = phi_403_;
                    let _e249 = phi_405_;
                    if _e249 {
                        phi_410_ = (_e247 + 1u);
                    } else {
                        phi_410_ = 0u;
                    }
                    let _e253 = phi_410_;
                    let _e254 = select(_e245, _e247, _e249);
                    let _e255 = select(_e240, select(2u, _e240, _e239), _e249);
                    if (_e122 < -126i) {
                        phi_422_ = -126i;
                    } else {
                        phi_422_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e260 = phi_422_;
                    let _e265 = bitcast<f32>((bitcast<u32>((_e260 + 127i)) << bitcast<u32>(23i)));
                    let _e271 = bitcast<f32>((bitcast<u32>(((_e122 - _e260) + 127i)) << bitcast<u32>(23i)));
                    let _e272 = -(_e235);
                    if (_e272 < -126i) {
                        phi_442_ = -126i;
                    } else {
                        phi_442_ = select(_e272, 127i, (_e272 > 127i));
                    }
                    let _e277 = phi_442_;
                    let _e282 = bitcast<f32>((bitcast<u32>((_e277 + 127i)) << bitcast<u32>(23i)));
                    let _e288 = bitcast<f32>((bitcast<u32>(((_e272 - _e277) + 127i)) << bitcast<u32>(23i)));
                    let _e292 = global_4.member[_e140].member;
                    let _e293 = (_e254 == 0u);
                    if _e293 {
                        phi_460_ = _e292[0];
                    } else {
                        phi_460_ = _e292[1];
                    }
                    let _e297 = phi_460_;
                    let _e298 = (_e254 == 2u);
                    if _e298 {
                        phi_466_ = _e292[2];
                    } else {
                        phi_466_ = _e297;
                    }
                    let _e301 = phi_466_;
                    let _e303 = ((_e301 * _e265) * _e271);
                    let _e304 = global_4.member[_e140].member_2;
                    if _e293 {
                        phi_477_ = _e304[0];
                    } else {
                        phi_477_ = _e304[1];
                    }
                    let _e308 = phi_477_;
                    if _e298 {
                        phi_483_ = _e304[2];
                    } else {
                        phi_483_ = _e308;
                    }
                    let _e311 = phi_483_;
                    let _e313 = ((_e311 * _e282) * _e288);
                    let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e317 {
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) * 0.00000011920929f);
                        phi_506_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                    } else {
                        phi_506_ = 0f;
                    }
                    let _e325 = phi_506_;
                    let _e326 = (_e303 + _e325);
                    let _e327 = (_e303 - _e325);
                    let _e328 = select(_e313, 0f, _e317);
                    if _e317 {
                        phi_517_ = 38685626000000000000000000f;
                    } else {
                        phi_517_ = (1f / _e313);
                    }
                    let _e331 = phi_517_;
                    let _e332 = (_e253 == 0u);
                    if _e332 {
                        phi_526_ = _e292[0];
                    } else {
                        phi_526_ = _e292[1];
                    }
                    let _e336 = phi_526_;
                    let _e337 = (_e253 == 2u);
                    if _e337 {
                        phi_532_ = _e292[2];
                    } else {
                        phi_532_ = _e336;
                    }
                    let _e340 = phi_532_;
                    let _e342 = ((_e340 * _e265) * _e271);
                    if _e332 {
                        phi_543_ = _e304[0];
                    } else {
                        phi_543_ = _e304[1];
                    }
                    let _e346 = phi_543_;
                    if _e337 {
                        phi_549_ = _e304[2];
                    } else {
                        phi_549_ = _e346;
                    }
                    let _e349 = phi_549_;
                    let _e351 = ((_e349 * _e282) * _e288);
                    let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e355 {
                        let _e359 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) * 0.00000011920929f);
                        phi_572_ = select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f));
                    } else {
                        phi_572_ = 0f;
                    }
                    let _e363 = phi_572_;
                    let _e364 = (_e342 + _e363);
                    let _e365 = (_e342 - _e363);
                    let _e366 = select(_e351, 0f, _e355);
                    if _e355 {
                        phi_583_ = 38685626000000000000000000f;
                    } else {
                        phi_583_ = (1f / _e351);
                    }
                    let _e369 = phi_583_;
                    let _e370 = (_e255 == 0u);
                    if _e370 {
                        phi_592_ = _e292[0];
                    } else {
                        phi_592_ = _e292[1];
                    }
                    let _e374 = phi_592_;
                    let _e375 = (_e255 == 2u);
                    if _e375 {
                        phi_598_ = _e292[2];
                    } else {
                        phi_598_ = _e374;
                    }
                    let _e378 = phi_598_;
                    let _e380 = ((_e378 * _e265) * _e271);
                    if _e370 {
                        phi_609_ = _e304[0];
                    } else {
                        phi_609_ = _e304[1];
                    }
                    let _e384 = phi_609_;
                    if _e375 {
                        phi_615_ = _e304[2];
                    } else {
                        phi_615_ = _e384;
                    }
                    let _e387 = phi_615_;
                    let _e389 = ((_e387 * _e282) * _e288);
                    let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e393 {
                        let _e397 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) * 0.00000011920929f);
                        phi_638_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                    } else {
                        phi_638_ = 0f;
                    }
                    let _e401 = phi_638_;
                    let _e402 = (_e380 + _e401);
                    let _e403 = (_e380 - _e401);
                    let _e404 = select(_e389, 0f, _e393);
                    if _e393 {
                        phi_649_ = 38685626000000000000000000f;
                    } else {
                        phi_649_ = (1f / _e389);
                    }
                    let _e407 = phi_649_;
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
                        phi_749_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                        phi_750_ = select(-340282350000000000000000000000000000000f, _e441, (_e441 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_749_ = 0f;
                        phi_750_ = 1f;
                    }
                    let _e452 = phi_749_;
                    let _e454 = phi_750_;
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
                    phi_3417_ = false;
                    phi_840_ = type_40(type_33(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e452), 0u, 0u);
                    phi_843_ = type_51(type_29(vec4<f32>((f32(_e462) * _e134), (f32(_e468) * _e134), (f32(_e474) * _e134), 0f), vec4<f32>((f32(_e479) * _e134), (f32(_e483) * _e134), (f32(_e487) * _e134), 0f)), select(0u, 2147483648u, (_e84 == 0u)));
                    phi_845_ = ((3u * _e84) + 1u);
                    phi_847_ = (_e454 <= _e452);
                    phi_849_ = 0u;
                    loop {
                        let _e497 = phi_3417_;
                        let _e499 = phi_840_;
                        let _e501 = phi_843_;
                        let _e503 = phi_845_;
                        let _e505 = phi_847_;
                        let _e507 = phi_849_;
                        local_10 = _e499;
                        local_11 = _e499;
                        if _e505 {
                            phi_860_ = true;
                        } else {
                            phi_860_ = (_e507 > 0u);
                        }
                        let _e510 = phi_860_;
                        if _e510 {
                            let _e511 = (_e503 > 0u);
                            if _e511 {
                                if _e505 {
                                    phi_946_ = _e501;
                                    phi_947_ = _e505;
                                    phi_948_ = _e507;
                                } else {
                                    let _e512 = (_e507 - 1u);
                                    let _e513 = (_e512 % 128u);
                                    let _e514 = (_e513 < 128u);
                                    if _e514 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e516 = local_7[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e518 = local_6[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e520 = local_5[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e522 = local_4[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e524 = local_3[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e526 = local_2[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e531 = local_8[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e534 = local_9[_e513];
                                    phi_946_ = type_51(type_29(vec4<f32>(_e516, _e518, _e520, 0f), vec4<f32>(_e522, _e524, _e526, 0f)), _e531);
                                    phi_947_ = (_e534 <= _e499.member.member_1);
                                    phi_948_ = _e512;
                                }
                                let _e539 = phi_946_;
                                let _e541 = phi_947_;
                                let _e543 = phi_948_;
                                if _e541 {
                                    if ((_e539.member_1 & 2147483648u) != 0u) {
                                        phi_966_ = _e499;
                                        phi_969_ = type_4(0u, ((_e539.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1012 = phi_966_;
                                            let _e1014 = phi_969_;
                                            local_12 = _e1012;
                                            if (_e1014.member < _e1014.member_1) {
                                                phi_970_ = type_4((_e1014.member + 1u), _e1014.member_1);
                                                phi_992_ = type_4(1u, _e1014.member);
                                            } else {
                                                phi_970_ = _e1014;
                                                phi_992_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1027 = phi_970_;
                                            let _e1029 = phi_992_;
                                            let _e1033 = (bitcast<i32>(_e1029.member) != 0i);
                                            if _e1033 {
                                                let _e1039 = type_40(_e1012.member, _e1012.member_1, (_e1012.member_2 + 1u));
                                                let _e1040 = ((_e539.member_1 & 268435455u) + _e1029.member_1);
                                                let _e1041 = (_e1040 < _e86);
                                                if _e1041 {
                                                    if _e1041 {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1045 = global_2.member[_e1040].member_1;
                                                    phi_1016_ = _e1045;
                                                } else {
                                                    phi_1016_ = 4294967295u;
                                                }
                                                let _e1047 = phi_1016_;
                                                if (_e1040 >= _e86) {
                                                    phi_1105_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1041 {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    if (_e459 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1054 = global_2.member[_e1040].member[_e459];
                                                    if (_e465 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1060 = global_2.member[_e1040].member[_e465];
                                                    if (_e471 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1066 = global_2.member[_e1040].member[_e471];
                                                    let _e1068 = (3u + _e459);
                                                    if (_e1068 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1074 = global_2.member[_e1040].member[_e1068];
                                                    let _e1075 = (3u + _e465);
                                                    if (_e1075 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1081 = global_2.member[_e1040].member[_e1075];
                                                    let _e1082 = (3u + _e471);
                                                    if (_e1082 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1088 = global_2.member[_e1040].member[_e1082];
                                                    let _e1090 = (6u + _e459);
                                                    if (_e1090 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1096 = global_2.member[_e1040].member[_e1090];
                                                    let _e1097 = (6u + _e465);
                                                    if (_e1097 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1103 = global_2.member[_e1040].member[_e1097];
                                                    let _e1104 = (6u + _e471);
                                                    if (_e1104 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1110 = global_2.member[_e1040].member[_e1104];
                                                    phi_1105_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1054, _e1060, _e1066), array<f32, 3>(_e1074, _e1081, _e1088), array<f32, 3>(_e1096, _e1103, _e1110));
                                                }
                                                let _e1114 = phi_1105_;
                                                let _e1123 = (_e1114[0][2] - _e380);
                                                let _e1126 = (((_e1114[0][0] - _e303) * _e404) - (_e1123 * _e328));
                                                let _e1129 = (((_e1114[0][1] - _e342) * _e404) - (_e1123 * _e366));
                                                let _e1136 = (_e1114[1][2] - _e380);
                                                let _e1139 = (((_e1114[1][0] - _e303) * _e404) - (_e1136 * _e328));
                                                let _e1142 = (((_e1114[1][1] - _e342) * _e404) - (_e1136 * _e366));
                                                let _e1149 = (_e1114[2][2] - _e380);
                                                let _e1152 = (((_e1114[2][0] - _e303) * _e404) - (_e1149 * _e328));
                                                let _e1155 = (((_e1114[2][1] - _e342) * _e404) - (_e1149 * _e366));
                                                let _e1156 = (_e1152 * _e1142);
                                                let _e1157 = (_e1155 * _e1139);
                                                let _e1158 = (_e1126 * _e1155);
                                                let _e1159 = (_e1129 * _e1152);
                                                let _e1160 = (_e1139 * _e1129);
                                                let _e1161 = (_e1142 * _e1126);
                                                let _e1166 = (((_e1156 >= _e1157) && (_e1158 >= _e1159)) && (_e1160 >= _e1161));
                                                if (_e1166 || (((_e1156 <= _e1157) && (_e1158 <= _e1159)) && (_e1160 <= _e1161))) {
                                                    let _e1173 = select(-1f, 1f, _e1166);
                                                    let _e1175 = ((_e1156 - _e1157) * _e1173);
                                                    let _e1177 = select(0f, _e1175, (_e1175 > 0f));
                                                    let _e1179 = ((_e1158 - _e1159) * _e1173);
                                                    let _e1181 = select(0f, _e1179, (_e1179 > 0f));
                                                    let _e1183 = ((_e1160 - _e1161) * _e1173);
                                                    let _e1185 = select(0f, _e1183, (_e1183 > 0f));
                                                    let _e1187 = ((_e1177 + _e1181) + _e1185);
                                                    if (_e1187 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1933_ = type_25();
                                                        phi_1934_ = true;
                                                        phi_1935_ = false;
                                                    } else {
                                                        let _e1190 = select(_e1139, _e1126, (_e1126 < _e1139));
                                                        if (select(_e1152, _e1190, (_e1190 < _e1152)) > 0f) {
                                                            phi_1222_ = true;
                                                        } else {
                                                            let _e1195 = select(_e1139, _e1126, (_e1126 > _e1139));
                                                            phi_1222_ = (select(_e1152, _e1195, (_e1195 > _e1152)) < 0f);
                                                        }
                                                        let _e1200 = phi_1222_;
                                                        if _e1200 {
                                                            phi_1930_ = type_25();
                                                            phi_1931_ = true;
                                                            phi_1932_ = false;
                                                        } else {
                                                            let _e1202 = select(_e1142, _e1129, (_e1129 < _e1142));
                                                            if (select(_e1155, _e1202, (_e1202 < _e1155)) > 0f) {
                                                                phi_1251_ = true;
                                                            } else {
                                                                let _e1207 = select(_e1142, _e1129, (_e1129 > _e1142));
                                                                phi_1251_ = (select(_e1155, _e1207, (_e1207 > _e1155)) < 0f);
                                                            }
                                                            let _e1212 = phi_1251_;
                                                            if _e1212 {
                                                                phi_1928_ = type_25();
                                                                phi_1929_ = false;
                                                            } else {
                                                                let _e1214 = select(_e1114[1][0], _e1114[0][0], (_e1114[0][0] < _e1114[1][0]));
                                                                let _e1218 = select(_e1114[1][0], _e1114[0][0], (_e1114[0][0] > _e1114[1][0]));
                                                                let _e1222 = select(_e1114[1][1], _e1114[0][1], (_e1114[0][1] < _e1114[1][1]));
                                                                let _e1226 = select(_e1114[1][1], _e1114[0][1], (_e1114[0][1] > _e1114[1][1]));
                                                                let _e1230 = select(_e1114[1][2], _e1114[0][2], (_e1114[0][2] < _e1114[1][2]));
                                                                let _e1234 = select(_e1114[1][2], _e1114[0][2], (_e1114[0][2] > _e1114[1][2]));
                                                                let _e1239 = ((select(_e1114[2][0], _e1214, (_e1214 < _e1114[2][0])) - _e326) * _e331);
                                                                let _e1240 = ((select(_e1114[2][0], _e1218, (_e1218 > _e1114[2][0])) - _e327) * _e331);
                                                                let _e1243 = ((select(_e1114[2][1], _e1222, (_e1222 < _e1114[2][1])) - _e364) * _e369);
                                                                let _e1244 = ((select(_e1114[2][1], _e1226, (_e1226 > _e1114[2][1])) - _e365) * _e369);
                                                                let _e1247 = ((select(_e1114[2][2], _e1230, (_e1230 < _e1114[2][2])) - _e402) * _e407);
                                                                let _e1248 = ((select(_e1114[2][2], _e1234, (_e1234 > _e1114[2][2])) - _e403) * _e407);
                                                                let _e1250 = select(_e1248, _e1247, (_e1247 < _e1248));
                                                                let _e1252 = select(_e1248, _e1247, (_e1247 > _e1248));
                                                                let _e1254 = select(_e1240, _e1239, (_e1239 < _e1240));
                                                                let _e1256 = select(_e1244, _e1243, (_e1243 < _e1244));
                                                                let _e1258 = select(_e1256, _e1254, (_e1254 > _e1256));
                                                                let _e1260 = select(_e1250, _e1258, (_e1258 > _e1250));
                                                                let _e1262 = select(_e1240, _e1239, (_e1239 > _e1240));
                                                                let _e1264 = select(_e1244, _e1243, (_e1243 > _e1244));
                                                                let _e1266 = select(_e1264, _e1262, (_e1262 < _e1264));
                                                                let _e1268 = select(_e1252, _e1266, (_e1266 < _e1252));
                                                                let _e1269 = -(_e1250);
                                                                let _e1275 = select(_e454, _e1260, (_e1260 > _e454));
                                                                if (_e1275 > (_e1268 + (select(_e1269, _e1252, (_e1252 > _e1269)) * 0.0000019073523f))) {
                                                                    phi_1923_ = type_25();
                                                                    phi_1924_ = true;
                                                                } else {
                                                                    let _e1277 = (_e1275 > _e1012.member.member_1);
                                                                    if _e1277 {
                                                                        phi_1922_ = type_25();
                                                                    } else {
                                                                        let _e1278 = vec3<f32>(_e1114[0][0], _e1114[0][1], _e1114[0][2]);
                                                                        let _e1279 = vec3<f32>(_e1114[1][0], _e1114[1][1], _e1114[1][2]);
                                                                        let _e1280 = vec3<f32>(_e1114[2][0], _e1114[2][1], _e1114[2][2]);
                                                                        let _e1281 = (_e1114[1][0] - _e1114[0][0]);
                                                                        let _e1282 = (_e1114[1][1] - _e1114[0][1]);
                                                                        let _e1283 = (_e1114[1][2] - _e1114[0][2]);
                                                                        let _e1284 = vec3<f32>(_e1281, _e1282, _e1283);
                                                                        let _e1285 = (_e1114[2][0] - _e1114[1][0]);
                                                                        let _e1286 = (_e1114[2][1] - _e1114[1][1]);
                                                                        let _e1287 = (_e1114[2][2] - _e1114[1][2]);
                                                                        let _e1288 = vec3<f32>(_e1285, _e1286, _e1287);
                                                                        let _e1289 = (_e1114[0][0] - _e1114[2][0]);
                                                                        let _e1290 = (_e1114[0][1] - _e1114[2][1]);
                                                                        let _e1291 = (_e1114[0][2] - _e1114[2][2]);
                                                                        let _e1292 = vec3<f32>(_e1289, _e1290, _e1291);
                                                                        let _e1295 = bitcast<f32>((bitcast<u32>(_e1281) & 2147483647u));
                                                                        let _e1298 = bitcast<f32>((bitcast<u32>(_e1282) & 2147483647u));
                                                                        let _e1300 = select(_e1298, _e1295, (_e1295 > _e1298));
                                                                        let _e1303 = bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u));
                                                                        let _e1305 = select(_e1303, _e1300, (_e1300 > _e1303));
                                                                        let _e1308 = bitcast<f32>((bitcast<u32>(_e1285) & 2147483647u));
                                                                        let _e1311 = bitcast<f32>((bitcast<u32>(_e1286) & 2147483647u));
                                                                        let _e1313 = select(_e1311, _e1308, (_e1308 > _e1311));
                                                                        let _e1316 = bitcast<f32>((bitcast<u32>(_e1287) & 2147483647u));
                                                                        let _e1318 = select(_e1316, _e1313, (_e1313 > _e1316));
                                                                        let _e1321 = bitcast<f32>((bitcast<u32>(_e1289) & 2147483647u));
                                                                        let _e1324 = bitcast<f32>((bitcast<u32>(_e1290) & 2147483647u));
                                                                        let _e1326 = select(_e1324, _e1321, (_e1321 > _e1324));
                                                                        let _e1329 = bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u));
                                                                        let _e1331 = select(_e1329, _e1326, (_e1326 > _e1329));
                                                                        let _e1333 = select(_e1318, _e1305, (_e1305 > _e1318));
                                                                        let _e1335 = select(_e1331, _e1333, (_e1333 > _e1331));
                                                                        if (_e1305 == _e1335) {
                                                                            phi_1652_ = _e1142;
                                                                            phi_1653_ = _e1139;
                                                                            phi_1654_ = _e1129;
                                                                            phi_1655_ = _e1126;
                                                                            phi_1656_ = _e1278;
                                                                            phi_1657_ = _e1292;
                                                                            phi_1658_ = _e1288;
                                                                            phi_1659_ = _e1284;
                                                                        } else {
                                                                            let _e1337 = (_e1318 == _e1335);
                                                                            let _e1342 = vec3(_e1337);
                                                                            phi_1652_ = select(_e1129, _e1155, _e1337);
                                                                            phi_1653_ = select(_e1126, _e1152, _e1337);
                                                                            phi_1654_ = select(_e1155, _e1142, _e1337);
                                                                            phi_1655_ = select(_e1152, _e1139, _e1337);
                                                                            phi_1656_ = select(_e1280, _e1279, _e1342);
                                                                            phi_1657_ = select(_e1288, _e1284, _e1342);
                                                                            phi_1658_ = select(_e1284, _e1292, _e1342);
                                                                            phi_1659_ = select(_e1292, _e1288, _e1342);
                                                                        }
                                                                        let _e1348 = phi_1652_;
                                                                        let _e1350 = phi_1653_;
                                                                        let _e1352 = phi_1654_;
                                                                        let _e1354 = phi_1655_;
                                                                        let _e1356 = phi_1656_;
                                                                        let _e1358 = phi_1657_;
                                                                        let _e1360 = phi_1658_;
                                                                        let _e1362 = phi_1659_;
                                                                        let _e1369 = ((_e1360.y * _e1358.z) - (_e1358.y * _e1360.z));
                                                                        let _e1374 = ((_e1360.z * _e1358.x) - (_e1358.z * _e1360.x));
                                                                        let _e1377 = ((_e1360.x * _e1358.y) - (_e1358.x * _e1360.y));
                                                                        if (_e1177 >= _e1181) {
                                                                            phi_1690_ = select(true, false, (_e1177 >= _e1185));
                                                                        } else {
                                                                            phi_1690_ = true;
                                                                        }
                                                                        let _e1382 = phi_1690_;
                                                                        if _e1382 {
                                                                            phi_1699_ = select(_e1280, _e1279, vec3((_e1181 >= _e1185)));
                                                                        } else {
                                                                            phi_1699_ = _e1278;
                                                                        }
                                                                        let _e1387 = phi_1699_;
                                                                        let _e1392 = (((_e1369 * _e328) + (_e1374 * _e366)) + (_e1377 * _e404));
                                                                        let _e1403 = (((_e1369 * (_e1387.x - _e303)) + (_e1374 * (_e1387.y - _e342))) + (_e1377 * (_e1387.z - _e380)));
                                                                        let _e1405 = (_e1350 - _e1354);
                                                                        let _e1406 = (_e1348 - _e1352);
                                                                        let _e1414 = (-(((_e1354 * _e1405) + (_e1352 * _e1406))) / ((_e1405 * _e1405) + (_e1406 * _e1406)));
                                                                        let _e1416 = select(1f, _e1414, (_e1414 < 1f));
                                                                        let _e1418 = select(0f, _e1416, (_e1416 > 0f));
                                                                        let _e1431 = ((_e1356.x + (_e1362.x * _e1418)) - _e303);
                                                                        let _e1432 = ((_e1356.y + (_e1362.y * _e1418)) - _e342);
                                                                        let _e1433 = ((_e1356.z + (_e1362.z * _e1418)) - _e380);
                                                                        let _e1434 = (_e1433 / _e404);
                                                                        let _e1446 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
                                                                        let _e1449 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                        let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                        let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                                                        let _e1462 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
                                                                        let _e1465 = bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u));
                                                                        let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                        let _e1470 = bitcast<f32>((bitcast<u32>(_e1377) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1369 * _e1431) + (_e1374 * _e1432)) + (_e1377 * _e1433)) - _e1403)) & 2147483647u)) <= ((0.0000009536743f * select(_e1335, _e1456, (_e1456 > _e1335))) * select(_e1470, _e1467, (_e1467 > _e1470)))) {
                                                                            let _e1480 = bitcast<f32>((bitcast<u32>(_e1360.x) & 2147483647u));
                                                                            let _e1483 = bitcast<f32>((bitcast<u32>(_e1360.y) & 2147483647u));
                                                                            let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                                            let _e1488 = bitcast<f32>((bitcast<u32>(_e1360.z) & 2147483647u));
                                                                            let _e1494 = bitcast<f32>((bitcast<u32>(_e1358.x) & 2147483647u));
                                                                            let _e1497 = bitcast<f32>((bitcast<u32>(_e1358.y) & 2147483647u));
                                                                            let _e1499 = select(_e1497, _e1494, (_e1494 > _e1497));
                                                                            let _e1502 = bitcast<f32>((bitcast<u32>(_e1358.z) & 2147483647u));
                                                                            phi_1866_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1392) & 2147483647u)) > ((0.0000038146973f * select(_e1488, _e1485, (_e1485 > _e1488))) * select(_e1502, _e1499, (_e1499 > _e1502)))));
                                                                        } else {
                                                                            phi_1866_ = true;
                                                                        }
                                                                        let _e1509 = phi_1866_;
                                                                        if _e1509 {
                                                                            let _e1520 = ((((_e1369 * (_e1431 - (_e328 * _e1434))) + (_e1374 * (_e1432 - (_e366 * _e1434)))) + (_e1377 * (_e1433 - _e1433))) / _e1392);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1520) & 2147483647u)) <= _e1335) {
                                                                                phi_1890_ = (_e1434 + _e1520);
                                                                            } else {
                                                                                phi_1890_ = _e1434;
                                                                            }
                                                                            let _e1527 = phi_1890_;
                                                                            phi_1891_ = _e1527;
                                                                        } else {
                                                                            phi_1891_ = (_e1403 / _e1392);
                                                                        }
                                                                        let _e1529 = phi_1891_;
                                                                        let _e1531 = select(_e1268, _e1529, (_e1529 < _e1268));
                                                                        let _e1533 = select(_e1260, _e1531, (_e1531 > _e1260));
                                                                        if (_e1533 >= _e454) {
                                                                            let _e1535 = (_e1533 <= _e1012.member.member_1);
                                                                            if _e1535 {
                                                                                let _e1536 = (1f / _e1187);
                                                                                phi_1914_ = type_25(_e1533, (_e1181 * _e1536), (_e1185 * _e1536), _e1047);
                                                                            } else {
                                                                                phi_1914_ = type_25();
                                                                            }
                                                                            let _e1541 = phi_1914_;
                                                                            phi_1916_ = _e1541;
                                                                            phi_1917_ = select(true, false, _e1535);
                                                                        } else {
                                                                            phi_1916_ = type_25();
                                                                            phi_1917_ = true;
                                                                        }
                                                                        let _e1544 = phi_1916_;
                                                                        let _e1546 = phi_1917_;
                                                                        if _e1546 {
                                                                            phi_1921_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1921_ = _e1544;
                                                                        }
                                                                        let _e1548 = phi_1921_;
                                                                        phi_1922_ = _e1548;
                                                                    }
                                                                    let _e1550 = phi_1922_;
                                                                    phi_1923_ = _e1550;
                                                                    phi_1924_ = _e1277;
                                                                }
                                                                let _e1552 = phi_1923_;
                                                                let _e1554 = phi_1924_;
                                                                phi_1928_ = _e1552;
                                                                phi_1929_ = _e1554;
                                                            }
                                                            let _e1556 = phi_1928_;
                                                            let _e1558 = phi_1929_;
                                                            phi_1930_ = _e1556;
                                                            phi_1931_ = _e1212;
                                                            phi_1932_ = _e1558;
                                                        }
                                                        let _e1560 = phi_1930_;
                                                        let _e1562 = phi_1931_;
                                                        let _e1564 = phi_1932_;
                                                        phi_1933_ = _e1560;
                                                        phi_1934_ = _e1562;
                                                        phi_1935_ = _e1564;
                                                    }
                                                    let _e1566 = phi_1933_;
                                                    let _e1568 = phi_1934_;
                                                    let _e1570 = phi_1935_;
                                                    phi_1943_ = _e1566;
                                                    phi_1944_ = select(_e1570, true, _e1568);
                                                } else {
                                                    phi_1943_ = type_25();
                                                    phi_1944_ = true;
                                                }
                                                let _e1573 = phi_1943_;
                                                let _e1575 = phi_1944_;
                                                if _e1575 {
                                                    phi_1948_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1948_ = _e1573;
                                                }
                                                let _e1577 = phi_1948_;
                                                if (_e1577.member_3 != 4294967295u) {
                                                    if (_e1047 != 4294967295u) {
                                                        if (_e1577.member < _e1012.member.member.member) {
                                                            phi_1974_ = true;
                                                        } else {
                                                            if (_e1577.member == _e1012.member.member.member) {
                                                                phi_1973_ = (_e1577.member_3 < _e1012.member.member.member_3);
                                                            } else {
                                                                phi_1973_ = false;
                                                            }
                                                            let _e1592 = phi_1973_;
                                                            phi_1974_ = _e1592;
                                                        }
                                                        let _e1594 = phi_1974_;
                                                        if _e1594 {
                                                            phi_1981_ = type_40(type_33(_e1577, _e1577.member), _e1039.member_1, _e1039.member_2);
                                                        } else {
                                                            phi_1981_ = _e1039;
                                                        }
                                                        let _e1601 = phi_1981_;
                                                        phi_1982_ = _e1601;
                                                    } else {
                                                        phi_1982_ = _e1039;
                                                    }
                                                    let _e1603 = phi_1982_;
                                                    phi_1983_ = _e1603;
                                                } else {
                                                    phi_1983_ = _e1039;
                                                }
                                                let _e1605 = phi_1983_;
                                                phi_967_ = _e1605;
                                            } else {
                                                phi_967_ = type_40();
                                            }
                                            let _e1607 = phi_967_;
                                            continue;
                                            continuing {
                                                phi_966_ = _e1607;
                                                phi_969_ = _e1027;
                                                phi_3411_ = _e497;
                                                break if !(_e1033);
                                            }
                                        }
                                        let _e1610 = phi_3411_;
                                        phi_3553_ = _e1610;
                                        if _e1610 {
                                            break;
                                        }
                                        phi_3557_ = _e1610;
                                        let _e1780 = local_12;
                                        phi_3191_ = _e1780;
                                        phi_3192_ = _e539;
                                        phi_3193_ = false;
                                        phi_3194_ = _e543;
                                    } else {
                                        if (_e539.member_1 >= _e84) {
                                            phi_2747_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e539.member_1 < _e84) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e560 = (_e254 * 2u);
                                            let _e562 = ((1u + _e560) % 7u);
                                            if (_e562 < 7u) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e567 = global_5.member[_e539.member_1][_e562];
                                            let _e569 = ((_e560 + 2u) % 7u);
                                            if (_e569 < 7u) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e574 = global_5.member[_e539.member_1][_e569];
                                            let _e575 = (_e253 * 2u);
                                            let _e577 = ((1u + _e575) % 7u);
                                            if (_e577 < 7u) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e582 = global_5.member[_e539.member_1][_e577];
                                            let _e584 = ((_e575 + 2u) % 7u);
                                            if (_e584 < 7u) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e589 = global_5.member[_e539.member_1][_e584];
                                            let _e590 = (_e255 * 2u);
                                            let _e592 = ((1u + _e590) % 7u);
                                            if (_e592 < 7u) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e597 = global_5.member[_e539.member_1][_e592];
                                            let _e599 = ((_e590 + 2u) % 7u);
                                            if (_e599 < 7u) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e604 = global_5.member[_e539.member_1][_e599];
                                            let _e627 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.x - _e539.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e628 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.y - _e539.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e629 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.z - _e539.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e631 = select(_e134, _e627, (_e627 > _e134));
                                            let _e633 = select(_e134, _e628, (_e628 > _e134));
                                            let _e635 = select(_e134, _e629, (_e629 > _e134));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e567 & 2097151u))) * _e631));
                                            let _e665 = (bitcast<i32>((_e567 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e669 = bitcast<u32>((f32(bitcast<i32>((_e582 & 2097151u))) * _e633));
                                            let _e674 = (bitcast<i32>((_e582 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e677 = bitcast<f32>((_e669 & bitcast<u32>(_e674)));
                                            let _e678 = bitcast<u32>((f32(bitcast<i32>((_e597 & 2097151u))) * _e635));
                                            let _e683 = (bitcast<i32>((_e597 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e686 = bitcast<f32>((_e678 & bitcast<u32>(_e683)));
                                            let _e690 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e694 = bitcast<f32>((_e669 & bitcast<u32>(~(_e674))));
                                            let _e698 = bitcast<f32>((_e678 & bitcast<u32>(~(_e683))));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e574 & 2097151u))) * _e631));
                                            let _e704 = (bitcast<i32>((_e574 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e708 = bitcast<u32>((f32(bitcast<i32>((_e589 & 2097151u))) * _e633));
                                            let _e713 = (bitcast<i32>((_e589 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e716 = bitcast<f32>((_e708 & bitcast<u32>(_e713)));
                                            let _e717 = bitcast<u32>((f32(bitcast<i32>((_e604 & 2097151u))) * _e635));
                                            let _e722 = (bitcast<i32>((_e604 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e725 = bitcast<f32>((_e717 & bitcast<u32>(_e722)));
                                            let _e729 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e733 = bitcast<f32>((_e708 & bitcast<u32>(~(_e713))));
                                            let _e737 = bitcast<f32>((_e717 & bitcast<u32>(~(_e722))));
                                            let _e767 = global_5.member[_e539.member_1][0u];
                                            let _e771 = global_5.member[_e539.member_1][2u];
                                            let _e775 = global_5.member[_e539.member_1][4u];
                                            let _e779 = global_5.member[_e539.member_1][6u];
                                            let _e791 = (((_e771 >> bitcast<u32>(22i)) | ((_e775 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e779 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e792 = (_e767 & 268435455u);
                                            let _e793 = (_e791 & 268435455u);
                                            let _e796 = ((_e767 >> bitcast<u32>(28u)) & 7u);
                                            let _e804 = ((_e767 >> bitcast<u32>(31i)) | (((_e791 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e805 = (_e796 != 0u);
                                            if (_e796 == 0u) {
                                                phi_2709_ = _e792;
                                            } else {
                                                if (_e796 == 7u) {
                                                    phi_2708_ = 2147483648u;
                                                } else {
                                                    phi_2708_ = ((2147483648u | (_e796 << bitcast<u32>(28u))) | (_e793 & 268435455u));
                                                }
                                                let _e814 = phi_2708_;
                                                phi_2709_ = _e814;
                                            }
                                            let _e816 = phi_2709_;
                                            if _e805 {
                                                let _e817 = (_e796 != 7u);
                                                if _e817 {
                                                    phi_2719_ = (_e793 + _e796);
                                                } else {
                                                    phi_2719_ = u32();
                                                }
                                                let _e820 = phi_2719_;
                                                phi_2721_ = _e820;
                                                phi_2722_ = select(true, false, _e817);
                                            } else {
                                                phi_2721_ = u32();
                                                phi_2722_ = true;
                                            }
                                            let _e823 = phi_2721_;
                                            let _e825 = phi_2722_;
                                            if (_e804 == 0u) {
                                                phi_2743_ = (_e792 + select(0u, 1u, !(_e805)));
                                            } else {
                                                if (_e804 == 7u) {
                                                    phi_2742_ = 2147483648u;
                                                } else {
                                                    phi_2742_ = ((2147483648u | (_e804 << bitcast<u32>(28u))) | (select(_e823, _e793, _e825) & 268435455u));
                                                }
                                                let _e838 = phi_2742_;
                                                phi_2743_ = _e838;
                                            }
                                            let _e840 = phi_2743_;
                                            phi_2747_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e539.member.member.x + _e668), (_e539.member.member.x + _e690), (_e539.member.member_1.x - _e707), (_e539.member.member_1.x - _e729)), vec4<f32>((_e539.member.member.y + _e677), (_e539.member.member.y + _e694), (_e539.member.member_1.y - _e716), (_e539.member.member_1.y - _e733)), vec4<f32>((_e539.member.member.z + _e686), (_e539.member.member.z + _e698), (_e539.member.member_1.z - _e725), (_e539.member.member_1.z - _e737))), type_51(type_29((_e539.member.member + vec4<f32>(_e668, _e677, _e686, 0f)), (_e539.member.member_1 - vec4<f32>(_e707, _e716, _e725, 0f))), _e816), type_51(type_29((_e539.member.member + vec4<f32>(_e690, _e694, _e698, 0f)), (_e539.member.member_1 - vec4<f32>(_e729, _e733, _e737, 0f))), _e840));
                                        }
                                        let _e845 = phi_2747_;
                                        let _e858 = ((_e845.member[0].x - _e326) * _e331);
                                        let _e859 = ((_e845.member[0].y - _e326) * _e331);
                                        let _e860 = ((_e845.member[0].z - _e327) * _e331);
                                        let _e861 = ((_e845.member[0].w - _e327) * _e331);
                                        let _e871 = ((_e845.member[1].x - _e364) * _e369);
                                        let _e872 = ((_e845.member[1].y - _e364) * _e369);
                                        let _e873 = ((_e845.member[1].z - _e365) * _e369);
                                        let _e874 = ((_e845.member[1].w - _e365) * _e369);
                                        let _e884 = ((_e845.member[2].x - _e402) * _e407);
                                        let _e885 = ((_e845.member[2].y - _e402) * _e407);
                                        let _e886 = ((_e845.member[2].z - _e403) * _e407);
                                        let _e887 = ((_e845.member[2].w - _e403) * _e407);
                                        let _e889 = select(_e886, _e884, (_e884 < _e886));
                                        let _e891 = select(_e887, _e885, (_e885 < _e887));
                                        let _e893 = select(_e886, _e884, (_e884 > _e886));
                                        let _e895 = select(_e887, _e885, (_e885 > _e887));
                                        let _e897 = select(_e860, _e858, (_e858 < _e860));
                                        let _e899 = select(_e861, _e859, (_e859 < _e861));
                                        let _e901 = select(_e873, _e871, (_e871 < _e873));
                                        let _e903 = select(_e874, _e872, (_e872 < _e874));
                                        let _e905 = select(_e901, _e897, (_e897 > _e901));
                                        let _e907 = select(_e903, _e899, (_e899 > _e903));
                                        let _e909 = select(_e889, _e905, (_e905 > _e889));
                                        let _e911 = select(_e891, _e907, (_e907 > _e891));
                                        let _e913 = select(_e860, _e858, (_e858 > _e860));
                                        let _e915 = select(_e861, _e859, (_e859 > _e861));
                                        let _e917 = select(_e873, _e871, (_e871 > _e873));
                                        let _e919 = select(_e874, _e872, (_e872 > _e874));
                                        let _e921 = select(_e917, _e913, (_e913 < _e917));
                                        let _e923 = select(_e919, _e915, (_e915 < _e919));
                                        let _e928 = -(_e889);
                                        let _e929 = -(_e891);
                                        let _e936 = (select(_e893, _e921, (_e921 < _e893)) + (select(_e928, _e893, (_e893 > _e928)) * 0.0000019073523f));
                                        let _e937 = (select(_e895, _e923, (_e923 < _e895)) + (select(_e929, _e895, (_e895 > _e929)) * 0.0000019073523f));
                                        let _e939 = select(_e454, _e909, (_e909 > _e454));
                                        let _e941 = select(_e454, _e911, (_e911 > _e454));
                                        let _e946 = (_e939 <= select(_e499.member.member_1, _e936, (_e936 < _e499.member.member_1)));
                                        let _e947 = (_e941 <= select(_e499.member.member_1, _e937, (_e937 < _e499.member.member_1)));
                                        let _e948 = (_e939 <= _e941);
                                        if _e946 {
                                            if _e947 {
                                                if _e948 {
                                                    phi_3091_ = _e845.member_2;
                                                } else {
                                                    phi_3091_ = _e845.member_1;
                                                }
                                                let _e952 = phi_3091_;
                                                let _e974 = (_e543 % 128u);
                                                let _e975 = (_e974 < 128u);
                                                if _e975 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_8[_e974] = _e952.member_1;
                                                if _e975 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_7[_e974] = _e952.member.member.x;
                                                if _e975 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_6[_e974] = _e952.member.member.y;
                                                if _e975 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_5[_e974] = _e952.member.member.z;
                                                if _e975 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_4[_e974] = _e952.member.member_1.x;
                                                if _e975 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_3[_e974] = _e952.member.member_1.y;
                                                if _e975 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_2[_e974] = _e952.member.member_1.z;
                                                if _e975 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_9[_e974] = select(_e941, _e939, (_e939 > _e941));
                                                if _e948 {
                                                    phi_3168_ = _e845.member_1;
                                                } else {
                                                    phi_3168_ = _e845.member_2;
                                                }
                                                let _e988 = phi_3168_;
                                                phi_3169_ = _e988;
                                                phi_3170_ = (_e543 + 1u);
                                            } else {
                                                phi_3169_ = type_51();
                                                phi_3170_ = u32();
                                            }
                                            let _e990 = phi_3169_;
                                            let _e992 = phi_3170_;
                                            phi_3172_ = _e990;
                                            phi_3173_ = _e992;
                                            phi_3174_ = select(true, false, _e947);
                                        } else {
                                            phi_3172_ = type_51();
                                            phi_3173_ = u32();
                                            phi_3174_ = true;
                                        }
                                        let _e995 = phi_3172_;
                                        let _e997 = phi_3173_;
                                        let _e999 = phi_3174_;
                                        if _e999 {
                                            if _e946 {
                                                phi_3183_ = _e845.member_1;
                                            } else {
                                                phi_3183_ = _e845.member_2;
                                            }
                                            let _e1003 = phi_3183_;
                                            phi_3188_ = _e1003;
                                            phi_3189_ = select(_e947, true, _e946);
                                        } else {
                                            phi_3188_ = _e995;
                                            phi_3189_ = _e541;
                                        }
                                        let _e1006 = phi_3188_;
                                        let _e1008 = phi_3189_;
                                        phi_3557_ = _e497;
                                        phi_3191_ = type_40(_e499.member, (_e499.member_1 + 1u), _e499.member_2);
                                        phi_3192_ = _e1006;
                                        phi_3193_ = _e1008;
                                        phi_3194_ = select(_e997, _e543, _e999);
                                    }
                                    let _e1612 = phi_3557_;
                                    let _e1614 = phi_3191_;
                                    let _e1616 = phi_3192_;
                                    let _e1618 = phi_3193_;
                                    let _e1620 = phi_3194_;
                                    phi_3556_ = _e1612;
                                    phi_3195_ = _e1614;
                                    phi_3196_ = _e1616;
                                    phi_3197_ = (_e503 - 1u);
                                    phi_3198_ = _e1618;
                                    phi_3199_ = _e1620;
                                } else {
                                    phi_3556_ = _e497;
                                    phi_3195_ = _e499;
                                    phi_3196_ = _e539;
                                    phi_3197_ = _e503;
                                    phi_3198_ = _e541;
                                    phi_3199_ = _e543;
                                }
                                let _e1622 = phi_3556_;
                                let _e1624 = phi_3195_;
                                let _e1626 = phi_3196_;
                                let _e1628 = phi_3197_;
                                let _e1630 = phi_3198_;
                                let _e1632 = phi_3199_;
                                phi_3555_ = _e1622;
                                phi_3200_ = _e1624;
                                phi_3201_ = _e1626;
                                phi_3202_ = _e1628;
                                phi_3203_ = _e1630;
                                phi_3204_ = _e1632;
                            } else {
                                phi_3555_ = _e497;
                                phi_3200_ = type_40();
                                phi_3201_ = type_51();
                                phi_3202_ = u32();
                                phi_3203_ = bool();
                                phi_3204_ = u32();
                            }
                            let _e1634 = phi_3555_;
                            let _e1636 = phi_3200_;
                            let _e1638 = phi_3201_;
                            let _e1640 = phi_3202_;
                            let _e1642 = phi_3203_;
                            let _e1644 = phi_3204_;
                            phi_3554_ = _e1634;
                            phi_841_ = _e1636;
                            phi_844_ = _e1638;
                            phi_846_ = _e1640;
                            phi_848_ = _e1642;
                            phi_850_ = _e1644;
                            phi_3205_ = _e511;
                        } else {
                            phi_3554_ = _e497;
                            phi_841_ = type_40();
                            phi_844_ = type_51();
                            phi_846_ = u32();
                            phi_848_ = bool();
                            phi_850_ = u32();
                            phi_3205_ = false;
                        }
                        let _e1646 = phi_3554_;
                        let _e1648 = phi_841_;
                        let _e1650 = phi_844_;
                        let _e1652 = phi_846_;
                        let _e1654 = phi_848_;
                        let _e1656 = phi_850_;
                        let _e1658 = phi_3205_;
                        continue;
                        continuing {
                            phi_3417_ = _e1646;
                            phi_840_ = _e1648;
                            phi_843_ = _e1650;
                            phi_845_ = _e1652;
                            phi_847_ = _e1654;
                            phi_849_ = _e1656;
                            phi_3553_ = _e1646;
                            break if !(_e1658);
                        }
                    }
                    let _e1661 = phi_3553_;
                    if _e1661 {
                        break;
                    }
                    let _e1663 = local_10;
                    let _e1666 = local_11;
                    if _e142 {
                    } else {
                        break;
                    }
                    global_6.member[_e140][0u] = _e1663.member_1;
                    global_6.member[_e140][1u] = _e1666.member_2;
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
