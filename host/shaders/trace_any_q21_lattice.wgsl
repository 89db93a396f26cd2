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

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: array<type_21>,
}

struct type_34 {
    member: f32,
    member_1: bool,
}

struct type_36 {
    member: array<vec4<u32>, 2>,
}

struct type_40 {
    member: array<array<u32, 7>>,
}

struct type_45 {
    member: type_24,
    member_1: u32,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: type_45,
    member_2: type_45,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_36;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_40;
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
    var phi_389_: i32;
    var phi_390_: i32;
    var phi_400_: bool;
    var phi_410_: u32;
    var phi_411_: u32;
    var phi_413_: bool;
    var phi_418_: u32;
    var phi_430_: i32;
    var phi_450_: i32;
    var phi_468_: f32;
    var phi_474_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_514_: f32;
    var phi_525_: f32;
    var phi_534_: f32;
    var phi_540_: f32;
    var phi_551_: f32;
    var phi_557_: f32;
    var phi_580_: f32;
    var phi_591_: f32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_617_: f32;
    var phi_623_: f32;
    var phi_646_: f32;
    var phi_657_: f32;
    var phi_757_: f32;
    var phi_758_: f32;
    var phi_4010_: bool;
    var phi_847_: type_34;
    var phi_850_: type_45;
    var phi_852_: u32;
    var phi_854_: bool;
    var phi_856_: u32;
    var phi_867_: bool;
    var phi_953_: type_45;
    var phi_954_: bool;
    var phi_955_: u32;
    var phi_3043_: u32;
    var phi_3049_: u32;
    var phi_3303_: u32;
    var phi_3304_: u32;
    var phi_3314_: u32;
    var phi_3316_: u32;
    var phi_3317_: bool;
    var phi_3337_: u32;
    var phi_3338_: u32;
    var phi_3342_: type_46;
    var phi_3686_: type_45;
    var phi_3763_: type_45;
    var phi_3764_: type_45;
    var phi_3765_: u32;
    var phi_3767_: type_45;
    var phi_3768_: u32;
    var phi_3769_: bool;
    var phi_3778_: type_45;
    var phi_3783_: type_45;
    var phi_3784_: bool;
    var phi_974_: type_34;
    var phi_977_: type_8;
    var phi_978_: type_8;
    var phi_1000_: type_8;
    var phi_1041_: u32;
    var phi_1047_: u32;
    var phi_1057_: u32;
    var phi_1073_: u32;
    var phi_1106_: u32;
    var phi_1112_: u32;
    var phi_1539_: u32;
    var phi_1557_: u32;
    var phi_1575_: u32;
    var phi_1595_: u32;
    var phi_1613_: u32;
    var phi_1631_: u32;
    var phi_1651_: u32;
    var phi_1669_: u32;
    var phi_1687_: u32;
    var phi_1265_: u32;
    var phi_1280_: u32;
    var phi_1290_: u32;
    var phi_1310_: u32;
    var phi_1330_: u32;
    var phi_1356_: u32;
    var phi_1371_: u32;
    var phi_1381_: u32;
    var phi_1401_: u32;
    var phi_1421_: u32;
    var phi_1447_: u32;
    var phi_1462_: u32;
    var phi_1472_: u32;
    var phi_1492_: u32;
    var phi_1512_: u32;
    var phi_1136_: u32;
    var phi_1179_: u32;
    var phi_1222_: u32;
    var phi_1693_: array<array<f32, 3>, 3>;
    var phi_1810_: bool;
    var phi_1839_: bool;
    var phi_2240_: f32;
    var phi_2241_: f32;
    var phi_2242_: f32;
    var phi_2243_: f32;
    var phi_2244_: vec3<f32>;
    var phi_2245_: vec3<f32>;
    var phi_2246_: vec3<f32>;
    var phi_2247_: vec3<f32>;
    var phi_2278_: bool;
    var phi_2287_: vec3<f32>;
    var phi_2452_: f32;
    var phi_2454_: f32;
    var phi_2455_: bool;
    var phi_2475_: f32;
    var phi_2476_: f32;
    var phi_2499_: type_20;
    var phi_2501_: type_20;
    var phi_2502_: bool;
    var phi_2506_: type_20;
    var phi_2507_: type_20;
    var phi_2508_: type_20;
    var phi_2509_: bool;
    var phi_2513_: type_20;
    var phi_2514_: bool;
    var phi_2515_: type_20;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var phi_2518_: type_20;
    var phi_2519_: bool;
    var phi_2520_: bool;
    var phi_2528_: type_20;
    var phi_2529_: bool;
    var phi_2533_: type_20;
    var phi_2544_: type_34;
    var phi_2545_: type_34;
    var phi_975_: type_34;
    var phi_4004_: bool;
    var local_10: type_34;
    var phi_4194_: bool;
    var phi_3786_: type_34;
    var phi_3787_: type_45;
    var phi_3788_: bool;
    var phi_3789_: u32;
    var phi_4193_: bool;
    var phi_3790_: type_34;
    var phi_3791_: type_45;
    var phi_3792_: u32;
    var phi_3793_: bool;
    var phi_3794_: u32;
    var phi_4192_: bool;
    var phi_3795_: type_34;
    var phi_3796_: type_45;
    var phi_3797_: u32;
    var phi_3798_: bool;
    var phi_3799_: u32;
    var phi_4191_: bool;
    var phi_848_: type_34;
    var phi_851_: type_45;
    var phi_853_: u32;
    var phi_855_: bool;
    var phi_857_: u32;
    var phi_3800_: bool;
    var phi_4190_: bool;
    var local_11: type_34;
    var local_12: type_34;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_5.member));
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
            let _e148 = (_e147 < arrayLength((&global_3.member)));
            if _e148 {
                let _e149 = (_e147 < arrayLength((&global_4.member)));
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
                            phi_389_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_389_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                        }
                        let _e240 = phi_389_;
                        phi_390_ = _e240;
                    } else {
                        phi_390_ = 0i;
                    }
                    let _e242 = phi_390_;
                    let _e243 = (_e159 == _e198);
                    if _e243 {
                        phi_400_ = true;
                    } else {
                        phi_400_ = (_e166 == _e198);
                    }
                    let _e246 = phi_400_;
                    let _e247 = select(1u, 0u, _e243);
                    if _e246 {
                        let _e248 = (_e247 + 1u);
                        phi_410_ = _e248;
                        phi_411_ = _e248;
                        phi_413_ = select(true, false, (_e248 == 2u));
                    } else {
                        phi_410_ = u32();
                        phi_411_ = 0u;
                        phi_413_ = true;
                    }
                    let _e252 = phi_410_;
                    let _e254 = phi_411_;
                    let _e256 = phi_413_;
                    if _e256 {
                        phi_418_ = (_e254 + 1u);
                    } else {
                        phi_418_ = 0u;
                    }
                    let _e260 = phi_418_;
                    let _e261 = select(_e252, _e254, _e256);
                    let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                    if (_e129 < -126i) {
                        phi_430_ = -126i;
                    } else {
                        phi_430_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e267 = phi_430_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e129 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = -(_e242);
                    if (_e279 < -126i) {
                        phi_450_ = -126i;
                    } else {
                        phi_450_ = select(_e279, 127i, (_e279 > 127i));
                    }
                    let _e284 = phi_450_;
                    let _e289 = bitcast<f32>((bitcast<u32>((_e284 + 127i)) << bitcast<u32>(23i)));
                    let _e295 = bitcast<f32>((bitcast<u32>(((_e279 - _e284) + 127i)) << bitcast<u32>(23i)));
                    let _e299 = global_3.member[_e147].member;
                    let _e300 = (_e261 == 0u);
                    if _e300 {
                        phi_468_ = _e299[0];
                    } else {
                        phi_468_ = _e299[1];
                    }
                    let _e304 = phi_468_;
                    let _e305 = (_e261 == 2u);
                    if _e305 {
                        phi_474_ = _e299[2];
                    } else {
                        phi_474_ = _e304;
                    }
                    let _e308 = phi_474_;
                    let _e310 = ((_e308 * _e272) * _e278);
                    let _e311 = global_3.member[_e147].member_2;
                    if _e300 {
                        phi_485_ = _e311[0];
                    } else {
                        phi_485_ = _e311[1];
                    }
                    let _e315 = phi_485_;
                    if _e305 {
                        phi_491_ = _e311[2];
                    } else {
                        phi_491_ = _e315;
                    }
                    let _e318 = phi_491_;
                    let _e320 = ((_e318 * _e289) * _e295);
                    let _e324 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e324 {
                        let _e328 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) * 0.00000011920929f);
                        phi_514_ = select(0.00000000000011368684f, _e328, (_e328 > 0.00000000000011368684f));
                    } else {
                        phi_514_ = 0f;
                    }
                    let _e332 = phi_514_;
                    let _e333 = (_e310 + _e332);
                    let _e334 = (_e310 - _e332);
                    let _e335 = select(_e320, 0f, _e324);
                    if _e324 {
                        phi_525_ = 38685626000000000000000000f;
                    } else {
                        phi_525_ = (1f / _e320);
                    }
                    let _e338 = phi_525_;
                    let _e339 = (_e260 == 0u);
                    if _e339 {
                        phi_534_ = _e299[0];
                    } else {
                        phi_534_ = _e299[1];
                    }
                    let _e343 = phi_534_;
                    let _e344 = (_e260 == 2u);
                    if _e344 {
                        phi_540_ = _e299[2];
                    } else {
                        phi_540_ = _e343;
                    }
                    let _e347 = phi_540_;
                    let _e349 = ((_e347 * _e272) * _e278);
                    if _e339 {
                        phi_551_ = _e311[0];
                    } else {
                        phi_551_ = _e311[1];
                    }
                    let _e353 = phi_551_;
                    if _e344 {
                        phi_557_ = _e311[2];
                    } else {
                        phi_557_ = _e353;
                    }
                    let _e356 = phi_557_;
                    let _e358 = ((_e356 * _e289) * _e295);
                    let _e362 = (bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e362 {
                        let _e366 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) * 0.00000011920929f);
                        phi_580_ = select(0.00000000000011368684f, _e366, (_e366 > 0.00000000000011368684f));
                    } else {
                        phi_580_ = 0f;
                    }
                    let _e370 = phi_580_;
                    let _e371 = (_e349 + _e370);
                    let _e372 = (_e349 - _e370);
                    let _e373 = select(_e358, 0f, _e362);
                    if _e362 {
                        phi_591_ = 38685626000000000000000000f;
                    } else {
                        phi_591_ = (1f / _e358);
                    }
                    let _e376 = phi_591_;
                    let _e377 = (_e262 == 0u);
                    if _e377 {
                        phi_600_ = _e299[0];
                    } else {
                        phi_600_ = _e299[1];
                    }
                    let _e381 = phi_600_;
                    let _e382 = (_e262 == 2u);
                    if _e382 {
                        phi_606_ = _e299[2];
                    } else {
                        phi_606_ = _e381;
                    }
                    let _e385 = phi_606_;
                    let _e387 = ((_e385 * _e272) * _e278);
                    if _e377 {
                        phi_617_ = _e311[0];
                    } else {
                        phi_617_ = _e311[1];
                    }
                    let _e391 = phi_617_;
                    if _e382 {
                        phi_623_ = _e311[2];
                    } else {
                        phi_623_ = _e391;
                    }
                    let _e394 = phi_623_;
                    let _e396 = ((_e394 * _e289) * _e295);
                    let _e400 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e400 {
                        let _e404 = (bitcast<f32>((bitcast<u32>(_e387) & 2147483647u)) * 0.00000011920929f);
                        phi_646_ = select(0.00000000000011368684f, _e404, (_e404 > 0.00000000000011368684f));
                    } else {
                        phi_646_ = 0f;
                    }
                    let _e408 = phi_646_;
                    let _e409 = (_e387 + _e408);
                    let _e410 = (_e387 - _e408);
                    let _e411 = select(_e396, 0f, _e400);
                    if _e400 {
                        phi_657_ = 38685626000000000000000000f;
                    } else {
                        phi_657_ = (1f / _e396);
                    }
                    let _e414 = phi_657_;
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
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e455, (_e455 > -340282350000000000000000000000000000000f));
                        phi_758_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_757_ = 0f;
                        phi_758_ = 1f;
                    }
                    let _e459 = phi_757_;
                    let _e461 = phi_758_;
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
                    phi_4010_ = false;
                    phi_847_ = type_34(_e459, false);
                    phi_850_ = type_45(type_24(vec4<f32>((f32(_e468) * _e141), (f32(_e474) * _e141), (f32(_e480) * _e141), 0f), vec4<f32>((f32(_e485) * _e141), (f32(_e489) * _e141), (f32(_e493) * _e141), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_852_ = ((3u * _e90) + 1u);
                    phi_854_ = (_e461 <= _e459);
                    phi_856_ = 0u;
                    loop {
                        let _e503 = phi_4010_;
                        let _e505 = phi_847_;
                        let _e507 = phi_850_;
                        let _e509 = phi_852_;
                        let _e511 = phi_854_;
                        let _e513 = phi_856_;
                        local_11 = _e505;
                        if _e511 {
                            phi_867_ = true;
                        } else {
                            phi_867_ = (_e513 > 0u);
                        }
                        let _e516 = phi_867_;
                        if _e516 {
                            let _e517 = (_e509 > 0u);
                            if _e517 {
                                if _e511 {
                                    phi_953_ = _e507;
                                    phi_954_ = _e511;
                                    phi_955_ = _e513;
                                } else {
                                    let _e518 = (_e513 - 1u);
                                    let _e519 = (_e518 % 128u);
                                    let _e520 = (_e519 < 128u);
                                    if _e520 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e522 = local_7[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e524 = local_6[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e526 = local_5[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e528 = local_4[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e530 = local_3[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e532 = local_2[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e537 = local_8[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e540 = local_9[_e519];
                                    phi_953_ = type_45(type_24(vec4<f32>(_e522, _e524, _e526, 0f), vec4<f32>(_e528, _e530, _e532, 0f)), _e537);
                                    phi_954_ = (_e540 <= _e505.member);
                                    phi_955_ = _e518;
                                }
                                let _e544 = phi_953_;
                                let _e546 = phi_954_;
                                let _e548 = phi_955_;
                                if _e546 {
                                    let _e553 = (_e544.member_1 & 268435455u);
                                    if ((_e544.member_1 & 2147483648u) != 0u) {
                                        phi_974_ = _e505;
                                        phi_977_ = type_8(0u, ((_e544.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1031 = phi_974_;
                                            let _e1033 = phi_977_;
                                            local_10 = _e1031;
                                            local_12 = _e1031;
                                            if (_e1033.member < _e1033.member_1) {
                                                phi_978_ = type_8((_e1033.member + 1u), _e1033.member_1);
                                                phi_1000_ = type_8(1u, _e1033.member);
                                            } else {
                                                phi_978_ = _e1033;
                                                phi_1000_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1046 = phi_978_;
                                            let _e1048 = phi_1000_;
                                            let _e1052 = (bitcast<i32>(_e1048.member) != 0i);
                                            if _e1052 {
                                                let _e1057 = (_e544.member.member_1.x - _e544.member.member.x);
                                                let _e1060 = (_e544.member.member_1.y - _e544.member.member.y);
                                                let _e1063 = (_e544.member.member_1.z - _e544.member.member.z);
                                                let _e1065 = select(_e1060, _e1057, (_e1057 > _e1060));
                                                let _e1067 = select(_e1063, _e1065, (_e1065 > _e1063));
                                                let _e1069 = (_e1067 < (1024f * _e141));
                                                if _e1069 {
                                                    phi_1041_ = 0u;
                                                } else {
                                                    phi_1041_ = select(2u, 1u, (_e1067 < (2097152f * _e141)));
                                                }
                                                let _e1074 = phi_1041_;
                                                switch bitcast<i32>(_e1074) {
                                                    case 0: {
                                                        phi_1047_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1047_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1047_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1047_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1077 = phi_1047_;
                                                switch bitcast<i32>(_e1074) {
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
                                                let _e1084 = phi_1057_;
                                                let _e1086 = ((_e553 + (_e1048.member_1 * ((3u * _e1077) + 1u))) + (3u * _e1084));
                                                let _e1087 = (_e1086 < _e93);
                                                if _e1087 {
                                                    if _e1087 {
                                                    } else {
                                                        phi_4004_ = true;
                                                        break;
                                                    }
                                                    let _e1089 = global_6.member[_e1086];
                                                    phi_1073_ = _e1089;
                                                } else {
                                                    phi_1073_ = 4294967295u;
                                                }
                                                let _e1091 = phi_1073_;
                                                if _e1069 {
                                                    phi_1106_ = 0u;
                                                } else {
                                                    phi_1106_ = select(2u, 1u, (_e1067 < (2097152f * _e141)));
                                                }
                                                let _e1096 = phi_1106_;
                                                switch bitcast<i32>(_e1096) {
                                                    case 0: {
                                                        phi_1112_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1112_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1112_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1112_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1099 = phi_1112_;
                                                let _e1103 = (_e553 + (_e1048.member_1 * ((3u * _e1099) + 1u)));
                                                switch bitcast<i32>(_e1096) {
                                                    case 0: {
                                                        let _e1369 = (_e1103 < _e93);
                                                        if _e1369 {
                                                            if _e1369 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1371 = global_6.member[_e1103];
                                                            phi_1136_ = _e1371;
                                                        } else {
                                                            phi_1136_ = 0u;
                                                        }
                                                        let _e1373 = phi_1136_;
                                                        let _e1375 = ((10u * _e261) & 31u);
                                                        let _e1384 = ((10u * _e260) & 31u);
                                                        let _e1393 = ((10u * _e262) & 31u);
                                                        let _e1402 = (_e1103 + 1u);
                                                        let _e1403 = (_e1402 < _e93);
                                                        if _e1403 {
                                                            if _e1403 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1405 = global_6.member[_e1402];
                                                            phi_1179_ = _e1405;
                                                        } else {
                                                            phi_1179_ = 0u;
                                                        }
                                                        let _e1407 = phi_1179_;
                                                        let _e1430 = (_e1103 + 2u);
                                                        let _e1431 = (_e1430 < _e93);
                                                        if _e1431 {
                                                            if _e1431 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1433 = global_6.member[_e1430];
                                                            phi_1222_ = _e1433;
                                                        } else {
                                                            phi_1222_ = 0u;
                                                        }
                                                        let _e1435 = phi_1222_;
                                                        phi_1693_ = array<array<f32, 3>, 3>(array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1373 >> bitcast<u32>(_e1375)) & 1023u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1373 >> bitcast<u32>(_e1384)) & 1023u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1373 >> bitcast<u32>(_e1393)) & 1023u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1407 >> bitcast<u32>(_e1375)) & 1023u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1407 >> bitcast<u32>(_e1384)) & 1023u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1407 >> bitcast<u32>(_e1393)) & 1023u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1435 >> bitcast<u32>(_e1375)) & 1023u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1435 >> bitcast<u32>(_e1384)) & 1023u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1435 >> bitcast<u32>(_e1393)) & 1023u))) * _e141))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1192 = (_e1103 < _e93);
                                                        if _e1192 {
                                                            if _e1192 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1194 = global_6.member[_e1103];
                                                            phi_1265_ = _e1194;
                                                        } else {
                                                            phi_1265_ = 0u;
                                                        }
                                                        let _e1196 = phi_1265_;
                                                        let _e1197 = (_e1103 + 1u);
                                                        let _e1198 = (_e1197 < _e93);
                                                        if _e1198 {
                                                            if _e1198 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1200 = global_6.member[_e1197];
                                                            phi_1280_ = _e1200;
                                                        } else {
                                                            phi_1280_ = 0u;
                                                        }
                                                        let _e1202 = phi_1280_;
                                                        let _e1203 = (_e261 == 1u);
                                                        if _e1203 {
                                                            phi_1290_ = ((_e1196 >> bitcast<u32>(21i)) | (_e1202 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1290_ = (_e1202 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1212 = phi_1290_;
                                                        let _e1219 = (_e260 == 1u);
                                                        if _e1219 {
                                                            phi_1310_ = ((_e1196 >> bitcast<u32>(21i)) | (_e1202 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1310_ = (_e1202 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1228 = phi_1310_;
                                                        let _e1235 = (_e262 == 1u);
                                                        if _e1235 {
                                                            phi_1330_ = ((_e1196 >> bitcast<u32>(21i)) | (_e1202 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1330_ = (_e1202 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1244 = phi_1330_;
                                                        let _e1252 = (_e1103 + 2u);
                                                        let _e1253 = (_e1252 < _e93);
                                                        if _e1253 {
                                                            if _e1253 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1255 = global_6.member[_e1252];
                                                            phi_1356_ = _e1255;
                                                        } else {
                                                            phi_1356_ = 0u;
                                                        }
                                                        let _e1257 = phi_1356_;
                                                        let _e1258 = (_e1103 + 3u);
                                                        let _e1259 = (_e1258 < _e93);
                                                        if _e1259 {
                                                            if _e1259 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1261 = global_6.member[_e1258];
                                                            phi_1371_ = _e1261;
                                                        } else {
                                                            phi_1371_ = 0u;
                                                        }
                                                        let _e1263 = phi_1371_;
                                                        if _e1203 {
                                                            phi_1381_ = ((_e1257 >> bitcast<u32>(21i)) | (_e1263 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1381_ = (_e1263 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1272 = phi_1381_;
                                                        if _e1219 {
                                                            phi_1401_ = ((_e1257 >> bitcast<u32>(21i)) | (_e1263 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1401_ = (_e1263 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1287 = phi_1401_;
                                                        if _e1235 {
                                                            phi_1421_ = ((_e1257 >> bitcast<u32>(21i)) | (_e1263 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1421_ = (_e1263 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1302 = phi_1421_;
                                                        let _e1310 = (_e1103 + 4u);
                                                        let _e1311 = (_e1310 < _e93);
                                                        if _e1311 {
                                                            if _e1311 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1313 = global_6.member[_e1310];
                                                            phi_1447_ = _e1313;
                                                        } else {
                                                            phi_1447_ = 0u;
                                                        }
                                                        let _e1315 = phi_1447_;
                                                        let _e1316 = (_e1103 + 5u);
                                                        let _e1317 = (_e1316 < _e93);
                                                        if _e1317 {
                                                            if _e1317 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1319 = global_6.member[_e1316];
                                                            phi_1462_ = _e1319;
                                                        } else {
                                                            phi_1462_ = 0u;
                                                        }
                                                        let _e1321 = phi_1462_;
                                                        if _e1203 {
                                                            phi_1472_ = ((_e1315 >> bitcast<u32>(21i)) | (_e1321 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1472_ = (_e1321 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1330 = phi_1472_;
                                                        if _e1219 {
                                                            phi_1492_ = ((_e1315 >> bitcast<u32>(21i)) | (_e1321 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1492_ = (_e1321 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1345 = phi_1492_;
                                                        if _e1235 {
                                                            phi_1512_ = ((_e1315 >> bitcast<u32>(21i)) | (_e1321 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1512_ = (_e1321 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1360 = phi_1512_;
                                                        phi_1693_ = array<array<f32, 3>, 3>(array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1212, _e1196, _e300) & 2097151u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1228, _e1196, _e339) & 2097151u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1244, _e1196, _e377) & 2097151u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1272, _e1257, _e300) & 2097151u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1287, _e1257, _e339) & 2097151u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1302, _e1257, _e377) & 2097151u))) * _e141))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1330, _e1315, _e300) & 2097151u))) * _e141)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1345, _e1315, _e339) & 2097151u))) * _e141)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1360, _e1315, _e377) & 2097151u))) * _e141))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1105 = (_e1103 + _e261);
                                                        let _e1106 = (_e1105 < _e93);
                                                        if _e1106 {
                                                            if _e1106 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1108 = global_6.member[_e1105];
                                                            phi_1539_ = _e1108;
                                                        } else {
                                                            phi_1539_ = 0u;
                                                        }
                                                        let _e1110 = phi_1539_;
                                                        let _e1114 = (_e1103 + _e260);
                                                        let _e1115 = (_e1114 < _e93);
                                                        if _e1115 {
                                                            if _e1115 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1117 = global_6.member[_e1114];
                                                            phi_1557_ = _e1117;
                                                        } else {
                                                            phi_1557_ = 0u;
                                                        }
                                                        let _e1119 = phi_1557_;
                                                        let _e1123 = (_e1103 + _e262);
                                                        let _e1124 = (_e1123 < _e93);
                                                        if _e1124 {
                                                            if _e1124 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1126 = global_6.member[_e1123];
                                                            phi_1575_ = _e1126;
                                                        } else {
                                                            phi_1575_ = 0u;
                                                        }
                                                        let _e1128 = phi_1575_;
                                                        let _e1133 = (_e1103 + 3u);
                                                        let _e1134 = (_e1133 + _e261);
                                                        let _e1135 = (_e1134 < _e93);
                                                        if _e1135 {
                                                            if _e1135 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1137 = global_6.member[_e1134];
                                                            phi_1595_ = _e1137;
                                                        } else {
                                                            phi_1595_ = 0u;
                                                        }
                                                        let _e1139 = phi_1595_;
                                                        let _e1143 = (_e1133 + _e260);
                                                        let _e1144 = (_e1143 < _e93);
                                                        if _e1144 {
                                                            if _e1144 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1146 = global_6.member[_e1143];
                                                            phi_1613_ = _e1146;
                                                        } else {
                                                            phi_1613_ = 0u;
                                                        }
                                                        let _e1148 = phi_1613_;
                                                        let _e1152 = (_e1133 + _e262);
                                                        let _e1153 = (_e1152 < _e93);
                                                        if _e1153 {
                                                            if _e1153 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1155 = global_6.member[_e1152];
                                                            phi_1631_ = _e1155;
                                                        } else {
                                                            phi_1631_ = 0u;
                                                        }
                                                        let _e1157 = phi_1631_;
                                                        let _e1162 = (_e1103 + 6u);
                                                        let _e1163 = (_e1162 + _e261);
                                                        let _e1164 = (_e1163 < _e93);
                                                        if _e1164 {
                                                            if _e1164 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1166 = global_6.member[_e1163];
                                                            phi_1651_ = _e1166;
                                                        } else {
                                                            phi_1651_ = 0u;
                                                        }
                                                        let _e1168 = phi_1651_;
                                                        let _e1172 = (_e1162 + _e260);
                                                        let _e1173 = (_e1172 < _e93);
                                                        if _e1173 {
                                                            if _e1173 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1175 = global_6.member[_e1172];
                                                            phi_1669_ = _e1175;
                                                        } else {
                                                            phi_1669_ = 0u;
                                                        }
                                                        let _e1177 = phi_1669_;
                                                        let _e1181 = (_e1162 + _e262);
                                                        let _e1182 = (_e1181 < _e93);
                                                        if _e1182 {
                                                            if _e1182 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1184 = global_6.member[_e1181];
                                                            phi_1687_ = _e1184;
                                                        } else {
                                                            phi_1687_ = 0u;
                                                        }
                                                        let _e1186 = phi_1687_;
                                                        phi_1693_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1110)) * _e141), (f32(bitcast<i32>(_e1119)) * _e141), (f32(bitcast<i32>(_e1128)) * _e141)), array<f32, 3>((f32(bitcast<i32>(_e1139)) * _e141), (f32(bitcast<i32>(_e1148)) * _e141), (f32(bitcast<i32>(_e1157)) * _e141)), array<f32, 3>((f32(bitcast<i32>(_e1168)) * _e141), (f32(bitcast<i32>(_e1177)) * _e141), (f32(bitcast<i32>(_e1186)) * _e141)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1693_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1460 = phi_1693_;
                                                let _e1468 = (_e1460[0][2] - _e387);
                                                let _e1471 = (((_e1460[0][0] - _e310) * _e411) - (_e1468 * _e335));
                                                let _e1474 = (((_e1460[0][1] - _e349) * _e411) - (_e1468 * _e373));
                                                let _e1481 = (_e1460[1][2] - _e387);
                                                let _e1484 = (((_e1460[1][0] - _e310) * _e411) - (_e1481 * _e335));
                                                let _e1487 = (((_e1460[1][1] - _e349) * _e411) - (_e1481 * _e373));
                                                let _e1494 = (_e1460[2][2] - _e387);
                                                let _e1497 = (((_e1460[2][0] - _e310) * _e411) - (_e1494 * _e335));
                                                let _e1500 = (((_e1460[2][1] - _e349) * _e411) - (_e1494 * _e373));
                                                let _e1501 = (_e1497 * _e1487);
                                                let _e1502 = (_e1500 * _e1484);
                                                let _e1503 = (_e1471 * _e1500);
                                                let _e1504 = (_e1474 * _e1497);
                                                let _e1505 = (_e1484 * _e1474);
                                                let _e1506 = (_e1487 * _e1471);
                                                let _e1511 = (((_e1501 >= _e1502) && (_e1503 >= _e1504)) && (_e1505 >= _e1506));
                                                if (_e1511 || (((_e1501 <= _e1502) && (_e1503 <= _e1504)) && (_e1505 <= _e1506))) {
                                                    let _e1518 = select(-1f, 1f, _e1511);
                                                    let _e1520 = ((_e1501 - _e1502) * _e1518);
                                                    let _e1522 = select(0f, _e1520, (_e1520 > 0f));
                                                    let _e1524 = ((_e1503 - _e1504) * _e1518);
                                                    let _e1526 = select(0f, _e1524, (_e1524 > 0f));
                                                    let _e1528 = ((_e1505 - _e1506) * _e1518);
                                                    let _e1530 = select(0f, _e1528, (_e1528 > 0f));
                                                    let _e1532 = ((_e1522 + _e1526) + _e1530);
                                                    if (_e1532 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2518_ = type_20();
                                                        phi_2519_ = true;
                                                        phi_2520_ = false;
                                                    } else {
                                                        let _e1535 = select(_e1484, _e1471, (_e1471 < _e1484));
                                                        if (select(_e1497, _e1535, (_e1535 < _e1497)) > 0f) {
                                                            phi_1810_ = true;
                                                        } else {
                                                            let _e1540 = select(_e1484, _e1471, (_e1471 > _e1484));
                                                            phi_1810_ = (select(_e1497, _e1540, (_e1540 > _e1497)) < 0f);
                                                        }
                                                        let _e1545 = phi_1810_;
                                                        if _e1545 {
                                                            phi_2515_ = type_20();
                                                            phi_2516_ = true;
                                                            phi_2517_ = false;
                                                        } else {
                                                            let _e1547 = select(_e1487, _e1474, (_e1474 < _e1487));
                                                            if (select(_e1500, _e1547, (_e1547 < _e1500)) > 0f) {
                                                                phi_1839_ = true;
                                                            } else {
                                                                let _e1552 = select(_e1487, _e1474, (_e1474 > _e1487));
                                                                phi_1839_ = (select(_e1500, _e1552, (_e1552 > _e1500)) < 0f);
                                                            }
                                                            let _e1557 = phi_1839_;
                                                            if _e1557 {
                                                                phi_2513_ = type_20();
                                                                phi_2514_ = false;
                                                            } else {
                                                                let _e1559 = select(_e1460[1][0], _e1460[0][0], (_e1460[0][0] < _e1460[1][0]));
                                                                let _e1563 = select(_e1460[1][0], _e1460[0][0], (_e1460[0][0] > _e1460[1][0]));
                                                                let _e1567 = select(_e1460[1][1], _e1460[0][1], (_e1460[0][1] < _e1460[1][1]));
                                                                let _e1571 = select(_e1460[1][1], _e1460[0][1], (_e1460[0][1] > _e1460[1][1]));
                                                                let _e1575 = select(_e1460[1][2], _e1460[0][2], (_e1460[0][2] < _e1460[1][2]));
                                                                let _e1579 = select(_e1460[1][2], _e1460[0][2], (_e1460[0][2] > _e1460[1][2]));
                                                                let _e1584 = ((select(_e1460[2][0], _e1559, (_e1559 < _e1460[2][0])) - _e333) * _e338);
                                                                let _e1585 = ((select(_e1460[2][0], _e1563, (_e1563 > _e1460[2][0])) - _e334) * _e338);
                                                                let _e1588 = ((select(_e1460[2][1], _e1567, (_e1567 < _e1460[2][1])) - _e371) * _e376);
                                                                let _e1589 = ((select(_e1460[2][1], _e1571, (_e1571 > _e1460[2][1])) - _e372) * _e376);
                                                                let _e1592 = ((select(_e1460[2][2], _e1575, (_e1575 < _e1460[2][2])) - _e409) * _e414);
                                                                let _e1593 = ((select(_e1460[2][2], _e1579, (_e1579 > _e1460[2][2])) - _e410) * _e414);
                                                                let _e1595 = select(_e1593, _e1592, (_e1592 < _e1593));
                                                                let _e1597 = select(_e1593, _e1592, (_e1592 > _e1593));
                                                                let _e1599 = select(_e1585, _e1584, (_e1584 < _e1585));
                                                                let _e1601 = select(_e1589, _e1588, (_e1588 < _e1589));
                                                                let _e1603 = select(_e1601, _e1599, (_e1599 > _e1601));
                                                                let _e1605 = select(_e1595, _e1603, (_e1603 > _e1595));
                                                                let _e1607 = select(_e1585, _e1584, (_e1584 > _e1585));
                                                                let _e1609 = select(_e1589, _e1588, (_e1588 > _e1589));
                                                                let _e1611 = select(_e1609, _e1607, (_e1607 < _e1609));
                                                                let _e1613 = select(_e1597, _e1611, (_e1611 < _e1597));
                                                                let _e1614 = -(_e1595);
                                                                let _e1620 = select(_e461, _e1605, (_e1605 > _e461));
                                                                if (_e1620 > (_e1613 + (select(_e1614, _e1597, (_e1597 > _e1614)) * 0.0000019073523f))) {
                                                                    phi_2508_ = type_20();
                                                                    phi_2509_ = true;
                                                                } else {
                                                                    let _e1622 = (_e1620 > _e1031.member);
                                                                    if _e1622 {
                                                                        phi_2507_ = type_20();
                                                                    } else {
                                                                        let _e1623 = vec3<f32>(_e1460[0][0], _e1460[0][1], _e1460[0][2]);
                                                                        let _e1624 = vec3<f32>(_e1460[1][0], _e1460[1][1], _e1460[1][2]);
                                                                        let _e1625 = vec3<f32>(_e1460[2][0], _e1460[2][1], _e1460[2][2]);
                                                                        let _e1626 = (_e1460[1][0] - _e1460[0][0]);
                                                                        let _e1627 = (_e1460[1][1] - _e1460[0][1]);
                                                                        let _e1628 = (_e1460[1][2] - _e1460[0][2]);
                                                                        let _e1629 = vec3<f32>(_e1626, _e1627, _e1628);
                                                                        let _e1630 = (_e1460[2][0] - _e1460[1][0]);
                                                                        let _e1631 = (_e1460[2][1] - _e1460[1][1]);
                                                                        let _e1632 = (_e1460[2][2] - _e1460[1][2]);
                                                                        let _e1633 = vec3<f32>(_e1630, _e1631, _e1632);
                                                                        let _e1634 = (_e1460[0][0] - _e1460[2][0]);
                                                                        let _e1635 = (_e1460[0][1] - _e1460[2][1]);
                                                                        let _e1636 = (_e1460[0][2] - _e1460[2][2]);
                                                                        let _e1637 = vec3<f32>(_e1634, _e1635, _e1636);
                                                                        let _e1640 = bitcast<f32>((bitcast<u32>(_e1626) & 2147483647u));
                                                                        let _e1643 = bitcast<f32>((bitcast<u32>(_e1627) & 2147483647u));
                                                                        let _e1645 = select(_e1643, _e1640, (_e1640 > _e1643));
                                                                        let _e1648 = bitcast<f32>((bitcast<u32>(_e1628) & 2147483647u));
                                                                        let _e1650 = select(_e1648, _e1645, (_e1645 > _e1648));
                                                                        let _e1653 = bitcast<f32>((bitcast<u32>(_e1630) & 2147483647u));
                                                                        let _e1656 = bitcast<f32>((bitcast<u32>(_e1631) & 2147483647u));
                                                                        let _e1658 = select(_e1656, _e1653, (_e1653 > _e1656));
                                                                        let _e1661 = bitcast<f32>((bitcast<u32>(_e1632) & 2147483647u));
                                                                        let _e1663 = select(_e1661, _e1658, (_e1658 > _e1661));
                                                                        let _e1666 = bitcast<f32>((bitcast<u32>(_e1634) & 2147483647u));
                                                                        let _e1669 = bitcast<f32>((bitcast<u32>(_e1635) & 2147483647u));
                                                                        let _e1671 = select(_e1669, _e1666, (_e1666 > _e1669));
                                                                        let _e1674 = bitcast<f32>((bitcast<u32>(_e1636) & 2147483647u));
                                                                        let _e1676 = select(_e1674, _e1671, (_e1671 > _e1674));
                                                                        let _e1678 = select(_e1663, _e1650, (_e1650 > _e1663));
                                                                        let _e1680 = select(_e1676, _e1678, (_e1678 > _e1676));
                                                                        if (_e1650 == _e1680) {
                                                                            phi_2240_ = _e1487;
                                                                            phi_2241_ = _e1484;
                                                                            phi_2242_ = _e1474;
                                                                            phi_2243_ = _e1471;
                                                                            phi_2244_ = _e1623;
                                                                            phi_2245_ = _e1637;
                                                                            phi_2246_ = _e1633;
                                                                            phi_2247_ = _e1629;
                                                                        } else {
                                                                            let _e1682 = (_e1663 == _e1680);
                                                                            let _e1687 = vec3(_e1682);
                                                                            phi_2240_ = select(_e1474, _e1500, _e1682);
                                                                            phi_2241_ = select(_e1471, _e1497, _e1682);
                                                                            phi_2242_ = select(_e1500, _e1487, _e1682);
                                                                            phi_2243_ = select(_e1497, _e1484, _e1682);
                                                                            phi_2244_ = select(_e1625, _e1624, _e1687);
                                                                            phi_2245_ = select(_e1633, _e1629, _e1687);
                                                                            phi_2246_ = select(_e1629, _e1637, _e1687);
                                                                            phi_2247_ = select(_e1637, _e1633, _e1687);
                                                                        }
                                                                        let _e1693 = phi_2240_;
                                                                        let _e1695 = phi_2241_;
                                                                        let _e1697 = phi_2242_;
                                                                        let _e1699 = phi_2243_;
                                                                        let _e1701 = phi_2244_;
                                                                        let _e1703 = phi_2245_;
                                                                        let _e1705 = phi_2246_;
                                                                        let _e1707 = phi_2247_;
                                                                        let _e1714 = ((_e1705.y * _e1703.z) - (_e1703.y * _e1705.z));
                                                                        let _e1719 = ((_e1705.z * _e1703.x) - (_e1703.z * _e1705.x));
                                                                        let _e1722 = ((_e1705.x * _e1703.y) - (_e1703.x * _e1705.y));
                                                                        if (_e1522 >= _e1526) {
                                                                            phi_2278_ = select(true, false, (_e1522 >= _e1530));
                                                                        } else {
                                                                            phi_2278_ = true;
                                                                        }
                                                                        let _e1727 = phi_2278_;
                                                                        if _e1727 {
                                                                            phi_2287_ = select(_e1625, _e1624, vec3((_e1526 >= _e1530)));
                                                                        } else {
                                                                            phi_2287_ = _e1623;
                                                                        }
                                                                        let _e1732 = phi_2287_;
                                                                        let _e1743 = (((_e1714 * (_e1732.x - _e310)) + (_e1719 * (_e1732.y - _e349))) + (_e1722 * (_e1732.z - _e387)));
                                                                        let _e1748 = (((_e1714 * _e335) + (_e1719 * _e373)) + (_e1722 * _e411));
                                                                        let _e1749 = (_e1695 - _e1699);
                                                                        let _e1750 = (_e1693 - _e1697);
                                                                        let _e1758 = (-(((_e1699 * _e1749) + (_e1697 * _e1750))) / ((_e1749 * _e1749) + (_e1750 * _e1750)));
                                                                        let _e1760 = select(1f, _e1758, (_e1758 < 1f));
                                                                        let _e1762 = select(0f, _e1760, (_e1760 > 0f));
                                                                        let _e1775 = ((_e1701.x + (_e1707.x * _e1762)) - _e310);
                                                                        let _e1776 = ((_e1701.y + (_e1707.y * _e1762)) - _e349);
                                                                        let _e1777 = ((_e1701.z + (_e1707.z * _e1762)) - _e387);
                                                                        let _e1778 = (_e1777 / _e411);
                                                                        let _e1790 = bitcast<f32>((bitcast<u32>(_e1775) & 2147483647u));
                                                                        let _e1793 = bitcast<f32>((bitcast<u32>(_e1776) & 2147483647u));
                                                                        let _e1795 = select(_e1793, _e1790, (_e1790 > _e1793));
                                                                        let _e1798 = bitcast<f32>((bitcast<u32>(_e1777) & 2147483647u));
                                                                        let _e1800 = select(_e1798, _e1795, (_e1795 > _e1798));
                                                                        let _e1806 = bitcast<f32>((bitcast<u32>(_e1714) & 2147483647u));
                                                                        let _e1809 = bitcast<f32>((bitcast<u32>(_e1719) & 2147483647u));
                                                                        let _e1811 = select(_e1809, _e1806, (_e1806 > _e1809));
                                                                        let _e1814 = bitcast<f32>((bitcast<u32>(_e1722) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1714 * _e1775) + (_e1719 * _e1776)) + (_e1722 * _e1777)) - _e1743)) & 2147483647u)) <= ((0.0000009536743f * select(_e1680, _e1800, (_e1800 > _e1680))) * select(_e1814, _e1811, (_e1811 > _e1814)))) {
                                                                            let _e1824 = bitcast<f32>((bitcast<u32>(_e1705.x) & 2147483647u));
                                                                            let _e1827 = bitcast<f32>((bitcast<u32>(_e1705.y) & 2147483647u));
                                                                            let _e1829 = select(_e1827, _e1824, (_e1824 > _e1827));
                                                                            let _e1832 = bitcast<f32>((bitcast<u32>(_e1705.z) & 2147483647u));
                                                                            let _e1838 = bitcast<f32>((bitcast<u32>(_e1703.x) & 2147483647u));
                                                                            let _e1841 = bitcast<f32>((bitcast<u32>(_e1703.y) & 2147483647u));
                                                                            let _e1843 = select(_e1841, _e1838, (_e1838 > _e1841));
                                                                            let _e1846 = bitcast<f32>((bitcast<u32>(_e1703.z) & 2147483647u));
                                                                            let _e1850 = (bitcast<f32>((bitcast<u32>(_e1748) & 2147483647u)) > ((0.0000038146973f * select(_e1832, _e1829, (_e1829 > _e1832))) * select(_e1846, _e1843, (_e1843 > _e1846))));
                                                                            if _e1850 {
                                                                                phi_2452_ = (_e1743 / _e1748);
                                                                            } else {
                                                                                phi_2452_ = f32();
                                                                            }
                                                                            let _e1853 = phi_2452_;
                                                                            phi_2454_ = _e1853;
                                                                            phi_2455_ = select(true, false, _e1850);
                                                                        } else {
                                                                            phi_2454_ = f32();
                                                                            phi_2455_ = true;
                                                                        }
                                                                        let _e1856 = phi_2454_;
                                                                        let _e1858 = phi_2455_;
                                                                        if _e1858 {
                                                                            let _e1866 = (((_e1714 * (_e1775 - (_e335 * _e1778))) + (_e1719 * (_e1776 - (_e373 * _e1778)))) / _e1748);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1866) & 2147483647u)) <= _e1680) {
                                                                                phi_2475_ = (_e1778 + _e1866);
                                                                            } else {
                                                                                phi_2475_ = _e1778;
                                                                            }
                                                                            let _e1873 = phi_2475_;
                                                                            phi_2476_ = _e1873;
                                                                        } else {
                                                                            phi_2476_ = _e1856;
                                                                        }
                                                                        let _e1875 = phi_2476_;
                                                                        let _e1877 = select(_e1613, _e1875, (_e1875 < _e1613));
                                                                        let _e1879 = select(_e1605, _e1877, (_e1877 > _e1605));
                                                                        if (_e1879 >= _e461) {
                                                                            let _e1881 = (_e1879 <= _e1031.member);
                                                                            if _e1881 {
                                                                                let _e1882 = (1f / _e1532);
                                                                                phi_2499_ = type_20(_e1879, (_e1526 * _e1882), (_e1530 * _e1882), _e1091);
                                                                            } else {
                                                                                phi_2499_ = type_20();
                                                                            }
                                                                            let _e1887 = phi_2499_;
                                                                            phi_2501_ = _e1887;
                                                                            phi_2502_ = select(true, false, _e1881);
                                                                        } else {
                                                                            phi_2501_ = type_20();
                                                                            phi_2502_ = true;
                                                                        }
                                                                        let _e1890 = phi_2501_;
                                                                        let _e1892 = phi_2502_;
                                                                        if _e1892 {
                                                                            phi_2506_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2506_ = _e1890;
                                                                        }
                                                                        let _e1894 = phi_2506_;
                                                                        phi_2507_ = _e1894;
                                                                    }
                                                                    let _e1896 = phi_2507_;
                                                                    phi_2508_ = _e1896;
                                                                    phi_2509_ = _e1622;
                                                                }
                                                                let _e1898 = phi_2508_;
                                                                let _e1900 = phi_2509_;
                                                                phi_2513_ = _e1898;
                                                                phi_2514_ = _e1900;
                                                            }
                                                            let _e1902 = phi_2513_;
                                                            let _e1904 = phi_2514_;
                                                            phi_2515_ = _e1902;
                                                            phi_2516_ = _e1557;
                                                            phi_2517_ = _e1904;
                                                        }
                                                        let _e1906 = phi_2515_;
                                                        let _e1908 = phi_2516_;
                                                        let _e1910 = phi_2517_;
                                                        phi_2518_ = _e1906;
                                                        phi_2519_ = _e1908;
                                                        phi_2520_ = _e1910;
                                                    }
                                                    let _e1912 = phi_2518_;
                                                    let _e1914 = phi_2519_;
                                                    let _e1916 = phi_2520_;
                                                    phi_2528_ = _e1912;
                                                    phi_2529_ = select(_e1916, true, _e1914);
                                                } else {
                                                    phi_2528_ = type_20();
                                                    phi_2529_ = true;
                                                }
                                                let _e1919 = phi_2528_;
                                                let _e1921 = phi_2529_;
                                                if _e1921 {
                                                    phi_2533_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2533_ = _e1919;
                                                }
                                                let _e1923 = phi_2533_;
                                                if (_e1923.member_3 != 4294967295u) {
                                                    if (_e1091 != 4294967295u) {
                                                        phi_2544_ = type_34(_e1031.member, true);
                                                    } else {
                                                        phi_2544_ = _e1031;
                                                    }
                                                    let _e1931 = phi_2544_;
                                                    phi_2545_ = _e1931;
                                                } else {
                                                    phi_2545_ = _e1031;
                                                }
                                                let _e1933 = phi_2545_;
                                                phi_975_ = _e1933;
                                            } else {
                                                phi_975_ = type_34();
                                            }
                                            let _e1935 = phi_975_;
                                            continue;
                                            continuing {
                                                phi_974_ = _e1935;
                                                phi_977_ = _e1046;
                                                phi_4004_ = _e503;
                                                break if !(_e1052);
                                            }
                                        }
                                        let _e1938 = phi_4004_;
                                        phi_4190_ = _e1938;
                                        if _e1938 {
                                            break;
                                        }
                                        let _e1940 = local_10;
                                        phi_4194_ = _e1938;
                                        let _e2140 = local_12;
                                        phi_3786_ = _e2140;
                                        phi_3787_ = _e544;
                                        phi_3788_ = false;
                                        phi_3789_ = select(_e548, 0u, _e1940.member_1);
                                    } else {
                                        if (_e544.member_1 >= _e90) {
                                            phi_3342_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e544.member_1 < _e90) {
                                            } else {
                                                phi_4190_ = true;
                                                break;
                                            }
                                            let _e560 = (_e261 * 2u);
                                            let _e562 = ((1u + _e560) % 7u);
                                            if (_e562 < 7u) {
                                            } else {
                                                phi_4190_ = true;
                                                break;
                                            }
                                            let _e567 = global_5.member[_e544.member_1][_e562];
                                            let _e569 = ((_e560 + 2u) % 7u);
                                            if (_e569 < 7u) {
                                            } else {
                                                phi_4190_ = true;
                                                break;
                                            }
                                            let _e574 = global_5.member[_e544.member_1][_e569];
                                            let _e575 = (_e260 * 2u);
                                            let _e577 = ((1u + _e575) % 7u);
                                            if (_e577 < 7u) {
                                            } else {
                                                phi_4190_ = true;
                                                break;
                                            }
                                            let _e582 = global_5.member[_e544.member_1][_e577];
                                            let _e584 = ((_e575 + 2u) % 7u);
                                            if (_e584 < 7u) {
                                            } else {
                                                phi_4190_ = true;
                                                break;
                                            }
                                            let _e589 = global_5.member[_e544.member_1][_e584];
                                            let _e590 = (_e262 * 2u);
                                            let _e592 = ((1u + _e590) % 7u);
                                            if (_e592 < 7u) {
                                            } else {
                                                phi_4190_ = true;
                                                break;
                                            }
                                            let _e597 = global_5.member[_e544.member_1][_e592];
                                            let _e599 = ((_e590 + 2u) % 7u);
                                            if (_e599 < 7u) {
                                            } else {
                                                phi_4190_ = true;
                                                break;
                                            }
                                            let _e604 = global_5.member[_e544.member_1][_e599];
                                            let _e627 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.x - _e544.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e628 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.y - _e544.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e629 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.z - _e544.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e631 = select(_e141, _e627, (_e627 > _e141));
                                            let _e633 = select(_e141, _e628, (_e628 > _e141));
                                            let _e635 = select(_e141, _e629, (_e629 > _e141));
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
                                            let _e738 = (_e544.member.member.x + _e668);
                                            let _e739 = (_e544.member.member.y + _e677);
                                            let _e740 = (_e544.member.member.z + _e686);
                                            let _e743 = (_e544.member.member_1.x - _e707);
                                            let _e744 = (_e544.member.member_1.y - _e716);
                                            let _e745 = (_e544.member.member_1.z - _e725);
                                            let _e764 = (_e743 - _e738);
                                            let _e765 = (_e744 - _e739);
                                            let _e766 = (_e745 - _e740);
                                            let _e768 = select(_e765, _e764, (_e764 > _e765));
                                            let _e770 = select(_e766, _e768, (_e768 > _e766));
                                            if (_e770 < (1024f * _e141)) {
                                                phi_3043_ = 0u;
                                            } else {
                                                phi_3043_ = select(2u, 1u, (_e770 < (2097152f * _e141)));
                                            }
                                            let _e777 = phi_3043_;
                                            switch bitcast<i32>(_e777) {
                                                case 0: {
                                                    phi_3049_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3049_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3049_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3049_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e780 = phi_3049_;
                                            let _e786 = global_5.member[_e544.member_1][0u];
                                            let _e790 = global_5.member[_e544.member_1][2u];
                                            let _e794 = global_5.member[_e544.member_1][4u];
                                            let _e798 = global_5.member[_e544.member_1][6u];
                                            let _e810 = (((_e790 >> bitcast<u32>(22i)) | ((_e794 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e798 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e811 = (_e786 & 268435455u);
                                            let _e812 = (_e810 & 268435455u);
                                            let _e815 = ((_e786 >> bitcast<u32>(28u)) & 7u);
                                            let _e823 = ((_e786 >> bitcast<u32>(31i)) | (((_e810 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e824 = (_e815 != 0u);
                                            if (_e815 == 0u) {
                                                phi_3304_ = _e811;
                                            } else {
                                                if (_e815 == 7u) {
                                                    phi_3303_ = 2147483648u;
                                                } else {
                                                    phi_3303_ = ((2147483648u | (_e815 << bitcast<u32>(28u))) | (_e812 & 268435455u));
                                                }
                                                let _e833 = phi_3303_;
                                                phi_3304_ = _e833;
                                            }
                                            let _e835 = phi_3304_;
                                            if _e824 {
                                                let _e836 = (_e815 != 7u);
                                                if _e836 {
                                                    phi_3314_ = (_e812 + (_e815 * ((3u * _e780) + 1u)));
                                                } else {
                                                    phi_3314_ = u32();
                                                }
                                                let _e840 = phi_3314_;
                                                phi_3316_ = _e840;
                                                phi_3317_ = select(true, false, _e836);
                                            } else {
                                                phi_3316_ = u32();
                                                phi_3317_ = true;
                                            }
                                            let _e843 = phi_3316_;
                                            let _e845 = phi_3317_;
                                            if (_e823 == 0u) {
                                                phi_3338_ = (_e811 + select(0u, 1u, !(_e824)));
                                            } else {
                                                if (_e823 == 7u) {
                                                    phi_3337_ = 2147483648u;
                                                } else {
                                                    phi_3337_ = ((2147483648u | (_e823 << bitcast<u32>(28u))) | (select(_e843, _e812, _e845) & 268435455u));
                                                }
                                                let _e858 = phi_3337_;
                                                phi_3338_ = _e858;
                                            }
                                            let _e860 = phi_3338_;
                                            phi_3342_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e738, (_e544.member.member.x + _e690), _e743, (_e544.member.member_1.x - _e729)), vec4<f32>(_e739, (_e544.member.member.y + _e694), _e744, (_e544.member.member_1.y - _e733)), vec4<f32>(_e740, (_e544.member.member.z + _e698), _e745, (_e544.member.member_1.z - _e737))), type_45(type_24((_e544.member.member + vec4<f32>(_e668, _e677, _e686, 0f)), (_e544.member.member_1 - vec4<f32>(_e707, _e716, _e725, 0f))), _e835), type_45(type_24((_e544.member.member + vec4<f32>(_e690, _e694, _e698, 0f)), (_e544.member.member_1 - vec4<f32>(_e729, _e733, _e737, 0f))), _e860));
                                        }
                                        let _e865 = phi_3342_;
                                        let _e877 = ((_e865.member[0].x - _e333) * _e338);
                                        let _e878 = ((_e865.member[0].y - _e333) * _e338);
                                        let _e879 = ((_e865.member[0].z - _e334) * _e338);
                                        let _e880 = ((_e865.member[0].w - _e334) * _e338);
                                        let _e890 = ((_e865.member[1].x - _e371) * _e376);
                                        let _e891 = ((_e865.member[1].y - _e371) * _e376);
                                        let _e892 = ((_e865.member[1].z - _e372) * _e376);
                                        let _e893 = ((_e865.member[1].w - _e372) * _e376);
                                        let _e903 = ((_e865.member[2].x - _e409) * _e414);
                                        let _e904 = ((_e865.member[2].y - _e409) * _e414);
                                        let _e905 = ((_e865.member[2].z - _e410) * _e414);
                                        let _e906 = ((_e865.member[2].w - _e410) * _e414);
                                        let _e908 = select(_e905, _e903, (_e903 < _e905));
                                        let _e910 = select(_e906, _e904, (_e904 < _e906));
                                        let _e912 = select(_e905, _e903, (_e903 > _e905));
                                        let _e914 = select(_e906, _e904, (_e904 > _e906));
                                        let _e916 = select(_e879, _e877, (_e877 < _e879));
                                        let _e918 = select(_e880, _e878, (_e878 < _e880));
                                        let _e920 = select(_e892, _e890, (_e890 < _e892));
                                        let _e922 = select(_e893, _e891, (_e891 < _e893));
                                        let _e924 = select(_e920, _e916, (_e916 > _e920));
                                        let _e926 = select(_e922, _e918, (_e918 > _e922));
                                        let _e928 = select(_e908, _e924, (_e924 > _e908));
                                        let _e930 = select(_e910, _e926, (_e926 > _e910));
                                        let _e932 = select(_e879, _e877, (_e877 > _e879));
                                        let _e934 = select(_e880, _e878, (_e878 > _e880));
                                        let _e936 = select(_e892, _e890, (_e890 > _e892));
                                        let _e938 = select(_e893, _e891, (_e891 > _e893));
                                        let _e940 = select(_e936, _e932, (_e932 < _e936));
                                        let _e942 = select(_e938, _e934, (_e934 < _e938));
                                        let _e947 = -(_e908);
                                        let _e948 = -(_e910);
                                        let _e955 = (select(_e912, _e940, (_e940 < _e912)) + (select(_e947, _e912, (_e912 > _e947)) * 0.0000019073523f));
                                        let _e956 = (select(_e914, _e942, (_e942 < _e914)) + (select(_e948, _e914, (_e914 > _e948)) * 0.0000019073523f));
                                        let _e958 = select(_e461, _e928, (_e928 > _e461));
                                        let _e960 = select(_e461, _e930, (_e930 > _e461));
                                        let _e965 = (_e958 <= select(_e505.member, _e955, (_e955 < _e505.member)));
                                        let _e966 = (_e960 <= select(_e505.member, _e956, (_e956 < _e505.member)));
                                        let _e967 = (_e958 <= _e960);
                                        if _e965 {
                                            if _e966 {
                                                if _e967 {
                                                    phi_3686_ = _e865.member_2;
                                                } else {
                                                    phi_3686_ = _e865.member_1;
                                                }
                                                let _e971 = phi_3686_;
                                                let _e993 = (_e548 % 128u);
                                                let _e994 = (_e993 < 128u);
                                                if _e994 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_8[_e993] = _e971.member_1;
                                                if _e994 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_7[_e993] = _e971.member.member.x;
                                                if _e994 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_6[_e993] = _e971.member.member.y;
                                                if _e994 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_5[_e993] = _e971.member.member.z;
                                                if _e994 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_4[_e993] = _e971.member.member_1.x;
                                                if _e994 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_3[_e993] = _e971.member.member_1.y;
                                                if _e994 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_2[_e993] = _e971.member.member_1.z;
                                                if _e994 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_9[_e993] = select(_e960, _e958, (_e958 > _e960));
                                                if _e967 {
                                                    phi_3763_ = _e865.member_1;
                                                } else {
                                                    phi_3763_ = _e865.member_2;
                                                }
                                                let _e1007 = phi_3763_;
                                                phi_3764_ = _e1007;
                                                phi_3765_ = (_e548 + 1u);
                                            } else {
                                                phi_3764_ = type_45();
                                                phi_3765_ = u32();
                                            }
                                            let _e1009 = phi_3764_;
                                            let _e1011 = phi_3765_;
                                            phi_3767_ = _e1009;
                                            phi_3768_ = _e1011;
                                            phi_3769_ = select(true, false, _e966);
                                        } else {
                                            phi_3767_ = type_45();
                                            phi_3768_ = u32();
                                            phi_3769_ = true;
                                        }
                                        let _e1014 = phi_3767_;
                                        let _e1016 = phi_3768_;
                                        let _e1018 = phi_3769_;
                                        if _e1018 {
                                            if _e965 {
                                                phi_3778_ = _e865.member_1;
                                            } else {
                                                phi_3778_ = _e865.member_2;
                                            }
                                            let _e1022 = phi_3778_;
                                            phi_3783_ = _e1022;
                                            phi_3784_ = select(_e966, true, _e965);
                                        } else {
                                            phi_3783_ = _e1014;
                                            phi_3784_ = _e546;
                                        }
                                        let _e1025 = phi_3783_;
                                        let _e1027 = phi_3784_;
                                        phi_4194_ = _e503;
                                        phi_3786_ = _e505;
                                        phi_3787_ = _e1025;
                                        phi_3788_ = _e1027;
                                        phi_3789_ = select(_e1016, _e548, _e1018);
                                    }
                                    let _e1944 = phi_4194_;
                                    let _e1946 = phi_3786_;
                                    let _e1948 = phi_3787_;
                                    let _e1950 = phi_3788_;
                                    let _e1952 = phi_3789_;
                                    phi_4193_ = _e1944;
                                    phi_3790_ = _e1946;
                                    phi_3791_ = _e1948;
                                    phi_3792_ = (_e509 - 1u);
                                    phi_3793_ = _e1950;
                                    phi_3794_ = _e1952;
                                } else {
                                    phi_4193_ = _e503;
                                    phi_3790_ = _e505;
                                    phi_3791_ = _e544;
                                    phi_3792_ = _e509;
                                    phi_3793_ = _e546;
                                    phi_3794_ = _e548;
                                }
                                let _e1954 = phi_4193_;
                                let _e1956 = phi_3790_;
                                let _e1958 = phi_3791_;
                                let _e1960 = phi_3792_;
                                let _e1962 = phi_3793_;
                                let _e1964 = phi_3794_;
                                phi_4192_ = _e1954;
                                phi_3795_ = _e1956;
                                phi_3796_ = _e1958;
                                phi_3797_ = _e1960;
                                phi_3798_ = _e1962;
                                phi_3799_ = _e1964;
                            } else {
                                phi_4192_ = _e503;
                                phi_3795_ = type_34();
                                phi_3796_ = type_45();
                                phi_3797_ = u32();
                                phi_3798_ = bool();
                                phi_3799_ = u32();
                            }
                            let _e1966 = phi_4192_;
                            let _e1968 = phi_3795_;
                            let _e1970 = phi_3796_;
                            let _e1972 = phi_3797_;
                            let _e1974 = phi_3798_;
                            let _e1976 = phi_3799_;
                            phi_4191_ = _e1966;
                            phi_848_ = _e1968;
                            phi_851_ = _e1970;
                            phi_853_ = _e1972;
                            phi_855_ = _e1974;
                            phi_857_ = _e1976;
                            phi_3800_ = _e517;
                        } else {
                            phi_4191_ = _e503;
                            phi_848_ = type_34();
                            phi_851_ = type_45();
                            phi_853_ = u32();
                            phi_855_ = bool();
                            phi_857_ = u32();
                            phi_3800_ = false;
                        }
                        let _e1978 = phi_4191_;
                        let _e1980 = phi_848_;
                        let _e1982 = phi_851_;
                        let _e1984 = phi_853_;
                        let _e1986 = phi_855_;
                        let _e1988 = phi_857_;
                        let _e1990 = phi_3800_;
                        continue;
                        continuing {
                            phi_4010_ = _e1978;
                            phi_847_ = _e1980;
                            phi_850_ = _e1982;
                            phi_852_ = _e1984;
                            phi_854_ = _e1986;
                            phi_856_ = _e1988;
                            phi_4190_ = _e1978;
                            break if !(_e1990);
                        }
                    }
                    let _e1993 = phi_4190_;
                    if _e1993 {
                        break;
                    }
                    let _e1995 = local_11;
                    if _e149 {
                    } else {
                        break;
                    }
                    global_4.member[_e147] = select(0u, 1u, _e1995.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
