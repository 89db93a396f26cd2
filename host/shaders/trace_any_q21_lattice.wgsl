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
    var phi_4012_: bool;
    var phi_846_: type_34;
    var phi_849_: type_45;
    var phi_851_: u32;
    var phi_853_: bool;
    var phi_855_: u32;
    var phi_866_: bool;
    var phi_952_: type_45;
    var phi_953_: bool;
    var phi_954_: u32;
    var phi_3045_: u32;
    var phi_3051_: u32;
    var phi_3305_: u32;
    var phi_3306_: u32;
    var phi_3316_: u32;
    var phi_3318_: u32;
    var phi_3319_: bool;
    var phi_3339_: u32;
    var phi_3340_: u32;
    var phi_3344_: type_46;
    var phi_3688_: type_45;
    var phi_3765_: type_45;
    var phi_3766_: type_45;
    var phi_3767_: u32;
    var phi_3769_: type_45;
    var phi_3770_: u32;
    var phi_3771_: bool;
    var phi_3780_: type_45;
    var phi_3785_: type_45;
    var phi_3786_: bool;
    var phi_973_: type_34;
    var phi_976_: type_8;
    var phi_977_: type_8;
    var phi_999_: type_8;
    var phi_1040_: u32;
    var phi_1046_: u32;
    var phi_1056_: u32;
    var phi_1072_: u32;
    var phi_1105_: u32;
    var phi_1111_: u32;
    var phi_1538_: u32;
    var phi_1556_: u32;
    var phi_1574_: u32;
    var phi_1594_: u32;
    var phi_1612_: u32;
    var phi_1630_: u32;
    var phi_1650_: u32;
    var phi_1668_: u32;
    var phi_1686_: u32;
    var phi_1264_: u32;
    var phi_1279_: u32;
    var phi_1289_: u32;
    var phi_1309_: u32;
    var phi_1329_: u32;
    var phi_1355_: u32;
    var phi_1370_: u32;
    var phi_1380_: u32;
    var phi_1400_: u32;
    var phi_1420_: u32;
    var phi_1446_: u32;
    var phi_1461_: u32;
    var phi_1471_: u32;
    var phi_1491_: u32;
    var phi_1511_: u32;
    var phi_1135_: u32;
    var phi_1178_: u32;
    var phi_1221_: u32;
    var phi_1692_: array<array<f32, 3>, 3>;
    var phi_1809_: bool;
    var phi_1838_: bool;
    var phi_2239_: f32;
    var phi_2240_: f32;
    var phi_2241_: f32;
    var phi_2242_: f32;
    var phi_2243_: vec3<f32>;
    var phi_2244_: vec3<f32>;
    var phi_2245_: vec3<f32>;
    var phi_2246_: vec3<f32>;
    var phi_2277_: bool;
    var phi_2286_: vec3<f32>;
    var phi_2453_: bool;
    var phi_2477_: f32;
    var phi_2478_: f32;
    var phi_2501_: type_20;
    var phi_2503_: type_20;
    var phi_2504_: bool;
    var phi_2508_: type_20;
    var phi_2509_: type_20;
    var phi_2510_: type_20;
    var phi_2511_: bool;
    var phi_2515_: type_20;
    var phi_2516_: bool;
    var phi_2517_: type_20;
    var phi_2518_: bool;
    var phi_2519_: bool;
    var phi_2520_: type_20;
    var phi_2521_: bool;
    var phi_2522_: bool;
    var phi_2530_: type_20;
    var phi_2531_: bool;
    var phi_2535_: type_20;
    var phi_2546_: type_34;
    var phi_2547_: type_34;
    var phi_974_: type_34;
    var phi_4006_: bool;
    var local_10: type_34;
    var phi_4196_: bool;
    var phi_3788_: type_34;
    var phi_3789_: type_45;
    var phi_3790_: bool;
    var phi_3791_: u32;
    var phi_4195_: bool;
    var phi_3792_: type_34;
    var phi_3793_: type_45;
    var phi_3794_: u32;
    var phi_3795_: bool;
    var phi_3796_: u32;
    var phi_4194_: bool;
    var phi_3797_: type_34;
    var phi_3798_: type_45;
    var phi_3799_: u32;
    var phi_3800_: bool;
    var phi_3801_: u32;
    var phi_4193_: bool;
    var phi_847_: type_34;
    var phi_850_: type_45;
    var phi_852_: u32;
    var phi_854_: bool;
    var phi_856_: u32;
    var phi_3802_: bool;
    var phi_4192_: bool;
    var local_11: type_34;
    var local_12: type_34;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_5.member));
            let _e92 = arrayLength((&global_6.member));
            let _e100 = global_2.member[0u][0u];
            let _e104 = global_2.member[0u][1u];
            let _e108 = global_2.member[0u][2u];
            let _e112 = global_2.member[0u][3u];
            let _e116 = global_2.member[1u][0u];
            let _e120 = global_2.member[1u][1u];
            let _e124 = global_2.member[1u][2u];
            let _e127 = global_1.member[0u];
            let _e128 = bitcast<i32>(_e127);
            let _e140 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e112) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e100), bitcast<i32>(_e104), bitcast<i32>(_e108));
            local = array<i32, 3>(bitcast<i32>(_e116), bitcast<i32>(_e120), bitcast<i32>(_e124));
            let _e146 = (_e87.x + (_e87.y * 2097152u));
            let _e147 = (_e146 < arrayLength((&global_3.member)));
            if _e147 {
                let _e148 = (_e146 < arrayLength((&global_4.member)));
                if _e148 {
                    if _e147 {
                    } else {
                        break;
                    }
                    let _e156 = global_3.member[_e146].member_2[0u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_3.member[_e146].member_2[1u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_3.member[_e146].member_2[2u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_3.member[_e146].member[0u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_3.member[_e146].member[1u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_3.member[_e146].member[2u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e195 = select(_e165, _e158, (_e165 < _e158));
                    let _e197 = select(_e172, _e195, (_e172 < _e195));
                    let _e199 = select(_e179, _e197, (_e179 < _e197));
                    let _e201 = select(_e186, _e199, (_e186 < _e199));
                    let _e203 = select(_e193, _e201, (_e193 < _e201));
                    let _e207 = global_3.member[_e146].member_1;
                    let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                    let _e216 = global_3.member[_e146].member_3;
                    let _e222 = (((select(_e209, _e203, (_e209 < _e203)) < 2139095040u) && ((bitcast<u32>(_e216) & 2147483647u) <= 2139095040u)) && (_e197 > 0u));
                    if _e222 {
                        let _e225 = (bitcast<u32>(bitcast<f32>(_e197)) & 2147483647u);
                        if (_e225 >= 8388608u) {
                            phi_388_ = (bitcast<i32>((_e225 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_388_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e225)), 32u, (_e225 == 0u))));
                        }
                        let _e239 = phi_388_;
                        phi_389_ = _e239;
                    } else {
                        phi_389_ = 0i;
                    }
                    let _e241 = phi_389_;
                    let _e242 = (_e158 == _e197);
                    if _e242 {
                        phi_399_ = true;
                    } else {
                        phi_399_ = (_e165 == _e197);
                    }
                    let _e245 = phi_399_;
                    let _e246 = select(1u, 0u, _e242);
                    if _e245 {
                        let _e247 = (_e246 + 1u);
                        phi_409_ = _e247;
                        phi_410_ = _e247;
                        phi_412_ = select(true, false, (_e247 == 2u));
                    } else {
                        phi_409_ = u32();
                        phi_410_ = 0u;
                        phi_412_ = true;
                    }
                    let _e251 = phi_409_;
                    let _e253 = phi_410_;
                    let _e255 = phi_412_;
                    if _e255 {
                        phi_417_ = (_e253 + 1u);
                    } else {
                        phi_417_ = 0u;
                    }
                    let _e259 = phi_417_;
                    let _e260 = select(_e251, _e253, _e255);
                    let _e261 = select(_e246, select(2u, _e246, _e245), _e255);
                    if (_e128 < -126i) {
                        phi_429_ = -126i;
                    } else {
                        phi_429_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e266 = phi_429_;
                    let _e271 = bitcast<f32>((bitcast<u32>((_e266 + 127i)) << bitcast<u32>(23i)));
                    let _e277 = bitcast<f32>((bitcast<u32>(((_e128 - _e266) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = -(_e241);
                    if (_e278 < -126i) {
                        phi_449_ = -126i;
                    } else {
                        phi_449_ = select(_e278, 127i, (_e278 > 127i));
                    }
                    let _e283 = phi_449_;
                    let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                    let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                    let _e298 = global_3.member[_e146].member;
                    let _e299 = (_e260 == 0u);
                    if _e299 {
                        phi_467_ = _e298[0];
                    } else {
                        phi_467_ = _e298[1];
                    }
                    let _e303 = phi_467_;
                    let _e304 = (_e260 == 2u);
                    if _e304 {
                        phi_473_ = _e298[2];
                    } else {
                        phi_473_ = _e303;
                    }
                    let _e307 = phi_473_;
                    let _e309 = ((_e307 * _e271) * _e277);
                    let _e310 = global_3.member[_e146].member_2;
                    if _e299 {
                        phi_484_ = _e310[0];
                    } else {
                        phi_484_ = _e310[1];
                    }
                    let _e314 = phi_484_;
                    if _e304 {
                        phi_490_ = _e310[2];
                    } else {
                        phi_490_ = _e314;
                    }
                    let _e317 = phi_490_;
                    let _e319 = ((_e317 * _e288) * _e294);
                    let _e323 = (bitcast<f32>((bitcast<u32>(_e319) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e323 {
                        let _e327 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_513_ = select(0.00000000000011368684f, _e327, (_e327 > 0.00000000000011368684f));
                    } else {
                        phi_513_ = 0f;
                    }
                    let _e331 = phi_513_;
                    let _e332 = (_e309 + _e331);
                    let _e333 = (_e309 - _e331);
                    let _e334 = select(_e319, 0f, _e323);
                    if _e323 {
                        phi_524_ = 38685626000000000000000000f;
                    } else {
                        phi_524_ = (1f / _e319);
                    }
                    let _e337 = phi_524_;
                    let _e338 = (_e259 == 0u);
                    if _e338 {
                        phi_533_ = _e298[0];
                    } else {
                        phi_533_ = _e298[1];
                    }
                    let _e342 = phi_533_;
                    let _e343 = (_e259 == 2u);
                    if _e343 {
                        phi_539_ = _e298[2];
                    } else {
                        phi_539_ = _e342;
                    }
                    let _e346 = phi_539_;
                    let _e348 = ((_e346 * _e271) * _e277);
                    if _e338 {
                        phi_550_ = _e310[0];
                    } else {
                        phi_550_ = _e310[1];
                    }
                    let _e352 = phi_550_;
                    if _e343 {
                        phi_556_ = _e310[2];
                    } else {
                        phi_556_ = _e352;
                    }
                    let _e355 = phi_556_;
                    let _e357 = ((_e355 * _e288) * _e294);
                    let _e361 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e361 {
                        let _e365 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) * 0.00000011920929f);
                        phi_579_ = select(0.00000000000011368684f, _e365, (_e365 > 0.00000000000011368684f));
                    } else {
                        phi_579_ = 0f;
                    }
                    let _e369 = phi_579_;
                    let _e370 = (_e348 + _e369);
                    let _e371 = (_e348 - _e369);
                    let _e372 = select(_e357, 0f, _e361);
                    if _e361 {
                        phi_590_ = 38685626000000000000000000f;
                    } else {
                        phi_590_ = (1f / _e357);
                    }
                    let _e375 = phi_590_;
                    let _e376 = (_e261 == 0u);
                    if _e376 {
                        phi_599_ = _e298[0];
                    } else {
                        phi_599_ = _e298[1];
                    }
                    let _e380 = phi_599_;
                    let _e381 = (_e261 == 2u);
                    if _e381 {
                        phi_605_ = _e298[2];
                    } else {
                        phi_605_ = _e380;
                    }
                    let _e384 = phi_605_;
                    let _e386 = ((_e384 * _e271) * _e277);
                    if _e376 {
                        phi_616_ = _e310[0];
                    } else {
                        phi_616_ = _e310[1];
                    }
                    let _e390 = phi_616_;
                    if _e381 {
                        phi_622_ = _e310[2];
                    } else {
                        phi_622_ = _e390;
                    }
                    let _e393 = phi_622_;
                    let _e395 = ((_e393 * _e288) * _e294);
                    let _e399 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e399 {
                        let _e403 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) * 0.00000011920929f);
                        phi_645_ = select(0.00000000000011368684f, _e403, (_e403 > 0.00000000000011368684f));
                    } else {
                        phi_645_ = 0f;
                    }
                    let _e407 = phi_645_;
                    let _e408 = (_e386 + _e407);
                    let _e409 = (_e386 - _e407);
                    let _e410 = select(_e395, 0f, _e399);
                    if _e399 {
                        phi_656_ = 38685626000000000000000000f;
                    } else {
                        phi_656_ = (1f / _e395);
                    }
                    let _e413 = phi_656_;
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
                        phi_756_ = select(-340282350000000000000000000000000000000f, _e454, (_e454 > -340282350000000000000000000000000000000f));
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_756_ = 0f;
                        phi_757_ = 1f;
                    }
                    let _e458 = phi_756_;
                    let _e460 = phi_757_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e464 = (_e260 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e259 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    let _e476 = (_e261 % 3u);
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
                    phi_4012_ = false;
                    phi_846_ = type_34(_e458, false);
                    phi_849_ = type_45(type_24(vec4<f32>((f32(_e467) * _e140), (f32(_e473) * _e140), (f32(_e479) * _e140), 0f), vec4<f32>((f32(_e484) * _e140), (f32(_e488) * _e140), (f32(_e492) * _e140), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_851_ = ((3u * _e89) + 1u);
                    phi_853_ = (_e460 <= _e458);
                    phi_855_ = 0u;
                    loop {
                        let _e502 = phi_4012_;
                        let _e504 = phi_846_;
                        let _e506 = phi_849_;
                        let _e508 = phi_851_;
                        let _e510 = phi_853_;
                        let _e512 = phi_855_;
                        local_11 = _e504;
                        if _e510 {
                            phi_866_ = true;
                        } else {
                            phi_866_ = (_e512 > 0u);
                        }
                        let _e515 = phi_866_;
                        if _e515 {
                            let _e516 = (_e508 > 0u);
                            if _e516 {
                                if _e510 {
                                    phi_952_ = _e506;
                                    phi_953_ = _e510;
                                    phi_954_ = _e512;
                                } else {
                                    let _e517 = (_e512 - 1u);
                                    let _e518 = (_e517 % 128u);
                                    let _e519 = (_e518 < 128u);
                                    if _e519 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e521 = local_7[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e523 = local_6[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e525 = local_5[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e527 = local_4[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e529 = local_3[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e531 = local_2[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e536 = local_8[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e539 = local_9[_e518];
                                    phi_952_ = type_45(type_24(vec4<f32>(_e521, _e523, _e525, 0f), vec4<f32>(_e527, _e529, _e531, 0f)), _e536);
                                    phi_953_ = (_e539 <= _e504.member);
                                    phi_954_ = _e517;
                                }
                                let _e543 = phi_952_;
                                let _e545 = phi_953_;
                                let _e547 = phi_954_;
                                if _e545 {
                                    let _e552 = (_e543.member_1 & 268435455u);
                                    if ((_e543.member_1 & 2147483648u) != 0u) {
                                        phi_973_ = _e504;
                                        phi_976_ = type_8(0u, ((_e543.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1030 = phi_973_;
                                            let _e1032 = phi_976_;
                                            local_10 = _e1030;
                                            local_12 = _e1030;
                                            if (_e1032.member < _e1032.member_1) {
                                                phi_977_ = type_8((_e1032.member + 1u), _e1032.member_1);
                                                phi_999_ = type_8(1u, _e1032.member);
                                            } else {
                                                phi_977_ = _e1032;
                                                phi_999_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1045 = phi_977_;
                                            let _e1047 = phi_999_;
                                            let _e1051 = (bitcast<i32>(_e1047.member) != 0i);
                                            if _e1051 {
                                                let _e1056 = (_e543.member.member_1.x - _e543.member.member.x);
                                                let _e1059 = (_e543.member.member_1.y - _e543.member.member.y);
                                                let _e1062 = (_e543.member.member_1.z - _e543.member.member.z);
                                                let _e1064 = select(_e1059, _e1056, (_e1056 > _e1059));
                                                let _e1066 = select(_e1062, _e1064, (_e1064 > _e1062));
                                                let _e1068 = (_e1066 < (1024f * _e140));
                                                if _e1068 {
                                                    phi_1040_ = 0u;
                                                } else {
                                                    phi_1040_ = select(2u, 1u, (_e1066 < (2097152f * _e140)));
                                                }
                                                let _e1073 = phi_1040_;
                                                switch bitcast<i32>(_e1073) {
                                                    case 0: {
                                                        phi_1046_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1046_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1046_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1046_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1076 = phi_1046_;
                                                switch bitcast<i32>(_e1073) {
                                                    case 0: {
                                                        phi_1056_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1056_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1056_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1056_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1083 = phi_1056_;
                                                let _e1085 = ((_e552 + (_e1047.member_1 * ((3u * _e1076) + 1u))) + (3u * _e1083));
                                                let _e1086 = (_e1085 < _e92);
                                                if _e1086 {
                                                    if _e1086 {
                                                    } else {
                                                        phi_4006_ = true;
                                                        break;
                                                    }
                                                    let _e1088 = global_6.member[_e1085];
                                                    phi_1072_ = _e1088;
                                                } else {
                                                    phi_1072_ = 4294967295u;
                                                }
                                                let _e1090 = phi_1072_;
                                                if _e1068 {
                                                    phi_1105_ = 0u;
                                                } else {
                                                    phi_1105_ = select(2u, 1u, (_e1066 < (2097152f * _e140)));
                                                }
                                                let _e1095 = phi_1105_;
                                                switch bitcast<i32>(_e1095) {
                                                    case 0: {
                                                        phi_1111_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1111_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1111_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1111_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1098 = phi_1111_;
                                                let _e1102 = (_e552 + (_e1047.member_1 * ((3u * _e1098) + 1u)));
                                                switch bitcast<i32>(_e1095) {
                                                    case 0: {
                                                        let _e1368 = (_e1102 < _e92);
                                                        if _e1368 {
                                                            if _e1368 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1370 = global_6.member[_e1102];
                                                            phi_1135_ = _e1370;
                                                        } else {
                                                            phi_1135_ = 0u;
                                                        }
                                                        let _e1372 = phi_1135_;
                                                        let _e1374 = ((10u * _e260) & 31u);
                                                        let _e1383 = ((10u * _e259) & 31u);
                                                        let _e1392 = ((10u * _e261) & 31u);
                                                        let _e1401 = (_e1102 + 1u);
                                                        let _e1402 = (_e1401 < _e92);
                                                        if _e1402 {
                                                            if _e1402 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1404 = global_6.member[_e1401];
                                                            phi_1178_ = _e1404;
                                                        } else {
                                                            phi_1178_ = 0u;
                                                        }
                                                        let _e1406 = phi_1178_;
                                                        let _e1429 = (_e1102 + 2u);
                                                        let _e1430 = (_e1429 < _e92);
                                                        if _e1430 {
                                                            if _e1430 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1432 = global_6.member[_e1429];
                                                            phi_1221_ = _e1432;
                                                        } else {
                                                            phi_1221_ = 0u;
                                                        }
                                                        let _e1434 = phi_1221_;
                                                        phi_1692_ = array<array<f32, 3>, 3>(array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>(((_e1372 >> bitcast<u32>(_e1374)) & 1023u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>(((_e1372 >> bitcast<u32>(_e1383)) & 1023u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>(((_e1372 >> bitcast<u32>(_e1392)) & 1023u))) * _e140))), array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>(((_e1406 >> bitcast<u32>(_e1374)) & 1023u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>(((_e1406 >> bitcast<u32>(_e1383)) & 1023u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>(((_e1406 >> bitcast<u32>(_e1392)) & 1023u))) * _e140))), array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1374)) & 1023u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1383)) & 1023u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1392)) & 1023u))) * _e140))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1191 = (_e1102 < _e92);
                                                        if _e1191 {
                                                            if _e1191 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1193 = global_6.member[_e1102];
                                                            phi_1264_ = _e1193;
                                                        } else {
                                                            phi_1264_ = 0u;
                                                        }
                                                        let _e1195 = phi_1264_;
                                                        let _e1196 = (_e1102 + 1u);
                                                        let _e1197 = (_e1196 < _e92);
                                                        if _e1197 {
                                                            if _e1197 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1199 = global_6.member[_e1196];
                                                            phi_1279_ = _e1199;
                                                        } else {
                                                            phi_1279_ = 0u;
                                                        }
                                                        let _e1201 = phi_1279_;
                                                        let _e1202 = (_e260 == 1u);
                                                        if _e1202 {
                                                            phi_1289_ = ((_e1195 >> bitcast<u32>(21i)) | (_e1201 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1289_ = (_e1201 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1211 = phi_1289_;
                                                        let _e1218 = (_e259 == 1u);
                                                        if _e1218 {
                                                            phi_1309_ = ((_e1195 >> bitcast<u32>(21i)) | (_e1201 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1309_ = (_e1201 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1227 = phi_1309_;
                                                        let _e1234 = (_e261 == 1u);
                                                        if _e1234 {
                                                            phi_1329_ = ((_e1195 >> bitcast<u32>(21i)) | (_e1201 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1329_ = (_e1201 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1243 = phi_1329_;
                                                        let _e1251 = (_e1102 + 2u);
                                                        let _e1252 = (_e1251 < _e92);
                                                        if _e1252 {
                                                            if _e1252 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1254 = global_6.member[_e1251];
                                                            phi_1355_ = _e1254;
                                                        } else {
                                                            phi_1355_ = 0u;
                                                        }
                                                        let _e1256 = phi_1355_;
                                                        let _e1257 = (_e1102 + 3u);
                                                        let _e1258 = (_e1257 < _e92);
                                                        if _e1258 {
                                                            if _e1258 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1260 = global_6.member[_e1257];
                                                            phi_1370_ = _e1260;
                                                        } else {
                                                            phi_1370_ = 0u;
                                                        }
                                                        let _e1262 = phi_1370_;
                                                        if _e1202 {
                                                            phi_1380_ = ((_e1256 >> bitcast<u32>(21i)) | (_e1262 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1380_ = (_e1262 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1271 = phi_1380_;
                                                        if _e1218 {
                                                            phi_1400_ = ((_e1256 >> bitcast<u32>(21i)) | (_e1262 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1400_ = (_e1262 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1286 = phi_1400_;
                                                        if _e1234 {
                                                            phi_1420_ = ((_e1256 >> bitcast<u32>(21i)) | (_e1262 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1420_ = (_e1262 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1301 = phi_1420_;
                                                        let _e1309 = (_e1102 + 4u);
                                                        let _e1310 = (_e1309 < _e92);
                                                        if _e1310 {
                                                            if _e1310 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1312 = global_6.member[_e1309];
                                                            phi_1446_ = _e1312;
                                                        } else {
                                                            phi_1446_ = 0u;
                                                        }
                                                        let _e1314 = phi_1446_;
                                                        let _e1315 = (_e1102 + 5u);
                                                        let _e1316 = (_e1315 < _e92);
                                                        if _e1316 {
                                                            if _e1316 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1318 = global_6.member[_e1315];
                                                            phi_1461_ = _e1318;
                                                        } else {
                                                            phi_1461_ = 0u;
                                                        }
                                                        let _e1320 = phi_1461_;
                                                        if _e1202 {
                                                            phi_1471_ = ((_e1314 >> bitcast<u32>(21i)) | (_e1320 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1471_ = (_e1320 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1329 = phi_1471_;
                                                        if _e1218 {
                                                            phi_1491_ = ((_e1314 >> bitcast<u32>(21i)) | (_e1320 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1491_ = (_e1320 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1344 = phi_1491_;
                                                        if _e1234 {
                                                            phi_1511_ = ((_e1314 >> bitcast<u32>(21i)) | (_e1320 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1511_ = (_e1320 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1359 = phi_1511_;
                                                        phi_1692_ = array<array<f32, 3>, 3>(array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>((select(_e1211, _e1195, _e299) & 2097151u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>((select(_e1227, _e1195, _e338) & 2097151u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>((select(_e1243, _e1195, _e376) & 2097151u))) * _e140))), array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>((select(_e1271, _e1256, _e299) & 2097151u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>((select(_e1286, _e1256, _e338) & 2097151u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>((select(_e1301, _e1256, _e376) & 2097151u))) * _e140))), array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>((select(_e1329, _e1314, _e299) & 2097151u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>((select(_e1344, _e1314, _e338) & 2097151u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>((select(_e1359, _e1314, _e376) & 2097151u))) * _e140))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1104 = (_e1102 + _e260);
                                                        let _e1105 = (_e1104 < _e92);
                                                        if _e1105 {
                                                            if _e1105 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1107 = global_6.member[_e1104];
                                                            phi_1538_ = _e1107;
                                                        } else {
                                                            phi_1538_ = 0u;
                                                        }
                                                        let _e1109 = phi_1538_;
                                                        let _e1113 = (_e1102 + _e259);
                                                        let _e1114 = (_e1113 < _e92);
                                                        if _e1114 {
                                                            if _e1114 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1116 = global_6.member[_e1113];
                                                            phi_1556_ = _e1116;
                                                        } else {
                                                            phi_1556_ = 0u;
                                                        }
                                                        let _e1118 = phi_1556_;
                                                        let _e1122 = (_e1102 + _e261);
                                                        let _e1123 = (_e1122 < _e92);
                                                        if _e1123 {
                                                            if _e1123 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1125 = global_6.member[_e1122];
                                                            phi_1574_ = _e1125;
                                                        } else {
                                                            phi_1574_ = 0u;
                                                        }
                                                        let _e1127 = phi_1574_;
                                                        let _e1132 = (_e1102 + 3u);
                                                        let _e1133 = (_e1132 + _e260);
                                                        let _e1134 = (_e1133 < _e92);
                                                        if _e1134 {
                                                            if _e1134 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1136 = global_6.member[_e1133];
                                                            phi_1594_ = _e1136;
                                                        } else {
                                                            phi_1594_ = 0u;
                                                        }
                                                        let _e1138 = phi_1594_;
                                                        let _e1142 = (_e1132 + _e259);
                                                        let _e1143 = (_e1142 < _e92);
                                                        if _e1143 {
                                                            if _e1143 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1145 = global_6.member[_e1142];
                                                            phi_1612_ = _e1145;
                                                        } else {
                                                            phi_1612_ = 0u;
                                                        }
                                                        let _e1147 = phi_1612_;
                                                        let _e1151 = (_e1132 + _e261);
                                                        let _e1152 = (_e1151 < _e92);
                                                        if _e1152 {
                                                            if _e1152 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1154 = global_6.member[_e1151];
                                                            phi_1630_ = _e1154;
                                                        } else {
                                                            phi_1630_ = 0u;
                                                        }
                                                        let _e1156 = phi_1630_;
                                                        let _e1161 = (_e1102 + 6u);
                                                        let _e1162 = (_e1161 + _e260);
                                                        let _e1163 = (_e1162 < _e92);
                                                        if _e1163 {
                                                            if _e1163 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1165 = global_6.member[_e1162];
                                                            phi_1650_ = _e1165;
                                                        } else {
                                                            phi_1650_ = 0u;
                                                        }
                                                        let _e1167 = phi_1650_;
                                                        let _e1171 = (_e1161 + _e259);
                                                        let _e1172 = (_e1171 < _e92);
                                                        if _e1172 {
                                                            if _e1172 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1174 = global_6.member[_e1171];
                                                            phi_1668_ = _e1174;
                                                        } else {
                                                            phi_1668_ = 0u;
                                                        }
                                                        let _e1176 = phi_1668_;
                                                        let _e1180 = (_e1161 + _e261);
                                                        let _e1181 = (_e1180 < _e92);
                                                        if _e1181 {
                                                            if _e1181 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1183 = global_6.member[_e1180];
                                                            phi_1686_ = _e1183;
                                                        } else {
                                                            phi_1686_ = 0u;
                                                        }
                                                        let _e1185 = phi_1686_;
                                                        phi_1692_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1109)) * _e140), (f32(bitcast<i32>(_e1118)) * _e140), (f32(bitcast<i32>(_e1127)) * _e140)), array<f32, 3>((f32(bitcast<i32>(_e1138)) * _e140), (f32(bitcast<i32>(_e1147)) * _e140), (f32(bitcast<i32>(_e1156)) * _e140)), array<f32, 3>((f32(bitcast<i32>(_e1167)) * _e140), (f32(bitcast<i32>(_e1176)) * _e140), (f32(bitcast<i32>(_e1185)) * _e140)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1692_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1459 = phi_1692_;
                                                let _e1467 = (_e1459[0][2] - _e386);
                                                let _e1470 = (((_e1459[0][0] - _e309) * _e410) - (_e1467 * _e334));
                                                let _e1473 = (((_e1459[0][1] - _e348) * _e410) - (_e1467 * _e372));
                                                let _e1480 = (_e1459[1][2] - _e386);
                                                let _e1483 = (((_e1459[1][0] - _e309) * _e410) - (_e1480 * _e334));
                                                let _e1486 = (((_e1459[1][1] - _e348) * _e410) - (_e1480 * _e372));
                                                let _e1493 = (_e1459[2][2] - _e386);
                                                let _e1496 = (((_e1459[2][0] - _e309) * _e410) - (_e1493 * _e334));
                                                let _e1499 = (((_e1459[2][1] - _e348) * _e410) - (_e1493 * _e372));
                                                let _e1500 = (_e1496 * _e1486);
                                                let _e1501 = (_e1499 * _e1483);
                                                let _e1502 = (_e1470 * _e1499);
                                                let _e1503 = (_e1473 * _e1496);
                                                let _e1504 = (_e1483 * _e1473);
                                                let _e1505 = (_e1486 * _e1470);
                                                let _e1510 = (((_e1500 >= _e1501) && (_e1502 >= _e1503)) && (_e1504 >= _e1505));
                                                if (_e1510 || (((_e1500 <= _e1501) && (_e1502 <= _e1503)) && (_e1504 <= _e1505))) {
                                                    let _e1517 = select(-1f, 1f, _e1510);
                                                    let _e1519 = ((_e1500 - _e1501) * _e1517);
                                                    let _e1521 = select(0f, _e1519, (_e1519 > 0f));
                                                    let _e1523 = ((_e1502 - _e1503) * _e1517);
                                                    let _e1525 = select(0f, _e1523, (_e1523 > 0f));
                                                    let _e1527 = ((_e1504 - _e1505) * _e1517);
                                                    let _e1529 = select(0f, _e1527, (_e1527 > 0f));
                                                    let _e1531 = ((_e1521 + _e1525) + _e1529);
                                                    if (_e1531 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2520_ = type_20();
                                                        phi_2521_ = true;
                                                        phi_2522_ = false;
                                                    } else {
                                                        let _e1534 = select(_e1483, _e1470, (_e1470 < _e1483));
                                                        if (select(_e1496, _e1534, (_e1534 < _e1496)) > 0f) {
                                                            phi_1809_ = true;
                                                        } else {
                                                            let _e1539 = select(_e1483, _e1470, (_e1470 > _e1483));
                                                            phi_1809_ = (select(_e1496, _e1539, (_e1539 > _e1496)) < 0f);
                                                        }
                                                        let _e1544 = phi_1809_;
                                                        if _e1544 {
                                                            phi_2517_ = type_20();
                                                            phi_2518_ = true;
                                                            phi_2519_ = false;
                                                        } else {
                                                            let _e1546 = select(_e1486, _e1473, (_e1473 < _e1486));
                                                            if (select(_e1499, _e1546, (_e1546 < _e1499)) > 0f) {
                                                                phi_1838_ = true;
                                                            } else {
                                                                let _e1551 = select(_e1486, _e1473, (_e1473 > _e1486));
                                                                phi_1838_ = (select(_e1499, _e1551, (_e1551 > _e1499)) < 0f);
                                                            }
                                                            let _e1556 = phi_1838_;
                                                            if _e1556 {
                                                                phi_2515_ = type_20();
                                                                phi_2516_ = false;
                                                            } else {
                                                                let _e1558 = select(_e1459[1][0], _e1459[0][0], (_e1459[0][0] < _e1459[1][0]));
                                                                let _e1562 = select(_e1459[1][0], _e1459[0][0], (_e1459[0][0] > _e1459[1][0]));
                                                                let _e1566 = select(_e1459[1][1], _e1459[0][1], (_e1459[0][1] < _e1459[1][1]));
                                                                let _e1570 = select(_e1459[1][1], _e1459[0][1], (_e1459[0][1] > _e1459[1][1]));
                                                                let _e1574 = select(_e1459[1][2], _e1459[0][2], (_e1459[0][2] < _e1459[1][2]));
                                                                let _e1578 = select(_e1459[1][2], _e1459[0][2], (_e1459[0][2] > _e1459[1][2]));
                                                                let _e1583 = ((select(_e1459[2][0], _e1558, (_e1558 < _e1459[2][0])) - _e332) * _e337);
                                                                let _e1584 = ((select(_e1459[2][0], _e1562, (_e1562 > _e1459[2][0])) - _e333) * _e337);
                                                                let _e1587 = ((select(_e1459[2][1], _e1566, (_e1566 < _e1459[2][1])) - _e370) * _e375);
                                                                let _e1588 = ((select(_e1459[2][1], _e1570, (_e1570 > _e1459[2][1])) - _e371) * _e375);
                                                                let _e1591 = ((select(_e1459[2][2], _e1574, (_e1574 < _e1459[2][2])) - _e408) * _e413);
                                                                let _e1592 = ((select(_e1459[2][2], _e1578, (_e1578 > _e1459[2][2])) - _e409) * _e413);
                                                                let _e1594 = select(_e1592, _e1591, (_e1591 < _e1592));
                                                                let _e1596 = select(_e1592, _e1591, (_e1591 > _e1592));
                                                                let _e1598 = select(_e1584, _e1583, (_e1583 < _e1584));
                                                                let _e1600 = select(_e1588, _e1587, (_e1587 < _e1588));
                                                                let _e1602 = select(_e1600, _e1598, (_e1598 > _e1600));
                                                                let _e1604 = select(_e1594, _e1602, (_e1602 > _e1594));
                                                                let _e1606 = select(_e1584, _e1583, (_e1583 > _e1584));
                                                                let _e1608 = select(_e1588, _e1587, (_e1587 > _e1588));
                                                                let _e1610 = select(_e1608, _e1606, (_e1606 < _e1608));
                                                                let _e1612 = select(_e1596, _e1610, (_e1610 < _e1596));
                                                                let _e1613 = -(_e1594);
                                                                let _e1619 = select(_e460, _e1604, (_e1604 > _e460));
                                                                if (_e1619 > (_e1612 + (select(_e1613, _e1596, (_e1596 > _e1613)) * 0.0000019073523f))) {
                                                                    phi_2510_ = type_20();
                                                                    phi_2511_ = true;
                                                                } else {
                                                                    let _e1621 = (_e1619 > _e1030.member);
                                                                    if _e1621 {
                                                                        phi_2509_ = type_20();
                                                                    } else {
                                                                        let _e1622 = vec3<f32>(_e1459[0][0], _e1459[0][1], _e1459[0][2]);
                                                                        let _e1623 = vec3<f32>(_e1459[1][0], _e1459[1][1], _e1459[1][2]);
                                                                        let _e1624 = vec3<f32>(_e1459[2][0], _e1459[2][1], _e1459[2][2]);
                                                                        let _e1625 = (_e1459[1][0] - _e1459[0][0]);
                                                                        let _e1626 = (_e1459[1][1] - _e1459[0][1]);
                                                                        let _e1627 = (_e1459[1][2] - _e1459[0][2]);
                                                                        let _e1628 = vec3<f32>(_e1625, _e1626, _e1627);
                                                                        let _e1629 = (_e1459[2][0] - _e1459[1][0]);
                                                                        let _e1630 = (_e1459[2][1] - _e1459[1][1]);
                                                                        let _e1631 = (_e1459[2][2] - _e1459[1][2]);
                                                                        let _e1632 = vec3<f32>(_e1629, _e1630, _e1631);
                                                                        let _e1633 = (_e1459[0][0] - _e1459[2][0]);
                                                                        let _e1634 = (_e1459[0][1] - _e1459[2][1]);
                                                                        let _e1635 = (_e1459[0][2] - _e1459[2][2]);
                                                                        let _e1636 = vec3<f32>(_e1633, _e1634, _e1635);
                                                                        let _e1639 = bitcast<f32>((bitcast<u32>(_e1625) & 2147483647u));
                                                                        let _e1642 = bitcast<f32>((bitcast<u32>(_e1626) & 2147483647u));
                                                                        let _e1644 = select(_e1642, _e1639, (_e1639 > _e1642));
                                                                        let _e1647 = bitcast<f32>((bitcast<u32>(_e1627) & 2147483647u));
                                                                        let _e1649 = select(_e1647, _e1644, (_e1644 > _e1647));
                                                                        let _e1652 = bitcast<f32>((bitcast<u32>(_e1629) & 2147483647u));
                                                                        let _e1655 = bitcast<f32>((bitcast<u32>(_e1630) & 2147483647u));
                                                                        let _e1657 = select(_e1655, _e1652, (_e1652 > _e1655));
                                                                        let _e1660 = bitcast<f32>((bitcast<u32>(_e1631) & 2147483647u));
                                                                        let _e1662 = select(_e1660, _e1657, (_e1657 > _e1660));
                                                                        let _e1665 = bitcast<f32>((bitcast<u32>(_e1633) & 2147483647u));
                                                                        let _e1668 = bitcast<f32>((bitcast<u32>(_e1634) & 2147483647u));
                                                                        let _e1670 = select(_e1668, _e1665, (_e1665 > _e1668));
                                                                        let _e1673 = bitcast<f32>((bitcast<u32>(_e1635) & 2147483647u));
                                                                        let _e1675 = select(_e1673, _e1670, (_e1670 > _e1673));
                                                                        let _e1677 = select(_e1662, _e1649, (_e1649 > _e1662));
                                                                        let _e1679 = select(_e1675, _e1677, (_e1677 > _e1675));
                                                                        if (_e1649 == _e1679) {
                                                                            phi_2239_ = _e1486;
                                                                            phi_2240_ = _e1483;
                                                                            phi_2241_ = _e1473;
                                                                            phi_2242_ = _e1470;
                                                                            phi_2243_ = _e1622;
                                                                            phi_2244_ = _e1636;
                                                                            phi_2245_ = _e1632;
                                                                            phi_2246_ = _e1628;
                                                                        } else {
                                                                            let _e1681 = (_e1662 == _e1679);
                                                                            let _e1686 = vec3(_e1681);
                                                                            phi_2239_ = select(_e1473, _e1499, _e1681);
                                                                            phi_2240_ = select(_e1470, _e1496, _e1681);
                                                                            phi_2241_ = select(_e1499, _e1486, _e1681);
                                                                            phi_2242_ = select(_e1496, _e1483, _e1681);
                                                                            phi_2243_ = select(_e1624, _e1623, _e1686);
                                                                            phi_2244_ = select(_e1632, _e1628, _e1686);
                                                                            phi_2245_ = select(_e1628, _e1636, _e1686);
                                                                            phi_2246_ = select(_e1636, _e1632, _e1686);
                                                                        }
                                                                        let _e1692 = phi_2239_;
                                                                        let _e1694 = phi_2240_;
                                                                        let _e1696 = phi_2241_;
                                                                        let _e1698 = phi_2242_;
                                                                        let _e1700 = phi_2243_;
                                                                        let _e1702 = phi_2244_;
                                                                        let _e1704 = phi_2245_;
                                                                        let _e1706 = phi_2246_;
                                                                        let _e1713 = ((_e1704.y * _e1702.z) - (_e1702.y * _e1704.z));
                                                                        let _e1718 = ((_e1704.z * _e1702.x) - (_e1702.z * _e1704.x));
                                                                        let _e1721 = ((_e1704.x * _e1702.y) - (_e1702.x * _e1704.y));
                                                                        if (_e1521 >= _e1525) {
                                                                            phi_2277_ = select(true, false, (_e1521 >= _e1529));
                                                                        } else {
                                                                            phi_2277_ = true;
                                                                        }
                                                                        let _e1726 = phi_2277_;
                                                                        if _e1726 {
                                                                            phi_2286_ = select(_e1624, _e1623, vec3((_e1525 >= _e1529)));
                                                                        } else {
                                                                            phi_2286_ = _e1622;
                                                                        }
                                                                        let _e1731 = phi_2286_;
                                                                        let _e1736 = (((_e1713 * _e334) + (_e1718 * _e372)) + (_e1721 * _e410));
                                                                        let _e1747 = (((_e1713 * (_e1731.x - _e309)) + (_e1718 * (_e1731.y - _e348))) + (_e1721 * (_e1731.z - _e386)));
                                                                        let _e1749 = (_e1694 - _e1698);
                                                                        let _e1750 = (_e1692 - _e1696);
                                                                        let _e1758 = (-(((_e1698 * _e1749) + (_e1696 * _e1750))) / ((_e1749 * _e1749) + (_e1750 * _e1750)));
                                                                        let _e1760 = select(1f, _e1758, (_e1758 < 1f));
                                                                        let _e1762 = select(0f, _e1760, (_e1760 > 0f));
                                                                        let _e1775 = ((_e1700.x + (_e1706.x * _e1762)) - _e309);
                                                                        let _e1776 = ((_e1700.y + (_e1706.y * _e1762)) - _e348);
                                                                        let _e1777 = ((_e1700.z + (_e1706.z * _e1762)) - _e386);
                                                                        let _e1778 = (_e1777 / _e410);
                                                                        let _e1790 = bitcast<f32>((bitcast<u32>(_e1775) & 2147483647u));
                                                                        let _e1793 = bitcast<f32>((bitcast<u32>(_e1776) & 2147483647u));
                                                                        let _e1795 = select(_e1793, _e1790, (_e1790 > _e1793));
                                                                        let _e1798 = bitcast<f32>((bitcast<u32>(_e1777) & 2147483647u));
                                                                        let _e1800 = select(_e1798, _e1795, (_e1795 > _e1798));
                                                                        let _e1806 = bitcast<f32>((bitcast<u32>(_e1713) & 2147483647u));
                                                                        let _e1809 = bitcast<f32>((bitcast<u32>(_e1718) & 2147483647u));
                                                                        let _e1811 = select(_e1809, _e1806, (_e1806 > _e1809));
                                                                        let _e1814 = bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1713 * _e1775) + (_e1718 * _e1776)) + (_e1721 * _e1777)) - _e1747)) & 2147483647u)) <= ((0.0000009536743f * select(_e1679, _e1800, (_e1800 > _e1679))) * select(_e1814, _e1811, (_e1811 > _e1814)))) {
                                                                            let _e1824 = bitcast<f32>((bitcast<u32>(_e1704.x) & 2147483647u));
                                                                            let _e1827 = bitcast<f32>((bitcast<u32>(_e1704.y) & 2147483647u));
                                                                            let _e1829 = select(_e1827, _e1824, (_e1824 > _e1827));
                                                                            let _e1832 = bitcast<f32>((bitcast<u32>(_e1704.z) & 2147483647u));
                                                                            let _e1838 = bitcast<f32>((bitcast<u32>(_e1702.x) & 2147483647u));
                                                                            let _e1841 = bitcast<f32>((bitcast<u32>(_e1702.y) & 2147483647u));
                                                                            let _e1843 = select(_e1841, _e1838, (_e1838 > _e1841));
                                                                            let _e1846 = bitcast<f32>((bitcast<u32>(_e1702.z) & 2147483647u));
                                                                            phi_2453_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1736) & 2147483647u)) > ((0.0000038146973f * select(_e1832, _e1829, (_e1829 > _e1832))) * select(_e1846, _e1843, (_e1843 > _e1846)))));
                                                                        } else {
                                                                            phi_2453_ = true;
                                                                        }
                                                                        let _e1853 = phi_2453_;
                                                                        if _e1853 {
                                                                            let _e1864 = ((((_e1713 * (_e1775 - (_e334 * _e1778))) + (_e1718 * (_e1776 - (_e372 * _e1778)))) + (_e1721 * (_e1777 - _e1777))) / _e1736);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1864) & 2147483647u)) <= _e1679) {
                                                                                phi_2477_ = (_e1778 + _e1864);
                                                                            } else {
                                                                                phi_2477_ = _e1778;
                                                                            }
                                                                            let _e1871 = phi_2477_;
                                                                            phi_2478_ = _e1871;
                                                                        } else {
                                                                            phi_2478_ = (_e1747 / _e1736);
                                                                        }
                                                                        let _e1873 = phi_2478_;
                                                                        let _e1875 = select(_e1612, _e1873, (_e1873 < _e1612));
                                                                        let _e1877 = select(_e1604, _e1875, (_e1875 > _e1604));
                                                                        if (_e1877 >= _e460) {
                                                                            let _e1879 = (_e1877 <= _e1030.member);
                                                                            if _e1879 {
                                                                                let _e1880 = (1f / _e1531);
                                                                                phi_2501_ = type_20(_e1877, (_e1525 * _e1880), (_e1529 * _e1880), _e1090);
                                                                            } else {
                                                                                phi_2501_ = type_20();
                                                                            }
                                                                            let _e1885 = phi_2501_;
                                                                            phi_2503_ = _e1885;
                                                                            phi_2504_ = select(true, false, _e1879);
                                                                        } else {
                                                                            phi_2503_ = type_20();
                                                                            phi_2504_ = true;
                                                                        }
                                                                        let _e1888 = phi_2503_;
                                                                        let _e1890 = phi_2504_;
                                                                        if _e1890 {
                                                                            phi_2508_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2508_ = _e1888;
                                                                        }
                                                                        let _e1892 = phi_2508_;
                                                                        phi_2509_ = _e1892;
                                                                    }
                                                                    let _e1894 = phi_2509_;
                                                                    phi_2510_ = _e1894;
                                                                    phi_2511_ = _e1621;
                                                                }
                                                                let _e1896 = phi_2510_;
                                                                let _e1898 = phi_2511_;
                                                                phi_2515_ = _e1896;
                                                                phi_2516_ = _e1898;
                                                            }
                                                            let _e1900 = phi_2515_;
                                                            let _e1902 = phi_2516_;
                                                            phi_2517_ = _e1900;
                                                            phi_2518_ = _e1556;
                                                            phi_2519_ = _e1902;
                                                        }
                                                        let _e1904 = phi_2517_;
                                                        let _e1906 = phi_2518_;
                                                        let _e1908 = phi_2519_;
                                                        phi_2520_ = _e1904;
                                                        phi_2521_ = _e1906;
                                                        phi_2522_ = _e1908;
                                                    }
                                                    let _e1910 = phi_2520_;
                                                    let _e1912 = phi_2521_;
                                                    let _e1914 = phi_2522_;
                                                    phi_2530_ = _e1910;
                                                    phi_2531_ = select(_e1914, true, _e1912);
                                                } else {
                                                    phi_2530_ = type_20();
                                                    phi_2531_ = true;
                                                }
                                                let _e1917 = phi_2530_;
                                                let _e1919 = phi_2531_;
                                                if _e1919 {
                                                    phi_2535_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2535_ = _e1917;
                                                }
                                                let _e1921 = phi_2535_;
                                                if (_e1921.member_3 != 4294967295u) {
                                                    if (_e1090 != 4294967295u) {
                                                        phi_2546_ = type_34(_e1030.member, true);
                                                    } else {
                                                        phi_2546_ = _e1030;
                                                    }
                                                    let _e1929 = phi_2546_;
                                                    phi_2547_ = _e1929;
                                                } else {
                                                    phi_2547_ = _e1030;
                                                }
                                                let _e1931 = phi_2547_;
                                                phi_974_ = _e1931;
                                            } else {
                                                phi_974_ = type_34();
                                            }
                                            let _e1933 = phi_974_;
                                            continue;
                                            continuing {
                                                phi_973_ = _e1933;
                                                phi_976_ = _e1045;
                                                phi_4006_ = _e502;
                                                break if !(_e1051);
                                            }
                                        }
                                        let _e1936 = phi_4006_;
                                        phi_4192_ = _e1936;
                                        if _e1936 {
                                            break;
                                        }
                                        let _e1938 = local_10;
                                        phi_4196_ = _e1936;
                                        let _e2136 = local_12;
                                        phi_3788_ = _e2136;
                                        phi_3789_ = _e543;
                                        phi_3790_ = false;
                                        phi_3791_ = select(_e547, 0u, _e1938.member_1);
                                    } else {
                                        if (_e543.member_1 >= _e89) {
                                            phi_3344_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e543.member_1 < _e89) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e559 = (_e260 * 2u);
                                            let _e561 = ((1u + _e559) % 7u);
                                            if (_e561 < 7u) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e566 = global_5.member[_e543.member_1][_e561];
                                            let _e568 = ((_e559 + 2u) % 7u);
                                            if (_e568 < 7u) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e573 = global_5.member[_e543.member_1][_e568];
                                            let _e574 = (_e259 * 2u);
                                            let _e576 = ((1u + _e574) % 7u);
                                            if (_e576 < 7u) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e581 = global_5.member[_e543.member_1][_e576];
                                            let _e583 = ((_e574 + 2u) % 7u);
                                            if (_e583 < 7u) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e588 = global_5.member[_e543.member_1][_e583];
                                            let _e589 = (_e261 * 2u);
                                            let _e591 = ((1u + _e589) % 7u);
                                            if (_e591 < 7u) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e596 = global_5.member[_e543.member_1][_e591];
                                            let _e598 = ((_e589 + 2u) % 7u);
                                            if (_e598 < 7u) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e603 = global_5.member[_e543.member_1][_e598];
                                            let _e626 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.x - _e543.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e627 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.y - _e543.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e628 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.z - _e543.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e630 = select(_e140, _e626, (_e626 > _e140));
                                            let _e632 = select(_e140, _e627, (_e627 > _e140));
                                            let _e634 = select(_e140, _e628, (_e628 > _e140));
                                            let _e659 = bitcast<u32>((f32(bitcast<i32>((_e566 & 2097151u))) * _e630));
                                            let _e664 = (bitcast<i32>((_e566 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e667 = bitcast<f32>((_e659 & bitcast<u32>(_e664)));
                                            let _e668 = bitcast<u32>((f32(bitcast<i32>((_e581 & 2097151u))) * _e632));
                                            let _e673 = (bitcast<i32>((_e581 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e676 = bitcast<f32>((_e668 & bitcast<u32>(_e673)));
                                            let _e677 = bitcast<u32>((f32(bitcast<i32>((_e596 & 2097151u))) * _e634));
                                            let _e682 = (bitcast<i32>((_e596 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                            let _e689 = bitcast<f32>((_e659 & bitcast<u32>(~(_e664))));
                                            let _e693 = bitcast<f32>((_e668 & bitcast<u32>(~(_e673))));
                                            let _e697 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                            let _e698 = bitcast<u32>((f32(bitcast<i32>((_e573 & 2097151u))) * _e630));
                                            let _e703 = (bitcast<i32>((_e573 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e706 = bitcast<f32>((_e698 & bitcast<u32>(_e703)));
                                            let _e707 = bitcast<u32>((f32(bitcast<i32>((_e588 & 2097151u))) * _e632));
                                            let _e712 = (bitcast<i32>((_e588 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e715 = bitcast<f32>((_e707 & bitcast<u32>(_e712)));
                                            let _e716 = bitcast<u32>((f32(bitcast<i32>((_e603 & 2097151u))) * _e634));
                                            let _e721 = (bitcast<i32>((_e603 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e724 = bitcast<f32>((_e716 & bitcast<u32>(_e721)));
                                            let _e728 = bitcast<f32>((_e698 & bitcast<u32>(~(_e703))));
                                            let _e732 = bitcast<f32>((_e707 & bitcast<u32>(~(_e712))));
                                            let _e736 = bitcast<f32>((_e716 & bitcast<u32>(~(_e721))));
                                            let _e737 = (_e543.member.member.x + _e667);
                                            let _e738 = (_e543.member.member.y + _e676);
                                            let _e739 = (_e543.member.member.z + _e685);
                                            let _e742 = (_e543.member.member_1.x - _e706);
                                            let _e743 = (_e543.member.member_1.y - _e715);
                                            let _e744 = (_e543.member.member_1.z - _e724);
                                            let _e763 = (_e742 - _e737);
                                            let _e764 = (_e743 - _e738);
                                            let _e765 = (_e744 - _e739);
                                            let _e767 = select(_e764, _e763, (_e763 > _e764));
                                            let _e769 = select(_e765, _e767, (_e767 > _e765));
                                            if (_e769 < (1024f * _e140)) {
                                                phi_3045_ = 0u;
                                            } else {
                                                phi_3045_ = select(2u, 1u, (_e769 < (2097152f * _e140)));
                                            }
                                            let _e776 = phi_3045_;
                                            switch bitcast<i32>(_e776) {
                                                case 0: {
                                                    phi_3051_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3051_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3051_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3051_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e779 = phi_3051_;
                                            let _e785 = global_5.member[_e543.member_1][0u];
                                            let _e789 = global_5.member[_e543.member_1][2u];
                                            let _e793 = global_5.member[_e543.member_1][4u];
                                            let _e797 = global_5.member[_e543.member_1][6u];
                                            let _e809 = (((_e789 >> bitcast<u32>(22i)) | ((_e793 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e797 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e810 = (_e785 & 268435455u);
                                            let _e811 = (_e809 & 268435455u);
                                            let _e814 = ((_e785 >> bitcast<u32>(28u)) & 7u);
                                            let _e822 = ((_e785 >> bitcast<u32>(31i)) | (((_e809 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e823 = (_e814 != 0u);
                                            if (_e814 == 0u) {
                                                phi_3306_ = _e810;
                                            } else {
                                                if (_e814 == 7u) {
                                                    phi_3305_ = 2147483648u;
                                                } else {
                                                    phi_3305_ = ((2147483648u | (_e814 << bitcast<u32>(28u))) | (_e811 & 268435455u));
                                                }
                                                let _e832 = phi_3305_;
                                                phi_3306_ = _e832;
                                            }
                                            let _e834 = phi_3306_;
                                            if _e823 {
                                                let _e835 = (_e814 != 7u);
                                                if _e835 {
                                                    phi_3316_ = (_e811 + (_e814 * ((3u * _e779) + 1u)));
                                                } else {
                                                    phi_3316_ = u32();
                                                }
                                                let _e839 = phi_3316_;
                                                phi_3318_ = _e839;
                                                phi_3319_ = select(true, false, _e835);
                                            } else {
                                                phi_3318_ = u32();
                                                phi_3319_ = true;
                                            }
                                            let _e842 = phi_3318_;
                                            let _e844 = phi_3319_;
                                            if (_e822 == 0u) {
                                                phi_3340_ = (_e810 + select(0u, 1u, !(_e823)));
                                            } else {
                                                if (_e822 == 7u) {
                                                    phi_3339_ = 2147483648u;
                                                } else {
                                                    phi_3339_ = ((2147483648u | (_e822 << bitcast<u32>(28u))) | (select(_e842, _e811, _e844) & 268435455u));
                                                }
                                                let _e857 = phi_3339_;
                                                phi_3340_ = _e857;
                                            }
                                            let _e859 = phi_3340_;
                                            phi_3344_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e737, (_e543.member.member.x + _e689), _e742, (_e543.member.member_1.x - _e728)), vec4<f32>(_e738, (_e543.member.member.y + _e693), _e743, (_e543.member.member_1.y - _e732)), vec4<f32>(_e739, (_e543.member.member.z + _e697), _e744, (_e543.member.member_1.z - _e736))), type_45(type_24((_e543.member.member + vec4<f32>(_e667, _e676, _e685, 0f)), (_e543.member.member_1 - vec4<f32>(_e706, _e715, _e724, 0f))), _e834), type_45(type_24((_e543.member.member + vec4<f32>(_e689, _e693, _e697, 0f)), (_e543.member.member_1 - vec4<f32>(_e728, _e732, _e736, 0f))), _e859));
                                        }
                                        let _e864 = phi_3344_;
                                        let _e876 = ((_e864.member[0].x - _e332) * _e337);
                                        let _e877 = ((_e864.member[0].y - _e332) * _e337);
                                        let _e878 = ((_e864.member[0].z - _e333) * _e337);
                                        let _e879 = ((_e864.member[0].w - _e333) * _e337);
                                        let _e889 = ((_e864.member[1].x - _e370) * _e375);
                                        let _e890 = ((_e864.member[1].y - _e370) * _e375);
                                        let _e891 = ((_e864.member[1].z - _e371) * _e375);
                                        let _e892 = ((_e864.member[1].w - _e371) * _e375);
                                        let _e902 = ((_e864.member[2].x - _e408) * _e413);
                                        let _e903 = ((_e864.member[2].y - _e408) * _e413);
                                        let _e904 = ((_e864.member[2].z - _e409) * _e413);
                                        let _e905 = ((_e864.member[2].w - _e409) * _e413);
                                        let _e907 = select(_e904, _e902, (_e902 < _e904));
                                        let _e909 = select(_e905, _e903, (_e903 < _e905));
                                        let _e911 = select(_e904, _e902, (_e902 > _e904));
                                        let _e913 = select(_e905, _e903, (_e903 > _e905));
                                        let _e915 = select(_e878, _e876, (_e876 < _e878));
                                        let _e917 = select(_e879, _e877, (_e877 < _e879));
                                        let _e919 = select(_e891, _e889, (_e889 < _e891));
                                        let _e921 = select(_e892, _e890, (_e890 < _e892));
                                        let _e923 = select(_e919, _e915, (_e915 > _e919));
                                        let _e925 = select(_e921, _e917, (_e917 > _e921));
                                        let _e927 = select(_e907, _e923, (_e923 > _e907));
                                        let _e929 = select(_e909, _e925, (_e925 > _e909));
                                        let _e931 = select(_e878, _e876, (_e876 > _e878));
                                        let _e933 = select(_e879, _e877, (_e877 > _e879));
                                        let _e935 = select(_e891, _e889, (_e889 > _e891));
                                        let _e937 = select(_e892, _e890, (_e890 > _e892));
                                        let _e939 = select(_e935, _e931, (_e931 < _e935));
                                        let _e941 = select(_e937, _e933, (_e933 < _e937));
                                        let _e946 = -(_e907);
                                        let _e947 = -(_e909);
                                        let _e954 = (select(_e911, _e939, (_e939 < _e911)) + (select(_e946, _e911, (_e911 > _e946)) * 0.0000019073523f));
                                        let _e955 = (select(_e913, _e941, (_e941 < _e913)) + (select(_e947, _e913, (_e913 > _e947)) * 0.0000019073523f));
                                        let _e957 = select(_e460, _e927, (_e927 > _e460));
                                        let _e959 = select(_e460, _e929, (_e929 > _e460));
                                        let _e964 = (_e957 <= select(_e504.member, _e954, (_e954 < _e504.member)));
                                        let _e965 = (_e959 <= select(_e504.member, _e955, (_e955 < _e504.member)));
                                        let _e966 = (_e957 <= _e959);
                                        if _e964 {
                                            if _e965 {
                                                if _e966 {
                                                    phi_3688_ = _e864.member_2;
                                                } else {
                                                    phi_3688_ = _e864.member_1;
                                                }
                                                let _e970 = phi_3688_;
                                                let _e992 = (_e547 % 128u);
                                                let _e993 = (_e992 < 128u);
                                                if _e993 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_8[_e992] = _e970.member_1;
                                                if _e993 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_7[_e992] = _e970.member.member.x;
                                                if _e993 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_6[_e992] = _e970.member.member.y;
                                                if _e993 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_5[_e992] = _e970.member.member.z;
                                                if _e993 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_4[_e992] = _e970.member.member_1.x;
                                                if _e993 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_3[_e992] = _e970.member.member_1.y;
                                                if _e993 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_2[_e992] = _e970.member.member_1.z;
                                                if _e993 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_9[_e992] = select(_e959, _e957, (_e957 > _e959));
                                                if _e966 {
                                                    phi_3765_ = _e864.member_1;
                                                } else {
                                                    phi_3765_ = _e864.member_2;
                                                }
                                                let _e1006 = phi_3765_;
                                                phi_3766_ = _e1006;
                                                phi_3767_ = (_e547 + 1u);
                                            } else {
                                                phi_3766_ = type_45();
                                                phi_3767_ = u32();
                                            }
                                            let _e1008 = phi_3766_;
                                            let _e1010 = phi_3767_;
                                            phi_3769_ = _e1008;
                                            phi_3770_ = _e1010;
                                            phi_3771_ = select(true, false, _e965);
                                        } else {
                                            phi_3769_ = type_45();
                                            phi_3770_ = u32();
                                            phi_3771_ = true;
                                        }
                                        let _e1013 = phi_3769_;
                                        let _e1015 = phi_3770_;
                                        let _e1017 = phi_3771_;
                                        if _e1017 {
                                            if _e964 {
                                                phi_3780_ = _e864.member_1;
                                            } else {
                                                phi_3780_ = _e864.member_2;
                                            }
                                            let _e1021 = phi_3780_;
                                            phi_3785_ = _e1021;
                                            phi_3786_ = select(_e965, true, _e964);
                                        } else {
                                            phi_3785_ = _e1013;
                                            phi_3786_ = _e545;
                                        }
                                        let _e1024 = phi_3785_;
                                        let _e1026 = phi_3786_;
                                        phi_4196_ = _e502;
                                        phi_3788_ = _e504;
                                        phi_3789_ = _e1024;
                                        phi_3790_ = _e1026;
                                        phi_3791_ = select(_e1015, _e547, _e1017);
                                    }
                                    let _e1942 = phi_4196_;
                                    let _e1944 = phi_3788_;
                                    let _e1946 = phi_3789_;
                                    let _e1948 = phi_3790_;
                                    let _e1950 = phi_3791_;
                                    phi_4195_ = _e1942;
                                    phi_3792_ = _e1944;
                                    phi_3793_ = _e1946;
                                    phi_3794_ = (_e508 - 1u);
                                    phi_3795_ = _e1948;
                                    phi_3796_ = _e1950;
                                } else {
                                    phi_4195_ = _e502;
                                    phi_3792_ = _e504;
                                    phi_3793_ = _e543;
                                    phi_3794_ = _e508;
                                    phi_3795_ = _e545;
                                    phi_3796_ = _e547;
                                }
                                let _e1952 = phi_4195_;
                                let _e1954 = phi_3792_;
                                let _e1956 = phi_3793_;
                                let _e1958 = phi_3794_;
                                let _e1960 = phi_3795_;
                                let _e1962 = phi_3796_;
                                phi_4194_ = _e1952;
                                phi_3797_ = _e1954;
                                phi_3798_ = _e1956;
                                phi_3799_ = _e1958;
                                phi_3800_ = _e1960;
                                phi_3801_ = _e1962;
                            } else {
                                phi_4194_ = _e502;
                                phi_3797_ = type_34();
                                phi_3798_ = type_45();
                                phi_3799_ = u32();
                                phi_3800_ = bool();
                                phi_3801_ = u32();
                            }
                            let _e1964 = phi_4194_;
                            let _e1966 = phi_3797_;
                            let _e1968 = phi_3798_;
                            let _e1970 = phi_3799_;
                            let _e1972 = phi_3800_;
                            let _e1974 = phi_3801_;
                            phi_4193_ = _e1964;
                            phi_847_ = _e1966;
                            phi_850_ = _e1968;
                            phi_852_ = _e1970;
                            phi_854_ = _e1972;
                            phi_856_ = _e1974;
                            phi_3802_ = _e516;
                        } else {
                            phi_4193_ = _e502;
                            phi_847_ = type_34();
                            phi_850_ = type_45();
                            phi_852_ = u32();
                            phi_854_ = bool();
                            phi_856_ = u32();
                            phi_3802_ = false;
                        }
                        let _e1976 = phi_4193_;
                        let _e1978 = phi_847_;
                        let _e1980 = phi_850_;
                        let _e1982 = phi_852_;
                        let _e1984 = phi_854_;
                        let _e1986 = phi_856_;
                        let _e1988 = phi_3802_;
                        continue;
                        continuing {
                            phi_4012_ = _e1976;
                            phi_846_ = _e1978;
                            phi_849_ = _e1980;
                            phi_851_ = _e1982;
                            phi_853_ = _e1984;
                            phi_855_ = _e1986;
                            phi_4192_ = _e1976;
                            break if !(_e1988);
                        }
                    }
                    let _e1991 = phi_4192_;
                    if _e1991 {
                        break;
                    }
                    let _e1993 = local_11;
                    if _e148 {
                    } else {
                        break;
                    }
                    global_4.member[_e146] = select(0u, 1u, _e1993.member_1);
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
