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
    var phi_410_: i32;
    var phi_411_: i32;
    var phi_421_: bool;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_434_: bool;
    var phi_439_: u32;
    var phi_452_: i32;
    var phi_472_: i32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_507_: f32;
    var phi_513_: f32;
    var phi_536_: f32;
    var phi_547_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_602_: f32;
    var phi_613_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_668_: f32;
    var phi_679_: f32;
    var phi_779_: f32;
    var phi_780_: f32;
    var phi_3796_: bool;
    var phi_3710_: f32;
    var phi_922_: type_55;
    var phi_925_: u32;
    var phi_927_: bool;
    var phi_929_: u32;
    var phi_940_: bool;
    var phi_1027_: type_55;
    var phi_1028_: bool;
    var phi_1029_: u32;
    var phi_2579_: u32;
    var phi_2585_: u32;
    var phi_2839_: u32;
    var phi_2840_: u32;
    var phi_2850_: u32;
    var phi_2852_: u32;
    var phi_2853_: bool;
    var phi_2873_: u32;
    var phi_2874_: u32;
    var phi_2878_: type_56;
    var phi_3223_: type_55;
    var phi_3300_: type_55;
    var phi_3301_: type_55;
    var phi_3302_: u32;
    var phi_3304_: type_55;
    var phi_3305_: u32;
    var phi_3306_: bool;
    var phi_3315_: type_55;
    var phi_3320_: type_55;
    var phi_3321_: bool;
    var phi_3868_: f32;
    var phi_3793_: bool;
    var phi_1048_: type_8;
    var phi_1049_: type_8;
    var phi_1072_: type_8;
    var phi_1113_: u32;
    var phi_1119_: u32;
    var phi_1129_: u32;
    var phi_1145_: u32;
    var phi_1182_: u32;
    var phi_1188_: u32;
    var phi_1198_: u32;
    var phi_3778_: bool;
    var phi_1214_: type_8;
    var phi_1215_: type_8;
    var phi_1238_: type_8;
    var phi_1261_: u32;
    var phi_1276_: u32;
    var phi_1279_: type_8;
    var phi_1280_: type_8;
    var phi_1303_: type_8;
    var phi_1369_: u32;
    var phi_1349_: u32;
    var phi_1350_: u32;
    var phi_1373_: f32;
    var phi_3771_: bool;
    var phi_3850_: bool;
    var phi_3849_: bool;
    var phi_1874_: vec3<f32>;
    var phi_1875_: vec3<f32>;
    var phi_1906_: bool;
    var phi_1915_: vec3<f32>;
    var phi_1955_: type_24;
    var phi_1957_: type_24;
    var phi_1958_: bool;
    var phi_1962_: type_24;
    var phi_1963_: type_24;
    var phi_1964_: type_24;
    var phi_1965_: bool;
    var phi_1969_: type_24;
    var phi_1970_: bool;
    var phi_1974_: type_24;
    var phi_1975_: bool;
    var phi_1979_: type_24;
    var phi_1991_: type_8;
    var phi_1994_: type_24;
    var phi_1992_: type_8;
    var phi_2017_: type_8;
    var phi_2049_: bool;
    var phi_2050_: bool;
    var phi_2071_: type_24;
    var phi_1995_: type_24;
    var phi_3880_: bool;
    var phi_4149_: f32;
    var phi_4148_: f32;
    var phi_3942_: bool;
    var phi_4147_: f32;
    var phi_3941_: bool;
    var phi_4146_: f32;
    var phi_3940_: bool;
    var phi_4086_: f32;
    var phi_3939_: bool;
    var phi_4051_: f32;
    var phi_3948_: bool;
    var phi_3323_: type_55;
    var phi_3324_: bool;
    var phi_3325_: u32;
    var phi_4050_: f32;
    var phi_3947_: bool;
    var phi_3326_: type_55;
    var phi_3327_: u32;
    var phi_3328_: bool;
    var phi_3329_: u32;
    var phi_4049_: f32;
    var phi_3946_: bool;
    var phi_3330_: type_55;
    var phi_3331_: u32;
    var phi_3332_: bool;
    var phi_3333_: u32;
    var phi_4048_: f32;
    var phi_3945_: bool;
    var phi_923_: type_55;
    var phi_926_: u32;
    var phi_928_: bool;
    var phi_930_: u32;
    var phi_3334_: bool;
    var phi_3944_: bool;
    var phi_3341_: type_8;
    var phi_3342_: type_8;
    var phi_3365_: type_8;
    var phi_3431_: type_24;
    var phi_4041_: bool;

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
                            phi_410_ = (bitcast<i32>((_e233 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e233)), 32u, (_e233 == 0u))));
                        }
                        let _e247 = phi_410_;
                        phi_411_ = _e247;
                    } else {
                        phi_411_ = 0i;
                    }
                    let _e249 = phi_411_;
                    let _e250 = (_e166 == _e205);
                    if _e250 {
                        phi_421_ = true;
                    } else {
                        phi_421_ = (_e173 == _e205);
                    }
                    let _e253 = phi_421_;
                    let _e254 = select(1u, 0u, _e250);
                    if _e253 {
                        let _e255 = (_e254 + 1u);
                        phi_431_ = _e255;
                        phi_432_ = _e255;
                        phi_434_ = select(true, false, (_e255 == 2u));
                    } else {
                        phi_431_ = u32();
                        phi_432_ = 0u;
                        phi_434_ = true;
                    }
                    let _e259 = phi_431_;
                    let _e261 = phi_432_;
                    let _e263 = phi_434_;
                    if _e263 {
                        phi_439_ = (_e261 + 1u);
                    } else {
                        phi_439_ = 0u;
                    }
                    let _e267 = phi_439_;
                    let _e268 = select(_e259, _e261, _e263);
                    let _e269 = select(_e254, select(2u, _e254, _e253), _e263);
                    if (_e136 < -126i) {
                        phi_452_ = -126i;
                    } else {
                        phi_452_ = select(_e136, 127i, (_e136 > 127i));
                    }
                    let _e274 = phi_452_;
                    let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                    let _e285 = bitcast<f32>((bitcast<u32>(((_e136 - _e274) + 127i)) << bitcast<u32>(23i)));
                    let _e286 = -(_e249);
                    if (_e286 < -126i) {
                        phi_472_ = -126i;
                    } else {
                        phi_472_ = select(_e286, 127i, (_e286 > 127i));
                    }
                    let _e291 = phi_472_;
                    let _e296 = bitcast<f32>((bitcast<u32>((_e291 + 127i)) << bitcast<u32>(23i)));
                    let _e302 = bitcast<f32>((bitcast<u32>(((_e286 - _e291) + 127i)) << bitcast<u32>(23i)));
                    let _e306 = global_4.member[_e154].member;
                    let _e307 = (_e268 == 0u);
                    if _e307 {
                        phi_490_ = _e306[0];
                    } else {
                        phi_490_ = _e306[1];
                    }
                    let _e311 = phi_490_;
                    let _e312 = (_e268 == 2u);
                    if _e312 {
                        phi_496_ = _e306[2];
                    } else {
                        phi_496_ = _e311;
                    }
                    let _e315 = phi_496_;
                    let _e317 = ((_e315 * _e279) * _e285);
                    let _e318 = global_4.member[_e154].member_2;
                    if _e307 {
                        phi_507_ = _e318[0];
                    } else {
                        phi_507_ = _e318[1];
                    }
                    let _e322 = phi_507_;
                    if _e312 {
                        phi_513_ = _e318[2];
                    } else {
                        phi_513_ = _e322;
                    }
                    let _e325 = phi_513_;
                    let _e327 = ((_e325 * _e296) * _e302);
                    let _e331 = (bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e331 {
                        let _e335 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) * 0.00000011920929f);
                        phi_536_ = select(0.00000000000011368684f, _e335, (_e335 > 0.00000000000011368684f));
                    } else {
                        phi_536_ = 0f;
                    }
                    let _e339 = phi_536_;
                    let _e340 = (_e317 + _e339);
                    let _e341 = (_e317 - _e339);
                    let _e342 = select(_e327, 0f, _e331);
                    if _e331 {
                        phi_547_ = 38685626000000000000000000f;
                    } else {
                        phi_547_ = (1f / _e327);
                    }
                    let _e345 = phi_547_;
                    let _e346 = (_e267 == 0u);
                    if _e346 {
                        phi_556_ = _e306[0];
                    } else {
                        phi_556_ = _e306[1];
                    }
                    let _e350 = phi_556_;
                    let _e351 = (_e267 == 2u);
                    if _e351 {
                        phi_562_ = _e306[2];
                    } else {
                        phi_562_ = _e350;
                    }
                    let _e354 = phi_562_;
                    let _e356 = ((_e354 * _e279) * _e285);
                    if _e346 {
                        phi_573_ = _e318[0];
                    } else {
                        phi_573_ = _e318[1];
                    }
                    let _e360 = phi_573_;
                    if _e351 {
                        phi_579_ = _e318[2];
                    } else {
                        phi_579_ = _e360;
                    }
                    let _e363 = phi_579_;
                    let _e365 = ((_e363 * _e296) * _e302);
                    let _e369 = (bitcast<f32>((bitcast<u32>(_e365) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e369 {
                        let _e373 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) * 0.00000011920929f);
                        phi_602_ = select(0.00000000000011368684f, _e373, (_e373 > 0.00000000000011368684f));
                    } else {
                        phi_602_ = 0f;
                    }
                    let _e377 = phi_602_;
                    let _e378 = (_e356 + _e377);
                    let _e379 = (_e356 - _e377);
                    let _e380 = select(_e365, 0f, _e369);
                    if _e369 {
                        phi_613_ = 38685626000000000000000000f;
                    } else {
                        phi_613_ = (1f / _e365);
                    }
                    let _e383 = phi_613_;
                    let _e384 = (_e269 == 0u);
                    if _e384 {
                        phi_622_ = _e306[0];
                    } else {
                        phi_622_ = _e306[1];
                    }
                    let _e388 = phi_622_;
                    let _e389 = (_e269 == 2u);
                    if _e389 {
                        phi_628_ = _e306[2];
                    } else {
                        phi_628_ = _e388;
                    }
                    let _e392 = phi_628_;
                    let _e394 = ((_e392 * _e279) * _e285);
                    if _e384 {
                        phi_639_ = _e318[0];
                    } else {
                        phi_639_ = _e318[1];
                    }
                    let _e398 = phi_639_;
                    if _e389 {
                        phi_645_ = _e318[2];
                    } else {
                        phi_645_ = _e398;
                    }
                    let _e401 = phi_645_;
                    let _e403 = ((_e401 * _e296) * _e302);
                    let _e407 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e407 {
                        let _e411 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) * 0.00000011920929f);
                        phi_668_ = select(0.00000000000011368684f, _e411, (_e411 > 0.00000000000011368684f));
                    } else {
                        phi_668_ = 0f;
                    }
                    let _e415 = phi_668_;
                    let _e416 = (_e394 + _e415);
                    let _e417 = (_e394 - _e415);
                    let _e418 = select(_e403, 0f, _e407);
                    if _e407 {
                        phi_679_ = 38685626000000000000000000f;
                    } else {
                        phi_679_ = (1f / _e403);
                    }
                    let _e421 = phi_679_;
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
                        phi_779_ = select(-340282350000000000000000000000000000000f, _e462, (_e462 > -340282350000000000000000000000000000000f));
                        phi_780_ = select(-340282350000000000000000000000000000000f, _e455, (_e455 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_779_ = 0f;
                        phi_780_ = 1f;
                    }
                    let _e466 = phi_779_;
                    let _e468 = phi_780_;
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
                    phi_3796_ = false;
                    phi_3710_ = _e466;
                    phi_922_ = type_55(type_28(vec4<f32>((f32(_e474) * _e148), (f32(_e480) * _e148), (f32(_e486) * _e148), 0f), vec4<f32>((f32(_e491) * _e148), (f32(_e495) * _e148), (f32(_e499) * _e148), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                    phi_925_ = ((3u * _e97) + 1u);
                    phi_927_ = (_e468 <= _e466);
                    phi_929_ = 0u;
                    loop {
                        let _e509 = phi_3796_;
                        let _e511 = phi_3710_;
                        let _e513 = phi_922_;
                        let _e515 = phi_925_;
                        let _e517 = phi_927_;
                        let _e519 = phi_929_;
                        if _e517 {
                            phi_940_ = true;
                        } else {
                            phi_940_ = (_e519 > 0u);
                        }
                        let _e522 = phi_940_;
                        if _e522 {
                            let _e523 = (_e515 > 0u);
                            if _e523 {
                                if _e517 {
                                    phi_1027_ = _e513;
                                    phi_1028_ = _e517;
                                    phi_1029_ = _e519;
                                } else {
                                    let _e524 = (_e519 - 1u);
                                    let _e525 = (_e524 % 128u);
                                    let _e526 = (_e525 < 128u);
                                    if _e526 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e528 = local_7[_e525];
                                    if _e526 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e530 = local_6[_e525];
                                    if _e526 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e532 = local_5[_e525];
                                    if _e526 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e534 = local_4[_e525];
                                    if _e526 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e536 = local_3[_e525];
                                    if _e526 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e538 = local_2[_e525];
                                    if _e526 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e543 = local_8[_e525];
                                    if _e526 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e546 = local_10[_e525];
                                    phi_1027_ = type_55(type_28(vec4<f32>(_e528, _e530, _e532, 0f), vec4<f32>(_e534, _e536, _e538, 0f)), _e543);
                                    phi_1028_ = (_e546 <= _e511);
                                    phi_1029_ = _e524;
                                }
                                let _e549 = phi_1027_;
                                let _e551 = phi_1028_;
                                let _e553 = phi_1029_;
                                if _e551 {
                                    let _e558 = (_e549.member_1 & 268435455u);
                                    if ((_e549.member_1 & 2147483648u) != 0u) {
                                        phi_3868_ = _e511;
                                        phi_3793_ = _e509;
                                        phi_1048_ = type_8(0u, ((_e549.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1017 = phi_3868_;
                                            let _e1019 = phi_3793_;
                                            let _e1021 = phi_1048_;
                                            if (_e1021.member < _e1021.member_1) {
                                                phi_1049_ = type_8((_e1021.member + 1u), _e1021.member_1);
                                                phi_1072_ = type_8(1u, _e1021.member);
                                            } else {
                                                phi_1049_ = _e1021;
                                                phi_1072_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1034 = phi_1049_;
                                            let _e1036 = phi_1072_;
                                            let _e1040 = (bitcast<i32>(_e1036.member) != 0i);
                                            if _e1040 {
                                                let _e1045 = (_e549.member.member_1.x - _e549.member.member.x);
                                                let _e1048 = (_e549.member.member_1.y - _e549.member.member.y);
                                                let _e1051 = (_e549.member.member_1.z - _e549.member.member.z);
                                                let _e1053 = select(_e1048, _e1045, (_e1045 > _e1048));
                                                let _e1055 = select(_e1051, _e1053, (_e1053 > _e1051));
                                                let _e1057 = (_e1055 < (1024f * _e148));
                                                if _e1057 {
                                                    phi_1113_ = 0u;
                                                } else {
                                                    phi_1113_ = select(2u, 1u, (_e1055 < (2097152f * _e148)));
                                                }
                                                let _e1062 = phi_1113_;
                                                switch bitcast<i32>(_e1062) {
                                                    case 0: {
                                                        phi_1119_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1119_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1119_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1119_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1065 = phi_1119_;
                                                switch bitcast<i32>(_e1062) {
                                                    case 0: {
                                                        phi_1129_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1129_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1129_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1129_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1072 = phi_1129_;
                                                let _e1074 = ((_e558 + (_e1036.member_1 * ((3u * _e1065) + 1u))) + (3u * _e1072));
                                                let _e1075 = (_e1074 < _e100);
                                                if _e1075 {
                                                    if _e1075 {
                                                    } else {
                                                        phi_4086_ = _e1017;
                                                        phi_3939_ = true;
                                                        break;
                                                    }
                                                    let _e1077 = global_5.member[_e1074];
                                                    phi_1145_ = _e1077;
                                                } else {
                                                    phi_1145_ = 4294967295u;
                                                }
                                                let _e1079 = phi_1145_;
                                                local_11 = array<u32, 3>(_e268, _e267, _e269);
                                                if _e1057 {
                                                    phi_1182_ = 0u;
                                                } else {
                                                    phi_1182_ = select(2u, 1u, (_e1055 < (2097152f * _e148)));
                                                }
                                                let _e1085 = phi_1182_;
                                                switch bitcast<i32>(_e1085) {
                                                    case 0: {
                                                        phi_1188_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1188_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1188_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1188_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1088 = phi_1188_;
                                                switch bitcast<i32>(_e1085) {
                                                    case 0: {
                                                        phi_1198_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1198_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1198_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1198_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1095 = phi_1198_;
                                                local_13 = array<f32, 4>(_e549.member.member.x, _e549.member.member.y, _e549.member.member.z, _e549.member.member.w);
                                                local_12[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_12[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_12[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3778_ = _e1019;
                                                phi_1214_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1109 = phi_3778_;
                                                    let _e1111 = phi_1214_;
                                                    if (_e1111.member < _e1111.member_1) {
                                                        phi_1215_ = type_8((_e1111.member + 1u), _e1111.member_1);
                                                        phi_1238_ = type_8(1u, _e1111.member);
                                                    } else {
                                                        phi_1215_ = _e1111;
                                                        phi_1238_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1124 = phi_1215_;
                                                    let _e1126 = phi_1238_;
                                                    let _e1130 = (bitcast<i32>(_e1126.member) != 0i);
                                                    if _e1130 {
                                                        let _e1132 = ((_e558 + (_e1036.member_1 * ((3u * _e1088) + 1u))) + (_e1126.member_1 * _e1095));
                                                        let _e1133 = (_e1132 < _e100);
                                                        if _e1133 {
                                                            if _e1133 {
                                                            } else {
                                                                phi_3849_ = true;
                                                                break;
                                                            }
                                                            let _e1135 = global_5.member[_e1132];
                                                            phi_1261_ = _e1135;
                                                        } else {
                                                            phi_1261_ = 0u;
                                                        }
                                                        let _e1137 = phi_1261_;
                                                        let _e1138 = (_e1132 + 1u);
                                                        let _e1139 = (_e1138 < _e100);
                                                        if _e1139 {
                                                            if _e1139 {
                                                            } else {
                                                                phi_3849_ = true;
                                                                break;
                                                            }
                                                            let _e1141 = global_5.member[_e1138];
                                                            phi_1276_ = _e1141;
                                                        } else {
                                                            phi_1276_ = 0u;
                                                        }
                                                        let _e1143 = phi_1276_;
                                                        phi_1279_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1145 = phi_1279_;
                                                            if (_e1145.member < _e1145.member_1) {
                                                                phi_1280_ = type_8((_e1145.member + 1u), _e1145.member_1);
                                                                phi_1303_ = type_8(1u, _e1145.member);
                                                            } else {
                                                                phi_1280_ = _e1145;
                                                                phi_1303_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1158 = phi_1280_;
                                                            let _e1160 = phi_1303_;
                                                            let _e1164 = (bitcast<i32>(_e1160.member) != 0i);
                                                            if _e1164 {
                                                                let _e1165 = (_e1160.member_1 < 3u);
                                                                if _e1165 {
                                                                } else {
                                                                    phi_3771_ = true;
                                                                    break;
                                                                }
                                                                let _e1167 = local_11[_e1160.member_1];
                                                                if (_e1160.member_1 < 4u) {
                                                                } else {
                                                                    phi_3771_ = true;
                                                                    break;
                                                                }
                                                                let _e1170 = local_13[_e1160.member_1];
                                                                switch bitcast<i32>(_e1085) {
                                                                    case 0: {
                                                                        phi_1373_ = (_e1170 + (f32(((_e1137 >> bitcast<u32>(((10u * _e1167) & 31u))) & 1023u)) * _e148));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1167 == 0u) {
                                                                            phi_1350_ = _e1137;
                                                                        } else {
                                                                            if (_e1167 == 1u) {
                                                                                phi_1349_ = ((_e1137 >> bitcast<u32>(21i)) | (_e1143 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1349_ = (_e1143 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1191 = phi_1349_;
                                                                            phi_1350_ = _e1191;
                                                                        }
                                                                        let _e1193 = phi_1350_;
                                                                        phi_1373_ = (_e1170 + (f32((_e1193 & 2097151u)) * _e148));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1172 = (_e1132 + _e1167);
                                                                        let _e1173 = (_e1172 < _e100);
                                                                        if _e1173 {
                                                                            if _e1173 {
                                                                            } else {
                                                                                phi_3771_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1175 = global_5.member[_e1172];
                                                                            phi_1369_ = _e1175;
                                                                        } else {
                                                                            phi_1369_ = 0u;
                                                                        }
                                                                        let _e1177 = phi_1369_;
                                                                        phi_1373_ = (f32(bitcast<i32>(_e1177)) * _e148);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1373_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1207 = phi_1373_;
                                                                if (_e1126.member_1 < 3u) {
                                                                } else {
                                                                    phi_3771_ = true;
                                                                    break;
                                                                }
                                                                if _e1165 {
                                                                } else {
                                                                    phi_3771_ = true;
                                                                    break;
                                                                }
                                                                local_12[_e1126.member_1][_e1160.member_1] = _e1207;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1279_ = _e1158;
                                                                phi_3771_ = _e1109;
                                                                break if !(_e1164);
                                                            }
                                                        }
                                                        let _e1213 = phi_3771_;
                                                        phi_3849_ = _e1213;
                                                        if _e1213 {
                                                            break;
                                                        }
                                                        phi_3850_ = _e1213;
                                                    } else {
                                                        phi_3850_ = _e1109;
                                                    }
                                                    let _e1215 = phi_3850_;
                                                    continue;
                                                    continuing {
                                                        phi_3778_ = _e1215;
                                                        phi_1214_ = _e1124;
                                                        phi_3849_ = _e1215;
                                                        break if !(_e1130);
                                                    }
                                                }
                                                let _e1218 = phi_3849_;
                                                phi_4086_ = _e1017;
                                                phi_3939_ = _e1218;
                                                if _e1218 {
                                                    break;
                                                }
                                                let _e1219 = local_12;
                                                let _e1234 = (_e1219[0][2] - _e394);
                                                let _e1237 = (((_e1219[0][0] - _e317) * _e418) - (_e1234 * _e342));
                                                let _e1240 = (((_e1219[0][1] - _e356) * _e418) - (_e1234 * _e380));
                                                let _e1243 = (_e1219[1][2] - _e394);
                                                let _e1246 = (((_e1219[1][0] - _e317) * _e418) - (_e1243 * _e342));
                                                let _e1249 = (((_e1219[1][1] - _e356) * _e418) - (_e1243 * _e380));
                                                let _e1252 = (_e1219[2][2] - _e394);
                                                let _e1255 = (((_e1219[2][0] - _e317) * _e418) - (_e1252 * _e342));
                                                let _e1258 = (((_e1219[2][1] - _e356) * _e418) - (_e1252 * _e380));
                                                let _e1259 = (_e1255 * _e1249);
                                                let _e1260 = (_e1258 * _e1246);
                                                let _e1261 = (_e1237 * _e1258);
                                                let _e1262 = (_e1240 * _e1255);
                                                let _e1263 = (_e1246 * _e1240);
                                                let _e1264 = (_e1249 * _e1237);
                                                let _e1269 = (((_e1259 >= _e1260) && (_e1261 >= _e1262)) && (_e1263 >= _e1264));
                                                if (_e1269 || (((_e1259 <= _e1260) && (_e1261 <= _e1262)) && (_e1263 <= _e1264))) {
                                                    let _e1276 = select(-1f, 1f, _e1269);
                                                    let _e1278 = ((_e1259 - _e1260) * _e1276);
                                                    let _e1280 = select(0f, _e1278, (_e1278 > 0f));
                                                    let _e1282 = ((_e1261 - _e1262) * _e1276);
                                                    let _e1284 = select(0f, _e1282, (_e1282 > 0f));
                                                    let _e1286 = ((_e1263 - _e1264) * _e1276);
                                                    let _e1288 = select(0f, _e1286, (_e1286 > 0f));
                                                    let _e1290 = ((_e1280 + _e1284) + _e1288);
                                                    if (_e1290 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1969_ = type_24();
                                                        phi_1970_ = true;
                                                    } else {
                                                        let _e1293 = select(_e1219[1][0], _e1219[0][0], (_e1219[0][0] < _e1219[1][0]));
                                                        let _e1297 = select(_e1219[1][0], _e1219[0][0], (_e1219[0][0] > _e1219[1][0]));
                                                        let _e1301 = select(_e1219[1][1], _e1219[0][1], (_e1219[0][1] < _e1219[1][1]));
                                                        let _e1305 = select(_e1219[1][1], _e1219[0][1], (_e1219[0][1] > _e1219[1][1]));
                                                        let _e1309 = select(_e1219[1][2], _e1219[0][2], (_e1219[0][2] < _e1219[1][2]));
                                                        let _e1313 = select(_e1219[1][2], _e1219[0][2], (_e1219[0][2] > _e1219[1][2]));
                                                        let _e1318 = ((select(_e1219[2][0], _e1293, (_e1293 < _e1219[2][0])) - _e340) * _e345);
                                                        let _e1319 = ((select(_e1219[2][0], _e1297, (_e1297 > _e1219[2][0])) - _e341) * _e345);
                                                        let _e1322 = ((select(_e1219[2][1], _e1301, (_e1301 < _e1219[2][1])) - _e378) * _e383);
                                                        let _e1323 = ((select(_e1219[2][1], _e1305, (_e1305 > _e1219[2][1])) - _e379) * _e383);
                                                        let _e1326 = ((select(_e1219[2][2], _e1309, (_e1309 < _e1219[2][2])) - _e416) * _e421);
                                                        let _e1327 = ((select(_e1219[2][2], _e1313, (_e1313 > _e1219[2][2])) - _e417) * _e421);
                                                        let _e1329 = select(_e1327, _e1326, (_e1326 < _e1327));
                                                        let _e1331 = select(_e1327, _e1326, (_e1326 > _e1327));
                                                        let _e1333 = select(_e1319, _e1318, (_e1318 < _e1319));
                                                        let _e1335 = select(_e1323, _e1322, (_e1322 < _e1323));
                                                        let _e1337 = select(_e1335, _e1333, (_e1333 > _e1335));
                                                        let _e1339 = select(_e1329, _e1337, (_e1337 > _e1329));
                                                        let _e1341 = select(_e1319, _e1318, (_e1318 > _e1319));
                                                        let _e1343 = select(_e1323, _e1322, (_e1322 > _e1323));
                                                        let _e1345 = select(_e1343, _e1341, (_e1341 < _e1343));
                                                        let _e1347 = select(_e1331, _e1345, (_e1345 < _e1331));
                                                        let _e1348 = -(_e1329);
                                                        let _e1354 = select(_e468, _e1339, (_e1339 > _e468));
                                                        if (_e1354 > (_e1347 + (select(_e1348, _e1331, (_e1331 > _e1348)) * 0.0000019073523f))) {
                                                            phi_1964_ = type_24();
                                                            phi_1965_ = true;
                                                        } else {
                                                            let _e1356 = (_e1354 > _e1017);
                                                            if _e1356 {
                                                                phi_1963_ = type_24();
                                                            } else {
                                                                let _e1360 = (_e1219[1][0] - _e1219[0][0]);
                                                                let _e1361 = (_e1219[1][1] - _e1219[0][1]);
                                                                let _e1362 = (_e1219[1][2] - _e1219[0][2]);
                                                                let _e1363 = vec3<f32>(_e1360, _e1361, _e1362);
                                                                let _e1364 = (_e1219[2][0] - _e1219[1][0]);
                                                                let _e1365 = (_e1219[2][1] - _e1219[1][1]);
                                                                let _e1366 = (_e1219[2][2] - _e1219[1][2]);
                                                                let _e1367 = vec3<f32>(_e1364, _e1365, _e1366);
                                                                let _e1368 = (_e1219[0][0] - _e1219[2][0]);
                                                                let _e1369 = (_e1219[0][1] - _e1219[2][1]);
                                                                let _e1370 = (_e1219[0][2] - _e1219[2][2]);
                                                                let _e1371 = vec3<f32>(_e1368, _e1369, _e1370);
                                                                let _e1374 = bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u));
                                                                let _e1377 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
                                                                let _e1379 = select(_e1377, _e1374, (_e1374 > _e1377));
                                                                let _e1382 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                let _e1384 = select(_e1382, _e1379, (_e1379 > _e1382));
                                                                let _e1387 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                let _e1390 = bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u));
                                                                let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                let _e1395 = bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u));
                                                                let _e1397 = select(_e1395, _e1392, (_e1392 > _e1395));
                                                                let _e1400 = bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u));
                                                                let _e1403 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
                                                                let _e1405 = select(_e1403, _e1400, (_e1400 > _e1403));
                                                                let _e1408 = bitcast<f32>((bitcast<u32>(_e1370) & 2147483647u));
                                                                let _e1410 = select(_e1408, _e1405, (_e1405 > _e1408));
                                                                let _e1412 = select(_e1397, _e1384, (_e1384 > _e1397));
                                                                let _e1414 = select(_e1410, _e1412, (_e1412 > _e1410));
                                                                if (_e1384 == _e1414) {
                                                                    phi_1874_ = _e1367;
                                                                    phi_1875_ = _e1371;
                                                                } else {
                                                                    let _e1417 = vec3((_e1397 == _e1414));
                                                                    phi_1874_ = select(_e1363, _e1371, _e1417);
                                                                    phi_1875_ = select(_e1367, _e1363, _e1417);
                                                                }
                                                                let _e1421 = phi_1874_;
                                                                let _e1423 = phi_1875_;
                                                                let _e1430 = ((_e1421.y * _e1423.z) - (_e1423.y * _e1421.z));
                                                                let _e1435 = ((_e1421.z * _e1423.x) - (_e1423.z * _e1421.x));
                                                                let _e1438 = ((_e1421.x * _e1423.y) - (_e1423.x * _e1421.y));
                                                                if (_e1280 >= _e1284) {
                                                                    phi_1906_ = select(true, false, (_e1280 >= _e1288));
                                                                } else {
                                                                    phi_1906_ = true;
                                                                }
                                                                let _e1443 = phi_1906_;
                                                                if _e1443 {
                                                                    phi_1915_ = select(vec3<f32>(_e1219[2][0], _e1219[2][1], _e1219[2][2]), vec3<f32>(_e1219[1][0], _e1219[1][1], _e1219[1][2]), vec3((_e1284 >= _e1288)));
                                                                } else {
                                                                    phi_1915_ = vec3<f32>(_e1219[0][0], _e1219[0][1], _e1219[0][2]);
                                                                }
                                                                let _e1448 = phi_1915_;
                                                                let _e1465 = ((((_e1430 * (_e1448.x - _e317)) + (_e1435 * (_e1448.y - _e356))) + (_e1438 * (_e1448.z - _e394))) / (((_e1430 * _e342) + (_e1435 * _e380)) + (_e1438 * _e418)));
                                                                let _e1467 = select(_e1347, _e1465, (_e1465 < _e1347));
                                                                let _e1469 = select(_e1339, _e1467, (_e1467 > _e1339));
                                                                if (_e1469 >= _e468) {
                                                                    let _e1471 = (_e1469 <= _e1017);
                                                                    if _e1471 {
                                                                        let _e1472 = (1f / _e1290);
                                                                        phi_1955_ = type_24(_e1469, (_e1284 * _e1472), (_e1288 * _e1472), _e1079);
                                                                    } else {
                                                                        phi_1955_ = type_24();
                                                                    }
                                                                    let _e1477 = phi_1955_;
                                                                    phi_1957_ = _e1477;
                                                                    phi_1958_ = select(true, false, _e1471);
                                                                } else {
                                                                    phi_1957_ = type_24();
                                                                    phi_1958_ = true;
                                                                }
                                                                let _e1480 = phi_1957_;
                                                                let _e1482 = phi_1958_;
                                                                if _e1482 {
                                                                    phi_1962_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1962_ = _e1480;
                                                                }
                                                                let _e1484 = phi_1962_;
                                                                phi_1963_ = _e1484;
                                                            }
                                                            let _e1486 = phi_1963_;
                                                            phi_1964_ = _e1486;
                                                            phi_1965_ = _e1356;
                                                        }
                                                        let _e1488 = phi_1964_;
                                                        let _e1490 = phi_1965_;
                                                        phi_1969_ = _e1488;
                                                        phi_1970_ = _e1490;
                                                    }
                                                    let _e1492 = phi_1969_;
                                                    let _e1494 = phi_1970_;
                                                    phi_1974_ = _e1492;
                                                    phi_1975_ = _e1494;
                                                } else {
                                                    phi_1974_ = type_24();
                                                    phi_1975_ = true;
                                                }
                                                let _e1496 = phi_1974_;
                                                let _e1498 = phi_1975_;
                                                if _e1498 {
                                                    phi_1979_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1979_ = _e1496;
                                                }
                                                let _e1500 = phi_1979_;
                                                if (_e1500.member_3 != 4294967295u) {
                                                    if (_e1079 != 4294967295u) {
                                                        phi_1991_ = type_8(0u, 8u);
                                                        phi_1994_ = _e1500;
                                                        loop {
                                                            let _e1505 = phi_1991_;
                                                            let _e1507 = phi_1994_;
                                                            if (_e1505.member < _e1505.member_1) {
                                                                phi_1992_ = type_8((_e1505.member + 1u), _e1505.member_1);
                                                                phi_2017_ = type_8(1u, _e1505.member);
                                                            } else {
                                                                phi_1992_ = _e1505;
                                                                phi_2017_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1520 = phi_1992_;
                                                            let _e1522 = phi_2017_;
                                                            let _e1526 = (bitcast<i32>(_e1522.member) != 0i);
                                                            if _e1526 {
                                                                let _e1527 = (_e1522.member_1 < 8u);
                                                                if _e1527 {
                                                                } else {
                                                                    phi_3880_ = true;
                                                                    break;
                                                                }
                                                                let _e1532 = local_9[_e1522.member_1].member;
                                                                if (_e1507.member < _e1532) {
                                                                    phi_2050_ = true;
                                                                } else {
                                                                    let _e1534 = local_9[_e1522.member_1].member;
                                                                    if (_e1507.member == _e1534) {
                                                                        let _e1539 = local_9[_e1522.member_1].member_3;
                                                                        phi_2049_ = (_e1507.member_3 < _e1539);
                                                                    } else {
                                                                        phi_2049_ = false;
                                                                    }
                                                                    let _e1542 = phi_2049_;
                                                                    phi_2050_ = _e1542;
                                                                }
                                                                let _e1544 = phi_2050_;
                                                                if _e1544 {
                                                                    if _e1527 {
                                                                    } else {
                                                                        phi_3880_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1545 = local_9[_e1522.member_1];
                                                                    local_9[_e1522.member_1] = type_24(_e1507.member, _e1507.member_1, _e1507.member_2, _e1507.member_3);
                                                                    phi_2071_ = type_24(_e1545.member, _e1545.member_1, _e1545.member_2, _e1545.member_3);
                                                                } else {
                                                                    phi_2071_ = _e1507;
                                                                }
                                                                let _e1556 = phi_2071_;
                                                                phi_1995_ = _e1556;
                                                            } else {
                                                                phi_1995_ = type_24();
                                                            }
                                                            let _e1558 = phi_1995_;
                                                            continue;
                                                            continuing {
                                                                phi_1991_ = _e1520;
                                                                phi_1994_ = _e1558;
                                                                phi_3880_ = _e1218;
                                                                break if !(_e1526);
                                                            }
                                                        }
                                                        let _e1561 = phi_3880_;
                                                        phi_4086_ = _e1017;
                                                        phi_3939_ = _e1561;
                                                        if _e1561 {
                                                            break;
                                                        }
                                                        let _e1564 = local_9[7u].member_3;
                                                        if (_e1564 != 4294967295u) {
                                                            let _e1568 = local_9[7u].member;
                                                            phi_4149_ = _e1568;
                                                        } else {
                                                            phi_4149_ = _e1017;
                                                        }
                                                        let _e1570 = phi_4149_;
                                                        phi_4148_ = _e1570;
                                                        phi_3942_ = _e1561;
                                                    } else {
                                                        phi_4148_ = _e1017;
                                                        phi_3942_ = _e1218;
                                                    }
                                                    let _e1572 = phi_4148_;
                                                    let _e1574 = phi_3942_;
                                                    phi_4147_ = _e1572;
                                                    phi_3941_ = _e1574;
                                                } else {
                                                    phi_4147_ = _e1017;
                                                    phi_3941_ = _e1218;
                                                }
                                                let _e1576 = phi_4147_;
                                                let _e1578 = phi_3941_;
                                                phi_4146_ = _e1576;
                                                phi_3940_ = _e1578;
                                            } else {
                                                phi_4146_ = _e1017;
                                                phi_3940_ = _e1019;
                                            }
                                            let _e1580 = phi_4146_;
                                            let _e1582 = phi_3940_;
                                            continue;
                                            continuing {
                                                phi_3868_ = _e1580;
                                                phi_3793_ = _e1582;
                                                phi_1048_ = _e1034;
                                                phi_4086_ = _e1580;
                                                phi_3939_ = _e1582;
                                                break if !(_e1040);
                                            }
                                        }
                                        let _e1585 = phi_4086_;
                                        let _e1587 = phi_3939_;
                                        phi_3944_ = _e1587;
                                        if _e1587 {
                                            break;
                                        }
                                        phi_4051_ = _e1585;
                                        phi_3948_ = _e1587;
                                        phi_3323_ = _e549;
                                        phi_3324_ = false;
                                        phi_3325_ = _e553;
                                    } else {
                                        if (_e549.member_1 >= _e97) {
                                            phi_2878_ = type_56(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_55(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_55(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e549.member_1 < _e97) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e566 = ((1u + _e268) % 4u);
                                            if (_e566 < 4u) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e571 = global_3.member[_e549.member_1][_e566];
                                            let _e573 = (_e571 >> bitcast<u32>(11u));
                                            let _e575 = ((1u + _e267) % 4u);
                                            if (_e575 < 4u) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e580 = global_3.member[_e549.member_1][_e575];
                                            let _e582 = (_e580 >> bitcast<u32>(11u));
                                            let _e584 = ((1u + _e269) % 4u);
                                            if (_e584 < 4u) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e589 = global_3.member[_e549.member_1][_e584];
                                            let _e591 = (_e589 >> bitcast<u32>(11u));
                                            let _e614 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.x - _e549.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e615 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.y - _e549.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e616 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.z - _e549.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e618 = select(_e148, _e614, (_e614 > _e148));
                                            let _e620 = select(_e148, _e615, (_e615 > _e148));
                                            let _e622 = select(_e148, _e616, (_e616 > _e148));
                                            let _e647 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e618));
                                            let _e652 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e655 = bitcast<f32>((_e647 & bitcast<u32>(_e652)));
                                            let _e656 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e620));
                                            let _e661 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e664 = bitcast<f32>((_e656 & bitcast<u32>(_e661)));
                                            let _e665 = bitcast<u32>((f32(bitcast<i32>((_e589 & 1023u))) * _e622));
                                            let _e670 = (bitcast<i32>((_e589 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e673 = bitcast<f32>((_e665 & bitcast<u32>(_e670)));
                                            let _e677 = bitcast<f32>((_e647 & bitcast<u32>(~(_e652))));
                                            let _e681 = bitcast<f32>((_e656 & bitcast<u32>(~(_e661))));
                                            let _e685 = bitcast<f32>((_e665 & bitcast<u32>(~(_e670))));
                                            let _e686 = bitcast<u32>((f32(bitcast<i32>((_e573 & 1023u))) * _e618));
                                            let _e691 = (bitcast<i32>((_e573 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e694 = bitcast<f32>((_e686 & bitcast<u32>(_e691)));
                                            let _e695 = bitcast<u32>((f32(bitcast<i32>((_e582 & 1023u))) * _e620));
                                            let _e700 = (bitcast<i32>((_e582 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e703 = bitcast<f32>((_e695 & bitcast<u32>(_e700)));
                                            let _e704 = bitcast<u32>((f32(bitcast<i32>((_e591 & 1023u))) * _e622));
                                            let _e709 = (bitcast<i32>((_e591 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e712 = bitcast<f32>((_e704 & bitcast<u32>(_e709)));
                                            let _e716 = bitcast<f32>((_e686 & bitcast<u32>(~(_e691))));
                                            let _e720 = bitcast<f32>((_e695 & bitcast<u32>(~(_e700))));
                                            let _e724 = bitcast<f32>((_e704 & bitcast<u32>(~(_e709))));
                                            let _e725 = (_e549.member.member.x + _e655);
                                            let _e726 = (_e549.member.member.y + _e664);
                                            let _e727 = (_e549.member.member.z + _e673);
                                            let _e730 = (_e549.member.member_1.x - _e694);
                                            let _e731 = (_e549.member.member_1.y - _e703);
                                            let _e732 = (_e549.member.member_1.z - _e712);
                                            let _e751 = (_e730 - _e725);
                                            let _e752 = (_e731 - _e726);
                                            let _e753 = (_e732 - _e727);
                                            let _e755 = select(_e752, _e751, (_e751 > _e752));
                                            let _e757 = select(_e753, _e755, (_e755 > _e753));
                                            if (_e757 < (1024f * _e148)) {
                                                phi_2579_ = 0u;
                                            } else {
                                                phi_2579_ = select(2u, 1u, (_e757 < (2097152f * _e148)));
                                            }
                                            let _e764 = phi_2579_;
                                            switch bitcast<i32>(_e764) {
                                                case 0: {
                                                    phi_2585_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2585_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2585_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2585_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e767 = phi_2585_;
                                            let _e773 = global_3.member[_e549.member_1][0u];
                                            let _e777 = global_3.member[_e549.member_1][1u];
                                            let _e781 = global_3.member[_e549.member_1][2u];
                                            let _e785 = global_3.member[_e549.member_1][3u];
                                            let _e797 = (((_e777 >> bitcast<u32>(22i)) | ((_e781 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e785 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e798 = (_e773 & 268435455u);
                                            let _e799 = (_e797 & 268435455u);
                                            let _e802 = ((_e773 >> bitcast<u32>(28u)) & 7u);
                                            let _e810 = ((_e773 >> bitcast<u32>(31i)) | (((_e797 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e811 = (_e802 != 0u);
                                            if (_e802 == 0u) {
                                                phi_2840_ = _e798;
                                            } else {
                                                if (_e802 == 7u) {
                                                    phi_2839_ = 2147483648u;
                                                } else {
                                                    phi_2839_ = ((2147483648u | (_e802 << bitcast<u32>(28u))) | (_e799 & 268435455u));
                                                }
                                                let _e820 = phi_2839_;
                                                phi_2840_ = _e820;
                                            }
                                            let _e822 = phi_2840_;
                                            if _e811 {
                                                let _e823 = (_e802 != 7u);
                                                if _e823 {
                                                    phi_2850_ = (_e799 + (_e802 * ((3u * _e767) + 1u)));
                                                } else {
                                                    phi_2850_ = u32();
                                                }
                                                let _e827 = phi_2850_;
                                                phi_2852_ = _e827;
                                                phi_2853_ = select(true, false, _e823);
                                            } else {
                                                phi_2852_ = u32();
                                                phi_2853_ = true;
                                            }
                                            let _e830 = phi_2852_;
                                            let _e832 = phi_2853_;
                                            if (_e810 == 0u) {
                                                phi_2874_ = (_e798 + select(0u, 1u, !(_e811)));
                                            } else {
                                                if (_e810 == 7u) {
                                                    phi_2873_ = 2147483648u;
                                                } else {
                                                    phi_2873_ = ((2147483648u | (_e810 << bitcast<u32>(28u))) | (select(_e830, _e799, _e832) & 268435455u));
                                                }
                                                let _e845 = phi_2873_;
                                                phi_2874_ = _e845;
                                            }
                                            let _e847 = phi_2874_;
                                            phi_2878_ = type_56(array<vec4<f32>, 3>(vec4<f32>(_e725, (_e549.member.member.x + _e677), _e730, (_e549.member.member_1.x - _e716)), vec4<f32>(_e726, (_e549.member.member.y + _e681), _e731, (_e549.member.member_1.y - _e720)), vec4<f32>(_e727, (_e549.member.member.z + _e685), _e732, (_e549.member.member_1.z - _e724))), type_55(type_28((_e549.member.member + vec4<f32>(_e655, _e664, _e673, 0f)), (_e549.member.member_1 - vec4<f32>(_e694, _e703, _e712, 0f))), _e822), type_55(type_28((_e549.member.member + vec4<f32>(_e677, _e681, _e685, 0f)), (_e549.member.member_1 - vec4<f32>(_e716, _e720, _e724, 0f))), _e847));
                                        }
                                        let _e852 = phi_2878_;
                                        let _e863 = ((_e852.member[0].x - _e340) * _e345);
                                        let _e864 = ((_e852.member[0].y - _e340) * _e345);
                                        let _e865 = ((_e852.member[0].z - _e341) * _e345);
                                        let _e866 = ((_e852.member[0].w - _e341) * _e345);
                                        let _e876 = ((_e852.member[1].x - _e378) * _e383);
                                        let _e877 = ((_e852.member[1].y - _e378) * _e383);
                                        let _e878 = ((_e852.member[1].z - _e379) * _e383);
                                        let _e879 = ((_e852.member[1].w - _e379) * _e383);
                                        let _e889 = ((_e852.member[2].x - _e416) * _e421);
                                        let _e890 = ((_e852.member[2].y - _e416) * _e421);
                                        let _e891 = ((_e852.member[2].z - _e417) * _e421);
                                        let _e892 = ((_e852.member[2].w - _e417) * _e421);
                                        let _e894 = select(_e891, _e889, (_e889 < _e891));
                                        let _e896 = select(_e892, _e890, (_e890 < _e892));
                                        let _e898 = select(_e891, _e889, (_e889 > _e891));
                                        let _e900 = select(_e892, _e890, (_e890 > _e892));
                                        let _e902 = select(_e865, _e863, (_e863 < _e865));
                                        let _e904 = select(_e866, _e864, (_e864 < _e866));
                                        let _e906 = select(_e878, _e876, (_e876 < _e878));
                                        let _e908 = select(_e879, _e877, (_e877 < _e879));
                                        let _e910 = select(_e906, _e902, (_e902 > _e906));
                                        let _e912 = select(_e908, _e904, (_e904 > _e908));
                                        let _e914 = select(_e894, _e910, (_e910 > _e894));
                                        let _e916 = select(_e896, _e912, (_e912 > _e896));
                                        let _e918 = select(_e865, _e863, (_e863 > _e865));
                                        let _e920 = select(_e866, _e864, (_e864 > _e866));
                                        let _e922 = select(_e878, _e876, (_e876 > _e878));
                                        let _e924 = select(_e879, _e877, (_e877 > _e879));
                                        let _e926 = select(_e922, _e918, (_e918 < _e922));
                                        let _e928 = select(_e924, _e920, (_e920 < _e924));
                                        let _e933 = -(_e894);
                                        let _e934 = -(_e896);
                                        let _e941 = (select(_e898, _e926, (_e926 < _e898)) + (select(_e933, _e898, (_e898 > _e933)) * 0.0000019073523f));
                                        let _e942 = (select(_e900, _e928, (_e928 < _e900)) + (select(_e934, _e900, (_e900 > _e934)) * 0.0000019073523f));
                                        let _e944 = select(_e468, _e914, (_e914 > _e468));
                                        let _e946 = select(_e468, _e916, (_e916 > _e468));
                                        let _e951 = (_e944 <= select(_e511, _e941, (_e941 < _e511)));
                                        let _e952 = (_e946 <= select(_e511, _e942, (_e942 < _e511)));
                                        let _e953 = (_e944 <= _e946);
                                        if _e951 {
                                            if _e952 {
                                                if _e953 {
                                                    phi_3223_ = _e852.member_2;
                                                } else {
                                                    phi_3223_ = _e852.member_1;
                                                }
                                                let _e957 = phi_3223_;
                                                let _e979 = (_e553 % 128u);
                                                let _e980 = (_e979 < 128u);
                                                if _e980 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_8[_e979] = _e957.member_1;
                                                if _e980 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_7[_e979] = _e957.member.member.x;
                                                if _e980 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_6[_e979] = _e957.member.member.y;
                                                if _e980 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_5[_e979] = _e957.member.member.z;
                                                if _e980 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_4[_e979] = _e957.member.member_1.x;
                                                if _e980 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_3[_e979] = _e957.member.member_1.y;
                                                if _e980 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_2[_e979] = _e957.member.member_1.z;
                                                if _e980 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_10[_e979] = select(_e946, _e944, (_e944 > _e946));
                                                if _e953 {
                                                    phi_3300_ = _e852.member_1;
                                                } else {
                                                    phi_3300_ = _e852.member_2;
                                                }
                                                let _e993 = phi_3300_;
                                                phi_3301_ = _e993;
                                                phi_3302_ = (_e553 + 1u);
                                            } else {
                                                phi_3301_ = type_55();
                                                phi_3302_ = u32();
                                            }
                                            let _e995 = phi_3301_;
                                            let _e997 = phi_3302_;
                                            phi_3304_ = _e995;
                                            phi_3305_ = _e997;
                                            phi_3306_ = select(true, false, _e952);
                                        } else {
                                            phi_3304_ = type_55();
                                            phi_3305_ = u32();
                                            phi_3306_ = true;
                                        }
                                        let _e1000 = phi_3304_;
                                        let _e1002 = phi_3305_;
                                        let _e1004 = phi_3306_;
                                        if _e1004 {
                                            if _e951 {
                                                phi_3315_ = _e852.member_1;
                                            } else {
                                                phi_3315_ = _e852.member_2;
                                            }
                                            let _e1008 = phi_3315_;
                                            phi_3320_ = _e1008;
                                            phi_3321_ = select(_e952, true, _e951);
                                        } else {
                                            phi_3320_ = _e1000;
                                            phi_3321_ = _e551;
                                        }
                                        let _e1011 = phi_3320_;
                                        let _e1013 = phi_3321_;
                                        phi_4051_ = _e511;
                                        phi_3948_ = _e509;
                                        phi_3323_ = _e1011;
                                        phi_3324_ = _e1013;
                                        phi_3325_ = select(_e1002, _e553, _e1004);
                                    }
                                    let _e1589 = phi_4051_;
                                    let _e1591 = phi_3948_;
                                    let _e1593 = phi_3323_;
                                    let _e1595 = phi_3324_;
                                    let _e1597 = phi_3325_;
                                    phi_4050_ = _e1589;
                                    phi_3947_ = _e1591;
                                    phi_3326_ = _e1593;
                                    phi_3327_ = (_e515 - 1u);
                                    phi_3328_ = _e1595;
                                    phi_3329_ = _e1597;
                                } else {
                                    phi_4050_ = _e511;
                                    phi_3947_ = _e509;
                                    phi_3326_ = _e549;
                                    phi_3327_ = _e515;
                                    phi_3328_ = _e551;
                                    phi_3329_ = _e553;
                                }
                                let _e1599 = phi_4050_;
                                let _e1601 = phi_3947_;
                                let _e1603 = phi_3326_;
                                let _e1605 = phi_3327_;
                                let _e1607 = phi_3328_;
                                let _e1609 = phi_3329_;
                                phi_4049_ = _e1599;
                                phi_3946_ = _e1601;
                                phi_3330_ = _e1603;
                                phi_3331_ = _e1605;
                                phi_3332_ = _e1607;
                                phi_3333_ = _e1609;
                            } else {
                                phi_4049_ = _e511;
                                phi_3946_ = _e509;
                                phi_3330_ = type_55();
                                phi_3331_ = u32();
                                phi_3332_ = bool();
                                phi_3333_ = u32();
                            }
                            let _e1611 = phi_4049_;
                            let _e1613 = phi_3946_;
                            let _e1615 = phi_3330_;
                            let _e1617 = phi_3331_;
                            let _e1619 = phi_3332_;
                            let _e1621 = phi_3333_;
                            phi_4048_ = _e1611;
                            phi_3945_ = _e1613;
                            phi_923_ = _e1615;
                            phi_926_ = _e1617;
                            phi_928_ = _e1619;
                            phi_930_ = _e1621;
                            phi_3334_ = _e523;
                        } else {
                            phi_4048_ = _e511;
                            phi_3945_ = _e509;
                            phi_923_ = type_55();
                            phi_926_ = u32();
                            phi_928_ = bool();
                            phi_930_ = u32();
                            phi_3334_ = false;
                        }
                        let _e1623 = phi_4048_;
                        let _e1625 = phi_3945_;
                        let _e1627 = phi_923_;
                        let _e1629 = phi_926_;
                        let _e1631 = phi_928_;
                        let _e1633 = phi_930_;
                        let _e1635 = phi_3334_;
                        continue;
                        continuing {
                            phi_3796_ = _e1625;
                            phi_3710_ = _e1623;
                            phi_922_ = _e1627;
                            phi_925_ = _e1629;
                            phi_927_ = _e1631;
                            phi_929_ = _e1633;
                            phi_3944_ = _e1625;
                            break if !(_e1635);
                        }
                    }
                    let _e1638 = phi_3944_;
                    if _e1638 {
                        break;
                    }
                    phi_3341_ = type_8(0u, 8u);
                    loop {
                        let _e1640 = phi_3341_;
                        if (_e1640.member < _e1640.member_1) {
                            phi_3342_ = type_8((_e1640.member + 1u), _e1640.member_1);
                            phi_3365_ = type_8(1u, _e1640.member);
                        } else {
                            phi_3342_ = _e1640;
                            phi_3365_ = type_8(0u, type_8().member_1);
                        }
                        let _e1653 = phi_3342_;
                        let _e1655 = phi_3365_;
                        let _e1659 = (bitcast<i32>(_e1655.member) != 0i);
                        if _e1659 {
                            let _e1660 = (_e1655.member_1 < 8u);
                            if _e1660 {
                            } else {
                                phi_4041_ = true;
                                break;
                            }
                            let _e1662 = local_9[_e1655.member_1];
                            if (_e1662.member_3 != 4294967295u) {
                                let _e1668 = -(_e435);
                                let _e1669 = (_e1668 / 3i);
                                let _e1676 = bitcast<f32>((bitcast<u32>((_e1669 + 127i)) << bitcast<u32>(23i)));
                                let _e1684 = (((_e1662.member * _e1676) * _e1676) * bitcast<f32>((bitcast<u32>(((_e1668 - (2i * _e1669)) + 127i)) << bitcast<u32>(23i))));
                                let _e1686 = select(340282350000000000000000000000000000000f, _e1684, (_e1684 < 340282350000000000000000000000000000000f));
                                phi_3431_ = type_24(select(-340282350000000000000000000000000000000f, _e1686, (_e1686 > -340282350000000000000000000000000000000f)), _e1662.member_1, _e1662.member_2, _e1662.member_3);
                            } else {
                                phi_3431_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1691 = phi_3431_;
                            if _e1660 {
                            } else {
                                phi_4041_ = true;
                                break;
                            }
                            local_9[_e1655.member_1] = type_24(_e1691.member, _e1691.member_1, _e1691.member_2, _e1691.member_3);
                        }
                        continue;
                        continuing {
                            phi_3341_ = _e1653;
                            phi_4041_ = _e1638;
                            break if !(_e1659);
                        }
                    }
                    let _e1699 = phi_4041_;
                    if _e1699 {
                        break;
                    }
                    let _e1700 = local_9;
                    if _e156 {
                    } else {
                        break;
                    }
                    global_6.member[_e154] = array<type_24, 8>(type_24(_e1700[0].member, _e1700[0].member_1, _e1700[0].member_2, _e1700[0].member_3), type_24(_e1700[1].member, _e1700[1].member_1, _e1700[1].member_2, _e1700[1].member_3), type_24(_e1700[2].member, _e1700[2].member_1, _e1700[2].member_2, _e1700[2].member_3), type_24(_e1700[3].member, _e1700[3].member_1, _e1700[3].member_2, _e1700[3].member_3), type_24(_e1700[4].member, _e1700[4].member_1, _e1700[4].member_2, _e1700[4].member_3), type_24(_e1700[5].member, _e1700[5].member_1, _e1700[5].member_2, _e1700[5].member_3), type_24(_e1700[6].member, _e1700[6].member_1, _e1700[6].member_2, _e1700[6].member_3), type_24(_e1700[7].member, _e1700[7].member_1, _e1700[7].member_2, _e1700[7].member_3));
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
