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

struct type_36 {
    member: array<type_25>,
}

struct type_38 {
    member: f32,
    member_1: bool,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: type_28,
    member_1: u32,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: type_45,
    member_2: type_45,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(3) 
var<storage> global_6: type_4;

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
    var phi_382_: i32;
    var phi_383_: i32;
    var phi_393_: bool;
    var phi_403_: u32;
    var phi_404_: u32;
    var phi_406_: bool;
    var phi_411_: u32;
    var phi_423_: i32;
    var phi_443_: i32;
    var phi_461_: f32;
    var phi_467_: f32;
    var phi_478_: f32;
    var phi_484_: f32;
    var phi_507_: f32;
    var phi_518_: f32;
    var phi_527_: f32;
    var phi_533_: f32;
    var phi_544_: f32;
    var phi_550_: f32;
    var phi_573_: f32;
    var phi_584_: f32;
    var phi_593_: f32;
    var phi_599_: f32;
    var phi_610_: f32;
    var phi_616_: f32;
    var phi_639_: f32;
    var phi_650_: f32;
    var phi_750_: f32;
    var phi_751_: f32;
    var phi_3739_: bool;
    var phi_840_: type_38;
    var phi_843_: type_45;
    var phi_845_: u32;
    var phi_847_: bool;
    var phi_849_: u32;
    var phi_860_: bool;
    var phi_946_: type_45;
    var phi_947_: bool;
    var phi_948_: u32;
    var phi_2772_: u32;
    var phi_2778_: u32;
    var phi_3032_: u32;
    var phi_3033_: u32;
    var phi_3043_: u32;
    var phi_3045_: u32;
    var phi_3046_: bool;
    var phi_3066_: u32;
    var phi_3067_: u32;
    var phi_3071_: type_46;
    var phi_3415_: type_45;
    var phi_3492_: type_45;
    var phi_3493_: type_45;
    var phi_3494_: u32;
    var phi_3496_: type_45;
    var phi_3497_: u32;
    var phi_3498_: bool;
    var phi_3507_: type_45;
    var phi_3512_: type_45;
    var phi_3513_: bool;
    var phi_967_: type_38;
    var phi_970_: type_8;
    var phi_971_: type_8;
    var phi_993_: type_8;
    var phi_1034_: u32;
    var phi_1040_: u32;
    var phi_1050_: u32;
    var phi_1066_: u32;
    var phi_1099_: u32;
    var phi_1105_: u32;
    var phi_1532_: u32;
    var phi_1550_: u32;
    var phi_1568_: u32;
    var phi_1588_: u32;
    var phi_1606_: u32;
    var phi_1624_: u32;
    var phi_1644_: u32;
    var phi_1662_: u32;
    var phi_1680_: u32;
    var phi_1258_: u32;
    var phi_1273_: u32;
    var phi_1283_: u32;
    var phi_1303_: u32;
    var phi_1323_: u32;
    var phi_1349_: u32;
    var phi_1364_: u32;
    var phi_1374_: u32;
    var phi_1394_: u32;
    var phi_1414_: u32;
    var phi_1440_: u32;
    var phi_1455_: u32;
    var phi_1465_: u32;
    var phi_1485_: u32;
    var phi_1505_: u32;
    var phi_1129_: u32;
    var phi_1172_: u32;
    var phi_1215_: u32;
    var phi_1686_: array<array<f32, 3>, 3>;
    var phi_2157_: vec3<f32>;
    var phi_2158_: vec3<f32>;
    var phi_2189_: bool;
    var phi_2198_: vec3<f32>;
    var phi_2238_: type_24;
    var phi_2240_: type_24;
    var phi_2241_: bool;
    var phi_2245_: type_24;
    var phi_2246_: type_24;
    var phi_2247_: type_24;
    var phi_2248_: bool;
    var phi_2252_: type_24;
    var phi_2253_: bool;
    var phi_2257_: type_24;
    var phi_2258_: bool;
    var phi_2262_: type_24;
    var phi_2273_: type_38;
    var phi_2274_: type_38;
    var phi_968_: type_38;
    var phi_3733_: bool;
    var local_10: type_38;
    var phi_3895_: bool;
    var phi_3515_: type_38;
    var phi_3516_: type_45;
    var phi_3517_: bool;
    var phi_3518_: u32;
    var phi_3894_: bool;
    var phi_3519_: type_38;
    var phi_3520_: type_45;
    var phi_3521_: u32;
    var phi_3522_: bool;
    var phi_3523_: u32;
    var phi_3893_: bool;
    var phi_3524_: type_38;
    var phi_3525_: type_45;
    var phi_3526_: u32;
    var phi_3527_: bool;
    var phi_3528_: u32;
    var phi_3892_: bool;
    var phi_841_: type_38;
    var phi_844_: type_45;
    var phi_846_: u32;
    var phi_848_: bool;
    var phi_850_: u32;
    var phi_3529_: bool;
    var phi_3891_: bool;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_3.member));
            let _e93 = arrayLength((&global_6.member));
            let _e101 = global_2.member[0u][0u];
            let _e105 = global_2.member[0u][1u];
            let _e109 = global_2.member[0u][2u];
            let _e113 = global_2.member[0u][3u];
            let _e117 = global_2.member[1u][0u];
            let _e121 = global_2.member[1u][1u];
            let _e125 = global_2.member[1u][2u];
            let _e128 = global_1.member[0u];
            let _e129 = bitcast<i32>(_e128);
            let _e141 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e113) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e101), bitcast<i32>(_e105), bitcast<i32>(_e109));
            local = array<i32, 3>(bitcast<i32>(_e117), bitcast<i32>(_e121), bitcast<i32>(_e125));
            let _e147 = (_e88.x + (_e88.y * 2097152u));
            let _e148 = (_e147 < arrayLength((&global_4.member)));
            if _e148 {
                let _e149 = (_e147 < arrayLength((&global_5.member)));
                if _e149 {
                    if _e148 {
                    } else {
                        break;
                    }
                    let _e157 = global_4.member[_e147].member_2[0u];
                    let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                    let _e164 = global_4.member[_e147].member_2[1u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_4.member[_e147].member_2[2u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_4.member[_e147].member[0u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_4.member[_e147].member[1u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e192 = global_4.member[_e147].member[2u];
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e196 = select(_e166, _e159, (_e166 < _e159));
                    let _e198 = select(_e173, _e196, (_e173 < _e196));
                    let _e200 = select(_e180, _e198, (_e180 < _e198));
                    let _e202 = select(_e187, _e200, (_e187 < _e200));
                    let _e204 = select(_e194, _e202, (_e194 < _e202));
                    let _e208 = global_4.member[_e147].member_1;
                    let _e210 = (bitcast<u32>(_e208) & 2147483647u);
                    let _e217 = global_4.member[_e147].member_3;
                    let _e223 = (((select(_e210, _e204, (_e210 < _e204)) < 2139095040u) && ((bitcast<u32>(_e217) & 2147483647u) <= 2139095040u)) && (_e198 > 0u));
                    if _e223 {
                        let _e226 = (bitcast<u32>(bitcast<f32>(_e198)) & 2147483647u);
                        if (_e226 >= 8388608u) {
                            phi_382_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_382_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                        }
                        let _e240 = phi_382_;
                        phi_383_ = _e240;
                    } else {
                        phi_383_ = 0i;
                    }
                    let _e242 = phi_383_;
                    let _e243 = (_e159 == _e198);
                    if _e243 {
                        phi_393_ = true;
                    } else {
                        phi_393_ = (_e166 == _e198);
                    }
                    let _e246 = phi_393_;
                    let _e247 = select(1u, 0u, _e243);
                    if _e246 {
                        let _e248 = (_e247 + 1u);
                        phi_403_ = _e248;
                        phi_404_ = _e248;
                        phi_406_ = select(true, false, (_e248 == 2u));
                    } else {
                        phi_403_ = u32();
                        phi_404_ = 0u;
                        phi_406_ = true;
                    }
                    let _e252 = phi_403_;
                    let _e254 = phi_404_;
                    let _e256 = phi_406_;
                    if _e256 {
                        phi_411_ = (_e254 + 1u);
                    } else {
                        phi_411_ = 0u;
                    }
                    let _e260 = phi_411_;
                    let _e261 = select(_e252, _e254, _e256);
                    let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                    if (_e129 < -126i) {
                        phi_423_ = -126i;
                    } else {
                        phi_423_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e267 = phi_423_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e129 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = -(_e242);
                    if (_e279 < -126i) {
                        phi_443_ = -126i;
                    } else {
                        phi_443_ = select(_e279, 127i, (_e279 > 127i));
                    }
                    let _e284 = phi_443_;
                    let _e289 = bitcast<f32>((bitcast<u32>((_e284 + 127i)) << bitcast<u32>(23i)));
                    let _e295 = bitcast<f32>((bitcast<u32>(((_e279 - _e284) + 127i)) << bitcast<u32>(23i)));
                    let _e299 = global_4.member[_e147].member;
                    let _e300 = (_e261 == 0u);
                    if _e300 {
                        phi_461_ = _e299[0];
                    } else {
                        phi_461_ = _e299[1];
                    }
                    let _e304 = phi_461_;
                    let _e305 = (_e261 == 2u);
                    if _e305 {
                        phi_467_ = _e299[2];
                    } else {
                        phi_467_ = _e304;
                    }
                    let _e308 = phi_467_;
                    let _e310 = ((_e308 * _e272) * _e278);
                    let _e311 = global_4.member[_e147].member_2;
                    if _e300 {
                        phi_478_ = _e311[0];
                    } else {
                        phi_478_ = _e311[1];
                    }
                    let _e315 = phi_478_;
                    if _e305 {
                        phi_484_ = _e311[2];
                    } else {
                        phi_484_ = _e315;
                    }
                    let _e318 = phi_484_;
                    let _e320 = ((_e318 * _e289) * _e295);
                    let _e324 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e324 {
                        let _e328 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) * 0.00000011920929f);
                        phi_507_ = select(0.00000000000011368684f, _e328, (_e328 > 0.00000000000011368684f));
                    } else {
                        phi_507_ = 0f;
                    }
                    let _e332 = phi_507_;
                    let _e333 = (_e310 + _e332);
                    let _e334 = (_e310 - _e332);
                    let _e335 = select(_e320, 0f, _e324);
                    if _e324 {
                        phi_518_ = 38685626000000000000000000f;
                    } else {
                        phi_518_ = (1f / _e320);
                    }
                    let _e338 = phi_518_;
                    let _e339 = (_e260 == 0u);
                    if _e339 {
                        phi_527_ = _e299[0];
                    } else {
                        phi_527_ = _e299[1];
                    }
                    let _e343 = phi_527_;
                    let _e344 = (_e260 == 2u);
                    if _e344 {
                        phi_533_ = _e299[2];
                    } else {
                        phi_533_ = _e343;
                    }
                    let _e347 = phi_533_;
                    let _e349 = ((_e347 * _e272) * _e278);
                    if _e339 {
                        phi_544_ = _e311[0];
                    } else {
                        phi_544_ = _e311[1];
                    }
                    let _e353 = phi_544_;
                    if _e344 {
                        phi_550_ = _e311[2];
                    } else {
                        phi_550_ = _e353;
                    }
                    let _e356 = phi_550_;
                    let _e358 = ((_e356 * _e289) * _e295);
                    let _e362 = (bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e362 {
                        let _e366 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) * 0.00000011920929f);
                        phi_573_ = select(0.00000000000011368684f, _e366, (_e366 > 0.00000000000011368684f));
                    } else {
                        phi_573_ = 0f;
                    }
                    let _e370 = phi_573_;
                    let _e371 = (_e349 + _e370);
                    let _e372 = (_e349 - _e370);
                    let _e373 = select(_e358, 0f, _e362);
                    if _e362 {
                        phi_584_ = 38685626000000000000000000f;
                    } else {
                        phi_584_ = (1f / _e358);
                    }
                    let _e376 = phi_584_;
                    let _e377 = (_e262 == 0u);
                    if _e377 {
                        phi_593_ = _e299[0];
                    } else {
                        phi_593_ = _e299[1];
                    }
                    let _e381 = phi_593_;
                    let _e382 = (_e262 == 2u);
                    if _e382 {
                        phi_599_ = _e299[2];
                    } else {
                        phi_599_ = _e381;
                    }
                    let _e385 = phi_599_;
                    let _e387 = ((_e385 * _e272) * _e278);
                    if _e377 {
                        phi_610_ = _e311[0];
                    } else {
                        phi_610_ = _e311[1];
                    }
                    let _e391 = phi_610_;
                    if _e382 {
                        phi_616_ = _e311[2];
                    } else {
                        phi_616_ = _e391;
                    }
                    let _e394 = phi_616_;
                    let _e396 = ((_e394 * _e289) * _e295);
                    let _e400 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e400 {
                        let _e404 = (bitcast<f32>((bitcast<u32>(_e387) & 2147483647u)) * 0.00000011920929f);
                        phi_639_ = select(0.00000000000011368684f, _e404, (_e404 > 0.00000000000011368684f));
                    } else {
                        phi_639_ = 0f;
                    }
                    let _e408 = phi_639_;
                    let _e409 = (_e387 + _e408);
                    let _e410 = (_e387 - _e408);
                    let _e411 = select(_e396, 0f, _e400);
                    if _e400 {
                        phi_650_ = 38685626000000000000000000f;
                    } else {
                        phi_650_ = (1f / _e396);
                    }
                    let _e414 = phi_650_;
                    let _e417 = bitcast<f32>((bitcast<u32>(_e310) & 2147483647u));
                    let _e420 = bitcast<f32>((bitcast<u32>(_e349) & 2147483647u));
                    let _e422 = select(_e420, _e417, (_e417 > _e420));
                    let _e425 = bitcast<f32>((bitcast<u32>(_e387) & 2147483647u));
                    let _e428 = (_e129 + _e242);
                    if (_e223 && (select(_e425, _e422, (_e422 > _e425)) <= 1099511600000f)) {
                        let _e431 = (_e428 / 3i);
                        let _e438 = bitcast<f32>((bitcast<u32>((_e431 + 127i)) << bitcast<u32>(23i)));
                        let _e445 = bitcast<f32>((bitcast<u32>(((_e428 - (2i * _e431)) + 127i)) << bitcast<u32>(23i)));
                        let _e446 = (((_e208 * _e438) * _e438) * _e445);
                        let _e448 = select(340282350000000000000000000000000000000f, _e446, (_e446 < 340282350000000000000000000000000000000f));
                        let _e453 = (((_e217 * _e438) * _e438) * _e445);
                        let _e455 = select(340282350000000000000000000000000000000f, _e453, (_e453 < 340282350000000000000000000000000000000f));
                        phi_750_ = select(-340282350000000000000000000000000000000f, _e455, (_e455 > -340282350000000000000000000000000000000f));
                        phi_751_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_750_ = 0f;
                        phi_751_ = 1f;
                    }
                    let _e459 = phi_750_;
                    let _e461 = phi_751_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e465 = (_e261 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_1[_e465];
                    let _e471 = (_e260 % 3u);
                    let _e472 = (_e471 < 3u);
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e474 = local_1[_e471];
                    let _e477 = (_e262 % 3u);
                    let _e478 = (_e477 < 3u);
                    if _e478 {
                    } else {
                        break;
                    }
                    let _e480 = local_1[_e477];
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e485 = local[_e465];
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e489 = local[_e471];
                    if _e478 {
                    } else {
                        break;
                    }
                    let _e493 = local[_e477];
                    phi_3739_ = false;
                    phi_840_ = type_38(_e459, false);
                    phi_843_ = type_45(type_28(vec4<f32>((f32(_e468) * _e141), (f32(_e474) * _e141), (f32(_e480) * _e141), 0f), vec4<f32>((f32(_e485) * _e141), (f32(_e489) * _e141), (f32(_e493) * _e141), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_845_ = ((3u * _e90) + 1u);
                    phi_847_ = (_e461 <= _e459);
                    phi_849_ = 0u;
                    loop {
                        let _e503 = phi_3739_;
                        let _e505 = phi_840_;
                        let _e507 = phi_843_;
                        let _e509 = phi_845_;
                        let _e511 = phi_847_;
                        let _e513 = phi_849_;
                        local_11 = _e505;
                        if _e511 {
                            phi_860_ = true;
                        } else {
                            phi_860_ = (_e513 > 0u);
                        }
                        let _e516 = phi_860_;
                        if _e516 {
                            let _e517 = (_e509 > 0u);
                            if _e517 {
                                if _e511 {
                                    phi_946_ = _e507;
                                    phi_947_ = _e511;
                                    phi_948_ = _e513;
                                } else {
                                    let _e518 = (_e513 - 1u);
                                    let _e519 = (_e518 % 128u);
                                    let _e520 = (_e519 < 128u);
                                    if _e520 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e522 = local_7[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e524 = local_6[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e526 = local_5[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e528 = local_4[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e530 = local_3[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e532 = local_2[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e537 = local_8[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e540 = local_9[_e519];
                                    phi_946_ = type_45(type_28(vec4<f32>(_e522, _e524, _e526, 0f), vec4<f32>(_e528, _e530, _e532, 0f)), _e537);
                                    phi_947_ = (_e540 <= _e505.member);
                                    phi_948_ = _e518;
                                }
                                let _e544 = phi_946_;
                                let _e546 = phi_947_;
                                let _e548 = phi_948_;
                                if _e546 {
                                    let _e553 = (_e544.member_1 & 268435455u);
                                    if ((_e544.member_1 & 2147483648u) != 0u) {
                                        phi_967_ = _e505;
                                        phi_970_ = type_8(0u, ((_e544.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1013 = phi_967_;
                                            let _e1015 = phi_970_;
                                            local_10 = _e1013;
                                            local_12 = _e1013;
                                            if (_e1015.member < _e1015.member_1) {
                                                phi_971_ = type_8((_e1015.member + 1u), _e1015.member_1);
                                                phi_993_ = type_8(1u, _e1015.member);
                                            } else {
                                                phi_971_ = _e1015;
                                                phi_993_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1028 = phi_971_;
                                            let _e1030 = phi_993_;
                                            let _e1034 = (bitcast<i32>(_e1030.member) != 0i);
                                            if _e1034 {
                                                let _e1039 = (_e544.member.member_1.x - _e544.member.member.x);
                                                let _e1042 = (_e544.member.member_1.y - _e544.member.member.y);
                                                let _e1045 = (_e544.member.member_1.z - _e544.member.member.z);
                                                let _e1047 = select(_e1042, _e1039, (_e1039 > _e1042));
                                                let _e1049 = select(_e1045, _e1047, (_e1047 > _e1045));
                                                let _e1051 = (_e1049 < (1024f * _e141));
                                                if _e1051 {
                                                    phi_1034_ = 0u;
                                                } else {
                                                    phi_1034_ = select(2u, 1u, (_e1049 < (2097152f * _e141)));
                                                }
                                                let _e1056 = phi_1034_;
                                                switch bitcast<i32>(_e1056) {
                                                    case 0: {
                                                        phi_1040_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1040_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1040_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1040_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1059 = phi_1040_;
                                                switch bitcast<i32>(_e1056) {
                                                    case 0: {
                                                        phi_1050_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1050_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1050_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1050_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1066 = phi_1050_;
                                                let _e1068 = ((_e553 + (_e1030.member_1 * ((3u * _e1059) + 1u))) + (3u * _e1066));
                                                let _e1069 = (_e1068 < _e93);
                                                if _e1069 {
                                                    if _e1069 {
                                                    } else {
                                                        phi_3733_ = true;
                                                        break;
                                                    }
                                                    let _e1071 = global_6.member[_e1068];
                                                    phi_1066_ = _e1071;
                                                } else {
                                                    phi_1066_ = 4294967295u;
                                                }
                                                let _e1073 = phi_1066_;
                                                if _e1051 {
                                                    phi_1099_ = 0u;
                                                } else {
                                                    phi_1099_ = select(2u, 1u, (_e1049 < (2097152f * _e141)));
                                                }
                                                let _e1078 = phi_1099_;
                                                switch bitcast<i32>(_e1078) {
                                                    case 0: {
                                                        phi_1105_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1105_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1105_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1105_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1081 = phi_1105_;
                                                let _e1085 = (_e553 + (_e1030.member_1 * ((3u * _e1081) + 1u)));
                                                switch bitcast<i32>(_e1078) {
                                                    case 0: {
                                                        let _e1351 = (_e1085 < _e93);
                                                        if _e1351 {
                                                            if _e1351 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1353 = global_6.member[_e1085];
                                                            phi_1129_ = _e1353;
                                                        } else {
                                                            phi_1129_ = 0u;
                                                        }
                                                        let _e1355 = phi_1129_;
                                                        let _e1357 = ((10u * _e261) & 31u);
                                                        let _e1366 = ((10u * _e260) & 31u);
                                                        let _e1375 = ((10u * _e262) & 31u);
                                                        let _e1384 = (_e1085 + 1u);
                                                        let _e1385 = (_e1384 < _e93);
                                                        if _e1385 {
                                                            if _e1385 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1387 = global_6.member[_e1384];
                                                            phi_1172_ = _e1387;
                                                        } else {
                                                            phi_1172_ = 0u;
                                                        }
                                                        let _e1389 = phi_1172_;
                                                        let _e1412 = (_e1085 + 2u);
                                                        let _e1413 = (_e1412 < _e93);
                                                        if _e1413 {
                                                            if _e1413 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1415 = global_6.member[_e1412];
                                                            phi_1215_ = _e1415;
                                                        } else {
                                                            phi_1215_ = 0u;
                                                        }
                                                        let _e1417 = phi_1215_;
                                                        phi_1686_ = array<array<f32, 3>, 3>(array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1355 >> bitcast<u32>(_e1357)) & 1023u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1355 >> bitcast<u32>(_e1366)) & 1023u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1355 >> bitcast<u32>(_e1375)) & 1023u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1389 >> bitcast<u32>(_e1357)) & 1023u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1389 >> bitcast<u32>(_e1366)) & 1023u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1389 >> bitcast<u32>(_e1375)) & 1023u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1417 >> bitcast<u32>(_e1357)) & 1023u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1417 >> bitcast<u32>(_e1366)) & 1023u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1417 >> bitcast<u32>(_e1375)) & 1023u))) * _e141))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1174 = (_e1085 < _e93);
                                                        if _e1174 {
                                                            if _e1174 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1176 = global_6.member[_e1085];
                                                            phi_1258_ = _e1176;
                                                        } else {
                                                            phi_1258_ = 0u;
                                                        }
                                                        let _e1178 = phi_1258_;
                                                        let _e1179 = (_e1085 + 1u);
                                                        let _e1180 = (_e1179 < _e93);
                                                        if _e1180 {
                                                            if _e1180 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1182 = global_6.member[_e1179];
                                                            phi_1273_ = _e1182;
                                                        } else {
                                                            phi_1273_ = 0u;
                                                        }
                                                        let _e1184 = phi_1273_;
                                                        let _e1185 = (_e261 == 1u);
                                                        if _e1185 {
                                                            phi_1283_ = ((_e1178 >> bitcast<u32>(21i)) | (_e1184 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1283_ = (_e1184 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1194 = phi_1283_;
                                                        let _e1201 = (_e260 == 1u);
                                                        if _e1201 {
                                                            phi_1303_ = ((_e1178 >> bitcast<u32>(21i)) | (_e1184 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1303_ = (_e1184 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1210 = phi_1303_;
                                                        let _e1217 = (_e262 == 1u);
                                                        if _e1217 {
                                                            phi_1323_ = ((_e1178 >> bitcast<u32>(21i)) | (_e1184 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1323_ = (_e1184 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1226 = phi_1323_;
                                                        let _e1234 = (_e1085 + 2u);
                                                        let _e1235 = (_e1234 < _e93);
                                                        if _e1235 {
                                                            if _e1235 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1237 = global_6.member[_e1234];
                                                            phi_1349_ = _e1237;
                                                        } else {
                                                            phi_1349_ = 0u;
                                                        }
                                                        let _e1239 = phi_1349_;
                                                        let _e1240 = (_e1085 + 3u);
                                                        let _e1241 = (_e1240 < _e93);
                                                        if _e1241 {
                                                            if _e1241 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1243 = global_6.member[_e1240];
                                                            phi_1364_ = _e1243;
                                                        } else {
                                                            phi_1364_ = 0u;
                                                        }
                                                        let _e1245 = phi_1364_;
                                                        if _e1185 {
                                                            phi_1374_ = ((_e1239 >> bitcast<u32>(21i)) | (_e1245 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1374_ = (_e1245 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1254 = phi_1374_;
                                                        if _e1201 {
                                                            phi_1394_ = ((_e1239 >> bitcast<u32>(21i)) | (_e1245 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1394_ = (_e1245 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1269 = phi_1394_;
                                                        if _e1217 {
                                                            phi_1414_ = ((_e1239 >> bitcast<u32>(21i)) | (_e1245 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1414_ = (_e1245 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1284 = phi_1414_;
                                                        let _e1292 = (_e1085 + 4u);
                                                        let _e1293 = (_e1292 < _e93);
                                                        if _e1293 {
                                                            if _e1293 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1295 = global_6.member[_e1292];
                                                            phi_1440_ = _e1295;
                                                        } else {
                                                            phi_1440_ = 0u;
                                                        }
                                                        let _e1297 = phi_1440_;
                                                        let _e1298 = (_e1085 + 5u);
                                                        let _e1299 = (_e1298 < _e93);
                                                        if _e1299 {
                                                            if _e1299 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1301 = global_6.member[_e1298];
                                                            phi_1455_ = _e1301;
                                                        } else {
                                                            phi_1455_ = 0u;
                                                        }
                                                        let _e1303 = phi_1455_;
                                                        if _e1185 {
                                                            phi_1465_ = ((_e1297 >> bitcast<u32>(21i)) | (_e1303 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1465_ = (_e1303 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1312 = phi_1465_;
                                                        if _e1201 {
                                                            phi_1485_ = ((_e1297 >> bitcast<u32>(21i)) | (_e1303 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1485_ = (_e1303 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1327 = phi_1485_;
                                                        if _e1217 {
                                                            phi_1505_ = ((_e1297 >> bitcast<u32>(21i)) | (_e1303 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1505_ = (_e1303 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1342 = phi_1505_;
                                                        phi_1686_ = array<array<f32, 3>, 3>(array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1194, _e1178, _e300) & 2097151u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1210, _e1178, _e339) & 2097151u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1226, _e1178, _e377) & 2097151u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1254, _e1239, _e300) & 2097151u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1269, _e1239, _e339) & 2097151u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1284, _e1239, _e377) & 2097151u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1312, _e1297, _e300) & 2097151u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1327, _e1297, _e339) & 2097151u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1342, _e1297, _e377) & 2097151u))) * _e141))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1087 = (_e1085 + _e261);
                                                        let _e1088 = (_e1087 < _e93);
                                                        if _e1088 {
                                                            if _e1088 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1090 = global_6.member[_e1087];
                                                            phi_1532_ = _e1090;
                                                        } else {
                                                            phi_1532_ = 0u;
                                                        }
                                                        let _e1092 = phi_1532_;
                                                        let _e1096 = (_e1085 + _e260);
                                                        let _e1097 = (_e1096 < _e93);
                                                        if _e1097 {
                                                            if _e1097 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1099 = global_6.member[_e1096];
                                                            phi_1550_ = _e1099;
                                                        } else {
                                                            phi_1550_ = 0u;
                                                        }
                                                        let _e1101 = phi_1550_;
                                                        let _e1105 = (_e1085 + _e262);
                                                        let _e1106 = (_e1105 < _e93);
                                                        if _e1106 {
                                                            if _e1106 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1108 = global_6.member[_e1105];
                                                            phi_1568_ = _e1108;
                                                        } else {
                                                            phi_1568_ = 0u;
                                                        }
                                                        let _e1110 = phi_1568_;
                                                        let _e1115 = (_e1085 + 3u);
                                                        let _e1116 = (_e1115 + _e261);
                                                        let _e1117 = (_e1116 < _e93);
                                                        if _e1117 {
                                                            if _e1117 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1119 = global_6.member[_e1116];
                                                            phi_1588_ = _e1119;
                                                        } else {
                                                            phi_1588_ = 0u;
                                                        }
                                                        let _e1121 = phi_1588_;
                                                        let _e1125 = (_e1115 + _e260);
                                                        let _e1126 = (_e1125 < _e93);
                                                        if _e1126 {
                                                            if _e1126 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1128 = global_6.member[_e1125];
                                                            phi_1606_ = _e1128;
                                                        } else {
                                                            phi_1606_ = 0u;
                                                        }
                                                        let _e1130 = phi_1606_;
                                                        let _e1134 = (_e1115 + _e262);
                                                        let _e1135 = (_e1134 < _e93);
                                                        if _e1135 {
                                                            if _e1135 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1137 = global_6.member[_e1134];
                                                            phi_1624_ = _e1137;
                                                        } else {
                                                            phi_1624_ = 0u;
                                                        }
                                                        let _e1139 = phi_1624_;
                                                        let _e1144 = (_e1085 + 6u);
                                                        let _e1145 = (_e1144 + _e261);
                                                        let _e1146 = (_e1145 < _e93);
                                                        if _e1146 {
                                                            if _e1146 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1148 = global_6.member[_e1145];
                                                            phi_1644_ = _e1148;
                                                        } else {
                                                            phi_1644_ = 0u;
                                                        }
                                                        let _e1150 = phi_1644_;
                                                        let _e1154 = (_e1144 + _e260);
                                                        let _e1155 = (_e1154 < _e93);
                                                        if _e1155 {
                                                            if _e1155 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1157 = global_6.member[_e1154];
                                                            phi_1662_ = _e1157;
                                                        } else {
                                                            phi_1662_ = 0u;
                                                        }
                                                        let _e1159 = phi_1662_;
                                                        let _e1163 = (_e1144 + _e262);
                                                        let _e1164 = (_e1163 < _e93);
                                                        if _e1164 {
                                                            if _e1164 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1166 = global_6.member[_e1163];
                                                            phi_1680_ = _e1166;
                                                        } else {
                                                            phi_1680_ = 0u;
                                                        }
                                                        let _e1168 = phi_1680_;
                                                        phi_1686_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1092)) * _e141), (f32(bitcast<i32>(_e1101)) * _e141), (f32(bitcast<i32>(_e1110)) * _e141)), array<f32, 3>((f32(bitcast<i32>(_e1121)) * _e141), (f32(bitcast<i32>(_e1130)) * _e141), (f32(bitcast<i32>(_e1139)) * _e141)), array<f32, 3>((f32(bitcast<i32>(_e1150)) * _e141), (f32(bitcast<i32>(_e1159)) * _e141), (f32(bitcast<i32>(_e1168)) * _e141)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1686_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1442 = phi_1686_;
                                                let _e1450 = (_e1442[0][2] - _e387);
                                                let _e1453 = (((_e1442[0][0] - _e310) * _e411) - (_e1450 * _e335));
                                                let _e1456 = (((_e1442[0][1] - _e349) * _e411) - (_e1450 * _e373));
                                                let _e1463 = (_e1442[1][2] - _e387);
                                                let _e1466 = (((_e1442[1][0] - _e310) * _e411) - (_e1463 * _e335));
                                                let _e1469 = (((_e1442[1][1] - _e349) * _e411) - (_e1463 * _e373));
                                                let _e1476 = (_e1442[2][2] - _e387);
                                                let _e1479 = (((_e1442[2][0] - _e310) * _e411) - (_e1476 * _e335));
                                                let _e1482 = (((_e1442[2][1] - _e349) * _e411) - (_e1476 * _e373));
                                                let _e1483 = (_e1479 * _e1469);
                                                let _e1484 = (_e1482 * _e1466);
                                                let _e1485 = (_e1453 * _e1482);
                                                let _e1486 = (_e1456 * _e1479);
                                                let _e1487 = (_e1466 * _e1456);
                                                let _e1488 = (_e1469 * _e1453);
                                                let _e1493 = (((_e1483 >= _e1484) && (_e1485 >= _e1486)) && (_e1487 >= _e1488));
                                                if (_e1493 || (((_e1483 <= _e1484) && (_e1485 <= _e1486)) && (_e1487 <= _e1488))) {
                                                    let _e1500 = select(-1f, 1f, _e1493);
                                                    let _e1502 = ((_e1483 - _e1484) * _e1500);
                                                    let _e1504 = select(0f, _e1502, (_e1502 > 0f));
                                                    let _e1506 = ((_e1485 - _e1486) * _e1500);
                                                    let _e1508 = select(0f, _e1506, (_e1506 > 0f));
                                                    let _e1510 = ((_e1487 - _e1488) * _e1500);
                                                    let _e1512 = select(0f, _e1510, (_e1510 > 0f));
                                                    let _e1514 = ((_e1504 + _e1508) + _e1512);
                                                    if (_e1514 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2252_ = type_24();
                                                        phi_2253_ = true;
                                                    } else {
                                                        let _e1517 = select(_e1442[1][0], _e1442[0][0], (_e1442[0][0] < _e1442[1][0]));
                                                        let _e1521 = select(_e1442[1][0], _e1442[0][0], (_e1442[0][0] > _e1442[1][0]));
                                                        let _e1525 = select(_e1442[1][1], _e1442[0][1], (_e1442[0][1] < _e1442[1][1]));
                                                        let _e1529 = select(_e1442[1][1], _e1442[0][1], (_e1442[0][1] > _e1442[1][1]));
                                                        let _e1533 = select(_e1442[1][2], _e1442[0][2], (_e1442[0][2] < _e1442[1][2]));
                                                        let _e1537 = select(_e1442[1][2], _e1442[0][2], (_e1442[0][2] > _e1442[1][2]));
                                                        let _e1542 = ((select(_e1442[2][0], _e1517, (_e1517 < _e1442[2][0])) - _e333) * _e338);
                                                        let _e1543 = ((select(_e1442[2][0], _e1521, (_e1521 > _e1442[2][0])) - _e334) * _e338);
                                                        let _e1546 = ((select(_e1442[2][1], _e1525, (_e1525 < _e1442[2][1])) - _e371) * _e376);
                                                        let _e1547 = ((select(_e1442[2][1], _e1529, (_e1529 > _e1442[2][1])) - _e372) * _e376);
                                                        let _e1550 = ((select(_e1442[2][2], _e1533, (_e1533 < _e1442[2][2])) - _e409) * _e414);
                                                        let _e1551 = ((select(_e1442[2][2], _e1537, (_e1537 > _e1442[2][2])) - _e410) * _e414);
                                                        let _e1553 = select(_e1551, _e1550, (_e1550 < _e1551));
                                                        let _e1555 = select(_e1551, _e1550, (_e1550 > _e1551));
                                                        let _e1557 = select(_e1543, _e1542, (_e1542 < _e1543));
                                                        let _e1559 = select(_e1547, _e1546, (_e1546 < _e1547));
                                                        let _e1561 = select(_e1559, _e1557, (_e1557 > _e1559));
                                                        let _e1563 = select(_e1553, _e1561, (_e1561 > _e1553));
                                                        let _e1565 = select(_e1543, _e1542, (_e1542 > _e1543));
                                                        let _e1567 = select(_e1547, _e1546, (_e1546 > _e1547));
                                                        let _e1569 = select(_e1567, _e1565, (_e1565 < _e1567));
                                                        let _e1571 = select(_e1555, _e1569, (_e1569 < _e1555));
                                                        let _e1572 = -(_e1553);
                                                        let _e1578 = select(_e461, _e1563, (_e1563 > _e461));
                                                        if (_e1578 > (_e1571 + (select(_e1572, _e1555, (_e1555 > _e1572)) * 0.0000019073523f))) {
                                                            phi_2247_ = type_24();
                                                            phi_2248_ = true;
                                                        } else {
                                                            let _e1580 = (_e1578 > _e1013.member);
                                                            if _e1580 {
                                                                phi_2246_ = type_24();
                                                            } else {
                                                                let _e1584 = (_e1442[1][0] - _e1442[0][0]);
                                                                let _e1585 = (_e1442[1][1] - _e1442[0][1]);
                                                                let _e1586 = (_e1442[1][2] - _e1442[0][2]);
                                                                let _e1587 = vec3<f32>(_e1584, _e1585, _e1586);
                                                                let _e1588 = (_e1442[2][0] - _e1442[1][0]);
                                                                let _e1589 = (_e1442[2][1] - _e1442[1][1]);
                                                                let _e1590 = (_e1442[2][2] - _e1442[1][2]);
                                                                let _e1591 = vec3<f32>(_e1588, _e1589, _e1590);
                                                                let _e1592 = (_e1442[0][0] - _e1442[2][0]);
                                                                let _e1593 = (_e1442[0][1] - _e1442[2][1]);
                                                                let _e1594 = (_e1442[0][2] - _e1442[2][2]);
                                                                let _e1595 = vec3<f32>(_e1592, _e1593, _e1594);
                                                                let _e1598 = bitcast<f32>((bitcast<u32>(_e1584) & 2147483647u));
                                                                let _e1601 = bitcast<f32>((bitcast<u32>(_e1585) & 2147483647u));
                                                                let _e1603 = select(_e1601, _e1598, (_e1598 > _e1601));
                                                                let _e1606 = bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u));
                                                                let _e1608 = select(_e1606, _e1603, (_e1603 > _e1606));
                                                                let _e1611 = bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u));
                                                                let _e1614 = bitcast<f32>((bitcast<u32>(_e1589) & 2147483647u));
                                                                let _e1616 = select(_e1614, _e1611, (_e1611 > _e1614));
                                                                let _e1619 = bitcast<f32>((bitcast<u32>(_e1590) & 2147483647u));
                                                                let _e1621 = select(_e1619, _e1616, (_e1616 > _e1619));
                                                                let _e1624 = bitcast<f32>((bitcast<u32>(_e1592) & 2147483647u));
                                                                let _e1627 = bitcast<f32>((bitcast<u32>(_e1593) & 2147483647u));
                                                                let _e1629 = select(_e1627, _e1624, (_e1624 > _e1627));
                                                                let _e1632 = bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u));
                                                                let _e1634 = select(_e1632, _e1629, (_e1629 > _e1632));
                                                                let _e1636 = select(_e1621, _e1608, (_e1608 > _e1621));
                                                                let _e1638 = select(_e1634, _e1636, (_e1636 > _e1634));
                                                                if (_e1608 == _e1638) {
                                                                    phi_2157_ = _e1591;
                                                                    phi_2158_ = _e1595;
                                                                } else {
                                                                    let _e1641 = vec3((_e1621 == _e1638));
                                                                    phi_2157_ = select(_e1587, _e1595, _e1641);
                                                                    phi_2158_ = select(_e1591, _e1587, _e1641);
                                                                }
                                                                let _e1645 = phi_2157_;
                                                                let _e1647 = phi_2158_;
                                                                let _e1654 = ((_e1645.y * _e1647.z) - (_e1647.y * _e1645.z));
                                                                let _e1659 = ((_e1645.z * _e1647.x) - (_e1647.z * _e1645.x));
                                                                let _e1662 = ((_e1645.x * _e1647.y) - (_e1647.x * _e1645.y));
                                                                if (_e1504 >= _e1508) {
                                                                    phi_2189_ = select(true, false, (_e1504 >= _e1512));
                                                                } else {
                                                                    phi_2189_ = true;
                                                                }
                                                                let _e1667 = phi_2189_;
                                                                if _e1667 {
                                                                    phi_2198_ = select(vec3<f32>(_e1442[2][0], _e1442[2][1], _e1442[2][2]), vec3<f32>(_e1442[1][0], _e1442[1][1], _e1442[1][2]), vec3((_e1508 >= _e1512)));
                                                                } else {
                                                                    phi_2198_ = vec3<f32>(_e1442[0][0], _e1442[0][1], _e1442[0][2]);
                                                                }
                                                                let _e1672 = phi_2198_;
                                                                let _e1689 = ((((_e1654 * (_e1672.x - _e310)) + (_e1659 * (_e1672.y - _e349))) + (_e1662 * (_e1672.z - _e387))) / (((_e1654 * _e335) + (_e1659 * _e373)) + (_e1662 * _e411)));
                                                                let _e1691 = select(_e1571, _e1689, (_e1689 < _e1571));
                                                                let _e1693 = select(_e1563, _e1691, (_e1691 > _e1563));
                                                                if (_e1693 >= _e461) {
                                                                    let _e1695 = (_e1693 <= _e1013.member);
                                                                    if _e1695 {
                                                                        let _e1696 = (1f / _e1514);
                                                                        phi_2238_ = type_24(_e1693, (_e1508 * _e1696), (_e1512 * _e1696), _e1073);
                                                                    } else {
                                                                        phi_2238_ = type_24();
                                                                    }
                                                                    let _e1701 = phi_2238_;
                                                                    phi_2240_ = _e1701;
                                                                    phi_2241_ = select(true, false, _e1695);
                                                                } else {
                                                                    phi_2240_ = type_24();
                                                                    phi_2241_ = true;
                                                                }
                                                                let _e1704 = phi_2240_;
                                                                let _e1706 = phi_2241_;
                                                                if _e1706 {
                                                                    phi_2245_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2245_ = _e1704;
                                                                }
                                                                let _e1708 = phi_2245_;
                                                                phi_2246_ = _e1708;
                                                            }
                                                            let _e1710 = phi_2246_;
                                                            phi_2247_ = _e1710;
                                                            phi_2248_ = _e1580;
                                                        }
                                                        let _e1712 = phi_2247_;
                                                        let _e1714 = phi_2248_;
                                                        phi_2252_ = _e1712;
                                                        phi_2253_ = _e1714;
                                                    }
                                                    let _e1716 = phi_2252_;
                                                    let _e1718 = phi_2253_;
                                                    phi_2257_ = _e1716;
                                                    phi_2258_ = _e1718;
                                                } else {
                                                    phi_2257_ = type_24();
                                                    phi_2258_ = true;
                                                }
                                                let _e1720 = phi_2257_;
                                                let _e1722 = phi_2258_;
                                                if _e1722 {
                                                    phi_2262_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2262_ = _e1720;
                                                }
                                                let _e1724 = phi_2262_;
                                                if (_e1724.member_3 != 4294967295u) {
                                                    if (_e1073 != 4294967295u) {
                                                        phi_2273_ = type_38(_e1013.member, true);
                                                    } else {
                                                        phi_2273_ = _e1013;
                                                    }
                                                    let _e1732 = phi_2273_;
                                                    phi_2274_ = _e1732;
                                                } else {
                                                    phi_2274_ = _e1013;
                                                }
                                                let _e1734 = phi_2274_;
                                                phi_968_ = _e1734;
                                            } else {
                                                phi_968_ = type_38();
                                            }
                                            let _e1736 = phi_968_;
                                            continue;
                                            continuing {
                                                phi_967_ = _e1736;
                                                phi_970_ = _e1028;
                                                phi_3733_ = _e503;
                                                break if !(_e1034);
                                            }
                                        }
                                        let _e1739 = phi_3733_;
                                        phi_3891_ = _e1739;
                                        if _e1739 {
                                            break;
                                        }
                                        let _e1741 = local_10;
                                        phi_3895_ = _e1739;
                                        let _e1922 = local_12;
                                        phi_3515_ = _e1922;
                                        phi_3516_ = _e544;
                                        phi_3517_ = false;
                                        phi_3518_ = select(_e548, 0u, _e1741.member_1);
                                    } else {
                                        if (_e544.member_1 >= _e90) {
                                            phi_3071_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e544.member_1 < _e90) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e561 = ((1u + _e261) % 4u);
                                            if (_e561 < 4u) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e566 = global_3.member[_e544.member_1][_e561];
                                            let _e568 = (_e566 >> bitcast<u32>(11u));
                                            let _e570 = ((1u + _e260) % 4u);
                                            if (_e570 < 4u) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e575 = global_3.member[_e544.member_1][_e570];
                                            let _e577 = (_e575 >> bitcast<u32>(11u));
                                            let _e579 = ((1u + _e262) % 4u);
                                            if (_e579 < 4u) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e584 = global_3.member[_e544.member_1][_e579];
                                            let _e586 = (_e584 >> bitcast<u32>(11u));
                                            let _e609 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.x - _e544.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e610 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.y - _e544.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.z - _e544.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e613 = select(_e141, _e609, (_e609 > _e141));
                                            let _e615 = select(_e141, _e610, (_e610 > _e141));
                                            let _e617 = select(_e141, _e611, (_e611 > _e141));
                                            let _e642 = bitcast<u32>((f32(bitcast<i32>((_e566 & 1023u))) * _e613));
                                            let _e647 = (bitcast<i32>((_e566 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e650 = bitcast<f32>((_e642 & bitcast<u32>(_e647)));
                                            let _e651 = bitcast<u32>((f32(bitcast<i32>((_e575 & 1023u))) * _e615));
                                            let _e656 = (bitcast<i32>((_e575 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e659 = bitcast<f32>((_e651 & bitcast<u32>(_e656)));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e584 & 1023u))) * _e617));
                                            let _e665 = (bitcast<i32>((_e584 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e672 = bitcast<f32>((_e642 & bitcast<u32>(~(_e647))));
                                            let _e676 = bitcast<f32>((_e651 & bitcast<u32>(~(_e656))));
                                            let _e680 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e681 = bitcast<u32>((f32(bitcast<i32>((_e568 & 1023u))) * _e613));
                                            let _e686 = (bitcast<i32>((_e568 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e689 = bitcast<f32>((_e681 & bitcast<u32>(_e686)));
                                            let _e690 = bitcast<u32>((f32(bitcast<i32>((_e577 & 1023u))) * _e615));
                                            let _e695 = (bitcast<i32>((_e577 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e698 = bitcast<f32>((_e690 & bitcast<u32>(_e695)));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e586 & 1023u))) * _e617));
                                            let _e704 = (bitcast<i32>((_e586 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e711 = bitcast<f32>((_e681 & bitcast<u32>(~(_e686))));
                                            let _e715 = bitcast<f32>((_e690 & bitcast<u32>(~(_e695))));
                                            let _e719 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e720 = (_e544.member.member.x + _e650);
                                            let _e721 = (_e544.member.member.y + _e659);
                                            let _e722 = (_e544.member.member.z + _e668);
                                            let _e725 = (_e544.member.member_1.x - _e689);
                                            let _e726 = (_e544.member.member_1.y - _e698);
                                            let _e727 = (_e544.member.member_1.z - _e707);
                                            let _e746 = (_e725 - _e720);
                                            let _e747 = (_e726 - _e721);
                                            let _e748 = (_e727 - _e722);
                                            let _e750 = select(_e747, _e746, (_e746 > _e747));
                                            let _e752 = select(_e748, _e750, (_e750 > _e748));
                                            if (_e752 < (1024f * _e141)) {
                                                phi_2772_ = 0u;
                                            } else {
                                                phi_2772_ = select(2u, 1u, (_e752 < (2097152f * _e141)));
                                            }
                                            let _e759 = phi_2772_;
                                            switch bitcast<i32>(_e759) {
                                                case 0: {
                                                    phi_2778_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2778_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2778_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2778_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e762 = phi_2778_;
                                            let _e768 = global_3.member[_e544.member_1][0u];
                                            let _e772 = global_3.member[_e544.member_1][1u];
                                            let _e776 = global_3.member[_e544.member_1][2u];
                                            let _e780 = global_3.member[_e544.member_1][3u];
                                            let _e792 = (((_e772 >> bitcast<u32>(22i)) | ((_e776 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e780 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e793 = (_e768 & 268435455u);
                                            let _e794 = (_e792 & 268435455u);
                                            let _e797 = ((_e768 >> bitcast<u32>(28u)) & 7u);
                                            let _e805 = ((_e768 >> bitcast<u32>(31i)) | (((_e792 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e806 = (_e797 != 0u);
                                            if (_e797 == 0u) {
                                                phi_3033_ = _e793;
                                            } else {
                                                if (_e797 == 7u) {
                                                    phi_3032_ = 2147483648u;
                                                } else {
                                                    phi_3032_ = ((2147483648u | (_e797 << bitcast<u32>(28u))) | (_e794 & 268435455u));
                                                }
                                                let _e815 = phi_3032_;
                                                phi_3033_ = _e815;
                                            }
                                            let _e817 = phi_3033_;
                                            if _e806 {
                                                let _e818 = (_e797 != 7u);
                                                if _e818 {
                                                    phi_3043_ = (_e794 + (_e797 * ((3u * _e762) + 1u)));
                                                } else {
                                                    phi_3043_ = u32();
                                                }
                                                let _e822 = phi_3043_;
                                                phi_3045_ = _e822;
                                                phi_3046_ = select(true, false, _e818);
                                            } else {
                                                phi_3045_ = u32();
                                                phi_3046_ = true;
                                            }
                                            let _e825 = phi_3045_;
                                            let _e827 = phi_3046_;
                                            if (_e805 == 0u) {
                                                phi_3067_ = (_e793 + select(0u, 1u, !(_e806)));
                                            } else {
                                                if (_e805 == 7u) {
                                                    phi_3066_ = 2147483648u;
                                                } else {
                                                    phi_3066_ = ((2147483648u | (_e805 << bitcast<u32>(28u))) | (select(_e825, _e794, _e827) & 268435455u));
                                                }
                                                let _e840 = phi_3066_;
                                                phi_3067_ = _e840;
                                            }
                                            let _e842 = phi_3067_;
                                            phi_3071_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e720, (_e544.member.member.x + _e672), _e725, (_e544.member.member_1.x - _e711)), vec4<f32>(_e721, (_e544.member.member.y + _e676), _e726, (_e544.member.member_1.y - _e715)), vec4<f32>(_e722, (_e544.member.member.z + _e680), _e727, (_e544.member.member_1.z - _e719))), type_45(type_28((_e544.member.member + vec4<f32>(_e650, _e659, _e668, 0f)), (_e544.member.member_1 - vec4<f32>(_e689, _e698, _e707, 0f))), _e817), type_45(type_28((_e544.member.member + vec4<f32>(_e672, _e676, _e680, 0f)), (_e544.member.member_1 - vec4<f32>(_e711, _e715, _e719, 0f))), _e842));
                                        }
                                        let _e847 = phi_3071_;
                                        let _e859 = ((_e847.member[0].x - _e333) * _e338);
                                        let _e860 = ((_e847.member[0].y - _e333) * _e338);
                                        let _e861 = ((_e847.member[0].z - _e334) * _e338);
                                        let _e862 = ((_e847.member[0].w - _e334) * _e338);
                                        let _e872 = ((_e847.member[1].x - _e371) * _e376);
                                        let _e873 = ((_e847.member[1].y - _e371) * _e376);
                                        let _e874 = ((_e847.member[1].z - _e372) * _e376);
                                        let _e875 = ((_e847.member[1].w - _e372) * _e376);
                                        let _e885 = ((_e847.member[2].x - _e409) * _e414);
                                        let _e886 = ((_e847.member[2].y - _e409) * _e414);
                                        let _e887 = ((_e847.member[2].z - _e410) * _e414);
                                        let _e888 = ((_e847.member[2].w - _e410) * _e414);
                                        let _e890 = select(_e887, _e885, (_e885 < _e887));
                                        let _e892 = select(_e888, _e886, (_e886 < _e888));
                                        let _e894 = select(_e887, _e885, (_e885 > _e887));
                                        let _e896 = select(_e888, _e886, (_e886 > _e888));
                                        let _e898 = select(_e861, _e859, (_e859 < _e861));
                                        let _e900 = select(_e862, _e860, (_e860 < _e862));
                                        let _e902 = select(_e874, _e872, (_e872 < _e874));
                                        let _e904 = select(_e875, _e873, (_e873 < _e875));
                                        let _e906 = select(_e902, _e898, (_e898 > _e902));
                                        let _e908 = select(_e904, _e900, (_e900 > _e904));
                                        let _e910 = select(_e890, _e906, (_e906 > _e890));
                                        let _e912 = select(_e892, _e908, (_e908 > _e892));
                                        let _e914 = select(_e861, _e859, (_e859 > _e861));
                                        let _e916 = select(_e862, _e860, (_e860 > _e862));
                                        let _e918 = select(_e874, _e872, (_e872 > _e874));
                                        let _e920 = select(_e875, _e873, (_e873 > _e875));
                                        let _e922 = select(_e918, _e914, (_e914 < _e918));
                                        let _e924 = select(_e920, _e916, (_e916 < _e920));
                                        let _e929 = -(_e890);
                                        let _e930 = -(_e892);
                                        let _e937 = (select(_e894, _e922, (_e922 < _e894)) + (select(_e929, _e894, (_e894 > _e929)) * 0.0000019073523f));
                                        let _e938 = (select(_e896, _e924, (_e924 < _e896)) + (select(_e930, _e896, (_e896 > _e930)) * 0.0000019073523f));
                                        let _e940 = select(_e461, _e910, (_e910 > _e461));
                                        let _e942 = select(_e461, _e912, (_e912 > _e461));
                                        let _e947 = (_e940 <= select(_e505.member, _e937, (_e937 < _e505.member)));
                                        let _e948 = (_e942 <= select(_e505.member, _e938, (_e938 < _e505.member)));
                                        let _e949 = (_e940 <= _e942);
                                        if _e947 {
                                            if _e948 {
                                                if _e949 {
                                                    phi_3415_ = _e847.member_2;
                                                } else {
                                                    phi_3415_ = _e847.member_1;
                                                }
                                                let _e953 = phi_3415_;
                                                let _e975 = (_e548 % 128u);
                                                let _e976 = (_e975 < 128u);
                                                if _e976 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_8[_e975] = _e953.member_1;
                                                if _e976 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_7[_e975] = _e953.member.member.x;
                                                if _e976 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_6[_e975] = _e953.member.member.y;
                                                if _e976 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_5[_e975] = _e953.member.member.z;
                                                if _e976 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_4[_e975] = _e953.member.member_1.x;
                                                if _e976 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_3[_e975] = _e953.member.member_1.y;
                                                if _e976 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_2[_e975] = _e953.member.member_1.z;
                                                if _e976 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_9[_e975] = select(_e942, _e940, (_e940 > _e942));
                                                if _e949 {
                                                    phi_3492_ = _e847.member_1;
                                                } else {
                                                    phi_3492_ = _e847.member_2;
                                                }
                                                let _e989 = phi_3492_;
                                                phi_3493_ = _e989;
                                                phi_3494_ = (_e548 + 1u);
                                            } else {
                                                phi_3493_ = type_45();
                                                phi_3494_ = u32();
                                            }
                                            let _e991 = phi_3493_;
                                            let _e993 = phi_3494_;
                                            phi_3496_ = _e991;
                                            phi_3497_ = _e993;
                                            phi_3498_ = select(true, false, _e948);
                                        } else {
                                            phi_3496_ = type_45();
                                            phi_3497_ = u32();
                                            phi_3498_ = true;
                                        }
                                        let _e996 = phi_3496_;
                                        let _e998 = phi_3497_;
                                        let _e1000 = phi_3498_;
                                        if _e1000 {
                                            if _e947 {
                                                phi_3507_ = _e847.member_1;
                                            } else {
                                                phi_3507_ = _e847.member_2;
                                            }
                                            let _e1004 = phi_3507_;
                                            phi_3512_ = _e1004;
                                            phi_3513_ = select(_e948, true, _e947);
                                        } else {
                                            phi_3512_ = _e996;
                                            phi_3513_ = _e546;
                                        }
                                        let _e1007 = phi_3512_;
                                        let _e1009 = phi_3513_;
                                        phi_3895_ = _e503;
                                        phi_3515_ = _e505;
                                        phi_3516_ = _e1007;
                                        phi_3517_ = _e1009;
                                        phi_3518_ = select(_e998, _e548, _e1000);
                                    }
                                    let _e1745 = phi_3895_;
                                    let _e1747 = phi_3515_;
                                    let _e1749 = phi_3516_;
                                    let _e1751 = phi_3517_;
                                    let _e1753 = phi_3518_;
                                    phi_3894_ = _e1745;
                                    phi_3519_ = _e1747;
                                    phi_3520_ = _e1749;
                                    phi_3521_ = (_e509 - 1u);
                                    phi_3522_ = _e1751;
                                    phi_3523_ = _e1753;
                                } else {
                                    phi_3894_ = _e503;
                                    phi_3519_ = _e505;
                                    phi_3520_ = _e544;
                                    phi_3521_ = _e509;
                                    phi_3522_ = _e546;
                                    phi_3523_ = _e548;
                                }
                                let _e1755 = phi_3894_;
                                let _e1757 = phi_3519_;
                                let _e1759 = phi_3520_;
                                let _e1761 = phi_3521_;
                                let _e1763 = phi_3522_;
                                let _e1765 = phi_3523_;
                                phi_3893_ = _e1755;
                                phi_3524_ = _e1757;
                                phi_3525_ = _e1759;
                                phi_3526_ = _e1761;
                                phi_3527_ = _e1763;
                                phi_3528_ = _e1765;
                            } else {
                                phi_3893_ = _e503;
                                phi_3524_ = type_38();
                                phi_3525_ = type_45();
                                phi_3526_ = u32();
                                phi_3527_ = bool();
                                phi_3528_ = u32();
                            }
                            let _e1767 = phi_3893_;
                            let _e1769 = phi_3524_;
                            let _e1771 = phi_3525_;
                            let _e1773 = phi_3526_;
                            let _e1775 = phi_3527_;
                            let _e1777 = phi_3528_;
                            phi_3892_ = _e1767;
                            phi_841_ = _e1769;
                            phi_844_ = _e1771;
                            phi_846_ = _e1773;
                            phi_848_ = _e1775;
                            phi_850_ = _e1777;
                            phi_3529_ = _e517;
                        } else {
                            phi_3892_ = _e503;
                            phi_841_ = type_38();
                            phi_844_ = type_45();
                            phi_846_ = u32();
                            phi_848_ = bool();
                            phi_850_ = u32();
                            phi_3529_ = false;
                        }
                        let _e1779 = phi_3892_;
                        let _e1781 = phi_841_;
                        let _e1783 = phi_844_;
                        let _e1785 = phi_846_;
                        let _e1787 = phi_848_;
                        let _e1789 = phi_850_;
                        let _e1791 = phi_3529_;
                        continue;
                        continuing {
                            phi_3739_ = _e1779;
                            phi_840_ = _e1781;
                            phi_843_ = _e1783;
                            phi_845_ = _e1785;
                            phi_847_ = _e1787;
                            phi_849_ = _e1789;
                            phi_3891_ = _e1779;
                            break if !(_e1791);
                        }
                    }
                    let _e1794 = phi_3891_;
                    if _e1794 {
                        break;
                    }
                    let _e1796 = local_11;
                    if _e149 {
                    } else {
                        break;
                    }
                    global_5.member[_e147] = select(0u, 1u, _e1796.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
