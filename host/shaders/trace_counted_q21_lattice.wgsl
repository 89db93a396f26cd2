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

struct type_32 {
    member: type_24,
    member_1: f32,
}

struct type_37 {
    member: array<type_25>,
}

struct type_39 {
    member: type_32,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_28,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
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
    var phi_395_: i32;
    var phi_396_: i32;
    var phi_406_: bool;
    var phi_416_: u32;
    var phi_417_: u32;
    var phi_419_: bool;
    var phi_424_: u32;
    var phi_436_: i32;
    var phi_456_: i32;
    var phi_474_: f32;
    var phi_480_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_520_: f32;
    var phi_531_: f32;
    var phi_540_: f32;
    var phi_546_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_586_: f32;
    var phi_597_: f32;
    var phi_606_: f32;
    var phi_612_: f32;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_652_: f32;
    var phi_663_: f32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_4047_: bool;
    var phi_854_: type_39;
    var phi_857_: type_50;
    var phi_859_: u32;
    var phi_861_: bool;
    var phi_863_: u32;
    var phi_874_: bool;
    var phi_960_: type_50;
    var phi_961_: bool;
    var phi_962_: u32;
    var phi_3078_: u32;
    var phi_3084_: u32;
    var phi_3338_: u32;
    var phi_3339_: u32;
    var phi_3349_: u32;
    var phi_3351_: u32;
    var phi_3352_: bool;
    var phi_3372_: u32;
    var phi_3373_: u32;
    var phi_3377_: type_51;
    var phi_3721_: type_50;
    var phi_3798_: type_50;
    var phi_3799_: type_50;
    var phi_3800_: u32;
    var phi_3802_: type_50;
    var phi_3803_: u32;
    var phi_3804_: bool;
    var phi_3813_: type_50;
    var phi_3818_: type_50;
    var phi_3819_: bool;
    var phi_981_: type_39;
    var phi_984_: type_8;
    var phi_985_: type_8;
    var phi_1007_: type_8;
    var phi_1051_: u32;
    var phi_1057_: u32;
    var phi_1067_: u32;
    var phi_1083_: u32;
    var phi_1116_: u32;
    var phi_1122_: u32;
    var phi_1549_: u32;
    var phi_1567_: u32;
    var phi_1585_: u32;
    var phi_1605_: u32;
    var phi_1623_: u32;
    var phi_1641_: u32;
    var phi_1661_: u32;
    var phi_1679_: u32;
    var phi_1697_: u32;
    var phi_1275_: u32;
    var phi_1290_: u32;
    var phi_1300_: u32;
    var phi_1320_: u32;
    var phi_1340_: u32;
    var phi_1366_: u32;
    var phi_1381_: u32;
    var phi_1391_: u32;
    var phi_1411_: u32;
    var phi_1431_: u32;
    var phi_1457_: u32;
    var phi_1472_: u32;
    var phi_1482_: u32;
    var phi_1502_: u32;
    var phi_1522_: u32;
    var phi_1146_: u32;
    var phi_1189_: u32;
    var phi_1232_: u32;
    var phi_1703_: array<array<f32, 3>, 3>;
    var phi_1820_: bool;
    var phi_1849_: bool;
    var phi_2250_: f32;
    var phi_2251_: f32;
    var phi_2252_: f32;
    var phi_2253_: f32;
    var phi_2254_: vec3<f32>;
    var phi_2255_: vec3<f32>;
    var phi_2256_: vec3<f32>;
    var phi_2257_: vec3<f32>;
    var phi_2288_: bool;
    var phi_2297_: vec3<f32>;
    var phi_2462_: f32;
    var phi_2464_: f32;
    var phi_2465_: bool;
    var phi_2485_: f32;
    var phi_2486_: f32;
    var phi_2509_: type_24;
    var phi_2511_: type_24;
    var phi_2512_: bool;
    var phi_2516_: type_24;
    var phi_2517_: type_24;
    var phi_2518_: type_24;
    var phi_2519_: bool;
    var phi_2523_: type_24;
    var phi_2524_: bool;
    var phi_2525_: type_24;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: type_24;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2538_: type_24;
    var phi_2539_: bool;
    var phi_2543_: type_24;
    var phi_2568_: bool;
    var phi_2569_: bool;
    var phi_2576_: type_39;
    var phi_2577_: type_39;
    var phi_2578_: type_39;
    var phi_982_: type_39;
    var phi_4041_: bool;
    var phi_4234_: bool;
    var phi_3821_: type_39;
    var phi_3822_: type_50;
    var phi_3823_: bool;
    var phi_3824_: u32;
    var phi_4233_: bool;
    var phi_3825_: type_39;
    var phi_3826_: type_50;
    var phi_3827_: u32;
    var phi_3828_: bool;
    var phi_3829_: u32;
    var phi_4232_: bool;
    var phi_3830_: type_39;
    var phi_3831_: type_50;
    var phi_3832_: u32;
    var phi_3833_: bool;
    var phi_3834_: u32;
    var phi_4231_: bool;
    var phi_855_: type_39;
    var phi_858_: type_50;
    var phi_860_: u32;
    var phi_862_: bool;
    var phi_864_: u32;
    var phi_3835_: bool;
    var phi_4230_: bool;
    var local_10: type_39;
    var local_11: type_39;
    var local_12: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_4.member));
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
            let _e148 = (_e147 < arrayLength((&global_3.member)));
            if _e148 {
                let _e149 = (_e147 < arrayLength((&global_6.member)));
                if _e149 {
                    if _e148 {
                    } else {
                        break;
                    }
                    let _e157 = global_3.member[_e147].member_2[0u];
                    let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                    let _e164 = global_3.member[_e147].member_2[1u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_3.member[_e147].member_2[2u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_3.member[_e147].member[0u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_3.member[_e147].member[1u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e192 = global_3.member[_e147].member[2u];
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e196 = select(_e166, _e159, (_e166 < _e159));
                    let _e198 = select(_e173, _e196, (_e173 < _e196));
                    let _e200 = select(_e180, _e198, (_e180 < _e198));
                    let _e202 = select(_e187, _e200, (_e187 < _e200));
                    let _e204 = select(_e194, _e202, (_e194 < _e202));
                    let _e208 = global_3.member[_e147].member_1;
                    let _e210 = (bitcast<u32>(_e208) & 2147483647u);
                    let _e217 = global_3.member[_e147].member_3;
                    let _e223 = (((select(_e210, _e204, (_e210 < _e204)) < 2139095040u) && ((bitcast<u32>(_e217) & 2147483647u) <= 2139095040u)) && (_e198 > 0u));
                    if _e223 {
                        let _e226 = (bitcast<u32>(bitcast<f32>(_e198)) & 2147483647u);
                        if (_e226 >= 8388608u) {
                            phi_395_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_395_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                        }
                        let _e240 = phi_395_;
                        phi_396_ = _e240;
                    } else {
                        phi_396_ = 0i;
                    }
                    let _e242 = phi_396_;
                    let _e243 = (_e159 == _e198);
                    if _e243 {
                        phi_406_ = true;
                    } else {
                        phi_406_ = (_e166 == _e198);
                    }
                    let _e246 = phi_406_;
                    let _e247 = select(1u, 0u, _e243);
                    if _e246 {
                        let _e248 = (_e247 + 1u);
                        phi_416_ = _e248;
                        phi_417_ = _e248;
                        phi_419_ = select(true, false, (_e248 == 2u));
                    } else {
                        phi_416_ = u32();
                        phi_417_ = 0u;
                        phi_419_ = true;
                    }
                    let _e252 = phi_416_;
                    let _e254 = phi_417_;
                    let _e256 = phi_419_;
                    if _e256 {
                        phi_424_ = (_e254 + 1u);
                    } else {
                        phi_424_ = 0u;
                    }
                    let _e260 = phi_424_;
                    let _e261 = select(_e252, _e254, _e256);
                    let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                    if (_e129 < -126i) {
                        phi_436_ = -126i;
                    } else {
                        phi_436_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e267 = phi_436_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e129 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = -(_e242);
                    if (_e279 < -126i) {
                        phi_456_ = -126i;
                    } else {
                        phi_456_ = select(_e279, 127i, (_e279 > 127i));
                    }
                    let _e284 = phi_456_;
                    let _e289 = bitcast<f32>((bitcast<u32>((_e284 + 127i)) << bitcast<u32>(23i)));
                    let _e295 = bitcast<f32>((bitcast<u32>(((_e279 - _e284) + 127i)) << bitcast<u32>(23i)));
                    let _e299 = global_3.member[_e147].member;
                    let _e300 = (_e261 == 0u);
                    if _e300 {
                        phi_474_ = _e299[0];
                    } else {
                        phi_474_ = _e299[1];
                    }
                    let _e304 = phi_474_;
                    let _e305 = (_e261 == 2u);
                    if _e305 {
                        phi_480_ = _e299[2];
                    } else {
                        phi_480_ = _e304;
                    }
                    let _e308 = phi_480_;
                    let _e310 = ((_e308 * _e272) * _e278);
                    let _e311 = global_3.member[_e147].member_2;
                    if _e300 {
                        phi_491_ = _e311[0];
                    } else {
                        phi_491_ = _e311[1];
                    }
                    let _e315 = phi_491_;
                    if _e305 {
                        phi_497_ = _e311[2];
                    } else {
                        phi_497_ = _e315;
                    }
                    let _e318 = phi_497_;
                    let _e320 = ((_e318 * _e289) * _e295);
                    let _e324 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e324 {
                        let _e328 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) * 0.00000011920929f);
                        phi_520_ = select(0.00000000000011368684f, _e328, (_e328 > 0.00000000000011368684f));
                    } else {
                        phi_520_ = 0f;
                    }
                    let _e332 = phi_520_;
                    let _e333 = (_e310 + _e332);
                    let _e334 = (_e310 - _e332);
                    let _e335 = select(_e320, 0f, _e324);
                    if _e324 {
                        phi_531_ = 38685626000000000000000000f;
                    } else {
                        phi_531_ = (1f / _e320);
                    }
                    let _e338 = phi_531_;
                    let _e339 = (_e260 == 0u);
                    if _e339 {
                        phi_540_ = _e299[0];
                    } else {
                        phi_540_ = _e299[1];
                    }
                    let _e343 = phi_540_;
                    let _e344 = (_e260 == 2u);
                    if _e344 {
                        phi_546_ = _e299[2];
                    } else {
                        phi_546_ = _e343;
                    }
                    let _e347 = phi_546_;
                    let _e349 = ((_e347 * _e272) * _e278);
                    if _e339 {
                        phi_557_ = _e311[0];
                    } else {
                        phi_557_ = _e311[1];
                    }
                    let _e353 = phi_557_;
                    if _e344 {
                        phi_563_ = _e311[2];
                    } else {
                        phi_563_ = _e353;
                    }
                    let _e356 = phi_563_;
                    let _e358 = ((_e356 * _e289) * _e295);
                    let _e362 = (bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e362 {
                        let _e366 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) * 0.00000011920929f);
                        phi_586_ = select(0.00000000000011368684f, _e366, (_e366 > 0.00000000000011368684f));
                    } else {
                        phi_586_ = 0f;
                    }
                    let _e370 = phi_586_;
                    let _e371 = (_e349 + _e370);
                    let _e372 = (_e349 - _e370);
                    let _e373 = select(_e358, 0f, _e362);
                    if _e362 {
                        phi_597_ = 38685626000000000000000000f;
                    } else {
                        phi_597_ = (1f / _e358);
                    }
                    let _e376 = phi_597_;
                    let _e377 = (_e262 == 0u);
                    if _e377 {
                        phi_606_ = _e299[0];
                    } else {
                        phi_606_ = _e299[1];
                    }
                    let _e381 = phi_606_;
                    let _e382 = (_e262 == 2u);
                    if _e382 {
                        phi_612_ = _e299[2];
                    } else {
                        phi_612_ = _e381;
                    }
                    let _e385 = phi_612_;
                    let _e387 = ((_e385 * _e272) * _e278);
                    if _e377 {
                        phi_623_ = _e311[0];
                    } else {
                        phi_623_ = _e311[1];
                    }
                    let _e391 = phi_623_;
                    if _e382 {
                        phi_629_ = _e311[2];
                    } else {
                        phi_629_ = _e391;
                    }
                    let _e394 = phi_629_;
                    let _e396 = ((_e394 * _e289) * _e295);
                    let _e400 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e400 {
                        let _e404 = (bitcast<f32>((bitcast<u32>(_e387) & 2147483647u)) * 0.00000011920929f);
                        phi_652_ = select(0.00000000000011368684f, _e404, (_e404 > 0.00000000000011368684f));
                    } else {
                        phi_652_ = 0f;
                    }
                    let _e408 = phi_652_;
                    let _e409 = (_e387 + _e408);
                    let _e410 = (_e387 - _e408);
                    let _e411 = select(_e396, 0f, _e400);
                    if _e400 {
                        phi_663_ = 38685626000000000000000000f;
                    } else {
                        phi_663_ = (1f / _e396);
                    }
                    let _e414 = phi_663_;
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
                        phi_763_ = select(-340282350000000000000000000000000000000f, _e455, (_e455 > -340282350000000000000000000000000000000f));
                        phi_764_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_763_ = 0f;
                        phi_764_ = 1f;
                    }
                    let _e459 = phi_763_;
                    let _e461 = phi_764_;
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
                    phi_4047_ = false;
                    phi_854_ = type_39(type_32(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e459), 0u, 0u);
                    phi_857_ = type_50(type_28(vec4<f32>((f32(_e469) * _e141), (f32(_e475) * _e141), (f32(_e481) * _e141), 0f), vec4<f32>((f32(_e486) * _e141), (f32(_e490) * _e141), (f32(_e494) * _e141), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_859_ = ((3u * _e90) + 1u);
                    phi_861_ = (_e461 <= _e459);
                    phi_863_ = 0u;
                    loop {
                        let _e504 = phi_4047_;
                        let _e506 = phi_854_;
                        let _e508 = phi_857_;
                        let _e510 = phi_859_;
                        let _e512 = phi_861_;
                        let _e514 = phi_863_;
                        local_10 = _e506;
                        local_11 = _e506;
                        if _e512 {
                            phi_874_ = true;
                        } else {
                            phi_874_ = (_e514 > 0u);
                        }
                        let _e517 = phi_874_;
                        if _e517 {
                            let _e518 = (_e510 > 0u);
                            if _e518 {
                                if _e512 {
                                    phi_960_ = _e508;
                                    phi_961_ = _e512;
                                    phi_962_ = _e514;
                                } else {
                                    let _e519 = (_e514 - 1u);
                                    let _e520 = (_e519 % 128u);
                                    let _e521 = (_e520 < 128u);
                                    if _e521 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e523 = local_7[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e525 = local_6[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e527 = local_5[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e529 = local_4[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e531 = local_3[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e533 = local_2[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e538 = local_8[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e541 = local_9[_e520];
                                    phi_960_ = type_50(type_28(vec4<f32>(_e523, _e525, _e527, 0f), vec4<f32>(_e529, _e531, _e533, 0f)), _e538);
                                    phi_961_ = (_e541 <= _e506.member.member_1);
                                    phi_962_ = _e519;
                                }
                                let _e546 = phi_960_;
                                let _e548 = phi_961_;
                                let _e550 = phi_962_;
                                if _e548 {
                                    let _e555 = (_e546.member_1 & 268435455u);
                                    if ((_e546.member_1 & 2147483648u) != 0u) {
                                        phi_981_ = _e506;
                                        phi_984_ = type_8(0u, ((_e546.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1040 = phi_981_;
                                            let _e1042 = phi_984_;
                                            local_12 = _e1040;
                                            if (_e1042.member < _e1042.member_1) {
                                                phi_985_ = type_8((_e1042.member + 1u), _e1042.member_1);
                                                phi_1007_ = type_8(1u, _e1042.member);
                                            } else {
                                                phi_985_ = _e1042;
                                                phi_1007_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1055 = phi_985_;
                                            let _e1057 = phi_1007_;
                                            let _e1061 = (bitcast<i32>(_e1057.member) != 0i);
                                            if _e1061 {
                                                let _e1067 = type_39(_e1040.member, _e1040.member_1, (_e1040.member_2 + 1u));
                                                let _e1072 = (_e546.member.member_1.x - _e546.member.member.x);
                                                let _e1075 = (_e546.member.member_1.y - _e546.member.member.y);
                                                let _e1078 = (_e546.member.member_1.z - _e546.member.member.z);
                                                let _e1080 = select(_e1075, _e1072, (_e1072 > _e1075));
                                                let _e1082 = select(_e1078, _e1080, (_e1080 > _e1078));
                                                let _e1084 = (_e1082 < (1024f * _e141));
                                                if _e1084 {
                                                    phi_1051_ = 0u;
                                                } else {
                                                    phi_1051_ = select(2u, 1u, (_e1082 < (2097152f * _e141)));
                                                }
                                                let _e1089 = phi_1051_;
                                                switch bitcast<i32>(_e1089) {
                                                    case 0: {
                                                        phi_1057_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1057_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1057_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1057_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1092 = phi_1057_;
                                                switch bitcast<i32>(_e1089) {
                                                    case 0: {
                                                        phi_1067_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1067_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1067_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1067_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1099 = phi_1067_;
                                                let _e1101 = ((_e555 + (_e1057.member_1 * ((3u * _e1092) + 1u))) + (3u * _e1099));
                                                let _e1102 = (_e1101 < _e93);
                                                if _e1102 {
                                                    if _e1102 {
                                                    } else {
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e1104 = global_5.member[_e1101];
                                                    phi_1083_ = _e1104;
                                                } else {
                                                    phi_1083_ = 4294967295u;
                                                }
                                                let _e1106 = phi_1083_;
                                                if _e1084 {
                                                    phi_1116_ = 0u;
                                                } else {
                                                    phi_1116_ = select(2u, 1u, (_e1082 < (2097152f * _e141)));
                                                }
                                                let _e1111 = phi_1116_;
                                                switch bitcast<i32>(_e1111) {
                                                    case 0: {
                                                        phi_1122_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1122_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1122_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1122_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1114 = phi_1122_;
                                                let _e1118 = (_e555 + (_e1057.member_1 * ((3u * _e1114) + 1u)));
                                                switch bitcast<i32>(_e1111) {
                                                    case 0: {
                                                        let _e1384 = (_e1118 < _e93);
                                                        if _e1384 {
                                                            if _e1384 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1386 = global_5.member[_e1118];
                                                            phi_1146_ = _e1386;
                                                        } else {
                                                            phi_1146_ = 0u;
                                                        }
                                                        let _e1388 = phi_1146_;
                                                        let _e1390 = ((10u * _e261) & 31u);
                                                        let _e1399 = ((10u * _e260) & 31u);
                                                        let _e1408 = ((10u * _e262) & 31u);
                                                        let _e1417 = (_e1118 + 1u);
                                                        let _e1418 = (_e1417 < _e93);
                                                        if _e1418 {
                                                            if _e1418 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1420 = global_5.member[_e1417];
                                                            phi_1189_ = _e1420;
                                                        } else {
                                                            phi_1189_ = 0u;
                                                        }
                                                        let _e1422 = phi_1189_;
                                                        let _e1445 = (_e1118 + 2u);
                                                        let _e1446 = (_e1445 < _e93);
                                                        if _e1446 {
                                                            if _e1446 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1448 = global_5.member[_e1445];
                                                            phi_1232_ = _e1448;
                                                        } else {
                                                            phi_1232_ = 0u;
                                                        }
                                                        let _e1450 = phi_1232_;
                                                        phi_1703_ = array<array<f32, 3>, 3>(array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1388 >> bitcast<u32>(_e1390)) & 1023u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1388 >> bitcast<u32>(_e1399)) & 1023u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1388 >> bitcast<u32>(_e1408)) & 1023u))) * _e141))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1422 >> bitcast<u32>(_e1390)) & 1023u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1422 >> bitcast<u32>(_e1399)) & 1023u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1422 >> bitcast<u32>(_e1408)) & 1023u))) * _e141))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1450 >> bitcast<u32>(_e1390)) & 1023u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1450 >> bitcast<u32>(_e1399)) & 1023u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1450 >> bitcast<u32>(_e1408)) & 1023u))) * _e141))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1207 = (_e1118 < _e93);
                                                        if _e1207 {
                                                            if _e1207 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1209 = global_5.member[_e1118];
                                                            phi_1275_ = _e1209;
                                                        } else {
                                                            phi_1275_ = 0u;
                                                        }
                                                        let _e1211 = phi_1275_;
                                                        let _e1212 = (_e1118 + 1u);
                                                        let _e1213 = (_e1212 < _e93);
                                                        if _e1213 {
                                                            if _e1213 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1215 = global_5.member[_e1212];
                                                            phi_1290_ = _e1215;
                                                        } else {
                                                            phi_1290_ = 0u;
                                                        }
                                                        let _e1217 = phi_1290_;
                                                        let _e1218 = (_e261 == 1u);
                                                        if _e1218 {
                                                            phi_1300_ = ((_e1211 >> bitcast<u32>(21i)) | (_e1217 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1300_ = (_e1217 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1227 = phi_1300_;
                                                        let _e1234 = (_e260 == 1u);
                                                        if _e1234 {
                                                            phi_1320_ = ((_e1211 >> bitcast<u32>(21i)) | (_e1217 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1320_ = (_e1217 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1243 = phi_1320_;
                                                        let _e1250 = (_e262 == 1u);
                                                        if _e1250 {
                                                            phi_1340_ = ((_e1211 >> bitcast<u32>(21i)) | (_e1217 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1340_ = (_e1217 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1259 = phi_1340_;
                                                        let _e1267 = (_e1118 + 2u);
                                                        let _e1268 = (_e1267 < _e93);
                                                        if _e1268 {
                                                            if _e1268 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1270 = global_5.member[_e1267];
                                                            phi_1366_ = _e1270;
                                                        } else {
                                                            phi_1366_ = 0u;
                                                        }
                                                        let _e1272 = phi_1366_;
                                                        let _e1273 = (_e1118 + 3u);
                                                        let _e1274 = (_e1273 < _e93);
                                                        if _e1274 {
                                                            if _e1274 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1276 = global_5.member[_e1273];
                                                            phi_1381_ = _e1276;
                                                        } else {
                                                            phi_1381_ = 0u;
                                                        }
                                                        let _e1278 = phi_1381_;
                                                        if _e1218 {
                                                            phi_1391_ = ((_e1272 >> bitcast<u32>(21i)) | (_e1278 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1391_ = (_e1278 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1287 = phi_1391_;
                                                        if _e1234 {
                                                            phi_1411_ = ((_e1272 >> bitcast<u32>(21i)) | (_e1278 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1411_ = (_e1278 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1302 = phi_1411_;
                                                        if _e1250 {
                                                            phi_1431_ = ((_e1272 >> bitcast<u32>(21i)) | (_e1278 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1431_ = (_e1278 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1317 = phi_1431_;
                                                        let _e1325 = (_e1118 + 4u);
                                                        let _e1326 = (_e1325 < _e93);
                                                        if _e1326 {
                                                            if _e1326 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1328 = global_5.member[_e1325];
                                                            phi_1457_ = _e1328;
                                                        } else {
                                                            phi_1457_ = 0u;
                                                        }
                                                        let _e1330 = phi_1457_;
                                                        let _e1331 = (_e1118 + 5u);
                                                        let _e1332 = (_e1331 < _e93);
                                                        if _e1332 {
                                                            if _e1332 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1334 = global_5.member[_e1331];
                                                            phi_1472_ = _e1334;
                                                        } else {
                                                            phi_1472_ = 0u;
                                                        }
                                                        let _e1336 = phi_1472_;
                                                        if _e1218 {
                                                            phi_1482_ = ((_e1330 >> bitcast<u32>(21i)) | (_e1336 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1482_ = (_e1336 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1345 = phi_1482_;
                                                        if _e1234 {
                                                            phi_1502_ = ((_e1330 >> bitcast<u32>(21i)) | (_e1336 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1502_ = (_e1336 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1360 = phi_1502_;
                                                        if _e1250 {
                                                            phi_1522_ = ((_e1330 >> bitcast<u32>(21i)) | (_e1336 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1522_ = (_e1336 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1375 = phi_1522_;
                                                        phi_1703_ = array<array<f32, 3>, 3>(array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1227, _e1211, _e300) & 2097151u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1243, _e1211, _e339) & 2097151u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1259, _e1211, _e377) & 2097151u))) * _e141))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1287, _e1272, _e300) & 2097151u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1302, _e1272, _e339) & 2097151u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1317, _e1272, _e377) & 2097151u))) * _e141))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1345, _e1330, _e300) & 2097151u))) * _e141)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1360, _e1330, _e339) & 2097151u))) * _e141)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1375, _e1330, _e377) & 2097151u))) * _e141))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1120 = (_e1118 + _e261);
                                                        let _e1121 = (_e1120 < _e93);
                                                        if _e1121 {
                                                            if _e1121 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1123 = global_5.member[_e1120];
                                                            phi_1549_ = _e1123;
                                                        } else {
                                                            phi_1549_ = 0u;
                                                        }
                                                        let _e1125 = phi_1549_;
                                                        let _e1129 = (_e1118 + _e260);
                                                        let _e1130 = (_e1129 < _e93);
                                                        if _e1130 {
                                                            if _e1130 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1132 = global_5.member[_e1129];
                                                            phi_1567_ = _e1132;
                                                        } else {
                                                            phi_1567_ = 0u;
                                                        }
                                                        let _e1134 = phi_1567_;
                                                        let _e1138 = (_e1118 + _e262);
                                                        let _e1139 = (_e1138 < _e93);
                                                        if _e1139 {
                                                            if _e1139 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1141 = global_5.member[_e1138];
                                                            phi_1585_ = _e1141;
                                                        } else {
                                                            phi_1585_ = 0u;
                                                        }
                                                        let _e1143 = phi_1585_;
                                                        let _e1148 = (_e1118 + 3u);
                                                        let _e1149 = (_e1148 + _e261);
                                                        let _e1150 = (_e1149 < _e93);
                                                        if _e1150 {
                                                            if _e1150 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1152 = global_5.member[_e1149];
                                                            phi_1605_ = _e1152;
                                                        } else {
                                                            phi_1605_ = 0u;
                                                        }
                                                        let _e1154 = phi_1605_;
                                                        let _e1158 = (_e1148 + _e260);
                                                        let _e1159 = (_e1158 < _e93);
                                                        if _e1159 {
                                                            if _e1159 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1161 = global_5.member[_e1158];
                                                            phi_1623_ = _e1161;
                                                        } else {
                                                            phi_1623_ = 0u;
                                                        }
                                                        let _e1163 = phi_1623_;
                                                        let _e1167 = (_e1148 + _e262);
                                                        let _e1168 = (_e1167 < _e93);
                                                        if _e1168 {
                                                            if _e1168 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1170 = global_5.member[_e1167];
                                                            phi_1641_ = _e1170;
                                                        } else {
                                                            phi_1641_ = 0u;
                                                        }
                                                        let _e1172 = phi_1641_;
                                                        let _e1177 = (_e1118 + 6u);
                                                        let _e1178 = (_e1177 + _e261);
                                                        let _e1179 = (_e1178 < _e93);
                                                        if _e1179 {
                                                            if _e1179 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1181 = global_5.member[_e1178];
                                                            phi_1661_ = _e1181;
                                                        } else {
                                                            phi_1661_ = 0u;
                                                        }
                                                        let _e1183 = phi_1661_;
                                                        let _e1187 = (_e1177 + _e260);
                                                        let _e1188 = (_e1187 < _e93);
                                                        if _e1188 {
                                                            if _e1188 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1190 = global_5.member[_e1187];
                                                            phi_1679_ = _e1190;
                                                        } else {
                                                            phi_1679_ = 0u;
                                                        }
                                                        let _e1192 = phi_1679_;
                                                        let _e1196 = (_e1177 + _e262);
                                                        let _e1197 = (_e1196 < _e93);
                                                        if _e1197 {
                                                            if _e1197 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1199 = global_5.member[_e1196];
                                                            phi_1697_ = _e1199;
                                                        } else {
                                                            phi_1697_ = 0u;
                                                        }
                                                        let _e1201 = phi_1697_;
                                                        phi_1703_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1125)) * _e141), (f32(bitcast<i32>(_e1134)) * _e141), (f32(bitcast<i32>(_e1143)) * _e141)), array<f32, 3>((f32(bitcast<i32>(_e1154)) * _e141), (f32(bitcast<i32>(_e1163)) * _e141), (f32(bitcast<i32>(_e1172)) * _e141)), array<f32, 3>((f32(bitcast<i32>(_e1183)) * _e141), (f32(bitcast<i32>(_e1192)) * _e141), (f32(bitcast<i32>(_e1201)) * _e141)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1703_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1475 = phi_1703_;
                                                let _e1484 = (_e1475[0][2] - _e387);
                                                let _e1487 = (((_e1475[0][0] - _e310) * _e411) - (_e1484 * _e335));
                                                let _e1490 = (((_e1475[0][1] - _e349) * _e411) - (_e1484 * _e373));
                                                let _e1497 = (_e1475[1][2] - _e387);
                                                let _e1500 = (((_e1475[1][0] - _e310) * _e411) - (_e1497 * _e335));
                                                let _e1503 = (((_e1475[1][1] - _e349) * _e411) - (_e1497 * _e373));
                                                let _e1510 = (_e1475[2][2] - _e387);
                                                let _e1513 = (((_e1475[2][0] - _e310) * _e411) - (_e1510 * _e335));
                                                let _e1516 = (((_e1475[2][1] - _e349) * _e411) - (_e1510 * _e373));
                                                let _e1517 = (_e1513 * _e1503);
                                                let _e1518 = (_e1516 * _e1500);
                                                let _e1519 = (_e1487 * _e1516);
                                                let _e1520 = (_e1490 * _e1513);
                                                let _e1521 = (_e1500 * _e1490);
                                                let _e1522 = (_e1503 * _e1487);
                                                let _e1527 = (((_e1517 >= _e1518) && (_e1519 >= _e1520)) && (_e1521 >= _e1522));
                                                if (_e1527 || (((_e1517 <= _e1518) && (_e1519 <= _e1520)) && (_e1521 <= _e1522))) {
                                                    let _e1534 = select(-1f, 1f, _e1527);
                                                    let _e1536 = ((_e1517 - _e1518) * _e1534);
                                                    let _e1538 = select(0f, _e1536, (_e1536 > 0f));
                                                    let _e1540 = ((_e1519 - _e1520) * _e1534);
                                                    let _e1542 = select(0f, _e1540, (_e1540 > 0f));
                                                    let _e1544 = ((_e1521 - _e1522) * _e1534);
                                                    let _e1546 = select(0f, _e1544, (_e1544 > 0f));
                                                    let _e1548 = ((_e1538 + _e1542) + _e1546);
                                                    if (_e1548 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2528_ = type_24();
                                                        phi_2529_ = true;
                                                        phi_2530_ = false;
                                                    } else {
                                                        let _e1551 = select(_e1500, _e1487, (_e1487 < _e1500));
                                                        if (select(_e1513, _e1551, (_e1551 < _e1513)) > 0f) {
                                                            phi_1820_ = true;
                                                        } else {
                                                            let _e1556 = select(_e1500, _e1487, (_e1487 > _e1500));
                                                            phi_1820_ = (select(_e1513, _e1556, (_e1556 > _e1513)) < 0f);
                                                        }
                                                        let _e1561 = phi_1820_;
                                                        if _e1561 {
                                                            phi_2525_ = type_24();
                                                            phi_2526_ = true;
                                                            phi_2527_ = false;
                                                        } else {
                                                            let _e1563 = select(_e1503, _e1490, (_e1490 < _e1503));
                                                            if (select(_e1516, _e1563, (_e1563 < _e1516)) > 0f) {
                                                                phi_1849_ = true;
                                                            } else {
                                                                let _e1568 = select(_e1503, _e1490, (_e1490 > _e1503));
                                                                phi_1849_ = (select(_e1516, _e1568, (_e1568 > _e1516)) < 0f);
                                                            }
                                                            let _e1573 = phi_1849_;
                                                            if _e1573 {
                                                                phi_2523_ = type_24();
                                                                phi_2524_ = false;
                                                            } else {
                                                                let _e1575 = select(_e1475[1][0], _e1475[0][0], (_e1475[0][0] < _e1475[1][0]));
                                                                let _e1579 = select(_e1475[1][0], _e1475[0][0], (_e1475[0][0] > _e1475[1][0]));
                                                                let _e1583 = select(_e1475[1][1], _e1475[0][1], (_e1475[0][1] < _e1475[1][1]));
                                                                let _e1587 = select(_e1475[1][1], _e1475[0][1], (_e1475[0][1] > _e1475[1][1]));
                                                                let _e1591 = select(_e1475[1][2], _e1475[0][2], (_e1475[0][2] < _e1475[1][2]));
                                                                let _e1595 = select(_e1475[1][2], _e1475[0][2], (_e1475[0][2] > _e1475[1][2]));
                                                                let _e1600 = ((select(_e1475[2][0], _e1575, (_e1575 < _e1475[2][0])) - _e333) * _e338);
                                                                let _e1601 = ((select(_e1475[2][0], _e1579, (_e1579 > _e1475[2][0])) - _e334) * _e338);
                                                                let _e1604 = ((select(_e1475[2][1], _e1583, (_e1583 < _e1475[2][1])) - _e371) * _e376);
                                                                let _e1605 = ((select(_e1475[2][1], _e1587, (_e1587 > _e1475[2][1])) - _e372) * _e376);
                                                                let _e1608 = ((select(_e1475[2][2], _e1591, (_e1591 < _e1475[2][2])) - _e409) * _e414);
                                                                let _e1609 = ((select(_e1475[2][2], _e1595, (_e1595 > _e1475[2][2])) - _e410) * _e414);
                                                                let _e1611 = select(_e1609, _e1608, (_e1608 < _e1609));
                                                                let _e1613 = select(_e1609, _e1608, (_e1608 > _e1609));
                                                                let _e1615 = select(_e1601, _e1600, (_e1600 < _e1601));
                                                                let _e1617 = select(_e1605, _e1604, (_e1604 < _e1605));
                                                                let _e1619 = select(_e1617, _e1615, (_e1615 > _e1617));
                                                                let _e1621 = select(_e1611, _e1619, (_e1619 > _e1611));
                                                                let _e1623 = select(_e1601, _e1600, (_e1600 > _e1601));
                                                                let _e1625 = select(_e1605, _e1604, (_e1604 > _e1605));
                                                                let _e1627 = select(_e1625, _e1623, (_e1623 < _e1625));
                                                                let _e1629 = select(_e1613, _e1627, (_e1627 < _e1613));
                                                                let _e1630 = -(_e1611);
                                                                let _e1636 = select(_e461, _e1621, (_e1621 > _e461));
                                                                if (_e1636 > (_e1629 + (select(_e1630, _e1613, (_e1613 > _e1630)) * 0.0000019073523f))) {
                                                                    phi_2518_ = type_24();
                                                                    phi_2519_ = true;
                                                                } else {
                                                                    let _e1638 = (_e1636 > _e1040.member.member_1);
                                                                    if _e1638 {
                                                                        phi_2517_ = type_24();
                                                                    } else {
                                                                        let _e1639 = vec3<f32>(_e1475[0][0], _e1475[0][1], _e1475[0][2]);
                                                                        let _e1640 = vec3<f32>(_e1475[1][0], _e1475[1][1], _e1475[1][2]);
                                                                        let _e1641 = vec3<f32>(_e1475[2][0], _e1475[2][1], _e1475[2][2]);
                                                                        let _e1642 = (_e1475[1][0] - _e1475[0][0]);
                                                                        let _e1643 = (_e1475[1][1] - _e1475[0][1]);
                                                                        let _e1644 = (_e1475[1][2] - _e1475[0][2]);
                                                                        let _e1645 = vec3<f32>(_e1642, _e1643, _e1644);
                                                                        let _e1646 = (_e1475[2][0] - _e1475[1][0]);
                                                                        let _e1647 = (_e1475[2][1] - _e1475[1][1]);
                                                                        let _e1648 = (_e1475[2][2] - _e1475[1][2]);
                                                                        let _e1649 = vec3<f32>(_e1646, _e1647, _e1648);
                                                                        let _e1650 = (_e1475[0][0] - _e1475[2][0]);
                                                                        let _e1651 = (_e1475[0][1] - _e1475[2][1]);
                                                                        let _e1652 = (_e1475[0][2] - _e1475[2][2]);
                                                                        let _e1653 = vec3<f32>(_e1650, _e1651, _e1652);
                                                                        let _e1656 = bitcast<f32>((bitcast<u32>(_e1642) & 2147483647u));
                                                                        let _e1659 = bitcast<f32>((bitcast<u32>(_e1643) & 2147483647u));
                                                                        let _e1661 = select(_e1659, _e1656, (_e1656 > _e1659));
                                                                        let _e1664 = bitcast<f32>((bitcast<u32>(_e1644) & 2147483647u));
                                                                        let _e1666 = select(_e1664, _e1661, (_e1661 > _e1664));
                                                                        let _e1669 = bitcast<f32>((bitcast<u32>(_e1646) & 2147483647u));
                                                                        let _e1672 = bitcast<f32>((bitcast<u32>(_e1647) & 2147483647u));
                                                                        let _e1674 = select(_e1672, _e1669, (_e1669 > _e1672));
                                                                        let _e1677 = bitcast<f32>((bitcast<u32>(_e1648) & 2147483647u));
                                                                        let _e1679 = select(_e1677, _e1674, (_e1674 > _e1677));
                                                                        let _e1682 = bitcast<f32>((bitcast<u32>(_e1650) & 2147483647u));
                                                                        let _e1685 = bitcast<f32>((bitcast<u32>(_e1651) & 2147483647u));
                                                                        let _e1687 = select(_e1685, _e1682, (_e1682 > _e1685));
                                                                        let _e1690 = bitcast<f32>((bitcast<u32>(_e1652) & 2147483647u));
                                                                        let _e1692 = select(_e1690, _e1687, (_e1687 > _e1690));
                                                                        let _e1694 = select(_e1679, _e1666, (_e1666 > _e1679));
                                                                        let _e1696 = select(_e1692, _e1694, (_e1694 > _e1692));
                                                                        if (_e1666 == _e1696) {
                                                                            phi_2250_ = _e1503;
                                                                            phi_2251_ = _e1500;
                                                                            phi_2252_ = _e1490;
                                                                            phi_2253_ = _e1487;
                                                                            phi_2254_ = _e1639;
                                                                            phi_2255_ = _e1653;
                                                                            phi_2256_ = _e1649;
                                                                            phi_2257_ = _e1645;
                                                                        } else {
                                                                            let _e1698 = (_e1679 == _e1696);
                                                                            let _e1703 = vec3(_e1698);
                                                                            phi_2250_ = select(_e1490, _e1516, _e1698);
                                                                            phi_2251_ = select(_e1487, _e1513, _e1698);
                                                                            phi_2252_ = select(_e1516, _e1503, _e1698);
                                                                            phi_2253_ = select(_e1513, _e1500, _e1698);
                                                                            phi_2254_ = select(_e1641, _e1640, _e1703);
                                                                            phi_2255_ = select(_e1649, _e1645, _e1703);
                                                                            phi_2256_ = select(_e1645, _e1653, _e1703);
                                                                            phi_2257_ = select(_e1653, _e1649, _e1703);
                                                                        }
                                                                        let _e1709 = phi_2250_;
                                                                        let _e1711 = phi_2251_;
                                                                        let _e1713 = phi_2252_;
                                                                        let _e1715 = phi_2253_;
                                                                        let _e1717 = phi_2254_;
                                                                        let _e1719 = phi_2255_;
                                                                        let _e1721 = phi_2256_;
                                                                        let _e1723 = phi_2257_;
                                                                        let _e1730 = ((_e1721.y * _e1719.z) - (_e1719.y * _e1721.z));
                                                                        let _e1735 = ((_e1721.z * _e1719.x) - (_e1719.z * _e1721.x));
                                                                        let _e1738 = ((_e1721.x * _e1719.y) - (_e1719.x * _e1721.y));
                                                                        if (_e1538 >= _e1542) {
                                                                            phi_2288_ = select(true, false, (_e1538 >= _e1546));
                                                                        } else {
                                                                            phi_2288_ = true;
                                                                        }
                                                                        let _e1743 = phi_2288_;
                                                                        if _e1743 {
                                                                            phi_2297_ = select(_e1641, _e1640, vec3((_e1542 >= _e1546)));
                                                                        } else {
                                                                            phi_2297_ = _e1639;
                                                                        }
                                                                        let _e1748 = phi_2297_;
                                                                        let _e1759 = (((_e1730 * (_e1748.x - _e310)) + (_e1735 * (_e1748.y - _e349))) + (_e1738 * (_e1748.z - _e387)));
                                                                        let _e1764 = (((_e1730 * _e335) + (_e1735 * _e373)) + (_e1738 * _e411));
                                                                        let _e1765 = (_e1711 - _e1715);
                                                                        let _e1766 = (_e1709 - _e1713);
                                                                        let _e1774 = (-(((_e1715 * _e1765) + (_e1713 * _e1766))) / ((_e1765 * _e1765) + (_e1766 * _e1766)));
                                                                        let _e1776 = select(1f, _e1774, (_e1774 < 1f));
                                                                        let _e1778 = select(0f, _e1776, (_e1776 > 0f));
                                                                        let _e1791 = ((_e1717.x + (_e1723.x * _e1778)) - _e310);
                                                                        let _e1792 = ((_e1717.y + (_e1723.y * _e1778)) - _e349);
                                                                        let _e1793 = ((_e1717.z + (_e1723.z * _e1778)) - _e387);
                                                                        let _e1794 = (_e1793 / _e411);
                                                                        let _e1806 = bitcast<f32>((bitcast<u32>(_e1791) & 2147483647u));
                                                                        let _e1809 = bitcast<f32>((bitcast<u32>(_e1792) & 2147483647u));
                                                                        let _e1811 = select(_e1809, _e1806, (_e1806 > _e1809));
                                                                        let _e1814 = bitcast<f32>((bitcast<u32>(_e1793) & 2147483647u));
                                                                        let _e1816 = select(_e1814, _e1811, (_e1811 > _e1814));
                                                                        let _e1822 = bitcast<f32>((bitcast<u32>(_e1730) & 2147483647u));
                                                                        let _e1825 = bitcast<f32>((bitcast<u32>(_e1735) & 2147483647u));
                                                                        let _e1827 = select(_e1825, _e1822, (_e1822 > _e1825));
                                                                        let _e1830 = bitcast<f32>((bitcast<u32>(_e1738) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1730 * _e1791) + (_e1735 * _e1792)) + (_e1738 * _e1793)) - _e1759)) & 2147483647u)) <= ((0.0000009536743f * select(_e1696, _e1816, (_e1816 > _e1696))) * select(_e1830, _e1827, (_e1827 > _e1830)))) {
                                                                            let _e1840 = bitcast<f32>((bitcast<u32>(_e1721.x) & 2147483647u));
                                                                            let _e1843 = bitcast<f32>((bitcast<u32>(_e1721.y) & 2147483647u));
                                                                            let _e1845 = select(_e1843, _e1840, (_e1840 > _e1843));
                                                                            let _e1848 = bitcast<f32>((bitcast<u32>(_e1721.z) & 2147483647u));
                                                                            let _e1854 = bitcast<f32>((bitcast<u32>(_e1719.x) & 2147483647u));
                                                                            let _e1857 = bitcast<f32>((bitcast<u32>(_e1719.y) & 2147483647u));
                                                                            let _e1859 = select(_e1857, _e1854, (_e1854 > _e1857));
                                                                            let _e1862 = bitcast<f32>((bitcast<u32>(_e1719.z) & 2147483647u));
                                                                            let _e1866 = (bitcast<f32>((bitcast<u32>(_e1764) & 2147483647u)) > ((0.0000038146973f * select(_e1848, _e1845, (_e1845 > _e1848))) * select(_e1862, _e1859, (_e1859 > _e1862))));
                                                                            if _e1866 {
                                                                                phi_2462_ = (_e1759 / _e1764);
                                                                            } else {
                                                                                phi_2462_ = f32();
                                                                            }
                                                                            let _e1869 = phi_2462_;
                                                                            phi_2464_ = _e1869;
                                                                            phi_2465_ = select(true, false, _e1866);
                                                                        } else {
                                                                            phi_2464_ = f32();
                                                                            phi_2465_ = true;
                                                                        }
                                                                        let _e1872 = phi_2464_;
                                                                        let _e1874 = phi_2465_;
                                                                        if _e1874 {
                                                                            let _e1882 = (((_e1730 * (_e1791 - (_e335 * _e1794))) + (_e1735 * (_e1792 - (_e373 * _e1794)))) / _e1764);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1882) & 2147483647u)) <= _e1696) {
                                                                                phi_2485_ = (_e1794 + _e1882);
                                                                            } else {
                                                                                phi_2485_ = _e1794;
                                                                            }
                                                                            let _e1889 = phi_2485_;
                                                                            phi_2486_ = _e1889;
                                                                        } else {
                                                                            phi_2486_ = _e1872;
                                                                        }
                                                                        let _e1891 = phi_2486_;
                                                                        let _e1893 = select(_e1629, _e1891, (_e1891 < _e1629));
                                                                        let _e1895 = select(_e1621, _e1893, (_e1893 > _e1621));
                                                                        if (_e1895 >= _e461) {
                                                                            let _e1897 = (_e1895 <= _e1040.member.member_1);
                                                                            if _e1897 {
                                                                                let _e1898 = (1f / _e1548);
                                                                                phi_2509_ = type_24(_e1895, (_e1542 * _e1898), (_e1546 * _e1898), _e1106);
                                                                            } else {
                                                                                phi_2509_ = type_24();
                                                                            }
                                                                            let _e1903 = phi_2509_;
                                                                            phi_2511_ = _e1903;
                                                                            phi_2512_ = select(true, false, _e1897);
                                                                        } else {
                                                                            phi_2511_ = type_24();
                                                                            phi_2512_ = true;
                                                                        }
                                                                        let _e1906 = phi_2511_;
                                                                        let _e1908 = phi_2512_;
                                                                        if _e1908 {
                                                                            phi_2516_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2516_ = _e1906;
                                                                        }
                                                                        let _e1910 = phi_2516_;
                                                                        phi_2517_ = _e1910;
                                                                    }
                                                                    let _e1912 = phi_2517_;
                                                                    phi_2518_ = _e1912;
                                                                    phi_2519_ = _e1638;
                                                                }
                                                                let _e1914 = phi_2518_;
                                                                let _e1916 = phi_2519_;
                                                                phi_2523_ = _e1914;
                                                                phi_2524_ = _e1916;
                                                            }
                                                            let _e1918 = phi_2523_;
                                                            let _e1920 = phi_2524_;
                                                            phi_2525_ = _e1918;
                                                            phi_2526_ = _e1573;
                                                            phi_2527_ = _e1920;
                                                        }
                                                        let _e1922 = phi_2525_;
                                                        let _e1924 = phi_2526_;
                                                        let _e1926 = phi_2527_;
                                                        phi_2528_ = _e1922;
                                                        phi_2529_ = _e1924;
                                                        phi_2530_ = _e1926;
                                                    }
                                                    let _e1928 = phi_2528_;
                                                    let _e1930 = phi_2529_;
                                                    let _e1932 = phi_2530_;
                                                    phi_2538_ = _e1928;
                                                    phi_2539_ = select(_e1932, true, _e1930);
                                                } else {
                                                    phi_2538_ = type_24();
                                                    phi_2539_ = true;
                                                }
                                                let _e1935 = phi_2538_;
                                                let _e1937 = phi_2539_;
                                                if _e1937 {
                                                    phi_2543_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2543_ = _e1935;
                                                }
                                                let _e1939 = phi_2543_;
                                                if (_e1939.member_3 != 4294967295u) {
                                                    if (_e1106 != 4294967295u) {
                                                        if (_e1939.member < _e1040.member.member.member) {
                                                            phi_2569_ = true;
                                                        } else {
                                                            if (_e1939.member == _e1040.member.member.member) {
                                                                phi_2568_ = (_e1939.member_3 < _e1040.member.member.member_3);
                                                            } else {
                                                                phi_2568_ = false;
                                                            }
                                                            let _e1954 = phi_2568_;
                                                            phi_2569_ = _e1954;
                                                        }
                                                        let _e1956 = phi_2569_;
                                                        if _e1956 {
                                                            phi_2576_ = type_39(type_32(_e1939, _e1939.member), _e1067.member_1, _e1067.member_2);
                                                        } else {
                                                            phi_2576_ = _e1067;
                                                        }
                                                        let _e1963 = phi_2576_;
                                                        phi_2577_ = _e1963;
                                                    } else {
                                                        phi_2577_ = _e1067;
                                                    }
                                                    let _e1965 = phi_2577_;
                                                    phi_2578_ = _e1965;
                                                } else {
                                                    phi_2578_ = _e1067;
                                                }
                                                let _e1967 = phi_2578_;
                                                phi_982_ = _e1967;
                                            } else {
                                                phi_982_ = type_39();
                                            }
                                            let _e1969 = phi_982_;
                                            continue;
                                            continuing {
                                                phi_981_ = _e1969;
                                                phi_984_ = _e1055;
                                                phi_4041_ = _e504;
                                                break if !(_e1061);
                                            }
                                        }
                                        let _e1972 = phi_4041_;
                                        phi_4230_ = _e1972;
                                        if _e1972 {
                                            break;
                                        }
                                        phi_4234_ = _e1972;
                                        let _e2178 = local_12;
                                        phi_3821_ = _e2178;
                                        phi_3822_ = _e546;
                                        phi_3823_ = false;
                                        phi_3824_ = _e550;
                                    } else {
                                        if (_e546.member_1 >= _e90) {
                                            phi_3377_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e546.member_1 < _e90) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e568 = (_e261 * 2u);
                                            let _e570 = ((1u + _e568) % 7u);
                                            if (_e570 < 7u) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e575 = global_4.member[_e546.member_1][_e570];
                                            let _e577 = ((_e568 + 2u) % 7u);
                                            if (_e577 < 7u) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e582 = global_4.member[_e546.member_1][_e577];
                                            let _e583 = (_e260 * 2u);
                                            let _e585 = ((1u + _e583) % 7u);
                                            if (_e585 < 7u) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e590 = global_4.member[_e546.member_1][_e585];
                                            let _e592 = ((_e583 + 2u) % 7u);
                                            if (_e592 < 7u) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e597 = global_4.member[_e546.member_1][_e592];
                                            let _e598 = (_e262 * 2u);
                                            let _e600 = ((1u + _e598) % 7u);
                                            if (_e600 < 7u) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e605 = global_4.member[_e546.member_1][_e600];
                                            let _e607 = ((_e598 + 2u) % 7u);
                                            if (_e607 < 7u) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e612 = global_4.member[_e546.member_1][_e607];
                                            let _e635 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.x - _e546.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e636 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.y - _e546.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e637 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.z - _e546.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e639 = select(_e141, _e635, (_e635 > _e141));
                                            let _e641 = select(_e141, _e636, (_e636 > _e141));
                                            let _e643 = select(_e141, _e637, (_e637 > _e141));
                                            let _e668 = bitcast<u32>((f32(bitcast<i32>((_e575 & 2097151u))) * _e639));
                                            let _e673 = (bitcast<i32>((_e575 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e676 = bitcast<f32>((_e668 & bitcast<u32>(_e673)));
                                            let _e677 = bitcast<u32>((f32(bitcast<i32>((_e590 & 2097151u))) * _e641));
                                            let _e682 = (bitcast<i32>((_e590 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                            let _e686 = bitcast<u32>((f32(bitcast<i32>((_e605 & 2097151u))) * _e643));
                                            let _e691 = (bitcast<i32>((_e605 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e694 = bitcast<f32>((_e686 & bitcast<u32>(_e691)));
                                            let _e698 = bitcast<f32>((_e668 & bitcast<u32>(~(_e673))));
                                            let _e702 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                            let _e706 = bitcast<f32>((_e686 & bitcast<u32>(~(_e691))));
                                            let _e707 = bitcast<u32>((f32(bitcast<i32>((_e582 & 2097151u))) * _e639));
                                            let _e712 = (bitcast<i32>((_e582 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e715 = bitcast<f32>((_e707 & bitcast<u32>(_e712)));
                                            let _e716 = bitcast<u32>((f32(bitcast<i32>((_e597 & 2097151u))) * _e641));
                                            let _e721 = (bitcast<i32>((_e597 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e724 = bitcast<f32>((_e716 & bitcast<u32>(_e721)));
                                            let _e725 = bitcast<u32>((f32(bitcast<i32>((_e612 & 2097151u))) * _e643));
                                            let _e730 = (bitcast<i32>((_e612 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e733 = bitcast<f32>((_e725 & bitcast<u32>(_e730)));
                                            let _e737 = bitcast<f32>((_e707 & bitcast<u32>(~(_e712))));
                                            let _e741 = bitcast<f32>((_e716 & bitcast<u32>(~(_e721))));
                                            let _e745 = bitcast<f32>((_e725 & bitcast<u32>(~(_e730))));
                                            let _e746 = (_e546.member.member.x + _e676);
                                            let _e747 = (_e546.member.member.y + _e685);
                                            let _e748 = (_e546.member.member.z + _e694);
                                            let _e751 = (_e546.member.member_1.x - _e715);
                                            let _e752 = (_e546.member.member_1.y - _e724);
                                            let _e753 = (_e546.member.member_1.z - _e733);
                                            let _e772 = (_e751 - _e746);
                                            let _e773 = (_e752 - _e747);
                                            let _e774 = (_e753 - _e748);
                                            let _e776 = select(_e773, _e772, (_e772 > _e773));
                                            let _e778 = select(_e774, _e776, (_e776 > _e774));
                                            if (_e778 < (1024f * _e141)) {
                                                phi_3078_ = 0u;
                                            } else {
                                                phi_3078_ = select(2u, 1u, (_e778 < (2097152f * _e141)));
                                            }
                                            let _e785 = phi_3078_;
                                            switch bitcast<i32>(_e785) {
                                                case 0: {
                                                    phi_3084_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3084_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3084_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3084_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e788 = phi_3084_;
                                            let _e794 = global_4.member[_e546.member_1][0u];
                                            let _e798 = global_4.member[_e546.member_1][2u];
                                            let _e802 = global_4.member[_e546.member_1][4u];
                                            let _e806 = global_4.member[_e546.member_1][6u];
                                            let _e818 = (((_e798 >> bitcast<u32>(22i)) | ((_e802 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e806 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e819 = (_e794 & 268435455u);
                                            let _e820 = (_e818 & 268435455u);
                                            let _e823 = ((_e794 >> bitcast<u32>(28u)) & 7u);
                                            let _e831 = ((_e794 >> bitcast<u32>(31i)) | (((_e818 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e832 = (_e823 != 0u);
                                            if (_e823 == 0u) {
                                                phi_3339_ = _e819;
                                            } else {
                                                if (_e823 == 7u) {
                                                    phi_3338_ = 2147483648u;
                                                } else {
                                                    phi_3338_ = ((2147483648u | (_e823 << bitcast<u32>(28u))) | (_e820 & 268435455u));
                                                }
                                                let _e841 = phi_3338_;
                                                phi_3339_ = _e841;
                                            }
                                            let _e843 = phi_3339_;
                                            if _e832 {
                                                let _e844 = (_e823 != 7u);
                                                if _e844 {
                                                    phi_3349_ = (_e820 + (_e823 * ((3u * _e788) + 1u)));
                                                } else {
                                                    phi_3349_ = u32();
                                                }
                                                let _e848 = phi_3349_;
                                                phi_3351_ = _e848;
                                                phi_3352_ = select(true, false, _e844);
                                            } else {
                                                phi_3351_ = u32();
                                                phi_3352_ = true;
                                            }
                                            let _e851 = phi_3351_;
                                            let _e853 = phi_3352_;
                                            if (_e831 == 0u) {
                                                phi_3373_ = (_e819 + select(0u, 1u, !(_e832)));
                                            } else {
                                                if (_e831 == 7u) {
                                                    phi_3372_ = 2147483648u;
                                                } else {
                                                    phi_3372_ = ((2147483648u | (_e831 << bitcast<u32>(28u))) | (select(_e851, _e820, _e853) & 268435455u));
                                                }
                                                let _e866 = phi_3372_;
                                                phi_3373_ = _e866;
                                            }
                                            let _e868 = phi_3373_;
                                            phi_3377_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e746, (_e546.member.member.x + _e698), _e751, (_e546.member.member_1.x - _e737)), vec4<f32>(_e747, (_e546.member.member.y + _e702), _e752, (_e546.member.member_1.y - _e741)), vec4<f32>(_e748, (_e546.member.member.z + _e706), _e753, (_e546.member.member_1.z - _e745))), type_50(type_28((_e546.member.member + vec4<f32>(_e676, _e685, _e694, 0f)), (_e546.member.member_1 - vec4<f32>(_e715, _e724, _e733, 0f))), _e843), type_50(type_28((_e546.member.member + vec4<f32>(_e698, _e702, _e706, 0f)), (_e546.member.member_1 - vec4<f32>(_e737, _e741, _e745, 0f))), _e868));
                                        }
                                        let _e873 = phi_3377_;
                                        let _e886 = ((_e873.member[0].x - _e333) * _e338);
                                        let _e887 = ((_e873.member[0].y - _e333) * _e338);
                                        let _e888 = ((_e873.member[0].z - _e334) * _e338);
                                        let _e889 = ((_e873.member[0].w - _e334) * _e338);
                                        let _e899 = ((_e873.member[1].x - _e371) * _e376);
                                        let _e900 = ((_e873.member[1].y - _e371) * _e376);
                                        let _e901 = ((_e873.member[1].z - _e372) * _e376);
                                        let _e902 = ((_e873.member[1].w - _e372) * _e376);
                                        let _e912 = ((_e873.member[2].x - _e409) * _e414);
                                        let _e913 = ((_e873.member[2].y - _e409) * _e414);
                                        let _e914 = ((_e873.member[2].z - _e410) * _e414);
                                        let _e915 = ((_e873.member[2].w - _e410) * _e414);
                                        let _e917 = select(_e914, _e912, (_e912 < _e914));
                                        let _e919 = select(_e915, _e913, (_e913 < _e915));
                                        let _e921 = select(_e914, _e912, (_e912 > _e914));
                                        let _e923 = select(_e915, _e913, (_e913 > _e915));
                                        let _e925 = select(_e888, _e886, (_e886 < _e888));
                                        let _e927 = select(_e889, _e887, (_e887 < _e889));
                                        let _e929 = select(_e901, _e899, (_e899 < _e901));
                                        let _e931 = select(_e902, _e900, (_e900 < _e902));
                                        let _e933 = select(_e929, _e925, (_e925 > _e929));
                                        let _e935 = select(_e931, _e927, (_e927 > _e931));
                                        let _e937 = select(_e917, _e933, (_e933 > _e917));
                                        let _e939 = select(_e919, _e935, (_e935 > _e919));
                                        let _e941 = select(_e888, _e886, (_e886 > _e888));
                                        let _e943 = select(_e889, _e887, (_e887 > _e889));
                                        let _e945 = select(_e901, _e899, (_e899 > _e901));
                                        let _e947 = select(_e902, _e900, (_e900 > _e902));
                                        let _e949 = select(_e945, _e941, (_e941 < _e945));
                                        let _e951 = select(_e947, _e943, (_e943 < _e947));
                                        let _e956 = -(_e917);
                                        let _e957 = -(_e919);
                                        let _e964 = (select(_e921, _e949, (_e949 < _e921)) + (select(_e956, _e921, (_e921 > _e956)) * 0.0000019073523f));
                                        let _e965 = (select(_e923, _e951, (_e951 < _e923)) + (select(_e957, _e923, (_e923 > _e957)) * 0.0000019073523f));
                                        let _e967 = select(_e461, _e937, (_e937 > _e461));
                                        let _e969 = select(_e461, _e939, (_e939 > _e461));
                                        let _e974 = (_e967 <= select(_e506.member.member_1, _e964, (_e964 < _e506.member.member_1)));
                                        let _e975 = (_e969 <= select(_e506.member.member_1, _e965, (_e965 < _e506.member.member_1)));
                                        let _e976 = (_e967 <= _e969);
                                        if _e974 {
                                            if _e975 {
                                                if _e976 {
                                                    phi_3721_ = _e873.member_2;
                                                } else {
                                                    phi_3721_ = _e873.member_1;
                                                }
                                                let _e980 = phi_3721_;
                                                let _e1002 = (_e550 % 128u);
                                                let _e1003 = (_e1002 < 128u);
                                                if _e1003 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_8[_e1002] = _e980.member_1;
                                                if _e1003 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_7[_e1002] = _e980.member.member.x;
                                                if _e1003 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_6[_e1002] = _e980.member.member.y;
                                                if _e1003 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_5[_e1002] = _e980.member.member.z;
                                                if _e1003 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_4[_e1002] = _e980.member.member_1.x;
                                                if _e1003 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_3[_e1002] = _e980.member.member_1.y;
                                                if _e1003 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_2[_e1002] = _e980.member.member_1.z;
                                                if _e1003 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_9[_e1002] = select(_e969, _e967, (_e967 > _e969));
                                                if _e976 {
                                                    phi_3798_ = _e873.member_1;
                                                } else {
                                                    phi_3798_ = _e873.member_2;
                                                }
                                                let _e1016 = phi_3798_;
                                                phi_3799_ = _e1016;
                                                phi_3800_ = (_e550 + 1u);
                                            } else {
                                                phi_3799_ = type_50();
                                                phi_3800_ = u32();
                                            }
                                            let _e1018 = phi_3799_;
                                            let _e1020 = phi_3800_;
                                            phi_3802_ = _e1018;
                                            phi_3803_ = _e1020;
                                            phi_3804_ = select(true, false, _e975);
                                        } else {
                                            phi_3802_ = type_50();
                                            phi_3803_ = u32();
                                            phi_3804_ = true;
                                        }
                                        let _e1023 = phi_3802_;
                                        let _e1025 = phi_3803_;
                                        let _e1027 = phi_3804_;
                                        if _e1027 {
                                            if _e974 {
                                                phi_3813_ = _e873.member_1;
                                            } else {
                                                phi_3813_ = _e873.member_2;
                                            }
                                            let _e1031 = phi_3813_;
                                            phi_3818_ = _e1031;
                                            phi_3819_ = select(_e975, true, _e974);
                                        } else {
                                            phi_3818_ = _e1023;
                                            phi_3819_ = _e548;
                                        }
                                        let _e1034 = phi_3818_;
                                        let _e1036 = phi_3819_;
                                        phi_4234_ = _e504;
                                        phi_3821_ = type_39(_e506.member, (_e506.member_1 + 1u), _e506.member_2);
                                        phi_3822_ = _e1034;
                                        phi_3823_ = _e1036;
                                        phi_3824_ = select(_e1025, _e550, _e1027);
                                    }
                                    let _e1974 = phi_4234_;
                                    let _e1976 = phi_3821_;
                                    let _e1978 = phi_3822_;
                                    let _e1980 = phi_3823_;
                                    let _e1982 = phi_3824_;
                                    phi_4233_ = _e1974;
                                    phi_3825_ = _e1976;
                                    phi_3826_ = _e1978;
                                    phi_3827_ = (_e510 - 1u);
                                    phi_3828_ = _e1980;
                                    phi_3829_ = _e1982;
                                } else {
                                    phi_4233_ = _e504;
                                    phi_3825_ = _e506;
                                    phi_3826_ = _e546;
                                    phi_3827_ = _e510;
                                    phi_3828_ = _e548;
                                    phi_3829_ = _e550;
                                }
                                let _e1984 = phi_4233_;
                                let _e1986 = phi_3825_;
                                let _e1988 = phi_3826_;
                                let _e1990 = phi_3827_;
                                let _e1992 = phi_3828_;
                                let _e1994 = phi_3829_;
                                phi_4232_ = _e1984;
                                phi_3830_ = _e1986;
                                phi_3831_ = _e1988;
                                phi_3832_ = _e1990;
                                phi_3833_ = _e1992;
                                phi_3834_ = _e1994;
                            } else {
                                phi_4232_ = _e504;
                                phi_3830_ = type_39();
                                phi_3831_ = type_50();
                                phi_3832_ = u32();
                                phi_3833_ = bool();
                                phi_3834_ = u32();
                            }
                            let _e1996 = phi_4232_;
                            let _e1998 = phi_3830_;
                            let _e2000 = phi_3831_;
                            let _e2002 = phi_3832_;
                            let _e2004 = phi_3833_;
                            let _e2006 = phi_3834_;
                            phi_4231_ = _e1996;
                            phi_855_ = _e1998;
                            phi_858_ = _e2000;
                            phi_860_ = _e2002;
                            phi_862_ = _e2004;
                            phi_864_ = _e2006;
                            phi_3835_ = _e518;
                        } else {
                            phi_4231_ = _e504;
                            phi_855_ = type_39();
                            phi_858_ = type_50();
                            phi_860_ = u32();
                            phi_862_ = bool();
                            phi_864_ = u32();
                            phi_3835_ = false;
                        }
                        let _e2008 = phi_4231_;
                        let _e2010 = phi_855_;
                        let _e2012 = phi_858_;
                        let _e2014 = phi_860_;
                        let _e2016 = phi_862_;
                        let _e2018 = phi_864_;
                        let _e2020 = phi_3835_;
                        continue;
                        continuing {
                            phi_4047_ = _e2008;
                            phi_854_ = _e2010;
                            phi_857_ = _e2012;
                            phi_859_ = _e2014;
                            phi_861_ = _e2016;
                            phi_863_ = _e2018;
                            phi_4230_ = _e2008;
                            break if !(_e2020);
                        }
                    }
                    let _e2023 = phi_4230_;
                    if _e2023 {
                        break;
                    }
                    let _e2025 = local_10;
                    let _e2028 = local_11;
                    if _e149 {
                    } else {
                        break;
                    }
                    global_6.member[_e147][0u] = _e2025.member_1;
                    global_6.member[_e147][1u] = _e2028.member_2;
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
