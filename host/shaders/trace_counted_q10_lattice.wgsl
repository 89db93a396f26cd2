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

struct type_36 {
    member: type_28,
    member_1: f32,
}

struct type_41 {
    member: array<type_29>,
}

struct type_43 {
    member: type_36,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: type_32,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
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
    var phi_388_: i32;
    var phi_389_: i32;
    var phi_399_: bool;
    var phi_409_: u32;
    var phi_410_: u32;
    var phi_412_: bool;
    var phi_417_: u32;
    var phi_429_: i32;
    var phi_449_: i32;
    var phi_467_: f32;
    var phi_473_: f32;
    var phi_484_: f32;
    var phi_490_: f32;
    var phi_513_: f32;
    var phi_524_: f32;
    var phi_533_: f32;
    var phi_539_: f32;
    var phi_550_: f32;
    var phi_556_: f32;
    var phi_579_: f32;
    var phi_590_: f32;
    var phi_599_: f32;
    var phi_605_: f32;
    var phi_616_: f32;
    var phi_622_: f32;
    var phi_645_: f32;
    var phi_656_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_3776_: bool;
    var phi_847_: type_43;
    var phi_850_: type_50;
    var phi_852_: u32;
    var phi_854_: bool;
    var phi_856_: u32;
    var phi_867_: bool;
    var phi_953_: type_50;
    var phi_954_: bool;
    var phi_955_: u32;
    var phi_2807_: u32;
    var phi_2813_: u32;
    var phi_3067_: u32;
    var phi_3068_: u32;
    var phi_3078_: u32;
    var phi_3080_: u32;
    var phi_3081_: bool;
    var phi_3101_: u32;
    var phi_3102_: u32;
    var phi_3106_: type_51;
    var phi_3450_: type_50;
    var phi_3527_: type_50;
    var phi_3528_: type_50;
    var phi_3529_: u32;
    var phi_3531_: type_50;
    var phi_3532_: u32;
    var phi_3533_: bool;
    var phi_3542_: type_50;
    var phi_3547_: type_50;
    var phi_3548_: bool;
    var phi_974_: type_43;
    var phi_977_: type_8;
    var phi_978_: type_8;
    var phi_1000_: type_8;
    var phi_1044_: u32;
    var phi_1050_: u32;
    var phi_1060_: u32;
    var phi_1076_: u32;
    var phi_1109_: u32;
    var phi_1115_: u32;
    var phi_1542_: u32;
    var phi_1560_: u32;
    var phi_1578_: u32;
    var phi_1598_: u32;
    var phi_1616_: u32;
    var phi_1634_: u32;
    var phi_1654_: u32;
    var phi_1672_: u32;
    var phi_1690_: u32;
    var phi_1268_: u32;
    var phi_1283_: u32;
    var phi_1293_: u32;
    var phi_1313_: u32;
    var phi_1333_: u32;
    var phi_1359_: u32;
    var phi_1374_: u32;
    var phi_1384_: u32;
    var phi_1404_: u32;
    var phi_1424_: u32;
    var phi_1450_: u32;
    var phi_1465_: u32;
    var phi_1475_: u32;
    var phi_1495_: u32;
    var phi_1515_: u32;
    var phi_1139_: u32;
    var phi_1182_: u32;
    var phi_1225_: u32;
    var phi_1696_: array<array<f32, 3>, 3>;
    var phi_2167_: vec3<f32>;
    var phi_2168_: vec3<f32>;
    var phi_2199_: bool;
    var phi_2208_: vec3<f32>;
    var phi_2248_: type_28;
    var phi_2250_: type_28;
    var phi_2251_: bool;
    var phi_2255_: type_28;
    var phi_2256_: type_28;
    var phi_2257_: type_28;
    var phi_2258_: bool;
    var phi_2262_: type_28;
    var phi_2263_: bool;
    var phi_2267_: type_28;
    var phi_2268_: bool;
    var phi_2272_: type_28;
    var phi_2297_: bool;
    var phi_2298_: bool;
    var phi_2305_: type_43;
    var phi_2306_: type_43;
    var phi_2307_: type_43;
    var phi_975_: type_43;
    var phi_3770_: bool;
    var phi_3935_: bool;
    var phi_3550_: type_43;
    var phi_3551_: type_50;
    var phi_3552_: bool;
    var phi_3553_: u32;
    var phi_3934_: bool;
    var phi_3554_: type_43;
    var phi_3555_: type_50;
    var phi_3556_: u32;
    var phi_3557_: bool;
    var phi_3558_: u32;
    var phi_3933_: bool;
    var phi_3559_: type_43;
    var phi_3560_: type_50;
    var phi_3561_: u32;
    var phi_3562_: bool;
    var phi_3563_: u32;
    var phi_3932_: bool;
    var phi_848_: type_43;
    var phi_851_: type_50;
    var phi_853_: u32;
    var phi_855_: bool;
    var phi_857_: u32;
    var phi_3564_: bool;
    var phi_3931_: bool;
    var local_10: type_43;
    var local_11: type_43;
    var local_12: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_3.member));
            let _e93 = arrayLength((&global_5.member));
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
                let _e149 = (_e147 < arrayLength((&global_6.member)));
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
                            phi_388_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_388_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                        }
                        let _e240 = phi_388_;
                        phi_389_ = _e240;
                    } else {
                        phi_389_ = 0i;
                    }
                    let _e242 = phi_389_;
                    let _e243 = (_e159 == _e198);
                    if _e243 {
                        phi_399_ = true;
                    } else {
                        phi_399_ = (_e166 == _e198);
                    }
                    let _e246 = phi_399_;
                    let _e247 = select(1u, 0u, _e243);
                    if _e246 {
                        let _e248 = (_e247 + 1u);
                        phi_409_ = _e248;
                        phi_410_ = _e248;
                        phi_412_ = select(true, false, (_e248 == 2u));
                    } else {
                        phi_409_ = u32();
                        phi_410_ = 0u;
                        phi_412_ = true;
                    }
                    let _e252 = phi_409_;
                    let _e254 = phi_410_;
                    let _e256 = phi_412_;
                    if _e256 {
                        phi_417_ = (_e254 + 1u);
                    } else {
                        phi_417_ = 0u;
                    }
                    let _e260 = phi_417_;
                    let _e261 = select(_e252, _e254, _e256);
                    let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                    if (_e129 < -126i) {
                        phi_429_ = -126i;
                    } else {
                        phi_429_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e267 = phi_429_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e129 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = -(_e242);
                    if (_e279 < -126i) {
                        phi_449_ = -126i;
                    } else {
                        phi_449_ = select(_e279, 127i, (_e279 > 127i));
                    }
                    let _e284 = phi_449_;
                    let _e289 = bitcast<f32>((bitcast<u32>((_e284 + 127i)) << bitcast<u32>(23i)));
                    let _e295 = bitcast<f32>((bitcast<u32>(((_e279 - _e284) + 127i)) << bitcast<u32>(23i)));
                    let _e299 = global_4.member[_e147].member;
                    let _e300 = (_e261 == 0u);
                    if _e300 {
                        phi_467_ = _e299[0];
                    } else {
                        phi_467_ = _e299[1];
                    }
                    let _e304 = phi_467_;
                    let _e305 = (_e261 == 2u);
                    if _e305 {
                        phi_473_ = _e299[2];
                    } else {
                        phi_473_ = _e304;
                    }
                    let _e308 = phi_473_;
                    let _e310 = ((_e308 * _e272) * _e278);
                    let _e311 = global_4.member[_e147].member_2;
                    if _e300 {
                        phi_484_ = _e311[0];
                    } else {
                        phi_484_ = _e311[1];
                    }
                    let _e315 = phi_484_;
                    if _e305 {
                        phi_490_ = _e311[2];
                    } else {
                        phi_490_ = _e315;
                    }
                    let _e318 = phi_490_;
                    let _e320 = ((_e318 * _e289) * _e295);
                    let _e324 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e324 {
                        let _e328 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) * 0.00000011920929f);
                        phi_513_ = select(0.00000000000011368684f, _e328, (_e328 > 0.00000000000011368684f));
                    } else {
                        phi_513_ = 0f;
                    }
                    let _e332 = phi_513_;
                    let _e333 = (_e310 + _e332);
                    let _e334 = (_e310 - _e332);
                    let _e335 = select(_e320, 0f, _e324);
                    if _e324 {
                        phi_524_ = 38685626000000000000000000f;
                    } else {
                        phi_524_ = (1f / _e320);
                    }
                    let _e338 = phi_524_;
                    let _e339 = (_e260 == 0u);
                    if _e339 {
                        phi_533_ = _e299[0];
                    } else {
                        phi_533_ = _e299[1];
                    }
                    let _e343 = phi_533_;
                    let _e344 = (_e260 == 2u);
                    if _e344 {
                        phi_539_ = _e299[2];
                    } else {
                        phi_539_ = _e343;
                    }
                    let _e347 = phi_539_;
                    let _e349 = ((_e347 * _e272) * _e278);
                    if _e339 {
                        phi_550_ = _e311[0];
                    } else {
                        phi_550_ = _e311[1];
                    }
                    let _e353 = phi_550_;
                    if _e344 {
                        phi_556_ = _e311[2];
                    } else {
                        phi_556_ = _e353;
                    }
                    let _e356 = phi_556_;
                    let _e358 = ((_e356 * _e289) * _e295);
                    let _e362 = (bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e362 {
                        let _e366 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) * 0.00000011920929f);
                        phi_579_ = select(0.00000000000011368684f, _e366, (_e366 > 0.00000000000011368684f));
                    } else {
                        phi_579_ = 0f;
                    }
                    let _e370 = phi_579_;
                    let _e371 = (_e349 + _e370);
                    let _e372 = (_e349 - _e370);
                    let _e373 = select(_e358, 0f, _e362);
                    if _e362 {
                        phi_590_ = 38685626000000000000000000f;
                    } else {
                        phi_590_ = (1f / _e358);
                    }
                    let _e376 = phi_590_;
                    let _e377 = (_e262 == 0u);
                    if _e377 {
                        phi_599_ = _e299[0];
                    } else {
                        phi_599_ = _e299[1];
                    }
                    let _e381 = phi_599_;
                    let _e382 = (_e262 == 2u);
                    if _e382 {
                        phi_605_ = _e299[2];
                    } else {
                        phi_605_ = _e381;
                    }
                    let _e385 = phi_605_;
                    let _e387 = ((_e385 * _e272) * _e278);
                    if _e377 {
                        phi_616_ = _e311[0];
                    } else {
                        phi_616_ = _e311[1];
                    }
                    let _e391 = phi_616_;
                    if _e382 {
                        phi_622_ = _e311[2];
                    } else {
                        phi_622_ = _e391;
                    }
                    let _e394 = phi_622_;
                    let _e396 = ((_e394 * _e289) * _e295);
                    let _e400 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e400 {
                        let _e404 = (bitcast<f32>((bitcast<u32>(_e387) & 2147483647u)) * 0.00000011920929f);
                        phi_645_ = select(0.00000000000011368684f, _e404, (_e404 > 0.00000000000011368684f));
                    } else {
                        phi_645_ = 0f;
                    }
                    let _e408 = phi_645_;
                    let _e409 = (_e387 + _e408);
                    let _e410 = (_e387 - _e408);
                    let _e411 = select(_e396, 0f, _e400);
                    if _e400 {
                        phi_656_ = 38685626000000000000000000f;
                    } else {
                        phi_656_ = (1f / _e396);
                    }
                    let _e414 = phi_656_;
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
                        phi_756_ = select(-340282350000000000000000000000000000000f, _e455, (_e455 > -340282350000000000000000000000000000000f));
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_756_ = 0f;
                        phi_757_ = 1f;
                    }
                    let _e459 = phi_756_;
                    let _e461 = phi_757_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e466 = (_e261 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    let _e472 = (_e260 % 3u);
                    let _e473 = (_e472 < 3u);
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e475 = local_1[_e472];
                    let _e478 = (_e262 % 3u);
                    let _e479 = (_e478 < 3u);
                    if _e479 {
                    } else {
                        break;
                    }
                    let _e481 = local_1[_e478];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e486 = local[_e466];
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e490 = local[_e472];
                    if _e479 {
                    } else {
                        break;
                    }
                    let _e494 = local[_e478];
                    phi_3776_ = false;
                    phi_847_ = type_43(type_36(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e459), 0u, 0u);
                    phi_850_ = type_50(type_32(vec4<f32>((f32(_e469) * _e141), (f32(_e475) * _e141), (f32(_e481) * _e141), 0f), vec4<f32>((f32(_e486) * _e141), (f32(_e490) * _e141), (f32(_e494) * _e141), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_852_ = ((3u * _e90) + 1u);
                    phi_854_ = (_e461 <= _e459);
                    phi_856_ = 0u;
                    loop {
                        let _e504 = phi_3776_;
                        let _e506 = phi_847_;
                        let _e508 = phi_850_;
                        let _e510 = phi_852_;
                        let _e512 = phi_854_;
                        let _e514 = phi_856_;
                        local_10 = _e506;
                        local_11 = _e506;
                        if _e512 {
                            phi_867_ = true;
                        } else {
                            phi_867_ = (_e514 > 0u);
                        }
                        let _e517 = phi_867_;
                        if _e517 {
                            let _e518 = (_e510 > 0u);
                            if _e518 {
                                if _e512 {
                                    phi_953_ = _e508;
                                    phi_954_ = _e512;
                                    phi_955_ = _e514;
                                } else {
                                    let _e519 = (_e514 - 1u);
                                    let _e520 = (_e519 % 128u);
                                    let _e521 = (_e520 < 128u);
                                    if _e521 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e523 = local_7[_e520];
                                    if _e521 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e525 = local_6[_e520];
                                    if _e521 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e527 = local_5[_e520];
                                    if _e521 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e529 = local_4[_e520];
                                    if _e521 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e531 = local_3[_e520];
                                    if _e521 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e533 = local_2[_e520];
                                    if _e521 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e538 = local_8[_e520];
                                    if _e521 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e541 = local_9[_e520];
                                    phi_953_ = type_50(type_32(vec4<f32>(_e523, _e525, _e527, 0f), vec4<f32>(_e529, _e531, _e533, 0f)), _e538);
                                    phi_954_ = (_e541 <= _e506.member.member_1);
                                    phi_955_ = _e519;
                                }
                                let _e546 = phi_953_;
                                let _e548 = phi_954_;
                                let _e550 = phi_955_;
                                if _e548 {
                                    let _e555 = (_e546.member_1 & 268435455u);
                                    if ((_e546.member_1 & 2147483648u) != 0u) {
                                        phi_974_ = _e506;
                                        phi_977_ = type_8(0u, ((_e546.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1022 = phi_974_;
                                            let _e1024 = phi_977_;
                                            local_12 = _e1022;
                                            if (_e1024.member < _e1024.member_1) {
                                                phi_978_ = type_8((_e1024.member + 1u), _e1024.member_1);
                                                phi_1000_ = type_8(1u, _e1024.member);
                                            } else {
                                                phi_978_ = _e1024;
                                                phi_1000_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1037 = phi_978_;
                                            let _e1039 = phi_1000_;
                                            let _e1043 = (bitcast<i32>(_e1039.member) != 0i);
                                            if _e1043 {
                                                let _e1049 = type_43(_e1022.member, _e1022.member_1, (_e1022.member_2 + 1u));
                                                let _e1054 = (_e546.member.member_1.x - _e546.member.member.x);
                                                let _e1057 = (_e546.member.member_1.y - _e546.member.member.y);
                                                let _e1060 = (_e546.member.member_1.z - _e546.member.member.z);
                                                let _e1062 = select(_e1057, _e1054, (_e1054 > _e1057));
                                                let _e1064 = select(_e1060, _e1062, (_e1062 > _e1060));
                                                let _e1066 = (_e1064 < (1024f * _e141));
                                                if _e1066 {
                                                    phi_1044_ = 0u;
                                                } else {
                                                    phi_1044_ = select(2u, 1u, (_e1064 < (2097152f * _e141)));
                                                }
                                                let _e1071 = phi_1044_;
                                                switch bitcast<i32>(_e1071) {
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
                                                let _e1074 = phi_1050_;
                                                switch bitcast<i32>(_e1071) {
                                                    case 0: {
                                                        phi_1060_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1060_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1060_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1060_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1081 = phi_1060_;
                                                let _e1083 = ((_e555 + (_e1039.member_1 * ((3u * _e1074) + 1u))) + (3u * _e1081));
                                                let _e1084 = (_e1083 < _e93);
                                                if _e1084 {
                                                    if _e1084 {
                                                    } else {
                                                        phi_3770_ = true;
                                                        break;
                                                    }
                                                    let _e1086 = global_5.member[_e1083];
                                                    phi_1076_ = _e1086;
                                                } else {
                                                    phi_1076_ = 4294967295u;
                                                }
                                                let _e1088 = phi_1076_;
                                                if _e1066 {
                                                    phi_1109_ = 0u;
                                                } else {
                                                    phi_1109_ = select(2u, 1u, (_e1064 < (2097152f * _e141)));
                                                }
                                                let _e1093 = phi_1109_;
                                                switch bitcast<i32>(_e1093) {
                                                    case 0: {
                                                        phi_1115_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1115_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1115_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1115_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1096 = phi_1115_;
                                                let _e1100 = (_e555 + (_e1039.member_1 * ((3u * _e1096) + 1u)));
                                                switch bitcast<i32>(_e1093) {
                                                    case 0: {
                                                        let _e1366 = (_e1100 < _e93);
                                                        if _e1366 {
                                                            if _e1366 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1368 = global_5.member[_e1100];
                                                            phi_1139_ = _e1368;
                                                        } else {
                                                            phi_1139_ = 0u;
                                                        }
                                                        let _e1370 = phi_1139_;
                                                        let _e1372 = ((10u * _e261) & 31u);
                                                        let _e1381 = ((10u * _e260) & 31u);
                                                        let _e1390 = ((10u * _e262) & 31u);
                                                        let _e1399 = (_e1100 + 1u);
                                                        let _e1400 = (_e1399 < _e93);
                                                        if _e1400 {
                                                            if _e1400 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1402 = global_5.member[_e1399];
                                                            phi_1182_ = _e1402;
                                                        } else {
                                                            phi_1182_ = 0u;
                                                        }
                                                        let _e1404 = phi_1182_;
                                                        let _e1427 = (_e1100 + 2u);
                                                        let _e1428 = (_e1427 < _e93);
                                                        if _e1428 {
                                                            if _e1428 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1430 = global_5.member[_e1427];
                                                            phi_1225_ = _e1430;
                                                        } else {
                                                            phi_1225_ = 0u;
                                                        }
                                                        let _e1432 = phi_1225_;
                                                        phi_1696_ = array<array<f32, 3>, 3>(array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1370 >> bitcast<u32>(_e1372)) & 1023u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1370 >> bitcast<u32>(_e1381)) & 1023u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1370 >> bitcast<u32>(_e1390)) & 1023u))) * _e141))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1404 >> bitcast<u32>(_e1372)) & 1023u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1404 >> bitcast<u32>(_e1381)) & 1023u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1404 >> bitcast<u32>(_e1390)) & 1023u))) * _e141))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1432 >> bitcast<u32>(_e1372)) & 1023u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1432 >> bitcast<u32>(_e1381)) & 1023u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1432 >> bitcast<u32>(_e1390)) & 1023u))) * _e141))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1189 = (_e1100 < _e93);
                                                        if _e1189 {
                                                            if _e1189 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1191 = global_5.member[_e1100];
                                                            phi_1268_ = _e1191;
                                                        } else {
                                                            phi_1268_ = 0u;
                                                        }
                                                        let _e1193 = phi_1268_;
                                                        let _e1194 = (_e1100 + 1u);
                                                        let _e1195 = (_e1194 < _e93);
                                                        if _e1195 {
                                                            if _e1195 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1197 = global_5.member[_e1194];
                                                            phi_1283_ = _e1197;
                                                        } else {
                                                            phi_1283_ = 0u;
                                                        }
                                                        let _e1199 = phi_1283_;
                                                        let _e1200 = (_e261 == 1u);
                                                        if _e1200 {
                                                            phi_1293_ = ((_e1193 >> bitcast<u32>(21i)) | (_e1199 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1293_ = (_e1199 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1209 = phi_1293_;
                                                        let _e1216 = (_e260 == 1u);
                                                        if _e1216 {
                                                            phi_1313_ = ((_e1193 >> bitcast<u32>(21i)) | (_e1199 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1313_ = (_e1199 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1225 = phi_1313_;
                                                        let _e1232 = (_e262 == 1u);
                                                        if _e1232 {
                                                            phi_1333_ = ((_e1193 >> bitcast<u32>(21i)) | (_e1199 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1333_ = (_e1199 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1241 = phi_1333_;
                                                        let _e1249 = (_e1100 + 2u);
                                                        let _e1250 = (_e1249 < _e93);
                                                        if _e1250 {
                                                            if _e1250 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1252 = global_5.member[_e1249];
                                                            phi_1359_ = _e1252;
                                                        } else {
                                                            phi_1359_ = 0u;
                                                        }
                                                        let _e1254 = phi_1359_;
                                                        let _e1255 = (_e1100 + 3u);
                                                        let _e1256 = (_e1255 < _e93);
                                                        if _e1256 {
                                                            if _e1256 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1258 = global_5.member[_e1255];
                                                            phi_1374_ = _e1258;
                                                        } else {
                                                            phi_1374_ = 0u;
                                                        }
                                                        let _e1260 = phi_1374_;
                                                        if _e1200 {
                                                            phi_1384_ = ((_e1254 >> bitcast<u32>(21i)) | (_e1260 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1384_ = (_e1260 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1269 = phi_1384_;
                                                        if _e1216 {
                                                            phi_1404_ = ((_e1254 >> bitcast<u32>(21i)) | (_e1260 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1404_ = (_e1260 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1284 = phi_1404_;
                                                        if _e1232 {
                                                            phi_1424_ = ((_e1254 >> bitcast<u32>(21i)) | (_e1260 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1424_ = (_e1260 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1299 = phi_1424_;
                                                        let _e1307 = (_e1100 + 4u);
                                                        let _e1308 = (_e1307 < _e93);
                                                        if _e1308 {
                                                            if _e1308 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1310 = global_5.member[_e1307];
                                                            phi_1450_ = _e1310;
                                                        } else {
                                                            phi_1450_ = 0u;
                                                        }
                                                        let _e1312 = phi_1450_;
                                                        let _e1313 = (_e1100 + 5u);
                                                        let _e1314 = (_e1313 < _e93);
                                                        if _e1314 {
                                                            if _e1314 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1316 = global_5.member[_e1313];
                                                            phi_1465_ = _e1316;
                                                        } else {
                                                            phi_1465_ = 0u;
                                                        }
                                                        let _e1318 = phi_1465_;
                                                        if _e1200 {
                                                            phi_1475_ = ((_e1312 >> bitcast<u32>(21i)) | (_e1318 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1475_ = (_e1318 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1327 = phi_1475_;
                                                        if _e1216 {
                                                            phi_1495_ = ((_e1312 >> bitcast<u32>(21i)) | (_e1318 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1495_ = (_e1318 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1342 = phi_1495_;
                                                        if _e1232 {
                                                            phi_1515_ = ((_e1312 >> bitcast<u32>(21i)) | (_e1318 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1515_ = (_e1318 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1357 = phi_1515_;
                                                        phi_1696_ = array<array<f32, 3>, 3>(array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1209, _e1193, _e300) & 2097151u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1225, _e1193, _e339) & 2097151u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1241, _e1193, _e377) & 2097151u))) * _e141))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1269, _e1254, _e300) & 2097151u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1284, _e1254, _e339) & 2097151u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1299, _e1254, _e377) & 2097151u))) * _e141))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1327, _e1312, _e300) & 2097151u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1342, _e1312, _e339) & 2097151u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1357, _e1312, _e377) & 2097151u))) * _e141))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1102 = (_e1100 + _e261);
                                                        let _e1103 = (_e1102 < _e93);
                                                        if _e1103 {
                                                            if _e1103 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1105 = global_5.member[_e1102];
                                                            phi_1542_ = _e1105;
                                                        } else {
                                                            phi_1542_ = 0u;
                                                        }
                                                        let _e1107 = phi_1542_;
                                                        let _e1111 = (_e1100 + _e260);
                                                        let _e1112 = (_e1111 < _e93);
                                                        if _e1112 {
                                                            if _e1112 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1114 = global_5.member[_e1111];
                                                            phi_1560_ = _e1114;
                                                        } else {
                                                            phi_1560_ = 0u;
                                                        }
                                                        let _e1116 = phi_1560_;
                                                        let _e1120 = (_e1100 + _e262);
                                                        let _e1121 = (_e1120 < _e93);
                                                        if _e1121 {
                                                            if _e1121 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1123 = global_5.member[_e1120];
                                                            phi_1578_ = _e1123;
                                                        } else {
                                                            phi_1578_ = 0u;
                                                        }
                                                        let _e1125 = phi_1578_;
                                                        let _e1130 = (_e1100 + 3u);
                                                        let _e1131 = (_e1130 + _e261);
                                                        let _e1132 = (_e1131 < _e93);
                                                        if _e1132 {
                                                            if _e1132 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1134 = global_5.member[_e1131];
                                                            phi_1598_ = _e1134;
                                                        } else {
                                                            phi_1598_ = 0u;
                                                        }
                                                        let _e1136 = phi_1598_;
                                                        let _e1140 = (_e1130 + _e260);
                                                        let _e1141 = (_e1140 < _e93);
                                                        if _e1141 {
                                                            if _e1141 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1143 = global_5.member[_e1140];
                                                            phi_1616_ = _e1143;
                                                        } else {
                                                            phi_1616_ = 0u;
                                                        }
                                                        let _e1145 = phi_1616_;
                                                        let _e1149 = (_e1130 + _e262);
                                                        let _e1150 = (_e1149 < _e93);
                                                        if _e1150 {
                                                            if _e1150 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1152 = global_5.member[_e1149];
                                                            phi_1634_ = _e1152;
                                                        } else {
                                                            phi_1634_ = 0u;
                                                        }
                                                        let _e1154 = phi_1634_;
                                                        let _e1159 = (_e1100 + 6u);
                                                        let _e1160 = (_e1159 + _e261);
                                                        let _e1161 = (_e1160 < _e93);
                                                        if _e1161 {
                                                            if _e1161 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1163 = global_5.member[_e1160];
                                                            phi_1654_ = _e1163;
                                                        } else {
                                                            phi_1654_ = 0u;
                                                        }
                                                        let _e1165 = phi_1654_;
                                                        let _e1169 = (_e1159 + _e260);
                                                        let _e1170 = (_e1169 < _e93);
                                                        if _e1170 {
                                                            if _e1170 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1172 = global_5.member[_e1169];
                                                            phi_1672_ = _e1172;
                                                        } else {
                                                            phi_1672_ = 0u;
                                                        }
                                                        let _e1174 = phi_1672_;
                                                        let _e1178 = (_e1159 + _e262);
                                                        let _e1179 = (_e1178 < _e93);
                                                        if _e1179 {
                                                            if _e1179 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1181 = global_5.member[_e1178];
                                                            phi_1690_ = _e1181;
                                                        } else {
                                                            phi_1690_ = 0u;
                                                        }
                                                        let _e1183 = phi_1690_;
                                                        phi_1696_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1107)) * _e141), (f32(bitcast<i32>(_e1116)) * _e141), (f32(bitcast<i32>(_e1125)) * _e141)), array<f32, 3>((f32(bitcast<i32>(_e1136)) * _e141), (f32(bitcast<i32>(_e1145)) * _e141), (f32(bitcast<i32>(_e1154)) * _e141)), array<f32, 3>((f32(bitcast<i32>(_e1165)) * _e141), (f32(bitcast<i32>(_e1174)) * _e141), (f32(bitcast<i32>(_e1183)) * _e141)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1696_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1457 = phi_1696_;
                                                let _e1466 = (_e1457[0][2] - _e387);
                                                let _e1469 = (((_e1457[0][0] - _e310) * _e411) - (_e1466 * _e335));
                                                let _e1472 = (((_e1457[0][1] - _e349) * _e411) - (_e1466 * _e373));
                                                let _e1479 = (_e1457[1][2] - _e387);
                                                let _e1482 = (((_e1457[1][0] - _e310) * _e411) - (_e1479 * _e335));
                                                let _e1485 = (((_e1457[1][1] - _e349) * _e411) - (_e1479 * _e373));
                                                let _e1492 = (_e1457[2][2] - _e387);
                                                let _e1495 = (((_e1457[2][0] - _e310) * _e411) - (_e1492 * _e335));
                                                let _e1498 = (((_e1457[2][1] - _e349) * _e411) - (_e1492 * _e373));
                                                let _e1499 = (_e1495 * _e1485);
                                                let _e1500 = (_e1498 * _e1482);
                                                let _e1501 = (_e1469 * _e1498);
                                                let _e1502 = (_e1472 * _e1495);
                                                let _e1503 = (_e1482 * _e1472);
                                                let _e1504 = (_e1485 * _e1469);
                                                let _e1509 = (((_e1499 >= _e1500) && (_e1501 >= _e1502)) && (_e1503 >= _e1504));
                                                if (_e1509 || (((_e1499 <= _e1500) && (_e1501 <= _e1502)) && (_e1503 <= _e1504))) {
                                                    let _e1516 = select(-1f, 1f, _e1509);
                                                    let _e1518 = ((_e1499 - _e1500) * _e1516);
                                                    let _e1520 = select(0f, _e1518, (_e1518 > 0f));
                                                    let _e1522 = ((_e1501 - _e1502) * _e1516);
                                                    let _e1524 = select(0f, _e1522, (_e1522 > 0f));
                                                    let _e1526 = ((_e1503 - _e1504) * _e1516);
                                                    let _e1528 = select(0f, _e1526, (_e1526 > 0f));
                                                    let _e1530 = ((_e1520 + _e1524) + _e1528);
                                                    if (_e1530 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2262_ = type_28();
                                                        phi_2263_ = true;
                                                    } else {
                                                        let _e1533 = select(_e1457[1][0], _e1457[0][0], (_e1457[0][0] < _e1457[1][0]));
                                                        let _e1537 = select(_e1457[1][0], _e1457[0][0], (_e1457[0][0] > _e1457[1][0]));
                                                        let _e1541 = select(_e1457[1][1], _e1457[0][1], (_e1457[0][1] < _e1457[1][1]));
                                                        let _e1545 = select(_e1457[1][1], _e1457[0][1], (_e1457[0][1] > _e1457[1][1]));
                                                        let _e1549 = select(_e1457[1][2], _e1457[0][2], (_e1457[0][2] < _e1457[1][2]));
                                                        let _e1553 = select(_e1457[1][2], _e1457[0][2], (_e1457[0][2] > _e1457[1][2]));
                                                        let _e1558 = ((select(_e1457[2][0], _e1533, (_e1533 < _e1457[2][0])) - _e333) * _e338);
                                                        let _e1559 = ((select(_e1457[2][0], _e1537, (_e1537 > _e1457[2][0])) - _e334) * _e338);
                                                        let _e1562 = ((select(_e1457[2][1], _e1541, (_e1541 < _e1457[2][1])) - _e371) * _e376);
                                                        let _e1563 = ((select(_e1457[2][1], _e1545, (_e1545 > _e1457[2][1])) - _e372) * _e376);
                                                        let _e1566 = ((select(_e1457[2][2], _e1549, (_e1549 < _e1457[2][2])) - _e409) * _e414);
                                                        let _e1567 = ((select(_e1457[2][2], _e1553, (_e1553 > _e1457[2][2])) - _e410) * _e414);
                                                        let _e1569 = select(_e1567, _e1566, (_e1566 < _e1567));
                                                        let _e1571 = select(_e1567, _e1566, (_e1566 > _e1567));
                                                        let _e1573 = select(_e1559, _e1558, (_e1558 < _e1559));
                                                        let _e1575 = select(_e1563, _e1562, (_e1562 < _e1563));
                                                        let _e1577 = select(_e1575, _e1573, (_e1573 > _e1575));
                                                        let _e1579 = select(_e1569, _e1577, (_e1577 > _e1569));
                                                        let _e1581 = select(_e1559, _e1558, (_e1558 > _e1559));
                                                        let _e1583 = select(_e1563, _e1562, (_e1562 > _e1563));
                                                        let _e1585 = select(_e1583, _e1581, (_e1581 < _e1583));
                                                        let _e1587 = select(_e1571, _e1585, (_e1585 < _e1571));
                                                        let _e1588 = -(_e1569);
                                                        let _e1594 = select(_e461, _e1579, (_e1579 > _e461));
                                                        if (_e1594 > (_e1587 + (select(_e1588, _e1571, (_e1571 > _e1588)) * 0.0000019073523f))) {
                                                            phi_2257_ = type_28();
                                                            phi_2258_ = true;
                                                        } else {
                                                            let _e1596 = (_e1594 > _e1022.member.member_1);
                                                            if _e1596 {
                                                                phi_2256_ = type_28();
                                                            } else {
                                                                let _e1600 = (_e1457[1][0] - _e1457[0][0]);
                                                                let _e1601 = (_e1457[1][1] - _e1457[0][1]);
                                                                let _e1602 = (_e1457[1][2] - _e1457[0][2]);
                                                                let _e1603 = vec3<f32>(_e1600, _e1601, _e1602);
                                                                let _e1604 = (_e1457[2][0] - _e1457[1][0]);
                                                                let _e1605 = (_e1457[2][1] - _e1457[1][1]);
                                                                let _e1606 = (_e1457[2][2] - _e1457[1][2]);
                                                                let _e1607 = vec3<f32>(_e1604, _e1605, _e1606);
                                                                let _e1608 = (_e1457[0][0] - _e1457[2][0]);
                                                                let _e1609 = (_e1457[0][1] - _e1457[2][1]);
                                                                let _e1610 = (_e1457[0][2] - _e1457[2][2]);
                                                                let _e1611 = vec3<f32>(_e1608, _e1609, _e1610);
                                                                let _e1614 = bitcast<f32>((bitcast<u32>(_e1600) & 2147483647u));
                                                                let _e1617 = bitcast<f32>((bitcast<u32>(_e1601) & 2147483647u));
                                                                let _e1619 = select(_e1617, _e1614, (_e1614 > _e1617));
                                                                let _e1622 = bitcast<f32>((bitcast<u32>(_e1602) & 2147483647u));
                                                                let _e1624 = select(_e1622, _e1619, (_e1619 > _e1622));
                                                                let _e1627 = bitcast<f32>((bitcast<u32>(_e1604) & 2147483647u));
                                                                let _e1630 = bitcast<f32>((bitcast<u32>(_e1605) & 2147483647u));
                                                                let _e1632 = select(_e1630, _e1627, (_e1627 > _e1630));
                                                                let _e1635 = bitcast<f32>((bitcast<u32>(_e1606) & 2147483647u));
                                                                let _e1637 = select(_e1635, _e1632, (_e1632 > _e1635));
                                                                let _e1640 = bitcast<f32>((bitcast<u32>(_e1608) & 2147483647u));
                                                                let _e1643 = bitcast<f32>((bitcast<u32>(_e1609) & 2147483647u));
                                                                let _e1645 = select(_e1643, _e1640, (_e1640 > _e1643));
                                                                let _e1648 = bitcast<f32>((bitcast<u32>(_e1610) & 2147483647u));
                                                                let _e1650 = select(_e1648, _e1645, (_e1645 > _e1648));
                                                                let _e1652 = select(_e1637, _e1624, (_e1624 > _e1637));
                                                                let _e1654 = select(_e1650, _e1652, (_e1652 > _e1650));
                                                                if (_e1624 == _e1654) {
                                                                    phi_2167_ = _e1607;
                                                                    phi_2168_ = _e1611;
                                                                } else {
                                                                    let _e1657 = vec3((_e1637 == _e1654));
                                                                    phi_2167_ = select(_e1603, _e1611, _e1657);
                                                                    phi_2168_ = select(_e1607, _e1603, _e1657);
                                                                }
                                                                let _e1661 = phi_2167_;
                                                                let _e1663 = phi_2168_;
                                                                let _e1670 = ((_e1661.y * _e1663.z) - (_e1663.y * _e1661.z));
                                                                let _e1675 = ((_e1661.z * _e1663.x) - (_e1663.z * _e1661.x));
                                                                let _e1678 = ((_e1661.x * _e1663.y) - (_e1663.x * _e1661.y));
                                                                if (_e1520 >= _e1524) {
                                                                    phi_2199_ = select(true, false, (_e1520 >= _e1528));
                                                                } else {
                                                                    phi_2199_ = true;
                                                                }
                                                                let _e1683 = phi_2199_;
                                                                if _e1683 {
                                                                    phi_2208_ = select(vec3<f32>(_e1457[2][0], _e1457[2][1], _e1457[2][2]), vec3<f32>(_e1457[1][0], _e1457[1][1], _e1457[1][2]), vec3((_e1524 >= _e1528)));
                                                                } else {
                                                                    phi_2208_ = vec3<f32>(_e1457[0][0], _e1457[0][1], _e1457[0][2]);
                                                                }
                                                                let _e1688 = phi_2208_;
                                                                let _e1705 = ((((_e1670 * (_e1688.x - _e310)) + (_e1675 * (_e1688.y - _e349))) + (_e1678 * (_e1688.z - _e387))) / (((_e1670 * _e335) + (_e1675 * _e373)) + (_e1678 * _e411)));
                                                                let _e1707 = select(_e1587, _e1705, (_e1705 < _e1587));
                                                                let _e1709 = select(_e1579, _e1707, (_e1707 > _e1579));
                                                                if (_e1709 >= _e461) {
                                                                    let _e1711 = (_e1709 <= _e1022.member.member_1);
                                                                    if _e1711 {
                                                                        let _e1712 = (1f / _e1530);
                                                                        phi_2248_ = type_28(_e1709, (_e1524 * _e1712), (_e1528 * _e1712), _e1088);
                                                                    } else {
                                                                        phi_2248_ = type_28();
                                                                    }
                                                                    let _e1717 = phi_2248_;
                                                                    phi_2250_ = _e1717;
                                                                    phi_2251_ = select(true, false, _e1711);
                                                                } else {
                                                                    phi_2250_ = type_28();
                                                                    phi_2251_ = true;
                                                                }
                                                                let _e1720 = phi_2250_;
                                                                let _e1722 = phi_2251_;
                                                                if _e1722 {
                                                                    phi_2255_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2255_ = _e1720;
                                                                }
                                                                let _e1724 = phi_2255_;
                                                                phi_2256_ = _e1724;
                                                            }
                                                            let _e1726 = phi_2256_;
                                                            phi_2257_ = _e1726;
                                                            phi_2258_ = _e1596;
                                                        }
                                                        let _e1728 = phi_2257_;
                                                        let _e1730 = phi_2258_;
                                                        phi_2262_ = _e1728;
                                                        phi_2263_ = _e1730;
                                                    }
                                                    let _e1732 = phi_2262_;
                                                    let _e1734 = phi_2263_;
                                                    phi_2267_ = _e1732;
                                                    phi_2268_ = _e1734;
                                                } else {
                                                    phi_2267_ = type_28();
                                                    phi_2268_ = true;
                                                }
                                                let _e1736 = phi_2267_;
                                                let _e1738 = phi_2268_;
                                                if _e1738 {
                                                    phi_2272_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2272_ = _e1736;
                                                }
                                                let _e1740 = phi_2272_;
                                                if (_e1740.member_3 != 4294967295u) {
                                                    if (_e1088 != 4294967295u) {
                                                        if (_e1740.member < _e1022.member.member.member) {
                                                            phi_2298_ = true;
                                                        } else {
                                                            if (_e1740.member == _e1022.member.member.member) {
                                                                phi_2297_ = (_e1740.member_3 < _e1022.member.member.member_3);
                                                            } else {
                                                                phi_2297_ = false;
                                                            }
                                                            let _e1755 = phi_2297_;
                                                            phi_2298_ = _e1755;
                                                        }
                                                        let _e1757 = phi_2298_;
                                                        if _e1757 {
                                                            phi_2305_ = type_43(type_36(_e1740, _e1740.member), _e1049.member_1, _e1049.member_2);
                                                        } else {
                                                            phi_2305_ = _e1049;
                                                        }
                                                        let _e1764 = phi_2305_;
                                                        phi_2306_ = _e1764;
                                                    } else {
                                                        phi_2306_ = _e1049;
                                                    }
                                                    let _e1766 = phi_2306_;
                                                    phi_2307_ = _e1766;
                                                } else {
                                                    phi_2307_ = _e1049;
                                                }
                                                let _e1768 = phi_2307_;
                                                phi_975_ = _e1768;
                                            } else {
                                                phi_975_ = type_43();
                                            }
                                            let _e1770 = phi_975_;
                                            continue;
                                            continuing {
                                                phi_974_ = _e1770;
                                                phi_977_ = _e1037;
                                                phi_3770_ = _e504;
                                                break if !(_e1043);
                                            }
                                        }
                                        let _e1773 = phi_3770_;
                                        phi_3931_ = _e1773;
                                        if _e1773 {
                                            break;
                                        }
                                        phi_3935_ = _e1773;
                                        let _e1960 = local_12;
                                        phi_3550_ = _e1960;
                                        phi_3551_ = _e546;
                                        phi_3552_ = false;
                                        phi_3553_ = _e550;
                                    } else {
                                        if (_e546.member_1 >= _e90) {
                                            phi_3106_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e546.member_1 < _e90) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e569 = ((1u + _e261) % 4u);
                                            if (_e569 < 4u) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e574 = global_3.member[_e546.member_1][_e569];
                                            let _e576 = (_e574 >> bitcast<u32>(11u));
                                            let _e578 = ((1u + _e260) % 4u);
                                            if (_e578 < 4u) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e583 = global_3.member[_e546.member_1][_e578];
                                            let _e585 = (_e583 >> bitcast<u32>(11u));
                                            let _e587 = ((1u + _e262) % 4u);
                                            if (_e587 < 4u) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e592 = global_3.member[_e546.member_1][_e587];
                                            let _e594 = (_e592 >> bitcast<u32>(11u));
                                            let _e617 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.x - _e546.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e618 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.y - _e546.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e619 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.z - _e546.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e621 = select(_e141, _e617, (_e617 > _e141));
                                            let _e623 = select(_e141, _e618, (_e618 > _e141));
                                            let _e625 = select(_e141, _e619, (_e619 > _e141));
                                            let _e650 = bitcast<u32>((f32(bitcast<i32>((_e574 & 1023u))) * _e621));
                                            let _e655 = (bitcast<i32>((_e574 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e658 = bitcast<f32>((_e650 & bitcast<u32>(_e655)));
                                            let _e659 = bitcast<u32>((f32(bitcast<i32>((_e583 & 1023u))) * _e623));
                                            let _e664 = (bitcast<i32>((_e583 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e667 = bitcast<f32>((_e659 & bitcast<u32>(_e664)));
                                            let _e668 = bitcast<u32>((f32(bitcast<i32>((_e592 & 1023u))) * _e625));
                                            let _e673 = (bitcast<i32>((_e592 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e676 = bitcast<f32>((_e668 & bitcast<u32>(_e673)));
                                            let _e680 = bitcast<f32>((_e650 & bitcast<u32>(~(_e655))));
                                            let _e684 = bitcast<f32>((_e659 & bitcast<u32>(~(_e664))));
                                            let _e688 = bitcast<f32>((_e668 & bitcast<u32>(~(_e673))));
                                            let _e689 = bitcast<u32>((f32(bitcast<i32>((_e576 & 1023u))) * _e621));
                                            let _e694 = (bitcast<i32>((_e576 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e697 = bitcast<f32>((_e689 & bitcast<u32>(_e694)));
                                            let _e698 = bitcast<u32>((f32(bitcast<i32>((_e585 & 1023u))) * _e623));
                                            let _e703 = (bitcast<i32>((_e585 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e706 = bitcast<f32>((_e698 & bitcast<u32>(_e703)));
                                            let _e707 = bitcast<u32>((f32(bitcast<i32>((_e594 & 1023u))) * _e625));
                                            let _e712 = (bitcast<i32>((_e594 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e715 = bitcast<f32>((_e707 & bitcast<u32>(_e712)));
                                            let _e719 = bitcast<f32>((_e689 & bitcast<u32>(~(_e694))));
                                            let _e723 = bitcast<f32>((_e698 & bitcast<u32>(~(_e703))));
                                            let _e727 = bitcast<f32>((_e707 & bitcast<u32>(~(_e712))));
                                            let _e728 = (_e546.member.member.x + _e658);
                                            let _e729 = (_e546.member.member.y + _e667);
                                            let _e730 = (_e546.member.member.z + _e676);
                                            let _e733 = (_e546.member.member_1.x - _e697);
                                            let _e734 = (_e546.member.member_1.y - _e706);
                                            let _e735 = (_e546.member.member_1.z - _e715);
                                            let _e754 = (_e733 - _e728);
                                            let _e755 = (_e734 - _e729);
                                            let _e756 = (_e735 - _e730);
                                            let _e758 = select(_e755, _e754, (_e754 > _e755));
                                            let _e760 = select(_e756, _e758, (_e758 > _e756));
                                            if (_e760 < (1024f * _e141)) {
                                                phi_2807_ = 0u;
                                            } else {
                                                phi_2807_ = select(2u, 1u, (_e760 < (2097152f * _e141)));
                                            }
                                            let _e767 = phi_2807_;
                                            switch bitcast<i32>(_e767) {
                                                case 0: {
                                                    phi_2813_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2813_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2813_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2813_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e770 = phi_2813_;
                                            let _e776 = global_3.member[_e546.member_1][0u];
                                            let _e780 = global_3.member[_e546.member_1][1u];
                                            let _e784 = global_3.member[_e546.member_1][2u];
                                            let _e788 = global_3.member[_e546.member_1][3u];
                                            let _e800 = (((_e780 >> bitcast<u32>(22i)) | ((_e784 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e788 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e801 = (_e776 & 268435455u);
                                            let _e802 = (_e800 & 268435455u);
                                            let _e805 = ((_e776 >> bitcast<u32>(28u)) & 7u);
                                            let _e813 = ((_e776 >> bitcast<u32>(31i)) | (((_e800 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e814 = (_e805 != 0u);
                                            if (_e805 == 0u) {
                                                phi_3068_ = _e801;
                                            } else {
                                                if (_e805 == 7u) {
                                                    phi_3067_ = 2147483648u;
                                                } else {
                                                    phi_3067_ = ((2147483648u | (_e805 << bitcast<u32>(28u))) | (_e802 & 268435455u));
                                                }
                                                let _e823 = phi_3067_;
                                                phi_3068_ = _e823;
                                            }
                                            let _e825 = phi_3068_;
                                            if _e814 {
                                                let _e826 = (_e805 != 7u);
                                                if _e826 {
                                                    phi_3078_ = (_e802 + (_e805 * ((3u * _e770) + 1u)));
                                                } else {
                                                    phi_3078_ = u32();
                                                }
                                                let _e830 = phi_3078_;
                                                phi_3080_ = _e830;
                                                phi_3081_ = select(true, false, _e826);
                                            } else {
                                                phi_3080_ = u32();
                                                phi_3081_ = true;
                                            }
                                            let _e833 = phi_3080_;
                                            let _e835 = phi_3081_;
                                            if (_e813 == 0u) {
                                                phi_3102_ = (_e801 + select(0u, 1u, !(_e814)));
                                            } else {
                                                if (_e813 == 7u) {
                                                    phi_3101_ = 2147483648u;
                                                } else {
                                                    phi_3101_ = ((2147483648u | (_e813 << bitcast<u32>(28u))) | (select(_e833, _e802, _e835) & 268435455u));
                                                }
                                                let _e848 = phi_3101_;
                                                phi_3102_ = _e848;
                                            }
                                            let _e850 = phi_3102_;
                                            phi_3106_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e728, (_e546.member.member.x + _e680), _e733, (_e546.member.member_1.x - _e719)), vec4<f32>(_e729, (_e546.member.member.y + _e684), _e734, (_e546.member.member_1.y - _e723)), vec4<f32>(_e730, (_e546.member.member.z + _e688), _e735, (_e546.member.member_1.z - _e727))), type_50(type_32((_e546.member.member + vec4<f32>(_e658, _e667, _e676, 0f)), (_e546.member.member_1 - vec4<f32>(_e697, _e706, _e715, 0f))), _e825), type_50(type_32((_e546.member.member + vec4<f32>(_e680, _e684, _e688, 0f)), (_e546.member.member_1 - vec4<f32>(_e719, _e723, _e727, 0f))), _e850));
                                        }
                                        let _e855 = phi_3106_;
                                        let _e868 = ((_e855.member[0].x - _e333) * _e338);
                                        let _e869 = ((_e855.member[0].y - _e333) * _e338);
                                        let _e870 = ((_e855.member[0].z - _e334) * _e338);
                                        let _e871 = ((_e855.member[0].w - _e334) * _e338);
                                        let _e881 = ((_e855.member[1].x - _e371) * _e376);
                                        let _e882 = ((_e855.member[1].y - _e371) * _e376);
                                        let _e883 = ((_e855.member[1].z - _e372) * _e376);
                                        let _e884 = ((_e855.member[1].w - _e372) * _e376);
                                        let _e894 = ((_e855.member[2].x - _e409) * _e414);
                                        let _e895 = ((_e855.member[2].y - _e409) * _e414);
                                        let _e896 = ((_e855.member[2].z - _e410) * _e414);
                                        let _e897 = ((_e855.member[2].w - _e410) * _e414);
                                        let _e899 = select(_e896, _e894, (_e894 < _e896));
                                        let _e901 = select(_e897, _e895, (_e895 < _e897));
                                        let _e903 = select(_e896, _e894, (_e894 > _e896));
                                        let _e905 = select(_e897, _e895, (_e895 > _e897));
                                        let _e907 = select(_e870, _e868, (_e868 < _e870));
                                        let _e909 = select(_e871, _e869, (_e869 < _e871));
                                        let _e911 = select(_e883, _e881, (_e881 < _e883));
                                        let _e913 = select(_e884, _e882, (_e882 < _e884));
                                        let _e915 = select(_e911, _e907, (_e907 > _e911));
                                        let _e917 = select(_e913, _e909, (_e909 > _e913));
                                        let _e919 = select(_e899, _e915, (_e915 > _e899));
                                        let _e921 = select(_e901, _e917, (_e917 > _e901));
                                        let _e923 = select(_e870, _e868, (_e868 > _e870));
                                        let _e925 = select(_e871, _e869, (_e869 > _e871));
                                        let _e927 = select(_e883, _e881, (_e881 > _e883));
                                        let _e929 = select(_e884, _e882, (_e882 > _e884));
                                        let _e931 = select(_e927, _e923, (_e923 < _e927));
                                        let _e933 = select(_e929, _e925, (_e925 < _e929));
                                        let _e938 = -(_e899);
                                        let _e939 = -(_e901);
                                        let _e946 = (select(_e903, _e931, (_e931 < _e903)) + (select(_e938, _e903, (_e903 > _e938)) * 0.0000019073523f));
                                        let _e947 = (select(_e905, _e933, (_e933 < _e905)) + (select(_e939, _e905, (_e905 > _e939)) * 0.0000019073523f));
                                        let _e949 = select(_e461, _e919, (_e919 > _e461));
                                        let _e951 = select(_e461, _e921, (_e921 > _e461));
                                        let _e956 = (_e949 <= select(_e506.member.member_1, _e946, (_e946 < _e506.member.member_1)));
                                        let _e957 = (_e951 <= select(_e506.member.member_1, _e947, (_e947 < _e506.member.member_1)));
                                        let _e958 = (_e949 <= _e951);
                                        if _e956 {
                                            if _e957 {
                                                if _e958 {
                                                    phi_3450_ = _e855.member_2;
                                                } else {
                                                    phi_3450_ = _e855.member_1;
                                                }
                                                let _e962 = phi_3450_;
                                                let _e984 = (_e550 % 128u);
                                                let _e985 = (_e984 < 128u);
                                                if _e985 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_8[_e984] = _e962.member_1;
                                                if _e985 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_7[_e984] = _e962.member.member.x;
                                                if _e985 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_6[_e984] = _e962.member.member.y;
                                                if _e985 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_5[_e984] = _e962.member.member.z;
                                                if _e985 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_4[_e984] = _e962.member.member_1.x;
                                                if _e985 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_3[_e984] = _e962.member.member_1.y;
                                                if _e985 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_2[_e984] = _e962.member.member_1.z;
                                                if _e985 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_9[_e984] = select(_e951, _e949, (_e949 > _e951));
                                                if _e958 {
                                                    phi_3527_ = _e855.member_1;
                                                } else {
                                                    phi_3527_ = _e855.member_2;
                                                }
                                                let _e998 = phi_3527_;
                                                phi_3528_ = _e998;
                                                phi_3529_ = (_e550 + 1u);
                                            } else {
                                                phi_3528_ = type_50();
                                                phi_3529_ = u32();
                                            }
                                            let _e1000 = phi_3528_;
                                            let _e1002 = phi_3529_;
                                            phi_3531_ = _e1000;
                                            phi_3532_ = _e1002;
                                            phi_3533_ = select(true, false, _e957);
                                        } else {
                                            phi_3531_ = type_50();
                                            phi_3532_ = u32();
                                            phi_3533_ = true;
                                        }
                                        let _e1005 = phi_3531_;
                                        let _e1007 = phi_3532_;
                                        let _e1009 = phi_3533_;
                                        if _e1009 {
                                            if _e956 {
                                                phi_3542_ = _e855.member_1;
                                            } else {
                                                phi_3542_ = _e855.member_2;
                                            }
                                            let _e1013 = phi_3542_;
                                            phi_3547_ = _e1013;
                                            phi_3548_ = select(_e957, true, _e956);
                                        } else {
                                            phi_3547_ = _e1005;
                                            phi_3548_ = _e548;
                                        }
                                        let _e1016 = phi_3547_;
                                        let _e1018 = phi_3548_;
                                        phi_3935_ = _e504;
                                        phi_3550_ = type_43(_e506.member, (_e506.member_1 + 1u), _e506.member_2);
                                        phi_3551_ = _e1016;
                                        phi_3552_ = _e1018;
                                        phi_3553_ = select(_e1007, _e550, _e1009);
                                    }
                                    let _e1775 = phi_3935_;
                                    let _e1777 = phi_3550_;
                                    let _e1779 = phi_3551_;
                                    let _e1781 = phi_3552_;
                                    let _e1783 = phi_3553_;
                                    phi_3934_ = _e1775;
                                    phi_3554_ = _e1777;
                                    phi_3555_ = _e1779;
                                    phi_3556_ = (_e510 - 1u);
                                    phi_3557_ = _e1781;
                                    phi_3558_ = _e1783;
                                } else {
                                    phi_3934_ = _e504;
                                    phi_3554_ = _e506;
                                    phi_3555_ = _e546;
                                    phi_3556_ = _e510;
                                    phi_3557_ = _e548;
                                    phi_3558_ = _e550;
                                }
                                let _e1785 = phi_3934_;
                                let _e1787 = phi_3554_;
                                let _e1789 = phi_3555_;
                                let _e1791 = phi_3556_;
                                let _e1793 = phi_3557_;
                                let _e1795 = phi_3558_;
                                phi_3933_ = _e1785;
                                phi_3559_ = _e1787;
                                phi_3560_ = _e1789;
                                phi_3561_ = _e1791;
                                phi_3562_ = _e1793;
                                phi_3563_ = _e1795;
                            } else {
                                phi_3933_ = _e504;
                                phi_3559_ = type_43();
                                phi_3560_ = type_50();
                                phi_3561_ = u32();
                                phi_3562_ = bool();
                                phi_3563_ = u32();
                            }
                            let _e1797 = phi_3933_;
                            let _e1799 = phi_3559_;
                            let _e1801 = phi_3560_;
                            let _e1803 = phi_3561_;
                            let _e1805 = phi_3562_;
                            let _e1807 = phi_3563_;
                            phi_3932_ = _e1797;
                            phi_848_ = _e1799;
                            phi_851_ = _e1801;
                            phi_853_ = _e1803;
                            phi_855_ = _e1805;
                            phi_857_ = _e1807;
                            phi_3564_ = _e518;
                        } else {
                            phi_3932_ = _e504;
                            phi_848_ = type_43();
                            phi_851_ = type_50();
                            phi_853_ = u32();
                            phi_855_ = bool();
                            phi_857_ = u32();
                            phi_3564_ = false;
                        }
                        let _e1809 = phi_3932_;
                        let _e1811 = phi_848_;
                        let _e1813 = phi_851_;
                        let _e1815 = phi_853_;
                        let _e1817 = phi_855_;
                        let _e1819 = phi_857_;
                        let _e1821 = phi_3564_;
                        continue;
                        continuing {
                            phi_3776_ = _e1809;
                            phi_847_ = _e1811;
                            phi_850_ = _e1813;
                            phi_852_ = _e1815;
                            phi_854_ = _e1817;
                            phi_856_ = _e1819;
                            phi_3931_ = _e1809;
                            break if !(_e1821);
                        }
                    }
                    let _e1824 = phi_3931_;
                    if _e1824 {
                        break;
                    }
                    let _e1826 = local_10;
                    let _e1829 = local_11;
                    if _e149 {
                    } else {
                        break;
                    }
                    global_6.member[_e147][0u] = _e1826.member_1;
                    global_6.member[_e147][1u] = _e1829.member_2;
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
