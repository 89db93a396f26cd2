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
    var phi_840_: type_44;
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
    var phi_966_: type_44;
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
    var phi_1914_: type_29;
    var phi_1916_: type_29;
    var phi_1917_: bool;
    var phi_1921_: type_29;
    var phi_1922_: type_29;
    var phi_1923_: type_29;
    var phi_1924_: bool;
    var phi_1928_: type_29;
    var phi_1929_: bool;
    var phi_1930_: type_29;
    var phi_1931_: bool;
    var phi_1932_: bool;
    var phi_1933_: type_29;
    var phi_1934_: bool;
    var phi_1935_: bool;
    var phi_1943_: type_29;
    var phi_1944_: bool;
    var phi_1948_: type_29;
    var phi_1973_: bool;
    var phi_1974_: bool;
    var phi_1981_: type_44;
    var phi_1982_: type_44;
    var phi_1983_: type_44;
    var phi_967_: type_44;
    var phi_3411_: bool;
    var phi_3557_: bool;
    var phi_3191_: type_44;
    var phi_3192_: type_51;
    var phi_3193_: bool;
    var phi_3194_: u32;
    var phi_3556_: bool;
    var phi_3195_: type_44;
    var phi_3196_: type_51;
    var phi_3197_: u32;
    var phi_3198_: bool;
    var phi_3199_: u32;
    var phi_3555_: bool;
    var phi_3200_: type_44;
    var phi_3201_: type_51;
    var phi_3202_: u32;
    var phi_3203_: bool;
    var phi_3204_: u32;
    var phi_3554_: bool;
    var phi_841_: type_44;
    var phi_844_: type_51;
    var phi_846_: u32;
    var phi_848_: bool;
    var phi_850_: u32;
    var phi_3205_: bool;
    var phi_3553_: bool;
    var local_10: type_44;
    var local_11: type_44;
    var local_12: type_44;

    switch bitcast<i32>(0u) {
        default: {
            let _e84 = global;
            let _e86 = arrayLength((&global_4.member));
            let _e88 = arrayLength((&global_2.member));
            let _e96 = global_3.member[0u][0u];
            let _e100 = global_3.member[0u][1u];
            let _e104 = global_3.member[0u][2u];
            let _e108 = global_3.member[0u][3u];
            let _e112 = global_3.member[1u][0u];
            let _e116 = global_3.member[1u][1u];
            let _e120 = global_3.member[1u][2u];
            let _e123 = global_1.member[0u];
            let _e124 = bitcast<i32>(_e123);
            let _e136 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e108) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e96), bitcast<i32>(_e100), bitcast<i32>(_e104));
            local = array<i32, 3>(bitcast<i32>(_e112), bitcast<i32>(_e116), bitcast<i32>(_e120));
            let _e142 = (_e84.x + (_e84.y * 2097152u));
            let _e143 = (_e142 < arrayLength((&global_5.member)));
            if _e143 {
                let _e144 = (_e142 < arrayLength((&global_6.member)));
                if _e144 {
                    if _e143 {
                    } else {
                        break;
                    }
                    let _e152 = global_5.member[_e142].member_2[0u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_5.member[_e142].member_2[1u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_5.member[_e142].member_2[2u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_5.member[_e142].member[0u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_5.member[_e142].member[1u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_5.member[_e142].member[2u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e191 = select(_e161, _e154, (_e161 < _e154));
                    let _e193 = select(_e168, _e191, (_e168 < _e191));
                    let _e195 = select(_e175, _e193, (_e175 < _e193));
                    let _e197 = select(_e182, _e195, (_e182 < _e195));
                    let _e199 = select(_e189, _e197, (_e189 < _e197));
                    let _e203 = global_5.member[_e142].member_1;
                    let _e205 = (bitcast<u32>(_e203) & 2147483647u);
                    let _e212 = global_5.member[_e142].member_3;
                    let _e218 = (((select(_e205, _e199, (_e205 < _e199)) < 2139095040u) && ((bitcast<u32>(_e212) & 2147483647u) <= 2139095040u)) && (_e193 > 0u));
                    if _e218 {
                        let _e221 = (bitcast<u32>(bitcast<f32>(_e193)) & 2147483647u);
                        if (_e221 >= 8388608u) {
                            phi_381_ = (bitcast<i32>((_e221 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_381_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e221)), 32u, (_e221 == 0u))));
                        }
                        let _e235 = phi_381_;
                        phi_382_ = _e235;
                    } else {
                        phi_382_ = 0i;
                    }
                    let _e237 = phi_382_;
                    let _e238 = (_e154 == _e193);
                    if _e238 {
                        phi_392_ = true;
                    } else {
                        phi_392_ = (_e161 == _e193);
                    }
                    let _e241 = phi_392_;
                    let _e242 = select(1u, 0u, _e238);
                    if _e241 {
                        let _e243 = (_e242 + 1u);
                        phi_402_ = _e243;
                        phi_403_ = _e243;
                        phi_405_ = select(true, false, (_e243 == 2u));
                    } else {
                        phi_402_ = u32();
                        phi_403_ = 0u;
                        phi_405_ = true;
                    }
                    let _e247 = phi_402_;
                    let _e249 = phi_403_;
                    let _e251 = phi_405_;
                    if _e251 {
                        phi_410_ = (_e249 + 1u);
                    } else {
                        phi_410_ = 0u;
                    }
                    let _e255 = phi_410_;
                    let _e256 = select(_e247, _e249, _e251);
                    let _e257 = select(_e242, select(2u, _e242, _e241), _e251);
                    if (_e124 < -126i) {
                        phi_422_ = -126i;
                    } else {
                        phi_422_ = select(_e124, 127i, (_e124 > 127i));
                    }
                    let _e262 = phi_422_;
                    let _e267 = bitcast<f32>((bitcast<u32>((_e262 + 127i)) << bitcast<u32>(23i)));
                    let _e273 = bitcast<f32>((bitcast<u32>(((_e124 - _e262) + 127i)) << bitcast<u32>(23i)));
                    let _e274 = -(_e237);
                    if (_e274 < -126i) {
                        phi_442_ = -126i;
                    } else {
                        phi_442_ = select(_e274, 127i, (_e274 > 127i));
                    }
                    let _e279 = phi_442_;
                    let _e284 = bitcast<f32>((bitcast<u32>((_e279 + 127i)) << bitcast<u32>(23i)));
                    let _e290 = bitcast<f32>((bitcast<u32>(((_e274 - _e279) + 127i)) << bitcast<u32>(23i)));
                    let _e294 = global_5.member[_e142].member;
                    let _e295 = (_e256 == 0u);
                    if _e295 {
                        phi_460_ = _e294[0];
                    } else {
                        phi_460_ = _e294[1];
                    }
                    let _e299 = phi_460_;
                    let _e300 = (_e256 == 2u);
                    if _e300 {
                        phi_466_ = _e294[2];
                    } else {
                        phi_466_ = _e299;
                    }
                    let _e303 = phi_466_;
                    let _e305 = ((_e303 * _e267) * _e273);
                    let _e306 = global_5.member[_e142].member_2;
                    if _e295 {
                        phi_477_ = _e306[0];
                    } else {
                        phi_477_ = _e306[1];
                    }
                    let _e310 = phi_477_;
                    if _e300 {
                        phi_483_ = _e306[2];
                    } else {
                        phi_483_ = _e310;
                    }
                    let _e313 = phi_483_;
                    let _e315 = ((_e313 * _e284) * _e290);
                    let _e319 = (bitcast<f32>((bitcast<u32>(_e315) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e319 {
                        let _e323 = (bitcast<f32>((bitcast<u32>(_e305) & 2147483647u)) * 0.00000011920929f);
                        phi_506_ = select(0.00000000000011368684f, _e323, (_e323 > 0.00000000000011368684f));
                    } else {
                        phi_506_ = 0f;
                    }
                    let _e327 = phi_506_;
                    let _e328 = (_e305 + _e327);
                    let _e329 = (_e305 - _e327);
                    let _e330 = select(_e315, 0f, _e319);
                    if _e319 {
                        phi_517_ = 38685626000000000000000000f;
                    } else {
                        phi_517_ = (1f / _e315);
                    }
                    let _e333 = phi_517_;
                    let _e334 = (_e255 == 0u);
                    if _e334 {
                        phi_526_ = _e294[0];
                    } else {
                        phi_526_ = _e294[1];
                    }
                    let _e338 = phi_526_;
                    let _e339 = (_e255 == 2u);
                    if _e339 {
                        phi_532_ = _e294[2];
                    } else {
                        phi_532_ = _e338;
                    }
                    let _e342 = phi_532_;
                    let _e344 = ((_e342 * _e267) * _e273);
                    if _e334 {
                        phi_543_ = _e306[0];
                    } else {
                        phi_543_ = _e306[1];
                    }
                    let _e348 = phi_543_;
                    if _e339 {
                        phi_549_ = _e306[2];
                    } else {
                        phi_549_ = _e348;
                    }
                    let _e351 = phi_549_;
                    let _e353 = ((_e351 * _e284) * _e290);
                    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e357 {
                        let _e361 = (bitcast<f32>((bitcast<u32>(_e344) & 2147483647u)) * 0.00000011920929f);
                        phi_572_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                    } else {
                        phi_572_ = 0f;
                    }
                    let _e365 = phi_572_;
                    let _e366 = (_e344 + _e365);
                    let _e367 = (_e344 - _e365);
                    let _e368 = select(_e353, 0f, _e357);
                    if _e357 {
                        phi_583_ = 38685626000000000000000000f;
                    } else {
                        phi_583_ = (1f / _e353);
                    }
                    let _e371 = phi_583_;
                    let _e372 = (_e257 == 0u);
                    if _e372 {
                        phi_592_ = _e294[0];
                    } else {
                        phi_592_ = _e294[1];
                    }
                    let _e376 = phi_592_;
                    let _e377 = (_e257 == 2u);
                    if _e377 {
                        phi_598_ = _e294[2];
                    } else {
                        phi_598_ = _e376;
                    }
                    let _e380 = phi_598_;
                    let _e382 = ((_e380 * _e267) * _e273);
                    if _e372 {
                        phi_609_ = _e306[0];
                    } else {
                        phi_609_ = _e306[1];
                    }
                    let _e386 = phi_609_;
                    if _e377 {
                        phi_615_ = _e306[2];
                    } else {
                        phi_615_ = _e386;
                    }
                    let _e389 = phi_615_;
                    let _e391 = ((_e389 * _e284) * _e290);
                    let _e395 = (bitcast<f32>((bitcast<u32>(_e391) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e395 {
                        let _e399 = (bitcast<f32>((bitcast<u32>(_e382) & 2147483647u)) * 0.00000011920929f);
                        phi_638_ = select(0.00000000000011368684f, _e399, (_e399 > 0.00000000000011368684f));
                    } else {
                        phi_638_ = 0f;
                    }
                    let _e403 = phi_638_;
                    let _e404 = (_e382 + _e403);
                    let _e405 = (_e382 - _e403);
                    let _e406 = select(_e391, 0f, _e395);
                    if _e395 {
                        phi_649_ = 38685626000000000000000000f;
                    } else {
                        phi_649_ = (1f / _e391);
                    }
                    let _e409 = phi_649_;
                    let _e412 = bitcast<f32>((bitcast<u32>(_e305) & 2147483647u));
                    let _e415 = bitcast<f32>((bitcast<u32>(_e344) & 2147483647u));
                    let _e417 = select(_e415, _e412, (_e412 > _e415));
                    let _e420 = bitcast<f32>((bitcast<u32>(_e382) & 2147483647u));
                    let _e423 = (_e124 + _e237);
                    if (_e218 && (select(_e420, _e417, (_e417 > _e420)) <= 1099511600000f)) {
                        let _e426 = (_e423 / 3i);
                        let _e433 = bitcast<f32>((bitcast<u32>((_e426 + 127i)) << bitcast<u32>(23i)));
                        let _e440 = bitcast<f32>((bitcast<u32>(((_e423 - (2i * _e426)) + 127i)) << bitcast<u32>(23i)));
                        let _e441 = (((_e203 * _e433) * _e433) * _e440);
                        let _e443 = select(340282350000000000000000000000000000000f, _e441, (_e441 < 340282350000000000000000000000000000000f));
                        let _e448 = (((_e212 * _e433) * _e433) * _e440);
                        let _e450 = select(340282350000000000000000000000000000000f, _e448, (_e448 < 340282350000000000000000000000000000000f));
                        phi_749_ = select(-340282350000000000000000000000000000000f, _e450, (_e450 > -340282350000000000000000000000000000000f));
                        phi_750_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_749_ = 0f;
                        phi_750_ = 1f;
                    }
                    let _e454 = phi_749_;
                    let _e456 = phi_750_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e461 = (_e256 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_1[_e461];
                    let _e467 = (_e255 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_1[_e467];
                    let _e473 = (_e257 % 3u);
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
                    phi_3417_ = false;
                    phi_840_ = type_44(type_37(type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e454), 0u, 0u);
                    phi_843_ = type_51(type_33(vec4<f32>((f32(_e464) * _e136), (f32(_e470) * _e136), (f32(_e476) * _e136), 0f), vec4<f32>((f32(_e481) * _e136), (f32(_e485) * _e136), (f32(_e489) * _e136), 0f)), select(0u, 2147483648u, (_e86 == 0u)));
                    phi_845_ = ((3u * _e86) + 1u);
                    phi_847_ = (_e456 <= _e454);
                    phi_849_ = 0u;
                    loop {
                        let _e499 = phi_3417_;
                        let _e501 = phi_840_;
                        let _e503 = phi_843_;
                        let _e505 = phi_845_;
                        let _e507 = phi_847_;
                        let _e509 = phi_849_;
                        local_10 = _e501;
                        local_11 = _e501;
                        if _e507 {
                            phi_860_ = true;
                        } else {
                            phi_860_ = (_e509 > 0u);
                        }
                        let _e512 = phi_860_;
                        if _e512 {
                            let _e513 = (_e505 > 0u);
                            if _e513 {
                                if _e507 {
                                    phi_946_ = _e503;
                                    phi_947_ = _e507;
                                    phi_948_ = _e509;
                                } else {
                                    let _e514 = (_e509 - 1u);
                                    let _e515 = (_e514 % 128u);
                                    let _e516 = (_e515 < 128u);
                                    if _e516 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e518 = local_7[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e520 = local_6[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e522 = local_5[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e524 = local_4[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e526 = local_3[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e528 = local_2[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e533 = local_8[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3553_ = true;
                                        break;
                                    }
                                    let _e536 = local_9[_e515];
                                    phi_946_ = type_51(type_33(vec4<f32>(_e518, _e520, _e522, 0f), vec4<f32>(_e524, _e526, _e528, 0f)), _e533);
                                    phi_947_ = (_e536 <= _e501.member.member_1);
                                    phi_948_ = _e514;
                                }
                                let _e541 = phi_946_;
                                let _e543 = phi_947_;
                                let _e545 = phi_948_;
                                if _e543 {
                                    if ((_e541.member_1 & 2147483648u) != 0u) {
                                        phi_966_ = _e501;
                                        phi_969_ = type_4(0u, ((_e541.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e996 = phi_966_;
                                            let _e998 = phi_969_;
                                            local_12 = _e996;
                                            if (_e998.member < _e998.member_1) {
                                                phi_970_ = type_4((_e998.member + 1u), _e998.member_1);
                                                phi_992_ = type_4(1u, _e998.member);
                                            } else {
                                                phi_970_ = _e998;
                                                phi_992_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1011 = phi_970_;
                                            let _e1013 = phi_992_;
                                            let _e1017 = (bitcast<i32>(_e1013.member) != 0i);
                                            if _e1017 {
                                                let _e1023 = type_44(_e996.member, _e996.member_1, (_e996.member_2 + 1u));
                                                let _e1024 = ((_e541.member_1 & 268435455u) + _e1013.member_1);
                                                let _e1025 = (_e1024 < _e88);
                                                if _e1025 {
                                                    if _e1025 {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1029 = global_2.member[_e1024].member_1;
                                                    phi_1016_ = _e1029;
                                                } else {
                                                    phi_1016_ = 4294967295u;
                                                }
                                                let _e1031 = phi_1016_;
                                                if (_e1024 >= _e88) {
                                                    phi_1105_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1025 {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    if (_e461 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1038 = global_2.member[_e1024].member[_e461];
                                                    if (_e467 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1044 = global_2.member[_e1024].member[_e467];
                                                    if (_e473 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1050 = global_2.member[_e1024].member[_e473];
                                                    let _e1052 = (3u + _e461);
                                                    if (_e1052 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1058 = global_2.member[_e1024].member[_e1052];
                                                    let _e1059 = (3u + _e467);
                                                    if (_e1059 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1065 = global_2.member[_e1024].member[_e1059];
                                                    let _e1066 = (3u + _e473);
                                                    if (_e1066 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1072 = global_2.member[_e1024].member[_e1066];
                                                    let _e1074 = (6u + _e461);
                                                    if (_e1074 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_2.member[_e1024].member[_e1074];
                                                    let _e1081 = (6u + _e467);
                                                    if (_e1081 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1087 = global_2.member[_e1024].member[_e1081];
                                                    let _e1088 = (6u + _e473);
                                                    if (_e1088 < 9u) {
                                                    } else {
                                                        phi_3411_ = true;
                                                        break;
                                                    }
                                                    let _e1094 = global_2.member[_e1024].member[_e1088];
                                                    phi_1105_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1038, _e1044, _e1050), array<f32, 3>(_e1058, _e1065, _e1072), array<f32, 3>(_e1080, _e1087, _e1094));
                                                }
                                                let _e1098 = phi_1105_;
                                                let _e1107 = (_e1098[0][2] - _e382);
                                                let _e1110 = (((_e1098[0][0] - _e305) * _e406) - (_e1107 * _e330));
                                                let _e1113 = (((_e1098[0][1] - _e344) * _e406) - (_e1107 * _e368));
                                                let _e1120 = (_e1098[1][2] - _e382);
                                                let _e1123 = (((_e1098[1][0] - _e305) * _e406) - (_e1120 * _e330));
                                                let _e1126 = (((_e1098[1][1] - _e344) * _e406) - (_e1120 * _e368));
                                                let _e1133 = (_e1098[2][2] - _e382);
                                                let _e1136 = (((_e1098[2][0] - _e305) * _e406) - (_e1133 * _e330));
                                                let _e1139 = (((_e1098[2][1] - _e344) * _e406) - (_e1133 * _e368));
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
                                                        phi_1933_ = type_29();
                                                        phi_1934_ = true;
                                                        phi_1935_ = false;
                                                    } else {
                                                        let _e1174 = select(_e1123, _e1110, (_e1110 < _e1123));
                                                        if (select(_e1136, _e1174, (_e1174 < _e1136)) > 0f) {
                                                            phi_1222_ = true;
                                                        } else {
                                                            let _e1179 = select(_e1123, _e1110, (_e1110 > _e1123));
                                                            phi_1222_ = (select(_e1136, _e1179, (_e1179 > _e1136)) < 0f);
                                                        }
                                                        let _e1184 = phi_1222_;
                                                        if _e1184 {
                                                            phi_1930_ = type_29();
                                                            phi_1931_ = true;
                                                            phi_1932_ = false;
                                                        } else {
                                                            let _e1186 = select(_e1126, _e1113, (_e1113 < _e1126));
                                                            if (select(_e1139, _e1186, (_e1186 < _e1139)) > 0f) {
                                                                phi_1251_ = true;
                                                            } else {
                                                                let _e1191 = select(_e1126, _e1113, (_e1113 > _e1126));
                                                                phi_1251_ = (select(_e1139, _e1191, (_e1191 > _e1139)) < 0f);
                                                            }
                                                            let _e1196 = phi_1251_;
                                                            if _e1196 {
                                                                phi_1928_ = type_29();
                                                                phi_1929_ = false;
                                                            } else {
                                                                let _e1198 = select(_e1098[1][0], _e1098[0][0], (_e1098[0][0] < _e1098[1][0]));
                                                                let _e1202 = select(_e1098[1][0], _e1098[0][0], (_e1098[0][0] > _e1098[1][0]));
                                                                let _e1206 = select(_e1098[1][1], _e1098[0][1], (_e1098[0][1] < _e1098[1][1]));
                                                                let _e1210 = select(_e1098[1][1], _e1098[0][1], (_e1098[0][1] > _e1098[1][1]));
                                                                let _e1214 = select(_e1098[1][2], _e1098[0][2], (_e1098[0][2] < _e1098[1][2]));
                                                                let _e1218 = select(_e1098[1][2], _e1098[0][2], (_e1098[0][2] > _e1098[1][2]));
                                                                let _e1223 = ((select(_e1098[2][0], _e1198, (_e1198 < _e1098[2][0])) - _e328) * _e333);
                                                                let _e1224 = ((select(_e1098[2][0], _e1202, (_e1202 > _e1098[2][0])) - _e329) * _e333);
                                                                let _e1227 = ((select(_e1098[2][1], _e1206, (_e1206 < _e1098[2][1])) - _e366) * _e371);
                                                                let _e1228 = ((select(_e1098[2][1], _e1210, (_e1210 > _e1098[2][1])) - _e367) * _e371);
                                                                let _e1231 = ((select(_e1098[2][2], _e1214, (_e1214 < _e1098[2][2])) - _e404) * _e409);
                                                                let _e1232 = ((select(_e1098[2][2], _e1218, (_e1218 > _e1098[2][2])) - _e405) * _e409);
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
                                                                let _e1259 = select(_e456, _e1244, (_e1244 > _e456));
                                                                if (_e1259 > (_e1252 + (select(_e1253, _e1236, (_e1236 > _e1253)) * 0.0000019073523f))) {
                                                                    phi_1923_ = type_29();
                                                                    phi_1924_ = true;
                                                                } else {
                                                                    let _e1261 = (_e1259 > _e996.member.member_1);
                                                                    if _e1261 {
                                                                        phi_1922_ = type_29();
                                                                    } else {
                                                                        let _e1262 = vec3<f32>(_e1098[0][0], _e1098[0][1], _e1098[0][2]);
                                                                        let _e1263 = vec3<f32>(_e1098[1][0], _e1098[1][1], _e1098[1][2]);
                                                                        let _e1264 = vec3<f32>(_e1098[2][0], _e1098[2][1], _e1098[2][2]);
                                                                        let _e1265 = (_e1098[1][0] - _e1098[0][0]);
                                                                        let _e1266 = (_e1098[1][1] - _e1098[0][1]);
                                                                        let _e1267 = (_e1098[1][2] - _e1098[0][2]);
                                                                        let _e1268 = vec3<f32>(_e1265, _e1266, _e1267);
                                                                        let _e1269 = (_e1098[2][0] - _e1098[1][0]);
                                                                        let _e1270 = (_e1098[2][1] - _e1098[1][1]);
                                                                        let _e1271 = (_e1098[2][2] - _e1098[1][2]);
                                                                        let _e1272 = vec3<f32>(_e1269, _e1270, _e1271);
                                                                        let _e1273 = (_e1098[0][0] - _e1098[2][0]);
                                                                        let _e1274 = (_e1098[0][1] - _e1098[2][1]);
                                                                        let _e1275 = (_e1098[0][2] - _e1098[2][2]);
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
                                                                            phi_1652_ = _e1126;
                                                                            phi_1653_ = _e1123;
                                                                            phi_1654_ = _e1113;
                                                                            phi_1655_ = _e1110;
                                                                            phi_1656_ = _e1262;
                                                                            phi_1657_ = _e1276;
                                                                            phi_1658_ = _e1272;
                                                                            phi_1659_ = _e1268;
                                                                        } else {
                                                                            let _e1321 = (_e1302 == _e1319);
                                                                            let _e1326 = vec3(_e1321);
                                                                            phi_1652_ = select(_e1113, _e1139, _e1321);
                                                                            phi_1653_ = select(_e1110, _e1136, _e1321);
                                                                            phi_1654_ = select(_e1139, _e1126, _e1321);
                                                                            phi_1655_ = select(_e1136, _e1123, _e1321);
                                                                            phi_1656_ = select(_e1264, _e1263, _e1326);
                                                                            phi_1657_ = select(_e1272, _e1268, _e1326);
                                                                            phi_1658_ = select(_e1268, _e1276, _e1326);
                                                                            phi_1659_ = select(_e1276, _e1272, _e1326);
                                                                        }
                                                                        let _e1332 = phi_1652_;
                                                                        let _e1334 = phi_1653_;
                                                                        let _e1336 = phi_1654_;
                                                                        let _e1338 = phi_1655_;
                                                                        let _e1340 = phi_1656_;
                                                                        let _e1342 = phi_1657_;
                                                                        let _e1344 = phi_1658_;
                                                                        let _e1346 = phi_1659_;
                                                                        let _e1353 = ((_e1344.y * _e1342.z) - (_e1342.y * _e1344.z));
                                                                        let _e1358 = ((_e1344.z * _e1342.x) - (_e1342.z * _e1344.x));
                                                                        let _e1361 = ((_e1344.x * _e1342.y) - (_e1342.x * _e1344.y));
                                                                        if (_e1161 >= _e1165) {
                                                                            phi_1690_ = select(true, false, (_e1161 >= _e1169));
                                                                        } else {
                                                                            phi_1690_ = true;
                                                                        }
                                                                        let _e1366 = phi_1690_;
                                                                        if _e1366 {
                                                                            phi_1699_ = select(_e1264, _e1263, vec3((_e1165 >= _e1169)));
                                                                        } else {
                                                                            phi_1699_ = _e1262;
                                                                        }
                                                                        let _e1371 = phi_1699_;
                                                                        let _e1376 = (((_e1353 * _e330) + (_e1358 * _e368)) + (_e1361 * _e406));
                                                                        let _e1387 = (((_e1353 * (_e1371.x - _e305)) + (_e1358 * (_e1371.y - _e344))) + (_e1361 * (_e1371.z - _e382)));
                                                                        let _e1389 = (_e1334 - _e1338);
                                                                        let _e1390 = (_e1332 - _e1336);
                                                                        let _e1398 = (-(((_e1338 * _e1389) + (_e1336 * _e1390))) / ((_e1389 * _e1389) + (_e1390 * _e1390)));
                                                                        let _e1400 = select(1f, _e1398, (_e1398 < 1f));
                                                                        let _e1402 = select(0f, _e1400, (_e1400 > 0f));
                                                                        let _e1415 = ((_e1340.x + (_e1346.x * _e1402)) - _e305);
                                                                        let _e1416 = ((_e1340.y + (_e1346.y * _e1402)) - _e344);
                                                                        let _e1417 = ((_e1340.z + (_e1346.z * _e1402)) - _e382);
                                                                        let _e1418 = (_e1417 / _e406);
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
                                                                            phi_1866_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1376) & 2147483647u)) > ((0.0000038146973f * select(_e1472, _e1469, (_e1469 > _e1472))) * select(_e1486, _e1483, (_e1483 > _e1486)))));
                                                                        } else {
                                                                            phi_1866_ = true;
                                                                        }
                                                                        let _e1493 = phi_1866_;
                                                                        if _e1493 {
                                                                            let _e1504 = ((((_e1353 * (_e1415 - (_e330 * _e1418))) + (_e1358 * (_e1416 - (_e368 * _e1418)))) + (_e1361 * (_e1417 - _e1417))) / _e1376);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1504) & 2147483647u)) <= _e1319) {
                                                                                phi_1890_ = (_e1418 + _e1504);
                                                                            } else {
                                                                                phi_1890_ = _e1418;
                                                                            }
                                                                            let _e1511 = phi_1890_;
                                                                            phi_1891_ = _e1511;
                                                                        } else {
                                                                            phi_1891_ = (_e1387 / _e1376);
                                                                        }
                                                                        let _e1513 = phi_1891_;
                                                                        let _e1515 = select(_e1252, _e1513, (_e1513 < _e1252));
                                                                        let _e1517 = select(_e1244, _e1515, (_e1515 > _e1244));
                                                                        if (_e1517 >= _e456) {
                                                                            let _e1519 = (_e1517 <= _e996.member.member_1);
                                                                            if _e1519 {
                                                                                let _e1520 = (1f / _e1171);
                                                                                phi_1914_ = type_29(_e1517, (_e1165 * _e1520), (_e1169 * _e1520), _e1031);
                                                                            } else {
                                                                                phi_1914_ = type_29();
                                                                            }
                                                                            let _e1525 = phi_1914_;
                                                                            phi_1916_ = _e1525;
                                                                            phi_1917_ = select(true, false, _e1519);
                                                                        } else {
                                                                            phi_1916_ = type_29();
                                                                            phi_1917_ = true;
                                                                        }
                                                                        let _e1528 = phi_1916_;
                                                                        let _e1530 = phi_1917_;
                                                                        if _e1530 {
                                                                            phi_1921_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1921_ = _e1528;
                                                                        }
                                                                        let _e1532 = phi_1921_;
                                                                        phi_1922_ = _e1532;
                                                                    }
                                                                    let _e1534 = phi_1922_;
                                                                    phi_1923_ = _e1534;
                                                                    phi_1924_ = _e1261;
                                                                }
                                                                let _e1536 = phi_1923_;
                                                                let _e1538 = phi_1924_;
                                                                phi_1928_ = _e1536;
                                                                phi_1929_ = _e1538;
                                                            }
                                                            let _e1540 = phi_1928_;
                                                            let _e1542 = phi_1929_;
                                                            phi_1930_ = _e1540;
                                                            phi_1931_ = _e1196;
                                                            phi_1932_ = _e1542;
                                                        }
                                                        let _e1544 = phi_1930_;
                                                        let _e1546 = phi_1931_;
                                                        let _e1548 = phi_1932_;
                                                        phi_1933_ = _e1544;
                                                        phi_1934_ = _e1546;
                                                        phi_1935_ = _e1548;
                                                    }
                                                    let _e1550 = phi_1933_;
                                                    let _e1552 = phi_1934_;
                                                    let _e1554 = phi_1935_;
                                                    phi_1943_ = _e1550;
                                                    phi_1944_ = select(_e1554, true, _e1552);
                                                } else {
                                                    phi_1943_ = type_29();
                                                    phi_1944_ = true;
                                                }
                                                let _e1557 = phi_1943_;
                                                let _e1559 = phi_1944_;
                                                if _e1559 {
                                                    phi_1948_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1948_ = _e1557;
                                                }
                                                let _e1561 = phi_1948_;
                                                if (_e1561.member_3 != 4294967295u) {
                                                    if (_e1031 != 4294967295u) {
                                                        if (_e1561.member < _e996.member.member.member) {
                                                            phi_1974_ = true;
                                                        } else {
                                                            if (_e1561.member == _e996.member.member.member) {
                                                                phi_1973_ = (_e1561.member_3 < _e996.member.member.member_3);
                                                            } else {
                                                                phi_1973_ = false;
                                                            }
                                                            let _e1576 = phi_1973_;
                                                            phi_1974_ = _e1576;
                                                        }
                                                        let _e1578 = phi_1974_;
                                                        if _e1578 {
                                                            phi_1981_ = type_44(type_37(_e1561, _e1561.member), _e1023.member_1, _e1023.member_2);
                                                        } else {
                                                            phi_1981_ = _e1023;
                                                        }
                                                        let _e1585 = phi_1981_;
                                                        phi_1982_ = _e1585;
                                                    } else {
                                                        phi_1982_ = _e1023;
                                                    }
                                                    let _e1587 = phi_1982_;
                                                    phi_1983_ = _e1587;
                                                } else {
                                                    phi_1983_ = _e1023;
                                                }
                                                let _e1589 = phi_1983_;
                                                phi_967_ = _e1589;
                                            } else {
                                                phi_967_ = type_44();
                                            }
                                            let _e1591 = phi_967_;
                                            continue;
                                            continuing {
                                                phi_966_ = _e1591;
                                                phi_969_ = _e1011;
                                                phi_3411_ = _e499;
                                                break if !(_e1017);
                                            }
                                        }
                                        let _e1594 = phi_3411_;
                                        phi_3553_ = _e1594;
                                        if _e1594 {
                                            break;
                                        }
                                        phi_3557_ = _e1594;
                                        let _e1764 = local_12;
                                        phi_3191_ = _e1764;
                                        phi_3192_ = _e541;
                                        phi_3193_ = false;
                                        phi_3194_ = _e545;
                                    } else {
                                        if (_e541.member_1 >= _e86) {
                                            phi_2747_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e541.member_1 < _e86) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e563 = ((1u + _e256) % 4u);
                                            if (_e563 < 4u) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e568 = global_4.member[_e541.member_1][_e563];
                                            let _e570 = (_e568 >> bitcast<u32>(11u));
                                            let _e572 = ((1u + _e255) % 4u);
                                            if (_e572 < 4u) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e577 = global_4.member[_e541.member_1][_e572];
                                            let _e579 = (_e577 >> bitcast<u32>(11u));
                                            let _e581 = ((1u + _e257) % 4u);
                                            if (_e581 < 4u) {
                                            } else {
                                                phi_3553_ = true;
                                                break;
                                            }
                                            let _e586 = global_4.member[_e541.member_1][_e581];
                                            let _e588 = (_e586 >> bitcast<u32>(11u));
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e541.member.member_1.x - _e541.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e612 = (bitcast<f32>((bitcast<u32>((_e541.member.member_1.y - _e541.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e613 = (bitcast<f32>((bitcast<u32>((_e541.member.member_1.z - _e541.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e615 = select(_e136, _e611, (_e611 > _e136));
                                            let _e617 = select(_e136, _e612, (_e612 > _e136));
                                            let _e619 = select(_e136, _e613, (_e613 > _e136));
                                            let _e644 = bitcast<u32>((f32(bitcast<i32>((_e568 & 1023u))) * _e615));
                                            let _e649 = (bitcast<i32>((_e568 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e652 = bitcast<f32>((_e644 & bitcast<u32>(_e649)));
                                            let _e653 = bitcast<u32>((f32(bitcast<i32>((_e577 & 1023u))) * _e617));
                                            let _e658 = (bitcast<i32>((_e577 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e586 & 1023u))) * _e619));
                                            let _e667 = (bitcast<i32>((_e586 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e674 = bitcast<f32>((_e644 & bitcast<u32>(~(_e649))));
                                            let _e678 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                            let _e682 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e683 = bitcast<u32>((f32(bitcast<i32>((_e570 & 1023u))) * _e615));
                                            let _e688 = (bitcast<i32>((_e570 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e691 = bitcast<f32>((_e683 & bitcast<u32>(_e688)));
                                            let _e692 = bitcast<u32>((f32(bitcast<i32>((_e579 & 1023u))) * _e617));
                                            let _e697 = (bitcast<i32>((_e579 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e588 & 1023u))) * _e619));
                                            let _e706 = (bitcast<i32>((_e588 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e713 = bitcast<f32>((_e683 & bitcast<u32>(~(_e688))));
                                            let _e717 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                            let _e721 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e751 = global_4.member[_e541.member_1][0u];
                                            let _e755 = global_4.member[_e541.member_1][1u];
                                            let _e759 = global_4.member[_e541.member_1][2u];
                                            let _e763 = global_4.member[_e541.member_1][3u];
                                            let _e775 = (((_e755 >> bitcast<u32>(22i)) | ((_e759 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e763 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e776 = (_e751 & 268435455u);
                                            let _e777 = (_e775 & 268435455u);
                                            let _e780 = ((_e751 >> bitcast<u32>(28u)) & 7u);
                                            let _e788 = ((_e751 >> bitcast<u32>(31i)) | (((_e775 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e789 = (_e780 != 0u);
                                            if (_e780 == 0u) {
                                                phi_2709_ = _e776;
                                            } else {
                                                if (_e780 == 7u) {
                                                    phi_2708_ = 2147483648u;
                                                } else {
                                                    phi_2708_ = ((2147483648u | (_e780 << bitcast<u32>(28u))) | (_e777 & 268435455u));
                                                }
                                                let _e798 = phi_2708_;
                                                phi_2709_ = _e798;
                                            }
                                            let _e800 = phi_2709_;
                                            if _e789 {
                                                let _e801 = (_e780 != 7u);
                                                if _e801 {
                                                    phi_2719_ = (_e777 + _e780);
                                                } else {
                                                    phi_2719_ = u32();
                                                }
                                                let _e804 = phi_2719_;
                                                phi_2721_ = _e804;
                                                phi_2722_ = select(true, false, _e801);
                                            } else {
                                                phi_2721_ = u32();
                                                phi_2722_ = true;
                                            }
                                            let _e807 = phi_2721_;
                                            let _e809 = phi_2722_;
                                            if (_e788 == 0u) {
                                                phi_2743_ = (_e776 + select(0u, 1u, !(_e789)));
                                            } else {
                                                if (_e788 == 7u) {
                                                    phi_2742_ = 2147483648u;
                                                } else {
                                                    phi_2742_ = ((2147483648u | (_e788 << bitcast<u32>(28u))) | (select(_e807, _e777, _e809) & 268435455u));
                                                }
                                                let _e822 = phi_2742_;
                                                phi_2743_ = _e822;
                                            }
                                            let _e824 = phi_2743_;
                                            phi_2747_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e541.member.member.x + _e652), (_e541.member.member.x + _e674), (_e541.member.member_1.x - _e691), (_e541.member.member_1.x - _e713)), vec4<f32>((_e541.member.member.y + _e661), (_e541.member.member.y + _e678), (_e541.member.member_1.y - _e700), (_e541.member.member_1.y - _e717)), vec4<f32>((_e541.member.member.z + _e670), (_e541.member.member.z + _e682), (_e541.member.member_1.z - _e709), (_e541.member.member_1.z - _e721))), type_51(type_33((_e541.member.member + vec4<f32>(_e652, _e661, _e670, 0f)), (_e541.member.member_1 - vec4<f32>(_e691, _e700, _e709, 0f))), _e800), type_51(type_33((_e541.member.member + vec4<f32>(_e674, _e678, _e682, 0f)), (_e541.member.member_1 - vec4<f32>(_e713, _e717, _e721, 0f))), _e824));
                                        }
                                        let _e829 = phi_2747_;
                                        let _e842 = ((_e829.member[0].x - _e328) * _e333);
                                        let _e843 = ((_e829.member[0].y - _e328) * _e333);
                                        let _e844 = ((_e829.member[0].z - _e329) * _e333);
                                        let _e845 = ((_e829.member[0].w - _e329) * _e333);
                                        let _e855 = ((_e829.member[1].x - _e366) * _e371);
                                        let _e856 = ((_e829.member[1].y - _e366) * _e371);
                                        let _e857 = ((_e829.member[1].z - _e367) * _e371);
                                        let _e858 = ((_e829.member[1].w - _e367) * _e371);
                                        let _e868 = ((_e829.member[2].x - _e404) * _e409);
                                        let _e869 = ((_e829.member[2].y - _e404) * _e409);
                                        let _e870 = ((_e829.member[2].z - _e405) * _e409);
                                        let _e871 = ((_e829.member[2].w - _e405) * _e409);
                                        let _e873 = select(_e870, _e868, (_e868 < _e870));
                                        let _e875 = select(_e871, _e869, (_e869 < _e871));
                                        let _e877 = select(_e870, _e868, (_e868 > _e870));
                                        let _e879 = select(_e871, _e869, (_e869 > _e871));
                                        let _e881 = select(_e844, _e842, (_e842 < _e844));
                                        let _e883 = select(_e845, _e843, (_e843 < _e845));
                                        let _e885 = select(_e857, _e855, (_e855 < _e857));
                                        let _e887 = select(_e858, _e856, (_e856 < _e858));
                                        let _e889 = select(_e885, _e881, (_e881 > _e885));
                                        let _e891 = select(_e887, _e883, (_e883 > _e887));
                                        let _e893 = select(_e873, _e889, (_e889 > _e873));
                                        let _e895 = select(_e875, _e891, (_e891 > _e875));
                                        let _e897 = select(_e844, _e842, (_e842 > _e844));
                                        let _e899 = select(_e845, _e843, (_e843 > _e845));
                                        let _e901 = select(_e857, _e855, (_e855 > _e857));
                                        let _e903 = select(_e858, _e856, (_e856 > _e858));
                                        let _e905 = select(_e901, _e897, (_e897 < _e901));
                                        let _e907 = select(_e903, _e899, (_e899 < _e903));
                                        let _e912 = -(_e873);
                                        let _e913 = -(_e875);
                                        let _e920 = (select(_e877, _e905, (_e905 < _e877)) + (select(_e912, _e877, (_e877 > _e912)) * 0.0000019073523f));
                                        let _e921 = (select(_e879, _e907, (_e907 < _e879)) + (select(_e913, _e879, (_e879 > _e913)) * 0.0000019073523f));
                                        let _e923 = select(_e456, _e893, (_e893 > _e456));
                                        let _e925 = select(_e456, _e895, (_e895 > _e456));
                                        let _e930 = (_e923 <= select(_e501.member.member_1, _e920, (_e920 < _e501.member.member_1)));
                                        let _e931 = (_e925 <= select(_e501.member.member_1, _e921, (_e921 < _e501.member.member_1)));
                                        let _e932 = (_e923 <= _e925);
                                        if _e930 {
                                            if _e931 {
                                                if _e932 {
                                                    phi_3091_ = _e829.member_2;
                                                } else {
                                                    phi_3091_ = _e829.member_1;
                                                }
                                                let _e936 = phi_3091_;
                                                let _e958 = (_e545 % 128u);
                                                let _e959 = (_e958 < 128u);
                                                if _e959 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_8[_e958] = _e936.member_1;
                                                if _e959 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_7[_e958] = _e936.member.member.x;
                                                if _e959 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_6[_e958] = _e936.member.member.y;
                                                if _e959 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_5[_e958] = _e936.member.member.z;
                                                if _e959 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_4[_e958] = _e936.member.member_1.x;
                                                if _e959 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_3[_e958] = _e936.member.member_1.y;
                                                if _e959 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_2[_e958] = _e936.member.member_1.z;
                                                if _e959 {
                                                } else {
                                                    phi_3553_ = true;
                                                    break;
                                                }
                                                local_9[_e958] = select(_e925, _e923, (_e923 > _e925));
                                                if _e932 {
                                                    phi_3168_ = _e829.member_1;
                                                } else {
                                                    phi_3168_ = _e829.member_2;
                                                }
                                                let _e972 = phi_3168_;
                                                phi_3169_ = _e972;
                                                phi_3170_ = (_e545 + 1u);
                                            } else {
                                                phi_3169_ = type_51();
                                                phi_3170_ = u32();
                                            }
                                            let _e974 = phi_3169_;
                                            let _e976 = phi_3170_;
                                            phi_3172_ = _e974;
                                            phi_3173_ = _e976;
                                            phi_3174_ = select(true, false, _e931);
                                        } else {
                                            phi_3172_ = type_51();
                                            phi_3173_ = u32();
                                            phi_3174_ = true;
                                        }
                                        let _e979 = phi_3172_;
                                        let _e981 = phi_3173_;
                                        let _e983 = phi_3174_;
                                        if _e983 {
                                            if _e930 {
                                                phi_3183_ = _e829.member_1;
                                            } else {
                                                phi_3183_ = _e829.member_2;
                                            }
                                            let _e987 = phi_3183_;
                                            phi_3188_ = _e987;
                                            phi_3189_ = select(_e931, true, _e930);
                                        } else {
                                            phi_3188_ = _e979;
                                            phi_3189_ = _e543;
                                        }
                                        let _e990 = phi_3188_;
                                        let _e992 = phi_3189_;
                                        phi_3557_ = _e499;
                                        phi_3191_ = type_44(_e501.member, (_e501.member_1 + 1u), _e501.member_2);
                                        phi_3192_ = _e990;
                                        phi_3193_ = _e992;
                                        phi_3194_ = select(_e981, _e545, _e983);
                                    }
                                    let _e1596 = phi_3557_;
                                    let _e1598 = phi_3191_;
                                    let _e1600 = phi_3192_;
                                    let _e1602 = phi_3193_;
                                    let _e1604 = phi_3194_;
                                    phi_3556_ = _e1596;
                                    phi_3195_ = _e1598;
                                    phi_3196_ = _e1600;
                                    phi_3197_ = (_e505 - 1u);
                                    phi_3198_ = _e1602;
                                    phi_3199_ = _e1604;
                                } else {
                                    phi_3556_ = _e499;
                                    phi_3195_ = _e501;
                                    phi_3196_ = _e541;
                                    phi_3197_ = _e505;
                                    phi_3198_ = _e543;
                                    phi_3199_ = _e545;
                                }
                                let _e1606 = phi_3556_;
                                let _e1608 = phi_3195_;
                                let _e1610 = phi_3196_;
                                let _e1612 = phi_3197_;
                                let _e1614 = phi_3198_;
                                let _e1616 = phi_3199_;
                                phi_3555_ = _e1606;
                                phi_3200_ = _e1608;
                                phi_3201_ = _e1610;
                                phi_3202_ = _e1612;
                                phi_3203_ = _e1614;
                                phi_3204_ = _e1616;
                            } else {
                                phi_3555_ = _e499;
                                phi_3200_ = type_44();
                                phi_3201_ = type_51();
                                phi_3202_ = u32();
                                phi_3203_ = bool();
                                phi_3204_ = u32();
                            }
                            let _e1618 = phi_3555_;
                            let _e1620 = phi_3200_;
                            let _e1622 = phi_3201_;
                            let _e1624 = phi_3202_;
                            let _e1626 = phi_3203_;
                            let _e1628 = phi_3204_;
                            phi_3554_ = _e1618;
                            phi_841_ = _e1620;
                            phi_844_ = _e1622;
                            phi_846_ = _e1624;
                            phi_848_ = _e1626;
                            phi_850_ = _e1628;
                            phi_3205_ = _e513;
                        } else {
                            phi_3554_ = _e499;
                            phi_841_ = type_44();
                            phi_844_ = type_51();
                            phi_846_ = u32();
                            phi_848_ = bool();
                            phi_850_ = u32();
                            phi_3205_ = false;
                        }
                        let _e1630 = phi_3554_;
                        let _e1632 = phi_841_;
                        let _e1634 = phi_844_;
                        let _e1636 = phi_846_;
                        let _e1638 = phi_848_;
                        let _e1640 = phi_850_;
                        let _e1642 = phi_3205_;
                        continue;
                        continuing {
                            phi_3417_ = _e1630;
                            phi_840_ = _e1632;
                            phi_843_ = _e1634;
                            phi_845_ = _e1636;
                            phi_847_ = _e1638;
                            phi_849_ = _e1640;
                            phi_3553_ = _e1630;
                            break if !(_e1642);
                        }
                    }
                    let _e1645 = phi_3553_;
                    if _e1645 {
                        break;
                    }
                    let _e1647 = local_10;
                    let _e1650 = local_11;
                    if _e144 {
                    } else {
                        break;
                    }
                    global_6.member[_e142][0u] = _e1647.member_1;
                    global_6.member[_e142][1u] = _e1650.member_2;
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
