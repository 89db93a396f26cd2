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
    var phi_3767_: bool;
    var phi_3695_: f32;
    var phi_900_: type_52;
    var phi_903_: u32;
    var phi_905_: bool;
    var phi_907_: u32;
    var phi_918_: bool;
    var phi_1005_: type_52;
    var phi_1006_: bool;
    var phi_1007_: u32;
    var phi_2828_: u32;
    var phi_2829_: u32;
    var phi_2839_: u32;
    var phi_2841_: u32;
    var phi_2842_: bool;
    var phi_2862_: u32;
    var phi_2863_: u32;
    var phi_2867_: type_53;
    var phi_3212_: type_52;
    var phi_3289_: type_52;
    var phi_3290_: type_52;
    var phi_3291_: u32;
    var phi_3293_: type_52;
    var phi_3294_: u32;
    var phi_3295_: bool;
    var phi_3304_: type_52;
    var phi_3309_: type_52;
    var phi_3310_: bool;
    var phi_3764_: bool;
    var phi_3754_: f32;
    var phi_1025_: type_4;
    var phi_1026_: type_4;
    var phi_1049_: type_4;
    var phi_1070_: u32;
    var phi_1159_: array<array<f32, 3>, 3>;
    var phi_1277_: bool;
    var phi_1306_: bool;
    var phi_1707_: f32;
    var phi_1708_: f32;
    var phi_1709_: f32;
    var phi_1710_: f32;
    var phi_1711_: vec3<f32>;
    var phi_1712_: vec3<f32>;
    var phi_1713_: vec3<f32>;
    var phi_1714_: vec3<f32>;
    var phi_1745_: bool;
    var phi_1754_: vec3<f32>;
    var phi_1921_: bool;
    var phi_1945_: f32;
    var phi_1946_: f32;
    var phi_1969_: type_25;
    var phi_1971_: type_25;
    var phi_1972_: bool;
    var phi_1976_: type_25;
    var phi_1977_: type_25;
    var phi_1978_: type_25;
    var phi_1979_: bool;
    var phi_1983_: type_25;
    var phi_1984_: bool;
    var phi_1985_: type_25;
    var phi_1986_: bool;
    var phi_1987_: bool;
    var phi_1988_: type_25;
    var phi_1989_: bool;
    var phi_1990_: bool;
    var phi_1998_: type_25;
    var phi_1999_: bool;
    var phi_2003_: type_25;
    var phi_2015_: type_4;
    var phi_2018_: type_25;
    var phi_2016_: type_4;
    var phi_2041_: type_4;
    var phi_2073_: bool;
    var phi_2074_: bool;
    var phi_2095_: type_25;
    var phi_2019_: type_25;
    var phi_3755_: bool;
    var phi_4130_: f32;
    var phi_4129_: f32;
    var phi_3900_: bool;
    var phi_4128_: f32;
    var phi_3899_: bool;
    var phi_4127_: f32;
    var phi_3898_: bool;
    var phi_4039_: f32;
    var phi_3897_: bool;
    var phi_4004_: f32;
    var phi_3906_: bool;
    var phi_3312_: type_52;
    var phi_3313_: bool;
    var phi_3314_: u32;
    var phi_4003_: f32;
    var phi_3905_: bool;
    var phi_3315_: type_52;
    var phi_3316_: u32;
    var phi_3317_: bool;
    var phi_3318_: u32;
    var phi_4002_: f32;
    var phi_3904_: bool;
    var phi_3319_: type_52;
    var phi_3320_: u32;
    var phi_3321_: bool;
    var phi_3322_: u32;
    var phi_4001_: f32;
    var phi_3903_: bool;
    var phi_901_: type_52;
    var phi_904_: u32;
    var phi_906_: bool;
    var phi_908_: u32;
    var phi_3323_: bool;
    var phi_3902_: bool;
    var phi_3330_: type_4;
    var phi_3331_: type_4;
    var phi_3354_: type_4;
    var phi_3420_: type_25;
    var phi_3994_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_4.member));
            let _e92 = arrayLength((&global_2.member));
            let _e100 = global_3.member[0u][0u];
            let _e104 = global_3.member[0u][1u];
            let _e108 = global_3.member[0u][2u];
            let _e112 = global_3.member[0u][3u];
            let _e116 = global_3.member[1u][0u];
            let _e120 = global_3.member[1u][1u];
            let _e124 = global_3.member[1u][2u];
            let _e127 = global_1.member[0u];
            let _e128 = bitcast<i32>(_e127);
            let _e140 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e112) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e100), bitcast<i32>(_e104), bitcast<i32>(_e108));
            local = array<i32, 3>(bitcast<i32>(_e116), bitcast<i32>(_e120), bitcast<i32>(_e124));
            let _e146 = (_e88.x + (_e88.y * 2097152u));
            let _e147 = (_e146 < arrayLength((&global_5.member)));
            if _e147 {
                let _e148 = (_e146 < arrayLength((&global_6.member)));
                if _e148 {
                    if _e147 {
                    } else {
                        break;
                    }
                    let _e156 = global_5.member[_e146].member_2[0u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_5.member[_e146].member_2[1u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_5.member[_e146].member_2[2u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_5.member[_e146].member[0u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_5.member[_e146].member[1u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_5.member[_e146].member[2u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e195 = select(_e165, _e158, (_e165 < _e158));
                    let _e197 = select(_e172, _e195, (_e172 < _e195));
                    let _e199 = select(_e179, _e197, (_e179 < _e197));
                    let _e201 = select(_e186, _e199, (_e186 < _e199));
                    let _e203 = select(_e193, _e201, (_e193 < _e201));
                    let _e207 = global_5.member[_e146].member_1;
                    let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                    let _e216 = global_5.member[_e146].member_3;
                    let _e222 = (((select(_e209, _e203, (_e209 < _e203)) < 2139095040u) && ((bitcast<u32>(_e216) & 2147483647u) <= 2139095040u)) && (_e197 > 0u));
                    if _e222 {
                        let _e225 = (bitcast<u32>(bitcast<f32>(_e197)) & 2147483647u);
                        if (_e225 >= 8388608u) {
                            phi_389_ = (bitcast<i32>((_e225 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_389_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e225)), 32u, (_e225 == 0u))));
                        }
                        let _e239 = phi_389_;
                        phi_390_ = _e239;
                    } else {
                        phi_390_ = 0i;
                    }
                    let _e241 = phi_390_;
                    let _e242 = (_e158 == _e197);
                    if _e242 {
                        phi_400_ = true;
                    } else {
                        phi_400_ = (_e165 == _e197);
                    }
                    let _e245 = phi_400_;
                    let _e246 = select(1u, 0u, _e242);
                    if _e245 {
                        let _e247 = (_e246 + 1u);
                        phi_410_ = _e247;
                        phi_411_ = _e247;
                        phi_413_ = select(true, false, (_e247 == 2u));
                    } else {
                        phi_410_ = u32();
                        phi_411_ = 0u;
                        phi_413_ = true;
                    }
                    let _e251 = phi_410_;
                    let _e253 = phi_411_;
                    let _e255 = phi_413_;
                    if _e255 {
                        phi_418_ = (_e253 + 1u);
                    } else {
                        phi_418_ = 0u;
                    }
                    let _e259 = phi_418_;
                    let _e260 = select(_e251, _e253, _e255);
                    let _e261 = select(_e246, select(2u, _e246, _e245), _e255);
                    if (_e128 < -126i) {
                        phi_430_ = -126i;
                    } else {
                        phi_430_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e266 = phi_430_;
                    let _e271 = bitcast<f32>((bitcast<u32>((_e266 + 127i)) << bitcast<u32>(23i)));
                    let _e277 = bitcast<f32>((bitcast<u32>(((_e128 - _e266) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = -(_e241);
                    if (_e278 < -126i) {
                        phi_450_ = -126i;
                    } else {
                        phi_450_ = select(_e278, 127i, (_e278 > 127i));
                    }
                    let _e283 = phi_450_;
                    let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                    let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                    let _e298 = global_5.member[_e146].member;
                    let _e299 = (_e260 == 0u);
                    if _e299 {
                        phi_468_ = _e298[0];
                    } else {
                        phi_468_ = _e298[1];
                    }
                    let _e303 = phi_468_;
                    let _e304 = (_e260 == 2u);
                    if _e304 {
                        phi_474_ = _e298[2];
                    } else {
                        phi_474_ = _e303;
                    }
                    let _e307 = phi_474_;
                    let _e309 = ((_e307 * _e271) * _e277);
                    let _e310 = global_5.member[_e146].member_2;
                    if _e299 {
                        phi_485_ = _e310[0];
                    } else {
                        phi_485_ = _e310[1];
                    }
                    let _e314 = phi_485_;
                    if _e304 {
                        phi_491_ = _e310[2];
                    } else {
                        phi_491_ = _e314;
                    }
                    let _e317 = phi_491_;
                    let _e319 = ((_e317 * _e288) * _e294);
                    let _e323 = (bitcast<f32>((bitcast<u32>(_e319) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e323 {
                        let _e327 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_514_ = select(0.00000000000011368684f, _e327, (_e327 > 0.00000000000011368684f));
                    } else {
                        phi_514_ = 0f;
                    }
                    let _e331 = phi_514_;
                    let _e332 = (_e309 + _e331);
                    let _e333 = (_e309 - _e331);
                    let _e334 = select(_e319, 0f, _e323);
                    if _e323 {
                        phi_525_ = 38685626000000000000000000f;
                    } else {
                        phi_525_ = (1f / _e319);
                    }
                    let _e337 = phi_525_;
                    let _e338 = (_e259 == 0u);
                    if _e338 {
                        phi_534_ = _e298[0];
                    } else {
                        phi_534_ = _e298[1];
                    }
                    let _e342 = phi_534_;
                    let _e343 = (_e259 == 2u);
                    if _e343 {
                        phi_540_ = _e298[2];
                    } else {
                        phi_540_ = _e342;
                    }
                    let _e346 = phi_540_;
                    let _e348 = ((_e346 * _e271) * _e277);
                    if _e338 {
                        phi_551_ = _e310[0];
                    } else {
                        phi_551_ = _e310[1];
                    }
                    let _e352 = phi_551_;
                    if _e343 {
                        phi_557_ = _e310[2];
                    } else {
                        phi_557_ = _e352;
                    }
                    let _e355 = phi_557_;
                    let _e357 = ((_e355 * _e288) * _e294);
                    let _e361 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e361 {
                        let _e365 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) * 0.00000011920929f);
                        phi_580_ = select(0.00000000000011368684f, _e365, (_e365 > 0.00000000000011368684f));
                    } else {
                        phi_580_ = 0f;
                    }
                    let _e369 = phi_580_;
                    let _e370 = (_e348 + _e369);
                    let _e371 = (_e348 - _e369);
                    let _e372 = select(_e357, 0f, _e361);
                    if _e361 {
                        phi_591_ = 38685626000000000000000000f;
                    } else {
                        phi_591_ = (1f / _e357);
                    }
                    let _e375 = phi_591_;
                    let _e376 = (_e261 == 0u);
                    if _e376 {
                        phi_600_ = _e298[0];
                    } else {
                        phi_600_ = _e298[1];
                    }
                    let _e380 = phi_600_;
                    let _e381 = (_e261 == 2u);
                    if _e381 {
                        phi_606_ = _e298[2];
                    } else {
                        phi_606_ = _e380;
                    }
                    let _e384 = phi_606_;
                    let _e386 = ((_e384 * _e271) * _e277);
                    if _e376 {
                        phi_617_ = _e310[0];
                    } else {
                        phi_617_ = _e310[1];
                    }
                    let _e390 = phi_617_;
                    if _e381 {
                        phi_623_ = _e310[2];
                    } else {
                        phi_623_ = _e390;
                    }
                    let _e393 = phi_623_;
                    let _e395 = ((_e393 * _e288) * _e294);
                    let _e399 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e399 {
                        let _e403 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) * 0.00000011920929f);
                        phi_646_ = select(0.00000000000011368684f, _e403, (_e403 > 0.00000000000011368684f));
                    } else {
                        phi_646_ = 0f;
                    }
                    let _e407 = phi_646_;
                    let _e408 = (_e386 + _e407);
                    let _e409 = (_e386 - _e407);
                    let _e410 = select(_e395, 0f, _e399);
                    if _e399 {
                        phi_657_ = 38685626000000000000000000f;
                    } else {
                        phi_657_ = (1f / _e395);
                    }
                    let _e413 = phi_657_;
                    let _e416 = bitcast<f32>((bitcast<u32>(_e309) & 2147483647u));
                    let _e419 = bitcast<f32>((bitcast<u32>(_e348) & 2147483647u));
                    let _e421 = select(_e419, _e416, (_e416 > _e419));
                    let _e424 = bitcast<f32>((bitcast<u32>(_e386) & 2147483647u));
                    let _e427 = (_e128 + _e241);
                    if (_e222 && (select(_e424, _e421, (_e421 > _e424)) <= 1099511600000f)) {
                        let _e430 = (_e427 / 3i);
                        let _e437 = bitcast<f32>((bitcast<u32>((_e430 + 127i)) << bitcast<u32>(23i)));
                        let _e444 = bitcast<f32>((bitcast<u32>(((_e427 - (2i * _e430)) + 127i)) << bitcast<u32>(23i)));
                        let _e445 = (((_e207 * _e437) * _e437) * _e444);
                        let _e447 = select(340282350000000000000000000000000000000f, _e445, (_e445 < 340282350000000000000000000000000000000f));
                        let _e452 = (((_e216 * _e437) * _e437) * _e444);
                        let _e454 = select(340282350000000000000000000000000000000f, _e452, (_e452 < 340282350000000000000000000000000000000f));
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e454, (_e454 > -340282350000000000000000000000000000000f));
                        phi_758_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_757_ = 0f;
                        phi_758_ = 1f;
                    }
                    let _e458 = phi_757_;
                    let _e460 = phi_758_;
                    local_9 = array<type_25, 8>(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e463 = (_e260 % 3u);
                    let _e464 = (_e463 < 3u);
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e466 = local_1[_e463];
                    let _e469 = (_e259 % 3u);
                    let _e470 = (_e469 < 3u);
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e472 = local_1[_e469];
                    let _e475 = (_e261 % 3u);
                    let _e476 = (_e475 < 3u);
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e478 = local_1[_e475];
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e483 = local[_e463];
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e487 = local[_e469];
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e491 = local[_e475];
                    phi_3767_ = false;
                    phi_3695_ = _e458;
                    phi_900_ = type_52(type_29(vec4<f32>((f32(_e466) * _e140), (f32(_e472) * _e140), (f32(_e478) * _e140), 0f), vec4<f32>((f32(_e483) * _e140), (f32(_e487) * _e140), (f32(_e491) * _e140), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_903_ = ((3u * _e90) + 1u);
                    phi_905_ = (_e460 <= _e458);
                    phi_907_ = 0u;
                    loop {
                        let _e501 = phi_3767_;
                        let _e503 = phi_3695_;
                        let _e505 = phi_900_;
                        let _e507 = phi_903_;
                        let _e509 = phi_905_;
                        let _e511 = phi_907_;
                        if _e509 {
                            phi_918_ = true;
                        } else {
                            phi_918_ = (_e511 > 0u);
                        }
                        let _e514 = phi_918_;
                        if _e514 {
                            let _e515 = (_e507 > 0u);
                            if _e515 {
                                if _e509 {
                                    phi_1005_ = _e505;
                                    phi_1006_ = _e509;
                                    phi_1007_ = _e511;
                                } else {
                                    let _e516 = (_e511 - 1u);
                                    let _e517 = (_e516 % 128u);
                                    let _e518 = (_e517 < 128u);
                                    if _e518 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e520 = local_7[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e522 = local_6[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e524 = local_5[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e526 = local_4[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e528 = local_3[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e530 = local_2[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e535 = local_8[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e538 = local_10[_e517];
                                    phi_1005_ = type_52(type_29(vec4<f32>(_e520, _e522, _e524, 0f), vec4<f32>(_e526, _e528, _e530, 0f)), _e535);
                                    phi_1006_ = (_e538 <= _e503);
                                    phi_1007_ = _e516;
                                }
                                let _e541 = phi_1005_;
                                let _e543 = phi_1006_;
                                let _e545 = phi_1007_;
                                if _e543 {
                                    if ((_e541.member_1 & 2147483648u) != 0u) {
                                        phi_3764_ = _e501;
                                        phi_3754_ = _e503;
                                        phi_1025_ = type_4(0u, ((_e541.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e988 = phi_3764_;
                                            let _e990 = phi_3754_;
                                            let _e992 = phi_1025_;
                                            if (_e992.member < _e992.member_1) {
                                                phi_1026_ = type_4((_e992.member + 1u), _e992.member_1);
                                                phi_1049_ = type_4(1u, _e992.member);
                                            } else {
                                                phi_1026_ = _e992;
                                                phi_1049_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1005 = phi_1026_;
                                            let _e1007 = phi_1049_;
                                            let _e1011 = (bitcast<i32>(_e1007.member) != 0i);
                                            if _e1011 {
                                                let _e1012 = ((_e541.member_1 & 268435455u) + _e1007.member_1);
                                                let _e1013 = (_e1012 < _e92);
                                                if _e1013 {
                                                    if _e1013 {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1017 = global_2.member[_e1012].member_1;
                                                    phi_1070_ = _e1017;
                                                } else {
                                                    phi_1070_ = 4294967295u;
                                                }
                                                let _e1019 = phi_1070_;
                                                if (_e1012 >= _e92) {
                                                    phi_1159_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1013 {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    if (_e463 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1026 = global_2.member[_e1012].member[_e463];
                                                    if (_e469 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1032 = global_2.member[_e1012].member[_e469];
                                                    if (_e475 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1038 = global_2.member[_e1012].member[_e475];
                                                    let _e1040 = (3u + _e463);
                                                    if (_e1040 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1046 = global_2.member[_e1012].member[_e1040];
                                                    let _e1047 = (3u + _e469);
                                                    if (_e1047 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1053 = global_2.member[_e1012].member[_e1047];
                                                    let _e1054 = (3u + _e475);
                                                    if (_e1054 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1060 = global_2.member[_e1012].member[_e1054];
                                                    let _e1062 = (6u + _e463);
                                                    if (_e1062 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1068 = global_2.member[_e1012].member[_e1062];
                                                    let _e1069 = (6u + _e469);
                                                    if (_e1069 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1075 = global_2.member[_e1012].member[_e1069];
                                                    let _e1076 = (6u + _e475);
                                                    if (_e1076 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1082 = global_2.member[_e1012].member[_e1076];
                                                    phi_1159_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1026, _e1032, _e1038), array<f32, 3>(_e1046, _e1053, _e1060), array<f32, 3>(_e1068, _e1075, _e1082));
                                                }
                                                let _e1086 = phi_1159_;
                                                let _e1093 = (_e1086[0][2] - _e386);
                                                let _e1096 = (((_e1086[0][0] - _e309) * _e410) - (_e1093 * _e334));
                                                let _e1099 = (((_e1086[0][1] - _e348) * _e410) - (_e1093 * _e372));
                                                let _e1106 = (_e1086[1][2] - _e386);
                                                let _e1109 = (((_e1086[1][0] - _e309) * _e410) - (_e1106 * _e334));
                                                let _e1112 = (((_e1086[1][1] - _e348) * _e410) - (_e1106 * _e372));
                                                let _e1119 = (_e1086[2][2] - _e386);
                                                let _e1122 = (((_e1086[2][0] - _e309) * _e410) - (_e1119 * _e334));
                                                let _e1125 = (((_e1086[2][1] - _e348) * _e410) - (_e1119 * _e372));
                                                let _e1126 = (_e1122 * _e1112);
                                                let _e1127 = (_e1125 * _e1109);
                                                let _e1128 = (_e1096 * _e1125);
                                                let _e1129 = (_e1099 * _e1122);
                                                let _e1130 = (_e1109 * _e1099);
                                                let _e1131 = (_e1112 * _e1096);
                                                let _e1136 = (((_e1126 >= _e1127) && (_e1128 >= _e1129)) && (_e1130 >= _e1131));
                                                if (_e1136 || (((_e1126 <= _e1127) && (_e1128 <= _e1129)) && (_e1130 <= _e1131))) {
                                                    let _e1143 = select(-1f, 1f, _e1136);
                                                    let _e1145 = ((_e1126 - _e1127) * _e1143);
                                                    let _e1147 = select(0f, _e1145, (_e1145 > 0f));
                                                    let _e1149 = ((_e1128 - _e1129) * _e1143);
                                                    let _e1151 = select(0f, _e1149, (_e1149 > 0f));
                                                    let _e1153 = ((_e1130 - _e1131) * _e1143);
                                                    let _e1155 = select(0f, _e1153, (_e1153 > 0f));
                                                    let _e1157 = ((_e1147 + _e1151) + _e1155);
                                                    if (_e1157 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1988_ = type_25();
                                                        phi_1989_ = true;
                                                        phi_1990_ = false;
                                                    } else {
                                                        let _e1160 = select(_e1109, _e1096, (_e1096 < _e1109));
                                                        if (select(_e1122, _e1160, (_e1160 < _e1122)) > 0f) {
                                                            phi_1277_ = true;
                                                        } else {
                                                            let _e1165 = select(_e1109, _e1096, (_e1096 > _e1109));
                                                            phi_1277_ = (select(_e1122, _e1165, (_e1165 > _e1122)) < 0f);
                                                        }
                                                        let _e1170 = phi_1277_;
                                                        if _e1170 {
                                                            phi_1985_ = type_25();
                                                            phi_1986_ = true;
                                                            phi_1987_ = false;
                                                        } else {
                                                            let _e1172 = select(_e1112, _e1099, (_e1099 < _e1112));
                                                            if (select(_e1125, _e1172, (_e1172 < _e1125)) > 0f) {
                                                                phi_1306_ = true;
                                                            } else {
                                                                let _e1177 = select(_e1112, _e1099, (_e1099 > _e1112));
                                                                phi_1306_ = (select(_e1125, _e1177, (_e1177 > _e1125)) < 0f);
                                                            }
                                                            let _e1182 = phi_1306_;
                                                            if _e1182 {
                                                                phi_1983_ = type_25();
                                                                phi_1984_ = false;
                                                            } else {
                                                                let _e1184 = select(_e1086[1][0], _e1086[0][0], (_e1086[0][0] < _e1086[1][0]));
                                                                let _e1188 = select(_e1086[1][0], _e1086[0][0], (_e1086[0][0] > _e1086[1][0]));
                                                                let _e1192 = select(_e1086[1][1], _e1086[0][1], (_e1086[0][1] < _e1086[1][1]));
                                                                let _e1196 = select(_e1086[1][1], _e1086[0][1], (_e1086[0][1] > _e1086[1][1]));
                                                                let _e1200 = select(_e1086[1][2], _e1086[0][2], (_e1086[0][2] < _e1086[1][2]));
                                                                let _e1204 = select(_e1086[1][2], _e1086[0][2], (_e1086[0][2] > _e1086[1][2]));
                                                                let _e1209 = ((select(_e1086[2][0], _e1184, (_e1184 < _e1086[2][0])) - _e332) * _e337);
                                                                let _e1210 = ((select(_e1086[2][0], _e1188, (_e1188 > _e1086[2][0])) - _e333) * _e337);
                                                                let _e1213 = ((select(_e1086[2][1], _e1192, (_e1192 < _e1086[2][1])) - _e370) * _e375);
                                                                let _e1214 = ((select(_e1086[2][1], _e1196, (_e1196 > _e1086[2][1])) - _e371) * _e375);
                                                                let _e1217 = ((select(_e1086[2][2], _e1200, (_e1200 < _e1086[2][2])) - _e408) * _e413);
                                                                let _e1218 = ((select(_e1086[2][2], _e1204, (_e1204 > _e1086[2][2])) - _e409) * _e413);
                                                                let _e1220 = select(_e1218, _e1217, (_e1217 < _e1218));
                                                                let _e1222 = select(_e1218, _e1217, (_e1217 > _e1218));
                                                                let _e1224 = select(_e1210, _e1209, (_e1209 < _e1210));
                                                                let _e1226 = select(_e1214, _e1213, (_e1213 < _e1214));
                                                                let _e1228 = select(_e1226, _e1224, (_e1224 > _e1226));
                                                                let _e1230 = select(_e1220, _e1228, (_e1228 > _e1220));
                                                                let _e1232 = select(_e1210, _e1209, (_e1209 > _e1210));
                                                                let _e1234 = select(_e1214, _e1213, (_e1213 > _e1214));
                                                                let _e1236 = select(_e1234, _e1232, (_e1232 < _e1234));
                                                                let _e1238 = select(_e1222, _e1236, (_e1236 < _e1222));
                                                                let _e1239 = -(_e1220);
                                                                let _e1245 = select(_e460, _e1230, (_e1230 > _e460));
                                                                if (_e1245 > (_e1238 + (select(_e1239, _e1222, (_e1222 > _e1239)) * 0.0000019073523f))) {
                                                                    phi_1978_ = type_25();
                                                                    phi_1979_ = true;
                                                                } else {
                                                                    let _e1247 = (_e1245 > _e990);
                                                                    if _e1247 {
                                                                        phi_1977_ = type_25();
                                                                    } else {
                                                                        let _e1248 = vec3<f32>(_e1086[0][0], _e1086[0][1], _e1086[0][2]);
                                                                        let _e1249 = vec3<f32>(_e1086[1][0], _e1086[1][1], _e1086[1][2]);
                                                                        let _e1250 = vec3<f32>(_e1086[2][0], _e1086[2][1], _e1086[2][2]);
                                                                        let _e1251 = (_e1086[1][0] - _e1086[0][0]);
                                                                        let _e1252 = (_e1086[1][1] - _e1086[0][1]);
                                                                        let _e1253 = (_e1086[1][2] - _e1086[0][2]);
                                                                        let _e1254 = vec3<f32>(_e1251, _e1252, _e1253);
                                                                        let _e1255 = (_e1086[2][0] - _e1086[1][0]);
                                                                        let _e1256 = (_e1086[2][1] - _e1086[1][1]);
                                                                        let _e1257 = (_e1086[2][2] - _e1086[1][2]);
                                                                        let _e1258 = vec3<f32>(_e1255, _e1256, _e1257);
                                                                        let _e1259 = (_e1086[0][0] - _e1086[2][0]);
                                                                        let _e1260 = (_e1086[0][1] - _e1086[2][1]);
                                                                        let _e1261 = (_e1086[0][2] - _e1086[2][2]);
                                                                        let _e1262 = vec3<f32>(_e1259, _e1260, _e1261);
                                                                        let _e1265 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                                        let _e1268 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
                                                                        let _e1270 = select(_e1268, _e1265, (_e1265 > _e1268));
                                                                        let _e1273 = bitcast<f32>((bitcast<u32>(_e1253) & 2147483647u));
                                                                        let _e1275 = select(_e1273, _e1270, (_e1270 > _e1273));
                                                                        let _e1278 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
                                                                        let _e1281 = bitcast<f32>((bitcast<u32>(_e1256) & 2147483647u));
                                                                        let _e1283 = select(_e1281, _e1278, (_e1278 > _e1281));
                                                                        let _e1286 = bitcast<f32>((bitcast<u32>(_e1257) & 2147483647u));
                                                                        let _e1288 = select(_e1286, _e1283, (_e1283 > _e1286));
                                                                        let _e1291 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                                        let _e1294 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                        let _e1296 = select(_e1294, _e1291, (_e1291 > _e1294));
                                                                        let _e1299 = bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u));
                                                                        let _e1301 = select(_e1299, _e1296, (_e1296 > _e1299));
                                                                        let _e1303 = select(_e1288, _e1275, (_e1275 > _e1288));
                                                                        let _e1305 = select(_e1301, _e1303, (_e1303 > _e1301));
                                                                        if (_e1275 == _e1305) {
                                                                            phi_1707_ = _e1112;
                                                                            phi_1708_ = _e1109;
                                                                            phi_1709_ = _e1099;
                                                                            phi_1710_ = _e1096;
                                                                            phi_1711_ = _e1248;
                                                                            phi_1712_ = _e1262;
                                                                            phi_1713_ = _e1258;
                                                                            phi_1714_ = _e1254;
                                                                        } else {
                                                                            let _e1307 = (_e1288 == _e1305);
                                                                            let _e1312 = vec3(_e1307);
                                                                            phi_1707_ = select(_e1099, _e1125, _e1307);
                                                                            phi_1708_ = select(_e1096, _e1122, _e1307);
                                                                            phi_1709_ = select(_e1125, _e1112, _e1307);
                                                                            phi_1710_ = select(_e1122, _e1109, _e1307);
                                                                            phi_1711_ = select(_e1250, _e1249, _e1312);
                                                                            phi_1712_ = select(_e1258, _e1254, _e1312);
                                                                            phi_1713_ = select(_e1254, _e1262, _e1312);
                                                                            phi_1714_ = select(_e1262, _e1258, _e1312);
                                                                        }
                                                                        let _e1318 = phi_1707_;
                                                                        let _e1320 = phi_1708_;
                                                                        let _e1322 = phi_1709_;
                                                                        let _e1324 = phi_1710_;
                                                                        let _e1326 = phi_1711_;
                                                                        let _e1328 = phi_1712_;
                                                                        let _e1330 = phi_1713_;
                                                                        let _e1332 = phi_1714_;
                                                                        let _e1339 = ((_e1330.y * _e1328.z) - (_e1328.y * _e1330.z));
                                                                        let _e1344 = ((_e1330.z * _e1328.x) - (_e1328.z * _e1330.x));
                                                                        let _e1347 = ((_e1330.x * _e1328.y) - (_e1328.x * _e1330.y));
                                                                        if (_e1147 >= _e1151) {
                                                                            phi_1745_ = select(true, false, (_e1147 >= _e1155));
                                                                        } else {
                                                                            phi_1745_ = true;
                                                                        }
                                                                        let _e1352 = phi_1745_;
                                                                        if _e1352 {
                                                                            phi_1754_ = select(_e1250, _e1249, vec3((_e1151 >= _e1155)));
                                                                        } else {
                                                                            phi_1754_ = _e1248;
                                                                        }
                                                                        let _e1357 = phi_1754_;
                                                                        let _e1362 = (((_e1339 * _e334) + (_e1344 * _e372)) + (_e1347 * _e410));
                                                                        let _e1373 = (((_e1339 * (_e1357.x - _e309)) + (_e1344 * (_e1357.y - _e348))) + (_e1347 * (_e1357.z - _e386)));
                                                                        let _e1375 = (_e1320 - _e1324);
                                                                        let _e1376 = (_e1318 - _e1322);
                                                                        let _e1384 = (-(((_e1324 * _e1375) + (_e1322 * _e1376))) / ((_e1375 * _e1375) + (_e1376 * _e1376)));
                                                                        let _e1386 = select(1f, _e1384, (_e1384 < 1f));
                                                                        let _e1388 = select(0f, _e1386, (_e1386 > 0f));
                                                                        let _e1401 = ((_e1326.x + (_e1332.x * _e1388)) - _e309);
                                                                        let _e1402 = ((_e1326.y + (_e1332.y * _e1388)) - _e348);
                                                                        let _e1403 = ((_e1326.z + (_e1332.z * _e1388)) - _e386);
                                                                        let _e1404 = (_e1403 / _e410);
                                                                        let _e1416 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                                        let _e1419 = bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u));
                                                                        let _e1421 = select(_e1419, _e1416, (_e1416 > _e1419));
                                                                        let _e1424 = bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u));
                                                                        let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                                        let _e1432 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                        let _e1435 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                        let _e1437 = select(_e1435, _e1432, (_e1432 > _e1435));
                                                                        let _e1440 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1339 * _e1401) + (_e1344 * _e1402)) + (_e1347 * _e1403)) - _e1373)) & 2147483647u)) <= ((0.0000009536743f * select(_e1305, _e1426, (_e1426 > _e1305))) * select(_e1440, _e1437, (_e1437 > _e1440)))) {
                                                                            let _e1450 = bitcast<f32>((bitcast<u32>(_e1330.x) & 2147483647u));
                                                                            let _e1453 = bitcast<f32>((bitcast<u32>(_e1330.y) & 2147483647u));
                                                                            let _e1455 = select(_e1453, _e1450, (_e1450 > _e1453));
                                                                            let _e1458 = bitcast<f32>((bitcast<u32>(_e1330.z) & 2147483647u));
                                                                            let _e1464 = bitcast<f32>((bitcast<u32>(_e1328.x) & 2147483647u));
                                                                            let _e1467 = bitcast<f32>((bitcast<u32>(_e1328.y) & 2147483647u));
                                                                            let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                                                            let _e1472 = bitcast<f32>((bitcast<u32>(_e1328.z) & 2147483647u));
                                                                            phi_1921_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u)) > ((0.0000038146973f * select(_e1458, _e1455, (_e1455 > _e1458))) * select(_e1472, _e1469, (_e1469 > _e1472)))));
                                                                        } else {
                                                                            phi_1921_ = true;
                                                                        }
                                                                        let _e1479 = phi_1921_;
                                                                        if _e1479 {
                                                                            let _e1490 = ((((_e1339 * (_e1401 - (_e334 * _e1404))) + (_e1344 * (_e1402 - (_e372 * _e1404)))) + (_e1347 * (_e1403 - _e1403))) / _e1362);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u)) <= _e1305) {
                                                                                phi_1945_ = (_e1404 + _e1490);
                                                                            } else {
                                                                                phi_1945_ = _e1404;
                                                                            }
                                                                            let _e1497 = phi_1945_;
                                                                            phi_1946_ = _e1497;
                                                                        } else {
                                                                            phi_1946_ = (_e1373 / _e1362);
                                                                        }
                                                                        let _e1499 = phi_1946_;
                                                                        let _e1501 = select(_e1238, _e1499, (_e1499 < _e1238));
                                                                        let _e1503 = select(_e1230, _e1501, (_e1501 > _e1230));
                                                                        if (_e1503 >= _e460) {
                                                                            let _e1505 = (_e1503 <= _e990);
                                                                            if _e1505 {
                                                                                let _e1506 = (1f / _e1157);
                                                                                phi_1969_ = type_25(_e1503, (_e1151 * _e1506), (_e1155 * _e1506), _e1019);
                                                                            } else {
                                                                                phi_1969_ = type_25();
                                                                            }
                                                                            let _e1511 = phi_1969_;
                                                                            phi_1971_ = _e1511;
                                                                            phi_1972_ = select(true, false, _e1505);
                                                                        } else {
                                                                            phi_1971_ = type_25();
                                                                            phi_1972_ = true;
                                                                        }
                                                                        let _e1514 = phi_1971_;
                                                                        let _e1516 = phi_1972_;
                                                                        if _e1516 {
                                                                            phi_1976_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1976_ = _e1514;
                                                                        }
                                                                        let _e1518 = phi_1976_;
                                                                        phi_1977_ = _e1518;
                                                                    }
                                                                    let _e1520 = phi_1977_;
                                                                    phi_1978_ = _e1520;
                                                                    phi_1979_ = _e1247;
                                                                }
                                                                let _e1522 = phi_1978_;
                                                                let _e1524 = phi_1979_;
                                                                phi_1983_ = _e1522;
                                                                phi_1984_ = _e1524;
                                                            }
                                                            let _e1526 = phi_1983_;
                                                            let _e1528 = phi_1984_;
                                                            phi_1985_ = _e1526;
                                                            phi_1986_ = _e1182;
                                                            phi_1987_ = _e1528;
                                                        }
                                                        let _e1530 = phi_1985_;
                                                        let _e1532 = phi_1986_;
                                                        let _e1534 = phi_1987_;
                                                        phi_1988_ = _e1530;
                                                        phi_1989_ = _e1532;
                                                        phi_1990_ = _e1534;
                                                    }
                                                    let _e1536 = phi_1988_;
                                                    let _e1538 = phi_1989_;
                                                    let _e1540 = phi_1990_;
                                                    phi_1998_ = _e1536;
                                                    phi_1999_ = select(_e1540, true, _e1538);
                                                } else {
                                                    phi_1998_ = type_25();
                                                    phi_1999_ = true;
                                                }
                                                let _e1543 = phi_1998_;
                                                let _e1545 = phi_1999_;
                                                if _e1545 {
                                                    phi_2003_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2003_ = _e1543;
                                                }
                                                let _e1547 = phi_2003_;
                                                if (_e1547.member_3 != 4294967295u) {
                                                    if (_e1019 != 4294967295u) {
                                                        phi_2015_ = type_4(0u, 8u);
                                                        phi_2018_ = _e1547;
                                                        loop {
                                                            let _e1552 = phi_2015_;
                                                            let _e1554 = phi_2018_;
                                                            if (_e1552.member < _e1552.member_1) {
                                                                phi_2016_ = type_4((_e1552.member + 1u), _e1552.member_1);
                                                                phi_2041_ = type_4(1u, _e1552.member);
                                                            } else {
                                                                phi_2016_ = _e1552;
                                                                phi_2041_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1567 = phi_2016_;
                                                            let _e1569 = phi_2041_;
                                                            let _e1573 = (bitcast<i32>(_e1569.member) != 0i);
                                                            if _e1573 {
                                                                let _e1574 = (_e1569.member_1 < 8u);
                                                                if _e1574 {
                                                                } else {
                                                                    phi_3755_ = true;
                                                                    break;
                                                                }
                                                                let _e1579 = local_9[_e1569.member_1].member;
                                                                if (_e1554.member < _e1579) {
                                                                    phi_2074_ = true;
                                                                } else {
                                                                    let _e1581 = local_9[_e1569.member_1].member;
                                                                    if (_e1554.member == _e1581) {
                                                                        let _e1586 = local_9[_e1569.member_1].member_3;
                                                                        phi_2073_ = (_e1554.member_3 < _e1586);
                                                                    } else {
                                                                        phi_2073_ = false;
                                                                    }
                                                                    let _e1589 = phi_2073_;
                                                                    phi_2074_ = _e1589;
                                                                }
                                                                let _e1591 = phi_2074_;
                                                                if _e1591 {
                                                                    if _e1574 {
                                                                    } else {
                                                                        phi_3755_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1592 = local_9[_e1569.member_1];
                                                                    local_9[_e1569.member_1] = type_25(_e1554.member, _e1554.member_1, _e1554.member_2, _e1554.member_3);
                                                                    phi_2095_ = type_25(_e1592.member, _e1592.member_1, _e1592.member_2, _e1592.member_3);
                                                                } else {
                                                                    phi_2095_ = _e1554;
                                                                }
                                                                let _e1603 = phi_2095_;
                                                                phi_2019_ = _e1603;
                                                            } else {
                                                                phi_2019_ = type_25();
                                                            }
                                                            let _e1605 = phi_2019_;
                                                            continue;
                                                            continuing {
                                                                phi_2015_ = _e1567;
                                                                phi_2018_ = _e1605;
                                                                phi_3755_ = _e988;
                                                                break if !(_e1573);
                                                            }
                                                        }
                                                        let _e1608 = phi_3755_;
                                                        phi_4039_ = _e990;
                                                        phi_3897_ = _e1608;
                                                        if _e1608 {
                                                            break;
                                                        }
                                                        let _e1611 = local_9[7u].member_3;
                                                        if (_e1611 != 4294967295u) {
                                                            let _e1615 = local_9[7u].member;
                                                            phi_4130_ = _e1615;
                                                        } else {
                                                            phi_4130_ = _e990;
                                                        }
                                                        let _e1617 = phi_4130_;
                                                        phi_4129_ = _e1617;
                                                        phi_3900_ = _e1608;
                                                    } else {
                                                        phi_4129_ = _e990;
                                                        phi_3900_ = _e988;
                                                    }
                                                    let _e1619 = phi_4129_;
                                                    let _e1621 = phi_3900_;
                                                    phi_4128_ = _e1619;
                                                    phi_3899_ = _e1621;
                                                } else {
                                                    phi_4128_ = _e990;
                                                    phi_3899_ = _e988;
                                                }
                                                let _e1623 = phi_4128_;
                                                let _e1625 = phi_3899_;
                                                phi_4127_ = _e1623;
                                                phi_3898_ = _e1625;
                                            } else {
                                                phi_4127_ = _e990;
                                                phi_3898_ = _e988;
                                            }
                                            let _e1627 = phi_4127_;
                                            let _e1629 = phi_3898_;
                                            continue;
                                            continuing {
                                                phi_3764_ = _e1629;
                                                phi_3754_ = _e1627;
                                                phi_1025_ = _e1005;
                                                phi_4039_ = _e1627;
                                                phi_3897_ = _e1629;
                                                break if !(_e1011);
                                            }
                                        }
                                        let _e1632 = phi_4039_;
                                        let _e1634 = phi_3897_;
                                        phi_3902_ = _e1634;
                                        if _e1634 {
                                            break;
                                        }
                                        phi_4004_ = _e1632;
                                        phi_3906_ = _e1634;
                                        phi_3312_ = _e541;
                                        phi_3313_ = false;
                                        phi_3314_ = _e545;
                                    } else {
                                        if (_e541.member_1 >= _e90) {
                                            phi_2867_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e541.member_1 < _e90) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e557 = ((1u + _e260) % 4u);
                                            if (_e557 < 4u) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e562 = global_4.member[_e541.member_1][_e557];
                                            let _e564 = (_e562 >> bitcast<u32>(11u));
                                            let _e566 = ((1u + _e259) % 4u);
                                            if (_e566 < 4u) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e571 = global_4.member[_e541.member_1][_e566];
                                            let _e573 = (_e571 >> bitcast<u32>(11u));
                                            let _e575 = ((1u + _e261) % 4u);
                                            if (_e575 < 4u) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e580 = global_4.member[_e541.member_1][_e575];
                                            let _e582 = (_e580 >> bitcast<u32>(11u));
                                            let _e605 = (bitcast<f32>((bitcast<u32>((_e541.member.member_1.x - _e541.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e606 = (bitcast<f32>((bitcast<u32>((_e541.member.member_1.y - _e541.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e607 = (bitcast<f32>((bitcast<u32>((_e541.member.member_1.z - _e541.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e609 = select(_e140, _e605, (_e605 > _e140));
                                            let _e611 = select(_e140, _e606, (_e606 > _e140));
                                            let _e613 = select(_e140, _e607, (_e607 > _e140));
                                            let _e638 = bitcast<u32>((f32(bitcast<i32>((_e562 & 1023u))) * _e609));
                                            let _e643 = (bitcast<i32>((_e562 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e646 = bitcast<f32>((_e638 & bitcast<u32>(_e643)));
                                            let _e647 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e611));
                                            let _e652 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e655 = bitcast<f32>((_e647 & bitcast<u32>(_e652)));
                                            let _e656 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e613));
                                            let _e661 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e664 = bitcast<f32>((_e656 & bitcast<u32>(_e661)));
                                            let _e668 = bitcast<f32>((_e638 & bitcast<u32>(~(_e643))));
                                            let _e672 = bitcast<f32>((_e647 & bitcast<u32>(~(_e652))));
                                            let _e676 = bitcast<f32>((_e656 & bitcast<u32>(~(_e661))));
                                            let _e677 = bitcast<u32>((f32(bitcast<i32>((_e564 & 1023u))) * _e609));
                                            let _e682 = (bitcast<i32>((_e564 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                            let _e686 = bitcast<u32>((f32(bitcast<i32>((_e573 & 1023u))) * _e611));
                                            let _e691 = (bitcast<i32>((_e573 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e694 = bitcast<f32>((_e686 & bitcast<u32>(_e691)));
                                            let _e695 = bitcast<u32>((f32(bitcast<i32>((_e582 & 1023u))) * _e613));
                                            let _e700 = (bitcast<i32>((_e582 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e703 = bitcast<f32>((_e695 & bitcast<u32>(_e700)));
                                            let _e707 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                            let _e711 = bitcast<f32>((_e686 & bitcast<u32>(~(_e691))));
                                            let _e715 = bitcast<f32>((_e695 & bitcast<u32>(~(_e700))));
                                            let _e745 = global_4.member[_e541.member_1][0u];
                                            let _e749 = global_4.member[_e541.member_1][1u];
                                            let _e753 = global_4.member[_e541.member_1][2u];
                                            let _e757 = global_4.member[_e541.member_1][3u];
                                            let _e769 = (((_e749 >> bitcast<u32>(22i)) | ((_e753 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e757 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e770 = (_e745 & 268435455u);
                                            let _e771 = (_e769 & 268435455u);
                                            let _e774 = ((_e745 >> bitcast<u32>(28u)) & 7u);
                                            let _e782 = ((_e745 >> bitcast<u32>(31i)) | (((_e769 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e783 = (_e774 != 0u);
                                            if (_e774 == 0u) {
                                                phi_2829_ = _e770;
                                            } else {
                                                if (_e774 == 7u) {
                                                    phi_2828_ = 2147483648u;
                                                } else {
                                                    phi_2828_ = ((2147483648u | (_e774 << bitcast<u32>(28u))) | (_e771 & 268435455u));
                                                }
                                                let _e792 = phi_2828_;
                                                phi_2829_ = _e792;
                                            }
                                            let _e794 = phi_2829_;
                                            if _e783 {
                                                let _e795 = (_e774 != 7u);
                                                if _e795 {
                                                    phi_2839_ = (_e771 + _e774);
                                                } else {
                                                    phi_2839_ = u32();
                                                }
                                                let _e798 = phi_2839_;
                                                phi_2841_ = _e798;
                                                phi_2842_ = select(true, false, _e795);
                                            } else {
                                                phi_2841_ = u32();
                                                phi_2842_ = true;
                                            }
                                            let _e801 = phi_2841_;
                                            let _e803 = phi_2842_;
                                            if (_e782 == 0u) {
                                                phi_2863_ = (_e770 + select(0u, 1u, !(_e783)));
                                            } else {
                                                if (_e782 == 7u) {
                                                    phi_2862_ = 2147483648u;
                                                } else {
                                                    phi_2862_ = ((2147483648u | (_e782 << bitcast<u32>(28u))) | (select(_e801, _e771, _e803) & 268435455u));
                                                }
                                                let _e816 = phi_2862_;
                                                phi_2863_ = _e816;
                                            }
                                            let _e818 = phi_2863_;
                                            phi_2867_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e541.member.member.x + _e646), (_e541.member.member.x + _e668), (_e541.member.member_1.x - _e685), (_e541.member.member_1.x - _e707)), vec4<f32>((_e541.member.member.y + _e655), (_e541.member.member.y + _e672), (_e541.member.member_1.y - _e694), (_e541.member.member_1.y - _e711)), vec4<f32>((_e541.member.member.z + _e664), (_e541.member.member.z + _e676), (_e541.member.member_1.z - _e703), (_e541.member.member_1.z - _e715))), type_52(type_29((_e541.member.member + vec4<f32>(_e646, _e655, _e664, 0f)), (_e541.member.member_1 - vec4<f32>(_e685, _e694, _e703, 0f))), _e794), type_52(type_29((_e541.member.member + vec4<f32>(_e668, _e672, _e676, 0f)), (_e541.member.member_1 - vec4<f32>(_e707, _e711, _e715, 0f))), _e818));
                                        }
                                        let _e823 = phi_2867_;
                                        let _e834 = ((_e823.member[0].x - _e332) * _e337);
                                        let _e835 = ((_e823.member[0].y - _e332) * _e337);
                                        let _e836 = ((_e823.member[0].z - _e333) * _e337);
                                        let _e837 = ((_e823.member[0].w - _e333) * _e337);
                                        let _e847 = ((_e823.member[1].x - _e370) * _e375);
                                        let _e848 = ((_e823.member[1].y - _e370) * _e375);
                                        let _e849 = ((_e823.member[1].z - _e371) * _e375);
                                        let _e850 = ((_e823.member[1].w - _e371) * _e375);
                                        let _e860 = ((_e823.member[2].x - _e408) * _e413);
                                        let _e861 = ((_e823.member[2].y - _e408) * _e413);
                                        let _e862 = ((_e823.member[2].z - _e409) * _e413);
                                        let _e863 = ((_e823.member[2].w - _e409) * _e413);
                                        let _e865 = select(_e862, _e860, (_e860 < _e862));
                                        let _e867 = select(_e863, _e861, (_e861 < _e863));
                                        let _e869 = select(_e862, _e860, (_e860 > _e862));
                                        let _e871 = select(_e863, _e861, (_e861 > _e863));
                                        let _e873 = select(_e836, _e834, (_e834 < _e836));
                                        let _e875 = select(_e837, _e835, (_e835 < _e837));
                                        let _e877 = select(_e849, _e847, (_e847 < _e849));
                                        let _e879 = select(_e850, _e848, (_e848 < _e850));
                                        let _e881 = select(_e877, _e873, (_e873 > _e877));
                                        let _e883 = select(_e879, _e875, (_e875 > _e879));
                                        let _e885 = select(_e865, _e881, (_e881 > _e865));
                                        let _e887 = select(_e867, _e883, (_e883 > _e867));
                                        let _e889 = select(_e836, _e834, (_e834 > _e836));
                                        let _e891 = select(_e837, _e835, (_e835 > _e837));
                                        let _e893 = select(_e849, _e847, (_e847 > _e849));
                                        let _e895 = select(_e850, _e848, (_e848 > _e850));
                                        let _e897 = select(_e893, _e889, (_e889 < _e893));
                                        let _e899 = select(_e895, _e891, (_e891 < _e895));
                                        let _e904 = -(_e865);
                                        let _e905 = -(_e867);
                                        let _e912 = (select(_e869, _e897, (_e897 < _e869)) + (select(_e904, _e869, (_e869 > _e904)) * 0.0000019073523f));
                                        let _e913 = (select(_e871, _e899, (_e899 < _e871)) + (select(_e905, _e871, (_e871 > _e905)) * 0.0000019073523f));
                                        let _e915 = select(_e460, _e885, (_e885 > _e460));
                                        let _e917 = select(_e460, _e887, (_e887 > _e460));
                                        let _e922 = (_e915 <= select(_e503, _e912, (_e912 < _e503)));
                                        let _e923 = (_e917 <= select(_e503, _e913, (_e913 < _e503)));
                                        let _e924 = (_e915 <= _e917);
                                        if _e922 {
                                            if _e923 {
                                                if _e924 {
                                                    phi_3212_ = _e823.member_2;
                                                } else {
                                                    phi_3212_ = _e823.member_1;
                                                }
                                                let _e928 = phi_3212_;
                                                let _e950 = (_e545 % 128u);
                                                let _e951 = (_e950 < 128u);
                                                if _e951 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_8[_e950] = _e928.member_1;
                                                if _e951 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_7[_e950] = _e928.member.member.x;
                                                if _e951 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_6[_e950] = _e928.member.member.y;
                                                if _e951 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_5[_e950] = _e928.member.member.z;
                                                if _e951 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_4[_e950] = _e928.member.member_1.x;
                                                if _e951 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_3[_e950] = _e928.member.member_1.y;
                                                if _e951 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_2[_e950] = _e928.member.member_1.z;
                                                if _e951 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_10[_e950] = select(_e917, _e915, (_e915 > _e917));
                                                if _e924 {
                                                    phi_3289_ = _e823.member_1;
                                                } else {
                                                    phi_3289_ = _e823.member_2;
                                                }
                                                let _e964 = phi_3289_;
                                                phi_3290_ = _e964;
                                                phi_3291_ = (_e545 + 1u);
                                            } else {
                                                phi_3290_ = type_52();
                                                phi_3291_ = u32();
                                            }
                                            let _e966 = phi_3290_;
                                            let _e968 = phi_3291_;
                                            phi_3293_ = _e966;
                                            phi_3294_ = _e968;
                                            phi_3295_ = select(true, false, _e923);
                                        } else {
                                            phi_3293_ = type_52();
                                            phi_3294_ = u32();
                                            phi_3295_ = true;
                                        }
                                        let _e971 = phi_3293_;
                                        let _e973 = phi_3294_;
                                        let _e975 = phi_3295_;
                                        if _e975 {
                                            if _e922 {
                                                phi_3304_ = _e823.member_1;
                                            } else {
                                                phi_3304_ = _e823.member_2;
                                            }
                                            let _e979 = phi_3304_;
                                            phi_3309_ = _e979;
                                            phi_3310_ = select(_e923, true, _e922);
                                        } else {
                                            phi_3309_ = _e971;
                                            phi_3310_ = _e543;
                                        }
                                        let _e982 = phi_3309_;
                                        let _e984 = phi_3310_;
                                        phi_4004_ = _e503;
                                        phi_3906_ = _e501;
                                        phi_3312_ = _e982;
                                        phi_3313_ = _e984;
                                        phi_3314_ = select(_e973, _e545, _e975);
                                    }
                                    let _e1636 = phi_4004_;
                                    let _e1638 = phi_3906_;
                                    let _e1640 = phi_3312_;
                                    let _e1642 = phi_3313_;
                                    let _e1644 = phi_3314_;
                                    phi_4003_ = _e1636;
                                    phi_3905_ = _e1638;
                                    phi_3315_ = _e1640;
                                    phi_3316_ = (_e507 - 1u);
                                    phi_3317_ = _e1642;
                                    phi_3318_ = _e1644;
                                } else {
                                    phi_4003_ = _e503;
                                    phi_3905_ = _e501;
                                    phi_3315_ = _e541;
                                    phi_3316_ = _e507;
                                    phi_3317_ = _e543;
                                    phi_3318_ = _e545;
                                }
                                let _e1646 = phi_4003_;
                                let _e1648 = phi_3905_;
                                let _e1650 = phi_3315_;
                                let _e1652 = phi_3316_;
                                let _e1654 = phi_3317_;
                                let _e1656 = phi_3318_;
                                phi_4002_ = _e1646;
                                phi_3904_ = _e1648;
                                phi_3319_ = _e1650;
                                phi_3320_ = _e1652;
                                phi_3321_ = _e1654;
                                phi_3322_ = _e1656;
                            } else {
                                phi_4002_ = _e503;
                                phi_3904_ = _e501;
                                phi_3319_ = type_52();
                                phi_3320_ = u32();
                                phi_3321_ = bool();
                                phi_3322_ = u32();
                            }
                            let _e1658 = phi_4002_;
                            let _e1660 = phi_3904_;
                            let _e1662 = phi_3319_;
                            let _e1664 = phi_3320_;
                            let _e1666 = phi_3321_;
                            let _e1668 = phi_3322_;
                            phi_4001_ = _e1658;
                            phi_3903_ = _e1660;
                            phi_901_ = _e1662;
                            phi_904_ = _e1664;
                            phi_906_ = _e1666;
                            phi_908_ = _e1668;
                            phi_3323_ = _e515;
                        } else {
                            phi_4001_ = _e503;
                            phi_3903_ = _e501;
                            phi_901_ = type_52();
                            phi_904_ = u32();
                            phi_906_ = bool();
                            phi_908_ = u32();
                            phi_3323_ = false;
                        }
                        let _e1670 = phi_4001_;
                        let _e1672 = phi_3903_;
                        let _e1674 = phi_901_;
                        let _e1676 = phi_904_;
                        let _e1678 = phi_906_;
                        let _e1680 = phi_908_;
                        let _e1682 = phi_3323_;
                        continue;
                        continuing {
                            phi_3767_ = _e1672;
                            phi_3695_ = _e1670;
                            phi_900_ = _e1674;
                            phi_903_ = _e1676;
                            phi_905_ = _e1678;
                            phi_907_ = _e1680;
                            phi_3902_ = _e1672;
                            break if !(_e1682);
                        }
                    }
                    let _e1685 = phi_3902_;
                    if _e1685 {
                        break;
                    }
                    phi_3330_ = type_4(0u, 8u);
                    loop {
                        let _e1687 = phi_3330_;
                        if (_e1687.member < _e1687.member_1) {
                            phi_3331_ = type_4((_e1687.member + 1u), _e1687.member_1);
                            phi_3354_ = type_4(1u, _e1687.member);
                        } else {
                            phi_3331_ = _e1687;
                            phi_3354_ = type_4(0u, type_4().member_1);
                        }
                        let _e1700 = phi_3331_;
                        let _e1702 = phi_3354_;
                        let _e1706 = (bitcast<i32>(_e1702.member) != 0i);
                        if _e1706 {
                            let _e1707 = (_e1702.member_1 < 8u);
                            if _e1707 {
                            } else {
                                phi_3994_ = true;
                                break;
                            }
                            let _e1709 = local_9[_e1702.member_1];
                            if (_e1709.member_3 != 4294967295u) {
                                let _e1715 = -(_e427);
                                let _e1716 = (_e1715 / 3i);
                                let _e1723 = bitcast<f32>((bitcast<u32>((_e1716 + 127i)) << bitcast<u32>(23i)));
                                let _e1731 = (((_e1709.member * _e1723) * _e1723) * bitcast<f32>((bitcast<u32>(((_e1715 - (2i * _e1716)) + 127i)) << bitcast<u32>(23i))));
                                let _e1733 = select(340282350000000000000000000000000000000f, _e1731, (_e1731 < 340282350000000000000000000000000000000f));
                                phi_3420_ = type_25(select(-340282350000000000000000000000000000000f, _e1733, (_e1733 > -340282350000000000000000000000000000000f)), _e1709.member_1, _e1709.member_2, _e1709.member_3);
                            } else {
                                phi_3420_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1738 = phi_3420_;
                            if _e1707 {
                            } else {
                                phi_3994_ = true;
                                break;
                            }
                            local_9[_e1702.member_1] = type_25(_e1738.member, _e1738.member_1, _e1738.member_2, _e1738.member_3);
                        }
                        continue;
                        continuing {
                            phi_3330_ = _e1700;
                            phi_3994_ = _e1685;
                            break if !(_e1706);
                        }
                    }
                    let _e1746 = phi_3994_;
                    if _e1746 {
                        break;
                    }
                    let _e1747 = local_9;
                    if _e148 {
                    } else {
                        break;
                    }
                    global_6.member[_e146] = array<type_25, 8>(type_25(_e1747[0].member, _e1747[0].member_1, _e1747[0].member_2, _e1747[0].member_3), type_25(_e1747[1].member, _e1747[1].member_1, _e1747[1].member_2, _e1747[1].member_3), type_25(_e1747[2].member, _e1747[2].member_1, _e1747[2].member_2, _e1747[2].member_3), type_25(_e1747[3].member, _e1747[3].member_1, _e1747[3].member_2, _e1747[3].member_3), type_25(_e1747[4].member, _e1747[4].member_1, _e1747[4].member_2, _e1747[4].member_3), type_25(_e1747[5].member, _e1747[5].member_1, _e1747[5].member_2, _e1747[5].member_3), type_25(_e1747[6].member, _e1747[6].member_1, _e1747[6].member_2, _e1747[6].member_3), type_25(_e1747[7].member, _e1747[7].member_1, _e1747[7].member_2, _e1747[7].member_3));
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
