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
    var phi_394_: i32;
    var phi_395_: i32;
    var phi_405_: bool;
    var phi_415_: u32;
    var phi_416_: u32;
    var phi_418_: bool;
    var phi_423_: u32;
    var phi_435_: i32;
    var phi_455_: i32;
    var phi_473_: f32;
    var phi_479_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_519_: f32;
    var phi_530_: f32;
    var phi_539_: f32;
    var phi_545_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_585_: f32;
    var phi_596_: f32;
    var phi_605_: f32;
    var phi_611_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_651_: f32;
    var phi_662_: f32;
    var phi_762_: f32;
    var phi_763_: f32;
    var phi_4049_: bool;
    var phi_853_: type_39;
    var phi_856_: type_50;
    var phi_858_: u32;
    var phi_860_: bool;
    var phi_862_: u32;
    var phi_873_: bool;
    var phi_959_: type_50;
    var phi_960_: bool;
    var phi_961_: u32;
    var phi_3080_: u32;
    var phi_3086_: u32;
    var phi_3340_: u32;
    var phi_3341_: u32;
    var phi_3351_: u32;
    var phi_3353_: u32;
    var phi_3354_: bool;
    var phi_3374_: u32;
    var phi_3375_: u32;
    var phi_3379_: type_51;
    var phi_3723_: type_50;
    var phi_3800_: type_50;
    var phi_3801_: type_50;
    var phi_3802_: u32;
    var phi_3804_: type_50;
    var phi_3805_: u32;
    var phi_3806_: bool;
    var phi_3815_: type_50;
    var phi_3820_: type_50;
    var phi_3821_: bool;
    var phi_980_: type_39;
    var phi_983_: type_8;
    var phi_984_: type_8;
    var phi_1006_: type_8;
    var phi_1050_: u32;
    var phi_1056_: u32;
    var phi_1066_: u32;
    var phi_1082_: u32;
    var phi_1115_: u32;
    var phi_1121_: u32;
    var phi_1548_: u32;
    var phi_1566_: u32;
    var phi_1584_: u32;
    var phi_1604_: u32;
    var phi_1622_: u32;
    var phi_1640_: u32;
    var phi_1660_: u32;
    var phi_1678_: u32;
    var phi_1696_: u32;
    var phi_1274_: u32;
    var phi_1289_: u32;
    var phi_1299_: u32;
    var phi_1319_: u32;
    var phi_1339_: u32;
    var phi_1365_: u32;
    var phi_1380_: u32;
    var phi_1390_: u32;
    var phi_1410_: u32;
    var phi_1430_: u32;
    var phi_1456_: u32;
    var phi_1471_: u32;
    var phi_1481_: u32;
    var phi_1501_: u32;
    var phi_1521_: u32;
    var phi_1145_: u32;
    var phi_1188_: u32;
    var phi_1231_: u32;
    var phi_1702_: array<array<f32, 3>, 3>;
    var phi_1819_: bool;
    var phi_1848_: bool;
    var phi_2249_: f32;
    var phi_2250_: f32;
    var phi_2251_: f32;
    var phi_2252_: f32;
    var phi_2253_: vec3<f32>;
    var phi_2254_: vec3<f32>;
    var phi_2255_: vec3<f32>;
    var phi_2256_: vec3<f32>;
    var phi_2287_: bool;
    var phi_2296_: vec3<f32>;
    var phi_2463_: bool;
    var phi_2487_: f32;
    var phi_2488_: f32;
    var phi_2511_: type_24;
    var phi_2513_: type_24;
    var phi_2514_: bool;
    var phi_2518_: type_24;
    var phi_2519_: type_24;
    var phi_2520_: type_24;
    var phi_2521_: bool;
    var phi_2525_: type_24;
    var phi_2526_: bool;
    var phi_2527_: type_24;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2530_: type_24;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2540_: type_24;
    var phi_2541_: bool;
    var phi_2545_: type_24;
    var phi_2570_: bool;
    var phi_2571_: bool;
    var phi_2578_: type_39;
    var phi_2579_: type_39;
    var phi_2580_: type_39;
    var phi_981_: type_39;
    var phi_4043_: bool;
    var phi_4236_: bool;
    var phi_3823_: type_39;
    var phi_3824_: type_50;
    var phi_3825_: bool;
    var phi_3826_: u32;
    var phi_4235_: bool;
    var phi_3827_: type_39;
    var phi_3828_: type_50;
    var phi_3829_: u32;
    var phi_3830_: bool;
    var phi_3831_: u32;
    var phi_4234_: bool;
    var phi_3832_: type_39;
    var phi_3833_: type_50;
    var phi_3834_: u32;
    var phi_3835_: bool;
    var phi_3836_: u32;
    var phi_4233_: bool;
    var phi_854_: type_39;
    var phi_857_: type_50;
    var phi_859_: u32;
    var phi_861_: bool;
    var phi_863_: u32;
    var phi_3837_: bool;
    var phi_4232_: bool;
    var local_10: type_39;
    var local_11: type_39;
    var local_12: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_4.member));
            let _e92 = arrayLength((&global_5.member));
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
                let _e148 = (_e146 < arrayLength((&global_6.member)));
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
                            phi_394_ = (bitcast<i32>((_e225 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_394_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e225)), 32u, (_e225 == 0u))));
                        }
                        let _e239 = phi_394_;
                        phi_395_ = _e239;
                    } else {
                        phi_395_ = 0i;
                    }
                    let _e241 = phi_395_;
                    let _e242 = (_e158 == _e197);
                    if _e242 {
                        phi_405_ = true;
                    } else {
                        phi_405_ = (_e165 == _e197);
                    }
                    let _e245 = phi_405_;
                    let _e246 = select(1u, 0u, _e242);
                    if _e245 {
                        let _e247 = (_e246 + 1u);
                        phi_415_ = _e247;
                        phi_416_ = _e247;
                        phi_418_ = select(true, false, (_e247 == 2u));
                    } else {
                        phi_415_ = u32();
                        phi_416_ = 0u;
                        phi_418_ = true;
                    }
                    let _e251 = phi_415_;
                    let _e253 = phi_416_;
                    let _e255 = phi_418_;
                    if _e255 {
                        phi_423_ = (_e253 + 1u);
                    } else {
                        phi_423_ = 0u;
                    }
                    let _e259 = phi_423_;
                    let _e260 = select(_e251, _e253, _e255);
                    let _e261 = select(_e246, select(2u, _e246, _e245), _e255);
                    if (_e128 < -126i) {
                        phi_435_ = -126i;
                    } else {
                        phi_435_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e266 = phi_435_;
                    let _e271 = bitcast<f32>((bitcast<u32>((_e266 + 127i)) << bitcast<u32>(23i)));
                    let _e277 = bitcast<f32>((bitcast<u32>(((_e128 - _e266) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = -(_e241);
                    if (_e278 < -126i) {
                        phi_455_ = -126i;
                    } else {
                        phi_455_ = select(_e278, 127i, (_e278 > 127i));
                    }
                    let _e283 = phi_455_;
                    let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                    let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                    let _e298 = global_3.member[_e146].member;
                    let _e299 = (_e260 == 0u);
                    if _e299 {
                        phi_473_ = _e298[0];
                    } else {
                        phi_473_ = _e298[1];
                    }
                    let _e303 = phi_473_;
                    let _e304 = (_e260 == 2u);
                    if _e304 {
                        phi_479_ = _e298[2];
                    } else {
                        phi_479_ = _e303;
                    }
                    let _e307 = phi_479_;
                    let _e309 = ((_e307 * _e271) * _e277);
                    let _e310 = global_3.member[_e146].member_2;
                    if _e299 {
                        phi_490_ = _e310[0];
                    } else {
                        phi_490_ = _e310[1];
                    }
                    let _e314 = phi_490_;
                    if _e304 {
                        phi_496_ = _e310[2];
                    } else {
                        phi_496_ = _e314;
                    }
                    let _e317 = phi_496_;
                    let _e319 = ((_e317 * _e288) * _e294);
                    let _e323 = (bitcast<f32>((bitcast<u32>(_e319) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e323 {
                        let _e327 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_519_ = select(0.00000000000011368684f, _e327, (_e327 > 0.00000000000011368684f));
                    } else {
                        phi_519_ = 0f;
                    }
                    let _e331 = phi_519_;
                    let _e332 = (_e309 + _e331);
                    let _e333 = (_e309 - _e331);
                    let _e334 = select(_e319, 0f, _e323);
                    if _e323 {
                        phi_530_ = 38685626000000000000000000f;
                    } else {
                        phi_530_ = (1f / _e319);
                    }
                    let _e337 = phi_530_;
                    let _e338 = (_e259 == 0u);
                    if _e338 {
                        phi_539_ = _e298[0];
                    } else {
                        phi_539_ = _e298[1];
                    }
                    let _e342 = phi_539_;
                    let _e343 = (_e259 == 2u);
                    if _e343 {
                        phi_545_ = _e298[2];
                    } else {
                        phi_545_ = _e342;
                    }
                    let _e346 = phi_545_;
                    let _e348 = ((_e346 * _e271) * _e277);
                    if _e338 {
                        phi_556_ = _e310[0];
                    } else {
                        phi_556_ = _e310[1];
                    }
                    let _e352 = phi_556_;
                    if _e343 {
                        phi_562_ = _e310[2];
                    } else {
                        phi_562_ = _e352;
                    }
                    let _e355 = phi_562_;
                    let _e357 = ((_e355 * _e288) * _e294);
                    let _e361 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e361 {
                        let _e365 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) * 0.00000011920929f);
                        phi_585_ = select(0.00000000000011368684f, _e365, (_e365 > 0.00000000000011368684f));
                    } else {
                        phi_585_ = 0f;
                    }
                    let _e369 = phi_585_;
                    let _e370 = (_e348 + _e369);
                    let _e371 = (_e348 - _e369);
                    let _e372 = select(_e357, 0f, _e361);
                    if _e361 {
                        phi_596_ = 38685626000000000000000000f;
                    } else {
                        phi_596_ = (1f / _e357);
                    }
                    let _e375 = phi_596_;
                    let _e376 = (_e261 == 0u);
                    if _e376 {
                        phi_605_ = _e298[0];
                    } else {
                        phi_605_ = _e298[1];
                    }
                    let _e380 = phi_605_;
                    let _e381 = (_e261 == 2u);
                    if _e381 {
                        phi_611_ = _e298[2];
                    } else {
                        phi_611_ = _e380;
                    }
                    let _e384 = phi_611_;
                    let _e386 = ((_e384 * _e271) * _e277);
                    if _e376 {
                        phi_622_ = _e310[0];
                    } else {
                        phi_622_ = _e310[1];
                    }
                    let _e390 = phi_622_;
                    if _e381 {
                        phi_628_ = _e310[2];
                    } else {
                        phi_628_ = _e390;
                    }
                    let _e393 = phi_628_;
                    let _e395 = ((_e393 * _e288) * _e294);
                    let _e399 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e399 {
                        let _e403 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) * 0.00000011920929f);
                        phi_651_ = select(0.00000000000011368684f, _e403, (_e403 > 0.00000000000011368684f));
                    } else {
                        phi_651_ = 0f;
                    }
                    let _e407 = phi_651_;
                    let _e408 = (_e386 + _e407);
                    let _e409 = (_e386 - _e407);
                    let _e410 = select(_e395, 0f, _e399);
                    if _e399 {
                        phi_662_ = 38685626000000000000000000f;
                    } else {
                        phi_662_ = (1f / _e395);
                    }
                    let _e413 = phi_662_;
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
                        phi_762_ = select(-340282350000000000000000000000000000000f, _e454, (_e454 > -340282350000000000000000000000000000000f));
                        phi_763_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_762_ = 0f;
                        phi_763_ = 1f;
                    }
                    let _e458 = phi_762_;
                    let _e460 = phi_763_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e465 = (_e260 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_1[_e465];
                    let _e471 = (_e259 % 3u);
                    let _e472 = (_e471 < 3u);
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e474 = local_1[_e471];
                    let _e477 = (_e261 % 3u);
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
                    phi_4049_ = false;
                    phi_853_ = type_39(type_32(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e458), 0u, 0u);
                    phi_856_ = type_50(type_28(vec4<f32>((f32(_e468) * _e140), (f32(_e474) * _e140), (f32(_e480) * _e140), 0f), vec4<f32>((f32(_e485) * _e140), (f32(_e489) * _e140), (f32(_e493) * _e140), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_858_ = ((3u * _e89) + 1u);
                    phi_860_ = (_e460 <= _e458);
                    phi_862_ = 0u;
                    loop {
                        let _e503 = phi_4049_;
                        let _e505 = phi_853_;
                        let _e507 = phi_856_;
                        let _e509 = phi_858_;
                        let _e511 = phi_860_;
                        let _e513 = phi_862_;
                        local_10 = _e505;
                        local_11 = _e505;
                        if _e511 {
                            phi_873_ = true;
                        } else {
                            phi_873_ = (_e513 > 0u);
                        }
                        let _e516 = phi_873_;
                        if _e516 {
                            let _e517 = (_e509 > 0u);
                            if _e517 {
                                if _e511 {
                                    phi_959_ = _e507;
                                    phi_960_ = _e511;
                                    phi_961_ = _e513;
                                } else {
                                    let _e518 = (_e513 - 1u);
                                    let _e519 = (_e518 % 128u);
                                    let _e520 = (_e519 < 128u);
                                    if _e520 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e522 = local_7[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e524 = local_6[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e526 = local_5[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e528 = local_4[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e530 = local_3[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e532 = local_2[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e537 = local_8[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e540 = local_9[_e519];
                                    phi_959_ = type_50(type_28(vec4<f32>(_e522, _e524, _e526, 0f), vec4<f32>(_e528, _e530, _e532, 0f)), _e537);
                                    phi_960_ = (_e540 <= _e505.member.member_1);
                                    phi_961_ = _e518;
                                }
                                let _e545 = phi_959_;
                                let _e547 = phi_960_;
                                let _e549 = phi_961_;
                                if _e547 {
                                    let _e554 = (_e545.member_1 & 268435455u);
                                    if ((_e545.member_1 & 2147483648u) != 0u) {
                                        phi_980_ = _e505;
                                        phi_983_ = type_8(0u, ((_e545.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1039 = phi_980_;
                                            let _e1041 = phi_983_;
                                            local_12 = _e1039;
                                            if (_e1041.member < _e1041.member_1) {
                                                phi_984_ = type_8((_e1041.member + 1u), _e1041.member_1);
                                                phi_1006_ = type_8(1u, _e1041.member);
                                            } else {
                                                phi_984_ = _e1041;
                                                phi_1006_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1054 = phi_984_;
                                            let _e1056 = phi_1006_;
                                            let _e1060 = (bitcast<i32>(_e1056.member) != 0i);
                                            if _e1060 {
                                                let _e1066 = type_39(_e1039.member, _e1039.member_1, (_e1039.member_2 + 1u));
                                                let _e1071 = (_e545.member.member_1.x - _e545.member.member.x);
                                                let _e1074 = (_e545.member.member_1.y - _e545.member.member.y);
                                                let _e1077 = (_e545.member.member_1.z - _e545.member.member.z);
                                                let _e1079 = select(_e1074, _e1071, (_e1071 > _e1074));
                                                let _e1081 = select(_e1077, _e1079, (_e1079 > _e1077));
                                                let _e1083 = (_e1081 < (1024f * _e140));
                                                if _e1083 {
                                                    phi_1050_ = 0u;
                                                } else {
                                                    phi_1050_ = select(2u, 1u, (_e1081 < (2097152f * _e140)));
                                                }
                                                let _e1088 = phi_1050_;
                                                switch bitcast<i32>(_e1088) {
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
                                                let _e1091 = phi_1056_;
                                                switch bitcast<i32>(_e1088) {
                                                    case 0: {
                                                        phi_1066_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1066_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1066_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1066_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1098 = phi_1066_;
                                                let _e1100 = ((_e554 + (_e1056.member_1 * ((3u * _e1091) + 1u))) + (3u * _e1098));
                                                let _e1101 = (_e1100 < _e92);
                                                if _e1101 {
                                                    if _e1101 {
                                                    } else {
                                                        phi_4043_ = true;
                                                        break;
                                                    }
                                                    let _e1103 = global_5.member[_e1100];
                                                    phi_1082_ = _e1103;
                                                } else {
                                                    phi_1082_ = 4294967295u;
                                                }
                                                let _e1105 = phi_1082_;
                                                if _e1083 {
                                                    phi_1115_ = 0u;
                                                } else {
                                                    phi_1115_ = select(2u, 1u, (_e1081 < (2097152f * _e140)));
                                                }
                                                let _e1110 = phi_1115_;
                                                switch bitcast<i32>(_e1110) {
                                                    case 0: {
                                                        phi_1121_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1121_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1121_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1121_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1113 = phi_1121_;
                                                let _e1117 = (_e554 + (_e1056.member_1 * ((3u * _e1113) + 1u)));
                                                switch bitcast<i32>(_e1110) {
                                                    case 0: {
                                                        let _e1383 = (_e1117 < _e92);
                                                        if _e1383 {
                                                            if _e1383 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1385 = global_5.member[_e1117];
                                                            phi_1145_ = _e1385;
                                                        } else {
                                                            phi_1145_ = 0u;
                                                        }
                                                        let _e1387 = phi_1145_;
                                                        let _e1389 = ((10u * _e260) & 31u);
                                                        let _e1398 = ((10u * _e259) & 31u);
                                                        let _e1407 = ((10u * _e261) & 31u);
                                                        let _e1416 = (_e1117 + 1u);
                                                        let _e1417 = (_e1416 < _e92);
                                                        if _e1417 {
                                                            if _e1417 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1419 = global_5.member[_e1416];
                                                            phi_1188_ = _e1419;
                                                        } else {
                                                            phi_1188_ = 0u;
                                                        }
                                                        let _e1421 = phi_1188_;
                                                        let _e1444 = (_e1117 + 2u);
                                                        let _e1445 = (_e1444 < _e92);
                                                        if _e1445 {
                                                            if _e1445 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1447 = global_5.member[_e1444];
                                                            phi_1231_ = _e1447;
                                                        } else {
                                                            phi_1231_ = 0u;
                                                        }
                                                        let _e1449 = phi_1231_;
                                                        phi_1702_ = array<array<f32, 3>, 3>(array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>(((_e1387 >> bitcast<u32>(_e1389)) & 1023u))) * _e140)), (_e545.member.member.y + (f32(bitcast<i32>(((_e1387 >> bitcast<u32>(_e1398)) & 1023u))) * _e140)), (_e545.member.member.z + (f32(bitcast<i32>(((_e1387 >> bitcast<u32>(_e1407)) & 1023u))) * _e140))), array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>(((_e1421 >> bitcast<u32>(_e1389)) & 1023u))) * _e140)), (_e545.member.member.y + (f32(bitcast<i32>(((_e1421 >> bitcast<u32>(_e1398)) & 1023u))) * _e140)), (_e545.member.member.z + (f32(bitcast<i32>(((_e1421 >> bitcast<u32>(_e1407)) & 1023u))) * _e140))), array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>(((_e1449 >> bitcast<u32>(_e1389)) & 1023u))) * _e140)), (_e545.member.member.y + (f32(bitcast<i32>(((_e1449 >> bitcast<u32>(_e1398)) & 1023u))) * _e140)), (_e545.member.member.z + (f32(bitcast<i32>(((_e1449 >> bitcast<u32>(_e1407)) & 1023u))) * _e140))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1206 = (_e1117 < _e92);
                                                        if _e1206 {
                                                            if _e1206 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1208 = global_5.member[_e1117];
                                                            phi_1274_ = _e1208;
                                                        } else {
                                                            phi_1274_ = 0u;
                                                        }
                                                        let _e1210 = phi_1274_;
                                                        let _e1211 = (_e1117 + 1u);
                                                        let _e1212 = (_e1211 < _e92);
                                                        if _e1212 {
                                                            if _e1212 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1214 = global_5.member[_e1211];
                                                            phi_1289_ = _e1214;
                                                        } else {
                                                            phi_1289_ = 0u;
                                                        }
                                                        let _e1216 = phi_1289_;
                                                        let _e1217 = (_e260 == 1u);
                                                        if _e1217 {
                                                            phi_1299_ = ((_e1210 >> bitcast<u32>(21i)) | (_e1216 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1299_ = (_e1216 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1226 = phi_1299_;
                                                        let _e1233 = (_e259 == 1u);
                                                        if _e1233 {
                                                            phi_1319_ = ((_e1210 >> bitcast<u32>(21i)) | (_e1216 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1319_ = (_e1216 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1242 = phi_1319_;
                                                        let _e1249 = (_e261 == 1u);
                                                        if _e1249 {
                                                            phi_1339_ = ((_e1210 >> bitcast<u32>(21i)) | (_e1216 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1339_ = (_e1216 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1258 = phi_1339_;
                                                        let _e1266 = (_e1117 + 2u);
                                                        let _e1267 = (_e1266 < _e92);
                                                        if _e1267 {
                                                            if _e1267 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1269 = global_5.member[_e1266];
                                                            phi_1365_ = _e1269;
                                                        } else {
                                                            phi_1365_ = 0u;
                                                        }
                                                        let _e1271 = phi_1365_;
                                                        let _e1272 = (_e1117 + 3u);
                                                        let _e1273 = (_e1272 < _e92);
                                                        if _e1273 {
                                                            if _e1273 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1275 = global_5.member[_e1272];
                                                            phi_1380_ = _e1275;
                                                        } else {
                                                            phi_1380_ = 0u;
                                                        }
                                                        let _e1277 = phi_1380_;
                                                        if _e1217 {
                                                            phi_1390_ = ((_e1271 >> bitcast<u32>(21i)) | (_e1277 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1390_ = (_e1277 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1286 = phi_1390_;
                                                        if _e1233 {
                                                            phi_1410_ = ((_e1271 >> bitcast<u32>(21i)) | (_e1277 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1410_ = (_e1277 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1301 = phi_1410_;
                                                        if _e1249 {
                                                            phi_1430_ = ((_e1271 >> bitcast<u32>(21i)) | (_e1277 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1430_ = (_e1277 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1316 = phi_1430_;
                                                        let _e1324 = (_e1117 + 4u);
                                                        let _e1325 = (_e1324 < _e92);
                                                        if _e1325 {
                                                            if _e1325 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1327 = global_5.member[_e1324];
                                                            phi_1456_ = _e1327;
                                                        } else {
                                                            phi_1456_ = 0u;
                                                        }
                                                        let _e1329 = phi_1456_;
                                                        let _e1330 = (_e1117 + 5u);
                                                        let _e1331 = (_e1330 < _e92);
                                                        if _e1331 {
                                                            if _e1331 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1333 = global_5.member[_e1330];
                                                            phi_1471_ = _e1333;
                                                        } else {
                                                            phi_1471_ = 0u;
                                                        }
                                                        let _e1335 = phi_1471_;
                                                        if _e1217 {
                                                            phi_1481_ = ((_e1329 >> bitcast<u32>(21i)) | (_e1335 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1481_ = (_e1335 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1344 = phi_1481_;
                                                        if _e1233 {
                                                            phi_1501_ = ((_e1329 >> bitcast<u32>(21i)) | (_e1335 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1501_ = (_e1335 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1359 = phi_1501_;
                                                        if _e1249 {
                                                            phi_1521_ = ((_e1329 >> bitcast<u32>(21i)) | (_e1335 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1521_ = (_e1335 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1374 = phi_1521_;
                                                        phi_1702_ = array<array<f32, 3>, 3>(array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>((select(_e1226, _e1210, _e299) & 2097151u))) * _e140)), (_e545.member.member.y + (f32(bitcast<i32>((select(_e1242, _e1210, _e338) & 2097151u))) * _e140)), (_e545.member.member.z + (f32(bitcast<i32>((select(_e1258, _e1210, _e376) & 2097151u))) * _e140))), array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>((select(_e1286, _e1271, _e299) & 2097151u))) * _e140)), (_e545.member.member.y + (f32(bitcast<i32>((select(_e1301, _e1271, _e338) & 2097151u))) * _e140)), (_e545.member.member.z + (f32(bitcast<i32>((select(_e1316, _e1271, _e376) & 2097151u))) * _e140))), array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>((select(_e1344, _e1329, _e299) & 2097151u))) * _e140)), (_e545.member.member.y + (f32(bitcast<i32>((select(_e1359, _e1329, _e338) & 2097151u))) * _e140)), (_e545.member.member.z + (f32(bitcast<i32>((select(_e1374, _e1329, _e376) & 2097151u))) * _e140))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1119 = (_e1117 + _e260);
                                                        let _e1120 = (_e1119 < _e92);
                                                        if _e1120 {
                                                            if _e1120 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1122 = global_5.member[_e1119];
                                                            phi_1548_ = _e1122;
                                                        } else {
                                                            phi_1548_ = 0u;
                                                        }
                                                        let _e1124 = phi_1548_;
                                                        let _e1128 = (_e1117 + _e259);
                                                        let _e1129 = (_e1128 < _e92);
                                                        if _e1129 {
                                                            if _e1129 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1131 = global_5.member[_e1128];
                                                            phi_1566_ = _e1131;
                                                        } else {
                                                            phi_1566_ = 0u;
                                                        }
                                                        let _e1133 = phi_1566_;
                                                        let _e1137 = (_e1117 + _e261);
                                                        let _e1138 = (_e1137 < _e92);
                                                        if _e1138 {
                                                            if _e1138 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1140 = global_5.member[_e1137];
                                                            phi_1584_ = _e1140;
                                                        } else {
                                                            phi_1584_ = 0u;
                                                        }
                                                        let _e1142 = phi_1584_;
                                                        let _e1147 = (_e1117 + 3u);
                                                        let _e1148 = (_e1147 + _e260);
                                                        let _e1149 = (_e1148 < _e92);
                                                        if _e1149 {
                                                            if _e1149 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1151 = global_5.member[_e1148];
                                                            phi_1604_ = _e1151;
                                                        } else {
                                                            phi_1604_ = 0u;
                                                        }
                                                        let _e1153 = phi_1604_;
                                                        let _e1157 = (_e1147 + _e259);
                                                        let _e1158 = (_e1157 < _e92);
                                                        if _e1158 {
                                                            if _e1158 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1160 = global_5.member[_e1157];
                                                            phi_1622_ = _e1160;
                                                        } else {
                                                            phi_1622_ = 0u;
                                                        }
                                                        let _e1162 = phi_1622_;
                                                        let _e1166 = (_e1147 + _e261);
                                                        let _e1167 = (_e1166 < _e92);
                                                        if _e1167 {
                                                            if _e1167 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1169 = global_5.member[_e1166];
                                                            phi_1640_ = _e1169;
                                                        } else {
                                                            phi_1640_ = 0u;
                                                        }
                                                        let _e1171 = phi_1640_;
                                                        let _e1176 = (_e1117 + 6u);
                                                        let _e1177 = (_e1176 + _e260);
                                                        let _e1178 = (_e1177 < _e92);
                                                        if _e1178 {
                                                            if _e1178 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1180 = global_5.member[_e1177];
                                                            phi_1660_ = _e1180;
                                                        } else {
                                                            phi_1660_ = 0u;
                                                        }
                                                        let _e1182 = phi_1660_;
                                                        let _e1186 = (_e1176 + _e259);
                                                        let _e1187 = (_e1186 < _e92);
                                                        if _e1187 {
                                                            if _e1187 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1189 = global_5.member[_e1186];
                                                            phi_1678_ = _e1189;
                                                        } else {
                                                            phi_1678_ = 0u;
                                                        }
                                                        let _e1191 = phi_1678_;
                                                        let _e1195 = (_e1176 + _e261);
                                                        let _e1196 = (_e1195 < _e92);
                                                        if _e1196 {
                                                            if _e1196 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1198 = global_5.member[_e1195];
                                                            phi_1696_ = _e1198;
                                                        } else {
                                                            phi_1696_ = 0u;
                                                        }
                                                        let _e1200 = phi_1696_;
                                                        phi_1702_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1124)) * _e140), (f32(bitcast<i32>(_e1133)) * _e140), (f32(bitcast<i32>(_e1142)) * _e140)), array<f32, 3>((f32(bitcast<i32>(_e1153)) * _e140), (f32(bitcast<i32>(_e1162)) * _e140), (f32(bitcast<i32>(_e1171)) * _e140)), array<f32, 3>((f32(bitcast<i32>(_e1182)) * _e140), (f32(bitcast<i32>(_e1191)) * _e140), (f32(bitcast<i32>(_e1200)) * _e140)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1702_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1474 = phi_1702_;
                                                let _e1483 = (_e1474[0][2] - _e386);
                                                let _e1486 = (((_e1474[0][0] - _e309) * _e410) - (_e1483 * _e334));
                                                let _e1489 = (((_e1474[0][1] - _e348) * _e410) - (_e1483 * _e372));
                                                let _e1496 = (_e1474[1][2] - _e386);
                                                let _e1499 = (((_e1474[1][0] - _e309) * _e410) - (_e1496 * _e334));
                                                let _e1502 = (((_e1474[1][1] - _e348) * _e410) - (_e1496 * _e372));
                                                let _e1509 = (_e1474[2][2] - _e386);
                                                let _e1512 = (((_e1474[2][0] - _e309) * _e410) - (_e1509 * _e334));
                                                let _e1515 = (((_e1474[2][1] - _e348) * _e410) - (_e1509 * _e372));
                                                let _e1516 = (_e1512 * _e1502);
                                                let _e1517 = (_e1515 * _e1499);
                                                let _e1518 = (_e1486 * _e1515);
                                                let _e1519 = (_e1489 * _e1512);
                                                let _e1520 = (_e1499 * _e1489);
                                                let _e1521 = (_e1502 * _e1486);
                                                let _e1526 = (((_e1516 >= _e1517) && (_e1518 >= _e1519)) && (_e1520 >= _e1521));
                                                if (_e1526 || (((_e1516 <= _e1517) && (_e1518 <= _e1519)) && (_e1520 <= _e1521))) {
                                                    let _e1533 = select(-1f, 1f, _e1526);
                                                    let _e1535 = ((_e1516 - _e1517) * _e1533);
                                                    let _e1537 = select(0f, _e1535, (_e1535 > 0f));
                                                    let _e1539 = ((_e1518 - _e1519) * _e1533);
                                                    let _e1541 = select(0f, _e1539, (_e1539 > 0f));
                                                    let _e1543 = ((_e1520 - _e1521) * _e1533);
                                                    let _e1545 = select(0f, _e1543, (_e1543 > 0f));
                                                    let _e1547 = ((_e1537 + _e1541) + _e1545);
                                                    if (_e1547 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2530_ = type_24();
                                                        phi_2531_ = true;
                                                        phi_2532_ = false;
                                                    } else {
                                                        let _e1550 = select(_e1499, _e1486, (_e1486 < _e1499));
                                                        if (select(_e1512, _e1550, (_e1550 < _e1512)) > 0f) {
                                                            phi_1819_ = true;
                                                        } else {
                                                            let _e1555 = select(_e1499, _e1486, (_e1486 > _e1499));
                                                            phi_1819_ = (select(_e1512, _e1555, (_e1555 > _e1512)) < 0f);
                                                        }
                                                        let _e1560 = phi_1819_;
                                                        if _e1560 {
                                                            phi_2527_ = type_24();
                                                            phi_2528_ = true;
                                                            phi_2529_ = false;
                                                        } else {
                                                            let _e1562 = select(_e1502, _e1489, (_e1489 < _e1502));
                                                            if (select(_e1515, _e1562, (_e1562 < _e1515)) > 0f) {
                                                                phi_1848_ = true;
                                                            } else {
                                                                let _e1567 = select(_e1502, _e1489, (_e1489 > _e1502));
                                                                phi_1848_ = (select(_e1515, _e1567, (_e1567 > _e1515)) < 0f);
                                                            }
                                                            let _e1572 = phi_1848_;
                                                            if _e1572 {
                                                                phi_2525_ = type_24();
                                                                phi_2526_ = false;
                                                            } else {
                                                                let _e1574 = select(_e1474[1][0], _e1474[0][0], (_e1474[0][0] < _e1474[1][0]));
                                                                let _e1578 = select(_e1474[1][0], _e1474[0][0], (_e1474[0][0] > _e1474[1][0]));
                                                                let _e1582 = select(_e1474[1][1], _e1474[0][1], (_e1474[0][1] < _e1474[1][1]));
                                                                let _e1586 = select(_e1474[1][1], _e1474[0][1], (_e1474[0][1] > _e1474[1][1]));
                                                                let _e1590 = select(_e1474[1][2], _e1474[0][2], (_e1474[0][2] < _e1474[1][2]));
                                                                let _e1594 = select(_e1474[1][2], _e1474[0][2], (_e1474[0][2] > _e1474[1][2]));
                                                                let _e1599 = ((select(_e1474[2][0], _e1574, (_e1574 < _e1474[2][0])) - _e332) * _e337);
                                                                let _e1600 = ((select(_e1474[2][0], _e1578, (_e1578 > _e1474[2][0])) - _e333) * _e337);
                                                                let _e1603 = ((select(_e1474[2][1], _e1582, (_e1582 < _e1474[2][1])) - _e370) * _e375);
                                                                let _e1604 = ((select(_e1474[2][1], _e1586, (_e1586 > _e1474[2][1])) - _e371) * _e375);
                                                                let _e1607 = ((select(_e1474[2][2], _e1590, (_e1590 < _e1474[2][2])) - _e408) * _e413);
                                                                let _e1608 = ((select(_e1474[2][2], _e1594, (_e1594 > _e1474[2][2])) - _e409) * _e413);
                                                                let _e1610 = select(_e1608, _e1607, (_e1607 < _e1608));
                                                                let _e1612 = select(_e1608, _e1607, (_e1607 > _e1608));
                                                                let _e1614 = select(_e1600, _e1599, (_e1599 < _e1600));
                                                                let _e1616 = select(_e1604, _e1603, (_e1603 < _e1604));
                                                                let _e1618 = select(_e1616, _e1614, (_e1614 > _e1616));
                                                                let _e1620 = select(_e1610, _e1618, (_e1618 > _e1610));
                                                                let _e1622 = select(_e1600, _e1599, (_e1599 > _e1600));
                                                                let _e1624 = select(_e1604, _e1603, (_e1603 > _e1604));
                                                                let _e1626 = select(_e1624, _e1622, (_e1622 < _e1624));
                                                                let _e1628 = select(_e1612, _e1626, (_e1626 < _e1612));
                                                                let _e1629 = -(_e1610);
                                                                let _e1635 = select(_e460, _e1620, (_e1620 > _e460));
                                                                if (_e1635 > (_e1628 + (select(_e1629, _e1612, (_e1612 > _e1629)) * 0.0000019073523f))) {
                                                                    phi_2520_ = type_24();
                                                                    phi_2521_ = true;
                                                                } else {
                                                                    let _e1637 = (_e1635 > _e1039.member.member_1);
                                                                    if _e1637 {
                                                                        phi_2519_ = type_24();
                                                                    } else {
                                                                        let _e1638 = vec3<f32>(_e1474[0][0], _e1474[0][1], _e1474[0][2]);
                                                                        let _e1639 = vec3<f32>(_e1474[1][0], _e1474[1][1], _e1474[1][2]);
                                                                        let _e1640 = vec3<f32>(_e1474[2][0], _e1474[2][1], _e1474[2][2]);
                                                                        let _e1641 = (_e1474[1][0] - _e1474[0][0]);
                                                                        let _e1642 = (_e1474[1][1] - _e1474[0][1]);
                                                                        let _e1643 = (_e1474[1][2] - _e1474[0][2]);
                                                                        let _e1644 = vec3<f32>(_e1641, _e1642, _e1643);
                                                                        let _e1645 = (_e1474[2][0] - _e1474[1][0]);
                                                                        let _e1646 = (_e1474[2][1] - _e1474[1][1]);
                                                                        let _e1647 = (_e1474[2][2] - _e1474[1][2]);
                                                                        let _e1648 = vec3<f32>(_e1645, _e1646, _e1647);
                                                                        let _e1649 = (_e1474[0][0] - _e1474[2][0]);
                                                                        let _e1650 = (_e1474[0][1] - _e1474[2][1]);
                                                                        let _e1651 = (_e1474[0][2] - _e1474[2][2]);
                                                                        let _e1652 = vec3<f32>(_e1649, _e1650, _e1651);
                                                                        let _e1655 = bitcast<f32>((bitcast<u32>(_e1641) & 2147483647u));
                                                                        let _e1658 = bitcast<f32>((bitcast<u32>(_e1642) & 2147483647u));
                                                                        let _e1660 = select(_e1658, _e1655, (_e1655 > _e1658));
                                                                        let _e1663 = bitcast<f32>((bitcast<u32>(_e1643) & 2147483647u));
                                                                        let _e1665 = select(_e1663, _e1660, (_e1660 > _e1663));
                                                                        let _e1668 = bitcast<f32>((bitcast<u32>(_e1645) & 2147483647u));
                                                                        let _e1671 = bitcast<f32>((bitcast<u32>(_e1646) & 2147483647u));
                                                                        let _e1673 = select(_e1671, _e1668, (_e1668 > _e1671));
                                                                        let _e1676 = bitcast<f32>((bitcast<u32>(_e1647) & 2147483647u));
                                                                        let _e1678 = select(_e1676, _e1673, (_e1673 > _e1676));
                                                                        let _e1681 = bitcast<f32>((bitcast<u32>(_e1649) & 2147483647u));
                                                                        let _e1684 = bitcast<f32>((bitcast<u32>(_e1650) & 2147483647u));
                                                                        let _e1686 = select(_e1684, _e1681, (_e1681 > _e1684));
                                                                        let _e1689 = bitcast<f32>((bitcast<u32>(_e1651) & 2147483647u));
                                                                        let _e1691 = select(_e1689, _e1686, (_e1686 > _e1689));
                                                                        let _e1693 = select(_e1678, _e1665, (_e1665 > _e1678));
                                                                        let _e1695 = select(_e1691, _e1693, (_e1693 > _e1691));
                                                                        if (_e1665 == _e1695) {
                                                                            phi_2249_ = _e1502;
                                                                            phi_2250_ = _e1499;
                                                                            phi_2251_ = _e1489;
                                                                            phi_2252_ = _e1486;
                                                                            phi_2253_ = _e1638;
                                                                            phi_2254_ = _e1652;
                                                                            phi_2255_ = _e1648;
                                                                            phi_2256_ = _e1644;
                                                                        } else {
                                                                            let _e1697 = (_e1678 == _e1695);
                                                                            let _e1702 = vec3(_e1697);
                                                                            phi_2249_ = select(_e1489, _e1515, _e1697);
                                                                            phi_2250_ = select(_e1486, _e1512, _e1697);
                                                                            phi_2251_ = select(_e1515, _e1502, _e1697);
                                                                            phi_2252_ = select(_e1512, _e1499, _e1697);
                                                                            phi_2253_ = select(_e1640, _e1639, _e1702);
                                                                            phi_2254_ = select(_e1648, _e1644, _e1702);
                                                                            phi_2255_ = select(_e1644, _e1652, _e1702);
                                                                            phi_2256_ = select(_e1652, _e1648, _e1702);
                                                                        }
                                                                        let _e1708 = phi_2249_;
                                                                        let _e1710 = phi_2250_;
                                                                        let _e1712 = phi_2251_;
                                                                        let _e1714 = phi_2252_;
                                                                        let _e1716 = phi_2253_;
                                                                        let _e1718 = phi_2254_;
                                                                        let _e1720 = phi_2255_;
                                                                        let _e1722 = phi_2256_;
                                                                        let _e1729 = ((_e1720.y * _e1718.z) - (_e1718.y * _e1720.z));
                                                                        let _e1734 = ((_e1720.z * _e1718.x) - (_e1718.z * _e1720.x));
                                                                        let _e1737 = ((_e1720.x * _e1718.y) - (_e1718.x * _e1720.y));
                                                                        if (_e1537 >= _e1541) {
                                                                            phi_2287_ = select(true, false, (_e1537 >= _e1545));
                                                                        } else {
                                                                            phi_2287_ = true;
                                                                        }
                                                                        let _e1742 = phi_2287_;
                                                                        if _e1742 {
                                                                            phi_2296_ = select(_e1640, _e1639, vec3((_e1541 >= _e1545)));
                                                                        } else {
                                                                            phi_2296_ = _e1638;
                                                                        }
                                                                        let _e1747 = phi_2296_;
                                                                        let _e1752 = (((_e1729 * _e334) + (_e1734 * _e372)) + (_e1737 * _e410));
                                                                        let _e1763 = (((_e1729 * (_e1747.x - _e309)) + (_e1734 * (_e1747.y - _e348))) + (_e1737 * (_e1747.z - _e386)));
                                                                        let _e1765 = (_e1710 - _e1714);
                                                                        let _e1766 = (_e1708 - _e1712);
                                                                        let _e1774 = (-(((_e1714 * _e1765) + (_e1712 * _e1766))) / ((_e1765 * _e1765) + (_e1766 * _e1766)));
                                                                        let _e1776 = select(1f, _e1774, (_e1774 < 1f));
                                                                        let _e1778 = select(0f, _e1776, (_e1776 > 0f));
                                                                        let _e1791 = ((_e1716.x + (_e1722.x * _e1778)) - _e309);
                                                                        let _e1792 = ((_e1716.y + (_e1722.y * _e1778)) - _e348);
                                                                        let _e1793 = ((_e1716.z + (_e1722.z * _e1778)) - _e386);
                                                                        let _e1794 = (_e1793 / _e410);
                                                                        let _e1806 = bitcast<f32>((bitcast<u32>(_e1791) & 2147483647u));
                                                                        let _e1809 = bitcast<f32>((bitcast<u32>(_e1792) & 2147483647u));
                                                                        let _e1811 = select(_e1809, _e1806, (_e1806 > _e1809));
                                                                        let _e1814 = bitcast<f32>((bitcast<u32>(_e1793) & 2147483647u));
                                                                        let _e1816 = select(_e1814, _e1811, (_e1811 > _e1814));
                                                                        let _e1822 = bitcast<f32>((bitcast<u32>(_e1729) & 2147483647u));
                                                                        let _e1825 = bitcast<f32>((bitcast<u32>(_e1734) & 2147483647u));
                                                                        let _e1827 = select(_e1825, _e1822, (_e1822 > _e1825));
                                                                        let _e1830 = bitcast<f32>((bitcast<u32>(_e1737) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1729 * _e1791) + (_e1734 * _e1792)) + (_e1737 * _e1793)) - _e1763)) & 2147483647u)) <= ((0.0000009536743f * select(_e1695, _e1816, (_e1816 > _e1695))) * select(_e1830, _e1827, (_e1827 > _e1830)))) {
                                                                            let _e1840 = bitcast<f32>((bitcast<u32>(_e1720.x) & 2147483647u));
                                                                            let _e1843 = bitcast<f32>((bitcast<u32>(_e1720.y) & 2147483647u));
                                                                            let _e1845 = select(_e1843, _e1840, (_e1840 > _e1843));
                                                                            let _e1848 = bitcast<f32>((bitcast<u32>(_e1720.z) & 2147483647u));
                                                                            let _e1854 = bitcast<f32>((bitcast<u32>(_e1718.x) & 2147483647u));
                                                                            let _e1857 = bitcast<f32>((bitcast<u32>(_e1718.y) & 2147483647u));
                                                                            let _e1859 = select(_e1857, _e1854, (_e1854 > _e1857));
                                                                            let _e1862 = bitcast<f32>((bitcast<u32>(_e1718.z) & 2147483647u));
                                                                            phi_2463_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1752) & 2147483647u)) > ((0.0000038146973f * select(_e1848, _e1845, (_e1845 > _e1848))) * select(_e1862, _e1859, (_e1859 > _e1862)))));
                                                                        } else {
                                                                            phi_2463_ = true;
                                                                        }
                                                                        let _e1869 = phi_2463_;
                                                                        if _e1869 {
                                                                            let _e1880 = ((((_e1729 * (_e1791 - (_e334 * _e1794))) + (_e1734 * (_e1792 - (_e372 * _e1794)))) + (_e1737 * (_e1793 - _e1793))) / _e1752);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1880) & 2147483647u)) <= _e1695) {
                                                                                phi_2487_ = (_e1794 + _e1880);
                                                                            } else {
                                                                                phi_2487_ = _e1794;
                                                                            }
                                                                            let _e1887 = phi_2487_;
                                                                            phi_2488_ = _e1887;
                                                                        } else {
                                                                            phi_2488_ = (_e1763 / _e1752);
                                                                        }
                                                                        let _e1889 = phi_2488_;
                                                                        let _e1891 = select(_e1628, _e1889, (_e1889 < _e1628));
                                                                        let _e1893 = select(_e1620, _e1891, (_e1891 > _e1620));
                                                                        if (_e1893 >= _e460) {
                                                                            let _e1895 = (_e1893 <= _e1039.member.member_1);
                                                                            if _e1895 {
                                                                                let _e1896 = (1f / _e1547);
                                                                                phi_2511_ = type_24(_e1893, (_e1541 * _e1896), (_e1545 * _e1896), _e1105);
                                                                            } else {
                                                                                phi_2511_ = type_24();
                                                                            }
                                                                            let _e1901 = phi_2511_;
                                                                            phi_2513_ = _e1901;
                                                                            phi_2514_ = select(true, false, _e1895);
                                                                        } else {
                                                                            phi_2513_ = type_24();
                                                                            phi_2514_ = true;
                                                                        }
                                                                        let _e1904 = phi_2513_;
                                                                        let _e1906 = phi_2514_;
                                                                        if _e1906 {
                                                                            phi_2518_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2518_ = _e1904;
                                                                        }
                                                                        let _e1908 = phi_2518_;
                                                                        phi_2519_ = _e1908;
                                                                    }
                                                                    let _e1910 = phi_2519_;
                                                                    phi_2520_ = _e1910;
                                                                    phi_2521_ = _e1637;
                                                                }
                                                                let _e1912 = phi_2520_;
                                                                let _e1914 = phi_2521_;
                                                                phi_2525_ = _e1912;
                                                                phi_2526_ = _e1914;
                                                            }
                                                            let _e1916 = phi_2525_;
                                                            let _e1918 = phi_2526_;
                                                            phi_2527_ = _e1916;
                                                            phi_2528_ = _e1572;
                                                            phi_2529_ = _e1918;
                                                        }
                                                        let _e1920 = phi_2527_;
                                                        let _e1922 = phi_2528_;
                                                        let _e1924 = phi_2529_;
                                                        phi_2530_ = _e1920;
                                                        phi_2531_ = _e1922;
                                                        phi_2532_ = _e1924;
                                                    }
                                                    let _e1926 = phi_2530_;
                                                    let _e1928 = phi_2531_;
                                                    let _e1930 = phi_2532_;
                                                    phi_2540_ = _e1926;
                                                    phi_2541_ = select(_e1930, true, _e1928);
                                                } else {
                                                    phi_2540_ = type_24();
                                                    phi_2541_ = true;
                                                }
                                                let _e1933 = phi_2540_;
                                                let _e1935 = phi_2541_;
                                                if _e1935 {
                                                    phi_2545_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2545_ = _e1933;
                                                }
                                                let _e1937 = phi_2545_;
                                                if (_e1937.member_3 != 4294967295u) {
                                                    if (_e1105 != 4294967295u) {
                                                        if (_e1937.member < _e1039.member.member.member) {
                                                            phi_2571_ = true;
                                                        } else {
                                                            if (_e1937.member == _e1039.member.member.member) {
                                                                phi_2570_ = (_e1937.member_3 < _e1039.member.member.member_3);
                                                            } else {
                                                                phi_2570_ = false;
                                                            }
                                                            let _e1952 = phi_2570_;
                                                            phi_2571_ = _e1952;
                                                        }
                                                        let _e1954 = phi_2571_;
                                                        if _e1954 {
                                                            phi_2578_ = type_39(type_32(_e1937, _e1937.member), _e1066.member_1, _e1066.member_2);
                                                        } else {
                                                            phi_2578_ = _e1066;
                                                        }
                                                        let _e1961 = phi_2578_;
                                                        phi_2579_ = _e1961;
                                                    } else {
                                                        phi_2579_ = _e1066;
                                                    }
                                                    let _e1963 = phi_2579_;
                                                    phi_2580_ = _e1963;
                                                } else {
                                                    phi_2580_ = _e1066;
                                                }
                                                let _e1965 = phi_2580_;
                                                phi_981_ = _e1965;
                                            } else {
                                                phi_981_ = type_39();
                                            }
                                            let _e1967 = phi_981_;
                                            continue;
                                            continuing {
                                                phi_980_ = _e1967;
                                                phi_983_ = _e1054;
                                                phi_4043_ = _e503;
                                                break if !(_e1060);
                                            }
                                        }
                                        let _e1970 = phi_4043_;
                                        phi_4232_ = _e1970;
                                        if _e1970 {
                                            break;
                                        }
                                        phi_4236_ = _e1970;
                                        let _e2174 = local_12;
                                        phi_3823_ = _e2174;
                                        phi_3824_ = _e545;
                                        phi_3825_ = false;
                                        phi_3826_ = _e549;
                                    } else {
                                        if (_e545.member_1 >= _e89) {
                                            phi_3379_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e545.member_1 < _e89) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e567 = (_e260 * 2u);
                                            let _e569 = ((1u + _e567) % 7u);
                                            if (_e569 < 7u) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e574 = global_4.member[_e545.member_1][_e569];
                                            let _e576 = ((_e567 + 2u) % 7u);
                                            if (_e576 < 7u) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e581 = global_4.member[_e545.member_1][_e576];
                                            let _e582 = (_e259 * 2u);
                                            let _e584 = ((1u + _e582) % 7u);
                                            if (_e584 < 7u) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e589 = global_4.member[_e545.member_1][_e584];
                                            let _e591 = ((_e582 + 2u) % 7u);
                                            if (_e591 < 7u) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e596 = global_4.member[_e545.member_1][_e591];
                                            let _e597 = (_e261 * 2u);
                                            let _e599 = ((1u + _e597) % 7u);
                                            if (_e599 < 7u) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e604 = global_4.member[_e545.member_1][_e599];
                                            let _e606 = ((_e597 + 2u) % 7u);
                                            if (_e606 < 7u) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e611 = global_4.member[_e545.member_1][_e606];
                                            let _e634 = (bitcast<f32>((bitcast<u32>((_e545.member.member_1.x - _e545.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e635 = (bitcast<f32>((bitcast<u32>((_e545.member.member_1.y - _e545.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e636 = (bitcast<f32>((bitcast<u32>((_e545.member.member_1.z - _e545.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e638 = select(_e140, _e634, (_e634 > _e140));
                                            let _e640 = select(_e140, _e635, (_e635 > _e140));
                                            let _e642 = select(_e140, _e636, (_e636 > _e140));
                                            let _e667 = bitcast<u32>((f32(bitcast<i32>((_e574 & 2097151u))) * _e638));
                                            let _e672 = (bitcast<i32>((_e574 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e675 = bitcast<f32>((_e667 & bitcast<u32>(_e672)));
                                            let _e676 = bitcast<u32>((f32(bitcast<i32>((_e589 & 2097151u))) * _e640));
                                            let _e681 = (bitcast<i32>((_e589 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e684 = bitcast<f32>((_e676 & bitcast<u32>(_e681)));
                                            let _e685 = bitcast<u32>((f32(bitcast<i32>((_e604 & 2097151u))) * _e642));
                                            let _e690 = (bitcast<i32>((_e604 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e693 = bitcast<f32>((_e685 & bitcast<u32>(_e690)));
                                            let _e697 = bitcast<f32>((_e667 & bitcast<u32>(~(_e672))));
                                            let _e701 = bitcast<f32>((_e676 & bitcast<u32>(~(_e681))));
                                            let _e705 = bitcast<f32>((_e685 & bitcast<u32>(~(_e690))));
                                            let _e706 = bitcast<u32>((f32(bitcast<i32>((_e581 & 2097151u))) * _e638));
                                            let _e711 = (bitcast<i32>((_e581 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e714 = bitcast<f32>((_e706 & bitcast<u32>(_e711)));
                                            let _e715 = bitcast<u32>((f32(bitcast<i32>((_e596 & 2097151u))) * _e640));
                                            let _e720 = (bitcast<i32>((_e596 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e723 = bitcast<f32>((_e715 & bitcast<u32>(_e720)));
                                            let _e724 = bitcast<u32>((f32(bitcast<i32>((_e611 & 2097151u))) * _e642));
                                            let _e729 = (bitcast<i32>((_e611 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e732 = bitcast<f32>((_e724 & bitcast<u32>(_e729)));
                                            let _e736 = bitcast<f32>((_e706 & bitcast<u32>(~(_e711))));
                                            let _e740 = bitcast<f32>((_e715 & bitcast<u32>(~(_e720))));
                                            let _e744 = bitcast<f32>((_e724 & bitcast<u32>(~(_e729))));
                                            let _e745 = (_e545.member.member.x + _e675);
                                            let _e746 = (_e545.member.member.y + _e684);
                                            let _e747 = (_e545.member.member.z + _e693);
                                            let _e750 = (_e545.member.member_1.x - _e714);
                                            let _e751 = (_e545.member.member_1.y - _e723);
                                            let _e752 = (_e545.member.member_1.z - _e732);
                                            let _e771 = (_e750 - _e745);
                                            let _e772 = (_e751 - _e746);
                                            let _e773 = (_e752 - _e747);
                                            let _e775 = select(_e772, _e771, (_e771 > _e772));
                                            let _e777 = select(_e773, _e775, (_e775 > _e773));
                                            if (_e777 < (1024f * _e140)) {
                                                phi_3080_ = 0u;
                                            } else {
                                                phi_3080_ = select(2u, 1u, (_e777 < (2097152f * _e140)));
                                            }
                                            let _e784 = phi_3080_;
                                            switch bitcast<i32>(_e784) {
                                                case 0: {
                                                    phi_3086_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3086_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3086_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3086_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e787 = phi_3086_;
                                            let _e793 = global_4.member[_e545.member_1][0u];
                                            let _e797 = global_4.member[_e545.member_1][2u];
                                            let _e801 = global_4.member[_e545.member_1][4u];
                                            let _e805 = global_4.member[_e545.member_1][6u];
                                            let _e817 = (((_e797 >> bitcast<u32>(22i)) | ((_e801 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e805 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e818 = (_e793 & 268435455u);
                                            let _e819 = (_e817 & 268435455u);
                                            let _e822 = ((_e793 >> bitcast<u32>(28u)) & 7u);
                                            let _e830 = ((_e793 >> bitcast<u32>(31i)) | (((_e817 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e831 = (_e822 != 0u);
                                            if (_e822 == 0u) {
                                                phi_3341_ = _e818;
                                            } else {
                                                if (_e822 == 7u) {
                                                    phi_3340_ = 2147483648u;
                                                } else {
                                                    phi_3340_ = ((2147483648u | (_e822 << bitcast<u32>(28u))) | (_e819 & 268435455u));
                                                }
                                                let _e840 = phi_3340_;
                                                phi_3341_ = _e840;
                                            }
                                            let _e842 = phi_3341_;
                                            if _e831 {
                                                let _e843 = (_e822 != 7u);
                                                if _e843 {
                                                    phi_3351_ = (_e819 + (_e822 * ((3u * _e787) + 1u)));
                                                } else {
                                                    phi_3351_ = u32();
                                                }
                                                let _e847 = phi_3351_;
                                                phi_3353_ = _e847;
                                                phi_3354_ = select(true, false, _e843);
                                            } else {
                                                phi_3353_ = u32();
                                                phi_3354_ = true;
                                            }
                                            let _e850 = phi_3353_;
                                            let _e852 = phi_3354_;
                                            if (_e830 == 0u) {
                                                phi_3375_ = (_e818 + select(0u, 1u, !(_e831)));
                                            } else {
                                                if (_e830 == 7u) {
                                                    phi_3374_ = 2147483648u;
                                                } else {
                                                    phi_3374_ = ((2147483648u | (_e830 << bitcast<u32>(28u))) | (select(_e850, _e819, _e852) & 268435455u));
                                                }
                                                let _e865 = phi_3374_;
                                                phi_3375_ = _e865;
                                            }
                                            let _e867 = phi_3375_;
                                            phi_3379_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e745, (_e545.member.member.x + _e697), _e750, (_e545.member.member_1.x - _e736)), vec4<f32>(_e746, (_e545.member.member.y + _e701), _e751, (_e545.member.member_1.y - _e740)), vec4<f32>(_e747, (_e545.member.member.z + _e705), _e752, (_e545.member.member_1.z - _e744))), type_50(type_28((_e545.member.member + vec4<f32>(_e675, _e684, _e693, 0f)), (_e545.member.member_1 - vec4<f32>(_e714, _e723, _e732, 0f))), _e842), type_50(type_28((_e545.member.member + vec4<f32>(_e697, _e701, _e705, 0f)), (_e545.member.member_1 - vec4<f32>(_e736, _e740, _e744, 0f))), _e867));
                                        }
                                        let _e872 = phi_3379_;
                                        let _e885 = ((_e872.member[0].x - _e332) * _e337);
                                        let _e886 = ((_e872.member[0].y - _e332) * _e337);
                                        let _e887 = ((_e872.member[0].z - _e333) * _e337);
                                        let _e888 = ((_e872.member[0].w - _e333) * _e337);
                                        let _e898 = ((_e872.member[1].x - _e370) * _e375);
                                        let _e899 = ((_e872.member[1].y - _e370) * _e375);
                                        let _e900 = ((_e872.member[1].z - _e371) * _e375);
                                        let _e901 = ((_e872.member[1].w - _e371) * _e375);
                                        let _e911 = ((_e872.member[2].x - _e408) * _e413);
                                        let _e912 = ((_e872.member[2].y - _e408) * _e413);
                                        let _e913 = ((_e872.member[2].z - _e409) * _e413);
                                        let _e914 = ((_e872.member[2].w - _e409) * _e413);
                                        let _e916 = select(_e913, _e911, (_e911 < _e913));
                                        let _e918 = select(_e914, _e912, (_e912 < _e914));
                                        let _e920 = select(_e913, _e911, (_e911 > _e913));
                                        let _e922 = select(_e914, _e912, (_e912 > _e914));
                                        let _e924 = select(_e887, _e885, (_e885 < _e887));
                                        let _e926 = select(_e888, _e886, (_e886 < _e888));
                                        let _e928 = select(_e900, _e898, (_e898 < _e900));
                                        let _e930 = select(_e901, _e899, (_e899 < _e901));
                                        let _e932 = select(_e928, _e924, (_e924 > _e928));
                                        let _e934 = select(_e930, _e926, (_e926 > _e930));
                                        let _e936 = select(_e916, _e932, (_e932 > _e916));
                                        let _e938 = select(_e918, _e934, (_e934 > _e918));
                                        let _e940 = select(_e887, _e885, (_e885 > _e887));
                                        let _e942 = select(_e888, _e886, (_e886 > _e888));
                                        let _e944 = select(_e900, _e898, (_e898 > _e900));
                                        let _e946 = select(_e901, _e899, (_e899 > _e901));
                                        let _e948 = select(_e944, _e940, (_e940 < _e944));
                                        let _e950 = select(_e946, _e942, (_e942 < _e946));
                                        let _e955 = -(_e916);
                                        let _e956 = -(_e918);
                                        let _e963 = (select(_e920, _e948, (_e948 < _e920)) + (select(_e955, _e920, (_e920 > _e955)) * 0.0000019073523f));
                                        let _e964 = (select(_e922, _e950, (_e950 < _e922)) + (select(_e956, _e922, (_e922 > _e956)) * 0.0000019073523f));
                                        let _e966 = select(_e460, _e936, (_e936 > _e460));
                                        let _e968 = select(_e460, _e938, (_e938 > _e460));
                                        let _e973 = (_e966 <= select(_e505.member.member_1, _e963, (_e963 < _e505.member.member_1)));
                                        let _e974 = (_e968 <= select(_e505.member.member_1, _e964, (_e964 < _e505.member.member_1)));
                                        let _e975 = (_e966 <= _e968);
                                        if _e973 {
                                            if _e974 {
                                                if _e975 {
                                                    phi_3723_ = _e872.member_2;
                                                } else {
                                                    phi_3723_ = _e872.member_1;
                                                }
                                                let _e979 = phi_3723_;
                                                let _e1001 = (_e549 % 128u);
                                                let _e1002 = (_e1001 < 128u);
                                                if _e1002 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_8[_e1001] = _e979.member_1;
                                                if _e1002 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_7[_e1001] = _e979.member.member.x;
                                                if _e1002 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_6[_e1001] = _e979.member.member.y;
                                                if _e1002 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_5[_e1001] = _e979.member.member.z;
                                                if _e1002 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_4[_e1001] = _e979.member.member_1.x;
                                                if _e1002 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_3[_e1001] = _e979.member.member_1.y;
                                                if _e1002 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_2[_e1001] = _e979.member.member_1.z;
                                                if _e1002 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_9[_e1001] = select(_e968, _e966, (_e966 > _e968));
                                                if _e975 {
                                                    phi_3800_ = _e872.member_1;
                                                } else {
                                                    phi_3800_ = _e872.member_2;
                                                }
                                                let _e1015 = phi_3800_;
                                                phi_3801_ = _e1015;
                                                phi_3802_ = (_e549 + 1u);
                                            } else {
                                                phi_3801_ = type_50();
                                                phi_3802_ = u32();
                                            }
                                            let _e1017 = phi_3801_;
                                            let _e1019 = phi_3802_;
                                            phi_3804_ = _e1017;
                                            phi_3805_ = _e1019;
                                            phi_3806_ = select(true, false, _e974);
                                        } else {
                                            phi_3804_ = type_50();
                                            phi_3805_ = u32();
                                            phi_3806_ = true;
                                        }
                                        let _e1022 = phi_3804_;
                                        let _e1024 = phi_3805_;
                                        let _e1026 = phi_3806_;
                                        if _e1026 {
                                            if _e973 {
                                                phi_3815_ = _e872.member_1;
                                            } else {
                                                phi_3815_ = _e872.member_2;
                                            }
                                            let _e1030 = phi_3815_;
                                            phi_3820_ = _e1030;
                                            phi_3821_ = select(_e974, true, _e973);
                                        } else {
                                            phi_3820_ = _e1022;
                                            phi_3821_ = _e547;
                                        }
                                        let _e1033 = phi_3820_;
                                        let _e1035 = phi_3821_;
                                        phi_4236_ = _e503;
                                        phi_3823_ = type_39(_e505.member, (_e505.member_1 + 1u), _e505.member_2);
                                        phi_3824_ = _e1033;
                                        phi_3825_ = _e1035;
                                        phi_3826_ = select(_e1024, _e549, _e1026);
                                    }
                                    let _e1972 = phi_4236_;
                                    let _e1974 = phi_3823_;
                                    let _e1976 = phi_3824_;
                                    let _e1978 = phi_3825_;
                                    let _e1980 = phi_3826_;
                                    phi_4235_ = _e1972;
                                    phi_3827_ = _e1974;
                                    phi_3828_ = _e1976;
                                    phi_3829_ = (_e509 - 1u);
                                    phi_3830_ = _e1978;
                                    phi_3831_ = _e1980;
                                } else {
                                    phi_4235_ = _e503;
                                    phi_3827_ = _e505;
                                    phi_3828_ = _e545;
                                    phi_3829_ = _e509;
                                    phi_3830_ = _e547;
                                    phi_3831_ = _e549;
                                }
                                let _e1982 = phi_4235_;
                                let _e1984 = phi_3827_;
                                let _e1986 = phi_3828_;
                                let _e1988 = phi_3829_;
                                let _e1990 = phi_3830_;
                                let _e1992 = phi_3831_;
                                phi_4234_ = _e1982;
                                phi_3832_ = _e1984;
                                phi_3833_ = _e1986;
                                phi_3834_ = _e1988;
                                phi_3835_ = _e1990;
                                phi_3836_ = _e1992;
                            } else {
                                phi_4234_ = _e503;
                                phi_3832_ = type_39();
                                phi_3833_ = type_50();
                                phi_3834_ = u32();
                                phi_3835_ = bool();
                                phi_3836_ = u32();
                            }
                            let _e1994 = phi_4234_;
                            let _e1996 = phi_3832_;
                            let _e1998 = phi_3833_;
                            let _e2000 = phi_3834_;
                            let _e2002 = phi_3835_;
                            let _e2004 = phi_3836_;
                            phi_4233_ = _e1994;
                            phi_854_ = _e1996;
                            phi_857_ = _e1998;
                            phi_859_ = _e2000;
                            phi_861_ = _e2002;
                            phi_863_ = _e2004;
                            phi_3837_ = _e517;
                        } else {
                            phi_4233_ = _e503;
                            phi_854_ = type_39();
                            phi_857_ = type_50();
                            phi_859_ = u32();
                            phi_861_ = bool();
                            phi_863_ = u32();
                            phi_3837_ = false;
                        }
                        let _e2006 = phi_4233_;
                        let _e2008 = phi_854_;
                        let _e2010 = phi_857_;
                        let _e2012 = phi_859_;
                        let _e2014 = phi_861_;
                        let _e2016 = phi_863_;
                        let _e2018 = phi_3837_;
                        continue;
                        continuing {
                            phi_4049_ = _e2006;
                            phi_853_ = _e2008;
                            phi_856_ = _e2010;
                            phi_858_ = _e2012;
                            phi_860_ = _e2014;
                            phi_862_ = _e2016;
                            phi_4232_ = _e2006;
                            break if !(_e2018);
                        }
                    }
                    let _e2021 = phi_4232_;
                    if _e2021 {
                        break;
                    }
                    let _e2023 = local_10;
                    let _e2026 = local_11;
                    if _e148 {
                    } else {
                        break;
                    }
                    global_6.member[_e146][0u] = _e2023.member_1;
                    global_6.member[_e146][1u] = _e2026.member_2;
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
