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

struct type_37 {
    member: array<type_26>,
}

struct type_41 {
    member: array<array<type_25, 8>>,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: type_29,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_47;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_37;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_41;

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
    var local_9: array<type_25, 8>;
    var local_10: array<f32, 128>;
    var phi_390_: i32;
    var phi_391_: i32;
    var phi_401_: bool;
    var phi_411_: u32;
    var phi_412_: u32;
    var phi_414_: bool;
    var phi_419_: u32;
    var phi_431_: i32;
    var phi_451_: i32;
    var phi_469_: f32;
    var phi_475_: f32;
    var phi_486_: f32;
    var phi_492_: f32;
    var phi_515_: f32;
    var phi_526_: f32;
    var phi_535_: f32;
    var phi_541_: f32;
    var phi_552_: f32;
    var phi_558_: f32;
    var phi_581_: f32;
    var phi_592_: f32;
    var phi_601_: f32;
    var phi_607_: f32;
    var phi_618_: f32;
    var phi_624_: f32;
    var phi_647_: f32;
    var phi_658_: f32;
    var phi_758_: f32;
    var phi_759_: f32;
    var phi_3765_: bool;
    var phi_3693_: f32;
    var phi_901_: type_52;
    var phi_904_: u32;
    var phi_906_: bool;
    var phi_908_: u32;
    var phi_919_: bool;
    var phi_1006_: type_52;
    var phi_1007_: bool;
    var phi_1008_: u32;
    var phi_2826_: u32;
    var phi_2827_: u32;
    var phi_2837_: u32;
    var phi_2839_: u32;
    var phi_2840_: bool;
    var phi_2860_: u32;
    var phi_2861_: u32;
    var phi_2865_: type_53;
    var phi_3210_: type_52;
    var phi_3287_: type_52;
    var phi_3288_: type_52;
    var phi_3289_: u32;
    var phi_3291_: type_52;
    var phi_3292_: u32;
    var phi_3293_: bool;
    var phi_3302_: type_52;
    var phi_3307_: type_52;
    var phi_3308_: bool;
    var phi_3762_: bool;
    var phi_3752_: f32;
    var phi_1026_: type_4;
    var phi_1027_: type_4;
    var phi_1050_: type_4;
    var phi_1071_: u32;
    var phi_1160_: array<array<f32, 3>, 3>;
    var phi_1278_: bool;
    var phi_1307_: bool;
    var phi_1708_: f32;
    var phi_1709_: f32;
    var phi_1710_: f32;
    var phi_1711_: f32;
    var phi_1712_: vec3<f32>;
    var phi_1713_: vec3<f32>;
    var phi_1714_: vec3<f32>;
    var phi_1715_: vec3<f32>;
    var phi_1746_: bool;
    var phi_1755_: vec3<f32>;
    var phi_1920_: f32;
    var phi_1922_: f32;
    var phi_1923_: bool;
    var phi_1943_: f32;
    var phi_1944_: f32;
    var phi_1967_: type_25;
    var phi_1969_: type_25;
    var phi_1970_: bool;
    var phi_1974_: type_25;
    var phi_1975_: type_25;
    var phi_1976_: type_25;
    var phi_1977_: bool;
    var phi_1981_: type_25;
    var phi_1982_: bool;
    var phi_1983_: type_25;
    var phi_1984_: bool;
    var phi_1985_: bool;
    var phi_1986_: type_25;
    var phi_1987_: bool;
    var phi_1988_: bool;
    var phi_1996_: type_25;
    var phi_1997_: bool;
    var phi_2001_: type_25;
    var phi_2013_: type_4;
    var phi_2016_: type_25;
    var phi_2014_: type_4;
    var phi_2039_: type_4;
    var phi_2071_: bool;
    var phi_2072_: bool;
    var phi_2093_: type_25;
    var phi_2017_: type_25;
    var phi_3753_: bool;
    var phi_4128_: f32;
    var phi_4127_: f32;
    var phi_3898_: bool;
    var phi_4126_: f32;
    var phi_3897_: bool;
    var phi_4125_: f32;
    var phi_3896_: bool;
    var phi_4037_: f32;
    var phi_3895_: bool;
    var phi_4002_: f32;
    var phi_3904_: bool;
    var phi_3310_: type_52;
    var phi_3311_: bool;
    var phi_3312_: u32;
    var phi_4001_: f32;
    var phi_3903_: bool;
    var phi_3313_: type_52;
    var phi_3314_: u32;
    var phi_3315_: bool;
    var phi_3316_: u32;
    var phi_4000_: f32;
    var phi_3902_: bool;
    var phi_3317_: type_52;
    var phi_3318_: u32;
    var phi_3319_: bool;
    var phi_3320_: u32;
    var phi_3999_: f32;
    var phi_3901_: bool;
    var phi_902_: type_52;
    var phi_905_: u32;
    var phi_907_: bool;
    var phi_909_: u32;
    var phi_3321_: bool;
    var phi_3900_: bool;
    var phi_3328_: type_4;
    var phi_3329_: type_4;
    var phi_3352_: type_4;
    var phi_3418_: type_25;
    var phi_3992_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e89 = global;
            let _e91 = arrayLength((&global_4.member));
            let _e93 = arrayLength((&global_2.member));
            let _e101 = global_3.member[0u][0u];
            let _e105 = global_3.member[0u][1u];
            let _e109 = global_3.member[0u][2u];
            let _e113 = global_3.member[0u][3u];
            let _e117 = global_3.member[1u][0u];
            let _e121 = global_3.member[1u][1u];
            let _e125 = global_3.member[1u][2u];
            let _e128 = global_1.member[0u];
            let _e129 = bitcast<i32>(_e128);
            let _e141 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e113) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e101), bitcast<i32>(_e105), bitcast<i32>(_e109));
            local = array<i32, 3>(bitcast<i32>(_e117), bitcast<i32>(_e121), bitcast<i32>(_e125));
            let _e147 = (_e89.x + (_e89.y * 2097152u));
            let _e148 = (_e147 < arrayLength((&global_5.member)));
            if _e148 {
                let _e149 = (_e147 < arrayLength((&global_6.member)));
                if _e149 {
                    if _e148 {
                    } else {
                        break;
                    }
                    let _e157 = global_5.member[_e147].member_2[0u];
                    let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                    let _e164 = global_5.member[_e147].member_2[1u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_5.member[_e147].member_2[2u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_5.member[_e147].member[0u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_5.member[_e147].member[1u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e192 = global_5.member[_e147].member[2u];
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e196 = select(_e166, _e159, (_e166 < _e159));
                    let _e198 = select(_e173, _e196, (_e173 < _e196));
                    let _e200 = select(_e180, _e198, (_e180 < _e198));
                    let _e202 = select(_e187, _e200, (_e187 < _e200));
                    let _e204 = select(_e194, _e202, (_e194 < _e202));
                    let _e208 = global_5.member[_e147].member_1;
                    let _e210 = (bitcast<u32>(_e208) & 2147483647u);
                    let _e217 = global_5.member[_e147].member_3;
                    let _e223 = (((select(_e210, _e204, (_e210 < _e204)) < 2139095040u) && ((bitcast<u32>(_e217) & 2147483647u) <= 2139095040u)) && (_e198 > 0u));
                    if _e223 {
                        let _e226 = (bitcast<u32>(bitcast<f32>(_e198)) & 2147483647u);
                        if (_e226 >= 8388608u) {
                            phi_390_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_390_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                        }
                        let _e240 = phi_390_;
                        phi_391_ = _e240;
                    } else {
                        phi_391_ = 0i;
                    }
                    let _e242 = phi_391_;
                    let _e243 = (_e159 == _e198);
                    if _e243 {
                        phi_401_ = true;
                    } else {
                        phi_401_ = (_e166 == _e198);
                    }
                    let _e246 = phi_401_;
                    let _e247 = select(1u, 0u, _e243);
                    if _e246 {
                        let _e248 = (_e247 + 1u);
                        phi_411_ = _e248;
                        phi_412_ = _e248;
                        phi_414_ = select(true, false, (_e248 == 2u));
                    } else {
                        phi_411_ = u32();
                        phi_412_ = 0u;
                        phi_414_ = true;
                    }
                    let _e252 = phi_411_;
                    let _e254 = phi_412_;
                    let _e256 = phi_414_;
                    if _e256 {
                        phi_419_ = (_e254 + 1u);
                    } else {
                        phi_419_ = 0u;
                    }
                    let _e260 = phi_419_;
                    let _e261 = select(_e252, _e254, _e256);
                    let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                    if (_e129 < -126i) {
                        phi_431_ = -126i;
                    } else {
                        phi_431_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e267 = phi_431_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e129 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = -(_e242);
                    if (_e279 < -126i) {
                        phi_451_ = -126i;
                    } else {
                        phi_451_ = select(_e279, 127i, (_e279 > 127i));
                    }
                    let _e284 = phi_451_;
                    let _e289 = bitcast<f32>((bitcast<u32>((_e284 + 127i)) << bitcast<u32>(23i)));
                    let _e295 = bitcast<f32>((bitcast<u32>(((_e279 - _e284) + 127i)) << bitcast<u32>(23i)));
                    let _e299 = global_5.member[_e147].member;
                    let _e300 = (_e261 == 0u);
                    if _e300 {
                        phi_469_ = _e299[0];
                    } else {
                        phi_469_ = _e299[1];
                    }
                    let _e304 = phi_469_;
                    let _e305 = (_e261 == 2u);
                    if _e305 {
                        phi_475_ = _e299[2];
                    } else {
                        phi_475_ = _e304;
                    }
                    let _e308 = phi_475_;
                    let _e310 = ((_e308 * _e272) * _e278);
                    let _e311 = global_5.member[_e147].member_2;
                    if _e300 {
                        phi_486_ = _e311[0];
                    } else {
                        phi_486_ = _e311[1];
                    }
                    let _e315 = phi_486_;
                    if _e305 {
                        phi_492_ = _e311[2];
                    } else {
                        phi_492_ = _e315;
                    }
                    let _e318 = phi_492_;
                    let _e320 = ((_e318 * _e289) * _e295);
                    let _e324 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e324 {
                        let _e328 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) * 0.00000011920929f);
                        phi_515_ = select(0.00000000000011368684f, _e328, (_e328 > 0.00000000000011368684f));
                    } else {
                        phi_515_ = 0f;
                    }
                    let _e332 = phi_515_;
                    let _e333 = (_e310 + _e332);
                    let _e334 = (_e310 - _e332);
                    let _e335 = select(_e320, 0f, _e324);
                    if _e324 {
                        phi_526_ = 38685626000000000000000000f;
                    } else {
                        phi_526_ = (1f / _e320);
                    }
                    let _e338 = phi_526_;
                    let _e339 = (_e260 == 0u);
                    if _e339 {
                        phi_535_ = _e299[0];
                    } else {
                        phi_535_ = _e299[1];
                    }
                    let _e343 = phi_535_;
                    let _e344 = (_e260 == 2u);
                    if _e344 {
                        phi_541_ = _e299[2];
                    } else {
                        phi_541_ = _e343;
                    }
                    let _e347 = phi_541_;
                    let _e349 = ((_e347 * _e272) * _e278);
                    if _e339 {
                        phi_552_ = _e311[0];
                    } else {
                        phi_552_ = _e311[1];
                    }
                    let _e353 = phi_552_;
                    if _e344 {
                        phi_558_ = _e311[2];
                    } else {
                        phi_558_ = _e353;
                    }
                    let _e356 = phi_558_;
                    let _e358 = ((_e356 * _e289) * _e295);
                    let _e362 = (bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e362 {
                        let _e366 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) * 0.00000011920929f);
                        phi_581_ = select(0.00000000000011368684f, _e366, (_e366 > 0.00000000000011368684f));
                    } else {
                        phi_581_ = 0f;
                    }
                    let _e370 = phi_581_;
                    let _e371 = (_e349 + _e370);
                    let _e372 = (_e349 - _e370);
                    let _e373 = select(_e358, 0f, _e362);
                    if _e362 {
                        phi_592_ = 38685626000000000000000000f;
                    } else {
                        phi_592_ = (1f / _e358);
                    }
                    let _e376 = phi_592_;
                    let _e377 = (_e262 == 0u);
                    if _e377 {
                        phi_601_ = _e299[0];
                    } else {
                        phi_601_ = _e299[1];
                    }
                    let _e381 = phi_601_;
                    let _e382 = (_e262 == 2u);
                    if _e382 {
                        phi_607_ = _e299[2];
                    } else {
                        phi_607_ = _e381;
                    }
                    let _e385 = phi_607_;
                    let _e387 = ((_e385 * _e272) * _e278);
                    if _e377 {
                        phi_618_ = _e311[0];
                    } else {
                        phi_618_ = _e311[1];
                    }
                    let _e391 = phi_618_;
                    if _e382 {
                        phi_624_ = _e311[2];
                    } else {
                        phi_624_ = _e391;
                    }
                    let _e394 = phi_624_;
                    let _e396 = ((_e394 * _e289) * _e295);
                    let _e400 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e400 {
                        let _e404 = (bitcast<f32>((bitcast<u32>(_e387) & 2147483647u)) * 0.00000011920929f);
                        phi_647_ = select(0.00000000000011368684f, _e404, (_e404 > 0.00000000000011368684f));
                    } else {
                        phi_647_ = 0f;
                    }
                    let _e408 = phi_647_;
                    let _e409 = (_e387 + _e408);
                    let _e410 = (_e387 - _e408);
                    let _e411 = select(_e396, 0f, _e400);
                    if _e400 {
                        phi_658_ = 38685626000000000000000000f;
                    } else {
                        phi_658_ = (1f / _e396);
                    }
                    let _e414 = phi_658_;
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
                        phi_758_ = select(-340282350000000000000000000000000000000f, _e455, (_e455 > -340282350000000000000000000000000000000f));
                        phi_759_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_758_ = 0f;
                        phi_759_ = 1f;
                    }
                    let _e459 = phi_758_;
                    let _e461 = phi_759_;
                    local_9 = array<type_25, 8>(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e464 = (_e261 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e260 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    let _e476 = (_e262 % 3u);
                    let _e477 = (_e476 < 3u);
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e479 = local_1[_e476];
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e484 = local[_e464];
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e470];
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e492 = local[_e476];
                    phi_3765_ = false;
                    phi_3693_ = _e459;
                    phi_901_ = type_52(type_29(vec4<f32>((f32(_e467) * _e141), (f32(_e473) * _e141), (f32(_e479) * _e141), 0f), vec4<f32>((f32(_e484) * _e141), (f32(_e488) * _e141), (f32(_e492) * _e141), 0f)), select(0u, 2147483648u, (_e91 == 0u)));
                    phi_904_ = ((3u * _e91) + 1u);
                    phi_906_ = (_e461 <= _e459);
                    phi_908_ = 0u;
                    loop {
                        let _e502 = phi_3765_;
                        let _e504 = phi_3693_;
                        let _e506 = phi_901_;
                        let _e508 = phi_904_;
                        let _e510 = phi_906_;
                        let _e512 = phi_908_;
                        if _e510 {
                            phi_919_ = true;
                        } else {
                            phi_919_ = (_e512 > 0u);
                        }
                        let _e515 = phi_919_;
                        if _e515 {
                            let _e516 = (_e508 > 0u);
                            if _e516 {
                                if _e510 {
                                    phi_1006_ = _e506;
                                    phi_1007_ = _e510;
                                    phi_1008_ = _e512;
                                } else {
                                    let _e517 = (_e512 - 1u);
                                    let _e518 = (_e517 % 128u);
                                    let _e519 = (_e518 < 128u);
                                    if _e519 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e521 = local_7[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e523 = local_6[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e525 = local_5[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e527 = local_4[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e529 = local_3[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e531 = local_2[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e536 = local_8[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e539 = local_10[_e518];
                                    phi_1006_ = type_52(type_29(vec4<f32>(_e521, _e523, _e525, 0f), vec4<f32>(_e527, _e529, _e531, 0f)), _e536);
                                    phi_1007_ = (_e539 <= _e504);
                                    phi_1008_ = _e517;
                                }
                                let _e542 = phi_1006_;
                                let _e544 = phi_1007_;
                                let _e546 = phi_1008_;
                                if _e544 {
                                    if ((_e542.member_1 & 2147483648u) != 0u) {
                                        phi_3762_ = _e502;
                                        phi_3752_ = _e504;
                                        phi_1026_ = type_4(0u, ((_e542.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e989 = phi_3762_;
                                            let _e991 = phi_3752_;
                                            let _e993 = phi_1026_;
                                            if (_e993.member < _e993.member_1) {
                                                phi_1027_ = type_4((_e993.member + 1u), _e993.member_1);
                                                phi_1050_ = type_4(1u, _e993.member);
                                            } else {
                                                phi_1027_ = _e993;
                                                phi_1050_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1006 = phi_1027_;
                                            let _e1008 = phi_1050_;
                                            let _e1012 = (bitcast<i32>(_e1008.member) != 0i);
                                            if _e1012 {
                                                let _e1013 = ((_e542.member_1 & 268435455u) + _e1008.member_1);
                                                let _e1014 = (_e1013 < _e93);
                                                if _e1014 {
                                                    if _e1014 {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1018 = global_2.member[_e1013].member_1;
                                                    phi_1071_ = _e1018;
                                                } else {
                                                    phi_1071_ = 4294967295u;
                                                }
                                                let _e1020 = phi_1071_;
                                                if (_e1013 >= _e93) {
                                                    phi_1160_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1014 {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    if (_e464 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1027 = global_2.member[_e1013].member[_e464];
                                                    if (_e470 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1033 = global_2.member[_e1013].member[_e470];
                                                    if (_e476 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1039 = global_2.member[_e1013].member[_e476];
                                                    let _e1041 = (3u + _e464);
                                                    if (_e1041 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1047 = global_2.member[_e1013].member[_e1041];
                                                    let _e1048 = (3u + _e470);
                                                    if (_e1048 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1054 = global_2.member[_e1013].member[_e1048];
                                                    let _e1055 = (3u + _e476);
                                                    if (_e1055 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1061 = global_2.member[_e1013].member[_e1055];
                                                    let _e1063 = (6u + _e464);
                                                    if (_e1063 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1069 = global_2.member[_e1013].member[_e1063];
                                                    let _e1070 = (6u + _e470);
                                                    if (_e1070 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1076 = global_2.member[_e1013].member[_e1070];
                                                    let _e1077 = (6u + _e476);
                                                    if (_e1077 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1083 = global_2.member[_e1013].member[_e1077];
                                                    phi_1160_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1027, _e1033, _e1039), array<f32, 3>(_e1047, _e1054, _e1061), array<f32, 3>(_e1069, _e1076, _e1083));
                                                }
                                                let _e1087 = phi_1160_;
                                                let _e1094 = (_e1087[0][2] - _e387);
                                                let _e1097 = (((_e1087[0][0] - _e310) * _e411) - (_e1094 * _e335));
                                                let _e1100 = (((_e1087[0][1] - _e349) * _e411) - (_e1094 * _e373));
                                                let _e1107 = (_e1087[1][2] - _e387);
                                                let _e1110 = (((_e1087[1][0] - _e310) * _e411) - (_e1107 * _e335));
                                                let _e1113 = (((_e1087[1][1] - _e349) * _e411) - (_e1107 * _e373));
                                                let _e1120 = (_e1087[2][2] - _e387);
                                                let _e1123 = (((_e1087[2][0] - _e310) * _e411) - (_e1120 * _e335));
                                                let _e1126 = (((_e1087[2][1] - _e349) * _e411) - (_e1120 * _e373));
                                                let _e1127 = (_e1123 * _e1113);
                                                let _e1128 = (_e1126 * _e1110);
                                                let _e1129 = (_e1097 * _e1126);
                                                let _e1130 = (_e1100 * _e1123);
                                                let _e1131 = (_e1110 * _e1100);
                                                let _e1132 = (_e1113 * _e1097);
                                                let _e1137 = (((_e1127 >= _e1128) && (_e1129 >= _e1130)) && (_e1131 >= _e1132));
                                                if (_e1137 || (((_e1127 <= _e1128) && (_e1129 <= _e1130)) && (_e1131 <= _e1132))) {
                                                    let _e1144 = select(-1f, 1f, _e1137);
                                                    let _e1146 = ((_e1127 - _e1128) * _e1144);
                                                    let _e1148 = select(0f, _e1146, (_e1146 > 0f));
                                                    let _e1150 = ((_e1129 - _e1130) * _e1144);
                                                    let _e1152 = select(0f, _e1150, (_e1150 > 0f));
                                                    let _e1154 = ((_e1131 - _e1132) * _e1144);
                                                    let _e1156 = select(0f, _e1154, (_e1154 > 0f));
                                                    let _e1158 = ((_e1148 + _e1152) + _e1156);
                                                    if (_e1158 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1986_ = type_25();
                                                        phi_1987_ = true;
                                                        phi_1988_ = false;
                                                    } else {
                                                        let _e1161 = select(_e1110, _e1097, (_e1097 < _e1110));
                                                        if (select(_e1123, _e1161, (_e1161 < _e1123)) > 0f) {
                                                            phi_1278_ = true;
                                                        } else {
                                                            let _e1166 = select(_e1110, _e1097, (_e1097 > _e1110));
                                                            phi_1278_ = (select(_e1123, _e1166, (_e1166 > _e1123)) < 0f);
                                                        }
                                                        let _e1171 = phi_1278_;
                                                        if _e1171 {
                                                            phi_1983_ = type_25();
                                                            phi_1984_ = true;
                                                            phi_1985_ = false;
                                                        } else {
                                                            let _e1173 = select(_e1113, _e1100, (_e1100 < _e1113));
                                                            if (select(_e1126, _e1173, (_e1173 < _e1126)) > 0f) {
                                                                phi_1307_ = true;
                                                            } else {
                                                                let _e1178 = select(_e1113, _e1100, (_e1100 > _e1113));
                                                                phi_1307_ = (select(_e1126, _e1178, (_e1178 > _e1126)) < 0f);
                                                            }
                                                            let _e1183 = phi_1307_;
                                                            if _e1183 {
                                                                phi_1981_ = type_25();
                                                                phi_1982_ = false;
                                                            } else {
                                                                let _e1185 = select(_e1087[1][0], _e1087[0][0], (_e1087[0][0] < _e1087[1][0]));
                                                                let _e1189 = select(_e1087[1][0], _e1087[0][0], (_e1087[0][0] > _e1087[1][0]));
                                                                let _e1193 = select(_e1087[1][1], _e1087[0][1], (_e1087[0][1] < _e1087[1][1]));
                                                                let _e1197 = select(_e1087[1][1], _e1087[0][1], (_e1087[0][1] > _e1087[1][1]));
                                                                let _e1201 = select(_e1087[1][2], _e1087[0][2], (_e1087[0][2] < _e1087[1][2]));
                                                                let _e1205 = select(_e1087[1][2], _e1087[0][2], (_e1087[0][2] > _e1087[1][2]));
                                                                let _e1210 = ((select(_e1087[2][0], _e1185, (_e1185 < _e1087[2][0])) - _e333) * _e338);
                                                                let _e1211 = ((select(_e1087[2][0], _e1189, (_e1189 > _e1087[2][0])) - _e334) * _e338);
                                                                let _e1214 = ((select(_e1087[2][1], _e1193, (_e1193 < _e1087[2][1])) - _e371) * _e376);
                                                                let _e1215 = ((select(_e1087[2][1], _e1197, (_e1197 > _e1087[2][1])) - _e372) * _e376);
                                                                let _e1218 = ((select(_e1087[2][2], _e1201, (_e1201 < _e1087[2][2])) - _e409) * _e414);
                                                                let _e1219 = ((select(_e1087[2][2], _e1205, (_e1205 > _e1087[2][2])) - _e410) * _e414);
                                                                let _e1221 = select(_e1219, _e1218, (_e1218 < _e1219));
                                                                let _e1223 = select(_e1219, _e1218, (_e1218 > _e1219));
                                                                let _e1225 = select(_e1211, _e1210, (_e1210 < _e1211));
                                                                let _e1227 = select(_e1215, _e1214, (_e1214 < _e1215));
                                                                let _e1229 = select(_e1227, _e1225, (_e1225 > _e1227));
                                                                let _e1231 = select(_e1221, _e1229, (_e1229 > _e1221));
                                                                let _e1233 = select(_e1211, _e1210, (_e1210 > _e1211));
                                                                let _e1235 = select(_e1215, _e1214, (_e1214 > _e1215));
                                                                let _e1237 = select(_e1235, _e1233, (_e1233 < _e1235));
                                                                let _e1239 = select(_e1223, _e1237, (_e1237 < _e1223));
                                                                let _e1240 = -(_e1221);
                                                                let _e1246 = select(_e461, _e1231, (_e1231 > _e461));
                                                                if (_e1246 > (_e1239 + (select(_e1240, _e1223, (_e1223 > _e1240)) * 0.0000019073523f))) {
                                                                    phi_1976_ = type_25();
                                                                    phi_1977_ = true;
                                                                } else {
                                                                    let _e1248 = (_e1246 > _e991);
                                                                    if _e1248 {
                                                                        phi_1975_ = type_25();
                                                                    } else {
                                                                        let _e1249 = vec3<f32>(_e1087[0][0], _e1087[0][1], _e1087[0][2]);
                                                                        let _e1250 = vec3<f32>(_e1087[1][0], _e1087[1][1], _e1087[1][2]);
                                                                        let _e1251 = vec3<f32>(_e1087[2][0], _e1087[2][1], _e1087[2][2]);
                                                                        let _e1252 = (_e1087[1][0] - _e1087[0][0]);
                                                                        let _e1253 = (_e1087[1][1] - _e1087[0][1]);
                                                                        let _e1254 = (_e1087[1][2] - _e1087[0][2]);
                                                                        let _e1255 = vec3<f32>(_e1252, _e1253, _e1254);
                                                                        let _e1256 = (_e1087[2][0] - _e1087[1][0]);
                                                                        let _e1257 = (_e1087[2][1] - _e1087[1][1]);
                                                                        let _e1258 = (_e1087[2][2] - _e1087[1][2]);
                                                                        let _e1259 = vec3<f32>(_e1256, _e1257, _e1258);
                                                                        let _e1260 = (_e1087[0][0] - _e1087[2][0]);
                                                                        let _e1261 = (_e1087[0][1] - _e1087[2][1]);
                                                                        let _e1262 = (_e1087[0][2] - _e1087[2][2]);
                                                                        let _e1263 = vec3<f32>(_e1260, _e1261, _e1262);
                                                                        let _e1266 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
                                                                        let _e1269 = bitcast<f32>((bitcast<u32>(_e1253) & 2147483647u));
                                                                        let _e1271 = select(_e1269, _e1266, (_e1266 > _e1269));
                                                                        let _e1274 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                                        let _e1276 = select(_e1274, _e1271, (_e1271 > _e1274));
                                                                        let _e1279 = bitcast<f32>((bitcast<u32>(_e1256) & 2147483647u));
                                                                        let _e1282 = bitcast<f32>((bitcast<u32>(_e1257) & 2147483647u));
                                                                        let _e1284 = select(_e1282, _e1279, (_e1279 > _e1282));
                                                                        let _e1287 = bitcast<f32>((bitcast<u32>(_e1258) & 2147483647u));
                                                                        let _e1289 = select(_e1287, _e1284, (_e1284 > _e1287));
                                                                        let _e1292 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                        let _e1295 = bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u));
                                                                        let _e1297 = select(_e1295, _e1292, (_e1292 > _e1295));
                                                                        let _e1300 = bitcast<f32>((bitcast<u32>(_e1262) & 2147483647u));
                                                                        let _e1302 = select(_e1300, _e1297, (_e1297 > _e1300));
                                                                        let _e1304 = select(_e1289, _e1276, (_e1276 > _e1289));
                                                                        let _e1306 = select(_e1302, _e1304, (_e1304 > _e1302));
                                                                        if (_e1276 == _e1306) {
                                                                            phi_1708_ = _e1113;
                                                                            phi_1709_ = _e1110;
                                                                            phi_1710_ = _e1100;
                                                                            phi_1711_ = _e1097;
                                                                            phi_1712_ = _e1249;
                                                                            phi_1713_ = _e1263;
                                                                            phi_1714_ = _e1259;
                                                                            phi_1715_ = _e1255;
                                                                        } else {
                                                                            let _e1308 = (_e1289 == _e1306);
                                                                            let _e1313 = vec3(_e1308);
                                                                            phi_1708_ = select(_e1100, _e1126, _e1308);
                                                                            phi_1709_ = select(_e1097, _e1123, _e1308);
                                                                            phi_1710_ = select(_e1126, _e1113, _e1308);
                                                                            phi_1711_ = select(_e1123, _e1110, _e1308);
                                                                            phi_1712_ = select(_e1251, _e1250, _e1313);
                                                                            phi_1713_ = select(_e1259, _e1255, _e1313);
                                                                            phi_1714_ = select(_e1255, _e1263, _e1313);
                                                                            phi_1715_ = select(_e1263, _e1259, _e1313);
                                                                        }
                                                                        let _e1319 = phi_1708_;
                                                                        let _e1321 = phi_1709_;
                                                                        let _e1323 = phi_1710_;
                                                                        let _e1325 = phi_1711_;
                                                                        let _e1327 = phi_1712_;
                                                                        let _e1329 = phi_1713_;
                                                                        let _e1331 = phi_1714_;
                                                                        let _e1333 = phi_1715_;
                                                                        let _e1340 = ((_e1331.y * _e1329.z) - (_e1329.y * _e1331.z));
                                                                        let _e1345 = ((_e1331.z * _e1329.x) - (_e1329.z * _e1331.x));
                                                                        let _e1348 = ((_e1331.x * _e1329.y) - (_e1329.x * _e1331.y));
                                                                        if (_e1148 >= _e1152) {
                                                                            phi_1746_ = select(true, false, (_e1148 >= _e1156));
                                                                        } else {
                                                                            phi_1746_ = true;
                                                                        }
                                                                        let _e1353 = phi_1746_;
                                                                        if _e1353 {
                                                                            phi_1755_ = select(_e1251, _e1250, vec3((_e1152 >= _e1156)));
                                                                        } else {
                                                                            phi_1755_ = _e1249;
                                                                        }
                                                                        let _e1358 = phi_1755_;
                                                                        let _e1369 = (((_e1340 * (_e1358.x - _e310)) + (_e1345 * (_e1358.y - _e349))) + (_e1348 * (_e1358.z - _e387)));
                                                                        let _e1374 = (((_e1340 * _e335) + (_e1345 * _e373)) + (_e1348 * _e411));
                                                                        let _e1375 = (_e1321 - _e1325);
                                                                        let _e1376 = (_e1319 - _e1323);
                                                                        let _e1384 = (-(((_e1325 * _e1375) + (_e1323 * _e1376))) / ((_e1375 * _e1375) + (_e1376 * _e1376)));
                                                                        let _e1386 = select(1f, _e1384, (_e1384 < 1f));
                                                                        let _e1388 = select(0f, _e1386, (_e1386 > 0f));
                                                                        let _e1401 = ((_e1327.x + (_e1333.x * _e1388)) - _e310);
                                                                        let _e1402 = ((_e1327.y + (_e1333.y * _e1388)) - _e349);
                                                                        let _e1403 = ((_e1327.z + (_e1333.z * _e1388)) - _e387);
                                                                        let _e1404 = (_e1403 / _e411);
                                                                        let _e1416 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                                        let _e1419 = bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u));
                                                                        let _e1421 = select(_e1419, _e1416, (_e1416 > _e1419));
                                                                        let _e1424 = bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u));
                                                                        let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                                        let _e1432 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                        let _e1435 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                        let _e1437 = select(_e1435, _e1432, (_e1432 > _e1435));
                                                                        let _e1440 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1340 * _e1401) + (_e1345 * _e1402)) + (_e1348 * _e1403)) - _e1369)) & 2147483647u)) <= ((0.0000009536743f * select(_e1306, _e1426, (_e1426 > _e1306))) * select(_e1440, _e1437, (_e1437 > _e1440)))) {
                                                                            let _e1450 = bitcast<f32>((bitcast<u32>(_e1331.x) & 2147483647u));
                                                                            let _e1453 = bitcast<f32>((bitcast<u32>(_e1331.y) & 2147483647u));
                                                                            let _e1455 = select(_e1453, _e1450, (_e1450 > _e1453));
                                                                            let _e1458 = bitcast<f32>((bitcast<u32>(_e1331.z) & 2147483647u));
                                                                            let _e1464 = bitcast<f32>((bitcast<u32>(_e1329.x) & 2147483647u));
                                                                            let _e1467 = bitcast<f32>((bitcast<u32>(_e1329.y) & 2147483647u));
                                                                            let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                                                            let _e1472 = bitcast<f32>((bitcast<u32>(_e1329.z) & 2147483647u));
                                                                            let _e1476 = (bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u)) > ((0.0000038146973f * select(_e1458, _e1455, (_e1455 > _e1458))) * select(_e1472, _e1469, (_e1469 > _e1472))));
                                                                            if _e1476 {
                                                                                phi_1920_ = (_e1369 / _e1374);
                                                                            } else {
                                                                                phi_1920_ = f32();
                                                                            }
                                                                            let _e1479 = phi_1920_;
                                                                            phi_1922_ = _e1479;
                                                                            phi_1923_ = select(true, false, _e1476);
                                                                        } else {
                                                                            phi_1922_ = f32();
                                                                            phi_1923_ = true;
                                                                        }
                                                                        let _e1482 = phi_1922_;
                                                                        let _e1484 = phi_1923_;
                                                                        if _e1484 {
                                                                            let _e1492 = (((_e1340 * (_e1401 - (_e335 * _e1404))) + (_e1345 * (_e1402 - (_e373 * _e1404)))) / _e1374);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1492) & 2147483647u)) <= _e1306) {
                                                                                phi_1943_ = (_e1404 + _e1492);
                                                                            } else {
                                                                                phi_1943_ = _e1404;
                                                                            }
                                                                            let _e1499 = phi_1943_;
                                                                            phi_1944_ = _e1499;
                                                                        } else {
                                                                            phi_1944_ = _e1482;
                                                                        }
                                                                        let _e1501 = phi_1944_;
                                                                        let _e1503 = select(_e1239, _e1501, (_e1501 < _e1239));
                                                                        let _e1505 = select(_e1231, _e1503, (_e1503 > _e1231));
                                                                        if (_e1505 >= _e461) {
                                                                            let _e1507 = (_e1505 <= _e991);
                                                                            if _e1507 {
                                                                                let _e1508 = (1f / _e1158);
                                                                                phi_1967_ = type_25(_e1505, (_e1152 * _e1508), (_e1156 * _e1508), _e1020);
                                                                            } else {
                                                                                phi_1967_ = type_25();
                                                                            }
                                                                            let _e1513 = phi_1967_;
                                                                            phi_1969_ = _e1513;
                                                                            phi_1970_ = select(true, false, _e1507);
                                                                        } else {
                                                                            phi_1969_ = type_25();
                                                                            phi_1970_ = true;
                                                                        }
                                                                        let _e1516 = phi_1969_;
                                                                        let _e1518 = phi_1970_;
                                                                        if _e1518 {
                                                                            phi_1974_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1974_ = _e1516;
                                                                        }
                                                                        let _e1520 = phi_1974_;
                                                                        phi_1975_ = _e1520;
                                                                    }
                                                                    let _e1522 = phi_1975_;
                                                                    phi_1976_ = _e1522;
                                                                    phi_1977_ = _e1248;
                                                                }
                                                                let _e1524 = phi_1976_;
                                                                let _e1526 = phi_1977_;
                                                                phi_1981_ = _e1524;
                                                                phi_1982_ = _e1526;
                                                            }
                                                            let _e1528 = phi_1981_;
                                                            let _e1530 = phi_1982_;
                                                            phi_1983_ = _e1528;
                                                            phi_1984_ = _e1183;
                                                            phi_1985_ = _e1530;
                                                        }
                                                        let _e1532 = phi_1983_;
                                                        let _e1534 = phi_1984_;
                                                        let _e1536 = phi_1985_;
                                                        phi_1986_ = _e1532;
                                                        phi_1987_ = _e1534;
                                                        phi_1988_ = _e1536;
                                                    }
                                                    let _e1538 = phi_1986_;
                                                    let _e1540 = phi_1987_;
                                                    let _e1542 = phi_1988_;
                                                    phi_1996_ = _e1538;
                                                    phi_1997_ = select(_e1542, true, _e1540);
                                                } else {
                                                    phi_1996_ = type_25();
                                                    phi_1997_ = true;
                                                }
                                                let _e1545 = phi_1996_;
                                                let _e1547 = phi_1997_;
                                                if _e1547 {
                                                    phi_2001_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2001_ = _e1545;
                                                }
                                                let _e1549 = phi_2001_;
                                                if (_e1549.member_3 != 4294967295u) {
                                                    if (_e1020 != 4294967295u) {
                                                        phi_2013_ = type_4(0u, 8u);
                                                        phi_2016_ = _e1549;
                                                        loop {
                                                            let _e1554 = phi_2013_;
                                                            let _e1556 = phi_2016_;
                                                            if (_e1554.member < _e1554.member_1) {
                                                                phi_2014_ = type_4((_e1554.member + 1u), _e1554.member_1);
                                                                phi_2039_ = type_4(1u, _e1554.member);
                                                            } else {
                                                                phi_2014_ = _e1554;
                                                                phi_2039_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1569 = phi_2014_;
                                                            let _e1571 = phi_2039_;
                                                            let _e1575 = (bitcast<i32>(_e1571.member) != 0i);
                                                            if _e1575 {
                                                                let _e1576 = (_e1571.member_1 < 8u);
                                                                if _e1576 {
                                                                } else {
                                                                    phi_3753_ = true;
                                                                    break;
                                                                }
                                                                let _e1581 = local_9[_e1571.member_1].member;
                                                                if (_e1556.member < _e1581) {
                                                                    phi_2072_ = true;
                                                                } else {
                                                                    let _e1583 = local_9[_e1571.member_1].member;
                                                                    if (_e1556.member == _e1583) {
                                                                        let _e1588 = local_9[_e1571.member_1].member_3;
                                                                        phi_2071_ = (_e1556.member_3 < _e1588);
                                                                    } else {
                                                                        phi_2071_ = false;
                                                                    }
                                                                    let _e1591 = phi_2071_;
                                                                    phi_2072_ = _e1591;
                                                                }
                                                                let _e1593 = phi_2072_;
                                                                if _e1593 {
                                                                    if _e1576 {
                                                                    } else {
                                                                        phi_3753_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1594 = local_9[_e1571.member_1];
                                                                    local_9[_e1571.member_1] = type_25(_e1556.member, _e1556.member_1, _e1556.member_2, _e1556.member_3);
                                                                    phi_2093_ = type_25(_e1594.member, _e1594.member_1, _e1594.member_2, _e1594.member_3);
                                                                } else {
                                                                    phi_2093_ = _e1556;
                                                                }
                                                                let _e1605 = phi_2093_;
                                                                phi_2017_ = _e1605;
                                                            } else {
                                                                phi_2017_ = type_25();
                                                            }
                                                            let _e1607 = phi_2017_;
                                                            continue;
                                                            continuing {
                                                                phi_2013_ = _e1569;
                                                                phi_2016_ = _e1607;
                                                                phi_3753_ = _e989;
                                                                break if !(_e1575);
                                                            }
                                                        }
                                                        let _e1610 = phi_3753_;
                                                        phi_4037_ = _e991;
                                                        phi_3895_ = _e1610;
                                                        if _e1610 {
                                                            break;
                                                        }
                                                        let _e1613 = local_9[7u].member_3;
                                                        if (_e1613 != 4294967295u) {
                                                            let _e1617 = local_9[7u].member;
                                                            phi_4128_ = _e1617;
                                                        } else {
                                                            phi_4128_ = _e991;
                                                        }
                                                        let _e1619 = phi_4128_;
                                                        phi_4127_ = _e1619;
                                                        phi_3898_ = _e1610;
                                                    } else {
                                                        phi_4127_ = _e991;
                                                        phi_3898_ = _e989;
                                                    }
                                                    let _e1621 = phi_4127_;
                                                    let _e1623 = phi_3898_;
                                                    phi_4126_ = _e1621;
                                                    phi_3897_ = _e1623;
                                                } else {
                                                    phi_4126_ = _e991;
                                                    phi_3897_ = _e989;
                                                }
                                                let _e1625 = phi_4126_;
                                                let _e1627 = phi_3897_;
                                                phi_4125_ = _e1625;
                                                phi_3896_ = _e1627;
                                            } else {
                                                phi_4125_ = _e991;
                                                phi_3896_ = _e989;
                                            }
                                            let _e1629 = phi_4125_;
                                            let _e1631 = phi_3896_;
                                            continue;
                                            continuing {
                                                phi_3762_ = _e1631;
                                                phi_3752_ = _e1629;
                                                phi_1026_ = _e1006;
                                                phi_4037_ = _e1629;
                                                phi_3895_ = _e1631;
                                                break if !(_e1012);
                                            }
                                        }
                                        let _e1634 = phi_4037_;
                                        let _e1636 = phi_3895_;
                                        phi_3900_ = _e1636;
                                        if _e1636 {
                                            break;
                                        }
                                        phi_4002_ = _e1634;
                                        phi_3904_ = _e1636;
                                        phi_3310_ = _e542;
                                        phi_3311_ = false;
                                        phi_3312_ = _e546;
                                    } else {
                                        if (_e542.member_1 >= _e91) {
                                            phi_2865_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e542.member_1 < _e91) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e558 = ((1u + _e261) % 4u);
                                            if (_e558 < 4u) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e563 = global_4.member[_e542.member_1][_e558];
                                            let _e565 = (_e563 >> bitcast<u32>(11u));
                                            let _e567 = ((1u + _e260) % 4u);
                                            if (_e567 < 4u) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e572 = global_4.member[_e542.member_1][_e567];
                                            let _e574 = (_e572 >> bitcast<u32>(11u));
                                            let _e576 = ((1u + _e262) % 4u);
                                            if (_e576 < 4u) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e581 = global_4.member[_e542.member_1][_e576];
                                            let _e583 = (_e581 >> bitcast<u32>(11u));
                                            let _e606 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.x - _e542.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e607 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.y - _e542.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e608 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.z - _e542.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e610 = select(_e141, _e606, (_e606 > _e141));
                                            let _e612 = select(_e141, _e607, (_e607 > _e141));
                                            let _e614 = select(_e141, _e608, (_e608 > _e141));
                                            let _e639 = bitcast<u32>((f32(bitcast<i32>((_e563 & 1023u))) * _e610));
                                            let _e644 = (bitcast<i32>((_e563 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e647 = bitcast<f32>((_e639 & bitcast<u32>(_e644)));
                                            let _e648 = bitcast<u32>((f32(bitcast<i32>((_e572 & 1023u))) * _e612));
                                            let _e653 = (bitcast<i32>((_e572 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e656 = bitcast<f32>((_e648 & bitcast<u32>(_e653)));
                                            let _e657 = bitcast<u32>((f32(bitcast<i32>((_e581 & 1023u))) * _e614));
                                            let _e662 = (bitcast<i32>((_e581 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e665 = bitcast<f32>((_e657 & bitcast<u32>(_e662)));
                                            let _e669 = bitcast<f32>((_e639 & bitcast<u32>(~(_e644))));
                                            let _e673 = bitcast<f32>((_e648 & bitcast<u32>(~(_e653))));
                                            let _e677 = bitcast<f32>((_e657 & bitcast<u32>(~(_e662))));
                                            let _e678 = bitcast<u32>((f32(bitcast<i32>((_e565 & 1023u))) * _e610));
                                            let _e683 = (bitcast<i32>((_e565 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e686 = bitcast<f32>((_e678 & bitcast<u32>(_e683)));
                                            let _e687 = bitcast<u32>((f32(bitcast<i32>((_e574 & 1023u))) * _e612));
                                            let _e692 = (bitcast<i32>((_e574 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e695 = bitcast<f32>((_e687 & bitcast<u32>(_e692)));
                                            let _e696 = bitcast<u32>((f32(bitcast<i32>((_e583 & 1023u))) * _e614));
                                            let _e701 = (bitcast<i32>((_e583 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e704 = bitcast<f32>((_e696 & bitcast<u32>(_e701)));
                                            let _e708 = bitcast<f32>((_e678 & bitcast<u32>(~(_e683))));
                                            let _e712 = bitcast<f32>((_e687 & bitcast<u32>(~(_e692))));
                                            let _e716 = bitcast<f32>((_e696 & bitcast<u32>(~(_e701))));
                                            let _e746 = global_4.member[_e542.member_1][0u];
                                            let _e750 = global_4.member[_e542.member_1][1u];
                                            let _e754 = global_4.member[_e542.member_1][2u];
                                            let _e758 = global_4.member[_e542.member_1][3u];
                                            let _e770 = (((_e750 >> bitcast<u32>(22i)) | ((_e754 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e758 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e771 = (_e746 & 268435455u);
                                            let _e772 = (_e770 & 268435455u);
                                            let _e775 = ((_e746 >> bitcast<u32>(28u)) & 7u);
                                            let _e783 = ((_e746 >> bitcast<u32>(31i)) | (((_e770 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e784 = (_e775 != 0u);
                                            if (_e775 == 0u) {
                                                phi_2827_ = _e771;
                                            } else {
                                                if (_e775 == 7u) {
                                                    phi_2826_ = 2147483648u;
                                                } else {
                                                    phi_2826_ = ((2147483648u | (_e775 << bitcast<u32>(28u))) | (_e772 & 268435455u));
                                                }
                                                let _e793 = phi_2826_;
                                                phi_2827_ = _e793;
                                            }
                                            let _e795 = phi_2827_;
                                            if _e784 {
                                                let _e796 = (_e775 != 7u);
                                                if _e796 {
                                                    phi_2837_ = (_e772 + _e775);
                                                } else {
                                                    phi_2837_ = u32();
                                                }
                                                let _e799 = phi_2837_;
                                                phi_2839_ = _e799;
                                                phi_2840_ = select(true, false, _e796);
                                            } else {
                                                phi_2839_ = u32();
                                                phi_2840_ = true;
                                            }
                                            let _e802 = phi_2839_;
                                            let _e804 = phi_2840_;
                                            if (_e783 == 0u) {
                                                phi_2861_ = (_e771 + select(0u, 1u, !(_e784)));
                                            } else {
                                                if (_e783 == 7u) {
                                                    phi_2860_ = 2147483648u;
                                                } else {
                                                    phi_2860_ = ((2147483648u | (_e783 << bitcast<u32>(28u))) | (select(_e802, _e772, _e804) & 268435455u));
                                                }
                                                let _e817 = phi_2860_;
                                                phi_2861_ = _e817;
                                            }
                                            let _e819 = phi_2861_;
                                            phi_2865_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e542.member.member.x + _e647), (_e542.member.member.x + _e669), (_e542.member.member_1.x - _e686), (_e542.member.member_1.x - _e708)), vec4<f32>((_e542.member.member.y + _e656), (_e542.member.member.y + _e673), (_e542.member.member_1.y - _e695), (_e542.member.member_1.y - _e712)), vec4<f32>((_e542.member.member.z + _e665), (_e542.member.member.z + _e677), (_e542.member.member_1.z - _e704), (_e542.member.member_1.z - _e716))), type_52(type_29((_e542.member.member + vec4<f32>(_e647, _e656, _e665, 0f)), (_e542.member.member_1 - vec4<f32>(_e686, _e695, _e704, 0f))), _e795), type_52(type_29((_e542.member.member + vec4<f32>(_e669, _e673, _e677, 0f)), (_e542.member.member_1 - vec4<f32>(_e708, _e712, _e716, 0f))), _e819));
                                        }
                                        let _e824 = phi_2865_;
                                        let _e835 = ((_e824.member[0].x - _e333) * _e338);
                                        let _e836 = ((_e824.member[0].y - _e333) * _e338);
                                        let _e837 = ((_e824.member[0].z - _e334) * _e338);
                                        let _e838 = ((_e824.member[0].w - _e334) * _e338);
                                        let _e848 = ((_e824.member[1].x - _e371) * _e376);
                                        let _e849 = ((_e824.member[1].y - _e371) * _e376);
                                        let _e850 = ((_e824.member[1].z - _e372) * _e376);
                                        let _e851 = ((_e824.member[1].w - _e372) * _e376);
                                        let _e861 = ((_e824.member[2].x - _e409) * _e414);
                                        let _e862 = ((_e824.member[2].y - _e409) * _e414);
                                        let _e863 = ((_e824.member[2].z - _e410) * _e414);
                                        let _e864 = ((_e824.member[2].w - _e410) * _e414);
                                        let _e866 = select(_e863, _e861, (_e861 < _e863));
                                        let _e868 = select(_e864, _e862, (_e862 < _e864));
                                        let _e870 = select(_e863, _e861, (_e861 > _e863));
                                        let _e872 = select(_e864, _e862, (_e862 > _e864));
                                        let _e874 = select(_e837, _e835, (_e835 < _e837));
                                        let _e876 = select(_e838, _e836, (_e836 < _e838));
                                        let _e878 = select(_e850, _e848, (_e848 < _e850));
                                        let _e880 = select(_e851, _e849, (_e849 < _e851));
                                        let _e882 = select(_e878, _e874, (_e874 > _e878));
                                        let _e884 = select(_e880, _e876, (_e876 > _e880));
                                        let _e886 = select(_e866, _e882, (_e882 > _e866));
                                        let _e888 = select(_e868, _e884, (_e884 > _e868));
                                        let _e890 = select(_e837, _e835, (_e835 > _e837));
                                        let _e892 = select(_e838, _e836, (_e836 > _e838));
                                        let _e894 = select(_e850, _e848, (_e848 > _e850));
                                        let _e896 = select(_e851, _e849, (_e849 > _e851));
                                        let _e898 = select(_e894, _e890, (_e890 < _e894));
                                        let _e900 = select(_e896, _e892, (_e892 < _e896));
                                        let _e905 = -(_e866);
                                        let _e906 = -(_e868);
                                        let _e913 = (select(_e870, _e898, (_e898 < _e870)) + (select(_e905, _e870, (_e870 > _e905)) * 0.0000019073523f));
                                        let _e914 = (select(_e872, _e900, (_e900 < _e872)) + (select(_e906, _e872, (_e872 > _e906)) * 0.0000019073523f));
                                        let _e916 = select(_e461, _e886, (_e886 > _e461));
                                        let _e918 = select(_e461, _e888, (_e888 > _e461));
                                        let _e923 = (_e916 <= select(_e504, _e913, (_e913 < _e504)));
                                        let _e924 = (_e918 <= select(_e504, _e914, (_e914 < _e504)));
                                        let _e925 = (_e916 <= _e918);
                                        if _e923 {
                                            if _e924 {
                                                if _e925 {
                                                    phi_3210_ = _e824.member_2;
                                                } else {
                                                    phi_3210_ = _e824.member_1;
                                                }
                                                let _e929 = phi_3210_;
                                                let _e951 = (_e546 % 128u);
                                                let _e952 = (_e951 < 128u);
                                                if _e952 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_8[_e951] = _e929.member_1;
                                                if _e952 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_7[_e951] = _e929.member.member.x;
                                                if _e952 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_6[_e951] = _e929.member.member.y;
                                                if _e952 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_5[_e951] = _e929.member.member.z;
                                                if _e952 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_4[_e951] = _e929.member.member_1.x;
                                                if _e952 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_3[_e951] = _e929.member.member_1.y;
                                                if _e952 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_2[_e951] = _e929.member.member_1.z;
                                                if _e952 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_10[_e951] = select(_e918, _e916, (_e916 > _e918));
                                                if _e925 {
                                                    phi_3287_ = _e824.member_1;
                                                } else {
                                                    phi_3287_ = _e824.member_2;
                                                }
                                                let _e965 = phi_3287_;
                                                phi_3288_ = _e965;
                                                phi_3289_ = (_e546 + 1u);
                                            } else {
                                                phi_3288_ = type_52();
                                                phi_3289_ = u32();
                                            }
                                            let _e967 = phi_3288_;
                                            let _e969 = phi_3289_;
                                            phi_3291_ = _e967;
                                            phi_3292_ = _e969;
                                            phi_3293_ = select(true, false, _e924);
                                        } else {
                                            phi_3291_ = type_52();
                                            phi_3292_ = u32();
                                            phi_3293_ = true;
                                        }
                                        let _e972 = phi_3291_;
                                        let _e974 = phi_3292_;
                                        let _e976 = phi_3293_;
                                        if _e976 {
                                            if _e923 {
                                                phi_3302_ = _e824.member_1;
                                            } else {
                                                phi_3302_ = _e824.member_2;
                                            }
                                            let _e980 = phi_3302_;
                                            phi_3307_ = _e980;
                                            phi_3308_ = select(_e924, true, _e923);
                                        } else {
                                            phi_3307_ = _e972;
                                            phi_3308_ = _e544;
                                        }
                                        let _e983 = phi_3307_;
                                        let _e985 = phi_3308_;
                                        phi_4002_ = _e504;
                                        phi_3904_ = _e502;
                                        phi_3310_ = _e983;
                                        phi_3311_ = _e985;
                                        phi_3312_ = select(_e974, _e546, _e976);
                                    }
                                    let _e1638 = phi_4002_;
                                    let _e1640 = phi_3904_;
                                    let _e1642 = phi_3310_;
                                    let _e1644 = phi_3311_;
                                    let _e1646 = phi_3312_;
                                    phi_4001_ = _e1638;
                                    phi_3903_ = _e1640;
                                    phi_3313_ = _e1642;
                                    phi_3314_ = (_e508 - 1u);
                                    phi_3315_ = _e1644;
                                    phi_3316_ = _e1646;
                                } else {
                                    phi_4001_ = _e504;
                                    phi_3903_ = _e502;
                                    phi_3313_ = _e542;
                                    phi_3314_ = _e508;
                                    phi_3315_ = _e544;
                                    phi_3316_ = _e546;
                                }
                                let _e1648 = phi_4001_;
                                let _e1650 = phi_3903_;
                                let _e1652 = phi_3313_;
                                let _e1654 = phi_3314_;
                                let _e1656 = phi_3315_;
                                let _e1658 = phi_3316_;
                                phi_4000_ = _e1648;
                                phi_3902_ = _e1650;
                                phi_3317_ = _e1652;
                                phi_3318_ = _e1654;
                                phi_3319_ = _e1656;
                                phi_3320_ = _e1658;
                            } else {
                                phi_4000_ = _e504;
                                phi_3902_ = _e502;
                                phi_3317_ = type_52();
                                phi_3318_ = u32();
                                phi_3319_ = bool();
                                phi_3320_ = u32();
                            }
                            let _e1660 = phi_4000_;
                            let _e1662 = phi_3902_;
                            let _e1664 = phi_3317_;
                            let _e1666 = phi_3318_;
                            let _e1668 = phi_3319_;
                            let _e1670 = phi_3320_;
                            phi_3999_ = _e1660;
                            phi_3901_ = _e1662;
                            phi_902_ = _e1664;
                            phi_905_ = _e1666;
                            phi_907_ = _e1668;
                            phi_909_ = _e1670;
                            phi_3321_ = _e516;
                        } else {
                            phi_3999_ = _e504;
                            phi_3901_ = _e502;
                            phi_902_ = type_52();
                            phi_905_ = u32();
                            phi_907_ = bool();
                            phi_909_ = u32();
                            phi_3321_ = false;
                        }
                        let _e1672 = phi_3999_;
                        let _e1674 = phi_3901_;
                        let _e1676 = phi_902_;
                        let _e1678 = phi_905_;
                        let _e1680 = phi_907_;
                        let _e1682 = phi_909_;
                        let _e1684 = phi_3321_;
                        continue;
                        continuing {
                            phi_3765_ = _e1674;
                            phi_3693_ = _e1672;
                            phi_901_ = _e1676;
                            phi_904_ = _e1678;
                            phi_906_ = _e1680;
                            phi_908_ = _e1682;
                            phi_3900_ = _e1674;
                            break if !(_e1684);
                        }
                    }
                    let _e1687 = phi_3900_;
                    if _e1687 {
                        break;
                    }
                    phi_3328_ = type_4(0u, 8u);
                    loop {
                        let _e1689 = phi_3328_;
                        if (_e1689.member < _e1689.member_1) {
                            phi_3329_ = type_4((_e1689.member + 1u), _e1689.member_1);
                            phi_3352_ = type_4(1u, _e1689.member);
                        } else {
                            phi_3329_ = _e1689;
                            phi_3352_ = type_4(0u, type_4().member_1);
                        }
                        let _e1702 = phi_3329_;
                        let _e1704 = phi_3352_;
                        let _e1708 = (bitcast<i32>(_e1704.member) != 0i);
                        if _e1708 {
                            let _e1709 = (_e1704.member_1 < 8u);
                            if _e1709 {
                            } else {
                                phi_3992_ = true;
                                break;
                            }
                            let _e1711 = local_9[_e1704.member_1];
                            if (_e1711.member_3 != 4294967295u) {
                                let _e1717 = -(_e428);
                                let _e1718 = (_e1717 / 3i);
                                let _e1725 = bitcast<f32>((bitcast<u32>((_e1718 + 127i)) << bitcast<u32>(23i)));
                                let _e1733 = (((_e1711.member * _e1725) * _e1725) * bitcast<f32>((bitcast<u32>(((_e1717 - (2i * _e1718)) + 127i)) << bitcast<u32>(23i))));
                                let _e1735 = select(340282350000000000000000000000000000000f, _e1733, (_e1733 < 340282350000000000000000000000000000000f));
                                phi_3418_ = type_25(select(-340282350000000000000000000000000000000f, _e1735, (_e1735 > -340282350000000000000000000000000000000f)), _e1711.member_1, _e1711.member_2, _e1711.member_3);
                            } else {
                                phi_3418_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1740 = phi_3418_;
                            if _e1709 {
                            } else {
                                phi_3992_ = true;
                                break;
                            }
                            local_9[_e1704.member_1] = type_25(_e1740.member, _e1740.member_1, _e1740.member_2, _e1740.member_3);
                        }
                        continue;
                        continuing {
                            phi_3328_ = _e1702;
                            phi_3992_ = _e1687;
                            break if !(_e1708);
                        }
                    }
                    let _e1748 = phi_3992_;
                    if _e1748 {
                        break;
                    }
                    let _e1749 = local_9;
                    if _e149 {
                    } else {
                        break;
                    }
                    global_6.member[_e147] = array<type_25, 8>(type_25(_e1749[0].member, _e1749[0].member_1, _e1749[0].member_2, _e1749[0].member_3), type_25(_e1749[1].member, _e1749[1].member_1, _e1749[1].member_2, _e1749[1].member_3), type_25(_e1749[2].member, _e1749[2].member_1, _e1749[2].member_2, _e1749[2].member_3), type_25(_e1749[3].member, _e1749[3].member_1, _e1749[3].member_2, _e1749[3].member_3), type_25(_e1749[4].member, _e1749[4].member_1, _e1749[4].member_2, _e1749[4].member_3), type_25(_e1749[5].member, _e1749[5].member_1, _e1749[5].member_2, _e1749[5].member_3), type_25(_e1749[6].member, _e1749[6].member_1, _e1749[6].member_2, _e1749[6].member_3), type_25(_e1749[7].member, _e1749[7].member_1, _e1749[7].member_2, _e1749[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
