struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_25 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: array<type_22>,
}

struct type_37 {
    member: array<array<type_21, 8>>,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<array<u32, 7>>,
}

struct type_52 {
    member: type_25,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_43;
@group(0) @binding(4) 
var<storage> global_4: type_33;
@group(0) @binding(2) 
var<storage> global_5: type_47;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_37;

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
    var local_9: array<type_21, 8>;
    var local_10: array<f32, 128>;
    var phi_383_: i32;
    var phi_384_: i32;
    var phi_394_: bool;
    var phi_404_: u32;
    var phi_405_: u32;
    var phi_407_: bool;
    var phi_412_: u32;
    var phi_424_: i32;
    var phi_444_: i32;
    var phi_462_: f32;
    var phi_468_: f32;
    var phi_479_: f32;
    var phi_485_: f32;
    var phi_508_: f32;
    var phi_519_: f32;
    var phi_528_: f32;
    var phi_534_: f32;
    var phi_545_: f32;
    var phi_551_: f32;
    var phi_574_: f32;
    var phi_585_: f32;
    var phi_594_: f32;
    var phi_600_: f32;
    var phi_611_: f32;
    var phi_617_: f32;
    var phi_640_: f32;
    var phi_651_: f32;
    var phi_751_: f32;
    var phi_752_: f32;
    var phi_3494_: bool;
    var phi_3422_: f32;
    var phi_894_: type_52;
    var phi_897_: u32;
    var phi_899_: bool;
    var phi_901_: u32;
    var phi_912_: bool;
    var phi_999_: type_52;
    var phi_1000_: bool;
    var phi_1001_: u32;
    var phi_2555_: u32;
    var phi_2556_: u32;
    var phi_2566_: u32;
    var phi_2568_: u32;
    var phi_2569_: bool;
    var phi_2589_: u32;
    var phi_2590_: u32;
    var phi_2594_: type_53;
    var phi_2939_: type_52;
    var phi_3016_: type_52;
    var phi_3017_: type_52;
    var phi_3018_: u32;
    var phi_3020_: type_52;
    var phi_3021_: u32;
    var phi_3022_: bool;
    var phi_3031_: type_52;
    var phi_3036_: type_52;
    var phi_3037_: bool;
    var phi_3491_: bool;
    var phi_3481_: f32;
    var phi_1019_: type_4;
    var phi_1020_: type_4;
    var phi_1043_: type_4;
    var phi_1064_: u32;
    var phi_1153_: array<array<f32, 3>, 3>;
    var phi_1625_: vec3<f32>;
    var phi_1626_: vec3<f32>;
    var phi_1657_: bool;
    var phi_1666_: vec3<f32>;
    var phi_1706_: type_21;
    var phi_1708_: type_21;
    var phi_1709_: bool;
    var phi_1713_: type_21;
    var phi_1714_: type_21;
    var phi_1715_: type_21;
    var phi_1716_: bool;
    var phi_1720_: type_21;
    var phi_1721_: bool;
    var phi_1725_: type_21;
    var phi_1726_: bool;
    var phi_1730_: type_21;
    var phi_1742_: type_4;
    var phi_1745_: type_21;
    var phi_1743_: type_4;
    var phi_1768_: type_4;
    var phi_1800_: bool;
    var phi_1801_: bool;
    var phi_1822_: type_21;
    var phi_1746_: type_21;
    var phi_3482_: bool;
    var phi_3801_: f32;
    var phi_3800_: f32;
    var phi_3599_: bool;
    var phi_3799_: f32;
    var phi_3598_: bool;
    var phi_3798_: f32;
    var phi_3597_: bool;
    var phi_3738_: f32;
    var phi_3596_: bool;
    var phi_3703_: f32;
    var phi_3605_: bool;
    var phi_3039_: type_52;
    var phi_3040_: bool;
    var phi_3041_: u32;
    var phi_3702_: f32;
    var phi_3604_: bool;
    var phi_3042_: type_52;
    var phi_3043_: u32;
    var phi_3044_: bool;
    var phi_3045_: u32;
    var phi_3701_: f32;
    var phi_3603_: bool;
    var phi_3046_: type_52;
    var phi_3047_: u32;
    var phi_3048_: bool;
    var phi_3049_: u32;
    var phi_3700_: f32;
    var phi_3602_: bool;
    var phi_895_: type_52;
    var phi_898_: u32;
    var phi_900_: bool;
    var phi_902_: u32;
    var phi_3050_: bool;
    var phi_3601_: bool;
    var phi_3057_: type_4;
    var phi_3058_: type_4;
    var phi_3081_: type_4;
    var phi_3147_: type_21;
    var phi_3693_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e87 = arrayLength((&global_5.member));
            let _e89 = arrayLength((&global_2.member));
            let _e97 = global_3.member[0u][0u];
            let _e101 = global_3.member[0u][1u];
            let _e105 = global_3.member[0u][2u];
            let _e109 = global_3.member[0u][3u];
            let _e113 = global_3.member[1u][0u];
            let _e117 = global_3.member[1u][1u];
            let _e121 = global_3.member[1u][2u];
            let _e124 = global_1.member[0u];
            let _e125 = bitcast<i32>(_e124);
            let _e137 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e109) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e97), bitcast<i32>(_e101), bitcast<i32>(_e105));
            local = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            let _e143 = (_e85.x + (_e85.y * 2097152u));
            let _e144 = (_e143 < arrayLength((&global_4.member)));
            if _e144 {
                let _e145 = (_e143 < arrayLength((&global_6.member)));
                if _e145 {
                    if _e144 {
                    } else {
                        break;
                    }
                    let _e153 = global_4.member[_e143].member_2[0u];
                    let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                    let _e160 = global_4.member[_e143].member_2[1u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_4.member[_e143].member_2[2u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_4.member[_e143].member[0u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_4.member[_e143].member[1u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_4.member[_e143].member[2u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e192 = select(_e162, _e155, (_e162 < _e155));
                    let _e194 = select(_e169, _e192, (_e169 < _e192));
                    let _e196 = select(_e176, _e194, (_e176 < _e194));
                    let _e198 = select(_e183, _e196, (_e183 < _e196));
                    let _e200 = select(_e190, _e198, (_e190 < _e198));
                    let _e204 = global_4.member[_e143].member_1;
                    let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                    let _e213 = global_4.member[_e143].member_3;
                    let _e219 = (((select(_e206, _e200, (_e206 < _e200)) < 2139095040u) && ((bitcast<u32>(_e213) & 2147483647u) <= 2139095040u)) && (_e194 > 0u));
                    if _e219 {
                        let _e222 = (bitcast<u32>(bitcast<f32>(_e194)) & 2147483647u);
                        if (_e222 >= 8388608u) {
                            phi_383_ = (bitcast<i32>((_e222 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_383_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e222)), 32u, (_e222 == 0u))));
                        }
                        let _e236 = phi_383_;
                        phi_384_ = _e236;
                    } else {
                        phi_384_ = 0i;
                    }
                    let _e238 = phi_384_;
                    let _e239 = (_e155 == _e194);
                    if _e239 {
                        phi_394_ = true;
                    } else {
                        phi_394_ = (_e162 == _e194);
                    }
                    let _e242 = phi_394_;
                    let _e243 = select(1u, 0u, _e239);
                    if _e242 {
                        let _e244 = (_e243 + 1u);
                        phi_404_ = _e244;
                        phi_405_ = _e244;
                        phi_407_ = select(true, false, (_e244 == 2u));
                    } else {
                        phi_404_ = u32();
                        phi_405_ = 0u;
                        phi_407_ = true;
                    }
                    let _e248 = phi_404_;
                    let _e250 = phi_405_;
                    let _e252 = phi_407_;
                    if _e252 {
                        phi_412_ = (_e250 + 1u);
                    } else {
                        phi_412_ = 0u;
                    }
                    let _e256 = phi_412_;
                    let _e257 = select(_e248, _e250, _e252);
                    let _e258 = select(_e243, select(2u, _e243, _e242), _e252);
                    if (_e125 < -126i) {
                        phi_424_ = -126i;
                    } else {
                        phi_424_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e263 = phi_424_;
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e125 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e275 = -(_e238);
                    if (_e275 < -126i) {
                        phi_444_ = -126i;
                    } else {
                        phi_444_ = select(_e275, 127i, (_e275 > 127i));
                    }
                    let _e280 = phi_444_;
                    let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
                    let _e291 = bitcast<f32>((bitcast<u32>(((_e275 - _e280) + 127i)) << bitcast<u32>(23i)));
                    let _e295 = global_4.member[_e143].member;
                    let _e296 = (_e257 == 0u);
                    if _e296 {
                        phi_462_ = _e295[0];
                    } else {
                        phi_462_ = _e295[1];
                    }
                    let _e300 = phi_462_;
                    let _e301 = (_e257 == 2u);
                    if _e301 {
                        phi_468_ = _e295[2];
                    } else {
                        phi_468_ = _e300;
                    }
                    let _e304 = phi_468_;
                    let _e306 = ((_e304 * _e268) * _e274);
                    let _e307 = global_4.member[_e143].member_2;
                    if _e296 {
                        phi_479_ = _e307[0];
                    } else {
                        phi_479_ = _e307[1];
                    }
                    let _e311 = phi_479_;
                    if _e301 {
                        phi_485_ = _e307[2];
                    } else {
                        phi_485_ = _e311;
                    }
                    let _e314 = phi_485_;
                    let _e316 = ((_e314 * _e285) * _e291);
                    let _e320 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e320 {
                        let _e324 = (bitcast<f32>((bitcast<u32>(_e306) & 2147483647u)) * 0.00000011920929f);
                        phi_508_ = select(0.00000000000011368684f, _e324, (_e324 > 0.00000000000011368684f));
                    } else {
                        phi_508_ = 0f;
                    }
                    let _e328 = phi_508_;
                    let _e329 = (_e306 + _e328);
                    let _e330 = (_e306 - _e328);
                    let _e331 = select(_e316, 0f, _e320);
                    if _e320 {
                        phi_519_ = 38685626000000000000000000f;
                    } else {
                        phi_519_ = (1f / _e316);
                    }
                    let _e334 = phi_519_;
                    let _e335 = (_e256 == 0u);
                    if _e335 {
                        phi_528_ = _e295[0];
                    } else {
                        phi_528_ = _e295[1];
                    }
                    let _e339 = phi_528_;
                    let _e340 = (_e256 == 2u);
                    if _e340 {
                        phi_534_ = _e295[2];
                    } else {
                        phi_534_ = _e339;
                    }
                    let _e343 = phi_534_;
                    let _e345 = ((_e343 * _e268) * _e274);
                    if _e335 {
                        phi_545_ = _e307[0];
                    } else {
                        phi_545_ = _e307[1];
                    }
                    let _e349 = phi_545_;
                    if _e340 {
                        phi_551_ = _e307[2];
                    } else {
                        phi_551_ = _e349;
                    }
                    let _e352 = phi_551_;
                    let _e354 = ((_e352 * _e285) * _e291);
                    let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e358 {
                        let _e362 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) * 0.00000011920929f);
                        phi_574_ = select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f));
                    } else {
                        phi_574_ = 0f;
                    }
                    let _e366 = phi_574_;
                    let _e367 = (_e345 + _e366);
                    let _e368 = (_e345 - _e366);
                    let _e369 = select(_e354, 0f, _e358);
                    if _e358 {
                        phi_585_ = 38685626000000000000000000f;
                    } else {
                        phi_585_ = (1f / _e354);
                    }
                    let _e372 = phi_585_;
                    let _e373 = (_e258 == 0u);
                    if _e373 {
                        phi_594_ = _e295[0];
                    } else {
                        phi_594_ = _e295[1];
                    }
                    let _e377 = phi_594_;
                    let _e378 = (_e258 == 2u);
                    if _e378 {
                        phi_600_ = _e295[2];
                    } else {
                        phi_600_ = _e377;
                    }
                    let _e381 = phi_600_;
                    let _e383 = ((_e381 * _e268) * _e274);
                    if _e373 {
                        phi_611_ = _e307[0];
                    } else {
                        phi_611_ = _e307[1];
                    }
                    let _e387 = phi_611_;
                    if _e378 {
                        phi_617_ = _e307[2];
                    } else {
                        phi_617_ = _e387;
                    }
                    let _e390 = phi_617_;
                    let _e392 = ((_e390 * _e285) * _e291);
                    let _e396 = (bitcast<f32>((bitcast<u32>(_e392) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e396 {
                        let _e400 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) * 0.00000011920929f);
                        phi_640_ = select(0.00000000000011368684f, _e400, (_e400 > 0.00000000000011368684f));
                    } else {
                        phi_640_ = 0f;
                    }
                    let _e404 = phi_640_;
                    let _e405 = (_e383 + _e404);
                    let _e406 = (_e383 - _e404);
                    let _e407 = select(_e392, 0f, _e396);
                    if _e396 {
                        phi_651_ = 38685626000000000000000000f;
                    } else {
                        phi_651_ = (1f / _e392);
                    }
                    let _e410 = phi_651_;
                    let _e413 = bitcast<f32>((bitcast<u32>(_e306) & 2147483647u));
                    let _e416 = bitcast<f32>((bitcast<u32>(_e345) & 2147483647u));
                    let _e418 = select(_e416, _e413, (_e413 > _e416));
                    let _e421 = bitcast<f32>((bitcast<u32>(_e383) & 2147483647u));
                    let _e424 = (_e125 + _e238);
                    if (_e219 && (select(_e421, _e418, (_e418 > _e421)) <= 1099511600000f)) {
                        let _e427 = (_e424 / 3i);
                        let _e434 = bitcast<f32>((bitcast<u32>((_e427 + 127i)) << bitcast<u32>(23i)));
                        let _e441 = bitcast<f32>((bitcast<u32>(((_e424 - (2i * _e427)) + 127i)) << bitcast<u32>(23i)));
                        let _e442 = (((_e204 * _e434) * _e434) * _e441);
                        let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                        let _e449 = (((_e213 * _e434) * _e434) * _e441);
                        let _e451 = select(340282350000000000000000000000000000000f, _e449, (_e449 < 340282350000000000000000000000000000000f));
                        phi_751_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                        phi_752_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_751_ = 0f;
                        phi_752_ = 1f;
                    }
                    let _e455 = phi_751_;
                    let _e457 = phi_752_;
                    local_9 = array<type_21, 8>(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e460 = (_e257 % 3u);
                    let _e461 = (_e460 < 3u);
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e463 = local_1[_e460];
                    let _e466 = (_e256 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    let _e472 = (_e258 % 3u);
                    let _e473 = (_e472 < 3u);
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e475 = local_1[_e472];
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e480 = local[_e460];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e484 = local[_e466];
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e472];
                    phi_3494_ = false;
                    phi_3422_ = _e455;
                    phi_894_ = type_52(type_25(vec4<f32>((f32(_e463) * _e137), (f32(_e469) * _e137), (f32(_e475) * _e137), 0f), vec4<f32>((f32(_e480) * _e137), (f32(_e484) * _e137), (f32(_e488) * _e137), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_897_ = ((3u * _e87) + 1u);
                    phi_899_ = (_e457 <= _e455);
                    phi_901_ = 0u;
                    loop {
                        let _e498 = phi_3494_;
                        let _e500 = phi_3422_;
                        let _e502 = phi_894_;
                        let _e504 = phi_897_;
                        let _e506 = phi_899_;
                        let _e508 = phi_901_;
                        if _e506 {
                            phi_912_ = true;
                        } else {
                            phi_912_ = (_e508 > 0u);
                        }
                        let _e511 = phi_912_;
                        if _e511 {
                            let _e512 = (_e504 > 0u);
                            if _e512 {
                                if _e506 {
                                    phi_999_ = _e502;
                                    phi_1000_ = _e506;
                                    phi_1001_ = _e508;
                                } else {
                                    let _e513 = (_e508 - 1u);
                                    let _e514 = (_e513 % 128u);
                                    let _e515 = (_e514 < 128u);
                                    if _e515 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e517 = local_7[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e519 = local_6[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e521 = local_5[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e523 = local_4[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e525 = local_3[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e527 = local_2[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e532 = local_8[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e535 = local_10[_e514];
                                    phi_999_ = type_52(type_25(vec4<f32>(_e517, _e519, _e521, 0f), vec4<f32>(_e523, _e525, _e527, 0f)), _e532);
                                    phi_1000_ = (_e535 <= _e500);
                                    phi_1001_ = _e513;
                                }
                                let _e538 = phi_999_;
                                let _e540 = phi_1000_;
                                let _e542 = phi_1001_;
                                if _e540 {
                                    if ((_e538.member_1 & 2147483648u) != 0u) {
                                        phi_3491_ = _e498;
                                        phi_3481_ = _e500;
                                        phi_1019_ = type_4(0u, ((_e538.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1003 = phi_3491_;
                                            let _e1005 = phi_3481_;
                                            let _e1007 = phi_1019_;
                                            if (_e1007.member < _e1007.member_1) {
                                                phi_1020_ = type_4((_e1007.member + 1u), _e1007.member_1);
                                                phi_1043_ = type_4(1u, _e1007.member);
                                            } else {
                                                phi_1020_ = _e1007;
                                                phi_1043_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1020 = phi_1020_;
                                            let _e1022 = phi_1043_;
                                            let _e1026 = (bitcast<i32>(_e1022.member) != 0i);
                                            if _e1026 {
                                                let _e1027 = ((_e538.member_1 & 268435455u) + _e1022.member_1);
                                                let _e1028 = (_e1027 < _e89);
                                                if _e1028 {
                                                    if _e1028 {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1032 = global_2.member[_e1027].member_1;
                                                    phi_1064_ = _e1032;
                                                } else {
                                                    phi_1064_ = 4294967295u;
                                                }
                                                let _e1034 = phi_1064_;
                                                if (_e1027 >= _e89) {
                                                    phi_1153_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1028 {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    if (_e460 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1041 = global_2.member[_e1027].member[_e460];
                                                    if (_e466 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1047 = global_2.member[_e1027].member[_e466];
                                                    if (_e472 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1053 = global_2.member[_e1027].member[_e472];
                                                    let _e1055 = (3u + _e460);
                                                    if (_e1055 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1061 = global_2.member[_e1027].member[_e1055];
                                                    let _e1062 = (3u + _e466);
                                                    if (_e1062 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1068 = global_2.member[_e1027].member[_e1062];
                                                    let _e1069 = (3u + _e472);
                                                    if (_e1069 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1075 = global_2.member[_e1027].member[_e1069];
                                                    let _e1077 = (6u + _e460);
                                                    if (_e1077 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1083 = global_2.member[_e1027].member[_e1077];
                                                    let _e1084 = (6u + _e466);
                                                    if (_e1084 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1090 = global_2.member[_e1027].member[_e1084];
                                                    let _e1091 = (6u + _e472);
                                                    if (_e1091 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1097 = global_2.member[_e1027].member[_e1091];
                                                    phi_1153_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1041, _e1047, _e1053), array<f32, 3>(_e1061, _e1068, _e1075), array<f32, 3>(_e1083, _e1090, _e1097));
                                                }
                                                let _e1101 = phi_1153_;
                                                let _e1108 = (_e1101[0][2] - _e383);
                                                let _e1111 = (((_e1101[0][0] - _e306) * _e407) - (_e1108 * _e331));
                                                let _e1114 = (((_e1101[0][1] - _e345) * _e407) - (_e1108 * _e369));
                                                let _e1121 = (_e1101[1][2] - _e383);
                                                let _e1124 = (((_e1101[1][0] - _e306) * _e407) - (_e1121 * _e331));
                                                let _e1127 = (((_e1101[1][1] - _e345) * _e407) - (_e1121 * _e369));
                                                let _e1134 = (_e1101[2][2] - _e383);
                                                let _e1137 = (((_e1101[2][0] - _e306) * _e407) - (_e1134 * _e331));
                                                let _e1140 = (((_e1101[2][1] - _e345) * _e407) - (_e1134 * _e369));
                                                let _e1141 = (_e1137 * _e1127);
                                                let _e1142 = (_e1140 * _e1124);
                                                let _e1143 = (_e1111 * _e1140);
                                                let _e1144 = (_e1114 * _e1137);
                                                let _e1145 = (_e1124 * _e1114);
                                                let _e1146 = (_e1127 * _e1111);
                                                let _e1151 = (((_e1141 >= _e1142) && (_e1143 >= _e1144)) && (_e1145 >= _e1146));
                                                if (_e1151 || (((_e1141 <= _e1142) && (_e1143 <= _e1144)) && (_e1145 <= _e1146))) {
                                                    let _e1158 = select(-1f, 1f, _e1151);
                                                    let _e1160 = ((_e1141 - _e1142) * _e1158);
                                                    let _e1162 = select(0f, _e1160, (_e1160 > 0f));
                                                    let _e1164 = ((_e1143 - _e1144) * _e1158);
                                                    let _e1166 = select(0f, _e1164, (_e1164 > 0f));
                                                    let _e1168 = ((_e1145 - _e1146) * _e1158);
                                                    let _e1170 = select(0f, _e1168, (_e1168 > 0f));
                                                    let _e1172 = ((_e1162 + _e1166) + _e1170);
                                                    if (_e1172 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1720_ = type_21();
                                                        phi_1721_ = true;
                                                    } else {
                                                        let _e1175 = select(_e1101[1][0], _e1101[0][0], (_e1101[0][0] < _e1101[1][0]));
                                                        let _e1179 = select(_e1101[1][0], _e1101[0][0], (_e1101[0][0] > _e1101[1][0]));
                                                        let _e1183 = select(_e1101[1][1], _e1101[0][1], (_e1101[0][1] < _e1101[1][1]));
                                                        let _e1187 = select(_e1101[1][1], _e1101[0][1], (_e1101[0][1] > _e1101[1][1]));
                                                        let _e1191 = select(_e1101[1][2], _e1101[0][2], (_e1101[0][2] < _e1101[1][2]));
                                                        let _e1195 = select(_e1101[1][2], _e1101[0][2], (_e1101[0][2] > _e1101[1][2]));
                                                        let _e1200 = ((select(_e1101[2][0], _e1175, (_e1175 < _e1101[2][0])) - _e329) * _e334);
                                                        let _e1201 = ((select(_e1101[2][0], _e1179, (_e1179 > _e1101[2][0])) - _e330) * _e334);
                                                        let _e1204 = ((select(_e1101[2][1], _e1183, (_e1183 < _e1101[2][1])) - _e367) * _e372);
                                                        let _e1205 = ((select(_e1101[2][1], _e1187, (_e1187 > _e1101[2][1])) - _e368) * _e372);
                                                        let _e1208 = ((select(_e1101[2][2], _e1191, (_e1191 < _e1101[2][2])) - _e405) * _e410);
                                                        let _e1209 = ((select(_e1101[2][2], _e1195, (_e1195 > _e1101[2][2])) - _e406) * _e410);
                                                        let _e1211 = select(_e1209, _e1208, (_e1208 < _e1209));
                                                        let _e1213 = select(_e1209, _e1208, (_e1208 > _e1209));
                                                        let _e1215 = select(_e1201, _e1200, (_e1200 < _e1201));
                                                        let _e1217 = select(_e1205, _e1204, (_e1204 < _e1205));
                                                        let _e1219 = select(_e1217, _e1215, (_e1215 > _e1217));
                                                        let _e1221 = select(_e1211, _e1219, (_e1219 > _e1211));
                                                        let _e1223 = select(_e1201, _e1200, (_e1200 > _e1201));
                                                        let _e1225 = select(_e1205, _e1204, (_e1204 > _e1205));
                                                        let _e1227 = select(_e1225, _e1223, (_e1223 < _e1225));
                                                        let _e1229 = select(_e1213, _e1227, (_e1227 < _e1213));
                                                        let _e1230 = -(_e1211);
                                                        let _e1236 = select(_e457, _e1221, (_e1221 > _e457));
                                                        if (_e1236 > (_e1229 + (select(_e1230, _e1213, (_e1213 > _e1230)) * 0.0000019073523f))) {
                                                            phi_1715_ = type_21();
                                                            phi_1716_ = true;
                                                        } else {
                                                            let _e1238 = (_e1236 > _e1005);
                                                            if _e1238 {
                                                                phi_1714_ = type_21();
                                                            } else {
                                                                let _e1242 = (_e1101[1][0] - _e1101[0][0]);
                                                                let _e1243 = (_e1101[1][1] - _e1101[0][1]);
                                                                let _e1244 = (_e1101[1][2] - _e1101[0][2]);
                                                                let _e1245 = vec3<f32>(_e1242, _e1243, _e1244);
                                                                let _e1246 = (_e1101[2][0] - _e1101[1][0]);
                                                                let _e1247 = (_e1101[2][1] - _e1101[1][1]);
                                                                let _e1248 = (_e1101[2][2] - _e1101[1][2]);
                                                                let _e1249 = vec3<f32>(_e1246, _e1247, _e1248);
                                                                let _e1250 = (_e1101[0][0] - _e1101[2][0]);
                                                                let _e1251 = (_e1101[0][1] - _e1101[2][1]);
                                                                let _e1252 = (_e1101[0][2] - _e1101[2][2]);
                                                                let _e1253 = vec3<f32>(_e1250, _e1251, _e1252);
                                                                let _e1256 = bitcast<f32>((bitcast<u32>(_e1242) & 2147483647u));
                                                                let _e1259 = bitcast<f32>((bitcast<u32>(_e1243) & 2147483647u));
                                                                let _e1261 = select(_e1259, _e1256, (_e1256 > _e1259));
                                                                let _e1264 = bitcast<f32>((bitcast<u32>(_e1244) & 2147483647u));
                                                                let _e1266 = select(_e1264, _e1261, (_e1261 > _e1264));
                                                                let _e1269 = bitcast<f32>((bitcast<u32>(_e1246) & 2147483647u));
                                                                let _e1272 = bitcast<f32>((bitcast<u32>(_e1247) & 2147483647u));
                                                                let _e1274 = select(_e1272, _e1269, (_e1269 > _e1272));
                                                                let _e1277 = bitcast<f32>((bitcast<u32>(_e1248) & 2147483647u));
                                                                let _e1279 = select(_e1277, _e1274, (_e1274 > _e1277));
                                                                let _e1282 = bitcast<f32>((bitcast<u32>(_e1250) & 2147483647u));
                                                                let _e1285 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                                let _e1287 = select(_e1285, _e1282, (_e1282 > _e1285));
                                                                let _e1290 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
                                                                let _e1292 = select(_e1290, _e1287, (_e1287 > _e1290));
                                                                let _e1294 = select(_e1279, _e1266, (_e1266 > _e1279));
                                                                let _e1296 = select(_e1292, _e1294, (_e1294 > _e1292));
                                                                if (_e1266 == _e1296) {
                                                                    phi_1625_ = _e1249;
                                                                    phi_1626_ = _e1253;
                                                                } else {
                                                                    let _e1299 = vec3((_e1279 == _e1296));
                                                                    phi_1625_ = select(_e1245, _e1253, _e1299);
                                                                    phi_1626_ = select(_e1249, _e1245, _e1299);
                                                                }
                                                                let _e1303 = phi_1625_;
                                                                let _e1305 = phi_1626_;
                                                                let _e1312 = ((_e1303.y * _e1305.z) - (_e1305.y * _e1303.z));
                                                                let _e1317 = ((_e1303.z * _e1305.x) - (_e1305.z * _e1303.x));
                                                                let _e1320 = ((_e1303.x * _e1305.y) - (_e1305.x * _e1303.y));
                                                                if (_e1162 >= _e1166) {
                                                                    phi_1657_ = select(true, false, (_e1162 >= _e1170));
                                                                } else {
                                                                    phi_1657_ = true;
                                                                }
                                                                let _e1325 = phi_1657_;
                                                                if _e1325 {
                                                                    phi_1666_ = select(vec3<f32>(_e1101[2][0], _e1101[2][1], _e1101[2][2]), vec3<f32>(_e1101[1][0], _e1101[1][1], _e1101[1][2]), vec3((_e1166 >= _e1170)));
                                                                } else {
                                                                    phi_1666_ = vec3<f32>(_e1101[0][0], _e1101[0][1], _e1101[0][2]);
                                                                }
                                                                let _e1330 = phi_1666_;
                                                                let _e1347 = ((((_e1312 * (_e1330.x - _e306)) + (_e1317 * (_e1330.y - _e345))) + (_e1320 * (_e1330.z - _e383))) / (((_e1312 * _e331) + (_e1317 * _e369)) + (_e1320 * _e407)));
                                                                let _e1349 = select(_e1229, _e1347, (_e1347 < _e1229));
                                                                let _e1351 = select(_e1221, _e1349, (_e1349 > _e1221));
                                                                if (_e1351 >= _e457) {
                                                                    let _e1353 = (_e1351 <= _e1005);
                                                                    if _e1353 {
                                                                        let _e1354 = (1f / _e1172);
                                                                        phi_1706_ = type_21(_e1351, (_e1166 * _e1354), (_e1170 * _e1354), _e1034);
                                                                    } else {
                                                                        phi_1706_ = type_21();
                                                                    }
                                                                    let _e1359 = phi_1706_;
                                                                    phi_1708_ = _e1359;
                                                                    phi_1709_ = select(true, false, _e1353);
                                                                } else {
                                                                    phi_1708_ = type_21();
                                                                    phi_1709_ = true;
                                                                }
                                                                let _e1362 = phi_1708_;
                                                                let _e1364 = phi_1709_;
                                                                if _e1364 {
                                                                    phi_1713_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1713_ = _e1362;
                                                                }
                                                                let _e1366 = phi_1713_;
                                                                phi_1714_ = _e1366;
                                                            }
                                                            let _e1368 = phi_1714_;
                                                            phi_1715_ = _e1368;
                                                            phi_1716_ = _e1238;
                                                        }
                                                        let _e1370 = phi_1715_;
                                                        let _e1372 = phi_1716_;
                                                        phi_1720_ = _e1370;
                                                        phi_1721_ = _e1372;
                                                    }
                                                    let _e1374 = phi_1720_;
                                                    let _e1376 = phi_1721_;
                                                    phi_1725_ = _e1374;
                                                    phi_1726_ = _e1376;
                                                } else {
                                                    phi_1725_ = type_21();
                                                    phi_1726_ = true;
                                                }
                                                let _e1378 = phi_1725_;
                                                let _e1380 = phi_1726_;
                                                if _e1380 {
                                                    phi_1730_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1730_ = _e1378;
                                                }
                                                let _e1382 = phi_1730_;
                                                if (_e1382.member_3 != 4294967295u) {
                                                    if (_e1034 != 4294967295u) {
                                                        phi_1742_ = type_4(0u, 8u);
                                                        phi_1745_ = _e1382;
                                                        loop {
                                                            let _e1387 = phi_1742_;
                                                            let _e1389 = phi_1745_;
                                                            if (_e1387.member < _e1387.member_1) {
                                                                phi_1743_ = type_4((_e1387.member + 1u), _e1387.member_1);
                                                                phi_1768_ = type_4(1u, _e1387.member);
                                                            } else {
                                                                phi_1743_ = _e1387;
                                                                phi_1768_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1402 = phi_1743_;
                                                            let _e1404 = phi_1768_;
                                                            let _e1408 = (bitcast<i32>(_e1404.member) != 0i);
                                                            if _e1408 {
                                                                let _e1409 = (_e1404.member_1 < 8u);
                                                                if _e1409 {
                                                                } else {
                                                                    phi_3482_ = true;
                                                                    break;
                                                                }
                                                                let _e1414 = local_9[_e1404.member_1].member;
                                                                if (_e1389.member < _e1414) {
                                                                    phi_1801_ = true;
                                                                } else {
                                                                    let _e1416 = local_9[_e1404.member_1].member;
                                                                    if (_e1389.member == _e1416) {
                                                                        let _e1421 = local_9[_e1404.member_1].member_3;
                                                                        phi_1800_ = (_e1389.member_3 < _e1421);
                                                                    } else {
                                                                        phi_1800_ = false;
                                                                    }
                                                                    let _e1424 = phi_1800_;
                                                                    phi_1801_ = _e1424;
                                                                }
                                                                let _e1426 = phi_1801_;
                                                                if _e1426 {
                                                                    if _e1409 {
                                                                    } else {
                                                                        phi_3482_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1427 = local_9[_e1404.member_1];
                                                                    local_9[_e1404.member_1] = type_21(_e1389.member, _e1389.member_1, _e1389.member_2, _e1389.member_3);
                                                                    phi_1822_ = type_21(_e1427.member, _e1427.member_1, _e1427.member_2, _e1427.member_3);
                                                                } else {
                                                                    phi_1822_ = _e1389;
                                                                }
                                                                let _e1438 = phi_1822_;
                                                                phi_1746_ = _e1438;
                                                            } else {
                                                                phi_1746_ = type_21();
                                                            }
                                                            let _e1440 = phi_1746_;
                                                            continue;
                                                            continuing {
                                                                phi_1742_ = _e1402;
                                                                phi_1745_ = _e1440;
                                                                phi_3482_ = _e1003;
                                                                break if !(_e1408);
                                                            }
                                                        }
                                                        let _e1443 = phi_3482_;
                                                        phi_3738_ = _e1005;
                                                        phi_3596_ = _e1443;
                                                        if _e1443 {
                                                            break;
                                                        }
                                                        let _e1446 = local_9[7u].member_3;
                                                        if (_e1446 != 4294967295u) {
                                                            let _e1450 = local_9[7u].member;
                                                            phi_3801_ = _e1450;
                                                        } else {
                                                            phi_3801_ = _e1005;
                                                        }
                                                        let _e1452 = phi_3801_;
                                                        phi_3800_ = _e1452;
                                                        phi_3599_ = _e1443;
                                                    } else {
                                                        phi_3800_ = _e1005;
                                                        phi_3599_ = _e1003;
                                                    }
                                                    let _e1454 = phi_3800_;
                                                    let _e1456 = phi_3599_;
                                                    phi_3799_ = _e1454;
                                                    phi_3598_ = _e1456;
                                                } else {
                                                    phi_3799_ = _e1005;
                                                    phi_3598_ = _e1003;
                                                }
                                                let _e1458 = phi_3799_;
                                                let _e1460 = phi_3598_;
                                                phi_3798_ = _e1458;
                                                phi_3597_ = _e1460;
                                            } else {
                                                phi_3798_ = _e1005;
                                                phi_3597_ = _e1003;
                                            }
                                            let _e1462 = phi_3798_;
                                            let _e1464 = phi_3597_;
                                            continue;
                                            continuing {
                                                phi_3491_ = _e1464;
                                                phi_3481_ = _e1462;
                                                phi_1019_ = _e1020;
                                                phi_3738_ = _e1462;
                                                phi_3596_ = _e1464;
                                                break if !(_e1026);
                                            }
                                        }
                                        let _e1467 = phi_3738_;
                                        let _e1469 = phi_3596_;
                                        phi_3601_ = _e1469;
                                        if _e1469 {
                                            break;
                                        }
                                        phi_3703_ = _e1467;
                                        phi_3605_ = _e1469;
                                        phi_3039_ = _e538;
                                        phi_3040_ = false;
                                        phi_3041_ = _e542;
                                    } else {
                                        if (_e538.member_1 >= _e87) {
                                            phi_2594_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e538.member_1 < _e87) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e553 = (_e257 * 2u);
                                            let _e555 = ((1u + _e553) % 7u);
                                            if (_e555 < 7u) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e560 = global_5.member[_e538.member_1][_e555];
                                            let _e562 = ((_e553 + 2u) % 7u);
                                            if (_e562 < 7u) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e567 = global_5.member[_e538.member_1][_e562];
                                            let _e568 = (_e256 * 2u);
                                            let _e570 = ((1u + _e568) % 7u);
                                            if (_e570 < 7u) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e575 = global_5.member[_e538.member_1][_e570];
                                            let _e577 = ((_e568 + 2u) % 7u);
                                            if (_e577 < 7u) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e582 = global_5.member[_e538.member_1][_e577];
                                            let _e583 = (_e258 * 2u);
                                            let _e585 = ((1u + _e583) % 7u);
                                            if (_e585 < 7u) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e590 = global_5.member[_e538.member_1][_e585];
                                            let _e592 = ((_e583 + 2u) % 7u);
                                            if (_e592 < 7u) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e597 = global_5.member[_e538.member_1][_e592];
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.x - _e538.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.y - _e538.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.z - _e538.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e624 = select(_e137, _e620, (_e620 > _e137));
                                            let _e626 = select(_e137, _e621, (_e621 > _e137));
                                            let _e628 = select(_e137, _e622, (_e622 > _e137));
                                            let _e653 = bitcast<u32>((f32(bitcast<i32>((_e560 & 2097151u))) * _e624));
                                            let _e658 = (bitcast<i32>((_e560 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e575 & 2097151u))) * _e626));
                                            let _e667 = (bitcast<i32>((_e575 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e671 = bitcast<u32>((f32(bitcast<i32>((_e590 & 2097151u))) * _e628));
                                            let _e676 = (bitcast<i32>((_e590 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                            let _e683 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                            let _e687 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e691 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                            let _e692 = bitcast<u32>((f32(bitcast<i32>((_e567 & 2097151u))) * _e624));
                                            let _e697 = (bitcast<i32>((_e567 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e582 & 2097151u))) * _e626));
                                            let _e706 = (bitcast<i32>((_e582 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e710 = bitcast<u32>((f32(bitcast<i32>((_e597 & 2097151u))) * _e628));
                                            let _e715 = (bitcast<i32>((_e597 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e718 = bitcast<f32>((_e710 & bitcast<u32>(_e715)));
                                            let _e722 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                            let _e726 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e730 = bitcast<f32>((_e710 & bitcast<u32>(~(_e715))));
                                            let _e760 = global_5.member[_e538.member_1][0u];
                                            let _e764 = global_5.member[_e538.member_1][2u];
                                            let _e768 = global_5.member[_e538.member_1][4u];
                                            let _e772 = global_5.member[_e538.member_1][6u];
                                            let _e784 = (((_e764 >> bitcast<u32>(22i)) | ((_e768 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e772 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e785 = (_e760 & 268435455u);
                                            let _e786 = (_e784 & 268435455u);
                                            let _e789 = ((_e760 >> bitcast<u32>(28u)) & 7u);
                                            let _e797 = ((_e760 >> bitcast<u32>(31i)) | (((_e784 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e798 = (_e789 != 0u);
                                            if (_e789 == 0u) {
                                                phi_2556_ = _e785;
                                            } else {
                                                if (_e789 == 7u) {
                                                    phi_2555_ = 2147483648u;
                                                } else {
                                                    phi_2555_ = ((2147483648u | (_e789 << bitcast<u32>(28u))) | (_e786 & 268435455u));
                                                }
                                                let _e807 = phi_2555_;
                                                phi_2556_ = _e807;
                                            }
                                            let _e809 = phi_2556_;
                                            if _e798 {
                                                let _e810 = (_e789 != 7u);
                                                if _e810 {
                                                    phi_2566_ = (_e786 + _e789);
                                                } else {
                                                    phi_2566_ = u32();
                                                }
                                                let _e813 = phi_2566_;
                                                phi_2568_ = _e813;
                                                phi_2569_ = select(true, false, _e810);
                                            } else {
                                                phi_2568_ = u32();
                                                phi_2569_ = true;
                                            }
                                            let _e816 = phi_2568_;
                                            let _e818 = phi_2569_;
                                            if (_e797 == 0u) {
                                                phi_2590_ = (_e785 + select(0u, 1u, !(_e798)));
                                            } else {
                                                if (_e797 == 7u) {
                                                    phi_2589_ = 2147483648u;
                                                } else {
                                                    phi_2589_ = ((2147483648u | (_e797 << bitcast<u32>(28u))) | (select(_e816, _e786, _e818) & 268435455u));
                                                }
                                                let _e831 = phi_2589_;
                                                phi_2590_ = _e831;
                                            }
                                            let _e833 = phi_2590_;
                                            phi_2594_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e538.member.member.x + _e661), (_e538.member.member.x + _e683), (_e538.member.member_1.x - _e700), (_e538.member.member_1.x - _e722)), vec4<f32>((_e538.member.member.y + _e670), (_e538.member.member.y + _e687), (_e538.member.member_1.y - _e709), (_e538.member.member_1.y - _e726)), vec4<f32>((_e538.member.member.z + _e679), (_e538.member.member.z + _e691), (_e538.member.member_1.z - _e718), (_e538.member.member_1.z - _e730))), type_52(type_25((_e538.member.member + vec4<f32>(_e661, _e670, _e679, 0f)), (_e538.member.member_1 - vec4<f32>(_e700, _e709, _e718, 0f))), _e809), type_52(type_25((_e538.member.member + vec4<f32>(_e683, _e687, _e691, 0f)), (_e538.member.member_1 - vec4<f32>(_e722, _e726, _e730, 0f))), _e833));
                                        }
                                        let _e838 = phi_2594_;
                                        let _e849 = ((_e838.member[0].x - _e329) * _e334);
                                        let _e850 = ((_e838.member[0].y - _e329) * _e334);
                                        let _e851 = ((_e838.member[0].z - _e330) * _e334);
                                        let _e852 = ((_e838.member[0].w - _e330) * _e334);
                                        let _e862 = ((_e838.member[1].x - _e367) * _e372);
                                        let _e863 = ((_e838.member[1].y - _e367) * _e372);
                                        let _e864 = ((_e838.member[1].z - _e368) * _e372);
                                        let _e865 = ((_e838.member[1].w - _e368) * _e372);
                                        let _e875 = ((_e838.member[2].x - _e405) * _e410);
                                        let _e876 = ((_e838.member[2].y - _e405) * _e410);
                                        let _e877 = ((_e838.member[2].z - _e406) * _e410);
                                        let _e878 = ((_e838.member[2].w - _e406) * _e410);
                                        let _e880 = select(_e877, _e875, (_e875 < _e877));
                                        let _e882 = select(_e878, _e876, (_e876 < _e878));
                                        let _e884 = select(_e877, _e875, (_e875 > _e877));
                                        let _e886 = select(_e878, _e876, (_e876 > _e878));
                                        let _e888 = select(_e851, _e849, (_e849 < _e851));
                                        let _e890 = select(_e852, _e850, (_e850 < _e852));
                                        let _e892 = select(_e864, _e862, (_e862 < _e864));
                                        let _e894 = select(_e865, _e863, (_e863 < _e865));
                                        let _e896 = select(_e892, _e888, (_e888 > _e892));
                                        let _e898 = select(_e894, _e890, (_e890 > _e894));
                                        let _e900 = select(_e880, _e896, (_e896 > _e880));
                                        let _e902 = select(_e882, _e898, (_e898 > _e882));
                                        let _e904 = select(_e851, _e849, (_e849 > _e851));
                                        let _e906 = select(_e852, _e850, (_e850 > _e852));
                                        let _e908 = select(_e864, _e862, (_e862 > _e864));
                                        let _e910 = select(_e865, _e863, (_e863 > _e865));
                                        let _e912 = select(_e908, _e904, (_e904 < _e908));
                                        let _e914 = select(_e910, _e906, (_e906 < _e910));
                                        let _e919 = -(_e880);
                                        let _e920 = -(_e882);
                                        let _e927 = (select(_e884, _e912, (_e912 < _e884)) + (select(_e919, _e884, (_e884 > _e919)) * 0.0000019073523f));
                                        let _e928 = (select(_e886, _e914, (_e914 < _e886)) + (select(_e920, _e886, (_e886 > _e920)) * 0.0000019073523f));
                                        let _e930 = select(_e457, _e900, (_e900 > _e457));
                                        let _e932 = select(_e457, _e902, (_e902 > _e457));
                                        let _e937 = (_e930 <= select(_e500, _e927, (_e927 < _e500)));
                                        let _e938 = (_e932 <= select(_e500, _e928, (_e928 < _e500)));
                                        let _e939 = (_e930 <= _e932);
                                        if _e937 {
                                            if _e938 {
                                                if _e939 {
                                                    phi_2939_ = _e838.member_2;
                                                } else {
                                                    phi_2939_ = _e838.member_1;
                                                }
                                                let _e943 = phi_2939_;
                                                let _e965 = (_e542 % 128u);
                                                let _e966 = (_e965 < 128u);
                                                if _e966 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_8[_e965] = _e943.member_1;
                                                if _e966 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_7[_e965] = _e943.member.member.x;
                                                if _e966 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_6[_e965] = _e943.member.member.y;
                                                if _e966 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_5[_e965] = _e943.member.member.z;
                                                if _e966 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_4[_e965] = _e943.member.member_1.x;
                                                if _e966 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_3[_e965] = _e943.member.member_1.y;
                                                if _e966 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_2[_e965] = _e943.member.member_1.z;
                                                if _e966 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_10[_e965] = select(_e932, _e930, (_e930 > _e932));
                                                if _e939 {
                                                    phi_3016_ = _e838.member_1;
                                                } else {
                                                    phi_3016_ = _e838.member_2;
                                                }
                                                let _e979 = phi_3016_;
                                                phi_3017_ = _e979;
                                                phi_3018_ = (_e542 + 1u);
                                            } else {
                                                phi_3017_ = type_52();
                                                phi_3018_ = u32();
                                            }
                                            let _e981 = phi_3017_;
                                            let _e983 = phi_3018_;
                                            phi_3020_ = _e981;
                                            phi_3021_ = _e983;
                                            phi_3022_ = select(true, false, _e938);
                                        } else {
                                            phi_3020_ = type_52();
                                            phi_3021_ = u32();
                                            phi_3022_ = true;
                                        }
                                        let _e986 = phi_3020_;
                                        let _e988 = phi_3021_;
                                        let _e990 = phi_3022_;
                                        if _e990 {
                                            if _e937 {
                                                phi_3031_ = _e838.member_1;
                                            } else {
                                                phi_3031_ = _e838.member_2;
                                            }
                                            let _e994 = phi_3031_;
                                            phi_3036_ = _e994;
                                            phi_3037_ = select(_e938, true, _e937);
                                        } else {
                                            phi_3036_ = _e986;
                                            phi_3037_ = _e540;
                                        }
                                        let _e997 = phi_3036_;
                                        let _e999 = phi_3037_;
                                        phi_3703_ = _e500;
                                        phi_3605_ = _e498;
                                        phi_3039_ = _e997;
                                        phi_3040_ = _e999;
                                        phi_3041_ = select(_e988, _e542, _e990);
                                    }
                                    let _e1471 = phi_3703_;
                                    let _e1473 = phi_3605_;
                                    let _e1475 = phi_3039_;
                                    let _e1477 = phi_3040_;
                                    let _e1479 = phi_3041_;
                                    phi_3702_ = _e1471;
                                    phi_3604_ = _e1473;
                                    phi_3042_ = _e1475;
                                    phi_3043_ = (_e504 - 1u);
                                    phi_3044_ = _e1477;
                                    phi_3045_ = _e1479;
                                } else {
                                    phi_3702_ = _e500;
                                    phi_3604_ = _e498;
                                    phi_3042_ = _e538;
                                    phi_3043_ = _e504;
                                    phi_3044_ = _e540;
                                    phi_3045_ = _e542;
                                }
                                let _e1481 = phi_3702_;
                                let _e1483 = phi_3604_;
                                let _e1485 = phi_3042_;
                                let _e1487 = phi_3043_;
                                let _e1489 = phi_3044_;
                                let _e1491 = phi_3045_;
                                phi_3701_ = _e1481;
                                phi_3603_ = _e1483;
                                phi_3046_ = _e1485;
                                phi_3047_ = _e1487;
                                phi_3048_ = _e1489;
                                phi_3049_ = _e1491;
                            } else {
                                phi_3701_ = _e500;
                                phi_3603_ = _e498;
                                phi_3046_ = type_52();
                                phi_3047_ = u32();
                                phi_3048_ = bool();
                                phi_3049_ = u32();
                            }
                            let _e1493 = phi_3701_;
                            let _e1495 = phi_3603_;
                            let _e1497 = phi_3046_;
                            let _e1499 = phi_3047_;
                            let _e1501 = phi_3048_;
                            let _e1503 = phi_3049_;
                            phi_3700_ = _e1493;
                            phi_3602_ = _e1495;
                            phi_895_ = _e1497;
                            phi_898_ = _e1499;
                            phi_900_ = _e1501;
                            phi_902_ = _e1503;
                            phi_3050_ = _e512;
                        } else {
                            phi_3700_ = _e500;
                            phi_3602_ = _e498;
                            phi_895_ = type_52();
                            phi_898_ = u32();
                            phi_900_ = bool();
                            phi_902_ = u32();
                            phi_3050_ = false;
                        }
                        let _e1505 = phi_3700_;
                        let _e1507 = phi_3602_;
                        let _e1509 = phi_895_;
                        let _e1511 = phi_898_;
                        let _e1513 = phi_900_;
                        let _e1515 = phi_902_;
                        let _e1517 = phi_3050_;
                        continue;
                        continuing {
                            phi_3494_ = _e1507;
                            phi_3422_ = _e1505;
                            phi_894_ = _e1509;
                            phi_897_ = _e1511;
                            phi_899_ = _e1513;
                            phi_901_ = _e1515;
                            phi_3601_ = _e1507;
                            break if !(_e1517);
                        }
                    }
                    let _e1520 = phi_3601_;
                    if _e1520 {
                        break;
                    }
                    phi_3057_ = type_4(0u, 8u);
                    loop {
                        let _e1522 = phi_3057_;
                        if (_e1522.member < _e1522.member_1) {
                            phi_3058_ = type_4((_e1522.member + 1u), _e1522.member_1);
                            phi_3081_ = type_4(1u, _e1522.member);
                        } else {
                            phi_3058_ = _e1522;
                            phi_3081_ = type_4(0u, type_4().member_1);
                        }
                        let _e1535 = phi_3058_;
                        let _e1537 = phi_3081_;
                        let _e1541 = (bitcast<i32>(_e1537.member) != 0i);
                        if _e1541 {
                            let _e1542 = (_e1537.member_1 < 8u);
                            if _e1542 {
                            } else {
                                phi_3693_ = true;
                                break;
                            }
                            let _e1544 = local_9[_e1537.member_1];
                            if (_e1544.member_3 != 4294967295u) {
                                let _e1550 = -(_e424);
                                let _e1551 = (_e1550 / 3i);
                                let _e1558 = bitcast<f32>((bitcast<u32>((_e1551 + 127i)) << bitcast<u32>(23i)));
                                let _e1566 = (((_e1544.member * _e1558) * _e1558) * bitcast<f32>((bitcast<u32>(((_e1550 - (2i * _e1551)) + 127i)) << bitcast<u32>(23i))));
                                let _e1568 = select(340282350000000000000000000000000000000f, _e1566, (_e1566 < 340282350000000000000000000000000000000f));
                                phi_3147_ = type_21(select(-340282350000000000000000000000000000000f, _e1568, (_e1568 > -340282350000000000000000000000000000000f)), _e1544.member_1, _e1544.member_2, _e1544.member_3);
                            } else {
                                phi_3147_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1573 = phi_3147_;
                            if _e1542 {
                            } else {
                                phi_3693_ = true;
                                break;
                            }
                            local_9[_e1537.member_1] = type_21(_e1573.member, _e1573.member_1, _e1573.member_2, _e1573.member_3);
                        }
                        continue;
                        continuing {
                            phi_3057_ = _e1535;
                            phi_3693_ = _e1520;
                            break if !(_e1541);
                        }
                    }
                    let _e1581 = phi_3693_;
                    if _e1581 {
                        break;
                    }
                    let _e1582 = local_9;
                    if _e145 {
                    } else {
                        break;
                    }
                    global_6.member[_e143] = array<type_21, 8>(type_21(_e1582[0].member, _e1582[0].member_1, _e1582[0].member_2, _e1582[0].member_3), type_21(_e1582[1].member, _e1582[1].member_1, _e1582[1].member_2, _e1582[1].member_3), type_21(_e1582[2].member, _e1582[2].member_1, _e1582[2].member_2, _e1582[2].member_3), type_21(_e1582[3].member, _e1582[3].member_1, _e1582[3].member_2, _e1582[3].member_3), type_21(_e1582[4].member, _e1582[4].member_1, _e1582[4].member_2, _e1582[4].member_3), type_21(_e1582[5].member, _e1582[5].member_1, _e1582[5].member_2, _e1582[5].member_3), type_21(_e1582[6].member, _e1582[6].member_1, _e1582[6].member_2, _e1582[6].member_3), type_21(_e1582[7].member, _e1582[7].member_1, _e1582[7].member_2, _e1582[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
