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

struct type_40 {
    member: array<array<type_24, 8>>,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_55 {
    member: type_28,
    member_1: u32,
}

struct type_56 {
    member: array<vec4<f32>, 3>,
    member_1: type_55,
    member_2: type_55,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_40;

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
    var local_9: array<type_24, 8>;
    var local_10: array<f32, 128>;
    var local_11: array<u32, 3>;
    var local_12: array<array<f32, 3>, 3>;
    var local_13: array<f32, 4>;
    var phi_411_: i32;
    var phi_412_: i32;
    var phi_422_: bool;
    var phi_432_: u32;
    var phi_433_: u32;
    var phi_435_: bool;
    var phi_440_: u32;
    var phi_453_: i32;
    var phi_473_: i32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_508_: f32;
    var phi_514_: f32;
    var phi_537_: f32;
    var phi_548_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_603_: f32;
    var phi_614_: f32;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_640_: f32;
    var phi_646_: f32;
    var phi_669_: f32;
    var phi_680_: f32;
    var phi_780_: f32;
    var phi_781_: f32;
    var phi_3954_: bool;
    var phi_3853_: f32;
    var phi_923_: type_55;
    var phi_926_: u32;
    var phi_928_: bool;
    var phi_930_: u32;
    var phi_941_: bool;
    var phi_1028_: type_55;
    var phi_1029_: bool;
    var phi_1030_: u32;
    var phi_2722_: u32;
    var phi_2728_: u32;
    var phi_2982_: u32;
    var phi_2983_: u32;
    var phi_2993_: u32;
    var phi_2995_: u32;
    var phi_2996_: bool;
    var phi_3016_: u32;
    var phi_3017_: u32;
    var phi_3021_: type_56;
    var phi_3366_: type_55;
    var phi_3443_: type_55;
    var phi_3444_: type_55;
    var phi_3445_: u32;
    var phi_3447_: type_55;
    var phi_3448_: u32;
    var phi_3449_: bool;
    var phi_3458_: type_55;
    var phi_3463_: type_55;
    var phi_3464_: bool;
    var phi_4026_: f32;
    var phi_3951_: bool;
    var phi_1049_: type_8;
    var phi_1050_: type_8;
    var phi_1073_: type_8;
    var phi_1114_: u32;
    var phi_1120_: u32;
    var phi_1130_: u32;
    var phi_1146_: u32;
    var phi_1183_: u32;
    var phi_1189_: u32;
    var phi_1199_: u32;
    var phi_3936_: bool;
    var phi_1215_: type_8;
    var phi_1216_: type_8;
    var phi_1239_: type_8;
    var phi_1262_: u32;
    var phi_1277_: u32;
    var phi_1280_: type_8;
    var phi_1281_: type_8;
    var phi_1304_: type_8;
    var phi_1370_: u32;
    var phi_1350_: u32;
    var phi_1351_: u32;
    var phi_1374_: f32;
    var phi_3929_: bool;
    var phi_4008_: bool;
    var phi_4007_: bool;
    var phi_1875_: vec3<f32>;
    var phi_1876_: vec3<f32>;
    var phi_1907_: bool;
    var phi_1916_: vec3<f32>;
    var phi_1956_: type_24;
    var phi_1958_: type_24;
    var phi_1959_: bool;
    var phi_1963_: type_24;
    var phi_1964_: type_24;
    var phi_1965_: type_24;
    var phi_1966_: bool;
    var phi_1970_: type_24;
    var phi_1971_: bool;
    var phi_1975_: type_24;
    var phi_1976_: bool;
    var phi_1980_: type_24;
    var phi_1992_: type_8;
    var phi_1995_: type_24;
    var phi_1993_: type_8;
    var phi_2018_: type_8;
    var phi_2050_: bool;
    var phi_2051_: bool;
    var phi_2072_: type_24;
    var phi_1996_: type_24;
    var phi_4038_: bool;
    var phi_4322_: f32;
    var phi_4321_: f32;
    var phi_4100_: bool;
    var phi_4320_: f32;
    var phi_4099_: bool;
    var phi_4319_: f32;
    var phi_4098_: bool;
    var phi_4259_: f32;
    var phi_4097_: bool;
    var phi_4224_: f32;
    var phi_4106_: bool;
    var phi_3466_: type_55;
    var phi_3467_: bool;
    var phi_3468_: u32;
    var phi_4223_: f32;
    var phi_4105_: bool;
    var phi_3469_: type_55;
    var phi_3470_: u32;
    var phi_3471_: bool;
    var phi_3472_: u32;
    var phi_4222_: f32;
    var phi_4104_: bool;
    var phi_3473_: type_55;
    var phi_3474_: u32;
    var phi_3475_: bool;
    var phi_3476_: u32;
    var phi_4221_: f32;
    var phi_4103_: bool;
    var phi_924_: type_55;
    var phi_927_: u32;
    var phi_929_: bool;
    var phi_931_: u32;
    var phi_3477_: bool;
    var phi_4102_: bool;
    var phi_3484_: type_8;
    var phi_3485_: type_8;
    var phi_3508_: type_8;
    var phi_3574_: type_24;
    var phi_4214_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e97 = arrayLength((&global_3.member));
            let _e100 = arrayLength((&global_5.member));
            let _e108 = global_2.member[0u][0u];
            let _e112 = global_2.member[0u][1u];
            let _e116 = global_2.member[0u][2u];
            let _e120 = global_2.member[0u][3u];
            let _e124 = global_2.member[1u][0u];
            let _e128 = global_2.member[1u][1u];
            let _e132 = global_2.member[1u][2u];
            let _e135 = global_1.member[0u];
            let _e136 = bitcast<i32>(_e135);
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e154 = (_e95.x + (_e95.y * 2097152u));
            let _e155 = (_e154 < arrayLength((&global_4.member)));
            if _e155 {
                let _e156 = (_e154 < arrayLength((&global_6.member)));
                if _e156 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e164 = global_4.member[_e154].member_2[0u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_4.member[_e154].member_2[1u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_4.member[_e154].member_2[2u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_4.member[_e154].member[0u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e192 = global_4.member[_e154].member[1u];
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e199 = global_4.member[_e154].member[2u];
                    let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                    let _e203 = select(_e173, _e166, (_e173 < _e166));
                    let _e205 = select(_e180, _e203, (_e180 < _e203));
                    let _e207 = select(_e187, _e205, (_e187 < _e205));
                    let _e209 = select(_e194, _e207, (_e194 < _e207));
                    let _e211 = select(_e201, _e209, (_e201 < _e209));
                    let _e215 = global_4.member[_e154].member_1;
                    let _e217 = (bitcast<u32>(_e215) & 2147483647u);
                    let _e224 = global_4.member[_e154].member_3;
                    let _e230 = (((select(_e217, _e211, (_e217 < _e211)) < 2139095040u) && ((bitcast<u32>(_e224) & 2147483647u) <= 2139095040u)) && (_e205 > 0u));
                    if _e230 {
                        let _e233 = (bitcast<u32>(bitcast<f32>(_e205)) & 2147483647u);
                        if (_e233 >= 8388608u) {
                            phi_411_ = (bitcast<i32>((_e233 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_411_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e233)), 32u, (_e233 == 0u))));
                        }
                        let _e247 = phi_411_;
                        phi_412_ = _e247;
                    } else {
                        phi_412_ = 0i;
                    }
                    let _e249 = phi_412_;
                    let _e250 = (_e166 == _e205);
                    if _e250 {
                        phi_422_ = true;
                    } else {
                        phi_422_ = (_e173 == _e205);
                    }
                    let _e253 = phi_422_;
                    let _e254 = select(1u, 0u, _e250);
                    if _e253 {
                        let _e255 = (_e254 + 1u);
                        phi_432_ = _e255;
                        phi_433_ = _e255;
                        phi_435_ = select(true, false, (_e255 == 2u));
                    } else {
                        phi_432_ = u32();
                        phi_433_ = 0u;
                        phi_435_ = true;
                    }
                    let _e259 = phi_432_;
                    let _e261 = phi_433_;
                    let _e263 = phi_435_;
                    if _e263 {
                        phi_440_ = (_e261 + 1u);
                    } else {
                        phi_440_ = 0u;
                    }
                    let _e267 = phi_440_;
                    let _e268 = select(_e259, _e261, _e263);
                    let _e269 = select(_e254, select(2u, _e254, _e253), _e263);
                    if (_e136 < -126i) {
                        phi_453_ = -126i;
                    } else {
                        phi_453_ = select(_e136, 127i, (_e136 > 127i));
                    }
                    let _e274 = phi_453_;
                    let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                    let _e285 = bitcast<f32>((bitcast<u32>(((_e136 - _e274) + 127i)) << bitcast<u32>(23i)));
                    let _e286 = -(_e249);
                    if (_e286 < -126i) {
                        phi_473_ = -126i;
                    } else {
                        phi_473_ = select(_e286, 127i, (_e286 > 127i));
                    }
                    let _e291 = phi_473_;
                    let _e296 = bitcast<f32>((bitcast<u32>((_e291 + 127i)) << bitcast<u32>(23i)));
                    let _e302 = bitcast<f32>((bitcast<u32>(((_e286 - _e291) + 127i)) << bitcast<u32>(23i)));
                    let _e306 = global_4.member[_e154].member;
                    let _e307 = (_e268 == 0u);
                    if _e307 {
                        phi_491_ = _e306[0];
                    } else {
                        phi_491_ = _e306[1];
                    }
                    let _e311 = phi_491_;
                    let _e312 = (_e268 == 2u);
                    if _e312 {
                        phi_497_ = _e306[2];
                    } else {
                        phi_497_ = _e311;
                    }
                    let _e315 = phi_497_;
                    let _e317 = ((_e315 * _e279) * _e285);
                    let _e318 = global_4.member[_e154].member_2;
                    if _e307 {
                        phi_508_ = _e318[0];
                    } else {
                        phi_508_ = _e318[1];
                    }
                    let _e322 = phi_508_;
                    if _e312 {
                        phi_514_ = _e318[2];
                    } else {
                        phi_514_ = _e322;
                    }
                    let _e325 = phi_514_;
                    let _e327 = ((_e325 * _e296) * _e302);
                    let _e331 = (bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e331 {
                        let _e335 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) * 0.00000011920929f);
                        phi_537_ = select(0.00000000000011368684f, _e335, (_e335 > 0.00000000000011368684f));
                    } else {
                        phi_537_ = 0f;
                    }
                    let _e339 = phi_537_;
                    let _e340 = (_e317 + _e339);
                    let _e341 = (_e317 - _e339);
                    let _e342 = select(_e327, 0f, _e331);
                    if _e331 {
                        phi_548_ = 38685626000000000000000000f;
                    } else {
                        phi_548_ = (1f / _e327);
                    }
                    let _e345 = phi_548_;
                    let _e346 = (_e267 == 0u);
                    if _e346 {
                        phi_557_ = _e306[0];
                    } else {
                        phi_557_ = _e306[1];
                    }
                    let _e350 = phi_557_;
                    let _e351 = (_e267 == 2u);
                    if _e351 {
                        phi_563_ = _e306[2];
                    } else {
                        phi_563_ = _e350;
                    }
                    let _e354 = phi_563_;
                    let _e356 = ((_e354 * _e279) * _e285);
                    if _e346 {
                        phi_574_ = _e318[0];
                    } else {
                        phi_574_ = _e318[1];
                    }
                    let _e360 = phi_574_;
                    if _e351 {
                        phi_580_ = _e318[2];
                    } else {
                        phi_580_ = _e360;
                    }
                    let _e363 = phi_580_;
                    let _e365 = ((_e363 * _e296) * _e302);
                    let _e369 = (bitcast<f32>((bitcast<u32>(_e365) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e369 {
                        let _e373 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) * 0.00000011920929f);
                        phi_603_ = select(0.00000000000011368684f, _e373, (_e373 > 0.00000000000011368684f));
                    } else {
                        phi_603_ = 0f;
                    }
                    let _e377 = phi_603_;
                    let _e378 = (_e356 + _e377);
                    let _e379 = (_e356 - _e377);
                    let _e380 = select(_e365, 0f, _e369);
                    if _e369 {
                        phi_614_ = 38685626000000000000000000f;
                    } else {
                        phi_614_ = (1f / _e365);
                    }
                    let _e383 = phi_614_;
                    let _e384 = (_e269 == 0u);
                    if _e384 {
                        phi_623_ = _e306[0];
                    } else {
                        phi_623_ = _e306[1];
                    }
                    let _e388 = phi_623_;
                    let _e389 = (_e269 == 2u);
                    if _e389 {
                        phi_629_ = _e306[2];
                    } else {
                        phi_629_ = _e388;
                    }
                    let _e392 = phi_629_;
                    let _e394 = ((_e392 * _e279) * _e285);
                    if _e384 {
                        phi_640_ = _e318[0];
                    } else {
                        phi_640_ = _e318[1];
                    }
                    let _e398 = phi_640_;
                    if _e389 {
                        phi_646_ = _e318[2];
                    } else {
                        phi_646_ = _e398;
                    }
                    let _e401 = phi_646_;
                    let _e403 = ((_e401 * _e296) * _e302);
                    let _e407 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e407 {
                        let _e411 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) * 0.00000011920929f);
                        phi_669_ = select(0.00000000000011368684f, _e411, (_e411 > 0.00000000000011368684f));
                    } else {
                        phi_669_ = 0f;
                    }
                    let _e415 = phi_669_;
                    let _e416 = (_e394 + _e415);
                    let _e417 = (_e394 - _e415);
                    let _e418 = select(_e403, 0f, _e407);
                    if _e407 {
                        phi_680_ = 38685626000000000000000000f;
                    } else {
                        phi_680_ = (1f / _e403);
                    }
                    let _e421 = phi_680_;
                    let _e424 = bitcast<f32>((bitcast<u32>(_e317) & 2147483647u));
                    let _e427 = bitcast<f32>((bitcast<u32>(_e356) & 2147483647u));
                    let _e429 = select(_e427, _e424, (_e424 > _e427));
                    let _e432 = bitcast<f32>((bitcast<u32>(_e394) & 2147483647u));
                    let _e435 = (_e136 + _e249);
                    if (_e230 && (select(_e432, _e429, (_e429 > _e432)) <= 1099511600000f)) {
                        let _e438 = (_e435 / 3i);
                        let _e445 = bitcast<f32>((bitcast<u32>((_e438 + 127i)) << bitcast<u32>(23i)));
                        let _e452 = bitcast<f32>((bitcast<u32>(((_e435 - (2i * _e438)) + 127i)) << bitcast<u32>(23i)));
                        let _e453 = (((_e215 * _e445) * _e445) * _e452);
                        let _e455 = select(340282350000000000000000000000000000000f, _e453, (_e453 < 340282350000000000000000000000000000000f));
                        let _e460 = (((_e224 * _e445) * _e445) * _e452);
                        let _e462 = select(340282350000000000000000000000000000000f, _e460, (_e460 < 340282350000000000000000000000000000000f));
                        phi_780_ = select(-340282350000000000000000000000000000000f, _e462, (_e462 > -340282350000000000000000000000000000000f));
                        phi_781_ = select(-340282350000000000000000000000000000000f, _e455, (_e455 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_780_ = 0f;
                        phi_781_ = 1f;
                    }
                    let _e466 = phi_780_;
                    let _e468 = phi_781_;
                    local_9 = array<type_24, 8>(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e471 = (_e268 % 3u);
                    let _e472 = (_e471 < 3u);
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e474 = local_1[_e471];
                    let _e477 = (_e267 % 3u);
                    let _e478 = (_e477 < 3u);
                    if _e478 {
                    } else {
                        break;
                    }
                    let _e480 = local_1[_e477];
                    let _e483 = (_e269 % 3u);
                    let _e484 = (_e483 < 3u);
                    if _e484 {
                    } else {
                        break;
                    }
                    let _e486 = local_1[_e483];
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e491 = local[_e471];
                    if _e478 {
                    } else {
                        break;
                    }
                    let _e495 = local[_e477];
                    if _e484 {
                    } else {
                        break;
                    }
                    let _e499 = local[_e483];
                    phi_3954_ = false;
                    phi_3853_ = _e466;
                    phi_923_ = type_55(type_28(vec4<f32>((f32(_e474) * _e148), (f32(_e480) * _e148), (f32(_e486) * _e148), 0f), vec4<f32>((f32(_e491) * _e148), (f32(_e495) * _e148), (f32(_e499) * _e148), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                    phi_926_ = ((3u * _e97) + 1u);
                    phi_928_ = (_e468 <= _e466);
                    phi_930_ = 0u;
                    loop {
                        let _e509 = phi_3954_;
                        let _e511 = phi_3853_;
                        let _e513 = phi_923_;
                        let _e515 = phi_926_;
                        let _e517 = phi_928_;
                        let _e519 = phi_930_;
                        if _e517 {
                            phi_941_ = true;
                        } else {
                            phi_941_ = (_e519 > 0u);
                        }
                        let _e522 = phi_941_;
                        if _e522 {
                            let _e523 = (_e515 > 0u);
                            if _e523 {
                                if _e517 {
                                    phi_1028_ = _e513;
                                    phi_1029_ = _e517;
                                    phi_1030_ = _e519;
                                } else {
                                    let _e524 = (_e519 - 1u);
                                    let _e525 = (_e524 % 128u);
                                    let _e526 = (_e525 < 128u);
                                    if _e526 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e528 = local_7[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e530 = local_6[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e532 = local_5[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e534 = local_4[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e536 = local_3[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e538 = local_2[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e543 = local_8[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e546 = local_10[_e525];
                                    phi_1028_ = type_55(type_28(vec4<f32>(_e528, _e530, _e532, 0f), vec4<f32>(_e534, _e536, _e538, 0f)), _e543);
                                    phi_1029_ = (_e546 <= _e511);
                                    phi_1030_ = _e524;
                                }
                                let _e549 = phi_1028_;
                                let _e551 = phi_1029_;
                                let _e553 = phi_1030_;
                                if _e551 {
                                    let _e558 = (_e549.member_1 & 268435455u);
                                    if ((_e549.member_1 & 2147483648u) != 0u) {
                                        phi_4026_ = _e511;
                                        phi_3951_ = _e509;
                                        phi_1049_ = type_8(0u, ((_e549.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1038 = phi_4026_;
                                            let _e1040 = phi_3951_;
                                            let _e1042 = phi_1049_;
                                            if (_e1042.member < _e1042.member_1) {
                                                phi_1050_ = type_8((_e1042.member + 1u), _e1042.member_1);
                                                phi_1073_ = type_8(1u, _e1042.member);
                                            } else {
                                                phi_1050_ = _e1042;
                                                phi_1073_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1055 = phi_1050_;
                                            let _e1057 = phi_1073_;
                                            let _e1061 = (bitcast<i32>(_e1057.member) != 0i);
                                            if _e1061 {
                                                let _e1066 = (_e549.member.member_1.x - _e549.member.member.x);
                                                let _e1069 = (_e549.member.member_1.y - _e549.member.member.y);
                                                let _e1072 = (_e549.member.member_1.z - _e549.member.member.z);
                                                let _e1074 = select(_e1069, _e1066, (_e1066 > _e1069));
                                                let _e1076 = select(_e1072, _e1074, (_e1074 > _e1072));
                                                let _e1078 = (_e1076 < (1024f * _e148));
                                                if _e1078 {
                                                    phi_1114_ = 0u;
                                                } else {
                                                    phi_1114_ = select(2u, 1u, (_e1076 < (2097152f * _e148)));
                                                }
                                                let _e1083 = phi_1114_;
                                                switch bitcast<i32>(_e1083) {
                                                    case 0: {
                                                        phi_1120_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1120_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1120_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1120_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1086 = phi_1120_;
                                                switch bitcast<i32>(_e1083) {
                                                    case 0: {
                                                        phi_1130_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1130_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1130_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1130_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1093 = phi_1130_;
                                                let _e1095 = ((_e558 + (_e1057.member_1 * ((3u * _e1086) + 1u))) + (3u * _e1093));
                                                let _e1096 = (_e1095 < _e100);
                                                if _e1096 {
                                                    if _e1096 {
                                                    } else {
                                                        phi_4259_ = _e1038;
                                                        phi_4097_ = true;
                                                        break;
                                                    }
                                                    let _e1098 = global_5.member[_e1095];
                                                    phi_1146_ = _e1098;
                                                } else {
                                                    phi_1146_ = 4294967295u;
                                                }
                                                let _e1100 = phi_1146_;
                                                local_11 = array<u32, 3>(_e268, _e267, _e269);
                                                if _e1078 {
                                                    phi_1183_ = 0u;
                                                } else {
                                                    phi_1183_ = select(2u, 1u, (_e1076 < (2097152f * _e148)));
                                                }
                                                let _e1106 = phi_1183_;
                                                switch bitcast<i32>(_e1106) {
                                                    case 0: {
                                                        phi_1189_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1189_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1189_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1189_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1109 = phi_1189_;
                                                switch bitcast<i32>(_e1106) {
                                                    case 0: {
                                                        phi_1199_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1199_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1199_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1199_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1116 = phi_1199_;
                                                local_13 = array<f32, 4>(_e549.member.member.x, _e549.member.member.y, _e549.member.member.z, _e549.member.member.w);
                                                local_12[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_12[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_12[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3936_ = _e1040;
                                                phi_1215_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1130 = phi_3936_;
                                                    let _e1132 = phi_1215_;
                                                    if (_e1132.member < _e1132.member_1) {
                                                        phi_1216_ = type_8((_e1132.member + 1u), _e1132.member_1);
                                                        phi_1239_ = type_8(1u, _e1132.member);
                                                    } else {
                                                        phi_1216_ = _e1132;
                                                        phi_1239_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1145 = phi_1216_;
                                                    let _e1147 = phi_1239_;
                                                    let _e1151 = (bitcast<i32>(_e1147.member) != 0i);
                                                    if _e1151 {
                                                        let _e1153 = ((_e558 + (_e1057.member_1 * ((3u * _e1109) + 1u))) + (_e1147.member_1 * _e1116));
                                                        let _e1154 = (_e1153 < _e100);
                                                        if _e1154 {
                                                            if _e1154 {
                                                            } else {
                                                                phi_4007_ = true;
                                                                break;
                                                            }
                                                            let _e1156 = global_5.member[_e1153];
                                                            phi_1262_ = _e1156;
                                                        } else {
                                                            phi_1262_ = 0u;
                                                        }
                                                        let _e1158 = phi_1262_;
                                                        let _e1159 = (_e1153 + 1u);
                                                        let _e1160 = (_e1159 < _e100);
                                                        if _e1160 {
                                                            if _e1160 {
                                                            } else {
                                                                phi_4007_ = true;
                                                                break;
                                                            }
                                                            let _e1162 = global_5.member[_e1159];
                                                            phi_1277_ = _e1162;
                                                        } else {
                                                            phi_1277_ = 0u;
                                                        }
                                                        let _e1164 = phi_1277_;
                                                        phi_1280_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1166 = phi_1280_;
                                                            if (_e1166.member < _e1166.member_1) {
                                                                phi_1281_ = type_8((_e1166.member + 1u), _e1166.member_1);
                                                                phi_1304_ = type_8(1u, _e1166.member);
                                                            } else {
                                                                phi_1281_ = _e1166;
                                                                phi_1304_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1179 = phi_1281_;
                                                            let _e1181 = phi_1304_;
                                                            let _e1185 = (bitcast<i32>(_e1181.member) != 0i);
                                                            if _e1185 {
                                                                let _e1186 = (_e1181.member_1 < 3u);
                                                                if _e1186 {
                                                                } else {
                                                                    phi_3929_ = true;
                                                                    break;
                                                                }
                                                                let _e1188 = local_11[_e1181.member_1];
                                                                if (_e1181.member_1 < 4u) {
                                                                } else {
                                                                    phi_3929_ = true;
                                                                    break;
                                                                }
                                                                let _e1191 = local_13[_e1181.member_1];
                                                                switch bitcast<i32>(_e1106) {
                                                                    case 0: {
                                                                        phi_1374_ = (_e1191 + (f32(((_e1158 >> bitcast<u32>(((10u * _e1188) & 31u))) & 1023u)) * _e148));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1188 == 0u) {
                                                                            phi_1351_ = _e1158;
                                                                        } else {
                                                                            if (_e1188 == 1u) {
                                                                                phi_1350_ = ((_e1158 >> bitcast<u32>(21i)) | (_e1164 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1350_ = (_e1164 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1212 = phi_1350_;
                                                                            phi_1351_ = _e1212;
                                                                        }
                                                                        let _e1214 = phi_1351_;
                                                                        phi_1374_ = (_e1191 + (f32((_e1214 & 2097151u)) * _e148));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1193 = (_e1153 + _e1188);
                                                                        let _e1194 = (_e1193 < _e100);
                                                                        if _e1194 {
                                                                            if _e1194 {
                                                                            } else {
                                                                                phi_3929_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1196 = global_5.member[_e1193];
                                                                            phi_1370_ = _e1196;
                                                                        } else {
                                                                            phi_1370_ = 0u;
                                                                        }
                                                                        let _e1198 = phi_1370_;
                                                                        phi_1374_ = (f32(bitcast<i32>(_e1198)) * _e148);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1374_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1228 = phi_1374_;
                                                                if (_e1147.member_1 < 3u) {
                                                                } else {
                                                                    phi_3929_ = true;
                                                                    break;
                                                                }
                                                                if _e1186 {
                                                                } else {
                                                                    phi_3929_ = true;
                                                                    break;
                                                                }
                                                                local_12[_e1147.member_1][_e1181.member_1] = _e1228;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1280_ = _e1179;
                                                                phi_3929_ = _e1130;
                                                                break if !(_e1185);
                                                            }
                                                        }
                                                        let _e1234 = phi_3929_;
                                                        phi_4007_ = _e1234;
                                                        if _e1234 {
                                                            break;
                                                        }
                                                        phi_4008_ = _e1234;
                                                    } else {
                                                        phi_4008_ = _e1130;
                                                    }
                                                    let _e1236 = phi_4008_;
                                                    continue;
                                                    continuing {
                                                        phi_3936_ = _e1236;
                                                        phi_1215_ = _e1145;
                                                        phi_4007_ = _e1236;
                                                        break if !(_e1151);
                                                    }
                                                }
                                                let _e1239 = phi_4007_;
                                                phi_4259_ = _e1038;
                                                phi_4097_ = _e1239;
                                                if _e1239 {
                                                    break;
                                                }
                                                let _e1240 = local_12;
                                                let _e1255 = (_e1240[0][2] - _e394);
                                                let _e1258 = (((_e1240[0][0] - _e317) * _e418) - (_e1255 * _e342));
                                                let _e1261 = (((_e1240[0][1] - _e356) * _e418) - (_e1255 * _e380));
                                                let _e1264 = (_e1240[1][2] - _e394);
                                                let _e1267 = (((_e1240[1][0] - _e317) * _e418) - (_e1264 * _e342));
                                                let _e1270 = (((_e1240[1][1] - _e356) * _e418) - (_e1264 * _e380));
                                                let _e1273 = (_e1240[2][2] - _e394);
                                                let _e1276 = (((_e1240[2][0] - _e317) * _e418) - (_e1273 * _e342));
                                                let _e1279 = (((_e1240[2][1] - _e356) * _e418) - (_e1273 * _e380));
                                                let _e1280 = (_e1276 * _e1270);
                                                let _e1281 = (_e1279 * _e1267);
                                                let _e1282 = (_e1258 * _e1279);
                                                let _e1283 = (_e1261 * _e1276);
                                                let _e1284 = (_e1267 * _e1261);
                                                let _e1285 = (_e1270 * _e1258);
                                                let _e1290 = (((_e1280 >= _e1281) && (_e1282 >= _e1283)) && (_e1284 >= _e1285));
                                                if (_e1290 || (((_e1280 <= _e1281) && (_e1282 <= _e1283)) && (_e1284 <= _e1285))) {
                                                    let _e1297 = select(-1f, 1f, _e1290);
                                                    let _e1299 = ((_e1280 - _e1281) * _e1297);
                                                    let _e1301 = select(0f, _e1299, (_e1299 > 0f));
                                                    let _e1303 = ((_e1282 - _e1283) * _e1297);
                                                    let _e1305 = select(0f, _e1303, (_e1303 > 0f));
                                                    let _e1307 = ((_e1284 - _e1285) * _e1297);
                                                    let _e1309 = select(0f, _e1307, (_e1307 > 0f));
                                                    let _e1311 = ((_e1301 + _e1305) + _e1309);
                                                    if (_e1311 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1970_ = type_24();
                                                        phi_1971_ = true;
                                                    } else {
                                                        let _e1314 = select(_e1240[1][0], _e1240[0][0], (_e1240[0][0] < _e1240[1][0]));
                                                        let _e1318 = select(_e1240[1][0], _e1240[0][0], (_e1240[0][0] > _e1240[1][0]));
                                                        let _e1322 = select(_e1240[1][1], _e1240[0][1], (_e1240[0][1] < _e1240[1][1]));
                                                        let _e1326 = select(_e1240[1][1], _e1240[0][1], (_e1240[0][1] > _e1240[1][1]));
                                                        let _e1330 = select(_e1240[1][2], _e1240[0][2], (_e1240[0][2] < _e1240[1][2]));
                                                        let _e1334 = select(_e1240[1][2], _e1240[0][2], (_e1240[0][2] > _e1240[1][2]));
                                                        let _e1339 = ((select(_e1240[2][0], _e1314, (_e1314 < _e1240[2][0])) - _e340) * _e345);
                                                        let _e1340 = ((select(_e1240[2][0], _e1318, (_e1318 > _e1240[2][0])) - _e341) * _e345);
                                                        let _e1343 = ((select(_e1240[2][1], _e1322, (_e1322 < _e1240[2][1])) - _e378) * _e383);
                                                        let _e1344 = ((select(_e1240[2][1], _e1326, (_e1326 > _e1240[2][1])) - _e379) * _e383);
                                                        let _e1347 = ((select(_e1240[2][2], _e1330, (_e1330 < _e1240[2][2])) - _e416) * _e421);
                                                        let _e1348 = ((select(_e1240[2][2], _e1334, (_e1334 > _e1240[2][2])) - _e417) * _e421);
                                                        let _e1350 = select(_e1348, _e1347, (_e1347 < _e1348));
                                                        let _e1352 = select(_e1348, _e1347, (_e1347 > _e1348));
                                                        let _e1354 = select(_e1340, _e1339, (_e1339 < _e1340));
                                                        let _e1356 = select(_e1344, _e1343, (_e1343 < _e1344));
                                                        let _e1358 = select(_e1356, _e1354, (_e1354 > _e1356));
                                                        let _e1360 = select(_e1350, _e1358, (_e1358 > _e1350));
                                                        let _e1362 = select(_e1340, _e1339, (_e1339 > _e1340));
                                                        let _e1364 = select(_e1344, _e1343, (_e1343 > _e1344));
                                                        let _e1366 = select(_e1364, _e1362, (_e1362 < _e1364));
                                                        let _e1368 = select(_e1352, _e1366, (_e1366 < _e1352));
                                                        let _e1369 = -(_e1350);
                                                        let _e1375 = select(_e468, _e1360, (_e1360 > _e468));
                                                        if (_e1375 > (_e1368 + (select(_e1369, _e1352, (_e1352 > _e1369)) * 0.0000019073523f))) {
                                                            phi_1965_ = type_24();
                                                            phi_1966_ = true;
                                                        } else {
                                                            let _e1377 = (_e1375 > _e1038);
                                                            if _e1377 {
                                                                phi_1964_ = type_24();
                                                            } else {
                                                                let _e1381 = (_e1240[1][0] - _e1240[0][0]);
                                                                let _e1382 = (_e1240[1][1] - _e1240[0][1]);
                                                                let _e1383 = (_e1240[1][2] - _e1240[0][2]);
                                                                let _e1384 = vec3<f32>(_e1381, _e1382, _e1383);
                                                                let _e1385 = (_e1240[2][0] - _e1240[1][0]);
                                                                let _e1386 = (_e1240[2][1] - _e1240[1][1]);
                                                                let _e1387 = (_e1240[2][2] - _e1240[1][2]);
                                                                let _e1388 = vec3<f32>(_e1385, _e1386, _e1387);
                                                                let _e1389 = (_e1240[0][0] - _e1240[2][0]);
                                                                let _e1390 = (_e1240[0][1] - _e1240[2][1]);
                                                                let _e1391 = (_e1240[0][2] - _e1240[2][2]);
                                                                let _e1392 = vec3<f32>(_e1389, _e1390, _e1391);
                                                                let _e1395 = bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u));
                                                                let _e1398 = bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u));
                                                                let _e1400 = select(_e1398, _e1395, (_e1395 > _e1398));
                                                                let _e1403 = bitcast<f32>((bitcast<u32>(_e1383) & 2147483647u));
                                                                let _e1405 = select(_e1403, _e1400, (_e1400 > _e1403));
                                                                let _e1408 = bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u));
                                                                let _e1411 = bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u));
                                                                let _e1413 = select(_e1411, _e1408, (_e1408 > _e1411));
                                                                let _e1416 = bitcast<f32>((bitcast<u32>(_e1387) & 2147483647u));
                                                                let _e1418 = select(_e1416, _e1413, (_e1413 > _e1416));
                                                                let _e1421 = bitcast<f32>((bitcast<u32>(_e1389) & 2147483647u));
                                                                let _e1424 = bitcast<f32>((bitcast<u32>(_e1390) & 2147483647u));
                                                                let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                                let _e1429 = bitcast<f32>((bitcast<u32>(_e1391) & 2147483647u));
                                                                let _e1431 = select(_e1429, _e1426, (_e1426 > _e1429));
                                                                let _e1433 = select(_e1418, _e1405, (_e1405 > _e1418));
                                                                let _e1435 = select(_e1431, _e1433, (_e1433 > _e1431));
                                                                if (_e1405 == _e1435) {
                                                                    phi_1875_ = _e1388;
                                                                    phi_1876_ = _e1392;
                                                                } else {
                                                                    let _e1438 = vec3((_e1418 == _e1435));
                                                                    phi_1875_ = select(_e1384, _e1392, _e1438);
                                                                    phi_1876_ = select(_e1388, _e1384, _e1438);
                                                                }
                                                                let _e1442 = phi_1875_;
                                                                let _e1444 = phi_1876_;
                                                                let _e1451 = ((_e1442.y * _e1444.z) - (_e1444.y * _e1442.z));
                                                                let _e1456 = ((_e1442.z * _e1444.x) - (_e1444.z * _e1442.x));
                                                                let _e1459 = ((_e1442.x * _e1444.y) - (_e1444.x * _e1442.y));
                                                                if (_e1301 >= _e1305) {
                                                                    phi_1907_ = select(true, false, (_e1301 >= _e1309));
                                                                } else {
                                                                    phi_1907_ = true;
                                                                }
                                                                let _e1464 = phi_1907_;
                                                                if _e1464 {
                                                                    phi_1916_ = select(vec3<f32>(_e1240[2][0], _e1240[2][1], _e1240[2][2]), vec3<f32>(_e1240[1][0], _e1240[1][1], _e1240[1][2]), vec3((_e1305 >= _e1309)));
                                                                } else {
                                                                    phi_1916_ = vec3<f32>(_e1240[0][0], _e1240[0][1], _e1240[0][2]);
                                                                }
                                                                let _e1469 = phi_1916_;
                                                                let _e1486 = ((((_e1451 * (_e1469.x - _e317)) + (_e1456 * (_e1469.y - _e356))) + (_e1459 * (_e1469.z - _e394))) / (((_e1451 * _e342) + (_e1456 * _e380)) + (_e1459 * _e418)));
                                                                let _e1488 = select(_e1368, _e1486, (_e1486 < _e1368));
                                                                let _e1490 = select(_e1360, _e1488, (_e1488 > _e1360));
                                                                if (_e1490 >= _e468) {
                                                                    let _e1492 = (_e1490 <= _e1038);
                                                                    if _e1492 {
                                                                        let _e1493 = (1f / _e1311);
                                                                        phi_1956_ = type_24(_e1490, (_e1305 * _e1493), (_e1309 * _e1493), _e1100);
                                                                    } else {
                                                                        phi_1956_ = type_24();
                                                                    }
                                                                    let _e1498 = phi_1956_;
                                                                    phi_1958_ = _e1498;
                                                                    phi_1959_ = select(true, false, _e1492);
                                                                } else {
                                                                    phi_1958_ = type_24();
                                                                    phi_1959_ = true;
                                                                }
                                                                let _e1501 = phi_1958_;
                                                                let _e1503 = phi_1959_;
                                                                if _e1503 {
                                                                    phi_1963_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1963_ = _e1501;
                                                                }
                                                                let _e1505 = phi_1963_;
                                                                phi_1964_ = _e1505;
                                                            }
                                                            let _e1507 = phi_1964_;
                                                            phi_1965_ = _e1507;
                                                            phi_1966_ = _e1377;
                                                        }
                                                        let _e1509 = phi_1965_;
                                                        let _e1511 = phi_1966_;
                                                        phi_1970_ = _e1509;
                                                        phi_1971_ = _e1511;
                                                    }
                                                    let _e1513 = phi_1970_;
                                                    let _e1515 = phi_1971_;
                                                    phi_1975_ = _e1513;
                                                    phi_1976_ = _e1515;
                                                } else {
                                                    phi_1975_ = type_24();
                                                    phi_1976_ = true;
                                                }
                                                let _e1517 = phi_1975_;
                                                let _e1519 = phi_1976_;
                                                if _e1519 {
                                                    phi_1980_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1980_ = _e1517;
                                                }
                                                let _e1521 = phi_1980_;
                                                if (_e1521.member_3 != 4294967295u) {
                                                    if (_e1100 != 4294967295u) {
                                                        phi_1992_ = type_8(0u, 8u);
                                                        phi_1995_ = _e1521;
                                                        loop {
                                                            let _e1526 = phi_1992_;
                                                            let _e1528 = phi_1995_;
                                                            if (_e1526.member < _e1526.member_1) {
                                                                phi_1993_ = type_8((_e1526.member + 1u), _e1526.member_1);
                                                                phi_2018_ = type_8(1u, _e1526.member);
                                                            } else {
                                                                phi_1993_ = _e1526;
                                                                phi_2018_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1541 = phi_1993_;
                                                            let _e1543 = phi_2018_;
                                                            let _e1547 = (bitcast<i32>(_e1543.member) != 0i);
                                                            if _e1547 {
                                                                let _e1548 = (_e1543.member_1 < 8u);
                                                                if _e1548 {
                                                                } else {
                                                                    phi_4038_ = true;
                                                                    break;
                                                                }
                                                                let _e1553 = local_9[_e1543.member_1].member;
                                                                if (_e1528.member < _e1553) {
                                                                    phi_2051_ = true;
                                                                } else {
                                                                    let _e1555 = local_9[_e1543.member_1].member;
                                                                    if (_e1528.member == _e1555) {
                                                                        let _e1560 = local_9[_e1543.member_1].member_3;
                                                                        phi_2050_ = (_e1528.member_3 < _e1560);
                                                                    } else {
                                                                        phi_2050_ = false;
                                                                    }
                                                                    let _e1563 = phi_2050_;
                                                                    phi_2051_ = _e1563;
                                                                }
                                                                let _e1565 = phi_2051_;
                                                                if _e1565 {
                                                                    if _e1548 {
                                                                    } else {
                                                                        phi_4038_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1566 = local_9[_e1543.member_1];
                                                                    local_9[_e1543.member_1] = type_24(_e1528.member, _e1528.member_1, _e1528.member_2, _e1528.member_3);
                                                                    phi_2072_ = type_24(_e1566.member, _e1566.member_1, _e1566.member_2, _e1566.member_3);
                                                                } else {
                                                                    phi_2072_ = _e1528;
                                                                }
                                                                let _e1577 = phi_2072_;
                                                                phi_1996_ = _e1577;
                                                            } else {
                                                                phi_1996_ = type_24();
                                                            }
                                                            let _e1579 = phi_1996_;
                                                            continue;
                                                            continuing {
                                                                phi_1992_ = _e1541;
                                                                phi_1995_ = _e1579;
                                                                phi_4038_ = _e1239;
                                                                break if !(_e1547);
                                                            }
                                                        }
                                                        let _e1582 = phi_4038_;
                                                        phi_4259_ = _e1038;
                                                        phi_4097_ = _e1582;
                                                        if _e1582 {
                                                            break;
                                                        }
                                                        let _e1585 = local_9[7u].member_3;
                                                        if (_e1585 != 4294967295u) {
                                                            let _e1589 = local_9[7u].member;
                                                            phi_4322_ = _e1589;
                                                        } else {
                                                            phi_4322_ = _e1038;
                                                        }
                                                        let _e1591 = phi_4322_;
                                                        phi_4321_ = _e1591;
                                                        phi_4100_ = _e1582;
                                                    } else {
                                                        phi_4321_ = _e1038;
                                                        phi_4100_ = _e1239;
                                                    }
                                                    let _e1593 = phi_4321_;
                                                    let _e1595 = phi_4100_;
                                                    phi_4320_ = _e1593;
                                                    phi_4099_ = _e1595;
                                                } else {
                                                    phi_4320_ = _e1038;
                                                    phi_4099_ = _e1239;
                                                }
                                                let _e1597 = phi_4320_;
                                                let _e1599 = phi_4099_;
                                                phi_4319_ = _e1597;
                                                phi_4098_ = _e1599;
                                            } else {
                                                phi_4319_ = _e1038;
                                                phi_4098_ = _e1040;
                                            }
                                            let _e1601 = phi_4319_;
                                            let _e1603 = phi_4098_;
                                            continue;
                                            continuing {
                                                phi_4026_ = _e1601;
                                                phi_3951_ = _e1603;
                                                phi_1049_ = _e1055;
                                                phi_4259_ = _e1601;
                                                phi_4097_ = _e1603;
                                                break if !(_e1061);
                                            }
                                        }
                                        let _e1606 = phi_4259_;
                                        let _e1608 = phi_4097_;
                                        phi_4102_ = _e1608;
                                        if _e1608 {
                                            break;
                                        }
                                        phi_4224_ = _e1606;
                                        phi_4106_ = _e1608;
                                        phi_3466_ = _e549;
                                        phi_3467_ = false;
                                        phi_3468_ = _e553;
                                    } else {
                                        if (_e549.member_1 >= _e97) {
                                            phi_3021_ = type_56(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_55(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_55(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e549.member_1 < _e97) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e566 = ((1u + _e268) % 4u);
                                            if (_e566 < 4u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e571 = global_3.member[_e549.member_1][_e566];
                                            let _e573 = ((1u + _e267) % 4u);
                                            if (_e573 < 4u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e578 = global_3.member[_e549.member_1][_e573];
                                            let _e580 = ((1u + _e269) % 4u);
                                            if (_e580 < 4u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e585 = global_3.member[_e549.member_1][_e580];
                                            let _e587 = ((_e268 + 1u) % 4u);
                                            if (_e587 < 4u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e592 = global_3.member[_e549.member_1][_e587];
                                            let _e594 = (_e592 >> bitcast<u32>(11u));
                                            let _e596 = ((_e267 + 1u) % 4u);
                                            if (_e596 < 4u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e601 = global_3.member[_e549.member_1][_e596];
                                            let _e603 = (_e601 >> bitcast<u32>(11u));
                                            let _e605 = ((_e269 + 1u) % 4u);
                                            if (_e605 < 4u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e610 = global_3.member[_e549.member_1][_e605];
                                            let _e612 = (_e610 >> bitcast<u32>(11u));
                                            let _e635 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.x - _e549.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e636 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.y - _e549.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e637 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.z - _e549.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e639 = select(_e148, _e635, (_e635 > _e148));
                                            let _e641 = select(_e148, _e636, (_e636 > _e148));
                                            let _e643 = select(_e148, _e637, (_e637 > _e148));
                                            let _e668 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e639));
                                            let _e673 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e676 = bitcast<f32>((_e668 & bitcast<u32>(_e673)));
                                            let _e677 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e641));
                                            let _e682 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                            let _e686 = bitcast<u32>((f32(bitcast<i32>((_e585 & 1023u))) * _e643));
                                            let _e691 = (bitcast<i32>((_e585 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e694 = bitcast<f32>((_e686 & bitcast<u32>(_e691)));
                                            let _e698 = bitcast<f32>((_e668 & bitcast<u32>(~(_e673))));
                                            let _e702 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                            let _e706 = bitcast<f32>((_e686 & bitcast<u32>(~(_e691))));
                                            let _e707 = bitcast<u32>((f32(bitcast<i32>((_e594 & 1023u))) * _e639));
                                            let _e712 = (bitcast<i32>((_e594 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e715 = bitcast<f32>((_e707 & bitcast<u32>(_e712)));
                                            let _e716 = bitcast<u32>((f32(bitcast<i32>((_e603 & 1023u))) * _e641));
                                            let _e721 = (bitcast<i32>((_e603 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e724 = bitcast<f32>((_e716 & bitcast<u32>(_e721)));
                                            let _e725 = bitcast<u32>((f32(bitcast<i32>((_e612 & 1023u))) * _e643));
                                            let _e730 = (bitcast<i32>((_e612 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e733 = bitcast<f32>((_e725 & bitcast<u32>(_e730)));
                                            let _e737 = bitcast<f32>((_e707 & bitcast<u32>(~(_e712))));
                                            let _e741 = bitcast<f32>((_e716 & bitcast<u32>(~(_e721))));
                                            let _e745 = bitcast<f32>((_e725 & bitcast<u32>(~(_e730))));
                                            let _e746 = (_e549.member.member.x + _e676);
                                            let _e747 = (_e549.member.member.y + _e685);
                                            let _e748 = (_e549.member.member.z + _e694);
                                            let _e751 = (_e549.member.member_1.x - _e715);
                                            let _e752 = (_e549.member.member_1.y - _e724);
                                            let _e753 = (_e549.member.member_1.z - _e733);
                                            let _e772 = (_e751 - _e746);
                                            let _e773 = (_e752 - _e747);
                                            let _e774 = (_e753 - _e748);
                                            let _e776 = select(_e773, _e772, (_e772 > _e773));
                                            let _e778 = select(_e774, _e776, (_e776 > _e774));
                                            if (_e778 < (1024f * _e148)) {
                                                phi_2722_ = 0u;
                                            } else {
                                                phi_2722_ = select(2u, 1u, (_e778 < (2097152f * _e148)));
                                            }
                                            let _e785 = phi_2722_;
                                            switch bitcast<i32>(_e785) {
                                                case 0: {
                                                    phi_2728_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2728_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2728_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2728_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e788 = phi_2728_;
                                            let _e794 = global_3.member[_e549.member_1][0u];
                                            let _e798 = global_3.member[_e549.member_1][1u];
                                            let _e802 = global_3.member[_e549.member_1][2u];
                                            let _e806 = global_3.member[_e549.member_1][3u];
                                            let _e818 = (((_e798 >> bitcast<u32>(22i)) | ((_e802 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e806 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e819 = (_e794 & 268435455u);
                                            let _e820 = (_e818 & 268435455u);
                                            let _e823 = ((_e794 >> bitcast<u32>(28u)) & 7u);
                                            let _e831 = ((_e794 >> bitcast<u32>(31i)) | (((_e818 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e832 = (_e823 != 0u);
                                            if (_e823 == 0u) {
                                                phi_2983_ = _e819;
                                            } else {
                                                if (_e823 == 7u) {
                                                    phi_2982_ = 2147483648u;
                                                } else {
                                                    phi_2982_ = ((2147483648u | (_e823 << bitcast<u32>(28u))) | (_e820 & 268435455u));
                                                }
                                                let _e841 = phi_2982_;
                                                phi_2983_ = _e841;
                                            }
                                            let _e843 = phi_2983_;
                                            if _e832 {
                                                let _e844 = (_e823 != 7u);
                                                if _e844 {
                                                    phi_2993_ = (_e820 + (_e823 * ((3u * _e788) + 1u)));
                                                } else {
                                                    phi_2993_ = u32();
                                                }
                                                let _e848 = phi_2993_;
                                                phi_2995_ = _e848;
                                                phi_2996_ = select(true, false, _e844);
                                            } else {
                                                phi_2995_ = u32();
                                                phi_2996_ = true;
                                            }
                                            let _e851 = phi_2995_;
                                            let _e853 = phi_2996_;
                                            if (_e831 == 0u) {
                                                phi_3017_ = (_e819 + select(0u, 1u, !(_e832)));
                                            } else {
                                                if (_e831 == 7u) {
                                                    phi_3016_ = 2147483648u;
                                                } else {
                                                    phi_3016_ = ((2147483648u | (_e831 << bitcast<u32>(28u))) | (select(_e851, _e820, _e853) & 268435455u));
                                                }
                                                let _e866 = phi_3016_;
                                                phi_3017_ = _e866;
                                            }
                                            let _e868 = phi_3017_;
                                            phi_3021_ = type_56(array<vec4<f32>, 3>(vec4<f32>(_e746, (_e549.member.member.x + _e698), _e751, (_e549.member.member_1.x - _e737)), vec4<f32>(_e747, (_e549.member.member.y + _e702), _e752, (_e549.member.member_1.y - _e741)), vec4<f32>(_e748, (_e549.member.member.z + _e706), _e753, (_e549.member.member_1.z - _e745))), type_55(type_28((_e549.member.member + vec4<f32>(_e676, _e685, _e694, 0f)), (_e549.member.member_1 - vec4<f32>(_e715, _e724, _e733, 0f))), _e843), type_55(type_28((_e549.member.member + vec4<f32>(_e698, _e702, _e706, 0f)), (_e549.member.member_1 - vec4<f32>(_e737, _e741, _e745, 0f))), _e868));
                                        }
                                        let _e873 = phi_3021_;
                                        let _e884 = ((_e873.member[0].x - _e340) * _e345);
                                        let _e885 = ((_e873.member[0].y - _e340) * _e345);
                                        let _e886 = ((_e873.member[0].z - _e341) * _e345);
                                        let _e887 = ((_e873.member[0].w - _e341) * _e345);
                                        let _e897 = ((_e873.member[1].x - _e378) * _e383);
                                        let _e898 = ((_e873.member[1].y - _e378) * _e383);
                                        let _e899 = ((_e873.member[1].z - _e379) * _e383);
                                        let _e900 = ((_e873.member[1].w - _e379) * _e383);
                                        let _e910 = ((_e873.member[2].x - _e416) * _e421);
                                        let _e911 = ((_e873.member[2].y - _e416) * _e421);
                                        let _e912 = ((_e873.member[2].z - _e417) * _e421);
                                        let _e913 = ((_e873.member[2].w - _e417) * _e421);
                                        let _e915 = select(_e912, _e910, (_e910 < _e912));
                                        let _e917 = select(_e913, _e911, (_e911 < _e913));
                                        let _e919 = select(_e912, _e910, (_e910 > _e912));
                                        let _e921 = select(_e913, _e911, (_e911 > _e913));
                                        let _e923 = select(_e886, _e884, (_e884 < _e886));
                                        let _e925 = select(_e887, _e885, (_e885 < _e887));
                                        let _e927 = select(_e899, _e897, (_e897 < _e899));
                                        let _e929 = select(_e900, _e898, (_e898 < _e900));
                                        let _e931 = select(_e927, _e923, (_e923 > _e927));
                                        let _e933 = select(_e929, _e925, (_e925 > _e929));
                                        let _e935 = select(_e915, _e931, (_e931 > _e915));
                                        let _e937 = select(_e917, _e933, (_e933 > _e917));
                                        let _e939 = select(_e886, _e884, (_e884 > _e886));
                                        let _e941 = select(_e887, _e885, (_e885 > _e887));
                                        let _e943 = select(_e899, _e897, (_e897 > _e899));
                                        let _e945 = select(_e900, _e898, (_e898 > _e900));
                                        let _e947 = select(_e943, _e939, (_e939 < _e943));
                                        let _e949 = select(_e945, _e941, (_e941 < _e945));
                                        let _e954 = -(_e915);
                                        let _e955 = -(_e917);
                                        let _e962 = (select(_e919, _e947, (_e947 < _e919)) + (select(_e954, _e919, (_e919 > _e954)) * 0.0000019073523f));
                                        let _e963 = (select(_e921, _e949, (_e949 < _e921)) + (select(_e955, _e921, (_e921 > _e955)) * 0.0000019073523f));
                                        let _e965 = select(_e468, _e935, (_e935 > _e468));
                                        let _e967 = select(_e468, _e937, (_e937 > _e468));
                                        let _e972 = (_e965 <= select(_e511, _e962, (_e962 < _e511)));
                                        let _e973 = (_e967 <= select(_e511, _e963, (_e963 < _e511)));
                                        let _e974 = (_e965 <= _e967);
                                        if _e972 {
                                            if _e973 {
                                                if _e974 {
                                                    phi_3366_ = _e873.member_2;
                                                } else {
                                                    phi_3366_ = _e873.member_1;
                                                }
                                                let _e978 = phi_3366_;
                                                let _e1000 = (_e553 % 128u);
                                                let _e1001 = (_e1000 < 128u);
                                                if _e1001 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_8[_e1000] = _e978.member_1;
                                                if _e1001 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_7[_e1000] = _e978.member.member.x;
                                                if _e1001 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_6[_e1000] = _e978.member.member.y;
                                                if _e1001 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_5[_e1000] = _e978.member.member.z;
                                                if _e1001 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_4[_e1000] = _e978.member.member_1.x;
                                                if _e1001 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_3[_e1000] = _e978.member.member_1.y;
                                                if _e1001 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_2[_e1000] = _e978.member.member_1.z;
                                                if _e1001 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_10[_e1000] = select(_e967, _e965, (_e965 > _e967));
                                                if _e974 {
                                                    phi_3443_ = _e873.member_1;
                                                } else {
                                                    phi_3443_ = _e873.member_2;
                                                }
                                                let _e1014 = phi_3443_;
                                                phi_3444_ = _e1014;
                                                phi_3445_ = (_e553 + 1u);
                                            } else {
                                                phi_3444_ = type_55();
                                                phi_3445_ = u32();
                                            }
                                            let _e1016 = phi_3444_;
                                            let _e1018 = phi_3445_;
                                            phi_3447_ = _e1016;
                                            phi_3448_ = _e1018;
                                            phi_3449_ = select(true, false, _e973);
                                        } else {
                                            phi_3447_ = type_55();
                                            phi_3448_ = u32();
                                            phi_3449_ = true;
                                        }
                                        let _e1021 = phi_3447_;
                                        let _e1023 = phi_3448_;
                                        let _e1025 = phi_3449_;
                                        if _e1025 {
                                            if _e972 {
                                                phi_3458_ = _e873.member_1;
                                            } else {
                                                phi_3458_ = _e873.member_2;
                                            }
                                            let _e1029 = phi_3458_;
                                            phi_3463_ = _e1029;
                                            phi_3464_ = select(_e973, true, _e972);
                                        } else {
                                            phi_3463_ = _e1021;
                                            phi_3464_ = _e551;
                                        }
                                        let _e1032 = phi_3463_;
                                        let _e1034 = phi_3464_;
                                        phi_4224_ = _e511;
                                        phi_4106_ = _e509;
                                        phi_3466_ = _e1032;
                                        phi_3467_ = _e1034;
                                        phi_3468_ = select(_e1023, _e553, _e1025);
                                    }
                                    let _e1610 = phi_4224_;
                                    let _e1612 = phi_4106_;
                                    let _e1614 = phi_3466_;
                                    let _e1616 = phi_3467_;
                                    let _e1618 = phi_3468_;
                                    phi_4223_ = _e1610;
                                    phi_4105_ = _e1612;
                                    phi_3469_ = _e1614;
                                    phi_3470_ = (_e515 - 1u);
                                    phi_3471_ = _e1616;
                                    phi_3472_ = _e1618;
                                } else {
                                    phi_4223_ = _e511;
                                    phi_4105_ = _e509;
                                    phi_3469_ = _e549;
                                    phi_3470_ = _e515;
                                    phi_3471_ = _e551;
                                    phi_3472_ = _e553;
                                }
                                let _e1620 = phi_4223_;
                                let _e1622 = phi_4105_;
                                let _e1624 = phi_3469_;
                                let _e1626 = phi_3470_;
                                let _e1628 = phi_3471_;
                                let _e1630 = phi_3472_;
                                phi_4222_ = _e1620;
                                phi_4104_ = _e1622;
                                phi_3473_ = _e1624;
                                phi_3474_ = _e1626;
                                phi_3475_ = _e1628;
                                phi_3476_ = _e1630;
                            } else {
                                phi_4222_ = _e511;
                                phi_4104_ = _e509;
                                phi_3473_ = type_55();
                                phi_3474_ = u32();
                                phi_3475_ = bool();
                                phi_3476_ = u32();
                            }
                            let _e1632 = phi_4222_;
                            let _e1634 = phi_4104_;
                            let _e1636 = phi_3473_;
                            let _e1638 = phi_3474_;
                            let _e1640 = phi_3475_;
                            let _e1642 = phi_3476_;
                            phi_4221_ = _e1632;
                            phi_4103_ = _e1634;
                            phi_924_ = _e1636;
                            phi_927_ = _e1638;
                            phi_929_ = _e1640;
                            phi_931_ = _e1642;
                            phi_3477_ = _e523;
                        } else {
                            phi_4221_ = _e511;
                            phi_4103_ = _e509;
                            phi_924_ = type_55();
                            phi_927_ = u32();
                            phi_929_ = bool();
                            phi_931_ = u32();
                            phi_3477_ = false;
                        }
                        let _e1644 = phi_4221_;
                        let _e1646 = phi_4103_;
                        let _e1648 = phi_924_;
                        let _e1650 = phi_927_;
                        let _e1652 = phi_929_;
                        let _e1654 = phi_931_;
                        let _e1656 = phi_3477_;
                        continue;
                        continuing {
                            phi_3954_ = _e1646;
                            phi_3853_ = _e1644;
                            phi_923_ = _e1648;
                            phi_926_ = _e1650;
                            phi_928_ = _e1652;
                            phi_930_ = _e1654;
                            phi_4102_ = _e1646;
                            break if !(_e1656);
                        }
                    }
                    let _e1659 = phi_4102_;
                    if _e1659 {
                        break;
                    }
                    phi_3484_ = type_8(0u, 8u);
                    loop {
                        let _e1661 = phi_3484_;
                        if (_e1661.member < _e1661.member_1) {
                            phi_3485_ = type_8((_e1661.member + 1u), _e1661.member_1);
                            phi_3508_ = type_8(1u, _e1661.member);
                        } else {
                            phi_3485_ = _e1661;
                            phi_3508_ = type_8(0u, type_8().member_1);
                        }
                        let _e1674 = phi_3485_;
                        let _e1676 = phi_3508_;
                        let _e1680 = (bitcast<i32>(_e1676.member) != 0i);
                        if _e1680 {
                            let _e1681 = (_e1676.member_1 < 8u);
                            if _e1681 {
                            } else {
                                phi_4214_ = true;
                                break;
                            }
                            let _e1683 = local_9[_e1676.member_1];
                            if (_e1683.member_3 != 4294967295u) {
                                let _e1689 = -(_e435);
                                let _e1690 = (_e1689 / 3i);
                                let _e1697 = bitcast<f32>((bitcast<u32>((_e1690 + 127i)) << bitcast<u32>(23i)));
                                let _e1705 = (((_e1683.member * _e1697) * _e1697) * bitcast<f32>((bitcast<u32>(((_e1689 - (2i * _e1690)) + 127i)) << bitcast<u32>(23i))));
                                let _e1707 = select(340282350000000000000000000000000000000f, _e1705, (_e1705 < 340282350000000000000000000000000000000f));
                                phi_3574_ = type_24(select(-340282350000000000000000000000000000000f, _e1707, (_e1707 > -340282350000000000000000000000000000000f)), _e1683.member_1, _e1683.member_2, _e1683.member_3);
                            } else {
                                phi_3574_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1712 = phi_3574_;
                            if _e1681 {
                            } else {
                                phi_4214_ = true;
                                break;
                            }
                            local_9[_e1676.member_1] = type_24(_e1712.member, _e1712.member_1, _e1712.member_2, _e1712.member_3);
                        }
                        continue;
                        continuing {
                            phi_3484_ = _e1674;
                            phi_4214_ = _e1659;
                            break if !(_e1680);
                        }
                    }
                    let _e1720 = phi_4214_;
                    if _e1720 {
                        break;
                    }
                    let _e1721 = local_9;
                    if _e156 {
                    } else {
                        break;
                    }
                    global_6.member[_e154] = array<type_24, 8>(type_24(_e1721[0].member, _e1721[0].member_1, _e1721[0].member_2, _e1721[0].member_3), type_24(_e1721[1].member, _e1721[1].member_1, _e1721[1].member_2, _e1721[1].member_3), type_24(_e1721[2].member, _e1721[2].member_1, _e1721[2].member_2, _e1721[2].member_3), type_24(_e1721[3].member, _e1721[3].member_1, _e1721[3].member_2, _e1721[3].member_3), type_24(_e1721[4].member, _e1721[4].member_1, _e1721[4].member_2, _e1721[4].member_3), type_24(_e1721[5].member, _e1721[5].member_1, _e1721[5].member_2, _e1721[5].member_3), type_24(_e1721[6].member, _e1721[6].member_1, _e1721[6].member_2, _e1721[6].member_3), type_24(_e1721[7].member, _e1721[7].member_1, _e1721[7].member_2, _e1721[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
