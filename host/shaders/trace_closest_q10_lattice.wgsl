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

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
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
    member: type_24,
    member_1: f32,
}

struct type_41 {
    member: array<type_28>,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_32,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_44;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_41;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_26;

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
    var phi_387_: i32;
    var phi_388_: i32;
    var phi_398_: bool;
    var phi_408_: u32;
    var phi_409_: u32;
    var phi_411_: bool;
    var phi_416_: u32;
    var phi_428_: i32;
    var phi_448_: i32;
    var phi_466_: f32;
    var phi_472_: f32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_512_: f32;
    var phi_523_: f32;
    var phi_532_: f32;
    var phi_538_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_578_: f32;
    var phi_589_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_644_: f32;
    var phi_655_: f32;
    var phi_755_: f32;
    var phi_756_: f32;
    var phi_3811_: bool;
    var phi_845_: type_36;
    var phi_848_: type_49;
    var phi_850_: u32;
    var phi_852_: bool;
    var phi_854_: u32;
    var phi_865_: bool;
    var phi_951_: type_49;
    var phi_952_: bool;
    var phi_953_: u32;
    var phi_2798_: u32;
    var phi_2804_: u32;
    var phi_3058_: u32;
    var phi_3059_: u32;
    var phi_3069_: u32;
    var phi_3071_: u32;
    var phi_3072_: bool;
    var phi_3092_: u32;
    var phi_3093_: u32;
    var phi_3097_: type_50;
    var phi_3441_: type_49;
    var phi_3518_: type_49;
    var phi_3519_: type_49;
    var phi_3520_: u32;
    var phi_3522_: type_49;
    var phi_3523_: u32;
    var phi_3524_: bool;
    var phi_3533_: type_49;
    var phi_3538_: type_49;
    var phi_3539_: bool;
    var phi_972_: type_36;
    var phi_975_: type_8;
    var phi_976_: type_8;
    var phi_998_: type_8;
    var phi_1039_: u32;
    var phi_1045_: u32;
    var phi_1055_: u32;
    var phi_1071_: u32;
    var phi_1104_: u32;
    var phi_1110_: u32;
    var phi_1537_: u32;
    var phi_1555_: u32;
    var phi_1573_: u32;
    var phi_1593_: u32;
    var phi_1611_: u32;
    var phi_1629_: u32;
    var phi_1649_: u32;
    var phi_1667_: u32;
    var phi_1685_: u32;
    var phi_1263_: u32;
    var phi_1278_: u32;
    var phi_1288_: u32;
    var phi_1308_: u32;
    var phi_1328_: u32;
    var phi_1354_: u32;
    var phi_1369_: u32;
    var phi_1379_: u32;
    var phi_1399_: u32;
    var phi_1419_: u32;
    var phi_1445_: u32;
    var phi_1460_: u32;
    var phi_1470_: u32;
    var phi_1490_: u32;
    var phi_1510_: u32;
    var phi_1134_: u32;
    var phi_1177_: u32;
    var phi_1220_: u32;
    var phi_1691_: array<array<f32, 3>, 3>;
    var phi_2162_: vec3<f32>;
    var phi_2163_: vec3<f32>;
    var phi_2194_: bool;
    var phi_2203_: vec3<f32>;
    var phi_2243_: type_24;
    var phi_2245_: type_24;
    var phi_2246_: bool;
    var phi_2250_: type_24;
    var phi_2251_: type_24;
    var phi_2252_: type_24;
    var phi_2253_: bool;
    var phi_2257_: type_24;
    var phi_2258_: bool;
    var phi_2262_: type_24;
    var phi_2263_: bool;
    var phi_2267_: type_24;
    var phi_2292_: bool;
    var phi_2293_: bool;
    var phi_2299_: type_36;
    var phi_2300_: type_36;
    var phi_2301_: type_36;
    var phi_973_: type_36;
    var phi_3805_: bool;
    var phi_3970_: bool;
    var phi_3541_: type_36;
    var phi_3542_: type_49;
    var phi_3543_: bool;
    var phi_3544_: u32;
    var phi_3969_: bool;
    var phi_3545_: type_36;
    var phi_3546_: type_49;
    var phi_3547_: u32;
    var phi_3548_: bool;
    var phi_3549_: u32;
    var phi_3968_: bool;
    var phi_3550_: type_36;
    var phi_3551_: type_49;
    var phi_3552_: u32;
    var phi_3553_: bool;
    var phi_3554_: u32;
    var phi_3967_: bool;
    var phi_846_: type_36;
    var phi_849_: type_49;
    var phi_851_: u32;
    var phi_853_: bool;
    var phi_855_: u32;
    var phi_3555_: bool;
    var phi_3966_: bool;
    var local_10: type_36;
    var phi_3607_: type_24;
    var local_11: type_36;

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
                            phi_387_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_387_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                        }
                        let _e240 = phi_387_;
                        phi_388_ = _e240;
                    } else {
                        phi_388_ = 0i;
                    }
                    let _e242 = phi_388_;
                    let _e243 = (_e159 == _e198);
                    if _e243 {
                        phi_398_ = true;
                    } else {
                        phi_398_ = (_e166 == _e198);
                    }
                    let _e246 = phi_398_;
                    let _e247 = select(1u, 0u, _e243);
                    if _e246 {
                        let _e248 = (_e247 + 1u);
                        phi_408_ = _e248;
                        phi_409_ = _e248;
                        phi_411_ = select(true, false, (_e248 == 2u));
                    } else {
                        phi_408_ = u32();
                        phi_409_ = 0u;
                        phi_411_ = true;
                    }
                    let _e252 = phi_408_;
                    let _e254 = phi_409_;
                    let _e256 = phi_411_;
                    if _e256 {
                        phi_416_ = (_e254 + 1u);
                    } else {
                        phi_416_ = 0u;
                    }
                    let _e260 = phi_416_;
                    let _e261 = select(_e252, _e254, _e256);
                    let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                    if (_e129 < -126i) {
                        phi_428_ = -126i;
                    } else {
                        phi_428_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e267 = phi_428_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e129 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = -(_e242);
                    if (_e279 < -126i) {
                        phi_448_ = -126i;
                    } else {
                        phi_448_ = select(_e279, 127i, (_e279 > 127i));
                    }
                    let _e284 = phi_448_;
                    let _e289 = bitcast<f32>((bitcast<u32>((_e284 + 127i)) << bitcast<u32>(23i)));
                    let _e295 = bitcast<f32>((bitcast<u32>(((_e279 - _e284) + 127i)) << bitcast<u32>(23i)));
                    let _e299 = global_4.member[_e147].member;
                    let _e300 = (_e261 == 0u);
                    if _e300 {
                        phi_466_ = _e299[0];
                    } else {
                        phi_466_ = _e299[1];
                    }
                    let _e304 = phi_466_;
                    let _e305 = (_e261 == 2u);
                    if _e305 {
                        phi_472_ = _e299[2];
                    } else {
                        phi_472_ = _e304;
                    }
                    let _e308 = phi_472_;
                    let _e310 = ((_e308 * _e272) * _e278);
                    let _e311 = global_4.member[_e147].member_2;
                    if _e300 {
                        phi_483_ = _e311[0];
                    } else {
                        phi_483_ = _e311[1];
                    }
                    let _e315 = phi_483_;
                    if _e305 {
                        phi_489_ = _e311[2];
                    } else {
                        phi_489_ = _e315;
                    }
                    let _e318 = phi_489_;
                    let _e320 = ((_e318 * _e289) * _e295);
                    let _e324 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e324 {
                        let _e328 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) * 0.00000011920929f);
                        phi_512_ = select(0.00000000000011368684f, _e328, (_e328 > 0.00000000000011368684f));
                    } else {
                        phi_512_ = 0f;
                    }
                    let _e332 = phi_512_;
                    let _e333 = (_e310 + _e332);
                    let _e334 = (_e310 - _e332);
                    let _e335 = select(_e320, 0f, _e324);
                    if _e324 {
                        phi_523_ = 38685626000000000000000000f;
                    } else {
                        phi_523_ = (1f / _e320);
                    }
                    let _e338 = phi_523_;
                    let _e339 = (_e260 == 0u);
                    if _e339 {
                        phi_532_ = _e299[0];
                    } else {
                        phi_532_ = _e299[1];
                    }
                    let _e343 = phi_532_;
                    let _e344 = (_e260 == 2u);
                    if _e344 {
                        phi_538_ = _e299[2];
                    } else {
                        phi_538_ = _e343;
                    }
                    let _e347 = phi_538_;
                    let _e349 = ((_e347 * _e272) * _e278);
                    if _e339 {
                        phi_549_ = _e311[0];
                    } else {
                        phi_549_ = _e311[1];
                    }
                    let _e353 = phi_549_;
                    if _e344 {
                        phi_555_ = _e311[2];
                    } else {
                        phi_555_ = _e353;
                    }
                    let _e356 = phi_555_;
                    let _e358 = ((_e356 * _e289) * _e295);
                    let _e362 = (bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e362 {
                        let _e366 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) * 0.00000011920929f);
                        phi_578_ = select(0.00000000000011368684f, _e366, (_e366 > 0.00000000000011368684f));
                    } else {
                        phi_578_ = 0f;
                    }
                    let _e370 = phi_578_;
                    let _e371 = (_e349 + _e370);
                    let _e372 = (_e349 - _e370);
                    let _e373 = select(_e358, 0f, _e362);
                    if _e362 {
                        phi_589_ = 38685626000000000000000000f;
                    } else {
                        phi_589_ = (1f / _e358);
                    }
                    let _e376 = phi_589_;
                    let _e377 = (_e262 == 0u);
                    if _e377 {
                        phi_598_ = _e299[0];
                    } else {
                        phi_598_ = _e299[1];
                    }
                    let _e381 = phi_598_;
                    let _e382 = (_e262 == 2u);
                    if _e382 {
                        phi_604_ = _e299[2];
                    } else {
                        phi_604_ = _e381;
                    }
                    let _e385 = phi_604_;
                    let _e387 = ((_e385 * _e272) * _e278);
                    if _e377 {
                        phi_615_ = _e311[0];
                    } else {
                        phi_615_ = _e311[1];
                    }
                    let _e391 = phi_615_;
                    if _e382 {
                        phi_621_ = _e311[2];
                    } else {
                        phi_621_ = _e391;
                    }
                    let _e394 = phi_621_;
                    let _e396 = ((_e394 * _e289) * _e295);
                    let _e400 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e400 {
                        let _e404 = (bitcast<f32>((bitcast<u32>(_e387) & 2147483647u)) * 0.00000011920929f);
                        phi_644_ = select(0.00000000000011368684f, _e404, (_e404 > 0.00000000000011368684f));
                    } else {
                        phi_644_ = 0f;
                    }
                    let _e408 = phi_644_;
                    let _e409 = (_e387 + _e408);
                    let _e410 = (_e387 - _e408);
                    let _e411 = select(_e396, 0f, _e400);
                    if _e400 {
                        phi_655_ = 38685626000000000000000000f;
                    } else {
                        phi_655_ = (1f / _e396);
                    }
                    let _e414 = phi_655_;
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
                        phi_755_ = select(-340282350000000000000000000000000000000f, _e455, (_e455 > -340282350000000000000000000000000000000f));
                        phi_756_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_755_ = 0f;
                        phi_756_ = 1f;
                    }
                    let _e459 = phi_755_;
                    let _e461 = phi_756_;
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
                    phi_3811_ = false;
                    phi_845_ = type_36(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e459);
                    phi_848_ = type_49(type_32(vec4<f32>((f32(_e468) * _e141), (f32(_e474) * _e141), (f32(_e480) * _e141), 0f), vec4<f32>((f32(_e485) * _e141), (f32(_e489) * _e141), (f32(_e493) * _e141), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_850_ = ((3u * _e90) + 1u);
                    phi_852_ = (_e461 <= _e459);
                    phi_854_ = 0u;
                    loop {
                        let _e503 = phi_3811_;
                        let _e505 = phi_845_;
                        let _e507 = phi_848_;
                        let _e509 = phi_850_;
                        let _e511 = phi_852_;
                        let _e513 = phi_854_;
                        local_10 = _e505;
                        if _e511 {
                            phi_865_ = true;
                        } else {
                            phi_865_ = (_e513 > 0u);
                        }
                        let _e516 = phi_865_;
                        if _e516 {
                            let _e517 = (_e509 > 0u);
                            if _e517 {
                                if _e511 {
                                    phi_951_ = _e507;
                                    phi_952_ = _e511;
                                    phi_953_ = _e513;
                                } else {
                                    let _e518 = (_e513 - 1u);
                                    let _e519 = (_e518 % 128u);
                                    let _e520 = (_e519 < 128u);
                                    if _e520 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e522 = local_7[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e524 = local_6[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e526 = local_5[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e528 = local_4[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e530 = local_3[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e532 = local_2[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e537 = local_8[_e519];
                                    if _e520 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e540 = local_9[_e519];
                                    phi_951_ = type_49(type_32(vec4<f32>(_e522, _e524, _e526, 0f), vec4<f32>(_e528, _e530, _e532, 0f)), _e537);
                                    phi_952_ = (_e540 <= _e505.member_1);
                                    phi_953_ = _e518;
                                }
                                let _e544 = phi_951_;
                                let _e546 = phi_952_;
                                let _e548 = phi_953_;
                                if _e546 {
                                    let _e553 = (_e544.member_1 & 268435455u);
                                    if ((_e544.member_1 & 2147483648u) != 0u) {
                                        phi_972_ = _e505;
                                        phi_975_ = type_8(0u, ((_e544.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1013 = phi_972_;
                                            let _e1015 = phi_975_;
                                            local_11 = _e1013;
                                            if (_e1015.member < _e1015.member_1) {
                                                phi_976_ = type_8((_e1015.member + 1u), _e1015.member_1);
                                                phi_998_ = type_8(1u, _e1015.member);
                                            } else {
                                                phi_976_ = _e1015;
                                                phi_998_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1028 = phi_976_;
                                            let _e1030 = phi_998_;
                                            let _e1034 = (bitcast<i32>(_e1030.member) != 0i);
                                            if _e1034 {
                                                let _e1039 = (_e544.member.member_1.x - _e544.member.member.x);
                                                let _e1042 = (_e544.member.member_1.y - _e544.member.member.y);
                                                let _e1045 = (_e544.member.member_1.z - _e544.member.member.z);
                                                let _e1047 = select(_e1042, _e1039, (_e1039 > _e1042));
                                                let _e1049 = select(_e1045, _e1047, (_e1047 > _e1045));
                                                let _e1051 = (_e1049 < (1024f * _e141));
                                                if _e1051 {
                                                    phi_1039_ = 0u;
                                                } else {
                                                    phi_1039_ = select(2u, 1u, (_e1049 < (2097152f * _e141)));
                                                }
                                                let _e1056 = phi_1039_;
                                                switch bitcast<i32>(_e1056) {
                                                    case 0: {
                                                        phi_1045_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1045_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1045_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1045_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1059 = phi_1045_;
                                                switch bitcast<i32>(_e1056) {
                                                    case 0: {
                                                        phi_1055_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1055_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1055_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1055_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1066 = phi_1055_;
                                                let _e1068 = ((_e553 + (_e1030.member_1 * ((3u * _e1059) + 1u))) + (3u * _e1066));
                                                let _e1069 = (_e1068 < _e93);
                                                if _e1069 {
                                                    if _e1069 {
                                                    } else {
                                                        phi_3805_ = true;
                                                        break;
                                                    }
                                                    let _e1071 = global_5.member[_e1068];
                                                    phi_1071_ = _e1071;
                                                } else {
                                                    phi_1071_ = 4294967295u;
                                                }
                                                let _e1073 = phi_1071_;
                                                if _e1051 {
                                                    phi_1104_ = 0u;
                                                } else {
                                                    phi_1104_ = select(2u, 1u, (_e1049 < (2097152f * _e141)));
                                                }
                                                let _e1078 = phi_1104_;
                                                switch bitcast<i32>(_e1078) {
                                                    case 0: {
                                                        phi_1110_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1110_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1110_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1110_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1081 = phi_1110_;
                                                let _e1085 = (_e553 + (_e1030.member_1 * ((3u * _e1081) + 1u)));
                                                switch bitcast<i32>(_e1078) {
                                                    case 0: {
                                                        let _e1351 = (_e1085 < _e93);
                                                        if _e1351 {
                                                            if _e1351 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1353 = global_5.member[_e1085];
                                                            phi_1134_ = _e1353;
                                                        } else {
                                                            phi_1134_ = 0u;
                                                        }
                                                        let _e1355 = phi_1134_;
                                                        let _e1357 = ((10u * _e261) & 31u);
                                                        let _e1366 = ((10u * _e260) & 31u);
                                                        let _e1375 = ((10u * _e262) & 31u);
                                                        let _e1384 = (_e1085 + 1u);
                                                        let _e1385 = (_e1384 < _e93);
                                                        if _e1385 {
                                                            if _e1385 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1387 = global_5.member[_e1384];
                                                            phi_1177_ = _e1387;
                                                        } else {
                                                            phi_1177_ = 0u;
                                                        }
                                                        let _e1389 = phi_1177_;
                                                        let _e1412 = (_e1085 + 2u);
                                                        let _e1413 = (_e1412 < _e93);
                                                        if _e1413 {
                                                            if _e1413 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1415 = global_5.member[_e1412];
                                                            phi_1220_ = _e1415;
                                                        } else {
                                                            phi_1220_ = 0u;
                                                        }
                                                        let _e1417 = phi_1220_;
                                                        phi_1691_ = array<array<f32, 3>, 3>(array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1355 >> bitcast<u32>(_e1357)) & 1023u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1355 >> bitcast<u32>(_e1366)) & 1023u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1355 >> bitcast<u32>(_e1375)) & 1023u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1389 >> bitcast<u32>(_e1357)) & 1023u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1389 >> bitcast<u32>(_e1366)) & 1023u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1389 >> bitcast<u32>(_e1375)) & 1023u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1417 >> bitcast<u32>(_e1357)) & 1023u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1417 >> bitcast<u32>(_e1366)) & 1023u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1417 >> bitcast<u32>(_e1375)) & 1023u))) * _e141))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1174 = (_e1085 < _e93);
                                                        if _e1174 {
                                                            if _e1174 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1176 = global_5.member[_e1085];
                                                            phi_1263_ = _e1176;
                                                        } else {
                                                            phi_1263_ = 0u;
                                                        }
                                                        let _e1178 = phi_1263_;
                                                        let _e1179 = (_e1085 + 1u);
                                                        let _e1180 = (_e1179 < _e93);
                                                        if _e1180 {
                                                            if _e1180 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1182 = global_5.member[_e1179];
                                                            phi_1278_ = _e1182;
                                                        } else {
                                                            phi_1278_ = 0u;
                                                        }
                                                        let _e1184 = phi_1278_;
                                                        let _e1185 = (_e261 == 1u);
                                                        if _e1185 {
                                                            phi_1288_ = ((_e1178 >> bitcast<u32>(21i)) | (_e1184 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1288_ = (_e1184 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1194 = phi_1288_;
                                                        let _e1201 = (_e260 == 1u);
                                                        if _e1201 {
                                                            phi_1308_ = ((_e1178 >> bitcast<u32>(21i)) | (_e1184 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1308_ = (_e1184 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1210 = phi_1308_;
                                                        let _e1217 = (_e262 == 1u);
                                                        if _e1217 {
                                                            phi_1328_ = ((_e1178 >> bitcast<u32>(21i)) | (_e1184 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1328_ = (_e1184 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1226 = phi_1328_;
                                                        let _e1234 = (_e1085 + 2u);
                                                        let _e1235 = (_e1234 < _e93);
                                                        if _e1235 {
                                                            if _e1235 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1237 = global_5.member[_e1234];
                                                            phi_1354_ = _e1237;
                                                        } else {
                                                            phi_1354_ = 0u;
                                                        }
                                                        let _e1239 = phi_1354_;
                                                        let _e1240 = (_e1085 + 3u);
                                                        let _e1241 = (_e1240 < _e93);
                                                        if _e1241 {
                                                            if _e1241 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1243 = global_5.member[_e1240];
                                                            phi_1369_ = _e1243;
                                                        } else {
                                                            phi_1369_ = 0u;
                                                        }
                                                        let _e1245 = phi_1369_;
                                                        if _e1185 {
                                                            phi_1379_ = ((_e1239 >> bitcast<u32>(21i)) | (_e1245 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1379_ = (_e1245 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1254 = phi_1379_;
                                                        if _e1201 {
                                                            phi_1399_ = ((_e1239 >> bitcast<u32>(21i)) | (_e1245 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1399_ = (_e1245 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1269 = phi_1399_;
                                                        if _e1217 {
                                                            phi_1419_ = ((_e1239 >> bitcast<u32>(21i)) | (_e1245 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1419_ = (_e1245 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1284 = phi_1419_;
                                                        let _e1292 = (_e1085 + 4u);
                                                        let _e1293 = (_e1292 < _e93);
                                                        if _e1293 {
                                                            if _e1293 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1295 = global_5.member[_e1292];
                                                            phi_1445_ = _e1295;
                                                        } else {
                                                            phi_1445_ = 0u;
                                                        }
                                                        let _e1297 = phi_1445_;
                                                        let _e1298 = (_e1085 + 5u);
                                                        let _e1299 = (_e1298 < _e93);
                                                        if _e1299 {
                                                            if _e1299 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1301 = global_5.member[_e1298];
                                                            phi_1460_ = _e1301;
                                                        } else {
                                                            phi_1460_ = 0u;
                                                        }
                                                        let _e1303 = phi_1460_;
                                                        if _e1185 {
                                                            phi_1470_ = ((_e1297 >> bitcast<u32>(21i)) | (_e1303 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1470_ = (_e1303 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1312 = phi_1470_;
                                                        if _e1201 {
                                                            phi_1490_ = ((_e1297 >> bitcast<u32>(21i)) | (_e1303 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1490_ = (_e1303 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1327 = phi_1490_;
                                                        if _e1217 {
                                                            phi_1510_ = ((_e1297 >> bitcast<u32>(21i)) | (_e1303 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1510_ = (_e1303 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1342 = phi_1510_;
                                                        phi_1691_ = array<array<f32, 3>, 3>(array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1194, _e1178, _e300) & 2097151u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1210, _e1178, _e339) & 2097151u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1226, _e1178, _e377) & 2097151u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1254, _e1239, _e300) & 2097151u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1269, _e1239, _e339) & 2097151u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1284, _e1239, _e377) & 2097151u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1312, _e1297, _e300) & 2097151u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1327, _e1297, _e339) & 2097151u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1342, _e1297, _e377) & 2097151u))) * _e141))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1087 = (_e1085 + _e261);
                                                        let _e1088 = (_e1087 < _e93);
                                                        if _e1088 {
                                                            if _e1088 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1090 = global_5.member[_e1087];
                                                            phi_1537_ = _e1090;
                                                        } else {
                                                            phi_1537_ = 0u;
                                                        }
                                                        let _e1092 = phi_1537_;
                                                        let _e1096 = (_e1085 + _e260);
                                                        let _e1097 = (_e1096 < _e93);
                                                        if _e1097 {
                                                            if _e1097 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1099 = global_5.member[_e1096];
                                                            phi_1555_ = _e1099;
                                                        } else {
                                                            phi_1555_ = 0u;
                                                        }
                                                        let _e1101 = phi_1555_;
                                                        let _e1105 = (_e1085 + _e262);
                                                        let _e1106 = (_e1105 < _e93);
                                                        if _e1106 {
                                                            if _e1106 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1108 = global_5.member[_e1105];
                                                            phi_1573_ = _e1108;
                                                        } else {
                                                            phi_1573_ = 0u;
                                                        }
                                                        let _e1110 = phi_1573_;
                                                        let _e1115 = (_e1085 + 3u);
                                                        let _e1116 = (_e1115 + _e261);
                                                        let _e1117 = (_e1116 < _e93);
                                                        if _e1117 {
                                                            if _e1117 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1119 = global_5.member[_e1116];
                                                            phi_1593_ = _e1119;
                                                        } else {
                                                            phi_1593_ = 0u;
                                                        }
                                                        let _e1121 = phi_1593_;
                                                        let _e1125 = (_e1115 + _e260);
                                                        let _e1126 = (_e1125 < _e93);
                                                        if _e1126 {
                                                            if _e1126 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1128 = global_5.member[_e1125];
                                                            phi_1611_ = _e1128;
                                                        } else {
                                                            phi_1611_ = 0u;
                                                        }
                                                        let _e1130 = phi_1611_;
                                                        let _e1134 = (_e1115 + _e262);
                                                        let _e1135 = (_e1134 < _e93);
                                                        if _e1135 {
                                                            if _e1135 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1137 = global_5.member[_e1134];
                                                            phi_1629_ = _e1137;
                                                        } else {
                                                            phi_1629_ = 0u;
                                                        }
                                                        let _e1139 = phi_1629_;
                                                        let _e1144 = (_e1085 + 6u);
                                                        let _e1145 = (_e1144 + _e261);
                                                        let _e1146 = (_e1145 < _e93);
                                                        if _e1146 {
                                                            if _e1146 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1148 = global_5.member[_e1145];
                                                            phi_1649_ = _e1148;
                                                        } else {
                                                            phi_1649_ = 0u;
                                                        }
                                                        let _e1150 = phi_1649_;
                                                        let _e1154 = (_e1144 + _e260);
                                                        let _e1155 = (_e1154 < _e93);
                                                        if _e1155 {
                                                            if _e1155 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1157 = global_5.member[_e1154];
                                                            phi_1667_ = _e1157;
                                                        } else {
                                                            phi_1667_ = 0u;
                                                        }
                                                        let _e1159 = phi_1667_;
                                                        let _e1163 = (_e1144 + _e262);
                                                        let _e1164 = (_e1163 < _e93);
                                                        if _e1164 {
                                                            if _e1164 {
                                                            } else {
                                                                phi_3805_ = true;
                                                                break;
                                                            }
                                                            let _e1166 = global_5.member[_e1163];
                                                            phi_1685_ = _e1166;
                                                        } else {
                                                            phi_1685_ = 0u;
                                                        }
                                                        let _e1168 = phi_1685_;
                                                        phi_1691_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1092)) * _e141), (f32(bitcast<i32>(_e1101)) * _e141), (f32(bitcast<i32>(_e1110)) * _e141)), array<f32, 3>((f32(bitcast<i32>(_e1121)) * _e141), (f32(bitcast<i32>(_e1130)) * _e141), (f32(bitcast<i32>(_e1139)) * _e141)), array<f32, 3>((f32(bitcast<i32>(_e1150)) * _e141), (f32(bitcast<i32>(_e1159)) * _e141), (f32(bitcast<i32>(_e1168)) * _e141)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1691_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1442 = phi_1691_;
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
                                                        phi_2257_ = type_24();
                                                        phi_2258_ = true;
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
                                                            phi_2252_ = type_24();
                                                            phi_2253_ = true;
                                                        } else {
                                                            let _e1580 = (_e1578 > _e1013.member_1);
                                                            if _e1580 {
                                                                phi_2251_ = type_24();
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
                                                                    phi_2162_ = _e1591;
                                                                    phi_2163_ = _e1595;
                                                                } else {
                                                                    let _e1641 = vec3((_e1621 == _e1638));
                                                                    phi_2162_ = select(_e1587, _e1595, _e1641);
                                                                    phi_2163_ = select(_e1591, _e1587, _e1641);
                                                                }
                                                                let _e1645 = phi_2162_;
                                                                let _e1647 = phi_2163_;
                                                                let _e1654 = ((_e1645.y * _e1647.z) - (_e1647.y * _e1645.z));
                                                                let _e1659 = ((_e1645.z * _e1647.x) - (_e1647.z * _e1645.x));
                                                                let _e1662 = ((_e1645.x * _e1647.y) - (_e1647.x * _e1645.y));
                                                                if (_e1504 >= _e1508) {
                                                                    phi_2194_ = select(true, false, (_e1504 >= _e1512));
                                                                } else {
                                                                    phi_2194_ = true;
                                                                }
                                                                let _e1667 = phi_2194_;
                                                                if _e1667 {
                                                                    phi_2203_ = select(vec3<f32>(_e1442[2][0], _e1442[2][1], _e1442[2][2]), vec3<f32>(_e1442[1][0], _e1442[1][1], _e1442[1][2]), vec3((_e1508 >= _e1512)));
                                                                } else {
                                                                    phi_2203_ = vec3<f32>(_e1442[0][0], _e1442[0][1], _e1442[0][2]);
                                                                }
                                                                let _e1672 = phi_2203_;
                                                                let _e1689 = ((((_e1654 * (_e1672.x - _e310)) + (_e1659 * (_e1672.y - _e349))) + (_e1662 * (_e1672.z - _e387))) / (((_e1654 * _e335) + (_e1659 * _e373)) + (_e1662 * _e411)));
                                                                let _e1691 = select(_e1571, _e1689, (_e1689 < _e1571));
                                                                let _e1693 = select(_e1563, _e1691, (_e1691 > _e1563));
                                                                if (_e1693 >= _e461) {
                                                                    let _e1695 = (_e1693 <= _e1013.member_1);
                                                                    if _e1695 {
                                                                        let _e1696 = (1f / _e1514);
                                                                        phi_2243_ = type_24(_e1693, (_e1508 * _e1696), (_e1512 * _e1696), _e1073);
                                                                    } else {
                                                                        phi_2243_ = type_24();
                                                                    }
                                                                    let _e1701 = phi_2243_;
                                                                    phi_2245_ = _e1701;
                                                                    phi_2246_ = select(true, false, _e1695);
                                                                } else {
                                                                    phi_2245_ = type_24();
                                                                    phi_2246_ = true;
                                                                }
                                                                let _e1704 = phi_2245_;
                                                                let _e1706 = phi_2246_;
                                                                if _e1706 {
                                                                    phi_2250_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2250_ = _e1704;
                                                                }
                                                                let _e1708 = phi_2250_;
                                                                phi_2251_ = _e1708;
                                                            }
                                                            let _e1710 = phi_2251_;
                                                            phi_2252_ = _e1710;
                                                            phi_2253_ = _e1580;
                                                        }
                                                        let _e1712 = phi_2252_;
                                                        let _e1714 = phi_2253_;
                                                        phi_2257_ = _e1712;
                                                        phi_2258_ = _e1714;
                                                    }
                                                    let _e1716 = phi_2257_;
                                                    let _e1718 = phi_2258_;
                                                    phi_2262_ = _e1716;
                                                    phi_2263_ = _e1718;
                                                } else {
                                                    phi_2262_ = type_24();
                                                    phi_2263_ = true;
                                                }
                                                let _e1720 = phi_2262_;
                                                let _e1722 = phi_2263_;
                                                if _e1722 {
                                                    phi_2267_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2267_ = _e1720;
                                                }
                                                let _e1724 = phi_2267_;
                                                if (_e1724.member_3 != 4294967295u) {
                                                    if (_e1073 != 4294967295u) {
                                                        if (_e1724.member < _e1013.member.member) {
                                                            phi_2293_ = true;
                                                        } else {
                                                            if (_e1724.member == _e1013.member.member) {
                                                                phi_2292_ = (_e1724.member_3 < _e1013.member.member_3);
                                                            } else {
                                                                phi_2292_ = false;
                                                            }
                                                            let _e1737 = phi_2292_;
                                                            phi_2293_ = _e1737;
                                                        }
                                                        let _e1739 = phi_2293_;
                                                        if _e1739 {
                                                            phi_2299_ = type_36(_e1724, _e1724.member);
                                                        } else {
                                                            phi_2299_ = _e1013;
                                                        }
                                                        let _e1742 = phi_2299_;
                                                        phi_2300_ = _e1742;
                                                    } else {
                                                        phi_2300_ = _e1013;
                                                    }
                                                    let _e1744 = phi_2300_;
                                                    phi_2301_ = _e1744;
                                                } else {
                                                    phi_2301_ = _e1013;
                                                }
                                                let _e1746 = phi_2301_;
                                                phi_973_ = _e1746;
                                            } else {
                                                phi_973_ = type_36();
                                            }
                                            let _e1748 = phi_973_;
                                            continue;
                                            continuing {
                                                phi_972_ = _e1748;
                                                phi_975_ = _e1028;
                                                phi_3805_ = _e503;
                                                break if !(_e1034);
                                            }
                                        }
                                        let _e1751 = phi_3805_;
                                        phi_3966_ = _e1751;
                                        if _e1751 {
                                            break;
                                        }
                                        phi_3970_ = _e1751;
                                        let _e1960 = local_11;
                                        phi_3541_ = _e1960;
                                        phi_3542_ = _e544;
                                        phi_3543_ = false;
                                        phi_3544_ = _e548;
                                    } else {
                                        if (_e544.member_1 >= _e90) {
                                            phi_3097_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e544.member_1 < _e90) {
                                            } else {
                                                phi_3966_ = true;
                                                break;
                                            }
                                            let _e561 = ((1u + _e261) % 4u);
                                            if (_e561 < 4u) {
                                            } else {
                                                phi_3966_ = true;
                                                break;
                                            }
                                            let _e566 = global_3.member[_e544.member_1][_e561];
                                            let _e568 = (_e566 >> bitcast<u32>(11u));
                                            let _e570 = ((1u + _e260) % 4u);
                                            if (_e570 < 4u) {
                                            } else {
                                                phi_3966_ = true;
                                                break;
                                            }
                                            let _e575 = global_3.member[_e544.member_1][_e570];
                                            let _e577 = (_e575 >> bitcast<u32>(11u));
                                            let _e579 = ((1u + _e262) % 4u);
                                            if (_e579 < 4u) {
                                            } else {
                                                phi_3966_ = true;
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
                                                phi_2798_ = 0u;
                                            } else {
                                                phi_2798_ = select(2u, 1u, (_e752 < (2097152f * _e141)));
                                            }
                                            let _e759 = phi_2798_;
                                            switch bitcast<i32>(_e759) {
                                                case 0: {
                                                    phi_2804_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2804_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2804_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2804_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e762 = phi_2804_;
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
                                                phi_3059_ = _e793;
                                            } else {
                                                if (_e797 == 7u) {
                                                    phi_3058_ = 2147483648u;
                                                } else {
                                                    phi_3058_ = ((2147483648u | (_e797 << bitcast<u32>(28u))) | (_e794 & 268435455u));
                                                }
                                                let _e815 = phi_3058_;
                                                phi_3059_ = _e815;
                                            }
                                            let _e817 = phi_3059_;
                                            if _e806 {
                                                let _e818 = (_e797 != 7u);
                                                if _e818 {
                                                    phi_3069_ = (_e794 + (_e797 * ((3u * _e762) + 1u)));
                                                } else {
                                                    phi_3069_ = u32();
                                                }
                                                let _e822 = phi_3069_;
                                                phi_3071_ = _e822;
                                                phi_3072_ = select(true, false, _e818);
                                            } else {
                                                phi_3071_ = u32();
                                                phi_3072_ = true;
                                            }
                                            let _e825 = phi_3071_;
                                            let _e827 = phi_3072_;
                                            if (_e805 == 0u) {
                                                phi_3093_ = (_e793 + select(0u, 1u, !(_e806)));
                                            } else {
                                                if (_e805 == 7u) {
                                                    phi_3092_ = 2147483648u;
                                                } else {
                                                    phi_3092_ = ((2147483648u | (_e805 << bitcast<u32>(28u))) | (select(_e825, _e794, _e827) & 268435455u));
                                                }
                                                let _e840 = phi_3092_;
                                                phi_3093_ = _e840;
                                            }
                                            let _e842 = phi_3093_;
                                            phi_3097_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e720, (_e544.member.member.x + _e672), _e725, (_e544.member.member_1.x - _e711)), vec4<f32>(_e721, (_e544.member.member.y + _e676), _e726, (_e544.member.member_1.y - _e715)), vec4<f32>(_e722, (_e544.member.member.z + _e680), _e727, (_e544.member.member_1.z - _e719))), type_49(type_32((_e544.member.member + vec4<f32>(_e650, _e659, _e668, 0f)), (_e544.member.member_1 - vec4<f32>(_e689, _e698, _e707, 0f))), _e817), type_49(type_32((_e544.member.member + vec4<f32>(_e672, _e676, _e680, 0f)), (_e544.member.member_1 - vec4<f32>(_e711, _e715, _e719, 0f))), _e842));
                                        }
                                        let _e847 = phi_3097_;
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
                                        let _e947 = (_e940 <= select(_e505.member_1, _e937, (_e937 < _e505.member_1)));
                                        let _e948 = (_e942 <= select(_e505.member_1, _e938, (_e938 < _e505.member_1)));
                                        let _e949 = (_e940 <= _e942);
                                        if _e947 {
                                            if _e948 {
                                                if _e949 {
                                                    phi_3441_ = _e847.member_2;
                                                } else {
                                                    phi_3441_ = _e847.member_1;
                                                }
                                                let _e953 = phi_3441_;
                                                let _e975 = (_e548 % 128u);
                                                let _e976 = (_e975 < 128u);
                                                if _e976 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_8[_e975] = _e953.member_1;
                                                if _e976 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_7[_e975] = _e953.member.member.x;
                                                if _e976 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_6[_e975] = _e953.member.member.y;
                                                if _e976 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_5[_e975] = _e953.member.member.z;
                                                if _e976 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_4[_e975] = _e953.member.member_1.x;
                                                if _e976 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_3[_e975] = _e953.member.member_1.y;
                                                if _e976 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_2[_e975] = _e953.member.member_1.z;
                                                if _e976 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_9[_e975] = select(_e942, _e940, (_e940 > _e942));
                                                if _e949 {
                                                    phi_3518_ = _e847.member_1;
                                                } else {
                                                    phi_3518_ = _e847.member_2;
                                                }
                                                let _e989 = phi_3518_;
                                                phi_3519_ = _e989;
                                                phi_3520_ = (_e548 + 1u);
                                            } else {
                                                phi_3519_ = type_49();
                                                phi_3520_ = u32();
                                            }
                                            let _e991 = phi_3519_;
                                            let _e993 = phi_3520_;
                                            phi_3522_ = _e991;
                                            phi_3523_ = _e993;
                                            phi_3524_ = select(true, false, _e948);
                                        } else {
                                            phi_3522_ = type_49();
                                            phi_3523_ = u32();
                                            phi_3524_ = true;
                                        }
                                        let _e996 = phi_3522_;
                                        let _e998 = phi_3523_;
                                        let _e1000 = phi_3524_;
                                        if _e1000 {
                                            if _e947 {
                                                phi_3533_ = _e847.member_1;
                                            } else {
                                                phi_3533_ = _e847.member_2;
                                            }
                                            let _e1004 = phi_3533_;
                                            phi_3538_ = _e1004;
                                            phi_3539_ = select(_e948, true, _e947);
                                        } else {
                                            phi_3538_ = _e996;
                                            phi_3539_ = _e546;
                                        }
                                        let _e1007 = phi_3538_;
                                        let _e1009 = phi_3539_;
                                        phi_3970_ = _e503;
                                        phi_3541_ = _e505;
                                        phi_3542_ = _e1007;
                                        phi_3543_ = _e1009;
                                        phi_3544_ = select(_e998, _e548, _e1000);
                                    }
                                    let _e1753 = phi_3970_;
                                    let _e1755 = phi_3541_;
                                    let _e1757 = phi_3542_;
                                    let _e1759 = phi_3543_;
                                    let _e1761 = phi_3544_;
                                    phi_3969_ = _e1753;
                                    phi_3545_ = _e1755;
                                    phi_3546_ = _e1757;
                                    phi_3547_ = (_e509 - 1u);
                                    phi_3548_ = _e1759;
                                    phi_3549_ = _e1761;
                                } else {
                                    phi_3969_ = _e503;
                                    phi_3545_ = _e505;
                                    phi_3546_ = _e544;
                                    phi_3547_ = _e509;
                                    phi_3548_ = _e546;
                                    phi_3549_ = _e548;
                                }
                                let _e1763 = phi_3969_;
                                let _e1765 = phi_3545_;
                                let _e1767 = phi_3546_;
                                let _e1769 = phi_3547_;
                                let _e1771 = phi_3548_;
                                let _e1773 = phi_3549_;
                                phi_3968_ = _e1763;
                                phi_3550_ = _e1765;
                                phi_3551_ = _e1767;
                                phi_3552_ = _e1769;
                                phi_3553_ = _e1771;
                                phi_3554_ = _e1773;
                            } else {
                                phi_3968_ = _e503;
                                phi_3550_ = type_36();
                                phi_3551_ = type_49();
                                phi_3552_ = u32();
                                phi_3553_ = bool();
                                phi_3554_ = u32();
                            }
                            let _e1775 = phi_3968_;
                            let _e1777 = phi_3550_;
                            let _e1779 = phi_3551_;
                            let _e1781 = phi_3552_;
                            let _e1783 = phi_3553_;
                            let _e1785 = phi_3554_;
                            phi_3967_ = _e1775;
                            phi_846_ = _e1777;
                            phi_849_ = _e1779;
                            phi_851_ = _e1781;
                            phi_853_ = _e1783;
                            phi_855_ = _e1785;
                            phi_3555_ = _e517;
                        } else {
                            phi_3967_ = _e503;
                            phi_846_ = type_36();
                            phi_849_ = type_49();
                            phi_851_ = u32();
                            phi_853_ = bool();
                            phi_855_ = u32();
                            phi_3555_ = false;
                        }
                        let _e1787 = phi_3967_;
                        let _e1789 = phi_846_;
                        let _e1791 = phi_849_;
                        let _e1793 = phi_851_;
                        let _e1795 = phi_853_;
                        let _e1797 = phi_855_;
                        let _e1799 = phi_3555_;
                        continue;
                        continuing {
                            phi_3811_ = _e1787;
                            phi_845_ = _e1789;
                            phi_848_ = _e1791;
                            phi_850_ = _e1793;
                            phi_852_ = _e1795;
                            phi_854_ = _e1797;
                            phi_3966_ = _e1787;
                            break if !(_e1799);
                        }
                    }
                    let _e1802 = phi_3966_;
                    if _e1802 {
                        break;
                    }
                    let _e1804 = local_10;
                    if (_e1804.member.member_3 != 4294967295u) {
                        let _e1809 = -(_e428);
                        let _e1810 = (_e1809 / 3i);
                        let _e1817 = bitcast<f32>((bitcast<u32>((_e1810 + 127i)) << bitcast<u32>(23i)));
                        let _e1825 = (((_e1804.member.member * _e1817) * _e1817) * bitcast<f32>((bitcast<u32>(((_e1809 - (2i * _e1810)) + 127i)) << bitcast<u32>(23i))));
                        let _e1827 = select(340282350000000000000000000000000000000f, _e1825, (_e1825 < 340282350000000000000000000000000000000f));
                        phi_3607_ = type_24(select(-340282350000000000000000000000000000000f, _e1827, (_e1827 > -340282350000000000000000000000000000000f)), _e1804.member.member_1, _e1804.member.member_2, _e1804.member.member_3);
                    } else {
                        phi_3607_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1834 = phi_3607_;
                    if _e149 {
                    } else {
                        break;
                    }
                    global_6.member[_e147] = _e1834;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
