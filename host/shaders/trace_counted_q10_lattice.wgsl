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
    var phi_853_: type_43;
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
    var phi_980_: type_43;
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
    var phi_2511_: type_28;
    var phi_2513_: type_28;
    var phi_2514_: bool;
    var phi_2518_: type_28;
    var phi_2519_: type_28;
    var phi_2520_: type_28;
    var phi_2521_: bool;
    var phi_2525_: type_28;
    var phi_2526_: bool;
    var phi_2527_: type_28;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2530_: type_28;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2540_: type_28;
    var phi_2541_: bool;
    var phi_2545_: type_28;
    var phi_2570_: bool;
    var phi_2571_: bool;
    var phi_2578_: type_43;
    var phi_2579_: type_43;
    var phi_2580_: type_43;
    var phi_981_: type_43;
    var phi_4043_: bool;
    var phi_4236_: bool;
    var phi_3823_: type_43;
    var phi_3824_: type_50;
    var phi_3825_: bool;
    var phi_3826_: u32;
    var phi_4235_: bool;
    var phi_3827_: type_43;
    var phi_3828_: type_50;
    var phi_3829_: u32;
    var phi_3830_: bool;
    var phi_3831_: u32;
    var phi_4234_: bool;
    var phi_3832_: type_43;
    var phi_3833_: type_50;
    var phi_3834_: u32;
    var phi_3835_: bool;
    var phi_3836_: u32;
    var phi_4233_: bool;
    var phi_854_: type_43;
    var phi_857_: type_50;
    var phi_859_: u32;
    var phi_861_: bool;
    var phi_863_: u32;
    var phi_3837_: bool;
    var phi_4232_: bool;
    var local_10: type_43;
    var local_11: type_43;
    var local_12: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e92 = arrayLength((&global_3.member));
            let _e95 = arrayLength((&global_5.member));
            let _e103 = global_2.member[0u][0u];
            let _e107 = global_2.member[0u][1u];
            let _e111 = global_2.member[0u][2u];
            let _e115 = global_2.member[0u][3u];
            let _e119 = global_2.member[1u][0u];
            let _e123 = global_2.member[1u][1u];
            let _e127 = global_2.member[1u][2u];
            let _e130 = global_1.member[0u];
            let _e131 = bitcast<i32>(_e130);
            let _e143 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e115) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e103), bitcast<i32>(_e107), bitcast<i32>(_e111));
            local = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            let _e149 = (_e90.x + (_e90.y * 2097152u));
            let _e150 = (_e149 < arrayLength((&global_4.member)));
            if _e150 {
                let _e151 = (_e149 < arrayLength((&global_6.member)));
                if _e151 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e159 = global_4.member[_e149].member_2[0u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_4.member[_e149].member_2[1u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_4.member[_e149].member_2[2u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_4.member[_e149].member[0u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_4.member[_e149].member[1u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_4.member[_e149].member[2u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e198 = select(_e168, _e161, (_e168 < _e161));
                    let _e200 = select(_e175, _e198, (_e175 < _e198));
                    let _e202 = select(_e182, _e200, (_e182 < _e200));
                    let _e204 = select(_e189, _e202, (_e189 < _e202));
                    let _e206 = select(_e196, _e204, (_e196 < _e204));
                    let _e210 = global_4.member[_e149].member_1;
                    let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                    let _e219 = global_4.member[_e149].member_3;
                    let _e225 = (((select(_e212, _e206, (_e212 < _e206)) < 2139095040u) && ((bitcast<u32>(_e219) & 2147483647u) <= 2139095040u)) && (_e200 > 0u));
                    if _e225 {
                        let _e228 = (bitcast<u32>(bitcast<f32>(_e200)) & 2147483647u);
                        if (_e228 >= 8388608u) {
                            phi_394_ = (bitcast<i32>((_e228 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_394_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u))));
                        }
                        let _e242 = phi_394_;
                        phi_395_ = _e242;
                    } else {
                        phi_395_ = 0i;
                    }
                    let _e244 = phi_395_;
                    let _e245 = (_e161 == _e200);
                    if _e245 {
                        phi_405_ = true;
                    } else {
                        phi_405_ = (_e168 == _e200);
                    }
                    let _e248 = phi_405_;
                    let _e249 = select(1u, 0u, _e245);
                    if _e248 {
                        let _e250 = (_e249 + 1u);
                        phi_415_ = _e250;
                        phi_416_ = _e250;
                        phi_418_ = select(true, false, (_e250 == 2u));
                    } else {
                        phi_415_ = u32();
                        phi_416_ = 0u;
                        phi_418_ = true;
                    }
                    let _e254 = phi_415_;
                    let _e256 = phi_416_;
                    let _e258 = phi_418_;
                    if _e258 {
                        phi_423_ = (_e256 + 1u);
                    } else {
                        phi_423_ = 0u;
                    }
                    let _e262 = phi_423_;
                    let _e263 = select(_e254, _e256, _e258);
                    let _e264 = select(_e249, select(2u, _e249, _e248), _e258);
                    if (_e131 < -126i) {
                        phi_435_ = -126i;
                    } else {
                        phi_435_ = select(_e131, 127i, (_e131 > 127i));
                    }
                    let _e269 = phi_435_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e131 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e281 = -(_e244);
                    if (_e281 < -126i) {
                        phi_455_ = -126i;
                    } else {
                        phi_455_ = select(_e281, 127i, (_e281 > 127i));
                    }
                    let _e286 = phi_455_;
                    let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
                    let _e297 = bitcast<f32>((bitcast<u32>(((_e281 - _e286) + 127i)) << bitcast<u32>(23i)));
                    let _e301 = global_4.member[_e149].member;
                    let _e302 = (_e263 == 0u);
                    if _e302 {
                        phi_473_ = _e301[0];
                    } else {
                        phi_473_ = _e301[1];
                    }
                    let _e306 = phi_473_;
                    let _e307 = (_e263 == 2u);
                    if _e307 {
                        phi_479_ = _e301[2];
                    } else {
                        phi_479_ = _e306;
                    }
                    let _e310 = phi_479_;
                    let _e312 = ((_e310 * _e274) * _e280);
                    let _e313 = global_4.member[_e149].member_2;
                    if _e302 {
                        phi_490_ = _e313[0];
                    } else {
                        phi_490_ = _e313[1];
                    }
                    let _e317 = phi_490_;
                    if _e307 {
                        phi_496_ = _e313[2];
                    } else {
                        phi_496_ = _e317;
                    }
                    let _e320 = phi_496_;
                    let _e322 = ((_e320 * _e291) * _e297);
                    let _e326 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e326 {
                        let _e330 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) * 0.00000011920929f);
                        phi_519_ = select(0.00000000000011368684f, _e330, (_e330 > 0.00000000000011368684f));
                    } else {
                        phi_519_ = 0f;
                    }
                    let _e334 = phi_519_;
                    let _e335 = (_e312 + _e334);
                    let _e336 = (_e312 - _e334);
                    let _e337 = select(_e322, 0f, _e326);
                    if _e326 {
                        phi_530_ = 38685626000000000000000000f;
                    } else {
                        phi_530_ = (1f / _e322);
                    }
                    let _e340 = phi_530_;
                    let _e341 = (_e262 == 0u);
                    if _e341 {
                        phi_539_ = _e301[0];
                    } else {
                        phi_539_ = _e301[1];
                    }
                    let _e345 = phi_539_;
                    let _e346 = (_e262 == 2u);
                    if _e346 {
                        phi_545_ = _e301[2];
                    } else {
                        phi_545_ = _e345;
                    }
                    let _e349 = phi_545_;
                    let _e351 = ((_e349 * _e274) * _e280);
                    if _e341 {
                        phi_556_ = _e313[0];
                    } else {
                        phi_556_ = _e313[1];
                    }
                    let _e355 = phi_556_;
                    if _e346 {
                        phi_562_ = _e313[2];
                    } else {
                        phi_562_ = _e355;
                    }
                    let _e358 = phi_562_;
                    let _e360 = ((_e358 * _e291) * _e297);
                    let _e364 = (bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e364 {
                        let _e368 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) * 0.00000011920929f);
                        phi_585_ = select(0.00000000000011368684f, _e368, (_e368 > 0.00000000000011368684f));
                    } else {
                        phi_585_ = 0f;
                    }
                    let _e372 = phi_585_;
                    let _e373 = (_e351 + _e372);
                    let _e374 = (_e351 - _e372);
                    let _e375 = select(_e360, 0f, _e364);
                    if _e364 {
                        phi_596_ = 38685626000000000000000000f;
                    } else {
                        phi_596_ = (1f / _e360);
                    }
                    let _e378 = phi_596_;
                    let _e379 = (_e264 == 0u);
                    if _e379 {
                        phi_605_ = _e301[0];
                    } else {
                        phi_605_ = _e301[1];
                    }
                    let _e383 = phi_605_;
                    let _e384 = (_e264 == 2u);
                    if _e384 {
                        phi_611_ = _e301[2];
                    } else {
                        phi_611_ = _e383;
                    }
                    let _e387 = phi_611_;
                    let _e389 = ((_e387 * _e274) * _e280);
                    if _e379 {
                        phi_622_ = _e313[0];
                    } else {
                        phi_622_ = _e313[1];
                    }
                    let _e393 = phi_622_;
                    if _e384 {
                        phi_628_ = _e313[2];
                    } else {
                        phi_628_ = _e393;
                    }
                    let _e396 = phi_628_;
                    let _e398 = ((_e396 * _e291) * _e297);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) * 0.00000011920929f);
                        phi_651_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_651_ = 0f;
                    }
                    let _e410 = phi_651_;
                    let _e411 = (_e389 + _e410);
                    let _e412 = (_e389 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_662_ = 38685626000000000000000000f;
                    } else {
                        phi_662_ = (1f / _e398);
                    }
                    let _e416 = phi_662_;
                    let _e419 = bitcast<f32>((bitcast<u32>(_e312) & 2147483647u));
                    let _e422 = bitcast<f32>((bitcast<u32>(_e351) & 2147483647u));
                    let _e424 = select(_e422, _e419, (_e419 > _e422));
                    let _e427 = bitcast<f32>((bitcast<u32>(_e389) & 2147483647u));
                    let _e430 = (_e131 + _e244);
                    if (_e225 && (select(_e427, _e424, (_e424 > _e427)) <= 1099511600000f)) {
                        let _e433 = (_e430 / 3i);
                        let _e440 = bitcast<f32>((bitcast<u32>((_e433 + 127i)) << bitcast<u32>(23i)));
                        let _e447 = bitcast<f32>((bitcast<u32>(((_e430 - (2i * _e433)) + 127i)) << bitcast<u32>(23i)));
                        let _e448 = (((_e210 * _e440) * _e440) * _e447);
                        let _e450 = select(340282350000000000000000000000000000000f, _e448, (_e448 < 340282350000000000000000000000000000000f));
                        let _e455 = (((_e219 * _e440) * _e440) * _e447);
                        let _e457 = select(340282350000000000000000000000000000000f, _e455, (_e455 < 340282350000000000000000000000000000000f));
                        phi_762_ = select(-340282350000000000000000000000000000000f, _e457, (_e457 > -340282350000000000000000000000000000000f));
                        phi_763_ = select(-340282350000000000000000000000000000000f, _e450, (_e450 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_762_ = 0f;
                        phi_763_ = 1f;
                    }
                    let _e461 = phi_762_;
                    let _e463 = phi_763_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e468 = (_e263 % 3u);
                    let _e469 = (_e468 < 3u);
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e471 = local_1[_e468];
                    let _e474 = (_e262 % 3u);
                    let _e475 = (_e474 < 3u);
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e477 = local_1[_e474];
                    let _e480 = (_e264 % 3u);
                    let _e481 = (_e480 < 3u);
                    if _e481 {
                    } else {
                        break;
                    }
                    let _e483 = local_1[_e480];
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e468];
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e492 = local[_e474];
                    if _e481 {
                    } else {
                        break;
                    }
                    let _e496 = local[_e480];
                    phi_4049_ = false;
                    phi_853_ = type_43(type_36(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e461), 0u, 0u);
                    phi_856_ = type_50(type_32(vec4<f32>((f32(_e471) * _e143), (f32(_e477) * _e143), (f32(_e483) * _e143), 0f), vec4<f32>((f32(_e488) * _e143), (f32(_e492) * _e143), (f32(_e496) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_858_ = ((3u * _e92) + 1u);
                    phi_860_ = (_e463 <= _e461);
                    phi_862_ = 0u;
                    loop {
                        let _e506 = phi_4049_;
                        let _e508 = phi_853_;
                        let _e510 = phi_856_;
                        let _e512 = phi_858_;
                        let _e514 = phi_860_;
                        let _e516 = phi_862_;
                        local_10 = _e508;
                        local_11 = _e508;
                        if _e514 {
                            phi_873_ = true;
                        } else {
                            phi_873_ = (_e516 > 0u);
                        }
                        let _e519 = phi_873_;
                        if _e519 {
                            let _e520 = (_e512 > 0u);
                            if _e520 {
                                if _e514 {
                                    phi_959_ = _e510;
                                    phi_960_ = _e514;
                                    phi_961_ = _e516;
                                } else {
                                    let _e521 = (_e516 - 1u);
                                    let _e522 = (_e521 % 128u);
                                    let _e523 = (_e522 < 128u);
                                    if _e523 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e525 = local_7[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e527 = local_6[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e529 = local_5[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e531 = local_4[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e533 = local_3[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e535 = local_2[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e540 = local_8[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4232_ = true;
                                        break;
                                    }
                                    let _e543 = local_9[_e522];
                                    phi_959_ = type_50(type_32(vec4<f32>(_e525, _e527, _e529, 0f), vec4<f32>(_e531, _e533, _e535, 0f)), _e540);
                                    phi_960_ = (_e543 <= _e508.member.member_1);
                                    phi_961_ = _e521;
                                }
                                let _e548 = phi_959_;
                                let _e550 = phi_960_;
                                let _e552 = phi_961_;
                                if _e550 {
                                    let _e557 = (_e548.member_1 & 268435455u);
                                    if ((_e548.member_1 & 2147483648u) != 0u) {
                                        phi_980_ = _e508;
                                        phi_983_ = type_8(0u, ((_e548.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1024 = phi_980_;
                                            let _e1026 = phi_983_;
                                            local_12 = _e1024;
                                            if (_e1026.member < _e1026.member_1) {
                                                phi_984_ = type_8((_e1026.member + 1u), _e1026.member_1);
                                                phi_1006_ = type_8(1u, _e1026.member);
                                            } else {
                                                phi_984_ = _e1026;
                                                phi_1006_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1039 = phi_984_;
                                            let _e1041 = phi_1006_;
                                            let _e1045 = (bitcast<i32>(_e1041.member) != 0i);
                                            if _e1045 {
                                                let _e1051 = type_43(_e1024.member, _e1024.member_1, (_e1024.member_2 + 1u));
                                                let _e1056 = (_e548.member.member_1.x - _e548.member.member.x);
                                                let _e1059 = (_e548.member.member_1.y - _e548.member.member.y);
                                                let _e1062 = (_e548.member.member_1.z - _e548.member.member.z);
                                                let _e1064 = select(_e1059, _e1056, (_e1056 > _e1059));
                                                let _e1066 = select(_e1062, _e1064, (_e1064 > _e1062));
                                                let _e1068 = (_e1066 < (1024f * _e143));
                                                if _e1068 {
                                                    phi_1050_ = 0u;
                                                } else {
                                                    phi_1050_ = select(2u, 1u, (_e1066 < (2097152f * _e143)));
                                                }
                                                let _e1073 = phi_1050_;
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
                                                let _e1076 = phi_1056_;
                                                switch bitcast<i32>(_e1073) {
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
                                                let _e1083 = phi_1066_;
                                                let _e1085 = ((_e557 + (_e1041.member_1 * ((3u * _e1076) + 1u))) + (3u * _e1083));
                                                let _e1086 = (_e1085 < _e95);
                                                if _e1086 {
                                                    if _e1086 {
                                                    } else {
                                                        phi_4043_ = true;
                                                        break;
                                                    }
                                                    let _e1088 = global_5.member[_e1085];
                                                    phi_1082_ = _e1088;
                                                } else {
                                                    phi_1082_ = 4294967295u;
                                                }
                                                let _e1090 = phi_1082_;
                                                if _e1068 {
                                                    phi_1115_ = 0u;
                                                } else {
                                                    phi_1115_ = select(2u, 1u, (_e1066 < (2097152f * _e143)));
                                                }
                                                let _e1095 = phi_1115_;
                                                switch bitcast<i32>(_e1095) {
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
                                                let _e1098 = phi_1121_;
                                                let _e1102 = (_e557 + (_e1041.member_1 * ((3u * _e1098) + 1u)));
                                                switch bitcast<i32>(_e1095) {
                                                    case 0: {
                                                        let _e1368 = (_e1102 < _e95);
                                                        if _e1368 {
                                                            if _e1368 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1370 = global_5.member[_e1102];
                                                            phi_1145_ = _e1370;
                                                        } else {
                                                            phi_1145_ = 0u;
                                                        }
                                                        let _e1372 = phi_1145_;
                                                        let _e1374 = ((10u * _e263) & 31u);
                                                        let _e1383 = ((10u * _e262) & 31u);
                                                        let _e1392 = ((10u * _e264) & 31u);
                                                        let _e1401 = (_e1102 + 1u);
                                                        let _e1402 = (_e1401 < _e95);
                                                        if _e1402 {
                                                            if _e1402 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1404 = global_5.member[_e1401];
                                                            phi_1188_ = _e1404;
                                                        } else {
                                                            phi_1188_ = 0u;
                                                        }
                                                        let _e1406 = phi_1188_;
                                                        let _e1429 = (_e1102 + 2u);
                                                        let _e1430 = (_e1429 < _e95);
                                                        if _e1430 {
                                                            if _e1430 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1432 = global_5.member[_e1429];
                                                            phi_1231_ = _e1432;
                                                        } else {
                                                            phi_1231_ = 0u;
                                                        }
                                                        let _e1434 = phi_1231_;
                                                        phi_1702_ = array<array<f32, 3>, 3>(array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>(((_e1372 >> bitcast<u32>(_e1374)) & 1023u))) * _e143)), (_e548.member.member.y + (f32(bitcast<i32>(((_e1372 >> bitcast<u32>(_e1383)) & 1023u))) * _e143)), (_e548.member.member.z + (f32(bitcast<i32>(((_e1372 >> bitcast<u32>(_e1392)) & 1023u))) * _e143))), array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>(((_e1406 >> bitcast<u32>(_e1374)) & 1023u))) * _e143)), (_e548.member.member.y + (f32(bitcast<i32>(((_e1406 >> bitcast<u32>(_e1383)) & 1023u))) * _e143)), (_e548.member.member.z + (f32(bitcast<i32>(((_e1406 >> bitcast<u32>(_e1392)) & 1023u))) * _e143))), array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1374)) & 1023u))) * _e143)), (_e548.member.member.y + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1383)) & 1023u))) * _e143)), (_e548.member.member.z + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1392)) & 1023u))) * _e143))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1191 = (_e1102 < _e95);
                                                        if _e1191 {
                                                            if _e1191 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1193 = global_5.member[_e1102];
                                                            phi_1274_ = _e1193;
                                                        } else {
                                                            phi_1274_ = 0u;
                                                        }
                                                        let _e1195 = phi_1274_;
                                                        let _e1196 = (_e1102 + 1u);
                                                        let _e1197 = (_e1196 < _e95);
                                                        if _e1197 {
                                                            if _e1197 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1199 = global_5.member[_e1196];
                                                            phi_1289_ = _e1199;
                                                        } else {
                                                            phi_1289_ = 0u;
                                                        }
                                                        let _e1201 = phi_1289_;
                                                        let _e1202 = (_e263 == 1u);
                                                        if _e1202 {
                                                            phi_1299_ = ((_e1195 >> bitcast<u32>(21i)) | (_e1201 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1299_ = (_e1201 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1211 = phi_1299_;
                                                        let _e1218 = (_e262 == 1u);
                                                        if _e1218 {
                                                            phi_1319_ = ((_e1195 >> bitcast<u32>(21i)) | (_e1201 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1319_ = (_e1201 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1227 = phi_1319_;
                                                        let _e1234 = (_e264 == 1u);
                                                        if _e1234 {
                                                            phi_1339_ = ((_e1195 >> bitcast<u32>(21i)) | (_e1201 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1339_ = (_e1201 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1243 = phi_1339_;
                                                        let _e1251 = (_e1102 + 2u);
                                                        let _e1252 = (_e1251 < _e95);
                                                        if _e1252 {
                                                            if _e1252 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1254 = global_5.member[_e1251];
                                                            phi_1365_ = _e1254;
                                                        } else {
                                                            phi_1365_ = 0u;
                                                        }
                                                        let _e1256 = phi_1365_;
                                                        let _e1257 = (_e1102 + 3u);
                                                        let _e1258 = (_e1257 < _e95);
                                                        if _e1258 {
                                                            if _e1258 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1260 = global_5.member[_e1257];
                                                            phi_1380_ = _e1260;
                                                        } else {
                                                            phi_1380_ = 0u;
                                                        }
                                                        let _e1262 = phi_1380_;
                                                        if _e1202 {
                                                            phi_1390_ = ((_e1256 >> bitcast<u32>(21i)) | (_e1262 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1390_ = (_e1262 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1271 = phi_1390_;
                                                        if _e1218 {
                                                            phi_1410_ = ((_e1256 >> bitcast<u32>(21i)) | (_e1262 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1410_ = (_e1262 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1286 = phi_1410_;
                                                        if _e1234 {
                                                            phi_1430_ = ((_e1256 >> bitcast<u32>(21i)) | (_e1262 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1430_ = (_e1262 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1301 = phi_1430_;
                                                        let _e1309 = (_e1102 + 4u);
                                                        let _e1310 = (_e1309 < _e95);
                                                        if _e1310 {
                                                            if _e1310 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1312 = global_5.member[_e1309];
                                                            phi_1456_ = _e1312;
                                                        } else {
                                                            phi_1456_ = 0u;
                                                        }
                                                        let _e1314 = phi_1456_;
                                                        let _e1315 = (_e1102 + 5u);
                                                        let _e1316 = (_e1315 < _e95);
                                                        if _e1316 {
                                                            if _e1316 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1318 = global_5.member[_e1315];
                                                            phi_1471_ = _e1318;
                                                        } else {
                                                            phi_1471_ = 0u;
                                                        }
                                                        let _e1320 = phi_1471_;
                                                        if _e1202 {
                                                            phi_1481_ = ((_e1314 >> bitcast<u32>(21i)) | (_e1320 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1481_ = (_e1320 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1329 = phi_1481_;
                                                        if _e1218 {
                                                            phi_1501_ = ((_e1314 >> bitcast<u32>(21i)) | (_e1320 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1501_ = (_e1320 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1344 = phi_1501_;
                                                        if _e1234 {
                                                            phi_1521_ = ((_e1314 >> bitcast<u32>(21i)) | (_e1320 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1521_ = (_e1320 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1359 = phi_1521_;
                                                        phi_1702_ = array<array<f32, 3>, 3>(array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>((select(_e1211, _e1195, _e302) & 2097151u))) * _e143)), (_e548.member.member.y + (f32(bitcast<i32>((select(_e1227, _e1195, _e341) & 2097151u))) * _e143)), (_e548.member.member.z + (f32(bitcast<i32>((select(_e1243, _e1195, _e379) & 2097151u))) * _e143))), array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>((select(_e1271, _e1256, _e302) & 2097151u))) * _e143)), (_e548.member.member.y + (f32(bitcast<i32>((select(_e1286, _e1256, _e341) & 2097151u))) * _e143)), (_e548.member.member.z + (f32(bitcast<i32>((select(_e1301, _e1256, _e379) & 2097151u))) * _e143))), array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>((select(_e1329, _e1314, _e302) & 2097151u))) * _e143)), (_e548.member.member.y + (f32(bitcast<i32>((select(_e1344, _e1314, _e341) & 2097151u))) * _e143)), (_e548.member.member.z + (f32(bitcast<i32>((select(_e1359, _e1314, _e379) & 2097151u))) * _e143))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1104 = (_e1102 + _e263);
                                                        let _e1105 = (_e1104 < _e95);
                                                        if _e1105 {
                                                            if _e1105 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1107 = global_5.member[_e1104];
                                                            phi_1548_ = _e1107;
                                                        } else {
                                                            phi_1548_ = 0u;
                                                        }
                                                        let _e1109 = phi_1548_;
                                                        let _e1113 = (_e1102 + _e262);
                                                        let _e1114 = (_e1113 < _e95);
                                                        if _e1114 {
                                                            if _e1114 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1116 = global_5.member[_e1113];
                                                            phi_1566_ = _e1116;
                                                        } else {
                                                            phi_1566_ = 0u;
                                                        }
                                                        let _e1118 = phi_1566_;
                                                        let _e1122 = (_e1102 + _e264);
                                                        let _e1123 = (_e1122 < _e95);
                                                        if _e1123 {
                                                            if _e1123 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1125 = global_5.member[_e1122];
                                                            phi_1584_ = _e1125;
                                                        } else {
                                                            phi_1584_ = 0u;
                                                        }
                                                        let _e1127 = phi_1584_;
                                                        let _e1132 = (_e1102 + 3u);
                                                        let _e1133 = (_e1132 + _e263);
                                                        let _e1134 = (_e1133 < _e95);
                                                        if _e1134 {
                                                            if _e1134 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1136 = global_5.member[_e1133];
                                                            phi_1604_ = _e1136;
                                                        } else {
                                                            phi_1604_ = 0u;
                                                        }
                                                        let _e1138 = phi_1604_;
                                                        let _e1142 = (_e1132 + _e262);
                                                        let _e1143 = (_e1142 < _e95);
                                                        if _e1143 {
                                                            if _e1143 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1145 = global_5.member[_e1142];
                                                            phi_1622_ = _e1145;
                                                        } else {
                                                            phi_1622_ = 0u;
                                                        }
                                                        let _e1147 = phi_1622_;
                                                        let _e1151 = (_e1132 + _e264);
                                                        let _e1152 = (_e1151 < _e95);
                                                        if _e1152 {
                                                            if _e1152 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1154 = global_5.member[_e1151];
                                                            phi_1640_ = _e1154;
                                                        } else {
                                                            phi_1640_ = 0u;
                                                        }
                                                        let _e1156 = phi_1640_;
                                                        let _e1161 = (_e1102 + 6u);
                                                        let _e1162 = (_e1161 + _e263);
                                                        let _e1163 = (_e1162 < _e95);
                                                        if _e1163 {
                                                            if _e1163 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1165 = global_5.member[_e1162];
                                                            phi_1660_ = _e1165;
                                                        } else {
                                                            phi_1660_ = 0u;
                                                        }
                                                        let _e1167 = phi_1660_;
                                                        let _e1171 = (_e1161 + _e262);
                                                        let _e1172 = (_e1171 < _e95);
                                                        if _e1172 {
                                                            if _e1172 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1174 = global_5.member[_e1171];
                                                            phi_1678_ = _e1174;
                                                        } else {
                                                            phi_1678_ = 0u;
                                                        }
                                                        let _e1176 = phi_1678_;
                                                        let _e1180 = (_e1161 + _e264);
                                                        let _e1181 = (_e1180 < _e95);
                                                        if _e1181 {
                                                            if _e1181 {
                                                            } else {
                                                                phi_4043_ = true;
                                                                break;
                                                            }
                                                            let _e1183 = global_5.member[_e1180];
                                                            phi_1696_ = _e1183;
                                                        } else {
                                                            phi_1696_ = 0u;
                                                        }
                                                        let _e1185 = phi_1696_;
                                                        phi_1702_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1109)) * _e143), (f32(bitcast<i32>(_e1118)) * _e143), (f32(bitcast<i32>(_e1127)) * _e143)), array<f32, 3>((f32(bitcast<i32>(_e1138)) * _e143), (f32(bitcast<i32>(_e1147)) * _e143), (f32(bitcast<i32>(_e1156)) * _e143)), array<f32, 3>((f32(bitcast<i32>(_e1167)) * _e143), (f32(bitcast<i32>(_e1176)) * _e143), (f32(bitcast<i32>(_e1185)) * _e143)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1702_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1459 = phi_1702_;
                                                let _e1468 = (_e1459[0][2] - _e389);
                                                let _e1471 = (((_e1459[0][0] - _e312) * _e413) - (_e1468 * _e337));
                                                let _e1474 = (((_e1459[0][1] - _e351) * _e413) - (_e1468 * _e375));
                                                let _e1481 = (_e1459[1][2] - _e389);
                                                let _e1484 = (((_e1459[1][0] - _e312) * _e413) - (_e1481 * _e337));
                                                let _e1487 = (((_e1459[1][1] - _e351) * _e413) - (_e1481 * _e375));
                                                let _e1494 = (_e1459[2][2] - _e389);
                                                let _e1497 = (((_e1459[2][0] - _e312) * _e413) - (_e1494 * _e337));
                                                let _e1500 = (((_e1459[2][1] - _e351) * _e413) - (_e1494 * _e375));
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
                                                        phi_2530_ = type_28();
                                                        phi_2531_ = true;
                                                        phi_2532_ = false;
                                                    } else {
                                                        let _e1535 = select(_e1484, _e1471, (_e1471 < _e1484));
                                                        if (select(_e1497, _e1535, (_e1535 < _e1497)) > 0f) {
                                                            phi_1819_ = true;
                                                        } else {
                                                            let _e1540 = select(_e1484, _e1471, (_e1471 > _e1484));
                                                            phi_1819_ = (select(_e1497, _e1540, (_e1540 > _e1497)) < 0f);
                                                        }
                                                        let _e1545 = phi_1819_;
                                                        if _e1545 {
                                                            phi_2527_ = type_28();
                                                            phi_2528_ = true;
                                                            phi_2529_ = false;
                                                        } else {
                                                            let _e1547 = select(_e1487, _e1474, (_e1474 < _e1487));
                                                            if (select(_e1500, _e1547, (_e1547 < _e1500)) > 0f) {
                                                                phi_1848_ = true;
                                                            } else {
                                                                let _e1552 = select(_e1487, _e1474, (_e1474 > _e1487));
                                                                phi_1848_ = (select(_e1500, _e1552, (_e1552 > _e1500)) < 0f);
                                                            }
                                                            let _e1557 = phi_1848_;
                                                            if _e1557 {
                                                                phi_2525_ = type_28();
                                                                phi_2526_ = false;
                                                            } else {
                                                                let _e1559 = select(_e1459[1][0], _e1459[0][0], (_e1459[0][0] < _e1459[1][0]));
                                                                let _e1563 = select(_e1459[1][0], _e1459[0][0], (_e1459[0][0] > _e1459[1][0]));
                                                                let _e1567 = select(_e1459[1][1], _e1459[0][1], (_e1459[0][1] < _e1459[1][1]));
                                                                let _e1571 = select(_e1459[1][1], _e1459[0][1], (_e1459[0][1] > _e1459[1][1]));
                                                                let _e1575 = select(_e1459[1][2], _e1459[0][2], (_e1459[0][2] < _e1459[1][2]));
                                                                let _e1579 = select(_e1459[1][2], _e1459[0][2], (_e1459[0][2] > _e1459[1][2]));
                                                                let _e1584 = ((select(_e1459[2][0], _e1559, (_e1559 < _e1459[2][0])) - _e335) * _e340);
                                                                let _e1585 = ((select(_e1459[2][0], _e1563, (_e1563 > _e1459[2][0])) - _e336) * _e340);
                                                                let _e1588 = ((select(_e1459[2][1], _e1567, (_e1567 < _e1459[2][1])) - _e373) * _e378);
                                                                let _e1589 = ((select(_e1459[2][1], _e1571, (_e1571 > _e1459[2][1])) - _e374) * _e378);
                                                                let _e1592 = ((select(_e1459[2][2], _e1575, (_e1575 < _e1459[2][2])) - _e411) * _e416);
                                                                let _e1593 = ((select(_e1459[2][2], _e1579, (_e1579 > _e1459[2][2])) - _e412) * _e416);
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
                                                                let _e1620 = select(_e463, _e1605, (_e1605 > _e463));
                                                                if (_e1620 > (_e1613 + (select(_e1614, _e1597, (_e1597 > _e1614)) * 0.0000019073523f))) {
                                                                    phi_2520_ = type_28();
                                                                    phi_2521_ = true;
                                                                } else {
                                                                    let _e1622 = (_e1620 > _e1024.member.member_1);
                                                                    if _e1622 {
                                                                        phi_2519_ = type_28();
                                                                    } else {
                                                                        let _e1623 = vec3<f32>(_e1459[0][0], _e1459[0][1], _e1459[0][2]);
                                                                        let _e1624 = vec3<f32>(_e1459[1][0], _e1459[1][1], _e1459[1][2]);
                                                                        let _e1625 = vec3<f32>(_e1459[2][0], _e1459[2][1], _e1459[2][2]);
                                                                        let _e1626 = (_e1459[1][0] - _e1459[0][0]);
                                                                        let _e1627 = (_e1459[1][1] - _e1459[0][1]);
                                                                        let _e1628 = (_e1459[1][2] - _e1459[0][2]);
                                                                        let _e1629 = vec3<f32>(_e1626, _e1627, _e1628);
                                                                        let _e1630 = (_e1459[2][0] - _e1459[1][0]);
                                                                        let _e1631 = (_e1459[2][1] - _e1459[1][1]);
                                                                        let _e1632 = (_e1459[2][2] - _e1459[1][2]);
                                                                        let _e1633 = vec3<f32>(_e1630, _e1631, _e1632);
                                                                        let _e1634 = (_e1459[0][0] - _e1459[2][0]);
                                                                        let _e1635 = (_e1459[0][1] - _e1459[2][1]);
                                                                        let _e1636 = (_e1459[0][2] - _e1459[2][2]);
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
                                                                            phi_2249_ = _e1487;
                                                                            phi_2250_ = _e1484;
                                                                            phi_2251_ = _e1474;
                                                                            phi_2252_ = _e1471;
                                                                            phi_2253_ = _e1623;
                                                                            phi_2254_ = _e1637;
                                                                            phi_2255_ = _e1633;
                                                                            phi_2256_ = _e1629;
                                                                        } else {
                                                                            let _e1682 = (_e1663 == _e1680);
                                                                            let _e1687 = vec3(_e1682);
                                                                            phi_2249_ = select(_e1474, _e1500, _e1682);
                                                                            phi_2250_ = select(_e1471, _e1497, _e1682);
                                                                            phi_2251_ = select(_e1500, _e1487, _e1682);
                                                                            phi_2252_ = select(_e1497, _e1484, _e1682);
                                                                            phi_2253_ = select(_e1625, _e1624, _e1687);
                                                                            phi_2254_ = select(_e1633, _e1629, _e1687);
                                                                            phi_2255_ = select(_e1629, _e1637, _e1687);
                                                                            phi_2256_ = select(_e1637, _e1633, _e1687);
                                                                        }
                                                                        let _e1693 = phi_2249_;
                                                                        let _e1695 = phi_2250_;
                                                                        let _e1697 = phi_2251_;
                                                                        let _e1699 = phi_2252_;
                                                                        let _e1701 = phi_2253_;
                                                                        let _e1703 = phi_2254_;
                                                                        let _e1705 = phi_2255_;
                                                                        let _e1707 = phi_2256_;
                                                                        let _e1714 = ((_e1705.y * _e1703.z) - (_e1703.y * _e1705.z));
                                                                        let _e1719 = ((_e1705.z * _e1703.x) - (_e1703.z * _e1705.x));
                                                                        let _e1722 = ((_e1705.x * _e1703.y) - (_e1703.x * _e1705.y));
                                                                        if (_e1522 >= _e1526) {
                                                                            phi_2287_ = select(true, false, (_e1522 >= _e1530));
                                                                        } else {
                                                                            phi_2287_ = true;
                                                                        }
                                                                        let _e1727 = phi_2287_;
                                                                        if _e1727 {
                                                                            phi_2296_ = select(_e1625, _e1624, vec3((_e1526 >= _e1530)));
                                                                        } else {
                                                                            phi_2296_ = _e1623;
                                                                        }
                                                                        let _e1732 = phi_2296_;
                                                                        let _e1737 = (((_e1714 * _e337) + (_e1719 * _e375)) + (_e1722 * _e413));
                                                                        let _e1748 = (((_e1714 * (_e1732.x - _e312)) + (_e1719 * (_e1732.y - _e351))) + (_e1722 * (_e1732.z - _e389)));
                                                                        let _e1750 = (_e1695 - _e1699);
                                                                        let _e1751 = (_e1693 - _e1697);
                                                                        let _e1759 = (-(((_e1699 * _e1750) + (_e1697 * _e1751))) / ((_e1750 * _e1750) + (_e1751 * _e1751)));
                                                                        let _e1761 = select(1f, _e1759, (_e1759 < 1f));
                                                                        let _e1763 = select(0f, _e1761, (_e1761 > 0f));
                                                                        let _e1776 = ((_e1701.x + (_e1707.x * _e1763)) - _e312);
                                                                        let _e1777 = ((_e1701.y + (_e1707.y * _e1763)) - _e351);
                                                                        let _e1778 = ((_e1701.z + (_e1707.z * _e1763)) - _e389);
                                                                        let _e1779 = (_e1778 / _e413);
                                                                        let _e1791 = bitcast<f32>((bitcast<u32>(_e1776) & 2147483647u));
                                                                        let _e1794 = bitcast<f32>((bitcast<u32>(_e1777) & 2147483647u));
                                                                        let _e1796 = select(_e1794, _e1791, (_e1791 > _e1794));
                                                                        let _e1799 = bitcast<f32>((bitcast<u32>(_e1778) & 2147483647u));
                                                                        let _e1801 = select(_e1799, _e1796, (_e1796 > _e1799));
                                                                        let _e1807 = bitcast<f32>((bitcast<u32>(_e1714) & 2147483647u));
                                                                        let _e1810 = bitcast<f32>((bitcast<u32>(_e1719) & 2147483647u));
                                                                        let _e1812 = select(_e1810, _e1807, (_e1807 > _e1810));
                                                                        let _e1815 = bitcast<f32>((bitcast<u32>(_e1722) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1714 * _e1776) + (_e1719 * _e1777)) + (_e1722 * _e1778)) - _e1748)) & 2147483647u)) <= ((0.0000009536743f * select(_e1680, _e1801, (_e1801 > _e1680))) * select(_e1815, _e1812, (_e1812 > _e1815)))) {
                                                                            let _e1825 = bitcast<f32>((bitcast<u32>(_e1705.x) & 2147483647u));
                                                                            let _e1828 = bitcast<f32>((bitcast<u32>(_e1705.y) & 2147483647u));
                                                                            let _e1830 = select(_e1828, _e1825, (_e1825 > _e1828));
                                                                            let _e1833 = bitcast<f32>((bitcast<u32>(_e1705.z) & 2147483647u));
                                                                            let _e1839 = bitcast<f32>((bitcast<u32>(_e1703.x) & 2147483647u));
                                                                            let _e1842 = bitcast<f32>((bitcast<u32>(_e1703.y) & 2147483647u));
                                                                            let _e1844 = select(_e1842, _e1839, (_e1839 > _e1842));
                                                                            let _e1847 = bitcast<f32>((bitcast<u32>(_e1703.z) & 2147483647u));
                                                                            phi_2463_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1737) & 2147483647u)) > ((0.0000038146973f * select(_e1833, _e1830, (_e1830 > _e1833))) * select(_e1847, _e1844, (_e1844 > _e1847)))));
                                                                        } else {
                                                                            phi_2463_ = true;
                                                                        }
                                                                        let _e1854 = phi_2463_;
                                                                        if _e1854 {
                                                                            let _e1865 = ((((_e1714 * (_e1776 - (_e337 * _e1779))) + (_e1719 * (_e1777 - (_e375 * _e1779)))) + (_e1722 * (_e1778 - _e1778))) / _e1737);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1865) & 2147483647u)) <= _e1680) {
                                                                                phi_2487_ = (_e1779 + _e1865);
                                                                            } else {
                                                                                phi_2487_ = _e1779;
                                                                            }
                                                                            let _e1872 = phi_2487_;
                                                                            phi_2488_ = _e1872;
                                                                        } else {
                                                                            phi_2488_ = (_e1748 / _e1737);
                                                                        }
                                                                        let _e1874 = phi_2488_;
                                                                        let _e1876 = select(_e1613, _e1874, (_e1874 < _e1613));
                                                                        let _e1878 = select(_e1605, _e1876, (_e1876 > _e1605));
                                                                        if (_e1878 >= _e463) {
                                                                            let _e1880 = (_e1878 <= _e1024.member.member_1);
                                                                            if _e1880 {
                                                                                let _e1881 = (1f / _e1532);
                                                                                phi_2511_ = type_28(_e1878, (_e1526 * _e1881), (_e1530 * _e1881), _e1090);
                                                                            } else {
                                                                                phi_2511_ = type_28();
                                                                            }
                                                                            let _e1886 = phi_2511_;
                                                                            phi_2513_ = _e1886;
                                                                            phi_2514_ = select(true, false, _e1880);
                                                                        } else {
                                                                            phi_2513_ = type_28();
                                                                            phi_2514_ = true;
                                                                        }
                                                                        let _e1889 = phi_2513_;
                                                                        let _e1891 = phi_2514_;
                                                                        if _e1891 {
                                                                            phi_2518_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2518_ = _e1889;
                                                                        }
                                                                        let _e1893 = phi_2518_;
                                                                        phi_2519_ = _e1893;
                                                                    }
                                                                    let _e1895 = phi_2519_;
                                                                    phi_2520_ = _e1895;
                                                                    phi_2521_ = _e1622;
                                                                }
                                                                let _e1897 = phi_2520_;
                                                                let _e1899 = phi_2521_;
                                                                phi_2525_ = _e1897;
                                                                phi_2526_ = _e1899;
                                                            }
                                                            let _e1901 = phi_2525_;
                                                            let _e1903 = phi_2526_;
                                                            phi_2527_ = _e1901;
                                                            phi_2528_ = _e1557;
                                                            phi_2529_ = _e1903;
                                                        }
                                                        let _e1905 = phi_2527_;
                                                        let _e1907 = phi_2528_;
                                                        let _e1909 = phi_2529_;
                                                        phi_2530_ = _e1905;
                                                        phi_2531_ = _e1907;
                                                        phi_2532_ = _e1909;
                                                    }
                                                    let _e1911 = phi_2530_;
                                                    let _e1913 = phi_2531_;
                                                    let _e1915 = phi_2532_;
                                                    phi_2540_ = _e1911;
                                                    phi_2541_ = select(_e1915, true, _e1913);
                                                } else {
                                                    phi_2540_ = type_28();
                                                    phi_2541_ = true;
                                                }
                                                let _e1918 = phi_2540_;
                                                let _e1920 = phi_2541_;
                                                if _e1920 {
                                                    phi_2545_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2545_ = _e1918;
                                                }
                                                let _e1922 = phi_2545_;
                                                if (_e1922.member_3 != 4294967295u) {
                                                    if (_e1090 != 4294967295u) {
                                                        if (_e1922.member < _e1024.member.member.member) {
                                                            phi_2571_ = true;
                                                        } else {
                                                            if (_e1922.member == _e1024.member.member.member) {
                                                                phi_2570_ = (_e1922.member_3 < _e1024.member.member.member_3);
                                                            } else {
                                                                phi_2570_ = false;
                                                            }
                                                            let _e1937 = phi_2570_;
                                                            phi_2571_ = _e1937;
                                                        }
                                                        let _e1939 = phi_2571_;
                                                        if _e1939 {
                                                            phi_2578_ = type_43(type_36(_e1922, _e1922.member), _e1051.member_1, _e1051.member_2);
                                                        } else {
                                                            phi_2578_ = _e1051;
                                                        }
                                                        let _e1946 = phi_2578_;
                                                        phi_2579_ = _e1946;
                                                    } else {
                                                        phi_2579_ = _e1051;
                                                    }
                                                    let _e1948 = phi_2579_;
                                                    phi_2580_ = _e1948;
                                                } else {
                                                    phi_2580_ = _e1051;
                                                }
                                                let _e1950 = phi_2580_;
                                                phi_981_ = _e1950;
                                            } else {
                                                phi_981_ = type_43();
                                            }
                                            let _e1952 = phi_981_;
                                            continue;
                                            continuing {
                                                phi_980_ = _e1952;
                                                phi_983_ = _e1039;
                                                phi_4043_ = _e506;
                                                break if !(_e1045);
                                            }
                                        }
                                        let _e1955 = phi_4043_;
                                        phi_4232_ = _e1955;
                                        if _e1955 {
                                            break;
                                        }
                                        phi_4236_ = _e1955;
                                        let _e2159 = local_12;
                                        phi_3823_ = _e2159;
                                        phi_3824_ = _e548;
                                        phi_3825_ = false;
                                        phi_3826_ = _e552;
                                    } else {
                                        if (_e548.member_1 >= _e92) {
                                            phi_3379_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e548.member_1 < _e92) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e571 = ((1u + _e263) % 4u);
                                            if (_e571 < 4u) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e576 = global_3.member[_e548.member_1][_e571];
                                            let _e578 = (_e576 >> bitcast<u32>(11u));
                                            let _e580 = ((1u + _e262) % 4u);
                                            if (_e580 < 4u) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e585 = global_3.member[_e548.member_1][_e580];
                                            let _e587 = (_e585 >> bitcast<u32>(11u));
                                            let _e589 = ((1u + _e264) % 4u);
                                            if (_e589 < 4u) {
                                            } else {
                                                phi_4232_ = true;
                                                break;
                                            }
                                            let _e594 = global_3.member[_e548.member_1][_e589];
                                            let _e596 = (_e594 >> bitcast<u32>(11u));
                                            let _e619 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.x - _e548.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.y - _e548.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.z - _e548.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e623 = select(_e143, _e619, (_e619 > _e143));
                                            let _e625 = select(_e143, _e620, (_e620 > _e143));
                                            let _e627 = select(_e143, _e621, (_e621 > _e143));
                                            let _e652 = bitcast<u32>((f32(bitcast<i32>((_e576 & 1023u))) * _e623));
                                            let _e657 = (bitcast<i32>((_e576 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e660 = bitcast<f32>((_e652 & bitcast<u32>(_e657)));
                                            let _e661 = bitcast<u32>((f32(bitcast<i32>((_e585 & 1023u))) * _e625));
                                            let _e666 = (bitcast<i32>((_e585 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e669 = bitcast<f32>((_e661 & bitcast<u32>(_e666)));
                                            let _e670 = bitcast<u32>((f32(bitcast<i32>((_e594 & 1023u))) * _e627));
                                            let _e675 = (bitcast<i32>((_e594 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e678 = bitcast<f32>((_e670 & bitcast<u32>(_e675)));
                                            let _e682 = bitcast<f32>((_e652 & bitcast<u32>(~(_e657))));
                                            let _e686 = bitcast<f32>((_e661 & bitcast<u32>(~(_e666))));
                                            let _e690 = bitcast<f32>((_e670 & bitcast<u32>(~(_e675))));
                                            let _e691 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e623));
                                            let _e696 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e699 = bitcast<f32>((_e691 & bitcast<u32>(_e696)));
                                            let _e700 = bitcast<u32>((f32(bitcast<i32>((_e587 & 1023u))) * _e625));
                                            let _e705 = (bitcast<i32>((_e587 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e708 = bitcast<f32>((_e700 & bitcast<u32>(_e705)));
                                            let _e709 = bitcast<u32>((f32(bitcast<i32>((_e596 & 1023u))) * _e627));
                                            let _e714 = (bitcast<i32>((_e596 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e717 = bitcast<f32>((_e709 & bitcast<u32>(_e714)));
                                            let _e721 = bitcast<f32>((_e691 & bitcast<u32>(~(_e696))));
                                            let _e725 = bitcast<f32>((_e700 & bitcast<u32>(~(_e705))));
                                            let _e729 = bitcast<f32>((_e709 & bitcast<u32>(~(_e714))));
                                            let _e730 = (_e548.member.member.x + _e660);
                                            let _e731 = (_e548.member.member.y + _e669);
                                            let _e732 = (_e548.member.member.z + _e678);
                                            let _e735 = (_e548.member.member_1.x - _e699);
                                            let _e736 = (_e548.member.member_1.y - _e708);
                                            let _e737 = (_e548.member.member_1.z - _e717);
                                            let _e756 = (_e735 - _e730);
                                            let _e757 = (_e736 - _e731);
                                            let _e758 = (_e737 - _e732);
                                            let _e760 = select(_e757, _e756, (_e756 > _e757));
                                            let _e762 = select(_e758, _e760, (_e760 > _e758));
                                            if (_e762 < (1024f * _e143)) {
                                                phi_3080_ = 0u;
                                            } else {
                                                phi_3080_ = select(2u, 1u, (_e762 < (2097152f * _e143)));
                                            }
                                            let _e769 = phi_3080_;
                                            switch bitcast<i32>(_e769) {
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
                                            let _e772 = phi_3086_;
                                            let _e778 = global_3.member[_e548.member_1][0u];
                                            let _e782 = global_3.member[_e548.member_1][1u];
                                            let _e786 = global_3.member[_e548.member_1][2u];
                                            let _e790 = global_3.member[_e548.member_1][3u];
                                            let _e802 = (((_e782 >> bitcast<u32>(22i)) | ((_e786 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e790 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e803 = (_e778 & 268435455u);
                                            let _e804 = (_e802 & 268435455u);
                                            let _e807 = ((_e778 >> bitcast<u32>(28u)) & 7u);
                                            let _e815 = ((_e778 >> bitcast<u32>(31i)) | (((_e802 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e816 = (_e807 != 0u);
                                            if (_e807 == 0u) {
                                                phi_3341_ = _e803;
                                            } else {
                                                if (_e807 == 7u) {
                                                    phi_3340_ = 2147483648u;
                                                } else {
                                                    phi_3340_ = ((2147483648u | (_e807 << bitcast<u32>(28u))) | (_e804 & 268435455u));
                                                }
                                                let _e825 = phi_3340_;
                                                phi_3341_ = _e825;
                                            }
                                            let _e827 = phi_3341_;
                                            if _e816 {
                                                let _e828 = (_e807 != 7u);
                                                if _e828 {
                                                    phi_3351_ = (_e804 + (_e807 * ((3u * _e772) + 1u)));
                                                } else {
                                                    phi_3351_ = u32();
                                                }
                                                let _e832 = phi_3351_;
                                                phi_3353_ = _e832;
                                                phi_3354_ = select(true, false, _e828);
                                            } else {
                                                phi_3353_ = u32();
                                                phi_3354_ = true;
                                            }
                                            let _e835 = phi_3353_;
                                            let _e837 = phi_3354_;
                                            if (_e815 == 0u) {
                                                phi_3375_ = (_e803 + select(0u, 1u, !(_e816)));
                                            } else {
                                                if (_e815 == 7u) {
                                                    phi_3374_ = 2147483648u;
                                                } else {
                                                    phi_3374_ = ((2147483648u | (_e815 << bitcast<u32>(28u))) | (select(_e835, _e804, _e837) & 268435455u));
                                                }
                                                let _e850 = phi_3374_;
                                                phi_3375_ = _e850;
                                            }
                                            let _e852 = phi_3375_;
                                            phi_3379_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e730, (_e548.member.member.x + _e682), _e735, (_e548.member.member_1.x - _e721)), vec4<f32>(_e731, (_e548.member.member.y + _e686), _e736, (_e548.member.member_1.y - _e725)), vec4<f32>(_e732, (_e548.member.member.z + _e690), _e737, (_e548.member.member_1.z - _e729))), type_50(type_32((_e548.member.member + vec4<f32>(_e660, _e669, _e678, 0f)), (_e548.member.member_1 - vec4<f32>(_e699, _e708, _e717, 0f))), _e827), type_50(type_32((_e548.member.member + vec4<f32>(_e682, _e686, _e690, 0f)), (_e548.member.member_1 - vec4<f32>(_e721, _e725, _e729, 0f))), _e852));
                                        }
                                        let _e857 = phi_3379_;
                                        let _e870 = ((_e857.member[0].x - _e335) * _e340);
                                        let _e871 = ((_e857.member[0].y - _e335) * _e340);
                                        let _e872 = ((_e857.member[0].z - _e336) * _e340);
                                        let _e873 = ((_e857.member[0].w - _e336) * _e340);
                                        let _e883 = ((_e857.member[1].x - _e373) * _e378);
                                        let _e884 = ((_e857.member[1].y - _e373) * _e378);
                                        let _e885 = ((_e857.member[1].z - _e374) * _e378);
                                        let _e886 = ((_e857.member[1].w - _e374) * _e378);
                                        let _e896 = ((_e857.member[2].x - _e411) * _e416);
                                        let _e897 = ((_e857.member[2].y - _e411) * _e416);
                                        let _e898 = ((_e857.member[2].z - _e412) * _e416);
                                        let _e899 = ((_e857.member[2].w - _e412) * _e416);
                                        let _e901 = select(_e898, _e896, (_e896 < _e898));
                                        let _e903 = select(_e899, _e897, (_e897 < _e899));
                                        let _e905 = select(_e898, _e896, (_e896 > _e898));
                                        let _e907 = select(_e899, _e897, (_e897 > _e899));
                                        let _e909 = select(_e872, _e870, (_e870 < _e872));
                                        let _e911 = select(_e873, _e871, (_e871 < _e873));
                                        let _e913 = select(_e885, _e883, (_e883 < _e885));
                                        let _e915 = select(_e886, _e884, (_e884 < _e886));
                                        let _e917 = select(_e913, _e909, (_e909 > _e913));
                                        let _e919 = select(_e915, _e911, (_e911 > _e915));
                                        let _e921 = select(_e901, _e917, (_e917 > _e901));
                                        let _e923 = select(_e903, _e919, (_e919 > _e903));
                                        let _e925 = select(_e872, _e870, (_e870 > _e872));
                                        let _e927 = select(_e873, _e871, (_e871 > _e873));
                                        let _e929 = select(_e885, _e883, (_e883 > _e885));
                                        let _e931 = select(_e886, _e884, (_e884 > _e886));
                                        let _e933 = select(_e929, _e925, (_e925 < _e929));
                                        let _e935 = select(_e931, _e927, (_e927 < _e931));
                                        let _e940 = -(_e901);
                                        let _e941 = -(_e903);
                                        let _e948 = (select(_e905, _e933, (_e933 < _e905)) + (select(_e940, _e905, (_e905 > _e940)) * 0.0000019073523f));
                                        let _e949 = (select(_e907, _e935, (_e935 < _e907)) + (select(_e941, _e907, (_e907 > _e941)) * 0.0000019073523f));
                                        let _e951 = select(_e463, _e921, (_e921 > _e463));
                                        let _e953 = select(_e463, _e923, (_e923 > _e463));
                                        let _e958 = (_e951 <= select(_e508.member.member_1, _e948, (_e948 < _e508.member.member_1)));
                                        let _e959 = (_e953 <= select(_e508.member.member_1, _e949, (_e949 < _e508.member.member_1)));
                                        let _e960 = (_e951 <= _e953);
                                        if _e958 {
                                            if _e959 {
                                                if _e960 {
                                                    phi_3723_ = _e857.member_2;
                                                } else {
                                                    phi_3723_ = _e857.member_1;
                                                }
                                                let _e964 = phi_3723_;
                                                let _e986 = (_e552 % 128u);
                                                let _e987 = (_e986 < 128u);
                                                if _e987 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_8[_e986] = _e964.member_1;
                                                if _e987 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_7[_e986] = _e964.member.member.x;
                                                if _e987 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_6[_e986] = _e964.member.member.y;
                                                if _e987 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_5[_e986] = _e964.member.member.z;
                                                if _e987 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_4[_e986] = _e964.member.member_1.x;
                                                if _e987 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_3[_e986] = _e964.member.member_1.y;
                                                if _e987 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_2[_e986] = _e964.member.member_1.z;
                                                if _e987 {
                                                } else {
                                                    phi_4232_ = true;
                                                    break;
                                                }
                                                local_9[_e986] = select(_e953, _e951, (_e951 > _e953));
                                                if _e960 {
                                                    phi_3800_ = _e857.member_1;
                                                } else {
                                                    phi_3800_ = _e857.member_2;
                                                }
                                                let _e1000 = phi_3800_;
                                                phi_3801_ = _e1000;
                                                phi_3802_ = (_e552 + 1u);
                                            } else {
                                                phi_3801_ = type_50();
                                                phi_3802_ = u32();
                                            }
                                            let _e1002 = phi_3801_;
                                            let _e1004 = phi_3802_;
                                            phi_3804_ = _e1002;
                                            phi_3805_ = _e1004;
                                            phi_3806_ = select(true, false, _e959);
                                        } else {
                                            phi_3804_ = type_50();
                                            phi_3805_ = u32();
                                            phi_3806_ = true;
                                        }
                                        let _e1007 = phi_3804_;
                                        let _e1009 = phi_3805_;
                                        let _e1011 = phi_3806_;
                                        if _e1011 {
                                            if _e958 {
                                                phi_3815_ = _e857.member_1;
                                            } else {
                                                phi_3815_ = _e857.member_2;
                                            }
                                            let _e1015 = phi_3815_;
                                            phi_3820_ = _e1015;
                                            phi_3821_ = select(_e959, true, _e958);
                                        } else {
                                            phi_3820_ = _e1007;
                                            phi_3821_ = _e550;
                                        }
                                        let _e1018 = phi_3820_;
                                        let _e1020 = phi_3821_;
                                        phi_4236_ = _e506;
                                        phi_3823_ = type_43(_e508.member, (_e508.member_1 + 1u), _e508.member_2);
                                        phi_3824_ = _e1018;
                                        phi_3825_ = _e1020;
                                        phi_3826_ = select(_e1009, _e552, _e1011);
                                    }
                                    let _e1957 = phi_4236_;
                                    let _e1959 = phi_3823_;
                                    let _e1961 = phi_3824_;
                                    let _e1963 = phi_3825_;
                                    let _e1965 = phi_3826_;
                                    phi_4235_ = _e1957;
                                    phi_3827_ = _e1959;
                                    phi_3828_ = _e1961;
                                    phi_3829_ = (_e512 - 1u);
                                    phi_3830_ = _e1963;
                                    phi_3831_ = _e1965;
                                } else {
                                    phi_4235_ = _e506;
                                    phi_3827_ = _e508;
                                    phi_3828_ = _e548;
                                    phi_3829_ = _e512;
                                    phi_3830_ = _e550;
                                    phi_3831_ = _e552;
                                }
                                let _e1967 = phi_4235_;
                                let _e1969 = phi_3827_;
                                let _e1971 = phi_3828_;
                                let _e1973 = phi_3829_;
                                let _e1975 = phi_3830_;
                                let _e1977 = phi_3831_;
                                phi_4234_ = _e1967;
                                phi_3832_ = _e1969;
                                phi_3833_ = _e1971;
                                phi_3834_ = _e1973;
                                phi_3835_ = _e1975;
                                phi_3836_ = _e1977;
                            } else {
                                phi_4234_ = _e506;
                                phi_3832_ = type_43();
                                phi_3833_ = type_50();
                                phi_3834_ = u32();
                                phi_3835_ = bool();
                                phi_3836_ = u32();
                            }
                            let _e1979 = phi_4234_;
                            let _e1981 = phi_3832_;
                            let _e1983 = phi_3833_;
                            let _e1985 = phi_3834_;
                            let _e1987 = phi_3835_;
                            let _e1989 = phi_3836_;
                            phi_4233_ = _e1979;
                            phi_854_ = _e1981;
                            phi_857_ = _e1983;
                            phi_859_ = _e1985;
                            phi_861_ = _e1987;
                            phi_863_ = _e1989;
                            phi_3837_ = _e520;
                        } else {
                            phi_4233_ = _e506;
                            phi_854_ = type_43();
                            phi_857_ = type_50();
                            phi_859_ = u32();
                            phi_861_ = bool();
                            phi_863_ = u32();
                            phi_3837_ = false;
                        }
                        let _e1991 = phi_4233_;
                        let _e1993 = phi_854_;
                        let _e1995 = phi_857_;
                        let _e1997 = phi_859_;
                        let _e1999 = phi_861_;
                        let _e2001 = phi_863_;
                        let _e2003 = phi_3837_;
                        continue;
                        continuing {
                            phi_4049_ = _e1991;
                            phi_853_ = _e1993;
                            phi_856_ = _e1995;
                            phi_858_ = _e1997;
                            phi_860_ = _e1999;
                            phi_862_ = _e2001;
                            phi_4232_ = _e1991;
                            break if !(_e2003);
                        }
                    }
                    let _e2006 = phi_4232_;
                    if _e2006 {
                        break;
                    }
                    let _e2008 = local_10;
                    let _e2011 = local_11;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_6.member[_e149][0u] = _e2008.member_1;
                    global_6.member[_e149][1u] = _e2011.member_2;
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
